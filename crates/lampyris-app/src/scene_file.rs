//! Loading a scene as the arguments say, and passing on what was odd about it.

use crate::cli::SceneArgs;
use crate::failure::Failure;
use crate::say;
use lampyris::import::{self, Limits, Loaded, Options};

/// Loads the scene; warnings go to standard error unless `quiet`.
pub(crate) fn load(args: &SceneArgs, quiet: bool) -> Result<Loaded, Failure> {
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
    };
    let loaded = import::load(
        &args.file,
        &Options {
            root: args.root.clone(),
            limits,
            circle_steps: args.circle.unwrap_or(import::CIRCLE_STEPS),
        },
    )?;
    if !quiet {
        loaded.warnings.iter().for_each(|w| say::note(&format!("warning: {w}")));
    }
    Ok(loaded)
}
