//! Which way is up where no file says: every scene that ships, published rooms, and a room that shines at its ceiling alone.

mod mgf_support;

use glam::Vec3;
use lampyris::import::{Options, load};
use lampyris::scene::upward;
use mgf_support::{clean, scenes};
use std::path::Path;

/// What is up in a file, by its shapes and lamps alone.
fn found(file: &Path) -> Vec3 {
    let options = Options { root: Some("/".into()), ..Options::default() };
    let mut scene = load(file, &options).unwrap_or_else(|e| panic!("{e}")).scene;
    scene.up = None;
    upward(&scene)
}

#[test]
fn scenes_that_ship_stand_upright() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").canonicalize().expect("scenes");
    for file in ["conference", "cube", "egg", "foyer", "office", "ring", "table"] {
        assert_eq!(found(&folder.join(file).with_extension("mgf")), Vec3::Z, "{file}");
    }
    for file in ["cornell.mgf", "parlour/parlour.gltf"] {
        assert_eq!(found(&folder.join(file)), Vec3::Y, "{file}");
    }
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn published_rooms_stand_upright() {
    let rooms = ["corridor.mgf", "cube.mgf", "floor_gloss.mgf", "hospital/hosp.mgf", "office2/office2.mgf"];
    for file in rooms {
        assert_eq!(found(&scenes().join(file)), Vec3::Z, "{file}");
    }
    assert_eq!(found(&scenes().join("office-b90/office.mgf")), Vec3::Y);
}

/// A table in a room of 4 × 3 × 2.5 m, and one lamp that shines along z.
fn uplit(lamp: f32, up: f32) -> Vec3 {
    let corners = |[x0, y0, x1, y1]: [f32; 4]| {
        let points = [("a", x0, y0), ("b", x1, y0), ("c", x1, y1), ("d", x0, y1)];
        points.map(|(name, x, y)| format!("v {name} =\n\tp {x} {y} 0\n")).concat()
    };
    let (room, table) = (corners([0.0, 0.0, 4.0, 3.0]), corners([1.0, 1.0, 2.0, 2.0]));
    let (high, low, lamp) = (-2.5 * up, -0.75 * up, lamp * up);
    upward(&clean(&format!(
        "m grey =\n\tc\n\trd 0.5\n{room}prism a b c d {high}\n{table}prism a b c d {low}\n\
         m glow =\n\tsides 1\n\tc\n\ted 50000\nv l =\n\tp 3 2.4 {lamp}\n\tn 0 0 {up}\nring l 0 .15\n"
    )))
}

#[test]
fn a_room_lit_by_its_ceiling_is_not_stood_on_its_head() {
    for lamp in [1.3, 1.8, 2.2] {
        assert_eq!(uplit(lamp, 1.0), Vec3::Z, "a lamp at {lamp} m");
        assert_eq!(uplit(lamp, -1.0), Vec3::NEG_Z, "a lamp at {lamp} m, upside down");
    }
}
