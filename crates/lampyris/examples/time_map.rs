//! Speed of the photon map: `time_map [PHOTONS]`. It balances that many photons (a million unless told otherwise) strewn over
//! the six walls of a room, or through its volume, on all cores and on one, and asks for the 50 nearest photons, for
//! illuminance by them and within a radius of as many, and for illuminance kept at every fourth photon, at as many places on
//! the walls, one thread asking.

use glam::Vec3;
use lampyris::Rgb;
use lampyris::map::{Estimate, Kernel, Nearest, Past, Photon, PhotonMap, Precomputed, Reach, Reader};
use lampyris::sequence::uniform;
use std::time::Instant;

const REPETITIONS: usize = 7;
const QUERIES: u32 = 20_000;
const COUNT: u32 = 50;

/// The median time of some repetitions [s], and what was made in the last.
fn timed<T>(mut make: impl FnMut() -> T) -> (f64, T) {
    let mut once = || {
        let start = Instant::now();
        let made = make();
        (start.elapsed().as_secs_f64(), made)
    };
    let mut all: Vec<(f64, T)> = (0..REPETITIONS).map(|_| once()).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.swap_remove(REPETITIONS / 2)
}

/// The median time of single queries [µs].
fn median(mut ask: impl FnMut(u32)) -> f64 {
    let mut time = |k: u32| {
        let start = Instant::now();
        ask(k);
        start.elapsed().as_secs_f64()
    };
    let mut all: Vec<f64> = (0..QUERIES).map(&mut time).collect();
    all.sort_by(f64::total_cmp);
    1e6 * all[all.len() / 2]
}

/// A place and the normal there.
fn on_a_wall(k: u32, dimension: u32) -> (Vec3, Vec3) {
    let [u, v, wall] = [0, 1, 2].map(|d| uniform(5, k, dimension + d));
    let wall = (wall * 6.0) as usize;
    let (axis, side) = (wall % 3, (wall / 3) as f32);
    let mut p = Vec3::new(u, v, u);
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    p[axis] = side;
    let mut n = Vec3::ZERO;
    n[axis] = 1.0 - 2.0 * side;
    (p * Vec3::new(8.0, 3.0, 5.0), n)
}

#[allow(clippy::print_stdout, reason = "a program that prints figures")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count: u32 = std::env::args().nth(1).map_or(Ok(1_000_000), |n| n.parse())?;
    let volume = |k: u32| [0, 1, 2].map(|d| 8.0 * uniform(6, k, d)).into();
    for name in ["walls", "volume"] {
        let place = |k: u32| if name == "walls" { on_a_wall(k, 0) } else { (volume(k), Vec3::Y) };
        let photon = |k: u32| {
            let (p, n) = place(k);
            Photon::new(p, n, n, Rgb::WHITE, Past::default())
        };
        let photons: Vec<Photon> = (0..count).map(photon).collect();
        for threads in [1, 2, 0] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
            let (copying, _) = timed(|| photons.clone());
            let (seconds, _) = timed(|| pool.install(|| PhotonMap::new(photons.clone())));
            println!(
                "{name}: {count} photons balanced in {:.3} s on {} threads",
                seconds - copying,
                pool.current_num_threads()
            );
        }
        let map = PhotonMap::new(photons);
        let ask = |k: u32| if name == "walls" { on_a_wall(k, 8) } else { (volume(k + count), Vec3::Y) };
        let mut nearest = Nearest::new(COUNT as usize);
        let mut sum = 0.0;
        let search = median(|k| {
            map.nearest(ask(k).0, f32::INFINITY, &mut nearest, |_, _, _| true);
            sum += nearest.found().next().map_or(0.0, |(_, d)| f64::from(d));
        });
        println!(
            "{name}: {COUNT} nearest in {search:.2} µs, mean square of distances {:.2e}",
            sum / f64::from(QUERIES)
        );
        let radius = (sum / f64::from(QUERIES)).sqrt() as f32;
        for kernel in Kernel::ALL {
            for reach in [Reach::Nearest { count: COUNT, within: f32::INFINITY }, Reach::Within(radius)] {
                let mut reader = Reader::new(&map, Estimate { kernel, reach });
                let mut sum = 0.0;
                let time = median(|k| {
                    let (x, n) = ask(k);
                    sum += f64::from(reader.irradiance(x, n).g);
                });
                println!(
                    "{name}: {kernel:?}, {reach:?}: {time:.2} µs, mean {:.1} lx",
                    sum / f64::from(QUERIES)
                );
            }
        }
        let estimate =
            Estimate { kernel: Kernel::Constant, reach: Reach::Nearest { count: COUNT, within: 1.0 } };
        let start = Instant::now();
        let kept = Precomputed::new(map, 4, estimate);
        println!("{name}: illuminance kept at every fourth photon in {:.2} s", start.elapsed().as_secs_f64());
        let mut sum = 0.0;
        let time = median(|k| {
            let (x, n) = ask(k);
            sum += kept.irradiance(x, n, 1.0).map_or(0.0, |e| f64::from(e.g));
        });
        println!("{name}: found in {time:.2} µs, mean {:.1} lx", sum / f64::from(QUERIES));
    }
    Ok(())
}
