//! A material made ready for shading: what every hit asks is worked out once.

use crate::color::Rgb;
use crate::material::{Bsdf, Class, Diffuse, Material, Sides};
use glam::Vec3;

/// A material with its answers at hand.
#[derive(Clone, Debug)]
pub struct Finish {
    /// Scattering.
    pub bsdf: Bsdf,
    /// Radiance from each side that glows [cd/m²].
    pub emission: Rgb,
    /// True if the back glows like the front.
    pub both_sides_glow: bool,
    /// Albedo of the sharp lobes at normal incidence.
    pub sharp: Rgb,
    /// Albedo of the dull lobes at normal incidence.
    pub dull: Rgb,
    /// ρ_d if the dull lobes are a Lambertian reflector's.
    pub lambertian: Option<Rgb>,
    /// True if dull lobes send light through the surface.
    pub transmits: bool,
}

/// A perfectly white receiver: its radiance is illuminance / π.
pub(super) static WHITE: Finish = Finish {
    bsdf: Bsdf::Diffuse(Diffuse { reflectance: Rgb::WHITE, transmittance: Rgb::BLACK }),
    emission: Rgb::BLACK,
    both_sides_glow: false,
    sharp: Rgb::BLACK,
    dull: Rgb::WHITE,
    lambertian: Some(Rgb::WHITE),
    transmits: false,
};

impl From<&Material> for Finish {
    fn from(m: &Material) -> Finish {
        Finish {
            bsdf: m.bsdf.clone(),
            emission: m.emission,
            both_sides_glow: m.sides == Sides::Both,
            sharp: m.bsdf.albedo(Class::Sharp, Vec3::Z),
            dull: m.bsdf.albedo(Class::Dull, Vec3::Z),
            lambertian: m.bsdf.lambertian(),
            transmits: m.bsdf.transmits(),
        }
    }
}

impl Finish {
    /// How likely a path should scatter by each class: (sharp, dull), the brightest channel of either, not negative.
    pub fn weights(&self) -> (f32, f32) {
        (self.sharp.max_channel().max(0.0), self.dull.max_channel().max(0.0))
    }
}
