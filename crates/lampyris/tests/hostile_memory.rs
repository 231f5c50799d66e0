//! Hundreds of glTF and OBJ files that mean harm: bombs, loops, diamonds, absurd counts, names that climb out. None may
//! panic, take long, read outside its folder, or hold more than 64 MiB and 64 bytes for each of its own.
//! One test in a binary of its own, because its allocator counts for the whole process.

mod gltf_support;

use gltf_support::{Folder, Glb, assert_sound, container};
use lampyris::import::{Options, load};
use peak_alloc::PeakAlloc;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Loads `main` of a folder whose files have `bytes` in all, within the bounds; returns its error.
fn attempt(folder: &Folder, main: &str, bytes: usize, name: &str) -> Option<String> {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let start = Instant::now();
    let loaded = load(&folder.0.join(main), &Options::default());
    let (took, peak) = (start.elapsed(), MEMORY.peak_usage().saturating_sub(before));
    assert!(took < Duration::from_secs(10), "{name}: {took:?}");
    let allowed = (64 << 20) + 64 * bytes;
    assert!(peak <= allowed, "{name}: {} MiB of {} MiB", peak >> 20, allowed >> 20);
    match loaded {
        Ok(loaded) => {
            assert_sound(&loaded.scene);
            assert!(!loaded.warnings.join("\n").contains("CANARY"), "{name}");
            None
        }
        Err(error) => {
            let text = error.to_string();
            assert!(!text.contains("CANARY") && text.len() < 2000, "{name}: {text}");
            Some(text)
        }
    }
}

fn attempt_bytes(main: &str, bytes: &[u8], name: &str) -> Option<String> {
    let folder = Folder::new();
    folder.write(main, bytes);
    attempt(&folder, main, bytes.len(), name)
}

/// A square with everything that may be asked for too much.
fn full() -> Glb {
    let mut glb = Glb::new();
    glb.square(json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
    let uv = glb.floats("VEC2", &[0.0; 8]);
    let (places, values) = (glb.view(&[1, 0, 2, 0]), glb.view(&[0; 24]));
    glb.json["accessors"][0]["sparse"] = json!({"count": 2,
        "indices": {"bufferView": places, "byteOffset": 0, "componentType": 5123},
        "values": {"bufferView": values, "byteOffset": 0}});
    glb.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(uv);
    glb.json["accessors"][0]["byteOffset"] = json!(0);
    glb.json["textures"] = json!([{"source": 0, "sampler": 0}]);
    glb.json["samplers"] = json!([{}]);
    let image = glb.view(&[137, 80, 78, 71]);
    glb.json["images"] = json!([{"bufferView": image}]);
    glb.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1}}]);
    glb.json["nodes"] = json!([{"mesh": 0, "camera": 0, "children": [1]}, {"mesh": 0}]);
    glb.json["scenes"] = json!([{"nodes": [0]}]);
    glb.json["scene"] = json!(0);
    glb.json["buffers"] = json!([{"byteLength": glb.binary.len()}]);
    glb.json["bufferViews"][0]["byteStride"] = json!(12);
    glb
}

/// Every number of the document, by its path.
fn numbers(value: &Value, path: &str, out: &mut Vec<String>) {
    match value {
        Value::Number(_) => out.push(path.into()),
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(k, v)| numbers(v, &format!("{path}/{k}"), out))
        }
        Value::Object(items) => items.iter().for_each(|(k, v)| numbers(v, &format!("{path}/{k}"), out)),
        _ => {}
    }
}

/// Each number replaced by each of a row of absurd ones.
fn absurd_numbers() -> usize {
    let glb = full();
    let mut paths = Vec::new();
    numbers(&glb.json, "", &mut paths);
    let absurd = [
        json!(-1),
        json!(2_000_000_000u32),
        json!(u32::MAX),
        json!(1u64 << 53),
        json!(u64::MAX),
        json!(1e300),
        json!(0.5),
        json!("x"),
        json!([]),
        json!({}),
        json!(null),
    ];
    for path in &paths {
        for value in &absurd {
            let mut edited = glb.clone();
            *edited.json.pointer_mut(path).unwrap() = value.clone();
            attempt_bytes("main.glb", &edited.bytes(), &format!("{path} = {value}"));
        }
    }
    paths.len() * absurd.len()
}

