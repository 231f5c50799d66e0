//! What the tracer is told of a scene: where its meshes stand, which triangles let rays pass from behind, and where
//! surfaces have holes.

use crate::geometry::{MeshGeometry, Placement, Screen, Tracer};
use crate::material::{Coverage, Material, Sides};
use crate::scene::{Least, Mesh, Scene};
use crate::sequence;
use std::collections::HashMap;
use std::sync::Arc;

/// Seed of the screens of half-there surfaces.
const SCREEN: u32 = 0x5c4e_e111;

/// Of each triangle of a mesh, unless none is so.
struct Flags {
    one_sided: Vec<bool>,
    screened: Vec<bool>,
}

impl Flags {
    fn new(scene: &Scene, mesh: &Mesh, least: &mut Least) -> Flags {
        let material = |k: &u32| &scene.materials[*k as usize];
        let one_sided = |k: &u32| material(k).sides == Sides::FrontOnly;
        let one_sided = if mesh.materials.iter().any(one_sided) {
            mesh.materials.iter().map(one_sided).collect()
        } else {
            Vec::new()
        };
        if mesh.materials.iter().all(|k| material(k).coverage == Coverage::Full) {
            return Flags { one_sided, screened: Vec::new() };
        }
        let mut known = HashMap::new();
        let mut holes =
            |k: &u32| *known.entry(*k).or_insert_with(|| least.may_have_holes(scene, material(k), mesh));
        Flags { one_sided, screened: mesh.materials.iter().map(&mut holes).collect() }
    }

    fn of<'a>(&'a self, mesh: &'a Mesh) -> MeshGeometry<'a> {
        MeshGeometry {
            positions: &mesh.positions,
            triangles: &mesh.triangles,
            one_sided: &self.one_sided,
            screened: &self.screened,
        }
    }
}

/// The tracer of a scene.
pub(super) fn tracer(scene: &Arc<Scene>, least: &mut Least) -> Tracer {
    let flags: Vec<Flags> = scene.meshes.iter().map(|m| Flags::new(scene, m, least)).collect();
    let meshes: Vec<MeshGeometry<'_>> = scene.meshes.iter().zip(&flags).map(|(m, f)| f.of(m)).collect();
    let placements: Vec<Placement> =
        scene.instances.iter().map(|i| Placement { mesh: i.mesh, transform: i.transform }).collect();
    Tracer::with_screen(&meshes, &placements, &screen(scene))
}

/// Where an instance stands, unless it was taken away.
fn placement(scene: &Scene, instance: u32) -> Option<Placement> {
    let instance = scene.instances.get(instance as usize)?;
    scene.meshes.get(instance.mesh as usize)?;
    Some(Placement { mesh: instance.mesh, transform: instance.transform })
}

/// Tells the tracer that an instance stands otherwise.
pub(super) fn replace(tracer: &mut Tracer, scene: &Arc<Scene>, instance: u32, least: &mut Least) {
    let now = placement(scene, instance);
    let concerned: Vec<(u32, &Mesh, Placement, Flags)> = tracer
        .concerned(instance, now.as_ref())
        .into_iter()
        .filter_map(|number| {
            let at = placement(scene, number)?;
            let mesh = &scene.meshes[at.mesh as usize];
            Some((number, mesh, at, Flags::new(scene, mesh, least)))
        })
        .collect();
    let concerned: Vec<(u32, MeshGeometry<'_>, Placement)> =
        concerned.iter().map(|(number, mesh, at, flags)| (*number, flags.of(mesh), *at)).collect();
    tracer.replace(instance, now.as_ref(), &concerned);
}

/// True if the tracer sees surfaces of the two materials alike.
pub(super) fn alike(a: &Material, b: &Material) -> bool {
    let one_sided = |m: &Material| m.sides == Sides::FrontOnly;
    let whole = |m: &Material| m.coverage == Coverage::Full;
    let alpha = |m: &Material| (m.coverage, m.maps.color, m.maps.alpha);
    one_sided(a) == one_sided(b) && ((whole(a) && whole(b)) || alpha(a) == alpha(b))
}

/// The holes of a scene's surfaces.
pub(super) fn screen(scene: &Arc<Scene>) -> Screen {
    let scene = scene.clone();
    Screen::new(move |instance, triangle, u, v| is_hole(&scene, instance, triangle, u, v))
}

/// Does light pass through a hit of a surface that is not all there? What is there in part is a screen of holes finer
/// than any ray: the bits of a hit say by their hash whether it met one.
fn is_hole(scene: &Scene, instance: u32, triangle: u32, u: f32, v: f32) -> bool {
    let Some(spot) = scene.spot(instance, triangle, u, v) else { return false };
    let Some(material) = spot.mesh.materials.get(triangle as usize) else { return false };
    let coverage = spot.coverage(&scene.materials[*material as usize]);
    let place = [instance, triangle, u.to_bits(), v.to_bits()].into_iter().fold(SCREEN, sequence::hash);
    coverage <= sequence::unit_f32(place)
}
