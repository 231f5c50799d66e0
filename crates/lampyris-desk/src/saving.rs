//! What a desk keeps in a document beside the edits of the scene: what faders, places and colours people see, so that they
//! find them as they left them. Lamps and objects go by their names; of those that are as in the file nothing is kept.

use crate::model::{Body, Group, Lamp, Model, Thing};
use crate::patch::{LampPatch, MaterialPatch, Place};
use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::light::LightKind;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// The section of a document.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
struct Kept {
    groups: Vec<KeptGroup>,
    lamps: BTreeMap<String, KeptLamp>,
    things: BTreeMap<String, KeptThing>,
    materials: BTreeMap<String, KeptMaterial>,
    views: BTreeMap<u32, Value>,
    looks: BTreeMap<u32, Value>,
    meters: BTreeMap<u32, Value>,
    grids: BTreeMap<u32, Value>,
}

#[derive(Debug, Serialize, Deserialize)]
struct KeptGroup {
    name: String,
    on: bool,
    level: f32,
    #[serde(default)]
    gone: bool,
}

#[derive(Debug, Serialize, Deserialize)]
struct KeptLamp {
    /// What people call it.
    name: String,
    shall: LampPatch,
    /// As in the file.
    file: FileLamp,
}

#[derive(Debug, Serialize, Deserialize)]
struct FileLamp {
    place: Place,
    colors: Vec<Rgb>,
    shining: Rgb,
    flux: Option<f32>,
    own: bool,
    kind: Option<LightKind>,
    bounds: Option<[Vec3; 2]>,
}

#[derive(Debug, Serialize, Deserialize)]
struct KeptThing {
    place: Place,
    hidden: bool,
    locked: bool,
    mesh: u32,
    transform: Affine3A,
    bounds: [Vec3; 2],
    materials: Vec<u32>,
}

#[derive(Debug, Serialize, Deserialize)]
struct KeptMaterial {
    shall: MaterialPatch,
    file: lampyris::material::Material,
}

/// Names by number, those that occur again counted.
fn paths<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut met: BTreeMap<&str, u32> = BTreeMap::new();
    let path = |name: &'a str| {
        let count = met.entry(name).or_default();
        *count += 1;
        if *count == 1 { name.to_owned() } else { format!("{name}#{count}") }
    };
    names.map(path).collect()
}

/// What to keep of a model.
pub(crate) fn kept(model: &Model) -> Value {
    let group =
        |own: &Group| KeptGroup { name: own.name.clone(), on: own.on, level: own.level, gone: own.gone };
    let lamps = paths(model.lamps.iter().map(|own| own.file_name.as_str()));
    let lamps = lamps.into_iter().zip(&model.lamps).filter(|(_, own)| own.is_touched());
    let things = paths(model.things.iter().map(|own| own.name.as_str()));
    let things = things.into_iter().zip(&model.things).filter(|(_, own)| own.is_touched());
    let materials = paths(model.materials.iter().map(|own| own.file.name.as_str()));
    let materials = materials.into_iter().zip(&model.materials);
    let materials = materials.filter(|(_, own)| own.shall != MaterialPatch::default());
    let kept = Kept {
        groups: model.groups.iter().map(group).collect(),
        lamps: lamps.map(|(path, own)| (path, lamp(own))).collect(),
        things: things.map(|(path, own)| (path, thing(own))).collect(),
        materials: materials
            .map(|(path, own)| (path, KeptMaterial { shall: own.shall.clone(), file: own.file.clone() }))
            .collect(),
        views: model.notes.views.clone(),
        looks: model.notes.looks.clone(),
        meters: model.notes.meters.clone(),
        grids: model.notes.grids.clone(),
    };
    serde_json::to_value(kept).unwrap_or_default()
}

fn lamp(own: &Lamp) -> KeptLamp {
    let shall = LampPatch {
        name: None,
        on: Some(own.on),
        level: Some(own.level),
        color: Some(own.color.whole()),
        group: Some(own.group),
        parked: Some(own.parked),
        place: Some(own.place.clone()),
        gone: Some(own.gone),
    };
    let kind = match &own.body {
        Body::Light(_, kind) => Some(kind.clone()),
        _ => None,
    };
    let file = FileLamp {
        place: own.file_place.clone(),
        colors: own.emitters.iter().map(|(_, color)| *color).collect(),
        shining: own.shining,
        flux: own.flux,
        own: own.own,
        kind,
        bounds: own.bounds,
    };
    KeptLamp { name: own.name.clone(), shall, file }
}

