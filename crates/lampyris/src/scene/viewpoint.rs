//! A good view of a scene that has no camera: inside, at eye height, clear of what stands near, seeing most of the room.
//! A search over standing places and directions that counts the surface points each of them sees; no paper.
//! Deterministic: the same scene has the same view on every machine. It looks for no beauty.

use super::upward::{bounds, facet, facets, upward};
use super::{Camera, Scene};
use crate::geometry::{Frame, Hit, Ray};
use crate::material::Sides;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::f32::consts::{PI, TAU};

/// Vertical field of view of a found camera [degrees].
const FOV_Y: f32 = 65.0;

/// Standing places tried along each horizontal axis.
const GRID: usize = 16;

/// Directions in which a standing place is felt out.
const PROBES: usize = 256;

/// A room encloses at least this share of the directions from a place in it.
const ENCLOSED: f32 = 0.55;

/// Surface points that views are measured by.
const POINTS: usize = 1024;

/// Compass directions tried at a standing place.
const HEADINGS: usize = 48;

/// Eye height of a standing person [m], in rooms between these heights [m]; a share of the height elsewhere, where the
/// unit may not be the metre at all.
const EYE_HEIGHT: f32 = 1.6;
const ROOM_HEIGHTS: std::ops::RangeInclusive<f32> = 2.1..=4.5;
const EYE_SHARE: f32 = 0.6;

/// A view that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Where to stand and look.
    pub camera: Camera,
    /// The upward unit vector, stated by the scene or found.
    pub up: Vec3,
    /// Share of the surface points visible from any standing place that this view sees, furniture and walls each
    /// counting half.
    pub seen: f32,
}

/// Finds a view. `trace` returns the nearest hit of a ray; `aspect` is width / height of the picture.
pub fn find_view(scene: &Scene, trace: &(dyn Fn(&Ray) -> Option<Hit> + Sync), aspect: f32) -> Found {
    let search = Search { trace, scene, axes: Frame::new(upward(scene)), aspect };
    search.inside().unwrap_or_else(|| search.outside())
}

/// What every step of the search needs.
struct Search<'a> {
    trace: &'a (dyn Fn(&Ray) -> Option<Hit> + Sync),
    scene: &'a Scene,
    /// Horizontal axes and the upward one.
    axes: Frame,
    aspect: f32,
}

/// The free part of a vertical line through the scene, in heights along the upward axis [m].
#[derive(Clone, Copy)]
struct Column {
    foot: Vec2,
    floor: f32,
    ceiling: f32,
}

/// A place to stand, and how far one sees from it in each probe direction [m; infinite where nothing is].
struct Place {
    eye: Vec3,
    reach: Vec<f32>,
    /// Share of the directions that end at a wall's front; its back counts half.
    enclosed: f32,
}

/// A point of a surface that one may want to see.
struct Point {
    position: Vec3,
    furniture: bool,
}

