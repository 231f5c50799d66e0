//! Pictures are the same to the bit: for any number of threads, from run to run, and whatever ran before.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Absorption, Backend, Batch, Gather, Settings, Source};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::integrator::FULL_SOLUTION;
use lampyris::light::{Beam, LightKind};
use lampyris::material::Sides;
use lampyris::scene::Scene;
use lampyris::sequence::Sequence;
use support::{Build, FAST, ORACLE, glass, gloss, meter, settings, view};

/// Something of everything: gloss, glass, a panel, a spot, a sky through a missing wall.
fn scene() -> Scene {
    let mut b = Build(Scene { environment: Rgb::new(0.2, 0.3, 0.5), ..Default::default() });
    let wall = b.grey(0.6);
    let floor = b.material(gloss(0.3, 0.3, 0.1), 0.0, Sides::Both);
    let clear = b.material(glass(), 0.0, Sides::Both);
    let glow = b.material(gloss(0.2, 0.2, 0.3), 10.0, Sides::Both);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, wall, floor, wall, wall, wall]);
    b.0.instances.pop();
    b.sphere(Vec3::new(0.7, 0.5, 0.7), 0.4, 2, false, |_| clear);
    b.quad(Vec3::new(0.7, 1.95, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, glow);
    b.light(LightKind::Spot {
        position: Vec3::new(1.5, 1.5, 1.5),
        direction: Vec3::new(-0.6, -0.8, 0.0),
        intensity: Rgb::grey(3.0),
        beam: Beam::Cosine { exponent: 5.0 },
    });
    b.0
}

/// Every bit of a picture's mean and of its parts. The size is no multiple of tile or packet.
fn bits(threads: usize, eye: &Eye, settings: &Settings) -> Vec<u32> {
    let mut cpu = Cpu::new(Some(threads)).expect("threads");
    cpu.begin(scene(), eye.clone(), settings).expect("sound");
    (0..5).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    let frame = cpu.frame().expect("begun");
    let names: Vec<String> = frame.part_names().map(str::to_owned).collect();
    let mut all = [frame.mean(), frame.shown()].concat();
    all.extend(names.iter().flat_map(|n| frame.part(n).expect("rendered")));
    all.iter().flat_map(|v| v.to_array().map(f32::to_bits)).collect()
}

fn eyes() -> [Eye; 2] {
    let meters = (0..37).map(|k| meter(Vec3::new(0.05 * k as f32 + 0.02, 1e-3, 1.0), Vec3::Y)).collect();
    [view(Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3), 70.0, 37, 21), Eye::Meters(meters)]
}

#[test]
fn any_number_of_threads_and_any_run() {
    for eye in eyes() {
        let shown = Settings { paths: 100, photons: 500, ..Settings::interactive() };
        let gathered = Gather { rays: 2, paths: 1 << 10, source: Source::Photons, ..Gather::default() };
        let mapped = ["emission", "direct-map", "final-gather", "caustic-map"];
        let mapped = Settings { photons: 1 << 12, gather: gathered, ..settings(&mapped, 20, 3, 1) };
        let elements = Gather { source: Source::Elements, ..gathered };
        let full = Settings { gather: elements, ..settings(FULL_SOLUTION, 20, 3, 1) };
        for s in [settings(FAST, 20, 7, 1), settings(ORACLE, 1, 3, 1), shown, mapped, full] {
            let one = bits(1, &eye, &s);
            assert!(one.iter().any(|b| *b != 0), "a black picture proves nothing");
            for threads in [1, 2, 3, 7] {
                assert_eq!(one, bits(threads, &eye, &s), "{threads} threads, {:?}", s.parts);
            }
        }
    }
}

#[test]
fn every_sequence_and_absorption() {
    let [eye, _] = eyes();
    let mut pictures: Vec<Vec<u32>> = Vec::new();
    for sequence in Sequence::ALL {
        for (_, absorption) in Absorption::ALL {
            let s = Settings { sequence, absorption: *absorption, ..settings(FAST, 20, 4, 1) };
            let one = bits(1, &eye, &s);
            assert_eq!(one, bits(3, &eye, &s), "{sequence:?}, {absorption:?}");
            assert!(!pictures.contains(&one), "{sequence:?}, {absorption:?} is another's picture");
            pictures.push(one);
        }
    }
}

/// `begin` starts afresh: nothing of an earlier picture stays.
#[test]
fn a_machine_used_before() {
    let [eye, meters] = eyes();
    let s = settings(FAST, 20, 4, 1);
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    let mut picture = |first: bool| {
        if first {
            cpu.begin(scene(), meters.clone(), &settings(ORACLE, 3, 2, 9)).expect("sound");
            cpu.add(Batch { index: 3 }).expect("a batch");
        }
        cpu.begin(scene(), eye.clone(), &s).expect("sound");
        cpu.add(Batch { index: 0 }).expect("a batch");
        cpu.frame().expect("begun").mean()
    };
    assert_eq!(picture(false), picture(true));
}

/// Short of the exact sums what is shown is another picture than their mean, and nearer to a long mean, on surfaces that are
/// smooth at least.
#[test]
fn what_is_shown_is_nearer() {
    let mut b = Build::default();
    let [red, white] = [b.grey(0.3), b.grey(0.8)];
    b.room(Vec3::ZERO, Vec3::splat(2.0), [red, white, white, white, white, white]);
    b.block(Vec3::new(0.3, 0.0, 0.3), Vec3::new(0.9, 0.8, 0.9), white);
    let glow = b.glow(10.0);
    b.quad(Vec3::new(0.7, 1.95, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, glow);
    let [eye, _] = eyes();
    let pictures = |settings: &Settings, batches: u32| {
        let mut cpu = Cpu::new(None).expect("threads");
        cpu.begin(b.0.clone(), eye.clone(), settings).expect("sound");
        (0..batches).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
        let frame = cpu.frame().expect("begun");
        [frame.mean(), frame.shown()]
    };
    let few = Settings { paths: 400, ..Settings::interactive() };
    let [truth, _] = pictures(&settings(FAST, 256, 64, 9), 16);
    let [mean, shown] = pictures(&few, 4);
    let error = |picture: &[Rgb]| {
        let pairs = picture.iter().zip(&truth).map(|(p, t)| (p.luminance(), t.luminance()));
        pairs.filter(|(_, t)| *t < 5.0).map(|(p, t)| ((p - t) / (t + 0.1)).powi(2)).sum::<f32>()
    };
    let gain = error(&mean) / error(&shown);
    support::say(format_args!("squared error of the mean over that of what is shown: {gain:.1}"));
    assert!(gain > 4.0, "filtering gains {gain}");
}

/// Another seed is another picture; so is another batch.
#[test]
fn seeds_differ() {
    let [eye, _] = eyes();
    assert_ne!(bits(1, &eye, &settings(FAST, 20, 4, 1)), bits(1, &eye, &settings(FAST, 20, 4, 2)));
}
