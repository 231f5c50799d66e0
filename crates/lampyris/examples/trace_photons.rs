//! Speed of caustic photons: `trace_photons SCENE [PHOTONS]`. It traces and sorts that many (a million unless told
//! otherwise), half of them from the lights and half from the walk, on all cores, and asks the map of a picture's batch,
//! and the large one, at every visible point of a picture of 640 × 480 from the scene's first camera.

use glam::Vec3;
use lampyris::backend::{Batch, Settings};
use lampyris::eye::{Eye, Rect, Sampling};
use lampyris::geometry::LANES;
use lampyris::import;
use lampyris::particle::{Plan, Walk};
use lampyris::photon::Photons;
use lampyris::scene::View;
use lampyris::world::World;
use std::path::Path;
use std::time::Instant;

const REPETITIONS: usize = 7;

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

fn vector(lanes: &[[f32; LANES]; 3], k: usize) -> Vec3 {
    Vec3::new(lanes[0][k], lanes[1][k], lanes[2][k])
}

#[allow(clippy::print_stdout, reason = "a program that prints figures")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let file = arguments.first().ok_or("which scene?")?;
    let photons: u32 = arguments.get(1).map_or(Ok(1_000_000), |n| n.parse())?;
    let world = World::new(import::load(Path::new(file), &import::Options::default())?.scene);
    let camera = world.scene().cameras.first().ok_or("the scene has no camera")?;
    let eye = Eye::Camera(View::new(camera, 640, 480));
    let mut tile = eye.tiles(&world, Rect { x: 0, y: 0, width: 640, height: 480 }, [1, 1]).remove(0);
    eye.look(&Sampling { offset: [0.5, 0.5], index: 0, seed: 0 }, &mut tile);

    for photons in [Settings::default().photons, photons / 2] {
        let settings = Settings { photons, ..Settings::default() };
        let batch = Batch { index: 0 };
        let plan = Plan::new(&world, &settings);
        let walk = Walk::new(&world, &settings, &plan, batch);
        let (seconds, map) =
            timed(|| Photons::new(&world, &settings, &plan, &[0], std::slice::from_ref(&walk), batch));
        println!(
            "{} photons traced and sorted in {seconds:.3} s, {} rays; {} + {} stayed, radii {:.2} and {:.2} mm",
            2 * photons,
            map.rays,
            map.near.photons().len(),
            map.far.photons().len(),
            1e3 * map.near.radius(),
            1e3 * map.far.radius()
        );
        let (seconds, (points, sum)) = timed(|| {
            let (mut points, mut sum) = (0_u32, 0.0);
            for packet in &tile.packets {
                for k in (0..LANES).filter(|k| packet.live >> k & 1 == 1) {
                    let mut e = [lampyris::Rgb::BLACK];
                    map.irradiance(vector(&packet.position, k), vector(&packet.geometric, k), &mut e);
                    sum += f64::from(e[0].luminance());
                    points += 1;
                }
            }
            (points, sum)
        });
        println!(
            "{points} queries of both maps, {:.3} µs each; mean {:.6} lx",
            1e6 * seconds / f64::from(points),
            sum / f64::from(points)
        );
    }
    Ok(())
}
