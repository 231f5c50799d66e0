//! Lampyris: global illumination by virtual point lights.

pub mod backend;
pub mod color;
pub mod cpu;
pub mod error;
pub mod eye;
pub mod frame;
pub mod geometry;
pub mod import;
pub mod integrator;
pub mod light;
pub mod material;
#[cfg(feature = "pictures")]
pub mod output;
pub mod particle;
pub mod sampling;
pub mod scene;
pub mod sequence;
pub mod testing;
pub mod world;

pub use color::Rgb;
pub use error::{Error, Result};