impl Search<'_> {
    /// The best view from within a room, if there is a room.
    fn inside(&self) -> Option<Found> {
        let (floor, ceiling, columns) = self.storey()?;
        let height = ceiling - floor;
        let eye = floor + if ROOM_HEIGHTS.contains(&height) { EYE_HEIGHT } else { EYE_SHARE * height };
        let places = self.places(&columns, eye, 0.1 * height)?;
        let (points, sees) = self.points(&places, floor, ceiling);
        let (lo, hi) = bounds(points.iter().map(|p| p.position));
        let size = (hi - lo).length();
        let best = (places.par_iter().zip(&sees))
            .map(|(place, sees)| self.best_heading(place, &points, sees, 0.15 * size))
            .collect::<Vec<_>>()
            .into_iter()
            .zip(&places)
            .reduce(|a, b| if b.0.score > a.0.score { b } else { a })?;
        let (look, place) = best;
        let target = place.eye + look.forward * (0.5 * size);
        Some(Found { camera: self.camera(place.eye, target), up: self.axes.n, seen: look.seen })
    }

    /// A view of the whole scene from outside and a little above, for a scene without a room.
    fn outside(&self) -> Found {
        let (lo, hi) = bounds(facets(self.scene).flat_map(|f| f.corners));
        let (lo, hi) = if lo.is_finite() && hi.is_finite() { (lo, hi) } else { (Vec3::NEG_ONE, Vec3::ONE) };
        let middle = (lo + hi) * 0.5;
        let half_angle = (FOV_Y * 0.5).to_radians();
        let narrow = libm::atanf(libm::tanf(half_angle) * self.aspect.min(1.0));
        let distance = (hi - lo).length().max(1e-6) * 0.5 / libm::sinf(narrow);
        let towards = (self.axes.s * 0.6 + self.axes.t * -0.7 + self.axes.n * 0.4).normalize();
        Found { camera: self.camera(middle + towards * distance, middle), up: self.axes.n, seen: 1.0 }
    }

    fn camera(&self, eye: Vec3, target: Vec3) -> Camera {
        Camera { name: "found".into(), eye, target, up: self.axes.n, fov_y: FOV_Y }
    }

    /// The floor's and the ceiling's height of the storey with most free space, and its columns.
    fn storey(&self) -> Option<(f32, f32, Vec<Column>)> {
        let corners = facets(self.scene).flat_map(|f| f.corners);
        let (lo, hi) = bounds(corners.map(|p| self.axes.to_local(p)));
        let extent = hi - lo;
        if !extent.is_finite() || extent.min_element() <= 0.0 {
            return None;
        }
        let columns: Vec<Column> = (0..GRID * GRID)
            .into_par_iter()
            .filter_map(|k| {
                let cell = Vec2::new((k % GRID) as f32 + 0.5, (k / GRID) as f32 + 0.5) / GRID as f32;
                self.column(lo.truncate() + cell * extent.truncate(), lo.z, hi.z)
            })
            .collect();
        // Floors differ by sills and carpets; the storey is the level on which most of the free space stands.
        let tolerance = 0.04 * extent.z;
        let on = |level: f32| columns.iter().filter(move |c| (c.floor - level).abs() <= tolerance);
        let space = |c: &Column| on(c.floor).map(|o| o.ceiling - o.floor).sum::<f32>();
        let floor = columns.iter().max_by(|a, b| space(a).total_cmp(&space(b)))?.floor;
        let storey: Vec<Column> = on(floor).copied().collect();
        let mut ceilings: Vec<f32> = storey.iter().map(|c| c.ceiling).collect();
        ceilings.sort_by(f32::total_cmp);
        Some((floor, ceilings[ceilings.len() / 2], storey))
    }

    /// The longest free stretch of a vertical line that has a floor.
    fn column(&self, foot: Vec2, bottom: f32, top: f32) -> Option<Column> {
        let step = 1e-4 * (top - bottom);
        let mut from = top + step;
        let mut longest: Option<Column> = None;
        // Sixteen surfaces one above the other are a bookshelf, and no room is below it.
        for _ in 0..16 {
            let origin = self.axes.to_world(foot.extend(from));
            let Some(hit) = (self.trace)(&Ray::new(origin, -self.axes.n)) else { break };
            let floor = from - hit.t;
            let ceiling = from.min(top);
            if longest.is_none_or(|l| ceiling - floor > l.ceiling - l.floor) {
                longest = Some(Column { foot, floor, ceiling });
            }
            from = floor - step;
        }
        longest
    }

    /// Where one can stand at eye height, within walls, `clear` [m] of everything.
    fn places(&self, columns: &[Column], eye: f32, clear: f32) -> Option<Vec<Place>> {
        let places: Vec<Place> = (columns.par_iter())
            .filter(|c| c.floor < eye && eye < c.ceiling)
            .map(|c| self.place(c.foot.extend(eye)))
            .collect();
        let most = places.iter().map(|p| p.enclosed).reduce(f32::max)?;
        let free = |p: &Place| {
            let nearest = p.reach.iter().copied().fold(f32::INFINITY, f32::min);
            p.enclosed > ENCLOSED && p.enclosed >= 0.9 * most && nearest >= clear
        };
        let free: Vec<Place> = places.into_iter().filter(free).collect();
        (!free.is_empty()).then_some(free)
    }

    /// Feels out a place, given in local coordinates.
    fn place(&self, eye: Vec3) -> Place {
        let eye = self.axes.to_world(eye);
        let mut enclosed = 0.0;
        let reach = |k| {
            let Some(hit) = (self.trace)(&Ray::new(eye, probe(k))) else { return f32::INFINITY };
            // Behind its walls one is not in the room; but a wall turned about by mistake should not spoil it.
            enclosed += if self.shows_back(&hit, probe(k)) { 0.5 } else { 1.0 };
            hit.t
        };
        let reach = (0..PROBES).map(reach).collect();
        Place { eye, reach, enclosed: enclosed / PROBES as f32 }
    }

    /// Whether a surface that has a front is hit from behind.
    fn shows_back(&self, hit: &Hit, direction: Vec3) -> bool {
        facet(self.scene, hit.instance as usize, hit.triangle as usize).is_some_and(|f| {
            let sides = self.scene.materials.get(f.material as usize).map_or(Sides::EmitFront, |m| m.sides);
            sides != Sides::Both && f.normal.dot(direction) > 0.0
        })
    }

    /// Points spread evenly over the surfaces that any place sees, and for each place which of them it sees.
    fn points(&self, places: &[Place], floor: f32, ceiling: f32) -> (Vec<Point>, Vec<Vec<bool>>) {
        let spread = spread(self.scene, POINTS);
        let sees: Vec<Vec<bool>> = places
            .par_iter()
            .map(|place| spread.iter().map(|&p| self.sees(place.eye, p)).collect())
            .collect();
        let seen: Vec<usize> = (0..spread.len()).filter(|&k| sees.iter().any(|s| s[k])).collect();
        let local: Vec<Vec3> = seen.iter().map(|&k| self.axes.to_local(spread[k])).collect();
        let margin = 0.05 * (ceiling - floor);
        let lo = local.iter().copied().fold(Vec3::INFINITY, Vec3::min).truncate().extend(floor) + margin;
        let hi =
            local.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max).truncate().extend(ceiling) - margin;
        let furniture = |p: Vec3| p.cmpgt(lo).all() && p.cmplt(hi).all();
        let points =
            seen.iter().zip(&local).map(|(&k, &l)| Point { position: spread[k], furniture: furniture(l) });
        (points.collect(), sees.iter().map(|s| seen.iter().map(|&k| s[k]).collect()).collect())
    }

    fn sees(&self, eye: Vec3, point: Vec3) -> bool {
        (self.trace)(&Ray::new(eye, point - eye)).is_some_and(|h| (h.t - 1.0).abs() < 1e-3)
    }

    /// The best direction to look from a place: much in sight, little within `near` [m], slightly down.
    fn best_heading(&self, place: &Place, points: &[Point], sees: &[bool], near: f32) -> Look {
        let furniture = points.iter().filter(|p| p.furniture).count();
        let walls = points.len() - furniture;
        let weight = |p: &Point| match (furniture, walls) {
            // Without furniture the walls are everything.
            (0, n) | (n, 0) => 1.0 / n as f32,
            _ => 0.5 / if p.furniture { furniture } else { walls } as f32,
        };
        let visible: Vec<(&Point, f32)> =
            points.iter().zip(sees).filter(|(_, s)| **s).map(|(p, _)| (p, weight(p))).collect();
        let mut best = Look { score: f32::NEG_INFINITY, seen: 0.0, forward: self.axes.s };
        for k in 0..HEADINGS * 4 {
            let heading = TAU * (k % HEADINGS) as f32 / HEADINGS as f32;
            let pitch = -0.1 * (k / HEADINGS) as f32;
            let level = self.axes.s * libm::cosf(heading) + self.axes.t * libm::sinf(heading);
            let forward = level * libm::cosf(pitch) + self.axes.n * libm::sinf(pitch);
            let frustum = Frustum::new(forward, self.axes.n, self.aspect);
            let in_sight = visible.iter().filter(|(p, _)| frustum.contains(p.position - place.eye));
            let seen: f32 = in_sight.map(|(_, w)| w).sum();
            let in_frame = (0..PROBES).filter(|&k| frustum.contains(probe(k))).map(|k| place.reach[k]);
            // What fills the frame from close by, and the void behind an open side, show nothing of the room.
            let (idle, all) = in_frame
                .fold((0.0, 0.0), |(n, all), r| (n + f32::from(r < near || r.is_infinite()), all + 1.0));
            let score = seen - 0.8 * idle / f32::max(all, 1.0) - 0.2 * (pitch + 0.15).abs();
            if score > best.score {
                best = Look { score, seen, forward };
            }
        }
        best
    }
}

