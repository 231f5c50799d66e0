//! What the materials of facets owe to physics: glTF's metal, plastic and pane, rough glass, Beer's law in its body.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::light::LightKind;
use lampyris::material::{Bsdf, Class, Dielectric, Diffuse, Pbr, Sides, Transport, fresnel};
use lampyris::sequence::sobol::sobol_owen_pair;
use lampyris::sequence::uniform;
use lampyris::testing::Moments;
use support::{Build, FAST, ORACLE, close_mean, lux, meter, render, say, settings, view};

const CLASSES: [Class; 2] = [Class::Sharp, Class::Dull];

fn at(degrees: f32) -> Vec3 {
    let (sin, cos) = libm::sincosf(degrees.to_radians());
    Vec3::new(sin * 0.8, sin * 0.6, cos)
}

fn pbr(metallic: f32, transmission: f32, roughness: f32) -> Pbr {
    Pbr { metallic, transmission, roughness, ..Pbr::default() }
}

/// What comes back, or passes, of unit radiance from everywhere: the sampled weights of both classes.
fn furnace(bsdf: &Bsdf, wo: Vec3, transport: Transport) -> f64 {
    const SAMPLES: u32 = 1 << 14;
    let weight = |class, i| {
        let s = bsdf.sample(class, wo, sobol_owen_pair(i, 0, 1), sobol_owen_pair(i, 2, 2)[0], transport);
        // Radiance beyond an interface is that of the same light: η² times as much inside.
        s.map_or(0.0, |s| match (bsdf, transport) {
            (Bsdf::Dielectric(d), Transport::Radiance) => {
                let index = |w: Vec3| if w.z < 0.0 { d.ior * d.ior } else { 1.0 };
                f64::from(s.weight.r * index(s.wi) / index(wo))
            }
            _ => f64::from(s.weight.r),
        })
    };
    let sum: f64 =
        CLASSES.into_iter().flat_map(|c| (0..SAMPLES).map(move |i| (c, i))).map(|(c, i)| weight(c, i)).sum();
    sum / f64::from(SAMPLES)
}

#[test]
fn white_surfaces_of_any_roughness_return_what_they_receive() {
    for step in 0..=20 {
        let roughness = step as f32 / 20.0;
        for degrees in [0.0, 30.0, 60.0, 80.0] {
            let plastics = [1.0, 1.2, 1.5, 2.0].map(|ior| Pbr { ior, ..pbr(0.0, 0.0, roughness) });
            let others = [pbr(1.0, 0.0, roughness), pbr(0.0, 1.0, roughness), pbr(0.3, 0.4, roughness)];
            for surface in plastics.into_iter().chain(others) {
                let back = furnace(&Bsdf::Pbr(surface), at(degrees), Transport::Flux);
                assert!((back - 1.0).abs() < 0.01, "{surface:?} at {degrees}°: {back}");
            }
        }
    }
}

#[test]
fn rough_glass_gains_nothing_on_either_side() {
    let mut least = [1.0f64; 11];
    for step in 0..=10u8 {
        let alpha = f32::from(step) / 10.0;
        for degrees in [0.0, 30.0, 60.0, 80.0, 100.0, 130.0, 150.0, 180.0] {
            let bsdf = Bsdf::Dielectric(Dielectric { alpha, ..Dielectric::new(1.5, Rgb::WHITE) });
            let [flux, radiance] =
                [Transport::Flux, Transport::Radiance].map(|t| furnace(&bsdf, at(degrees), t));
            assert!((flux - radiance).abs() < 1e-5, "α {alpha} at {degrees}°: {flux} {radiance}");
            assert!(flux < 1.0 + 1e-5, "α {alpha} at {degrees}°: {flux}");
            least[usize::from(step)] = least[usize::from(step)].min(flux);
        }
    }
    say(format_args!("least of rough glass by α: {least:.3?}"));
    assert!((least[0] - 1.0).abs() < 1e-5, "smooth glass loses nothing");
}

