//! A hand that drags faster than the line carries: the last value wins, and it is one step of undo.

#![allow(clippy::print_stdout, reason = "what was measured is told")]

mod support;

use serde_json::json;
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use support::Folder;
use support::desk::{Client, Desk, Heard};

/// Values a second, and how many.
const RATE: f64 = 200.0;
const VALUES: u32 = 600;

/// A line to an address on which all bytes take so long, either way; its own address.
fn line(to: &str, delay: Duration) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let own = listener.local_addr().unwrap().to_string();
    let to = to.to_owned();
    std::thread::spawn(move || {
        let (near, _) = listener.accept().unwrap();
        let far = TcpStream::connect(to).unwrap();
        for (from, to) in [(&near, &far), (&far, &near)] {
            to.set_nodelay(true).unwrap();
            carry(from.try_clone().unwrap(), to.try_clone().unwrap(), delay);
        }
    });
    own
}

/// Carries bytes one way, each for so long.
fn carry(mut from: TcpStream, mut to: TcpStream, delay: Duration) {
    let (put, take) = mpsc::channel::<(Instant, Vec<u8>)>();
    std::thread::spawn(move || {
        let mut bytes = vec![0; 1 << 16];
        while let Ok(count @ 1..) = from.read(&mut bytes) {
            if put.send((Instant::now() + delay, bytes[..count].to_vec())).is_err() {
                return;
            }
        }
    });
    std::thread::spawn(move || {
        for (due, bytes) in take {
            std::thread::sleep(due.saturating_duration_since(Instant::now()));
            if to.write_all(&bytes).is_err() {
                return;
            }
        }
    });
}

/// Drags the lamp's level; the most values that were under way at once.
fn drag(client: &mut Client) -> u32 {
    let first = client.seq + 1;
    let (began, mut sent, mut answered, mut most) = (Instant::now(), 0, 0, 0);
    client.wait(Duration::from_millis(1));
    let mut numbers = Vec::new();
    while sent < VALUES {
        while sent < VALUES && f64::from(sent) < began.elapsed().as_secs_f64() * RATE {
            sent += 1;
            let level = f64::from(sent) / 1024.0;
            numbers.push(client.say(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}})));
        }
        match client.hear() {
            Heard::Text(value) if value["patch"]["lamps"].is_object() => {
                let seq = value["seq"].as_u64().unwrap_or(0) as u32;
                answered = numbers.partition_point(|own| *own <= seq) as u32;
                assert!(seq >= first);
            }
            Heard::Text(value) => assert_ne!(value["is"], "refused", "{value}"),
            Heard::Closed => panic!("the desk hung up"),
            _ => {}
        }
        most = most.max(sent - answered);
    }
    most
}

fn torture(delay: Duration) {
    let folder = Folder::new(&format!("torture-{}", delay.as_millis()));
    let desk = Desk::start(&folder, "cornell.mgf --size 160x120");
    let mut client = desk.client_by(&desk.key, &line(&desk.host, delay));
    client.until(|value| value["is"] == "state");
    client.say(json!({"do": "begin", "label": "drag"}));
    let most = drag(&mut client);
    let last = client.seq;
    let let_go = Instant::now();
    client.say(json!({"do": "end"}));
    client.wait(Duration::from_secs(60));
    let frame = client.until_frame(|frame| frame.seq >= last);
    let late = let_go.elapsed();
    let answers = client.ask(json!({"do": "set", "patch": {}})).unwrap();
    assert!(answers["lamps"].is_null(), "{answers}");
    let last_level = f64::from(VALUES) / 1024.0;
    assert_eq!(client.state["lamps"]["0"]["level"], last_level);
    assert_eq!(client.state["history"]["steps"], 1);
    println!("{delay:?}: at most {most} under way; frame {} shows the last {late:?} after it", frame.number);
    // What is under way is what the line holds, and half a second of a slow machine: nothing piles up.
    let way = 2.0 * delay.as_secs_f64() + 0.5;
    assert!(f64::from(most) < RATE * way, "{most} values are under way");
    assert!(late.as_secs_f64() < way + 1.0, "the picture comes {late:?} late");
    client.ask(json!({"do": "undo"})).unwrap();
    assert_eq!(client.state["lamps"]["0"]["level"], 1.0);
    assert!(client.ask(json!({"do": "undo"})).is_err());
    assert_eq!(desk.end(), 130);
}

#[test]
fn a_drag_over_lines_of_any_length() {
    [0, 50, 300].map(Duration::from_millis).into_iter().for_each(torture);
}
