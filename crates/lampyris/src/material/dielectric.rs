//! Glass: Fresnel reflection and Snell refraction at the interface of a solid body, smooth or by GGX facets
//! [Walter et al. 2007]. Exact Fresnel terms, total internal reflection; no memory of polarisation: a solid pane at 60°
//! passes 0.831 of the light where the two polarisations apart would pass 0.843. Light that falls from facet to facet
//! is lost. What the body itself absorbs is the business of who follows the light (`world::Surface`).

use super::ggx::Ggx;
use super::{Class, Scatter, Transport, same_side};
use crate::color::Rgb;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// Indices of refraction as close as this to that of air bend light too little for a lobe to be told from a ray.
const NO_INTERFACE: f32 = 0.01;

/// The interface between air (outside, +z) and a transparent body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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

    /// f_r [sr⁻¹] for light that arrives from `wi` and leaves toward `wo`: the other way round it differs by the squares
    /// of the indices. A smooth interface evaluates to black.
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        let ggx = self.ggx();
        if class != ggx.class() || ggx.is_delta() {
            return Rgb::BLACK;
        }
        let eta = self.relative_ior(wo);
        if same_side(wo, wi) {
            let (wo, wi) = (above(wo, wo), above(wi, wo));
            let (reflectance, _) = fresnel(0.5 * (wo + wi).length(), eta);
            return Rgb::grey(reflectance * ggx.reflection(wo, wi).0);
        }
        let (wo, wi) = (above(wo, wo), above(wi, wo));
        bend(wo, wi, eta).map_or(Rgb::BLACK, |(facet, passed, jacobian)| {
            let (both, _) = ggx.passage(wo.z, facet, -wi.z);
            self.transmittance * (passed * both * wo.dot(facet) * jacobian * eta * eta)
        })
    }

    /// Reflects or refracts at a facet that `wo` sees, by Fresnel's share; `wo.z < 0` means that `wo` runs inside the
    /// body.
    ///
    /// The weight is 1 in reflection, less what facets hide. In refraction it is the tint besides, for
    /// [`Transport::Radiance`] times (η_o/η_i)²: L/η² is what stays constant along a refracted ray, while the flux of a
    /// particle stays itself.
    pub fn sample(
        &self,
        class: Class,
        wo: Vec3,
        u: [f32; 2],
        choice: f32,
        transport: Transport,
    ) -> Option<Scatter> {
        let ggx = self.ggx();
        if class != ggx.class() {
            return None;
        }
        let eta = self.relative_ior(wo);
        let up = above(wo, wo);
        let facet = self.facet(up, u);
        let cos_o = up.dot(facet);
        let (reflectance, cos_t) = fresnel(cos_o, eta);
        let (wi, weight) = if choice < reflectance {
            (facet * (2.0 * cos_o) - up, Rgb::WHITE)
        } else {
            let scale = match transport {
                Transport::Radiance => eta * eta,
                Transport::Flux => 1.0,
            };
            ((facet * (eta * cos_o - cos_t) - up * eta).normalize(), self.transmittance * scale)
        };
        // A facet may send light to the wrong side.
        if weight.is_black() || (choice < reflectance) != (wi.z > 0.0) {
            return None;
        }
        let wi = above(wi, wo);
        if ggx.is_delta() {
            return Some(Scatter { wi, weight, pdf: f32::INFINITY });
        }
        let pdf = self.pdf(class, wo, wi);
        (pdf > 0.0).then(|| Scatter { wi, weight: weight * ggx.weight(up.z, wi.z.abs()), pdf })
    }

    /// The chance of `sample` to reflect at the facet that `u` draws.
    pub fn reflected_share(&self, wo: Vec3, u: [f32; 2]) -> f32 {
        let up = above(wo, wo);
        fresnel(up.dot(self.facet(up, u)), self.relative_ior(wo)).0
    }

    /// The normal of a facet that is seen from `up`.
    fn facet(&self, up: Vec3, u: [f32; 2]) -> Vec3 {
        let ggx = self.ggx();
        if ggx.is_delta() { Vec3::Z } else { ggx.facet(up, u) }
    }

    /// Density of `sample` [sr⁻¹].
    pub fn pdf(&self, class: Class, wo: Vec3, wi: Vec3) -> f32 {
        let ggx = self.ggx();
        if class != ggx.class() || ggx.is_delta() {
            return 0.0;
        }
        let eta = self.relative_ior(wo);
        let reflected = same_side(wo, wi);
        let (wo, wi) = (above(wo, wo), above(wi, wo));
        if reflected {
            return fresnel(0.5 * (wo + wi).length(), eta).0 * ggx.reflection(wo, wi).1;
        }
        bend(wo, wi, eta).map_or(0.0, |(facet, passed, jacobian)| {
            let (_, one) = ggx.passage(wo.z, facet, -wi.z);
            if self.transmittance.is_black() { 0.0 } else { passed * one * wo.dot(facet) * jacobian }
        })
    }

    /// What is reflected and what passes, counted in flux.
    pub fn albedo(&self, class: Class, wo: Vec3) -> Rgb {
        if class != self.ggx().class() {
            return Rgb::BLACK;
        }
        let (reflectance, _) = fresnel(wo.z.abs(), self.relative_ior(wo));
        Rgb::grey(reflectance) + self.transmittance * (1.0 - reflectance)
    }

    /// True if the facets are rough enough for the dull class.
    pub fn is_dull(&self) -> bool {
        self.ggx().class() == Class::Dull
    }

    fn ggx(&self) -> Ggx {
        let bends = (self.ior - 1.0).abs() > NO_INTERFACE;
        Ggx { alpha: if bends { self.alpha.clamp(0.0, 1.0) } else { 0.0 } }
    }

    /// η on the side of `wo` over η on the other.
    fn relative_ior(&self, wo: Vec3) -> f32 {
        if wo.z < 0.0 { self.ior } else { 1.0 / self.ior }
    }
}

