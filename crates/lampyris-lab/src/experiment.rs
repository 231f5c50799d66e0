//! What an experiment is.

use crate::effort::Effort;
use crate::error::Result;
use crate::findings::Findings;

/// A row of the table.
pub struct Experiment {
    /// The name by which it is asked for, also that of its folder in a report.
    pub name: &'static str,
    /// What it is about, in a line.
    pub title: &'static str,
    /// Which paper.
    pub paper: &'static str,
    /// Where in it.
    pub place: &'static str,
    /// What it claims there.
    pub claim: &'static str,
    /// About how long it takes on two cores, quickly and in full [s]: an estimate until something was measured.
    pub seconds: [f64; 2],
    /// Measures.
    pub run: fn(&Effort<'_>) -> Result<Findings>,
}

/// Keller's report of 1997.
pub(crate) const KELLER97: &str = "A. Keller, Instant Radiosity, 1997";
