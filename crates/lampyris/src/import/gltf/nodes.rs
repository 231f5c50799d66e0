//! The tree of nodes, walked from the roots of the scene: where meshes, cameras and lamps stand, and what they are called.
//! An explicit stack, and each node at most once: glTF's nodes make trees, so that a second way to one is a loop or a
//! diamond, which a thousand bytes could unfold to more instances than there is memory for.

use super::json::{Camera as JsonCamera, Document, Light as JsonLight, Node};
use crate::color::Rgb;
use crate::error::Result;
use crate::import::BRIGHTEST;
use crate::import::Limits;
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::light::{Beam, Light, LightKind};
use crate::scene::Camera;
use glam::{DAffine3, DMat3, DQuat, DVec3, Vec3};

/// The largest number of a transform: products with coordinates must stay within f32.
const FARTHEST: f64 = 1e18;

/// A mesh at its place.
pub(super) struct Placed {
    pub(super) mesh: u32,
    pub(super) name: String,
    pub(super) transform: DAffine3,
}

/// What the nodes say.
#[derive(Default)]
pub(super) struct Placement {
    pub(super) meshes: Vec<Placed>,
    pub(super) cameras: Vec<Camera>,
    pub(super) lights: Vec<Light>,
}

/// A node whose children are being visited.
struct Open<'a> {
    children: &'a [u32],
    next: usize,
    transform: DAffine3,
    /// Length of its name, those around it included.
    name: usize,
}

/// Walks the scene that the file chooses.
pub(super) fn walk(document: &Document, limits: &Limits, notes: &mut Notes) -> Result<Placement> {
    let roots = roots(document, notes)?;
    let mut out = Placement::default();
    let mut seen = vec![false; document.nodes.len()];
    let mut name = String::new();
    let mut open = vec![Open { children: &roots, next: 0, transform: DAffine3::IDENTITY, name: 0 }];
    while let Some(top) = open.last_mut() {
        let Some(&index) = top.children.get(top.next) else {
            open.pop();
            continue;
        };
        top.next += 1;
        let (outer, length) = (top.transform, top.name);
        let place = format!("node {index}");
        let node = document.nodes.get(index as usize);
        let node = node.ok_or_else(|| notes.bad(&place, "there is no such node"))?;
        if std::mem::replace(&mut seen[index as usize], true) {
            return Err(notes.bad(place, "it is reached twice: nodes must make trees, without loops"));
        }
        if node.extensions.as_ref().is_some_and(|e| !e.visibility.visible) {
            continue;
        }
        name.truncate(length);
        append(&mut name, node.name.as_deref().unwrap_or_default());
        let transform = outer * local(node, &place, notes);
        let columns = transform.to_cols_array();
        if !columns.iter().all(|v| v.abs() <= FARTHEST) {
            notes.warn(&place, "a transform that is not finite or beyond 1e18; the node is left out");
            continue;
        }
        furnish(document, node, index, &name, &transform, notes, &mut out)?;
        notes.limit(
            &place,
            "the number of instances",
            out.meshes.len() as u64,
            limits.instances,
            "--max-instances",
        )?;
        if !node.children.is_empty() {
            notes.limit(&place, "the depth of nodes", open.len() as u64 + 1, limits.depth, "--max-depth")?;
            open.push(Open { children: &node.children, next: 0, transform, name: name.len() });
        }
    }
    Ok(out)
}

/// The scene's roots; without scenes, every node that is nobody's child.
fn roots(document: &Document, notes: &Notes) -> Result<Vec<u32>> {
    let chosen = document.scene.unwrap_or(0);
    match document.scenes.get(chosen as usize) {
        Some(scene) => Ok(scene.nodes.clone()),
        None if document.scene.is_some() => {
            Err(notes.bad(format!("scene {chosen}"), "there is no such scene"))
        }
        None => {
            let mut root = vec![true; document.nodes.len()];
            for child in document.nodes.iter().flat_map(|n| n.children.iter()) {
                if let Some(r) = root.get_mut(*child as usize) {
                    *r = false;
                }
            }
            Ok((0..).zip(root).filter(|(_, root)| *root).map(|(k, _)| k).collect())
        }
    }
}

fn append(path: &mut String, name: &str) {
    if !name.is_empty() {
        if !path.is_empty() {
            path.push('/');
        }
        path.push_str(clipped(name));
        let kept = clipped(path).len();
        path.truncate(kept);
    }
}

