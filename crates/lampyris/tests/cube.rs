//! Keller's closed cube: walls of ρ = 1/2 that emit Lₑ = 1/4 look ½ everywhere. Weights of the particles, pictures,
//! corners, and the equality of one long walk and many short ones.

mod support;

use glam::Vec3;
use lampyris::backend::{Absorption, Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::import;
use lampyris::material::Sides;
use lampyris::particle::{Plan, Walk};
use lampyris::scene::Scene;
use lampyris::sequence::Sequence;
use lampyris::testing::{Moments, sidak};
use lampyris::world::World;
use std::path::Path;
use support::{Build, FAST, diffuse, meter, say, settings, view};

/// Draws of the walk, of the picture: seeds.
const DRAWS: u32 = 16;

/// All walls in one mesh: a single light, as in the paper.
fn cube() -> Scene {
    let mut b = Build::default();
    let wall = b.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    let mut all = Build::default();
    all.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    let positions = b.0.meshes.iter().flat_map(|m| m.positions.clone()).collect();
    let triangles = (0..6).flat_map(|k| [[4 * k, 4 * k + 1, 4 * k + 2], [4 * k, 4 * k + 2, 4 * k + 3]]);
    all.mesh(positions, triangles.collect(), vec![wall; 12]);
    all.0
}

/// The same from the file, where each wall is a light of its own.
fn cube_file() -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cube.mgf");
    import::load(&file, &import::Options::default()).expect("readable").scene
}

/// Mean radiance of the walls, from the particles alone: Lₑ + Σ over vertices of radiance × area, over the area. Each
/// vertex' intensity is multiplied by the number of passes that share the vertices out.
fn radiance_of_walk(world: &World, settings: &Settings, batch: u32) -> f64 {
    let plan = Plan::new(world, settings);
    let walk = Walk::new(world, settings, &plan, Batch { index: batch });
    let sum: f64 = walk.vpls.iter().map(|v| f64::from(v.intensity.luminance())).sum();
    0.25 + sum / f64::from(world.area()) / f64::from(settings.eye_passes())
}

/// Generation j has x_j = N qʲ particles in the mean over ξ, each of flux Φ ρʲ⁻¹/x_j: the sum telescopes to
/// Lₑ(1 + ρ + ρ² + …) = ½ at any N. One draw misses by rounding the counts: Σ ρʲ (n_j − x_j)/x_j.
#[test]
fn particles_carry_one_half() {
    for (name, scene) in [("built", cube()), ("cube.mgf", cube_file())] {
        let world = World::new(scene);
        for paths in [1024, 1025, 1500, 2304, 4096, 10_000] {
            let draw = |seed| radiance_of_walk(&world, &settings(FAST, paths, 1, seed), 0);
            let draws: Moments = (0..DRAWS).map(draw).collect();
            let worst = (0..DRAWS).map(|s| (draw(s) - 0.5).abs()).fold(0.0, f64::max);
            say(format_args!(
                "{name}, N = {paths}: mean {:+.1e}, worst draw {worst:.1e}",
                draws.mean() - 0.5
            ));
            assert!((draws.mean() - 0.5).abs() <= 1e-3, "{paths} paths: {}", draws.mean());
            assert!(worst <= 3e-3, "{paths} paths: one draw is off by {worst}");
        }
    }
}

/// The paper's ⌊ρ̄ʲN⌋ ends where it reaches 0: at N = 1024 = 2¹⁰ it keeps generations 1 to 10 exactly and loses the
/// tail Σ_{j>10} Lₑ ρʲ = 2.44e-4.
#[test]
fn the_papers_absorption_loses_the_tail() {
    let world = World::new(cube());
    let paper = Settings { absorption: Absorption::Paper, ..settings(FAST, 1024, 1, 0) };
    let lost = 0.5 - radiance_of_walk(&world, &paper, 0);
    say(format_args!("the paper's form loses {lost:.3e} at N = 1024"));
    assert!((lost - 0.25 / 1024.0).abs() < 1e-6, "lost {lost}");
}

