//! A batch that is given up loses nothing and leaves nothing: what is completed later has the bits of one that never was
//! disturbed, whatever is done meanwhile, and whoever gives up need not wait.

mod stage;

use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::frame::Frame;
use lampyris::scene::{Edit, Scene, View};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{FAST, settings};
use stage::{Chance, some_edit, stage};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Several bands of tiles, since 128 tiles are worked on together.
const SIZE: [u32; 2] = [4, 2400];

fn exact() -> Settings {
    Settings { photons: 100, ..settings(&["emission", "direct", "vpl"], 4, 1, 1) }
}

/// As a program shows it.
fn shown() -> Settings {
    let filter =
        Settings { interleave: [2, 2], picks: Some(2), light_points: Some(4), filter: true, ..exact() };
    Settings { parts: FAST.iter().map(|part| (*part).to_owned()).collect(), edges: 1, paths: 8, ..filter }
}

fn separated(most: usize) -> Scene {
    let mut world = World::new(stage());
    world.separate(most).expect("a scene that was read");
    world.scene().clone()
}

fn open(scene: Scene, settings: &Settings, threads: usize) -> Session {
    Session::open(scene, SIZE, settings, Some(threads)).expect("a scene with a view")
}

/// Says no at one question, and from then on. Counts what was asked, and what was asked after that.
struct Patience {
    asked: AtomicUsize,
    most: usize,
}

impl Patience {
    fn of(most: usize) -> Patience {
        Patience { asked: AtomicUsize::new(0), most }
    }

    fn step(&self, session: &mut Session) -> bool {
        session.step_while(&|| self.asked.fetch_add(1, Ordering::Relaxed) < self.most).expect("a batch")
    }

    fn asked(&self) -> usize {
        self.asked.load(Ordering::Relaxed)
    }
}

/// All that a frame tells.
fn told(frame: &Frame) -> (Vec<Rgb>, Vec<Rgb>, Vec<u32>, [u32; 2]) {
    let batches = (0..frame.layers()).map(|layer| frame.batches_of(layer)).collect();
    let errors = [frame.relative_error(), frame.standard_error(99)].map(f32::to_bits);
    (frame.mean(), frame.shown(), batches, errors)
}

/// Given up at every k-th question, for all k, until it is done.
#[test]
fn what_is_completed_was_never_disturbed() {
    for settings in [exact(), shown(), Settings { auxiliary: true, ..exact() }] {
        let mut whole = open(separated(3), &settings, 2);
        whole.settle(3).expect("batches");
        let whole = told(whole.frame().expect("open"));
        let mut given_up = 0;
        for most in [1, 30, 132, 140] {
            let mut session = open(separated(3), &settings, 2);
            for batches in 0..3 {
                let mut patience = most;
                while !Patience::of(patience).step(&mut session) {
                    given_up += 1;
                    patience += 20;
                }
                // Who asks what the eye meets first loses what was begun.
                assert!(settings.auxiliary || session.frame().expect("open").batches() == batches + 1);
            }
            session.settle(3).expect("batches");
            assert!(told(session.frame().expect("open")) == whole, "given up at question {most}");
        }
        assert!(given_up > 20, "{given_up}");
    }
}

/// The rows that have a batch more are weighted by it; counts and errors know of whole batches alone.
#[test]
fn half_a_batch_is_shown_as_what_it_is() {
    let settings = Settings { edges: 0, ..shown() };
    let after = |batches: u32| {
        let mut session = open(separated(2), &settings, 2);
        session.settle(batches).expect("batches");
        told(session.frame().expect("open"))
    };
    for batches in [0, 1, 3] {
        let [before, next] = [after(batches), after(batches + 1)];
        let mut session = open(separated(2), &settings, 2);
        session.settle(batches).expect("batches");
        assert!(!Patience::of(145).step(&mut session));
        let half = told(session.frame().expect("open"));
        assert!((&half.2, half.3) == (&before.2, before.3), "counts and errors");
        let rows = half.0.iter().zip(&next.0).take_while(|(a, b)| a == b).count();
        if batches > 0 {
            assert!(rows > 1000 && rows < 9_000, "{rows} pixels have it");
            assert!(half.0[rows..].iter().zip(&before.0[rows..]).all(|(a, b)| a == b));
        } else {
            assert!(half.0.iter().chain(&half.1).all(|v| *v == Rgb::BLACK));
        }
        // Somebody asks for the picture of so many batches.
        session.settle(batches.max(1)).expect("batches");
        assert!(told(session.frame().expect("open")) == after(batches.max(1)));
    }
}

