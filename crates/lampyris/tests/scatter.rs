//! The random walk of 1996 in scenes whose light is known.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Batch, Settings};
use lampyris::elements::{ClosedCube, Criterion, ElementLight, Elements, converge};
use lampyris::import;
use lampyris::light::{Beam, LightKind};
use lampyris::material::{Bsdf, Class, Diffuse, Sides, Ward};
use lampyris::particle::{Plan, Walk};
use lampyris::scatter::{Ending, Inversion, PAPER_REFLECTIONS, RandomWalk, Rules};
use lampyris::sequence::Generator;
use lampyris::testing::{Moments, sidak};
use lampyris::world::World;
use std::f64::consts::PI;
use std::path::Path;
use support::{Build, diffuse, gloss, say, settings};

/// A closed unit cube of one material that emits 1/4.
fn cube(bsdf: Bsdf) -> World {
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

/// Light that a narrow beam throws onto a floor goes on as f_r cos θ says, whatever was inverted: cell by cell of the
/// hemisphere against the integral.
#[test]
fn light_goes_on_as_the_bsdf_says_whatever_is_inverted() {
    const CELLS: [usize; 2] = [4, 8];
    let mut p_values = Vec::new();
    for (name, bsdf) in [
        ("diffuse", diffuse(0.7)),
        ("dull gloss on paint", gloss(0.3, 0.5, 0.25)),
        ("sharp gloss on paint", gloss(0.4, 0.5, 0.12)),
        ("sharp gloss", gloss(0.0, 0.8, 0.1)),
    ] {
        let mut b = Build::default();
        let (black, floor) = (b.grey(0.0), b.material(bsdf, 0.0, Sides::FrontOnly));
        b.room(
            Vec3::new(-2.0, -2.0, 0.0),
            Vec3::new(2.0, 2.0, 2.0),
            [black, black, black, black, floor, black],
        );
        let position = Vec3::new(-1.0, 0.0, 1.0);
        b.light(LightKind::Spot {
            position,
            direction: -position.normalize(),
            intensity: Rgb::WHITE,
            beam: Beam::Cone { cos_inner: 0.999_999, cos_outer: 0.999_99 },
        });
        let world = World::new(b.0);
        let expected = cells(CELLS, |wi| f64::from(value(&bsdf, position.normalize(), wi)));
        for inversion in [Inversion::Nothing, Inversion::Cosine, Inversion::Bsdf] {
            let (mut of_cells, mut whole) = (vec![Moments::default(); expected.len()], Moments::default());
            for seed in 0..12 {
                let rules = Rules { inversion, seed, ending: Ending::After(2), ..Rules::default() };
                let mut found = vec![0.0; expected.len()];
                let mut first = 0.0;
                let walk = RandomWalk::new(&world, rules);
                for path in 0..4096 {
                    walk.path(path, |a| match a.bounces {
                        0 => first += f64::from(a.flux.luminance()),
                        _ => found[cell(CELLS, -a.from())] += f64::from(a.flux.luminance()),
                    });
                }
                of_cells.iter_mut().zip(&found).for_each(|(moments, sum)| moments.push(sum / first));
                whole.push(found.iter().sum::<f64>() / first);
            }
            // Where next to nothing goes, and by rare great weights, no t-test holds: what goes there is in the sum.
            let total: f64 = expected.iter().sum();
            let large = of_cells.iter().zip(&expected).filter(|(_, e)| **e > 0.01 * total);
            let p: Vec<f64> = large.map(|(m, e)| p_value(m, *e)).chain([p_value(&whole, total)]).collect();
            let worst = p.iter().copied().fold(1.0, f64::min);
            say(format_args!("{name}, {inversion:?}: least p-value of {} cells {worst:.1e}", p.len()));
            p_values.extend(p);
        }
    }
    let least = p_values.iter().copied().fold(1.0, f64::min);
    assert!(least > sidak(0.01, p_values.len()), "{least:e} of {}", p_values.len());
}

/// Of a mean that should be `expected`; what agrees to the accuracy of the quadrature has no spread to be judged by.
fn p_value(found: &Moments, expected: f64) -> f64 {
    let same = (found.mean() - expected).abs() < 1e-5;
    if same { 1.0 } else { found.p_value(expected) }
}

/// f_r cos θ of all lobes.
fn value(bsdf: &Bsdf, wo: Vec3, wi: Vec3) -> f32 {
    [Class::Dull, Class::Sharp].map(|class| bsdf.eval(class, wo, wi).luminance() * wi.z).iter().sum()
}

/// The cell of a direction above the floor: equal steps of the cosine, and of the azimuth.
fn cell([rings, sectors]: [usize; 2], w: Vec3) -> usize {
    let ring = ((w.z * rings as f32) as usize).min(rings - 1);
    let turn = (libm::atan2f(w.y, w.x) / std::f32::consts::TAU + 1.0) % 1.0;
    ring * sectors + ((turn * sectors as f32) as usize).min(sectors - 1)
}

/// ∫ over each cell.
fn cells(cells: [usize; 2], f: impl Fn(Vec3) -> f64) -> Vec<f64> {
    const FINE: usize = 512;
    let mut sums = vec![0.0; cells[0] * cells[1]];
    for (i, j) in (0..FINE).flat_map(|i| (0..FINE).map(move |j| (i, j))) {
        let z = (i as f32 + 0.5) / FINE as f32;
        let (sin, cos) = libm::sincosf(std::f32::consts::TAU * (j as f32 + 0.5) / FINE as f32);
        let r = (1.0 - z * z).sqrt();
        let w = Vec3::new(r * cos, r * sin, z);
        sums[cell(cells, w)] += f(w) * 2.0 * PI / (FINE * FINE) as f64;
    }
    sums
}

/// In a closed room of Ward's material each generation carries the share of the last that the albedo says, angle by angle.
#[test]
fn a_closed_room_of_gloss_keeps_the_light_that_its_albedo_says() {
    const NODES: usize = 64;
    let mut p_values = Vec::new();
    for (base, specular, alpha) in [(0.2, 0.7, 0.2), (0.1, 0.8, 0.12)] {
        let bsdf = gloss(base, specular, alpha);
        let albedos: Vec<f64> = (0..=NODES)
            .map(|k| {
                let cos = (k as f32 / NODES as f32).max(1e-3);
                let wo = Vec3::new((1.0 - cos * cos).sqrt(), 0.0, cos);
                cells([1, 1], |wi| f64::from(value(&bsdf, wo, wi)))[0]
            })
            .collect();
        let albedo = |cos: f32| {
            let x = f64::from(cos) * NODES as f64;
            let k = (x as usize).min(NODES - 1);
            albedos[k] + (x - k as f64) * (albedos[k + 1] - albedos[k])
        };
        let world = cube(bsdf);
        for ending in [Ending::After(5), Ending::Roulette] {
            let mut differences = [Moments::default(); 4];
            let mut kept = 0.0;
            for seed in 0..16 {
                let walk = RandomWalk::new(&world, Rules { ending, seed, ..Rules::default() });
                let (mut due, mut came) = (vec![0.0; 6], vec![0.0; 6]);
                for path in 0..4096 {
                    walk.path(path, |a| {
                        let (j, flux) = (a.bounces as usize, f64::from(a.flux.luminance()));
                        if j < 5 {
                            came[j] += flux;
                            due[j + 1] += flux * albedo(a.normal().dot(a.from()));
                        }
                    });
                }
                differences.iter_mut().zip(1..).for_each(|(d, j)| d.push(came[j] - due[j]));
                kept += came[4] / came[0] / 16.0;
            }
            let p: Vec<f64> = differences.iter().map(|d| d.p_value(0.0)).collect();
            say(format_args!("α = {alpha}, {ending:?}: {kept:.4} after four bounces, {p:.3?}"));
            p_values.extend(p);
        }
    }
    let least = p_values.iter().copied().fold(1.0, f64::min);
    assert!(least > sidak(0.01, p_values.len()), "{p_values:?}");
}

/// Runs are cut by number: the same on one thread and on three, and whatever range they were asked in.
#[test]
fn threads_do_not_matter() {
    let world = cube(gloss(0.3, 0.5, 0.2));
    let elements = Elements::new(&world, 0.2).expect("few");
    let walk = RandomWalk::new(&world, Rules::default());
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let light = ElementLight::of(&walk, &elements, 300..70_000);
            let radiances = light.radiances(&elements);
            let criterion = Criterion { epsilon: 1e-3, ..Criterion::default() };
            let done = converge(&walk, &elements, &criterion);
            let positions = walk.paths(500..2500, |all: &mut Vec<Vec3>, a| all.push(a.position()));
            (radiances, done.paths, done.changes, positions)
        })
    };
    let (one, three) = (bits(1), bits(3));
    assert!(one == three && one.1.is_some());
    let flat: Vec<Vec3> = one.3.into_iter().flat_map(|(run, _)| run).collect();
    let mut again = Vec::new();
    (500..2500).for_each(|i| _ = walk.path(i, |a| again.push(a.position())));
    assert_eq!(flat, again);
}

