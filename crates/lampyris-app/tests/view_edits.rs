//! Edits by chance: whatever a client asks for that makes sense is done, and what is there in the end is what was asked for.

#![allow(clippy::print_stdout, reason = "what was measured is told")]

mod support;

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};
use support::desk::{Client, Desk, Heard};
use support::dice::Dice;
use support::{Folder, run};

/// Lamps that are added at most: who is taken away keeps the number.
const ADDED: usize = 12;

/// Looks that are kept at most.
const LOOKS: usize = 6;

/// Messages a second, acknowledgements apart: a desk hears 400, and hangs up on who says more for long.
const RATE: f64 = 300.0;

/// Edits that are sent before their answers are awaited.
const AT_ONCE: usize = 25;

/// What this test knows of faders: level and switch of lamps that are there, and of groups.
#[derive(Clone, Debug, Default, PartialEq)]
struct Faders {
    lamps: BTreeMap<usize, (f64, bool)>,
    groups: BTreeMap<usize, (f64, bool)>,
}

impl Faders {
    fn of(state: &Value) -> Faders {
        let all = |slice: &str| {
            let entries = state[slice].as_object().unwrap().iter();
            let fader = |(id, own): (&String, &Value)| {
                (id.parse().unwrap(), (own["level"].as_f64().unwrap(), own["on"] == true))
            };
            entries.map(fader).collect()
        };
        Faders { lamps: all("lamps"), groups: all("groups") }
    }
}

/// A designer without a plan, who remembers what the faders should stand at.
struct Designer {
    dice: Dice,
    faders: Faders,
    /// What they stood at after each step.
    steps: Vec<Faders>,
    at: usize,
    /// Faders in the looks that are stored, by step as well.
    looks: Vec<BTreeMap<usize, Faders>>,
    look: BTreeMap<usize, Faders>,
    /// Numbers that lamps were given.
    lamps: usize,
    things: Vec<Value>,
    materials: Vec<Value>,
}

impl Designer {
    fn new(seed: u64, state: &Value) -> Designer {
        let faders = Faders::of(state);
        let all = |slice: &str| state[slice].as_object().unwrap().values().cloned().collect();
        Designer {
            dice: Dice(seed),
            steps: vec![faders.clone()],
            at: 0,
            looks: vec![BTreeMap::new()],
            look: BTreeMap::new(),
            lamps: faders.lamps.len(),
            faders,
            things: all("things"),
            materials: all("materials"),
        }
    }

    fn some_lamp(&mut self) -> usize {
        let all: Vec<usize> = self.faders.lamps.keys().copied().collect();
        self.dice.of(&all)
    }

    fn point(&mut self) -> Value {
        let mut axis = || self.dice.between(0.5, 5.0);
        json!([axis(), axis(), axis()])
    }

    /// An edit that changes something.
    fn edit(&mut self) -> Value {
        let lamp = self.some_lamp();
        match self.dice.below(12) {
            0..=2 => self.dim(),
            3 => {
                let on = &mut self.faders.lamps.get_mut(&lamp).unwrap().1;
                *on = !*on;
                set("lamps", lamp, json!({"on": *on}))
            }
            4 => {
                let color = self.color();
                set("lamps", lamp, json!({"color": color}))
            }
            5 => {
                let groups: Vec<usize> = self.faders.groups.keys().copied().collect();
                let group = self.dice.of(&groups);
                let level = self.dice.between(0.0, 2.0);
                let on = self.dice.coin();
                self.faders.groups.insert(group, (level, on));
                set("groups", group, json!({"level": level, "on": on}))
            }
            6 => {
                let to = self.point();
                set("lamps", lamp, json!({"place": {"position": to}}))
            }
            7 => {
                let (thing, to) = (self.dice.below(self.things.len()), self.point());
                let place = json!({"position": to, "scale": self.dice.between(0.5, 1.5)});
                set("things", thing, json!({"place": place, "hidden": self.dice.below(4) == 0}))
            }
            8 => {
                let material = self.dice.below(self.materials.len());
                let mut share = || self.dice.between(0.05, 0.9);
                set("materials", material, json!({"color": [share(), share(), share()]}))
            }
            9 if self.lamps < ADDED => self.add(),
            9 | 10 => self.take_away(),
            _ if self.look.len() >= LOOKS => {
                let looks: Vec<usize> = self.look.keys().copied().collect();
                let id = self.dice.of(&looks);
                if self.look[&id] == self.faders {
                    return self.dim();
                }
                self.look.insert(id, self.faders.clone());
                json!({"do": "look", "what": "update", "id": id})
            }
            _ => {
                let id = self.look.keys().next_back().map_or(0, |last| last + 1);
                self.look.insert(id, self.faders.clone());
                json!({"do": "look", "what": "store"})
            }
        }
    }

