//! Direct light against closed forms: lamps, discs, spheres, rectangles, triangles; by the fast parts and by the oracle.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::eye::Meter;
use lampyris::light::{Beam, LightKind};
use lampyris::material::Sides;
use libm::{atan, cos, sqrt};
use std::f64::consts::PI;
use support::{Build, FAST, ORACLE, close, lux, meter, render, settings, view, who};

/// The tolerance for direct light from extended sources.
const DIRECT: f64 = 5e-3;

/// Rounding: sixty-four estimates summed in f32.
const EXACT: f64 = 1e-5;

/// Both renderers; each with so many estimates that their noise is far below the tolerance.
fn both() -> [Settings; 2] {
    [settings(FAST, 1 << 14, 4, 1), settings(ORACLE, 1, 1 << 12, 1)]
}

fn expect(what: &str, build: &Build, at: Meter, expected: f64) {
    for s in both() {
        let measured = lux(&build.0, &[at], &s, 4)[0];
        close(&format!("{what} by {}", who(&s)), measured, expected, DIRECT);
    }
}

/// Lamps without size have no noise: a few estimates are as good as many.
fn expect_exactly(what: &str, build: &Build, at: Meter, expected: f64) {
    for s in [settings(FAST, 16, 4, 1), settings(ORACLE, 1, 16, 1)] {
        let measured = lux(&build.0, &[at], &s, 4)[0];
        close(&format!("{what} by {}", who(&s)), measured, expected, EXACT);
    }
}

/// E(r) = Φ/4π · h/(h² + r²)^{3/2}: 88.42, 75.49, 50.93, 31.26, 19.10, 12.04 lx.
#[test]
fn isotropic_point_over_a_floor() {
    let mut b = Build::default();
    b.bulb(Vec3::Y * 3.0, 10_000.0);
    let table = [88.42, 75.49, 50.93, 31.26, 19.10, 12.04];
    for (r, listed) in table.into_iter().enumerate() {
        let d2 = 9.0 + (r * r) as f64;
        let expected = 10_000.0 / (4.0 * PI) * 3.0 / (d2 * sqrt(d2));
        close("the table", listed, expected, 5e-4);
        expect_exactly("point", &b, meter(Vec3::X * r as f32, Vec3::Y), expected);
    }
}

/// E = I cos θ/d² and E = E₀ cos θ: 100 cd at 2 m give 25 lx; 500 lx of parallel light, 500 cos θ.
#[test]
fn point_and_parallel_light() {
    let mut b = Build::default();
    b.light(LightKind::Point { position: Vec3::Y * 2.0, intensity: Rgb::grey(100.0) });
    expect_exactly("100 cd", &b, meter(Vec3::ZERO, Vec3::Y), 25.0);
    let tilted = Vec3::new(0.6, 0.8, 0.0);
    expect_exactly("100 cd tilted", &b, meter(Vec3::ZERO, tilted), 20.0);

    let mut b = Build::default();
    let floor = b.grey(0.0);
    b.quad(Vec3::new(-1.0, -1.0, -1.0), Vec3::Z * 2.0, Vec3::X * 2.0, floor);
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::grey(500.0) });
    for degrees in [0.0, 30.0, 60.0, 85.0] {
        let t = f64::to_radians(degrees);
        let normal = Vec3::new(libm::sin(t) as f32, cos(t) as f32, 0.0);
        expect_exactly("500 lx", &b, meter(Vec3::ZERO, normal), 500.0 * cos(t));
    }
}