/// Lamps have paths in proportion to their power, and carry all of it; black tints leave them out.
#[test]
fn paths_start_in_proportion_to_power() {
    let mut b = Build::default();
    let black = b.grey(0.0);
    b.room(Vec3::ZERO, Vec3::splat(3.0), [black; 6]);
    b.bulb(Vec3::splat(1.0), 300.0);
    b.bulb(Vec3::splat(2.0), 100.0);
    let world = World::new(b.0);
    for (tint, total) in [([1.0, 1.0], 400.0), ([0.5, 1.0], 250.0), ([0.0, 1.0], 100.0)] {
        let walk = RandomWalk::tinted(&world, Rules::default(), |k| Rgb::grey(tint[k as usize]));
        let (mut flux, mut of_first) = (0.0, 0);
        for path in 0..1000 {
            walk.path(path, |a| {
                flux += f64::from(a.flux.g) / 1000.0;
                of_first += u32::from(a.emitter == 0);
            });
        }
        assert!((flux / total - 1.0).abs() < 1e-5, "{flux} of {total}");
        let share = f64::from(300.0 * tint[0]) / total;
        assert!((f64::from(of_first) / 1000.0 - share).abs() < 0.002, "{of_first} for {share}");
    }
    let dark = RandomWalk::tinted(&world, Rules::default(), |_| Rgb::BLACK);
    assert_eq!(dark.path(0, |_| panic!("light from nowhere")), 0);
}

