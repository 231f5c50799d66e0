//! What all are told of the model, as docs/wire.md says.

use crate::event::{Found, Progress};
use crate::model::{Body, Coating, Group, Lamp, Model, Thing, Touched};
use crate::patch::{GroupPatch, LampPatch, Patch};
use glam::Vec3;
use lampyris::Rgb;
use lampyris::cpu::{Answer, Reading};
use lampyris::light::LightKind;
use lampyris::material::Bsdf;
use lampyris::measuring::Estimate;
use lampyris::scene::{Scene, upward};
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// All that is kept by number.
pub(crate) fn whole(model: &Model, scene: &Scene) -> Value {
    let all = |count: usize| (0..count as u32).collect::<BTreeSet<u32>>();
    let keys = |notes: &BTreeMap<u32, Value>| notes.keys().copied().collect();
    let touched = Touched {
        lamps: all(model.lamps.len()),
        groups: all(model.groups.len()),
        things: all(model.things.len()),
        materials: all(model.materials.len()),
        views: keys(&model.notes.views),
        looks: keys(&model.notes.looks),
        meters: keys(&model.notes.meters),
        grids: keys(&model.notes.grids),
    };
    let mut whole = of(model, scene, &touched);
    for slice in ["lamps", "groups", "things", "materials", "views", "looks", "meters", "grids"] {
        match &mut whole[slice] {
            Value::Object(entries) => entries.retain(|_, entry| !entry.is_null()),
            none => *none = json!({}),
        }
    }
    whole
}

/// What was touched, as it is now; null for what is gone.
pub(crate) fn of(model: &Model, scene: &Scene, touched: &Touched) -> Value {
    fn entries<'a>(ids: &BTreeSet<u32>, entry: impl Fn(u32) -> Value + 'a) -> Value {
        ids.iter().map(|id| (id.to_string(), entry(*id))).collect::<Map<String, Value>>().into()
    }
    let mut patch = Map::new();
    let mut lamps = touched.lamps.clone();
    for thing in &touched.things {
        lamps.extend(model.lamp_of(*thing));
    }
    let mut put = |name: &str, ids: &BTreeSet<u32>, entry: &dyn Fn(u32) -> Value| {
        if !ids.is_empty() {
            patch.insert(name.into(), entries(ids, entry));
        }
    };
    put("lamps", &lamps, &|id| {
        model.lamps.get(id as usize).map_or(Value::Null, |own| lamp(model, scene, own))
    });
    put("groups", &touched.groups, &|id| group(model, id));
    put("things", &touched.things, &|id| model.things.get(id as usize).map_or(Value::Null, thing));
    put("materials", &touched.materials, &|id| {
        model.materials.get(id as usize).map_or(Value::Null, material)
    });
    let notes = &model.notes;
    let kinds = [
        ("views", &touched.views, &notes.views),
        ("looks", &touched.looks, &notes.looks),
        ("meters", &touched.meters, &notes.meters),
        ("grids", &touched.grids, &notes.grids),
    ];
    for (name, ids, notes) in kinds {
        put(name, ids, &|id| notes.get(&id).cloned().unwrap_or_default());
    }
    patch.into()
}

fn lamp(model: &Model, scene: &Scene, own: &Lamp) -> Value {
    if own.gone {
        return Value::Null;
    }
    let group = model.groups.get(own.group as usize).filter(|group| !group.gone).map(|_| own.group);
    let kind = match &own.body {
        Body::Surface(_) => "surface",
        Body::Sky => "sky",
        Body::Light(_, LightKind::Point { .. }) => "point",
        Body::Light(_, LightKind::Spot { .. }) => "spot",
        Body::Light(_, LightKind::Directional { .. }) => "parallel",
        Body::Light(_, LightKind::Sphere { .. }) => "sphere",
        Body::Light(_, LightKind::Disc { .. }) => "disc",
    };
    let layer =
        own.emitters.first().and_then(|(k, _)| scene.reference.shares.get(*k as usize)).map(|s| s.group);
    let base = own.emitters.first().map_or(Rgb::WHITE, |(_, base)| *base);
    let swatch = own.color.light().unwrap_or(base * own.shining);
    json!({
        "name": own.name, "kind": kind, "on": own.on, "level": own.level, "color": own.color, "flux": own.flux,
        "swatch": swatch.to_array(), "group": group, "layer": layer, "free": layer.is_some(), "parked": own.parked,
        "own": own.own, "place": own.place, "box": own.bounds.map(|bounds| shifted(bounds, own.place.position)),
    })
}

