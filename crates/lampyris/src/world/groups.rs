//! Light groups: which lamps are summed apart, so that dimming and colouring them is arithmetic and no light transport.
//!
//! Light is linear in what each lamp sends out, channel by channel. The lamps of a group are made white, of the luminance
//! that they have in the file, and their colour becomes the first value of the group's mix. What is of several colours, or
//! painted by a texture, keeps them, and is tinted.

use super::World;
use crate::color::Rgb;
use crate::error::Result;
use crate::material::Material;
use crate::scene::{Edit, Group, Scene, Share, Source};
use std::collections::BTreeMap;

/// What holds the lamps of a group together.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    /// The luminaire's name in the file, and its colour if it has but one.
    Name(String, Option<Tint>),
    /// The material that glows.
    Material(u32),
    /// Nothing but that there are too many of them.
    Rest,
}

/// A colour of luminance 1, in 4096ths.
type Tint = [i32; 3];

impl World {
    /// Sorts the lamps into at most `most` groups (1 to [`Group::MOST`]): by the names of luminaires, the strongest first, then by material.
    /// Lamps that are sorted already stay as they are. Where there is no lamp there is a group that is empty.
    ///
    /// # Errors
    /// None that a scene could cause which was read without one.
    pub fn separate(&mut self, most: usize) -> Result<()> {
        let shares = self.scene.reference.shares.clone();
        if !self.scene.groups.is_empty() {
            return Ok(());
        }
        if shares.is_empty() {
            self.change_scene(|scene| scene.groups.push(Group { name: "none".into(), color: Rgb::WHITE }));
            return Ok(());
        }
        let bonds = bonds(&self.scene, &shares, most.clamp(1, Group::MOST));
        let mut groups: Vec<Group> = Vec::new();
        let mut numbers: BTreeMap<&Bond, u16> = BTreeMap::new();
        let numbers: Vec<u16> = (bonds.iter().zip(&shares))
            .map(|(bond, share)| {
                *numbers.entry(bond).or_insert_with(|| {
                    groups.push(Group { name: bond.name(&self.scene, share), color: Rgb::WHITE });
                    groups.len() as u16 - 1
                })
            })
            .collect();
        // A material's colour is taken out for all its users or for none.
        let mixed = |source: Source| {
            let same = |other: Source| match (source, other) {
                (Source::Side { material: a, .. }, Source::Side { material: b, .. }) => a == b,
                _ => source == other,
            };
            let keeps = |bond: &Bond| matches!(bond, Bond::Rest | Bond::Name(_, None));
            bonds.iter().zip(&shares).any(|(bond, share)| keeps(bond) && same(share.source))
        };
        let mut edits = Vec::new();
        for (number, share) in numbers.iter().zip(&shares) {
            if let Some(color) = tint(&self.scene, share.source).filter(|_| !mixed(share.source)) {
                groups[usize::from(*number)].color = color;
                edits.push(whiten(&self.scene, share.source));
            }
        }
        self.emitters.reference.shares.iter_mut().zip(&numbers).for_each(|(share, n)| share.group = *n);
        let reference = self.emitters.reference.clone();
        self.change_scene(|scene| (scene.groups, scene.reference) = (groups, reference));
        edits.iter().flatten().try_for_each(|edit| self.apply(edit).map(drop))
    }

    /// Gives emitters that are new since `known` of them a group: one of their own, or that of the same surface.
    pub(super) fn group_from(&mut self, known: usize) {
        let mut groups = self.scene.groups.clone();
        if groups.is_empty() {
            return;
        }
        let shares = &mut self.emitters.reference.shares;
        for k in known..shares.len() {
            let surface = |source: Source| match source {
                Source::Side { instance, .. } => Some(instance),
                _ => None,
            };
            let own = surface(shares[k].source);
            let same = shares[known..k].iter().find(|s| own.is_some() && surface(s.source) == own);
            let group = same.map(|s| s.group).unwrap_or_else(|| {
                if groups.len() < Group::MOST {
                    groups.push(Group { name: name(&self.scene, shares[k].source), color: Rgb::WHITE });
                }
                groups.len() as u16 - 1
            });
            shares[k].group = group;
        }
        self.change_scene(|scene| scene.groups = groups);
    }
}

