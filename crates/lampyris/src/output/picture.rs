//! A finished picture: planes of numbers and what they are, still in scene units.
//! It knows nothing of files, displays or how it came about.

use crate::color::Rgb;
use glam::Vec3;

/// What was rendered. Every plane has `width · height` pixels, row by row from the upper left corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Width [pixels].
    pub width: u32,
    /// Height [pixels].
    pub height: u32,
    /// Radiance towards the eye [cd/m²]; may be negative where a colour lies outside the gamut.
    pub radiance: Vec<Rgb>,
    /// Further planes, for formats that hold them.
    pub layers: Vec<Layer>,
    /// What repeats the picture: names and values, in this order.
    pub metadata: Vec<(String, String)>,
}

/// A named plane beside the picture itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Name of the part in the file.
    pub name: String,
    /// The numbers.
    pub plane: Plane,
}

/// The kinds of planes, which decide the names of their channels.
#[derive(Clone, Debug, PartialEq)]
pub enum Plane {
    /// Radiance [cd/m²] or a reflectance: R, G, B.
    Color(Vec<Rgb>),
    /// Unit vectors in world space, zero where nothing was hit: X, Y, Z.
    Normal(Vec<Vec3>),
    /// Distance from the eye [m], infinite where nothing was hit: Z.
    Depth(Vec<f32>),
    /// Number of the instance + 1, 0 where nothing was hit: id.
    Id(Vec<u32>),
}

impl Plane {
    /// How many pixels there are.
    pub fn len(&self) -> usize {
        match self {
            Plane::Color(p) => p.len(),
            Plane::Normal(p) => p.len(),
            Plane::Depth(p) => p.len(),
            Plane::Id(p) => p.len(),
        }
    }

    /// True where there is no pixel at all.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Picture {
    /// A picture without further layers and metadata.
    pub fn new(width: u32, height: u32, radiance: Vec<Rgb>) -> Picture {
        Picture { width, height, radiance, ..Picture::default() }
    }

    /// Whether there is a pixel, and every plane has the picture's size; else what is wrong.
    pub(super) fn check(&self) -> Result<(), String> {
        let pixels = self.width as usize * self.height as usize;
        if pixels == 0 {
            return Err(format!("a picture of {} x {} pixels", self.width, self.height));
        }
        let planes = self.layers.iter().map(|l| (l.name.as_str(), l.plane.len()));
        match planes.chain([("radiance", self.radiance.len())]).find(|&(_, len)| len != pixels) {
            Some((name, len)) => Err(format!("layer {name} has {len} pixels, the picture {pixels}")),
            None => Ok(()),
        }
    }
}
