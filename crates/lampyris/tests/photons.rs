//! Caustic photons: what they carry, from which lights, over which bodies, against closed forms, against plain particles
//! and against the oracle; and the grid against a sum over all photons.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Batch, Settings};
use lampyris::geometry::Ray;
use lampyris::light::{Beam, LightKind};
use lampyris::material::{Bsdf, Diffuse, Pbr, Sides, Ward};
use lampyris::particle::{Plan, Walk};
use lampyris::photon::{Grid, Photon, Photons};
use lampyris::sequence;
use lampyris::testing::Moments;
use lampyris::world::World;
use std::f32::consts::{PI, TAU};
use support::{Build, close, close_mean, glass, gloss, lux, meter, render, say, settings, spread, view};

/// A thin pane that absorbs nothing.
fn pane() -> Bsdf {
    Bsdf::Pbr(Pbr {
        base_color: Rgb::WHITE,
        metallic: 0.0,
        transmission: 1.0,
        roughness: 0.0,
        ..Pbr::default()
    })
}

/// The photons of one batch, so many from the lights.
fn map(world: &World, photons: u32, seed: u32, index: u32) -> Photons {
    let s = Settings { photons, ..settings(&["caustic"], 64, 4, seed) };
    let batch = Batch { index };
    let plan = Plan::new(world, &s);
    let walk = Walk::new(world, &s, &plan, batch);
    Photons::new(world, &s, &plan, &[0], &[walk], batch)
}

/// Illuminance by the photons of a grid [lx].
fn light(grid: &Grid, x: Vec3, normal: Vec3) -> Rgb {
    let mut sum = Rgb::BLACK;
    grid.irradiance(x, normal, |_, light| sum += light);
    sum
}

/// Flux of photons [lm].
fn flux<'a>(photons: impl IntoIterator<Item = &'a Photon>) -> f64 {
    photons.into_iter().map(|p| f64::from(p.flux.luminance())).sum()
}

/// Walls around everything, seen from inside alone: light from without passes, and nothing that is inside gets out.
fn walls(b: &mut Build, half: f32, rho: f32) {
    let wall = b.material(support::diffuse(rho), 0.0, Sides::FrontOnly);
    b.room(Vec3::splat(-half), Vec3::splat(half), [wall; 6]);
}

fn down(b: &mut Build, illuminance: f32) {
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::grey(illuminance) });
}

/// Σ over all photons, with the rules of the grid told once more.
fn everything(photons: &[Photon], x: Vec3, n: Vec3, r: f32) -> f64 {
    let near = |p: &&Photon| {
        (p.position - x).length() < r && (p.position - x).dot(n).abs() <= 0.25 * r && p.normal.dot(n) >= 0.7
    };
    let kernel = |p: &Photon| {
        let d2 = f64::from((p.position - x).length_squared()) / f64::from(r * r);
        f64::from(p.flux.r) * 2.0 * (1.0 - d2) / f64::from(PI * r * r)
    };
    photons.iter().filter(near).map(kernel).sum()
}

