//! Pictures on surfaces: pixels, and how a place in the unit square looks them up.
//! Values multiply the factors of a material; which factor a texture feeds, the material says.
//!
//! There are no smaller copies of an image for distant surfaces: the many samples of a pixel are the filter.

mod lookup;
mod srgb;

pub use srgb::linear;

use serde::{Deserialize, Serialize};

/// Pixels, row by row from the upper left corner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Image {
    /// Name in the file.
    pub name: String,
    /// Width [pixels].
    pub width: u32,
    /// Height [pixels].
    pub height: u32,
    /// The pixels: `width` · `height` of them.
    pub pixels: Pixels,
}

/// The pixels as they are kept: in as few bytes as their file had.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Pixels {
    /// Red, green, blue and alpha of 8 bits; what the first three mean, [`Encoding`] says.
    Byte(Vec<[u8; 4]>),
    /// Linear red, green and blue without bounds.
    Float(Vec<[f32; 3]>),
}

/// What the bytes of an image mean. Alpha is linear always.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Encoding {
    /// Colours under the transfer function of IEC 61966-2-1.
    Srgb,
    /// Numbers.
    Linear,
}

/// What lies outside the unit square.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture and its mirror image in turn.
    Mirror,
    /// Its border.
    Clamp,
}

/// How values between pixel centres are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Filter {
    /// Bilinear.
    #[default]
    Linear,
    /// The nearest pixel's.
    Nearest,
}

/// An image with everything that a look-up needs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Texture {
    /// Which image of the scene.
    pub image: u32,
    /// What its bytes mean.
    pub encoding: Encoding,
    /// Beyond the left and right edge, and beyond the upper and lower one.
    pub wrap: [Wrap; 2],
    /// Between pixels.
    pub filter: Filter,
}
