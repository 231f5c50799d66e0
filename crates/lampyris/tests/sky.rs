//! Light by pictures: environments and textured emitters, against closed forms, quadrature, and each other.

mod support;

use glam::{Affine2, Vec2, Vec3};
use lampyris::Rgb;
use lampyris::light::{Bounds, Emitter, Sky};
use lampyris::material::{Coverage, Map};
use lampyris::testing::{Moments, SphereBins, chi_square_test};
use lampyris::texture::{Encoding, Filter, Image, Pixels, Texture, Wrap};
use lampyris::world::World;
use std::f64::consts::PI;
use std::sync::Arc;
use support::{Build, FAST, ORACLE, close, close_mean, lux, meter, parts_equal_path, render, settings, view};

fn picture(width: u32, height: u32, at: impl Fn(u32, u32) -> [f32; 3]) -> Image {
    let pixels = Pixels::Float((0..width * height).map(|k| at(k % width, k / width)).collect());
    Image { name: String::new(), width, height, pixels }
}

/// Colours without order, and one pixel a thousand times brighter.
fn wild(x: u32, y: u32) -> [f32; 3] {
    let sun = if (x, y) == (5, 2) { 1000.0 } else { 1.0 };
    [0, 1, 2].map(|c| sun * lampyris::sequence::uniform(3, x * 64 + y, c))
}

fn sky(image: &Image) -> Sky {
    Sky::new(image, Rgb::WHITE, Vec3::Y).expect("light")
}

/// Finer bins than the picture's pixels about the axis of its rows.
const BINS: SphereBins = SphereBins { rings: 16, sectors: 32, power: 1, axis: Vec3::Y };

#[test]
fn the_picture_lies_as_it_is_said_to() {
    let spot =
        |x0: u32, y0: u32| picture(8, 4, move |x, y| if (x, y) == (x0, y0) { [1.0; 3] } else { [0.0; 3] });
    let at = |x: f32, y: f32, up: Vec3, d: Vec3| {
        let sky = Sky::new(&spot(x as u32, y as u32), Rgb::grey(2.0), up).expect("light");
        (sky.radiance(d), sky.pdf(d))
    };
    // Directions of pixel centres: an eighth of the way round is 45°, the first row 22.5° from the top.
    let (s, c) = libm::sincosf(std::f32::consts::PI / 8.0);
    let toward = |right: f32, up: f32, forward: f32| Vec3::new(right, up, -forward);
    // Column 4 is the first right of the middle, column 6 the first right of the right quarter, column 0 is behind.
    for (x, d) in [(4.0, toward(s, 0.0, c)), (6.0, toward(c, 0.0, -s)), (0.0, toward(-s, 0.0, -c))] {
        let d = d * libm::cosf(std::f32::consts::PI / 8.0) + Vec3::Y * libm::sinf(std::f32::consts::PI / 8.0);
        let (radiance, pdf) = at(x, 1.0, Vec3::Y, d);
        assert!((radiance.r - 2.0).abs() < 1e-4 && pdf > 1.0, "{x}: {radiance:?} {pdf}");
        // With z up the middle lies at +y.
        let turned = Vec3::new(d.x, -d.z, d.y);
        assert!((at(x, 1.0, Vec3::Z, turned).0.r - 2.0).abs() < 1e-4);
    }
    assert!(at(3.0, 0.0, Vec3::Y, Vec3::Y).0.r > 0.0 && at(3.0, 3.0, Vec3::Y, Vec3::Y).0.is_black());
    assert!(Sky::new(&picture(4, 2, |_, _| [0.0; 3]), Rgb::WHITE, Vec3::Y).is_none());
    assert!(
        Sky::new(&picture(4, 2, |x, _| [if x == 1 { f32::NAN } else { 1.0 }; 3]), Rgb::WHITE, Vec3::Y)
            .is_some()
    );
}

