//! `lampyris info`: what is in a scene, in figures.

use crate::cli::InfoArgs;
use crate::failure::Failure;
use crate::play::{lamp_names, object_names};
use crate::{say, scene_file};
use lampyris::light::{Bounds, Emitter};
use lampyris::scene::{Scene, upward};
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
    // Within bounds of no size, light from infinity has no flux.
    let power = |light| f64::from(Emitter::from(light).power(Bounds::default()).luminance());
    let sources: f64 = scene.lights.iter().map(power).sum();
    Figures {
        triangles: sum.triangles,
        instances: scene.instances.len(),
        materials: sum.materials,
        lights: sum.lights,
        power_lm: sum.power_lm + sources,
        power_lm_front: sum.power_lm_front + sources,
        bounds: sum.bounds.map(|corners| corners.map(Into::into)),
        up: upward(scene).into(),
        cameras: scene.cameras.iter().map(|c| c.name.clone()).collect(),
        lamps: lamp_names(scene).into_iter().map(str::to_owned).collect(),
        objects: object_names(scene).into_iter().map(str::to_owned).collect(),
        warnings,
    }
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
