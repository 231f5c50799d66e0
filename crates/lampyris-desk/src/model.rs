//! The scene as people work on it: lamps with levels and colours in groups, things, materials. It knows what shall be; what
//! that is for the renderer, [`crate::mixer`] and [`crate::edits`] say.

use crate::color::Color;
use crate::patch::{GroupPatch, LampPatch, MaterialPatch, Mode, Patch, Place, ThingPatch, swap};
use crate::place;
use crate::wire;
use glam::{Affine3A, Quat, Vec3};
use lampyris::Rgb;
use lampyris::light::LightKind;
use lampyris::material::{Bsdf, Material};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Everything that undo can undo.
#[derive(Clone, Debug, Default)]
pub(crate) struct Model {
    pub(crate) lamps: Vec<Lamp>,
    pub(crate) groups: Vec<Group>,
    pub(crate) things: Vec<Thing>,
    pub(crate) materials: Vec<Coating>,
    pub(crate) notes: Notes,
}

/// What the page keeps here, by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    pub(crate) views: BTreeMap<u32, Value>,
    pub(crate) looks: BTreeMap<u32, Value>,
    pub(crate) meters: BTreeMap<u32, Value>,
    pub(crate) grids: BTreeMap<u32, Value>,
}

/// A luminaire.
#[derive(Clone, Debug)]
pub(crate) struct Lamp {
    pub(crate) name: String,
    /// What the file calls it, with a number where others are called so too.
    pub(crate) file_name: String,
    pub(crate) body: Body,
    pub(crate) on: bool,
    pub(crate) level: f32,
    pub(crate) color: Color,
    pub(crate) group: u32,
    pub(crate) parked: bool,
    pub(crate) gone: bool,
    /// Added here.
    pub(crate) own: bool,
    pub(crate) place: Place,
    /// Where the file has it.
    pub(crate) file_place: Place,
    pub(crate) file_group: u32,
    /// At level 1 [lm]; infinite lights have none.
    pub(crate) flux: Option<f32>,
    /// Its numbers in [`lampyris::scene::Reference`], each with the colour of its light group when the scene was opened.
    pub(crate) emitters: Vec<(u32, Rgb)>,
    /// What it sends out, that colour apart, as a colour of luminance 1.
    pub(crate) shining: Rgb,
    /// Lowest and highest corner as the file has it [m].
    pub(crate) bounds: Option<[Vec3; 2]>,
}

/// What a lamp is for the renderer.
#[derive(Clone, Debug)]
pub(crate) enum Body {
    /// A light of the scene, as it was.
    Light(u32, LightKind),
    /// Surfaces that glow; with them these things move.
    Surface(Vec<u32>),
    /// What surrounds the scene.
    Sky,
}

/// Lamps that are dimmed together.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub(crate) name: String,
    pub(crate) on: bool,
    pub(crate) level: f32,
    pub(crate) gone: bool,
}

/// An object: an instance of the scene.
#[derive(Clone, Debug)]
pub(crate) struct Thing {
    pub(crate) name: String,
    pub(crate) mesh: u32,
    pub(crate) transform: Affine3A,
    /// Lowest and highest corner as the file has it [m].
    pub(crate) bounds: [Vec3; 2],
    pub(crate) materials: Vec<u32>,
    pub(crate) place: Place,
    pub(crate) hidden: bool,
    pub(crate) locked: bool,
}

/// A material, as it was and as it shall be.
#[derive(Clone, Debug)]
pub(crate) struct Coating {
    pub(crate) file: Material,
    pub(crate) shall: MaterialPatch,
}

/// What an edit touched.
#[derive(Clone, Debug, Default)]
pub(crate) struct Touched {
    pub(crate) lamps: BTreeSet<u32>,
    pub(crate) groups: BTreeSet<u32>,
    pub(crate) things: BTreeSet<u32>,
    pub(crate) materials: BTreeSet<u32>,
    pub(crate) views: BTreeSet<u32>,
    pub(crate) looks: BTreeSet<u32>,
    pub(crate) meters: BTreeSet<u32>,
    pub(crate) grids: BTreeSet<u32>,
}

/// Brightest that a fader goes, and how far things may be taken [m].
const BRIGHTEST: f32 = 1e4;
const FAR: f32 = 1e5;

/// Bytes of a note.
const NOTE: usize = 16 << 10;

/// Bytes that a look may have besides for each lamp and group.
const FADER: usize = 256;

/// How many notes there may be of a kind.
const NOTES: u32 = 1000;

