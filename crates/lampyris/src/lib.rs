//! Lampyris: global illumination by virtual point lights.

pub mod color;
pub mod error;
pub mod geometry;
pub mod import;
pub mod light;
pub mod material;
#[cfg(feature = "pictures")]
pub mod output;
pub mod sampling;
pub mod scene;
pub mod sequence;

pub use color::Rgb;
pub use error::{Error, Result};