/// The node's own transform, by its matrix or by its three parts.
fn local(node: &Node, place: &str, notes: &mut Notes) -> DAffine3 {
    if let Some(m) = &node.matrix {
        let column = |k: usize| DVec3::new(m[4 * k], m[4 * k + 1], m[4 * k + 2]);
        let matrix3 = DMat3::from_cols(column(0), column(1), column(2));
        return DAffine3 { matrix3, translation: column(3) };
    }
    let scale = node.scale.as_deref().map_or(DVec3::ONE, |s| DVec3::from_array(*s));
    let translation = node.translation.as_deref().map_or(DVec3::ZERO, |t| DVec3::from_array(*t));
    let turn = node.rotation.as_deref().map_or(DQuat::IDENTITY, |r| DQuat::from_array(*r));
    let length = turn.length();
    let rotation = if length.is_finite() && length > 1e-6 {
        turn / length
    } else {
        notes.warn(place, "a rotation that is no quaternion of length 1; none is used");
        DQuat::IDENTITY
    };
    DAffine3::from_scale_rotation_translation(scale, rotation, translation)
}

/// Notes what stands at a node.
fn furnish(
    document: &Document,
    node: &Node,
    index: u32,
    name: &str,
    transform: &DAffine3,
    notes: &mut Notes,
    out: &mut Placement,
) -> Result<()> {
    let place = format!("node {index}");
    let called = |own: Option<&str>| match (name, own.unwrap_or_default()) {
        ("", "") => place.clone(),
        ("", own) => clipped(own).to_owned(),
        _ => name.to_owned(),
    };
    if let Some(mesh) = node.mesh {
        let known = document.meshes.get(mesh as usize);
        let known = known.ok_or_else(|| notes.bad(&place, format!("there is no mesh {mesh}")))?;
        if node.skin {
            notes.warn(&place, "skins are not read: the mesh stands as it was modelled");
        }
        if transform.matrix3.determinant() == 0.0 {
            notes.warn(&place, "a transform that flattens everything; the instance is left out");
        } else {
            out.meshes.push(Placed { mesh, name: called(known.name.as_deref()), transform: *transform });
        }
    }
    if let Some(camera) = node.camera {
        let known = document.cameras.get(camera as usize);
        let known = known.ok_or_else(|| notes.bad(&place, format!("there is no camera {camera}")))?;
        match view(known, called(None), transform) {
            Ok(camera) => out.cameras.push(camera),
            Err(why) => notes.warn(&place, why),
        }
    }
    if let Some(of) = node.extensions.as_ref().and_then(|e| e.light.as_ref()) {
        let known = document.extensions.lights.lights.get(of.light as usize);
        let known = known.ok_or_else(|| notes.bad(&place, format!("there is no light {}", of.light)))?;
        match lamp(known, called(known.name.as_deref()), transform) {
            Some(light) => out.lights.push(light),
            None => notes.warn(&place, "a light of an unknown type or with impossible numbers; left out"),
        }
    }
    Ok(())
}

/// A direction of the node's own space, in the world.
fn direction(transform: &DAffine3, own: DVec3) -> Vec3 {
    transform.transform_vector3(own).normalize_or_zero().as_vec3()
}

/// A camera looks along its −z, with +y up.
fn view(
    camera: &JsonCamera,
    name: String,
    transform: &DAffine3,
) -> std::result::Result<Camera, &'static str> {
    if &*camera.kind != "perspective" {
        return Err("a camera that is not perspective; left out");
    }
    let fov_y = camera.perspective.yfov.to_degrees();
    let eye = transform.translation.as_vec3();
    let (forward, up) = (direction(transform, DVec3::NEG_Z), direction(transform, DVec3::Y));
    if !(fov_y > 0.0 && fov_y < 180.0) || forward.cross(up).length() < 1e-6 {
        return Err("a camera with an impossible field of view or transform; left out");
    }
    Ok(Camera { name, eye, target: eye + forward, up, fov_y })
}

/// A light of `KHR_lights_punctual`: candela from points and spots, lux from parallel light.
fn lamp(light: &JsonLight, name: String, transform: &DAffine3) -> Option<Light> {
    let [r, g, b] = light.color;
    let light_strength = light.intensity;
    let strength = Rgb::new(r, g, b) * light_strength;
    let (position, direction) = (transform.translation.as_vec3(), direction(transform, DVec3::NEG_Z));
    let kind = match &*light.kind {
        "point" => LightKind::Point { position, intensity: strength },
        "directional" => LightKind::Directional { direction, illuminance: strength },
        "spot" => {
            let cos_outer = libm::cosf(light.spot.outer_cone_angle);
            // A sharp edge is one step of the number wide.
            let cos_inner = libm::cosf(light.spot.inner_cone_angle).max(cos_outer.next_up());
            LightKind::Spot {
                position,
                direction,
                intensity: strength,
                beam: Beam::Cone { cos_inner, cos_outer },
            }
        }
        _ => return None,
    };
    let light = Light::new(name, kind);
    let possible = strength.max_channel() <= BRIGHTEST && [r, g, b, light_strength].iter().all(|v| *v >= 0.0);
    (light.is_sound() && possible).then_some(light)
}
