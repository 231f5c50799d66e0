//! The window of a walkthrough: what is shown is the mean of the last N batches, each of the scene as it was then; nothing
//! of it is in the sums, and nothing of it is left where one looks from elsewhere or asks for the picture of n batches.

mod stage;

use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::light::{Light, LightKind};
use lampyris::scene::{Camera, Edit, Scene, View};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{Build, FAST, settings};

const SIZE: [u32; 2] = [16, 12];

fn shown(window: u32) -> Settings {
    Settings { interleave: [2, 2], filter: true, window, photons: 100, ..settings(FAST, 24, 1, 1) }
}

/// A grey room with a ball in it and two lamps.
fn room() -> Scene {
    let mut b = Build(Scene::default());
    let (wall, red) = (b.grey(0.5), b.grey(0.2));
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall; 6]);
    b.quad(Vec3::new(0.6, 0.6, 0.6), Vec3::X * 0.5, Vec3::Y * 0.5, red);
    for at in [Vec3::new(0.5, 1.7, 0.6), Vec3::new(1.4, 1.6, 1.2)] {
        let kind = LightKind::Point { position: at, intensity: Rgb::grey(4.0) };
        b.0.lights.push(Light::new(format!("lamp {}", b.0.lights.len()), kind));
    }
    let (eye, target) = (Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3));
    b.0.view = Some(Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 70.0 });
    b.0
}

/// Both lamps this bright.
fn lit(level: f32) -> [Edit; 2] {
    [0, 1].map(|light| {
        let kind = room().lights[light].kind.clone();
        let brightness = kind.brightness() * level;
        Edit::Light { light: light as u32, kind: kind.with_brightness(brightness) }
    })
}

/// What one batch alone shows.
fn image(scene: &Scene, index: u32) -> Vec<Rgb> {
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    let view = View::new(scene.view.as_ref().expect("a view"), SIZE[0], SIZE[1]);
    cpu.begin(scene.clone(), Eye::Camera(view), &shown(1)).expect("sound");
    cpu.show(Batch { index }).expect("a batch");
    let frame = cpu.frame().expect("begun");
    assert!(frame.batches() == 0 && frame.mean().iter().all(|v| *v == Rgb::BLACK), "shown, not added");
    frame.shown()
}

fn assert_sum(found: &[Rgb], images: &[(f32, &Vec<Rgb>)]) {
    let most = found.iter().map(|v| v.max_channel()).fold(0.0, f32::max);
    for (k, v) in found.iter().enumerate() {
        let sum = images.iter().fold(Rgb::BLACK, |sum, (by, image)| sum + image[k] * *by);
        assert!((*v - sum).map(f32::abs).max_channel() < 2e-5 * most, "pixel {k}: {v:?} for {sum:?}");
    }
}

/// An image among the batches of a session.
struct Drawn<'a> {
    level: f32,
    image: &'a Vec<Rgb>,
    /// Those of equal number are summed together: of one state of the scene, added or only shown.
    sum: usize,
}

