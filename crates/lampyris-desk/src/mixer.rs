//! Levels and colours of lamps as a mix of layers, which costs no ray. Lamps that shall be alike may share a layer; one that
//! shall differ from the others of its layer gets a layer to itself, as long as there are some.

use crate::model::{Lamp, Model};
use lampyris::Rgb;
use lampyris::scene::{Edit, Group, Scene};

/// Most layers that lamps are taken apart into: each costs 24 bytes a pixel, and its share of every batch.
pub(crate) const LAYERS: usize = 24;

/// What a lamp's light is multiplied by, by the colour of its layer when the scene was opened.
fn wanted(model: &Model, lamp: &Lamp, base: Rgb) -> Rgb {
    let level = model.level_of(lamp);
    if level == 0.0 {
        return Rgb::BLACK;
    }
    let color = lamp.color.light().map_or(base, |color| {
        // Light is linear channel by channel; a channel that a lamp does not have stays dark.
        let channel = |k: usize| if lamp.shining[k] > 1e-6 { color[k] / lamp.shining[k] } else { 0.0 };
        Rgb::new(channel(0), channel(1), channel(2))
    });
    color * level
}

/// What a model wants of each layer of a scene as its lamps are sorted now, and whether it can be had so: of lamps that share
/// a layer and are to differ it is the mean, by their flux.
pub(crate) fn colors(model: &Model, scene: &Scene) -> (Vec<Rgb>, bool) {
    let mut exact = true;
    let mut wanting: Vec<Vec<(Rgb, f32)>> = vec![Vec::new(); scene.groups.len()];
    for lamp in &model.lamps {
        for (emitter, base) in &lamp.emitters {
            let share = scene.reference.shares.get(*emitter as usize);
            if let Some(own) = share.and_then(|share| wanting.get_mut(usize::from(share.group))) {
                own.push((wanted(model, lamp, *base), lamp.flux.unwrap_or(1.0) / lamp.emitters.len() as f32));
            }
        }
    }
    let mean = |(own, group): (&Vec<(Rgb, f32)>, &Group)| match own.as_slice() {
        [] => group.color,
        // Where all want the same it is that, to the bit.
        [(first, _), rest @ ..] if rest.iter().all(|(color, _)| color == first) => *first,
        all => {
            exact = false;
            let flux = all.iter().map(|(_, flux)| flux).sum::<f32>();
            all.iter().fold(Rgb::BLACK, |sum, (color, flux)| sum + *color * *flux) * (1.0 / flux.max(1e-9))
        }
    };
    let colors = wanting.iter().zip(&scene.groups).map(mean).collect();
    (colors, exact)
}

/// What is wanted of a lamp's light: its colour, and that in what it is compared with.
type Shall = (Rgb, Option<Rgb>);

/// Brings the layers of a scene to what a model wants of them, and returns the edits that did so; or why there are too few
/// layers, and the scene is as it was. Lamps that share a layer are alike in another model too, if there is one, so that
/// a mix of the layers shows that as well.
pub(crate) fn mix(model: &Model, against: Option<&Model>, scene: &mut Scene) -> Result<Vec<Edit>, String> {
    let before = (scene.groups.clone(), scene.reference.clone());
    let mut edits = Vec::new();
    let done = separate(model, against, scene, &mut edits);
    if done.is_err() {
        (scene.groups, scene.reference) = before;
    }
    done.map(|()| edits)
}

fn separate(
    model: &Model,
    against: Option<&Model>,
    scene: &mut Scene,
    edits: &mut Vec<Edit>,
) -> Result<(), String> {
    let mut colors: Vec<Option<Shall>> = vec![None; scene.reference.shares.len()];
    for (number, lamp) in model.lamps.iter().enumerate() {
        let other = against.and_then(|model| Some((model, model.lamps.get(number)?)));
        for (emitter, base) in &lamp.emitters {
            if let Some(color) = colors.get_mut(*emitter as usize) {
                let other = other.map(|(model, lamp)| wanted(model, lamp, *base));
                *color = Some((wanted(model, lamp, *base), other));
            }
        }
    }
    let mut act = |scene: &mut Scene, edit: Edit| -> Result<(), String> {
        scene.apply(&edit).map_err(|e| e.to_string())?;
        edits.push(edit);
        Ok(())
    };
    for group in 0..scene.groups.len() as u16 {
        let mut classes = classes(scene, &colors, group);
        // The largest stays; of equal ones the first.
        let largest = (0..classes.len()).rev().max_by_key(|k| classes[*k].1.len());
        let Some(largest) = largest else { continue };
        let (color, _) = classes.remove(largest);
        for (color, emitters) in classes {
            let to = place_for(scene, &colors, group, color).ok_or_else(|| {
                format!(
                    "all {LAYERS} layers are in use: lamps that shall differ from each other must be fewer"
                )
            })?;
            if let Place::Cleared { from, to } = to {
                let emitters = members(scene, from);
                act(scene, Edit::Regroup { emitters, group: to })?;
            }
            let to = match to {
                Place::Group(to) => to,
                Place::Cleared { from, .. } => from,
            };
            act(scene, Edit::Regroup { emitters, group: to })?;
            dye(scene, to, color, &mut act)?;
        }
        dye(scene, group, color, &mut act)?;
    }
    Ok(())
}

