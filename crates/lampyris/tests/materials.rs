//! The properties every material must have, asserted once for a table of instances; then what each owes to physics.

use glam::Vec3;
use lampyris::Rgb;
use lampyris::material::{
    Bsdf, Class, DELTA_ALPHA, Dielectric, Diffuse, Pbr, Scatter, Transport, Ward, fresnel,
};
use lampyris::sequence::uniform;
use lampyris::testing::{Moments, SphereBins, sidak};
use std::f32::consts::{FRAC_1_PI, PI};

const CLASSES: [Class; 2] = [Class::Sharp, Class::Dull];
const ANGLES: [f32; 6] = [0.0, 30.0, 60.0, 80.0, 88.0, 140.0];

fn ward(rho_d: f32, tau_d: f32, (rho_s, alpha): (f32, f32), (tau_s, tau_alpha): (f32, f32)) -> Bsdf {
    // Coloured a little, never above the value given.
    let tint = |v: f32| Rgb::new(v, 0.8 * v, 0.5 * v);
    Bsdf::Ward(Ward {
        base: Diffuse { reflectance: tint(rho_d), transmittance: tint(tau_d) },
        specular: tint(rho_s),
        alpha,
        transmission: tint(tau_s),
        transmission_alpha: tau_alpha,
    })
}

/// (metallic, transmission, roughness) of a coloured surface.
fn pbr(metallic: f32, transmission: f32, roughness: f32) -> Pbr {
    let base_color = Rgb::new(0.95, 0.7, 0.3);
    Pbr { base_color, metallic, transmission, roughness, ..Pbr::default() }
}

/// Every kind of material, and of mixture.
fn instances() -> Vec<(&'static str, Bsdf)> {
    let none = (0.0, 0.0);
    let glass = |ior, t| Bsdf::Dielectric(Dielectric::new(ior, t));
    vec![
        ("diffuse", Bsdf::Diffuse(Diffuse::opaque(Rgb::new(0.9, 0.5, 0.1)))),
        (
            "curtain",
            Bsdf::Diffuse(Diffuse { reflectance: Rgb::grey(0.4), transmittance: Rgb::new(0.1, 0.6, 0.2) }),
        ),
        ("black", Bsdf::Diffuse(Diffuse::opaque(Rgb::BLACK))),
        ("black ward", ward(0.0, 0.0, (0.0, 0.2), (0.0, 0.05))),
        ("ward as diffuse", ward(0.7, 0.0, none, none)),
        ("dull gloss", ward(0.0, 0.0, (1.0, 0.2), none)),
        ("very dull gloss", ward(0.2, 0.0, (0.8, 0.8), none)),
        ("dull gloss on paint", ward(0.5, 0.0, (0.4, 0.3), none)),
        ("sharp gloss on paint", ward(0.5, 0.0, (0.3, 0.05), none)),
        ("finest gloss", ward(0.3, 0.0, (0.6, DELTA_ALPHA), none)),
        ("mirror on paint", ward(0.5, 0.0, (0.5, 0.0), none)),
        ("mirror and sharp transmission", ward(0.1, 0.1, (0.4, 0.0), (0.4, 0.08))),
        ("pane", ward(0.0, 0.0, (0.1, 0.0), (0.9, 0.0))),
        ("frosted pane", ward(0.1, 0.2, (0.2, 0.1), (0.5, 0.25))),
        ("two dull lobes", ward(0.2, 0.1, (0.3, 0.4), (0.4, 0.2))),
        ("glass", glass(1.52, Rgb::WHITE)),
        ("green diamond", glass(2.4, Rgb::new(0.2, 0.8, 0.3))),
        ("mirror that is solid", glass(1.5, Rgb::BLACK)),
        ("polished glass", Bsdf::Dielectric(Dielectric { alpha: 0.1, ..Dielectric::new(1.5, Rgb::WHITE) })),
        ("rough glass", rough_glass(1.5, 0.3)),
        ("rough diamond", rough_glass(2.4, 0.2)),
        ("roughest glass", rough_glass(1.33, 1.0)),
        ("mirror metal", Bsdf::Pbr(pbr(1.0, 0.0, 0.0))),
        ("polished metal", Bsdf::Pbr(pbr(1.0, 0.0, 0.3))),
        ("rough metal", Bsdf::Pbr(pbr(1.0, 0.0, 0.5))),
        ("roughest metal", Bsdf::Pbr(pbr(1.0, 0.0, 1.0))),
        ("varnish", Bsdf::Pbr(pbr(0.0, 0.0, 0.0))),
        ("polished plastic", Bsdf::Pbr(pbr(0.0, 0.0, 0.35))),
        ("plastic", Bsdf::Pbr(pbr(0.0, 0.0, 0.5))),
        ("roughest plastic", Bsdf::Pbr(Pbr { ior: 1.8, ..pbr(0.0, 0.0, 1.0) })),
        ("half as red plastic", {
            let specular_color = Rgb::new(1.0, 0.2, 0.1);
            Bsdf::Pbr(Pbr { specular: 0.5, specular_color, ..pbr(0.0, 0.0, 0.6) })
        }),
        ("matt", Bsdf::Pbr(Pbr { specular: 0.0, ..pbr(0.0, 0.0, 0.6) })),
        ("thin pane", Bsdf::Pbr(pbr(0.0, 1.0, 0.0))),
        ("polished thin pane", Bsdf::Pbr(pbr(0.0, 1.0, 0.3))),
        ("frosted thin pane", Bsdf::Pbr(pbr(0.0, 1.0, 0.6))),
        ("all in one", Bsdf::Pbr(pbr(0.3, 0.4, 0.7))),
        ("all in one, polished", Bsdf::Pbr(pbr(0.3, 0.4, 0.35))),
    ]
}

