//! Smooth glass: Fresnel reflection and Snell refraction at the interface of a solid body.
//! Exact Fresnel terms, total internal reflection; no absorption inside the body, no roughness, and no memory of
//! polarisation: a pane at 60° passes 0.831 of the light where the two polarisations apart would pass 0.843.

use super::{Class, Scatter, Transport};
use crate::color::Rgb;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// The interface between air (outside, +z) and a transparent body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dielectric {
    /// Index of refraction of the body, > 0.
    pub ior: f32,
    /// Factor on light that passes the interface.
    pub transmittance: Rgb,
    /// GGX's α; 0 is smooth.
    pub alpha: f32,
    /// σ of Beer's law inside the body [m⁻¹].
    pub attenuation: Rgb,
}

impl Dielectric {
    /// Smooth and clear.
    pub const fn new(ior: f32, transmittance: Rgb) -> Dielectric {
        Dielectric { ior, transmittance, alpha: 0.0, attenuation: Rgb::BLACK }
    }

    /// Reflects or refracts by Fresnel's share; `wo.z < 0` means that `wo` runs inside the body.
    ///
    /// The weight is 1 in reflection. In refraction it is the tint, for [`Transport::Radiance`] times (η_o/η_i)²:
    /// L/η² is what stays constant along a refracted ray, while the flux of a particle stays itself.
    pub fn sample(&self, class: Class, wo: Vec3, choice: f32, transport: Transport) -> Option<Scatter> {
        if class != Class::Sharp {
            return None;
        }
        let eta = self.relative_ior(wo);
        let (reflectance, cos_t) = fresnel(wo.z.abs(), eta);
        if choice < reflectance {
            let wi = Vec3::new(-wo.x, -wo.y, wo.z);
            return Some(Scatter { wi, weight: Rgb::WHITE, pdf: f32::INFINITY });
        }
        if self.transmittance.is_black() {
            return None;
        }
        let wi = Vec3::new(-eta * wo.x, -eta * wo.y, -cos_t.copysign(wo.z)).normalize();
        let scale = match transport {
            Transport::Radiance => eta * eta,
            Transport::Flux => 1.0,
        };
        Some(Scatter { wi, weight: self.transmittance * scale, pdf: f32::INFINITY })
    }

    /// What is reflected and what passes, both sharply, counted in flux.
    pub fn albedo(&self, class: Class, wo: Vec3) -> Rgb {
        if class != Class::Sharp {
            return Rgb::BLACK;
        }
        let (reflectance, _) = fresnel(wo.z.abs(), self.relative_ior(wo));
        Rgb::grey(reflectance) + self.transmittance * (1.0 - reflectance)
    }

    /// η on the side of `wo` over η on the other.
    fn relative_ior(&self, wo: Vec3) -> f32 {
        if wo.z < 0.0 { self.ior } else { 1.0 / self.ior }
    }
}

/// Fresnel's reflectance for unpolarised light that meets a smooth interface at `cos_i` ≥ 0, and the cosine of the
/// refracted angle. `eta` is the index on the side of the light over the index beyond; (1, 0) in total reflection.
pub fn fresnel(cos_i: f32, eta: f32) -> (f32, f32) {
    let sin2_t = eta * eta * (1.0 - cos_i * cos_i).max(0.0);
    // At exactly grazing incidence everything is reflected, whatever the indices.
    if sin2_t >= 1.0 || cos_i <= 0.0 {
        return (1.0, 0.0);
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    let perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    (0.5 * (perpendicular * perpendicular + parallel * parallel), cos_t)
}