/// Arrays of as many empty elements as fit.
fn floods() -> usize {
    let wrapped = [
        ("nodes", "{\"nodes\":[", "{}", "]"),
        ("meshes", "{\"meshes\":[", "{}", "]"),
        ("accessors", "{\"accessors\":[", "{}", "]"),
        ("materials", "{\"materials\":[", "{}", "]"),
        ("textures", "{\"textures\":[", "{}", "]"),
        ("images", "{\"images\":[", "{}", "]"),
        ("samplers", "{\"samplers\":[", "{}", "]"),
        ("cameras", "{\"cameras\":[", "{}", "]"),
        ("buffers", "{\"buffers\":[", "{}", "]"),
        ("views", "{\"bufferViews\":[", "{}", "]"),
        ("scenes", "{\"scenes\":[", "{}", "]"),
        ("animations", "{\"animations\":[", "{}", "]"),
        ("used", "{\"extensionsUsed\":[", "\"\"", "]"),
        ("required", "{\"extensionsRequired\":[", "\"\"", "]"),
        ("roots", "{\"scenes\":[{\"nodes\":[", "0", "]}]"),
        ("children", "{\"nodes\":[{\"children\":[", "0", "]}]"),
        ("primitives", "{\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[", "{}", "]}]"),
        ("lights", "{\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[", "{}", "]}}"),
        ("lamps", "{\"nodes\":[", "{\"extensions\":{}}", "]"),
        ("paint", "{\"materials\":[", "{\"pbrMetallicRoughness\":{}}", "]"),
        ("glass", "{\"materials\":[", "{\"extensions\":{}}", "]"),
        ("sparse", "{\"accessors\":[", "{\"sparse\":{}}", "]"),
        ("packed", "{\"bufferViews\":[", "{\"extensions\":{}}", "]"),
        ("extras", "{\"extras\":[", "[]", "]"),
        ("placed", "{\"meshes\":[{}],\"nodes\":[", "{\"mesh\":0}", "]"),
    ];
    for (name, head, item, tail) in wrapped {
        let sizes: &[usize] =
            if matches!(name, "nodes" | "primitives") { &[1 << 20, 4 << 20] } else { &[1 << 20] };
        for size in sizes {
            let items = vec![item; *size / (item.len() + 1)].join(",");
            let text = format!("{head}{items}{tail},\"asset\":{{\"version\":\"2.0\"}}}}");
            attempt_bytes("main.gltf", text.as_bytes(), name);
        }
    }
    wrapped.len() + 2
}

fn trees() -> usize {
    let asset = json!({"version": "2.0"});
    let refused = |nodes: Value, name: &str| {
        let text =
            json!({"asset": asset, "nodes": nodes, "meshes": [{}], "scenes": [{"nodes": [0]}]}).to_string();
        assert!(attempt_bytes("main.gltf", text.as_bytes(), name).is_some(), "{name} must be refused");
    };
    refused(json!([{"children": [0]}]), "a loop of one");
    refused(json!([{"children": [1]}, {"children": [0]}]), "a loop of two");
    refused((0..100_000).map(|k| json!({"children": [k + 1]})).chain([json!({})]).collect(), "a deep chain");
    let diamond = (0..40).map(|k| json!({"children": [k + 1, k + 1]})).chain([json!({"mesh": 0})]);
    refused(diamond.collect(), "a diamond");
    let ladder = (0..40).flat_map(|k| vec![json!({"children": [2 * k + 2, 2 * k + 3]}); 2]);
    refused(ladder.chain([json!({"mesh": 0}), json!({"mesh": 0})]).collect(), "a ladder");
    let name = "n".repeat(10_000);
    let long: Value = (0..200)
        .map(|k| json!({"name": name, "mesh": 0, "children": if k < 199 { vec![k + 1] } else { vec![] }}))
        .collect();
    let text = json!({"asset": asset, "nodes": long, "meshes": [{}], "scenes": [{"nodes": [0]}]}).to_string();
    attempt_bytes("main.gltf", text.as_bytes(), "long names");
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        for end in [close, ""] {
            let deep = format!("{{\"extras\":{}0{}", open.repeat(200_000), end.repeat(200_000));
            attempt_bytes("main.gltf", format!("{deep}}}").as_bytes(), "deep JSON");
        }
    }
    10
}