impl Touched {
    pub(crate) fn of(patch: &Patch) -> Touched {
        Touched {
            lamps: patch.lamps.keys().copied().collect(),
            groups: patch.groups.keys().copied().collect(),
            things: patch.things.keys().copied().collect(),
            materials: patch.materials.keys().copied().collect(),
            views: patch.views.keys().copied().collect(),
            looks: patch.looks.keys().copied().collect(),
            meters: patch.meters.keys().copied().collect(),
            grids: patch.grids.keys().copied().collect(),
        }
    }

    /// Takes in what becomes otherwise by it: groups that lamps came into or left, and where lamps were sorted into layers
    /// anew, all of them.
    pub(crate) fn spread(&mut self, model: &Model, inverse: &Patch, sorted: bool) {
        for (id, before) in &inverse.lamps {
            if before.group.is_some() || before.gone.is_some() {
                let now = model.lamps.get(*id as usize).map(|lamp| lamp.group);
                self.groups.extend(before.group.into_iter().chain(now));
            }
        }
        if sorted {
            self.lamps.extend(0..model.lamps.len() as u32);
        }
    }
}

impl Model {
    /// Changes what a patch says and returns the patch that takes it back; or changes nothing and says why.
    pub(crate) fn apply(&mut self, patch: &Patch) -> Result<Patch, String> {
        let mut new = self.touched_of(patch)?;
        let mut inverse = Patch::default();
        let groups = self.groups.len() as u32;
        for (id, lamp) in &mut new.lamps {
            inverse.lamps.insert(*id, lamp.apply(&patch.lamps[id], groups)?);
        }
        for (id, group) in &mut new.groups {
            inverse.groups.insert(*id, group.apply(&patch.groups[id])?);
        }
        for (id, thing) in &mut new.things {
            inverse.things.insert(*id, thing.apply(&patch.things[id])?);
        }
        for (id, material) in &mut new.materials {
            inverse.materials.insert(*id, material.apply(&patch.materials[id])?);
        }
        let faders = NOTE + FADER * (self.lamps.len() + self.groups.len());
        let rooms =
            [(&patch.views, NOTE), (&patch.looks, faders), (&patch.meters, NOTE), (&patch.grids, NOTE)];
        for (notes, room) in rooms {
            for (id, note) in notes {
                let long = note.as_ref().is_some_and(|note| note.to_string().len() > room);
                if *id >= NOTES || long {
                    return Err(format!("there is room for {NOTES} of {room} bytes"));
                }
            }
        }
        let Notes { views, looks, meters, grids } = &mut self.notes;
        let notes = [
            (views, &patch.views, &mut inverse.views),
            (looks, &patch.looks, &mut inverse.looks),
            (meters, &patch.meters, &mut inverse.meters),
            (grids, &patch.grids, &mut inverse.grids),
        ];
        // From here on nothing can be refused.
        for (own, patch, inverse) in notes {
            for (id, note) in patch {
                inverse.insert(*id, noted(own, *id, note.as_ref()));
            }
        }
        new.lamps.into_iter().for_each(|(id, lamp)| self.lamps[id as usize] = lamp);
        new.groups.into_iter().for_each(|(id, group)| self.groups[id as usize] = group);
        new.things.into_iter().for_each(|(id, thing)| self.things[id as usize] = thing);
        new.materials.into_iter().for_each(|(id, material)| self.materials[id as usize] = material);
        Ok(inverse)
    }

    /// Copies of what a patch is about; or which of it there is not.
    fn touched_of(&self, patch: &Patch) -> Result<Copies, String> {
        fn copies<'a, T: Clone + 'a>(
            all: &'a [T],
            ids: impl Iterator<Item = &'a u32>,
            what: &str,
        ) -> Result<BTreeMap<u32, T>, String> {
            let copy = |id: &u32| match all.get(*id as usize) {
                Some(own) => Ok((*id, own.clone())),
                None => Err(format!("there is no {what} {id}")),
            };
            ids.map(copy).collect()
        }
        Ok(Copies {
            lamps: copies(&self.lamps, patch.lamps.keys(), "lamp")?,
            groups: copies(&self.groups, patch.groups.keys(), "group")?,
            things: copies(&self.things, patch.things.keys(), "object")?,
            materials: copies(&self.materials, patch.materials.keys(), "material")?,
        })
    }

    /// Whether it has the same lamps, things and materials under the same numbers.
    pub(crate) fn is_like(&self, other: &Model) -> bool {
        let lamps = |model: &Model| model.lamps.iter().map(|own| own.file_name.clone()).collect::<Vec<_>>();
        let things = |model: &Model| model.things.iter().map(|own| own.name.clone()).collect::<Vec<_>>();
        let materials =
            |model: &Model| model.materials.iter().map(|own| own.file.name.clone()).collect::<Vec<_>>();
        lamps(self) == lamps(other) && things(self) == things(other) && materials(self) == materials(other)
    }