/// A spot's intensity on and off its axis: I(θ) cos/d² with glTF's squared ramp, and with cosᵈ.
#[test]
fn spot_off_its_axis() {
    let spot = |beam| {
        let mut b = Build::default();
        let (position, direction) = (Vec3::Y * 2.0, Vec3::NEG_Y);
        b.light(LightKind::Spot { position, direction, intensity: Rgb::grey(100.0), beam });
        b
    };
    let cone = spot(Beam::Cone { cos_inner: 0.9, cos_outer: 0.6 });
    let power = spot(Beam::Cosine { exponent: 3.0 });
    for r in [0.0, 0.5, 1.0, 1.5, 2.0] {
        let d2 = 4.0 + r * r;
        let c = 2.0 / sqrt(d2);
        let ramp = ((c - 0.6) / 0.3).clamp(0.0, 1.0);
        let at = meter(Vec3::X * r as f32, Vec3::Y);
        expect_exactly("cone", &cone, at, 100.0 * ramp * ramp * c / d2);
        expect_exactly("cosine", &power, at, 100.0 * c * c * c * c / d2);
    }
}

/// Below the centre of a Lambertian disc, E = πL a²/(a² + h²); for a = h, πL/2. As a lamp and as a mesh.
#[test]
fn disc_below_its_centre() {
    for h in [0.2, 1.0, 5.0] {
        let expected = PI / (1.0 + h * h);
        let center = Vec3::Y * h as f32;
        let mut lamp = Build::default();
        let radiance = Rgb::WHITE;
        lamp.light(LightKind::Disc { center, normal: Vec3::NEG_Y, radius: 1.0, radiance });
        expect("lamp", &lamp, meter(Vec3::ZERO, Vec3::Y), expected);
        let mut mesh = Build::default();
        let glow = mesh.glow(1.0);
        mesh.disc(center, Vec3::NEG_Y, 1.0, glow);
        expect("mesh", &mesh, meter(Vec3::ZERO, Vec3::Y), expected);
    }
}

/// A sphere wholly above the horizon: E = πL (r/d)² cos θ at any distance. The bulb of 1600 lm and 3.81 cm radius has
/// L = Φ/(4π²r²) = 27 920 cd/m² and gives 31.83 lx at 2 m.
#[test]
fn sphere_at_any_distance() {
    let sphere = |center, radius: f32, radiance| {
        let mut b = Build::default();
        b.light(LightKind::Sphere { center, radius, radiance: Rgb::grey(radiance) });
        b
    };
    let bulb = 1600.0 / (4.0 * PI * PI * 0.0381 * 0.0381);
    close("L", 27_920.0, bulb, 1e-4);
    let at = meter(Vec3::ZERO, Vec3::Y);
    expect("bulb", &sphere(Vec3::Y * 2.0, 0.0381, bulb as f32), at, 31.83);
    for (r, d, degrees) in [(1.0, 1.1, 0.0), (1.0, 2.0, 45.0), (1.0, 3.0, 60.0), (0.01, 4.0, 80.0)] {
        let t = f64::to_radians(degrees);
        let center = Vec3::new((d * libm::sin(t)) as f32, (d * cos(t)) as f32, 0.0);
        expect("sphere", &sphere(center, r as f32, 1.0), at, PI * r * r / (d * d) * cos(t));
    }
}

/// Under the corner of a parallel rectangle X = a/h, Y = b/h,
/// E = L/2 [X/√(1+X²) atan(Y/√(1+X²)) + Y/√(1+Y²) atan(X/√(1+Y²))]: 0.435210 L for X = Y = 1; below the centre of the
/// unit square at unit height four such quarters, 0.752275 L.
#[test]
fn rectangle_overhead() {
    let formula = |x: f64, y: f64| {
        let (u, v) = (sqrt(1.0 + x * x), sqrt(1.0 + y * y));
        0.5 * (x / u * atan(y / u) + y / v * atan(x / v))
    };
    close("table", 0.435_210, formula(1.0, 1.0), 2e-6);
    close("table", 0.752_275, 4.0 * formula(0.5, 0.5), 2e-6);
    let mut b = Build::default();
    let glow = b.glow(1.0);
    // Looks down: x × z = −y.
    b.quad(Vec3::new(0.0, 1.0, 0.0), Vec3::X, Vec3::Z, glow);
    expect("corner", &b, meter(Vec3::ZERO, Vec3::Y), formula(1.0, 1.0));
    expect("centre", &b, meter(Vec3::new(0.5, 0.0, 0.5), Vec3::Y), 0.752_275);
    let near = meter(Vec3::new(0.5, 0.9, 0.5), Vec3::Y);
    expect("near", &b, near, 4.0 * formula(5.0, 5.0));
}

