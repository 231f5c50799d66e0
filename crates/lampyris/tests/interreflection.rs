//! Interreflection with exact answers: homogeneous enclosures, the integrating sphere and its zones, energy in a closed
//! room, plates, furnaces; by the fast parts and by the oracle.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::eye::Meter;
use lampyris::light::{Beam, LightKind};
use lampyris::material::Sides;
use std::f32::consts::PI;
use support::{
    Build, FAST, ORACLE, close, close_mean, diffuse, glass, gloss, lux, meter, render, settings, spread,
    view, who,
};

/// The tolerance for means of indirect light.
const MEAN: f64 = 3e-3;
/// The tolerance for the light at one point.
const POINT: f64 = 1e-2;
/// The tolerance in a white furnace.
const FURNACE: f64 = 1e-3;
/// Meters lie this far before a wall [m].
const GAP: f32 = 1e-4;

/// Settings with another clamping radius: a wider one trades the spikes of near virtual lights for short rays.
fn clamped(clamp: f32, s: Settings) -> Settings {
    Settings { clamp, ..s }
}

fn mean(all: &[f64]) -> f64 {
    all.iter().sum::<f64>() / all.len() as f64
}

/// In any closed scene whose walls all reflect ρ and emit Lₑ, the constant L = Lₑ/(1 − ρ) solves the rendering equation:
/// Lₑ = 1 with ρ = 1/2 gives 2, with ρ = 0.8 gives 5. Here a tetrahedron with a block floating in it.
#[test]
fn homogeneous_enclosure() {
    for rho in [0.5, 0.8] {
        let mut b = Build::default();
        let wall = b.material(diffuse(rho), 1.0, Sides::EmitFront);
        let corners = vec![Vec3::ZERO, Vec3::X * 3.0, Vec3::Y * 3.0, Vec3::Z * 3.0];
        b.mesh(corners, vec![[0, 1, 3], [0, 3, 2], [0, 2, 1], [1, 2, 3]], vec![wall; 4]);
        // The fronts of a tetrahedron that is seen from inside; the block's from outside.
        b.0.meshes[0].triangles.iter_mut().for_each(|t| t.swap(1, 2));
        b.block(Vec3::splat(0.4), Vec3::splat(0.7), wall);
        let expected = 1.0 / (1.0 - f64::from(rho));
        for s in [settings(FAST, 1 << 11, 16, 3), settings(ORACLE, 1, 64, 3)] {
            let picture = render(&b.0, view(Vec3::splat(0.2), Vec3::splat(1.0), 90.0, 12, 12), &s, 4);
            let all: Vec<f64> = picture.iter().map(|v| f64::from(v.luminance())).collect();
            close(&format!("rho {rho} by {}", who(&s)), mean(&all), expected, MEAN);
        }
    }
}

/// Meters at centres of a sphere's facets, looking in.
fn on_the_wall(sphere: &Build, count: usize) -> Vec<Meter> {
    let mesh = &sphere.0.meshes[0];
    let facet = |k: usize| {
        let [a, b, c] = mesh.triangles[k * mesh.triangles.len() / count].map(|v| mesh.positions[v as usize]);
        let n = (b - a).cross(c - a).normalize();
        meter((a + b + c) / 3.0 + n * GAP, n)
    };
    (0..count).map(facet).collect()
}

/// In a sphere any two points see each other under the same G = 1/4R², so every reflection spreads evenly:
/// E_ind = Φρ/(4πR²(1 − ρ)) at every point, wherever the source and whatever its web. Φ = 1000 lm, R = 1 m, ρ = 0.8:
/// 318.31 lx. The mesh of 20 480 facets has the sphere's area; it departs from its shape by h²/8 = 0.02 %.
#[test]
fn integrating_sphere_knows_no_place_and_no_web() {
    let mut webs = Vec::new();
    for (position, beam) in [
        (Vec3::new(0.4, 0.2, -0.3), None),
        (Vec3::new(-0.5, 0.1, 0.2), Some(Beam::Cosine { exponent: 4.0 })),
        (Vec3::new(0.0, 0.7, 0.0), Some(Beam::Cone { cos_inner: 0.95, cos_outer: 0.8 })),
    ] {
        let mut b = Build::default();
        let wall = b.grey(0.8);
        b.sphere(Vec3::ZERO, 1.0, 5, true, |_| wall);
        match beam {
            None => b.bulb(position, 1000.0),
            Some(beam) => {
                let intensity = Rgb::grey(1000.0 / beam.solid_angle());
                b.light(LightKind::Spot { position, direction: Vec3::new(0.6, 0.0, 0.8), intensity, beam });
            }
        }
        webs.push(b);
    }
    let indirect = settings(&["vpl", "compensation"], 1 << 13, 16, 4);
    for b in &webs {
        let all = lux(&b.0, &on_the_wall(b, 16), &indirect, 4);
        close("mean", mean(&all), 318.31, MEAN);
        for e in all {
            close("at a point", e, 318.31, POINT);
        }
    }
}