/// Both unbiased forms with every sequence whose numbers are uniform, each for itself, over the seeds: ½ in the mean of
/// many draws, by Student's t. Halton's sequence, plain or moved within its cells, has no such seeds.
#[test]
fn unbiased_forms_carry_one_half() {
    let world = World::new(cube());
    let mut p_values = Vec::new();
    for sequence in [Sequence::SobolOwen, Sequence::SobolXor, Sequence::ScrambledHalton] {
        for absorption in [Absorption::Fractional, Absorption::Roulette] {
            let s = |seed| Settings { absorption, sequence, ..settings(FAST, 256, 1, seed) };
            let draws: Moments = (0..64).map(|seed| radiance_of_walk(&world, &s(seed), seed % 7)).collect();
            p_values.push(draws.p_value(0.5));
            say(format_args!("{sequence:?}, {absorption:?}: {:+.1e}", draws.mean() - 0.5));
        }
    }
    let least = p_values.iter().copied().fold(1.0, f64::min);
    assert!(least > sidak(0.01, p_values.len()), "{p_values:?}");
}

/// Into the corner at the origin; and meters on all faces, 1 cm before the four corners and the four edges' middles,
/// and at the centres.
fn eyes() -> [Eye; 2] {
    let into_corner = view(Vec3::new(0.7, 0.6, 0.5), Vec3::ZERO, 70.0, 8, 8);
    let mut meters: Vec<Meter> = Vec::new();
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        let (u, v) = axis.any_orthonormal_pair();
        for normal in [axis, -axis] {
            let centre = Vec3::splat(0.5) - normal * (0.5 - 1e-4);
            for (a, b) in (-1..=1).flat_map(|a| (-1..=1).map(move |b| (a as f32, b as f32))) {
                meters.push(meter(centre + (u * a + v * b) * 0.49, normal));
            }
        }
    }
    [into_corner, Eye::Meters(meters)]
}

/// The picture of every scramble, pixel by pixel.
fn draws(scene: &Scene, eye: &Eye, settings: &Settings, batches: u32) -> Vec<Vec<f64>> {
    let mut all = Vec::new();
    for seed in 0..DRAWS {
        let s = Settings { seed, ..settings.clone() };
        let mean = support::render(scene, eye.clone(), &s, batches);
        all.push(mean.iter().map(|v| f64::from(v.luminance())).collect());
    }
    all
}

/// Every pixel, and their mean, is ½: by Student's t over the scrambles, pixels corrected for their number, and within
/// 2e-3 in the mean of the picture.
#[test]
fn pictures_are_one_half_corners_included() {
    for (name, eye) in ["camera", "meters"].into_iter().zip(eyes()) {
        let s = Settings { clamp: 4.0, ..settings(FAST, 1 << 11, 1 << 7, 0) };
        let draws = draws(&cube(), &eye, &s, 4);
        let pixels = draws[0].len();
        let pixel = |k: usize| draws.iter().map(|d| d[k]).collect::<Moments>();
        let least = (0..pixels).map(|k| pixel(k).p_value(0.5)).fold(1.0, f64::min);
        let worst = (0..pixels).map(|k| (pixel(k).mean() - 0.5).abs()).fold(0.0, f64::max);
        let whole: Moments = draws.iter().map(|d| d.iter().sum::<f64>() / pixels as f64).collect();
        say(format_args!(
            "{name}: mean {:+.1e} ± {:.1e}, worst pixel {worst:.1e}, least p {least:.3}",
            whole.mean() - 0.5,
            whole.standard_error()
        ));
        assert!(least > sidak(0.01, pixels), "a pixel is not one half: p = {least}");
        assert!((whole.mean() - 0.5).abs() < 2e-3, "{}", whole.mean());
        assert!((whole.mean() - 0.5).abs() < 3.0 * whole.standard_error(), "{whole:?}");
    }
}

