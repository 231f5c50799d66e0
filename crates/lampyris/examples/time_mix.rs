//! How long a mix of light groups takes: `cargo run --release --example time_mix -- scenes/conference.mgf 16`.
//!
//! A session of 1920 × 1080 pixels and its groups gets a batch; then levels change, and the picture is summed and tone-mapped
//! anew, without a ray. Then one lamp that is no object moves, if there is one.

use lampyris::backend::Settings;
use lampyris::import;
use lampyris::output::{Display, Exposure, Picture, display};
use lampyris::scene::{Edit, Scene, find_view};
use lampyris::session::Session;
use lampyris::world::World;
use lampyris::{Error, Rgb};
use std::path::Path;
use std::time::Instant;

#[allow(clippy::print_stdout, reason = "a program that prints figures")]
fn main() -> lampyris::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let missing = || Error::BadSetting("give a scene, and how many groups".into());
    let (file, groups) = (arguments.first().ok_or_else(missing)?, arguments.get(1).ok_or_else(missing)?);
    let groups: usize = groups.parse().map_err(|_| missing())?;
    let mut world = World::new(import::load(Path::new(file), &import::Options::default())?.scene);
    world.separate(groups)?;
    let view = find_view(world.scene(), &|ray| world.tracer().closest(ray), 16.0 / 9.0).camera;
    let scene = Scene { view: Some(view), ..world.scene().clone() };
    drop(world);
    let [width, height] = [1920, 1080];
    let mut session = Session::open(scene, [width, height], &Settings::interactive(), None)?;
    let groups = session.world()?.groups();
    session.settle(2)?;
    let rays = session.statistics();
    // As somebody sees it who turns a dimmer: automatic exposure would hide that.
    let locked = Display { exposure: Exposure::Ev(0.0), despeckle: false, ..Display::default() };
    let mut times = [(); 2].map(|()| Vec::new());
    for round in 0..15 {
        for group in 0..groups as u16 {
            let color = Rgb::grey(0.5 + 0.1 * ((round + u32::from(group)) % 5) as f32);
            session.edit(&Edit::Mix { group, color })?;
        }
        let start = Instant::now();
        let picture = session.frame()?.shown();
        times[0].push(start.elapsed().as_secs_f64());
        display(&Picture::new(width, height, picture), &locked);
        times[1].push(start.elapsed().as_secs_f64());
    }
    let [sum, pixels] = times.map(|mut t| {
        t.sort_by(f64::total_cmp);
        1e3 * t[t.len() / 2]
    });
    let traced = session.statistics() != rays;
    println!(
        "{groups} groups mixed in {sum:.1} ms, to pixels in {pixels:.1} ms; rays traced meanwhile: {traced}"
    );
    Ok(())
}
