//! Saved documents: what was edited, applied to the scene as its file has it, is the edited scene to the bit; and whatever
//! stands in such a file, it is understood or refused in words.

mod stage;

use glam::{Affine3A, Vec3};
use lampyris::backend::Settings;
use lampyris::document::{Document, VERSION, outline};
use lampyris::error::Error;
use lampyris::import::Limits;
use lampyris::light::{Light, LightKind, State};
use lampyris::scene::{Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use lampyris::{Result, Rgb};
use serde_json::json;
use stage::support::{FAST, settings};
use stage::{Chance, some_edit, stage};
use std::path::Path;

/// All of it, bit by bit: −0 is not written as 0.
fn bits(scene: &Scene) -> String {
    format!("{scene:?}")
}

fn read(text: &str) -> Result<Document> {
    Document::read(Path::new("a.lampyris.json"), text.as_bytes(), &Limits::default())
}

/// The stage, with names as files have them: the same ones twice, odd ones, none.
fn named() -> Scene {
    let mut scene = stage();
    let names = ["wall", "wall", "desk/lamp", "", "ü \"quoted\" \\", "wall#2", "ball", "line\nbreak"];
    let all = || names.iter().cycle().map(|name| (*name).to_owned());
    scene.instances.iter_mut().zip(all()).for_each(|(instance, name)| instance.name = name);
    scene.materials.iter_mut().zip(all().skip(2)).for_each(|(material, name)| material.name = name);
    scene.lights.iter_mut().zip(all().skip(5)).for_each(|(light, name)| light.name = name);
    // Some in colours, which groups take out.
    let color = Rgb::new(0.3, 1.0, 2.0);
    scene.lights[0].kind = scene.lights[0].kind.clone().with_brightness(color);
    scene.materials.iter_mut().filter(|m| !m.emission.is_black()).for_each(|m| m.emission = color * 4.0);
    scene
}

/// Opened as the desk does it, and edited at random.
fn edited(before: &Scene, layers: Option<usize>, edits: usize, c: &mut Chance) -> Scene {
    let mut world = World::new(before.clone());
    layers.map_or(Ok(()), |most| world.separate(most)).expect("a scene that was read");
    let mut undo = Vec::new();
    for _ in 0..edits {
        let scene = world.scene();
        let groups = scene.groups.len();
        let edit = match c.below(if groups > 0 { 5 } else { 3 }) {
            0 if !undo.is_empty() => undo.swap_remove(c.below(undo.len())),
            3 => Edit::Mix { group: c.below(groups) as u16, color: Rgb::new(c.unit(), c.unit(), -c.unit()) },
            4 => {
                let emitter = c.below(scene.reference.shares.len()) as u32;
                Edit::Regroup { emitters: vec![emitter], group: c.below(groups + 1) as u16 }
            }
            _ => some_edit(scene, c),
        };
        // What is not of one group any more is refused, and changes nothing.
        if let Ok(changes) = world.apply(&edit) {
            undo.push(changes.inverse);
        }
    }
    world.scene().clone()
}

#[test]
fn what_was_edited_makes_the_edited_scene_to_the_bit() {
    let mut c = Chance::new(7);
    let mut texts = std::collections::HashSet::new();
    for round in 0..120 {
        let before = if round % 2 == 0 { named() } else { stage() };
        let layers = [None, Some(1), Some(3), Some(16), Some(64)][round % 5];
        let after = edited(&before, layers, [0, 1, 5, 60][round % 4], &mut c);
        let document = Document::of(&outline(&before), &outline(&after));
        let (made, lost) = document.apply(before.clone());
        assert_eq!(lost, [""; 0]);
        assert_eq!(bits(&made), bits(&after), "round {round}");
        let text = document.text();
        let again = read(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!(again, document);
        assert_eq!(again.text(), text, "one text for one document");
        assert_eq!(bits(&again.apply(before.clone()).0), bits(&after), "{text}");
        // What is as it was is not written down, and what was edited before may be edited on.
        assert_eq!(Document::of(&after, &after), Document::default());
        let further = edited(&after, None, 5, &mut c);
        let (made, lost) = Document::of(&before, &further).apply(before);
        assert_eq!((bits(&made), lost.len()), (bits(&further), 0));
        texts.insert(text);
    }
    assert!(texts.len() > 80, "{} documents", texts.len());
}

#[test]
fn a_reloaded_scene_has_the_bits_of_the_session() {
    let settings = Settings { photons: 200, ..settings(FAST, 12, 4, 1) };
    let mut c = Chance::new(3);
    let picture = |scene: Scene| {
        let mut session = Session::open(scene, [10, 8], &settings, Some(2)).expect("a view");
        session.settle(2).expect("batches");
        let frame = session.frame().expect("a frame");
        let all = frame.mean().into_iter().chain(frame.shown());
        all.flat_map(|v| v.to_array().map(f32::to_bits)).collect::<Vec<_>>()
    };
    let mut pictures = std::collections::HashSet::new();
    for layers in [None, Some(2), Some(16)] {
        let before = named();
        let after = edited(&before, layers, 30, &mut c);
        let text = Document::of(&before, &after).text();
        let (made, _) = read(&text).expect("what was written").apply(before);
        let shown = picture(after);
        assert!(shown == picture(made), "{layers:?}");
        pictures.insert(shown);
    }
    assert_eq!(pictures.len(), 3);
}

/// A lamp whose colour is in its group takes one word; a dimmed group changes one line.
#[test]
fn texts_are_short_and_differ_where_scenes_do() {
    let before = named();
    let mut world = World::new(before.clone());
    world.separate(16).expect("a scene that was read");
    let text = |world: &World| Document::of(&before, world.scene()).text();
    let first = text(&world);
    assert!(first.contains("\"wall#2#1\": {\"white\": true}"), "{first}");
    for edit in [
        Edit::Mix { group: 1, color: Rgb::new(0.1, 0.2, 0.3) },
        Edit::Switch { light: 2, state: State::Off },
        Edit::Move { instance: 3, transform: Affine3A::from_translation(Vec3::X) },
    ] {
        let before = text(&world);
        world.apply(&edit).expect("a sound edit");
        let after = text(&world);
        let known: Vec<&str> = before.lines().collect();
        let other = after.lines().filter(|line| !known.contains(line)).count();
        assert!((1..=3).contains(&other), "{other} lines for {edit:?}:\n{after}");
    }
    assert!(text(&world).contains("{\"r\": 0.1, \"g\": 0.2, \"b\": 0.3}"), "{}", text(&world));
}

#[test]
fn what_a_desk_keeps_stays() {
    let looks = json!({"looks": {"0": {"name": "evening", "levels": [0.1, 1e-7, 3, -0.0, null, true]}}, "text": "ü\n\u{7}"});
    let wide: Vec<_> = (0..60).map(|k| json!({"number": k, "name": "x".repeat(k)})).collect();
    for desk in
        [json!(null), json!({}), json!([]), json!([[[]]]), looks, json!({"wide": wide, "list": vec![7; 200]})]
    {
        let mut document = Document::default();
        document.desk = desk;
        let text = document.text();
        assert_eq!(read(&text).unwrap_or_else(|e| panic!("{e}\n{text}")), document);
    }
}

/// Objects are found again by their paths; what lost its own is named, and all else stays.
#[test]
fn edits_attach_again_to_a_changed_file() {
    let mut before = named();
    before.instances[2].name = "chair".into();
    let mut world = World::new(before.clone());
    world.separate(16).expect("a scene that was read");
    let place = Affine3A::from_translation(Vec3::new(0.1, 0.2, 0.3));
    let lamp = LightKind::Point { position: Vec3::ONE, intensity: Rgb::grey(3.0) };
    let off = Edit::Switch { light: 1, state: State::Off };
    let moves = [2, 5].map(|instance| Edit::Move { instance, transform: place });
    let added = Edit::AddLight { light: Light::new("new", lamp) };
    for edit in moves.iter().chain([&off, &added]) {
        world.apply(edit).expect("a sound edit");
    }
    let document = Document::of(&before, world.scene());
    // The file gains an object and a light in front of all others, and loses an object, a light and a material's name.
    let mut changed = before.clone();
    let mut gone = changed.instances.remove(2);
    gone.name = "another".into();
    changed.instances.insert(0, gone);
    let dark = changed.lights.remove(0);
    changed.lights.insert(0, Light { name: "first".into(), ..dark });
    let (made, lost) = document.apply(changed.clone());
    assert!(lost.iter().any(|line| line == "object \"chair\" is not in the scene any more"), "{lost:?}");
    assert!(lost.iter().all(|line| line.contains("chair") || line.contains("wall#2")), "{lost:?}");
    let own = |scene: &Scene, name: &str| scene.instances.iter().position(|i| i.name == name).expect("there");
    assert_eq!(made.instances[own(&made, "wall#2")].transform, place);
    assert_eq!(made.instances[0].transform, changed.instances[0].transform);
    assert_eq!(made.lights[1].state, State::Off);
    assert_eq!(made.lights.last().map(|l| l.name.as_str()), Some("new"));
    // It can be rendered, and every emitter has a group that there is.
    let world = World::new(made);
    let groups = world.scene().groups.len();
    assert!(world.scene().reference.shares.iter().all(|s| usize::from(s.group) < groups));
    // In a scene that has nothing of it, everything is lost, and nothing fails.
    let (empty, lost) = document.apply(Scene::default());
    assert!(lost.len() > 8 && empty.instances.is_empty() && empty.lights.len() == 1, "{lost:?}");
    World::new(empty);
}

#[test]
fn what_cannot_be_is_refused_in_words() {
    let scene = r#""scene": {"file": "a.mgf"}"#;
    let with = |rest: &str| format!(r#"{{"lampyris": {VERSION}, {scene}, {rest}}}"#);
    assert!(read(&with(r#""layers": 4"#)).is_ok());
    let point = |intensity: &str| {
        format!(r#"{{"name": "x", "kind": {{"Point": {{"position": [0,0,0], "intensity": {intensity}}}}}}}"#)
    };
    let emitter = |rest: &str| with(&format!(r#""emitters": [{{"share": 0.5, {rest}}}]"#));
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    let nested = format!("{}1{}", "[".repeat(500), "]".repeat(500));
    let cases = [
        ("".into(), "EOF"),
        ("[]".into(), "no document"),
        ("{}".into(), "states no version"),
        ("{\"lampyris\": \"1\"}".into(), "states no version"),
        ("{\"lampyris\": 0}".into(), "no version 0"),
        ("{\"lampyris\": 2, \"new\": 1}".into(), "version 2, and this program knows 1"),
        ("{\"lampyris\": 1e99}".into(), "states no version"),
        (format!("[{VERSION}]"), "no document"),
        (with("\"lights\": [1]"), "an object in braces"),
        (with("\"wishes\": 1"), "unknown field `wishes`"),
        (with("\"lights\": {\"a\": {\"colour\": 1}}"), "unknown field `colour`"),
        (with("\"lights\": {\"a\": {\"state\": \"Off\"}, \"a\": {\"state\": \"On\"}}"), "twice"),
        (with("\"layers\": 4, \"layers\": 5"), "duplicate"),
        (with("\"layers\": -1"), "invalid value"),
        (with("\"layers\": NaN"), "expected value"),
        (with("\"groups\": [{\"name\": \"a\", \"color\": {\"r\": 1e30, \"g\": 0, \"b\": 0}}]"), "too bright"),
        (
            with("\"groups\": [{\"name\": \"a\", \"color\": {\"r\": 1e999, \"g\": 0, \"b\": 0}}]"),
            "out of range",
        ),
        (
            with("\"groups\": [{\"name\": \"a\", \"level\": 1, \"color\": {\"r\": 1, \"g\": 0, \"b\": 0}}]"),
            "unknown field `level`",
        ),
        (
            with(&format!(
                "\"groups\": [{}]",
                vec!["{\"name\": \"a\", \"color\": {\"r\": 1, \"g\": 0, \"b\": 0}}"; 65].join(",")
            )),
            "65 groups",
        ),
        (with("\"flux\": -1"), "a number from 0"),
        (emitter("\"light\": \"a\", \"environment\": true"), "one of them"),
        (emitter("\"object\": \"a\""), "one of them"),
        (emitter("\"material\": \"a\""), "one of them"),
        (emitter("\"group\": 3, \"environment\": true"), "group 3, which there is not"),
        (with("\"emitters\": [{\"share\": 1.5, \"environment\": true}]"), "between 0 and 1"),
        (with(&format!("\"added_lights\": [{}]", point("{\"r\": 1, \"g\": 1, \"b\": 1, \"a\": 1}"))), "unknown field `a`"),
        (with(&format!("\"desk\": {nested}")), "recursion limit"),
        (deep, "no document"),
        (
"{\"lampyris\": 1, \"scene\": {\"file\": \"a\", \"environment\": {\"file\": \"b\", \"scale\": 0}}}".into(),
            "above 0",
        ),
    ];
    for (text, words) in cases {
        let error = read(&text).expect_err(&text).to_string();
        assert!(error.starts_with("a.lampyris.json:") && error.contains(words), "{error}\n{text:.300}");
        assert!(error.len() < 500 && !error.contains('\n'));
    }
    // Sound text, senseless numbers: those edits are left out and named.
    let senseless = with(&format!(
        r#""lights": {{"wall": {{"kind": {{"Disc": {{"center": [0, 0, 0], "normal": [0, 0, 0], "radius": 1, "radiance": {{"r": 1, "g": 1, "b": 1}}}}}}}}}},
        "objects": {{"wall": {{"transform": [0,0,0, 0,0,0, 0,0,0, 1,2,3]}}, "ball": {{"mesh": 99}}, "": {{"mesh": "nobody"}}}},
        "added_lights": [{}], "added_objects": [{{"name": "x", "mesh": 99, "transform": [1,0,0, 0,1,0, 0,0,1, 1,2,3]}}],
        "materials": {{"wall": {{"emission": {{"r": 1e30, "g": 0, "b": 0}}}}}},
        "emitters": [{{"added_light": 0, "share": 1}}, {{"added_object": 7, "material": "wall", "share": 1}}]"#,
        point(r#"{"r": 1e38, "g": 1, "b": 1}"#)
    ));
    let document = read(&senseless).expect("sound text");
    let (made, lost) = document.apply(named());
    assert_eq!(lost.len(), 9, "{lost:#?}");
    let expected = Scene { reference: made.reference.clone(), ..named() };
    assert_eq!(bits(&made), bits(&expected));
    World::new(made);
    let short = Limits { json_bytes: 50, ..Limits::default() };
    let error =
        Document::read(Path::new("a"), with("\"layers\": 4").as_bytes(), &short).expect_err("too long");
    assert!(matches!(error, Error::OverLimit { limit: 50, option: "--max-json-bytes", .. }), "{error}");
    let few = Limits { nodes: 10, ..Limits::default() };
    let many = with(&format!("\"desk\": [{}]", vec!["{}"; 20].join(",")));
    let error = Document::read(Path::new("a"), many.as_bytes(), &few).expect_err("too many");
    assert!(matches!(error, Error::OverLimit { limit: 10, .. }), "{error}");
}

/// The example of the manual is one.
#[test]
fn the_manual_shows_a_document() {
    let manual = include_str!("../../../docs/formats.md");
    let section = manual.split("## Saved edits").nth(1).expect("a section");
    let text = section.split("```json\n").nth(1).and_then(|t| t.split("```").next()).expect("an example");
    let document = read(text).expect("a sound document");
    assert_eq!((document.layers, document.scene.file.as_str()), (Some(16), "office.mgf"));
    assert!(document.apply(named()).1.len() > 5, "our stage is no office");
}