/// Accumulation: 256 batches of N = 9 paths (Wald's class size) have the mean of one batch of 2304. The error of either
/// is the spread of its scrambles.
#[test]
fn many_short_batches_equal_a_long_one() {
    let [camera, _] = eyes();
    let short = draws(&cube(), &camera, &settings(FAST, 9, 9, 0), 256);
    let long = draws(&cube(), &camera, &settings(FAST, 2304, 2304, 0), 1);
    let mean = |draws: &[Vec<f64>]| {
        draws.iter().map(|d| d.iter().sum::<f64>() / d.len() as f64).collect::<Moments>()
    };
    let (a, b) = (mean(&short), mean(&long));
    let sigma = (a.standard_error().powi(2) + b.standard_error().powi(2)).sqrt();
    say(format_args!(
        "256 of 9: {:.5} ± {:.1e}; one of 2304: {:.5} ± {:.1e}",
        a.mean(),
        a.standard_error(),
        b.mean(),
        b.standard_error()
    ));
    assert!((a.mean() - b.mean()).abs() < 3.0 * sigma);
    assert!(sigma < 5e-3, "a test of this noise says nothing: {sigma}");
    // The particles too, with far less noise: the paper's form would lose 11 % of the indirect light here.
    let world = World::new(cube());
    let s = settings(FAST, 9, 1, 0);
    let walks: Moments = (0..256).map(|batch| radiance_of_walk(&world, &s, batch)).collect();
    say(format_args!("particles of 256 of 9: {:+.1e}", walks.mean() - 0.5));
    assert!((walks.mean() - 0.5).abs() < 2e-3, "{walks:?}");
}

/// Student's 95 % interval over the four randomisations of one picture covers the truth, ½, in 88 to 99 % of 64 runs, and
/// of its blocks of 8 × 8 pixels, and of meters:
/// with a right coverage of 95 % the count lies outside with probability 4 %, with one of 80 % inside with 6 %.
#[test]
fn stated_errors_hold() {
    const RUNS: u32 = 64;
    let [camera, meters] = eyes();
    for (name, eye) in [("camera", camera), ("meters", meters)] {
        let mut covered = 0;
        let mut whole = 0;
        let mut places = 0;
        for seed in 0..RUNS {
            let mut cpu = Cpu::new(None).expect("threads");
            cpu.begin(cube(), eye.clone(), &settings(FAST, 64, 16, 1000 + seed)).expect("sound");
            (0..16).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
            let frame = cpu.frame().expect("begun");
            let mean = frame.mean();
            let factor = frame.student_factor();
            assert!((factor - 3.182).abs() < 1e-3, "Student's factor for four randomisations: {factor}");
            let edge = if frame.height == 1 { 1 } else { 8 };
            let (width, height) = (frame.width as usize, frame.height as usize);
            for (x, y) in
                (0..height).step_by(edge).flat_map(|y| (0..width).step_by(edge).map(move |x| (x, y)))
            {
                let pixels =
                    (y..height.min(y + edge)).flat_map(|y| (x..width.min(x + edge)).map(move |x| (x, y)));
                let block: Moments =
                    pixels.map(|(x, y)| f64::from(mean[y * width + x].luminance())).collect();
                let error = f64::from(factor * frame.standard_error(y * width + x));
                covered += u32::from((block.mean() - 0.5).abs() <= error);
                places += 1;
            }
            let picture = mean.iter().map(|v| v.luminance()).sum::<f32>() / mean.len() as f32;
            let stated = factor * frame.relative_error() * picture;
            whole += u32::from((picture - 0.5).abs() <= stated);
        }
        let share = |covered: u32, of: u32| f64::from(covered) / f64::from(of);
        let (each, mean) = (share(covered, places), share(whole, RUNS));
        say(format_args!("{name}: covered {:.1} % of places, {:.1} % of means", 100.0 * each, 100.0 * mean));
        assert!((0.88..=0.99).contains(&each), "{name}: {each} of the places");
        assert!((0.88..=0.99).contains(&mean), "{name}: {mean} of the means");
    }
}
