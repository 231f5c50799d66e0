//! Meshes: the primitives of one glTF mesh merged to as few of the scene's as their attributes allow.
//!
//! What a primitive costs is known, and held against the limit, before any of it is read. One that uses few of many
//! vertices, because many primitives share one large array, copies those few.

use super::accessor::{Accessor, Accessors};
use super::json::{Attributes, Document, Mesh as JsonMesh, Primitive, Shape};
use super::material::Worn;
use crate::error::Result;
use crate::import::notes::Notes;
use crate::scene::Mesh;
use glam::{Vec2, Vec3, Vec4};

/// Farthest coordinate [m]; squares of it stay within single precision.
const FARTHEST: f32 = 1e18;

/// A primitive made of triangles, its bounds checked.
struct Plan<'a> {
    primitive: &'a Primitive,
    place: String,
    positions: Accessor<'a>,
    indices: Option<Accessor<'a>>,
    triangles: u64,
}

impl Plan<'_> {
    /// Vertices that it will add at most.
    fn vertices(&self) -> usize {
        let used = self.indices.as_ref().map_or(usize::MAX, Accessor::count);
        self.positions.count().min(used)
    }

    /// Which attributes its vertices have.
    fn signature(&self, surfaces: &[Worn]) -> [bool; 5] {
        let Attributes { normal, tangent, uv0, uv1, color, .. } = self.primitive.attributes;
        let bumpy = self.primitive.material.and_then(|m| surfaces.get(m as usize)).is_some_and(|w| w.bumpy);
        [normal.is_some(), tangent.is_some() && bumpy, uv0.is_some(), uv1.is_some(), color.is_some()]
    }
}

/// A glTF mesh, planned.
pub(super) struct Planned<'a> {
    plans: Vec<Plan<'a>>,
    /// Triangles in all.
    pub(super) triangles: u64,
}

/// Looks at a mesh's primitives without reading them.
pub(super) fn plan<'a>(
    index: u32,
    mesh: &'a JsonMesh,
    document: &Document,
    accessors: &Accessors<'a>,
    notes: &mut Notes,
) -> Result<Planned<'a>> {
    let mut plans = Vec::new();
    for (k, primitive) in mesh.primitives.iter().enumerate() {
        let place = format!("mesh {index}, primitive {k}");
        if primitive.mode > 6 {
            return Err(notes.bad(place, format!("mode {} does not exist", primitive.mode)));
        }
        if primitive.mode < 4 {
            notes.warn(place, "points and lines are not drawn");
            continue;
        }
        let Some(position) = primitive.attributes.position else {
            notes.warn(place, "a primitive without positions; left out");
            continue;
        };
        if primitive.targets {
            notes.warn(&place, "morph targets are not read: the mesh stands as it was modelled");
        }
        if let Some(m) = primitive.material.filter(|m| *m as usize >= document.materials.len()) {
            return Err(notes.bad(place, format!("there is no material {m}")));
        }
        if accessors.is_empty_promise(position) {
            notes.warn(place, "a primitive without data, or packed as is not read (Draco); left out");
            continue;
        }
        let bad = |e| notes.bad(&place, e);
        let positions = accessors.get(position, &[Shape::Vec3]).map_err(bad)?;
        let indices =
            primitive.indices.map(|i| accessors.get(i, &[Shape::Scalar])).transpose().map_err(bad)?;
        let corners = indices.as_ref().unwrap_or(&positions).count() as u64;
        let triangles = if primitive.mode == 4 { corners / 3 } else { corners.saturating_sub(2) };
        if primitive.mode == 4 && !corners.is_multiple_of(3) {
            notes.warn(&place, "corners that make no whole triangle; left out");
        }
        plans.push(Plan { primitive, place, positions, indices, triangles });
    }
    let triangles = plans.iter().map(|p| p.triangles).fold(0, u64::saturating_add);
    Ok(Planned { plans, triangles })
}