#[test]
fn the_grid_finds_what_a_sum_over_all_photons_finds() {
    let random = |i: u32, d: u32| sequence::uniform(7, i, d);
    let mut found = 0;
    for (count, size) in [(0, 1.0), (1, 1.0), (3, 0.05), (17, 0.3), (300, 0.5), (5000, 2.0), (20_000, 40.0)] {
        let place = |i: u32| {
            let p = Vec3::new(random(i, 0), 0.02 * random(i, 1), random(i, 2)) * size;
            p - Vec3::splat(0.4 * size) + Vec3::new(0.0, if i.is_multiple_of(3) { 0.3 } else { 0.0 }, 0.0)
        };
        let photons: Vec<Photon> = (0..count)
            .map(|i: u32| {
                let normal = if i.is_multiple_of(5) { Vec3::X } else { Vec3::Y };
                let flux = Rgb::grey(random(i, 3));
                Photon { position: place(i), flux, wi: normal, normal, emitter: 0 }
            })
            .collect();
        let corner = Vec3::splat(-0.5 * size);
        for r in [0.01, 0.1, 0.6] {
            let grid = Grid::new(photons.clone(), corner, r);
            for i in 0..400 {
                // Around photons, and anywhere.
                let jump = Vec3::new(random(i, 8) - 0.5, 0.1 * random(i, 9), random(i, 10) - 0.5) * (2.0 * r);
                let x = if i.is_multiple_of(2) { place(i * 7) + jump } else { place(i + count) };
                let n = if i.is_multiple_of(4) { Vec3::X } else { Vec3::Y };
                let (one, all) = (f64::from(light(&grid, x, n).r), everything(&photons, x, n, r));
                // A photon at the very rim may fall to either side of the cut.
                let rounding = 1e-4 * all + 1e-4 / f64::from(r * r);
                assert!((one - all).abs() <= rounding, "{count} photons, r = {r}: {one} for {all} at {x}");
                found += u32::from(all > 0.0);
            }
        }
    }
    assert!(found > 2000, "only {found} queries found anything");
}

/// ∫ k(d/r)/(πr²) dA = 1 on a plane, and the radiance of a white surface is that of its illuminance.
#[test]
fn the_kernel_integrates_to_one() {
    const STEPS: u32 = 400;
    let n = Vec3::new(0.3, 0.8, -0.5).normalize();
    let frame = lampyris::geometry::Frame::new(n);
    let (r, position) = (0.3, Vec3::new(4.0, -2.0, 1.0));
    let photon = Photon { position, flux: Rgb::WHITE, wi: n, normal: n, emitter: 0 };
    let grid = Grid::new(vec![photon], position, r);
    let step = 2.4 * r / STEPS as f32;
    let at = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| (k as f32 + 0.5) * step - 1.2 * r);
        position + frame.s * x + frame.t * y
    };
    let cells = (0..STEPS * STEPS).map(|k| light(&grid, at(k / STEPS, k % STEPS), n).r);
    let integral: f64 = cells.map(|e| f64::from(e * step * step)).sum();
    close("kernel", integral, 1.0, 2e-4);
    assert!(light(&grid, position, -n).is_black() && light(&grid, position + n * r, n).is_black());
}

/// Parallel light through a pane: (1 − R)/(1 + R) of it lies below, with R = 0.04. The rest is reflected by what counts
/// as a planar mirror.
#[test]
fn a_pane_lets_pass_what_it_must() {
    let mut b = Build::default();
    // So dark that light comes once only.
    walls(&mut b, 2.0, 0.01);
    let clear = b.material(pane(), 0.0, Sides::Both);
    b.quad(Vec3::new(-0.7, 0.0, -0.5), Vec3::Z, Vec3::X * 1.4, clear);
    down(&mut b, 10.0);
    let world = World::new(b.0);
    let photons = map(&world, 1 << 16, 1, 0).near;
    let passed = 0.96 / 1.04;
    let below = |p: &&Photon| p.position.y < -1.9;
    // The pane fills a known part of the disc that photons start on.
    close("below", flux(photons.photons().iter().filter(below)), 14.0 * passed, 0.01);
    // From above through the pane, and from the side.
    for (x, seen) in [(0.0, passed), (1.5, 1.0)] {
        let eye = view(Vec3::new(x, 1.0, 0.0), Vec3::new(0.0, -2.0, 0.0), 10.0, 16, 12);
        let s = Settings { photons: 1 << 16, ..settings(&["caustic"], 16, 16, 1) };
        let picture = render(world.scene(), eye, &s, 2);
        let mean = picture.iter().map(|c| f64::from(c.r)).sum::<f64>() / picture.len() as f64;
        close("picture", mean, 0.01 * 10.0 * passed * seen / f64::from(PI), 0.01);
    }
}

