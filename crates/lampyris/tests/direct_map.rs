//! Direct light by shadow photons: where they are sure it is that of *direct* to the bit, without a ray; where they are not, rays
//! tell; and where lamps are seen in part, few are sure and wrong.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::import::{self, Options};
use lampyris::integrator::select;
use lampyris::light::LightKind;
use lampyris::scene::{Camera, Edit, Scene, View};
use std::path::Path;
use support::{Build, say, settings, view};

/// A picture, the shadow rays of its points and those of its light.
fn draw(scene: &Scene, eye: &Eye, settings: &Settings) -> (Vec<Rgb>, u64, u64) {
    let mut cpu = Cpu::new(None).expect("threads");
    cpu.begin(scene.clone(), eye.clone(), settings).expect("sound settings");
    (0..4).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    let rays = cpu.statistics().rays;
    (cpu.frame().expect("begun").mean(), rays.shadow, rays.particle)
}

fn by(part: &str) -> Settings {
    settings(&[part], 16, 4, 1)
}

/// A bulb over a floor and a plate between, whose shadow on the floor is two metres wide.
fn plate() -> Build {
    let mut b = Build::default();
    let grey = b.grey(0.5);
    b.quad(Vec3::new(-4.0, 0.0, -4.0), Vec3::Z * 8.0, Vec3::X * 8.0, grey);
    b.quad(Vec3::new(-0.5, 1.0, -0.5), Vec3::Z, Vec3::X, grey);
    b.bulb(Vec3::new(0.0, 2.0, 0.0), 1000.0);
    b
}

/// Wholly in the light, and wholly in the shadow, no ray is traced for a lamp that photons know; the light is the same to the
/// bit. Across the edge of the shadow rays are.
#[test]
fn who_is_sure_asks_for_no_ray() {
    let b = plate();
    for (target, sure) in
        [(Vec3::new(2.0, 0.0, 0.0), 1.0), (Vec3::ZERO, 1.0), (Vec3::new(1.0, 0.0, 0.0), 0.75)]
    {
        let eye = view(target + Vec3::new(0.0, 0.6, 0.01), target, 40.0, 32, 24);
        let (truth, all, walked) = draw(&b.0, &eye, &by("direct"));
        let (own, asked, shot) = draw(&b.0, &eye, &by("direct-map"));
        assert!(all > 10_000 && shot > walked + (1 << 20), "{all}, {shot}");
        let saved = 1.0 - asked as f64 / all as f64;
        say(format_args!("{target}: {asked} of {all} shadow rays, {saved:.3} saved"));
        if sure == 1.0 {
            assert_eq!((own, asked), (truth, 0), "{target}");
        } else {
            assert!((sure - 0.15..sure + 0.15).contains(&saved), "{saved} saved at the edge");
        }
    }
}

fn shipped(name: &str, camera: Camera) -> (Scene, Eye) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name);
    let scene = import::load(&file, &Options::default()).expect("readable").scene;
    (scene, Eye::Camera(View::new(&camera, 96, 64)))
}

/// The Cornell box and the office: the mean of *direct* to 0.1 %, pixels to 1 % of the mean in the mean square, by so many of its
/// shadow rays. The panels of the office lie 4 cm deep in the ceiling: hardly a point sees one whole, and photons say so.
#[test]
fn rooms_are_lit_as_by_rays() {
    let name = String::new;
    let (eye, target, up) = (Vec3::new(2.78, 2.73, -8.0), Vec3::new(2.78, 2.73, 0.0), Vec3::Y);
    let cornell = shipped("cornell.mgf", Camera { name: name(), eye, target, up, fov_y: 39.3 });
    let (eye, target, up) = (Vec3::new(0.35, 0.35, 1.5), Vec3::new(4.05, 3.7, 0.9), Vec3::Z);
    let office = shipped("office.mgf", Camera { name: name(), eye, target, up, fov_y: 55.0 });
    for ((scene, eye), most) in [(cornell, 0.2), (office, 0.92)] {
        let (truth, all, _) = draw(&scene, &eye, &by("direct"));
        let (own, asked, _) = draw(&scene, &eye, &by("direct-map"));
        let sum = |p: &[Rgb]| p.iter().map(|c| f64::from(c.luminance())).sum::<f64>();
        let mean = sum(&truth) / truth.len() as f64;
        let squares = own.iter().zip(&truth).map(|(a, b)| f64::from((*a - *b).luminance()).powi(2));
        let rms = (squares.sum::<f64>() / own.len() as f64).sqrt() / mean;
        let (off, share) = (sum(&own) / sum(&truth) - 1.0, asked as f64 / all as f64);
        say(format_args!(
            "{share:.3} of the shadow rays, mean {:+.4} %, pixels {:.3} %",
            100.0 * off,
            100.0 * rms
        ));
        assert!(off.abs() < 1e-3 && rms < 0.01 && share < most, "{off}, {rms}, {share}");
    }
}

/// A lamp that moves takes its photons along: the picture after the edit is one begun anew, to the bit.
#[test]
fn shadow_follows_a_lamp() {
    let eye = view(Vec3::new(0.5, 3.0, 3.0), Vec3::ZERO, 60.0, 24, 16);
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    cpu.begin(plate().0, eye.clone(), &by("direct-map")).expect("sound");
    cpu.add(Batch { index: 0 }).expect("a batch");
    let before = cpu.frame().expect("begun").mean();
    let kind = LightKind::Point { position: Vec3::new(0.8, 1.7, 0.3), intensity: Rgb::grey(60.0) };
    let changes = cpu.edit(&Edit::Light { light: 0, kind }).expect("a sound edit");
    assert!(!changes.restarts_all());
    (0..4).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    let after = cpu.frame().expect("begun").mean();
    let scene = cpu.world().expect("begun").scene().clone();
    assert_eq!(after, draw(&scene, &eye, &by("direct-map")).0);
    assert!(after != before);
}

/// It has the paths of *direct*, and stands in its place.
#[test]
fn no_light_is_counted_twice() {
    for part in ["direct", "path"] {
        let refused = select(&["direct-map", part]).err();
        assert!(refused.is_some_and(|why| why.to_string().contains(part)), "{part}");
    }
    assert!(select(&["emission", "direct-map", "vpl", "compensation", "mirror", "caustic"]).is_ok());
}
