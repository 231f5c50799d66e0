//! `lampyris play` from end to end: pictures and films of the same frames, errors in scripts, interruption, flicker, and
//! `render --frame`.

mod support;

use support::{Folder, Run, command, run};

/// A quarter of a second through the Cornell box: everything moves.
const WALK: &str = r#"{
    "scene": "cornell.mgf", "size": [24, 18], "fps": 16, "frames": 4,
    "camera": [
        {"frame": 0, "eye": [2.78, 2.73, -8], "target": [2.78, 2.73, 0], "up": [0, 1, 0], "fov": 39},
        {"frame": 3, "eye": [2.98, 2.73, -8]}
    ],
    "lights": [{"name": "luminaire", "keys": [{"frame": 0, "power": 1}, {"frame": 3, "power": 0.5}]}],
    "objects": [{"name": "block_short", "keys": [
        {"frame": 0, "move": [0, 0, 0], "turn": [0, 1, 0, 0], "scale": 1},
        {"frame": 3, "move": [0.2, 0.3, 0], "turn": [0, 1, 0, 30], "scale": 1.2}
    ]}]
}"#;

fn played(folder: &Folder, script: &str, args: &str) -> Run {
    folder.put("walk.json", script);
    run(folder, &format!("play walk.json {args}"))
}

/// Width, height, and pixels of a PNG.
fn pixels(folder: &Folder, name: &str) -> (u32, u32, Vec<[u8; 3]>) {
    let picture = image::load_from_memory(&folder.bytes(name)).unwrap().to_rgb8();
    (picture.width(), picture.height(), picture.pixels().map(|p| p.0).collect())
}

#[test]
fn pictures_and_a_film_show_the_same_frames() {
    let folder = Folder::new("play");
    let run = played(&folder, WALK, "-o f_%02d.png -o walk.y4m --json");
    assert_eq!(run.code, 0, "{}", run.err);
    let names = ["f_00.png", "f_01.png", "f_02.png", "f_03.png", "walk.json", "walk.y4m"];
    assert_eq!(folder.files(), names);
    let report = run.json();
    assert_eq!((&report["frames"], &report["interrupted"]), (&4.into(), &false.into()));
    // One eye ray a pixel and frame at least.
    assert!(report["rays"]["eye"].as_u64().unwrap() >= 4 * 24 * 18);
    let seconds = |key: &str| report["seconds"][key].as_f64().unwrap();
    assert!(seconds("frame_worst") >= seconds("frame_median") && seconds("frame_median") > 0.0);

    let film = folder.bytes("walk.y4m");
    let header = b"YUV4MPEG2 W24 H18 F16:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n";
    let (head, frames) = film.split_at(header.len());
    assert_eq!(head, header);
    let size = 24 * 18;
    let frames: Vec<&[u8]> = frames.chunks(6 + 3 * size).collect();
    assert_eq!(frames.len(), 4);
    let mut shown = std::collections::HashSet::new();
    for (k, frame) in frames.iter().enumerate() {
        let (mark, planes) = frame.split_at(6);
        assert_eq!((mark, planes.len()), (&b"FRAME\n"[..], 3 * size));
        let (width, height, picture) = pixels(&folder, names[k]);
        assert_eq!((width, height), (24, 18));
        for (at, rgb) in picture.iter().enumerate() {
            // Rec. ITU-R BT.601, backwards; a step of a plane is up to 2.2 steps of a channel.
            let [y, u, v] = [0, 1, 2].map(|plane| f64::from(planes[plane * size + at]));
            let (y, u, v) =
                (255.0 * (y - 16.0) / 219.0, 255.0 * (u - 128.0) / 224.0, 255.0 * (v - 128.0) / 224.0);
            let back = [y + 1.402 * v, y - (0.114 * 1.772 * u + 0.299 * 1.402 * v) / 0.587, y + 1.772 * u];
            for (a, b) in rgb.iter().zip(back) {
                assert!((f64::from(*a) - b).abs() < 2.0, "frame {k}, pixel {at}: {rgb:?} {back:?}");
            }
        }
        shown.insert(picture);
    }
    assert_eq!(shown.len(), 4, "frames that are all the same prove nothing");
}

/// The exposure stays that of the first frame, so a quarter of the light is darker; rendered anew or weighted otherwise.
#[test]
fn a_dimmed_lamp_darkens_the_film() {
    let folder = Folder::new("play-dim");
    let still = r#"{"scene": "cornell.mgf", "size": [16, 12], "frames": 2, "lights": [{"name": "luminaire", "keys": [
        {"frame": 0, "power": 1}, {"frame": 1, "power": 0.25}]}]}"#;
    for groups in ["", "--groups 4"] {
        assert_eq!(played(&folder, still, &format!("-o %d.exr --settle 64 {groups}")).code, 0);
        let mean = |name: &str| {
            let picture = image_of(&folder, name);
            picture.iter().flatten().map(|v| f64::from(*v)).sum::<f64>()
        };
        let ratio = mean("1.exr") / mean("0.exr");
        assert!((ratio - 0.25).abs() < 0.03, "{ratio} {groups}");
    }
}