/// What an arrival says of its way: over a mirror it is a caustic, after paint it is not any more.
#[test]
fn arrivals_know_their_way() {
    let mut b = Build::default();
    let (paint, mirror) = (b.grey(0.5), b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both));
    b.room(Vec3::ZERO, Vec3::splat(2.0), [paint, paint, paint, paint, mirror, paint]);
    b.bulb(Vec3::splat(1.0), 100.0);
    let world = World::new(b.0);
    let walk = RandomWalk::new(&world, Rules::paper(Generator::SobolOwen, 3));
    let mut caustics = 0;
    for path in 0..500 {
        let mut met: Vec<bool> = Vec::new();
        walk.path(path, |a| {
            assert_eq!((a.path, a.bounces as usize), (path, met.len()));
            assert_eq!(a.sharp, met.last() == Some(&true));
            assert_eq!(a.diffused, met.contains(&false));
            assert_eq!(a.is_caustic(), met.last() == Some(&true) && !met.contains(&false));
            caustics += u32::from(a.is_caustic());
            assert!((a.from().length() - 1.0).abs() < 1e-5 && a.normal().dot(a.from()) >= 0.0);
            met.push(a.position().z < 1e-4);
        });
        assert_eq!(met.len(), PAPER_REFLECTIONS as usize);
    }
    assert!((70..100).contains(&caustics), "a sixth of the paths: {caustics}");
    let none = RandomWalk::new(&world, Rules { ending: Ending::After(0), ..Rules::default() });
    assert_eq!(none.path(0, |_| panic!("it was told not to")), 0);
}

/// What an element sends out itself is what is seen of it on its side, in whichever instance and on either side of a panel.
#[test]
fn elements_shine_as_their_surfaces_do() {
    let mut b = Build::default();
    let wall = b.grey(0.5);
    b.room(Vec3::ZERO, Vec3::new(2.0, 1.0, 1.0), [wall; 6]);
    for (k, sides) in [Sides::EmitFront, Sides::Both, Sides::FrontOnly].into_iter().enumerate() {
        let glow = b.material(diffuse(0.2), 1.0 + k as f32, sides);
        b.quad(Vec3::new(0.2 + 0.6 * k as f32, 0.5, 0.3), Vec3::X * 0.4, Vec3::Z * 0.4, glow);
    }
    let world = World::new(b.0);
    let elements = Elements::new(&world, 0.2).expect("few");
    let walk = RandomWalk::new(&world, Rules::default());
    let (mut bright, mut dark) = (0, 0);
    for path in 0..4000 {
        walk.path(path, |a| {
            let shines = a.surface.emission();
            let element = elements.at(&world, &a.hit, a.surface.front).expect("a side that is met");
            assert_eq!(elements.emission(&world, element), shines);
            if shines.is_black() { dark += 1 } else { bright += 1 }
        });
    }
    assert!(bright > 200 && dark > 2000, "{bright} {dark}");
}

