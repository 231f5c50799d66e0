//! A good view of a scene that has no camera: inside, at eye height, clear of what stands near, seeing most of the room;
//! or from before the opening, where a wall is missing. A search from coarse to fine over standing places and directions
//! that counts what each of them shows; no paper. Deterministic, and it looks for no beauty.

use super::rooms::{Rooms, sees};
use super::sight::{Frustum, Look, PROBES, Point, Room, Seen, probe, spread};
use super::upward::{bounds, facet, facets, upward};
use super::{Camera, Scene};
use crate::geometry::{Frame, Hit, Ray};
use crate::material::Sides;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::f32::consts::TAU;

/// Vertical field of view of a camera in a room, and of one before it [degrees].
const FOV_Y: f32 = 65.0;
const FOV_Y_OUTSIDE: f32 = 40.0;

/// Standing places tried along each horizontal axis.
const GRID: usize = 16;

/// A room encloses at least this share of the directions from a place in it.
const ENCLOSED: f32 = 0.55;

/// A wall is missing if this share of the glances towards it, from all over the room, ends nowhere.
const OPEN: f32 = 0.3;

/// Surface points that views are measured by.
const POINTS: usize = 4096;

/// Rooms of a storey for each of which there are so many points.
const MOST_ROOMS: usize = 8;

/// A passage narrower than this parts rooms [heights of the storey]: doors are.
const DOOR: f32 = 0.5;

/// The coarse search: probes of a place, every how many points, headings.
const COARSE: (usize, usize, usize) = (64, 16, 24);

/// Places that the fine search looks at.
const FINALISTS: usize = 12;

/// Compass directions tried at a finalist, each at several pitches.
const HEADINGS: usize = 48;
const PITCHES: usize = 4;

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
    /// What the view shows of the room.
    pub seen: Seen,
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

/// The storey that is looked at: between heights along the upward axis [m].
struct Storey {
    floor: f32,
    ceiling: f32,
    columns: Vec<Column>,
    /// Bottom and top of the scene.
    heights: [f32; 2],
    /// How much floors may differ.
    tolerance: f32,
}

impl Storey {
    fn has(&self, column: &Column) -> bool {
        (column.floor - self.floor).abs() <= self.tolerance
    }
}

/// A place to stand.
struct Place {
    eye: Vec3,
    /// How far one sees from it in some directions [m; infinite where nothing is].
    reach: Vec<(Vec3, f32)>,
    /// Share of the directions that end at a wall's front; its back counts half.
    enclosed: f32,
}

impl Place {
    fn nearest(&self) -> f32 {
        self.reach.iter().fold(f32::INFINITY, |nearest, (_, r)| nearest.min(*r))
    }
}