/// ∫ L dω by quadrature, by the sum over pixels, and by samples; the density integrates to one and samples follow it.
#[test]
fn samples_follow_the_light() {
    let sky = sky(&picture(16, 8, wild));
    let exact = BINS.integral(|w| f64::from(sky.radiance(w).luminance()));
    // Within a pixel the sum over pixels counts solid angle as even.
    close("sum", sky.light().luminance().into(), exact, 0.02);
    let all: Moments = (0..1 << 16)
        .map(|i| {
            let (w, pdf) = sky.sample(support::spread(i, 4));
            assert!((w.length() - 1.0).abs() < 1e-5 && pdf > 0.0);
            f64::from(sky.radiance(w).luminance() / pdf)
        })
        .collect();
    close("samples", all.mean(), exact, 3e-3);
    assert!(all.mean() * 3.0 > all.standard_error() * 256.0, "the sun is not found in proportion");
    // Pixel by pixel: the density is even within each.
    let edge = |y: u32| libm::cos(PI * f64::from(y) / 8.0);
    let pixels = || (0..128u32).map(|k| (k % 16, k / 16));
    let centre = |(x, y): (u32, u32)| {
        let (s, c) = libm::sincosf(std::f32::consts::TAU * ((x as f32 + 0.5) / 16.0 - 0.5));
        let (sin, cos) = libm::sincosf(std::f32::consts::PI * (y as f32 + 0.5) / 8.0);
        Vec3::new(sin * s, cos, -sin * c)
    };
    let solid_angle = |y: u32| 2.0 * PI / 16.0 * (edge(y) - edge(y + 1));
    let shares: Vec<f64> = pixels().map(|p| f64::from(sky.pdf(centre(p))) * solid_angle(p.1)).collect();
    close("density", shares.iter().sum(), 1.0, 1e-5);
    let mut observed = vec![0.0; 128];
    let (n, mut odd) = (200_000, 0);
    for i in 0..n {
        let (w, pdf) = sky.sample([0, 1].map(|d| lampyris::sequence::uniform(9, i, d)));
        let longitude = libm::atan2(f64::from(w.x), f64::from(-w.z)) / (2.0 * PI) + 0.5;
        let x = (longitude * 16.0).clamp(0.0, 15.0) as u32;
        let y = (libm::acos(f64::from(w.y)) / PI * 8.0).clamp(0.0, 7.0) as u32;
        observed[(y * 16 + x) as usize] += 1.0;
        odd += u32::from((sky.pdf(w) / pdf - 1.0).abs() > 1e-3);
    }
    let expected: Vec<f64> = shares.iter().map(|s| s * f64::from(n)).collect();
    // On an edge rounding may find the neighbour.
    assert!(odd < n / 1000, "{odd} densities differ");
    let p = chi_square_test(&observed, &expected, 0);
    assert!(p > 0.01, "p = {p}");
}

/// Particles through a window, weighted by their flux, against ∫ L cos dω by quadrature: the light of the upper half.
#[test]
fn particles_of_a_sky() {
    const BOUNDS: Bounds = Bounds { center: Vec3::ZERO, radius: 2.0 };
    const N: u32 = 1 << 20;
    let sky = sky(&picture(16, 8, wild));
    let expected = BINS.integral(|w| f64::from(sky.radiance(w).luminance() * w.y.max(0.0)));
    let e = Emitter::Sky(Arc::new(sky));
    let one = |i| {
        let s = e.emit([0, 1, 2, 3].map(|d| lampyris::sequence::sobol::sobol_owen(i, d, 9)), BOUNDS);
        let t = (0.3 - s.origin.y) / s.direction.y;
        let p = s.origin + s.direction * t;
        let inside = (p.x - 0.4).abs() < 0.5 && (p.z + 0.2).abs() < 0.5;
        if s.direction.y < 0.0 && t > 0.0 && inside { f64::from(s.flux.luminance()) } else { 0.0 }
    };
    close("window", (0..N).map(one).sum::<f64>() / f64::from(N), expected, 0.01);
}

/// Under the overcast sky of the CIE, L = L_z (1 + 2 sin elevation)/3 above the horizon, a meter reads 7π/9 L_z.
#[test]
fn an_overcast_sky() {
    let mut b = Build::default();
    let black = b.grey(0.0);
    b.quad(Vec3::new(-1.0, -0.5, -1.0), Vec3::Z * 2.0, Vec3::X * 2.0, black);
    let rows = 64;
    b.0.images.push(picture(2 * rows, rows, |_, y| {
        let cos = libm::cosf((y as f32 + 0.5) / rows as f32 * std::f32::consts::PI);
        [if cos > 0.0 { 900.0 * (1.0 + 2.0 * cos) / 3.0 } else { 0.0 }; 3]
    }));
    b.0.environment = Rgb::grey(1.0 / 9.0);
    b.0.environment_image = Some(0);
    let upward = [meter(Vec3::ZERO, Vec3::Y)];
    for parts in [FAST, ORACLE] {
        let draw = |seed| lux(&b.0, &upward, &settings(parts, 1 << 9, 1 << 9, seed), 8)[0];
        close_mean("overcast", 4, 700.0 * PI / 9.0, 0.005, draw);
    }
    // Seen directly.
    let up = view(Vec3::ZERO, Vec3::Y, 5.0, 1, 1);
    let zenith = render(&b.0, up, &settings(&["emission"], 64, 64, 0), 1)[0].luminance();
    close("zenith", zenith.into(), 100.0, 2e-3);
}