    /// An edit that is like no other before it.
    fn dim(&mut self) -> Value {
        let (lamp, level) = (self.some_lamp(), self.dice.between(0.0, 3.0));
        self.faders.lamps.get_mut(&lamp).unwrap().0 = level;
        set("lamps", lamp, json!({"level": level}))
    }

    fn color(&mut self) -> Value {
        let dice = &mut self.dice;
        match dice.below(3) {
            0 => {
                json!({"mode": "kelvin", "kelvin": dice.between(1800.0, 9000.0), "tint": dice.between(-20.0, 20.0)})
            }
            1 => {
                json!({"mode": "rgb", "rgb": [dice.between(0.1, 1.0), dice.between(0.1, 1.0), dice.between(0.1, 1.0)]})
            }
            _ => json!({"mode": "xy", "xy": [dice.between(0.25, 0.45), dice.between(0.25, 0.45)]}),
        }
    }

    fn add(&mut self) -> Value {
        let own: Vec<usize> = self.faders.lamps.keys().copied().filter(|id| *id > 0).collect();
        let group = self.faders.groups.len();
        if self.dice.coin() && !own.is_empty() && self.lamps + 2 <= ADDED {
            let lamp = self.dice.of(&own);
            for _ in 0..2 {
                self.faders.lamps.insert(self.lamps, self.faders.lamps[&lamp]);
                self.lamps += 1;
            }
            return json!({"do": "copy", "lamps": [lamp], "count": 2, "step": [0.1, 0.0, 0.2]});
        }
        if group == 1 {
            self.faders.groups.insert(1, (1.0, true));
        }
        self.faders.lamps.insert(self.lamps, (1.0, true));
        self.lamps += 1;
        let (kind, to, aim) =
            (self.dice.of(&["point", "spot", "sphere", "disc"]), self.point(), self.point());
        let mut place = json!({"position": to});
        if matches!(kind, "spot" | "disc") {
            place["aim"] = aim;
        }
        json!({"do": "add", "lamp": {"kind": kind, "flux": self.dice.between(10.0, 500.0), "place": place}})
    }

    /// One of the lamps that were added; a light dimmed where there is none.
    fn take_away(&mut self) -> Value {
        let own: Vec<usize> = self.faders.lamps.keys().copied().filter(|id| *id > 0).collect();
        if own.len() < 3 {
            return self.dim();
        }
        let lamp = self.dice.of(&own);
        self.faders.lamps.remove(&lamp);
        json!({"do": "remove", "lamps": [lamp]})
    }

    /// What was done is a step.
    fn step(&mut self) {
        self.steps.truncate(self.at + 1);
        self.looks.truncate(self.at + 1);
        self.steps.push(self.faders.clone());
        self.looks.push(self.look.clone());
        self.at += 1;
    }

    fn stand_at(&mut self, step: usize) {
        self.at = step;
        (self.faders, self.look) = (self.steps[step].clone(), self.looks[step].clone());
    }

