//! Edits: the only way a scene changes while it is looked at. Each states what shall be, not by how much it differs, so
//! an edit that is repeated, or written down and read again, means the same; and each has an inverse.
//!
//! Numbers are never used twice: what is taken away leaves its number behind, and what was added later keeps its own.

use super::{Camera, Group, Instance, Scene};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::light::{Bounds, Emitter, Light, LightKind, State};
use crate::material::{Material, glows_soundly};
use glam::Affine3A;
use serde::{Deserialize, Serialize};

/// One change of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Edit {
    /// A light's power, colour, place, aim and shape.
    Light {
        /// Which light.
        light: u32,
        /// What it is from now on.
        kind: LightKind,
    },
    /// Turns a light on or off, takes it away or brings it back.
    Switch {
        /// Which light.
        light: u32,
        /// Whether it shines from now on.
        state: State,
    },
    /// A light more, of the next number.
    AddLight {
        /// What it is.
        light: Light,
    },
    /// Moves, turns and scales an object.
    Move {
        /// Which instance.
        instance: u32,
        /// Mesh space → world.
        transform: Affine3A,
    },
    /// Gives an object another mesh, takes it away, or brings it back.
    Mesh {
        /// Which instance.
        instance: u32,
        /// Which mesh; `None` takes the object away.
        mesh: Option<u32>,
    },
    /// An object more, of the next number.
    AddInstance {
        /// A mesh of the scene in its place.
        instance: Instance,
    },
    /// Replaces a material.
    Material {
        /// Which material.
        material: u32,
        /// What it is from now on.
        to: Box<Material>,
    },
    /// Power and colour of a material that glows.
    Emission {
        /// Which material.
        material: u32,
        /// Emitted radiance [cd/m²].
        emission: Rgb,
    },
    /// Level and colour of a light group. No light takes other ways: its sums are weighted otherwise.
    Mix {
        /// Which group.
        group: u16,
        /// What its light is multiplied by from now on.
        color: Rgb,
    },
    /// Puts emitters of one group into another, or into one more, of the next number.
    Regroup {
        /// Which emitters.
        emitters: Vec<u32>,
        /// Which group.
        group: u16,
    },
    /// From where the scene is looked at.
    View {
        /// The camera; `None` where nobody has decided.
        camera: Option<Camera>,
    },
}

impl Scene {
    /// Changes the scene, and returns the edit that takes the change back.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a number that the scene does not have, and for values that no importer would let
    /// pass. Nothing is changed then.
    pub fn apply(&mut self, edit: &Edit) -> Result<Edit> {
        match edit {
            Edit::Light { light, kind } => {
                check_light(kind)?;
                let own = &mut entry(&mut self.lights, *light, "light")?.kind;
                Ok(Edit::Light { light: *light, kind: std::mem::replace(own, kind.clone()) })
            }
            Edit::Switch { light, state } => {
                let own = &mut entry(&mut self.lights, *light, "light")?.state;
                Ok(Edit::Switch { light: *light, state: std::mem::replace(own, *state) })
            }
            Edit::AddLight { light } => {
                check_light(&light.kind)?;
                let number = next(self.lights.len())?;
                self.lights.push(light.clone());
                Ok(Edit::Switch { light: number, state: State::Away })
            }
            Edit::Move { instance, transform } => {
                check_transform(transform)?;
                let own = &mut entry(&mut self.instances, *instance, "object")?.transform;
                Ok(Edit::Move { instance: *instance, transform: std::mem::replace(own, *transform) })
            }
            Edit::Mesh { instance, mesh } => {
                self.check_mesh(*mesh)?;
                let own = &mut entry(&mut self.instances, *instance, "object")?.mesh;
                let old = std::mem::replace(own, mesh.unwrap_or(Instance::AWAY));
                Ok(Edit::Mesh { instance: *instance, mesh: (old != Instance::AWAY).then_some(old) })
            }
            Edit::AddInstance { instance } => {
                self.check_mesh(Some(instance.mesh))?;
                check_transform(&instance.transform)?;
                let number = next(self.instances.len())?;
                self.instances.push(instance.clone());
                Ok(Edit::Mesh { instance: number, mesh: None })
            }
            Edit::Material { material, to } => {
                if !to.is_sound() {
                    return Err(bad("a material with numbers that make no sense"));
                }
                let own = entry(&mut self.materials, *material, "material")?;
                Ok(Edit::Material {
                    material: *material,
                    to: Box::new(std::mem::replace(own, Material::clone(to))),
                })
            }
            Edit::Emission { material, emission } => {
                if !glows_soundly(*emission) {
                    return Err(bad("an emission that is not finite or too bright"));
                }
                let own = &mut entry(&mut self.materials, *material, "material")?.emission;
                Ok(Edit::Emission { material: *material, emission: std::mem::replace(own, *emission) })
            }
            Edit::Mix { group, color } => {
                if !glows_soundly(*color) {
                    return Err(bad("a level that is not finite or too bright"));
                }
                let own = &mut entry(&mut self.groups, u32::from(*group), "light group")?.color;
                Ok(Edit::Mix { group: *group, color: std::mem::replace(own, *color) })
            }
            Edit::Regroup { emitters, group } => self.regroup(emitters, *group),
            Edit::View { camera } => {
                if !camera.as_ref().is_none_or(Camera::is_sound) {
                    return Err(bad("a camera that looks nowhere"));
                }
                Ok(Edit::View { camera: std::mem::replace(&mut self.view, camera.clone()) })
            }
        }
    }

