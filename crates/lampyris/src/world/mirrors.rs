//! Planar mirrors: flat facets that reflect like a looking-glass, plane by plane.
//!
//! Before such a mirror each light has one image, whatever looks at it: the virtual light sources of [Keller97, §4.2].
//! Which facets belong to a mirror the scene alone decides, so that all who gather images or sort paths agree. Curved
//! mirrors are none, even where they are made of flat facets; nor is glass, whose other side counts as much.

use super::facet::Facets;
use super::surface::Surface;
use crate::color::Rgb;
use crate::geometry::Frame;
use crate::material::{Coverage, Maps, Material};
use glam::{Vec2, Vec3};
use std::collections::HashMap;

/// Most mirrors of a scene: each costs a look at every light. The largest count.
const MOST: usize = 8;

/// Planes among which facets are sorted; the facets of others are too small to make a mirror.
const PLANES: usize = 32;

/// A mirror has at least this share of the flat mirroring area of its instance: all faces of a cube do, and no facet
/// of a ball.
const LEAST_SHARE: f64 = 1.0 / 12.0;

/// Distance within which a point lies in a mirror's plane, in its largest coordinate. Rays leave surfaces at up to
/// 3e-6 of it.
const MARGIN: f32 = 1e-5;

/// Cosine between the normals of facets of one plane.
const PARALLEL: f32 = 0.999_999;

/// Flat facets in one plane, of one instance. It mirrors on both sides of the plane where their materials do.
#[derive(Clone, Debug, PartialEq)]
pub struct Mirror {
    /// A corner, where distances from the plane are counted from [m, world].
    origin: Vec3,
    /// The plane's axes and normal.
    frame: Frame,
    /// The rectangle around all facets, along the axes from `origin`, wider by the margin.
    rectangle: [Vec2; 2],
    /// The box around them.
    extent: [Vec3; 2],
    margin: f32,
    strength: f32,
}

/// All planar mirrors of a scene, the largest first.
#[derive(Clone, Debug, Default)]
pub struct Mirrors {
    mirrors: Vec<Mirror>,
    /// Of each instance the triangles that belong to a mirror, in order, and which.
    of: Vec<Vec<(u32, u8)>>,
}

/// Facets of a plane while they are collected.
struct Plane {
    instance: u32,
    area: f64,
    mirror: Mirror,
    facets: Vec<(u32, u32)>,
}

impl Mirror {
    fn new(corners: &[Vec3; 3], normal: Vec3) -> Mirror {
        let mut mirror = Mirror {
            origin: corners[0],
            frame: Frame::new(normal),
            rectangle: [Vec2::INFINITY, Vec2::NEG_INFINITY],
            extent: [Vec3::INFINITY, Vec3::NEG_INFINITY],
            margin: 0.0,
            strength: 0.0,
        };
        mirror.grow(corners);
        mirror
    }

    fn grow(&mut self, corners: &[Vec3; 3]) {
        for p in corners {
            self.margin = self.margin.max(MARGIN * p.abs().max_element());
            let at = self.frame.to_local(*p - self.origin).truncate();
            let [low, high] = self.rectangle;
            self.rectangle = [low.min(at - self.margin), high.max(at + self.margin)];
            self.extent = [self.extent[0].min(*p), self.extent[1].max(*p)];
        }
    }

    fn contains(&self, corners: &[Vec3; 3], normal: Vec3) -> bool {
        self.frame.n.dot(normal).abs() > PARALLEL && corners.iter().all(|p| self.height(*p).is_none())
    }

    /// Signed distance from the plane [m]; `None` where `p` lies in it, up to rounding.
    pub fn height(&self, p: Vec3) -> Option<f32> {
        let height = self.frame.n.dot(p - self.origin);
        let margin = self.margin.max(MARGIN * p.abs().max_element());
        (height.abs() > margin).then_some(height)
    }

    /// The point on the other side of the plane, as far from it.
    pub fn image(&self, p: Vec3) -> Vec3 {
        p - self.frame.n * (2.0 * self.frame.n.dot(p - self.origin))
    }

    /// A direction as the mirror turns it.
    pub fn turned(&self, d: Vec3) -> Vec3 {
        d - self.frame.n * (2.0 * self.frame.n.dot(d))
    }

    /// The most that any of its facets reflects at normal incidence, in any channel.
    pub fn strength(&self) -> f32 {
        self.strength
    }