    /// By what a lamp's light is multiplied, its colour apart.
    pub(crate) fn level_of(&self, lamp: &Lamp) -> f32 {
        let group = self.groups.get(lamp.group as usize).filter(|group| !group.gone);
        let master = group.map_or(1.0, |group| if group.on { group.level } else { 0.0 });
        if lamp.on && !lamp.gone && !lamp.parked { lamp.level * master } else { 0.0 }
    }

    /// The lamp that an instance is or belongs to.
    pub(crate) fn lamp_of(&self, instance: u32) -> Option<u32> {
        let is = |lamp: &Lamp| matches!(&lamp.body, Body::Surface(things) if things.contains(&instance));
        self.lamps.iter().position(is).map(|at| at as u32)
    }
}

/// Changes the fields of a note that a patch names, or all of it away; returns what takes it back. A field that is null is none.
fn noted(own: &mut BTreeMap<u32, Value>, id: u32, note: Option<&Value>) -> Option<Value> {
    let Some(note) = note else { return own.remove(&id) };
    let (Some(Value::Object(before)), Value::Object(fields)) = (own.get_mut(&id), note) else {
        return own.insert(id, note.clone());
    };
    let mut inverse = serde_json::Map::new();
    for (name, field) in fields {
        let old =
            if field.is_null() { before.remove(name) } else { before.insert(name.clone(), field.clone()) };
        inverse.insert(name.clone(), old.unwrap_or_default());
    }
    Some(inverse.into())
}

struct Copies {
    lamps: BTreeMap<u32, Lamp>,
    groups: BTreeMap<u32, Group>,
    things: BTreeMap<u32, Thing>,
    materials: BTreeMap<u32, Coating>,
}

impl Lamp {
    /// Whether it is otherwise than in the file.
    pub(crate) fn is_touched(&self) -> bool {
        let as_it_was =
            self.on && self.level == 1.0 && self.color.mode == Mode::File && !self.parked && !self.gone;
        let there =
            self.place == self.file_place && self.group == self.file_group && self.name == self.file_name;
        self.own || !as_it_was || !there
    }

    pub(crate) fn apply(&mut self, patch: &LampPatch, groups: u32) -> Result<LampPatch, String> {
        if let Some(name) = &patch.name {
            wire::name(name.clone())?;
        }
        if patch.level.is_some_and(|level| !(0.0..=BRIGHTEST).contains(&level)) {
            return Err(format!("a level lies between 0 and {BRIGHTEST}"));
        }
        if patch.group.is_some_and(|group| group >= groups) {
            return Err("there is no such group".into());
        }
        let color = patch.color.as_ref().map(|patch| self.color.apply(patch)).transpose()?;
        let place = patch.place.as_ref().map(|patch| placed(&mut self.place, patch)).transpose()?;
        Ok(LampPatch {
            name: swap(&mut self.name, &patch.name),
            on: swap(&mut self.on, &patch.on),
            level: swap(&mut self.level, &patch.level),
            color,
            group: swap(&mut self.group, &patch.group),
            parked: swap(&mut self.parked, &patch.parked),
            place,
            gone: swap(&mut self.gone, &patch.gone),
        })
    }
}

impl Group {
    fn apply(&mut self, patch: &GroupPatch) -> Result<GroupPatch, String> {
        if let Some(name) = &patch.name {
            wire::name(name.clone())?;
        }
        if patch.level.is_some_and(|level| !(0.0..=BRIGHTEST).contains(&level)) {
            return Err(format!("a level lies between 0 and {BRIGHTEST}"));
        }
        Ok(GroupPatch {
            name: swap(&mut self.name, &patch.name),
            on: swap(&mut self.on, &patch.on),
            level: swap(&mut self.level, &patch.level),
            gone: swap(&mut self.gone, &patch.gone),
        })
    }
}

impl Thing {
    /// Whether it is otherwise than in the file.
    pub(crate) fn is_touched(&self) -> bool {
        self.hidden || !self.locked || self.place != place::surface_place(self.bounds)
    }

    fn apply(&mut self, patch: &ThingPatch) -> Result<ThingPatch, String> {
        let place = patch.place.as_ref().map(|patch| placed(&mut self.place, patch)).transpose()?;
        Ok(ThingPatch {
            place,
            hidden: swap(&mut self.hidden, &patch.hidden),
            locked: swap(&mut self.locked, &patch.locked),
        })
    }
}

