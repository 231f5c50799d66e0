//! The parts sum to the oracle: fast parts and path tracer agree scene by scene, tile by tile, by Welch's t-test over
//! independent seeds at a common level of 1 % (Šidák over the tiles and meters of all scenes). Caustics are the oracle's
//! here, since a photon's kernel reaches over edges; what photons carry, tests/photons.rs asserts.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::eye::Eye;
use lampyris::light::{Beam, LightKind};
use lampyris::material::{Bsdf, Dielectric, Diffuse, Pbr, Sides};
use lampyris::testing::{Moments, sidak};
use support::{Build, ORACLE, UNBIASED, diffuse, glass, gloss, meter, render, say, settings, view};

/// Seeds of each side.
const SEEDS: u32 = 16;
/// Pixels of a picture, width and height, and of the square tiles that are compared.
const SIZE: [u32; 2] = [16, 12];
const TILE: u32 = 4;
/// Tests of one scene: tiles, meters, and the whole picture.
const TESTS: usize = 12 + 2 + 1;
/// Scenes in this file.
const SCENES: usize = 15;

/// Sums over tiles of the camera's picture, then the meters, then the sum of the picture.
fn observe(scene: &Build, eye: &Eye, meters: &Eye, s: &Settings, batches: u32) -> Vec<f64> {
    let picture = render(&scene.0, eye.clone(), s, batches);
    let mut all = Vec::new();
    for ty in (0..SIZE[1]).step_by(TILE as usize) {
        for tx in (0..SIZE[0]).step_by(TILE as usize) {
            let inside = (0..TILE * TILE).map(|k| (ty + k / TILE) * SIZE[0] + tx + k % TILE);
            all.push(inside.map(|k| f64::from(picture[k as usize].luminance())).sum::<f64>());
        }
    }
    let e = render(&scene.0, meters.clone(), s, batches);
    all.extend(e.iter().map(|v| f64::from(v.luminance())));
    all.push(all[..12].iter().sum());
    all
}

/// The same parts by interleaved pixels, of which packets pick among the virtual lights of their class.
fn in_classes(fast: &Settings) -> Settings {
    Settings {
        paths: 16 * fast.paths,
        passes: Some(fast.eye_passes()),
        interleave: [4, 3],
        light_points: Some(8 * fast.paths),
        picks: Some(5),
        ..fast.clone()
    }
}

/// All three sides of the equation over all seeds: the parts, the same in classes, and the oracle. The least p must not be
/// improbable, the noise must be small.
fn compare(name: &str, scene: &Build, [eye, target]: [Vec3; 2], fast: Settings, oracle: Settings) {
    let camera = view(eye, target, 60.0, SIZE[0], SIZE[1]);
    let meters = Eye::Meters(vec![
        meter(0.5 * (eye + target), Vec3::Y),
        meter(eye.lerp(target, 0.7), Vec3::new(0.6, -0.8, 0.0)),
    ]);
    let mut sides = [(); 3].map(|()| vec![Moments::default(); TESTS]);
    for seed in 0..SEEDS {
        for ((side, s), k) in sides.iter_mut().zip([&fast, &in_classes(&fast), &oracle]).zip(0..) {
            // No number serves two sides.
            let s = Settings { seed: 3 * seed + k, ..s.clone() };
            let all = observe(scene, &camera, &meters, &s, 4);
            side.iter_mut().zip(all).for_each(|(m, v)| m.push(v));
        }
    }
    let [a, classes, b] = &sides;
    let against = |a: &[Moments]| a.iter().zip(b).map(|(a, b)| a.p_value_against(b)).fold(1.0, f64::min);
    let (least, least_in_classes) = (against(a), against(classes));
    let noise =
        |m: &[Moments]| m.iter().map(|m| m.standard_error() / m.mean().abs().max(1e-9)).fold(0.0, f64::max);
    let (whole, truth) = (a[TESTS - 1], b[TESTS - 1]);
    say(format_args!(
        "{name}: fast/path {:+.2e} ± {:.1e}, least p {least:.4}, in classes {least_in_classes:.4}; noisiest test ± {:.1e} fast, {:.1e} in classes, {:.1e} path",
        whole.mean() / truth.mean() - 1.0,
        (whole.standard_error().powi(2) + truth.standard_error().powi(2)).sqrt() / truth.mean(),
        noise(a),
        noise(classes),
        noise(b)
    ));
    let least = least.min(least_in_classes);
    assert!(least > sidak(0.01, 2 * TESTS * SCENES), "{name}: p = {least}");
    let noisiest = [a, classes, b].into_iter().map(|side| noise(side)).fold(0.0, f64::max);
    assert!(noisiest < 0.1, "{name}: too noisy to tell anything");
}

