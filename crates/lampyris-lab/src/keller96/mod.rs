//! The tables of Keller's paper of 1996, and the discrepancies that they rest on.

mod bias;
mod discrepancy;
mod gathering;
mod rooms;
mod solved;

pub(crate) use bias::{FULL, RADIUS};
pub(crate) use discrepancy::DISCREPANCY;
pub(crate) use gathering::GATHERING;
pub(crate) use rooms::TABLE_2;
pub(crate) use solved::TABLE_1;

/// The paper.
pub(crate) const KELLER96: &str =
    "A. Keller, Quasi-Monte Carlo Methods in Computer Graphics: The Global Illumination Problem, 1996";
