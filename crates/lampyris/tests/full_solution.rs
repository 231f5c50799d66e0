//! The full solution of 1996: emission, direct light, final gathering, mirrors and caustics. Where light is as even as an element
//! it is exact; elsewhere its bias is small, and smaller with smaller elements.

mod support;

use glam::Vec3;
use lampyris::backend::{Backend, Batch, Gather, Settings, Source};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::integrator::{FULL_SOLUTION, select};
use lampyris::material::{Bsdf, Diffuse, Sides};
use lampyris::world::World;
use lampyris::{Error, Rgb};
use support::{Build, FAST, diffuse, glass, gloss, lux, meter, render, say, settings, spread, view};

/// The full solution by elements of a size [m].
fn full(rays: u32, paths: u32, element: f32) -> Settings {
    Settings {
        gather: Gather { rays, paths, element, ..Gather::default() },
        ..settings(FULL_SOLUTION, 256, 4, 7)
    }
}

/// Walls that emit ¼ and reflect half look ½ everywhere, and reflect ⅛ of what others reflect: whatever the elements are, of a
/// light that is the same in all of them nothing is lost, but for the noise of the particles and of the rays that find them.
#[test]
fn a_furnace_is_even() {
    let mut b = Build::default();
    let wall = b.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    for element in [f32::INFINITY, 0.2] {
        let eye = view(Vec3::splat(0.8), Vec3::splat(0.1), 60.0, 16, 12);
        let gathered = Settings { parts: vec!["final-gather".into()], ..full(16, 1 << 14, element) };
        let picture = render(&b.0, eye, &gathered, 4);
        let mean = picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>() / picture.len() as f64;
        assert!((mean - 0.125).abs() < 6e-4, "{mean} by elements of {element} m");
        let worst = picture.iter().map(|c| (c.luminance() - 0.125).abs()).fold(0.0, f32::max);
        assert!(worst < 0.005, "{worst} by elements of {element} m");
    }
    // A meter lets all of it count, near an edge too.
    let at = [meter(Vec3::splat(0.5), Vec3::X), meter(Vec3::new(0.01, 0.5, 0.02), Vec3::Y)];
    let gathered = Settings { parts: vec!["final-gather".into()], ..full(64, 1 << 14, 0.5) };
    for lux in lux(&b.0, &at, &gathered, 4) {
        assert!((lux / (0.25 * std::f64::consts::PI) - 1.0).abs() < 0.01, "{lux}");
    }
}

/// A room of 4 × 3 × 4 m with a block, a red wall and a varnished floor, and a panel under the ceiling.
fn room() -> Build {
    let mut b = Build::default();
    let (white, dark) = (b.grey(0.7), b.grey(0.3));
    let red = Bsdf::Diffuse(Diffuse::opaque(Rgb::new(0.6, 0.1, 0.05)));
    let red = b.material(red, 0.0, Sides::Both);
    let floor = b.material(gloss(0.3, 0.05, 0.05), 0.0, Sides::Both);
    b.room(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 3.0, 2.0), [red, white, floor, white, white, dark]);
    b.block(Vec3::new(0.1, 0.0, -1.2), Vec3::new(1.1, 1.2, -0.2), white);
    let lamp = b.glow(20.0);
    b.quad(Vec3::new(-0.5, 2.9, -0.5), Vec3::X, Vec3::Z, lamp);
    b
}

const SIZE: [u32; 2] = [64, 48];
const TILE: u32 = 16;

/// Luminance of tiles of 16 × 16 pixels.
fn tiles(build: &Build, settings: &Settings, batches: u32) -> Vec<f64> {
    let eye = view(Vec3::new(0.3, 1.6, 1.9), Vec3::new(0.0, 1.1, -1.0), 60.0, SIZE[0], SIZE[1]);
    let picture = render(&build.0, eye, settings, batches);
    let tile = |(left, top): (u32, u32)| {
        let pixels = (0..TILE * TILE).map(|k| (top + k / TILE) * SIZE[0] + left + k % TILE);
        pixels.map(|k| f64::from(picture[k as usize].luminance())).sum::<f64>()
    };
    let corners = (0..SIZE[1]).step_by(16).flat_map(|y| (0..SIZE[0]).step_by(16).map(move |x| (x, y)));
    corners.map(tile).collect()
}

/// How far tiles are off in the mean, and in the mean square.
fn deviation(what: &str, own: &[f64], truth: &[f64]) -> (f64, f64) {
    let off: Vec<f64> = own.iter().zip(truth).map(|(own, truth)| own / truth - 1.0).collect();
    let rms = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
    let mean = own.iter().sum::<f64>() / truth.iter().sum::<f64>() - 1.0;
    let (least, most) = off.iter().fold((0.0_f64, 0.0_f64), |(l, m), off| (l.min(*off), m.max(*off)));
    say(format_args!(
        "{what}: mean {:+.2} %, tiles {:+.2} to {:+.2} %, in the mean square {:.2} %",
        100.0 * mean,
        100.0 * least,
        100.0 * most,
        100.0 * rms
    ));
    (mean, rms)
}