fn usual() -> (Settings, Settings) {
    (settings(UNBIASED, 1 << 8, 1 << 5, 0), settings(ORACLE, 1, 1 << 6, 0))
}

/// A room of 4 × 3 × 4 m.
fn room(b: &mut Build, materials: [u32; 6]) {
    b.room(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 3.0, 2.0), materials);
}

/// An area light that shines down from `center`.
fn panel(b: &mut Build, center: Vec3, side: f32, radiance: f32) {
    let glow = b.glow(radiance);
    let corner = center - Vec3::new(0.5 * side, 0.0, 0.5 * side);
    b.quad(corner, Vec3::X * side, Vec3::Z * side, glow);
}

fn coloured(r: f32, g: f32, b: f32) -> Bsdf {
    Bsdf::Diffuse(Diffuse::opaque(Rgb::new(r, g, b)))
}

/// From near one wall toward the other, a little down.
const ACROSS: [Vec3; 2] = [Vec3::new(0.3, 1.6, 1.9), Vec3::new(0.0, 1.1, -1.0)];

#[test]
fn coloured_box_with_blocks() {
    let mut b = Build::default();
    let white = b.grey(0.75);
    let red = b.material(coloured(0.6, 0.06, 0.05), 0.0, Sides::Both);
    let green = b.material(coloured(0.12, 0.45, 0.1), 0.0, Sides::Both);
    room(&mut b, [red, green, white, white, white, white]);
    b.block(Vec3::new(-1.2, 0.0, -1.4), Vec3::new(-0.2, 1.8, -0.4), white);
    b.block(Vec3::new(0.3, 0.0, -0.6), Vec3::new(1.2, 0.9, 0.3), white);
    panel(&mut b, Vec3::new(0.0, 2.95, 0.0), 1.0, 10.0);
    let (fast, oracle) = usual();
    compare("coloured box", &b, ACROSS, fast, oracle);
}

#[test]
fn closed_cube() {
    let mut b = Build::default();
    let wall = b.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    let (fast, oracle) = usual();
    compare("closed cube", &b, [Vec3::splat(0.8), Vec3::splat(0.1)], fast, oracle);
}

/// Polish just below the threshold is seen by the eye path, gloss just above it by light points.
#[test]
fn gloss_on_both_sides_of_the_threshold() {
    for alpha in [0.14, 0.16] {
        let mut b = Build::default();
        let wall = b.grey(0.5);
        let floor = b.material(gloss(0.3, 0.3, alpha), 0.0, Sides::Both);
        let ball = b.material(gloss(0.2, 0.5, alpha), 0.0, Sides::Both);
        room(&mut b, [wall, wall, floor, wall, wall, wall]);
        b.sphere(Vec3::new(-0.6, 0.7, -0.8), 0.6, 2, false, |_| ball);
        panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 1.2, 10.0);
        let (fast, oracle) = usual();
        compare(&format!("gloss {alpha}"), &b, ACROSS, fast, oracle);
    }
}

/// A mirror wall and a glass ball under a large panel: emission over S*, and caustics.
#[test]
fn mirror_and_glass() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    let clear = b.material(glass(), 0.0, Sides::Both);
    room(&mut b, [mirror, wall, wall, wall, wall, wall]);
    b.sphere(Vec3::new(0.4, 0.8, -0.6), 0.6, 3, false, |_| clear);
    panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 2.5, 10.0);
    compare(
        "mirror and glass",
        &b,
        ACROSS,
        settings(UNBIASED, 1 << 8, 1 << 6, 0),
        settings(ORACLE, 1, 1 << 7, 0),
    );
}

/// A mirror for one wall, and a body close to it, whose light the clamp takes on both ways.
#[test]
fn mirror_wall() {
    let mut b = Build::default();
    let white = b.grey(0.75);
    let red = b.material(coloured(0.6, 0.06, 0.05), 0.0, Sides::Both);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    room(&mut b, [red, white, white, white, mirror, white]);
    b.block(Vec3::new(-1.2, 0.0, -1.95), Vec3::new(-0.2, 1.5, -1.0), white);
    panel(&mut b, Vec3::new(0.0, 2.9, -0.5), 1.5, 10.0);
    let (fast, oracle) = usual();
    compare("mirror wall", &b, ACROSS, fast, oracle);
}

