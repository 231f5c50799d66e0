//! From a scene and a document to the edited scene. What does not fit is left out and told of, since a scene's file may
//! have changed since; nothing of it is an error.

use super::names::Names;
use super::{Document, LightEdit, MaterialEdit, MeshOf, ObjectEdit, Shining, white};
use crate::material::Material;
use crate::scene::{Edit, Group, Instance, Scene, Share, Source};
use std::collections::HashSet;

impl Document {
    /// The scene as it was edited, and what of the edits had no place in it, a line each.
    ///
    /// For any two scenes, of which the second came to be from the first by edits, what was said of them
    /// ([`Document::of`]) makes the second of the first to the bit, and all has its place.
    pub fn apply(&self, scene: Scene) -> (Scene, Vec<String>) {
        let edits = &self.edits;
        let outline = super::outline(&scene);
        let mut stage = Stage {
            lights: Names::new(outline.lights.iter().map(|l| l.name.as_str())),
            objects: Names::new(outline.instances.iter().map(|i| i.name.as_str())),
            materials: Names::new(outline.materials.iter().map(|m| m.name.as_str())),
            before: &outline,
            scene,
            added_lights: Vec::new(),
            added_objects: Vec::new(),
            lost: Vec::new(),
        };
        edits.lights.0.iter().for_each(|(path, edit)| stage.light(path, edit));
        for light in &edits.added_lights {
            let number = stage.scene.lights.len() as u32;
            let done = stage.edit(&Edit::AddLight { light: light.clone() }, "added light", &light.name);
            stage.added_lights.push(done.then_some(number));
        }
        edits.objects.0.iter().for_each(|(path, edit)| stage.object(path, edit));
        edits.added_objects.iter().for_each(|added| stage.add_object(added));
        edits.materials.0.iter().for_each(|(path, edit)| stage.material(path, edit));
        if let Some(camera) = &edits.view {
            stage.edit(&Edit::View { camera: camera.clone() }, "view", "");
        }
        if let Some(groups) = &edits.groups {
            stage.scene.groups = groups.iter().take(Group::MOST).cloned().collect();
        }
        stage.scene.reference.flux = edits.flux.unwrap_or(stage.scene.reference.flux);
        if let Some(emitters) = &edits.emitters {
            stage.share_out(emitters);
        }
        (stage.scene, stage.lost)
    }
}

/// A scene on its way to the edited one.
struct Stage<'a> {
    before: &'a Scene,
    lights: Names<'a>,
    objects: Names<'a>,
    materials: Names<'a>,
    scene: Scene,
    /// The numbers that were given to what was added, as far as it could be.
    added_lights: Vec<Option<u32>>,
    added_objects: Vec<Option<u32>>,
    lost: Vec<String>,
}

