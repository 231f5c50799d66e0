//! Who plays in a script: names found in the scene, and the edits that each frame asks for.

use super::script::{CameraKey, LightKey, ObjectKey, Script, Track, at};
use glam::{Affine3A, Quat, Vec3};
use lampyris::light::LightKind;
use lampyris::scene::{Camera, Edit, Scene};
use lampyris::{Error, Result, Rgb};
use std::collections::BTreeSet;
use std::path::Path;

/// The cast, as the scene had it before the first frame.
#[derive(Clone)]
pub(crate) struct Stage {
    camera: Camera,
    camera_keys: Vec<CameraKey>,
    lights: Vec<(Vec<Lamp>, Vec<LightKey>)>,
    objects: Vec<(Vec<Thing>, Vec<ObjectKey>)>,
}

/// Something that shines.
#[derive(Clone)]
enum Lamp {
    /// A light that is no surface.
    Light(u32, LightKind),
    /// The material of a surface.
    Glow(u32, Rgb),
    /// A light group, which is weighted.
    Group(u16, Rgb),
}

/// An instance, where the file has it, and the middle of the object that it belongs to.
#[derive(Clone)]
struct Thing {
    instance: u32,
    transform: Affine3A,
    middle: Vec3,
}

impl Stage {
    /// Finds everybody whom a script names; `camera` holds where its keys set nothing.
    ///
    /// # Errors
    /// [`Error::BadInput`] for a name that nothing in the scene has, with the names that come near, and for keys that do
    /// not fit what they move.
    pub(crate) fn new(script: &Script, file: &Path, scene: &Scene, camera: &Camera) -> Result<Stage> {
        let bad = |place: String, reason: String| Error::BadInput { file: file.into(), place, reason };
        let mut lights = Vec::new();
        for (k, track) in script.lights.iter().enumerate() {
            let place = || format!("lights[{k}]");
            let moves = track.keys.iter().any(|key| key.position.is_some());
            let group = if moves { None } else { group(scene, &track.name) };
            let lamps = group.map_or_else(|| lamps(scene, &track.name), |group| vec![group]);
            if lamps.is_empty() {
                return Err(bad(place(), unknown("light", &track.name, lamp_names(scene))));
            }
            let placed = |lamp: &Lamp| matches!(lamp, Lamp::Light(_, kind) if with_position(kind, Vec3::ZERO).is_some());
            if moves && !lamps.iter().all(placed) {
                let mend = "is a surface or infinitely far; a surface is moved by a track of \"objects\"";
                return Err(bad(place(), format!("\"{}\" has no position: it {mend}", track.name)));
            }
            lights.push((lamps, track.keys.clone()));
        }
        let mut objects = Vec::new();
        for (k, Track { name, keys }) in script.objects.iter().enumerate() {
            let things = things(scene, name);
            if things.is_empty() {
                return Err(bad(format!("objects[{k}]"), unknown("object", name, object_names(scene))));
            }
            objects.push((things, keys.clone()));
        }
        Ok(Stage { camera: camera.clone(), camera_keys: script.camera.clone(), lights, objects })
    }

    /// Where the camera is at a frame.
    pub(crate) fn camera(&self, frame: u32) -> Camera {
        let keys = &self.camera_keys;
        Camera {
            name: self.camera.name.clone(),
            eye: at(keys, frame, |k| k.eye).unwrap_or(self.camera.eye),
            target: at(keys, frame, |k| k.target).unwrap_or(self.camera.target),
            up: at(keys, frame, |k| k.up).unwrap_or(self.camera.up),
            fov_y: at(keys, frame, |k| k.fov).unwrap_or(self.camera.fov_y),
        }
    }

    /// What shall be at a frame, all of it: an edit that changes nothing costs nothing.
    pub(crate) fn edits(&self, frame: u32) -> Vec<Edit> {
        let mut edits = vec![Edit::View { camera: Some(self.camera(frame)) }];
        for (lamps, keys) in &self.lights {
            let power = at(keys, frame, |k| k.power).unwrap_or(1.0);
            let position = at(keys, frame, |k| k.position);
            edits.extend(lamps.iter().map(|lamp| match lamp {
                Lamp::Light(light, kind) => {
                    let moved = position.and_then(|p| with_position(kind, p)).unwrap_or_else(|| kind.clone());
                    let brightness = moved.brightness() * power;
                    Edit::Light { light: *light, kind: moved.with_brightness(brightness) }
                }
                Lamp::Group(group, color) => Edit::Mix { group: *group, color: *color * power },
                Lamp::Glow(material, emission) => {
                    Edit::Emission { material: *material, emission: *emission * power }
                }
            }));
        }
        for (things, keys) in &self.objects {
            let shift = at(keys, frame, |k| k.shift).unwrap_or(Vec3::ZERO);
            let scale = at(keys, frame, |k| k.scale).unwrap_or(1.0);
            let turn = at(keys, frame, |k| k.turn).and_then(|turn| {
                Some(Quat::from_axis_angle(turn.truncate().try_normalize()?, turn.w.to_radians()))
            });
            let about = |thing: &Thing| {
                Affine3A::from_scale_rotation_translation(
                    Vec3::splat(scale),
                    turn.unwrap_or(Quat::IDENTITY),
                    thing.middle + shift,
                ) * Affine3A::from_translation(-thing.middle)
            };
            let still = shift == Vec3::ZERO && scale == 1.0 && turn.is_none_or(|t| t == Quat::IDENTITY);
            edits.extend(things.iter().map(|thing| Edit::Move {
                instance: thing.instance,
                transform: if still { thing.transform } else { about(thing) * thing.transform },
            }));
        }
        edits
    }
}

