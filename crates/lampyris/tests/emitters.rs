//! Every kind of light agrees with itself: what it sends (`emit`, `power`), what points of it give (`point`), what
//! next-event estimation draws (`toward`) and at which density (`pdf`), and what rays meet (`met_by`).

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::light::{Beam, Bounds, EmissiveSide, Emitter, GlowingTriangle, LightKind, Shine};
use lampyris::testing::{SphereBins, sidak};
use libm::sqrt;
use std::f64::consts::PI;
use support::{close, say, spread};

const BOUNDS: Bounds = Bounds { center: Vec3::ZERO, radius: 2.0 };

/// Radius of the sphere on which light is measured; every lamp lies well within.
const FAR: f32 = 2.0;

fn side() -> Emitter {
    let corners = [Vec3::new(-0.4, 0.1, -0.3), Vec3::new(0.5, 0.0, -0.2), Vec3::new(0.1, 0.2, 0.6)];
    let tip = Vec3::new(0.3, 0.7, 0.1);
    let triangle = |a: Vec3, b: Vec3, c: Vec3| GlowingTriangle {
        vertices: [a, b, c],
        normal: (b - a).cross(c - a).normalize(),
    };
    // Two triangles back to back over an edge: a roof, which does not shade itself outward.
    let [a, b, c] = corners;
    let all = vec![triangle(a, tip, b), triangle(b, tip, c)];
    Emitter::Side(EmissiveSide::new(Rgb::WHITE, all).expect("area"))
}

/// Lamps at finite places, with the name of each.
fn lamps() -> Vec<(&'static str, Emitter)> {
    let at = Vec3::new(0.2, -0.1, 0.15);
    let axis = Vec3::new(0.36, 0.48, 0.8);
    let spot =
        |beam| Emitter::Lamp(LightKind::Spot { position: at, direction: axis, intensity: Rgb::WHITE, beam });
    vec![
        ("point", Emitter::Lamp(LightKind::Point { position: at, intensity: Rgb::WHITE })),
        ("cone", spot(Beam::Cone { cos_inner: 0.8, cos_outer: 0.3 })),
        ("wide cone", spot(Beam::Cone { cos_inner: 0.2, cos_outer: -0.6 })),
        ("cosine", spot(Beam::Cosine { exponent: 1.0 })),
        ("narrow cosine", spot(Beam::Cosine { exponent: 20.0 })),
        ("sphere", Emitter::Lamp(LightKind::Sphere { center: at, radius: 0.5, radiance: Rgb::WHITE })),
        (
            "disc",
            Emitter::Lamp(LightKind::Disc { center: at, normal: axis, radius: 0.5, radiance: Rgb::WHITE }),
        ),
        ("side", side()),
    ]
}

/// Illuminance at x toward the inside of the sphere, by the points of a light: Σ I·shine·cos/d² over `n` points.
fn lux_by_points(e: &Emitter, x: Vec3, n: u32) -> f64 {
    let normal = -x.normalize();
    let one = |i| {
        let p = e.point(spread(i, 3));
        let d = p.position - x;
        let d2 = d.length_squared();
        let wi = d / d2.sqrt();
        let law = match p.shine {
            Shine::Lambert(n) => (-n.dot(wi)).max(0.0),
            Shine::Isotropic => 1.0,
            Shine::Beam(axis, beam) => beam.profile(-axis.dot(wi)),
            Shine::Distant => unreachable!("lamps at finite places"),
        };
        f64::from(p.intensity.luminance() * law * normal.dot(wi).max(0.0) / d2)
    };
    (0..n).map(one).sum::<f64>() / f64::from(n)
}

/// The same by next-event estimation: Σ weight·cos.
fn lux_by_toward(e: &Emitter, x: Vec3, n: u32) -> f64 {
    let normal = -x.normalize();
    let one = |i| {
        e.toward(x, spread(i, 4)).map_or(0.0, |a| f64::from(a.weight.luminance() * normal.dot(a.wi).max(0.0)))
    };
    (0..n).map(one).sum::<f64>() / f64::from(n)
}

fn points_needed(e: &Emitter) -> u32 {
    if e.area() > 0.0 { 256 } else { 1 }
}