/// `w` in the frame whose +z lies on the side of `wo`.
fn above(w: Vec3, wo: Vec3) -> Vec3 {
    if wo.z < 0.0 { Vec3::new(w.x, w.y, -w.z) } else { w }
}

/// The facet that refracts `wi` (below) into `wo` (above), the share that passes it, and the Jacobian
/// |wi·h| / (η wo·h + wi·h)² of its normal by `wi` [Walter et al. 2007, eq. 17].
fn bend(wo: Vec3, wi: Vec3, eta: f32) -> Option<(Vec3, f32, f32)> {
    let h = wo * eta + wi;
    let facet = h.try_normalize()?;
    let facet = if facet.z < 0.0 { -facet } else { facet };
    let (cos_o, cos_i) = (wo.dot(facet), wi.dot(facet));
    if cos_o <= 0.0 || cos_i >= 0.0 {
        return None;
    }
    // 1 − F from both cosines, which are known: alike from both sides, and exact where almost all is reflected.
    let across = |sum: f32| -2.0 * eta * cos_o * cos_i / (sum * sum);
    let passed = across(eta * cos_o - cos_i) + across(cos_o - eta * cos_i);
    Some((facet, passed, -cos_i / h.length_squared()))
}

/// Fresnel's reflectance for unpolarised light that meets a smooth interface at `cos_i` ≥ 0, and the cosine of the
/// refracted angle. `eta` is the index on the side of the light over the index beyond; (1, 0) in total reflection.
pub fn fresnel(cos_i: f32, eta: f32) -> (f32, f32) {
    let ([perpendicular, parallel], cos_t) = fresnel_polarised(cos_i, eta);
    (0.5 * (perpendicular + parallel), cos_t)
}

/// [`fresnel`] for light polarised perpendicular and parallel to the plane of incidence.
pub(super) fn fresnel_polarised(cos_i: f32, eta: f32) -> ([f32; 2], f32) {
    let sin2_t = eta * eta * (1.0 - cos_i * cos_i).max(0.0);
    // At exactly grazing incidence everything is reflected, whatever the indices.
    if sin2_t >= 1.0 || cos_i <= 0.0 {
        return ([1.0; 2], 0.0);
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    let perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    ([perpendicular * perpendicular, parallel * parallel], cos_t)
}