/// The same light elsewhere; `None` for one that is nowhere.
fn with_position(kind: &LightKind, to: Vec3) -> Option<LightKind> {
    let mut kind = kind.clone();
    match &mut kind {
        LightKind::Point { position, .. } | LightKind::Spot { position, .. } => *position = to,
        LightKind::Sphere { center, .. } | LightKind::Disc { center, .. } => *center = to,
        LightKind::Directional { .. } => return None,
    }
    Some(kind)
}

/// Whether an instance is the object of a name, or a part of it.
fn belongs(instance: &str, object: &str) -> bool {
    instance.strip_prefix(object).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

fn lamps(scene: &Scene, name: &str) -> Vec<Lamp> {
    let lights = (0..).zip(&scene.lights).filter(|(_, light)| light.name == name);
    let mut lamps: Vec<Lamp> = lights.map(|(k, light)| Lamp::Light(k, light.kind.clone())).collect();
    let materials: BTreeSet<u32> = (scene.instances.iter())
        .filter(|instance| belongs(&instance.name, name))
        .flat_map(|instance| glowing(scene, instance.mesh))
        .collect();
    lamps.extend(materials.into_iter().map(|m| Lamp::Glow(m, scene.materials[m as usize].emission)));
    lamps
}

/// The light group of a name.
fn group(scene: &Scene, name: &str) -> Option<Lamp> {
    let found = (0..).zip(&scene.groups).find(|(_, group)| group.name == name);
    found.map(|(number, group)| Lamp::Group(number, group.color))
}

/// Materials of a mesh that glow.
fn glowing(scene: &Scene, mesh: u32) -> BTreeSet<u32> {
    let worn = scene.meshes.get(mesh as usize).map_or(&[][..], |mesh| &mesh.materials);
    let glows = |m: &&u32| scene.materials.get(**m as usize).is_some_and(|m| !m.emission.is_black());
    worn.iter().filter(glows).copied().collect()
}

fn things(scene: &Scene, name: &str) -> Vec<Thing> {
    let own = || (0..).zip(&scene.instances).filter(|(_, instance)| belongs(&instance.name, name));
    let corners = own().flat_map(|(_, instance)| {
        let points = scene.meshes.get(instance.mesh as usize).map_or(&[][..], |mesh| &mesh.positions);
        points.iter().map(|p| instance.transform.transform_point3(*p))
    });
    let none = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (low, high) = corners.fold(none, |(low, high), p| (low.min(p), high.max(p)));
    let middle = if low.cmple(high).all() { low + (high - low) * 0.5 } else { Vec3::ZERO };
    own().map(|(k, instance)| Thing { instance: k, transform: instance.transform, middle }).collect()
}

/// Every name that a track of lights can have, each once.
pub(crate) fn lamp_names(scene: &Scene) -> Vec<&str> {
    let glows = scene.instances.iter().filter(|instance| !glowing(scene, instance.mesh).is_empty());
    let names = glows.map(|i| i.name.as_str()).chain(scene.lights.iter().map(|light| light.name.as_str()));
    names.collect::<BTreeSet<_>>().into_iter().collect()
}

/// Every name that a track of objects can have, but those that stand for several together, each once.
pub(crate) fn object_names(scene: &Scene) -> Vec<&str> {
    scene.instances.iter().map(|i| i.name.as_str()).collect::<BTreeSet<_>>().into_iter().collect()
}

/// What to say of a name that nothing has.
fn unknown(what: &str, name: &str, known: Vec<&str>) -> String {
    /// As many names as a line holds.
    const SHOWN: usize = 8;
    let mut near: Vec<(usize, &str)> = known.iter().map(|other| (distance(name, other), *other)).collect();
    near.sort();
    let near: Vec<&str> = near.into_iter().take(SHOWN).map(|(_, other)| other).collect();
    let more = if known.len() > SHOWN { ", …; lampyris info --json has them all" } else { "" };
    let near = if near.is_empty() { "none".into() } else { near.join(", ") };
    format!("no {what} is called \"{}\"; the scene has: {near}{more}", clipped(name))
}

fn clipped(name: &str) -> String {
    name.chars().take(LONG).collect()
}

/// Letters of a name that count.
const LONG: usize = 64;

/// How many letters must be put in, taken out or changed to make one name the other.
fn distance(a: &str, b: &str) -> usize {
    let (a, b) = (clipped(a), clipped(b));
    let mut row: Vec<usize> = (0..=b.chars().count()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.chars().enumerate() {
            let changed = corner + usize::from(x != y);
            corner = row[j + 1];
            row[j + 1] = changed.min(corner + 1).min(row[j] + 1);
        }
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_of_names() {
        for (a, b, n) in [("", "", 0), ("lamp", "", 4), ("lamp", "lamps", 1), ("kitten", "sitting", 3)] {
            assert_eq!((distance(a, b), distance(b, a)), (n, n), "{a} {b}");
        }
    }

    #[test]
    fn objects_hold_their_parts_and_no_others() {
        assert!(belongs("shelf", "shelf") && belongs("shelf/led", "shelf"));
        assert!(!belongs("shelf_2", "shelf") && !belongs("shelf", "shelf/led"));
    }
}
