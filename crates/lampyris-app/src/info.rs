//! `lampyris info`: what is in a scene, in figures.

use crate::cli::InfoArgs;
use crate::failure::Failure;
use crate::{say, scene_file};
use glam::Vec3;
use lampyris::light::{Beam, LightKind};
use lampyris::material::Sides;
use lampyris::scene::{Scene, upward};
use serde::Serialize;
use std::f64::consts::PI;
use std::process::ExitCode;

#[derive(Serialize)]
struct Figures {
    triangles: u64,
    instances: usize,
    materials: usize,
    /// Emitting instances and light sources that are no surfaces.
    lights: u64,
    /// Luminous flux of all light sources, from every side that emits [lm].
    power_lm: f64,
    /// The same with one side of each surface [lm].
    power_lm_front: f64,
    /// Lower and upper corner of the surfaces [m]; null where there is none.
    bounds: Option<[[f32; 3]; 2]>,
    up: [f32; 3],
    cameras: Vec<String>,
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
    let mut f = Figures {
        triangles: 0,
        instances: scene.instances.len(),
        materials: scene.materials.len(),
        lights: scene.lights.len() as u64,
        power_lm: 0.0,
        power_lm_front: 0.0,
        bounds: None,
        up: upward(scene).into(),
        cameras: scene.cameras.iter().map(|c| c.name.clone()).collect(),
        warnings,
    };
    let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for instance in &scene.instances {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else { continue };
        let mut glows = false;
        for (k, triangle) in mesh.triangles.iter().enumerate() {
            f.triangles += 1;
            let corner =
                |i: u32| mesh.positions.get(i as usize).map(|&p| instance.transform.transform_point3(p));
            let [Some(a), Some(b), Some(c)] = triangle.map(corner) else { continue };
            lo = lo.min(a).min(b).min(c);
            hi = hi.max(a).max(b).max(c);
            let material = mesh.materials.get(k).and_then(|&m| scene.materials.get(m as usize));
            if let Some(m) = material.filter(|m| !m.emission.is_black()) {
                glows = true;
                // M = π L of a Lambertian emitter.
                let side =
                    PI * f64::from(m.emission.luminance()) * f64::from((b - a).cross(c - a).length() * 0.5);
                f.power_lm_front += side;
                f.power_lm += if m.sides == Sides::Both { 2.0 * side } else { side };
            }
        }
        f.lights += u64::from(glows);
    }
    let sources: f64 = scene.lights.iter().map(|l| power(&l.kind)).sum();
    f.power_lm += sources;
    f.power_lm_front += sources;
    f.bounds = (lo.is_finite() && hi.is_finite()).then(|| [lo.into(), hi.into()]);
    f
}

/// Luminous flux of a light source [lm]; a directional one has none of its own.
fn power(light: &LightKind) -> f64 {
    let (factor, value) = match light {
        LightKind::Point { intensity, .. } => (4.0 * PI, intensity),
        LightKind::Spot { intensity, beam, .. } => (2.0 * PI * profile(beam), intensity),
        LightKind::Directional { illuminance, .. } => (0.0, illuminance),
        LightKind::Sphere { radius, radiance, .. } => (4.0 * PI * PI * f64::from(*radius).powi(2), radiance),
        LightKind::Disc { radius, radiance, .. } => (PI * PI * f64::from(*radius).powi(2), radiance),
    };
    factor * f64::from(value.luminance())
}

/// ∫ profile d(cos θ): what a beam sends of 2π times the intensity on its axis.
fn profile(beam: &Beam) -> f64 {
    match *beam {
        // The square of a linear ramp has a third of its base.
        Beam::Cone { cos_inner, cos_outer } => {
            1.0 - f64::from(cos_inner) + f64::from(cos_inner - cos_outer) / 3.0
        }
        Beam::Cosine { exponent } => 1.0 / (f64::from(exponent) + 1.0),
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
