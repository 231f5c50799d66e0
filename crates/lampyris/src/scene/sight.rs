//! What a view shows of a room: points spread over its surfaces, sorted into furniture and walls, and a picture's frustum.
//! The measure by which [`super::find_view`] chooses and reports; no paper. It traces nothing.

use super::Scene;
use super::upward::{bounds, facets};
use crate::geometry::Frame;
use glam::{Vec2, Vec3};
use std::f32::consts::PI;

/// Directions in which a standing place is felt out.
pub(super) const PROBES: usize = 256;

/// Solid things show a third of what one could see of them by walking around them, at best from a corner two thirds.
const SHOWN: f32 = 1.0 / 3.0;

/// What a view shows of all that can be seen of a room by walking about in it; shares of 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Of the furniture, thing by thing, each weighted by its area: fully there once a third of its surface is seen,
    /// since nothing shows its back. Things too small to matter are not counted. 1 where there is none.
    pub furniture: f32,
    /// Of the area of walls, floor and ceiling. 1 where there is none.
    pub walls: f32,
}

/// A point of a surface, and the instance that it belongs to.
pub(super) struct Point {
    pub(super) position: Vec3,
    instance: usize,
}

/// What can be seen of a room.
pub(super) struct Room {
    pub(super) points: Vec<Point>,
    /// Corners of the box around it, along the axes of the search [m].
    pub(super) lo: Vec3,
    pub(super) hi: Vec3,
    /// For each point the thing that it belongs to; `None` for the walls.
    things: Vec<Option<usize>>,
    /// Points of each thing.
    sizes: Vec<u32>,
}

impl Room {
    /// A room of points of a scene, between heights along the upward axis [m].
    pub(super) fn new(points: Vec<Point>, scene: &Scene, axes: &Frame, floor: f32, ceiling: f32) -> Room {
        let local: Vec<Vec3> = points.iter().map(|p| axes.to_local(p.position)).collect();
        let (lo, hi) = bounds(local.iter().copied());
        let (lo, hi) = (lo.truncate().extend(floor), hi.truncate().extend(ceiling));
        let margin = 0.05 * (ceiling - floor);
        let mut heights = vec![(f32::INFINITY, f32::NEG_INFINITY); scene.instances.len()];
        for f in facets(scene) {
            let (low, high) = &mut heights[f.instance];
            for z in f.corners.map(|p| p.dot(axes.n)) {
                (*low, *high) = (low.min(z), high.max(z));
            }
        }
        // What stands from the floor to the ceiling parts rooms, wherever it stands.
        let parts = |instance: usize| {
            let (low, high) = heights[instance];
            low <= floor + margin && high >= ceiling - margin
        };
        let free = |(p, l): (&Point, &Vec3)| {
            l.cmpgt(lo + margin).all() && l.cmplt(hi - margin).all() && !parts(p.instance)
        };
        let mut instances: Vec<usize> =
            points.iter().zip(&local).filter(|pair| free(*pair)).map(|(p, _)| p.instance).collect();
        instances.sort_unstable();
        instances.dedup();
        let thing =
            |pair: (&Point, &Vec3)| free(pair).then(|| instances.binary_search(&pair.0.instance).ok())?;
        let things: Vec<Option<usize>> = points.iter().zip(&local).map(thing).collect();
        let mut sizes = vec![0; instances.len()];
        things.iter().flatten().for_each(|&t| sizes[t] += 1);
        Room { points, lo, hi, things, sizes }
    }

    /// How much there is to see: points of furniture, then all points.
    pub(super) fn worth(&self) -> [usize; 2] {
        [self.sizes.iter().sum::<u32>() as usize, self.points.len()]
    }

    /// What is seen, from the numbers of the points that are.
    pub(super) fn seen(&self, points: impl Iterator<Item = usize>) -> Seen {
        let mut things = vec![0; self.sizes.len()];
        let mut walls = 0;
        for k in points {
            match self.things[k] {
                Some(thing) => things[thing] += 1,
                None => walls += 1,
            }
        }
        let all: u32 = self.sizes.iter().sum();
        let shown = |(&n, &of): (&u32, &u32)| (n as f32 / SHOWN).min(of as f32);
        let furniture: f32 = things.iter().zip(&self.sizes).map(shown).sum();
        let share = |n: f32, of: usize| if of == 0 { 1.0 } else { n / of as f32 };
        Seen {
            furniture: share(furniture, all as usize),
            walls: share(walls as f32, self.points.len() - all as usize),
        }
    }
}

/// A direction looked in, and what it is worth.
pub(super) struct Look {
    pub(super) score: f32,
    pub(super) seen: Seen,
    pub(super) forward: Vec3,
    pub(super) fov_y: f32,
}

impl Look {
    pub(super) const NOTHING: Look = Look {
        score: f32::NEG_INFINITY,
        seen: Seen { furniture: 0.0, walls: 0.0 },
        forward: Vec3::X,
        fov_y: 60.0,
    };
}

