//! `lampyris lab`: the papers' experiments, and the page that sets their figures beside ours.

use crate::cli::{LabCommand, LabRunArgs, ListArgs};
use crate::failure::{Failure, INTERRUPTED};
use crate::progress::LabProgress;
use crate::{interrupt, say};
use lampyris_lab::{ALL, Effort, Error, Experiment, Measured, Report, select};
use serde::Serialize;
use std::path::PathBuf;
use std::process::ExitCode;

/// Lists or runs.
pub(crate) fn lab(command: &LabCommand) -> Result<ExitCode, Failure> {
    match command {
        LabCommand::List(args) => list(args),
        LabCommand::Run(args) => run(args),
    }
}

#[derive(Serialize)]
struct Row {
    name: &'static str,
    title: &'static str,
    paper: &'static str,
    place: &'static str,
    claim: &'static str,
}

fn list(args: &ListArgs) -> Result<ExitCode, Failure> {
    if args.json {
        let row = |e: &Experiment| Row {
            name: e.name,
            title: e.title,
            paper: e.paper,
            place: e.place,
            claim: e.claim,
        };
        say::json(&ALL.iter().map(row).collect::<Vec<_>>())?;
    } else {
        let line =
            |e: &Experiment| format!("{:<22} {}\n{:<22} {}, {}\n", e.name, e.title, "", e.paper, e.place);
        say::result(&ALL.iter().map(line).collect::<String>())?;
    }
    Ok(ExitCode::SUCCESS)
}

fn run(args: &LabRunArgs) -> Result<ExitCode, Failure> {
    let experiments = select(&args.names)?;
    let further = std::env::var_os("LAMPYRIS_SCENES").map(PathBuf::from);
    let report = Report::open(&args.output)?;
    let progress = LabProgress::new(&experiments, args.quick, args.quiet);
    let effort = Effort {
        quick: args.quick,
        scenes: &args.scenes,
        further: further.as_deref(),
        go_on: &|| !interrupt::asked(),
        told: &|share| progress.step(share),
    };
    interrupt::rendering();
    let mut whole = true;
    for experiment in experiments {
        progress.begin(experiment);
        match Measured::by(experiment, &effort) {
            Ok(measured) => interrupt::writing(|| report.keep(measured))?,
            Err(Error::Interrupted) => {
                whole = false;
                break;
            }
            Err(error) => return Err(error.into()),
        }
    }
    progress.end();
    interrupt::writing(|| report.assemble())?;
    say::result(&format!("{}\n", report.page().display()))?;
    Ok(if whole { ExitCode::SUCCESS } else { ExitCode::from(INTERRUPTED) })
}