/// The lamp goes out: half of a mean of two is what was.
#[test]
fn a_window_shows_what_was() {
    let folder = Folder::new("play-window");
    let out = |window: &str| {
        format!(
            r#"{{"scene": "cornell.mgf", "size": [16, 12], "frames": 3, {window} "lights": [{{"name": "luminaire",
            "keys": [{{"frame": 0, "power": 1}}, {{"frame": 1, "power": 0}}]}}]}}"#
        )
    };
    for (script, args) in [(out(""), "--window 2"), (out(r#""window": 2,"#), "")] {
        assert_eq!(played(&folder, &script, &format!("-o %d.exr {args}")).code, 0);
        let [first, second, third] =
            ["0.exr", "1.exr", "2.exr"].map(|name| image_of(&folder, name).into_iter().flatten());
        assert!(first.zip(second).all(|(was, is)| is == 0.5 * was));
        assert!(third.into_iter().all(|v| v == 0.0), "two batches later it is dark");
    }
    assert_eq!(played(&folder, &out(r#""window": 2,"#), "-o %d.exr --window 1").code, 0);
    assert!(image_of(&folder, "1.exr").iter().flatten().all(|v| *v == 0.0));
}

#[test]
fn frames_do_not_depend_on_threads_and_the_first_is_that_of_render() {
    let folder = Folder::new("play-threads");
    for threads in [1, 2, 3, 7] {
        let run = played(&folder, WALK, &format!("-o {threads}.y4m -o {threads}_%d.exr --threads {threads}"));
        assert_eq!(run.code, 0, "{}", run.err);
    }
    for threads in [2, 3, 7] {
        assert!(folder.bytes("1.y4m") == folder.bytes(&format!("{threads}.y4m")), "{threads} threads");
    }
    let view = "--eye 2.78,2.73,-8 --target 2.78,2.73,0 --up 0,1,0 --fov 39";
    assert_eq!(run(&folder, &format!("render cornell.mgf --frame -o a.exr --size 24x18 {view}")).code, 0);
    let values = |name: &str| -> Vec<u32> {
        let picture = image_of(&folder, name);
        picture.into_iter().flatten().map(f32::to_bits).collect()
    };
    assert!(values("a.exr") == values("1_0.exr"));
    assert!(values("a.exr") != values("1_1.exr"));
}

/// Channels of an OpenEXR picture.
fn image_of(folder: &Folder, name: &str) -> Vec<Vec<f32>> {
    let image = exr::prelude::read_all_flat_layers_from_file(folder.0.join(name)).unwrap();
    let channels: &exr::prelude::AnyChannels<exr::prelude::FlatSamples> = &image.layer_data[0].channel_data;
    channels.list.iter().map(|c| c.sample_data.values_as_f32().collect()).collect()
}

#[test]
fn a_frame_leaves_nothing_to_choose() {
    let folder = Folder::new("frame");
    let args = "render cornell.mgf --frame -o a.png --size 16x12";
    let one = run(&folder, &format!("{args} --seed 3 --json"));
    assert_eq!((one.code, &one.json()["batches"]), (0, &1.into()), "{}", one.err);
    for also in ["--batches 2", "--time 1", "--paths 8", "--spp 2", "--parts direct", "--filter off"] {
        let refused = run(&folder, &format!("{args} {also}"));
        assert!(refused.code == 2 && refused.err.contains("--frame"), "{also}: {}", refused.err);
    }
}

#[test]
fn faults_of_scripts_are_named_with_place_and_mend() {
    let folder = Folder::new("play-bad");
    let with = |field: &str| format!(r#"{{"scene": "cornell.mgf", "size": [8, 6], "frames": 2, {field}}}"#);
    let light =
        |name: &str, key: &str| with(&format!(r#""lights": [{{"name": "{name}", "keys": [{key}]}}]"#));
    let cases = [
        ("{".into(), 3, "walk.json:line 1 column 1: "),
        (r#"{"frames": 2, "film": 1}"#.into(), 3, "unknown field `film`"),
        (r#"{"scene": "cornell.mgf", "frames": 0}"#.into(), 3, "walk.json:frames: need 1 to 100000"),
        (r#"{"scene": "cornell.mgf", "frames": 2000000}"#.into(), 3, "walk.json:frames: "),
        (with(r#""window": 65"#), 3, "walk.json:window: need 1 to 64"),
        (r#"{"scene": "cornell.mgf", "frames": 1, "size": [99999, 99999]}"#.into(), 3, "walk.json:size: "),
        (r#"{"frames": 1}"#.into(), 2, "no scene"),
        (
            light("luminair", r#"{"frame": 0}"#),
            3,
            "lights[0]: no light is called \"luminair\"; the scene has: luminaire",
        ),
        (light("luminaire", r#"{"frame": 0, "power": -1}"#), 3, "lights[0].keys[0]: power must not"),
        (light("luminaire", r#"{"frame": 0, "power": 1e39}"#), 3, "lights[0].keys[0]: need numbers"),
        (
            light("luminaire", r#"{"frame": 0, "power": "full"}"#),
            3,
            "walk.json:line 1 column 125: need a number, not text in quotes",
        ),
        (light("luminaire", r#"{"frame": 0, "power": 1e20}"#), 3, "lights[0].keys[0]: need numbers"),
        (light("luminaire", r#"{"frame": 0, "position": [0, 0, 0]}"#), 3, "moved by a track of \"objects\""),
        (light("luminaire", r#"{"frame": 5}, {"frame": 5}"#), 3, "lights[0].keys[1]: need keys in the order"),
        (light("luminaire", r#"{"frame": 0, "power": 1e9}"#), 0, ""),
        (
            with(r#""objects": [{"name": "block", "keys": []}]"#),
            3,
            "no object is called \"block\"; the scene has: block_tall",
        ),
        (
            with(r#""objects": [{"name": "luminaire", "keys": [{"frame": 0, "scale": 0}]}]"#),
            3,
            "scale must be more",
        ),
        (
            with(r#""objects": [{"name": "luminaire", "keys": [{"frame": 0, "turn": [0, 0, 0, 9]}]}]"#),
            3,
            "turn must be",
        ),
        (
            with(r#""camera": [{"frame": 0, "eye": [0, 0, 0], "target": [1, 0, 0], "up": [1, 0, 0]}]"#),
            3,
            "frame 0: the camera",
        ),
        (with(r#""camera": [{"frame": 0, "fov": 180}]"#), 3, "camera[0]: fov must be"),
    ];
    for (script, code, words) in cases {
        let run = played(&folder, &script, "-o f_%d.png");
        assert_eq!(run.code, code, "{script}: {}", run.err);
        assert!(run.err.contains(words), "{script}: {}", run.err);
    }
    for (args, code, words) in [
        ("-o frame.png", 2, "%04d"),
        ("-o a_%d.mov", 2, "y4m"),
        ("-o nowhere/a_%d.png", 4, "there is no folder nowhere"),
        ("-o - --json", 2, "not both"),
        ("-o a_%d.png --absorption often", 2, "no absorption is called"),
        ("", 2, "--output"),
    ] {
        let run = played(&folder, WALK, args);
        assert!(run.code == code && run.err.contains(words), "{args}: {} {}", run.code, run.err);
    }
}

#[cfg(unix)]
#[test]
fn one_interrupt_keeps_the_frames_that_are_done() {
    let folder = Folder::new("play-interrupt");
    folder.put("walk.json", &WALK.replace("\"frames\": 4", "\"frames\": 100000"));
    let child = command(&folder, "play walk.json -o f_%05d.png -o walk.y4m --json").spawn().unwrap();
    let begun = std::time::Instant::now();
    while !folder.0.join("f_00001.png").exists() && begun.elapsed().as_secs() < 60 {
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let frames = report["frames"].as_u64().unwrap() as usize;
    assert!(frames >= 2 && report["interrupted"] == true);
    assert_eq!(folder.files().len(), frames + 2, "pictures, the film and the script");
    let header = b"YUV4MPEG2 W24 H18 F16:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n".len();
    assert_eq!(folder.bytes("walk.y4m").len(), header + frames * (6 + 3 * 24 * 18));
}

/// The walkthrough that ships: what a lamp that moves leaves of its random numbers makes frames five times as steady at least.
#[test]
fn a_lamp_that_moves_through_the_office_hardly_flickers() {
    let folder = Folder::new("pendant");
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/pendant.json");
    let run = run(&folder, &format!("play {script} --wald --size 12x9 --flicker 2 --json"));
    assert_eq!((run.code, &run.json()["frames"]), (0, &60.into()), "{}", run.err);
    for kind in ["unfiltered", "displayed"] {
        let ratio = run.json()["flicker"][kind]["ratio"].as_f64().unwrap();
        assert!(ratio > 5.0, "{kind}: {}", run.json()["flicker"]);
    }
}

/// A lamp that is dimmed changes no path, so the frames of a session change as the truth does.
#[test]
fn flicker_is_measured_against_frames_that_draw_anew() {
    let folder = Folder::new("flicker");
    let dim = r#"{"scene": "cornell.mgf", "size": [16, 12], "frames": 3, "lights": [{"name": "luminaire", "keys": [
        {"frame": 0, "power": 1}, {"frame": 2, "power": 0.9}]}]}"#;
    let run = played(&folder, dim, "--flicker 8 --json");
    assert_eq!(run.code, 0, "{}", run.err);
    let flicker = &run.json()["flicker"];
    for kind in ["unfiltered", "displayed"] {
        let of = |key: &str| flicker[kind][key].as_f64().unwrap();
        assert!(of("session") > 0.0 && of("session") < 0.1 && of("ratio") > 3.0, "{kind}: {flicker}");
        assert!((of("ratio") - of("independent") / of("session")).abs() < 1e-9 * of("ratio"));
    }
}