/// Data used again and again, and data that grow.
fn bombs() -> usize {
    let mut cases: Vec<(&str, Glb)> = Vec::new();
    let mut shared = Glb::new();
    let position = shared.floats("VEC3", &vec![0.5; 300_000]);
    let few = shared.indices(&[0, 1, 2]);
    let primitive = json!({"attributes": {"POSITION": position, "NORMAL": position}, "indices": few});
    shared.add("meshes", json!({"primitives": vec![primitive; 20_000]}));
    shared.add("nodes", json!({"mesh": 0}));
    cases.push(("small parts of one large array", shared.clone()));
    shared.json["accessors"][position]["sparse"] = json!({"count": 100_000,
        "indices": {"bufferView": 0, "componentType": 5125}, "values": {"bufferView": 0}});
    cases.push(("the same, sparse", shared.clone()));
    let mut many = Glb::new();
    let position = many.floats("VEC3", &vec![0.5; 9_000]);
    many.add("meshes", json!({"primitives": vec![json!({"attributes": {"POSITION": position}}); 200_000]}));
    many.add("nodes", json!({"mesh": 0}));
    cases.push(("two hundred million triangles of one array", many.clone()));
    many.json["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": position}}]}]);
    many.json["nodes"] = (0..100_000).map(|_| json!({"mesh": 0})).collect();
    cases.push(("a hundred million triangles by instances", many));
    let mut zeros = Glb::new();
    zeros.json["accessors"] = json!([{"componentType": 5126, "type": "VEC3", "count": 1_000_000}]);
    zeros.json["meshes"] = json!([{"primitives": vec![json!({"attributes": {"POSITION": 0}}); 100]}]);
    zeros.add("nodes", json!({"mesh": 0}));
    cases.push(("zeros from nothing", zeros.clone()));
    zeros.binary = vec![0; 64];
    let sparse =
        json!({"count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}});
    zeros.json["bufferViews"] = json!([{"buffer": 0, "byteLength": 64}]);
    zeros.json["accessors"] =
        vec![json!({"componentType": 5126, "type": "VEC3", "count": 1_000_000, "sparse": sparse}); 100]
            .into();
    zeros.json["meshes"] =
        json!([{"primitives": (0..100).map(|k| json!({"attributes": {"POSITION": k}})).collect::<Vec<_>>()}]);
    cases.push(("sparse zeros", zeros));
    for (mode, stride, first) in
        [("ATTRIBUTES", 256, 0xa0u8), ("ATTRIBUTES", 4, 0xa0), ("TRIANGLES", 4, 0xe1), ("INDICES", 4, 0xd1)]
    {
        let mut packed = Glb::new();
        packed.binary = vec![0; 10_000];
        packed.binary[0] = first;
        for count in [3u64, 3000, 300_000, 3_000_000_000, 1 << 60] {
            let extension = json!({"EXT_meshopt_compression": {"buffer": 0, "byteLength": 10_000, "byteStride": stride,
                "count": count, "mode": mode}});
            packed.json["bufferViews"] =
                vec![json!({"buffer": 0, "byteLength": 10, "extensions": extension}); 2000].into();
            cases.push(("packed bombs", packed.clone()));
        }
    }
    let mut text = Glb::new();
    text.json["buffers"] =
        json!([{"byteLength": 1, "uri": format!("data:;base64,{}", "AAAA".repeat(500_000))}]);
    text.json["bufferViews"] = json!([{"buffer": 0, "byteLength": 1}]);
    cases.push(("base64", text));
    for (name, glb) in &cases {
        attempt_bytes("main.glb", &glb.bytes(), name);
    }
    // One file under many names.
    let folder = Folder::new();
    folder.write("a.bin", vec![0; 1 << 20]);
    let buffers = vec![json!({"byteLength": 1 << 20, "uri": "a.bin"}); 5000];
    let views: Vec<Value> = (0..5000).map(|k| json!({"buffer": k, "byteLength": 1})).collect();
    let text = json!({"asset": {"version": "2.0"}, "buffers": buffers, "bufferViews": views}).to_string();
    folder.write("main.gltf", &text);
    assert_eq!(attempt(&folder, "main.gltf", text.len() + (1 << 20), "one file often"), None);
    cases.len() + 1
}

fn containers() -> usize {
    let good = full().bytes();
    let mut cases = Vec::new();
    for at in [4, 8, 12, 16, 20] {
        for value in [0u32, 1, 11, 12, 19, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
            let mut bytes = good.clone();
            bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
            cases.push(bytes);
        }
    }
    cases.extend([
        b"glTF".to_vec(),
        Vec::new(),
        vec![0xff; 4096],
        container(b"", None),
        container(b"{}", None),
    ]);
    cases.push(container(&vec![b' '; 4 << 20], Some(&[])));
    for (k, bytes) in cases.iter().enumerate() {
        attempt_bytes("main.glb", bytes, &format!("container {k}"));
    }
    cases.len()
}

fn texts() -> usize {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    let face = |n: usize| format!("{square}f{}\n", " 1 2 3".repeat(n));
    let cases: Vec<(&str, String)> = vec![
        ("a long line", "#".repeat(4 << 20)),
        ("a line without end", "v 1 \\\n".repeat(1 << 18)),
        ("objects", format!("{square}{}", "o a\nf 1 2 3\n".repeat(300_000))),
        ("too many objects", "g\n".repeat(1_500_000)),
        ("groups without faces", "g a\n".repeat(500_000)),
        ("a polygon at the limit", face(21_845)),
        ("a polygon over the limit", face(21_846)),
        ("polygons", format!("{square}{}", "f 1 2 3 1 2 3 1 2 3\n".repeat(50_000))),
        ("vertices", "v 0 0 0\n".repeat(500_000)),
        ("coordinates", "vt 0\n".repeat(800_000)),
        ("normals", "vn\n".repeat(1_000_000)),
        ("corners", format!("{square}{}", "f 1 2 3\n".repeat(500_000))),
        ("corners of many kinds", {
            let vt = "vt 0\n".repeat(100_000);
            let faces: String = (1..=100_000).map(|k| format!("f 1/{k} 2/{k} 3/{k}\n")).collect();
            format!("{square}{vt}{faces}")
        }),
        ("unknown words", (0..300_000).map(|k| format!("w{k}\n")).collect()),
        ("unknown materials", (0..300_000).map(|k| format!("usemtl {k}\n")).collect()),
        ("missing libraries", (0..10_000).map(|k| format!("mtllib {k}.mtl\n")).collect()),
        ("the same library", "mtllib main.obj\n".repeat(100_000)),
        ("one line of libraries", format!("mtllib {}\n", "a ".repeat(10_000))),
        ("infinite numbers", "v 1e39 inf nan\nv -inf 0 0\nv 1e38 1e38 1e38\nf 1 2 3\nf 3 3 3\n".into()),
        ("indices beyond", format!("{square}f 99999999999999999999 1 2\n")),
        ("least index", format!("{square}f -9223372036854775808 1 2\n")),
        ("zero bytes", "\0".repeat(1 << 20)),
        ("line ends", "\r\n\n\r".repeat(1 << 20)),
    ];
    for (name, text) in &cases {
        attempt_bytes("main.obj", text.as_bytes(), name);
    }
    let libraries: Vec<(&str, String)> = vec![
        ("materials", (0..200_000).map(|k| format!("newmtl {k}\n")).collect()),
        ("one material often", "newmtl a\n".repeat(300_000)),
        ("missing pictures", (0..5_000).map(|k| format!("newmtl {k}\nmap_Kd {k}.png\n")).collect()),
        ("options", format!("newmtl a\nmap_Kd {}\n", "-s 1 1 1 ".repeat(100_000))),
        (
            "infinite factors",
            "newmtl a\nKd 1e39 nan -inf\nKe 1e38 1e38 1e38\nNs -1e38\nd 7\nNi -1\nillum 1e30\n".into(),
        ),
    ];
    for (name, text) in &libraries {
        let folder = Folder::new();
        let main = format!("mtllib lib.mtl\n{square}f 1 2 3\n");
        folder.write("lib.mtl", text);
        folder.write("main.obj", &main);
        attempt(&folder, "main.obj", main.len() + text.len(), name);
    }
    cases.len() + libraries.len()
}

/// Names that lead out, or to what is no file, in every place that takes one.
#[cfg(unix)]
fn names() -> usize {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    folder.write("secret.txt", "newmtl CANARY\nCANARY CANARY\n");
    folder.write("scene/main.obj", "");
    folder.write("scene/sub/inner.bin", "");
    let at = |name: &str| folder.0.join("scene").join(name);
    symlink("../secret.txt", at("link.txt")).unwrap();
    symlink("..", at("up")).unwrap();
    symlink("/dev/zero", at("zero")).unwrap();
    symlink("loop", at("loop")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(at("pipe")).status().unwrap().success());
    let absolute = folder.0.join("secret.txt").display().to_string();
    let mut all: Vec<String> = [
        "../secret.txt",
        "sub/../../secret.txt",
        "link.txt",
        "up/secret.txt",
        "zero",
        "loop",
        "pipe",
        "sub",
        ".",
        "..",
        "/etc/passwd",
        "/dev/zero",
        "//etc/passwd",
        "C:\\secret.txt",
        "c:secret.txt",
        "..\\secret.txt",
        "\\\\host\\secret.txt",
        "file:///etc/passwd",
        "file:../secret.txt",
        "http://host/secret.txt",
        "ftp://host/a",
        "%2e%2e/secret.txt",
        "%2e%2e%2fsecret.txt",
        "..%2Fsecret.txt",
        "%2fetc%2fpasswd",
        "%66ile:///etc/passwd",
        "up%2fsecret.txt",
        "%2e%2e%5csecret.txt",
        "sub/inner.bin/../../../secret.txt",
        "main.obj/",
        "a%00b",
        "~/secret.txt",
        "",
        "%",
        "%zz",
        "?",
        "#",
    ]
    .map(String::from)
    .into();
    all.push(absolute.clone());
    all.push(format!("file://{absolute}"));
    all.push("../".repeat(2000) + "etc/passwd");
    let mut glb = full();
    for name in &all {
        glb.json["buffers"] = json!([{"byteLength": 4, "uri": name}]);
        std::fs::write(at("buffer.gltf"), glb.json.to_string()).unwrap();
        assert!(attempt(&folder, "scene/buffer.gltf", 4096, name).is_some(), "buffer {name:?}");
        let mut picture = full();
        picture.json["images"] = json!([{"uri": name}]);
        std::fs::write(at("image.glb"), picture.bytes()).unwrap();
        assert_eq!(attempt(&folder, "scene/image.glb", 4096, name), None, "image {name:?}");
        std::fs::write(at("library.obj"), format!("mtllib {name}\n")).unwrap();
        assert_eq!(attempt(&folder, "scene/library.obj", 4096, name), None, "library {name:?}");
        std::fs::write(at("own.mtl"), format!("newmtl a\nmap_Kd {name}\nnorm -bm 1 {name}\n")).unwrap();
        std::fs::write(at("texture.obj"), "mtllib own.mtl\n").unwrap();
        assert_eq!(attempt(&folder, "scene/texture.obj", 4096, name), None, "texture {name:?}");
    }
    4 * all.len()
}

#[test]
fn no_file_does_harm() {
    let mut files =
        [absurd_numbers(), floods(), trees(), bombs(), containers(), texts()].iter().sum::<usize>();
    #[cfg(unix)]
    {
        files += names();
    }
    assert!(files >= 300, "{files} files");
}
