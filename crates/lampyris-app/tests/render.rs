//! `lampyris render` from end to end: reports, files, interruption, and the same bytes however it is run.

mod support;

use serde_json::Value;
use std::time::{Duration, Instant};
use support::{Folder, command, run};

#[test]
fn the_report_has_every_key_and_the_figures_make_sense() {
    let folder = Folder::new("report");
    for scene in ["cornell.mgf", "cube.mgf"] {
        let run = run(&folder, &format!("render {scene} -o a.png --size 32x24 --paths 8 --batches 4 --json"));
        assert_eq!(run.code, 0, "{}", run.err);
        let report = run.json();
        let keys: Vec<&str> = report.as_object().unwrap().keys().map(String::as_str).collect();
        let mut expected = [
            "scene",
            "outputs",
            "size",
            "view",
            "seconds",
            "rays",
            "vpls",
            "records",
            "batches",
            "error",
            "exposure",
            "peak_memory_bytes",
            "non_finite",
            "interrupted",
            "warnings",
        ];
        expected.sort_unstable();
        let mut sorted = keys.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, expected);
        assert_eq!((&report["non_finite"], &report["interrupted"]), (&Value::from(0), &Value::from(false)));
        assert_eq!((&report["batches"], &report["size"]), (&Value::from(4), &serde_json::json!([32, 24])));
        assert_eq!(report["outputs"], serde_json::json!(["a.png"]));
        assert_eq!(report["view"]["found"], Value::from(true));
        for key in ["furniture", "walls"] {
            let share = report["view"]["seen"][key].as_f64().unwrap();
            assert!(share > 0.0 && share <= 1.0, "{key}: {share}");
        }
        let eye_rays = report["rays"]["eye"].as_u64().unwrap();
        // One eye pass for eight light paths and batch, and mirrors only add.
        assert!(eye_rays >= 32 * 24 * 4 && report["vpls"].as_u64().unwrap() > 0);
        let error = report["error"].as_f64().unwrap();
        assert!(error > 0.0 && error < 1.0, "{error}");
        let seconds = |key: &str| report["seconds"][key].as_f64().unwrap();
        let phases: f64 = ["load", "build", "view", "render", "write"].map(seconds).iter().sum();
        assert!((phases - seconds("total")).abs() < 0.05, "{phases} {}", seconds("total"));
    }
}

#[test]
fn a_picture_repeats_from_its_own_metadata() {
    let folder = Folder::new("repeat");
    let first = run(&folder, "render cornell.mgf -o a.exr --size 24x18 --paths 4 --batches 2 --json");
    let view = &first.json()["view"];
    let vector = |key: &str| {
        let v: Vec<String> =
            view[key].as_array().unwrap().iter().map(|n| (n.as_f64().unwrap() as f32).to_string()).collect();
        v.join(",")
    };
    let (eye, target, up) = (vector("eye"), vector("target"), vector("up"));
    let fov = view["fov"].as_f64().unwrap();
    let again = run(
        &folder,
        &format!(
            "render cornell.mgf -o b.exr --size 24x18 --paths 4 --batches 2 --eye {eye} --target {target} --up {up} --fov {fov} --json"
        ),
    );
    assert_eq!(again.json()["view"]["found"], Value::from(false));
    assert_eq!(again.json()["view"]["seen"], Value::Null);
    assert!(folder.bytes("a.exr") == folder.bytes("b.exr"));
}

#[test]
fn bytes_do_not_depend_on_the_number_of_threads() {
    let folder = Folder::new("threads");
    for threads in [1, 2, 3, 7] {
        let args = format!(
            "render cornell.mgf -o {threads}.exr -o {threads}.png --size 40x30 --paths 6 --batches 3 --aov --threads {threads}"
        );
        let run = run(&folder, &args);
        assert_eq!(run.code, 0, "{}", run.err);
    }
    for kind in ["exr", "png"] {
        let one = folder.bytes(&format!("1.{kind}"));
        for threads in [2, 3, 7] {
            assert!(one == folder.bytes(&format!("{threads}.{kind}")), "{threads} threads, {kind}");
        }
    }
}