/// The same rectangle upright, the receiver in the plane of its lower edge at distance c from a corner:
/// E = L/2 [atan(1/Y) − Y/√(X²+Y²) atan(1/√(X²+Y²))], X = a/b, Y = c/b: 0.175094 L for X = Y = 1.
#[test]
fn rectangle_upright() {
    let formula = |x: f64, y: f64| {
        let s = sqrt(x * x + y * y);
        0.5 * (atan(1.0 / y) - y / s * atan(1.0 / s))
    };
    close("table", 0.175_094, formula(1.0, 1.0), 2e-6);
    for (a, c) in [(1.0, 1.0), (2.0, 0.5), (1.0, 0.1)] {
        let mut b = Build::default();
        let glow = b.glow(1.0);
        // Faces −x: its front is y × z turned, z × y = −x.
        b.quad(Vec3::X * c as f32, Vec3::Z, Vec3::Y * a as f32, glow);
        expect("upright", &b, meter(Vec3::ZERO, Vec3::Y), formula(a, c));
    }
}

/// Five triangles over a floor of ρ = 1/2, L = 1: the radiance reflected at the origin is ρ/π · E, with Lambert's
/// (1760) E = L/2 |Σ Θ_k Γ_k·n| over the edges; the numbers are the published ones. Seen by a camera.
#[test]
fn five_triangles_over_a_floor() {
    let triangles = [
        (
            [
                [-0.443432, 0.596366, 0.495985],
                [-0.320397, 0.0677699, -0.229359],
                [0.0341197, 0.11415, -0.343049],
            ],
            0.0898394,
        ),
        (
            [
                [0.461963, 0.397843, 0.412747],
                [-0.0381582, 0.851323, -0.156872],
                [0.195443, 0.891957, -0.260672],
            ],
            0.02292,
        ),
        (
            [
                [0.100871, 0.289075, -0.422609],
                [-0.308386, 0.629587, 0.423966],
                [-0.373132, 0.237287, 0.351592],
            ],
            0.0534198,
        ),
        (
            [[-0.17575, 0.639397, 0.151268], [0.318604, 0.732996, 0.459771], [0.139095, 0.294498, 0.478556]],
            0.0205314,
        ),
        (
            [
                [-0.17487, 0.447916, 0.367201],
                [-0.405259, 0.249607, -0.354079],
                [0.356029, 0.0918984, -0.132271],
            ],
            0.26174,
        ),
    ];
    for (corners, expected) in triangles {
        let corners = corners.map(|c: [f32; 3]| Vec3::from(c));
        let lambert: f64 = (0..3)
            .map(|k| {
                let (a, b) = (corners[k].as_dvec3().normalize(), corners[(k + 1) % 3].as_dvec3().normalize());
                libm::acos(a.dot(b)) * a.cross(b).normalize().y
            })
            .sum();
        close("Lambert's formula", 0.5 * lambert.abs() * 0.5 / PI, expected, 1e-5);

        let mut b = Build::default();
        let floor = b.grey(0.5);
        b.quad(Vec3::new(-9.0, 0.0, -9.0), Vec3::Z * 18.0, Vec3::X * 18.0, floor);
        let glow = b.material(support::diffuse(0.0), 1.0, Sides::Both);
        b.mesh(corners.to_vec(), vec![[0, 1, 2]], vec![glow]);
        // From low down, below every triangle; the pixel's trace on the floor is 3 mm long.
        let eye = || view(Vec3::new(0.0, 0.05, -3.0), Vec3::ZERO, 0.001, 1, 1);
        for s in both() {
            let measured = f64::from(render(&b.0, eye(), &s, 4)[0].luminance());
            close(&format!("reflected, {}", who(&s)), measured, expected, DIRECT);
        }
    }
}