/// A direction looked in, and what it is worth.
struct Look {
    score: f32,
    seen: f32,
    forward: Vec3,
}

/// What a camera's picture covers, seen from its eye.
struct Frustum {
    forward: Vec3,
    side: Vec3,
    up: Vec3,
    slope: Vec2,
}

impl Frustum {
    fn new(forward: Vec3, up: Vec3, aspect: f32) -> Frustum {
        let side = forward.cross(up).normalize();
        let half = libm::tanf((FOV_Y * 0.5).to_radians());
        Frustum { forward, side, up: side.cross(forward), slope: Vec2::new(half * aspect, half) }
    }

    fn contains(&self, w: Vec3) -> bool {
        let depth = w.dot(self.forward);
        depth > 0.0
            && w.dot(self.side).abs() < depth * self.slope.x
            && w.dot(self.up).abs() < depth * self.slope.y
    }
}

/// The k-th of [`PROBES`] directions spread over the sphere along a golden spiral.
fn probe(k: usize) -> Vec3 {
    let z = 1.0 - (2.0 * k as f32 + 1.0) / PROBES as f32;
    let turn = PI * (3.0 - 5.0f32.sqrt()) * k as f32;
    let r = (1.0 - z * z).sqrt();
    Vec3::new(r * libm::cosf(turn), r * libm::sinf(turn), z)
}

