//! The desk as a client finds it: who is let in, what edits do, and what remains of them.

mod support;

use serde_json::json;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use support::desk::{Client, Desk, Heard};
use support::{Folder, run};

/// Every combination of path, host, origin and cookie is let in or refused as docs/wire.md says.
#[test]
fn the_door_opens_to_its_own_page_alone() {
    let folder = Folder::new("door");
    let desk = Desk::start(&folder, "cube.mgf --size 32x24");
    let host = desk.host.clone();
    let port = host.split_once(':').unwrap().1.to_owned();
    let cookie = desk.cookie(&desk.key);
    let hosts = [
        (host.clone(), true),
        (format!("localhost:{port}"), true),
        ("evil.example".into(), false),
        (format!("evil.example:{port}"), false),
    ];
    let cookies = [
        (Some(cookie.clone()), true),
        (None, false),
        (Some(format!("{}x", cookie)), false),
        (Some("lampyris-0=1".into()), false),
    ];
    for (name, known) in &hosts {
        let origins = [
            (Some(format!("http://{name}")), true),
            (None, false),
            (Some("null".into()), false),
            (Some("http://evil.example".into()), false),
            (Some(format!("https://{name}")), false),
        ];
        for (origin, own) in &origins {
            for (cookie, valid) in &cookies {
                for (method, path) in
                    [("GET", "/"), ("GET", "/wire"), ("POST", "/enter"), ("GET", "/nothing"), ("DELETE", "/")]
                {
                    let changes = path == "/wire" || method != "GET";
                    let mut head = format!("{method} {path} HTTP/1.1\r\nHost: {name}");
                    origin.iter().for_each(|origin| head += &format!("\r\nOrigin: {origin}"));
                    cookie.iter().for_each(|cookie| head += &format!("\r\nCookie: {cookie}"));
                    let expected = match (*known, *own || (origin.is_none() && !changes), path) {
                        (false, _, _) => 421,
                        (true, false, _) => 403,
                        (_, _, "/enter") => 400,
                        (_, _, "/wire") => {
                            if *valid {
                                426
                            } else {
                                401
                            }
                        }
                        (_, _, "/nothing") => 404,
                        _ => {
                            if method == "GET" {
                                200
                            } else {
                                405
                            }
                        }
                    };
                    let (status, answer, _) = desk.request(&head, "");
                    assert_eq!(status, expected, "{head}\n{answer}");
                    assert!(answer.contains("content-security-policy: default-src 'self'"), "{answer}");
                    assert!(!answer.contains(&desk.key));
                }
            }
        }
    }
    assert_eq!(desk.end(), 130);
}

/// Links open to their role, one at a time edits, and who was let in by a link that is revoked goes.
#[test]
fn roles_links_and_the_pen() {
    let folder = Folder::new("roles");
    let desk = Desk::start(&folder, "cube.mgf --size 32x24");
    let mut first = desk.client(&desk.key);
    first.until(|value| value["is"] == "state");
    assert_eq!(first.state["editor"]["you"], true);
    first.say(json!({"do": "links", "what": "make", "role": "watch"}));
    let links = first.until(|value| value["is"] == "links");
    let link = &links["links"][1];
    let key = link["address"].as_str().unwrap().split_once('#').unwrap().1.to_owned();
    let mut watcher = desk.client(&key);
    watcher.until(|value| value["is"] == "state");
    for message in [
        json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.5}}}}),
        json!({"do": "undo"}),
        json!({"do": "camera", "eye": [0, 0, 0], "target": [1, 0, 0], "up": [0, 1, 0], "fov": 50}),
        json!({"do": "links", "what": "list"}),
        json!({"do": "edit", "what": "take"}),
        json!({"do": "size", "width": 100, "height": 100}),
    ] {
        assert!(watcher.ask(message.clone()).is_err(), "{message}");
    }
    // A second editor takes the pen; the first one's gesture is whole, and undone by the second.
    let mut second = desk.client(&desk.key);
    second.until(|value| value["is"] == "state");
    first.say(json!({"do": "begin", "label": "dim"}));
    first.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.25}}}})).unwrap();
    assert!(second.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 2}}}})).is_err());
    second.say(json!({"do": "edit", "what": "take"}));
    first.until(|value| value["what"] == "taken");
    second.until(|value| value["patch"]["editor"]["you"] == true);
    assert!(first.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 3}}}})).is_err());
    second.ask(json!({"do": "undo"})).unwrap();
    assert_eq!(second.state["lamps"]["0"]["level"], 1.0);
    second.say(json!({"do": "links", "what": "revoke", "id": link["id"]}));
    let gone = Instant::now();
    while !matches!(watcher.hear(), Heard::Closed) {
        assert!(gone.elapsed() < Duration::from_secs(20), "the watcher is still there");
    }
}

