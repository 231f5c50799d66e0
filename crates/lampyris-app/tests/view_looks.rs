//! Looks as a client of the desk finds them: their thumbnails.

mod support;

use serde_json::{Value, json};
use support::desk::{Client, Desk};
use support::Folder;

const SIZE: [u32; 2] = [64, 48];

/// The final picture after all that was said.
fn final_picture(client: &mut Client) -> image::RgbImage {
    let seq = client.say(json!({"do": "solo"}));
    let frame = client.until_frame(|frame| frame.kind == 2 && frame.seq >= seq);
    image::load_from_memory(&frame.picture).unwrap().to_rgb8()
}

/// Where the thumbnail of a look is, once it is another one than `before`.
fn thumbnail(client: &mut Client, id: &str, before: &Value) -> String {
    while client.state["looks"][id]["picture"].is_null() || client.state["looks"][id]["picture"] == *before {
        client.until(|value| !value["patch"]["looks"][id].is_null());
    }
    client.state["looks"][id]["picture"].as_str().unwrap().to_owned()
}

fn fetched(desk: &Desk, path: &str) -> image::RgbImage {
    let (status, bytes) = desk.get(path, &desk.cookie(&desk.key));
    assert_eq!(status, 200, "{path}");
    image::load_from_memory_with_format(&bytes, image::ImageFormat::Jpeg).unwrap().to_rgb8()
}

/// Mean of how much channels of two pictures differ [of 255].
fn apart(a: &image::RgbImage, b: &image::RgbImage) -> f64 {
    assert_eq!(a.dimensions(), b.dimensions());
    let off = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)));
    off.sum::<f64>() / a.as_raw().len() as f64
}

/// The thumbnail of a look is the picture with its levels, whatever they are by now: of one that is stored, of one that is
/// updated, and of those that a saved document has. Nobody else sees it, and it goes with its look.
#[test]
fn looks_have_thumbnails() {
    let folder = Folder::new("thumbnails");
    let start = |scene: &str| Desk::start(&folder, &format!("{scene} --size 64x48 --batches 6 --threads 2"));
    let desk = start("cornell.mgf");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let bright = final_picture(&mut client);
    client.ask(json!({"do": "look", "what": "store", "name": "bright"})).unwrap();
    let first = thumbnail(&mut client, "0", &Value::Null);
    client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.1}}}})).unwrap();
    client.ask(json!({"do": "look", "what": "store", "name": "dim"})).unwrap();
    let second = thumbnail(&mut client, "1", &Value::Null);
    let dim = final_picture(&mut client);
    let (one, two) = (fetched(&desk, &first), fetched(&desk, &second));
    assert_eq!(one.dimensions(), SIZE.into());
    // As near as JPEG is.
    assert!(apart(&bright, &dim) > 20.0, "{}", apart(&bright, &dim));
    assert!(apart(&one, &bright) < 3.0 && apart(&two, &dim) < 3.0, "{} {}", apart(&one, &bright), apart(&two, &dim));

    // One that is updated has another, and the old one is gone; so it is with one that is removed.
    client.ask(json!({"do": "look", "what": "update", "id": 0})).unwrap();
    let third = thumbnail(&mut client, "0", &first.clone().into());
    assert!(apart(&fetched(&desk, &third), &dim) < 3.0);
    let cookie = desk.cookie(&desk.key);
    assert_eq!(desk.get(&first, &cookie).0, 404);
    client.ask(json!({"do": "look", "what": "remove", "id": 0})).unwrap();
    assert_eq!(desk.get(&second, "lampyris-0=1").0, 401);
    client.ask(json!({"do": "undo"})).unwrap();
    let fourth = thumbnail(&mut client, "0", &third.clone().into());
    assert_eq!(desk.get(&third, &cookie).0, 404);
    assert!(apart(&fetched(&desk, &fourth), &dim) < 3.0);
    client.ask(json!({"do": "undo"})).unwrap();
    thumbnail(&mut client, "0", &fourth.into());

    // They are not saved, but made again of what is.
    client.say(json!({"do": "save"}));
    client.until(|value| value["patch"]["saved"]["state"] == "saved");
    let saved = String::from_utf8(folder.bytes("cornell.mgf.lampyris.json")).unwrap();
    assert!(saved.contains("bright") && !saved.contains("/look/"));
    assert_eq!(desk.end(), 130);
    let desk = start("cornell.mgf.lampyris.json");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    client.ask(json!({"do": "display", "patch": {"ev": 0}})).unwrap();
    let again = thumbnail(&mut client, "1", &Value::Null);
    assert_eq!(fetched(&desk, &again).dimensions(), SIZE.into());
}
