//! Light over a planar mirror against closed forms: a light and its image behind the mirror; what is a mirror and what
//! is none; and how much quieter images are than paths that look for the light.

mod support;

use glam::{Affine3A, Quat, Vec3};
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::eye::Meter;
use lampyris::import;
use lampyris::light::{Beam, LightKind};
use lampyris::material::{Bsdf, Coverage, Diffuse, Sides};
use lampyris::testing::Moments;
use lampyris::world::World;
use std::f64::consts::PI;
use std::path::Path;
use support::{
    Build, FAST, close, close_mean, diffuse, glass, gloss, lux, meter, render, say, settings, view,
};

/// Of a light and its image, as the issue of mirrors asks.
const IMAGE: f64 = 5e-3;

/// Rounding, where there is no noise.
const EXACT: f64 = 2e-5;

/// What the mirrors here reflect.
const RHO: f64 = 0.9;

/// A mirror in z = 0 that faces up, over a rectangle in x and |y| ≤ `half`.
fn looking_glass(b: &mut Build, from: f32, to: f32, half: f32) -> u32 {
    let mirror = b.material(gloss(0.0, RHO as f32, 0.0), 0.0, Sides::Both);
    b.quad(Vec3::new(from, -half, 0.0), Vec3::X * (to - from), Vec3::Y * (2.0 * half), mirror);
    mirror
}

/// cos θ/d² of a meter toward a point, 0 behind it.
fn cos_over_square(at: Meter, point: Vec3) -> f64 {
    let d = (point - at.position).as_dvec3();
    at.normal.as_dvec3().dot(d).max(0.0) / d.length().powi(3)
}

fn behind_the_mirror(p: Vec3) -> Vec3 {
    Vec3::new(p.x, p.y, -p.z)
}

/// E = I cos θ/d² + ρ I cos θ'/d'², for meters that face anywhere.
#[test]
fn point_and_its_image() {
    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let lamp = Vec3::new(0.3, -0.2, 1.5);
    b.light(LightKind::Point { position: lamp, intensity: Rgb::grey(100.0) });
    for normal in [Vec3::Z, Vec3::NEG_Z, Vec3::new(-0.6, 0.0, 0.8), Vec3::new(-0.8, 0.0, -0.6)] {
        for position in [Vec3::new(1.0, 0.5, 0.7), Vec3::new(2.0, -1.0, 3.0)] {
            let at = meter(position, normal);
            let image = cos_over_square(at, behind_the_mirror(lamp));
            let expected = 100.0 * (cos_over_square(at, lamp) + RHO * image);
            if expected > 0.0 {
                let measured = lux(&b.0, &[at], &settings(FAST, 16, 4, 1), 4)[0];
                close("light and image", measured, expected, EXACT);
            }
        }
    }
}

/// A spot seen in the mirror, and parallel light: E = E₀ (cos θ + ρ cos θ').
#[test]
fn beams_in_a_mirror() {
    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let (position, direction) = (Vec3::new(-1.0, 0.0, 2.0), Vec3::new(0.6, 0.0, -0.8));
    let beam = Beam::Cosine { exponent: 3.0 };
    b.light(LightKind::Spot { position, direction, intensity: Rgb::grey(50.0), beam });
    let at = meter(Vec3::new(1.5, 0.4, 1.0), Vec3::NEG_Z);
    let way = (at.position - behind_the_mirror(position)).as_dvec3().normalize();
    let cos = way.dot(behind_the_mirror(direction).as_dvec3());
    let spot = 50.0 * RHO * cos.powi(3) * cos_over_square(at, behind_the_mirror(position));
    close("spot", lux(&b.0, &[at], &settings(&["mirror"], 16, 4, 1), 4)[0], spot, EXACT);

    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let direction = Vec3::new(0.6, 0.0, -0.8);
    b.light(LightKind::Directional { direction, illuminance: Rgb::grey(500.0) });
    for (normal, cosines) in [(Vec3::NEG_X, 0.6 + RHO * 0.6), (Vec3::NEG_Z, RHO * 0.8), (Vec3::Z, 0.8)] {
        let at = meter(Vec3::new(0.5, 0.5, 1.0), normal);
        let measured = lux(&b.0, &[at], &settings(FAST, 16, 4, 1), 4)[0];
        close("parallel light", measured, 500.0 * cosines, EXACT);
    }
}