/// Closed forms: Φ = 4πI; I ∫ profile dω, for cosᵈ 2πI/(d + 1); πLA for surfaces; and the integral of the profile by
/// quadrature. A spot cosine web: πI₀, isotropic 1 cd: 12.566 lm.
#[test]
fn powers() {
    for (name, e) in lamps() {
        let expected = match &e {
            Emitter::Lamp(LightKind::Point { .. }) => 4.0 * PI,
            Emitter::Lamp(LightKind::Spot { direction, beam, .. }) => {
                let bins = SphereBins { axis: *direction, ..SphereBins::EVEN };
                bins.integral(|w| f64::from(beam.profile(direction.dot(w))))
            }
            _ => PI * f64::from(e.area()),
        };
        close(name, e.power(BOUNDS).luminance().into(), expected, 1e-4);
    }
    let web = |exponent: f32| f64::from(Beam::Cosine { exponent }.solid_angle());
    close("cosine web", web(1.0), PI, 1e-6);
    for n in [2.0f32, 10.0, 50.0] {
        close("cosine power", web(n), 2.0 * PI / f64::from(n + 1.0), 1e-6);
    }
    close("sphere", lamps()[5].1.area().into(), 4.0 * PI * 0.25, 1e-6);
    close("disc", lamps()[6].1.area().into(), PI * 0.25, 1e-6);
}

/// All that a lamp sends arrives on a sphere around it: ∫ E dA = Φ, by its points and by next-event estimation.
#[test]
fn what_is_sent_arrives() {
    for (name, e) in lamps() {
        let n = points_needed(&e).min(64);
        let bins = SphereBins { rings: 8, sectors: 12, ..SphereBins::EVEN };
        for (how, lux) in
            [("points", lux_by_points as fn(&Emitter, Vec3, u32) -> f64), ("toward", lux_by_toward)]
        {
            let arrived = bins.integral(|w| lux(&e, w * FAR, n)) * f64::from(FAR * FAR);
            close(&format!("{name} by {how}"), arrived, e.power(BOUNDS).luminance().into(), 3e-3);
        }
    }
}

/// Particles land on a sphere around the lamp with density E/Φ: χ² of 100 000 of them against the illuminance that the
/// lamp's points give, at 1 % in all. A particle that carried anything but Φ/N, or another law, would show.
#[test]
fn particles_land_where_the_light_is() {
    let all = lamps();
    let level = sidak(0.01, all.len());
    for (name, e) in all {
        let flux = f64::from(e.power(BOUNDS).luminance());
        let n = points_needed(&e);
        let pdf = |w: Vec3| (lux_by_points(&e, w * FAR, n) * f64::from(FAR * FAR) / flux) as f32;
        let bins = SphereBins { rings: 5, sectors: 8, ..SphereBins::EVEN };
        let p = bins.test(
            100_000,
            |i| {
                let u = [0, 1, 2, 3].map(|d| lampyris::sequence::uniform(77, i, d));
                let start = e.emit(u, BOUNDS);
                // Where the ray leaves the sphere.
                let b = start.origin.dot(start.direction);
                let t = (b * b + FAR * FAR - start.origin.length_squared()).sqrt() - b;
                Some((start.origin + start.direction * t).normalize())
            },
            pdf,
        );
        say(format_args!("{name}: p = {p:.3}"));
        assert!(p > level, "{name}: p = {p}");
    }
}

/// Emission directions alone: cone and cosᵈ against their profile, χ².
#[test]
fn beams_follow_their_profile() {
    let beams = [
        Beam::Cone { cos_inner: 0.9, cos_outer: 0.5 },
        Beam::Cone { cos_inner: 0.999, cos_outer: 0.99 },
        Beam::Cone { cos_inner: 1.0, cos_outer: -1.0 },
        Beam::Cosine { exponent: 0.0 },
        Beam::Cosine { exponent: 1.0 },
        Beam::Cosine { exponent: 7.5 },
        Beam::Cosine { exponent: 200.0 },
    ];
    for beam in beams {
        let u = |i| [0, 1].map(|d| lampyris::sequence::uniform(5, i, d));
        // Finer at the pole, where narrow beams are.
        let bins = SphereBins { rings: 24, sectors: 12, power: 4, axis: Vec3::Z };
        let p = bins.test(200_000, |i| Some(beam.sample(u(i))), |w| beam.profile(w.z) / beam.solid_angle());
        say(format_args!("{beam:?}: p = {p:.3}"));
        assert!(p > sidak(0.01, beams.len()), "{beam:?}: p = {p}");
    }
}

