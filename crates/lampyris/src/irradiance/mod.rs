//! Irradiance of a batch, kept at a few points that the eye sees and interpolated between them [Ward et al. 1988; Ward and
//! Heckbert 1992]: an option of final gathering, where surfaces reflect evenly.
//!
//! The points are found before the picture is drawn, over ever finer grids of pixels: where no record counts, one is made. Those of
//! one grid do not know of each other, save within a small square, so threads need not wait; and where records lie is a
//! matter of the surfaces alone, so that the light of one group does not depend on that of others.

mod hemisphere;
mod octree;
mod record;

use crate::coarse::Coarse;
use crate::color::Rgb;
use crate::eye::{Eye, Numbers, Rect, Sampling, Tile};
use crate::geometry::Ray;
use crate::sequence;
use crate::settings::{Rays, Settings};
use crate::world::{Surface, World};
use glam::Vec3;
use hemisphere::{Cells, Hemisphere, Light};
use octree::Octree;
use rayon::prelude::*;
use record::{Place, Record};

/// Rays of a record for each one of a plain gather.
const RAYS: u32 = 8;

/// Fewest rays of a record: fewer do not tell how light changes.
const LEAST_RAYS: u32 = 64;

/// From which to which of the pixels in a row or column points are looked for.
const STEPS: [u32; 4] = [32, 16, 8, 4];

/// Points in a row and in a column of a square.
const SQUARE: u32 = 8;

/// Records of one batch.
#[derive(Clone, Debug)]
pub struct Irradiance {
    /// a, the error that is aimed at.
    accuracy: f32,
    groups: usize,
    records: Vec<Record>,
    /// Of each record, the groups' light.
    lights: Vec<Light>,
    tree: Octree,
    /// Rays that it took.
    pub rays: Rays,
}

/// What all squares of a grid share.
struct Grid<'w> {
    world: &'w World,
    eye: &'w Eye,
    coarse: &'w Coarse<'w>,
    sampling: Sampling,
    cells: &'w Cells,
    /// Every so many pixels there is a point.
    step: u32,
    /// Which ones: a number below `step`².
    class: u32,
}

/// Records of a square, and the rays that they took.
type Found = (Vec<(Record, Vec<Light>)>, Rays);

impl Irradiance {
    /// Makes the records of a batch; `None` where the settings ask for none, and for meters, which hang where nobody looks and
    /// shall not interpolate. The `coarse` solution has so many `groups`, and its rays start where the eye's `sampling` ends.
    pub fn new(
        world: &World,
        eye: &Eye,
        settings: &Settings,
        (coarse, groups): (&Coarse<'_>, usize),
        sampling: Sampling,
    ) -> Option<Irradiance> {
        let accuracy = settings.gather.cache.filter(|_| matches!(eye, Eye::Camera(_)))?;
        let bounds = world.bounds();
        let tree = Octree::new(bounds.center, bounds.radius);
        let (records, lights) = (Vec::new(), Vec::new());
        let mut all = Irradiance { accuracy, groups, records, lights, tree, rays: Rays::default() };
        let cells = Cells::of((RAYS * settings.gather.rays).max(LEAST_RAYS));
        for step in STEPS {
            let class = sequence::hash(sequence::hash(sampling.seed, sampling.index), step) % (step * step);
            let grid = Grid { world, eye, coarse, sampling, cells: &cells, step, class };
            let found: Vec<Found> = squares(eye.size(), step * SQUARE)
                .into_par_iter()
                .map_init(Tile::default, |tile, rect| all.within(&grid, rect, tile))
                .collect();
            for (records, rays) in found {
                all.rays += rays;
                records.into_iter().for_each(|(record, lights)| all.insert(record, lights));
            }
        }
        Some(all)
    }

    /// How many there are.
    pub fn records(&self) -> usize {
        self.records.len()
    }

    /// Sets the irradiance of a point on the side of `wo`, group by group [lx]; false, and then nothing is set, where no record
    /// counts.
    pub fn at(&self, x: &Surface<'_>, irradiance: &mut [Rgb]) -> bool {
        let place = Place::from(x);
        let mut total = 0.0;
        for k in self.tree.around(place.position) {
            let record = &self.records[k as usize];
            let Some(weight) = record.weight(self.accuracy, &place) else { continue };
            if total == 0.0 {
                irradiance.fill(Rgb::BLACK);
            }
            total += weight;
            // E_i + (n_i × n) · ∇_r E_i + (x − x_i) · ∇_t E_i [Ward and Heckbert 1992].
            let (turn, way) =
                (record.place.normal.cross(place.normal), place.position - record.place.position);
            let first = k as usize * self.groups;
            for (sum, light) in irradiance.iter_mut().zip(&self.lights[first..]) {
                *sum += (light.irradiance + along(&light.turned, turn) + along(&light.moved, way)) * weight;
            }
        }
        irradiance.iter_mut().filter(|_| total > 0.0).for_each(|sum| *sum *= 1.0 / total);
        total > 0.0
    }

    fn insert(&mut self, record: Record, lights: Vec<Light>) {
        self.tree.insert(self.records.len() as u32, record.place.position, self.accuracy * record.distance);
        self.records.push(record);
        self.lights.extend(lights);
    }

    /// Makes records at points of a square where none of those so far counts, nor one of its own.
    fn within<'w>(&self, grid: &Grid<'w>, rect: Rect, tile: &mut Tile<'w>) -> Found {
        let mut found: Vec<(Record, Vec<Light>)> = Vec::new();
        let mut rays = Rays::default();
        grid.eye.lay_out_class(grid.world, rect, [grid.step; 2], grid.class, tile);
        grid.eye.look(&grid.sampling, tile);
        rays.eye += tile.rays;
        for p in &tile.packets {
            for (k, x) in p.lanes().filter_map(|k| Some((k, p.visible(k)?.surface))) {
                let Some((x, _)) = evenly(&x) else { continue };
                let place = Place::from(&x);
                let counts = |record: &Record| record.weight(self.accuracy, &place).is_some();
                let known = self.tree.around(x.position).any(|k| counts(&self.records[k as usize]));
                if !known && !found.iter().any(|(record, _)| counts(record)) {
                    let numbers = p.numbers[k].branch(b'i'.into());
                    found.push(self.record(grid, &x, place, numbers, &mut rays));
                }
            }
        }
        (found, rays)
    }

