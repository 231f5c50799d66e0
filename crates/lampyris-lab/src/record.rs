//! What a finished experiment leaves in the folder of a report, to be put on its page.

use crate::findings::{Comparison, Table};
use crate::plot::Plot;
use serde::{Deserialize, Serialize};

/// What a finished experiment left in its folder.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) paper: String,
    pub(crate) place: String,
    pub(crate) claim: String,
    /// By small settings.
    pub(crate) quick: bool,
    /// How long it took [s].
    pub(crate) seconds: f64,
    /// Threads of the machine.
    pub(crate) threads: usize,
    /// Of which version.
    pub(crate) version: String,
    pub(crate) comparisons: Vec<Comparison>,
    pub(crate) exhibits: Vec<Shown>,
    pub(crate) gaps: Vec<String>,
}

/// An exhibit whose files are written; they are named within the experiment's folder.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Shown {
    Table(Table),
    Plot { file: String, plot: Plot },
    Images(Vec<ShownImage>),
    Note(String),
}

/// A picture that is written.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct ShownImage {
    pub(crate) file: String,
    pub(crate) caption: String,
    /// On the page [pixels].
    pub(crate) size: [u32; 2],
}