fn rough_glass(ior: f32, alpha: f32) -> Bsdf {
    Bsdf::Dielectric(Dielectric { alpha, ..Dielectric::new(ior, Rgb::new(0.9, 0.8, 0.7)) })
}

/// f_r for light that arrives from `wo` and leaves toward `wi`: what flux meets.
fn onward(bsdf: &Bsdf, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
    bsdf.eval(class, wi, wo)
}

/// The index of refraction on the side of a direction.
fn index(bsdf: &Bsdf, w: Vec3) -> f32 {
    match bsdf {
        Bsdf::Dielectric(d) if w.z < 0.0 => d.ior,
        _ => 1.0,
    }
}

/// A unit vector at `degrees` off +z; above 90 it lies below.
fn at(degrees: f32, azimuth: f32) -> Vec3 {
    let (sin, cos) = libm::sincosf(degrees.to_radians());
    let (y, x) = libm::sincosf(azimuth);
    Vec3::new(sin * x, sin * y, cos)
}

fn random_direction(seed: u32, i: u32) -> Vec3 {
    lampyris::sampling::uniform_sphere([uniform(seed, i, 0), uniform(seed, i, 1)])
}

fn draw(bsdf: &Bsdf, class: Class, wo: Vec3, seed: u32, i: u32) -> Option<Scatter> {
    let u = [uniform(seed, i, 0), uniform(seed, i, 1)];
    bsdf.sample(class, wo, u, uniform(seed, i, 2), Transport::Flux)
}

fn mirrored(wo: Vec3) -> Vec3 {
    Vec3::new(-wo.x, -wo.y, wo.z)
}

/// Bins that resolve lobes about `axis` down to a slope of a hundredth.
fn fine(axis: Vec3) -> SphereBins {
    SphereBins { rings: 14, sectors: 24, power: 6, axis }
}

/// f_r is continuous across nothing but the horizon: there `EVEN` has an edge, hence it unless a lobe is narrow.
fn bins(bsdf: &Bsdf, class: Class, wo: Vec3) -> SphereBins {
    match bsdf {
        Bsdf::Ward(_) | Bsdf::Pbr(_) if class == Class::Sharp => {
            let brightness = |wi: &Vec3| bsdf.eval(class, wo, *wi).r;
            let through = brightness(&-wo) > brightness(&mirrored(wo));
            fine(if through { -wo } else { mirrored(wo) })
        }
        // The refracted lobe is narrower than the reflected one.
        Bsdf::Dielectric(d) if class == Class::Sharp => {
            let smooth = Bsdf::Dielectric(Dielectric { alpha: 0.0, ..*d });
            let bent = smooth.sample(class, wo, [0.0; 2], 1.0f32.next_down(), Transport::Flux);
            fine(bent.map_or(mirrored(wo), |s| s.wi))
        }
        _ => SphereBins::EVEN,
    }
}

