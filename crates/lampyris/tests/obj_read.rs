//! What OBJ and MTL mean: corners, polygons, objects, materials, on files of a few lines.

mod gltf_support;

use glam::{Vec2, Vec3};
use gltf_support::{Folder, assert_sound};
use lampyris::import::Loaded;
use lampyris::material::{Bsdf, Coverage, Dielectric, Sides};
use lampyris::scene::Scene;
use lampyris::{Error, Rgb};

fn loaded(obj: &str, mtl: &str) -> Loaded {
    let folder = Folder::new();
    folder.write("lib.mtl", mtl);
    folder.write("main.obj", obj);
    let loaded = folder.load("main.obj").unwrap();
    assert_sound(&loaded.scene);
    loaded
}

fn clean(obj: &str, mtl: &str) -> Scene {
    let loaded = loaded(obj, mtl);
    assert_eq!(loaded.warnings, Vec::<String>::new());
    loaded.scene
}

fn bad(obj: &str) -> (String, String) {
    let folder = Folder::new();
    folder.write("main.obj", obj);
    match folder.load("main.obj") {
        Err(Error::BadInput { place, reason, .. }) => (place, reason),
        other => panic!("{obj:?}: {other:?}"),
    }
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn area(scene: &Scene) -> Vec3 {
    let mesh = &scene.meshes[0];
    let half = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
        0.5 * (b - a).cross(c - a)
    };
    mesh.triangles.iter().map(half).sum()
}

#[test]
fn corners_count_from_one_or_from_the_end() {
    let want = [Vec3::ZERO, Vec3::X, Vec3::new(1., 1., 0.), Vec3::Y];
    for face in ["f 1 2 3 4", "f -4 -3 -2 -1", "f 1// 2// 3// 4//", "f 1 2 \\\n3 4", "f\t1 2   3 4 \r"] {
        let scene = clean(&format!("# a\n{SQUARE}{face}\n"), "");
        assert_eq!(scene.meshes[0].positions, want, "{face}");
        assert_eq!(scene.meshes[0].triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!((scene.up, scene.instances[0].name.as_str()), (Some(Vec3::Y), "main"));
    }
    for (face, why) in [
        ("f 1 2 5", "index 5 of 4"),
        ("f 0 1 2", "index 0 of 4"),
        ("f -5 1 2", "index -5 of 4"),
        ("f 1 2 x", "no index"),
        ("f 1/1 2 3", "index 1 of 0"),
        ("f 1/// 2 3", "three indices"),
    ] {
        let (place, reason) = bad(&format!("{SQUARE}{face}\n"));
        assert!(place == "line 5" && reason.contains(why), "{face}: {place}: {reason}");
    }
    assert!(bad("v 1 2\n").1.contains("three numbers"));
}

#[test]
fn vertices_are_what_corners_say_together() {
    let file = format!("{SQUARE}vt 0 0\nvt 0.25 1\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\nf 1/2/1 3/1/1 4\n");
    let scene = clean(&file, "");
    let mesh = &scene.meshes[0];
    // The first corner of the second face differs in its coordinates alone, the third vertex is shared.
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 2, 4]]);
    assert_eq!(mesh.positions[0], mesh.positions[3]);
    assert_eq!(mesh.uvs[0], [Vec2::Y, Vec2::new(0.25, 0.), Vec2::Y, Vec2::new(0.25, 0.), Vec2::ZERO]);
    assert_eq!(mesh.normals, [Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Z, Vec3::ZERO]);
}

#[test]
fn polygons_of_any_shape_keep_area_and_sense() {
    // An L, a quadrilateral with a dent at either place, and a regular polygon of 64 corners.
    assert_eq!(
        area(&clean("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", "")),
        Vec3::Z * 3.0
    );
    for turn in 0..4 {
        let order: Vec<String> = (0..4).map(|k| ((k + turn) % 4 + 1).to_string()).collect();
        let file = format!("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf {}\n", order.join(" "));
        let scene = clean(&file, "");
        assert_eq!((area(&scene), scene.meshes[0].triangles.len()), (Vec3::Z * 4.0, 2), "{turn}");
    }
    let crossed = loaded("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 .5 0\nf 1 2 3 4 5\n", "");
    assert_eq!(crossed.scene.meshes[0].triangles.len(), 3);
}

