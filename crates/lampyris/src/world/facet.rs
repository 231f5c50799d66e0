//! Triangles in world space with what a hit needs of them: worked out once when the world is built.

use crate::scene::Scene;
use glam::{Affine3A, Vec3};

/// A triangle in its place.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    /// Corners [m, world].
    pub corners: [Vec3; 3],
    /// Unit normal of the front side; zero for a triangle without area.
    pub normal: Vec3,
    /// Material number.
    pub material: u32,
    /// Where its three shading normals are; `u32::MAX` for a flat one.
    smooth: u32,
}

impl Facet {
    /// True if its shading normal is the geometric one everywhere.
    pub fn is_flat(&self) -> bool {
        self.smooth == u32::MAX
    }
}

/// All facets of a scene.
#[derive(Clone, Debug, Default)]
pub struct Facets {
    facets: Vec<Facet>,
    /// First facet of each instance.
    first: Vec<u32>,
    normals: Vec<[Vec3; 3]>,
}

impl Facets {
    /// From every triangle of every instance.
    pub fn new(scene: &Scene) -> Facets {
        let mut all = Facets::default();
        for instance in &scene.instances {
            all.first.push(all.facets.len() as u32);
            let mesh = &scene.meshes[instance.mesh as usize];
            let transform = &instance.transform;
            let mirror = if transform.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
            for (triangle, material) in mesh.triangles.iter().zip(&mesh.materials) {
                let corners = triangle.map(|v| transform.transform_point3(mesh.positions[v as usize]));
                let [a, b, c] = corners;
                let normal = (b - a).cross(c - a).normalize_or_zero() * mirror;
                let given = triangle.map(|v| mesh.normals.get(v as usize).copied().unwrap_or_default());
                let bent = given.map(|n| turned(transform, n).normalize_or(normal));
                let smooth = if bent.iter().all(|n| n.dot(normal) > FLAT) {
                    u32::MAX
                } else {
                    all.normals.push(bent);
                    all.normals.len() as u32 - 1
                };
                all.facets.push(Facet { corners, normal, material: *material, smooth });
            }
        }
        all
    }

    /// One triangle of one instance.
    pub fn get(&self, instance: u32, triangle: u32) -> &Facet {
        &self.facets[(self.first[instance as usize] + triangle) as usize]
    }

    /// Every triangle: (instance, triangle, facet).
    pub fn iter(&self) -> impl Iterator<Item = (u32, u32, &Facet)> {
        let end = |i: usize| self.first.get(i + 1).map_or(self.facets.len(), |e| *e as usize);
        (0..self.first.len()).flat_map(move |i| {
            (0..).zip(&self.facets[self.first[i] as usize..end(i)]).map(move |(k, f)| (i as u32, k, f))
        })
    }

    /// Unit shading normal at barycentric (u, v), on the front side.
    pub fn shading_normal(&self, facet: &Facet, u: f32, v: f32) -> Vec3 {
        let Some([a, b, c]) = self.normals.get(facet.smooth as usize) else { return facet.normal };
        let n = (*a * (1.0 - u - v) + *b * u + *c * v).normalize_or(facet.normal);
        if n.dot(facet.normal) < 0.0 { -n } else { n }
    }
}

/// Cosine above which a shading normal is the geometric one.
const FLAT: f32 = 0.999_999;

/// Normals transform by the inverse transpose, here the cofactors: no division, no trouble with mirrors.
fn turned(transform: &Affine3A, n: Vec3) -> Vec3 {
    let m = transform.matrix3;
    let [x, y, z] = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
    Vec3::from(x * n.x + y * n.y + z * n.z)
}