    /// What is done next: one edit, a gesture, a step back or forth, or another look at it.
    fn next(&mut self) -> Vec<Value> {
        match self.dice.below(20) {
            0 | 1 if self.at > 0 => {
                self.stand_at(self.at - 1);
                vec![json!({"do": "undo"})]
            }
            2 if self.at + 1 < self.steps.len() => {
                self.stand_at(self.at + 1);
                vec![json!({"do": "redo"})]
            }
            3..=5 => {
                let mut all = vec![json!({"do": "begin", "label": "a gesture"}), self.dim()];
                (0..self.dice.below(6)).for_each(|_| all.push(self.edit()));
                all.push(self.dim());
                if self.dice.below(3) == 0 {
                    self.stand_at(self.at);
                    all.push(json!({"do": "cancel"}));
                } else {
                    self.step();
                    all.push(json!({"do": "end", "label": "a gesture that was"}));
                }
                all
            }
            6 if !self.look.is_empty() => {
                let looks: Vec<usize> = self.look.keys().copied().collect();
                let id = self.dice.of(&looks);
                let recalled = self.look[&id].clone();
                for (lamp, own) in recalled.lamps {
                    self.faders.lamps.entry(lamp).and_modify(|now| *now = own);
                }
                for (group, own) in recalled.groups {
                    self.faders.groups.entry(group).and_modify(|now| *now = own);
                }
                let seconds = self.dice.between(0.0, 0.2);
                let recall = json!({"do": "look", "what": "recall", "id": id, "seconds": seconds});
                let all =
                    vec![json!({"do": "begin", "label": "recall"}), recall, self.dim(), json!({"do": "end"})];
                self.step();
                all
            }
            7 => {
                let lamps = if self.dice.coin() { vec![self.some_lamp()] } else { Vec::new() };
                vec![json!({"do": "solo", "lamps": lamps})]
            }
            8 => {
                let x = self.dice.between(2.0, 3.5);
                vec![
                    json!({"do": "camera", "eye": [x, 2.7, -8.0], "target": [2.78, 2.7, 0.0], "up": [0, 1, 0], "fov": 40}),
                ]
            }
            _ => {
                let edit = self.edit();
                self.step();
                vec![edit]
            }
        }
    }
}

fn set(slice: &str, id: usize, patch: Value) -> Value {
    json!({"do": "set", "patch": {slice: {id.to_string(): patch}}})
}

/// Waits until all that was said was followed; nothing of it may be refused.
fn all_followed(client: &mut Client) {
    let before = client.told;
    client.say(json!({"do": "display", "patch": {"tone": "filmic"}}));
    loop {
        match client.hear() {
            Heard::Text(value) if value["is"] == "refused" => {
                panic!("refused: {value}")
            }
            // A display is told with the number of the message before it.
            Heard::Text(value)
                if value["patch"]["display"].is_object()
                    && value["seq"].as_u64() >= Some(u64::from(before)) =>
            {
                return;
            }
            Heard::Closed => panic!("the desk hung up"),
            _ => {}
        }
    }
}

/// Waits until so much may have been said.
fn rest(began: Instant, said: usize) {
    let due = Duration::from_secs_f64(said as f64 / RATE);
    std::thread::sleep(due.saturating_sub(began.elapsed()));
}

/// The pixels of a final frame.
fn final_picture(client: &mut Client) -> Vec<u8> {
    let seq = client.say(json!({"do": "solo"}));
    let frame = client.until_frame(|frame| frame.kind == 2 && frame.seq >= seq);
    image::load_from_memory(&frame.picture).unwrap().to_rgb8().into_raw()
}

/// What a client keeps of a state that is not a measure of how far the picture is.
fn lasting(state: &Value) -> Value {
    let slices = ["lamps", "groups", "things", "materials", "views", "looks", "meters", "grids"];
    let kept = slices.map(|slice| (slice.to_owned(), state[slice].clone()));
    let mut all = Value::Object(kept.into_iter().collect());
    // Thumbnails come when the picture has settled.
    for look in all["looks"].as_object_mut().unwrap().values_mut() {
        look["picture"] = Value::Null;
    }
    all
}

/// As much, but for the layers that lamps were taken apart into, which stay apart.
fn visible(state: &Value) -> Value {
    let mut all = lasting(state);
    for lamp in all["lamps"].as_object_mut().unwrap().values_mut() {
        lamp["layer"] = Value::Null;
    }
    all
}

/// Memory that the program has [KiB].
fn resident(desk: &Desk) -> f64 {
    let status = std::fs::read_to_string(format!("/proc/{}/status", desk.child.id())).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    line.and_then(|line| line.split_whitespace().next()).and_then(|n| n.parse().ok()).unwrap_or(0.0)
}

/// Slope of a line through points by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let over: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    over / points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
}

