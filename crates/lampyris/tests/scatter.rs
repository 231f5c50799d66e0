//! The random walk of 1996 in scenes whose light is known.

mod support;

use glam::Vec3;
use lampyris::material::Sides;
use lampyris::scatter::{PAPER_REFLECTIONS, RandomWalk, Rules};
use lampyris::sequence::Generator;
use lampyris::world::World;
use std::f64::consts::PI;
use support::{Build, diffuse};

/// A closed unit cube of one material that emits 1/4.
fn cube(bsdf: lampyris::material::Bsdf) -> World {
    let mut b = Build::default();
    let wall = b.material(bsdf, 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    World::new(b.0)
}

/// Mean over the walls of the light that comes to them, as radiance, generation by generation: Σ Φ/(π A N).
fn arriving(world: &World, rules: Rules, numbers: std::ops::Range<u32>) -> Vec<f64> {
    let walk = RandomWalk::new(world, rules);
    let count = f64::from(numbers.end - numbers.start);
    let mut sums: Vec<f64> = Vec::new();
    for (run, _) in walk.paths(numbers, |sums: &mut Vec<f64>, a| {
        sums.resize(sums.len().max(a.bounces as usize + 1), 0.0);
        sums[a.bounces as usize] += f64::from(a.flux.luminance());
    }) {
        sums.resize(sums.len().max(run.len()), 0.0);
        run.iter().zip(&mut sums).for_each(|(x, sum)| *sum += x);
    }
    sums.iter().map(|sum| sum / (PI * f64::from(world.area()) * count)).collect()
}

/// Emission, cosine and Lambert's lobe are inverted exactly, so generation j brings ¼ · 2⁻ʲ whatever the numbers are. (Of some million paths
/// one meets an edge so exactly that it gets out; not with these seeds.)
#[test]
fn every_generation_of_the_closed_cube_brings_half_of_the_last() {
    let world = cube(diffuse(0.5));
    for generator in Generator::ALL {
        let brought = arriving(&world, Rules::paper(generator, 2), 0..500);
        assert_eq!(brought.len(), PAPER_REFLECTIONS as usize);
        for (j, b) in brought.iter().enumerate() {
            assert!((b - 0.25 * 0.5_f64.powi(j as i32)).abs() < 1e-6, "{}, {j}: {b}", generator.name());
        }
    }
}