/// Weights of the last `most` images; where some of a sum are older, all of it counts less.
fn weights<'a>(drawn: &[Drawn<'a>], most: usize) -> Vec<(f32, &'a Vec<Rgb>)> {
    let last = &drawn[drawn.len().saturating_sub(most)..];
    let of = |images: &[Drawn<'_>], sum: usize| images.iter().filter(|d| d.sum == sum).count() as f32;
    let share = |sum: usize| of(last, sum) / of(drawn, sum) / last.len() as f32;
    drawn.iter().map(|d| (d.level * share(d.sum), d.image)).collect()
}

/// Light is linear in the lamps' brightness, so each image is known: that of its number, times the level that was.
#[test]
fn the_last_n_batches_are_shown_each_as_it_was() {
    const N: u32 = 4;
    let images: Vec<Vec<Rgb>> = (0..2 * N).map(|index| image(&room(), index)).collect();
    // A change each batch; every second or third one, so that some are added; and of several in a row.
    for every in [1, 2, 3, 5] {
        let mut session = Session::open(room(), SIZE, &shown(N), Some(2)).expect("a view");
        let mut drawn: Vec<Drawn<'_>> = Vec::new();
        let (mut level, mut sum) = (1.0, 0);
        for t in 0..15 {
            if t % every == every - 1 {
                level = 1.0 + 0.5 * (t % 3) as f32 + 0.1 * t as f32;
                let before = session.frame().expect("open").shown();
                for edit in lit(level) {
                    session.edit(&edit).expect("sound");
                }
                if !drawn.is_empty() {
                    let after = session.frame().expect("open").shown();
                    assert_sum(&after, &[(1.0, &before)]);
                }
                sum += 1;
            }
            let batches = session.frame().expect("open").batches();
            session.step().expect("a batch");
            let kept = session.frame().expect("open").batches() > batches;
            // Numbers go round, and what is added begins with the first.
            assert_eq!(kept, batches > 0 || t % N as usize == 0, "step {t} of {every}");
            sum += usize::from(kept && batches == 0);
            let image = &images[if kept { batches as usize } else { t % N as usize }];
            drawn.push(Drawn { level, image, sum });
            let frame = session.frame().expect("open");
            if frame.batches() <= N {
                assert_sum(&frame.shown(), &weights(&drawn, N as usize));
            }
        }
    }
}

/// An object that moves leaves its images, one's own moving none, and only what changes is averaged.
#[test]
fn images_are_kept_as_long_as_they_are_of_use() {
    let moved = Edit::Move { instance: 1, transform: Affine3A::from_translation(Vec3::X * 0.3) };
    let mut session = Session::open(room(), SIZE, &shown(3), Some(2)).expect("a view");
    session.step().expect("a batch");
    session.edit(&moved).expect("sound");
    session.step().expect("a batch");
    let scene = session.scene().expect("open").clone();
    let (first, second) = (image(&room(), 0), image(&scene, 1));
    assert!(first != image(&scene, 0), "it is seen");
    assert_sum(&session.frame().expect("open").shown(), &[(0.5, &first), (0.5, &second)]);

    let camera = room().view.map(|camera| Camera { fov_y: 60.0, ..camera });
    session.edit(&Edit::View { camera }).expect("sound");
    assert!(session.frame().expect("open").shown().iter().all(|v| *v == Rgb::BLACK));
    session.step().expect("a batch");
    let scene = session.scene().expect("open").clone();
    assert_sum(&session.frame().expect("open").shown(), &[(1.0, &image(&scene, 0))]);

    let mut world = World::new(room());
    world.separate(2).expect("a scene that was read");
    let mut session = Session::open(world.scene().clone(), SIZE, &shown(3), Some(2)).expect("a view");
    session.settle(2).expect("batches");
    let layers = |s: &mut Session| [0, 1].map(|k| s.frame().expect("open").shown_layer(k));
    let before = layers(&mut session);
    session.edit(&lit(2.0)[0]).expect("sound");
    session.step().expect("a batch");
    let after = layers(&mut session);
    assert!(before[1] == after[1] && before[0] != after[0]);
}

/// Threads are none of its business: the same steps and edits show the same bits.
#[test]
fn a_film_does_not_depend_on_threads() {
    let film = |threads: usize| -> Vec<u32> {
        let mut session = Session::open(room(), SIZE, &shown(3), Some(threads)).expect("a view");
        let mut bits = Vec::new();
        for t in 0..8 {
            let edit = match t % 3 {
                0 => lit(1.0 + t as f32)[1].clone(),
                1 => Edit::Move {
                    instance: 1,
                    transform: Affine3A::from_translation(Vec3::X * 0.1 * t as f32),
                },
                _ => lit(0.5 * t as f32)[0].clone(),
            };
            session.edit(&edit).expect("sound");
            session.step().expect("a batch");
            let picture = session.frame().expect("open").shown();
            bits.extend(picture.into_iter().flat_map(|v| v.to_array().map(f32::to_bits)));
        }
        bits
    };
    let one = film(1);
    assert!([2, 3, 7].into_iter().all(|threads| film(threads) == one));
}

/// Asked for so many batches, a session has the bits of one opened afresh, with or without a window.
#[test]
fn a_window_is_for_what_is_shown_alone() {
    let mut session = Session::open(room(), SIZE, &shown(5), Some(2)).expect("a view");
    for level in [2.0, 0.5, 3.0] {
        session.step().expect("a batch");
        session.edit(&lit(level)[1]).expect("sound");
        session.step().expect("a batch");
    }
    session.settle(2).expect("batches");
    let scene = session.scene().expect("open").clone();
    for window in [1, 5] {
        let mut fresh = Session::open(scene.clone(), SIZE, &shown(window), Some(1)).expect("a view");
        fresh.settle(2).expect("batches");
        let [a, b] = [&mut session, &mut fresh].map(|s| s.frame().expect("open").clone());
        assert!(a.mean() == b.mean() && a.shown() == b.shown(), "window {window}");
        assert_eq!(a.standard_error(5), b.standard_error(5));
    }
    for bad in [
        Settings { window: 0, ..shown(1) },
        Settings { window: 65, ..shown(1) },
        Settings { filter: false, ..shown(2) },
    ] {
        assert!(bad.check().is_err(), "{bad:?}");
    }
}