#[test]
fn without_specular_the_plastic_is_lambert_to_the_bit() {
    let color = Rgb::new(0.725, 0.3, 0.05);
    for roughness in [0.0, 0.2, 0.6, 1.0] {
        let matt = Bsdf::Pbr(Pbr { base_color: color, specular: 0.0, ..pbr(0.0, 0.0, roughness) });
        let lambert = Bsdf::Diffuse(Diffuse::opaque(color));
        assert_eq!(matt.lambertian(), Some(color));
        assert!(!matt.transmits());
        for i in 0..1000 {
            let [wo, wi] =
                [1, 2].map(|s| lampyris::sampling::uniform_sphere([uniform(s, i, 0), uniform(s, i, 1)]));
            for class in CLASSES {
                assert_eq!(matt.eval(class, wo, wi), lambert.eval(class, wo, wi));
                assert_eq!(matt.albedo(class, wo), lambert.albedo(class, wo));
            }
        }
    }
}

#[test]
fn at_normal_incidence_the_reflectance_is_that_of_the_index() {
    for ior in [1.2f32, 1.5, 2.4] {
        let r = ((ior - 1.0) / (ior + 1.0)).powi(2);
        let of = |p: Pbr| {
            Bsdf::Pbr(Pbr { ior, ..p }).sample(Class::Sharp, Vec3::Z, [0.3; 2], 0.0, Transport::Flux)
        };
        let varnish = of(pbr(0.0, 0.0, 0.0)).unwrap();
        assert!((varnish.weight.r - r).abs() < 1e-6 && varnish.wi == Vec3::Z, "{varnish:?}");
        let tinted = Pbr { specular: 0.5, specular_color: Rgb::new(1.0, 0.5, 0.0), ..pbr(0.0, 0.0, 0.0) };
        let tinted = of(tinted).unwrap().weight;
        assert!((tinted.r - 0.5 * r).abs() < 1e-6 && (tinted.g - 0.25 * r).abs() < 1e-6, "{tinted:?}");
    }
    let gold = Rgb::new(1.0, 0.77, 0.34);
    let gold = Bsdf::Pbr(Pbr { base_color: gold, ..pbr(1.0, 0.0, 0.0) });
    let s = gold.sample(Class::Sharp, Vec3::Z, [0.3; 2], 0.0, Transport::Flux).unwrap();
    assert_eq!(s.weight, Rgb::new(1.0, 0.77, 0.34));
}

/// (1 − R)/(1 + R), the polarisations apart, for n = 1.52.
#[test]
fn a_sheet_of_thin_glass_passes_the_whole_series() {
    let known = [
        (0.0, 0.9183),
        (30.0, 0.9160),
        (45.0, 0.9025),
        (60.0, 0.8435),
        (70.0, 0.7247),
        (75.0, 0.6148),
        (80.0, 0.4560),
    ];
    let tint = Rgb::new(1.0, 0.5, 0.25);
    for (degrees, expected) in known {
        let pane = Bsdf::Pbr(Pbr { ior: 1.52, base_color: tint, ..pbr(0.0, 1.0, 0.0) });
        let wo = at(degrees);
        // Both lobes are deltas: the sum over picks is exact.
        let (mut passed, mut reflected) = (Rgb::BLACK, 0.0);
        const PICKS: u32 = 1 << 16;
        for i in 0..PICKS {
            let choice = (i as f32 + 0.5) / PICKS as f32;
            let s = pane.sample(Class::Sharp, wo, [0.5; 2], choice, Transport::Radiance).unwrap();
            assert!(s.pdf.is_infinite());
            if s.wi.z < 0.0 {
                assert_eq!(s.wi, -wo);
                passed += s.weight / PICKS as f32;
            } else {
                assert_eq!(s.wi, Vec3::new(-wo.x, -wo.y, wo.z));
                reflected += s.weight.r / PICKS as f32;
            }
        }
        for k in 0..3 {
            assert!((passed[k] - tint[k] * expected).abs() < 1e-4, "{degrees}°: {passed:?} for {expected}");
        }
        assert!((passed.r + reflected - 1.0).abs() < 1e-4);
    }
}