/// Clear glass keeps no light: what meets a ball leaves it, however often it is reflected inside.
#[test]
fn a_ball_of_clear_glass_passes_all_light_on() {
    let mut b = Build::default();
    walls(&mut b, 3.0, 0.5);
    let clear = b.material(glass(), 0.0, Sides::Both);
    let mesh = b.sphere(Vec3::new(0.3, 0.2, 0.1), 0.8, 3, false, |_| clear);
    let shadow: f64 = (mesh.triangles.iter())
        .map(|t| {
            let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
            0.5 * f64::from((b - a).cross(c - a).y).max(0.0)
        })
        .sum();
    down(&mut b, 5.0);
    let world = World::new(b.0);
    close("ball", flux(map(&world, 1 << 16, 1, 0).near.photons()), 5.0 * shadow, 0.01);
}

/// Bodies whose spheres overlap: each photon counts for the body that it meets first, so the light is that on all of them
/// together and no more. What the first pane reflects is the part *mirror*; what it lets pass must come out somewhere.
#[test]
fn overlapping_cones_count_once() {
    let mut b = Build::default();
    walls(&mut b, 2.0, 0.5);
    let clear = b.material(pane(), 0.0, Sides::Both);
    b.quad(Vec3::new(-0.75, 0.0, -0.5), Vec3::Z, Vec3::X, clear);
    b.quad(Vec3::new(-0.25, 0.1, -0.5), Vec3::Z, Vec3::X, clear);
    b.quad(Vec3::new(-0.25, 0.2, -0.5), Vec3::Z, Vec3::X * 0.5, clear);
    down(&mut b, 10.0);
    let world = World::new(b.0);
    assert_eq!(world.bodies().all().len(), 3);
    let expected = 15.0 * 0.96 / 1.04;
    close_mean("three panes", 8, expected, 0.01, |seed| flux(map(&world, 1 << 16, seed, 0).near.photons()));
}

/// Every kind of light, far and near: photons carry what plain particles of that light bring to the bodies first.
#[test]
fn photons_carry_the_light_of_every_kind_of_lamp() {
    let bodies = |b: &mut Build| {
        let mirror = b.material(gloss(0.0, 1.0, 0.0), 0.0, Sides::Both);
        b.sphere(Vec3::new(-0.8, -0.4, 0.2), 0.7, 2, false, |_| mirror);
        b.sphere(Vec3::new(0.9, -0.6, -0.5), 0.3, 2, false, |_| mirror);
        // Around some of the lamps.
        b.quad(Vec3::new(-1.6, 1.4, -1.5), Vec3::new(0.3, 0.0, 3.0), Vec3::new(3.0, 0.4, 0.0), mirror);
    };
    let at = Vec3::new(0.3, 0.9, 0.4);
    let aim = (Vec3::new(-0.8, -0.4, 0.2) - at).normalize();
    let grey = Rgb::grey;
    let lamps = [
        LightKind::Point { position: at, intensity: grey(3.0) },
        LightKind::Spot {
            position: at,
            direction: aim,
            intensity: grey(9.0),
            beam: Beam::Cone { cos_inner: 0.97, cos_outer: 0.9 },
        },
        LightKind::Spot {
            position: at,
            direction: Vec3::NEG_Y,
            intensity: grey(9.0),
            beam: Beam::Cosine { exponent: 3.0 },
        },
        LightKind::Directional { direction: Vec3::new(0.48, -0.8, 0.36), illuminance: grey(2.0) },
        LightKind::Sphere { center: at, radius: 0.4, radiance: grey(2.0) },
        LightKind::Disc { center: at, normal: aim, radius: 0.5, radiance: grey(2.0) },
    ];
    let mut scenes: Vec<(String, Build)> = Vec::new();
    for lamp in lamps {
        let mut b = Build::default();
        b.light(lamp.clone());
        scenes.push((format!("{lamp:?}"), b));
    }
    let mut panel = Build::default();
    let glow = panel.material(support::diffuse(0.5), 3.0, Sides::EmitFront);
    panel.quad(Vec3::new(-0.5, 1.0, -0.5), Vec3::X, Vec3::Z, glow);
    scenes.push(("panel".into(), panel));
    let mut sky = Build::default();
    sky.0.environment = grey(1.0);
    scenes.push(("sky".into(), sky));
    for (name, mut b) in scenes {
        bodies(&mut b);
        walls(&mut b, 2.5, 0.5);
        let world = World::new(b.0);
        let particles = |seed: u32| {
            let lands = |i: u32| {
                let u = [0, 1, 2, 3].map(|d| sequence::sobol::sobol_owen(i, d, seed + 77));
                let start = world.emitters()[0].emit(u, world.bounds());
                let met = world.closest(&Ray::new(start.origin, start.direction));
                met.and_then(|y| world.bodies().of(&y)).map_or(0.0, |_| f64::from(start.flux.luminance()))
            };
            (0..1 << 13).map(lands).sum::<f64>() / f64::from(1 << 13)
        };
        let truth: Moments = (0..8).map(particles).collect();
        let photons: Moments = (0..8)
            .map(|seed| {
                // Light over one planar mirror is left out; a ray tells how much that is.
                let all = map(&world, 1 << 12, seed, 0);
                flux(all.near.photons()) + folded(&world, seed)
            })
            .collect();
        let noise = (truth.standard_error() + photons.standard_error()) / truth.mean();
        let p = photons.p_value_against(&truth);
        say(format_args!("{name}: {:.4} for {:.4}, noise {noise:.1e}", photons.mean(), truth.mean()));
        assert!(p > 1e-3 && noise < 0.02, "{name}: {} for {}, p = {p}", photons.mean(), truth.mean());
    }
}

