//! Every map of `sampling` follows the density that it states, by χ².

use glam::Vec3;
use lampyris::sampling::*;
use lampyris::sequence::uniform;
use lampyris::testing::{SphereBins, chi_square_test, sidak};
use std::f32::consts::{FRAC_1_PI, TAU};

const SAMPLES: u32 = 200_000;
const TESTS: usize = 11;

fn u(i: u32) -> [f32; 2] {
    [uniform(1, i, 0), uniform(1, i, 1)]
}

fn assert_follows(name: &str, bins: SphereBins, map: impl Fn([f32; 2]) -> Vec3, pdf: impl Fn(Vec3) -> f32) {
    let p = bins.test(SAMPLES, |i| Some(map(u(i))), pdf);
    assert!(p > sidak(0.01, TESTS), "{name}: p = {p}");
    for k in 0..16 {
        let edge = [0.0, 1e-7, 0.5, 1.0f32.next_down()];
        let w = map([edge[k % 4], edge[k / 4]]);
        assert!((w.length() - 1.0).abs() < 1e-5, "{name}: {w} is no unit vector");
    }
}

#[test]
fn directions_follow_their_densities() {
    let even = SphereBins::EVEN;
    assert_follows("cosine", even, cosine_hemisphere, |w| w.z.max(0.0) * FRAC_1_PI);
    assert_follows("sphere", even, uniform_sphere, |_| 0.5 / TAU);
    // 0.25 and 0.9375 are edges of bins, so that the quadrature sees no jump.
    for cos_max in [0.25, 0.9375] {
        let pdf = |w: Vec3| if w.z >= cos_max { 1.0 / (TAU * (1.0 - cos_max)) } else { 0.0 };
        let finer = SphereBins { rings: 64, ..even };
        assert_follows("cone", finer, |u| uniform_cone(u, cos_max), pdf);
    }
    for d in [0.0, 1.0, 2.5, 20.0, 300.0] {
        let bins = SphereBins { power: 2, ..even };
        assert_follows("cosᵈ", bins, |u| cosine_power(u, d), |w| cosine_power_pdf(w.z, d));
    }
}

/// χ² of points in a grid over [−1, 1]², the expected share of each cell by counting a fine lattice.
fn plane_p_value(map: impl Fn([f32; 2]) -> [f32; 2], inside: impl Fn(f64, f64) -> bool) -> f64 {
    const CELLS: usize = 12;
    let cell = |x: f64| ((x + 1.0) * 0.5 * CELLS as f64).clamp(0.0, CELLS as f64 - 1.0) as usize;
    let mut observed = vec![0.0; CELLS * CELLS];
    for i in 0..SAMPLES {
        let [x, y] = map(u(i)).map(f64::from);
        observed[cell(x) * CELLS + cell(y)] += 1.0;
    }
    let mut expected = vec![0.0; CELLS * CELLS];
    let fine = 6000;
    let at = |k: usize| (2 * k + 1) as f64 / fine as f64 - 1.0;
    let mut total = 0.0;
    for (x, y) in (0..fine * fine).map(|k| (at(k / fine), at(k % fine))).filter(|&(x, y)| inside(x, y)) {
        expected[cell(x) * CELLS + cell(y)] += 1.0;
        total += 1.0;
    }
    expected.iter_mut().for_each(|e| *e *= f64::from(SAMPLES) / total);
    chi_square_test(&observed, &expected, 0)
}

#[test]
fn areas_are_preserved() {
    let disc = plane_p_value(concentric_disc, |x, y| x * x + y * y <= 1.0);
    let corner = plane_p_value(triangle, |x, y| x >= 0.0 && y >= 0.0 && x + y <= 1.0);
    assert!(disc > sidak(0.01, TESTS), "disc: p = {disc}");
    assert!(corner > sidak(0.01, TESTS), "triangle: p = {corner}");
}