#[test]
fn layers_come_with_the_picture() {
    let folder = Folder::new("layers");
    let args = "render cornell.mgf -o a.exr --size 16x12 --paths 8 --batches 4 --aov --eye 2.78,2.73,-8 --target 2.78,2.73,0 --up 0,1,0 --fov 39.3";
    assert_eq!(run(&folder, args).code, 0);
    let image = exr::prelude::read_all_flat_layers_from_file(folder.0.join("a.exr")).unwrap();
    let values = |layer: &str, channel: &str| -> Vec<f32> {
        let named =
            |name: &Option<exr::prelude::Text>| name.as_ref().map(ToString::to_string).unwrap_or_default();
        let of = |l: &&exr::prelude::Layer<_>| named(&l.attributes.layer_name).contains(layer);
        let layer = image.layer_data.iter().find(of).unwrap_or_else(|| panic!("no layer {layer}"));
        let list: &exr::prelude::AnyChannels<exr::prelude::FlatSamples> = &layer.channel_data;
        let channel = list.list.iter().find(|c| c.name.to_string().ends_with(channel)).unwrap();
        channel.sample_data.values_as_f32().collect()
    };
    for (name, channels) in
        [("direct", "RGB"), ("indirect", "RGB"), ("albedo", "RGB"), ("normal", "XYZ"), ("depth", "Z")]
    {
        for channel in channels.chars() {
            let plane = values(name, &channel.to_string());
            assert_eq!(plane.len(), 16 * 12, "{name}.{channel}");
            assert!(plane.iter().all(|v| !v.is_nan()), "{name}.{channel}");
        }
    }
    // A little above the middle is the back wall, 13.59 m away along the axis, facing the eye.
    let middle = 4 * 16 + 8;
    let depth = values("depth", "Z")[middle];
    assert!((13.59..13.75).contains(&depth), "{depth}");
    assert!((values("normal", "Z")[middle] + 1.0).abs() < 1e-3);
    // The layers are the picture, but for the light itself, which is direct too.
    let (direct, indirect) = (values("direct", "G"), values("indirect", "G"));
    let picture: Vec<f32> = {
        let first = &image.layer_data[0].channel_data.list;
        first.iter().find(|c| c.name.to_string() == "G").unwrap().sample_data.values_as_f32().collect()
    };
    for k in 0..picture.len() {
        let sum = direct[k] + indirect[k];
        assert!((picture[k] - sum).abs() <= 1e-5 * picture[k].abs().max(1e-3), "{k}: {} {sum}", picture[k]);
    }
}

/// Light groups have a layer each, by the names of the luminaires, and the layers add up to the picture.
#[test]
fn light_groups_add_up() {
    let folder = Folder::new("groups");
    folder.put("office.mgf", include_str!("../../../scenes/office.mgf"));
    let args = "render office.mgf -o a.exr --size 32x24 --frame --groups 16 --eye 0.35,0.35,1.5 --target 4.05,3.7,0.9 --up 0,0,1 --fov 55 --json";
    let run = run(&folder, args);
    assert_eq!((run.code, run.json()["non_finite"].as_u64()), (0, Some(0)), "{}", run.err);
    let image = exr::prelude::read_all_flat_layers_from_file(folder.0.join("a.exr")).unwrap();
    let layers: Vec<(String, Vec<f32>)> = image
        .layer_data
        .iter()
        .map(|layer| {
            let name = layer.attributes.layer_name.as_ref().map(ToString::to_string).unwrap_or_default();
            let list: &exr::prelude::AnyChannels<exr::prelude::FlatSamples> = &layer.channel_data;
            (name, list.list.iter().flat_map(|c| c.sample_data.values_as_f32()).collect())
        })
        .collect();
    let names: Vec<&str> = layers.iter().map(|(name, _)| name.as_str()).collect();
    assert!((5..=17).contains(&names.len()), "{names:?}");
    for lamp in ["light panel_desk", "light lamp_torchiere", "light lamp_pendant", "light lamp_desk"] {
        assert!(names.iter().any(|name| name.contains(lamp)), "no {lamp} in {names:?}");
    }
    let most = layers[0].1.iter().copied().fold(0.0, f32::max);
    for k in 0..layers[0].1.len() {
        let sum: f32 = layers[1..].iter().map(|(_, values)| values[k]).sum();
        assert!((layers[0].1[k] - sum).abs() <= 1e-5 * most, "{k}: {} {sum}", layers[0].1[k]);
    }
}

#[test]
fn a_time_is_kept_to_within_a_batch() {
    let folder = Folder::new("time");
    let begun = Instant::now();
    let run = run(&folder, "render cornell.mgf -o a.png --size 64x48 --paths 8 --time 2 --json");
    let (took, report) = (begun.elapsed(), run.json());
    let batches = report["batches"].as_u64().unwrap();
    let render = report["seconds"]["render"].as_f64().unwrap();
    let batch = render / batches as f64;
    assert!(batches > 1 && run.code == 0);
    // Loading is within the time; writing comes on top, and starting the program is nobody's.
    let spent = report["seconds"]["total"].as_f64().unwrap() - report["seconds"]["write"].as_f64().unwrap();
    assert!(spent < 2.0 * 1.1 + batch, "{spent} s with batches of {batch} s");
    assert!(spent > 2.0 - 2.0 * batch - 0.2, "gave up after {spent} s");
    assert!(took < Duration::from_secs(8));
}

