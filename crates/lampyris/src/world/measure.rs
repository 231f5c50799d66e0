//! Figures of the whole scene: its extent, its area, what it reflects in the mean. They are sums over instances, so that
//! an edit measures anew only what it touches, and sums to the same bits.

use super::Facets;
use crate::light::{Bounds, Light, State};
use glam::Vec3;

/// What one instance adds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    lo: Vec3,
    hi: Vec3,
    /// [m²]
    area: f64,
    /// Σ ρ_k A_k [m²]
    reflected: f64,
}

/// The sums.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Figures {
    /// The sphere around everything.
    pub(super) bounds: Bounds,
    /// Total area of all surfaces [m²], each side counted once.
    pub(super) area: f32,
    /// ρ̄ = Σ ρ_k A_k / Σ A_k [Keller97, §3.2]
    pub(super) mean_reflectance: f32,
}

impl Extent {
    /// Of an instance, by the mean albedo of each material.
    pub(super) fn new(facets: &Facets, albedos: &[f32], instance: u32) -> Extent {
        let mut sum = Extent { lo: Vec3::INFINITY, hi: Vec3::NEG_INFINITY, area: 0.0, reflected: 0.0 };
        for triangle in 0..facets.count(instance) {
            let [a, b, c] = facets.corners(instance, triangle);
            let a2 = f64::from((b - a).cross(c - a).length());
            if !a2.is_finite() {
                continue;
            }
            for p in [a, b, c] {
                (sum.lo, sum.hi) = (sum.lo.min(p), sum.hi.max(p));
            }
            sum.area += 0.5 * a2;
            sum.reflected += 0.5 * a2 * f64::from(albedos[facets.material(instance, triangle) as usize]);
        }
        sum
    }
}

impl Figures {
    /// Of all instances, and of the lights that are no surfaces.
    pub(super) fn new(extents: &[Extent], lights: &[Light]) -> Figures {
        let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (mut area, mut reflected) = (0.0, 0.0);
        for e in extents {
            (lo, hi) = (lo.min(e.lo), hi.max(e.hi));
            area += e.area;
            reflected += e.reflected;
        }
        for light in lights.iter().filter(|l| l.state != State::Away && l.is_sound()) {
            if let Some((p, r)) = light.extent() {
                (lo, hi) = (lo.min(p - r), hi.max(p + r));
            }
        }
        let mut bounds = Bounds::default();
        if lo.x <= hi.x {
            // A little more than the box's sphere: distant light starts outside everything.
            bounds = Bounds { center: (lo + hi) * 0.5, radius: 0.5 * (hi - lo).length() * 1.001 };
        }
        if bounds.radius == 0.0 {
            // Over nothing at all the sky still has a share of the paths, and lights meters.
            bounds.radius = 1.0;
        }
        let mean_reflectance = if area > 0.0 { (reflected / area) as f32 } else { 0.0 };
        Figures { bounds, area: area as f32, mean_reflectance }
    }
}
