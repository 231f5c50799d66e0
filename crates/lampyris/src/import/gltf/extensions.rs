//! What a document says it needs: its version, and extensions. One that is required and not read is an error that names
//! it; one that is only used is a warning, and what the file holds without it is shown.

use super::json::Document;
use crate::error::Result;
use crate::import::notes::Notes;
use crate::import::report::quote;

/// Extensions that are read.
const READ: &[&str] = &[
    "EXT_meshopt_compression",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_transform",
];

/// Extensions that change nothing about a still picture of the default variant.
const HARMLESS: &[&str] = &[
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "KHR_animation_pointer",
    "KHR_materials_variants",
    "KHR_xmp",
    "KHR_xmp_json_ld",
];

/// Refuses what cannot be read, warns of what is left out.
pub(super) fn check(document: &Document, notes: &mut Notes) -> Result<()> {
    let asset =
        document.asset.as_ref().ok_or_else(|| notes.bad("asset", "there is none: is this glTF 2.0?"))?;
    let needed = asset.min_version.as_deref().unwrap_or(&asset.version);
    let readable = match asset.min_version {
        Some(_) => needed == "2.0",
        None => needed.split_once('.').is_some_and(|(major, _)| major == "2"),
    };
    if !readable {
        return Err(
            notes.bad("asset", format!("version {} of glTF; version 2.0 is what is read", quote(needed)))
        );
    }
    let known = |name: &&String| READ.contains(&name.as_str()) || HARMLESS.contains(&name.as_str());
    if let Some(name) = document.extensions_required.iter().find(|n| !known(n)) {
        let reason = format!("the file requires {}, which is not read; export it without", quote(name));
        return Err(notes.bad("extensionsRequired", reason));
    }
    for name in document.extensions_used.iter().filter(|n| !known(n)) {
        notes.warn(
            "extensionsUsed",
            &format!("{} is not read; what the file says without it is shown", quote(name)),
        );
    }
    if document.animations > 0 {
        notes.warn("animations", "animations are not read: everything stands as it was modelled");
    }
    Ok(())
}
