//! The program is killed at random moments while edits stream in: the document is whole whenever that is, and holds every edit
//! that was made more than a second before.

#![allow(clippy::print_stdout, reason = "what was measured is told")]

mod support;

use serde_json::{Value, json};
use std::time::{Duration, Instant};
use support::desk::{Client, Desk, Heard};
use support::dice::Dice;
use support::{Folder, run};

const DOCUMENT: &str = "cornell.mgf.lampyris.json";

/// Level of the lamp in the document, if there is one.
fn saved(folder: &Folder) -> Option<f64> {
    let bytes = std::fs::read(folder.0.join(DOCUMENT)).ok()?;
    let document: Value = serde_json::from_slice(&bytes).expect("the document is whole");
    let done = run(folder, &format!("info {DOCUMENT}"));
    assert_eq!(done.code, 0, "{}", done.err);
    find(&document, "shall").and_then(|lamp| lamp["level"].as_f64())
}

/// The first value of a name, however deep.
fn find<'a>(value: &'a Value, name: &str) -> Option<&'a Value> {
    match value {
        Value::Object(fields) => fields.get(name).or_else(|| fields.values().find_map(|own| find(own, name))),
        Value::Array(all) => all.iter().find_map(|own| find(own, name)),
        _ => None,
    }
}

/// Raises the lamp's level step by step for a time; the steps that are known to be made, and when that was heard.
fn raise(client: &mut Client, step: &mut u32, time: Duration) -> Vec<(Instant, u32)> {
    let (began, first) = (Instant::now(), *step);
    let mut made = Vec::new();
    let mut asked = std::collections::BTreeMap::new();
    client.wait(Duration::from_millis(2));
    while began.elapsed() < time {
        // Some hundred and fifty a second, whatever the answers do.
        if f64::from(*step - first) < began.elapsed().as_secs_f64() * 150.0 {
            *step += 1;
            let level = f64::from(*step) / 1024.0;
            let seq = client.say(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}}));
            asked.insert(u64::from(seq), *step);
        }
        match client.hear() {
            Heard::Text(value) if value["is"] == "patch" => {
                let known = value["seq"].as_u64().and_then(|seq| asked.range(..=seq).next_back());
                made.extend(known.map(|(_, step)| (Instant::now(), *step)));
            }
            Heard::Text(value) => assert_ne!(value["is"], "refused", "{value}"),
            Heard::Closed => panic!("the desk hung up"),
            _ => {}
        }
    }
    made
}

/// Kills it so many times; returns the longest time that was lost.
fn kill_again_and_again(name: &str, seed: u64, times: usize) -> Duration {
    let folder = Folder::new(name);
    let mut dice = Dice(seed);
    let (mut step, mut longest) = (0, Duration::ZERO);
    for _ in 0..times {
        let before = saved(&folder);
        let file = if before.is_some() { DOCUMENT } else { "cornell.mgf" };
        let desk = Desk::start(&folder, &format!("{file} --size 32x24"));
        let mut client = desk.client(&desk.key);
        client.until(|value| value["is"] == "state");
        let level = client.state["lamps"]["0"]["level"].as_f64().unwrap();
        assert_eq!(level, before.unwrap_or(1.0));
        let time = Duration::from_secs_f64(dice.between(0.02, 2.0));
        let made = raise(&mut client, &mut step, time);
        let killed = Instant::now();
        desk.kill();
        let after = saved(&folder).unwrap_or(0.0);
        assert!(after >= before.unwrap_or(0.0), "{before:?} {after}");
        assert!(after <= f64::from(step) / 1024.0);
        // What is not in it was made a short time before.
        let lost = made.iter().find(|(_, step)| f64::from(*step) / 1024.0 > after);
        let lost = lost.map_or(Duration::ZERO, |(at, _)| killed.duration_since(*at));
        longest = longest.max(lost);
        assert!(lost < Duration::from_secs(1), "{lost:?} of edits are lost, killed after {time:?}");
    }
    println!("killed {times} times, at most {longest:?} lost; beside it lie {:?}", folder.files());
    longest
}

#[test]
fn killed_at_any_moment() {
    kill_again_and_again("killed", 1, 8);
}

#[test]
#[ignore = "long: two minutes and more"]
fn killed_a_hundred_times() {
    kill_again_and_again("killed-often", 2, 100);
}
