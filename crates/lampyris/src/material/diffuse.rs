//! Lambert's law, in reflection and in transmission: f_r = ρ/π on the side of `wo`, τ/π on the other.

use super::{Class, Scatter, same_side};
use crate::color::Rgb;
use crate::sampling::cosine_hemisphere;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::f32::consts::FRAC_1_PI;

/// A Lambertian surface. Energy asks for reflectance + transmittance ≤ 1 in each channel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Diffuse {
    /// ρ_d, hemispherical reflectance.
    pub reflectance: Rgb,
    /// τ_d, hemispherical transmittance (a lampshade, a curtain).
    pub transmittance: Rgb,
}

impl Diffuse {
    /// An opaque Lambertian reflector.
    pub fn opaque(reflectance: Rgb) -> Diffuse {
        Diffuse { reflectance, transmittance: Rgb::BLACK }
    }

    /// f_r [sr⁻¹].
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        match class {
            Class::Sharp => Rgb::BLACK,
            Class::Dull if same_side(wo, wi) => self.reflectance * FRAC_1_PI,
            Class::Dull => self.transmittance * FRAC_1_PI,
        }
    }

    /// Cosine-distributed, on the reflecting or the transmitting side in proportion to their shares.
    pub fn sample(&self, class: Class, wo: Vec3, u: [f32; 2], choice: f32) -> Option<Scatter> {
        let p = self.reflected_share()?;
        if class == Class::Sharp {
            return None;
        }
        let up = cosine_hemisphere(u);
        let reflected = choice < p;
        let (value, p) = if reflected { (self.reflectance, p) } else { (self.transmittance, 1.0 - p) };
        let side = if reflected == (wo.z >= 0.0) { 1.0 } else { -1.0 };
        let wi = Vec3::new(up.x, up.y, up.z * side);
        Some(Scatter { wi, weight: value / p, pdf: p * up.z * FRAC_1_PI })
    }

    /// Density of `sample` [sr⁻¹].
    pub fn pdf(&self, class: Class, wo: Vec3, wi: Vec3) -> f32 {
        match (class, self.reflected_share()) {
            (Class::Dull, Some(p)) => (if same_side(wo, wi) { p } else { 1.0 - p }) * wi.z.abs() * FRAC_1_PI,
            _ => 0.0,
        }
    }

    /// ρ + τ.
    pub fn albedo(&self, class: Class) -> Rgb {
        if class == Class::Dull { self.reflectance + self.transmittance } else { Rgb::BLACK }
    }

    /// ρ, unless light also passes.
    pub fn lambertian(&self) -> Option<Rgb> {
        self.transmittance.is_black().then_some(self.reflectance)
    }

    /// Probability of the reflecting side; `None` for a perfect absorber.
    fn reflected_share(&self) -> Option<f32> {
        let r = self.reflectance.max_channel().max(0.0);
        let t = self.transmittance.max_channel().max(0.0);
        (r + t > 0.0).then(|| r / (r + t))
    }
}
