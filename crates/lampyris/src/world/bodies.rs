//! Sharp bodies: what caustic photons are aimed at. A body is all that one instance has of one material with sharp lobes,
//! and the sphere and the box around it. They steer choices; no estimate depends on how tight they are.

use super::facet::Facets;
use super::finish::Finish;
use super::mirrors::Mirrors;
use super::surface::Surface;
use glam::Vec3;

/// Most bodies of a scene: each photon looks at all of them. What is left over counts as one.
pub const MOST_BODIES: usize = 64;

/// Least worth of a body: at grazing angles even what reflects little reflects all.
const LEAST_WORTH: f32 = 0.25;

/// Worth of a planar mirror: most of what it sends on is the part *mirror*, which needs no photons.
const MIRROR_WORTH: f32 = 0.25;

/// Spheres are wider than what they hold by this factor, which covers rounding.
const MARGIN: f32 = 1.0 + 1e-4;

/// A body that reflects or refracts sharply.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Centre of the sphere around it [m].
    pub center: Vec3,
    /// Its radius [m].
    pub radius: f32,
    /// The box around it.
    pub extent: [Vec3; 2],
    /// The share of the light that it sends on, roughly: how many photons it is worth.
    pub worth: f32,
}

/// All sharp bodies of a scene.
#[derive(Clone, Debug, Default)]
pub struct Bodies {
    bodies: Vec<Body>,
    /// They are more than one planar mirror.
    caustics: bool,
    /// Of each instance the materials with sharp lobes, and the bodies they belong to.
    of: Vec<Vec<(u32, u32)>>,
}

/// What an instance has of a material.
struct Part {
    instance: u32,
    material: u32,
    extent: [Vec3; 2],
    /// All of it lies in planar mirrors.
    plane: bool,
}

impl Bodies {
    /// Those among the facets; `sharp` says which materials have sharp lobes anywhere.
    pub(super) fn find(facets: &Facets, finishes: &[Finish], sharp: &[bool], mirrors: &Mirrors) -> Bodies {
        if !sharp.contains(&true) {
            return Bodies::default();
        }
        let facets = || {
            let finite = |corners: &[Vec3; 3]| corners.iter().all(|p| p.is_finite());
            facets.iter().filter(move |(_, _, f)| sharp[f.material as usize] && finite(&f.corners))
        };
        let mut parts: Vec<Part> = Vec::new();
        for (instance, triangle, facet) in facets() {
            let material = facet.material;
            // The parts of an instance lie together, at the end of the list.
            let of_instance = parts.iter().rev().take_while(|p| p.instance == instance).count();
            let first = parts.len() - of_instance;
            let known = parts[first..].iter().position(|p| p.material == material);
            let k = known.map_or(parts.len(), |k| first + k);
            if known.is_none() {
                let extent = [Vec3::INFINITY, Vec3::NEG_INFINITY];
                parts.push(Part { instance, material, extent, plane: true });
            }
            let part = &mut parts[k];
            part.plane &= mirrors.of(instance, triangle).is_some();
            part.extent = facet.corners.iter().fold(part.extent, |[lo, hi], p| [lo.min(*p), hi.max(*p)]);
        }
        // The largest first; the order of the scene among equals.
        let size = |p: &Part| (p.extent[1] - p.extent[0]).length_squared();
        parts.sort_by(|a, b| size(b).total_cmp(&size(a)));

        // Light that leaves a plane does not come back to it.
        let mirror = |p: &Part| p.plane && finishes[p.material as usize].bsdf.only_mirrors();
        let single = mirrors.all().len() == 1 && parts.iter().all(mirror);
        let mut found = Bodies { caustics: !single && !parts.is_empty(), ..Bodies::default() };
        for (k, part) in parts.iter().enumerate() {
            let number = k.min(MOST_BODIES - 1);
            let reflects = finishes[part.material as usize].sharp.max_channel().clamp(LEAST_WORTH, 1.0);
            let worth = if part.plane { reflects * MIRROR_WORTH } else { reflects };
            match found.bodies.get_mut(number) {
                Some(body) => body.swallow(part.extent, worth),
                None => found.bodies.push(Body::within(part.extent, worth)),
            }
            let instance = part.instance as usize;
            found.of.resize(found.of.len().max(instance + 1), Vec::new());
            found.of[instance].push((part.material, number as u32));
        }
        for (instance, _, facet) in facets() {
            if let Some(number) = found.number(instance, facet.material) {
                let body = &mut found.bodies[number as usize];
                let reach = facet.corners.map(|p| (p - body.center).length() * MARGIN);
                body.radius = reach.into_iter().fold(body.radius, f32::max);
            }
        }
        found
    }

    /// All of them, the largest first; a body's place in the list is its number.
    pub fn all(&self) -> &[Body] {
        &self.bodies
    }

    /// False only if all light that they send on is that over a single planar mirror: the part *mirror*, and no other.
    pub fn make_caustics(&self) -> bool {
        self.caustics
    }

    /// The body that a surface belongs to.
    pub fn of(&self, surface: &Surface<'_>) -> Option<u32> {
        self.number(surface.instance, surface.material)
    }

    fn number(&self, instance: u32, material: u32) -> Option<u32> {
        let of = self.of.get(instance as usize)?;
        of.iter().find(|(m, _)| *m == material).map(|(_, number)| *number)
    }
}

impl Body {
    /// Of a box; its sphere has no radius yet.
    fn within(extent: [Vec3; 2], worth: f32) -> Body {
        Body { center: (extent[0] + extent[1]) * 0.5, radius: 0.0, extent, worth }
    }

    fn swallow(&mut self, [low, high]: [Vec3; 2], worth: f32) {
        let extent = [self.extent[0].min(low), self.extent[1].max(high)];
        *self = Body::within(extent, self.worth.max(worth));
    }

    /// False only if no point of the body lies before the plane through `p` of normal `n`.
    pub fn may_be_before(&self, p: Vec3, n: Vec3) -> bool {
        let [low, high] = self.extent;
        let farthest = Vec3::select(n.cmpgt(Vec3::ZERO), high, low);
        n.dot(farthest - p) > 0.0
    }
}
