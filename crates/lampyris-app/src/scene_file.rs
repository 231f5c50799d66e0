//! Loading a scene, or a document of one, as the arguments say, and passing on what was odd about it.

use crate::cli::{ReadingArgs, SceneArgs};
use crate::failure::Failure;
use crate::progress::Phase;
use crate::say;
use lampyris::document::{self, Ask, Opened};
use lampyris::import::{self, Limits, Options};
use lampyris::scene::Scene;
use std::path::Path;

/// Loads the scene, or the saved document of one; warnings go to standard error unless `quiet`.
pub(crate) fn load(args: &SceneArgs, quiet: bool) -> Result<Opened, Failure> {
    read(&args.file, &args.reading, quiet)
}

/// [`load`] of a file.
pub(crate) fn read(file: &Path, args: &ReadingArgs, quiet: bool) -> Result<Opened, Failure> {
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
    let ask = Ask {
        options: Options { root: args.root.clone(), limits, circle_steps: import::CIRCLE_STEPS },
        circle: args.circle,
        environment: args.environment.clone().map(|file| (file, args.environment_scale)),
    };
    let phase = Phase::begin("reading the scene", quiet);
    let mut loaded = document::open(file, &ask, document::state_folder().as_deref())?;
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
