//! Files that go, break or cannot be written while a desk is open: it says so, goes on, and loses nothing.

#![allow(clippy::print_stdout, reason = "what was measured is told")]

mod support;

use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use support::Folder;
use support::desk::{Client, Desk};

fn level(client: &mut Client, level: f64) -> Result<Value, String> {
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}}))
}

/// Sets a level and waits until it is seen.
fn shows(client: &mut Client, level: f64) {
    let seq = client.say(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}}));
    client.until_frame(|frame| frame.seq >= seq);
}

/// Waits until it is said of saving what is looked for; what is said.
fn saved(client: &mut Client, wanted: &str) -> Value {
    let value = client.until(|value| value["patch"]["saved"]["state"] == wanted);
    value["patch"]["saved"].clone()
}

/// Without its file a scene is edited and saved all the same; broken it is not taken; whole again it is, with the edits.
#[test]
fn a_scene_that_goes_breaks_and_comes_back() {
    let folder = Folder::new("goes");
    let desk = Desk::start(&folder, "cornell.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let file = folder.0.join("cornell.mgf");
    let text = std::fs::read_to_string(&file).unwrap();

    std::fs::remove_file(&file).unwrap();
    level(&mut client, 0.5).unwrap();
    saved(&mut client, "saved");
    assert!(folder.files().contains(&"cornell.mgf.lampyris.json".into()), "{:?}", folder.files());

    folder.put("cornell.mgf", "m light =\n\tsides one two");
    let broken = client.until(|value| value["what"] == "broken");
    assert!(broken["why"].as_str().unwrap().contains("cornell.mgf"), "{broken}");
    shows(&mut client, 0.25);

    folder.put("cornell.mgf", &text);
    let back = client.until(|value| value["what"] == "reloaded");
    assert_eq!(back["lost"], json!([]), "{back}");
    assert_eq!(client.state["lamps"]["0"]["level"], 0.25);
    client.ask(json!({"do": "undo"})).unwrap();
    assert_eq!(client.state["lamps"]["0"]["level"], 0.5);
    assert_eq!(desk.end(), 130);
    let document: Value = serde_json::from_slice(&folder.bytes("cornell.mgf.lampyris.json")).unwrap();
    assert!(document.to_string().contains("\"level\":0.5"), "{document}");
}

/// A small disk of a test's own, away at the end.
struct Disk(PathBuf);

impl Disk {
    /// `None` where this may not be done.
    fn mount(at: &Path) -> Option<Disk> {
        std::fs::create_dir_all(at).unwrap();
        let args = ["-t", "tmpfs", "-o", "size=256k", "lampyris-test"];
        let done = Command::new("mount").args(args).arg(at).output().ok()?;
        done.status.success().then(|| Disk(at.to_owned()))
    }

    fn remount(&self, how: &str) {
        let done =
            Command::new("mount").args(["-o", &format!("remount,{how}")]).arg(&self.0).status().unwrap();
        assert!(done.success());
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg("-l").arg(&self.0).status();
    }
}

/// A desk on a scene on a small disk; `None` where there can be none.
fn on_a_disk(folder: &Folder) -> Option<Disk> {
    let disk = Disk::mount(&folder.0.join("disk"));
    match &disk {
        Some(disk) => drop(std::fs::copy(folder.0.join("cornell.mgf"), disk.0.join("cornell.mgf")).unwrap()),
        None => println!("no disk may be mounted here: nothing is tested"),
    }
    disk
}

/// Where the disk is full it is said, edits go on, and they are written once there is room, without another edit.
#[test]
fn a_full_disk() {
    let folder = Folder::new("full");
    let Some(disk) = on_a_disk(&folder) else { return };
    let desk = Desk::start(&folder, "disk/cornell.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    level(&mut client, 0.5).unwrap();
    saved(&mut client, "saved");
    let document = disk.0.join("cornell.mgf.lampyris.json");
    let before = std::fs::read(&document).unwrap();

    let filler = disk.0.join("filler");
    assert!(std::fs::write(&filler, vec![1; 1 << 20]).is_err());
    level(&mut client, 0.25).unwrap();
    let failed = saved(&mut client, "failed");
    println!("{failed}");
    assert!(!failed["why"].as_str().unwrap().is_empty());
    assert_eq!(std::fs::read(&document).unwrap(), before);
    shows(&mut client, 0.125);

    std::fs::remove_file(&filler).unwrap();
    let room = Instant::now();
    saved(&mut client, "saved");
    assert!(room.elapsed() < Duration::from_secs(10));
    let text = String::from_utf8(std::fs::read(&document).unwrap()).unwrap();
    assert!(text.contains("0.125"), "{text}");
    assert_eq!(desk.end(), 130);
}

/// Beside a scene in a folder that cannot be written to nothing is written, but in the user's own folder, and it says so.
#[test]
fn a_folder_that_cannot_be_written_to() {
    let folder = Folder::new("readonly");
    let Some(disk) = on_a_disk(&folder) else { return };
    disk.remount("ro");
    let desk = Desk::start(&folder, "disk/cornell.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    level(&mut client, 0.5).unwrap();
    let told = saved(&mut client, "saved");
    let file = PathBuf::from(told["file"].as_str().unwrap());
    assert!(file.starts_with(folder.0.join("state")), "{told}");
    assert!(told["why"].as_str().unwrap().contains("edits are kept in"), "{told}");
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains("0.5"), "{text}");
    assert_eq!(desk.end(), 130);
}