/// A box about its new middle.
fn shifted([low, high]: [Vec3; 2], middle: Option<Vec3>) -> [Vec3; 2] {
    let by = middle.map_or(Vec3::ZERO, |middle| middle - (low + (high - low) * 0.5));
    [low + by, high + by]
}

fn group(model: &Model, id: u32) -> Value {
    let Some(own) = model.groups.get(id as usize).filter(|own| !own.gone) else { return Value::Null };
    let lamps = (0..).zip(&model.lamps).filter(|(_, lamp)| lamp.group == id && !lamp.gone);
    let lamps: Vec<u32> = lamps.map(|(number, _)| number).collect();
    json!({"name": own.name, "on": own.on, "level": own.level, "lamps": lamps})
}

fn thing(own: &Thing) -> Value {
    json!({
        "name": own.name, "place": own.place, "hidden": own.hidden, "locked": own.locked, "materials": own.materials,
        "box": shifted(own.bounds, own.place.position),
    })
}

fn material(own: &Coating) -> Value {
    let shall = &own.shall;
    let color = |file: Rgb| shall.color.unwrap_or(file.to_array());
    let mut told = match &own.file.bsdf {
        Bsdf::Diffuse(m) => json!({"kind": "matt", "color": color(m.reflectance)}),
        Bsdf::Ward(m) => json!({
            "kind": "gloss", "color": color(m.base.reflectance), "roughness": shall.roughness.unwrap_or(m.alpha),
            "specular": shall.specular.unwrap_or(m.specular.luminance()),
        }),
        Bsdf::Dielectric(m) => json!({
            "kind": "glass", "transmittance": shall.transmittance.unwrap_or(m.transmittance.to_array()),
            "roughness": shall.roughness.unwrap_or(m.alpha),
        }),
        Bsdf::Pbr(m) => json!({
            "kind": "pbr", "color": color(m.base_color), "roughness": shall.roughness.unwrap_or(m.roughness),
            "specular": shall.specular.unwrap_or(m.specular),
        }),
    };
    told["name"] = own.file.name.clone().into();
    let reflectance = |c: &Value| {
        serde_json::from_value::<[f32; 3]>(c.clone()).map(|[r, g, b]| Rgb::new(r, g, b).luminance())
    };
    told["reflectance"] = json!(told.get("color").and_then(|c| reflectance(c).ok()));
    told
}

/// What does not change while a scene is open.
pub(crate) fn scene(scene: &Scene, file: &Path, model: &Model, warnings: &[String]) -> Value {
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned());
    let boxes = model.things.iter().map(|thing| thing.bounds);
    let bounds = boxes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or_default();
    let cameras: Vec<Value> = (scene.cameras.iter())
        .map(|camera| json!({"name": camera.name, "eye": camera.eye, "target": camera.target, "up": camera.up, "fov": camera.fov_y}))
        .collect();
    json!({
        "name": name, "file": file.display().to_string(), "up": scene.up.unwrap_or_else(|| upward(scene)), "bounds": bounds,
        "cameras": cameras, "warnings": warnings,
    })
}

/// The layers, with how far each is.
pub(crate) fn layers(scene: Option<&Scene>, progress: Option<&Progress>) -> Value {
    let names = scene.map_or(&[][..], |scene| &scene.groups).iter().map(|group| &group.name);
    let far = progress.map_or(&[][..], |progress| &progress.layers).iter();
    let layer = |(name, (batches, of, held)): (&String, &(u32, u32, bool))| json!({"name": name, "batches": batches, "of": of, "held": held});
    names.zip(far).map(layer).collect()
}

/// The answer to what lies behind a pixel.
pub(crate) fn found(model: &Model, id: u32, found: Option<Found>) -> Value {
    let Some(found) = found else { return json!({"is": "answer", "id": id, "hit": false}) };
    let emits =
        |lamp: &Lamp| found.emitter.is_some_and(|emitter| lamp.emitters.iter().any(|(k, _)| *k == emitter));
    let lamp =
        model.lamps.iter().position(emits).map(|at| at as u32).or_else(|| model.lamp_of(found.instance));
    json!({
        "is": "answer", "id": id, "hit": true, "point": found.point, "normal": found.normal, "thing": found.instance,
        "material": found.material, "lamp": lamp, "lux": found.lux.map(told), "luminance": found.luminance.map(told),
        "change": found.change,
    })
}

