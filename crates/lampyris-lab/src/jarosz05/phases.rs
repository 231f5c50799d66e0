//! The phases of photon mapping, each measured by itself on the photons and the points of one picture.

use crate::seen::Seen;
use glam::Vec3;
use lampyris::Rgb;
use lampyris::geometry::Ray;
use lampyris::map::{Estimate, Keep, Kernel, Past, Photon, PhotonMap, Precomputed, Reach};
use lampyris::material::Class;
use lampyris::photon::{self, Grid};
use lampyris::scatter::{RandomWalk, Rules};
use lampyris::sequence::uniform;
use lampyris::world::{Surface, World};
use rayon::prelude::*;
use std::time::Instant;

/// Illuminance is kept at one of so many photons, by so many of them.
const EVERY: u32 = 4;
const NEAREST: u32 = 50;

/// What is measured, and how.
#[derive(Clone, Copy)]
pub(super) struct Picture {
    /// Photons shot at what is sharp.
    pub(super) caustics: u32,
    /// Light paths of the global map.
    pub(super) paths: u32,
    /// Rays of a pixel's final gather.
    pub(super) rays: u32,
    /// How far caustic photons may lie from what they light [m].
    pub(super) radius: f32,
    /// And global ones from where somebody looks for one.
    pub(super) within: f32,
    /// Each phase is measured so often; the median counts.
    pub(super) runs: u32,
}

/// How a map is made.
#[derive(Clone, Copy)]
pub(super) struct Made {
    pub(super) photons: usize,
    /// [s]
    pub(super) tracing: f64,
    /// [s]
    pub(super) balancing: f64,
}

/// Medians [s].
pub(super) struct Phases {
    pub(super) caustic: Made,
    pub(super) global: Made,
    /// Range search for caustics in the middle of each pixel.
    pub(super) searching: f64,
    /// Sorting the same photons into the hashed grid, and the same search there.
    pub(super) grid: [f64; 2],
    /// Illuminance kept at global photons.
    pub(super) keeping: f64,
    /// The search for it where rays end, and how many do.
    pub(super) looking: f64,
    pub(super) ends: usize,
}

impl Phases {
    pub(super) fn new(seen: &Seen<'_>, picture: Picture) -> Phases {
        let Picture { caustics, paths, rays, radius, within, runs } = picture;
        let world = seen.world;
        let (tracing, shot) = timed(runs, || caustic_photons(world, caustics));
        let photons: Vec<Photon> = shot.iter().map(Photon::from).collect();
        let (balancing, map) = timed(runs, || PhotonMap::new(photons.clone()));
        let caustic = Made { photons: photons.len(), tracing, balancing };
        let estimate = Estimate { kernel: Kernel::Constant, reach: Reach::Within(radius) };
        let (searching, _) = timed(runs, || seen.estimated(&map, estimate));
        let bounds = world.bounds();
        let origin = bounds.center - bounds.radius;
        let (sorting, grid) = timed(runs, || Grid::new(shot.clone(), origin, radius));
        let read = |x: &Option<Surface<'_>>| {
            let mut sum = Rgb::BLACK;
            x.iter().for_each(|x| grid.radiance(x, |_, light| sum += light));
            sum
        };
        let (in_the_grid, _) = timed(runs, || seen.surfaces.par_iter().map(read).collect::<Vec<_>>());
        let (tracing, photons) = timed(runs, || global_photons(world, paths));
        let (balancing, map) = timed(runs, || PhotonMap::new(photons.clone()));
        let global = Made { photons: photons.len(), tracing, balancing };
        let reach = Reach::Nearest { count: NEAREST, within };
        let estimate = Estimate { kernel: Kernel::Constant, reach };
        let (keeping, kept) = timed(runs, || Precomputed::new(map.clone(), EVERY, estimate));
        let ends = ends(seen, rays);
        let look = |(y, normal): &(Vec3, Vec3)| kept.irradiance(*y, *normal, within);
        let (looking, _) = timed(runs, || ends.par_iter().map(look).collect::<Vec<_>>());
        let grid = [sorting, in_the_grid];
        Phases { caustic, global, searching, grid, keeping, looking, ends: ends.len() }
    }
}

/// Caustics of lamps.
pub(super) fn caustic_photons(world: &World, shot: u32) -> Vec<photon::Photon> {
    photon::from_lights(world, shot, &|_| Rgb::WHITE, (0, 1), true).0
}

/// All light that comes to surfaces.
pub(super) fn global_photons(world: &World, paths: u32) -> Vec<Photon> {
    let walk = RandomWalk::new(world, Rules::default());
    let runs = walk.paths(0..paths, |photons: &mut Vec<Photon>, light| {
        if let Some(flux) = light.lit().filter(|_| Keep::Every.wants(light)) {
            let past = Past { dull: light.diffused, sharp_last: light.sharp, shadow: false };
            let flux = flux * (1.0 / paths as f32);
            photons.push(Photon::new(light.position(), light.normal(), light.from(), flux, past));
        }
    });
    runs.into_iter().flat_map(|(photons, _)| photons).collect()
}

/// Where the rays of a final gather end on surfaces that reflect evenly, and the normals there.
fn ends<'a>(seen: &'a Seen<'_>, rays: u32) -> Vec<(Vec3, Vec3)> {
    let end = |(x, number): (&Surface<'_>, u32)| {
        let [u, v, lobe] = [0, 1, 2].map(|d| uniform(7, number, d));
        let wi = x.sample(Class::Dull, [u, v], lobe)?.wi;
        let y = seen.world.closest(&Ray::new(x.spawn(wi), wi))?;
        y.finish.lambertian.map(|_| (y.position, y.normal))
    };
    let pixels = seen.surfaces.par_iter().zip(0..seen.surfaces.len() as u32);
    let of = |(x, pixel): (&'a Option<Surface<'_>>, u32)| {
        (0..rays).filter_map(move |ray| end((x.as_ref()?, pixel * rays + ray)))
    };
    pixels.flat_map_iter(of).collect()
}

/// The median time of some runs [s], and what the last of them made.
fn timed<T>(runs: u32, mut make: impl FnMut() -> T) -> (f64, T) {
    let mut once = || {
        let start = Instant::now();
        let made = make();
        (start.elapsed().as_secs_f64(), made)
    };
    let (first, mut made) = once();
    let mut times = vec![first];
    for _ in 1..runs {
        let (time, again) = once();
        times.push(time);
        made = again;
    }
    (median(times), made)
}

/// The middle one.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::{RING, tests::shipped};

    /// What is timed is what the library makes at once, to the bit; and rays end on surfaces.
    #[test]
    fn phases_are_those_of_the_library() {
        let world = shipped("ring.mgf");
        let walk = RandomWalk::new(&world, Rules::default());
        let (whole, _) = PhotonMap::of_walk(&walk, 0..3000, |light| Keep::Every.wants(light));
        assert!(PhotonMap::new(global_photons(&world, 3000)) == whole && !whole.photons().is_empty());
        let seen = Seen::new(&world, RING, [16, 12]);
        let picture = Picture { caustics: 2000, paths: 500, rays: 2, radius: 0.01, within: 0.1, runs: 1 };
        let phases = Phases::new(&seen, picture);
        assert_eq!(phases.caustic.photons, caustic_photons(&world, 2000).len());
        assert!(phases.ends > 100 && phases.ends <= 2 * 16 * 12, "{}", phases.ends);
        let times = [phases.searching, phases.grid[0], phases.grid[1], phases.keeping, phases.looking];
        assert!(times.iter().all(|t| *t > 0.0 && t.is_finite()));
    }
}