    /// A new record.
    fn record(
        &self,
        grid: &Grid<'_>,
        x: &Surface<'_>,
        place: Place,
        numbers: Numbers,
        rays: &mut Rays,
    ) -> (Record, Vec<Light>) {
        let seed = sequence::hash(numbers.seed, numbers.index);
        let jitter = |cell| [0, 1].map(|d| sequence::uniform(seed, cell as u32, d));
        let seen = Hemisphere::look(grid.cells, place.normal, self.groups, jitter, |direction, out| {
            look(grid.world, grid.coarse, x, direction, out)
        });
        rays.gather += grid.cells.count() as u64;
        // It counts at least for the pixels to the next point of the finest grid, and nothing is farther off than the scene.
        let least = STEPS[STEPS.len() - 1] as f32 * grid.eye.pixel_size(x.position) / self.accuracy;
        let distance = seen.distance().min(grid.world.bounds().radius).max(least);
        let record = Record { place, distance };
        let lights = record.lights(self.accuracy, &seen, self.groups);
        (record, lights)
    }
}

/// What a point reflects evenly, as a surface of its own, and what else it reflects; `None` where the one cannot be told from the
/// other.
pub fn evenly<'w>(x: &Surface<'w>) -> Option<(Surface<'w>, Option<Surface<'w>>)> {
    if x.finish.lambertian.is_some() {
        return Some((*x, None));
    }
    let [even, other] = x.parted()?;
    even.finish.lambertian.filter(|rho| !rho.is_black()).map(|_| (even, Some(other)))
}

/// Sets what surfaces reflect toward a point from a direction, group by group [cd/m²], and returns one over the distance of the
/// surface that is met.
fn look(world: &World, coarse: &Coarse<'_>, x: &Surface<'_>, direction: Vec3, out: &mut [Rgb]) -> f32 {
    // Below the surface itself, where its normals disagree, there is nothing to see.
    if direction.dot(x.normal) <= 0.0 {
        return 0.0;
    }
    let ray = Ray::new(x.spawn(direction), direction);
    let Some(hit) = world.tracer().closest(&ray) else { return 0.0 };
    let y = world.surface(direction, &hit);
    coarse.add_mean(world, &hit, &y, y.clear_from(ray.origin, Some(x)), out);
    1.0 / hit.t
}

/// A gradient along a way.
fn along(gradient: &[Rgb; 3], way: Vec3) -> Rgb {
    gradient[0] * way.x + gradient[1] * way.y + gradient[2] * way.z
}