/// `n` points at equal steps of area through the triangles of a scene, inside each by the golden ratio's cousins.
fn spread(scene: &Scene, n: usize) -> Vec<Vec3> {
    let total: f64 = facets(scene).map(|f| f64::from(f.area)).sum();
    let mut points = Vec::with_capacity(n);
    let mut before = 0.0;
    for f in facets(scene) {
        let after = before + f64::from(f.area);
        while points.len() < n && (points.len() as f64 + 0.5) * total / (n as f64) < after {
            let k = points.len() as f32;
            let (a, b) = ((k * 0.754_877_7).fract(), (k * 0.569_840_3).fract());
            let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
            points.push(f.corners[0] + (f.corners[1] - f.corners[0]) * a + (f.corners[2] - f.corners[0]) * b);
        }
        before = after;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::super::upward::Facet;
    use super::*;
    use crate::color::Rgb;
    use crate::material::{Bsdf, Diffuse, Material};
    use crate::scene::{Instance, Mesh};
    use glam::{Affine3A, Mat3A, Vec3A};

    /// A box as an instance of its own; faces outward, or inward for a room.
    fn cuboid(scene: &mut Scene, lo: [f32; 3], hi: [f32; 3], inward: bool, material: u32) {
        let corner =
            |k: usize| Vec3::from_array(std::array::from_fn(|a| if k >> a & 1 == 0 { lo[a] } else { hi[a] }));
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let mut mesh = Mesh { positions: (0..8).map(corner).collect(), ..Mesh::default() };
        for [a, b, c, d] in faces {
            let halves = if inward { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            mesh.triangles.extend(halves);
            mesh.materials.extend([material; 2]);
        }
        scene.meshes.push(mesh);
        let mesh = scene.meshes.len() as u32 - 1;
        scene.instances.push(Instance { name: format!("box {mesh}"), mesh, transform: Affine3A::IDENTITY });
    }

    /// A furnished room, z upward: 6 m × 4 m × 2.8 m with a table, a cupboard, two chairs and a lamp at the ceiling.
    fn room() -> Scene {
        let mut scene = Scene::default();
        for emission in [0.0, 5000.0] {
            scene.materials.push(Material {
                name: "any".into(),
                bsdf: Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.5))),
                emission: Rgb::grey(emission),
                sides: Sides::EmitFront,
            });
        }
        cuboid(&mut scene, [0.0, 0.0, 0.0], [6.0, 4.0, 2.8], true, 0);
        cuboid(&mut scene, [2.0, 1.5, 0.7], [3.6, 2.5, 0.75], false, 0);
        cuboid(&mut scene, [5.4, 1.0, 0.0], [6.0, 3.0, 2.0], false, 0);
        cuboid(&mut scene, [2.2, 0.9, 0.0], [2.7, 1.4, 0.5], false, 0);
        cuboid(&mut scene, [3.0, 2.6, 0.0], [3.5, 3.1, 0.5], false, 0);
        cuboid(&mut scene, [2.5, 1.8, 2.6], [3.5, 2.2, 2.7], false, 1);
        scene
    }

    fn turned(mut scene: Scene, turn: Mat3A, shift: Vec3A) -> Scene {
        for instance in &mut scene.instances {
            instance.transform = Affine3A { matrix3: turn, translation: shift };
        }
        scene
    }

    /// The nearest triangle, by trying each [Möller, Trumbore 1997].
    fn nearest(facets: &[(u32, u32, Facet)], ray: &Ray) -> Option<Hit> {
        let meet = |&(instance, triangle, f): &(u32, u32, Facet)| {
            let (e1, e2) = (f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]);
            let p = ray.direction.cross(e2);
            let scale = 1.0 / e1.dot(p);
            let from = ray.origin - f.corners[0];
            let q = from.cross(e1);
            let (u, v, t) = (from.dot(p) * scale, ray.direction.dot(q) * scale, e2.dot(q) * scale);
            let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < ray.t_max;
            inside.then_some(Hit { t, u, v, instance, triangle })
        };
        facets.iter().filter_map(meet).min_by(|a, b| a.t.total_cmp(&b.t))
    }

    fn numbered(scene: &Scene) -> Vec<(u32, u32, Facet)> {
        let ids = (0..scene.instances.len()).flat_map(|i| (0..12).map(move |k| (i, k)));
        ids.filter_map(|(i, k)| Some((i as u32, k as u32, facet(scene, i, k)?))).collect()
    }

    fn found(scene: &Scene) -> Found {
        let facets = numbered(scene);
        find_view(scene, &|ray| nearest(&facets, ray), 4.0 / 3.0)
    }

    #[test]
    fn a_furnished_room_is_seen_from_a_clear_standing_place_whichever_way_is_up() {
        let quarter = std::f32::consts::FRAC_PI_2;
        let turns = [
            (Mat3A::IDENTITY, Vec3::Z),
            (Mat3A::from_rotation_x(-quarter), Vec3::Y),
            (Mat3A::from_rotation_y(quarter), Vec3::X),
            (Mat3A::from_rotation_x(2.0 * quarter), Vec3::NEG_Z),
        ];
        for (turn, up) in turns {
            let shift = Vec3A::new(10.0, -20.0, 5.0);
            let scene = turned(room(), turn, shift);
            let found = found(&scene);
            assert_eq!(found.up, up);
            let back = |p: Vec3| Vec3::from(turn.transpose() * (Vec3A::from(p) - shift));
            let (eye, target) = (back(found.camera.eye), back(found.camera.target));
            assert!((eye.z - 1.6).abs() < 0.01, "eye at {eye}");
            assert!(
                eye.cmpgt(Vec3::splat(0.2)).all() && eye.cmplt(Vec3::new(5.8, 3.8, 2.8)).all(),
                "eye at {eye}"
            );
            let forward = (target - eye).normalize();
            assert!((-0.4..=0.05).contains(&forward.z), "looks {forward}");
            assert!(found.seen > 0.6, "sees {}", found.seen);
        }
    }

    #[test]
    fn nothing_stands_before_the_eye() {
        let scene = room();
        let facets = numbered(&scene);
        let camera = found(&scene).camera;
        let view = crate::scene::View::new(&camera, 32, 24);
        let distance = |k: u32| {
            let ray = view.ray((k % 32) as f32 + 0.5, (k / 32) as f32 + 0.5);
            nearest(&facets, &ray).map_or(f32::INFINITY, |h| h.t)
        };
        let near = (0..32 * 24).filter(|&k| distance(k) < 1.0).count();
        assert!(near * 10 < 32 * 24, "{near} of 768 pixels are nearer than a metre");
    }

    #[test]
    fn a_stated_up_is_obeyed_and_other_units_scale_the_eye() {
        let mut scene = turned(room(), Mat3A::from_diagonal(Vec3::splat(3.28)), Vec3A::ZERO);
        scene.up = Some(Vec3::new(0.0, 0.0, 2.0));
        let found = found(&scene);
        assert_eq!(found.up, Vec3::Z);
        assert!((found.camera.eye.z - 0.6 * 2.8 * 3.28).abs() < 0.1, "eye at {}", found.camera.eye);
    }

    #[test]
    fn the_same_scene_has_the_same_view() {
        assert_eq!(found(&room()), found(&room()));
    }

    #[test]
    fn a_lone_object_is_seen_from_outside_and_nothing_is_no_panic() {
        let mut scene = Scene::default();
        cuboid(&mut scene, [0.0, 0.0, 0.0], [1.0, 1.0, 1.0], false, 0);
        let camera = found(&scene).camera;
        let frustum = Frustum::new((camera.target - camera.eye).normalize(), camera.up, 4.0 / 3.0);
        assert!((0..8).all(|k| frustum.contains(scene.meshes[0].positions[k] - camera.eye)));
        let nowhere = found(&Scene::default()).camera;
        assert!(nowhere.eye.is_finite() && nowhere.target.is_finite() && nowhere.eye != nowhere.target);
    }
}
