//! MGF, the Materials and Geometry Format of G. Ward (version 2; docs/formats.md says what is read and how it maps).
//! A line at a time: contexts keep what was named, geometry is placed and triangulated at once, arrays re-read their
//! block. Light distributions (`ies`) are not read yet.

mod args;
mod contexts;
mod entities;
mod geometry;
mod material;
mod reader;
mod shapes;
mod sink;
mod transform;

use super::{Loaded, Options};
use crate::error::Result;
use std::path::Path;

/// Loads an MGF file and what it includes.
pub(super) fn load(path: &Path, options: &Options) -> Result<Loaded> {
    reader::Reader::new(path, options)?.run()
}