/// The mean is right to 1 % with elements of 0.3 m, and the bias of tiles of 16 × 16 pixels falls as elements are halved.
#[test]
fn the_bias_is_that_of_elements() {
    let room = room();
    let truth = tiles(&room, &settings(FAST, 512, 32, 1), 8);
    let biases = [1.2, 0.6, 0.3].map(|element| {
        let own = tiles(&room, &full(16, 1 << 15, element), 8);
        deviation(&format!("by elements of {element} m"), &own, &truth)
    });
    let [coarse, middle, fine] = biases;
    assert!(fine.0.abs() < 0.01, "{}", fine.0);
    assert!(fine.1 < middle.1 && middle.1 < coarse.1, "{biases:?}");
}

/// By photons a disc that reaches over the edge of its surface finds less: on a wall of a unit cube a strip along each edge loses
/// (2/3π) r in the mean, so that walls look darker by 4 (2/3π) r to meters all over the walls, which see each place of them
/// alike; and that is all, also where a disc holds an eighth of a photon.
#[test]
fn photons_lose_light_at_edges_alone() {
    let mut b = Build::default();
    let wall = b.material(diffuse(0.5), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    let at = |k: u32| {
        let [u, v] = spread(k / 6, k % 6);
        let (axis, side) = (k as usize % 3, if k % 6 < 3 { 1.0 } else { -1.0 });
        let mut place = Vec3::ZERO;
        (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (u, v);
        place[axis] = 0.5 - side * 0.4999;
        meter(place, Vec3::AXES[axis] * side)
    };
    let meters: Vec<_> = (0..6 * 64).map(at).collect();
    for (radius, paths, batches) in [(0.2, 1 << 16, 4), (0.05, 1 << 16, 4), (0.05, 1 << 10, 256)] {
        let gather = Gather { rays: 4, paths, source: Source::Photons, radius, ..Gather::default() };
        let parts = vec!["final-gather".into()];
        let all = lux(&b.0, &meters, &Settings { parts, gather, ..full(1, 1, 1.0) }, batches);
        let mean = all.iter().sum::<f64>() / all.len() as f64 / (0.25 * std::f64::consts::PI);
        // Of the radii of the cube, half its diagonal, a quarter.
        let r = f64::from(radius) * 0.25 * 0.75_f64.sqrt();
        let expected = 1.0 - 8.0 / (3.0 * std::f64::consts::PI) * r;
        say(format_args!("r = {r:.4} m, {paths} paths: {mean:.4} of all, expected {expected:.4}"));
        assert!((mean - expected).abs() < 0.003, "{mean} by photons within {r} m");
    }
}

/// The mean is right to 1 % by photons of the default radius, and the bias of tiles of 16 × 16 pixels falls as the radius shrinks
/// and photons are more.
#[test]
fn the_bias_is_that_of_the_radius() {
    let room = room();
    let truth = tiles(&room, &settings(FAST, 512, 32, 1), 16);
    let by = |(radius, paths)| {
        let gather = Gather { radius, paths, source: Source::Photons, ..Gather::default() };
        deviation(
            &format!("within {radius}/4"),
            &tiles(&room, &Settings { gather, ..full(16, 1, 1.0) }, 8),
            &truth,
        )
    };
    let [wide, middle, narrow] = [(0.32, 1 << 13), (0.16, 1 << 14), (0.08, 1 << 15)].map(by);
    assert!(narrow.1 < 0.7 * middle.1 && middle.1 < 0.7 * wide.1, "{wide:?} {middle:?} {narrow:?}");
    let usual = by((Gather::default().radius, Gather::default().paths));
    assert!(usual.0.abs() < 0.01 && usual.1 < narrow.1, "{usual:?}");
}

/// Light groups have photons of their own: their layers add up to what all lamps give together.
#[test]
fn groups_of_photons_add_up() {
    let mut b = room();
    b.bulb(Vec3::new(1.2, 2.2, 1.0), 300.0);
    let gather = Gather { source: Source::Photons, ..Gather::default() };
    let by = Settings { gather, parts: vec!["final-gather".into()], ..full(16, 1, 1.0) };
    let whole = tiles(&b, &by, 8);
    let mut world = World::new(b.0);
    world.separate(4).expect("groups");
    assert!(world.groups() > 1);
    let apart = tiles(&Build(world.scene().clone()), &by, 8);
    let (mean, rms) = deviation("of groups", &apart, &whole);
    assert!(mean.abs() < 0.002 && rms < 0.01, "{mean}, {rms}");
}

/// In a furnace gloss sees ½ everywhere as well, by photons of a fixed radius: away from edges all of it, however many glossy
/// surfaces are one behind the other. Where walls meet, a ball around a point holds less than a disc of surface, or more.
#[test]
fn gloss_is_lit_by_photons() {
    let mut b = Build::default();
    let wall = b.material(gloss(0.3, 0.2, 0.3), 0.25, Sides::FrontOnly);
    b.room(Vec3::ZERO, Vec3::ONE, [wall; 6]);
    let eye = || view(Vec3::splat(0.5), Vec3::new(0.5, 0.1, 0.45), 60.0, 16, 12);
    let picture = |parts: &[&str], gather: Gather| {
        let parts = parts.iter().map(|part| (*part).into()).collect();
        let picture = render(&b.0, eye(), &Settings { parts, gather, ..full(1, 1, 1.0) }, 8);
        picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>() / picture.len() as f64
    };
    let truth = picture(&["vpl", "compensation"], Gather::default());
    for levels in [1, 2, 3] {
        let gather = Gather { rays: 32, paths: 1 << 15, radius: 0.02, levels, ..Gather::default() };
        let own = picture(&["final-gather"], gather);
        say(format_args!("{levels} levels: {own} {truth}"));
        assert!((own / truth - 1.0).abs() < 0.02, "{levels} levels: {own} {truth}");
    }
}

/// Elements, photons for gloss and photons of caustics are left by one walk: whoever wants caustics has walked the paths that
/// lit the elements, and traces not a ray more for them.
#[test]
fn one_walk_lights_all() {
    let mut b = room();
    let clear = b.material(glass(), 0.0, Sides::Both);
    b.sphere(Vec3::new(-0.8, 0.5, 0.3), 0.4, 2, false, |_| clear);
    let rays = |parts: &[&str]| {
        let mut cpu = Cpu::new(None).unwrap();
        let eye = view(Vec3::new(0.3, 1.6, 1.9), Vec3::new(0.0, 1.1, -1.0), 60.0, 4, 3);
        cpu.begin(b.0.clone(), eye, &settings(parts, 4, 1, 7)).unwrap();
        cpu.add(Batch { index: 0 }).unwrap();
        cpu.statistics().rays.particle
    };
    let (all, caustics) = (rays(FULL_SOLUTION), rays(&["caustic-map"]));
    let (gathered, nothing) = (rays(&["final-gather"]), rays(&["direct"]));
    say(format_args!(
        "{all} for all, {caustics} for caustics, {gathered} to gather, {nothing} for direct light"
    ));
    assert_eq!(all, caustics);
    assert!(gathered < all && nothing + (1 << 15) < gathered);
}

/// A glass ball and a mirror in a room: light that photons of one radius bring to the floor is that of the parts *mirror* and
/// *caustic*, whose radii shrink, to 1 %.
#[test]
fn caustics_keep_their_energy() {
    let mut b = Build::default();
    let (wall, floor) = (b.grey(0.5), b.grey(0.8));
    let clear = b.material(glass(), 0.0, Sides::Both);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    b.room(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 3.0, 2.0), [wall, wall, floor, wall, mirror, wall]);
    b.sphere(Vec3::new(0.0, 0.8, 0.0), 0.5, 3, false, |_| clear);
    let lamp = b.glow(30.0);
    b.quad(Vec3::new(-0.5, 2.9, -0.5), Vec3::X, Vec3::Z, lamp);
    let picture = |parts: &[&str], batches: u32| {
        let eye = view(Vec3::new(0.3, 2.6, 1.9), Vec3::new(0.0, 0.0, -0.3), 60.0, 48, 36);
        let s =
            Settings { gather: Gather { radius: 0.01, ..Gather::default() }, ..settings(parts, 64, 4, 3) };
        let picture = render(&b.0, eye, &s, batches);
        picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>()
    };
    let truth = picture(&["mirror", "caustic"], 24);
    let own = picture(&["caustic-map"], 24);
    say(format_args!("{own} {truth}: {:+.2} %", 100.0 * (own / truth - 1.0)));
    assert!((own / truth - 1.0).abs() < 0.01, "{own} {truth}");
}

/// Parts that find the same light exclude each other, and settings that make no sense are refused with the mend.
#[test]
fn no_path_is_counted_twice() {
    for part in ["vpl", "compensation", "cut-off", "path"] {
        let refused = select(&["final-gather", part]).err();
        assert!(matches!(refused, Some(Error::BadSetting(why)) if why.contains(part)), "{part}");
    }
    for part in ["mirror", "caustic", "caustic-path", "path"] {
        let refused = select(&["caustic-map", part]).err();
        assert!(matches!(refused, Some(Error::BadSetting(why)) if why.contains(part)), "{part}");
    }
    assert!(select(&["final-gather", "caustic-path"]).is_ok());
    let bad = Gather { element: -1.0, ..Gather::default() };
    let refused = Settings { gather: bad, ..full(1, 1, 1.0) }.check();
    assert!(matches!(refused, Err(Error::BadSetting(_))), "{refused:?}");
    let tiny = Settings { gather: Gather { element: 1e-5, ..Gather::default() }, ..full(1, 1, 1.0) };
    let mut cpu = Cpu::new(None).unwrap();
    let eye = Eye::Meters(vec![meter(Vec3::ONE, Vec3::Y)]);
    let refused = cpu.begin(room().0, eye, &tiny);
    assert!(matches!(refused, Err(Error::BadSetting(why)) if why.contains("larger")));
}
