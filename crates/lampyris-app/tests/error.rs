//! The error that the program states is the error that there is.

use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::frame::Frame;
use lampyris::import;
use lampyris::scene::{Camera, View};
use lampyris::world::World;
use std::path::Path;

/// Mean luminance of a small picture of the Cornell box and its stated relative standard error, by seed.
fn pictures(parts: &[&str], batches: u32, seeds: u32) -> Vec<(f64, f64)> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cornell.mgf");
    let scene = import::load(&file, &import::Options::default()).unwrap().scene;
    let camera = Camera {
        name: String::new(),
        eye: glam::Vec3::new(2.78, 2.73, -8.0),
        target: glam::Vec3::new(2.78, 2.73, 0.0),
        up: glam::Vec3::Y,
        fov_y: 39.3,
    };
    let mut cpu = Cpu::new(None).unwrap();
    let mut picture = |seed| {
        let parts = parts.iter().map(|p| (*p).to_owned()).collect();
        let settings = Settings { parts, paths: 16, seed, ..Settings::default() };
        let eye = Eye::Camera(View::new(&camera, 24, 18));
        cpu.begin_world(World::new(scene.clone()), eye, &settings).unwrap();
        (0..batches).for_each(|index| cpu.add(Batch { index }).unwrap());
        let frame = cpu.frame().unwrap();
        let mean = frame.mean().iter().map(|c| f64::from(c.luminance())).sum::<f64>() / (24.0 * 18.0);
        (mean, f64::from(frame.relative_error()))
    };
    (0..seeds).map(&mut picture).collect()
}

#[test]
fn the_stated_error_is_the_spread_over_seeds() {
    for (parts, batches) in [(&["direct"][..], 4), (&["vpl"][..], 4), (&["direct", "vpl"][..], 8)] {
        let pictures = pictures(parts, batches, 24);
        let n = pictures.len() as f64;
        let mean = pictures.iter().map(|(m, _)| m).sum::<f64>() / n;
        let spread = (pictures.iter().map(|(m, _)| (m / mean - 1.0).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
        let stated = (pictures.iter().map(|(_, e)| e * e).sum::<f64>() / n).sqrt();
        // Both are standard deviations, of 72 and of 23 degrees of freedom: by Fisher's F a ratio beyond these
        // bounds is rarer than one in a thousand.
        assert!((0.5..2.0).contains(&(stated / spread)), "{parts:?}: stated {stated}, spread {spread}");
    }
}

#[test]
fn the_interval_of_95_percent_is_student_s() {
    // Quantiles of Student's distribution at 97.5 % [any table]: 12.706 for one degree of freedom, 3.182 for three.
    let mut frame = Frame::new(1, 1, &["direct"], &Settings::default(), 1);
    frame.count(0, 0);
    assert_eq!(frame.student_factor(), f32::INFINITY);
    frame.count(0, 1);
    assert!((frame.student_factor() - 12.706).abs() < 1e-3);
    frame.count(0, 2);
    frame.count(0, 3);
    assert!((frame.student_factor() - 3.182).abs() < 1e-3);
}