/// `toward` says the density that `pdf` says; radiance × 1/density is its weight; the shadow ray ends on the light.
#[test]
fn densities_agree() {
    let radiance = 1.0;
    for (name, e) in lamps().into_iter().filter(|(_, e)| e.area() > 0.0) {
        for k in 0..200 {
            let [u, v] = spread(k, 8);
            let x = lampyris::sampling::uniform_sphere([u, v]) * (0.9 + u);
            for i in 0..16 {
                let Some(a) = e.toward(x, spread(i, k)) else { continue };
                assert!((a.wi.length() - 1.0).abs() < 1e-5);
                close(name, f64::from(a.weight.luminance() * a.pdf), radiance, 1e-5);
                let end = a.end.expect("near");
                let distance = (end - x).length();
                // The cosine at the light, from its shape.
                let cosine = match &e {
                    Emitter::Lamp(LightKind::Sphere { .. }) => 1.0,
                    Emitter::Lamp(LightKind::Disc { normal, .. }) => -normal.dot(a.wi),
                    _ => {
                        let Shine::Lambert(n) = e.point(spread(i, k)).shine else {
                            unreachable!("a surface")
                        };
                        -n.dot(a.wi)
                    }
                };
                close(name, e.pdf(x, distance, cosine).into(), a.pdf.into(), 2e-4);
                if matches!(e, Emitter::Lamp(_)) {
                    let met = e.met_by(x, a.wi, f32::INFINITY);
                    // A direction at the very rim may round past it.
                    if let Some((t, glow, _)) = met {
                        close(name, t.into(), distance.into(), 2e-3);
                        assert_eq!(glow, Rgb::WHITE);
                    }
                }
            }
        }
    }
}

/// ∫ pdf dω over the directions in which rays meet the lamp is 1, and ∫ L cos dω the illuminance of `toward`.
#[test]
fn densities_integrate_to_one() {
    let x = Vec3::new(-1.2, 0.8, 1.0);
    for (name, e) in lamps() {
        let (Emitter::Lamp(LightKind::Sphere { center, .. }) | Emitter::Lamp(LightKind::Disc { center, .. })) =
            e
        else {
            continue;
        };
        let (e, axis) = (&e, (center - x).normalize());
        let bins = SphereBins { rings: 24, sectors: 32, power: 2, axis };
        let over = |f: &dyn Fn(f32, Rgb, f32, Vec3) -> f64| {
            bins.integral(|w| e.met_by(x, w, f32::INFINITY).map_or(0.0, |(t, l, c)| f(t, l, c, w)))
        };
        close(name, over(&|t, _, c, _| f64::from(e.pdf(x, t, c))), 1.0, 3e-3);
        let normal = -x.normalize();
        let lux = over(&|_, l, _, w| f64::from(l.luminance() * normal.dot(w).max(0.0)));
        close(name, lux, lux_by_toward(e, x, 1 << 12), 3e-3);
    }
}

/// Parallel light and the environment set out from a disc as wide as the scene: Φ = E πR², and L π·4π·R²/4·4 = 4π²R² L.
/// Through any plane within the sphere passes E cos θ, or πL: particles counted through a small window.
#[test]
fn distant_light() {
    let travel = Vec3::new(0.6, -0.8, 0.0);
    let sun = Emitter::Lamp(LightKind::Directional { direction: travel, illuminance: Rgb::grey(500.0) });
    let sky = Emitter::Environment { radiance: Rgb::grey(3.0) };
    let disc = PI * 4.0;
    close("sun", sun.power(BOUNDS).luminance().into(), 500.0 * disc, 1e-6);
    close("sky", sky.power(BOUNDS).luminance().into(), 3.0 * 4.0 * PI * disc, 1e-6);
    // Lux on the upper side of a horizontal window of 1 m² off the centre.
    let window = |e: &Emitter| {
        const N: u32 = 1 << 20;
        let through = |i: u32| {
            let s = e.emit([0, 1, 2, 3].map(|d| lampyris::sequence::sobol::sobol_owen(i, d, 9)), BOUNDS);
            let t = (0.3 - s.origin.y) / s.direction.y;
            let p = s.origin + s.direction * t;
            s.direction.y < 0.0 && t > 0.0 && (p.x - 0.4).abs() < 0.5 && (p.z + 0.2).abs() < 0.5
        };
        f64::from((0..N).filter(|i| through(*i)).count() as u32) / f64::from(N)
            * f64::from(e.power(BOUNDS).luminance())
    };
    close("sun through a window", window(&sun), 400.0, 5e-3);
    close("sky through a window", window(&sky), 3.0 * PI, 5e-3);
    for (e, lux) in [(&sun, 400.0), (&sky, 3.0 * PI)] {
        let normal = Vec3::Y;
        let n = 1 << 12;
        let toward = (0..n).map(|i| {
            let a = e.toward(Vec3::ZERO, spread(i, 2)).expect("everywhere");
            assert!(a.end.is_none());
            f64::from(a.weight.luminance() * normal.dot(a.wi).max(0.0))
        });
        close("by toward", toward.sum::<f64>() / f64::from(n), lux, 1e-3);
        let points = (0..n).map(|i| {
            let p = e.point(spread(i, 2));
            f64::from(p.intensity.luminance() * normal.dot(p.position).max(0.0))
        });
        close("by points", points.sum::<f64>() / f64::from(n), lux, 1e-3);
    }
    close("unit", sqrt(f64::from(travel.length_squared())), 1.0, 1e-6);
}
