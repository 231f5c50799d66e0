//! What glTF means: geometry in all its encodings, nodes, cameras and lamps, on files of a few triangles.

mod gltf_support;

use glam::{Vec2, Vec3, Vec4};
use gltf_support::{Folder, Glb, SQUARE, assert_sound};
use lampyris::Rgb;
use lampyris::light::{Beam, LightKind};
use lampyris::scene::{Mesh, Scene};
use serde_json::json;

fn only_mesh(scene: &Scene) -> &Mesh {
    assert_sound(scene);
    assert_eq!(scene.meshes.len(), 1);
    &scene.meshes[0]
}

fn corners(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    mesh.triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize])).collect()
}

fn square_corners() -> Vec<[Vec3; 3]> {
    let [a, b, c, d] = [Vec3::ZERO, Vec3::X, Vec3::new(1., 1., 0.), Vec3::Y];
    vec![[a, b, c], [a, c, d]]
}

fn bytes_of<const N: usize>(values: &[f32], each: impl Fn(f32) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|v| each(*v)).collect()
}

#[test]
fn a_square_is_a_square_in_every_encoding() {
    let mut plain = Glb::new();
    plain.square(json!({}));
    let scene = plain.clean();
    assert_eq!(corners(only_mesh(&scene)), square_corners());
    assert_eq!((scene.up, only_mesh(&scene).materials.clone()), (Some(Vec3::Y), vec![0, 0]));
    // Positions as integers (KHR_mesh_quantization), indices of every type, triangles as list, strip and fan.
    let quantized: [(u32, Vec<u8>, bool); 6] = [
        (5120, bytes_of(&SQUARE, |v| [(v as i8) as u8]), false),
        (5121, bytes_of(&SQUARE, |v| [v as u8 * 255]), true),
        (5122, bytes_of(&SQUARE, |v| (v as i16).to_le_bytes()), false),
        (5122, bytes_of(&SQUARE, |v| (v as i16 * 32767).to_le_bytes()), true),
        (5123, bytes_of(&SQUARE, |v| (v as u16 * 65535).to_le_bytes()), true),
        (5126, bytes_of(&SQUARE, f32::to_le_bytes), false),
    ];
    for (component, bytes, normalized) in quantized {
        let mut glb = Glb::new();
        let position = glb.accessor(&bytes, component, "VEC3", 4);
        glb.json["accessors"][position]["normalized"] = json!(normalized);
        let index = glb.accessor(&[0, 1, 2, 0, 2, 3], 5121, "SCALAR", 6);
        glb.mesh(json!({"attributes": {"POSITION": position}, "indices": index}));
        assert_eq!(corners(only_mesh(&glb.clean())), square_corners(), "{component}");
    }
    for (mode, order) in [(4, vec![0u16, 1, 2, 0, 2, 3]), (5, vec![1, 2, 0, 3]), (6, vec![0, 1, 2, 3])] {
        let mut glb = Glb::new();
        let position = glb.floats("VEC3", &SQUARE);
        let bytes: Vec<u8> = order.iter().flat_map(|i| i.to_le_bytes()).collect();
        let index = glb.accessor(&bytes, 5123, "SCALAR", order.len());
        glb.mesh(json!({"attributes": {"POSITION": position}, "indices": index, "mode": mode}));
        let scene = glb.clean();
        let made = corners(only_mesh(&scene));
        let area = |t: &[Vec3; 3]| 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
        assert_eq!(made.iter().map(area).collect::<Vec<_>>(), [Vec3::Z * 0.5; 2], "mode {mode}");
    }
}