/// The meshes of a planned one; `plain` makes the material of primitives without any.
pub(super) fn read(
    planned: Planned<'_>,
    accessors: &Accessors<'_>,
    surfaces: &[Worn],
    plain: &mut impl FnMut() -> u32,
    notes: &mut Notes,
) -> Result<Vec<Mesh>> {
    let mut kinds: Vec<[bool; 5]> = planned.plans.iter().map(|p| p.signature(surfaces)).collect();
    let all = kinds.clone();
    kinds.sort_by_key(|kind| all.iter().position(|k| k == kind));
    kinds.dedup();
    let mut meshes = Vec::new();
    for kind in kinds {
        let group = || planned.plans.iter().zip(&all).filter(|(_, k)| **k == kind).map(|(p, _)| p);
        let mut mesh = Mesh::default();
        mesh.positions.reserve_exact(group().map(Plan::vertices).sum());
        mesh.triangles.reserve_exact(group().map(|p| p.triangles as usize).sum());
        mesh.materials.reserve_exact(mesh.triangles.capacity());
        for plan in group() {
            let known = plan.primitive.material.and_then(|m| surfaces.get(m as usize));
            let material = known.map_or_else(&mut *plain, |w| w.number);
            add(plan, accessors, kind, material, &mut mesh, notes)?;
        }
        if !mesh.triangles.is_empty() {
            meshes.push(mesh);
        }
    }
    Ok(meshes)
}

/// Adds a primitive's vertices and triangles.
fn add(
    plan: &Plan<'_>,
    accessors: &Accessors<'_>,
    kind: [bool; 5],
    material: u32,
    mesh: &mut Mesh,
    notes: &mut Notes,
) -> Result<()> {
    let there = plan.positions.count();
    let base = mesh.positions.len();
    if u32::try_from(base.saturating_add(there)).is_err() {
        return Err(notes.bad(&plan.place, "more than 2^32 vertices; split the mesh"));
    }
    let mut corners = match &plan.indices {
        Some(indices) => Some(indices.indices(there).map_err(|e| notes.bad(&plan.place, e))?),
        None => None,
    };
    // Of a large shared array only what is used: sorted, so that places are found without a table of the whole.
    let used = corners.as_mut().filter(|c| c.len() < there).map(|corners| {
        let mut used = corners.clone();
        used.sort_unstable();
        used.dedup();
        for c in corners.iter_mut() {
            *c = used.partition_point(|u| u < c) as u32;
        }
        used
    });
    let first = mesh.triangles.len();
    let offset = base as u32;
    match &corners {
        Some(c) => triangulate(plan.primitive.mode, c.len(), |k| c[k] + offset, &mut mesh.triangles),
        None => triangulate(plan.primitive.mode, there, |k| k as u32 + offset, &mut mesh.triangles),
    }
    drop(corners);
    let used = used.as_deref();
    plan.positions.read(used, 0.0, &mut mesh.positions, Vec3::from_array);
    attributes(plan, accessors, kind, used, mesh, notes)?;
    drop_what_is_nowhere(mesh, base, first, &plan.place, notes);
    mesh.materials.resize(mesh.triangles.len(), material);
    Ok(())
}

/// Triangles of a list, a strip or a fan; every second one of a strip is turned.
fn triangulate(mode: u32, corners: usize, at: impl Fn(usize) -> u32, out: &mut Vec<[u32; 3]>) {
    match mode {
        4 => out.extend((0..corners / 3).map(|t| [at(3 * t), at(3 * t + 1), at(3 * t + 2)])),
        5 => out.extend((2..corners).map(|k| {
            let turn = k % 2;
            [at(k - 2), at(k - 1 + turn), at(k - turn)]
        })),
        _ => out.extend((2..corners).map(|k| [at(k - 1), at(k), at(0)])),
    }
}

