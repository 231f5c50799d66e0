//! Published MGF scenes, in figures computed with the reference implementation (`mgfilt` of Radiance 6.0a, 20 facets
//! a circle). Counts are exact, bounds, areas and lumens to 10⁻³.

use lampyris::import::{Loaded, Options, load};
use lampyris::scene::find_view;
use lampyris::world::World;
use std::path::PathBuf;

fn scenes() -> PathBuf {
    PathBuf::from(std::env::var_os("LAMPYRIS_SCENES").expect("LAMPYRIS_SCENES names the folder of scenes"))
        .join("mgf")
}

fn read(file: &str) -> Loaded {
    let root = scenes();
    load(&root.join(file), &Options { root: Some(root), ..Options::default() }).unwrap()
}

struct Facts {
    file: &'static str,
    triangles: u64,
    area: f64,
    bounds: [[f32; 3]; 2],
    emitting_area: f64,
    lumens: f64,
    materials: usize,
}

const FACTS: &[Facts] = &[
    Facts {
        file: "office-b90/office.mgf",
        triangles: 34000,
        area: 142.1434,
        bounds: [[-2.286, 1.181, -2.286], [2.286, 3.886, 2.286]],
        emitting_area: 1.17369,
        lumens: 16694.9,
        materials: 28,
    },
    Facts {
        file: "office2/office2.mgf",
        triangles: 741,
        area: 108.8219,
        bounds: [[-0.075, -0.150, -0.020], [4.0, 5.750, 2.8]],
        emitting_area: 0.052,
        lumens: 2600.0,
        materials: 23,
    },
    Facts {
        file: "corridor.mgf",
        triangles: 1376,
        area: 1361.3895,
        bounds: [[-5.0, 0.0, 0.0], [15.0, 20.0, 10.0]],
        emitting_area: 9.12,
        lumens: 2_280_000.0,
        materials: 12,
    },
    Facts {
        file: "floor_gloss.mgf",
        triangles: 376,
        area: 51.3321,
        bounds: [[0.0; 3], [10.0, 4.0, 3.0]],
        emitting_area: 0.05657,
        lumens: 565.7,
        materials: 4,
    },
    Facts {
        file: "cube.mgf",
        triangles: 67,
        area: 728.2480,
        bounds: [[0.0; 3], [10.0, 9.8, 10.0]],
        emitting_area: 1.0,
        lumens: 200_000.0,
        materials: 9,
    },
    Facts {
        file: "examp1.mgf",
        triangles: 500,
        area: 1.0606,
        bounds: [[-0.613, -0.129, -0.044], [0.613, 0.129, 0.044]],
        emitting_area: 0.19378,
        lumens: 8661.8,
        materials: 4,
    },
    Facts {
        file: "blinds20c.mgf",
        triangles: 132,
        area: 7.92,
        bounds: [[-1.5, -0.014, -0.038], [1.5, 0.960, 0.0]],
        emitting_area: 0.0,
        lumens: 0.0,
        materials: 2,
    },
    Facts {
        file: "hospital/hosp.mgf",
        triangles: 59180,
        area: 834.2430,
        bounds: [[-5.0, 0.0, 0.0], [8.5, 13.0, 2.5]],
        emitting_area: 1.59663,
        lumens: 20210.3,
        materials: 219,
    },
];

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn published_scenes_have_the_reference_figures() {
    let mut faults = Vec::new();
    for want in FACTS {
        let loaded = read(want.file);
        let have = loaded.scene.summary();
        if have.triangles != want.triangles || have.materials != want.materials {
            faults.push(format!("{}: {} triangles, {} materials", want.file, have.triangles, have.materials));
        }
        let figures = [
            (have.area, want.area),
            (have.emitting_area, want.emitting_area),
            (have.power_lm_front, want.lumens),
        ];
        for (have, want_value) in figures {
            if (have - want_value).abs() > 1e-3 * want_value {
                faults.push(format!("{}: {have} against {want_value}", want.file));
            }
        }
        let bounds = have.bounds.unwrap().map(|p| p.to_array());
        for (have, want_value) in bounds.iter().flatten().zip(want.bounds.iter().flatten()) {
            // The table has three decimals.
            if (have - want_value).abs() > 0.001 {
                faults.push(format!("{}: bounds {bounds:?}", want.file));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Where a scene has no camera the view that is found shows seven tenths of the furniture of a room: of one room, where a
/// storey has many, and around a corner.
#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn found_views_show_the_furniture() {
    for file in ["office-b90/office.mgf", "office2/office2.mgf", "corridor.mgf", "hospital/hosp.mgf"] {
        let world = World::new(read(file).scene);
        let found = find_view(world.scene(), &|ray| world.tracer().closest(ray), 4.0 / 3.0);
        assert!(found.seen.furniture >= 0.7 && found.seen.walls >= 0.3, "{file}: {:?}", found.seen);
    }
}