/// Zones of reflectance ρ_i, area A_i and exitance M_i: E = Σ A_i M_i/A ÷ (1 − Σ A_i ρ_i/A) at every point, direct light
/// included, for emitters are part of the wall. Hemispheres of 0.2 and 0.8, M = 100 and 0: E = 50/(1 − 0.5) = 100 lx;
/// they leave B = M + ρE = 120 and 80 lm/m². And one patch alone: E = M A_s/(4πR²(1 − ρ)).
#[test]
fn integrating_sphere_with_zones() {
    let zones = |rho: [f32; 2], exitance: f32, border: f32| {
        let mut b = Build::default();
        let lamp = b.material(diffuse(rho[0]), exitance / PI, Sides::EmitFront);
        let wall = b.grey(rho[1]);
        b.sphere(Vec3::ZERO, 1.0, 5, true, |d| if d.z > border { lamp } else { wall });
        // The border follows the facets: the zone's area is theirs.
        let mesh = &b.0.meshes[0];
        let facets = mesh.triangles.iter().zip(&mesh.materials).filter(|(_, m)| **m == lamp);
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| mesh.positions[v as usize].as_dvec3());
            0.5 * (b - a).cross(c - a).length()
        };
        let share = facets.map(|(t, _)| area(t)).sum::<f64>() / (4.0 * f64::from(PI));
        let [r_1, r_2] = rho.map(f64::from);
        (b, share * f64::from(exitance) / (1.0 - share * r_1 - (1.0 - share) * r_2), share)
    };
    let (b, expected, share) = zones([0.2, 0.8], 100.0, 0.0);
    assert!((share - 0.5).abs() < 0.01 && (expected - 100.0).abs() < 2.0, "{expected} on {share}");
    let meters = on_the_wall(&b, 16);
    for s in [settings(FAST, 1 << 13, 16, 5), settings(ORACLE, 1, 1 << 12, 5)] {
        let all = lux(&b.0, &meters, &s, 4);
        close(&format!("mean by {}", who(&s)), mean(&all), expected, MEAN);
        for e in all {
            close("at a point", e, expected, POINT);
        }
        // B = πL of either zone, seen by a camera in the middle.
        for (way, exitance) in [(Vec3::Z, 100.0 + 0.2 * expected), (Vec3::NEG_Z, 0.8 * expected)] {
            let seen = render(&b.0, view(Vec3::ZERO, way, 60.0, 4, 4), &s, 4);
            let all: Vec<f64> = seen.iter().map(|v| f64::from(v.luminance() * PI)).collect();
            close("B", mean(&all), exitance, MEAN);
        }
    }
    let (b, expected, share) = zones([0.5, 0.5], 1000.0, 0.9);
    close("patch, its own table", 1000.0 * share / 0.5, expected, 1e-9);
    let s = settings(FAST, 1 << 13, 16, 6);
    close("patch", mean(&lux(&b.0, &on_the_wall(&b, 16), &s, 4)), expected, MEAN);
}

/// A cube of 4 m, an isotropic lamp of 10 000 lm in its centre.
fn lit_cube(rho: f32) -> Build {
    let mut b = Build::default();
    let wall = b.grey(rho);
    b.room(Vec3::splat(-2.0), Vec3::splat(2.0), [wall; 6]);
    b.bulb(Vec3::ZERO, 10_000.0);
    b
}

/// Nodes and weights of Gauss's rule with six points on [−1, 1].
const GAUSS: [(f32, f64); 6] = [
    (-0.932_469_5, 0.171_324_492_379),
    (-0.661_209_4, 0.360_761_573_048),
    (-0.238_619_2, 0.467_913_934_573),
    (0.238_619_2, 0.467_913_934_573),
    (0.661_209_4, 0.360_761_573_048),
    (0.932_469_5, 0.171_324_492_379),
];

