//! `lampyris info`: what is in a scene, in figures.

use crate::cli::InfoArgs;
use crate::failure::Failure;
use crate::play::{lamp_names, object_names};
use crate::{say, scene_file};
use lampyris::light::{Bounds, Emitter};
use lampyris::scene::{Scene, Source, upward};
use lampyris::world::World;
use serde::Serialize;
use std::process::ExitCode;

#[derive(Serialize)]
struct Figures {
    triangles: u64,
    instances: usize,
    materials: usize,
    /// Groups of emitting triangles, and light sources that are no surfaces.
    lights: usize,
    /// Luminous flux of all light sources, from every side that emits [lm]; light from infinity not counted.
    power_lm: f64,
    /// The same with one side of each surface [lm].
    power_lm_front: f64,
    /// Lower and upper corner of the surfaces [m]; null where there is none.
    bounds: Option<[[f32; 3]; 2]>,
    up: [f32; 3],
    cameras: Vec<String>,
    /// Names of what shines and of all objects, each once: a script calls them so.
    lamps: Vec<String>,
    objects: Vec<String>,
    warnings: Vec<String>,
}

/// Prints the figures.
pub(crate) fn info(args: &InfoArgs) -> Result<ExitCode, Failure> {
    let loaded = scene_file::load(&args.scene, args.json)?;
    let figures = figures(&loaded.scene, loaded.warnings);
    if args.json {
        say::json(&figures)?
    } else {
        say::result(&text(&figures))?
    }
    Ok(ExitCode::SUCCESS)
}

fn figures(scene: &Scene, warnings: Vec<String>) -> Figures {
    let sum = scene.summary();
    let power = |light| f64::from(Emitter::from(light).power(Bounds::default()).luminance());
    let sources: f64 = scene.lights.iter().map(power).sum();
    let [both, front] = match mixed_power(scene) {
        Some(mixed) => mixed,
        None => [sum.power_lm + sources, sum.power_lm_front + sources],
    };
    Figures {
        triangles: sum.triangles,
        instances: scene.instances.len(),
        materials: sum.materials,
        lights: sum.lights,
        power_lm: both,
        power_lm_front: front,
        bounds: sum.bounds.map(|corners| corners.map(Into::into)),
        up: upward(scene).into(),
        cameras: scene.cameras.iter().map(|c| c.name.clone()).collect(),
        lamps: lamp_names(scene).into_iter().map(str::to_owned).collect(),
        objects: object_names(scene).into_iter().map(str::to_owned).collect(),
        warnings,
    }
}

/// The power of lamps in groups, each at the level of its group: of all sides, and of fronts [lm]. None without groups.
fn mixed_power(scene: &Scene) -> Option<[f64; 2]> {
    if scene.groups.is_empty() {
        return None;
    }
    let world = World::new(scene.clone());
    let (mix, shares) = (world.mix(), &world.scene().reference.shares);
    let mut sums = [0.0; 2];
    for (emitter, share) in world.emitters().iter().zip(shares) {
        // Within bounds of no size, light from infinity has no flux.
        let power = emitter.power(Bounds::default());
        let power = f64::from((power * mix[usize::from(share.group)]).luminance());
        sums[0] += power;
        sums[1] += if matches!(share.source, Source::Side { back: true, .. }) { 0.0 } else { power };
    }
    Some(sums)
}

fn text(f: &Figures) -> String {
    let bounds = f.bounds.map_or("none".to_string(), |[lo, hi]| format!("{lo:?} to {hi:?} m"));
    let cameras = if f.cameras.is_empty() { "none".to_string() } else { f.cameras.join(", ") };
    format!(
        "triangles  {}\ninstances  {}\nmaterials  {}\nlights     {}\npower      {:.1} lm ({:.1} lm from one side)\n\
         bounds     {bounds}\nup         {:?}\ncameras    {cameras}\n",
        f.triangles, f.instances, f.materials, f.lights, f.power_lm, f.power_lm_front, f.up
    )
}
