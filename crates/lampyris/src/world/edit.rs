//! Edits in place: a world changes as its scene does, and only what an edit touches is worked out anew. Afterwards light
//! cannot tell it from a world built afresh of the edited scene: hits, emitters, shares and figures are the same bits.

use super::finish::Finish;
use super::measure::Extent;
use super::mirrors::{Mirrors, reflectance};
use super::{World, geometry};
use crate::color::Rgb;
use crate::error::Result;
use crate::geometry::Screen;
use crate::material::Material;
use crate::scene::{Edit, Instance, Mesh, Scene};
use std::sync::Arc;

/// What an edit changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes {
    /// The edit that takes it back.
    pub inverse: Edit,
    /// Emitters whose light is another one now, by number: all of them, where the scene's extent is.
    pub emitters: Vec<u32>,
    /// Light groups whose sum is another one now: the groups of these emitters, and those that lost some.
    pub groups: Vec<usize>,
    /// The groups are weighted otherwise.
    pub mix: bool,
    /// Surfaces stand elsewhere: all light takes other ways.
    pub geometry: bool,
    /// Surfaces scatter otherwise: all light becomes other light.
    pub materials: bool,
    /// It is looked at from elsewhere.
    pub view: bool,
}

impl Changes {
    /// True if a picture is another one now.
    pub fn any(&self) -> bool {
        self.mix || self.restarts_all() || !self.groups.is_empty()
    }

    /// True if the light of every group is another one now.
    pub fn restarts_all(&self) -> bool {
        self.geometry || self.materials || self.view
    }
}

impl World {
    /// Changes the scene and follows it.
    ///
    /// # Errors
    /// As [`Scene::apply`]; nothing is changed then.
    pub fn apply(&mut self, edit: &Edit) -> Result<Changes> {
        let inverse = self.change_scene(|scene| scene.apply(edit))?;
        let mut changes = Changes {
            inverse,
            emitters: Vec::new(),
            groups: Vec::new(),
            mix: false,
            geometry: false,
            materials: false,
            view: false,
        };
        if changes.inverse == *edit {
            return Ok(changes);
        }
        match (edit, &changes.inverse) {
            (Edit::Light { light, .. } | Edit::Switch { light, .. }, _)
            | (Edit::AddLight { .. }, Edit::Switch { light, .. }) => {
                self.emitters.set_light(*light, &self.scene.lights[*light as usize]);
            }
            (Edit::Move { instance, .. }, _) => {
                self.facets.moved(*instance);
                changes.geometry = self.stand(*instance, None);
            }
            (Edit::Mesh { instance, .. }, Edit::Mesh { mesh, .. }) => {
                self.facets.swapped(*instance);
                changes.geometry = self.stand(*instance, *mesh);
            }
            (Edit::AddInstance { .. }, Edit::Mesh { instance, .. }) => {
                self.facets.moved(*instance);
                changes.geometry = self.stand(*instance, None);
            }
            (Edit::Material { material, .. }, Edit::Material { to, .. }) => {
                let old = to.clone();
                (changes.materials, changes.geometry) = self.refinish(*material, &old);
            }
            (Edit::Emission { material, .. }, Edit::Emission { emission, .. }) => {
                let old =
                    Material { emission: *emission, ..self.scene.materials[*material as usize].clone() };
                self.refinish(*material, &old);
            }
            (Edit::Mix { .. }, _) => {
                changes.mix = true;
                return Ok(changes);
            }
            (Edit::Regroup { emitters, group }, Edit::Regroup { group: before, .. }) => {
                let shares = &mut self.emitters.reference.shares;
                emitters.iter().for_each(|k| shares[*k as usize].group = *group);
                changes.groups = vec![usize::from(*before), usize::from(*group)];
                return Ok(changes);
            }
            _ => changes.view = true,
        }
        let before = self.figures.bounds;
        self.conclude();
        changes.emitters = self.emitters.take_changed();
        let after = self.figures.bounds;
        if (before.center, before.radius) != (after.center, after.radius) {
            changes.emitters = (0..self.emitters.all.len() as u32).collect();
        }
        changes.groups = changes.emitters.iter().map(|k| self.group_of(*k)).collect();
        changes.groups.sort_unstable();
        changes.groups.dedup();
        Ok(changes)
    }

