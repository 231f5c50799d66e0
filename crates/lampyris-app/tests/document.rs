//! Saved documents in place of scenes: every command takes them, and pictures of them have the bits of a session's.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::document::{Ask, Document, Place, beside, open};
use lampyris::scene::{Camera, Edit, Scene};
use lampyris::session::Session;
use lampyris::world::World;
use support::{Folder, run};

/// The document that a desk would leave: lamps in groups, edited in a session.
fn saved(folder: &Folder, scene: &str, edits: impl FnOnce(&Scene) -> Vec<Edit>) -> Scene {
    let opened = open(&folder.0.join(scene), &Ask::default(), None).unwrap();
    let mut world = World::new(opened.scene.clone());
    world.separate(16).unwrap();
    for edit in edits(world.scene()) {
        world.apply(&edit).unwrap();
    }
    let mut document = Document::of(&opened.before, world.scene());
    document.layers = Some(16);
    Place::claim(&opened, None).unwrap().save(&document).unwrap();
    world.scene().clone()
}

fn view(eye: Vec3, target: Vec3) -> Edit {
    Edit::View { camera: Some(Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 50.0 }) }
}

/// All that a desk does to the box, so that nothing is as its file has it.
fn everything(scene: &Scene) -> Vec<Edit> {
    let mut chair = scene.instances[1].transform;
    chair.translation.x += 0.05;
    let mut added = scene.instances[1].clone();
    added.transform.translation.y += 0.3;
    let kind = lampyris::light::LightKind::Point {
        position: Vec3::new(0.2, 0.3, 0.4),
        intensity: Rgb::new(0.5, 1.0, 0.2),
    };
    vec![
        Edit::Move { instance: 1, transform: chair },
        Edit::AddInstance { instance: added },
        Edit::AddLight { light: lampyris::light::Light::new("new", kind) },
        Edit::Mix { group: 0, color: Rgb::new(0.4, 0.3, 0.1) },
        view(Vec3::new(0.27, 0.27, -0.6), Vec3::new(0.27, 0.27, 0.3)),
    ]
}

/// What `render --batches N` writes of a document is what a session shows of its scene after N batches.
#[test]
fn a_rendered_document_has_the_bits_of_the_session() {
    let folder = Folder::new("document-bits");
    let scene = saved(&folder, "cornell.mgf", everything);
    let rendered = run(&folder, "render cornell.mgf.lampyris.json -o a.exr --size 32x24 --batches 3 --json");
    assert_eq!(rendered.code, 0, "{}", rendered.err);
    assert_eq!(rendered.json()["view"]["found"], false);
    assert_eq!(rendered.json()["warnings"], serde_json::json!([]));
    let settings = Settings::interactive();
    let mut session = Session::open(scene, [32, 24], &settings, Some(2)).unwrap();
    session.settle(3).unwrap();
    let shown = session.frame().unwrap().shown();
    let (width, pixels) = picture(&folder, "a.exr");
    assert_eq!((width, pixels.len()), (32, shown.len()));
    for (k, (pixel, expected)) in pixels.iter().zip(&shown).enumerate() {
        assert_eq!(pixel.map(f32::to_bits), expected.to_array().map(f32::to_bits), "pixel {k}");
    }
    assert!(pixels.iter().flatten().any(|v| *v > 0.0));
    // The scene alone is shown as it is, and says where its edits lie.
    let plain = run(&folder, "render cornell.mgf -o b.exr --size 32x24 --batches 3 --json");
    let warning = plain.json()["warnings"][0].as_str().unwrap().to_owned();
    assert!(
        warning.contains("cornell.mgf.lampyris.json: open that") && plain.err.contains(&warning),
        "{warning}"
    );
    assert!(picture(&folder, "b.exr").1 != pixels);
}

fn picture(folder: &Folder, name: &str) -> (usize, Vec<[f32; 3]>) {
    let image = exr::prelude::read_first_rgba_layer_from_file(
        folder.0.join(name),
        |size, _| (size.width(), vec![[0.0; 3]; size.width() * size.height()]),
        |(width, pixels): &mut (usize, Vec<[f32; 3]>), at, (r, g, b, _): (f32, f32, f32, f32)| {
            pixels[at.y() * *width + at.x()] = [r, g, b];
        },
    );
    image.unwrap().layer_data.channel_data.pixels
}