/// Light of the first emitter that the part *mirror* takes: its first hit is a planar mirror and its second is dull.
fn folded(world: &World, seed: u32) -> f64 {
    let lands = |i: u32| {
        let u = [0, 1, 2, 3].map(|d| sequence::sobol::sobol_owen(i, d, seed + 1077));
        let start = world.emitters()[0].emit(u, world.bounds());
        let first = world.closest(&Ray::new(start.origin, start.direction)).filter(|y| y.mirror.is_some());
        let second = first.and_then(|y| {
            let (direction, _) = y.mirrored();
            world.closest(&Ray::new(y.spawn(direction), direction))
        });
        let dull = second.is_some_and(|y| world.bodies().of(&y).is_none());
        if dull { f64::from(start.flux.luminance()) } else { 0.0 }
    };
    (0..1 << 13).map(lands).sum::<f64>() / f64::from(1 << 13)
}

/// A lamp in a room with a glass ball and a gold band.
fn still_life() -> Build {
    let mut b = Build::default();
    let wall = b.grey(0.6);
    let clear = b.material(glass(), 0.0, Sides::Both);
    let gold = b.material(gloss(0.0, 0.75, 0.01), 0.0, Sides::Both);
    b.room(Vec3::new(-1.5, 0.0, -1.5), Vec3::new(1.5, 2.5, 1.5), [wall; 6]);
    b.sphere(Vec3::new(0.5, 0.6, -0.2), 0.4, 3, false, |_| clear);
    const STEPS: u32 = 24;
    for k in 0..STEPS {
        let corner = |k: u32| {
            let (sin, cos) = libm::sincosf(TAU * k as f32 / STEPS as f32);
            Vec3::new(-0.6 + 0.4 * cos, 0.01, 0.3 + 0.4 * sin)
        };
        b.quad(corner(k), corner(k + 1) - corner(k), Vec3::Y * 0.25, gold);
    }
    let glow = b.material(support::diffuse(0.4), 10.0, Sides::EmitFront);
    b.quad(Vec3::new(-1.4, 2.49, -1.4), Vec3::X * 2.8, Vec3::Z * 2.8, glow);
    b
}