/// Energy: the mean illuminance of a closed room is E = Φ/(S(1 − ρ)), whatever its shape (CIE 171, case 5.8's room):
/// 104.17, 130.21, 208.33, 520.83, 1041.67, 2083.33 lx. Measured on all six faces at the 36 nodes of Gauss's rule.
#[test]
fn energy_in_a_closed_room() {
    let mut meters = Vec::new();
    let mut weights = Vec::new();
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        let (u, v) = axis.any_orthonormal_pair();
        for normal in [axis, -axis] {
            for (x, wx) in GAUSS {
                for (y, wy) in GAUSS {
                    meters.push(meter((u * x + v * y) * 2.0 - normal * (2.0 - GAP), normal));
                    weights.push(wx * wy / 24.0);
                }
            }
        }
    }
    for (rho, expected) in
        [(0.0, 104.17), (0.2, 130.21), (0.5, 208.33), (0.8, 520.83), (0.9, 1041.67), (0.95, 2083.33)]
    {
        let exact = 10_000.0 / (96.0 * (1.0 - f64::from(rho)));
        close("the table", expected, exact, 1e-4);
        let s = settings(FAST, 1 << 10, 16, 7);
        let all = lux(&lit_cube(rho).0, &meters, &s, 4);
        let mean = all.iter().zip(&weights).map(|(e, w)| e * w).sum();
        close(&format!("mean at rho {rho}"), mean, exact, MEAN);
    }
}

/// The 48 places that a cube's symmetry makes of one point of a face, offset from the face's centre.
fn alike(x: f32, y: f32) -> Vec<Meter> {
    let mut meters = Vec::new();
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        let (u, v) = axis.any_orthonormal_pair();
        for normal in [axis, -axis] {
            for (a, b) in [(x, y), (x, -y), (-x, y), (-x, -y), (y, x), (y, -x), (-y, x), (-y, -x)] {
                meters.push(meter(u * a + v * b - normal * (2.0 - GAP), normal));
            }
        }
    }
    meters
}

/// Illuminance at five points of a face, offsets in metres from its centre: no closed form, but a reference to ±0.01 lx
/// (±0.2 where ρ = 0.8) by an independent path tracer. Clamping without compensation shows first near the corner.
fn points_in_the_closed_room(rho: f32, table: [f64; 5], fast: Settings, draws: u32) {
    let places = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.9, 0.0), (1.9, 1.9)];
    for ((x, y), expected) in places.into_iter().zip(table) {
        for s in [fast.clone(), settings(ORACLE, 1, 1 << 7, 0)] {
            let what = format!("rho {rho} at ({x}, {y}) by {}", who(&s));
            close_mean(&what, draws, expected, POINT, |seed| {
                mean(&lux(&lit_cube(rho).0, &alike(x, y), &Settings { seed, ..s.clone() }, 4))
            });
        }
    }
}

#[test]
fn points_in_the_closed_room_of_a_fifth() {
    let table = [227.82, 170.79, 135.59, 100.65, 59.65];
    points_in_the_closed_room(0.2, table, clamped(4.0, settings(FAST, 1 << 11, 1 << 7, 0)), 8);
}

#[test]
fn points_in_the_closed_room_of_a_half() {
    let table = [310.97, 253.24, 216.06, 177.05, 119.40];
    points_in_the_closed_room(0.5, table, clamped(4.0, settings(FAST, 1 << 11, 1 << 7, 0)), 8);
}

#[test]
#[ignore = "long: a minute"]
fn points_in_the_closed_room_of_four_fifths() {
    let table = [630.1, 571.3, 532.1, 488.5, 402.0];
    points_in_the_closed_room(0.8, table, clamped(2.0, settings(FAST, 1 << 12, 1 << 8, 0)), 64);
}

/// Infinite parallel plates: B₁ = M₁ + ρ₁B₂, B₂ = ρ₂B₁, hence B₁ = M₁/(1 − ρ₁ρ₂). The floor's illuminance is
/// E₁ = B₂ = ρ₂B₁, the ceiling's E₂ = B₁. Plates 200 times as wide as their distance lose 1e-4 at the centre.
#[test]
fn parallel_plates() {
    let (rho_1, rho_2) = (0.6, 0.5);
    let mut b = Build::default();
    let floor = b.material(diffuse(rho_1), 1.0 / PI, Sides::EmitFront);
    let ceiling = b.grey(rho_2);
    let side = 200.0;
    b.quad(Vec3::new(-0.5 * side, 0.0, -0.5 * side), Vec3::Z * side, Vec3::X * side, floor);
    b.quad(Vec3::new(-0.5 * side, 1.0, -0.5 * side), Vec3::X * side, Vec3::Z * side, ceiling);
    let meters = |y: f32, normal: Vec3| -> Vec<Meter> {
        let at = |i| spread(i, 6).map(|u| 60.0 * (u - 0.5));
        (0..256).map(|i| meter(Vec3::new(at(i)[0], y, at(i)[1]), normal)).collect()
    };
    let b_1 = 1.0 / (1.0 - f64::from(rho_1 * rho_2));
    let (ceiling, floor) = (meters(1.0 - GAP, Vec3::NEG_Y), meters(GAP, Vec3::Y));
    for s in [clamped(8.0, settings(FAST, 1 << 12, 512, 0)), settings(ORACLE, 1, 64, 0)] {
        let measure = |meters: &[Meter], seed| mean(&lux(&b.0, meters, &Settings { seed, ..s.clone() }, 1));
        close_mean(&format!("ceiling by {}", who(&s)), 16, b_1, MEAN, |seed| measure(&ceiling, seed));
        let b_2 = f64::from(rho_2) * b_1;
        close_mean(&format!("floor by {}", who(&s)), 16, b_2, MEAN, |seed| measure(&floor, seed));
    }
}

