//! The figures of Keller's report of 1997.

mod aliasing;
mod fourier;
mod patterns;
mod thinning;

pub(crate) use aliasing::FIGURE_8;
pub(crate) use fourier::FIGURE_7;
pub(crate) use patterns::{FIGURE_1, FIGURE_4};
pub(crate) use thinning::THINNING;