/// A picture in squares, row by row.
fn squares((width, height): (u32, u32), edge: u32) -> Vec<Rect> {
    let corners = (0..height)
        .step_by(edge as usize)
        .flat_map(|y| (0..width).step_by(edge as usize).map(move |x| (x, y)));
    corners.map(|(x, y)| Rect { x, y, width: edge.min(width - x), height: edge.min(height - y) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ACCURACY: f32 = 0.4;

    /// Records at places and with normals, of light that changes linearly along ways, and with the normal as that of a far lamp.
    fn known(places: &[(Vec3, Vec3)], slope: Vec3, lamp: Vec3) -> Irradiance {
        let tree = Octree::new(Vec3::ZERO, 4.0);
        let (records, lights, rays) = (Vec::new(), Vec::new(), Rays::default());
        let mut all = Irradiance { accuracy: ACCURACY, groups: 1, records, lights, tree, rays };
        for (position, normal) in places.iter().copied() {
            let irradiance = Rgb::grey(2.0 + slope.dot(position) + lamp.dot(normal));
            let moved = slope.to_array().map(Rgb::grey);
            // A turn about n × l is one toward the lamp.
            let turned = normal.cross(lamp).to_array().map(Rgb::grey);
            let place = Place { position, normal, geometric: Vec3::Z };
            all.insert(Record { place, distance: 1.0 }, vec![Light { irradiance, turned, moved }]);
        }
        all
    }

    fn at(records: &Irradiance, position: Vec3, normal: Vec3) -> Option<f32> {
        let mut sum = [Rgb::grey(7.0)];
        let surface = Surface { shading: normal, ..Surface::meter(position, Vec3::Z * normal.z.signum()) };
        records.at(&surface, &mut sum).then_some(sum[0].g)
    }

    #[test]
    fn gradients_carry_light_to_where_it_is_asked_for() {
        let (slope, lamp) = (Vec3::new(3.0, -1.0, 0.0), Vec3::new(0.5, 0.2, 0.8));
        let tilted = Vec3::new(0.1, -0.05, 1.0).normalize();
        let places = [(Vec3::ZERO, Vec3::Z), (Vec3::new(0.3, 0.1, 0.0), tilted)];
        let records = known(&places, slope, lamp);
        for (x, y, tilt) in [(0.1, 0.05, 0.0), (0.2, 0.2, 0.05), (-0.2, 0.1, 0.0), (0.0, 0.0, 0.1)] {
            let (position, normal) = (Vec3::new(x, y, 0.0), Vec3::new(tilt, tilt, 1.0).normalize());
            let exact = 2.0 + slope.dot(position) + lamp.dot(normal);
            let found = at(&records, position, normal).expect("a record is near");
            // Of a turn, what is of second order is lost.
            assert!(
                (found - exact).abs() < 1e-5 + 0.04 * f32::from(tilt > 0.0 || x > 0.0),
                "{position}: {found} {exact}"
            );
        }
        // At its own place a record says what it knows.
        let own = at(&records, places[1].0, places[1].1).expect("itself");
        assert!((own - records.lights[1].irradiance.g).abs() < 1e-3 * own);
    }

    #[test]
    fn records_count_where_they_may() {
        let records = known(&[(Vec3::ZERO, Vec3::Z)], Vec3::ZERO, Vec3::ZERO);
        let count = |position, normal| at(&records, position, normal).is_some();
        assert!(count(Vec3::X * 0.39, Vec3::Z) && !count(Vec3::X * 0.41, Vec3::Z));
        // √(1 − cos 30°) = 0.366, and 0.43 for 35°.
        let turned =
            |degrees: f32| Vec3::new(libm::sinf(degrees.to_radians()), 0.0, libm::cosf(degrees.to_radians()));
        assert!(
            count(Vec3::ZERO, turned(30.0))
                && !count(Vec3::ZERO, turned(35.0))
                && !count(Vec3::ZERO, -Vec3::Z)
        );
        // What lies above or below sees what is hidden from the record, but where the surface bends that far.
        assert!(count(Vec3::new(0.1, 0.0, 5e-4), Vec3::Z));
        for height in [-0.01, 0.01] {
            let way = Vec3::new(0.1, 0.0, height);
            assert!(!count(way, Vec3::Z));
            let bent = Place { position: way, normal: Vec3::Z, geometric: turned(-15.0 * height.signum()) };
            assert!(records.records[0].weight(ACCURACY, &bent).is_some());
        }
        assert!(!count(Vec3::X * 3.9, Vec3::Z) && !count(Vec3::X * 40.0, Vec3::Z));
    }

    #[test]
    fn squares_cover_a_picture_once() {
        for (size, edge) in [((64, 32), 32), ((77, 53), 32), ((5, 3), 64)] {
            let mut seen = vec![0; (size.0 * size.1) as usize];
            for rect in squares(size, edge) {
                assert!(rect.x.is_multiple_of(edge) && rect.y.is_multiple_of(edge), "classes would not meet");
                for (x, y) in (0..rect.width * rect.height).map(|k| rect.pixel(k)) {
                    seen[(y * size.0 + x) as usize] += 1;
                }
            }
            assert!(seen.iter().all(|times| *times == 1), "{size:?} by {edge}");
        }
    }
}