/// The light of the caustic is the oracle's, which has meters all over the floor: by the flux of the photons there, which
/// needs no kernel, and by the estimate of density.
#[test]
fn the_light_of_the_caustic_is_the_oracles() {
    let b = still_life();
    let world = World::new(b.0.clone());
    const METERS: u32 = 1 << 13;
    let oracle = settings(&["caustic-path"], 1, 1 << 6, 0);
    let meters = |seed| -> Vec<_> {
        let at = |[u, v]: [f32; 2]| meter(Vec3::new(3.0 * u - 1.5, 1e-4, 3.0 * v - 1.5), Vec3::Y);
        (0..METERS).map(|i| at(spread(i, seed))).collect()
    };
    let floor = |p: &&Photon| p.position.y < 1e-3 && p.normal.y > 0.9;
    let on_floor = |photons: &Photons| {
        flux(photons.near.photons().iter().filter(floor)) + flux(photons.far.photons().iter().filter(floor))
    };
    let truth = |seed| lux(&b.0, &meters(seed), &Settings { seed, ..oracle.clone() }, 2).iter().sum::<f64>();
    let truth: Moments = (0..8).map(truth).map(|sum| sum * 9.0 / f64::from(METERS)).collect();
    say(format_args!("oracle {:.5} ± {:.1e}", truth.mean(), truth.standard_error() / truth.mean()));
    assert!(3.0 * truth.standard_error() < 0.01 * truth.mean());
    close_mean("flux on the floor", 12, truth.mean(), 0.01, |seed| on_floor(&map(&world, 1 << 16, seed, 0)));

    let estimated = |photons: &Photons, seed: u32| {
        let e = |[u, v]: [f32; 2]| {
            let mut light = [Rgb::BLACK];
            photons.irradiance(Vec3::new(3.0 * u - 1.5, 0.0, 3.0 * v - 1.5), Vec3::Y, &mut light);
            light[0]
        };
        let sum: f64 = (0..4 * METERS).map(|i| f64::from(e(spread(i, seed)).luminance())).sum();
        sum * 9.0 / f64::from(4 * METERS)
    };
    close_mean("estimated on the floor", 12, truth.mean(), 0.01, |seed| {
        estimated(&map(&world, 1 << 16, seed, 0), seed)
    });
}

/// A planar mirror alone has no caustics: its light is the part *mirror*. Two that face each other have, and so has all
/// that does more than a mirror does. The world tells which, so that nobody traces photons in vain.
#[test]
fn light_over_a_single_mirror_is_left_out() {
    let ward = |transmission: f32| {
        Bsdf::Ward(Ward {
            base: Diffuse::opaque(Rgb::grey(0.1)),
            specular: Rgb::grey(0.5),
            alpha: 0.0,
            transmission: Rgb::grey(transmission),
            transmission_alpha: 0.0,
        })
    };
    let metal = |roughness| Bsdf::Pbr(Pbr { metallic: 1.0, roughness, ..Pbr::default() });
    let looking_glass = gloss(0.0, 0.9, 0.0);
    let cases = [
        ("a mirror", looking_glass, support::diffuse(0.5), false),
        ("two mirrors", looking_glass, looking_glass, true),
        ("a painted mirror", ward(0.0), support::diffuse(0.5), false),
        ("a mirror that lets pass", ward(0.3), support::diffuse(0.5), true),
        ("metal", metal(0.0), metal(0.6), false),
        ("brushed metal", metal(0.2), metal(0.6), true),
        ("a mirror and polish", looking_glass, gloss(0.2, 0.3, 0.05), true),
        ("a mirror and gloss", looking_glass, gloss(0.2, 0.3, 0.3), false),
        ("polish", gloss(0.2, 0.5, 0.05), support::diffuse(0.5), true),
        ("a mirror and a pane", looking_glass, pane(), true),
        ("a pane", pane(), support::diffuse(0.5), true),
        ("nothing sharp", support::diffuse(0.5), gloss(0.2, 0.3, 0.3), false),
    ];
    for (name, first, second, any) in cases {
        let mut b = Build::default();
        let wall = b.grey(0.5);
        let [first, second] = [first, second].map(|bsdf| b.material(bsdf, 0.0, Sides::Both));
        // Around the panes, which let light out.
        b.room(Vec3::splat(-1.0), Vec3::splat(3.0), [wall; 6]);
        b.room(Vec3::ZERO, Vec3::splat(2.0), [first, second, wall, wall, wall, wall]);
        b.bulb(Vec3::new(0.7, 1.2, 0.9), 10.0);
        let world = World::new(b.0);
        assert_eq!(world.bodies().make_caustics(), any, "{name}");
        let photons = map(&world, 1 << 12, 1, 0);
        assert_eq!(photons.near.photons().is_empty(), !any, "{name}");
        assert_eq!(photons.far.photons().is_empty(), !any, "{name}");
    }
}