/// A value and its error.
fn told(estimate: Estimate) -> Value {
    json!([estimate.value, estimate.error])
}

/// What is known of what lights a point.
pub(crate) fn lit(model: &Model, id: u32, answer: &Answer, done: bool) -> Value {
    let reading = |own: Reading| json!([own.lux, own.error.is_finite().then_some(own.error)]);
    let there = (0..).zip(&model.lamps).filter(|(_, lamp): &(u32, &Lamp)| !lamp.gone);
    let lamps = there.map(|(number, lamp)| {
        let emitters: Vec<u32> = lamp.emitters.iter().map(|(emitter, _)| *emitter).collect();
        let own = answer.of(&emitters);
        json!({
            "id": number, "direct": reading(own.direct), "indirect": reading(own.indirect), "caustic": reading(own.caustic),
        })
    });
    let lamps: Vec<Value> = lamps.collect();
    json!({"is": "answer", "id": id, "lux": reading(answer.total().all), "lamps": lamps, "done": done})
}

/// What to call an edit.
pub(crate) fn label(model: &Model, patch: &Patch) -> String {
    let lamp = |id: &u32| model.lamps.get(*id as usize).map_or(String::new(), |own| own.name.clone());
    let thing = |id: &u32| model.things.get(*id as usize).map_or(String::new(), |own| own.name.clone());
    let material =
        |id: &u32| model.materials.get(*id as usize).map_or(String::new(), |own| own.file.name.clone());
    let group = |id: &u32| model.groups.get(*id as usize).map_or(String::new(), |own| own.name.clone());
    let names = (patch.lamps.keys().map(lamp))
        .chain(patch.groups.keys().map(group))
        .chain(patch.things.keys().map(thing))
        .chain(patch.materials.keys().map(material));
    let names: Vec<String> = names.take(4).collect();
    match names.as_slice() {
        [] => "Edit".into(),
        [a] => a.clone(),
        [a, b] => format!("{a}, {b}"),
        [a, ..] => format!("{a} and others"),
    }
}

/// What each channel is multiplied by, so that a light looks white: null, or its temperature and tint.
pub(crate) fn white(value: &Value) -> Result<Rgb, String> {
    if value.is_null() {
        return Ok(Rgb::WHITE);
    }
    let number = |name: &str, range: std::ops::RangeInclusive<f64>| {
        let number = value.get(name).and_then(Value::as_f64).unwrap_or(0.0);
        range.contains(&number).then_some(number).ok_or(format!("{name} lies out of range"))
    };
    let (kelvin, tint) = (number("kelvin", 1000.0..=40_000.0)?, number("tint", -50.0..=50.0)?);
    let c = lampyris::chromaticity::Chromaticity::from_temperature_and_tint(kelvin, tint * 1e-3)
        .unwrap_or_default();
    let light = Rgb::from_xy_e(c.x, c.y, 1.0).map(|c| 1.0 / c.max(0.02));
    Ok(light * (1.0 / light.luminance()))
}

/// A note with what was measured for it.
pub(crate) fn measured(note: &Value, told: &Value) -> Value {
    let mut note = note.clone();
    if let (Some(note), Some(told)) = (note.as_object_mut(), told.as_object()) {
        note.extend(told.clone());
    }
    note
}

/// What all faders stand at.
pub(crate) fn faders(model: &Model) -> Patch {
    let lamp = |own: &Lamp| {
        let color = Some(own.color.whole());
        LampPatch { on: Some(own.on), level: Some(own.level), color, ..LampPatch::default() }
    };
    let lamps = (0..).zip(&model.lamps).filter(|(_, own)| !own.gone).map(|(id, own)| (id, lamp(own)));
    let groups = (0..).zip(&model.groups).filter(|(_, own)| !own.gone);
    let group =
        |own: &Group| GroupPatch { on: Some(own.on), level: Some(own.level), ..GroupPatch::default() };
    let groups = groups.map(|(id, own)| (id, group(own)));
    Patch { lamps: lamps.collect(), groups: groups.collect(), ..Patch::default() }
}
