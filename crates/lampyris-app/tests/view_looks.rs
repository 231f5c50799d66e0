//! Looks as a client of the desk finds them: their thumbnails, differences to them, and mixes that reach targets.

mod support;

use serde_json::{Value, json};
use std::time::Duration;
use support::Folder;
use support::desk::{Client, Desk, Heard};

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
    assert!(
        apart(&one, &bright) < 3.0 && apart(&two, &dim) < 3.0,
        "{} {}",
        apart(&one, &bright),
        apart(&two, &dim)
    );

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

/// Shows false colour and returns the final picture of it, with the colours of the legend.
fn false_color(client: &mut Client, asked: Value) -> (image::RgbImage, Vec<String>) {
    client.say(json!({"do": "display", "patch": {"false_color": asked}}));
    client.until(|value| value["patch"]["display"]["false_color"]["quantity"] == asked["quantity"]);
    let colors = client.state["display"]["false_color"]["colors"].clone();
    let picture = final_picture(client);
    (picture, serde_json::from_value(colors).unwrap())
}

/// Pixels that are no hatching.
fn told(picture: &image::RgbImage) -> impl Iterator<Item = [u8; 3]> {
    picture.pixels().map(|p| p.0).filter(|p| ![[96; 3], [128; 3]].contains(p))
}

/// What meter 0 reads and by how much that is more, once both are of the mix that was asked for last.
fn reading(client: &mut Client, lux: impl Fn(f64) -> bool) -> (f64, Option<f64>) {
    loop {
        let meter = &client.state["meters"]["0"];
        if let Some(value) = meter["lux"][0].as_f64().filter(|value| lux(*value)) {
            return (value, meter["change"].as_f64());
        }
        client.until(|value| !value["patch"]["meters"]["0"].is_null());
    }
}

/// To itself a look has no difference; to a look in the dark all light is one, to the bit; and half the light is as much less
/// than all of it as it is more than none. Meters and the pointer tell the same in figures.
#[test]
fn differences_to_looks_are_told_in_lux() {
    let folder = Folder::new("differences");
    let desk = Desk::start(&folder, "cornell.mgf --size 64x48 --batches 4 --threads 2");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let meter = json!({"name": "m", "kind": "horizontal", "point": [1.0, 0.5, 0.5], "normal": [0, 1, 0]});
    client.ask(json!({"do": "set", "patch": {"meters": {"0": meter}}})).unwrap();
    client.ask(json!({"do": "look", "what": "store", "name": "bright"})).unwrap();
    let level = |client: &mut Client, level: f64| {
        client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": level}}}})).unwrap();
    };
    let difference = |look: u32, high: f64| {
        json!({"quantity": "difference", "against": look, "low": -high, "high": high, "scale": "linear",
               "palette": "diverging"})
    };
    let (none, colors) = false_color(&mut client, difference(0, 100.0));
    assert_eq!(colors.len(), 33);
    let hex = |[r, g, b]: [u8; 3]| format!("#{r:02x}{g:02x}{b:02x}");
    assert!(told(&none).count() > 500 && told(&none).all(|p| hex(p) == colors[16]));
    let (full, _) = reading(&mut client, |lux| lux > 0.0);

    level(&mut client, 0.0);
    client.ask(json!({"do": "look", "what": "store", "name": "dark"})).unwrap();
    level(&mut client, 0.5);
    let (more, _) = false_color(&mut client, difference(1, full));
    let lit = json!({"quantity": "illuminance", "low": -full, "high": full, "scale": "linear", "palette": "diverging"});
    let (all, _) = false_color(&mut client, lit);
    assert_eq!(more.as_raw(), all.as_raw());
    let (less, _) = false_color(&mut client, difference(0, full));
    // What is blue is as dark as what is orange: seen by its place in the legend.
    let at = |colors: &[String], p: [u8; 3]| colors.iter().position(|own| *own == hex(p));
    assert!(told(&less).all(|p| at(&colors, p).is_none_or(|place| place <= 16)));
    assert!(told(&more).all(|p| at(&colors, p).is_none_or(|place| place >= 16)));
    assert!(told(&less).any(|p| p != told(&none).next().unwrap()));

    // At a quarter meters read a quarter, three quarters less than all.
    level(&mut client, 0.25);
    let quarter = reading(&mut client, |lux| lux < 0.4 * full);
    let change = quarter.1.expect("a change");
    assert!((change / (-3.0 * quarter.0) - 1.0).abs() < 1e-4, "{quarter:?}");
    let frame = client.frame.clone().unwrap().number;
    let mut pointed = 0;
    for (id, x) in (1..).zip([8.0, 24.0, 40.0, 56.0]) {
        client.say(json!({"do": "ask", "id": id, "what": "point", "frame": frame, "x": x, "y": 40.0}));
        let answer = client.until(|value| value["is"] == "answer" && value["id"] == id);
        if let Some((lux, change)) = answer["lux"][0].as_f64().zip(answer["change"].as_f64()) {
            pointed += 1;
            assert!((change / (-3.0 * lux) - 1.0).abs() < 1e-3, "{answer}");
        }
    }
    assert!(pointed > 0);

    // Nothing is compared with what is not there.
    client.say(json!({"do": "display", "patch": {"false_color": difference(7, 10.0)}}));
    let refused = client.until(|value| value["is"] == "refused");
    assert!(refused["why"].as_str().unwrap().contains("no such look"));
    assert_eq!(client.state["display"]["false_color"]["against"], 0);
    client.ask(json!({"do": "look", "what": "remove", "id": 0})).unwrap();
    while !client.state["display"]["false_color"].is_null() {
        client.until(|value| !value["patch"]["display"].is_null());
    }
    assert_eq!(desk.end(), 130);
}

