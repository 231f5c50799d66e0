//! The Cornell box against another renderer's picture of the same box (Mitsuba 3's path tracer, 5376 samples a pixel).
//! The reference lies in the folder that `LAMPYRIS_REFS` names.

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::import;
use lampyris::scene::{Camera, View};
use std::path::{Path, PathBuf};

const WIDTH: usize = 640;
const HEIGHT: usize = 480;
/// Pixels of the reference along the edge of one of ours.
const BLOCK: usize = 4;

fn reference() -> Vec<Rgb> {
    let folder =
        std::env::var_os("LAMPYRIS_REFS").expect("LAMPYRIS_REFS names the folder of reference pictures");
    let file = PathBuf::from(folder).join("cornell_640x480.exr");
    let image = exr::prelude::read_first_rgba_layer_from_file(
        &file,
        |size, _| vec![Rgb::BLACK; size.area()],
        |pixels: &mut Vec<Rgb>, at, (r, g, b, _): (f32, f32, f32, f32)| {
            pixels[at.y() * WIDTH + at.x()] = Rgb::new(r, g, b);
        },
    )
    .unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let pixels = image.layer_data.channel_data.pixels;
    assert_eq!(pixels.len(), WIDTH * HEIGHT);
    let mean = |x: usize, y: usize| {
        let block = (0..BLOCK * BLOCK)
            .map(|k| pixels[(y * BLOCK + k / BLOCK) * WIDTH + x * BLOCK + k % BLOCK])
            .fold(Rgb::BLACK, |a, b| a + b);
        block / (BLOCK * BLOCK) as f32
    };
    (0..HEIGHT / BLOCK)
        .flat_map(|y| (0..WIDTH / BLOCK).map(move |x| (x, y)))
        .map(|(x, y)| mean(x, y))
        .collect()
}

/// The picture at a quarter of the reference's size, and half its relative 95 % interval.
fn render(parts: &[&str], paths: u32, passes: u32, batches: u32) -> (Vec<Rgb>, f32) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cornell.mgf");
    let scene = import::load(&file, &import::Options::default()).unwrap().scene;
    let camera = Camera {
        name: "reference".into(),
        eye: Vec3::new(2.78, 2.73, -8.0),
        target: Vec3::new(2.78, 2.73, 0.0),
        up: Vec3::Y,
        fov_y: 39.307_65,
    };
    let view = View::new(&camera, (WIDTH / BLOCK) as u32, (HEIGHT / BLOCK) as u32);
    let settings = Settings {
        parts: parts.iter().map(|p| (*p).to_owned()).collect(),
        paths,
        passes: Some(passes),
        ..Settings::default()
    };
    let mut cpu = Cpu::new(None).unwrap();
    cpu.begin(scene, Eye::Camera(view), &settings).unwrap();
    for index in 0..batches {
        cpu.add(Batch { index }).unwrap();
    }
    let frame = cpu.frame().unwrap();
    (frame.mean(), frame.relative_error() * frame.student_factor())
}

/// Ratio of the means of each channel, the lamp and its edge left out: there a subpixel decides.
fn ratios(ours: &[Rgb], reference: &[Rgb]) -> [f64; 3] {
    let row = WIDTH / BLOCK;
    let bright = |k: usize| reference.get(k).is_some_and(|c| c.r > 1.5);
    let near_lamp = |k: usize| [k, k + 1, k - 1, k + row, k - row].into_iter().any(bright);
    let sums =
        (row..reference.len() - row).filter(|k| !near_lamp(*k)).fold([[0.0f64; 2]; 3], |mut sums, k| {
            for (c, sum) in sums.iter_mut().enumerate() {
                sum[0] += f64::from(ours[k][c]);
                sum[1] += f64::from(reference[k][c]);
            }
            sums
        });
    sums.map(|[ours, reference]| ours / reference)
}

#[test]
#[ignore = "needs LAMPYRIS_REFS"]
fn path_agrees_with_mitsuba_in_each_channel() {
    let (ours, _) = render(&["path"], 64, 64, 4);
    let ratios = ratios(&ours, &reference());
    assert!(ratios.iter().all(|r| (r - 1.0).abs() < 0.005), "{ratios:?}");
}

#[test]
#[ignore = "needs LAMPYRIS_REFS"]
fn the_parts_agree_with_mitsuba_within_their_stated_error() {
    let (ours, error) =
        render(&["emission", "direct", "vpl", "compensation", "mirror", "caustic"], 256, 4, 64);
    let ratios = ratios(&ours, &reference());
    assert!(error < 0.02, "the interval is too wide to say anything: {error}");
    // The interval is the luminance's; single channels, carried by fewer bounces, spread a little more.
    assert!(ratios.iter().all(|r| (r - 1.0).abs() < f64::from(error) * 1.5), "{ratios:?} ± {error}");
}