/// The image shines through the mirror as through a window: just inside the pyramid all of it, just outside nothing.
#[test]
fn the_pyramid_ends_where_the_mirror_does() {
    let mut b = Build::default();
    looking_glass(&mut b, -1.0, 1.0, 1.0);
    b.light(LightKind::Point { position: Vec3::Z * 2.0, intensity: Rgb::grey(100.0) });
    // From the image 2 m below through the rim at 1 m to 3 m above: 2.5 m from the axis.
    for (x, y, inside) in [(2.499, 0.3, true), (2.501, 0.3, false), (0.3, -2.499, true), (0.3, -2.501, false)]
    {
        let at = meter(Vec3::new(x, y, 3.0), Vec3::NEG_Z);
        let measured = lux(&b.0, &[at], &settings(&["mirror"], 16, 4, 1), 4)[0];
        let expected = 100.0 * RHO * cos_over_square(at, Vec3::NEG_Z * 2.0);
        if inside {
            close("inside the pyramid", measured, expected, EXACT);
        } else {
            assert_eq!(measured, 0.0, "outside the pyramid");
        }
    }
    // What stands between mirror and point, or between light and mirror, blocks the image.
    for z in [0.5, 2.5] {
        let mut b = b.clone();
        let black = b.grey(0.0);
        let x = 2.0 / 5.0 * (2.0 + if z < 1.0 { -z } else { z });
        let corner = Vec3::new(x - 0.2, -0.2, z);
        b.quad(corner, Vec3::X * 0.4, Vec3::Y * 0.4, black);
        let at = meter(Vec3::new(2.0, 0.0, 3.0), Vec3::NEG_Z);
        assert_eq!(lux(&b.0, &[at], &settings(&["mirror"], 16, 4, 1), 4)[0], 0.0, "a shutter at {z}");
    }
}

/// A disc that shines into the mirror, E = ρπL a²/(a² + h²); a sphere, πL (r/d)² cos θ and ρ times the same.
#[test]
fn extended_lights_and_their_images() {
    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let disc = LightKind::Disc { center: Vec3::Z, normal: Vec3::NEG_Z, radius: 0.5, radiance: Rgb::WHITE };
    b.light(disc);
    let at = meter(Vec3::Z * 3.0, Vec3::NEG_Z);
    let expected = RHO * PI * 0.25 / (0.25 + 16.0);
    close("disc", lux(&b.0, &[at], &settings(FAST, 1 << 12, 4, 1), 4)[0], expected, IMAGE);

    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let center = Vec3::new(0.0, 0.0, 1.0);
    b.light(LightKind::Sphere { center, radius: 0.3, radiance: Rgb::grey(10.0) });
    let at = meter(Vec3::new(2.0, 0.0, 1.5), Vec3::NEG_X);
    let both = cos_over_square(at, center) + RHO * cos_over_square(at, behind_the_mirror(center));
    close("sphere", lux(&b.0, &[at], &settings(FAST, 1 << 13, 4, 1), 4)[0], 10.0 * PI * 0.09 * both, IMAGE);
}

/// The sky in a square mirror of half side a, h before its centre: E = ρπL F, F = 4/π · s atan s, s = a/√(a² + h²).
#[test]
fn sky_in_a_mirror() {
    let mut b = Build::default();
    b.0.environment = Rgb::grey(2.0);
    looking_glass(&mut b, -1.0, 1.0, 1.0);
    for h in [0.3, 1.0] {
        let s = 1.0 / libm::sqrt(1.0 + h * h);
        let expected = RHO * 2.0 * PI * (4.0 / PI * s * libm::atan(s));
        let at = meter(Vec3::Z * h as f32, Vec3::NEG_Z);
        close("sky", lux(&b.0, &[at], &settings(&["mirror"], 1 << 13, 4, 1), 4)[0], expected, IMAGE);
    }
}

