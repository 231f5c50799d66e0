//! The closed table of experiments.

use crate::artifacts;
use crate::convergence;
use crate::error::{Error, Result};
use crate::experiment::Experiment;
use crate::jarosz05;
use crate::keller96;
use crate::keller97;
use crate::slides;
use crate::wald02;

/// All of them, in the order of the page.
pub const ALL: &[Experiment] = &[
    keller96::DISCREPANCY,
    keller96::TABLE_1,
    keller96::TABLE_2,
    keller96::GATHERING,
    keller96::FULL,
    keller96::RADIUS,
    keller97::FIGURE_1,
    keller97::FIGURE_4,
    keller97::FIGURE_5,
    keller97::FIGURE_7,
    keller97::FIGURE_8,
    keller97::FIGURE_9,
    keller97::FIGURE_10,
    keller97::FIGURE_11,
    keller97::FIGURE_12,
    keller97::ENDS,
    keller97::THINNING,
    artifacts::ARTIFACTS,
    slides::HALTON,
    keller97::GLOSS,
    wald02::FIGURE_3,
    wald02::TABLE_1,
    wald02::SCENES,
    jarosz05::TABLE_1,
    jarosz05::FIGURE_9,
    jarosz05::CACHING,
    jarosz05::SHADOWS,
    convergence::CONVERGENCE,
];

/// Those of the names given, in the order of the table, each once; `all` stands for all of them.
///
/// # Errors
/// [`Error::Unknown`] with the names that there are.
pub fn select<S: AsRef<str>>(names: &[S]) -> Result<Vec<&'static Experiment>> {
    let asked = |name: &str| names.iter().any(|n| n.as_ref() == name);
    if let Some(name) =
        names.iter().map(AsRef::as_ref).find(|n| *n != "all" && ALL.iter().all(|e| e.name != *n))
    {
        let known: Vec<&str> = ALL.iter().map(|e| e.name).collect();
        return Err(Error::Unknown { name: name.into(), known: known.join(", ") });
    }
    Ok(ALL.iter().filter(|e| asked("all") || asked(e.name)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn names_are_unique_and_fit_for_folders() {
        let names: BTreeSet<&str> = ALL.iter().map(|e| e.name).collect();
        assert_eq!(names.len(), ALL.len());
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(names.iter().all(|n| !n.is_empty() && n.chars().all(plain) && *n != "all"));
        assert!(ALL.iter().all(|e| e.seconds[0] <= 15.0 && e.seconds[0] <= e.seconds[1]));
    }

    #[test]
    fn names_select() {
        assert_eq!(select(&["all"]).unwrap().len(), ALL.len());
        assert_eq!(select(&[ALL[0].name, ALL[0].name]).unwrap().len(), 1);
        let error = select(&[ALL[0].name, "alchemy"]).err().unwrap().to_string();
        assert!(error.contains("\"alchemy\"") && error.contains(ALL[0].name), "{error}");
    }
}
