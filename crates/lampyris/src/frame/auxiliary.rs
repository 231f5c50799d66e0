//! What the eye meets first, for those who denoise, compose or pick.

use crate::color::Rgb;

/// Means of what the eye meets first, pixel by pixel.
#[derive(Clone, Debug, Default)]
pub struct Auxiliary {
    /// Sum of directional albedos.
    pub albedo: Vec<Rgb>,
    /// Sum of shading normals, as (x, y, z).
    pub normal: Vec<Rgb>,
    /// Sum of distances to the first surface [m]; 0 where the eye looks into the void.
    pub depth: Vec<f32>,
    /// 1 + number of the instance seen at the pixel's first sample; 0 for the void.
    pub object: Vec<u32>,
    /// Samples in the sums.
    pub samples: u32,
}

impl Auxiliary {
    pub(crate) fn new(pixels: usize) -> Auxiliary {
        Auxiliary {
            albedo: vec![Rgb::BLACK; pixels],
            normal: vec![Rgb::BLACK; pixels],
            depth: vec![0.0; pixels],
            object: vec![0; pixels],
            samples: 0,
        }
    }

    /// Adds pixel `from` of `other` to pixel `at`.
    pub(crate) fn add(&mut self, at: usize, other: &Auxiliary, from: usize) {
        self.albedo[at] += other.albedo[from];
        self.normal[at] += other.normal[from];
        self.depth[at] += other.depth[from];
        if self.object[at] == 0 {
            self.object[at] = other.object[from];
        }
    }
}
