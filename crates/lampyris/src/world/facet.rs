//! Triangles in world space with what a hit needs of them. They are worked out where they are asked for, since a list of
//! all would be as large as the tree; what stands in one place alone is moved there beforehand.

use crate::scene::{Mesh, Scene};
use glam::{Affine3A, Vec3};
use std::sync::Arc;

/// A triangle in its place.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    /// Corners [m, world].
    pub corners: [Vec3; 3],
    /// Unit normal of the front side; zero for a triangle without area.
    pub normal: Vec3,
    /// Material number.
    pub material: u32,
}

/// All facets of a scene.
#[derive(Clone, Debug, Default)]
pub struct Facets {
    /// Whose triangles they are.
    pub(super) scene: Arc<Scene>,
    /// Of each instance.
    places: Vec<Place>,
    /// Triangles and vertices [m, world] of the meshes that have one instance.
    triangles: Vec<Triangle>,
    positions: Vec<Vec3>,
}

/// A triangle of a mesh that has one instance.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    vertices: [u32; 3],
    material: u32,
}

/// What all facets of an instance share.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Where in `triangles` and in `positions` its own begin, if they are there.
    first: Option<(u32, u32)>,
    /// −1 where the transform mirrors.
    mirror: f32,
    /// No facet has bent normals.
    flat: bool,
}

/// Cosine above which a shading normal is the geometric one.
const FLAT: f32 = 0.999_999;

impl Facets {
    /// Of every triangle of every instance.
    pub fn new(scene: &Arc<Scene>) -> Facets {
        let mut uses = vec![0_u32; scene.meshes.len()];
        for instance in &scene.instances {
            if let Some(uses) = uses.get_mut(instance.mesh as usize) {
                *uses += 1;
            }
        }
        let once = || scene.meshes.iter().zip(&uses).filter(|(_, uses)| **uses == 1);
        let mut all = Facets {
            scene: scene.clone(),
            places: Vec::with_capacity(scene.instances.len()),
            triangles: Vec::with_capacity(once().map(|(m, _)| m.triangles.len()).sum()),
            positions: Vec::with_capacity(once().map(|(m, _)| m.positions.len()).sum()),
        };
        for (number, instance) in (0..).zip(&scene.instances) {
            let first = (uses.get(instance.mesh as usize) == Some(&1))
                .then_some((all.triangles.len() as u32, all.positions.len() as u32));
            if let Some((_, base)) = first {
                let mesh = &scene.meshes[instance.mesh as usize];
                let moved = mesh.positions.iter().map(|p| instance.transform.transform_point3(*p));
                all.positions.extend(moved);
                let pairs = mesh.triangles.iter().zip(&mesh.materials);
                all.triangles.extend(pairs.map(|(vertices, material)| Triangle {
                    vertices: vertices.map(|v| base + v),
                    material: *material,
                }));
            }
            all.places.push(Place { first, mirror: 1.0, flat: false });
            all.orient(number);
        }
        all
    }

    /// An instance was moved, or is new.
    pub(super) fn moved(&mut self, number: u32) {
        let scene = self.scene.clone();
        let Some(instance) = scene.instances.get(number as usize) else { return };
        match self.places.get(number as usize).map(|place| place.first) {
            None => self.places.push(Place { first: None, mirror: 1.0, flat: false }),
            Some(None) => {}
            Some(Some((_, base))) => {
                let positions = self.positions[base as usize..].iter_mut();
                let given = scene.meshes.get(instance.mesh as usize).map(|mesh| &mesh.positions);
                for (at, p) in positions.zip(given.into_iter().flatten()) {
                    *at = instance.transform.transform_point3(*p);
                }
            }
        }
        self.orient(number);
    }

    /// An instance has another mesh, or none.
    pub(super) fn swapped(&mut self, number: u32) {
        if let Some(place) = self.places.get_mut(number as usize) {
            place.first = None;
        }
        self.orient(number);
    }

    /// Notes whether an instance is mirrored, and whether it is flat.
    fn orient(&mut self, number: u32) {
        let Some((mesh, transform)) = self.mesh(number) else { return };
        let (count, smooth) = (mesh.triangles.len() as u32, !mesh.normals.is_empty());
        let mirror = if transform.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        self.places[number as usize] = Place { mirror, flat: false, ..self.places[number as usize] };
        self.places[number as usize].flat = !smooth || (0..count).all(|t| self.is_flat(number, t));
    }