    /// Changes the scene in place. All others who look at it let go meanwhile, so that it need not be copied.
    pub(super) fn change_scene<R>(&mut self, change: impl FnOnce(&mut Scene) -> R) -> R {
        self.facets.scene = Arc::default();
        self.tracer.ask(&Screen::default());
        self.emitters.ask(None);
        let result = change(Arc::make_mut(&mut self.scene));
        self.facets.scene = self.scene.clone();
        self.tracer.ask(&geometry::screen(&self.scene));
        self.emitters.ask(Some(&self.scene));
        result
    }

    /// An instance stands otherwise, or has another mesh than the `old` one. Returns whether anything can be seen of it.
    fn stand(&mut self, instance: u32, old: Option<u32>) -> bool {
        let World { scene, tracer, facets, emitters, finishes, .. } = self;
        geometry::replace(tracer, scene, instance, &mut self.least);
        let extent = Extent::new(facets, &self.albedos, instance);
        match self.extents.get_mut(instance as usize) {
            Some(own) => *own = extent,
            None => self.extents.push(extent),
        }
        let glowing = emitters.glowing(finishes);
        emitters.set_instance(instance, facets, finishes, &glowing);
        let meshes: Vec<u32> = std::iter::once(scene.instances[instance as usize].mesh)
            .chain(old)
            .filter(|mesh| *mesh != Instance::AWAY)
            .collect();
        let reflects: Vec<bool> = scene.materials.iter().map(|m| reflectance(m) > 0.0).collect();
        let mirrors =
            |mesh: &u32| scene.meshes[*mesh as usize].materials.iter().any(|k| reflects[*k as usize]);
        if meshes.iter().any(mirrors) {
            self.mirrors = Mirrors::find(facets, &scene.materials);
        }
        let sharp =
            |mesh: &u32| scene.meshes[*mesh as usize].materials.iter().any(|k| self.sharp[*k as usize]);
        if meshes.iter().any(sharp) {
            self.find_bodies();
        }
        !meshes.is_empty()
    }

    /// A material was another one before. Returns whether it scatters otherwise, and whether rays meet it otherwise.
    fn refinish(&mut self, material: u32, old: &Material) -> (bool, bool) {
        let k = material as usize;
        let scene = self.scene.clone();
        let new = &scene.materials[k];
        let used: Vec<bool> = scene.meshes.iter().map(|m| m.materials.contains(&material)).collect();
        let colored = |(mesh, used): (&Mesh, &bool)| *used && !mesh.colors.is_empty();
        let finish = Finish::from(new);
        let painted = finish.painted || scene.meshes.iter().zip(&used).any(colored);
        self.finishes[k] = Finish { painted, ..finish };
        let users: Vec<u32> = (0..)
            .zip(&scene.instances)
            .filter(|(_, i)| used.get(i.mesh as usize) == Some(&true))
            .map(|(number, _)| number)
            .collect();
        let seen = !users.is_empty();
        let dark = |m: &Material| Material { emission: Rgb::BLACK, name: String::new(), ..m.clone() };
        let scatters = dark(old) != dark(new);
        let holes = seen && !geometry::alike(old, new);
        if holes {
            self.tracer = geometry::tracer(&scene, &mut self.least);
        }
        if scatters {
            let was_sharp = self.sharp[k];
            self.weigh(material);
            for user in &users {
                self.extents[*user as usize] = Extent::new(&self.facets, &self.albedos, *user);
            }
            if seen && reflectance(old) != reflectance(new) {
                self.mirrors = Mirrors::find(&self.facets, &scene.materials);
            }
            if seen && (was_sharp || self.sharp[k]) {
                self.find_bodies();
            }
        }
        let glow = |m: &Material| (m.emission, m.sides, m.coverage, m.maps.clone());
        let glowing = self.emitters.glowing(&self.finishes);
        if glowing[k] && glow(old) != glow(new) {
            for user in users {
                self.emitters.set_instance(user, &self.facets, &self.finishes, &glowing);
            }
        }
        (scatters && seen, holes)
    }
}
