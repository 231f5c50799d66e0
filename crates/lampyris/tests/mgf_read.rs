//! What MGF means: contexts, transforms, arrays, includes, shapes and colours, on scenes of a few lines.

mod mgf_support;

use glam::{Vec2, Vec3};
use lampyris::Rgb;
use lampyris::import::{Options, load};
use lampyris::material::{Bsdf, Sides};
use lampyris::scene::Scene;
use mgf_support::{Folder, bad, clean, load_text, load_with};

const SQUARE: &str = "v a =\np 0 0 0\nv b =\np 1 0 0\nv c =\np 1 1 0\nv d =\np 0 1 0\n";

/// The middle of each triangle, in the order of the file.
fn middles(scene: &Scene) -> Vec<Vec3> {
    let mesh = |i: usize| &scene.meshes[scene.instances[i].mesh as usize];
    (0..scene.instances.len())
        .flat_map(|i| {
            mesh(i)
                .triangles
                .iter()
                .map(move |t| t.map(|k| mesh(i).positions[k as usize]).iter().sum::<Vec3>() / 3.0)
        })
        .collect()
}

/// The front's direction of each triangle.
fn fronts(scene: &Scene) -> Vec<Vec3> {
    let front = |mesh: &lampyris::scene::Mesh, t: &[u32; 3]| {
        let [a, b, c] = t.map(|k| mesh.positions[k as usize]);
        (b - a).cross(c - a).normalize()
    };
    scene.meshes.iter().flat_map(|m| m.triangles.iter().map(move |t| front(m, t))).collect()
}

fn reflectances(scene: &Scene) -> Vec<Rgb> {
    let rho = |m: u32| match &scene.materials[m as usize].bsdf {
        Bsdf::Diffuse(d) => d.reflectance,
        other => panic!("{other:?}"),
    };
    scene.meshes.iter().flat_map(|m| m.materials.iter().map(|&m| rho(m))).collect()
}

/// Chromaticity under equal-energy white of what a colour makes of `ed 1`, by undoing `Rgb::from_xy_e`.
fn chromaticity(text: &str) -> Vec2 {
    let scene = clean(&format!("{SQUARE}{text}\nm lamp =\ned 1\nf a b c\n"));
    let have = scene.materials[0].emission;
    let error = |x: f64, y: f64| {
        let c = Rgb::from_xy_e(x, y, f64::from(have.luminance())) - have;
        f64::from(c.r * c.r + c.g * c.g + c.b * c.b)
    };
    // Coordinate descent with halved steps: the map is smooth and has one minimum.
    let (mut x, mut y, mut step) = (1.0 / 3.0, 1.0 / 3.0, 0.1);
    while step > 1e-6 {
        let moves = [(x, y), (x + step, y), (x - step, y), (x, y + step), (x, y - step)];
        let best = moves
            .into_iter()
            .filter(|m| m.1 > 0.01)
            .min_by(|a, b| error(a.0, a.1).total_cmp(&error(b.0, b.1)));
        let best = best.unwrap();
        if best == (x, y) { step *= 0.5 } else { (x, y) = best }
    }
    Vec2::new(x as f32, y as f32)
}

#[test]
fn values_are_taken_by_copy_when_used() {
    let scene = clean(&format!(
        "{SQUARE}c red =\ncxy .4 .33\nm paint =\nrd .5\nc red\ncxy .3333333333 .3333333333\nf a b c\nm paint\nrd .1\nf a c d\nv a\np 0 0 9\n"
    ));
    // The colour's edit came after `rd`, the material's after the first face, the vertex' after both.
    let rho = reflectances(&scene);
    assert!((rho[0].luminance() - 0.5).abs() < 1e-6 && rho[0].r > 1.2 * rho[0].g);
    assert!((rho[1].g - 0.1).abs() < 1e-6 && (rho[1].r - 0.1).abs() < 1e-6);
    assert!(middles(&scene).iter().all(|m| m.z == 0.0));
    assert_eq!(scene.materials.iter().filter(|m| m.name == "paint").count(), 2);
}

#[test]
fn equal_materials_of_one_name_are_one() {
    let scene = clean(&format!(
        "{SQUARE}m p =\nrd .5\nf a b c\nm q = p\nf a b c\nm p =\nrd .5\nf a b c\nm unused = p\n"
    ));
    let names: Vec<_> = scene.materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["p", "q", "unused"], "unused ones come last");
    assert_eq!(scene.meshes[0].materials, [0, 1, 0]);
}

#[test]
fn the_unnamed_material_is_a_black_absorber_of_two_sides() {
    let scene = clean(&format!("{SQUARE}rd .5\nm\nf a b c\n"));
    assert_eq!(reflectances(&scene), [Rgb::BLACK]);
    assert_eq!((scene.materials[0].name.as_str(), scene.materials[0].sides), ("(unnamed)", Sides::Both));
    let one = clean(&format!("{SQUARE}m one =\nsides 1\nf a b c\n"));
    assert_eq!(one.materials[0].sides, Sides::FrontOnly);
}