/// A panel of bytes that glows where its picture is white: half of its light, where the picture has it.
fn panel(b: &mut Build, corner: Vec3, along: Vec3, down: Vec3, pixels: Vec<[u8; 4]>, width: u32) -> u32 {
    let image = b.0.images.len() as u32;
    let height = pixels.len() as u32 / width;
    b.0.images.push(Image { name: String::new(), width, height, pixels: Pixels::Byte(pixels) });
    b.0.textures.push(Texture {
        image,
        encoding: Encoding::Srgb,
        wrap: [Wrap::Repeat; 2],
        filter: Filter::Nearest,
    });
    let glow = b.glow(20.0);
    let texture = b.0.textures.len() as u32 - 1;
    b.0.materials[glow as usize].maps.emission = Some(Map { texture, set: 0, transform: Affine2::IDENTITY });
    b.quad(corner, along, down, glow);
    b.0.meshes.last_mut().unwrap().uvs[0] = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    glow
}

/// Left half black, right half white, against a plain panel of half the size; by particles, points and paths.
#[test]
fn a_panel_glows_where_its_picture_does() {
    let mut b = Build::default();
    let half = vec![[0, 0, 0, 255], [255; 4]];
    panel(&mut b, Vec3::new(-1.0, 2.0, -0.5), Vec3::X * 2.0, Vec3::Z, half, 2);
    let mut plain = Build::default();
    let glow = plain.glow(20.0);
    plain.quad(Vec3::new(0.0, 2.0, -0.5), Vec3::X, Vec3::Z, glow);
    let power = b.0.summary().power_lm_front;
    close("lumens", power, PI * 20.0, 0.05);
    let desk = [meter(Vec3::new(0.3, 0.0, 0.2), Vec3::Y)];
    let expected = lux(&plain.0, &desk, &settings(FAST, 1 << 12, 1 << 12, 0), 8)[0];
    for parts in [FAST, ORACLE] {
        let draw = |seed| lux(&b.0, &desk, &settings(parts, 1 << 9, 1 << 9, seed), 8)[0];
        close_mean("half a panel", 4, expected, 0.01, draw);
    }
    let world = World::new(b.0);
    let (mut flux, n) = (0.0, 1 << 14);
    for i in 0..n {
        let u = [0, 1, 2, 3].map(|d| lampyris::sequence::sobol::sobol_owen(i, d, 9));
        let start = world.emitters()[0].emit(u, world.bounds());
        flux += f64::from(start.flux.luminance()) / f64::from(n);
        assert!(start.origin.x > 0.0 || start.flux.is_black());
    }
    close("particles", flux, PI * 20.0, 5e-3);
}

/// Floor, block and panel with holes under a picture with a sun: the parts add up to the path tracer.
#[test]
fn parts_add_up_under_pictures() {
    const SEEDS: u32 = 32;
    let mut b = Build::default();
    let ground = b.grey(0.5);
    let shiny = b.material(support::gloss(0.2, 0.4, 0.1), 0.0, lampyris::material::Sides::Both);
    b.quad(Vec3::new(-4.0, 0.0, -4.0), Vec3::Z * 8.0, Vec3::X * 8.0, ground);
    b.block(Vec3::new(-1.2, 0.0, -1.4), Vec3::new(-0.2, 1.2, -0.4), ground);
    b.block(Vec3::new(0.4, 0.0, -1.0), Vec3::new(1.2, 0.8, -0.3), shiny);
    let glowing = (0..16u32).map(|k| if k % 5 == 0 { [255, 200, 90, 255] } else { [20, 20, 20, 255] });
    let glow = panel(&mut b, Vec3::new(-1.0, 1.8, -1.0), Vec3::X * 1.5, Vec3::Z * 1.5, glowing.collect(), 4);
    b.0.materials[glow as usize].coverage = Coverage::Blend { factor: 0.6 };
    let image = b.0.images.len() as u32;
    b.0.images.push(picture(16, 8, |x, y| {
        if (x, y) == (5, 2) { [60.0, 50.0, 40.0] } else { [0.2, 0.3, 0.1 * y as f32] }
    }));
    b.0.environment_image = Some(image);
    b.0.environment = Rgb::WHITE;
    let camera = view(Vec3::new(0.3, 1.6, 2.4), Vec3::new(0.0, 0.6, -1.0), 60.0, 16, 12);
    let desks = [meter(Vec3::new(0.0, 0.5, 0.3), Vec3::Y), meter(Vec3::new(1.5, 1.0, 0.0), Vec3::NEG_X)];
    parts_equal_path(&b.0, &camera, &desks, SEEDS);
}
