//! What was edited, as a file beside the scene's: `office.mgf.lampyris.json`. The scene's file stays as it is.
//!
//! A document says by how much one scene differs from another, in paths instead of numbers; it is a pure function of both
//! ([`Document::of`]), and applied to the first it gives the second to the bit ([`Document::apply`]), shares of the light paths
//! and light groups included, so that a picture of the one is a picture of the other. docs/formats.md shows its text.

mod apply;
mod diff;
mod entries;
mod names;
mod open;
mod place;
mod text;

pub use open::{Ask, Opened, is_document, open};
pub use place::{Digest, Place, beside, state_folder};

use crate::color::Rgb;
use crate::light::{Light, LightKind, State};
use crate::material::{Bsdf, Coverage, Maps, Sides};
use crate::scene::{Camera, Group, Scene};
use entries::Entries;
use glam::Affine3A;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The version that is written, and the newest that is read.
pub const VERSION: u32 = 1;

/// What was edited in a scene, and what else is kept with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Which scene, and how its file is read.
    pub scene: Reading,
    /// Into how many light groups the lamps are sorted ([`crate::world::World::separate`]) where no groups are recorded yet.
    pub layers: Option<u32>,
    /// Whatever a program wants to keep: looks, views, meters. Nothing here reads it.
    pub desk: Value,
    edits: Edits,
}

/// Which file is the scene's, and how it is read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reading {
    /// Its name, relative to the document.
    pub file: String,
    /// Facets around a full circle of curved shapes, where it is not the usual number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub circle: Option<u32>,
    /// What surrounds it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub environment: Option<Environment>,
}

/// A picture around a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// Its file, relative to the document.
    pub file: String,
    /// Luminance of 1 in it [cd/m²].
    pub scale: f32,
}

/// By how much two scenes differ.
#[derive(Clone, Debug, Default, PartialEq)]
struct Edits {
    /// Where it is looked at from, if that is another place; nowhere, where it was decided and is not any more.
    view: Option<Option<Camera>>,
    lights: Entries<LightEdit>,
    added_lights: Vec<Light>,
    objects: Entries<ObjectEdit>,
    added_objects: Vec<Added>,
    materials: Entries<MaterialEdit>,
    groups: Option<Vec<Group>>,
    /// [`crate::scene::Reference`].
    flux: Option<f64>,
    emitters: Option<Vec<Shining>>,
}

/// What a light of the file is now.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct LightEdit {
    /// White, of the luminance that the file gives it: its colour is in its group.
    #[serde(skip_serializing_if = "is_false")]
    white: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    kind: Option<LightKind>,
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<State>,
}

/// Where an object of the file is now, and what stands there.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct ObjectEdit {
    #[serde(skip_serializing_if = "is_false")]
    away: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<MeshOf>,
    #[serde(skip_serializing_if = "Option::is_none")]
    transform: Option<Affine3A>,
}

/// An object that the file does not have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Added {
    name: String,
    /// None where it was taken away again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mesh: Option<MeshOf>,
    transform: Affine3A,
}

/// Which mesh: meshes have no names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
enum MeshOf {
    /// The one that the file gives this object.
    Object(String),
    /// The one of this number, which no object of the file has.
    Number(u32),
}

/// What a material of the file is now.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct MaterialEdit {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    /// It glows white, of the luminance that the file gives it: its colour is in its group.
    #[serde(skip_serializing_if = "is_false")]
    white: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    emission: Option<Rgb>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bsdf: Option<Bsdf>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sides: Option<Sides>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coverage: Option<Coverage>,
    #[serde(skip_serializing_if = "Option::is_none")]
    maps: Option<Maps>,
}

/// Who shines: a light, a material of an object, or the environment. Its place in the list is its number.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Shining {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    light: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    added_light: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    object: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    added_object: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    material: Option<String>,
    #[serde(default, skip_serializing_if = "is_false")]
    back: bool,
    #[serde(default, skip_serializing_if = "is_false")]
    environment: bool,
    share: f32,
    #[serde(default)]
    group: u16,
}

fn is_false(value: &bool) -> bool {
    !*value
}

/// A glow as white as it is bright: what [`crate::world::World::separate`] makes of a lamp whose colour it puts into the mix.
fn white(brightness: Rgb) -> Rgb {
    Rgb::grey(brightness.luminance())
}

/// What a document needs of a scene: all but meshes and pictures, which edits do not change.
pub fn outline(scene: &Scene) -> Scene {
    Scene {
        instances: scene.instances.clone(),
        materials: scene.materials.clone(),
        lights: scene.lights.clone(),
        environment: scene.environment,
        environment_image: scene.environment_image,
        textures: scene.textures.clone(),
        cameras: scene.cameras.clone(),
        up: scene.up,
        view: scene.view.clone(),
        reference: scene.reference.clone(),
        groups: scene.groups.clone(),
        ..Scene::default()
    }
}