/// What meter 0 reads, and ±, once it is measured no more.
fn settled(client: &mut Client) -> (f64, f64) {
    client.wait(Duration::from_millis(500));
    while !matches!(client.hear(), Heard::Silence) {}
    let lux = &client.state["meters"]["0"]["lux"];
    (lux[0].as_f64().expect("a reading"), lux[1].as_f64().expect("its ±"))
}

/// Levels are set so that targets are met whatever ± says, up to the lamp's flux, and beyond it if asked to.
#[test]
fn targets_are_met_for_certain() {
    let folder = Folder::new("reach");
    let desk = Desk::start(&folder, "cornell.mgf --size 32x24 --batches 2 --threads 2");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let mut reach = |target: f64, most: Value| {
        let meter = json!({"name": "m", "kind": "horizontal", "point": [2.78, 4.0, 2.8], "normal": [0, 1, 0],
                           "target": target});
        client.ask(json!({"do": "set", "patch": {"meters": {"0": meter}}})).unwrap();
        settled(&mut client);
        client.ask(json!({"do": "reach", "most": most})).unwrap();
        (client.state["lamps"]["0"]["level"].as_f64().unwrap(), settled(&mut client))
    };
    let (level, (full, error)) = reach(1000.0, json!(1));
    assert!(level == 1.0 && error > 0.0 && error < 0.05 * full, "{level}: {full} ±{error}");
    // Levels are held a little where they are.
    let held = 0.998;
    let (level, (lux, error)) = reach(0.5 * full, json!(1));
    assert!(lux - error > 0.5 * full * held && lux < 0.55 * full, "{level}: {lux} ±{error}");
    let (level, (lux, error)) = reach(1.2 * full, json!(2));
    assert!(lux - error > 1.2 * full * held && lux < 1.32 * full, "{level}: {lux} ±{error}");
    assert_eq!(reach(3.0 * full, json!(2)).0, 2.0);
    for bad in [json!(0.5), json!(11), json!("much")] {
        assert!(client.ask(json!({"do": "reach", "most": bad})).is_err());
    }
    assert_eq!(desk.end(), 130);
}
