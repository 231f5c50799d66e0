//! The figures of Keller's report of 1997.

mod aliasing;
mod ends;
mod fourier;
mod gloss;
mod patterns;
mod speed;
mod thinning;
mod walk;

pub(crate) use aliasing::FIGURE_8;
pub(crate) use ends::ENDS;
pub(crate) use fourier::FIGURE_7;
pub(crate) use gloss::{FIGURE_11, GLOSS};
pub(crate) use patterns::{FIGURE_1, FIGURE_4};
pub(crate) use speed::{FIGURE_10, FIGURE_12};
pub(crate) use thinning::THINNING;
pub(crate) use walk::{FIGURE_5, FIGURE_9};