fn has_finest(name: &str, class: Class) -> bool {
    name == "finest gloss" && class == Class::Sharp
}

#[test]
fn reciprocity() {
    for (name, bsdf) in instances() {
        for class in CLASSES {
            for i in 0..4000 {
                let (a, b) = (random_direction(1, i), random_direction(2, i));
                // Half of the pairs near each other's mirror image, or narrow lobes would compare zeros.
                let b = if i % 2 == 0 { b } else { (mirrored(a) + 0.1 * b).normalize() };
                // Between different media it is f_r/η² that is symmetric.
                let (there, back) = (bsdf.eval(class, a, b), bsdf.eval(class, b, a));
                let (there, back) = (there * index(&bsdf, b).powi(2), back * index(&bsdf, a).powi(2));
                let slack = if bsdf.is_solid_interface() { 2e-4 } else { 1e-5 };
                for k in 0..3 {
                    let error = (there[k] - back[k]).abs();
                    assert!(error <= slack * there[k].abs(), "{name} {class:?} {a} {b}: {there:?} {back:?}");
                }
            }
        }
    }
}

#[test]
fn no_surface_returns_more_than_it_receives() {
    for (name, bsdf) in instances() {
        for degrees in ANGLES {
            let wo = at(degrees, 0.4);
            let mut whole = 0.0;
            for class in CLASSES.into_iter().filter(|&c| !has_finest(name, c)) {
                let f = |wi: Vec3| f64::from(onward(&bsdf, class, wo, wi).r * wi.z.abs());
                whole += bins(&bsdf, class, wo).integral(f);
            }
            assert!(whole <= 1.0 + 1e-4, "{name} at {degrees}°: {whole}");
        }
    }
}

#[test]
fn samples_follow_their_density() {
    let mut trials = Vec::new();
    for (name, bsdf) in instances() {
        for class in CLASSES.into_iter().filter(|&c| !has_finest(name, c)) {
            for degrees in ANGLES {
                let wo = at(degrees, 0.4);
                let seed = 17 + degrees as u32;
                // A delta lobe has no density: for this test it is a loss.
                let sample = |i| draw(&bsdf, class, wo, seed, i).filter(|s| s.pdf.is_finite()).map(|s| s.wi);
                let p = bins(&bsdf, class, wo).test(50_000, sample, |wi| bsdf.pdf(class, wo, wi));
                trials.push((p, format!("{name} {class:?} at {degrees}°")));
            }
        }
    }
    let level = sidak(0.01, trials.len());
    let bad: Vec<_> = trials.iter().filter(|t| t.0 < level).collect();
    assert!(bad.is_empty(), "level {level:e}: {bad:#?}");
}

#[test]
fn weights_are_value_times_cosine_over_density() {
    for (name, bsdf) in instances() {
        for class in CLASSES {
            for i in 0..3000 {
                let wo = random_direction(3, i);
                let transport = if i % 2 == 0 { Transport::Flux } else { Transport::Radiance };
                let u = [uniform(4, i, 0), uniform(4, i, 1)];
                let Some(s) = bsdf.sample(class, wo, u, uniform(4, i, 2), transport) else { continue };
                assert!((s.wi.length() - 1.0).abs() < 1e-5, "{name}: {}", s.wi);
                if s.pdf.is_infinite() {
                    continue;
                }
                let pdf = bsdf.pdf(class, wo, s.wi);
                assert!((s.pdf - pdf).abs() <= 1e-4 * pdf, "{name} {class:?}: {} {pdf}", s.pdf);
                let f = match transport {
                    Transport::Flux => onward(&bsdf, class, wo, s.wi),
                    Transport::Radiance => bsdf.eval(class, wo, s.wi),
                };
                let expected = f * (s.wi.z.abs() / pdf);
                let slack = if bsdf.is_solid_interface() { 3e-4 } else { 1e-4 };
                for k in 0..3 {
                    let error = (s.weight[k] - expected[k]).abs();
                    assert!(error <= slack * expected[k], "{name} {class:?}: {:?} {expected:?}", s.weight);
                }
            }
        }
    }
}

