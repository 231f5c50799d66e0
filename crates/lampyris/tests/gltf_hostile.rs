//! glTF and OBJ files that are cut off or have a bit turned, limits at their edge, and published corpora.

mod gltf_support;

use gltf_support::{Folder, Glb, assert_sound, scenes};
use lampyris::Error;
use lampyris::import::{Limits, Options, load};
use serde_json::json;
use std::path::{Path, PathBuf};

fn limited(set: impl FnOnce(&mut Limits)) -> Options {
    let mut options = Options::default();
    set(&mut options.limits);
    options
}

/// Loads at the limit, is refused with the option's name one above.
fn assert_limit(option: &str, limit: u64, set: fn(&mut Limits, u64), path: &Path) {
    load(path, &limited(|l| set(l, limit))).unwrap_or_else(|e| panic!("{option} at {limit}: {e}"));
    match load(path, &limited(|l| set(l, limit - 1))) {
        Err(Error::OverLimit { option: named, limit: told, .. }) => {
            assert_eq!((named, told), (option, limit - 1))
        }
        other => panic!("{option} one above {}: {other:?}", limit - 1),
    }
}

#[test]
fn every_limit_holds_exactly() {
    let folder = Folder::new();
    let mut glb = Glb::new();
    glb.square(json!({}));
    glb.json["nodes"] =
        json!([{"children": [1]}, {"mesh": 0, "children": [2]}, {"mesh": 0, "children": [3]}, {"mesh": 0}]);
    let text = glb.json.to_string();
    glb.json["buffers"] = json!([{"byteLength": glb.binary.len(), "uri": "a.bin"}]);
    folder.write("a.bin", &glb.binary);
    let json = glb.json.to_string();
    let path = folder.write("main.gltf", &json);
    assert!(json.len() > text.len());
    assert_limit("--max-json-bytes", json.len() as u64, |l, n| l.json_bytes = n, &path);
    assert_limit("--max-nodes", 4, |l, n| l.nodes = n, &path);
    assert_limit("--max-depth", 4, |l, n| l.depth = n, &path);
    assert_limit("--max-instances", 3, |l, n| l.instances = n, &path);
    assert_limit("--max-triangles", 6, |l, n| l.triangles = n, &path);
    assert_limit("--max-file-bytes", json.len() as u64, |l, n| l.file_bytes = n, &path);
    for k in 0..3 {
        folder.write(&format!("{k}.mtl"), "# none\n");
    }
    let obj = "mtllib 0.mtl\nmtllib 1.mtl 2.mtl\no a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\ng b\nf 1 2 3\n";
    let path = folder.write("main.obj", obj);
    assert_limit("--max-libraries", 3, |l, n| l.libraries = n, &path);
    assert_limit("--max-objects", 2, |l, n| l.objects = n, &path);
    assert_limit("--max-triangles", 3, |l, n| l.triangles = n, &path);
    assert_limit("--max-polygon", 4, |l, n| l.polygon = n, &path);
    assert_limit("--max-line-bytes", "mtllib 1.mtl 2.mtl".len() as u64, |l, n| l.line_bytes = n, &path);
    let d = Limits::default();
    assert_eq!((d.nodes, d.depth, d.instances, d.json_bytes), (1_000_000, 1024, 10_000_000, 256 << 20));
    assert_eq!((d.objects, d.libraries, d.line_bytes), (1_000_000, 64, 1 << 20));
}

/// `folder::mutate`, and what loads must be sound.
fn mutate(folder: &Folder, extension: &str, seed: &[u8]) -> (usize, usize) {
    let options = limited(|l| *l = Limits { triangles: 100_000, ..*l });
    gltf_support::folder::mutate(folder, extension, seed, &options, |loaded| assert_sound(&loaded.scene))
}