    fn regroup(&mut self, emitters: &[u32], group: u16) -> Result<Edit> {
        let Scene { groups, reference, .. } = self;
        let known = usize::from(group) < groups.len();
        let next = !groups.is_empty() && groups.len() < Group::MOST && usize::from(group) == groups.len();
        if !known && !next {
            return Err(bad(format!("the scene has no light group {group}")));
        }
        let mut from = emitters.iter().map(|e| reference.shares.get(*e as usize).map(|share| share.group));
        let Some(Some(first)) = from.next() else {
            return Err(bad("a light group of emitters that the scene does not have"));
        };
        if from.any(|other| other != Some(first)) {
            return Err(bad("emitters that are not of one light group"));
        }
        if !known {
            groups.push(groups[usize::from(first)].clone());
        }
        emitters.iter().for_each(|e| reference.shares[*e as usize].group = group);
        Ok(Edit::Regroup { emitters: emitters.to_vec(), group: first })
    }

    fn check_mesh(&self, mesh: Option<u32>) -> Result<()> {
        match mesh.filter(|m| *m as usize >= self.meshes.len()) {
            Some(mesh) => Err(bad(format!("the scene has no mesh {mesh}"))),
            None => Ok(()),
        }
    }
}

/// The number of something more.
fn next(count: usize) -> Result<u32> {
    u32::try_from(count).ok().filter(|n| *n < Instance::AWAY).ok_or_else(|| bad("the scene is full"))
}

fn entry<'a, T>(all: &'a mut [T], number: u32, what: &str) -> Result<&'a mut T> {
    all.get_mut(number as usize).ok_or_else(|| bad(format!("the scene has no {what} {number}")))
}

/// What importers ask of a light, and that its flux is finite.
fn check_light(kind: &LightKind) -> Result<()> {
    let flux = Emitter::Lamp(kind.clone()).power(Bounds::default());
    if kind.is_sound() && glows_soundly(kind.brightness()) && flux.is_finite() {
        Ok(())
    } else {
        Err(bad("a light with numbers that make no sense"))
    }
}

fn check_transform(transform: &Affine3A) -> Result<()> {
    let determinant = transform.matrix3.determinant();
    let sound = transform.is_finite() && determinant != 0.0 && determinant.is_finite();
    if sound && transform.inverse().is_finite() {
        Ok(())
    } else {
        Err(bad("a transform that is not finite or flattens everything"))
    }
}

fn bad(what: impl Into<String>) -> Error {
    Error::BadSetting(format!("cannot edit: {}", what.into()))
}