/// Lamp and point so near the mirror that the clamp takes most of the image's light: it is paid back.
#[test]
fn what_the_clamp_takes_from_an_image_is_paid_back() {
    let mut b = Build::default();
    looking_glass(&mut b, -10.0, 10.0, 10.0);
    let center = Vec3::Z * 0.05;
    b.light(LightKind::Disc { center, normal: Vec3::NEG_Z, radius: 0.3, radiance: Rgb::WHITE });
    let at = meter(Vec3::Z * 0.1, Vec3::NEG_Z);
    let expected = RHO * PI * 0.09 / (0.09 + 0.0225);
    let s = |clamp| Settings { clamp, ..settings(&["mirror"], 8, 1 << 8, 0) };
    close_mean("near the mirror", 16, expected, 1.5e-2, |seed| {
        lux(&b.0, &[at], &Settings { seed, ..s(1.5) }, 16)[0]
    });
    // At eight light points a batch, G ≤ 12.6 for a true 44 on the axis.
    let clamped = |seed| lux(&b.0, &[at], &Settings { seed, ..s(1.5) }, 16)[0];
    let free = |seed| lux(&b.0, &[at], &Settings { seed, ..s(0.0) }, 16)[0];
    let (clamped, free): (Moments, Moments) = ((0..16).map(clamped).collect(), (0..16).map(free).collect());
    assert!(clamped.standard_error() < free.standard_error(), "the clamp has not bitten");
}

/// A spot lights a small patch, and the mirror shows it to a meter in its plane: E = ρ ρ_d Φ/π · cos²θ/d'².
#[test]
fn virtual_light_in_a_mirror() {
    let mut b = Build::default();
    looking_glass(&mut b, -0.3, 0.9, 0.5);
    let patch = b.grey(0.5);
    b.quad(Vec3::new(-0.1, -0.1, 1.0), Vec3::Y * 0.2, Vec3::X * 0.2, patch);
    let (position, target) = (Vec3::new(-1.0, 0.0, 0.2), Vec3::Z);
    let beam = Beam::Cone { cos_inner: 0.99995, cos_outer: 0.9999 };
    let intensity = Rgb::grey(1e4);
    b.light(LightKind::Spot { position, direction: (target - position).normalize(), intensity, beam });
    let flux = 1e4 * f64::from(beam.solid_angle());
    let expected = RHO * 0.5 * flux / PI * (4.0 / 5.0) / 5.0;
    let at = meter(Vec3::new(1.0, 0.0, 1.0), Vec3::NEG_Z);
    close("patch", lux(&b.0, &[at], &settings(&["mirror"], 1 << 10, 4, 1), 4)[0], expected, IMAGE);
}

/// Between two mirrors a lamp has endless images; the part holds the two of one reflection.
#[test]
fn one_reflection_only() {
    let mut b = Build::default();
    let mirror = looking_glass(&mut b, -9.0, 9.0, 9.0);
    b.quad(Vec3::new(-9.0, -9.0, 3.0), Vec3::Y * 18.0, Vec3::X * 18.0, mirror);
    b.light(LightKind::Point { position: Vec3::Z, intensity: Rgb::grey(100.0) });
    let at = meter(Vec3::new(2.0, 0.0, 2.0), Vec3::NEG_X);
    let images = cos_over_square(at, Vec3::NEG_Z) + cos_over_square(at, Vec3::Z * 5.0);
    let measured = lux(&b.0, &[at], &settings(&["mirror"], 16, 4, 1), 4)[0];
    close("two images", measured, 100.0 * RHO * images, EXACT);
}