#[cfg(unix)]
#[test]
fn one_interrupt_writes_what_is_there() {
    let folder = Folder::new("interrupt");
    let child =
        command(&folder, "render cornell.mgf -o a.png -o a.exr --size 64x48 --paths 8 --time 600 --json")
            .spawn()
            .unwrap();
    std::thread::sleep(Duration::from_secs(2));
    let kill = |signal: &str| {
        let status = std::process::Command::new("kill").args([signal, &child.id().to_string()]).status();
        assert!(status.unwrap().success());
    };
    kill("-INT");
    let asked = Instant::now();
    let output = child.wait_with_output().unwrap();
    assert!(asked.elapsed() < Duration::from_secs(10), "{:?}", asked.elapsed());
    assert_eq!(output.status.code(), Some(130));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["interrupted"], Value::from(true));
    assert!(report["batches"].as_u64().unwrap() > 0);
    assert_eq!(folder.files(), ["a.exr", "a.png"]);
    assert_eq!(folder.bytes("a.png")[1..4], *b"PNG");
}

#[cfg(unix)]
#[test]
fn a_second_interrupt_leaves_nothing_behind() {
    let folder = Folder::new("twice");
    // One batch alone would take minutes.
    let mut child = command(&folder, "render cornell.mgf -o a.png --size 640x480 --paths 65536 --batches 1")
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(2));
    for _ in 0..2 {
        std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        std::thread::sleep(Duration::from_millis(300));
    }
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(folder.files(), [""; 0]);
}

#[test]
fn a_bad_scene_or_a_full_folder_leaves_the_old_picture() {
    let folder = Folder::new("intact");
    folder.put("bad.mgf", "m red =\n\tc\n\tcxy 0.5 0.3\n\trd 0.5\nv a =\n\tp 0 0 0\nf a b c\n");
    folder.put("a.png", "old");
    let run_bad = run(&folder, "render bad.mgf -o a.png --json");
    assert_eq!((run_bad.code, run_bad.out.as_str()), (3, ""));
    assert!(run_bad.err.starts_with("error: bad.mgf:line 7: "), "{}", run_bad.err);
    assert_eq!(folder.bytes("a.png"), b"old");
    assert_eq!(folder.files(), ["a.png", "bad.mgf"]);

    std::fs::create_dir(folder.0.join("b.png")).unwrap();
    let run_folder = run(&folder, "render cube.mgf -o b.png -o c.png --size 8x6 --paths 2 --batches 2");
    assert_eq!(run_folder.code, 4, "{}", run_folder.err);
    assert!(run_folder.err.contains("cannot write b.png: it is a folder"), "{}", run_folder.err);
    // What can be written is.
    assert_eq!(folder.files(), ["a.png", "b.png", "bad.mgf", "c.png"]);
}

#[test]
fn quiet_is_silent_and_without_an_output_the_scene_names_it() {
    let folder = Folder::new("quiet");
    let run = run(&folder, "render cube.mgf --size 8x6 --paths 2 --batches 2 --quiet");
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert_eq!(folder.files(), ["cube.png"]);
}

#[cfg(unix)]
#[test]
fn a_file_over_the_limit_of_the_process_is_an_error_and_leaves_the_old_one() {
    let folder = Folder::new("limit");
    folder.put("a.exr", "old");
    // A block is 512 or 1024 bytes; the picture has 48 kB.
    let script = format!(
        "ulimit -f 8; exec {} render cube.mgf -o a.exr --size 64x64 --paths 2 --batches 2",
        env!("CARGO_BIN_EXE_lampyris")
    );
    let output =
        std::process::Command::new("sh").args(["-c", &script]).current_dir(&folder.0).output().unwrap();
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(4), "{err}");
    assert!(err.contains("cannot write a.exr"), "{err}");
    assert_eq!(folder.files(), ["a.exr"]);
    assert_eq!(folder.bytes("a.exr"), b"old");
}

#[test]
fn a_scene_without_light_is_told_of_and_a_sky_mends_it() {
    let folder = Folder::new("dark");
    std::fs::write(folder.0.join("dark.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let args = "render dark.obj -o dark.png --size 16x12 --batches 1 --json";
    let told = |run: &support::Run| run.json()["warnings"].to_string().contains("nothing shines");
    let dark = run(&folder, args);
    assert!(told(&dark) && dark.err.contains("--environment"), "{}", dark.err);
    std::fs::write(folder.0.join("sky.hdr"), {
        let mut sky = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".to_vec();
        sky.extend([128, 128, 128, 129, 128, 128, 128, 129]);
        sky
    })
    .unwrap();
    let lit = run(&folder, &format!("{args} --environment sky.hdr"));
    assert!(lit.code == 0 && !told(&lit), "{}", lit.err);
}