/// Edits by chance; returns edits and memory [KiB] by the way.
fn edit_by_chance(name: &str, seed: u64, edits: usize) -> Vec<(f64, f64)> {
    let folder = Folder::new(name);
    let desk = Desk::start(&folder, "cornell.mgf --size 32x24 --batches 4 --threads 2");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let opening = client.state.clone();
    let first = final_picture(&mut client);
    let ev = client.state["display"]["ev"].as_f64().unwrap();
    let mut designer = Designer::new(seed, &client.state);
    let (mut done, mut waiting, mut memory) = (0, 0, Vec::new());
    let began = Instant::now();
    while done < edits {
        for message in designer.next() {
            client.say(message);
            (done, waiting) = (done + 1, waiting + 1);
        }
        if waiting >= AT_ONCE || done >= edits {
            all_followed(&mut client);
            waiting = 0;
            rest(began, done);
            assert_eq!(Faders::of(&client.state), designer.faders, "after {done}");
            memory.push((done as f64, resident(&desk)));
        }
    }
    println!("{done} edits, {} steps, in {:.1} s", designer.at, began.elapsed().as_secs_f64());
    // Who was there all the time knows what one knows who comes anew.
    let mut other = desk.client(&desk.key);
    other.until(|value| value["is"] == "state");
    assert_eq!(client.state["lamps"], other.state["lamps"]);
    assert_eq!(client.state["groups"], other.state["groups"]);
    assert_eq!(lasting(&client.state), lasting(&other.state));
    drop(other);

    // What is seen in the end is what the program renders of the saved document by the command that the desk tells.
    client.say(json!({"do": "save"}));
    client.until(|value| value["patch"]["saved"]["state"] == "saved");
    let last = final_picture(&mut client);
    client.say(json!({"do": "ask", "id": 1, "what": "command"}));
    let answer = client.until(|value| value["is"] == "answer");
    let text = answer["text"].as_str().unwrap().replace('\'', "");
    assert!(text.contains(".lampyris.json"), "{text}");
    let args = text.strip_prefix("lampyris ").unwrap().replace("picture.png", "final.png");
    let rendered = run(&folder, &format!("{args} --quiet"));
    assert_eq!(rendered.code, 0, "{}", rendered.err);
    let rendered = image::load_from_memory(&folder.bytes("final.png")).unwrap().to_rgb8().into_raw();
    let differ = last.iter().zip(&rendered).filter(|(a, b)| a != b).count();
    assert_eq!((last.len(), differ), (rendered.len(), 0), "{args}");

    // Undone to the beginning it is as it was.
    let look = &opening["camera"];
    let mut camera = json!({"do": "camera"});
    for field in ["eye", "target", "up", "fov"] {
        camera[field] = look[field].clone();
    }
    client.say(camera);
    let began = Instant::now();
    for step in 0..designer.at {
        client.say(json!({"do": "undo"}));
        if step % AT_ONCE == 0 {
            all_followed(&mut client);
            rest(began, step);
        }
    }
    all_followed(&mut client);
    client.say(json!({"do": "display", "patch": {"ev": ev}}));
    assert!(client.ask(json!({"do": "undo"})).unwrap_err().contains("nothing to undo"));
    assert_eq!(Faders::of(&client.state), Faders::of(&opening));
    let (now, then) = (visible(&client.state), visible(&opening));
    for slice in ["lamps", "groups", "things", "materials", "looks"] {
        assert_eq!(now[slice], then[slice], "{slice}");
    }
    let again = final_picture(&mut client);
    let differ = first.iter().zip(&again).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 0, "of {}", first.len());
    assert_eq!(desk.end(), 130);
    memory
}

/// What a hundred and fifty edits leave.
#[test]
fn edits_by_chance() {
    edit_by_chance("edits", 1, 150);
}

/// Ten thousand edits, and memory: growth by edit over the second half of them, by least squares, extrapolated to an hour of an
/// edit each second, which is more than hands do.
#[test]
#[ignore = "long: a minute or more"]
fn ten_thousand_edits_by_chance() {
    let memory = edit_by_chance("many-edits", 2, 10_000);
    let second = &memory[memory.len() / 2..];
    let hourly = slope(second) * 3600.0 / 1024.0;
    println!("{:?} to {:?}: {hourly:.3} MiB/h", second.first(), second.last());
    assert!(hourly <= 1.0, "{hourly} MiB/h");
}