#[test]
fn a_ring_turned_over() {
    let scene = clean("v o =\np 0 10 0\nn 0 0 1\nxf -t 5 0 0\nxf -rx 180\nring o 0 2\nxf\nxf\n");
    let [low, high] = scene.summary().bounds.unwrap();
    assert!(((low + high) / 2.0 - Vec3::new(5.0, -10.0, 0.0)).length() < 1e-5, "{low} {high}");
    assert!(fronts(&scene).iter().all(|n| (*n - Vec3::NEG_Z).length() < 1e-5));
}

#[test]
fn an_array_of_three_dimensions() {
    let scene = clean(&format!(
        "{SQUARE}xf -a 3 -t 1 0 0 -a 4 -t 0 1 0 -a 5 -t 0 0 1 -i 1 -t 15 30 45\nf a b c\nxf\n"
    ));
    let mut have: Vec<_> = middles(&scene).iter().map(|m| m.floor().to_array().map(|v| v as i32)).collect();
    have.sort();
    let mut want = Vec::new();
    for x in 15..=17 {
        for y in 30..=33 {
            want.extend((45..=49).map(|z| [x, y, z]));
        }
    }
    assert_eq!(have, want);
}

#[test]
fn nested_transforms_act_from_the_inside() {
    let scene = clean(&format!("{SQUARE}xf -t 10 0 0\nxf -rz 90\nf a b c\nxf\nf a b c\nxf\nf a b c\n"));
    let m = middles(&scene);
    let third = 1.0 / 3.0;
    for (have, want) in
        m.iter().zip([(10.0 - third, 2.0 * third), (10.0 + 2.0 * third, third), (2.0 * third, third)])
    {
        assert!((have.truncate() - Vec2::new(want.0, want.1)).length() < 1e-5, "{m:?}");
    }
}

#[test]
fn an_array_executes_its_block_anew() {
    // The template doubles as a counter: each instance starts from what the last one left.
    let scene = clean(&format!("{SQUARE}m p =\nrd .8\nm q =\nrd .1\nxf -a 3 -t 0 0 1\nf a b c\nm p\nxf\n"));
    let rho: Vec<_> = reflectances(&scene).iter().map(|c| (c.g * 10.0).round()).collect();
    assert_eq!(rho, [1.0, 8.0, 8.0]);
    assert_eq!(middles(&scene).iter().map(|m| m.z).collect::<Vec<_>>(), [0.0, 1.0, 2.0]);
}

#[test]
fn mirrors_keep_fronts_in_front() {
    let solid = format!("{SQUARE}v e =\np .5 .5 .5\nn 0 0 1\nprism a b c d 2\nsph e .5\ntorus e .1 .4\n");
    let volume = |scene: &Scene| -> f32 {
        scene
            .meshes
            .iter()
            .flat_map(|m| m.triangles.iter().map(move |t| t.map(|k| m.positions[k as usize])))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum()
    };
    let plain = volume(&clean(&solid));
    assert!(plain > 2.4, "outward: {plain}");
    for (xf, factor) in
        [("-mx", 1.0), ("-mx -my", 1.0), ("-mx -my -mz", 1.0), ("-s -2", 8.0), ("-sx -1 -sy 3", 3.0)]
    {
        let placed = clean(&format!("xf {xf} -rx 30 -t 1 2 3\n{solid}xf\n"));
        assert!((volume(&placed) / plain / factor - 1.0).abs() < 1e-4, "{xf}: {}", volume(&placed) / plain);
        for mesh in &placed.meshes {
            for t in &mesh.triangles {
                let [a, b, c] = t.map(|k| mesh.positions[k as usize]);
                for k in *t {
                    // Shading normals, where there are any, stay on the front.
                    assert!(mesh.normals[k as usize].dot((b - a).cross(c - a)) >= 0.0);
                }
            }
        }
    }
}

#[test]
fn shading_normals_follow_the_transform() {
    let scene =
        clean("v a =\np 0 0 0\nn 1 0 1\nv b =\np 1 0 0\nv c =\np 0 1 0\nn 0 0 9\nxf -ry 90\nf a b c\nxf\n");
    let n = &scene.meshes[0].normals;
    let half = 0.5f32.sqrt();
    assert!((n[0] - Vec3::new(half, 0.0, -half)).length() < 1e-6, "{}", n[0]);
    assert_eq!(n[1], Vec3::ZERO, "no normal given: the triangle's own");
    assert!((n[2] - Vec3::X).length() < 1e-6);
    assert!(clean(&format!("{SQUARE}f a b c\n")).meshes[0].normals.is_empty());
}

