//! The rooms that ship, after the four kinds of [Wald et al. 2002, §5.1]: what their files promise of counts and lumens, that their
//! glass encloses what it should and is smooth, and that the first view each file names shows no hole.

mod support;

use glam::{DVec3, Vec3};
use lampyris::import::{Options, load};
use lampyris::light::Bounds;
use lampyris::scene::{Camera, Scene, View};
use lampyris::world::World;
use lampyris::{Rgb, eye::Eye};
use std::collections::HashMap;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use support::{FAST, close, render, settings};

/// Area of a circle of 20 steps and of a sphere of 20 by 10, over that of the round shape: Σ over its bands.
const DISC: f64 = 0.983_631_6;
const SPHERE: f64 = 0.979_570_8;

struct Room {
    file: &'static str,
    triangles: u64,
    /// Names of the luminaires, how many of each, and the lumens of one.
    lamps: &'static [(&'static str, usize, f64)],
    /// Bodies of glass: name, how many, and the volume of each where it has a formula [m³].
    glass: &'static [(&'static str, Option<f64>)],
}

/// ∫ π r² dz of the egg, r = w sin t (1 + k cos t) and z = h (1 − cos t)/2: π w² h/2 (4/3 + 4 k²/15).
const EGG: f64 = PI * 0.172 * 0.172 * 0.25 * (4.0 / 3.0 + 4.0 * 0.17 * 0.17 / 15.0);

const ROOMS: &[Room] = &[
    Room {
        file: "table.mgf",
        triangles: 36_183,
        lamps: &[("lamp_table", 1, 2400.0), ("lamp_floor", 1, 900.0 * SPHERE)],
        glass: &[("ball", Some(4.0 / 3.0 * PI * 0.12 * 0.12 * 0.12))],
    },
    Room {
        file: "egg.mgf",
        triangles: 12_128,
        lamps: &[("lamp_warm", 1, 2000.0 * DISC), ("lamp_cool", 1, 2000.0 * DISC)],
        glass: &[("egg", Some(EGG))],
    },
    Room {
        file: "foyer.mgf",
        triangles: 49_844,
        lamps: &[("lamp_west", 1, 5000.0 * DISC), ("lamp_east", 1, 5000.0 * DISC)],
        glass: &[("ball", Some(4.0 / 3.0 * PI * 0.13 * 0.13 * 0.13))],
    },
    // The paper's has 290 000 triangles and 104 lamps.
    Room {
        file: "conference.mgf",
        triangles: 322_559,
        lamps: &[
            ("bank_1/lamp", 13, 700.0),
            ("bank_2/lamp", 13, 700.0),
            ("bank_3/lamp", 13, 700.0),
            ("bank_4/lamp", 13, 700.0),
            ("bank_5/lamp", 13, 700.0),
            ("bank_6/lamp", 13, 700.0),
            ("bank_7/lamp", 13, 700.0),
            ("bank_8/lamp", 13, 700.0),
        ],
        glass: &[("tumblers", None), ("carafes", None)],
    },
];

impl Room {
    fn path(&self) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(self.file)
    }

    /// The scene; its file must give no warning.
    fn scene(&self) -> Scene {
        let loaded = load(&self.path(), &Options::default()).expect(self.file);
        assert_eq!(loaded.warnings, Vec::<String>::new(), "{}", self.file);
        loaded.scene
    }

    /// The first line `# view:` of the file.
    fn camera(&self) -> Camera {
        let text = std::fs::read_to_string(self.path()).expect(self.file);
        let line = text.lines().find_map(|l| l.strip_prefix("# view: ")).expect("a view");
        let words: Vec<&str> = line.split_whitespace().collect();
        let at = |key: &str| words.iter().position(|w| *w == key).expect("all that a view needs") + 1;
        let number = |k: usize| words[k].parse::<f32>().expect("a number");
        let vector = |key| Vec3::from_array([0, 1, 2].map(|k| number(at(key) + k)));
        Camera {
            name: "first".into(),
            eye: vector("eye"),
            target: vector("target"),
            up: vector("up"),
            fov_y: number(at("vfov")),
        }
    }
}