impl Stage<'_> {
    /// Carries an edit out; false where it makes no sense.
    fn edit(&mut self, edit: &Edit, what: &str, path: &str) -> bool {
        let done = self.scene.apply(edit);
        if let Err(error) = &done {
            self.lost.push(format!("{what} {}: {error}", shown(path)));
        }
        done.is_ok()
    }

    fn gone(&mut self, what: &str, path: &str) {
        self.lost.push(format!("{what} {} is not in the scene any more", shown(path)));
    }

    fn light(&mut self, path: &str, edit: &LightEdit) {
        let Some(light) = self.lights.number(path) else { return self.gone("light", path) };
        let own = &self.before.lights[light as usize].kind;
        let whitened = edit.white.then(|| own.clone().with_brightness(white(own.brightness())));
        if let Some(kind) = edit.kind.clone().or(whitened) {
            self.edit(&Edit::Light { light, kind }, "light", path);
        }
        if let Some(state) = edit.state {
            self.edit(&Edit::Switch { light, state }, "light", path);
        }
    }

    fn object(&mut self, path: &str, edit: &ObjectEdit) {
        let Some(instance) = self.objects.number(path) else { return self.gone("object", path) };
        if let Some(transform) = edit.transform {
            self.edit(&Edit::Move { instance, transform }, "object", path);
        }
        if edit.away {
            self.edit(&Edit::Mesh { instance, mesh: None }, "object", path);
        } else if let Some(of) = &edit.mesh {
            match self.mesh(of) {
                Some(mesh) => drop(self.edit(&Edit::Mesh { instance, mesh: Some(mesh) }, "object", path)),
                None => self.lost.push(format!("object {}: its other mesh is gone", shown(path))),
            }
        }
    }

    fn add_object(&mut self, added: &super::Added) {
        let number = self.scene.instances.len() as u32;
        let (name, transform) = (added.name.clone(), added.transform);
        // What was taken away again only keeps a number.
        let mesh = match &added.mesh {
            Some(of) => self.mesh(of),
            None => (!self.scene.meshes.is_empty()).then_some(0),
        };
        let done = match mesh {
            Some(mesh) => {
                let instance = Instance { name, mesh, transform };
                let done = self.edit(&Edit::AddInstance { instance }, "added object", &added.name);
                if done && added.mesh.is_none() {
                    self.edit(&Edit::Mesh { instance: number, mesh: None }, "added object", &added.name);
                }
                done
            }
            None => {
                self.lost.push(format!("added object {}: its mesh is gone", shown(&added.name)));
                false
            }
        };
        self.added_objects.push(done.then_some(number));
    }

    fn mesh(&self, of: &MeshOf) -> Option<u32> {
        match of {
            MeshOf::Object(path) => {
                self.objects.number(path).map(|number| self.before.instances[number as usize].mesh)
            }
            MeshOf::Number(mesh) => Some(*mesh),
        }
    }

    fn material(&mut self, path: &str, edit: &MaterialEdit) {
        let Some(material) = self.materials.number(path) else { return self.gone("material", path) };
        let own = &self.before.materials[material as usize];
        let emission = edit.emission.or(edit.white.then(|| white(own.emission)));
        let to = Material {
            name: edit.name.clone().unwrap_or_else(|| own.name.clone()),
            bsdf: edit.bsdf.unwrap_or(own.bsdf),
            emission: own.emission,
            sides: edit.sides.unwrap_or(own.sides),
            coverage: edit.coverage.unwrap_or(own.coverage),
            maps: edit.maps.clone().unwrap_or_else(|| own.maps.clone()),
        };
        let other = edit.name.is_some() || edit.bsdf.is_some() || edit.sides.is_some();
        if other || edit.coverage.is_some() || edit.maps.is_some() {
            self.edit(&Edit::Material { material, to: Box::new(to) }, "material", path);
        }
        if let Some(emission) = emission {
            self.edit(&Edit::Emission { material, emission }, "material", path);
        }
    }

    /// Who has what share of the light paths and belongs to what group, as far as they are still there.
    fn share_out(&mut self, emitters: &[Shining]) {
        let (mut shares, mut known) = (Vec::new(), HashSet::new());
        let groups = self.scene.groups.len().max(1);
        for of in emitters {
            match self.source(of) {
                Some(source) if known.insert(source) => {
                    let group = if usize::from(of.group) < groups { of.group } else { 0 };
                    shares.push(Share { source, share: of.share, group });
                }
                Some(_) => self.lost.push(format!("{} shines twice", of.name())),
                None => self.lost.push(format!("{} does not shine any more", of.name())),
            }
        }
        self.scene.reference.shares = shares;
    }

    fn source(&self, of: &Shining) -> Option<Source> {
        let added = |list: &[Option<u32>], place: u32| list.get(place as usize).copied().flatten();
        match of {
            Shining { light: Some(path), .. } => self.lights.number(path).map(Source::Light),
            Shining { added_light: Some(place), .. } => added(&self.added_lights, *place).map(Source::Light),
            Shining { environment: true, .. } => Some(Source::Environment),
            _ => {
                let instance = match (&of.object, of.added_object) {
                    (Some(path), _) => self.objects.number(path)?,
                    (_, place) => added(&self.added_objects, place?)?,
                };
                let material = self.materials.number(of.material.as_deref()?)?;
                Some(Source::Side { instance, material, back: of.back })
            }
        }
    }
}

impl Shining {
    fn name(&self) -> String {
        match (&self.light, &self.object, &self.material) {
            (Some(light), ..) => format!("light {}", shown(light)),
            (_, Some(object), _) => format!("object {}", shown(object)),
            (.., Some(material)) => format!("material {}", shown(material)),
            _ => "what was added".into(),
        }
    }
}

/// A name in quotes, as a message may show it: of one line, and not too long.
fn shown(name: &str) -> String {
    /// As many characters as a line holds.
    const LONG: usize = 80;
    let more = if name.chars().nth(LONG).is_some() { "…" } else { "" };
    format!("{:?}{more}", name.chars().take(LONG).collect::<String>())
}