#[test]
fn strides_offsets_and_sparse_values_are_followed() {
    // Position and normal side by side, behind 8 bytes that are nobody's.
    let mut glb = Glb::new();
    let mut bytes = vec![255u8; 8];
    for p in SQUARE.chunks_exact(3) {
        let vertex = [p[0], p[1], p[2], 0.0, 0.0, 2.0];
        bytes.extend(vertex.iter().flat_map(|v: &f32| v.to_le_bytes()));
    }
    let view = glb.view(&bytes);
    glb.json["bufferViews"][view]["byteStride"] = json!(24);
    let at = |offset: usize| json!({"bufferView": view, "byteOffset": offset, "componentType": 5126, "type": "VEC3", "count": 4});
    let (position, normal) = (glb.add("accessors", at(8)), glb.add("accessors", at(20)));
    let index = glb.indices(&[0, 1, 2, 0, 2, 3]);
    let attributes = json!({"POSITION": position, "NORMAL": normal});
    glb.mesh(json!({"attributes": attributes, "indices": index}));
    let scene = glb.clean();
    assert_eq!(corners(only_mesh(&scene)), square_corners());
    assert_eq!(only_mesh(&scene).normals, [Vec3::Z; 4], "made unit vectors");

    // A third corner moved by a sparse accessor; then one that has no other values than the sparse ones.
    let places = glb.view(&[2, 0]);
    let values = glb.view(&bytes_of(&[3., 3., 3.], f32::to_le_bytes));
    let sparse = json!({"count": 1, "indices": {"bufferView": places, "componentType": 5123},
        "values": {"bufferView": values}});
    glb.json["accessors"][position]["sparse"] = sparse.clone();
    let mesh = glb.clean();
    assert_eq!(only_mesh(&mesh).positions, [Vec3::ZERO, Vec3::X, Vec3::splat(3.), Vec3::Y]);
    glb.json["accessors"][position] =
        json!({"componentType": 5126, "type": "VEC3", "count": 4, "sparse": sparse});
    let mesh = glb.clean();
    assert_eq!(only_mesh(&mesh).positions, [Vec3::ZERO, Vec3::ZERO, Vec3::splat(3.), Vec3::ZERO]);
}

#[test]
fn attributes_come_in_their_types() {
    let mut glb = Glb::new();
    let position = glb.floats("VEC3", &SQUARE);
    let uv0 = glb.accessor(&[0, 0, 255, 0, 255, 255, 0, 51], 5121, "VEC2", 4);
    let uv1 = glb.floats("VEC2", &[0., 0., 2., 0., 2., 2., f32::NAN, 2.]);
    let color = glb.accessor(&[255, 0, 51, 9, 255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255, 9], 5121, "VEC3", 4);
    let view = glb.json["accessors"][color]["bufferView"].as_u64().unwrap() as usize;
    glb.json["bufferViews"][view]["byteStride"] = json!(4);
    for k in [uv0, color] {
        glb.json["accessors"][k]["normalized"] = json!(true);
    }
    let index = glb.indices(&[0, 1, 2, 0, 2, 3]);
    let attributes = json!({"POSITION": position, "TEXCOORD_0": uv0, "TEXCOORD_1": uv1, "COLOR_0": color});
    glb.mesh(json!({"attributes": attributes, "indices": index}));
    let scene = glb.clean();
    let mesh = only_mesh(&scene);
    assert_eq!(mesh.uvs[0], [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::new(0., 0.2)]);
    assert_eq!(mesh.uvs[1], [Vec2::ZERO, Vec2::new(2., 0.), Vec2::splat(2.), Vec2::new(0., 2.)]);
    assert_eq!(mesh.colors[0], Vec4::new(1., 0., 0.2, 1.));
    assert!(mesh.normals.is_empty() && mesh.tangents.is_empty(), "flat where the file has none");
    // Four channels, the last of which is alpha.
    let floats: Vec<f32> = (0..16).map(|k| k as f32 / 15.0).collect();
    let color = glb.floats("VEC4", &floats);
    glb.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = json!(color);
    assert_eq!(glb.clean().meshes[0].colors[3].to_array(), floats[12..]);
}