/// Exact counts; every luminaire is an emitter of its own, under its name, with the lumens that the file states.
#[test]
fn rooms_have_the_lamps_they_name() {
    for room in ROOMS {
        let scene = room.scene();
        assert_eq!(scene.summary().triangles, room.triangles, "{}", room.file);
        let glows = |name: &str| scene.instances.iter().filter(|i| i.name == name).count();
        for (name, count, _) in room.lamps {
            assert_eq!(glows(name), *count, "{}: {name}", room.file);
        }
        let lumens: f64 = room.lamps.iter().map(|(_, count, each)| *count as f64 * each).sum();
        close(room.file, scene.summary().power_lm, lumens, 1e-4);
        let mut want: Vec<f64> =
            room.lamps.iter().flat_map(|(_, n, each)| std::iter::repeat_n(*each, *n)).collect();
        let world = World::new(scene);
        let power = |e: &lampyris::light::Emitter| f64::from(e.power(Bounds::default()).luminance());
        let mut have: Vec<f64> = world.emitters().iter().map(power).collect();
        want.sort_by(f64::total_cmp);
        have.sort_by(f64::total_cmp);
        assert_eq!(have.len(), want.len(), "{}", room.file);
        for (have, want) in have.into_iter().zip(want) {
            close(room.file, have, want, 1e-4);
        }
    }
}

/// Glass is closed and faces outward: its area vectors sum to nothing, and it encloses the volume of the shape it is
/// inscribed in, up to its facets (2 %). It is smooth: a shading normal is at most a facet's turn off the facet's own,
/// and facets that meet share it.
#[test]
fn glass_is_closed_and_smooth() {
    for room in ROOMS {
        let scene = room.scene();
        for (name, volume) in room.glass {
            let place = scene.instances.iter().find(|i| i.name == *name).expect(name);
            let mesh = &scene.meshes[place.mesh as usize];
            let at = |k: u32| mesh.positions[k as usize].as_dvec3();
            // Counted from a point of its own, so that little is lost to the distance from the origin.
            let origin = at(0);
            let (mut vector, mut area, mut enclosed) = (DVec3::ZERO, 0.0, 0.0);
            let mut shared: HashMap<[i64; 3], Vec<Vec3>> = HashMap::new();
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|k| at(k) - origin);
                let cross = (b - a).cross(c - a) * 0.5;
                (vector, area, enclosed) =
                    (vector + cross, area + cross.length(), enclosed + a.dot(cross) / 3.0);
                for &k in triangle {
                    let normal = mesh.normals[k as usize];
                    let cos = normal.as_dvec3().dot(cross.normalize());
                    assert!(cos > 0.85, "{}: {name} is bent {cos} at {}", room.file, at(k));
                    let key = (at(k) * 1e5).to_array().map(|x| x.round() as i64);
                    shared.entry(key).or_default().push(normal);
                }
            }
            assert!(vector.length() < 1e-5 * area, "{}: {name} is open by {vector} of {area}", room.file);
            match volume {
                Some(volume) => {
                    close(name, enclosed, *volume, 0.02);
                    assert!(enclosed < *volume, "{name} is inscribed");
                    let apart = |n: &[Vec3]| n.iter().any(|m| m.dot(n[0]) < 0.999);
                    assert!(!shared.values().any(|n| apart(n)), "{}: {name} has an edge", room.file);
                }
                None => assert!(enclosed > 0.0, "{}: {name} faces inward", room.file),
            }
        }
    }
}

/// From the view that each file names first, every pixel of a small picture shows light: no hole, no black patch.
#[test]
fn first_views_show_no_hole() {
    for room in ROOMS {
        let view = View::new(&room.camera(), 48, 36);
        let picture = render(&room.scene(), Eye::Camera(view), &settings(FAST, 32, 4, 0), 2);
        let dark = picture.iter().filter(|v| v.luminance() <= 0.0).count();
        assert_eq!(dark, 0, "{}: pixels without any light", room.file);
        let mean = picture.iter().fold(Rgb::BLACK, |a, b| a + *b).luminance() / picture.len() as f32;
        assert!((10.0..1000.0).contains(&mean), "{}: {mean} cd/m² in the mean", room.file);
    }
}
