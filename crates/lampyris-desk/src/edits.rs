//! What a model says of places, shapes and surfaces, as edits of the scene: those by which it differs.

use crate::model::{Body, Coating, Lamp, Model, Touched};
use crate::patch::Place;
use crate::place::{moved, place_of};
use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::light::{Beam, LightKind, State};
use lampyris::material::{Bsdf, Material};
use lampyris::scene::{Edit, Instance, Scene};
use std::collections::BTreeSet;

/// Brings a scene to what a model says of what was touched, and returns the edits that did so. Where one is refused, those
/// before it are done.
pub(crate) fn edits(model: &Model, scene: &mut Scene, touched: &Touched) -> Result<Vec<Edit>, String> {
    let mut wanted = Vec::new();
    let mut things: BTreeSet<u32> = touched.things.clone();
    for lamp in touched.lamps.iter().filter_map(|id| model.lamps.get(*id as usize)) {
        match &lamp.body {
            Body::Light(light, file) => wanted.extend(light_edits(scene, *light, file, lamp)),
            Body::Surface(parts) => things.extend(parts),
            Body::Sky => {}
        }
    }
    for thing in things {
        wanted.extend(thing_edits(model, scene, thing));
    }
    for material in &touched.materials {
        let Some((coating, now)) =
            model.materials.get(*material as usize).zip(scene.materials.get(*material as usize))
        else {
            continue;
        };
        let to = finished(coating, now);
        if to != *now {
            wanted.push(Edit::Material { material: *material, to: Box::new(to) });
        }
    }
    let mut done = Vec::new();
    for edit in wanted {
        scene.apply(&edit).map_err(|e| e.to_string())?;
        done.push(edit);
    }
    Ok(done)
}

fn light_edits(scene: &Scene, light: u32, file: &LightKind, lamp: &Lamp) -> Vec<Edit> {
    let Some(now) = scene.lights.get(light as usize) else { return Vec::new() };
    let kind = lit_at(file, &lamp.place).with_brightness(now.kind.brightness());
    let state = match (lamp.gone, lamp.parked) {
        (true, _) => State::Away,
        (_, true) => State::Off,
        _ => State::On,
    };
    let kind = (kind != now.kind).then_some(Edit::Light { light, kind });
    let state = (state != now.state).then_some(Edit::Switch { light, state });
    kind.into_iter().chain(state).collect()
}

/// A light in its place.
pub(crate) fn lit_at(file: &LightKind, place: &Place) -> LightKind {
    let mut kind = file.clone();
    match &mut kind {
        LightKind::Point { position, .. } => *position = place.position.unwrap_or(*position),
        LightKind::Spot { position, direction, beam, .. } => {
            *position = place.position.unwrap_or(*position);
            *direction = place.direction.unwrap_or(*direction);
            let before = place_of(file);
            if let Beam::Cone { cos_inner, cos_outer } = beam
                && (place.inner, place.outer) != (before.inner, before.outer)
            {
                let cosine = |angle: f32| libm::cosf((0.5 * angle).to_radians());
                *cos_inner = place.inner.map_or(*cos_inner, cosine);
                *cos_outer = place.outer.map_or(*cos_outer, cosine);
            }
        }
        LightKind::Directional { direction, .. } => *direction = place.direction.unwrap_or(*direction),
        LightKind::Sphere { center, radius, .. } => {
            *center = place.position.unwrap_or(*center);
            *radius = place.radius.unwrap_or(*radius);
        }
        LightKind::Disc { center, normal, radius, .. } => {
            *center = place.position.unwrap_or(*center);
            *radius = place.radius.unwrap_or(*radius);
            *normal = place.direction.unwrap_or(*normal);
        }
    }
    kind
}

fn thing_edits(model: &Model, scene: &Scene, thing: u32) -> Vec<Edit> {
    let Some((own, now)) = model.things.get(thing as usize).zip(scene.instances.get(thing as usize)) else {
        return Vec::new();
    };
    let carrier = model.lamp_of(thing).map(|lamp| &model.lamps[lamp as usize]);
    let middle = |[low, high]: [Vec3; 2]| low + (high - low) * 0.5;
    let mut transform = moved(own.transform, middle(own.bounds), &own.place);
    if let Some((lamp, bounds)) = carrier.and_then(|lamp| lamp.bounds.map(|bounds| (lamp, bounds))) {
        let motion = moved(Affine3A::IDENTITY, middle(bounds), &lamp.place);
        if motion != Affine3A::IDENTITY {
            transform = motion * transform;
        }
    }
    let mesh = (!own.hidden && !carrier.is_some_and(|lamp| lamp.gone)).then_some(own.mesh);
    let shown = (now.mesh != Instance::AWAY).then_some(now.mesh);
    let moves = (transform != now.transform).then_some(Edit::Move { instance: thing, transform });
    let shows = (mesh != shown).then_some(Edit::Mesh { instance: thing, mesh });
    moves.into_iter().chain(shows).collect()
}

/// A material as it shall be. What it sends out is the lamps' business.
fn finished(coating: &Coating, now: &Material) -> Material {
    let mut to = Material { emission: now.emission, ..coating.file.clone() };
    let shall = &coating.shall;
    let rgb = |[r, g, b]: [f32; 3]| Rgb::new(r, g, b);
    let color = shall.color.map(rgb);
    match &mut to.bsdf {
        Bsdf::Diffuse(m) => m.reflectance = color.unwrap_or(m.reflectance),
        Bsdf::Ward(m) => {
            m.base.reflectance = color.unwrap_or(m.base.reflectance);
            m.specular = shall.specular.map_or(m.specular, Rgb::grey);
            m.alpha = shall.roughness.unwrap_or(m.alpha);
        }
        Bsdf::Dielectric(m) => {
            m.transmittance = shall.transmittance.map_or(m.transmittance, rgb);
            m.alpha = shall.roughness.unwrap_or(m.alpha);
        }
        Bsdf::Pbr(m) => {
            m.base_color = color.unwrap_or(m.base_color);
            m.roughness = shall.roughness.unwrap_or(m.roughness);
            m.specular = shall.specular.unwrap_or(m.specular);
        }
    }
    to
}
