//! Scenes in which there is nothing, or nothing sensible, to see: a black picture, no panic, and no estimate that is not
//! a number.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Batch, Settings};
use lampyris::eye::Eye;
use lampyris::light::{Beam, LightKind};
use lampyris::material::Sides;
use lampyris::particle::{Plan, Walk};
use lampyris::world::World;
use support::{Build, FAST, ORACLE, diffuse, glass, meter, render, settings, view};

fn eyes() -> [Eye; 2] {
    let camera = view(Vec3::new(0.5, 0.4, 0.9), Vec3::new(0.5, 0.5, 0.0), 60.0, 5, 5);
    [camera, Eye::Meters(vec![meter(Vec3::splat(0.5), Vec3::Y), meter(Vec3::new(0.1, 0.0, 0.1), Vec3::Y)])]
}

fn both() -> [Settings; 2] {
    [settings(FAST, 16, 4, 1), settings(ORACLE, 4, 4, 1)]
}

/// Renders by both; `render` itself asserts that no estimate was left out.
fn pictures(scene: &Build) -> Vec<Rgb> {
    let mut all = Vec::new();
    for eye in eyes() {
        for s in both() {
            all.extend(render(&scene.0, eye.clone(), &s, 2));
        }
    }
    assert!(all.iter().all(|v| v.is_finite()), "a picture with holes");
    all
}

fn black(what: &str, scene: &Build) {
    assert!(pictures(scene).iter().all(|v| v.is_black()), "{what} is not black");
}

fn room(rho: f32, emission: f32) -> Build {
    let mut b = Build::default();
    let wall = b.material(diffuse(rho), emission, Sides::EmitFront);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    b
}

#[test]
fn nothing_shines() {
    black("nothing", &Build::default());
    black("a room", &room(0.5, 0.0));
    let mut b = Build::default();
    b.mesh(Vec::new(), Vec::new(), Vec::new());
    black("an empty mesh", &b);
    let mut b = room(0.5, 0.0);
    b.bulb(Vec3::splat(0.5), 0.0);
    b.light(LightKind::Sphere { center: Vec3::splat(0.3), radius: 0.1, radiance: Rgb::BLACK });
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::BLACK });
    black("dark lamps", &b);
}

/// A lamp outside a closed room of opaque walls lights nothing in it.
#[test]
fn lights_outside() {
    let mut b = room(0.5, 0.0);
    b.bulb(Vec3::splat(3.0), 1000.0);
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::WHITE });
    b.0.environment = Rgb::WHITE;
    black("a closed room", &b);
}

/// Lamps without anything to light: the camera sees none of them, the meters see them all.
#[test]
fn lights_without_geometry() {
    let mut b = Build::default();
    b.light(LightKind::Point { position: Vec3::new(0.5, 1.5, 0.5), intensity: Rgb::grey(2.0) });
    let s = settings(FAST, 16, 4, 1);
    for s in [s, settings(ORACLE, 4, 4, 1)] {
        let [camera, meters] = eyes();
        assert!(render(&b.0, camera, &s, 1).iter().all(|v| v.is_black()));
        // E = 2 cd / 1 m².
        let e = render(&b.0, meters, &s, 1)[0].luminance() * std::f32::consts::PI;
        assert!((e - 2.0).abs() < 1e-5, "{e}");
    }
}

/// The sky over nothing: radiance L to the camera, E = πL to a meter.
#[test]
fn sky_without_geometry() {
    let b = Build(lampyris::scene::Scene { environment: Rgb::WHITE, ..Default::default() });
    for s in [settings(FAST, 4096, 4, 1), settings(ORACLE, 1, 1024, 1)] {
        for eye in eyes() {
            for v in render(&b.0, eye, &s, 4) {
                assert!((v.luminance() - 1.0).abs() < 2e-2, "{v:?} by {:?}", s.parts);
            }
        }
    }
}

