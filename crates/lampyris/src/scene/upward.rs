//! Which way is up, where the file does not say: along the axis and in the sense that rooms, lamps and furniture agree on.
//! A vote of six signed axes by area-weighted evidence; no paper. It sees triangles only, traces no ray, and a scene
//! without any evidence stands along +z.

use super::Scene;
use crate::light::{LightKind, State};
use crate::material::Sides;
use glam::Vec3;

/// A triangle in the world, as far as voting and viewing need it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    /// Corners [m].
    pub(super) corners: [Vec3; 3],
    /// Unit normal of the front.
    pub(super) normal: Vec3,
    /// Area [m²].
    pub(super) area: f32,
    /// Material index.
    pub(super) material: u32,
    /// Instance index.
    pub(super) instance: usize,
}

/// One triangle; `None` where it is not there, only in part, or without area.
pub(super) fn facet(scene: &Scene, instance: usize, triangle: usize) -> Option<Facet> {
    let placed = scene.instances.get(instance)?;
    let mesh = scene.meshes.get(placed.mesh as usize)?;
    let [a, b, c] = mesh.triangles.get(triangle)?.map(|i| mesh.positions.get(i as usize));
    let corners = [*a?, *b?, *c?].map(|p| placed.transform.transform_point3(p));
    let mirrored = if placed.transform.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
    let cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]) * mirrored;
    let area = cross.length() * 0.5;
    let material = mesh.materials.get(triangle).copied().unwrap_or(0);
    let normal = cross / (2.0 * area);
    (area > 0.0 && area.is_finite()).then_some(Facet { corners, normal, area, material, instance })
}

/// Every triangle, in the order of the scene; made anew at each pass, since a list would outweigh the scene.
pub(super) fn facets(scene: &Scene) -> impl Iterator<Item = Facet> {
    scene.instances.iter().enumerate().flat_map(move |(i, instance)| {
        let count = scene.meshes.get(instance.mesh as usize).map_or(0, |m| m.triangles.len());
        (0..count).filter_map(move |k| facet(scene, i, k))
    })
}

/// The smallest box along the axes around points: lower and upper corner [m].
pub(super) fn bounds(points: impl Iterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), p| (lo.min(p), hi.max(p)))
}

/// The upward unit vector: as the file states it, or found.
pub fn upward(scene: &Scene) -> Vec3 {
    if let Some(up) = scene.up.and_then(Vec3::try_normalize) {
        return up;
    }
    let evidence = Evidence::gather(scene);
    // Ties go to the first: +z is the way of the formats that do not say.
    let axes = [Vec3::Z, Vec3::Y, Vec3::X, Vec3::NEG_Z, Vec3::NEG_Y, Vec3::NEG_X];
    axes.into_iter().rev().max_by(|&a, &b| evidence.votes(a).total_cmp(&evidence.votes(b))).unwrap_or(Vec3::Z)
}

/// What the way lamps shine counts, beside where they and the furniture are: that it is upright, and that it is down. A room
/// may well be lit by its ceiling alone.
const UPRIGHT: f32 = 0.5;
const DOWN: f32 = 0.25;

/// What speaks for an axis, each vector in shares of -1 to 1.
struct Evidence {
    /// Share of the area that faces along each axis: floors, ceilings and table tops are level.
    level: Vec3,
    /// Extent along each axis in shares of the longest: rooms are lower than they are long.
    extent: Vec3,
    /// Where the light comes from, against the middle of the scene: lamps hang high.
    lamps: Vec3,
    /// Which way the lamps shine: down, unless they light a ceiling.
    shine: Vec3,
    /// Where the things inside are, against the middle: they stand on the floor.
    things: Vec3,
}

impl Evidence {
    fn gather(scene: &Scene) -> Evidence {
        let (lo, hi) = bounds(facets(scene).flat_map(|f| f.corners));
        let half = ((hi - lo) * 0.5).max(Vec3::splat(1e-20));
        let offset = |p: Vec3| ((p - (lo + hi) * 0.5) / half).clamp(Vec3::NEG_ONE, Vec3::ONE);
        let mut level = Mean::default();
        let mut lamps = Mean::default();
        let mut shine = Mean::default();
        let mut things = Mean::default();
        for f in facets(scene) {
            let middle = offset((f.corners[0] + f.corners[1] + f.corners[2]) / 3.0);
            let facing = f.normal.abs();
            level.add(Vec3::select(facing.cmpgt(Vec3::splat(0.95)), Vec3::ONE, Vec3::ZERO), f.area);
            if middle.abs().max_element() < 0.97 {
                things.add(middle, f.area);
            }
            let Some(material) = scene.materials.get(f.material as usize) else { continue };
            let power = material.emission.luminance() * f.area;
            if power > 0.0 {
                lamps.add(middle, power);
                shine.add(if material.sides == Sides::Both { Vec3::ZERO } else { f.normal }, power);
            }
        }
        // Sources that are no surfaces count like the surfaces together: their units do not compare.
        let weight = lamps.weight.max(1.0) / scene.lights.len().max(1) as f32;
        for light in scene.lights.iter().filter(|l| l.state != State::Away) {
            let (position, direction) = match light.kind {
                LightKind::Point { position, .. } => (Some(position), Vec3::ZERO),
                LightKind::Spot { position, direction, .. } => (Some(position), direction),
                LightKind::Directional { direction, .. } => (None, direction),
                LightKind::Sphere { center, .. } => (Some(center), Vec3::ZERO),
                LightKind::Disc { center, normal, .. } => (Some(center), normal),
            };
            lamps.add(position.map_or(-direction, offset), weight);
            shine.add(direction, weight);
        }
        let extent = half / half.max_element();
        Evidence { level: level.get(), extent, lamps: lamps.get(), shine: shine.get(), things: things.get() }
    }

    /// How much speaks for an axis as the upward one.
    fn votes(&self, axis: Vec3) -> f32 {
        let size = axis.abs();
        self.level.dot(size) - 0.5 * self.extent.dot(size)
            + UPRIGHT * self.shine.abs().dot(size)
            + self.lamps.dot(axis)
            - DOWN * self.shine.dot(axis)
            - self.things.dot(axis)
    }
}

/// A weighted mean in the making.
#[derive(Default)]
struct Mean {
    sum: Vec3,
    weight: f32,
}

impl Mean {
    fn add(&mut self, value: Vec3, weight: f32) {
        self.sum += value * weight;
        self.weight += weight;
    }

    fn get(&self) -> Vec3 {
        if self.weight > 0.0 { self.sum / self.weight } else { Vec3::ZERO }
    }
}