impl Bond {
    /// What to call a group of it, to which `share` belongs.
    fn name(&self, scene: &Scene, share: &Share) -> String {
        match self {
            Bond::Name(name, _) => name.clone(),
            Bond::Material(material) => scene.materials[*material as usize].name.clone(),
            Bond::Rest if scene.reference.shares.len() == 1 => name(scene, share.source),
            Bond::Rest => "others".into(),
        }
    }
}

/// What each emitter is sorted by, so that there are at most `most` different ones.
fn bonds(scene: &Scene, shares: &[Share], most: usize) -> Vec<Bond> {
    let tint = |share: &Share| {
        let color = tint(scene, share.source).unwrap_or(Rgb::WHITE);
        color.to_array().map(|c| libm::roundf(c * 4096.0) as i32)
    };
    let mut tints: BTreeMap<String, Option<Tint>> = BTreeMap::new();
    for share in shares {
        let tint = Some(tint(share));
        tints
            .entry(name(scene, share.source))
            .and_modify(|own| *own = own.filter(|_| *own == tint))
            .or_insert(tint);
    }
    let by_name = |share: &Share| {
        let name = name(scene, share.source);
        let tint = tints.get(&name).copied().flatten();
        (!name.is_empty()).then_some(Bond::Name(name, tint))
    };
    let by_material = |share: &Share| match share.source {
        Source::Side { material, .. } => Bond::Material(material),
        _ => Bond::Rest,
    };
    let own: Vec<Bond> = shares.iter().map(|s| by_name(s).unwrap_or_else(|| by_material(s))).collect();
    let mut weights: BTreeMap<&Bond, f32> = BTreeMap::new();
    own.iter().zip(shares).for_each(|(bond, share)| *weights.entry(bond).or_default() += share.share);
    let mut strongest: Vec<(&Bond, f32)> = weights.into_iter().collect();
    // Equal ones in the order of their names.
    strongest.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let keep = |count: usize, other: &dyn Fn(&Share) -> Bond| -> Vec<Bond> {
        let kept = |bond: &Bond| strongest[..count].iter().any(|(k, _)| *k == bond);
        let pick = |(bond, share): (&Bond, &Share)| if kept(bond) { bond.clone() } else { other(share) };
        own.iter().zip(shares).map(pick).collect()
    };
    let fits = |bonds: &Vec<Bond>| {
        let mut different = bonds.clone();
        different.sort();
        different.dedup();
        different.len() <= most
    };
    let counts = || (0..=strongest.len().min(most)).rev();
    let sorted = counts().map(|count| keep(count, &by_material)).find(fits);
    let crowded = || counts().map(|count| keep(count, &|_| Bond::Rest)).find(fits);
    sorted.or_else(crowded).unwrap_or_else(|| vec![Bond::Rest; shares.len()])
}

/// What the file calls a lamp.
fn name(scene: &Scene, source: Source) -> String {
    match source {
        Source::Light(k) => scene.lights.get(k as usize).map_or(String::new(), |light| light.name.clone()),
        Source::Side { instance, .. } => scene.instances[instance as usize].name.clone(),
        Source::Environment => "environment".into(),
    }
}

/// The colour of a lamp, of luminance 1; `None` where it is not of one colour.
fn tint(scene: &Scene, source: Source) -> Option<Rgb> {
    let color = match source {
        Source::Light(k) => scene.lights.get(k as usize)?.kind.brightness(),
        Source::Side { material, .. } => plain(&scene.materials[material as usize])?,
        Source::Environment => return None,
    };
    let luminance = color.luminance();
    (luminance > 0.0).then(|| color * (1.0 / luminance))
}

/// The emission of a material that no texture paints.
fn plain(material: &Material) -> Option<Rgb> {
    material.maps.emission.is_none().then_some(material.emission)
}

/// Makes a lamp white.
fn whiten(scene: &Scene, source: Source) -> Option<Edit> {
    match source {
        Source::Light(light) => {
            let kind = scene.lights.get(light as usize)?.kind.clone();
            let white = Rgb::grey(kind.brightness().luminance());
            Some(Edit::Light { light, kind: kind.with_brightness(white) })
        }
        Source::Side { material, .. } => {
            let emission = Rgb::grey(scene.materials[material as usize].emission.luminance());
            Some(Edit::Emission { material, emission })
        }
        Source::Environment => None,
    }
}