/// Gives a layer a colour, if it has another.
fn dye(
    scene: &mut Scene,
    group: u16,
    color: Option<Shall>,
    act: &mut impl FnMut(&mut Scene, Edit) -> Result<(), String>,
) -> Result<(), String> {
    match color.map(|(color, _)| color).filter(|color| scene.groups[usize::from(group)].color != *color) {
        Some(color) => act(scene, Edit::Mix { group, color }),
        None => Ok(()),
    }
}

/// Where lamps may go.
enum Place {
    Group(u16),
    /// Into one layer, when its lamps have gone to those of another that shall look the same.
    Cleared {
        from: u16,
        to: u16,
    },
}

fn members(scene: &Scene, group: u16) -> Vec<u32> {
    let shares = (0..).zip(&scene.reference.shares);
    shares.filter(|(_, share)| share.group == group).map(|(number, _)| number).collect()
}

/// Emitters of a layer by what is wanted of them; of those that are nobody's nothing is.
fn classes(scene: &Scene, colors: &[Option<Shall>], group: u16) -> Vec<(Option<Shall>, Vec<u32>)> {
    let mut classes: Vec<(Option<Shall>, Vec<u32>)> = Vec::new();
    for emitter in members(scene, group) {
        let color = colors[emitter as usize];
        match classes.iter_mut().find(|(own, _)| *own == color) {
            Some((_, all)) => all.push(emitter),
            None => classes.push((color, vec![emitter])),
        }
    }
    classes
}

/// A layer for lamps that shall be of a colour, taken out of `not`.
fn place_for(scene: &Scene, colors: &[Option<Shall>], not: u16, color: Option<Shall>) -> Option<Place> {
    let others = || (0..scene.groups.len() as u16).filter(move |group| *group != not);
    if let Some(empty) = others().find(|group| members(scene, *group).is_empty()) {
        return Some(Place::Group(empty));
    }
    if scene.groups.len() < LAYERS {
        return Some(Place::Group(scene.groups.len() as u16));
    }
    let whole: Vec<(u16, Option<Shall>)> = others()
        .filter_map(|group| match classes(scene, colors, group).as_slice() {
            [(color, _)] => Some((group, *color)),
            _ => None,
        })
        .collect();
    if let Some((group, _)) = whole.iter().find(|(_, own)| *own == color) {
        return Some(Place::Group(*group));
    }
    let twin = |(to, own): &(u16, Option<Shall>)| {
        let from = whole.iter().find(|(from, other)| from > to && own == other)?;
        Some(Place::Cleared { from: from.0, to: *to })
    };
    whole.iter().find_map(twin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adding;
    use crate::model;
    use glam::Vec3;
    use lampyris::light::{Light, LightKind};

    /// Lamps of one layer that are alike, but not in what they are compared with, get layers of their own, and nothing looks
    /// otherwise; then both can be shown as they are.
    #[test]
    fn what_is_compared_with_has_layers_too() {
        let mut scene = Scene::default();
        let mut now = Model::default();
        now.groups.push(model::Group { name: "all".into(), on: true, level: 1.0, gone: false });
        for number in 0..4 {
            let position = Vec3::splat(number as f32);
            let light = Light::new(number.to_string(), LightKind::Point { position, intensity: Rgb::WHITE });
            scene.apply(&Edit::AddLight { light: light.clone() }).unwrap();
            let emitter = adding::enter(&mut scene, number);
            now.lamps.push(adding::lamp(number, &light, emitter, 0));
        }
        for emitter in [1, 2] {
            scene.apply(&Edit::Regroup { emitters: vec![emitter], group: 0 }).unwrap();
        }
        let mut then = now.clone();
        (then.lamps[1].level, then.lamps[3].on) = (0.5, false);
        let half = (Rgb::grey(2.0) + Rgb::grey(0.5)) * (1.0 / 3.0);
        let (mixed, exact) = colors(&then, &scene);
        assert!(!exact && (mixed[0].luminance() - half.luminance()).abs() < 1e-6, "{mixed:?}");
        assert_eq!(mix(&now, None, &mut scene), Ok(Vec::new()));
        let edits = mix(&now, Some(&then), &mut scene).unwrap();
        assert!(!edits.is_empty() && edits.iter().all(|edit| matches!(edit, Edit::Regroup { .. })));
        let shown = |model: &Model, scene: &Scene| {
            let (colors, exact) = colors(model, scene);
            assert!(exact);
            let of = |k: usize| colors[usize::from(scene.reference.shares[k].group)];
            (0..4).map(of).collect::<Vec<Rgb>>()
        };
        assert_eq!(shown(&now, &scene), [Rgb::WHITE; 4]);
        assert_eq!(shown(&then, &scene), [Rgb::WHITE, Rgb::grey(0.5), Rgb::WHITE, Rgb::BLACK]);
        // That is all there is to do, also where it is no more compared.
        assert_eq!(mix(&now, Some(&then), &mut scene), Ok(Vec::new()));
        assert_eq!(mix(&now, None, &mut scene), Ok(Vec::new()));
    }
}