#[test]
fn white_furnace_of_sampled_weights_matches_albedo_and_quadrature() {
    let mut exact = Vec::new();
    for (name, bsdf) in instances() {
        for class in CLASSES {
            for degrees in ANGLES {
                let wo = at(degrees, 1.0);
                let weights = |pick: &dyn Fn(&Scatter) -> bool| -> Moments {
                    (0..40_000)
                        .map(|i| {
                            draw(&bsdf, class, wo, 5, i)
                                .filter(|s| pick(s))
                                .map_or(0.0, |s| s.weight.r.into())
                        })
                        .collect()
                };
                let all = weights(&|_| true);
                assert!(
                    all.mean() < 1.0 + 4.0 * all.standard_error() + 1e-4,
                    "{name} {class:?} at {degrees}°"
                );
                let albedo = bsdf.albedo(class, wo);
                // What rough glass loses between its facets its albedo does not tell.
                let lost = match bsdf {
                    Bsdf::Dielectric(d) if d.alpha > 0.0 => (f64::from(albedo.r) - all.mean()).max(0.0),
                    _ => 0.0,
                };
                let slack = 0.05 * all.mean() + 4.0 * all.standard_error();
                let error = (all.mean() + lost - f64::from(albedo.r)).abs();
                assert!(error <= slack, "{name} {class:?} at {degrees}°: {} not {}", all.mean(), albedo.r);
                assert_eq!(albedo.is_black(), all.mean() == 0.0, "{name} {class:?}: black means empty");
                if !has_finest(name, class) {
                    let f = |wi: Vec3| f64::from(onward(&bsdf, class, wo, wi).r * wi.z.abs());
                    let integral = bins(&bsdf, class, wo).integral(f);
                    // Where every weight is the same number, only rounding separates the two.
                    let p = match (weights(&|s| s.pdf.is_finite()), integral) {
                        (m, i) if (m.mean() - i).abs() < 2e-5 => 1.0,
                        (m, i) => m.p_value(i),
                    };
                    exact.push((p, format!("{name} {class:?} at {degrees}°, {integral}")));
                }
            }
        }
    }
    let level = sidak(0.01, exact.len());
    let bad: Vec<_> = exact.iter().filter(|t| t.0 < level).collect();
    assert!(bad.is_empty(), "level {level:e}: {bad:#?}");
}