#[test]
fn a_mesh_used_twice_is_one_mesh_and_primitives_merge() {
    let mut glb = Glb::new();
    glb.square(json!({"name": "a"}));
    glb.add("materials", json!({"name": "b"}));
    let mut second = glb.json["meshes"][0]["primitives"][0].clone();
    second["material"] = json!(1);
    glb.json["meshes"][0]["primitives"].as_array_mut().unwrap().push(second.clone());
    glb.json["nodes"] = json!([
        {"name": "room", "translation": [1, 0, 0], "children": [1, 2]},
        {"name": "left", "mesh": 0, "translation": [0, 2, 0]},
        {"mesh": 0, "scale": [-1, 1, 1], "rotation": [0, 0, 0.6, 0.8]},
    ]);
    glb.json["scenes"] = json!([{"nodes": [0]}]);
    let scene = glb.clean();
    let mesh = only_mesh(&scene);
    assert_eq!((mesh.positions.len(), mesh.materials.clone()), (8, vec![0, 0, 1, 1]));
    assert_eq!(mesh.triangles[2], [4, 5, 6]);
    let names: Vec<&str> = scene.instances.iter().map(|i| i.name.as_str()).collect();
    assert_eq!((names, scene.instances[1].mesh), (vec!["room/left", "room"], 0));
    assert_eq!(scene.instances[0].transform.transform_point3(Vec3::ZERO), Vec3::new(1., 2., 0.));
    // Turned by the angle whose half has cosine 0.8: cos 0.28, sin 0.96; x was mirrored before.
    let turned = scene.instances[1].transform.transform_point3(Vec3::X);
    assert!((turned - Vec3::new(1.0 - 0.28, -0.96, 0.0)).length() < 1e-6, "{turned}");
    assert!(scene.instances[1].transform.matrix3.determinant() < 0.0);
    // The same by a matrix.
    glb.json["nodes"][2] =
        json!({"mesh": 0, "matrix": [-0.28, -0.96, 0, 0, -0.96, 0.28, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]});
    let by_matrix = glb.clean().instances[1].transform;
    assert!(by_matrix.abs_diff_eq(scene.instances[1].transform, 1e-6));
    // Other attributes make another mesh, and both stand where the node says.
    let uv = glb.floats("VEC2", &[0.; 8]);
    glb.json["meshes"][0]["primitives"][1]["attributes"]["TEXCOORD_0"] = json!(uv);
    let scene = glb.clean();
    assert_eq!((scene.meshes.len(), scene.instances.len()), (2, 4));
    assert_eq!(scene.meshes[1].materials, [1, 1]);
}

#[test]
fn a_mirrored_instance_keeps_its_front() {
    let mut glb = Glb::new();
    glb.square(json!({}));
    glb.json["nodes"][0]["scale"] = json!([-1, 1, 1]);
    let world = lampyris::world::World::new(glb.clean());
    let ray = lampyris::geometry::Ray::new(Vec3::new(-0.4, 0.3, 1.0), Vec3::NEG_Z);
    let hit = world.closest(&ray).unwrap();
    assert!(hit.front && hit.normal == Vec3::Z, "the front faces +z, mirrored in x or not");
}

#[test]
fn few_vertices_of_a_large_array_are_copied_alone() {
    let mut glb = Glb::new();
    let points: Vec<f32> = (0..3000).map(|k| k as f32).collect();
    let position = glb.floats("VEC3", &points);
    let index = glb.indices(&[900, 10, 500, 500, 10, 11]);
    glb.mesh(json!({"attributes": {"POSITION": position}, "indices": index}));
    let scene = glb.clean();
    let mesh = only_mesh(&scene);
    let at = |k: usize| Vec3::new(3.0 * k as f32, 3.0 * k as f32 + 1.0, 3.0 * k as f32 + 2.0);
    assert_eq!(mesh.positions, [at(10), at(11), at(500), at(900)]);
    assert_eq!(corners(mesh), [[at(900), at(10), at(500)], [at(500), at(10), at(11)]]);
}

