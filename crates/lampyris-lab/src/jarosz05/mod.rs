//! Jarosz' thesis: what the phases of photon mapping take, and photons drawn as points and discs.

mod caching;
mod figure;
mod phases;
mod shadows;
mod splats;
mod table;

pub(crate) use caching::CACHING;
pub(crate) use figure::FIGURE_9;
pub(crate) use shadows::SHADOWS;
pub(crate) use table::TABLE_1;

/// The thesis.
const JAROSZ05: &str =
    "W. Jarosz, Interactive Global Illumination for Improved Lighting Design Workflow, 2005";