/// Surfaces that let next to nothing through are shaded one by one, opaque ones sixteen at once: the same light.
#[test]
fn sixteen_at_once_equal_one_by_one() {
    let picture = |through: f32| {
        let mut b = Build::default();
        let wall = Diffuse { reflectance: Rgb::grey(0.5), transmittance: Rgb::grey(through) };
        let wall = b.material(Bsdf::Diffuse(wall), 0.0, Sides::Both);
        let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
        b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, wall, wall, wall, mirror, wall]);
        b.block(Vec3::new(0.4, 0.0, 0.3), Vec3::new(0.9, 0.8, 0.7), wall);
        b.light(LightKind::Sphere {
            center: Vec3::new(1.4, 1.6, 0.5),
            radius: 0.1,
            radiance: Rgb::grey(20.0),
        });
        let spot = Beam::Cosine { exponent: 4.0 };
        let (position, direction) = (Vec3::new(0.5, 1.5, 1.0), Vec3::new(0.0, -0.6, -0.8));
        b.light(LightKind::Spot { position, direction, intensity: Rgb::grey(5.0), beam: spot });
        let eye = view(Vec3::new(1.0, 1.2, 1.9), Vec3::new(1.0, 0.6, 0.0), 70.0, 24, 24);
        render(&b.0, eye, &settings(&["mirror"], 64, 8, 3), 2)
    };
    let (packets, singles) = (picture(0.0), picture(1e-30));
    let mean = packets.iter().map(|v| v.luminance()).sum::<f32>() / packets.len() as f32;
    assert!(mean > 0.0);
    let off = |(a, b): (&Rgb, &Rgb)| (a.luminance() - b.luminance()).abs() > 1e-4 * (a.luminance() + mean);
    let flipped = packets.iter().zip(&singles).filter(|p| off(*p)).count();
    assert!(flipped <= packets.len() / 100, "{flipped} pixels differ");
}

/// How many mirrors a world finds among one material's surfaces.
fn found(make: impl FnOnce(&mut Build, u32)) -> usize {
    let mut b = Build::default();
    let mirror = b.material(gloss(0.1, 0.8, 0.0), 0.0, Sides::Both);
    make(&mut b, mirror);
    World::new(b.0).mirrors().len()
}

/// Planes are mirrors however finely cut and however placed; balls, polish, glass and painted mirrors are none.
#[test]
fn what_is_a_mirror() {
    assert_eq!(found(|b, m| b.quad(Vec3::ZERO, Vec3::X, Vec3::Y, m)), 1, "a pane");
    let tiles = |b: &mut Build, m: u32| {
        let corner = |i: u32| Vec3::new((i % 33) as f32 / 7.0, (i / 33) as f32 / 11.0, 0.0);
        let square = |i: u32| [[i, i + 1, i + 34], [i, i + 34, i + 33]];
        let triangles: Vec<[u32; 3]> = (0..32 * 33).filter(|i| i % 33 != 32).flat_map(square).collect();
        let count = triangles.len();
        b.mesh((0..33 * 33).map(corner).collect(), triangles, vec![m; count]);
        let turn = Quat::from_axis_angle(Vec3::new(0.48, 0.6, 0.64), 1.1);
        b.0.instances[0].transform =
            Affine3A::from_scale_rotation_translation(Vec3::splat(1.7), turn, Vec3::new(3.0, -5.0, 2.0));
    };
    assert_eq!(found(tiles), 1, "two thousand triangles in a plane");
    let cube = |b: &mut Build, m: u32| {
        b.block(Vec3::ZERO, Vec3::ONE, m);
        let faces: Vec<_> = b.0.meshes.drain(..).collect();
        b.0.instances.clear();
        let triangles = (0..6).flat_map(|k| [[4 * k, 4 * k + 1, 4 * k + 2], [4 * k, 4 * k + 2, 4 * k + 3]]);
        b.mesh(faces.into_iter().flat_map(|f| f.positions).collect(), triangles.collect(), vec![m; 12]);
    };
    assert_eq!(found(cube), 6, "the faces of a cube");
    let ball = |b: &mut Build, m: u32| {
        b.sphere(Vec3::ZERO, 1.0, 2, false, |_| m);
    };
    assert_eq!(found(ball), 0, "a faceted ball");
    let panes = |b: &mut Build, m: u32| {
        (0..20).for_each(|k| b.quad(Vec3::Z * k as f32, Vec3::X * (1.0 + k as f32), Vec3::Y, m));
    };
    assert_eq!(found(panes), 8, "the largest of many");
    let bent = |b: &mut Build, m: u32| {
        b.quad(Vec3::ZERO, Vec3::X, Vec3::Y, m);
        b.0.meshes[0].normals = vec![Vec3::new(0.6, 0.0, 0.8); 4];
    };
    assert_eq!(found(bent), 0, "a pane with bent normals");
    for (what, bsdf) in [("glass", glass()), ("polish", gloss(0.1, 0.8, 0.01)), ("paint", diffuse(0.8))] {
        let pane = |b: &mut Build, m: u32| {
            b.0.materials[m as usize].bsdf = bsdf;
            b.quad(Vec3::ZERO, Vec3::X, Vec3::Y, m);
        };
        assert_eq!(found(pane), 0, "{what}");
    }
    let punched = |b: &mut Build, m: u32| {
        b.0.materials[m as usize].coverage = Coverage::Mask { factor: 1.0, cutoff: 0.5 };
        b.quad(Vec3::ZERO, Vec3::X, Vec3::Y, m);
    };
    assert_eq!(found(punched), 0, "a mirror with holes");
}