#[test]
fn shapes_have_their_number_of_triangles() {
    let vertices = "v o =\np 0 0 0\nn 0 0 1\nv u =\np 0 0 2\nv a =\np 4 0 0\nv b =\np 0 4 0\nv h =\np 1 1 0\nv i =\np 2 1 0\nv j =\np 1 2 0\n";
    for (shape, count) in [
        ("sph o 1", 360),
        ("sph o -1", 360),
        ("cyl o 1 u", 40),
        ("cone o 1 u 0", 20),
        ("cone o 0 u -1", 20),
        ("cone o 1 u 2", 40),
        ("prism o a b 1", 8),
        ("ring o 0 1", 20),
        ("ring o .5 1", 40),
        ("torus o .5 1", 800),
        ("torus o -.5 -1", 800),
        ("f o a b", 1),
        ("fh o a b - h i j", 6),
        ("fh o a b - h j i", 6),
    ] {
        assert_eq!(clean(&format!("{vertices}{shape}\n")).summary().triangles, count, "{shape}");
    }
    let coarse = Options { circle_steps: 4, ..Options::default() };
    assert_eq!(load_with(format!("{vertices}sph o 1\n"), &coarse).unwrap().scene.summary().triangles, 8);
    for steps in [0, 3, 6, 4100] {
        let options = Options { circle_steps: steps, ..Options::default() };
        assert!(load_with("", &options).is_err(), "{steps}");
    }
}

#[test]
fn a_bulb_of_1600_lumens() {
    let bulb = "v o =\nm glow =\nsides 1\ned 87712\nsph o .0381\n";
    let fine = Options { circle_steps: 400, ..Options::default() };
    let power = load_with(bulb, &fine).unwrap().scene.summary().power_lm;
    assert!((power - 1600.0).abs() < 0.5, "{power}");
}

#[test]
fn objects_are_instances_named_by_their_path() {
    let scene = clean(&format!(
        "{SQUARE}f a b c\no room\nf a b c\no lamp\nf a b c\no\no empty\no\nf a b c\no\nf a b c\nxf -a 2 -t 1 0 0\no box\nf a b c\no\nxf\n"
    ));
    let have: Vec<_> = scene
        .instances
        .iter()
        .map(|i| (i.name.as_str(), scene.meshes[i.mesh as usize].triangles.len()))
        .collect();
    assert_eq!(have, [("main", 2), ("room", 2), ("room/lamp", 1), ("box", 1), ("box", 1)]);
}

#[test]
fn includes_share_names_and_are_relative_to_their_file() {
    let folder = Folder::new();
    folder.write("lib/shapes/square.mgf", format!("{SQUARE}f a b c\n"));
    folder.write("lib/all.mgf", "i shapes/square.mgf -a 2 -t 2 0 0\ni ../top.mgf\n");
    folder.write("top.mgf", "f a c d\n");
    folder.write("main.mgf", "xf -t 0 0 7\ni lib/all.mgf\nxf\nf a b c\n");
    let loaded = folder.load("main.mgf").unwrap();
    assert_eq!(loaded.warnings, Vec::<String>::new());
    let m = middles(&loaded.scene);
    let places: Vec<_> = m.iter().map(|m| (m.x.floor(), m.z)).collect();
    assert_eq!(places, [(0.0, 7.0), (2.0, 7.0), (0.0, 7.0), (0.0, 0.0)]);
}

