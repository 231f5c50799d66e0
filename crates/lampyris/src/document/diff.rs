//! From two scenes to a document.

use super::names::Names;
use super::{Added, Document, Edits, LightEdit, MaterialEdit, MeshOf, ObjectEdit, Shining, white};
use crate::light::Light;
use crate::material::Material;
use crate::scene::{Instance, Scene, Share, Source};
use glam::Affine3A;
use serde::Serialize;
use std::collections::HashMap;

impl Document {
    /// What makes `after` of `before`, where `after` came to be by edits, by [`crate::world::World::new`] and by
    /// [`crate::world::World::separate`]. Meshes and pictures are not looked at ([`super::outline`] does).
    pub fn of(before: &Scene, after: &Scene) -> Document {
        let of = Before::new(before);
        let lights = (0..).zip(before.lights.iter().zip(&after.lights));
        let objects = (0..).zip(before.instances.iter().zip(&after.instances));
        let materials = (0..).zip(before.materials.iter().zip(&after.materials));
        let edits = Edits {
            view: differs(&before.view, &after.view).then(|| after.view.clone()),
            lights: entries(lights, &of.lights, light),
            added_lights: after.lights.iter().skip(before.lights.len()).cloned().collect(),
            objects: entries(objects, &of.objects, |before, after| of.object(before, after)),
            added_objects: after.instances.iter().skip(before.instances.len()).map(|i| of.added(i)).collect(),
            materials: entries(materials, &of.materials, material),
            groups: differs(&before.groups, &after.groups).then(|| after.groups.clone()),
            flux: differs(&before.reference.flux, &after.reference.flux).then_some(after.reference.flux),
            emitters: differs(&before.reference.shares, &after.reference.shares)
                .then(|| after.reference.shares.iter().map(|share| of.shining(share)).collect()),
        };
        Document { edits, ..Document::default() }
    }
}

/// The scene that others are compared with, by names.
struct Before<'a> {
    scene: &'a Scene,
    /// The first object that has a mesh.
    owners: HashMap<u32, u32>,
    lights: Names<'a>,
    objects: Names<'a>,
    materials: Names<'a>,
}

impl<'a> Before<'a> {
    fn new(scene: &'a Scene) -> Before<'a> {
        let mut owners = HashMap::new();
        for (number, instance) in (0..).zip(&scene.instances) {
            owners.entry(instance.mesh).or_insert(number);
        }
        Before {
            scene,
            owners,
            lights: Names::new(scene.lights.iter().map(|l| l.name.as_str())),
            objects: Names::new(scene.instances.iter().map(|i| i.name.as_str())),
            materials: Names::new(scene.materials.iter().map(|m| m.name.as_str())),
        }
    }

    fn object(&self, before: &Instance, after: &Instance) -> Option<ObjectEdit> {
        let replaced = before.mesh != after.mesh;
        let away = replaced && after.mesh == Instance::AWAY;
        let edit = ObjectEdit {
            away,
            mesh: (replaced && !away).then(|| self.mesh(after.mesh)),
            transform: (bits(&before.transform) != bits(&after.transform)).then_some(after.transform),
        };
        (edit != ObjectEdit::default()).then_some(edit)
    }

    fn added(&self, instance: &Instance) -> Added {
        let there = instance.mesh != Instance::AWAY;
        Added {
            name: instance.name.clone(),
            mesh: there.then(|| self.mesh(instance.mesh)),
            transform: instance.transform,
        }
    }

    fn mesh(&self, mesh: u32) -> MeshOf {
        let path = self.owners.get(&mesh).and_then(|owner| self.objects.path(*owner));
        path.map_or(MeshOf::Number(mesh), MeshOf::Object)
    }

    fn shining(&self, of: &Share) -> Shining {
        let mut shining = Shining { share: of.share, group: of.group, ..Shining::default() };
        match of.source {
            Source::Light(light) => {
                shining.light = self.lights.path(light);
                shining.added_light = light.checked_sub(self.scene.lights.len() as u32);
            }
            Source::Side { instance, material, back } => {
                shining.object = self.objects.path(instance);
                shining.added_object = instance.checked_sub(self.scene.instances.len() as u32);
                shining.material = self.materials.path(material);
                shining.back = back;
            }
            Source::Environment => shining.environment = true,
        }
        shining
    }
}

/// What is to be said of each of two lists, by path.
fn entries<'a, T: 'a, E>(
    pairs: impl Iterator<Item = (u32, (&'a T, &'a T))>,
    names: &Names<'_>,
    edit: impl Fn(&T, &T) -> Option<E>,
) -> super::Entries<E> {
    let said =
        pairs.filter_map(|(number, (before, after))| Some((names.path(number)?, edit(before, after)?)));
    super::Entries(said.collect())
}

fn light(before: &Light, after: &Light) -> Option<LightEdit> {
    let whitened = before.kind.clone().with_brightness(white(before.kind.brightness()));
    let changed = differs(&before.kind, &after.kind);
    let white = changed && !differs(&whitened, &after.kind);
    let edit = LightEdit {
        white,
        kind: (changed && !white).then(|| after.kind.clone()),
        state: (before.state != after.state).then_some(after.state),
    };
    (edit != LightEdit::default()).then_some(edit)
}

fn material(before: &Material, after: &Material) -> Option<MaterialEdit> {
    let glows = differs(&before.emission, &after.emission);
    let white = glows && !differs(&white(before.emission), &after.emission);
    let edit = MaterialEdit {
        name: (before.name != after.name).then(|| after.name.clone()),
        white,
        emission: (glows && !white).then_some(after.emission),
        bsdf: differs(&before.bsdf, &after.bsdf).then_some(after.bsdf),
        sides: (before.sides != after.sides).then_some(after.sides),
        coverage: differs(&before.coverage, &after.coverage).then_some(after.coverage),
        maps: differs(&before.maps, &after.maps).then(|| after.maps.clone()),
    };
    (edit != MaterialEdit::default()).then_some(edit)
}

/// True where two values are not written alike: 0 and −0 are equal numbers, and other bits.
fn differs<T: Serialize>(before: &T, after: &T) -> bool {
    serde_json::to_string(before).ok() != serde_json::to_string(after).ok()
}

fn bits(transform: &Affine3A) -> [u32; 12] {
    transform.to_cols_array().map(f32::to_bits)
}