#[test]
fn cameras_and_lamps_stand_at_their_nodes() {
    let mut glb = Glb::new();
    glb.json["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}]);
    glb.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [1, 0.5, 0.25], "intensity": 80},
        {"type": "spot", "intensity": 10, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}, "range": 3},
        {"type": "directional", "name": "sun"},
        {"type": "laser"},
    ]}});
    let lamp = |k: u32| json!({"KHR_lights_punctual": {"light": k}});
    // A quarter turn about y: −z becomes −x.
    let h = 0.5f64.sqrt();
    glb.json["nodes"] = json!([
        {"name": "eye", "camera": 0, "translation": [1, 2, 3], "rotation": [0, h, 0, h]},
        {"name": "bulb", "extensions": lamp(0), "translation": [0, 2, 0], "scale": [9, 9, 9]},
        {"name": "spot", "extensions": lamp(1), "rotation": [0, h, 0, h]},
        {"extensions": lamp(2)},
        {"camera": 1}, {"extensions": lamp(3)},
    ]);
    let loaded = glb.load().unwrap();
    assert_eq!(loaded.warnings.len(), 2, "{:?}", loaded.warnings);
    let scene = loaded.scene;
    assert_sound(&scene);
    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.eye, scene.cameras.len()), ("eye", Vec3::new(1., 2., 3.), 1));
    assert!(
        (camera.target - Vec3::new(0., 2., 3.)).length() < 1e-6 && (camera.fov_y - 57.29578).abs() < 1e-4
    );
    assert!((camera.up - Vec3::Y).length() < 1e-6);
    let names: Vec<&str> = scene.lights.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(names, ["bulb", "spot", "sun"]);
    let LightKind::Point { position, intensity } = scene.lights[0].kind else { panic!() };
    assert_eq!((position, intensity), (Vec3::new(0., 2., 0.), Rgb::new(80., 40., 20.)));
    let LightKind::Spot { direction, intensity, beam: Beam::Cone { cos_inner, cos_outer }, .. } =
        scene.lights[1].kind
    else {
        panic!()
    };
    assert!((direction - Vec3::NEG_X).length() < 1e-6 && intensity == Rgb::grey(10.0));
    assert!((cos_inner - 0.980_066_6).abs() < 1e-6 && (cos_outer - 0.877_582_6).abs() < 1e-6);
    let LightKind::Directional { direction, illuminance } = scene.lights[2].kind else { panic!() };
    assert_eq!((direction, illuminance), (Vec3::NEG_Z, Rgb::WHITE));
}

#[test]
fn hidden_nodes_and_other_scenes_are_not_shown() {
    let mut glb = Glb::new();
    glb.square(json!({}));
    glb.json["nodes"] = json!([{"mesh": 0, "name": "a"}, {"children": [2], "extensions": {"KHR_node_visibility":
        {"visible": false}}}, {"mesh": 0, "name": "hidden"}, {"mesh": 0, "name": "elsewhere"}]);
    glb.json["scenes"] = json!([{"nodes": [3]}, {"nodes": [0, 1]}]);
    glb.json["scene"] = json!(1);
    let names = |glb: &Glb| glb.clean().instances.iter().map(|i| i.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&glb), ["a"]);
    glb.json["scene"] = json!(0);
    assert_eq!(names(&glb), ["elsewhere"]);
}

#[test]
fn buffers_lie_in_data_uris_and_files_beside() {
    let mut glb = Glb::new();
    glb.square(json!({}));
    let want = glb.clean().meshes[0].positions.clone();
    let folder = Folder::new();
    folder.write("my data/büffer.bin", &glb.binary);
    for uri in ["my%20data/b%C3%BCffer.bin", "my data/büffer.bin", "./my%20data/../my%20data/b%c3%bcffer.bin"]
    {
        glb.json["buffers"] = json!([{"byteLength": glb.binary.len(), "uri": uri}]);
        folder.write("main.gltf", glb.json.to_string());
        assert_eq!(folder.load("main.gltf").unwrap().scene.meshes[0].positions, want);
    }
    let hex: String = glb.binary.iter().map(|b| format!("%{b:02x}")).collect();
    glb.json["buffers"] =
        json!([{"byteLength": glb.binary.len(), "uri": format!("data:application/octet-stream,{hex}")}]);
    assert_eq!(glb.clean().meshes[0].positions, want);
}