/// The lamp of the box at half of its level: half the lumens, half the lux, in half the light of a film.
#[test]
fn all_commands_take_documents() {
    let folder = Folder::new("document-all");
    folder.put("points.txt", "0.27 0.1 0.27 0 1 0\n");
    let lux = |scene: &str| {
        let run = run(
            &folder,
            &format!("measure {scene} --points points.txt --batches 2 --paths 64 --json --quiet"),
        );
        assert_eq!(run.code, 0, "{}", run.err);
        run.json()[0]["lux"].as_f64().unwrap()
    };
    let power = |scene: &str| {
        let info = run(&folder, &format!("info {scene} --json")).json();
        [info["power_lm"].as_f64().unwrap(), info["power_lm_front"].as_f64().unwrap()]
    };
    let (before, lumens) = (lux("cornell.mgf"), power("cornell.mgf"));
    saved(&folder, "cornell.mgf", |scene| {
        assert_eq!(scene.groups.len(), 1);
        vec![Edit::Mix { group: 0, color: scene.groups[0].color * 0.5 }]
    });
    let name = beside("cornell.mgf".as_ref());
    let name = name.to_str().unwrap();
    assert!((lux(name) / before - 0.5).abs() < 1e-4, "{} {before}", lux(name));
    let halved = power(name);
    assert!(
        halved.iter().zip(lumens).all(|(half, all)| (half / all - 0.5).abs() < 1e-4),
        "{halved:?} {lumens:?}"
    );
    folder.put("walk.json", &format!(r#"{{"scene": "{name}", "size": [12, 9], "frames": 1}}"#));
    let played = run(&folder, "play walk.json -o %d.exr --settle 2 --quiet");
    assert_eq!(played.code, 0, "{}", played.err);
    folder.put("plain.json", r#"{"scene": "cornell.mgf", "size": [12, 9], "frames": 1}"#);
    assert_eq!(run(&folder, "play plain.json -o p%d.exr --settle 2 --quiet").code, 0);
    let sum = |name: &str| picture(&folder, name).1.iter().flatten().map(|v| f64::from(*v)).sum::<f64>();
    assert!((sum("0.exr") / sum("p0.exr") - 0.5).abs() < 0.1);
}

#[test]
fn broken_documents_are_told_of_in_a_line() {
    let folder = Folder::new("document-broken");
    let cases = [
        ("{\"lampyris\": 7}", "version 7"),
        ("not json", "no document of Lampyris"),
        ("{\"lampyris\": 1, \"scene\": {\"file\": \"../x.mgf\"}}", "outside the scene's root"),
        ("{\"lampyris\": 1, \"scene\": {\"file\": \"gone.mgf\"}}", "cannot open"),
        ("{\"lampyris\": 1, \"scene\": {\"file\": \"cornell.mgf\"}, \"lamps\": {}}", "unknown field `lamps`"),
    ];
    for (text, words) in cases {
        folder.put("a.lampyris.json", text);
        for command in ["info", "render -o a.png", "measure --points a.lampyris.json"] {
            let run = run(&folder, &format!("{command} a.lampyris.json"));
            assert_eq!(run.code, 3, "{}", run.err);
            assert!(run.err.lines().count() == 1, "{}", run.err);
            assert!(run.err.contains(words) || command.starts_with("measure"), "{}", run.err);
        }
    }
    // Lamps that wait to be sorted: a document by hand.
    folder.put("a.lampyris.json", "{\"lampyris\": 1, \"scene\": {\"file\": \"cornell.mgf\"}, \"layers\": 4}");
    assert_eq!(run(&folder, "render a.lampyris.json -o a.exr --size 8x6 --batches 1 --quiet").code, 0);
    assert_eq!(run(&folder, "render cornell.mgf -o b.exr --size 8x6 --batches 1 --quiet --groups 4").code, 0);
    assert!(picture(&folder, "a.exr") == picture(&folder, "b.exr"));
}
