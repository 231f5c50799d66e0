//! Messages that mean harm: valid ones, broken by chance. Nothing panics, nothing that is no number gets in, and undo leads
//! back to the beginning as if nothing had been.

use super::{Desk, Parts};
use crate::door::{Door, Role};
use crate::event::Inbox;
use crate::hub::Hub;
use crate::model::Model;
use crate::printer::Printer;
use crate::screen::Screen;
use crate::studio::{Studio, bare};
use crate::wire::{Do, Message};
use crate::{opening, state};
use lampyris::import;
use lampyris::scene::Scene;
use lampyris::world::World;
use std::path::Path;
use std::sync::Arc;

const VALID: [&str; 31] = [
    r#"{"do":"size","seq":2,"width":640,"height":480}"#,
    r#"{"do":"camera","seq":3,"eye":[0,0,1.6],"target":[1,0,1.6],"up":[0,0,1],"fov":60,"height":5,"near":0.5}"#,
    r#"{"do":"ask","seq":4,"id":1,"what":"point","frame":7,"x":10,"y":20.5}"#,
    r#"{"do":"ask","seq":4,"id":1,"what":"ray","origin":[1,2,3],"direction":[0,0,1]}"#,
    r#"{"do":"ask","seq":4,"id":1,"what":"light","point":[1,2,3],"normal":[0,1,0]}"#,
    r#"{"do":"begin","seq":5,"label":"drag"}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"level":0.5,"on":true,"name":"a"}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"color":{"mode":"kelvin","kelvin":2700,"tint":1}}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"color":{"mode":"xy","xy":[0.3,0.3]}}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"color":{"mode":"rgb","rgb":[1,0.5,0.25]}}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"place":{"position":[1,2,3],"scale":2,"rotation":[0,0,0,1]}}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"lamps":{"0":{"place":{"aim":[1,2,3],"inner":20,"outer":40}}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"groups":{"0":{"level":0.5,"on":false,"name":"b"}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"things":{"1":{"place":{"position":[1,2,3]},"hidden":true}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"materials":{"0":{"color":[0.1,0.5,0.9],"roughness":0.2}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"views":{"0":{"name":"c","eye":[1,2,3]}},"meters":{"0":{"name":"d","kind":"surface","point":[1,2,3],"normal":[0,1,0],"target":500}}}}"#,
    r#"{"do":"set","seq":6,"patch":{"meters":{"0":null},"grids":{"0":{"name":"e","corner":[1,1,1],"u":[2,0,0],"v":[0,0,2],"normal":[0,1,0],"columns":4,"rows":3}}}}"#,
    r#"{"do":"add","seq":7,"lamp":{"kind":"spot","flux":300,"place":{"position":[1,4,1],"aim":[3,0.5,3]}}}"#,
    r#"{"do":"copy","seq":8,"lamps":[1],"count":2,"step":[0.1,0,0]}"#,
    r#"{"do":"remove","seq":9,"lamps":[1]}"#,
    r#"{"do":"group","seq":9,"lamps":[0,1],"name":"row"}"#,
    r#"{"do":"group","seq":9,"lamps":[0]}"#,
    r#"{"do":"end","seq":10,"label":"dragged"}"#,
    r#"{"do":"look","seq":11,"what":"store","name":"evening"}"#,
    r#"{"do":"look","seq":11,"what":"recall","id":0,"seconds":2}"#,
    r#"{"do":"display","seq":12,"patch":{"ev":3,"tone":"filmic","white":{"kelvin":4000,"tint":1},"false_color":{"quantity":"lux","low":1,"high":500,"scale":"log","palette":"viridis","lines":5}}}"#,
    r#"{"do":"display","seq":12,"patch":{"false_color":{"quantity":"difference","against":0,"low":-500,"high":500,"scale":"linear","palette":"diverging","lines":true}}}"#,
    r#"{"do":"reach","seq":13,"most":2}"#,
    r#"{"do":"solo","seq":13,"lamps":[0]}"#,
    r#"{"do":"reach","seq":14,"maintenance":0.8}"#,
    r#"{"do":"undo","seq":14}"#,
];

const TOKENS: [&str; 18] = [
    "1e999",
    "-1",
    "-0.0",
    "1e38",
    "1e-45",
    "null",
    "true",
    "{}",
    "[]",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "\"\"",
    "\"\\u0000\\ud800\"",
    "NaN",
    "[0,0,0]",
    "99",
    "\u{202e}",
];