/// Nor does a photon's place in the list depend on who traced it.
#[test]
fn photons_do_not_depend_on_threads() {
    let world = World::new(still_life().0);
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let all = pool.install(|| map(&world, 1 << 14, 3, 1));
        assert!(all.near.photons().len().min(all.far.photons().len()) > 1000);
        let photons = all.near.photons().iter().chain(all.far.photons());
        photons
            .flat_map(|p| {
                let (a, b, c, d) =
                    (p.position.to_array(), p.flux.to_array(), p.wi.to_array(), p.normal.to_array());
                [a, b, c, d].concat().into_iter().map(f32::to_bits).chain([p.emitter])
            })
            .collect::<Vec<u32>>()
    };
    let one = bits(1);
    assert!([2, 3, 7].iter().all(|threads| bits(*threads) == one));
}

/// A photon's number is its own light's: to move one light changes no photon of the others.
#[test]
fn lights_do_not_disturb_each_other() {
    let photons_of_the_second = |first: Vec3| {
        let mut b = still_life();
        b.bulb(first, 20.0);
        b.bulb(Vec3::new(-0.4, 1.2, 0.2), 30.0);
        let world = World::new(b.0);
        assert_eq!(world.emitters().len(), 3);
        let all = map(&world, 1 << 13, 3, 2);
        [all.near, all.far].map(|grid| {
            let of = grid.photons().iter().filter(|p| p.emitter == 1);
            let bits = |p: &Photon| {
                let [x, y, z] = p.position.to_array().map(f32::to_bits);
                [x, y, z, p.flux.r.to_bits(), p.flux.g.to_bits()]
            };
            let mut all: Vec<_> = of.map(bits).collect();
            all.sort_unstable();
            all
        })
    };
    let [near, far] = photons_of_the_second(Vec3::new(1.0, 1.0, 1.0));
    assert!(near.len() > 100 && far.len() > 100, "{} and {} photons", near.len(), far.len());
    assert_eq!([near, far], photons_of_the_second(Vec3::new(-1.0, 2.0, 0.5)));
}

/// r²ᵢ₊₁ = r²ᵢ (i + ⅔)/(i + 1) within each of the randomisations.
#[test]
fn radii_shrink_as_they_must() {
    let world = World::new(still_life().0);
    let radius = |index| map(&world, 16, 0, index).near.radius();
    let replicates = Settings::default().replicates;
    let mut expected = f64::from(radius(0)).powi(2);
    for i in 1..40 {
        expected *= (f64::from(i) + 2.0 / 3.0) / f64::from(i + 1);
        for replicate in [0, replicates - 1] {
            let r = f64::from(radius(i * replicates + replicate));
            close("r²", r * r, expected, 1e-5);
        }
    }
    assert!(radius(u32::MAX) > 0.0);
}