    /// Whether a line through the point `p`, off the plane, that goes along `d` from there, crosses the plane within
    /// the rectangle around the mirror: false only if it misses the mirror.
    #[inline(always)]
    pub fn may_be_crossed(&self, p: Vec3, d: Vec3) -> bool {
        let Frame { s, t, n } = &self.frame;
        let o = p - self.origin;
        let (from, along) = (n.dot(o), n.dot(d));
        let lengths = from / along;
        let (x, y) = (s.dot(o) - s.dot(d) * lengths, t.dot(o) - t.dot(d) * lengths);
        let [low, high] = self.rectangle;
        (from * along < 0.0) & (x >= low.x) & (x <= high.x) & (y >= low.y) & (y <= high.y)
    }

    /// A point by its coordinates along the mirror's axes and off its plane [m].
    #[inline(always)]
    pub fn local(&self, p: Vec3) -> Vec3 {
        let Frame { s, t, n } = &self.frame;
        let o = p - self.origin;
        Vec3::new(s.dot(o), t.dot(o), n.dot(o))
    }

    /// [`Mirror::may_be_crossed`] for the segment between two points of local coordinates, none of which lies in the plane.
    #[inline(always)]
    pub fn may_be_crossed_between(&self, a: Vec3, b: Vec3) -> bool {
        let [low, high] = self.rectangle;
        // Where it crosses, times the sum of both heights: no division.
        let (p, q) = (a.z.abs(), b.z.abs());
        let (x, y, sum) = (a.x * q + b.x * p, a.y * q + b.y * p, p + q);
        (a.z * b.z < 0.0)
            & (x >= low.x * sum)
            & (x <= high.x * sum)
            & (y >= low.y * sum)
            & (y <= high.y * sum)
    }

    /// [`Mirror::may_be_crossed_between`] for the segments from all points of a box to one point: false only if they all miss.
    #[inline(always)]
    pub fn may_be_crossed_from(&self, [low, high]: [Vec3; 2], b: Vec3) -> bool {
        let [left, right] = self.rectangle;
        let (above, below) = (low.z > 0.0, high.z < 0.0);
        let opposite = if above { b.z < 0.0 } else { (b.z > 0.0) | (!below & (b.z < 0.0)) };
        // The heights of the points over the plane.
        let most = if -low.z > high.z { -low.z } else { high.z };
        let least = if above { low.z } else { -high.z };
        let least = if above | below { least } else { 0.0 };
        // (a − edge) |b.z| + (b − edge) |a.z| at its largest, as the sign of the crossing's distance from an edge.
        let q = b.z.abs();
        let inside =
            |a: f32, slope: f32| a * q + if slope > 0.0 { slope * most } else { slope * least } >= 0.0;
        opposite
            & inside(high.x - left.x, b.x - left.x)
            & inside(right.x - low.x, right.x - b.x)
            & inside(high.y - left.y, b.y - left.y)
            & inside(right.y - low.y, right.y - b.y)
    }

    /// Whether anything of the rectangle around the mirror lies before a plane through `p` of normal `n`.
    pub fn may_be_before(&self, p: Vec3, n: Vec3) -> bool {
        let [low, high] = self.rectangle;
        let corner = |x, y| self.origin + self.frame.to_world(Vec3::new(x, y, 0.0));
        [corner(low.x, low.y), corner(low.x, high.y), corner(high.x, low.y), corner(high.x, high.y)]
            .iter()
            .any(|c| n.dot(*c - p) > 0.0)
    }

    /// False only if no point of the mirror lies within `distance` of the box from `low` to `high`.
    pub fn may_be_near(&self, [low, high]: [Vec3; 2], distance: f32) -> bool {
        let gap = (self.extent[0] - high).max(low - self.extent[1]).max(Vec3::ZERO);
        gap.length_squared() <= distance * distance
    }
}