/// Of the shipped still life only the hand mirror: ring, ball and egg are curved. The office has a looking-glass and a
/// window.
#[test]
fn mirrors_of_the_scenes_that_ship() {
    for (name, expected) in [("ring", 1), ("office", 2), ("cornell", 0)] {
        let file =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name).with_extension("mgf");
        let loaded = import::load(&file, &import::Options::default()).expect("a scene that ships");
        assert!(loaded.warnings.is_empty(), "{name}: {:?}", loaded.warnings);
        assert_eq!(World::new(loaded.scene).mirrors().len(), expected, "{name}");
    }
}

/// A lamp beside a mirror wall: images against paths from the eye that must find it, the same mean and far less
/// noise. A mirror that might have holes, but has none, is left to *caustic*, whose oracle is asked here.
#[test]
fn images_are_quieter_than_paths() {
    let light_over_mirror = |coverage: Coverage, seed: u32| {
        let mut b = Build::default();
        let wall = b.grey(0.5);
        let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
        b.0.materials[mirror as usize].coverage = coverage;
        b.room(Vec3::ZERO, Vec3::new(3.0, 2.5, 3.0), [mirror, wall, wall, wall, wall, wall]);
        let (center, radiance) = (Vec3::new(1.0, 2.0, 1.5), Rgb::grey(100.0));
        b.light(LightKind::Sphere { center, radius: 0.2, radiance });
        let eye = view(Vec3::new(2.5, 1.5, 2.5), Vec3::new(1.5, 0.5, 0.5), 60.0, 24, 16);
        render(&b.0, eye, &settings(&["mirror", "caustic-path"], 64, 8, seed), 8)
    };
    let holes = Coverage::Mask { factor: 1.0, cutoff: 0.5 };
    let sides = [Coverage::Full, holes].map(|coverage| {
        let mut pixels = vec![Moments::default(); 24 * 16];
        let mut whole = Moments::default();
        for seed in 0..16 {
            let picture = light_over_mirror(coverage, 2 * seed + u32::from(coverage == holes));
            pixels.iter_mut().zip(&picture).for_each(|(m, v)| m.push(f64::from(v.luminance())));
            whole.push(picture.iter().map(|v| f64::from(v.luminance())).sum());
        }
        (pixels.iter().map(|m| m.standard_error().powi(2)).sum::<f64>(), whole)
    });
    let [(quiet, images), (noisy, paths)] = &sides;
    let p = images.p_value_against(paths);
    say(format_args!(
        "variance of pixels: paths/images {:.0}; means {:.4} ± {:.4} and {:.4} ± {:.4}, p = {p:.3}",
        noisy / quiet,
        images.mean(),
        images.standard_error(),
        paths.mean(),
        paths.standard_error()
    ));
    assert!(p > 1e-3, "images {} paths {}", images.mean(), paths.mean());
    assert!(noisy / quiet > 30.0, "{}", noisy / quiet);
}
