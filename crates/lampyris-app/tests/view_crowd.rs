//! A desk in a crowd: many who look on, some who never read, and connections that come to nothing. The editor does not notice,
//! and who takes part in nothing is let go.

#![cfg(target_os = "linux")]
#![allow(clippy::print_stdout, reason = "what was measured is told")]

mod support;

use serde_json::json;
use std::io::Write;
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use support::Folder;
use support::desk::{Client, Desk, Heard};

/// Who never reads, and connections that were begun and left.
const DEAF: usize = 10;
const BEGUN: usize = 200;

/// Sockets that the program has.
fn sockets(desk: &Desk) -> usize {
    let all = std::fs::read_dir(format!("/proc/{}/fd", desk.child.id())).unwrap();
    let links = all.filter_map(|entry| std::fs::read_link(entry.ok()?.path()).ok());
    links.filter(|to| to.to_string_lossy().starts_with("socket:")).count()
}

/// Memory that the program has [MiB].
fn resident(desk: &Desk) -> f64 {
    let status = std::fs::read_to_string(format!("/proc/{}/status", desk.child.id())).unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap();
    line.split_whitespace().next().unwrap().parse::<f64>().unwrap() / 1024.0
}

/// Those who look on, five pictures a second each.
struct Crowd {
    over: Arc<AtomicBool>,
    /// Pictures that each has seen.
    seen: Vec<Arc<AtomicU32>>,
    threads: Vec<JoinHandle<()>>,
    deaf: Vec<Client>,
    begun: Vec<TcpStream>,
}

impl Crowd {
    fn come(desk: &Desk, key: &str, watchers: usize) -> Crowd {
        let begun = (0..BEGUN).map(|k| {
            let mut stream = TcpStream::connect(&desk.host).unwrap();
            // Some say nothing at all, some begin.
            stream.write_all(&b"GET /wire HTTP/1.1\r\nHost: 127"[..k % 29]).unwrap();
            stream
        });
        let begun = begun.collect();
        let deaf = (0..DEAF).map(|_| desk.client(key)).collect();
        let over = Arc::new(AtomicBool::new(false));
        let mut crowd = Crowd { over, seen: Vec::new(), threads: Vec::new(), deaf, begun };
        for _ in 0..watchers {
            let (mut client, over) = (desk.client(key), crowd.over.clone());
            let seen = Arc::new(AtomicU32::new(0));
            crowd.seen.push(seen.clone());
            client.wait(Duration::from_secs(1));
            crowd.threads.push(std::thread::spawn(move || {
                while !over.load(Ordering::Relaxed) {
                    match client.hear() {
                        Heard::Frame => {
                            seen.fetch_add(1, Ordering::Relaxed);
                            std::thread::sleep(Duration::from_millis(200));
                        }
                        Heard::Closed => return,
                        _ => {}
                    }
                }
            }));
        }
        crowd
    }

    fn go(self) {
        self.over.store(true, Ordering::Relaxed);
        drop((self.deaf, self.begun));
        self.threads.into_iter().for_each(|thread| thread.join().unwrap());
    }
}

/// A key to look on.
fn watch_key(client: &mut Client) -> String {
    client.say(json!({"do": "links", "what": "make", "role": "watch"}));
    let links = client.until(|value| value["is"] == "links");
    let address = links["links"][1]["address"].as_str().unwrap();
    address.split_once('#').unwrap().1.to_owned()
}

/// From a level that is set to the frame that has it [ms], so many times.
fn latencies(client: &mut Client, count: u32) -> Vec<f64> {
    let dim = |k: u32| {
        let level = 0.5 + f64::from(k % 64) / 128.0;
        let seq = client.say(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}}));
        let said = Instant::now();
        client.until_frame(|frame| frame.seq >= seq);
        let passed = said.elapsed();
        // The hand rests now and then, and hears what is said meanwhile.
        let rest = Instant::now();
        while let Some(left) = Duration::from_millis(60).checked_sub(rest.elapsed()).filter(|d| !d.is_zero())
        {
            client.wait(left);
            client.hear();
        }
        client.wait(Duration::from_secs(60));
        passed.as_secs_f64() * 1e3
    };
    (0..count).map(dim).collect()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Who never reads is gone within thirty seconds, and who never says what it wants; those who look on see all the time.
#[test]
fn who_takes_no_part_is_let_go() {
    let folder = Folder::new("crowd");
    let desk = Desk::start(&folder, "cornell.mgf --size 64x48");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let key = watch_key(&mut client);
    let before = (sockets(&desk), resident(&desk));
    let came = Instant::now();
    let crowd = Crowd::come(&desk, &key, 10);
    let all = sockets(&desk);
    assert!(all >= before.0 + DEAF + 10, "{all}");
    let mut most = 0.0_f64;
    let wanted = before.0 + 10;
    while sockets(&desk) > wanted {
        assert!(came.elapsed() < Duration::from_secs(32), "{} sockets, not {wanted}", sockets(&desk));
        latencies(&mut client, 3);
        most = most.max(resident(&desk));
    }
    println!(
        "{all} sockets, {wanted} after {:?}; {:.0} MiB, then at most {most:.0}",
        came.elapsed(),
        before.1
    );
    assert!(most < before.1 + 64.0, "{most} MiB");
    let seen: Vec<u32> = crowd.seen.iter().map(|seen| seen.load(Ordering::Relaxed)).collect();
    latencies(&mut client, 10);
    for (now, then) in crowd.seen.iter().zip(seen) {
        assert!(now.load(Ordering::Relaxed) > then, "one who looks on sees nothing any more");
    }
    crowd.go();
    assert_eq!(desk.end(), 130);
}

/// A hundred who look on cost the editor less than a fifth. Measured in turns with and without them on one machine, whose
/// threads their clients share: of each turn the median, of the turns the median of their ratios.
#[test]
#[ignore = "long: minutes, and a machine that does nothing else"]
fn a_crowd_costs_the_editor_little() {
    let folder = Folder::new("hundred");
    let desk = Desk::start(&folder, "cornell.mgf --size 320x240 --batches 1000000");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let key = watch_key(&mut client);
    latencies(&mut client, 20);
    let (idle, before) = (sockets(&desk), resident(&desk));
    let (mut ratios, mut most) = (Vec::new(), 0.0_f64);
    for _ in 0..5 {
        let alone = median(&mut latencies(&mut client, 60));
        let crowd = Crowd::come(&desk, &key, 100);
        latencies(&mut client, 10);
        let among = median(&mut latencies(&mut client, 60));
        most = most.max(resident(&desk));
        let seen: u32 = crowd.seen.iter().map(|seen| seen.load(Ordering::Relaxed)).sum();
        println!("alone {alone:.1} ms, among a hundred {among:.1} ms; {seen} pictures seen, {most:.0} MiB");
        ratios.push(among / alone);
        crowd.go();
        let gone = Instant::now();
        while sockets(&desk) > idle && gone.elapsed() < Duration::from_secs(30) {
            latencies(&mut client, 1);
        }
    }
    let ratio = median(&mut ratios);
    println!("{ratio:.2} times as long; {before:.0} MiB alone, at most {most:.0}");
    assert!(most < before + 128.0, "{most} MiB");
    assert!(ratio < 1.2, "{ratios:?}");
}
