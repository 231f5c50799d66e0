//! Batches that are frames to look at, without the filter: right in the mean, and their error falls with the number of
//! light paths as it must.
//!
//! Paths are added batch by batch. More of them in one batch do less: the bound of the geometry term grows with them
//! (docs/light-transport.md, "Clamping"), so that what lies in corners varies as before.

mod support;

use glam::Vec3;
use lampyris::backend::Settings;
use lampyris::eye::Eye;
use lampyris::scene::Scene;
use lampyris::testing::Moments;
use support::{Build, FAST, ORACLE, render, say, settings, view};

/// A closed room with a panel under the ceiling and a block, nothing sharp.
fn room() -> (Scene, Eye) {
    let mut b = Build::default();
    let (light, dark) = (b.grey(0.7), b.grey(0.4));
    let glow = b.glow(10.0);
    b.room(Vec3::ZERO, Vec3::new(3.0, 2.5, 3.0), [dark, light, light, light, light, light]);
    b.block(Vec3::new(1.7, 0.0, 1.5), Vec3::new(2.4, 1.1, 2.2), light);
    b.quad(Vec3::new(1.0, 2.45, 1.0), Vec3::X, Vec3::Z, glow);
    (b.0, view(Vec3::new(0.3, 1.3, 0.3), Vec3::new(2.0, 0.8, 2.2), 60.0, 64, 48))
}

fn luminances(scene: &Scene, eye: &Eye, settings: &Settings, batches: u32) -> Vec<f64> {
    render(scene, eye.clone(), settings, batches).iter().map(|c| f64::from(c.luminance())).collect()
}

fn mean(picture: &[f64]) -> f64 {
    picture.iter().sum::<f64>() / picture.len() as f64
}

/// Mean squared relative error.
fn error(picture: &[f64], truth: &[f64]) -> f64 {
    let square = |(x, r): (&f64, &f64)| (x / r - 1.0).powi(2);
    picture.iter().zip(truth).map(square).sum::<f64>() / truth.len() as f64
}

fn batch(paths: u32, seed: u32) -> Settings {
    Settings { paths, seed, filter: false, ..Settings::interactive() }
}

/// p of a fit of error ~ N⁻ᵖ by least squares of logarithms.
fn exponent(errors: &[(u32, f64)]) -> f64 {
    let points: Vec<(f64, f64)> =
        errors.iter().map(|(n, e)| (libm::log(f64::from(*n)), libm::log(*e))).collect();
    let n = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let along = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>();
    -along / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

#[test]
#[ignore = "long: half a minute"]
fn the_error_falls_at_least_as_one_over_the_paths() {
    const DRAWS: u32 = 24;
    let (scene, eye) = room();
    let truth = luminances(&scene, &eye, &settings(FAST, 1024, 16, 1000), 8);
    for paths in [16, 64] {
        let after = |batches: u32| {
            let draw = |seed| error(&luminances(&scene, &eye, &batch(paths, seed), batches), &truth);
            let all: Moments = (0..DRAWS).map(draw).collect();
            say(format_args!("{} paths: {:.4} ± {:.4}", paths * batches, all.mean(), all.standard_error()));
            (paths * batches, all.mean())
        };
        let errors: Vec<(u32, f64)> =
            [1, 4, 16, 64].into_iter().filter(|n| paths * n <= 1024).map(after).collect();
        let p = exponent(&errors);
        say(format_args!("batches of {paths} paths: error falls as N to the {:.3}", -p));
        assert!(p >= 1.0, "batches of {paths} paths: {errors:?}");
    }
}

#[test]
#[ignore = "long: a minute"]
fn their_mean_is_that_of_paths() {
    let (scene, eye) = room();
    let draws = |count: u32, settings: &dyn Fn(u32) -> Settings, batches: u32| -> Moments {
        (0..count).map(|seed| mean(&luminances(&scene, &eye, &settings(seed), batches))).collect()
    };
    let truth = draws(8, &|seed| settings(ORACLE, 1, 64, seed), 4);
    let noise = |m: &Moments| m.standard_error() / m.mean();
    for (paths, batches) in [(16, 400), (1024, 60)] {
        let means = draws(16, &|seed| batch(paths, 100 + seed), batches);
        let off = means.mean() / truth.mean() - 1.0;
        let noise = libm::hypot(noise(&means), noise(&truth));
        say(format_args!("batches of {paths} paths: off by {off:+.1e} ± {noise:.1e}"));
        assert!(off.abs() <= 2e-3 && 3.0 * noise <= 2e-3, "{paths} paths: {off:.1e} ± {noise:.1e}");
    }
}
