//! `lampyris list`: what there is to choose from, from the library's own tables.

use crate::cli::ListArgs;
use crate::failure::Failure;
use crate::say;
use lampyris::backend::Absorption;
use lampyris::integrator;
use lampyris::sequence::Sequence;
use lampyris::{import, output};
use output::ToneCurve;
use serde::Serialize;
use std::process::ExitCode;

#[derive(Serialize)]
struct Row {
    name: &'static str,
    about: String,
}

#[derive(Serialize)]
struct Tables {
    parts: Vec<Row>,
    sequences: Vec<Row>,
    absorption: Vec<&'static str>,
    scene_formats: Vec<Row>,
    picture_formats: Vec<Row>,
    tone_curves: Vec<Row>,
}

/// Prints the tables.
pub(crate) fn list(args: &ListArgs) -> Result<ExitCode, Failure> {
    let row = |name, about: &str| Row { name, about: about.to_string() };
    let tables = Tables {
        parts: integrator::ALL.iter().map(|i| row(i.name(), i.paths())).collect(),
        sequences: Sequence::ALL.iter().map(|s| row(s.name(), s.about())).collect(),
        absorption: Absorption::ALL.iter().map(|(name, _)| *name).collect(),
        scene_formats: (import::FORMATS.iter())
            .flat_map(|f| f.extensions.iter().map(move |e| row(e, f.name)))
            .collect(),
        picture_formats: output::FORMATS.iter().map(|f| row(f.extension, f.name)).collect(),
        tone_curves: ToneCurve::ALL.iter().map(|c| row(c.name(), c.formula())).collect(),
    };
    if args.json {
        say::json(&tables)?
    } else {
        say::result(&text(&tables))?
    }
    Ok(ExitCode::SUCCESS)
}

fn text(tables: &Tables) -> String {
    let sections = [
        ("Parts (--parts), and the paths they cover", &tables.parts),
        ("Sequences (--sequence)", &tables.sequences),
        ("Scene formats, by extension", &tables.scene_formats),
        ("Picture formats, by extension", &tables.picture_formats),
        ("Tone curves (--tone)", &tables.tone_curves),
    ];
    let mut text = String::new();
    for (title, rows) in sections {
        text += &format!("{title}:\n");
        text.extend(rows.iter().map(|r| format!("  {:<18} {}\n", r.name, r.about)));
    }
    text + &format!("Absorption (--absorption):\n  {}\n", tables.absorption.join(", "))
}