/// Chance from a seed (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    /// A message with a word in the place of one of its words, or broken otherwise; now and then one that is whole.
    fn message(&mut self) -> Vec<u8> {
        let mut text = VALID[self.below(VALID.len())].as_bytes().to_vec();
        for _ in 0..self.below(3) {
            let at = self.below(text.len().max(1)).min(text.len());
            let end = (at + self.below(12)).min(text.len());
            match self.below(9) {
                0 => text.truncate(at),
                1 => drop(text.drain(at..end)),
                2 => {
                    let part = text[at..end].to_vec();
                    drop(text.splice(at..at, part));
                }
                3 => {
                    if let Some(byte) = text.get_mut(at) {
                        *byte ^= 1 << self.below(8);
                    }
                }
                4 if self.below(20) == 0 => drop(text.splice(at..at, vec![b'['; 10_000])),
                4 if self.below(20) == 0 => drop(text.splice(at..at, vec![b'x'; 60_000])),
                _ => {
                    // From here on the first value is another one.
                    let is = |byte: &u8| byte.is_ascii_digit() || *byte == b'"';
                    let Some(from) = text[at..].iter().position(is).map(|from| at + from) else { continue };
                    let long = text[from + 1..].iter().position(|byte| b",}]:".contains(byte)).unwrap_or(0);
                    let token = TOKENS[self.below(TOKENS.len())];
                    drop(text.splice(from..from + 1 + long, token.bytes()));
                }
            }
        }
        text
    }
}

/// A desk that nobody renders for.
pub(super) fn desk(model: &Model, scene: &Scene) -> Desk {
    let parts = Parts {
        hub: Arc::new(Hub::new()),
        door: Arc::new(Door::new("127.0.0.1:4000".parse().unwrap(), None).unwrap()),
        studio: Arc::new(Studio::new()),
        screen: Arc::new(Screen::new()),
        // No such program: nothing is printed.
        printer: Arc::new(Printer::new("no such program".into())),
        album: Arc::default(),
        inbox: Inbox::new().0,
        file: "cornell.mgf".into(),
        build: "".into(),
        ends_alone: false,
        enough: 8,
    };
    let mut desk = Desk::new(parts).unwrap();
    (desk.model, desk.scene, desk.editor) = (model.clone(), Some(scene.clone()), Some(1));
    desk.clients.insert(1, Role::Edit);
    desk
}

/// What undo must bring back.
fn undone(desk: &Desk, opening: &Model) -> String {
    let Model { lamps, groups, things, materials, notes } = &desk.model;
    let (lamps, groups) = (&lamps[..opening.lamps.len()], &groups[..opening.groups.len()]);
    format!("{lamps:#?}{groups:#?}{things:#?}{materials:#?}{notes:#?}")
}

fn hear_hostile(seed: u64, count: usize) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cornell.mgf");
    let loaded = import::load(&file, &import::Options::default()).unwrap();
    let mut world = World::new(loaded.scene);
    world.separate(16).unwrap();
    let (opening, scene) = (opening::open(&world), bare(world.scene()));
    let (mut dice, mut followed) = (Dice(seed), 0);
    let mut steps = 0;
    for _ in 0..count / 500 {
        let mut desk = desk(&opening, &scene);
        let before = undone(&desk, &opening);
        for _ in 0..500 {
            let bytes = dice.message();
            let Ok(message) = std::str::from_utf8(&bytes)
                .map_err(drop)
                .and_then(|text| Message::read(text).map_err(|(_, why)| assert!(!why.is_empty())))
            else {
                continue;
            };
            followed += 1;
            desk.hear(1, message);
            desk.editor = Some(1);
            assert!(desk.model.lamps.iter().all(|lamp| desk.model.level_of(lamp).is_finite()));
        }
        let whole = state::whole(&desk.model, desk.scene.as_ref().unwrap());
        assert!(whole["lamps"].is_object());
        desk.end_gesture();
        steps += desk.history.steps();
        for _ in 0..=desk.history.steps() {
            desk.hear(1, Message { seq: 1, what: Do::Undo });
        }
        assert_eq!(desk.history.steps(), 0);
        assert_alike(&undone(&desk, &opening), &before);
    }
    assert!(followed > count / 10 && followed < count && steps > count / 1000);
}

/// The first lines that differ: all of them are too many to read.
fn assert_alike(now: &str, before: &str) {
    let differ = now.lines().zip(before.lines()).enumerate().find(|(_, (a, b))| a != b);
    assert!(now == before, "line {differ:?} of {}", before.lines().count());
}

#[test]
fn hostile_messages() {
    hear_hostile(1, 20_000);
}

#[test]
#[ignore = "long: a minute"]
fn a_hundred_thousand_hostile_messages() {
    hear_hostile(2, 100_000);
}