/// Mirrors that face each other: one reflection is the part *mirror*, more of them are *caustic*.
#[test]
fn facing_mirrors() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let mirror = b.material(gloss(0.0, 0.8, 0.0), 0.0, Sides::Both);
    room(&mut b, [mirror, mirror, wall, wall, wall, wall]);
    panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 2.5, 10.0);
    let (_, oracle) = usual();
    compare("facing mirrors", &b, ACROSS, settings(UNBIASED, 1 << 8, 1 << 6, 0), oracle);
}

/// A varnished floor that is wall and mirror at once, a mirror in the room, a glass ball, gloss and polish.
#[test]
fn mirrors_glass_and_gloss() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let varnish = b.material(gloss(0.4, 0.2, 0.0), 0.0, Sides::Both);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    let glossy = b.material(gloss(0.3, 0.3, 0.2), 0.0, Sides::Both);
    let polish = b.material(gloss(0.2, 0.5, 0.1), 0.0, Sides::Both);
    let clear = b.material(glass(), 0.0, Sides::Both);
    room(&mut b, [glossy, wall, varnish, wall, wall, wall]);
    b.quad(Vec3::new(-1.0, 0.2, -1.5), Vec3::X * 1.5, Vec3::new(0.0, 1.8, -0.3), mirror);
    b.sphere(Vec3::new(0.8, 0.7, -0.6), 0.5, 3, false, |_| clear);
    b.block(Vec3::new(-1.5, 0.0, -0.8), Vec3::new(-0.9, 0.9, -0.2), polish);
    panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 2.5, 10.0);
    compare(
        "mirrors, glass and gloss",
        &b,
        ACROSS,
        settings(UNBIASED, 1 << 8, 1 << 6, 0),
        settings(ORACLE, 1, 1 << 7, 0),
    );
}

/// A panel that glows on both sides 1 mm under the ceiling: half of its light is in the slot.
#[test]
fn two_sided_panel_close_to_the_ceiling() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    room(&mut b, [wall; 6]);
    let glow = b.material(diffuse(0.3), 10.0, Sides::Both);
    b.quad(Vec3::new(-0.6, 2.999, -0.6), Vec3::X * 1.2, Vec3::Z * 1.2, glow);
    let (fast, oracle) = usual();
    compare("panel in a slot", &b, ACROSS, fast, oracle);
}

/// A sphere, a disc, a spot and a point, all at once; diffuse, for caustics of the last two cannot be found.
#[test]
fn lamps_of_every_kind() {
    let mut b = Build::default();
    let wall = b.grey(0.6);
    room(&mut b, [wall; 6]);
    b.block(Vec3::new(-1.2, 0.0, -1.4), Vec3::new(-0.2, 1.2, -0.4), wall);
    b.light(LightKind::Sphere { center: Vec3::new(1.0, 2.0, -1.0), radius: 0.2, radiance: Rgb::grey(20.0) });
    b.light(LightKind::Disc {
        center: Vec3::new(-1.0, 2.8, 0.5),
        normal: Vec3::NEG_Y,
        radius: 0.4,
        radiance: Rgb::grey(8.0),
    });
    b.light(LightKind::Spot {
        position: Vec3::new(0.0, 2.9, 0.0),
        direction: Vec3::new(0.0, -0.8, -0.6),
        intensity: Rgb::grey(5.0),
        beam: Beam::Cone { cos_inner: 0.95, cos_outer: 0.8 },
    });
    b.bulb(Vec3::new(-1.5, 0.5, 1.0), 20.0);
    let (fast, oracle) = usual();
    compare("lamps", &b, ACROSS, fast, oracle);
}

/// Coarse balls with smooth normals, diffuse and glossy: shading normals bend both adjoints.
#[test]
fn smooth_normals() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let dull = b.grey(0.8);
    let shiny = b.material(gloss(0.3, 0.4, 0.2), 0.0, Sides::Both);
    room(&mut b, [wall; 6]);
    for (center, material) in [(Vec3::new(-0.7, 0.8, -0.7), dull), (Vec3::new(0.8, 0.7, -0.3), shiny)] {
        let mesh = b.sphere(center, 0.6, 1, false, |_| material);
        mesh.normals = mesh.positions.iter().map(|p| (*p - center).normalize()).collect();
    }
    panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 1.2, 10.0);
    let (fast, oracle) = usual();
    compare("smooth normals", &b, ACROSS, fast, oracle);
}

