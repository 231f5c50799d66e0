//! How long a mix of light groups takes, and a lamp that moves:
//! `cargo run --release --example time_mix -- scenes/conference.mgf 16`.
//!
//! A session of 1920 × 1080 pixels, and one of 640 × 480, and as many groups gets some batches; then levels change, and the
//! picture is summed and tone-mapped anew, without a ray; and stills are taken and mixed, with what they cost the next batch. Then sixteen equal point lights hang in the room instead of its own lamps, in 640 × 480
//! pixels, and one of them moves from frame to frame.

use glam::Vec3;
use lampyris::backend::Settings;
use lampyris::light::{Light, LightKind};
use lampyris::output::{Display, Exposure, Picture, display};
use lampyris::scene::{Edit, Scene, find_view};
use lampyris::session::Session;
use lampyris::world::World;
use lampyris::{Error, Rgb, import};
use std::path::Path;
use std::time::Instant;

#[allow(clippy::print_stdout, reason = "a program that prints figures")]
fn main() -> lampyris::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let missing = || Error::BadSetting("give a scene, and how many groups".into());
    let (file, groups) = (arguments.first().ok_or_else(missing)?, arguments.get(1).ok_or_else(missing)?);
    let groups: usize = groups.parse().map_err(|_| missing())?;
    let world = World::new(import::load(Path::new(file), &import::Options::default())?.scene);
    let view = find_view(world.scene(), &|ray| world.tracer().closest(ray), 16.0 / 9.0).camera;
    let bounds = world.bounds();
    let scene = Scene { view: Some(view), ..world.scene().clone() };
    drop(world);

    for size in [[640, 480], [1920, 1080]] {
        mix(&scene, groups, size)?;
    }

    let mut dark = scene;
    dark.materials.iter_mut().for_each(|material| material.emission = Rgb::BLACK);
    (dark.environment, dark.reference) = (Rgb::BLACK, lampyris::scene::Reference::default());
    let lamp = |k: usize, shift: f32| LightKind::Point {
        position: bounds.center
            + Vec3::new((k % 4) as f32 - 1.5 + shift, (k / 4) as f32 - 1.5, 1.0) * (0.15 * bounds.radius),
        intensity: Rgb::grey(50.0),
    };
    dark.lights = (0..16).map(|k| Light::new(format!("lamp {k}"), lamp(k, 0.0))).collect();
    let mut session = Session::open(separated(dark, 16)?, [640, 480], &Settings::interactive(), None)?;
    let all = |session: &Session| {
        let r = session.statistics().rays;
        (r.eye + r.particle + r.shadow + r.compensation) as f64
    };
    let start = Instant::now();
    session.step()?;
    let (first, whole) = (all(&session), 1e3 * start.elapsed().as_secs_f64());
    let mut times = Vec::new();
    for frame in 1..=9 {
        let start = Instant::now();
        session.edit(&Edit::Light { light: 5, kind: lamp(5, 0.02 * frame as f32) })?;
        session.step()?;
        session.frame()?.shown();
        times.push(start.elapsed().as_secs_f64());
    }
    let share = (all(&session) - first) / 9.0 / first;
    let moved = median(times);
    println!(
        "a first frame of {whole:.0} ms; after one of sixteen lamps moved {moved:.0} ms, {share:.3} of its rays"
    );
    Ok(())
}

/// Levels change in a session of that size.
#[allow(clippy::print_stdout, reason = "a program that prints figures")]
fn mix(scene: &Scene, groups: usize, [width, height]: [u32; 2]) -> lampyris::Result<()> {
    let mut session =
        Session::open(separated(scene.clone(), groups)?, [width, height], &Settings::interactive(), None)?;
    let groups = session.world()?.groups();
    session.settle(2)?;
    let rays = session.statistics();
    // As somebody sees it who turns a dimmer: automatic exposure would hide that.
    let locked = Display { exposure: Exposure::Ev(0.0), despeckle: false, ..Display::default() };
    let mut times = [(); 4].map(|()| Vec::new());
    for round in 0..15 {
        let colors: Vec<Rgb> =
            (0..groups as u32).map(|group| Rgb::grey(0.5 + 0.1 * ((round + group) % 5) as f32)).collect();
        for (group, color) in (0..).zip(&colors) {
            session.edit(&Edit::Mix { group, color: *color })?;
        }
        let start = Instant::now();
        let picture = session.frame()?.shown();
        times[0].push(start.elapsed().as_secs_f64());
        display(&Picture::new(width, height, picture), &locked);
        times[1].push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let still = session.frame()?.still();
        times[2].push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        still.mix(&colors);
        times[3].push(start.elapsed().as_secs_f64());
    }
    let traced = session.statistics() != rays;
    let [sum, pixels, take, blend] = times.map(median);
    println!(
        "{width} × {height}: {groups} groups mixed in {sum:.1} ms, to pixels in {pixels:.1} ms; rays traced meanwhile: {traced}; \
         a still taken in {take:.1} ms, mixed in {blend:.1} ms"
    );
    // Batches by turns with and without a still of what was before: it is copied while they are added.
    let mut times = [(); 2].map(|()| Vec::new());
    for round in 0..10 {
        let still = (round % 2 == 1).then_some(session.frame()?.still());
        let start = Instant::now();
        session.step()?;
        times[usize::from(still.is_some())].push(start.elapsed().as_secs_f64());
    }
    let [alone, beside] = times.map(median);
    println!("a batch takes {alone:.0} ms, {beside:.0} ms while somebody holds a still");
    Ok(())
}

fn separated(scene: Scene, groups: usize) -> lampyris::Result<Scene> {
    let mut world = World::new(scene);
    world.separate(groups)?;
    Ok(world.scene().clone())
}

/// [ms] of [s].
fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    1e3 * times[times.len() / 2]
}
