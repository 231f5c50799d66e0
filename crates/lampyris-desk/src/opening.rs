//! What people find when a scene opens: its lamps by the luminaires' names, each in a group; its objects and materials.

use crate::color::Color;
use crate::model::{Body, Coating, Group, Lamp, Model, Notes, Thing};
use crate::patch::{MaterialPatch, Place};
use crate::place::{place_of, surface_place};
use glam::Vec3;
use lampyris::Rgb;
use lampyris::light::{Bounds, Emitter, LightKind, State};
use lampyris::scene::{Instance, Scene, Share, Source};
use lampyris::world::World;
use std::collections::{BTreeMap, BTreeSet};

/// What holds the emitters of a lamp together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Light(u32),
    Instance(u32),
    Sky,
}

/// The model of a world whose lamps are sorted into groups.
pub(crate) fn open(world: &World) -> Model {
    let scene = world.scene();
    let things: Vec<Thing> = scene.instances.iter().map(|instance| thing(scene, instance)).collect();
    // In the order in which they first shone: what was added comes last, and keeps its number.
    let mut bonds: Vec<Bond> = Vec::new();
    let mut met = BTreeSet::new();
    bonds.extend(
        scene.reference.shares.iter().map(|share| bond(share.source)).filter(|bond| met.insert(*bond)),
    );
    let names: Vec<String> = bonds.iter().map(|bond| name(scene, *bond)).collect();
    let mut groups: Vec<String> = Vec::new();
    let lamps = bonds.into_iter().zip(&names).zip(unique(&names));
    let lamps = lamps.map(|((bond, file_name), name)| {
        let group = group_name(file_name);
        let number = groups.iter().position(|own| *own == group).unwrap_or_else(|| {
            groups.push(group);
            groups.len() - 1
        });
        lamp(world, &things, bond, name, number as u32, &names)
    });
    let lamps = lamps.collect();
    let groups = groups.into_iter().map(|name| Group { name, on: true, level: 1.0, gone: false }).collect();
    let materials = scene
        .materials
        .iter()
        .map(|m| Coating { file: m.clone(), shall: MaterialPatch::default() })
        .collect();
    Model { lamps, groups, things, materials, notes: Notes::default() }
}

fn bond(source: Source) -> Bond {
    match source {
        Source::Light(light) => Bond::Light(light),
        Source::Side { instance, .. } => Bond::Instance(instance),
        Source::Environment => Bond::Sky,
    }
}

fn name(scene: &Scene, bond: Bond) -> String {
    let name = match bond {
        Bond::Light(light) => scene.lights.get(light as usize).map(|light| light.name.clone()),
        Bond::Instance(instance) => scene.instances.get(instance as usize).map(|i| i.name.clone()),
        Bond::Sky => Some("sky".into()),
    };
    name.filter(|name| !name.is_empty()).unwrap_or_else(|| "lamp".into())
}

/// Names, those that occur again with a number.
fn unique(names: &[String]) -> Vec<String> {
    let mut count: BTreeMap<&str, u32> = BTreeMap::new();
    names.iter().for_each(|name| *count.entry(name).or_default() += 1);
    let mut met: BTreeMap<&str, u32> = BTreeMap::new();
    let numbered = |name: &'_ String| {
        if count[name.as_str()] == 1 {
            return name.clone();
        }
        let number = met.entry(names.iter().find(|own| *own == name).map_or("", String::as_str)).or_default();
        *number += 1;
        format!("{name} {number}")
    };
    names.iter().map(numbered).collect()
}

/// A lamp's group: its name without the number at the end, panel_1 and panel_2 are one row.
fn group_name(name: &str) -> String {
    let stem =
        name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches(['_', '-', '.', ' ', '#']);
    if stem.is_empty() { name.to_owned() } else { stem.to_owned() }
}

fn lamp(world: &World, things: &[Thing], bond: Bond, name: String, group: u32, names: &[String]) -> Lamp {
    let scene = world.scene();
    let shares = (0..).zip(&scene.reference.shares);
    let base =
        |share: &Share| scene.groups.get(usize::from(share.group)).map_or(Rgb::WHITE, |group| group.color);
    let own = shares
        .filter(|(_, share)| self::bond(share.source) == bond)
        .map(|(number, share)| (number, base(share)));
    let emitters: Vec<(u32, Rgb)> = own.collect();
    let own = || emitters.iter().filter_map(|(k, _)| world.emitters().get(*k as usize));
    let power = own().fold(Rgb::BLACK, |sum, emitter| sum + emitter.power(Bounds::default()));
    let luminance = power.luminance();
    let shining = if luminance > 0.0 { power * (1.0 / luminance) } else { Rgb::WHITE };
    // Lamps that the mix colours are white themselves.
    let file = emitters.first().map_or(shining, |(_, base)| *base * shining);
    let extent = own().filter_map(Emitter::extent).reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    let (body, place) = match bond {
        Bond::Light(light) => {
            let kind = scene.lights[light as usize].kind.clone();
            let place = place_of(&kind);
            (Body::Light(light, kind), place)
        }
        Bond::Instance(instance) => {
            let moved = luminaire(things, instance, names);
            let [low, high] = extent.unwrap_or_default();
            (Body::Surface(moved), surface_place([low, high]))
        }
        Bond::Sky => (Body::Sky, Place::default()),
    };
    let finite = !matches!(&body, Body::Sky | Body::Light(_, LightKind::Directional { .. }));
    let on = match body {
        Body::Light(light, _) => scene.lights[light as usize].state == State::On,
        _ => true,
    };
    Lamp {
        file_name: name.clone(),
        name,
        body,
        on,
        level: 1.0,
        color: Color::of_file(file),
        group,
        parked: false,
        gone: false,
        own: false,
        file_place: place.clone(),
        file_group: group,
        place,
        flux: finite.then_some(luminance),
        emitters,
        shining,
        bounds: extent,
    }
}

/// The things that move with a lamp: those of the same object, if it is the only lamp in it.
fn luminaire(things: &[Thing], instance: u32, names: &[String]) -> Vec<u32> {
    let within = |name: &str, object: &str| {
        name.strip_prefix(object).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    let Some((object, _)) = things[instance as usize].name.split_once('/') else { return vec![instance] };
    if names.iter().filter(|name| within(name, object)).count() > 1 {
        return vec![instance];
    }
    let parts = (0..).zip(things).filter(|(_, thing)| within(&thing.name, object));
    // The glowing part first: it says where the lamp is.
    std::iter::once(instance).chain(parts.map(|(k, _)| k).filter(|k| *k != instance)).collect()
}

fn thing(scene: &Scene, instance: &Instance) -> Thing {
    let mesh = scene.meshes.get(instance.mesh as usize);
    let corners = mesh.iter().flat_map(|mesh| &mesh.positions);
    let corners = corners.map(|p| instance.transform.transform_point3(*p));
    let none = [Vec3::INFINITY, Vec3::NEG_INFINITY];
    let bounds = corners.fold(none, |[low, high], p| [low.min(p), high.max(p)]);
    let bounds = if bounds[0].is_finite() { bounds } else { [Vec3::ZERO; 2] };
    let mut materials = mesh.map_or(Vec::new(), |mesh| mesh.materials.clone());
    materials.sort_unstable();
    materials.dedup();
    Thing {
        name: instance.name.clone(),
        mesh: instance.mesh,
        transform: instance.transform,
        bounds,
        materials,
        place: surface_place(bounds),
        hidden: false,
        locked: true,
    }
}
