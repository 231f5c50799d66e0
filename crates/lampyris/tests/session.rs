//! A session's picture does not depend on how its scene came to be: edited, undone, redone or replayed, on any number of
//! threads, it has the bits of one opened afresh.

mod stage;

use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::scene::{Edit, Scene};
use lampyris::session::Session;
use stage::support::{FAST, ORACLE, settings};
use stage::{Chance, some_edit, stage};

const SIZE: [u32; 2] = [8, 8];

fn fast() -> Settings {
    Settings { photons: 200, ..settings(FAST, 12, 4, 1) }
}

/// As a program shows it: pixels in classes, a few lights picked, each batch filtered.
fn shown() -> Settings {
    let light_points = Some(8);
    Settings {
        photons: 200,
        interleave: [2, 2],
        picks: Some(4),
        light_points,
        filter: true,
        ..settings(FAST, 24, 1, 1)
    }
}

fn open(scene: Scene, settings: &Settings, threads: usize) -> Session {
    Session::open(scene, SIZE, settings, Some(threads)).expect("a scene with a view")
}

/// Every bit of the picture and of its parts after so many batches.
fn bits(session: &mut Session, batches: u32) -> Vec<u32> {
    session.settle(batches).expect("batches");
    let frame = session.frame().expect("a frame");
    assert_eq!(frame.batches(), batches);
    let names: Vec<String> = frame.part_names().map(str::to_owned).collect();
    let parts = names.iter().flat_map(|n| frame.part(n).expect("rendered"));
    frame
        .mean()
        .into_iter()
        .chain(frame.shown())
        .chain(parts)
        .flat_map(|v| v.to_array().map(f32::to_bits))
        .collect()
}

fn scene(session: &Session) -> Scene {
    session.scene().expect("open").clone()
}

/// Steps between edits leave nothing behind, whatever they drew.
#[test]
fn edited_is_fresh() {
    let mut c = Chance::new(11);
    let mut pictures = std::collections::HashSet::new();
    let window = Settings { window: 3, ..shown() };
    for (settings, rounds) in [(fast(), 20), (shown(), 8), (window, 8), (settings(ORACLE, 1, 4, 1), 4)] {
        for round in 0..rounds {
            let mut session = open(stage(), &settings, 1 + round % 2);
            for _ in 0..250 {
                session.edit(&some_edit(&scene(&session), &mut c)).expect("a sound edit");
                if c.below(40) == 0 {
                    session.step().expect("a batch");
                }
            }
            let edited = bits(&mut session, 3);
            let mut fresh = open(scene(&session), &settings, 2);
            assert!(edited == bits(&mut fresh, 3), "round {round} of {:?}", settings.parts);
            pictures.insert(edited);
        }
    }
    assert_eq!(pictures.len(), 40, "pictures that are all the same prove nothing");
}

#[test]
fn logs_replay_on_any_number_of_threads() {
    let mut c = Chance::new(5);
    let mut session = open(stage(), &fast(), 2);
    for _ in 0..60 {
        match c.below(6) {
            0 => drop(session.undo().expect("what was done can be undone")),
            1 => drop(session.redo().expect("what was undone can be redone")),
            _ => drop(session.edit(&some_edit(&scene(&session), &mut c)).expect("a sound edit")),
        }
    }
    let log: Vec<Edit> = session.log().to_vec();
    assert!(log.len() > 50);
    let written = serde_json::to_string(&log).expect("a log can be written down");
    let read: Vec<Edit> = serde_json::from_str(&written).expect("and read");
    assert_eq!(read, log);
    let picture = bits(&mut session, 2);
    for threads in [1, 2, 3, 7] {
        let mut again = open(stage(), &fast(), threads);
        again.replay(&read).expect("edits that fitted before");
        assert_eq!(again.log(), log);
        assert!(picture == bits(&mut again, 2), "{threads} threads");
    }
}

#[test]
fn undo_and_redo_are_exact() {
    let mut c = Chance::new(2);
    let mut session = open(stage(), &fast(), 2);
    assert!(session.undo().expect("nothing to do").is_none() && session.redo().expect("nothing").is_none());
    // First a lamp that was dark in the file, and a floor that did not glow: they are entered among what shines, and an
    // undo leaves them there, dark.
    let lamp = stage().lights[0].kind.clone();
    let mut first =
        vec![Edit::Emission { material: 1, emission: Rgb::grey(3.0) }, Edit::Light { light: 1, kind: lamp }];
    let mut pictures = Vec::new();
    for _ in 0..12 {
        pictures.push(bits(&mut session, 1));
        let edit = first.pop().unwrap_or_else(|| some_edit(&scene(&session), &mut c));
        session.edit(&edit).expect("a sound edit");
    }
    let last = bits(&mut session, 1);
    for picture in pictures.iter().rev() {
        assert!(session.undo().expect("an edit").is_some());
        assert!(*picture == bits(&mut session, 1));
    }
    assert!(session.undo().expect("all undone").is_none());
    for picture in pictures.iter().skip(1).chain([&last]) {
        assert!(session.redo().expect("an edit").is_some());
        assert!(*picture == bits(&mut session, 1));
    }
    assert!(session.redo().expect("all redone").is_none());
    // A new edit ends what could be redone.
    session.undo().expect("an edit");
    session.edit(&some_edit(&scene(&session), &mut c)).expect("a sound edit");
    assert!(session.redo().expect("nothing").is_none());
    let differ = pictures.windows(2).filter(|two| two[0] != two[1]).count();
    assert!(differ > 6, "{differ} edits showed");
}

/// What changes no light leaves the picture as it is; what does starts it again; what is refused does neither.
#[test]
fn pictures_restart_when_they_must() {
    let mut session = open(stage(), &fast(), 2);
    session.settle(2).expect("batches");
    let light = stage().lights[0].clone();
    let changes = session.edit(&Edit::Light { light: 0, kind: light.kind.clone() }).expect("a sound edit");
    assert!(!changes.any() && session.frame().expect("a frame").batches() == 2);
    assert!(session.edit(&Edit::View { camera: None }).is_err());
    assert!(session.edit(&Edit::Mesh { instance: 99, mesh: None }).is_err());
    assert_eq!((session.frame().expect("a frame").batches(), session.log().len()), (2, 1));
    let moved = stage().view.map(|camera| lampyris::scene::Camera { fov_y: 50.0, ..camera });
    let changes = session.edit(&Edit::View { camera: moved }).expect("a sound edit");
    assert!(changes.view && session.frame().expect("a frame").batches() == 0);
    let blind = Scene { view: None, ..stage() };
    assert!(Session::open(blind, SIZE, &fast(), Some(1)).is_err());
}