/// Three documents of about a kilobyte that use everything.
fn seeds() -> [Glb; 3] {
    let mut plain = Glb::new();
    plain.square(
        json!({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0},
        "emissiveFactor": [1, 1, 1], "alphaMode": "MASK", "doubleSided": true,
        "extensions": {"KHR_materials_volume": {"thicknessFactor": 1}, "KHR_materials_ior": {"ior": 1.5}}}),
    );
    plain.json["nodes"] =
        json!([{"mesh": 0, "rotation": [0, 0, 0, 1], "children": [1]}, {"scale": [1, 2, 3], "mesh": 0}]);

    let mut lamps = Glb::new();
    let position = lamps.accessor(&[0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0], 5120, "VEC3", 3);
    lamps.json["bufferViews"][0]["byteStride"] = json!(4);
    lamps.mesh(json!({"attributes": {"POSITION": position, "COLOR_0": position}, "mode": 6}));
    lamps.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1}}]);
    lamps.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 7}]}});
    lamps.add("nodes", json!({"camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}));
    lamps.json["scenes"] = json!([{"nodes": [0, 1]}]);

    let mut sparse = Glb::new();
    let position = sparse.floats("VEC3", &gltf_support::SQUARE);
    let (places, values) = (sparse.view(&[1, 2]), sparse.view(&[0; 24]));
    sparse.json["accessors"][position]["sparse"] = json!({"count": 2,
        "indices": {"bufferView": places, "componentType": 5121}, "values": {"bufferView": values}});
    let index = sparse.accessor(&[0, 1, 2, 3], 5121, "SCALAR", 4);
    sparse.mesh(json!({"attributes": {"POSITION": position}, "indices": index, "mode": 5}));
    [plain, lamps, sparse]
}

#[test]
fn broken_gltf_never_panics() {
    let folder = Folder::new();
    for mut glb in seeds() {
        let bytes = glb.bytes();
        load(&folder.write("main.glb", &bytes), &Options::default()).unwrap();
        let (good, all) = mutate(&folder, "glb", &bytes);
        assert!(all > 5000 && good > all / 20, "{good} of {all} loaded: the seeds must not break at once");
        let hex: String = glb.binary.iter().map(|b| format!("%{b:02x}")).collect();
        glb.json["buffers"] = json!([{"byteLength": glb.binary.len(), "uri": format!("data:,{hex}")}]);
        let (good, all) = mutate(&folder, "gltf", glb.json.to_string().as_bytes());
        assert!(all > 5000 && good > all / 20, "{good} of {all} loaded");
    }
}

#[test]
fn broken_obj_never_panics() {
    let folder = Folder::new();
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n";
    let library = "newmtl a\nKd .5 .5 .5\nKs .1 .1 .1\nNs 40\nillum 2\nnewmtl b\nKe 1 2 3\nd .5\nmap_Kd -s 1 2 3 -o 1 a b.png\n\
        map_Bump -bm 2 n.png\nnewmtl c\nillum 7\nNi 1.5\nTf 1 .5 1\nPr .5\nPm 1\nnorm x.png\n";
    folder.write("lib.mtl", library);
    let seeds = [
        format!("mtllib lib.mtl\n{square}o one\nusemtl a\nf 1 2 3 4\ng two\nusemtl b\nf 1/1/1 2/2/1 3//1\n")
            .repeat(11),
        format!("{square}f -4 -3 -2 -1\n# comment\nf 1/1 2/2 \\\n 3/1\nl 1 2\np 1\ns off\ncurv 1\n")
            .repeat(10),
        format!("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv 2 2 2 1 1 1\nf 1 2 3 4 5 1 2\n{square}").repeat(12),
    ];
    for seed in seeds {
        load(&folder.write("main.obj", &seed), &Options::default()).unwrap();
        let (good, all) = mutate(&folder, "obj", seed.as_bytes());
        assert!(all > 5000 && good > all / 10, "{good} of {all} loaded: the seeds must not break at once");
    }
    // A library under each of the broken names, asked for by a scene of its own.
    folder.write("main.obj", format!("{square}mtllib x.mtl\nusemtl b\nf 1 2 3\n"));
    let library = library.as_bytes();
    for bit in 0..8 * library.len() {
        let mut bytes = library.to_vec();
        bytes[bit / 8] ^= 1 << (bit % 8);
        folder.write("x.mtl", bytes);
        assert_sound(&folder.load("main.obj").unwrap().scene);
        folder.write("x.mtl", &library[..bit / 8]);
        assert_sound(&folder.load("main.obj").unwrap().scene);
    }
}

/// Every file beneath a folder that ends so.
fn beneath(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if endings.iter().any(|e| path.extension().is_some_and(|x| x == *e)) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// What the validator calls these matters to a reader: data that are not there, or trees that are none.
const GRAVE: &[&str] = &[
    "ACCESSOR_INDEX_OOB",
    "ACCESSOR_TOO_LONG",
    "BUFFER_VIEW_TOO_LONG",
    "GLB_CHUNK_TOO_BIG",
    "GLB_INVALID_VERSION",
    "GLB_UNEXPECTED_END_OF_CHUNK_DATA",
    "GLB_UNEXPECTED_END_OF_CHUNK_HEADER",
    "GLB_UNEXPECTED_END_OF_HEADER",
    "GLB_UNEXPECTED_FIRST_CHUNK",
    "INVALID_JSON",
    "NODE_LOOP",
    "UNKNOWN_ASSET_MAJOR_VERSION",
];

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn the_validators_corpus_is_survived_and_its_grave_faults_are_seen() {
    let folder = scenes().join("gltf/khronos-validator-tests");
    let mut files = beneath(&folder, &["gltf", "glb"]);
    // A mark of byte order is against the letter, and harmless.
    files.retain(|f| !f.ends_with("json/bom.gltf"));
    assert!(files.len() >= 371, "{}", files.len());
    let (mut refused, mut unseen) = (0, Vec::new());
    for file in &files {
        let loaded = load(file, &Options::default());
        refused += usize::from(loaded.is_err());
        let silent = loaded.is_ok_and(|l| {
            assert_sound(&l.scene);
            l.warnings.is_empty()
        });
        let report = PathBuf::from(format!("{}.report.json", file.display()));
        let Ok(report) = std::fs::read_to_string(report) else { continue };
        if let Some(code) =
            GRAVE.iter().find(|code| report.contains(&format!("\"{code}\""))).filter(|_| silent)
        {
            unseen.push(format!("{}: {code}", file.display()));
        }
    }
    assert!(unseen.is_empty(), "{unseen:#?}");
    assert!(refused > 20 && refused < files.len(), "{refused} of {}", files.len());
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn published_scenes_load_or_say_why_not() {
    for file in ["bevy", "hiprt", "gltf-transform-MIT", "gltf-rs"]
        .iter()
        .flat_map(|name| beneath(&scenes().join("gltf").join(name), &["gltf", "glb"]))
    {
        match load(&file, &Options::default()) {
            Ok(loaded) => assert_sound(&loaded.scene),
            Err(error) => {
                let text = error.to_string();
                let known = ["KHR_draco_mesh_compression", ".bin\": No such file"];
                assert!(known.iter().any(|k| text.contains(k)), "{}: {text}", file.display());
            }
        }
    }
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn a_packed_box_is_a_box() {
    let folder = scenes().join("gltf/gltf-transform-MIT/test/in");
    for name in ["BoxMeshopt.glb", "BoxMeshopt.gltf", "Box_glTF-Binary/Box.glb", "Box_glTF-Embedded/Box.gltf"]
    {
        let sum = load(&folder.join(name), &Options::default()).unwrap().scene.summary();
        assert!(sum.triangles == 12 && (sum.area - 6.0).abs() < 1e-3, "{name}: {sum:?}");
    }
}

/// Corners of all triangles in the world, with their material's name.
fn geometry(path: &Path) -> Vec<(Vec<f32>, String)> {
    let scene = load(path, &Options::default()).unwrap().scene;
    let mut all = Vec::new();
    for instance in &scene.instances {
        let mesh = &scene.meshes[instance.mesh as usize];
        for (triangle, material) in mesh.triangles.iter().zip(&mesh.materials) {
            let corners =
                triangle.map(|v| instance.transform.transform_point3(mesh.positions[v as usize]).to_array());
            all.push((corners.concat(), scene.materials[*material as usize].name.clone()));
        }
    }
    all
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn generated_scenes_have_the_right_counts() {
    let at = |name: &str| scenes().join("generated").join(name);
    for (name, triangles, instances) in
        [("cornell/cornell.glb", 32, 8), ("room/room.glb", 145_342, 26), ("glass/glass.glb", 0, 8)]
    {
        let loaded = load(&at(name), &Options::default()).unwrap();
        assert_eq!(loaded.warnings, Vec::<String>::new(), "{name}");
        let summary = loaded.scene.summary();
        let told: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(at(name).with_file_name("scene.json")).unwrap())
                .unwrap();
        assert_eq!(Some(summary.triangles), told["triangles"].as_u64(), "{name}");
        assert!(triangles == 0 || summary.triangles == triangles);
        assert_eq!((loaded.scene.instances.len(), loaded.scene.cameras.len()), (instances, 1), "{name}");
        let (camera, lens) = (&loaded.scene.cameras[0], told["camera"]["vfov_deg"].as_f64().unwrap());
        assert!((f64::from(camera.fov_y) - lens).abs() < 1e-4);
    }
    assert_eq!(geometry(&at("cornell/cornell.glb")), geometry(&at("cornell/cornell.obj")));
}