/// An element is found where it lies, knows its side and area, and too many of them are refused.
#[test]
fn elements_tile_the_surface() {
    let world = cube(diffuse(0.5));
    let elements = Elements::new(&world, 0.3).expect("few");
    assert!((elements.total_area() - 6.0).abs() < 1e-5);
    assert_eq!(elements.len(), 12 * 32, "halved until √2/√2⁵ ≤ 0.3");
    let mut seen = vec![0_u32; elements.len()];
    let walk = RandomWalk::new(&world, Rules::default());
    for path in 0..20_000 {
        walk.path(path, |a| {
            let k = elements.at(&world, &a.hit, a.surface.front).expect("an element");
            seen[k as usize] += 1;
            assert_eq!(elements.at(&world, &a.hit, !a.surface.front), None);
            assert!((elements.emission(&world, k).g - 0.25).abs() < 1e-6);
        });
    }
    // 40 000 arrivals, about a hundred on each: equal areas of equal light.
    assert!(seen.iter().all(|n| (60..150).contains(n)), "{seen:?}");
    assert!(Elements::new(&world, 1e-5).is_err() && Elements::halved(&world, 30).is_err());
    assert!([0.0, -1.0, f32::NAN].into_iter().all(|size| Elements::new(&world, size).is_err()));
    assert_eq!(Elements::new(&world, f32::INFINITY).expect("whole").len(), 12);
    assert!(ClosedCube::new(25).is_err() && ClosedCube::new(0).is_err() && ClosedCube::new(36).is_err());
}

/// A curtain sends its shares to both sides, whatever is inverted.
#[test]
fn light_passes_a_curtain() {
    let base = Diffuse { reflectance: Rgb::grey(0.3), transmittance: Rgb::grey(0.5) };
    let gloss = Ward {
        base,
        specular: Rgb::grey(0.1),
        alpha: 0.3,
        transmission: Rgb::BLACK,
        transmission_alpha: 0.0,
    };
    for (bsdf, gloss) in [(Bsdf::Diffuse(base), 0.0), (Bsdf::Ward(gloss), 0.1)] {
        let mut b = Build::default();
        let (black, curtain) = (b.grey(0.0), b.material(bsdf, 0.0, Sides::Both));
        b.room(Vec3::ZERO, Vec3::splat(2.0), [black; 6]);
        b.quad(Vec3::new(0.0, 0.0, 1.0), Vec3::X * 2.0, Vec3::Y * 2.0, curtain);
        b.light(LightKind::Directional { direction: -Vec3::Z, illuminance: Rgb::WHITE });
        // Through the ceiling, which lets light in from behind.
        b.0.materials[black as usize].sides = Sides::FrontOnly;
        let world = World::new(b.0);
        for inversion in [Inversion::Nothing, Inversion::Cosine, Inversion::Bsdf] {
            for ending in [Ending::After(2), Ending::Roulette] {
                let walk = RandomWalk::new(&world, Rules { inversion, ending, ..Rules::default() });
                let (mut first, mut sides) = (0.0, [0.0, 0.0]);
                for path in 0..1 << 15 {
                    walk.path(path, |a| match a.bounces {
                        0 => first += f64::from(a.flux.g),
                        _ => sides[usize::from(a.from().z > 0.0)] += f64::from(a.flux.g),
                    });
                }
                let [up, down] = sides.map(|s| s / first);
                // At 0° the lobe of α = 0.3 has the albedo 0.91.
                let due = 0.3 + 0.91 * gloss;
                say(format_args!("{inversion:?}, {ending:?}: {up:.4} of {due}, {down:.4} of 0.5"));
                assert!((up - due).abs() < 0.005 && (down - 0.5).abs() < 0.005, "{inversion:?}: {up} {down}");
            }
        }
    }
}

