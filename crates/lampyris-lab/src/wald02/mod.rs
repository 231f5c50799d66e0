//! The figures and tables of Wald and others, 2002.

mod interleaving;
mod scaling;
pub mod workload;

pub(crate) use interleaving::FIGURE_3;
pub(crate) use scaling::{SCENES, TABLE_1};

/// The paper.
pub(crate) const WALD02: &str =
    "I. Wald, T. Kollig, C. Benthin, A. Keller and P. Slusallek, Interactive Global Illumination, 2002";