/// A lamp in a shade that lets half of the light through, diffusely.
#[test]
fn translucent_shade() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    let shade = Diffuse { reflectance: Rgb::grey(0.3), transmittance: Rgb::grey(0.5) };
    let shade = b.material(Bsdf::Diffuse(shade), 0.0, Sides::Both);
    room(&mut b, [wall; 6]);
    b.block(Vec3::new(-0.4, 1.4, -1.0), Vec3::new(0.4, 2.2, -0.2), shade);
    b.light(LightKind::Sphere { center: Vec3::new(0.0, 1.8, -0.6), radius: 0.15, radiance: Rgb::grey(40.0) });
    let (fast, oracle) = usual();
    compare("translucent shade", &b, ACROSS, fast, oracle);
}

/// Open to the sky: two bodies on a floor.
#[test]
fn under_the_sky() {
    let mut b = Build(lampyris::scene::Scene { environment: Rgb::grey(1.0), ..Default::default() });
    let ground = b.grey(0.4);
    let shiny = b.material(gloss(0.2, 0.4, 0.05), 0.0, Sides::Both);
    b.quad(Vec3::new(-4.0, 0.0, -4.0), Vec3::Z * 8.0, Vec3::X * 8.0, ground);
    b.block(Vec3::new(-1.2, 0.0, -1.4), Vec3::new(-0.2, 1.2, -0.4), ground);
    b.sphere(Vec3::new(0.8, 0.6, -0.5), 0.6, 2, false, |_| shiny);
    let (fast, oracle) = usual();
    compare("sky", &b, ACROSS, fast, oracle);
}

/// Metal, plastic and a frosted pane, dull and sharp.
#[test]
fn surfaces_of_gltf() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    room(&mut b, [wall; 6]);
    let mut pbr = |metallic: f32, transmission: f32, roughness: f32| {
        let base_color = Rgb::new(0.9, 0.7, 0.4);
        let surface = Pbr { base_color, metallic, transmission, roughness, ..Pbr::default() };
        b.material(Bsdf::Pbr(surface), 0.0, Sides::Both)
    };
    let (metal, plastic) = (pbr(1.0, 0.0, 0.6), pbr(0.0, 0.0, 0.5));
    let (polished, frosted) = (pbr(0.0, 0.0, 0.3), pbr(0.0, 0.8, 0.65));
    b.block(Vec3::new(-1.4, 0.0, -1.4), Vec3::new(-0.5, 1.2, -0.5), metal);
    b.block(Vec3::new(0.4, 0.0, -0.6), Vec3::new(1.2, 0.9, 0.2), plastic);
    b.block(Vec3::new(0.5, 0.9, -0.5), Vec3::new(1.1, 1.3, 0.1), polished);
    b.quad(Vec3::new(-0.8, 0.2, 0.3), Vec3::new(0.9, 0.0, 0.2), Vec3::Y * 1.5, frosted);
    panel(&mut b, Vec3::new(0.0, 2.9, 0.0), 1.4, 10.0);
    let (fast, oracle) = usual();
    compare("surfaces of glTF", &b, ACROSS, fast, oracle);
}

/// A block of rough glass that absorbs, with a lamp behind it, and a ball cast into it.
#[test]
fn body_of_rough_glass() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    room(&mut b, [wall; 6]);
    let attenuation = Rgb::new(0.3, 0.8, 2.0);
    let body = Dielectric { alpha: 0.6, attenuation, ..Dielectric::new(1.5, Rgb::grey(0.95)) };
    let rough = b.material(Bsdf::Dielectric(body), 0.0, Sides::Both);
    b.block(Vec3::new(-1.7, 0.01, -1.4), Vec3::new(-0.3, 1.6, -0.2), rough);
    b.sphere(Vec3::new(-1.0, 0.8, -0.7), 0.3, 2, false, |_| wall);
    panel(&mut b, Vec3::new(0.0, 2.9, -0.4), 1.4, 10.0);
    let (fast, oracle) = (settings(UNBIASED, 1 << 9, 1 << 6, 0), settings(ORACLE, 1, 1 << 6, 0));
    compare("body of rough glass", &b, ACROSS, fast, oracle);
}
