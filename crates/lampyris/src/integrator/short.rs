//! Short rays, which pay back what clamping took from lights nearby: G > b only within 1/√b. They leave a point by its
//! dull lobes and go straight, or are folded once at a planar mirror, where the distance in G is the unfolded one.

use crate::color::Rgb;
use crate::eye::Numbers;
use crate::geometry::Ray;
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::world::{Surface, World};

/// How a short ray may go. A part of the light asks for one way; where parts are no longer told apart, chance decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// To what it meets.
    Straight,
    /// Over one planar mirror.
    Folded,
    /// Both.
    Either,
}

/// A short ray, after its fold if it has one.
pub(super) struct Short<'w> {
    /// What is left of it.
    pub(super) ray: Ray,
    /// What it meets.
    pub(super) met: Option<Surface<'w>>,
    /// f_r cos/pdf, and what the mirror reflects, over the probability of the way.
    pub(super) weight: Rgb,
    /// The surface that the ray leaves, and how far the point is from there [m].
    from: Surface<'w>,
    walked: f32,
    /// Cosine at the point.
    cosine: f32,
}

impl<'w> Short<'w> {
    /// A ray from `x` of length `reach` in all, by the numbers of one vertex.
    pub(super) fn new(
        world: &'w World,
        x: &Surface<'w>,
        way: Way,
        reach: f32,
        numbers: Numbers,
        vertex: u32,
        rays: &mut u64,
    ) -> Option<Short<'w>> {
        let u = numbers.pair(ledger::direction(vertex));
        let s = x.sample(Class::Dull, u, numbers.one(ledger::lobe(vertex)))?;
        let ray = Ray { origin: x.spawn(s.wi), direction: s.wi, t_max: reach };
        *rays += 1;
        let met = world.closest(&ray);
        let cosine = x.cosine(s.wi);
        let straight = Short { ray, met, weight: s.weight, from: *x, walked: 0.0, cosine };
        let Some(mirror) = met.filter(|p| p.mirror.is_some() && way != Way::Straight) else {
            return (way != Way::Folded).then_some(straight);
        };
        let fold = match way {
            Way::Either if !mirror.finish.dull.is_black() => 0.5,
            _ => 1.0,
        };
        if numbers.one(ledger::class(vertex)) >= fold {
            return Some(Short { weight: s.weight * (1.0 / (1.0 - fold)), ..straight });
        }
        let (direction, reflectance) = mirror.mirrored();
        let walked = (mirror.position - x.position).length();
        let ray = Ray { origin: mirror.spawn(direction), direction, t_max: reach - walked };
        if ray.t_max <= 0.0 {
            return None;
        }
        *rays += 1;
        let weight = s.weight * mirror.clear_from(x.position, Some(x)) * reflectance * (1.0 / fold);
        Some(Short { ray, met: world.closest(&ray), weight, from: mirror, walked, cosine })
    }

    /// What Beer's law leaves of light on its way from the surface that the ray meets.
    pub(super) fn clear_from(&self, y: &Surface<'_>) -> Rgb {
        y.clear_from(self.ray.origin, Some(&self.from))
    }

    /// What it leaves of light from a distance along the ray.
    pub(super) fn clear_to(&self, distance: f32) -> Rgb {
        self.from.clear_to(self.ray.direction, distance, None)
    }

    /// (G − b)⁺/G for the surface that the ray meets.
    pub(super) fn taken_from(&self, y: &Surface<'_>, b: f32) -> f32 {
        self.taken((y.position - self.from.position).length(), y.normal.dot(y.wo).abs(), b)
    }

    /// (G − b)⁺/G for what lies at a distance along the ray and faces it under a cosine.
    pub(super) fn taken(&self, distance: f32, cosine: f32, b: f32) -> f32 {
        let unfolded = self.walked + distance;
        let g = self.cosine * cosine / (unfolded * unfolded);
        if g > b { 1.0 - b / g } else { 0.0 }
    }
}
