//! Lampyris: global illumination by virtual point lights.

pub mod color;
pub mod error;
pub mod geometry;
pub mod import;
pub mod light;
pub mod material;
pub mod sampling;
pub mod scene;
pub mod sequence;
pub mod testing;

pub use color::Rgb;
pub use error::{Error, Result};