#[test]
fn extremes_stay_finite_and_weights_bounded() {
    let edge = [0.0, 1e-7, 0.5, 1.0 - 1.0 / 16_777_216.0];
    for (name, bsdf) in instances() {
        for class in CLASSES {
            for z in [1.0, 0.5, 1e-2, 1e-4, 1e-6, 1e-10, 1e-30, 0.0, -0.0, -1e-10, -1e-3, -1.0f32] {
                let wo = Vec3::new((1.0 - z * z).max(0.0).sqrt(), 0.0, z);
                assert!(bsdf.albedo(class, wo).is_finite(), "{name} {wo}");
                for u in 0..64 {
                    let [a, b, c] = [u % 4, u / 4 % 4, u / 16].map(|k: usize| edge[k]);
                    for transport in [Transport::Flux, Transport::Radiance] {
                        let Some(s) = bsdf.sample(class, wo, [a, b], c, transport) else { continue };
                        assert!(
                            s.wi.is_finite() && s.weight.is_finite() && s.pdf >= 0.0,
                            "{name} {wo} {s:?}"
                        );
                        let radiance = if bsdf.is_solid_interface() { 2.4 * 2.4 } else { 1.0 };
                        // Twice for Ward's lobe, whose albedo that steers the choice may be 20 % below 1. A facet of
                        // plastic may reflect everything where all of them reflect 8 % in the mean.
                        let bound = if matches!(bsdf, Bsdf::Pbr(_)) { 12.0 } else { 2.5 };
                        assert!(s.weight.max_channel() <= bound * radiance, "{name} {wo} {s:?}");
                    }
                    for wi in [wo, -wo, mirrored(wo), -mirrored(wo), Vec3::X] {
                        let (f, p) = (bsdf.eval(class, wo, wi), bsdf.pdf(class, wo, wi));
                        assert!(f.is_finite() && p.is_finite() && p >= 0.0, "{name} {wo} {wi} {f:?} {p}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_lambertian_shortcut_is_the_whole_dull_class() {
    for (name, bsdf) in instances() {
        let is_lambertian = |rho: Rgb| {
            (0..500).all(|i| {
                let (wo, wi) = (random_direction(6, i), random_direction(7, i));
                let expected = if wo.z * wi.z > 0.0 { rho * FRAC_1_PI } else { Rgb::BLACK };
                bsdf.eval(Class::Dull, wo, wi) == expected
            })
        };
        match bsdf.lambertian() {
            Some(rho) => assert!(is_lambertian(rho), "{name}"),
            None => assert!(!is_lambertian(bsdf.eval(Class::Dull, Vec3::Z, Vec3::Z) * PI), "{name}"),
        }
    }
}

#[test]
fn the_classes_of_ward_sum_to_the_formula() {
    // f = Σ ρ_d/π + ρ_s exp(−tan²θ_h/α²)/(πα²)·(h·h)/(h·n)⁴, in double precision and with the lobe mirrored for τ.
    let lobe = |alpha: f32, wo: Vec3, wi: Vec3| {
        let a2 = f64::from(alpha).powi(2);
        let [x, y, z] = [0, 1, 2].map(|k| f64::from(wo[k]) + f64::from(wi[k]));
        let tan2 = (x * x + y * y) / (z * z);
        libm::exp(-tan2 / a2) / (std::f64::consts::PI * a2) * (x * x + y * y + z * z) / z.powi(4)
    };
    let bsdf = ward(0.1, 0.2, (0.2, 0.1), (0.5, 0.25));
    for i in 0..4000 {
        let wo = random_direction(8, i);
        let wo = Vec3::new(wo.x, wo.y, wo.z.abs().max(0.01)).normalize();
        let wi = random_direction(9, i);
        let up = Vec3::new(wi.x, wi.y, wi.z.abs());
        let (d, s, alpha) = if wi.z > 0.0 { (0.1, 0.2, 0.1) } else { (0.2, 0.5, 0.25) };
        let expected = d / std::f64::consts::PI + s * lobe(alpha, wo, up);
        let sum = CLASSES.map(|c| f64::from(bsdf.eval(c, wo, wi).r)).iter().sum::<f64>();
        assert!((sum - expected).abs() < 1e-4 * expected, "{wo} {wi}: {sum} {expected}");
    }
}

#[test]
fn ward_reflects_what_the_bounded_form_must() {
    // Directional albedo of the lobe for ρ_s = 1 by an independent quadrature.
    let table = [
        (0.05, [0.9975, 0.9971, 0.9937, 0.9790, 0.8720]),
        (0.10, [0.9900, 0.9883, 0.9740, 0.9175, 0.8128]),
        (0.20, [0.9600, 0.9526, 0.8976, 0.8212, 0.8055]),
        (0.30, [0.9100, 0.8926, 0.8186, 0.7776, 0.8142]),
    ];
    for (alpha, row) in table {
        let bsdf = ward(0.0, 0.0, (1.0, alpha), (0.0, 0.0));
        for (degrees, expected) in [0.0, 30.0, 60.0, 75.0, 85.0].into_iter().zip(row) {
            let wo = at(degrees, 0.0);
            let f = |wi: Vec3| CLASSES.map(|c| f64::from(bsdf.eval(c, wo, wi).r * wi.z.abs())).iter().sum();
            let albedo = fine(mirrored(wo)).integral(f);
            assert!(
                (albedo - expected).abs() < 0.01 * expected,
                "α {alpha} at {degrees}°: {albedo} {expected}"
            );
        }
    }
}

#[test]
fn glass_obeys_fresnel_and_snell() {
    let n = 1.52f32;
    let normal = ((n - 1.0) / (n + 1.0)).powi(2);
    assert!((fresnel(1.0, 1.0 / n).0 - normal).abs() < 1e-7);
    assert!((fresnel(1.0, n).0 - normal).abs() < 1e-7);
    // At Brewster's angle only the perpendicular part is reflected: R = ½((n² − 1)/(n² + 1))².
    let brewster = ((n * n - 1.0) / (n * n + 1.0)).powi(2) / 2.0;
    assert!((fresnel(1.0 / (1.0 + n * n).sqrt(), 1.0 / n).0 - brewster).abs() < 1e-6);
    assert_eq!(fresnel(0.0, 1.0 / n).0, 1.0);
    assert_eq!(fresnel(0.5, n).0, 1.0, "beyond the critical angle of 41°");
    let (none, straight) = fresnel(0.3, 1.0);
    assert!(none < 1e-12 && (straight - 0.3).abs() < 1e-6, "equal indices are no interface");
    let glass = Dielectric::new(n, Rgb::new(0.9, 0.8, 0.7));
    for degrees in (1..90).chain(92..180) {
        let wo = at(degrees as f32, 2.0);
        let (reflectance, cos_t) = fresnel(wo.z.abs(), if wo.z > 0.0 { 1.0 / n } else { n });
        let [flux, radiance] = [Transport::Flux, Transport::Radiance]
            .map(|t| glass.sample(Class::Sharp, wo, [0.0; 2], 1.0f32.next_down(), t).unwrap());
        if reflectance == 1.0 {
            assert_eq!((flux.wi, flux.weight), (mirrored(wo), Rgb::WHITE));
            continue;
        }
        // The same share is reflected on the way back: reciprocity of the interface.
        let back = fresnel(cos_t, if wo.z > 0.0 { n } else { 1.0 / n }).0;
        assert!((back - reflectance).abs() < 2e-4, "{degrees}°: {reflectance} {back}");
        let (outside, inside) = if wo.z > 0.0 { (wo, flux.wi) } else { (flux.wi, wo) };
        let sin = |w: Vec3| libm::hypotf(w.x, w.y);
        assert!((sin(outside) - n * sin(inside)).abs() < 1e-5 && outside.z * inside.z < 0.0);
        assert_eq!(flux.weight, glass.transmittance);
        let scale = if wo.z > 0.0 { 1.0 / (n * n) } else { n * n };
        assert!((radiance.weight.r / flux.weight.r - scale).abs() < 1e-5 * scale);
    }
}

#[test]
fn a_pane_of_two_interfaces_passes_the_whole_series() {
    // (1 − R)/(1 + R): all reflections between the faces. Light is unpolarised anew at each face, so off the normal
    // less passes than by the two polarisations apart, whose mean is given second: a limit of the model, measured here.
    let glass = Dielectric::new(1.52, Rgb::WHITE);
    let mut trials = Vec::new();
    for (degrees, polarised, gap) in
        [(0.0, 0.9183, 0.0), (30.0, 0.9160, 0.0005), (60.0, 0.8435, 0.0128), (80.0, 0.4560, 0.0181)]
    {
        let wo = at(degrees, 0.3);
        let reflectance = f64::from(fresnel(wo.z, 1.0 / 1.52).0);
        let series = (1.0 - reflectance) / (1.0 + reflectance);
        assert!((polarised - series - gap).abs() < 1e-4, "{degrees}°: {series}");
        for transport in [Transport::Flux, Transport::Radiance] {
            let passed: Moments = (0..100_000)
                .map(|i| {
                    let (mut w, mut throughput, mut lower) = (wo, 1.0f32, false);
                    // `w` always points back along the path; the lower face's outward normal is −z.
                    for k in 0.. {
                        let flip = if lower { -1.0 } else { 1.0 };
                        let local = Vec3::new(w.x, w.y, flip * w.z);
                        let choice = uniform(11, i, k);
                        let s = glass.sample(Class::Sharp, local, [0.0; 2], choice, transport).unwrap();
                        throughput *= s.weight.r;
                        if s.wi.z > 0.0 {
                            let out = Vec3::new(s.wi.x, s.wi.y, flip * s.wi.z);
                            assert!(!lower || (out + wo).length() < 1e-4, "leaves in parallel");
                            return if lower { f64::from(throughput) } else { 0.0 };
                        }
                        w = -Vec3::new(s.wi.x, s.wi.y, flip * s.wi.z);
                        lower = !lower;
                    }
                    0.0
                })
                .collect();
            trials.push(passed.p_value(series));
        }
    }
    let level = sidak(0.01, trials.len());
    assert!(trials.iter().all(|&p| p > level), "{trials:?}");
}
