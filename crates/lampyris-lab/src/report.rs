//! The folder of a report. Every experiment has a folder of its own in it, whose `figures.json` is written last: what is
//! there is whole, and the page is put together of what is there.

use crate::effort::Effort;
use crate::error::{Error, Result};
use crate::experiment::Experiment;
use crate::findings::{Exhibit, Findings};
use crate::page;
use crate::record::{Record, Shown, ShownImage};
use crate::table::ALL;
use lampyris::output;
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What an experiment found, and how long that took.
pub struct Measured {
    experiment: &'static Experiment,
    quick: bool,
    seconds: f64,
    found: Findings,
}

impl Measured {
    /// Runs an experiment.
    ///
    /// # Errors
    /// The experiment's.
    pub fn by(experiment: &'static Experiment, effort: &Effort<'_>) -> Result<Measured> {
        let start = Instant::now();
        let found = (experiment.run)(effort)?;
        Ok(Measured { experiment, quick: effort.quick, seconds: start.elapsed().as_secs_f64(), found })
    }
}

/// A folder with a page.
pub struct Report {
    folder: PathBuf,
}

const FIGURES: &str = "figures.json";
const PAGE: &str = "index.html";

impl Report {
    /// The report in a folder, which is made where there is none. Experiments that are in it stay until they are run again.
    ///
    /// # Errors
    /// [`Error::CannotWrite`] where the folder cannot be made, or has a page that is no report.
    pub fn open(folder: &Path) -> Result<Report> {
        fs::create_dir_all(folder).map_err(|e| cannot(folder, e))?;
        let (page, figures) = (folder.join(PAGE), folder.join(FIGURES));
        if page.exists() && !figures.exists() {
            return Err(cannot(&page, "it is there already, and is no report: name another folder"));
        }
        Ok(Report { folder: folder.into() })
    }

    /// Where the page is.
    pub fn page(&self) -> PathBuf {
        self.folder.join(PAGE)
    }

    /// Writes what an experiment found; then the page.
    ///
    /// # Errors
    /// [`Error::CannotWrite`].
    pub fn keep(&self, measured: Measured) -> Result<()> {
        let Measured { experiment, quick, seconds, found } = measured;
        let folder = self.folder.join(experiment.name);
        fs::create_dir_all(&folder).map_err(|e| cannot(&folder, e))?;
        let Findings { comparisons, exhibits, gaps } = found;
        let exhibits: Result<Vec<Shown>> = exhibits
            .into_iter()
            .enumerate()
            .map(|(number, exhibit)| write(&folder, number, exhibit))
            .collect();
        let record = Record {
            name: experiment.name.into(),
            title: experiment.title.into(),
            paper: experiment.paper.into(),
            place: experiment.place.into(),
            claim: experiment.claim.into(),
            quick,
            seconds,
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            version: env!("CARGO_PKG_VERSION").into(),
            comparisons,
            exhibits: exhibits?,
            gaps,
        };
        write_json(&folder.join(FIGURES), &record)?;
        self.assemble()
    }

    /// Writes the page, and a file with all figures, of the experiments that are there.
    ///
    /// # Errors
    /// [`Error::CannotWrite`].
    pub fn assemble(&self) -> Result<()> {
        let records: Vec<Record> = ALL.iter().filter_map(|e| self.read(e)).collect();
        write_json(&self.folder.join(FIGURES), &records)?;
        write_text(&self.page(), &page::html(&records))
    }

    /// What an experiment left, if it is of this version's shape.
    fn read(&self, experiment: &Experiment) -> Option<Record> {
        let text = fs::read_to_string(self.folder.join(experiment.name).join(FIGURES)).ok()?;
        serde_json::from_str(&text).ok()
    }
}

/// Writes the files of an exhibit.
fn write(folder: &Path, number: usize, exhibit: Exhibit) -> Result<Shown> {
    Ok(match exhibit {
        Exhibit::Table(table) => Shown::Table(table),
        Exhibit::Note(text) => Shown::Note(text),
        Exhibit::Plot(plot) => {
            let file = format!("plot{number}.svg");
            let svg = plot.svg().map_err(|e| cannot(&folder.join(&file), e))?;
            write_text(&folder.join(&file), &svg)?;
            Shown::Plot { file, plot }
        }
        Exhibit::Images(images) => {
            let mut shown = Vec::new();
            for (place, image) in images.into_iter().enumerate() {
                let file = format!("picture{number}-{place}.png");
                output::save(&folder.join(&file), &image.picture, &image.display)?;
                let size = [image.picture.width, image.picture.height].map(|n| n * image.zoom);
                shown.push(ShownImage { file, caption: image.caption, size });
            }
            Shown::Images(shown)
        }
    })
}

fn write_json(file: &Path, value: &impl Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value).map_err(|e| cannot(file, e))?;
    write_text(file, &(text + "\n"))
}

/// Puts a text at its place whole or not at all.
fn write_text(file: &Path, text: &str) -> Result<()> {
    let part = file.with_extension("part");
    fs::write(&part, text).and_then(|()| fs::rename(&part, file)).map_err(|e| cannot(file, e))
}

fn cannot(file: &Path, reason: impl std::fmt::Display) -> Error {
    Error::CannotWrite { file: file.into(), reason: reason.to_string() }
}
