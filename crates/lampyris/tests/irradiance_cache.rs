//! Irradiance interpolated between records, in place of a gather at each point: even light stays even, uneven light keeps its mean,
//! far fewer rays reach the same error, and nothing depends on threads or on which lamps are asked for.

mod support;

use glam::Vec3;
use lampyris::backend::{Backend, Batch, Gather, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::light::{Light, LightKind};
use lampyris::material::{Bsdf, Diffuse, Sides};
use lampyris::scene::{Camera, Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use lampyris::{Error, Rgb};
use support::{Build, diffuse, gloss, lux, meter, render, say, settings, view};

/// The final gather alone, by so many rays, interpolated or not.
fn gather(rays: u32, cache: Option<f32>, passes: u32) -> Settings {
    Settings {
        gather: Gather { rays, cache, paths: 1 << 14, ..Gather::default() },
        ..settings(&["final-gather"], 16, passes, 7)
    }
}

/// A room of 4 × 3 × 4 m with a block, a ball, a red wall and a varnished floor, and a panel under the ceiling.
fn room() -> Build {
    let mut b = Build::default();
    let (white, dark) = (b.grey(0.7), b.grey(0.3));
    let red = b.material(Bsdf::Diffuse(Diffuse::opaque(Rgb::new(0.6, 0.1, 0.05))), 0.0, Sides::Both);
    let floor = b.material(gloss(0.3, 0.05, 0.15), 0.0, Sides::Both);
    b.room(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 3.0, 2.0), [red, white, floor, white, white, dark]);
    b.block(Vec3::new(0.1, 0.0, -1.2), Vec3::new(1.1, 1.2, -0.2), white);
    b.sphere(Vec3::new(-0.9, 0.5, -0.6), 0.5, 3, false, |_| white);
    let lamp = b.glow(20.0);
    b.quad(Vec3::new(-0.5, 2.9, -0.5), Vec3::X, Vec3::Z, lamp);
    b
}

fn eye(width: u32, height: u32) -> Eye {
    view(Vec3::new(0.3, 1.6, 1.9), Vec3::new(0.0, 1.1, -1.0), 60.0, width, height)
}

/// Light of a picture, its root mean square difference from another one relative to that one's mean, and rays of a pixel.
fn compared(scene: &Scene, settings: &Settings, truth: &[Rgb]) -> [f64; 3] {
    let mut cpu = Cpu::new(None).expect("threads");
    cpu.begin(scene.clone(), eye(160, 120), settings).expect("sound settings");
    cpu.add(Batch { index: 0 }).expect("a batch");
    let picture = cpu.frame().expect("begun").mean();
    let luminance = |picture: &[Rgb]| picture.iter().map(|c| f64::from(c.luminance())).collect::<Vec<_>>();
    let (own, truth) = (luminance(&picture), luminance(truth));
    let mean = truth.iter().sum::<f64>() / truth.len() as f64;
    let square = own.iter().zip(&truth).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / truth.len() as f64;
    let rays = cpu.statistics().rays.gather as f64 / own.len() as f64;
    [own.iter().sum::<f64>() / own.len() as f64 / mean, square.sqrt() / mean, rays]
}

/// Walls that emit ¼ and reflect half reflect ⅛ of what others reflect: no record has a gradient but by noise, and no weight tells.
#[test]
fn a_furnace_is_even() {
    let mut b = Build::default();
    let wall = b.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    for accuracy in [0.1, 0.3, 1.0] {
        let eye = view(Vec3::splat(0.8), Vec3::splat(0.1), 60.0, 48, 36);
        let picture = render(&b.0, eye, &gather(16, Some(accuracy), 1), 4);
        let mean = picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>() / picture.len() as f64;
        let worst = picture.iter().map(|c| (c.luminance() - 0.125).abs()).fold(0.0, f32::max);
        say(format_args!("accuracy {accuracy}: {mean}, worst off by {worst}"));
        assert!((mean - 0.125).abs() < 6e-4, "{mean} to {accuracy}");
        assert!(worst < 0.006, "{worst} to {accuracy}");
    }
}

/// One coarse solution, seen by all points or by few: the plain gather reaches the error of the cache with more than ten times
/// its rays (21 to 31 times when this was written).
#[test]
fn fewer_rays_find_the_same_light() {
    let room = room();
    let truth = render(&room.0, eye(160, 120), &gather(256, None, 1), 1);
    let plain = compared(&room.0, &gather(16, None, 1), &truth);
    say(format_args!("plain: mean {:.4}, error {:.4}, {:.2} rays", plain[0], plain[1], plain[2]));
    for accuracy in [0.1, 0.2, 0.4] {
        let own = compared(&room.0, &gather(8, Some(accuracy), 1), &truth);
        // The error of plain gathering falls as the root of its rays.
        let saved = plain[2] * (plain[1] / own[1]).powi(2) / own[2];
        say(format_args!(
            "to {accuracy}: mean {:.4}, error {:.4}, {:.2} rays, {saved:.1} times fewer",
            own[0], own[1], own[2]
        ));
        assert!(own[1] < plain[1] && own[2] < plain[2] / 4.0, "{own:?} {plain:?}");
        assert!(saved > 10.0, "{saved} to {accuracy}");
    }
}

/// The mean over many batches: noise is gone, what is left is the interpolation's.
#[test]
fn the_mean_is_that_of_the_plain_gather() {
    let room = room();
    let mean = |cache| {
        let picture = render(&room.0, eye(64, 48), &gather(32, cache, 2), 16);
        picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>() / picture.len() as f64
    };
    let truth = mean(None);
    for accuracy in [0.1, 0.2] {
        let off = mean(Some(accuracy)) / truth - 1.0;
        say(format_args!("to {accuracy}: {:+.2} %", 100.0 * off));
        assert!(off.abs() < 0.01, "{off} to {accuracy}");
    }
}

/// Meters shall not interpolate: the same bits with and without.
#[test]
fn meters_gather_plainly() {
    let room = room();
    let at: Vec<_> = (0..20).map(|k| meter(Vec3::new(0.15 * k as f32 - 1.5, 0.8, 1.0), Vec3::Y)).collect();
    let [plain, cached] = [None, Some(0.5)].map(|cache| lux(&room.0, &at, &gather(16, cache, 2), 2));
    assert!(plain.iter().all(|lux| *lux > 0.0));
    assert_eq!(plain, cached);
}

/// Every bit, whatever the threads; and there are records.
#[test]
fn any_number_of_threads() {
    let room = room();
    let shown = Settings {
        gather: gather(4, Some(0.3), 1).gather,
        parts: vec!["final-gather".into()],
        ..Settings::interactive()
    };
    for settings in [gather(4, Some(0.2), 2), shown] {
        let bits = |threads: usize| {
            let mut cpu = Cpu::new(Some(threads)).expect("threads");
            cpu.begin(room.0.clone(), eye(77, 53), &settings).expect("sound settings");
            (0..3).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
            assert!(cpu.statistics().records > 30, "{:?}", cpu.statistics());
            let frame = cpu.frame().expect("begun");
            let all = [frame.mean(), frame.shown()].concat();
            all.iter().flat_map(|v| v.to_array().map(f32::to_bits)).collect::<Vec<_>>()
        };
        let one = bits(1);
        assert!(one.iter().any(|b| *b != 0), "a black picture proves nothing");
        for threads in [1, 2, 3, 7] {
            assert!(one == bits(threads), "{threads} threads");
        }
    }
}

/// Three lamps in a group each: their layers add up to the whole, and when one moves the others' keep their bits while its own
/// are those of a scene that was always so.
#[test]
fn lamps_leave_each_other_alone() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall; 6]);
    b.block(Vec3::new(0.5, 0.0, 0.5), Vec3::new(1.0, 0.6, 1.0), wall);
    for (k, color) in (0..).zip([Rgb::new(5.0, 1.0, 0.0), Rgb::grey(2.0), Rgb::new(0.0, 0.0, 4.0)]) {
        let kind = LightKind::Point { position: Vec3::new(0.4 + 0.6 * k as f32, 1.7, 0.9), intensity: color };
        b.0.lights.push(Light::new(format!("lamp {k}"), kind));
    }
    let (from, target) = (Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3));
    b.0.view = Some(Camera { name: String::new(), eye: from, target, up: Vec3::Y, fov_y: 70.0 });
    let mut world = World::new(b.0);
    world.separate(16).expect("sound");
    let scene = world.scene().clone();
    let open = |scene| {
        let mut session = Session::open(scene, [60, 40], &gather(8, Some(0.2), 1), Some(2)).expect("a view");
        session.settle(4).expect("batches");
        session
    };
    let layers = |session: &mut Session| {
        (0..3).map(|k| session.frame().expect("open").layer(k).expect("a layer")).collect::<Vec<_>>()
    };
    let mut session = open(scene.clone());
    let (before, whole) = (layers(&mut session), session.frame().expect("open").mean());
    let most = whole.iter().map(|v| v.max_channel()).fold(0.0, f32::max);
    for (k, whole) in whole.iter().enumerate() {
        let sum = before.iter().fold(Rgb::BLACK, |sum, layer| sum + layer[k]);
        assert!((sum - *whole).map(f32::abs).max_channel() < 1e-5 * most, "pixel {k}: {sum:?} for {whole:?}");
    }
    let kind = LightKind::Point { position: Vec3::new(1.0, 1.2, 0.3), intensity: Rgb::grey(2.0) };
    session.edit(&Edit::Light { light: 1, kind }).expect("a sound edit");
    session.settle(4).expect("batches");
    let edited = session.scene().expect("open").clone();
    let (after, fresh) = (layers(&mut session), layers(&mut open(edited)));
    assert_eq!(after, fresh);
    assert!(before[1] != after[1] && before[0] == after[0] && before[2] == after[2]);
}

#[test]
fn accuracies_that_make_no_sense_are_refused() {
    for accuracy in [0.0, -0.1, 1.01, f32::NAN, f32::INFINITY] {
        let refused = gather(16, Some(accuracy), 1).check();
        assert!(matches!(refused, Err(Error::BadSetting(why)) if why.contains("accuracy")), "{accuracy}");
    }
    assert!([1e-3, 1.0].iter().all(|a| gather(16, Some(*a), 1).check().is_ok()));
}