/// A gesture is one step of undo, whatever is in it; what is cancelled never was.
#[test]
fn gestures_are_undone_whole() {
    let folder = Folder::new("gestures");
    let desk = Desk::start(&folder, "cornell.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let before = client.state["lamps"]["0"].clone();
    client.say(json!({"do": "begin", "label": "dim and colour"}));
    for step in 1..=50 {
        let level = f64::from(step) / 64.0;
        client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}})).unwrap();
    }
    client
        .ask(json!({"do": "set", "patch": {"lamps": {"0": {"color": {"mode": "kelvin", "kelvin": 2700}}}}}))
        .unwrap();
    client.say(json!({"do": "end"}));
    client.until(|value| value["patch"]["history"]["steps"] == 1);
    let after = client.state["lamps"]["0"].clone();
    assert_eq!(
        (after["level"].as_f64(), after["color"]["mode"].as_str()),
        (Some(50.0 / 64.0), Some("kelvin"))
    );
    client.ask(json!({"do": "undo"})).unwrap();
    assert_eq!(client.state["lamps"]["0"], before);
    client.until(|value| value["patch"]["history"]["redo"] == "dim and colour");
    client.ask(json!({"do": "redo"})).unwrap();
    assert_eq!(client.state["lamps"]["0"], after);
    client.say(json!({"do": "begin", "label": "never"}));
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"on": false}}}})).unwrap();
    client.ask(json!({"do": "cancel"})).unwrap();
    assert_eq!(client.state["lamps"]["0"], after);
    // What makes no sense changes nothing.
    for bad in [
        json!({"level": -1}),
        json!({"level": 1e9}),
        json!({"color": {"kelvin": 5}}),
        json!({"place": {"position": [1e9, 0, 0]}}),
        json!({"group": 99}),
    ] {
        assert!(client.ask(json!({"do": "set", "patch": {"lamps": {"0": bad}}})).is_err());
    }
    assert!(client.ask(json!({"do": "set", "patch": {"lamps": {"99": {"level": 1}}}})).is_err());
    assert_eq!(client.state["lamps"]["0"], after);
}

/// The pixels of a final frame.
fn final_picture(client: &mut Client, seq: u32) -> image::RgbImage {
    let frame = client.until_frame(|frame| frame.kind == 2 && frame.seq >= seq);
    image::load_from_memory(&frame.picture).unwrap().to_rgb8()
}

/// What is on the screen in the end is what `lampyris render` makes of the saved document.
#[test]
fn the_final_picture_is_the_renderers() {
    let folder = Folder::new("final");
    let desk = Desk::start(&folder, "cornell.mgf --size 48x32 --batches 8");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let swatch = client.state["lamps"]["0"]["swatch"].clone();
    let lamp =
        json!({"kind": "spot", "flux": 300, "place": {"position": [1.0, 4.0, 1.0], "aim": [3.0, 0.5, 3.0]}});
    client.ask(json!({"do": "add", "lamp": lamp})).unwrap();
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.4, "color": {"mode": "kelvin", "kelvin": 3000}}}}})).unwrap();
    client
        .ask(json!({"do": "set", "patch": {"things": {"1": {"place": {"position": [1.5, 1.2, 2.0]}}}}}))
        .unwrap();
    client.ask(json!({"do": "set", "patch": {"materials": {"0": {"color": [0.2, 0.5, 0.7]}}}})).unwrap();
    let seq =
        client.say(json!({"do": "set", "patch": {"lamps": {"1": {"place": {"position": [1.2, 3.5, 1.0]}}}}}));
    let shown = final_picture(&mut client, seq);
    // It may have been saved long before.
    client.say(json!({"do": "save"}));
    client.until(|value| value["patch"]["saved"]["state"] == "saved");
    let ev = client.state["display"]["ev"].as_f64().unwrap();
    assert_eq!(desk.end(), 130);
    let args = format!(
        "render cornell.mgf.lampyris.json --size 48x32 --batches 8 --exposure {ev} -o final.png --quiet"
    );
    let done = run(&folder, &args);
    assert_eq!(done.code, 0, "{}", done.err);
    let rendered = image::load_from_memory(&folder.bytes("final.png")).unwrap().to_rgb8();
    let differ = shown.as_raw().iter().zip(rendered.as_raw()).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 0, "of {}", shown.as_raw().len());

    // Opened again it is as it was, and goes on.
    let desk = Desk::start(&folder, "cornell.mgf.lampyris.json --size 48x32 --batches 8");
    let mut again = desk.client(&desk.key);
    again.until(|value| value["is"] == "state");
    for slice in ["lamps", "groups", "things", "materials"] {
        assert_eq!(again.state[slice], client.state[slice], "{slice}");
    }
    again.say(json!({"do": "display", "patch": {"ev": ev}}));
    let seq = again.seq;
    assert_eq!(final_picture(&mut again, seq).as_raw(), shown.as_raw());
    again
        .ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 1, "color": {"mode": "file"}}}}}))
        .unwrap();
    assert_eq!(again.state["lamps"]["0"]["swatch"], swatch);
}

/// Who dawdles over a request is let go, and who sends nonsense hears so or is cut off; others do not notice.
#[test]
fn nonsense_and_silence() {
    let folder = Folder::new("nonsense");
    let desk = Desk::start(&folder, "cube.mgf --size 32x24");
    let silent: Vec<TcpStream> = (0..200)
        .map(|_| {
            let mut stream = TcpStream::connect(&desk.host).unwrap();
            stream.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
            stream
        })
        .collect();
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    for nonsense in
        [json!({"do": "fly"}), json!({"do": "set"}), json!({"do": "size", "width": 1e9, "height": 1})]
    {
        assert!(client.ask(nonsense).is_err());
    }
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.5}}}})).unwrap();
    for mut stream in silent {
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let mut rest = Vec::new();
        assert!(stream.read_to_end(&mut rest).is_ok(), "a connection that says nothing stays");
    }
    let long = "x".repeat(1 << 17);
    let mut other = desk.client(&desk.key);
    other.say(json!({"do": "begin", "label": long}));
    let start = Instant::now();
    while !matches!(other.hear(), Heard::Closed) {
        assert!(start.elapsed() < Duration::from_secs(20), "a message without end is listened to");
    }
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.75}}}})).unwrap();
}