impl Mirrors {
    /// Those among the facets; `materials` are the scene's.
    pub fn find(facets: &Facets, materials: &[Material]) -> Mirrors {
        let reflects: Vec<f32> = materials.iter().map(reflectance).collect();
        if reflects.iter().all(|r| *r <= 0.0) {
            return Mirrors::default();
        }
        let mut flat = Vec::new();
        let mut totals: HashMap<u32, f64> = HashMap::new();
        let instances = 0..facets.scene.instances.len() as u32;
        for place in instances.flat_map(|i| (0..facets.count(i)).map(move |triangle| (i, triangle))) {
            let (instance, triangle) = place;
            if reflects[facets.material(instance, triangle) as usize] <= 0.0 {
                continue;
            }
            let [a, b, c] = facets.corners(instance, triangle);
            let area = 0.5 * f64::from((b - a).cross(c - a).length());
            if facets.is_flat(instance, triangle) && area > 0.0 && area.is_finite() {
                *totals.entry(instance).or_default() += area;
                flat.push((area, place));
            }
        }
        // The largest first, then the order of the scene.
        flat.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut planes: Vec<Plane> = Vec::new();
        for (area, place) in flat {
            let facet = facets.get(place.0, place.1);
            let same =
                |p: &&mut Plane| p.instance == place.0 && p.mirror.contains(&facet.corners, facet.normal);
            if let Some(plane) = planes.iter_mut().find(same) {
                plane.mirror.grow(&facet.corners);
                plane.area += area;
                plane.facets.push(place);
            } else if planes.len() < PLANES {
                let mirror = Mirror::new(&facet.corners, facet.normal);
                planes.push(Plane { instance: place.0, area, mirror, facets: vec![place] });
            }
        }
        planes.retain(|p| p.area >= LEAST_SHARE * totals[&p.instance]);
        planes.sort_by(|a, b| b.area.total_cmp(&a.area));
        planes.truncate(MOST);
        let mut found = Mirrors::default();
        for (number, plane) in (0..).zip(planes) {
            let strengths = plane
                .facets
                .iter()
                .map(|(i, triangle)| reflects[facets.get(*i, *triangle).material as usize]);
            found.mirrors.push(Mirror { strength: strengths.fold(0.0, f32::max), ..plane.mirror });
            let instance = plane.instance as usize;
            found.of.resize(found.of.len().max(instance + 1), Vec::new());
            found.of[instance].extend(plane.facets.into_iter().map(|(_, triangle)| (triangle, number)));
        }
        found.of.iter_mut().for_each(|of| of.sort_unstable());
        found
    }

    /// All of them; a mirror's place in the list is its number.
    pub fn all(&self) -> &[Mirror] {
        &self.mirrors
    }

    /// The mirror that a triangle of an instance belongs to.
    pub fn of(&self, instance: u32, triangle: u32) -> Option<u8> {
        let of = self.of.get(instance as usize)?;
        let place = of.binary_search_by_key(&triangle, |(triangle, _)| *triangle).ok()?;
        Some(of[place].1)
    }
}

/// What the material reflects in a delta lobe, in its brightest channel; 0 where it is not the same everywhere.
pub(super) fn reflectance(m: &Material) -> f32 {
    let even = m.coverage == Coverage::Full && m.maps == Maps::default();
    if even { m.bsdf.mirror_reflectance(1.0).max_channel() } else { 0.0 }
}

impl Surface<'_> {
    /// Where a planar mirror sends what arrives from `wo`, and the share of it.
    pub fn mirrored(&self) -> (Vec3, Rgb) {
        let cosine = self.normal.dot(self.wo);
        (self.normal * (2.0 * cosine) - self.wo, self.finish.bsdf.mirror_reflectance(cosine.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::uniform_sphere;
    use crate::sequence::uniform;

    /// What a box says of all its points is never less than what one of them says; and it says no to most.
    #[test]
    fn a_box_sees_through_a_mirror_what_its_points_see() {
        let (mut seen, mut may) = (0, 0);
        for i in 0..4000 {
            let number = |k: u32| 4.0 * uniform(5, i, k) - 2.0;
            let vector = |k: u32| Vec3::new(number(k), number(k + 1), number(k + 2));
            let normal = uniform_sphere([uniform(6, i, 0), uniform(6, i, 1)]);
            let Frame { s, t, .. } = Frame::new(normal);
            let at = vector(0);
            let mirror = Mirror::new(&[at, at + s * 1.6, at + t * 1.3], normal);
            let size = Vec3::splat(0.5 * uniform(7, i, 0));
            let (corner, b) = (vector(3), mirror.local(vector(6)));
            let points = (0..64).map(|k| {
                let inside = [0, 1, 2].map(|axis| uniform(8 + i, k, axis));
                mirror.local(corner + size * Vec3::from(inside))
            });
            let points: Vec<Vec3> = points.collect();
            let low = points.iter().fold(Vec3::INFINITY, |low, p| low.min(*p));
            let high = points.iter().fold(Vec3::NEG_INFINITY, |high, p| high.max(*p));
            let whole = mirror.may_be_crossed_from([low, high], b);
            let some = points.iter().any(|a| mirror.may_be_crossed_between(*a, b));
            assert!(whole || !some, "case {i}");
            (seen, may) = (seen + u32::from(some), may + u32::from(whole));
        }
        assert!(seen > 100 && may < 2 * seen, "{seen} boxes see something, {may} may");
    }
}
