//! What is shown has, over a whole surface, the light of the exact sums: looking again at edges moves light between
//! neighbours, and neither takes nor gives any.

mod support;

use glam::Vec3;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::material::Sides;
use lampyris::testing::Moments;
use support::{Build, gloss, say, view};

/// A polished floor, which fills the picture, before a wall that glows in part: eye paths that end on the floor, which is
/// black here, and second ones, by chance, that see the wall's reflection. If that chance decided who looks again, or further
/// looks forgot what second paths saw, part of the reflection would be missing.
#[test]
fn polish_keeps_its_reflections() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let floor = b.material(gloss(0.6, 0.05, 0.0), 0.0, Sides::Both);
    let panel = b.glow(60.0);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, wall, floor, wall, wall, wall]);
    b.quad(Vec3::new(0.4, 0.5, 1.99), Vec3::Y * 0.8, Vec3::X * 1.2, panel);
    let eye = view(Vec3::new(1.0, 1.6, 0.3), Vec3::new(1.0, 0.0, 1.0), 40.0, 48, 40);
    let mut shown = Moments::default();
    for seed in 0..48 {
        let settings = Settings { parts: vec!["emission".into()], seed, ..Settings::interactive() };
        let mut cpu = Cpu::new(None).expect("threads");
        cpu.begin(b.0.clone(), eye.clone(), &settings).expect("sound");
        (0..2).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
        let frame = cpu.frame().expect("begun");
        let light =
            |picture: Vec<lampyris::Rgb>| picture.iter().map(|v| f64::from(v.luminance())).sum::<f64>();
        // The same batches: their own noise is in both.
        shown.push(light(frame.shown()) / light(frame.mean()) - 1.0);
    }
    let (mean, error) = (shown.mean(), shown.standard_error());
    say(format_args!("shown over exact light: {mean:+.4} ± {error:.4}"));
    assert!(error < 0.02 && mean.abs() < 3.5 * error + 1e-3);
}