/// An eye in a wall, on it, in a solid, or nowhere: any picture will do, if it is one.
#[test]
fn eyes_in_walls() {
    let mut b = room(0.5, 1.0);
    let clear = b.material(glass(), 0.0, Sides::Both);
    b.block(Vec3::splat(0.4), Vec3::splat(0.6), clear);
    let places =
        [Vec3::ZERO, Vec3::new(0.5, 0.0, 0.5), Vec3::splat(0.5), Vec3::splat(-1.0), Vec3::splat(0.4)];
    for place in places {
        for s in both() {
            let camera = view(place, place + Vec3::new(0.3, 0.2, 0.9), 60.0, 5, 5);
            for eye in [camera, Eye::Meters(vec![meter(place, Vec3::Y)])] {
                assert!(render(&b.0, eye, &s, 2).iter().all(|v| v.is_finite()), "{place}");
            }
        }
    }
    for place in [Vec3::NAN, Vec3::INFINITY, Vec3::splat(1e30)] {
        for s in both() {
            let camera = view(place, Vec3::ZERO, 60.0, 5, 5);
            for eye in [camera, Eye::Meters(vec![meter(place, Vec3::Y), meter(Vec3::ZERO, Vec3::NAN)])] {
                assert!(render(&b.0, eye, &s, 1).iter().all(|v| v.is_finite()), "{place}");
            }
        }
    }
}

/// Lamps where a number is missing, or of no size: what remains is lit, nothing is poisoned.
#[test]
fn lamps_of_nonsense() {
    let nonsense = [
        LightKind::Point { position: Vec3::NAN, intensity: Rgb::WHITE },
        LightKind::Point { position: Vec3::splat(0.5), intensity: Rgb::grey(f32::NAN) },
        LightKind::Point { position: Vec3::splat(0.5), intensity: Rgb::grey(f32::INFINITY) },
        LightKind::Sphere { center: Vec3::splat(0.5), radius: 0.0, radiance: Rgb::WHITE },
        LightKind::Disc { center: Vec3::splat(0.5), normal: Vec3::ZERO, radius: 0.2, radiance: Rgb::WHITE },
        LightKind::Directional { direction: Vec3::ZERO, illuminance: Rgb::WHITE },
        LightKind::Spot {
            position: Vec3::splat(0.5),
            direction: Vec3::ZERO,
            intensity: Rgb::WHITE,
            beam: Beam::Cone { cos_inner: 0.5, cos_outer: 0.5 },
        },
    ];
    for kind in nonsense {
        let what = format!("{kind:?}");
        let mut b = room(0.5, 0.25);
        b.light(kind);
        for v in pictures(&b) {
            assert!(v.luminance() > 0.1, "{what}: {v:?} where the walls alone give one half");
        }
    }
}

/// Triangles without area, with missing numbers, with corners in one place; reflectances of 0, 1 and more.
#[test]
fn surfaces_of_nonsense() {
    let mut b = room(0.5, 0.25);
    let glow = b.glow(1.0);
    let far = Vec3::new(f32::NAN, 0.0, 0.0);
    b.mesh(
        vec![Vec3::ZERO, Vec3::X, Vec3::X * 0.5, far],
        vec![[0, 1, 2], [0, 0, 0], [0, 1, 3]],
        vec![glow; 3],
    );
    pictures(&b);
    for rho in [0.0, 1.0] {
        pictures(&room(rho, 1.0));
    }
}

/// The power of lamps may lie beyond all numbers; how many particles leave them may not.
#[test]
fn blinding_lights_are_given_their_share_of_the_paths() {
    let mut b = room(0.5, f32::MAX);
    b.bulb(Vec3::splat(0.5), f32::MAX);
    let world = World::new(b.0);
    let shares: f32 = world.shares().iter().sum();
    assert!((shares - 1.0).abs() < 1e-5, "{:?}", world.shares());
    let settings = settings(FAST, 16, 4, 1);
    let walk = Walk::new(&world, &settings, &Plan::new(&world, &settings), Batch { index: 0 });
    let most = 16 + world.emitters().len();
    assert!(walk.lights.len() <= most, "{} lights for 16 paths", walk.lights.len());
}