/// What a camera's picture covers, seen from its eye.
pub(super) struct Frustum {
    forward: Vec3,
    side: Vec3,
    up: Vec3,
    slope: Vec2,
}

impl Frustum {
    pub(super) fn new(forward: Vec3, up: Vec3, fov_y: f32, aspect: f32) -> Frustum {
        let side = forward.cross(up).normalize();
        let half = libm::tanf((fov_y * 0.5).to_radians());
        Frustum { forward, side, up: side.cross(forward), slope: Vec2::new(half * aspect, half) }
    }

    pub(super) fn contains(&self, w: Vec3) -> bool {
        let depth = w.dot(self.forward);
        depth > 0.0
            && w.dot(self.side).abs() < depth * self.slope.x
            && w.dot(self.up).abs() < depth * self.slope.y
    }
}

/// The k-th of `n` directions spread over the sphere along a golden spiral.
pub(super) fn probe(k: usize, n: usize) -> Vec3 {
    let z = 1.0 - (2.0 * k as f32 + 1.0) / n as f32;
    let turn = PI * (3.0 - 5.0f32.sqrt()) * k as f32;
    let r = (1.0 - z * z).sqrt();
    Vec3::new(r * libm::cosf(turn), r * libm::sinf(turn), z)
}

/// `n` points at equal steps of area through the triangles of a scene, inside each by the golden ratio's cousins.
pub(super) fn spread(scene: &Scene, n: usize) -> Vec<Point> {
    let total: f64 = facets(scene).map(|f| f64::from(f.area)).sum();
    let mut points = Vec::with_capacity(n);
    let mut before = 0.0;
    for f in facets(scene) {
        let after = before + f64::from(f.area);
        while points.len() < n && (points.len() as f64 + 0.5) * total / (n as f64) < after {
            let k = points.len() as f32;
            let (a, b) = ((k * 0.754_877_7).fract(), (k * 0.569_840_3).fract());
            let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
            let position =
                f.corners[0] + (f.corners[1] - f.corners[0]) * a + (f.corners[2] - f.corners[0]) * b;
            points.push(Point { position, instance: f.instance });
        }
        before = after;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Instance, Mesh};
    use glam::Affine3A;

    /// A room 10 m wide and 3 m high with walls of 10 points, a thing of 6 and one of 3.
    fn room() -> Room {
        let at = |x: f32, z: f32, instance| Point { position: Vec3::new(x, x, z), instance };
        let walls = (0..10).map(|k| at(if k % 2 == 0 { 0.0 } else { 10.0 }, 1.0, 0));
        let things = (0..9).map(|k| at(2.0 + k as f32 * 0.5, 1.0, if k < 6 { 1 } else { 2 }));
        let place = || Instance { name: String::new(), mesh: 0, transform: Affine3A::IDENTITY };
        let scene = Scene { instances: (0..3).map(|_| place()).collect(), ..Scene::default() };
        Room::new(walls.chain(things).collect(), &scene, &Frame::new(Vec3::Z), 0.0, 3.0)
    }

    #[test]
    fn a_third_of_a_thing_is_all_of_it_and_a_wall_counts_by_area() {
        let room = room();
        let seen = |points: &[usize]| room.seen(points.iter().copied());
        assert_eq!(seen(&[]), Seen { furniture: 0.0, walls: 0.0 });
        assert_eq!(seen(&[0, 1, 2, 3]), Seen { furniture: 0.0, walls: 0.4 });
        // Two of six points are all of the larger thing: six of nine points of furniture; more makes it no larger.
        assert_eq!(seen(&[10, 11]).furniture, 6.0 / 9.0);
        assert_eq!(seen(&[10, 11, 12, 13]).furniture, 6.0 / 9.0);
        assert_eq!(seen(&[10]).furniture, 3.0 / 9.0);
        assert_eq!(seen(&[10, 11, 16]).furniture, 1.0);
    }

    #[test]
    fn points_lie_on_their_triangles_in_proportion_to_area() {
        let mesh = Mesh {
            positions: vec![
                Vec3::ZERO,
                Vec3::X,
                Vec3::Y,
                Vec3::Z,
                Vec3::new(3.0, 0.0, 1.0),
                Vec3::new(0.0, 1.0, 1.0),
            ],
            triangles: vec![[0, 1, 2], [3, 4, 5]],
            materials: vec![0, 0],
            ..Mesh::default()
        };
        let place = Instance { name: String::new(), mesh: 0, transform: Affine3A::IDENTITY };
        let scene = Scene { meshes: vec![mesh], instances: vec![place], ..Scene::default() };
        let points = spread(&scene, 400);
        let low = points.iter().filter(|p| p.position.z == 0.0).count();
        assert_eq!((points.len(), low), (400, 100));
        let inside = |p: Vec3| p.x >= 0.0 && p.y >= 0.0 && p.x / (1.0 + 2.0 * p.z) + p.y <= 1.0 + 1e-6;
        assert!(points.iter().all(|p| inside(p.position)));
    }
}