#[test]
fn objects_and_groups_are_instances() {
    let scene =
        clean(&format!("{SQUARE}o room\nf 1 2 3\ng wall one\nf 1 3 4\no empty\no lamp\nf 1 2 4\n"), "");
    let names: Vec<&str> = scene.instances.iter().map(|i| i.name.as_str()).collect();
    assert_eq!(names, ["room", "room/wall one", "lamp"]);
    assert_eq!(scene.meshes.iter().map(|m| m.triangles.len()).collect::<Vec<_>>(), [1, 1, 1]);
}

#[test]
fn materials_of_a_library_are_worn() {
    let mtl = "newmtl red wall\nKd 1 0 0\nillum 1\nKs 1 1 1\nnewmtl lamp\nKd 0 0 0\nKe 17 12 4\nnewmtl mirror\n\
        illum 3\nKd 0 0 0\nKs .9 .9 .9\nnewmtl glass\nillum 7\nNi 1.6\nTf 1 .25 1\nnewmtl veil\nd 0.5\n\
        newmtl metal\nPr 0.25\nPm 1\nKd .5\nnewmtl half\nTr 0.25\nKa 1 1 1\n";
    let faces = "usemtl lamp\nf 1 2 3\nusemtl red wall\nf 1 3 4\n";
    let scene = clean(&format!("mtllib lib.mtl\n{SQUARE}{faces}"), mtl);
    let [wall, lamp, mirror, glass, veil, metal, half] = &scene.materials[..] else { panic!() };
    assert_eq!((wall.name.as_str(), scene.meshes[0].materials.clone()), ("red wall", vec![1, 0]));
    assert!(matches!(&wall.bsdf, Bsdf::Diffuse(d) if d.reflectance == Rgb::new(1., 0., 0.)));
    assert_eq!((lamp.emission, lamp.sides), (Rgb::new(17., 12., 4.), Sides::EmitFront));
    assert!(matches!(&mirror.bsdf, Bsdf::Ward(w) if w.specular == Rgb::grey(0.9) && w.alpha == 0.0));
    assert_eq!(glass.bsdf, Bsdf::Dielectric(Dielectric::new(1.6, Rgb::new(1.0, 0.5, 1.0))));
    assert_eq!(
        (veil.coverage, half.coverage),
        (Coverage::Blend { factor: 0.5 }, Coverage::Blend { factor: 0.75 })
    );
    assert!(
        matches!(&metal.bsdf, Bsdf::Pbr(p) if p.roughness == 0.25 && p.metallic == 1.0 && p.base_color == Rgb::grey(0.5))
    );
}

#[test]
fn what_is_odd_is_told() {
    let told =
        |obj: &str, mtl: &str| loaded(&format!("mtllib lib.mtl\n{SQUARE}{obj}\nf 1 2 3\n"), mtl).warnings;
    for (obj, what) in [
        ("usemtl none", "\"none\" is not defined"),
        ("l 1 2", "points and lines"),
        ("curv 0 1 2", "\"curv\" is not read"),
        ("f 1 2", "fewer than three"),
        ("mtllib gone.mtl", "library is missing"),
        ("mtllib ../up.mtl", "outside the scene's root"),
        ("v 0 0 nan\nf 1 2 -1", "not finite"),
        ("v 0 0 0 1 1 1", "colours at vertices"),
    ] {
        let warnings = told(obj, "");
        assert!(warnings.len() == 1 && warnings[0].contains(what), "{obj}: {warnings:?}");
    }
    for (mtl, what) in [
        ("Kd 1 1 1", "before the first newmtl"),
        ("newmtl a\nKd spectral x.rfl", "\"Kd\" without its numbers"),
        ("newmtl a\nKd nan", "\"Kd\" without its numbers"),
        ("newmtl a\naniso 1", "\"aniso\" is not read"),
        ("newmtl a\nnewmtl a", "defined twice"),
        ("newmtl a\nmap_Kd gone.png", "gone.png"),
        ("newmtl a\nKd 1 1 1\nKs 1 1 1\nillum 2", "sum to more than 1"),
    ] {
        let warnings = told("", mtl);
        assert!(warnings.len() == 1 && warnings[0].contains(what), "{mtl}: {warnings:?}");
    }
}