#[test]
fn colours_have_their_chromaticities() {
    for (text, x, y) in [
        ("c k =\ncct 2856", 0.4476, 0.4075),
        ("c k =\ncct 3000", 0.4370, 0.4041),
        ("c k =\ncct 6500", 0.3135, 0.3237),
        (
            "c r =\ncxy .64 .33\nc g =\ncxy .29 .6\nc b =\ncxy .15 .06\nc k =\ncmix .265 r .67 g .065 b",
            0.3331,
            0.3330,
        ),
        ("c k =\ncspec 380 780 5 5", 0.3333, 0.3333),
        ("c k =\ncxy .5 .4", 0.5, 0.4),
    ] {
        let have = chromaticity(text);
        assert!((have - Vec2::new(x, y)).abs().max_element() < 0.001, "{text}: {have}");
    }
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn measured_chips_have_the_reference_chromaticities() {
    // The reference implementation averages each sample of a spectrum finer than 10 nm with the one before, which
    // shifts it by 2.5 nm. These are therefore shifted likewise; unshifted they differ by up to 0.01.
    let spectra = std::fs::read_to_string(mgf_support::scenes().join("Materials/macbeth.mgf")).unwrap();
    let shifted = spectra.replace("cspec 380 775", "cspec 382.5 777.5");
    for (chip, x, y) in [
        ("DarkSkin", 0.4620, 0.3769),
        ("LightSkin", 0.4108, 0.3542),
        ("BlueSky", 0.2626, 0.2670),
        ("Foliage", 0.3600, 0.4689),
        ("Orange", 0.5200, 0.4197),
        ("Blue", 0.2026, 0.1369),
        ("Green", 0.3007, 0.4822),
        ("Red", 0.5805, 0.3238),
    ] {
        let have = chromaticity(&format!("{shifted}\nc {chip}"));
        assert!((have - Vec2::new(x, y)).abs().max_element() < 0.001, "{chip}: {have} against {x}, {y}");
    }
}

#[test]
fn odd_lines_are_told_and_left_out() {
    let text = format!(
        "{SQUARE}wall x\n0\nwall\n#comment\n# m nothing\nies lamp.ies -m 2\nf a b a\nf a b c\nxf -t 1 0 0\no open\n"
    );
    let loaded = load_text(text).unwrap();
    let told: Vec<_> = loaded.warnings.iter().map(|w| w.rsplit('/').next().unwrap()).collect();
    assert_eq!(
        told,
        [
            "main.mgf:9: unknown entity \"wall\" is left out (2 times)",
            "main.mgf:10: unknown entity \"0\" is left out",
            "main.mgf:14: \"ies\" light distributions are not read yet; the luminaire is left out",
            "main.mgf:15: \"f\" without area is left out",
            "main.mgf:18: a transform is not ended by \"xf\" before the end of its file",
            "main.mgf:18: an object is not ended by \"o\" before the end of its file",
        ]
    );
    assert_eq!(loaded.scene.summary().triangles, 1);
}

#[test]
fn broken_lines_are_errors_with_their_place() {
    let cases = [
        "p 1 2",
        "p 1 2 3 4",
        "p 1 2 x",
        "p 1 2 nan",
        "p 1 2 inf",
        "n 1",
        "cxy .5",
        "cxy -.1 .5",
        "cxy .6 .5",
        "cct 0",
        "cct -1",
        "cct",
        "cspec 380 780",
        "cspec 380 780 1",
        "cspec 780 380 1 1",
        "cmix 1 w",
        "cmix 1 w 1",
        "cmix 1 w 1 x",
        "cmix 0 w 0 w",
        "sides 3",
        "sides",
        "rd 1.1",
        "rd -.1",
        "rd",
        "rd .1 .2",
        "ed -1",
        "rs .5",
        "rs .5 -1",
        "ts 2 0",
        "ir 0 0",
        "ir 1.5",
        "c x",
        "m x",
        "v x",
        "v x = y",
        "v x y",
        "f a b",
        "f a b x",
        "fh a b c - a b",
        "fh a b c -",
        "sph a 0",
        "sph a",
        "sph x 1",
        "cyl a 0 b",
        "cyl a 1 a",
        "cyl a 1",
        "cone a 1 b -1",
        "cone a 0 b 0",
        "prism a b c",
        "prism a b c 0",
        "prism a b 1",
        "prism",
        "ring a 0 1",
        "ring n 1 1",
        "ring n -1 1",
        "ring n 2 1",
        "torus n -2 -1",
        "torus n -1 1",
        "torus n 1",
        "xf",
        "o",
        "o a b",
        "xf -t 1",
        "xf -q",
        "i",
        "i nothing.mgf",
        "xf -s 1e200 -s 1e200",
        "sph a 1e30",
    ];
    for case in cases {
        let (place, reason) = bad(&format!("{SQUARE}v n =\nn 0 0 1\nc w =\n{case}\n"));
        assert_eq!(place, "line 12", "{case}: {reason}");
        assert!(reason.chars().count() < 200, "{case}: {reason}");
    }
}

#[test]
fn errors_name_the_included_file() {
    let folder = Folder::new();
    folder.write("sub/part.mgf", "\n\nrd 5\n");
    folder.write("main.mgf", "i sub/part.mgf\n");
    let text = folder.load("main.mgf").unwrap_err().to_string();
    assert!(text.contains("sub/part.mgf:line 3: "), "{text}");
}

#[test]
fn contexts_do_not_end_in_another_file() {
    let folder = Folder::new();
    for end in ["xf", "o"] {
        folder.write("end.mgf", format!("{end}\n"));
        folder.write("main.mgf", "xf -t 1 0 0\no name\ni end.mgf\no\nxf\n");
        assert!(folder.load("main.mgf").unwrap_err().to_string().contains("end.mgf:line 1"));
    }
}

#[test]
fn extensions_are_looked_up_in_any_case() {
    let folder = Folder::new();
    assert!(load(&folder.write("A.MGF", ""), &Options::default()).is_ok());
    assert!(load(&folder.write("a.xyz", ""), &Options::default()).unwrap_err().to_string().contains("mgf"));
}