/// A slab of an index like air's between a camera and a white sky: exp(−σ d) and nothing else.
#[test]
fn a_ray_through_a_slab_loses_what_beer_says() {
    let sigma = Rgb::new(0.0, 0.7, 3.0);
    for (tilt, parts) in [(0.0f32, FAST), (0.0, ORACLE), (0.8, FAST), (0.8, ORACLE)] {
        let mut b = Build(lampyris::scene::Scene { environment: Rgb::WHITE, ..Default::default() });
        let body = Dielectric { attenuation: sigma, ..Dielectric::new(1.0, Rgb::WHITE) };
        let body = b.material(Bsdf::Dielectric(body), 0.0, Sides::Both);
        b.block(Vec3::new(-50.0, -50.0, -0.4), Vec3::new(50.0, 50.0, 0.0), body);
        let toward = Vec3::new(libm::sinf(tilt), 0.0, -libm::cosf(tilt));
        let eye = view(Vec3::Z, Vec3::Z + toward, 1e-4, 1, 1);
        let seen = render(&b.0, eye, &settings(parts, 1, 1, 0), 1)[0];
        let d = 0.4 / libm::cosf(tilt);
        for k in 0..3 {
            let expected = libm::expf(-sigma[k] * d);
            assert!((seen[k] - expected).abs() < 3e-6, "{parts:?} {tilt}: {seen:?} not {expected}");
        }
    }
}

/// The same with reflections between its faces, from both sides of which comes the same light:
/// R + (1 − R)² (t + R t²)/(1 − R² t²) with t = exp(−σ d).
#[test]
fn an_absorbing_slab_of_glass_shows_the_series() {
    let (n, sigma, thickness) = (1.5f64, 0.8f64, 0.5f64);
    let mut b = Build(lampyris::scene::Scene { environment: Rgb::WHITE, ..Default::default() });
    let glass = Dielectric { attenuation: Rgb::grey(sigma as f32), ..Dielectric::new(n as f32, Rgb::WHITE) };
    let body = b.material(Bsdf::Dielectric(glass), 0.0, Sides::Both);
    let half = 0.5 * thickness as f32;
    b.block(Vec3::new(-9.0, -9.0, -half), Vec3::new(9.0, 9.0, half), body);
    let r = f64::from(fresnel(1.0, 1.0 / n as f32).0);
    let t = libm::exp(-sigma * thickness);
    let expected = r + (1.0 - r).powi(2) * (t + r * t * t) / (1.0 - r * r * t * t);
    for parts in [FAST, ORACLE] {
        close_mean("absorbing slab", 8, expected, 4e-3, |seed| {
            let eye = view(Vec3::Z * 3.0, Vec3::ZERO, 0.01, 32, 32);
            let picture = render(&b.0, eye, &settings(parts, 16, 16, seed), 1);
            picture.iter().map(|p| f64::from(p.g)).collect::<Moments>().mean()
        });
    }
}

/// Parallel light through an absorbing slab onto a square floor, whose virtual lights a meter above it sees: particles
/// lose by the same law. With ρ E exp(−σ d)/π from a square of half side 2 at height 1, form factor by its four corners.
#[test]
fn particles_through_a_slab_lose_what_beer_says() {
    let (sigma, thickness, rho) = (1.5f32, 0.6f32, 0.8f32);
    let mut b = Build::default();
    let floor = b.grey(rho);
    let body = Dielectric { attenuation: Rgb::grey(sigma), ..Dielectric::new(1.0, Rgb::WHITE) };
    let body = b.material(Bsdf::Dielectric(body), 0.0, Sides::Both);
    b.quad(Vec3::new(-2.0, 0.0, -2.0), Vec3::Z * 4.0, Vec3::X * 4.0, floor);
    b.block(Vec3::new(-2.1, 1.5, -2.1), Vec3::new(2.1, 1.5 + thickness, 2.1), body);
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::WHITE });
    let side = 2.0 / 5f64.sqrt();
    let seen = 4.0 * side * libm::atan(side) / std::f64::consts::PI;
    let expected = f64::from(rho) * libm::exp(f64::from(-sigma * thickness)) * seen;
    close_mean("particles through a slab", 8, expected, 5e-3, |seed| {
        let s = settings(&["vpl", "compensation"], 1 << 11, 64, seed);
        lux(&b.0, &[meter(Vec3::Y, Vec3::NEG_Y)], &s, 4)[0]
    });
}