#[test]
fn what_is_not_read_is_told() {
    let told = |edit: &dyn Fn(&mut Glb)| {
        let mut glb = Glb::new();
        glb.square(json!({}));
        edit(&mut glb);
        glb.load().unwrap().warnings.join("\n")
    };
    assert!(
        told(&|g| g.json["extensionsUsed"] = json!(["KHR_materials_sheen"]))
            .contains("\"KHR_materials_sheen\"")
    );
    assert!(told(&|g| g.json["animations"] = json!([{}])).contains("animations"));
    assert!(told(&|g| g.json["nodes"][0]["skin"] = json!(0)).contains("skins"));
    assert!(told(&|g| g.json["nodes"][0]["scale"] = json!([1, 0, 1])).contains("flattens"));
    assert!(told(&|g| g.json["nodes"][0]["scale"] = json!([1, 1e30, 1])).contains("beyond 1e18"));
    assert!(told(&|g| g.json["nodes"][0]["rotation"] = json!([0, 0, 0, 0])).contains("quaternion"));
    assert!(told(&|g| g.json["meshes"][0]["primitives"][0]["mode"] = json!(1)).contains("lines"));
    assert!(told(&|g| g.json["meshes"][0]["primitives"][0]["targets"] = json!([{}])).contains("morph"));
    assert!(told(&|g| g.json["accessors"][1]["count"] = json!(5)).contains("no whole triangle"));
    assert!(told(&|g| g.binary[0..4].copy_from_slice(&f32::NAN.to_le_bytes())).contains("not finite"));
}

#[test]
fn what_cannot_be_right_is_refused() {
    let bad = |edit: &dyn Fn(&mut Glb)| {
        let mut glb = Glb::new();
        glb.square(json!({}));
        edit(&mut glb);
        glb.bad()
    };
    for name in ["KHR_draco_mesh_compression", "KHR_texture_basisu", "VENDOR_odd"] {
        let (place, reason) = bad(&|g| g.json["extensionsRequired"] = json!([name]));
        assert!(place == "extensionsRequired" && reason.contains(name), "{reason}");
    }
    for version in ["1.0", "3.0", "99.0", "two", ""] {
        assert!(bad(&|g| g.json["asset"]["version"] = json!(version)).1.contains("version"));
    }
    assert!(bad(&|g| g.json["asset"]["minVersion"] = json!("2.1")).1.contains("version"));
    assert!(bad(&|g| g.json["accessors"][1]["componentType"] = json!(5126)).1.contains("indices"));
    assert!(bad(&|g| g.json["accessors"][0]["type"] = json!("VEC2")).1.contains("type"));
    assert!(bad(&|g| g.json["accessors"][0]["count"] = json!(3)).1.contains("index 3 reaches beyond 3"));
    assert!(bad(&|g| g.json["accessors"][0]["count"] = json!(5)).1.contains("need 60 bytes of a view of 48"));
    assert!(bad(&|g| g.json["accessors"][0]["byteOffset"] = json!(1)).1.contains("need 49 bytes"));
    assert!(bad(&|g| g.json["bufferViews"][0]["byteStride"] = json!(8)).1.contains("byteStride"));
    assert!(bad(&|g| g.json["bufferViews"][1]["byteLength"] = json!(1000)).1.contains("beyond buffer 0"));
    let twice = |g: &mut Glb| {
        g.json["scenes"] = json!([{"nodes": [0]}]);
        g.json["nodes"][0]["children"] = json!([0]);
    };
    assert!(bad(&twice).1.contains("twice"));
    assert!(bad(&|g| g.json["nodes"][0]["children"] = json!([9])).1.contains("no such node"));
    for (what, at) in [("mesh", "/nodes/0/mesh"), ("material", "/meshes/0/primitives/0/material")] {
        assert!(bad(&|g| *g.json.pointer_mut(at).unwrap() = json!(7)).1.contains(&format!("no {what} 7")));
    }
}