/// Whatever is done between batches that are given up, the picture has the bits of one begun anew.
#[test]
fn edited_is_fresh_for_those_who_give_up() {
    let mut c = Chance::new(83);
    let window = Settings { window: 3, ..shown() };
    for (round, settings) in [exact(), shown(), window, shown()].iter().enumerate() {
        let mut session = open(separated([2, 5, 16, 1][round]), settings, 1 + round % 2);
        let (mut given_up, mut done) = (0, 0);
        for step in 0..25 {
            // Looking elsewhere begins everything anew, lamps alone what is theirs.
            for _ in 0..1 + step % 2 {
                let scene = session.scene().expect("open").clone();
                let group = c.below(scene.groups.len()) as u16;
                let edit = match c.below(6) {
                    0 => Edit::Mix { group, color: Rgb::new(c.unit(), c.unit(), c.unit()) },
                    1 => {
                        let emitter = c.below(scene.reference.shares.len()) as u32;
                        Edit::Regroup { emitters: vec![emitter], group: group + c.below(2) as u16 }
                    }
                    2 if step % 5 == 0 => some_edit(&scene, &mut c),
                    _ => {
                        let light = c.below(scene.lights.len()) as u32;
                        let kind = scene.lights[light as usize].kind.clone();
                        Edit::Light { light, kind: kind.with_brightness(Rgb::grey(c.unit())) }
                    }
                };
                session.edit(&edit).expect("a sound edit");
            }
            if step % 20 == 19 {
                session.settle(2).expect("batches");
            }
            for _ in 0..3 {
                let patience = Patience::of([0, 3, 135, 140, 145, 1000][c.below(6)]);
                if patience.step(&mut session) { done += 1 } else { given_up += 1 }
            }
        }
        assert!(given_up > 10 && done > 10, "{given_up} given up, {done} done");
        let progress = session.frame().expect("open").progress();
        let most = progress.iter().map(|p| p.batches).max().expect("a layer").max(3);
        let mut fresh = open(session.scene().expect("open").clone(), settings, 2);
        session.settle(most).expect("batches");
        fresh.settle(most).expect("batches");
        let [edited, fresh] = [&mut session, &mut fresh].map(|s| told(s.frame().expect("open")));
        assert!(edited == fresh, "round {round}");
    }
}

/// One question after the answer is no for each thread at most, and no light at all where it is no from the first.
#[test]
fn giving_up_is_quick() {
    let mut session = open(separated(3), &shown(), 2);
    let never = Patience::of(0);
    assert!(!never.step(&mut session) && never.asked() == 1);
    assert_eq!(session.statistics().rays.particle, 0);
    for most in [1, 2, 40, 135, 145] {
        let (mut session, patience) = (open(separated(3), &shown(), 2), Patience::of(most));
        assert!(!patience.step(&mut session));
        assert!(patience.asked() <= most + 2, "{} questions of {most}", patience.asked());
    }
}

/// Whoever adds another batch than the one that was given up loses what was done of that one.
#[test]
fn another_batch_begins_anew() {
    let scene = separated(2);
    let eye = Eye::Camera(View::new(scene.view.as_ref().expect("a view"), SIZE[0], SIZE[1]));
    let picture = |torn: &[u32]| {
        let mut cpu = Cpu::new(Some(2)).expect("threads");
        cpu.begin(scene.clone(), eye.clone(), &shown()).expect("sound");
        for index in torn {
            let patience = Patience::of(145);
            let go_on = || patience.asked.fetch_add(1, Ordering::Relaxed) < patience.most;
            assert!(!cpu.add_while(Batch { index: *index }, &go_on).expect("a batch"));
        }
        (0..2).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
        told(cpu.frame().expect("begun"))
    };
    let whole = picture(&[]);
    assert!(picture(&[7]) == whole && picture(&[0]) == whole && picture(&[3, 0, 4]) == whole);
}
