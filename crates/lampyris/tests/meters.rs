//! Meters in a session: they follow every edit, disturb nothing, and show what a run of their own would.

mod stage;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::frame::Frame;
use lampyris::scene::{Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use stage::support::{FAST, settings};
use stage::{Chance, some_edit, stage};

const SIZE: [u32; 2] = [12, 8];

fn separated(most: usize) -> Scene {
    let mut world = World::new(stage());
    world.separate(most).expect("a scene that was read");
    world.scene().clone()
}

fn picture() -> Settings {
    let filter =
        Settings { interleave: [2, 2], picks: Some(4), light_points: Some(8), filter: true, ..meter() };
    Settings { paths: 24, passes: Some(1), ..filter }
}

fn meter() -> Settings {
    Settings { photons: 100, ..settings(FAST, 12, 3, 1) }
}

fn meters(count: usize, c: &mut Chance) -> Vec<Meter> {
    (0..count).map(|_| Meter { position: c.point(), normal: c.direction() }).collect()
}

fn told(frame: &Frame) -> (Vec<Rgb>, Vec<Option<Vec<Rgb>>>, Vec<u32>) {
    let errors = (0..frame.width as usize).map(|k| frame.standard_error(k).to_bits());
    (frame.mean(), (0..frame.layers()).map(|k| frame.layer(k)).collect(), errors.collect())
}

/// What `lampyris measure` does, with the scene's light groups.
fn fresh(scene: &Scene, meters: &[Meter], batches: u32) -> (Vec<Rgb>, Vec<Option<Vec<Rgb>>>, Vec<u32>) {
    let mut cpu = Cpu::new(Some(1)).expect("threads");
    cpu.begin(scene.clone(), Eye::Meters(meters.to_vec()), &meter()).expect("sound");
    (0..batches).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    told(cpu.frame().expect("begun"))
}

/// Steps of picture and meters in any order, given up or not, between edits of all kinds.
#[test]
fn meters_follow_every_edit() {
    let mut c = Chance::new(17);
    let mut figures = std::collections::HashSet::new();
    for round in 0..8 {
        let scene = if round % 4 == 3 { stage() } else { separated([2, 5, 16][round % 4]) };
        let mut session =
            Session::open(scene.clone(), SIZE, &picture(), Some(1 + round % 2)).expect("a view");
        // The same edits and steps, and nobody measures.
        let mut alone = Session::open(scene, SIZE, &picture(), Some(2)).expect("a view");
        let mut points = meters(7, &mut c);
        session.measure(&points, &meter()).expect("sound");
        for step in 0..30 {
            let scene = session.scene().expect("open").clone();
            let edit = match c.below(4) {
                0 if !scene.groups.is_empty() => {
                    let group = c.below(scene.groups.len()) as u16;
                    Edit::Mix { group, color: Rgb::new(c.unit(), c.unit(), c.unit()) }
                }
                1 if !scene.groups.is_empty() => {
                    let emitter = c.below(scene.reference.shares.len()) as u32;
                    let group = c.below(scene.groups.len()) as u16;
                    Edit::Regroup { emitters: vec![emitter], group }
                }
                _ => some_edit(&scene, &mut c),
            };
            for session in [&mut session, &mut alone] {
                session.edit(&edit).expect("a sound edit");
                if step % 10 == 7 {
                    session.undo().expect("done").expect("an edit");
                }
            }
            if step % 11 == 10 {
                points = meters(1 + c.below(40), &mut c);
                session.measure(&points, &meter()).expect("sound");
            }
            if step % 5 == 0 {
                let done = session.step_meters(&|| step % 10 == 0).expect("a batch");
                assert_eq!(done, step % 10 == 0);
            }
            if step % 6 == 0 {
                session.step().expect("a batch");
                alone.step().expect("a batch");
            }
        }
        let most = session.meters().expect("meters").progress().iter().map(|p| p.batches).max();
        let batches = most.expect("a layer").max(2);
        session.settle_meters(batches).expect("batches");
        let found = told(session.meters().expect("meters"));
        let scene = session.scene().expect("open").clone();
        assert!(found == fresh(&scene, &points, batches), "round {round}");
        assert!(found.0.iter().any(|v| *v != Rgb::BLACK));
        figures.insert(found.2);
        let pictures = [&mut session, &mut alone].map(|s| {
            s.settle(3).expect("batches");
            s.frame().expect("open").shown()
        });
        assert!(pictures[0] == pictures[1], "nobody saw that somebody measured");
    }
    assert_eq!(figures.len(), 8);
}

/// Who looks elsewhere reads the same meters on, and levels change what is read without a batch.
#[test]
fn views_and_levels_begin_no_meter_anew() {
    let mut c = Chance::new(4);
    let mut session = Session::open(separated(5), SIZE, &picture(), Some(2)).expect("a view");
    assert!(session.meters().is_none() && !session.step_meters(&|| true).expect("nothing to do"));
    let points = meters(3, &mut c);
    session.measure(&points, &meter()).expect("sound");
    session.settle_meters(2).expect("batches");
    let before = told(session.meters().expect("meters"));
    let camera = session.scene().expect("open").view.clone();
    let moved = camera.map(|camera| lampyris::scene::Camera { eye: Vec3::ONE, ..camera });
    session.edit(&Edit::View { camera: moved }).expect("sound");
    session.set(&Settings { seed: 5, ..picture() }).expect("sound");
    session.step().expect("a batch");
    assert!(told(session.meters().expect("meters")) == before);
    session.edit(&Edit::Mix { group: 1, color: Rgb::BLACK }).expect("sound");
    let frame = session.meters().expect("meters");
    assert!(frame.batches() == 2 && frame.mean() != before.0);
    let scene = session.scene().expect("open").clone();
    assert!(told(frame) == fresh(&scene, &points, 2));
    // What makes no sense changes nothing, and nothing to measure ends it.
    assert!(session.measure(&points, &Settings { paths: 0, ..meter() }).is_err());
    assert!(session.meters().is_some());
    session.measure(&[], &meter()).expect("nothing");
    assert!(session.meters().is_none());
}

/// Of several thousand meters a batch that is given up is completed later.
#[test]
fn many_meters_are_given_up_and_completed() {
    let plain = Settings { ..settings(&["direct", "vpl"], 4, 1, 1) };
    let points = meters(5000, &mut Chance::new(1));
    let open = || {
        let mut session = Session::open(separated(3), SIZE, &picture(), Some(2)).expect("a view");
        session.measure(&points, &plain).expect("sound");
        session
    };
    let mut whole = open();
    whole.settle_meters(2).expect("batches");
    let mut session = open();
    let mut given_up = 0;
    for _ in 0..8 {
        let asked = std::sync::atomic::AtomicUsize::new(0);
        let go_on = || asked.fetch_add(1, std::sync::atomic::Ordering::Relaxed) < 150;
        if session.meters().expect("meters").batches() < 2 {
            given_up += usize::from(!session.step_meters(&go_on).expect("a batch"));
        }
    }
    assert_eq!((given_up, session.meters().expect("meters").batches()), (4, 2));
    assert!(told(session.meters().expect("meters")) == told(whole.meters().expect("meters")));
}