    /// One triangle of one instance.
    #[inline]
    pub fn get(&self, instance: u32, triangle: u32) -> Facet {
        let corners = self.corners(instance, triangle);
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or_zero() * self.mirror(instance);
        Facet { corners, normal, material: self.material(instance, triangle) }
    }

    /// The corners of a triangle, counter-clockwise seen from the front or, where [`Facets::mirror`] is −1, the back.
    #[inline]
    pub(super) fn corners(&self, instance: u32, triangle: u32) -> [Vec3; 3] {
        if let Some((first, _)) = self.places[instance as usize].first {
            let vertices = &self.triangles[(first + triangle) as usize].vertices;
            return vertices.map(|v| self.positions[v as usize]);
        }
        let (mesh, transform) = self.placed(instance);
        mesh.triangles[triangle as usize].map(|v| transform.transform_point3(mesh.positions[v as usize]))
    }

    /// −1 where the instance's transform mirrors, else 1.
    #[inline]
    pub(super) fn mirror(&self, instance: u32) -> f32 {
        self.places[instance as usize].mirror
    }

    /// The material of a triangle.
    #[inline]
    pub fn material(&self, instance: u32, triangle: u32) -> u32 {
        match self.places[instance as usize].first {
            Some((first, _)) => self.triangles[(first + triangle) as usize].material,
            None => self.placed(instance).0.materials[triangle as usize],
        }
    }

    /// How many triangles an instance has; none where it was taken away.
    pub fn count(&self, instance: u32) -> u32 {
        self.mesh(instance).map_or(0, |(mesh, _)| mesh.triangles.len() as u32)
    }

    /// Every triangle: (instance, triangle, facet).
    pub fn iter(&self) -> impl Iterator<Item = (u32, u32, Facet)> {
        (0..self.places.len() as u32).flat_map(move |instance| {
            let triangles = 0..self.count(instance);
            triangles.map(move |triangle| (instance, triangle, self.get(instance, triangle)))
        })
    }

    /// False only if some facet of the instance has bent normals.
    #[inline]
    pub fn all_flat(&self, instance: u32) -> bool {
        self.places[instance as usize].flat
    }

    /// True if the triangle's shading normal is the geometric one everywhere.
    pub fn is_flat(&self, instance: u32, triangle: u32) -> bool {
        self.all_flat(instance)
            || self.bent(instance, triangle, self.get(instance, triangle).normal).is_none()
    }

    /// Unit shading normal at barycentric (u, v), on the front side; `normal` is the facet's.
    pub fn shading_normal(&self, instance: u32, triangle: u32, normal: Vec3, u: f32, v: f32) -> Vec3 {
        if self.all_flat(instance) {
            return normal;
        }
        let Some([a, b, c]) = self.bent(instance, triangle, normal) else { return normal };
        let n = (a * (1.0 - u - v) + b * u + c * v).normalize_or(normal);
        if n.dot(normal) < 0.0 { -n } else { n }
    }

    /// The mesh of an instance, unless it was taken away.
    fn mesh(&self, instance: u32) -> Option<(&Mesh, &Affine3A)> {
        let instance = self.scene.instances.get(instance as usize)?;
        Some((self.scene.meshes.get(instance.mesh as usize)?, &instance.transform))
    }

    /// The mesh of an instance that has triangles.
    #[inline]
    fn placed(&self, instance: u32) -> (&Mesh, &Affine3A) {
        let instance = &self.scene.instances[instance as usize];
        (&self.scene.meshes[instance.mesh as usize], &instance.transform)
    }

    /// The normals of the corners, unless they are `normal`.
    fn bent(&self, instance: u32, triangle: u32, normal: Vec3) -> Option<[Vec3; 3]> {
        let (mesh, transform) = self.placed(instance);
        let given = |v: u32| mesh.normals.get(v as usize).copied().unwrap_or_default();
        let bent =
            mesh.triangles[triangle as usize].map(|v| turned(transform, given(v)).normalize_or(normal));
        (!bent.iter().all(|n| n.dot(normal) > FLAT)).then_some(bent)
    }
}

/// Normals transform by the inverse transpose, here the cofactors: no division, no trouble with mirrors.
fn turned(transform: &Affine3A, n: Vec3) -> Vec3 {
    let m = transform.matrix3;
    let [x, y, z] = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
    Vec3::from(x * n.x + y * n.y + z * n.z)
}
