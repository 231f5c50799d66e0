//! glTF 2.0, as JSON and as GLB (docs/formats.md says what is read and how it maps).
//! The JSON becomes data as it stands; every index and every range in it is checked where it is used. Animations, skins
//! and morph targets are left out: a mesh stands as it was modelled.

mod accessor;
mod buffers;
mod container;
mod extensions;
mod json;
mod material;
mod mesh;
mod meshopt;
mod nodes;
mod pictures;
mod soundness;

use super::files::Root;
use super::notes::Notes;
use super::{Limits, Loaded, Options};
use crate::error::Result;
use crate::import::report::quote;
use crate::material::{Bsdf, Material, Pbr, Sides};
use crate::scene::{Instance, Scene};
use accessor::Accessors;
use buffers::Buffers;
use glam::Vec3;
use json::Document;
use material::{Textures, Worn};
use nodes::Placed;
use std::path::Path;

/// Loads a `.gltf` or `.glb` file and what it names.
pub(super) fn load(path: &Path, options: &Options) -> Result<Loaded> {
    let (root, file) = Root::new(path, options)?;
    let mut notes = Notes::new(&file);
    let bytes = root.read(&file)?;
    let parts = container::split(&bytes).map_err(|(at, why)| notes.bad(format!("byte {at}"), why))?;
    let limits = &options.limits;
    notes.limit(
        "byte 0",
        "the size of the JSON",
        parts.json.len() as u64,
        limits.json_bytes,
        "--max-json-bytes",
    )?;
    let document = parse(parts.json, &notes)?;
    extensions::check(&document, &mut notes)?;
    let counts = [
        ("nodes", document.nodes.len()),
        ("meshes", document.meshes.len()),
        ("accessors", document.accessors.len()),
    ];
    for (what, count) in counts {
        notes.limit(what, &format!("the number of {what}"), count as u64, limits.nodes, "--max-nodes")?;
    }
    let placement = nodes::walk(&document, limits, &mut notes)?;
    if placement.meshes.is_empty() && !document.meshes.is_empty() {
        notes.warn("nodes", "no node of the scene places a mesh: there is nothing to see");
    }
    let buffers = Buffers::open(&document, parts.binary, &root, &file);
    let (images, numbers) = pictures::read(&document, &buffers, &root, &file, limits, &mut notes)?;
    let mut textures = Textures::new(&document, &numbers);
    let (materials, surfaces) = textures.materials(&worn(&document, &placement.meshes), &mut notes);
    let mut scene = Scene {
        images,
        textures: textures.textures,
        materials,
        cameras: placement.cameras,
        lights: placement.lights,
        up: Some(Vec3::Y),
        ..Scene::default()
    };
    fill(&mut scene, placement.meshes, &surfaces, &document, &buffers, limits, &mut notes)?;
    soundness::check(&document, &buffers, &mut notes);
    Ok(Loaded { scene, warnings: notes.into_lines() })
}

fn parse(json: &[u8], notes: &Notes) -> Result<Document> {
    serde_json::from_slice(json).map_err(|e| {
        // The parser's own words may repeat what it read.
        let text = e.to_string();
        let reason = match e.classify() {
            serde_json::error::Category::Data => quote(text.split(" at line").next().unwrap_or_default()),
            _ => text.split(" at line").next().unwrap_or_default().to_owned(),
        };
        notes.bad(format!("line {}, column {}", e.line(), e.column()), format!("JSON: {reason}"))
    })
}

/// Which materials the meshes shown wear.
fn worn(document: &Document, placed: &[Placed]) -> Vec<bool> {
    let mut shown = vec![false; document.meshes.len()];
    placed.iter().for_each(|p| shown[p.mesh as usize] = true);
    let mut worn = vec![false; document.materials.len()];
    let meshes = document.meshes.iter().zip(shown).filter(|(_, shown)| *shown);
    for material in meshes.flat_map(|(m, _)| &m.primitives).filter_map(|p| p.material) {
        if let Some(w) = worn.get_mut(material as usize) {
            *w = true;
        }
    }
    worn
}

/// Reads each mesh that is placed once, and places it as often as the nodes say.
fn fill(
    scene: &mut Scene,
    placed: Vec<Placed>,
    surfaces: &[Worn],
    document: &Document,
    buffers: &Buffers<'_>,
    limits: &Limits,
    notes: &mut Notes,
) -> Result<()> {
    let accessors = Accessors::new(document, buffers, limits.triangles);
    let mut uses = vec![0u64; document.meshes.len()];
    placed.iter().for_each(|p| uses[p.mesh as usize] += 1);
    let mut made: Vec<std::ops::Range<u32>> = vec![0..0; document.meshes.len()];
    let mut triangles = 0u64;
    let Scene { meshes, materials, instances, .. } = scene;
    let own = materials.len() as u32;
    // The material of primitives that name none, made for the first of them.
    let mut plain = || {
        if materials.len() as u32 == own {
            let bsdf = Bsdf::Pbr(Pbr::default());
            materials.push(Material { sides: Sides::EmitFront, ..Material::new("default", bsdf) });
        }
        own
    };
    for (index, mesh) in (0..).zip(&document.meshes).filter(|(k, _)| uses[*k as usize] > 0) {
        let planned = mesh::plan(index, mesh, document, &accessors, notes)?;
        triangles = triangles.saturating_add(planned.triangles.saturating_mul(uses[index as usize]));
        let what = "the number of triangles, instances counted";
        notes.limit(format!("mesh {index}"), what, triangles, limits.triangles, "--max-triangles")?;
        let first = meshes.len() as u32;
        meshes.extend(mesh::read(planned, &accessors, surfaces, &mut plain, notes)?);
        made[index as usize] = first..meshes.len() as u32;
    }
    let count = placed.iter().map(|p| made[p.mesh as usize].len()).sum();
    instances.reserve_exact(count);
    for Placed { mesh, name, transform } in placed {
        for mesh in made[mesh as usize].clone() {
            instances.push(Instance { name: name.clone(), mesh, transform: transform.as_affine3a() });
        }
    }
    Ok(())
}
