//! Clients that mean harm, on the wire: what is no message ends their own socket at most, and the desk goes on. What broken
//! messages do is tried by the thousand within the desk.

mod support;

use serde_json::json;
use std::time::{Duration, Instant};
use support::Folder;
use support::desk::{Desk, Heard};
use support::dice::Dice;

/// A frame of a client as it goes over the line, its mask nothing.
fn frame(first: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = vec![first, 0x80 | 126];
    bytes.extend((payload.len() as u16).to_be_bytes());
    bytes.extend([0; 4]);
    bytes.extend(payload);
    bytes
}

/// Frames that are none: each ends the socket that it came by, and no other.
#[test]
fn broken_frames() {
    let folder = Folder::new("frames");
    let desk = Desk::start(&folder, "cube.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let claims = |bytes: u64| {
        let mut head = vec![0x81, 0x80 | 127];
        head.extend(bytes.to_be_bytes());
        head.extend([0; 4]);
        head
    };
    let broken = [
        ("binary", frame(0x82, b"{}")),
        ("no UTF-8", frame(0x81, b"{\"do\":\"\xff\xfe\"}")),
        ("of bits that mean nothing", frame(0xf1, b"{}")),
        ("of a kind that is none", frame(0x8b, b"{}")),
        ("the rest of nothing", frame(0x80, b"{}")),
        ("of 64 KiB and one byte", claims((64 << 10) + 1)),
        ("of all bytes there are", claims(u64::MAX >> 1)),
        ("without a mask", b"\x81\x02{}".to_vec()),
        ("no frame at all", b"GET / HTTP/1.1\r\n\r\n".to_vec()),
    ];
    for (what, bytes) in broken {
        let mut other = desk.client(&desk.key);
        other.until(|value| value["is"] == "state");
        other.push(&bytes);
        let pushed = Instant::now();
        while !matches!(other.hear(), Heard::Closed) {
            assert!(pushed.elapsed() < Duration::from_secs(10), "a frame {what} is listened to");
        }
        client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.5}}}})).unwrap();
    }
    assert_eq!(desk.end(), 130);
}

/// Texts that are no messages are refused, one by one, and the same client is heard afterwards.
#[test]
fn broken_texts() {
    let folder = Folder::new("texts");
    let desk = Desk::start(&folder, "cube.mgf --size 32x24");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let mut dice = Dice(3);
    let whole = br#"{"do":"set","seq":7,"patch":{"lamps":{"0":{"color":{"mode":"xy","xy":[0.3,0.3]}}}}}"#;
    for _ in 0..300 {
        // Whatever is cut off, it is none any more.
        let rest = &whole[..dice.below(whole.len())];
        client.push(&frame(0x81, rest));
        client.until(|value| value["is"] == "refused" && value["seq"] == 0);
    }
    for deep in [b'[', b'{', b'9'] {
        client.push(&frame(0x81, &vec![deep; 60_000]));
        client.until(|value| value["is"] == "refused" && value["seq"] == 0);
    }
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.5}}}})).unwrap();
    assert_eq!(client.state["lamps"]["0"]["level"], 0.5);
    client.until(|value| value["patch"]["history"]["steps"] == 1);
    assert_eq!(desk.end(), 130);
}
