//! Form factors between finite patches, Howell's catalogue: one patch emits M = 1 lm/m² (L = 1/π), the mean
//! illuminance of the other is F₂₁ = F₁₂ A₁/A₂.

mod support;

use glam::Vec3;
use lampyris::eye::Meter;
use libm::{atan, log, pow, sqrt};
use std::f64::consts::PI;
use support::{Build, FAST, ORACLE, close, lux, meter, settings, spread, who};

/// Points on the receiving patch.
const METERS: u32 = 512;

/// The tolerance for direct light.
const TOLERANCE: f64 = 5e-3;

fn expect(what: &str, emitter: &Build, meters: &[Meter], expected: f64) {
    for s in [settings(FAST, 1 << 11, 4, 2), settings(ORACLE, 1, 128, 2)] {
        let all = lux(&emitter.0, meters, &s, 4);
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        close(&format!("{what} by {}", who(&s)), mean, expected, TOLERANCE);
    }
}

/// An emitter of unit exitance: the parallelogram at `corner`.
fn patch(corner: Vec3, a: Vec3, b: Vec3) -> Build {
    let mut build = Build::default();
    let glow = build.glow(std::f32::consts::FRAC_1_PI);
    build.quad(corner, a, b, glow);
    build
}

/// Meters on the floor rectangle [0, a] × [0, b] in x and z.
fn floor(a: f32, b: f32) -> Vec<Meter> {
    let at = |i| spread(i, 5);
    (0..METERS).map(|i| meter(Vec3::new(a * at(i)[0], 0.0, b * at(i)[1]), Vec3::Y)).collect()
}

/// F between parallel a × b rectangles at distance c, X = a/c, Y = b/c.
fn parallel(x: f64, y: f64) -> f64 {
    let (u, v) = (sqrt(1.0 + x * x), sqrt(1.0 + y * y));
    let ends = log(u * v / sqrt(1.0 + x * x + y * y));
    let sides = x * v * atan(x / v) + y * u * atan(y / u) - x * atan(x) - y * atan(y);
    2.0 / (PI * x * y) * (ends + sides)
}

/// F from the rectangle of depth y to the one of height z that meets it at a right angle in an edge of length x;
/// H = z/x, W = y/x.
fn perpendicular(h: f64, w: f64) -> f64 {
    let (h2, w2) = (h * h, w * w);
    let s = sqrt(h2 + w2);
    let angles = w * atan(1.0 / w) + h * atan(1.0 / h) - s * atan(1.0 / s);
    let product = (1.0 + w2) * (1.0 + h2) / (1.0 + w2 + h2)
        * pow(w2 * (1.0 + w2 + h2) / ((1.0 + w2) * (w2 + h2)), w2)
        * pow(h2 * (1.0 + h2 + w2) / ((1.0 + h2) * (h2 + w2)), h2);
    (angles + 0.25 * log(product)) / (PI * w)
}

/// F from the disc of radius R1 to a coaxial one of R2 at unit distance.
fn discs(r1: f64, r2: f64) -> f64 {
    let x = 1.0 + (1.0 + r2 * r2) / (r1 * r1);
    0.5 * (x - sqrt(x * x - 4.0 * (r2 / r1) * (r2 / r1)))
}

/// The formulas here, against the published numbers; and a closed box: the six factors of a unit cube sum to 1.
#[test]
fn formulas_give_the_published_numbers() {
    for (formula, published) in [
        (parallel(1.0, 1.0), 0.199_825),
        (parallel(2.0, 2.0), 0.415_253),
        (parallel(0.5, 0.5), 0.068_590),
        (perpendicular(1.0, 1.0), 0.200_044),
        (perpendicular(2.0, 1.0), 0.232_853),
        (discs(1.0, 1.0), 0.381_966),
        (discs(0.5, 1.0), 0.468_871),
    ] {
        assert!((formula - published).abs() < 1e-6, "{formula} for {published}");
    }
    assert!((parallel(1.0, 1.0) + 4.0 * perpendicular(1.0, 1.0) - 1.0).abs() < 1e-12);
}

#[test]
fn parallel_squares() {
    for (side, factor) in [(1.0, 0.199_825), (2.0, 0.415_253), (0.5, 0.068_590)] {
        let emitter = patch(Vec3::Y, Vec3::X * side, Vec3::Z * side);
        expect("parallel", &emitter, &floor(side, side), factor);
    }
}

/// The emitter stands on the edge x = 0 of the floor patch. With H = 2 it is the taller one: W = 1 for the floor.
#[test]
fn squares_that_share_an_edge() {
    for (height, factor) in [(1.0, 0.200_044), (2.0, 0.232_853)] {
        let emitter = patch(Vec3::ZERO, Vec3::Y * height, Vec3::Z);
        // F from the floor to the wall, times their areas, is the flux between them either way.
        expect("perpendicular", &emitter, &floor(1.0, 1.0), factor);
    }
}

#[test]
fn coaxial_discs() {
    for (r1, r2, factor) in [(1.0, 1.0, 0.381_966), (0.5, 1.0, 0.468_871)] {
        let mut emitter = Build::default();
        let glow = emitter.glow(std::f32::consts::FRAC_1_PI);
        emitter.disc(Vec3::Y, Vec3::NEG_Y, r2, glow);
        let meters: Vec<Meter> = (0..METERS)
            .map(|i| {
                let [x, z] = lampyris::sampling::concentric_disc(spread(i, 5));
                meter(Vec3::new(x, 0.0, z) * r1, Vec3::Y)
            })
            .collect();
        // The receiver is disc 1: E₁ = F₁₂ M.
        expect("discs", &emitter, &meters, factor);
    }
}