fn thing(own: &Thing) -> KeptThing {
    KeptThing {
        place: own.place.clone(),
        hidden: own.hidden,
        locked: own.locked,
        mesh: own.mesh,
        transform: own.transform,
        bounds: own.bounds,
        materials: own.materials.clone(),
    }
}

/// Makes the model of an edited scene what it was when it was kept; returns what of it had no place, a line each.
pub(crate) fn restore(model: &mut Model, value: &Value) -> Vec<String> {
    if value.is_null() {
        return Vec::new();
    }
    let kept: Kept = match Kept::deserialize(value) {
        Ok(kept) => kept,
        Err(error) => return vec![format!("what the desk kept cannot be read: {error}")],
    };
    let mut lost = Vec::new();
    let find = |all: &[String], path: &str| all.iter().position(|own| own == path);
    if !kept.groups.is_empty() {
        let old: Vec<Group> = std::mem::take(&mut model.groups);
        let group = |own: KeptGroup| Group { name: own.name, on: own.on, level: own.level, gone: own.gone };
        model.groups = kept.groups.into_iter().map(group).collect();
        // Lamps that are new since find a group of their name, or bring it.
        let paths_of = paths(model.lamps.iter().map(|own| own.file_name.as_str()));
        let new = paths_of.iter().zip(&mut model.lamps).filter(|(path, _)| !kept.lamps.contains_key(*path));
        for (_, lamp) in new {
            let name = old.get(lamp.group as usize).map_or(String::new(), |own| own.name.clone());
            let at = model.groups.iter().position(|own| own.name == name && !own.gone).unwrap_or_else(|| {
                model.groups.push(Group { name, on: true, level: 1.0, gone: false });
                model.groups.len() - 1
            });
            lamp.group = at as u32;
        }
    }
    let paths_of = paths(model.lamps.iter().map(|own| own.file_name.as_str()));
    let groups = model.groups.len() as u32;
    for (path, kept) in kept.lamps {
        let Some(at) = find(&paths_of, &path) else {
            lost.push(format!("lamp {path}"));
            continue;
        };
        let own = &mut model.lamps[at];
        let FileLamp { place, colors, shining, flux, own: added, kind, bounds } = kept.file;
        let before = own.clone();
        own.file_group = own.file_group.min(groups.saturating_sub(1));
        (own.file_place, own.place) = (place.clone(), place);
        (own.shining, own.flux, own.own, own.bounds) = (shining, flux, added, bounds);
        own.emitters.iter_mut().zip(colors).for_each(|((_, own), color)| *own = color);
        if let (Body::Light(_, own), Some(kind)) = (&mut own.body, kind) {
            *own = kind;
        }
        own.name = kept.name;
        let mut shall = kept.shall;
        match own.apply(&shall, groups) {
            // As it was written, where applying rounds directions.
            Ok(_) => own.place = shall.place.take().unwrap_or_default(),
            Err(why) => {
                lost.push(format!("lamp {path}: {why}"));
                *own = before;
            }
        }
    }
    let paths_of = paths(model.things.iter().map(|own| own.name.as_str()));
    for (path, kept) in kept.things {
        match find(&paths_of, &path) {
            None => lost.push(format!("object {path}")),
            Some(at) => {
                let KeptThing { place, hidden, locked, mesh, transform, bounds, materials } = kept;
                let own = &mut model.things[at];
                (own.place, own.hidden, own.locked) = (place, hidden, locked);
                (own.mesh, own.transform, own.bounds, own.materials) = (mesh, transform, bounds, materials);
            }
        }
    }
    let paths_of = paths(model.materials.iter().map(|own| own.file.name.as_str()));
    for (path, kept) in kept.materials {
        match find(&paths_of, &path) {
            None => lost.push(format!("material {path}")),
            Some(at) => (model.materials[at].shall, model.materials[at].file) = (kept.shall, kept.file),
        }
    }
    let notes = &mut model.notes;
    (notes.views, notes.looks, notes.meters, notes.grids) = (kept.views, kept.looks, kept.meters, kept.grids);
    lost
}
