//! Clamping is an exact split: min(G, b) by virtual lights and (G − b)⁺ by short rays sum to the unclamped light for any
//! bound, and the clamped share alone is less and grows with the bound.

mod support;

use glam::Vec3;
use lampyris::backend::Settings;
use lampyris::eye::Eye;
use lampyris::material::Sides;
use lampyris::scene::Scene;
use lampyris::testing::{Moments, sidak};
use support::{Build, FAST, diffuse, gloss, meter, render, say, settings, view};

const SEEDS: u32 = 16;
const CLAMPS: [f32; 3] = [0.5, 1.0, 2.0];

/// A room with a lamp, a block and a glossy floor: 2 × 2 × 2 m.
fn room() -> Scene {
    let mut b = Build::default();
    let wall = b.grey(0.6);
    let floor = b.material(gloss(0.3, 0.3, 0.25), 0.0, Sides::Both);
    let glow = b.material(diffuse(0.2), 10.0, Sides::EmitFront);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, wall, floor, wall, wall, wall]);
    b.block(Vec3::new(0.5, 0.0, 0.3), Vec3::new(1.1, 0.7, 0.9), wall);
    b.quad(Vec3::new(0.7, 1.95, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, glow);
    b.0
}

/// A picture of 3 × 2 tiles and three meters, one of them 5 cm before a corner.
fn eyes() -> [Eye; 2] {
    let meters = vec![
        meter(Vec3::new(1.5, 1e-4, 1.5), Vec3::Y),
        meter(Vec3::new(0.05, 1e-4, 0.05), Vec3::Y),
        meter(Vec3::new(1.0, 1.0, 1e-4), Vec3::Z),
    ];
    [view(Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3), 70.0, 12, 8), Eye::Meters(meters)]
}

/// Tiles of 4 × 4 pixels and meters, over the seeds.
fn observe(s: &Settings, seeds: std::ops::Range<u32>, batches: u32) -> Vec<Moments> {
    let scene = room();
    let [camera, meters] = eyes();
    let mut all = vec![Moments::default(); 9];
    for seed in seeds {
        let s = Settings { seed, ..s.clone() };
        let picture = render(&scene, camera.clone(), &s, batches);
        let mut values = vec![0.0; 6];
        for (k, v) in picture.iter().enumerate() {
            values[k / 12 / 4 * 3 + k % 12 / 4] += f64::from(v.luminance()) / 16.0;
        }
        let e = render(&scene, meters.clone(), &s, batches);
        values.extend(e.iter().map(|v| f64::from(v.luminance())));
        all.iter_mut().zip(values).for_each(|(m, v)| m.push(v));
    }
    all
}

/// Every bound against none, Welch's t by tile and meter at 1 % in all. Seeds are no side's twice.
#[test]
fn any_bound_gives_the_unclamped_light() {
    let s = settings(FAST, 1 << 9, 1 << 6, 0);
    let unclamped = observe(&Settings { clamp: 0.0, ..s.clone() }, 0..SEEDS, 8);
    for (k, clamp) in (1u32..).zip(CLAMPS) {
        let seeds = k * SEEDS..(k + 1) * SEEDS;
        let clamped = observe(&Settings { clamp, ..s.clone() }, seeds, 8);
        let least = clamped.iter().zip(&unclamped).map(|(a, b)| a.p_value_against(b)).fold(1.0, f64::min);
        let sum = |m: &[Moments]| m.iter().map(Moments::mean).sum::<f64>();
        let noise = clamped.iter().map(|m| m.standard_error() / m.mean()).fold(0.0, f64::max);
        say(format_args!(
            "c = {clamp}: clamped/unclamped {:+.1e}, least p {least:.4}, noisiest ± {noise:.1e}",
            sum(&clamped) / sum(&unclamped) - 1.0
        ));
        assert!(least > sidak(0.01, 9 * CLAMPS.len()), "c = {clamp}: p = {least}");
        assert!(noise < 0.05, "c = {clamp}: too noisy to tell anything");
    }
}

/// With the same seeds the clamped part alone never gains by clamping, tile by tile and meter by meter: each light's
/// min(G, b) falls with b, and c = 0 is b = ∞. Compensation is what fills the gap.
#[test]
fn the_clamped_part_alone_is_less() {
    let part = |clamp| {
        let s = Settings { clamp, ..settings(&["vpl"], 1 << 9, 1 << 6, 0) };
        observe(&s, 0..2, 2)
    };
    let mut before = part(0.0);
    for clamp in [0.5, 1.0, 2.0, 4.0] {
        let now = part(clamp);
        for (a, b) in before.iter().zip(&now) {
            assert!(b.mean() <= a.mean() * (1.0 + 1e-5), "c = {clamp}: {} after {}", b.mean(), a.mean());
        }
        before = now;
    }
    let sum = |m: &[Moments]| m.iter().map(Moments::mean).sum::<f64>();
    let left = sum(&before) / sum(&part(0.0));
    say(format_args!("c = 4 leaves {left:.3} of the indirect light to virtual lights"));
    assert!(left < 0.97, "clamped at c = 4, {left} is left: nothing was clamped");
}
