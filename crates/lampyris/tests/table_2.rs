//! Table 2 of [Keller96]: what inversion of the BRDF saves. In diffuse scenes nothing, to the path, since the cosine is all
//! there is to invert; among specular surfaces most of the paths.

mod support;

use glam::Vec3;
use lampyris::elements::{Criterion, Elements, converge};
use lampyris::import;
use lampyris::material::Sides;
use lampyris::scatter::{Inversion, RandomWalk, Rules};
use lampyris::scene::Scene;
use lampyris::sequence::Generator;
use lampyris::world::World;
use std::path::Path;
use support::{Build, diffuse, gloss, say};

const GENERATORS: [Generator; 2] = [Generator::Congruential, Generator::Halton];

/// N without and with inversion, by generator.
fn needed(name: &str, scene: Scene) -> Vec<[u32; 2]> {
    let world = World::new(scene);
    let elements = Elements::new(&world, 0.5).expect("few");
    let criterion = Criterion::default().scaled_to(&elements);
    let n = |generator, inversion| {
        let rules = Rules { inversion, ..Rules::paper(generator, 1) };
        let done = converge(&RandomWalk::new(&world, rules), &elements, &criterion);
        done.paths.expect("it stops")
    };
    let both = |g: Generator| {
        let both = [Inversion::Cosine, Inversion::Bsdf].map(|inversion| n(g, inversion));
        say(format_args!("{name}, {}: N = {} without, {} with inversion", g.name(), both[0], both[1]));
        both
    };
    GENERATORS.map(both).to_vec()
}

#[test]
fn inversion_saves_nothing_in_a_diffuse_scene() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cornell.mgf");
    let scene = import::load(&file, &import::Options::default()).expect("readable").scene;
    for [without, with] in needed("cornell.mgf", scene) {
        assert_eq!(without, with);
    }
}

/// A room of Ward's material, ρ_d = 0.2, ρ_s = 0.6, under a lamp: sharp lobes and dull ones.
#[test]
fn inversion_saves_paths_in_a_specular_scene() {
    for alpha in [0.1, 0.3] {
        let mut b = Build::default();
        let wall = b.material(gloss(0.2, 0.6, alpha), 0.0, Sides::FrontOnly);
        let lamp = b.material(diffuse(0.0), 100.0, Sides::FrontOnly);
        b.room(Vec3::ZERO, Vec3::new(4.0, 3.0, 2.5), [wall; 6]);
        b.quad(Vec3::new(1.5, 1.0, 2.49), Vec3::Y, Vec3::X, lamp);
        for [without, with] in needed(&format!("α = {alpha}"), b.0) {
            assert!(f64::from(with) < 0.75 * f64::from(without), "{with} of {without}");
        }
    }
}