impl Search<'_> {
    /// The best view of a room, if there is a room.
    fn inside(&self) -> Option<Found> {
        let storey = self.storey()?;
        let Storey { floor, ceiling, .. } = storey;
        let height = ceiling - floor;
        let eye = floor + if ROOM_HEIGHTS.contains(&height) { EYE_HEIGHT } else { EYE_SHARE * height };
        let clear = 0.1 * height;
        let (places, room) = self.room(&storey, eye, clear)?;
        let size = (room.hi - room.lo).length();
        let near = 0.15 * size;

        let finalists = self.finalists(&places, &room, near);
        let looks: Vec<(Look, Vec3)> = (finalists.par_iter())
            .filter_map(|place| {
                let fine = self.place(place.eye, PROBES);
                // The coarse probes may have missed what stands close by.
                (fine.nearest() >= clear || finalists.len() == 1)
                    .then(|| (self.best_heading(&fine, &room, 1, HEADINGS, PITCHES, near), place.eye))
            })
            .collect();
        let openings = self.openings(&places, &room).map(|(eye, forward)| {
            let mut fine = self.place(eye, PROBES);
            // The void beside an opening is not to blame on the view: the whole opening shall be in it.
            fine.reach.retain(|(_, r)| r.is_finite());
            (self.look(&fine, &room, &self.visible(eye, &room, 1), forward, FOV_Y_OUTSIDE, near), eye)
        });
        let (look, eye) =
            looks.into_iter().chain(openings).reduce(|a, b| if b.0.score > a.0.score { b } else { a })?;
        let camera = self.camera(eye, eye + look.forward * (0.5 * size), look.fov_y);
        Some(Found { camera, up: self.axes.n, seen: look.seen })
    }

    /// A view of the whole scene from outside and a little above, for a scene without a room.
    fn outside(&self) -> Found {
        let (lo, hi) = bounds(facets(self.scene).flat_map(|f| f.corners));
        let (lo, hi) = if lo.is_finite() && hi.is_finite() { (lo, hi) } else { (Vec3::NEG_ONE, Vec3::ONE) };
        let middle = (lo + hi) * 0.5;
        let half_angle = (FOV_Y_OUTSIDE * 0.5).to_radians();
        let narrow = libm::atanf(libm::tanf(half_angle) * self.aspect.min(1.0));
        let distance = (hi - lo).length().max(1e-6) * 0.5 / libm::sinf(narrow);
        let towards = (self.axes.s * 0.6 + self.axes.t * -0.7 + self.axes.n * 0.4).normalize();
        let camera = self.camera(middle + towards * distance, middle, FOV_Y_OUTSIDE);
        Found { camera, up: self.axes.n, seen: Seen { furniture: 1.0, walls: 1.0 } }
    }

    fn camera(&self, eye: Vec3, target: Vec3, fov_y: f32) -> Camera {
        Camera { name: "found".into(), eye, target, up: self.axes.n, fov_y }
    }

    /// The storey with most free space.
    fn storey(&self) -> Option<Storey> {
        let corners = facets(self.scene).flat_map(|f| f.corners);
        let (lo, hi) = bounds(corners.map(|p| self.axes.to_local(p)));
        let extent = hi - lo;
        if !extent.is_finite() || extent.min_element() <= 0.0 {
            return None;
        }
        let mut columns = self.columns([lo, hi]);
        // Floors differ by sills and carpets; the storey is the level on which most of the free space stands.
        let tolerance = 0.04 * extent.z;
        let on = |level: f32| columns.iter().filter(move |c| (c.floor - level).abs() <= tolerance);
        let space = |c: &Column| on(c.floor).map(|o| o.ceiling - o.floor).sum::<f32>();
        let floor = columns.iter().max_by(|a, b| space(a).total_cmp(&space(b)))?.floor;
        columns.retain(|c| (c.floor - floor).abs() <= tolerance);
        let mut ceilings: Vec<f32> = columns.iter().map(|c| c.ceiling).collect();
        ceilings.sort_by(f32::total_cmp);
        Some(Storey {
            heights: [lo.z, hi.z],
            floor,
            tolerance,
            ceiling: ceilings[ceilings.len() / 2],
            columns,
        })
    }

    /// Columns spread evenly over the ground of a box.
    fn columns(&self, [lo, hi]: [Vec3; 2]) -> Vec<Column> {
        let column = |k: usize| {
            let cell = Vec2::new((k % GRID) as f32 + 0.5, (k / GRID) as f32 + 0.5) / GRID as f32;
            self.column(lo.truncate() + cell * (hi - lo).truncate(), lo.z, hi.z)
        };
        (0..GRID * GRID).into_par_iter().filter_map(column).collect()
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
            .map(|c| self.place(self.axes.to_world(c.foot.extend(eye)), COARSE.0))
            .collect();
        let most = places.iter().map(|p| p.enclosed).reduce(f32::max)?;
        let free = |p: &Place| p.enclosed > ENCLOSED && p.enclosed >= 0.9 * most && p.nearest() >= clear;
        let free: Vec<Place> = places.into_iter().filter(free).collect();
        (!free.is_empty()).then_some(free)
    }

    /// Feels out a place with `probes` rays.
    fn place(&self, eye: Vec3, probes: usize) -> Place {
        let mut enclosed = 0.0;
        let reach = |k| {
            let direction = probe(k, probes);
            let Some(hit) = (self.trace)(&Ray::new(eye, direction)) else {
                return (direction, f32::INFINITY);
            };
            // Behind its walls one is not in the room; but a wall turned about by mistake should not spoil it.
            enclosed += if self.shows_back(&hit, direction) { 0.5 } else { 1.0 };
            (direction, hit.t)
        };
        let reach = (0..probes).map(reach).collect();
        Place { eye, reach, enclosed: enclosed / probes as f32 }
    }

    /// Whether a surface that has a front is hit from behind.
    fn shows_back(&self, hit: &Hit, direction: Vec3) -> bool {
        facet(self.scene, hit.instance as usize, hit.triangle as usize).is_some_and(|f| {
            let sides = self.scene.materials.get(f.material as usize).map_or(Sides::EmitFront, |m| m.sides);
            sides != Sides::Both && f.normal.dot(direction) > 0.0
        })
    }

    /// The room of a storey that holds most furniture, and the places in it.
    fn room(&self, storey: &Storey, eye: f32, clear: f32) -> Option<(Vec<Place>, Room)> {
        let places = self.places(&storey.columns, eye, clear)?;
        let eyes: Vec<Vec3> = places.iter().map(|place| place.eye).collect();
        let rooms = Rooms::new(self.trace, self.axes.n, &eyes, DOOR * (storey.ceiling - storey.floor));
        let (number, room) = self.fullest(&rooms, storey)?;
        // Of many rooms each has few of the places: more of them, closer together.
        let [bottom, top] = storey.heights;
        let mut columns = self.columns([room.lo.with_z(bottom), room.hi.with_z(top)]);
        columns.retain(|column| storey.has(column));
        let closer = self.places(&columns, eye, clear).unwrap_or_default();
        let all = places.into_iter().chain(closer);
        Some((all.filter(|place| rooms.at(place.eye) == Some(number)).collect(), room))
    }

    /// The number of the room that holds most furniture, and what can be seen of it from anywhere in it.
    fn fullest(&self, rooms: &Rooms<'_>, storey: &Storey) -> Option<(usize, Room)> {
        let points = spread(self.scene, POINTS * rooms.count().min(MOST_ROOMS));
        let homes: Vec<Option<usize>> = points.par_iter().map(|p| rooms.home(p.position)).collect();
        let mut seen: Vec<Vec<Point>> = (0..rooms.count()).map(|_| Vec::new()).collect();
        for (point, home) in points.into_iter().zip(homes) {
            if let Some(home) = home {
                seen[home].push(point);
            }
        }
        let room = |points| Room::new(points, self.scene, &self.axes, storey.floor, storey.ceiling);
        let fuller = |a: (usize, Room), b: (usize, Room)| if b.1.worth() > a.1.worth() { b } else { a };
        seen.into_iter().map(room).enumerate().reduce(fuller)
    }

    /// Every `step`-th of the room's points that is in sight of a place, whichever way one looks.
    fn visible(&self, eye: Vec3, room: &Room, step: usize) -> Vec<usize> {
        (0..room.points.len())
            .step_by(step)
            .filter(|&k| sees(self.trace, eye, room.points[k].position))
            .collect()
    }

    /// The places that promise most at a coarse look, in the order of what they promise.
    fn finalists<'p>(&self, places: &'p [Place], room: &Room, near: f32) -> Vec<&'p Place> {
        let (_, step, headings) = COARSE;
        let mut rated: Vec<(f32, &Place)> = (places.par_iter())
            .map(|place| (self.best_heading(place, room, step, headings, 1, near).score, place))
            .collect();
        rated.sort_by(|a, b| b.0.total_cmp(&a.0));
        rated.into_iter().take(FINALISTS).map(|(_, place)| place).collect()
    }

    /// The best direction to look from a place, by every `step`-th point.
    fn best_heading(
        &self,
        place: &Place,
        room: &Room,
        step: usize,
        headings: usize,
        pitches: usize,
        near: f32,
    ) -> Look {
        let visible = self.visible(place.eye, room, step);
        let looks = (0..headings * pitches).map(|k| {
            let heading = TAU * (k % headings) as f32 / headings as f32;
            // One pitch alone is the best of them: a little down.
            let pitch = if pitches == 1 { -0.15 } else { -0.1 * (k / headings) as f32 };
            let level = self.axes.s * libm::cosf(heading) + self.axes.t * libm::sinf(heading);
            let forward = level * libm::cosf(pitch) + self.axes.n * libm::sinf(pitch);
            let look = self.look(place, room, &visible, forward, FOV_Y, near);
            Look { score: look.score - 0.2 * (pitch + 0.15).abs(), ..look }
        });
        looks.reduce(|a, b| if b.score > a.score { b } else { a }).unwrap_or(Look::NOTHING)
    }

    /// What a direction is worth: much in sight, little within `near` [m], little void.
    fn look(
        &self,
        place: &Place,
        room: &Room,
        visible: &[usize],
        forward: Vec3,
        fov_y: f32,
        near: f32,
    ) -> Look {
        let frustum = Frustum::new(forward, self.axes.n, fov_y, self.aspect);
        let in_sight = visible.iter().filter(|&&k| frustum.contains(room.points[k].position - place.eye));
        let seen = room.seen(in_sight.copied());
        let in_frame = place.reach.iter().filter(|(d, _)| frustum.contains(*d)).map(|(_, r)| *r);
        // What fills the frame from close by, and the void behind an open side, show nothing of the room.
        let (idle, all) =
            in_frame.fold((0.0, 0.0), |(n, all), r| (n + f32::from(r < near || r.is_infinite()), all + 1.0));
        let score = 0.5 * (seen.furniture + seen.walls) - 0.8 * idle / f32::max(all, 1.0);
        Look { score, seen, forward, fov_y }
    }

    /// Eye and direction before each side of the room that is open, so far off that the whole opening is in the picture.
    fn openings(&self, places: &[Place], room: &Room) -> impl Iterator<Item = (Vec3, Vec3)> {
        let (middle, half) = ((room.lo + room.hi) * 0.5, (room.hi - room.lo) * 0.5);
        let slope = libm::tanf((FOV_Y_OUTSIDE * 0.5).to_radians());
        let sides = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y];
        let open = move |outward: &Vec3| {
            let towards = self.axes.to_world(*outward);
            let glances = places.iter().flat_map(|p| &p.reach).filter(|(d, _)| d.dot(towards) > 0.7);
            let (nowhere, all) =
                glances.fold((0, 0), |(n, all), (_, r)| (n + u32::from(r.is_infinite()), all + 1));
            nowhere as f32 > OPEN * all as f32
        };
        sides.into_iter().filter(open).map(move |outward| {
            let width = if outward.x == 0.0 { half.x } else { half.y };
            let distance = (half.z / slope).max(width / (slope * self.aspect));
            let eye = middle + outward * (outward.abs().dot(half) + 1.05 * distance);
            (self.axes.to_world(eye), -self.axes.to_world(outward))
        })
    }
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
                emission: Rgb::grey(emission),
                sides: Sides::EmitFront,
                ..Material::new("any", Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.5))))
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
            // Of a wall that the eye stands at, and of the floor before its feet, no picture shows much.
            assert!(found.seen.furniture > 0.9 && found.seen.walls > 0.4, "sees {:?}", found.seen);
        }
    }

    #[test]
    fn a_room_without_a_wall_is_seen_from_before_the_opening() {
        let mut scene = room();
        // The last face of the room's box is the wall at y = 4.
        let mesh = &mut scene.meshes[0];
        let wall = |t: &[u32; 3]| t.iter().all(|&k| mesh.positions[k as usize].y == 4.0);
        let kept: Vec<[u32; 3]> = mesh.triangles.iter().filter(|t| !wall(t)).copied().collect();
        assert_eq!(kept.len(), 10);
        (mesh.materials, mesh.triangles) = (vec![0; 10], kept);
        let found = found(&scene);
        let (eye, forward) = (found.camera.eye, found.camera.target - found.camera.eye);
        assert!(eye.y > 5.0 && forward.normalize().y < -0.99, "{:?}", found.camera);
        assert!(found.seen.furniture > 0.9 && found.seen.walls > 0.8, "sees {:?}", found.seen);
    }

    #[test]
    fn the_share_of_an_empty_room_is_that_of_its_area() {
        let mut scene = room();
        scene.instances.truncate(1);
        let found = found(&scene);
        let (camera, half) = (&found.camera, libm::tanf((found.camera.fov_y * 0.5).to_radians()));
        let forward = (camera.target - camera.eye).normalize();
        let side = forward.cross(camera.up).normalize();
        // Nothing hides a wall of an empty box: the share is how much of it lies within the picture's four edges.
        let (mut inside, mut all) = (0.0, 0.0);
        let size = Vec3::new(6.0, 4.0, 2.8);
        for (face, a, b) in (0..6).flat_map(|f| (0..100).flat_map(move |a| (0..100).map(move |b| (f, a, b))))
        {
            let axis = face / 2;
            let mut p = Vec3::ZERO;
            p[axis] = (face % 2) as f32;
            p[(axis + 1) % 3] = (a as f32 + 0.5) / 100.0;
            p[(axis + 2) % 3] = (b as f32 + 0.5) / 100.0;
            let w = p * size - camera.eye;
            let (x, y) = (w.dot(side), w.dot(side.cross(forward)));
            let depth = w.dot(forward) * half;
            let area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
            all += area;
            inside += if depth > 0.0 && y.abs() < depth && x.abs() < depth * 4.0 / 3.0 { area } else { 0.0 };
        }
        // 1024 points stand for the area: two standard deviations are 0.031 at most.
        assert!((found.seen.walls - inside / all).abs() < 0.031, "{:?}, not {}", found.seen, inside / all);
        assert_eq!(found.seen.furniture, 1.0);
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
        let frustum =
            Frustum::new((camera.target - camera.eye).normalize(), camera.up, camera.fov_y, 4.0 / 3.0);
        assert!((0..8).all(|k| frustum.contains(scene.meshes[0].positions[k] - camera.eye)));
        let nowhere = found(&Scene::default()).camera;
        assert!(nowhere.eye.is_finite() && nowhere.target.is_finite() && nowhere.eye != nowhere.target);
    }
}