impl Coating {
    fn apply(&mut self, patch: &MaterialPatch) -> Result<MaterialPatch, String> {
        let share = |v: f32| (0.0..=1.0).contains(&v);
        let colors = [patch.color, patch.transmittance].into_iter().flatten().flatten();
        let shares = colors.chain(patch.specular).chain(patch.roughness);
        if !shares.into_iter().all(share) {
            return Err("reflectances and roughness lie between 0 and 1".into());
        }
        let (file, own) = (self.of_file(), &mut self.shall);
        // What a material does not have is nothing to it; who wants what the file has wants the file's.
        fn set<T: Copy + PartialEq>(own: &mut Option<T>, file: Option<T>, shall: Option<T>) -> Option<T> {
            let (file, shall) = (file?, shall?);
            let before = own.unwrap_or(file);
            *own = (shall != file).then_some(shall);
            Some(before)
        }
        Ok(MaterialPatch {
            color: set(&mut own.color, file.color, patch.color),
            roughness: set(&mut own.roughness, file.roughness, patch.roughness),
            specular: set(&mut own.specular, file.specular, patch.specular),
            transmittance: set(&mut own.transmittance, file.transmittance, patch.transmittance),
        })
    }

    /// What the file has, of what its kind has.
    pub(crate) fn of_file(&self) -> MaterialPatch {
        let none = MaterialPatch::default();
        let rgb = |color: Rgb| Some(color.to_array());
        match &self.file.bsdf {
            Bsdf::Diffuse(m) => MaterialPatch { color: rgb(m.reflectance), ..none },
            Bsdf::Ward(m) => MaterialPatch {
                color: rgb(m.base.reflectance),
                roughness: Some(m.alpha),
                specular: Some(m.specular.luminance()),
                ..none
            },
            Bsdf::Dielectric(m) => {
                MaterialPatch { transmittance: rgb(m.transmittance), roughness: Some(m.alpha), ..none }
            }
            Bsdf::Pbr(m) => MaterialPatch {
                color: rgb(m.base_color),
                roughness: Some(m.roughness),
                specular: Some(m.specular),
                ..none
            },
        }
    }
}

/// Sets what a patch says of a place, whose fields are all there that the thing has; returns what takes it back.
fn placed(own: &mut Place, patch: &Place) -> Result<Place, String> {
    let near = |p: Vec3| p.abs().max_element() < FAR;
    let unit = |v: Vec3| (v.length() - 1.0).abs() < 1e-3;
    let angle = |a: f32| (0.0..=180.0).contains(&a);
    let sound = patch.position.is_none_or(near)
        && patch.aim.is_none_or(near)
        && patch.direction.is_none_or(unit)
        && patch.radius.is_none_or(|r| r > 0.0 && r < FAR)
        && patch.inner.is_none_or(angle)
        && patch.outer.is_none_or(angle)
        && patch.rotation.is_none_or(|q: Quat| (q.length() - 1.0).abs() < 1e-3)
        && patch.scale.is_none_or(|s| (1e-3..=1e3).contains(&s));
    if !sound {
        return Err("a place that makes no sense".into());
    }
    let patch = &pointed(own, patch);
    let mut new = own.clone();
    macro_rules! swapped {
        ($($field:ident),*) => {
            Place { $($field: match (&mut new.$field, &patch.$field) {
                (Some(own), shall) => swap(own, shall),
                (None, Some(_)) => return Err(concat!("it has no ", stringify!($field)).into()),
                (None, None) => None,
            }),* }
        };
    }
    let inverse = swapped!(position, direction, aim, radius, inner, outer, rotation, scale);
    if let (Some(inner), Some(outer)) = (new.inner, new.outer)
        && inner >= outer
    {
        return Err("the inner angle of a beam is less than the outer".into());
    }
    *own = new;
    Ok(inverse)
}

/// A patch that keeps what points together: who moves still points at its aim, and who is turned aims elsewhere.
fn pointed(own: &Place, patch: &Place) -> Place {
    let mut patch = patch.clone();
    let (Some(position), Some(aim), Some(direction)) = (own.position, own.aim, own.direction) else {
        return patch;
    };
    let to = patch.position.unwrap_or(position);
    match (patch.aim, patch.direction) {
        (Some(aim), _) => patch.direction = Some((aim - to).normalize_or(direction)),
        (None, Some(direction)) => patch.aim = Some(to + direction * (aim - position).length()),
        (None, None) if patch.position.is_some() => {
            patch.direction = Some((aim - to).normalize_or(direction));
        }
        (None, None) => {}
    }
    patch
}
