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
    /// Unit normals of their vertices, where meshes have any; zero where a vertex has none.
    normals: Vec<Vec3>,
}

/// A triangle of a mesh that has one instance.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    vertices: [u32; 3],
    material: u32,
    /// Of the front side: every hit asks for it.
    normal: Vec3,
}

/// Places in the lists of [`Facets`].
#[derive(Clone, Copy, Debug)]
struct First {
    triangle: u32,
    position: u32,
    normal: Option<u32>,
}

/// What all facets of an instance share.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Where its own begin, if they are there.
    first: Option<First>,
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
            normals: Vec::new(),
        };
        for (number, instance) in (0..).zip(&scene.instances) {
            let once = uses.get(instance.mesh as usize) == Some(&1);
            let first = once.then(|| all.settle(&scene.meshes[instance.mesh as usize], &instance.transform));
            all.places.push(Place { first, mirror: 1.0, flat: false });
            all.orient(number);
        }
        all
    }

    /// Moves a mesh to the only place that it has; where it lies then.
    fn settle(&mut self, mesh: &Mesh, transform: &Affine3A) -> First {
        let first = First {
            triangle: self.triangles.len() as u32,
            position: self.positions.len() as u32,
            normal: (!mesh.normals.is_empty()).then_some(self.normals.len() as u32),
        };
        let triangles = mesh.triangles.iter().zip(&mesh.materials).map(|(vertices, material)| Triangle {
            vertices: vertices.map(|v| first.position + v),
            material: *material,
            normal: Vec3::ZERO,
        });
        self.triangles.extend(triangles);
        self.positions.extend(positions(mesh, transform));
        self.normals.extend(first.normal.into_iter().flat_map(|_| normals(mesh, transform)));
        first
    }

    /// An instance was moved, or is new.
    pub(super) fn moved(&mut self, number: u32) {
        let scene = self.scene.clone();
        let Some(instance) = scene.instances.get(number as usize) else { return };
        match self.places.get(number as usize).map(|place| place.first) {
            None => self.places.push(Place { first: None, mirror: 1.0, flat: false }),
            Some(None) => {}
            Some(Some(first)) => {
                if let Some(mesh) = scene.meshes.get(instance.mesh as usize) {
                    let all = self.positions[first.position as usize..].iter_mut();
                    all.zip(positions(mesh, &instance.transform)).for_each(|(at, p)| *at = p);
                    let all = first.normal.map(|k| self.normals[k as usize..].iter_mut());
                    let all = all.into_iter().flatten();
                    all.zip(normals(mesh, &instance.transform)).for_each(|(at, n)| *at = n);
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

    /// Notes whether an instance is mirrored, where its triangles face, and whether it is flat.
    fn orient(&mut self, number: u32) {
        let Some((mesh, transform)) = self.mesh(number) else { return };
        let (count, smooth) = (mesh.triangles.len() as u32, !mesh.normals.is_empty());
        let mirror = if transform.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        let place = Place { mirror, flat: false, ..self.places[number as usize] };
        self.places[number as usize] = place;
        if let Some(first) = place.first {
            for triangle in 0..count {
                let normal = unit_normal(&self.corners(number, triangle)) * mirror;
                self.triangles[(first.triangle + triangle) as usize].normal = normal;
            }
        }
        self.places[number as usize].flat = !smooth || (0..count).all(|t| self.is_flat(number, t));
    }

    /// One triangle of one instance.
    #[inline]
    pub fn get(&self, instance: u32, triangle: u32) -> Facet {
        let corners = self.corners(instance, triangle);
        match self.places[instance as usize].first {
            Some(first) => {
                let Triangle { normal, material, .. } = self.triangles[(first.triangle + triangle) as usize];
                Facet { corners, normal, material }
            }
            None => {
                let normal = unit_normal(&corners) * self.mirror(instance);
                Facet { corners, normal, material: self.placed(instance).0.materials[triangle as usize] }
            }
        }
    }

    /// The corners of a triangle, counter-clockwise seen from the front or, where [`Facets::mirror`] is −1, the back.
    #[inline]
    pub(super) fn corners(&self, instance: u32, triangle: u32) -> [Vec3; 3] {
        if let Some(first) = self.places[instance as usize].first {
            let vertices = &self.triangles[(first.triangle + triangle) as usize].vertices;
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
            Some(first) => self.triangles[(first.triangle + triangle) as usize].material,
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
        let given = if let Some(first @ First { normal: Some(k), .. }) = self.places[instance as usize].first
        {
            let vertices = &self.triangles[(first.triangle + triangle) as usize].vertices;
            vertices.map(|v| self.normals[(v - first.position + k) as usize])
        } else {
            let (mesh, transform) = self.placed(instance);
            mesh.triangles[triangle as usize].map(|v| normal_at(mesh, transform, v))
        };
        let bent = given.map(|n| if n == Vec3::ZERO { normal } else { n });
        (!bent.iter().all(|n| n.dot(normal) > FLAT)).then_some(bent)
    }
}

/// The vertices of a mesh in a place [m, world].
fn positions(mesh: &Mesh, transform: &Affine3A) -> impl Iterator<Item = Vec3> {
    mesh.positions.iter().map(|p| transform.transform_point3(*p))
}

/// The unit normals of its vertices there.
fn normals(mesh: &Mesh, transform: &Affine3A) -> impl Iterator<Item = Vec3> {
    (0..mesh.positions.len() as u32).map(|v| normal_at(mesh, transform, v))
}

/// The unit normal of a vertex in a place; zero if it has none.
fn normal_at(mesh: &Mesh, transform: &Affine3A, vertex: u32) -> Vec3 {
    let given = mesh.normals.get(vertex as usize).copied().unwrap_or_default();
    turned(transform, given).normalize_or_zero()
}

/// Of the side from which the corners run counter-clockwise; zero for a triangle without area.
fn unit_normal([a, b, c]: &[Vec3; 3]) -> Vec3 {
    (*b - *a).cross(*c - *a).normalize_or_zero()
}

/// Normals transform by the inverse transpose, here the cofactors: no division, no trouble with mirrors.
fn turned(transform: &Affine3A, n: Vec3) -> Vec3 {
    let m = transform.matrix3;
    let [x, y, z] = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
    Vec3::from(x * n.x + y * n.y + z * n.z)
}