/// Adds everything but positions of a primitive's vertices.
fn attributes(
    plan: &Plan<'_>,
    accessors: &Accessors<'_>,
    kind: [bool; 5],
    used: Option<&[u32]>,
    mesh: &mut Mesh,
    notes: &mut Notes,
) -> Result<()> {
    let from = &plan.primitive.attributes;
    let get = |which: usize, index: Option<u32>, shapes: &[Shape]| {
        let Some(index) = index.filter(|_| kind[which]) else { return Ok(None) };
        let bad = |e| notes.bad(&plan.place, e);
        let accessor = accessors.get(index, shapes).map_err(bad)?;
        let (count, want) = (accessor.count(), plan.positions.count());
        if count != want {
            return Err(bad(format!("accessor {index} has {count} elements for {want} positions")));
        }
        Ok(Some(accessor))
    };
    let room = mesh.positions.capacity();
    if let Some(normals) = get(0, from.normal, &[Shape::Vec3])? {
        reserve(&mut mesh.normals, room);
        normals.read(used, 0.0, &mut mesh.normals, |n| Vec3::from_array(n).normalize_or_zero());
    }
    if let Some(tangents) = get(1, from.tangent, &[Shape::Vec4])? {
        reserve(&mut mesh.tangents, room);
        tangents.read(used, 0.0, &mut mesh.tangents, |[x, y, z, w]| {
            let along = Vec3::new(x, y, z).normalize_or_zero();
            along.extend(if w < 0.0 { -1.0 } else { 1.0 })
        });
    }
    for (set, index) in [from.uv0, from.uv1].into_iter().enumerate() {
        if let Some(uvs) = get(2 + set, index, &[Shape::Vec2])? {
            reserve(&mut mesh.uvs[set], room);
            let finite = |v: f32| if v.is_finite() { v } else { 0.0 };
            uvs.read(used, 0.0, &mut mesh.uvs[set], |[u, v]| Vec2::new(finite(u), finite(v)));
        }
    }
    if let Some(colors) = get(4, from.color, &[Shape::Vec3, Shape::Vec4])? {
        reserve(&mut mesh.colors, room);
        let share = |v: f32| if v.is_nan() { 1.0 } else { v.clamp(0.0, 1.0) };
        colors.read(used, 1.0, &mut mesh.colors, |c| Vec4::from_array(c.map(share)));
    }
    Ok(())
}

/// Room for as many as there are positions, once.
fn reserve<T>(items: &mut Vec<T>, room: usize) {
    items.reserve_exact(room.saturating_sub(items.len()));
}

/// Leaves out triangles with corners that are not finite or beyond all bounds.
fn drop_what_is_nowhere(mesh: &mut Mesh, base: usize, first: usize, place: &str, notes: &mut Notes) {
    let nowhere = |p: &Vec3| !p.is_finite() || p.abs().max_element() > FARTHEST;
    if !mesh.positions[base..].iter().any(nowhere) {
        return;
    }
    notes.warn(place, "positions that are not finite, or farther than 1e18 m; their triangles are left out");
    let bad: Vec<bool> = mesh.positions[base..].iter().map(nowhere).collect();
    let mut kept = first;
    for k in first..mesh.triangles.len() {
        let triangle = mesh.triangles[k];
        if !triangle.iter().any(|v| bad[*v as usize - base]) {
            mesh.triangles[kept] = triangle;
            kept += 1;
        }
    }
    mesh.triangles.truncate(kept);
    for (p, _) in mesh.positions[base..].iter_mut().zip(bad).filter(|(_, bad)| *bad) {
        *p = Vec3::ZERO;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(mode: u32, corners: usize) -> Vec<[u32; 3]> {
        let mut out = Vec::new();
        triangulate(mode, corners, |k| k as u32, &mut out);
        out
    }

    #[test]
    fn strips_and_fans_keep_their_sense() {
        assert_eq!(made(4, 7), [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(made(5, 5), [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
        assert_eq!(made(6, 5), [[1, 2, 0], [2, 3, 0], [3, 4, 0]]);
        assert!([4, 5, 6].iter().all(|&mode| (0..3).all(|n| made(mode, n).is_empty())));
    }

    #[test]
    fn triangles_without_a_place_go_and_no_other() {
        let mut mesh = Mesh {
            positions: vec![Vec3::NAN, Vec3::ONE, Vec3::X, Vec3::Y, Vec3::splat(2e18), Vec3::Z],
            triangles: vec![[0, 1, 2], [1, 2, 3], [3, 4, 5], [3, 5, 1]],
            ..Mesh::default()
        };
        let mut notes = Notes::new("a.glb".as_ref());
        drop_what_is_nowhere(&mut mesh, 1, 1, "mesh 0", &mut notes);
        assert_eq!(mesh.triangles, [[0, 1, 2], [1, 2, 3], [3, 5, 1]]);
        assert_eq!((mesh.positions[4], notes.into_lines().len()), (Vec3::ZERO, 1));
    }
}
