//! Facets by the GGX distribution of Trowbridge and Reitz [Walter et al. 2007], with the height-correlated Smith term
//! [Heitz 2014], drawn as far as they are visible. Isotropic; what a facet reflects or lets pass is its user's matter.

use super::{Class, DELTA_ALPHA, SHARP_ALPHA};
use crate::sampling::uniform_cap;
use glam::Vec3;
use std::f32::consts::PI;

/// A rough plane of facets about +z. All directions given lie above it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ggx {
    /// Width of the distribution of slopes, ≥ 0.
    pub(super) alpha: f32,
}

impl Ggx {
    pub(super) fn class(self) -> Class {
        if self.alpha < SHARP_ALPHA { Class::Sharp } else { Class::Dull }
    }

    pub(super) fn is_delta(self) -> bool {
        self.alpha < DELTA_ALPHA
    }

    /// D [sr⁻¹] of a facet whose normal `h` need not be a unit vector.
    fn density(self, h: Vec3) -> f32 {
        let alpha2 = self.alpha * self.alpha;
        // In slopes over α: nothing cancels where h is close to +z.
        let q = ((h.x * h.x + h.y * h.y) / alpha2 + h.z * h.z) / h.length_squared();
        1.0 / (PI * alpha2 * q * q)
    }

    /// cos θ (1 + 2Λ), with Smith's Λ for the cosine `z`.
    fn stretch(self, z: f32) -> f32 {
        (self.alpha * self.alpha * (1.0 - z * z).max(0.0) + z * z).sqrt()
    }

    /// G₂/(cos θ_o cos θ_i): the share of facets seen from both sides, over the projections.
    fn shadowing(self, zo: f32, zi: f32) -> f32 {
        2.0 / (zi * self.stretch(zo) + zo * self.stretch(zi)).max(f32::MIN_POSITIVE)
    }

    /// G₁/cos θ for one direction alone.
    fn masking(self, z: f32) -> f32 {
        2.0 / (z + self.stretch(z)).max(f32::MIN_POSITIVE)
    }

    /// (f_r of perfectly reflecting facets, density of drawing `wi` by [`Self::facet`]) [sr⁻¹].
    pub(super) fn reflection(self, wo: Vec3, wi: Vec3) -> (f32, f32) {
        let h = wo + wi;
        // Both within 1e-6 of the horizon and opposite each other: no facet, and no digits.
        if h.length_squared() < 1e-12 {
            return (0.0, 0.0);
        }
        let d = 0.25 * self.density(h);
        (d * self.shadowing(wo.z, wi.z), d * self.masking(wo.z))
    }

    /// (G₂ D/(cos θ_o cos θ_i), G₁ D/cos θ_o) at the facet `h` for a direction `zi` beyond the surface: what refraction
    /// multiplies by its own Jacobian.
    pub(super) fn passage(self, zo: f32, h: Vec3, zi: f32) -> (f32, f32) {
        let d = self.density(h);
        (d * self.shadowing(zo, zi), d * self.masking(zo))
    }

    /// G₂/G₁: the weight of a facet drawn for `zo` when light goes on at `zi`; at most 1.
    pub(super) fn weight(self, zo: f32, zi: f32) -> f32 {
        (zi * (zo + self.stretch(zo))
            / (zi * self.stretch(zo) + zo * self.stretch(zi)).max(f32::MIN_POSITIVE))
        .min(1.0)
    }

    /// Draws the normal of a facet in proportion to what `wo` sees of it: on a stretched sphere these are the half
    /// vectors of a cap [Dupuy and Benyoub 2023].
    pub(super) fn facet(self, wo: Vec3, u: [f32; 2]) -> Vec3 {
        let seen = Vec3::new(self.alpha * wo.x, self.alpha * wo.y, wo.z).normalize_or(Vec3::Z);
        let h = uniform_cap(u, 1.0 + seen.z) + seen;
        Vec3::new(self.alpha * h.x, self.alpha * h.y, h.z.max(0.0)).normalize_or(Vec3::Z)
    }

    /// Draws the direction in which a visible facet mirrors `wo`; `None` where it points below the surface.
    pub(super) fn reflect(self, wo: Vec3, u: [f32; 2]) -> Option<Vec3> {
        let h = self.facet(wo, u);
        let wi = (h * (2.0 * wo.dot(h)) - wo).normalize();
        (wi.z > 0.0).then_some(wi)
    }
}