/// Constant surroundings of radiance 1. A convex Lambertian of albedo a shows a; white bodies of any shape show 1 and
/// vanish; so does glass, which absorbs nothing: a block, and a facetted ball, in which some light stays for hundreds of
/// reflections.
#[test]
fn furnace() {
    let surrounded = || Build(lampyris::scene::Scene { environment: Rgb::WHITE, ..Default::default() });
    let see_to = |tolerance: f64, what: &str, b: &Build, expected: f64, all: [Settings; 2]| {
        for s in all {
            close_mean(&format!("{what} by {}", who(&s)), 8, expected, tolerance, |seed| {
                let eye = view(Vec3::new(0.0, 0.5, 4.0), Vec3::ZERO, 15.0, 8, 8);
                let all = render(&b.0, eye, &Settings { seed, ..s.clone() }, 4);
                mean(&all.iter().map(|v| f64::from(v.luminance())).collect::<Vec<_>>())
            });
        }
    };
    let see = |what: &str, b: &Build, expected: f64, all| see_to(FURNACE, what, b, expected, all);
    for albedo in [0.3, 1.0] {
        let mut b = surrounded();
        let body = b.grey(albedo);
        b.sphere(Vec3::ZERO, 1.0, 3, false, |_| body);
        let s = [settings(FAST, 1 << 12, 16, 0), settings(ORACLE, 1, 128, 0)];
        see(&format!("convex, albedo {albedo}"), &b, albedo.into(), s);
    }
    let mut b = surrounded();
    let white = b.grey(1.0);
    b.sphere(Vec3::new(-0.5, 0.0, 0.0), 0.35, 2, false, |_| white);
    b.sphere(Vec3::new(0.5, 0.0, 0.0), 0.35, 2, false, |_| white);
    see("two white bodies", &b, 1.0, [settings(FAST, 1 << 13, 64, 0), settings(ORACLE, 1, 128, 0)]);

    let eyes = [settings(FAST, 4, 256, 0), settings(ORACLE, 1, 256, 0)];
    let mut b = surrounded();
    let clear = b.material(glass(), 0.0, Sides::Both);
    b.block(Vec3::splat(-0.6), Vec3::splat(0.6), clear);
    see("glass block", &b, 1.0, eyes.clone());
    let mut b = surrounded();
    let clear = b.material(glass(), 0.0, Sides::Both);
    b.sphere(Vec3::ZERO, 0.5, 3, false, |_| clear);
    // Rare and long paths at its rim: noisier.
    let eyes = eyes.map(|s| Settings { passes: Some(1600), ..s });
    see_to(2.0 * FURNACE, "facetted glass ball", &b, 1.0, eyes);
}

/// A flat gloss in constant surroundings shows its directional albedo: the table of the bounded Ward lobe (2010) at 0°,
/// 30° and 60°, rounded to 1e-4. α = 0.1 is sharp and reflects the surroundings by the eye path, α = 0.2 is dull and is
/// lit by light points.
#[test]
fn furnace_of_gloss() {
    for (alpha, table) in [(0.1, [0.9900, 0.9883, 0.9740]), (0.2, [0.9600, 0.9526, 0.8976])] {
        let mut b = Build(lampyris::scene::Scene { environment: Rgb::WHITE, ..Default::default() });
        let plate = b.material(gloss(0.0, 1.0, alpha), 0.0, Sides::Both);
        b.quad(Vec3::new(-1.0, 0.0, -1.0), Vec3::Z * 2.0, Vec3::X * 2.0, plate);
        for (degrees, expected) in [0.0, 30.0, 60.0].into_iter().zip(table) {
            let (sin, cos) = libm::sincosf(f32::to_radians(degrees));
            let eye = || view(Vec3::new(3.0 * sin, 3.0 * cos, 0.0), Vec3::ZERO, 1.0, 4, 4);
            for s in [settings(FAST, 1 << 13, 1 << 10, 12), settings(ORACLE, 1, 1 << 12, 12)] {
                let all: Vec<f64> =
                    render(&b.0, eye(), &s, 4).iter().map(|v| f64::from(v.luminance())).collect();
                let what = format!("alpha {alpha} at {degrees} degrees by {}", who(&s));
                close(&what, mean(&all), expected, FURNACE);
            }
        }
    }
}
