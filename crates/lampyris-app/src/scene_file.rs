//! Loading a scene as the arguments say, and passing on what was odd about it.

use crate::cli::{ReadingArgs, SceneArgs};
use crate::failure::Failure;
use crate::progress::Phase;
use crate::say;
use lampyris::Rgb;
use lampyris::import::{self, Limits, Loaded, Options};
use lampyris::scene::{Scene, upward};
use std::path::Path;

/// Loads the scene; warnings go to standard error unless `quiet`.
pub(crate) fn load(args: &SceneArgs, quiet: bool) -> Result<Loaded, Failure> {
    read(&args.file, &args.reading, quiet)
}

/// [`load`] of a file.
pub(crate) fn read(file: &Path, args: &ReadingArgs, quiet: bool) -> Result<Loaded, Failure> {
    let (l, d) = (&args.limits, Limits::default());
    let limits = Limits {
        file_bytes: l.max_file_bytes.unwrap_or(d.file_bytes),
        triangles: l.max_triangles.unwrap_or(d.triangles),
        include_depth: l.max_include_depth.unwrap_or(d.include_depth),
        entities: l.max_entities.unwrap_or(d.entities),
        array: l.max_array.unwrap_or(d.array),
        polygon: l.max_polygon.unwrap_or(d.polygon),
        json_bytes: l.max_json_bytes.unwrap_or(d.json_bytes),
        nodes: l.max_nodes.unwrap_or(d.nodes),
        depth: l.max_depth.unwrap_or(d.depth),
        instances: l.max_instances.unwrap_or(d.instances),
        objects: l.max_objects.unwrap_or(d.objects),
        libraries: l.max_libraries.unwrap_or(d.libraries),
        line_bytes: l.max_line_bytes.unwrap_or(d.line_bytes),
        image_pixels: l.max_image_pixels.unwrap_or(d.image_pixels),
        image_bytes: l.max_image_bytes.unwrap_or(d.image_bytes),
    };
    let options = Options {
        root: args.root.clone(),
        limits,
        circle_steps: args.circle.unwrap_or(import::CIRCLE_STEPS),
    };
    let phase = Phase::begin("reading the scene", quiet);
    let mut loaded = import::load(file, &options)?;
    if let Some(file) = &args.environment {
        // A sky must know what is overhead, and not every format says.
        loaded.scene.up = Some(upward(&loaded.scene));
        loaded.scene.environment = Rgb::grey(args.environment_scale);
        loaded.scene.environment_image = Some(loaded.scene.images.len() as u32);
        loaded.scene.images.push(import::picture(file, &options)?);
    }
    drop(phase);
    if is_dark(&loaded.scene) {
        loaded
            .warnings
            .push("nothing shines: pictures of it are black; give it a sky with --environment".into());
    }
    if !quiet {
        loaded.warnings.iter().for_each(|w| say::note(&format!("warning: {w}")));
    }
    Ok(loaded)
}

/// True if no light, no surface and no sky shines.
fn is_dark(scene: &Scene) -> bool {
    scene.lights.is_empty()
        && scene.environment.is_black()
        && scene.materials.iter().all(|m| m.emission.is_black())
}
