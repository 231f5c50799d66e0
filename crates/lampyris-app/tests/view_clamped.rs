//! What clamping takes from virtual lights, as a client of the desk sees it.

mod support;

use lampyris::output::false_color::{FalseColor, Palette, Scale};
use serde_json::json;
use support::desk::Desk;
use support::{Folder, run};

/// How the desk estimates what clamping takes.
const UNFILTERED: &str =
    "--filter off --paths 2400 --spp 1 --interleave 5x5 --light-points 50 --picks 8 --clamp 4 --photons 8192";

/// Luminance of the pixels of a picture that the program renders.
fn rendered(folder: &Folder, args: &str) -> Vec<f64> {
    let run = run(folder, &format!("render cornell.mgf -o out.hdr --groups 16 --exposure 0 {args}"));
    assert_eq!(run.code, 0, "{}", run.err);
    let picture = image::load_from_memory(&folder.bytes("out.hdr")).unwrap().to_rgb32f();
    let luminance = |p: &image::Rgb<f32>| 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    picture.pixels().map(|p| f64::from(luminance(p))).collect()
}

/// The overlay shows what the part *compensation* is of the picture, pixel by pixel in the mean, in half its size: most where
/// surfaces meet, nothing in the middle of a wall. A level changes none of it where there is one lamp, what moves takes it away
/// until it rests, and other quantities know nothing of it.
#[test]
fn what_clamping_takes_is_shown() {
    let folder = Folder::new("clamped");
    let desk = Desk::start(&folder, "cornell.mgf --size 128x96 --batches 8 --threads 2");
    let mut client = desk.client(&desk.key);
    client.until(|value| value["is"] == "state");
    let asked = json!({"quantity": "clamped", "low": 0, "high": 100, "scale": "linear", "palette": "grey"});
    client.say(json!({"do": "display", "patch": {"false_color": asked}}));
    let whole = client.until_frame(|frame| frame.kind == 2 && frame.false_color);
    assert_eq!(whole.size, [64, 48]);
    let pixels = |frame: &support::desk::Frame| image::load_from_memory(&frame.picture).unwrap().to_rgb8();
    let shown = pixels(&whole);
    let legend = FalseColor {
        low: 0.0,
        high: 100.0,
        scale: Scale::Linear,
        steps: None,
        palette: Palette::Grey,
        lines: Vec::new(),
    };
    let place = |color: &[u8; 3]| {
        let mut places = (0..=247).map(|k| f64::from(k) / 247.0);
        places
            .find(|place| legend.color(*place as f32) == *color)
            .unwrap_or_else(|| panic!("{color:?} is in no legend"))
    };

    let taken = rendered(&folder, &format!("--size 64x48 --batches 32 --parts compensation {UNFILTERED}"));
    let all = rendered(&folder, "--size 128x96 --batches 8");
    let (mut told, mut black) = (Vec::new(), 0);
    for (k, (pixel, taken)) in shown.pixels().zip(&taken).enumerate() {
        let corner = k / 64 * 2 * 128 + k % 64 * 2;
        let all = [0, 1, 128, 129].iter().map(|next| all[corner + next] / 4.0).sum::<f64>();
        if all == 0.0 {
            black += 1;
            continue;
        }
        let (share, own) = (place(&pixel.0), (taken / all).min(1.0));
        // PNG has eight bits of the share, HDR of the brightest channel: of green on the red wall fewer.
        assert!((share - own).abs() < 0.5 / 247.0 + 0.08 * own, "{k}: {share} {own}");
        told.push(share);
    }
    assert!(told.len() > 1000 && black > 100, "{} {black}", told.len());
    assert!(told.iter().any(|told| *told > 0.25) && told.contains(&0.0));

    let dimmed = client.ask(json!({"do": "set", "patch": {"lamps": {"0": {"level": 0.25}}}}));
    assert!(dimmed.is_ok());
    let seq = client.say(json!({"do": "solo"}));
    let again = client.until_frame(|frame| frame.kind == 2 && frame.seq >= seq && frame.false_color);
    assert!(pixels(&again).pixels().zip(shown.pixels()).all(|(a, b)| a[0].abs_diff(b[0]) <= 1));

    let moved = json!({"do": "camera", "eye": [2.5, 2.73, -8.0], "target": [2.78, 2.73, 0.0], "up": [0, 1, 0], "fov": 39.3});
    client.say(moved);
    client.until_frame(|frame| frame.kind == 0 && !frame.false_color);
    let there = client.until_frame(|frame| frame.kind == 2 && frame.false_color);
    assert_ne!(pixels(&there).as_raw(), shown.as_raw());
    let lux = json!({"quantity": "illuminance", "low": 1, "high": 100, "scale": "log"});
    client.say(json!({"do": "display", "patch": {"false_color": lux}}));
    assert_eq!(client.until_frame(|frame| frame.kind == 2 && frame.false_color).size, [128, 96]);
}