/// In the office both walks bring all surfaces the same light, to be sent on diffusely: this one and that of the virtual lights.
#[test]
fn it_brings_the_light_of_the_other_walk() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/office.mgf");
    let world = World::new(import::load(&file, &import::Options::default()).expect("readable").scene);
    let elements = Elements::new(&world, f32::INFINITY).expect("few");
    let of_walk = |seed| {
        let walk = RandomWalk::new(&world, Rules { seed, ..Rules::default() });
        let light = ElementLight::of(&walk, &elements, 0..4096);
        let sent = (0..elements.len() as u32)
            .map(|k| f64::from(light.radiance(&elements, k).luminance() * elements.area(k)) * PI);
        sent.sum::<f64>()
    };
    let of_particles = |seed| {
        let settings = Settings { interleave: [1, 1], ..settings(support::FAST, 4096, 1, seed) };
        let plan = Plan::new(&world, &settings);
        let walk = Walk::new(&world, &settings, &plan, Batch { index: 0 });
        let sent = walk.vpls.iter().map(|v| match &v.gloss {
            None => f64::from(v.intensity.luminance()) * PI,
            Some(surface) => f64::from((v.intensity * surface.albedo(Class::Dull)).luminance()),
        });
        sent.sum::<f64>()
    };
    let (a, b): (Moments, Moments) = ((0..16).map(of_walk).collect(), (0..16).map(of_particles).collect());
    say(format_args!(
        "1996: {:.1} ± {:.1} lm, 1997: {:.1} ± {:.1}",
        a.mean(),
        a.standard_error(),
        b.mean(),
        b.standard_error()
    ));
    assert!(a.p_value_against(&b) > 0.01, "{} and {}", a.mean(), b.mean());
    assert!(a.standard_error() < 0.01 * a.mean(), "a test of nothing");
}

/// Where nothing is ever absorbed roulette ends paths all the same, and loses no light by it.
#[test]
fn white_rooms_are_left_alive() {
    let world = cube(diffuse(1.0));
    let mut generations: Vec<Moments> = vec![Moments::default(); 20];
    for seed in 0..16 {
        let brought = arriving(&world, Rules { seed, ..Rules::default() }, 0..1024);
        assert!(brought.len() > 100 && brought.len() <= 1024);
        brought.iter().zip(&mut generations).for_each(|(b, moments)| moments.push(*b));
    }
    for (j, moments) in generations.iter().enumerate() {
        let off = (moments.mean() - 0.25).abs();
        assert!(off < 1e-6 || moments.p_value(0.25) > sidak(0.01, 20), "{j}: {}", moments.mean());
    }
}

/// The rule stops where its formula says, and not before: Δ worked out anew from the light of N₁ and of N₂ paths.
#[test]
fn the_rule_is_its_formula() {
    let world = cube(gloss(0.5, 0.2, 0.2));
    let elements = Elements::halved(&world, 2).expect("few");
    let walk = RandomWalk::new(&world, Rules::default());
    let criterion = Criterion { epsilon: 1e-3, step: 500, times: 3, most: 100_000 };
    let done = converge(&walk, &elements, &criterion);
    let light = |n: usize| ElementLight::of(&walk, &elements, 0..500 * n as u32).radiances(&elements);
    let k = elements.len() as f64;
    for (n, change) in (1..).zip(&done.changes) {
        let squares = light(n).into_iter().zip(light(n + 1)).map(|(a, b)| {
            [a.r - b.r, a.g - b.g, a.b - b.b].map(|d| f64::from(d).powi(2)).iter().sum::<f64>()
        });
        // Areas are equal; Σ L₀ |A| = ¼ · 6.
        let expected = (squares.sum::<f64>() / (k * k)).sqrt() / 1.5;
        assert!((change / expected - 1.0).abs() < 1e-3, "{n}: {change} for {expected}");
    }
    let below: Vec<bool> = done.changes.iter().map(|c| *c < 1e-3).collect();
    let first = below.windows(3).position(|w| w == [true; 3]).expect("it stops");
    assert_eq!(done.changes.len(), first + 3);
    assert_eq!(done.paths, Some(500 * (first as u32 + 4)), "N₁ = (n + t) ΔN, n from 1, and ΔN more");
    assert_eq!((done.light.paths(), done.light.rays() > 4000), (u64::from(done.paths.unwrap()), true));
    let impatient = converge(&walk, &elements, &Criterion { most: 1400, ..criterion });
    assert_eq!((impatient.paths, impatient.light.paths(), impatient.changes.len()), (None, 1000, 1));
}
