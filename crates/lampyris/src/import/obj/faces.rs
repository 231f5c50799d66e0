//! Faces: corners that name position, texture coordinates and normal apart become vertices that have all three, and
//! polygons become triangles.

use crate::import::polygon::{flatten, triangulate, vector_area};
use crate::scene::Mesh;
use glam::{DVec2, DVec3, Vec2, Vec3};
use std::collections::HashMap;

/// Stands for what a corner does not have.
const NONE: u32 = u32::MAX;

/// Farthest coordinate [m]; squares of it stay within single precision.
const FARTHEST: f32 = 1e18;

/// A face's corner: indices of position, texture coordinates and normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Corner([u32; 3]);

impl Corner {
    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`, each counted from 1, or from the end if negative.
    pub(super) fn parse(word: &str, of: &Faces) -> Result<Corner, String> {
        let counts = [of.positions.len(), of.uvs.len(), of.normals.len()];
        let mut corner = [NONE; 3];
        for ((k, part), count) in word.split('/').enumerate().zip(counts.into_iter().chain([0])) {
            let slot = corner.get_mut(k).ok_or("a corner has at most three indices")?;
            if part.is_empty() && k > 0 {
                continue;
            }
            let number: i64 = part.parse().map_err(|_| "a corner that is no index")?;
            let index = if number < 0 { count as i64 + number } else { number - 1 };
            let known = u32::try_from(index).ok().filter(|i| (*i as usize) < count && *i != NONE);
            *slot = known.ok_or_else(|| format!("index {number} of {count}"))?;
        }
        Ok(Corner(corner))
    }
}

/// All positions, coordinates and normals of the file, and the mesh that grows.
#[derive(Default)]
pub(super) struct Faces {
    pub(super) positions: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) normals: Vec<Vec3>,
    /// The face being read.
    pub(super) outline: Vec<Corner>,
    /// Triangles in all.
    pub(super) triangles: u64,
    mesh: Mesh,
    vertices: HashMap<Corner, u32>,
    /// The face's corners as the mesh numbers them.
    numbers: Vec<u32>,
}

impl Faces {
    /// Adds the outline as triangles; says what was odd about it.
    pub(super) fn add(&mut self, material: u32) -> Result<Option<&'static str>, String> {
        let place = |c: &Corner| self.positions.get(c.0[0] as usize).copied().unwrap_or_default();
        let nowhere = |p: Vec3| !p.is_finite() || p.abs().max_element() > FARTHEST;
        if self.outline.iter().any(|c| nowhere(place(c))) {
            return Ok(Some(
                "positions that are not finite, or farther than 1e18 m; their faces are left out",
            ));
        }
        let (polygon, odd);
        let triangles: &[[u32; 3]] = if self.outline.len() == 3 {
            odd = None;
            &[[0, 1, 2]]
        } else {
            (polygon, odd) = cut(&self.outline.iter().map(|c| place(c).as_dvec3()).collect::<Vec<_>>());
            &polygon
        };
        self.numbers.clear();
        for k in 0..self.outline.len() {
            let number = self.vertex(self.outline[k])?;
            self.numbers.push(number);
        }
        self.triangles += triangles.len() as u64;
        self.mesh.triangles.extend(triangles.iter().map(|t| t.map(|k| self.numbers[k as usize])));
        self.mesh.materials.resize(self.mesh.triangles.len(), material);
        Ok(odd)
    }

    /// The number of a vertex, new or met before.
    fn vertex(&mut self, corner: Corner) -> Result<u32, String> {
        let next = self.mesh.positions.len();
        let next = u32::try_from(next).map_err(|_| "more than 2^32 vertices; split the object")?;
        let number = *self.vertices.entry(corner).or_insert(next);
        if number == next {
            let [p, t, n] = corner.0;
            let mesh = &mut self.mesh;
            mesh.positions.push(self.positions[p as usize]);
            // Sets begin with the first vertex that has one; those without have zeros.
            if t != NONE || !mesh.uvs[0].is_empty() {
                mesh.uvs[0].resize(next as usize, Vec2::ZERO);
                mesh.uvs[0].push(self.uvs.get(t as usize).copied().unwrap_or_default());
            }
            if n != NONE || !mesh.normals.is_empty() {
                mesh.normals.resize(next as usize, Vec3::ZERO);
                mesh.normals.push(self.normals.get(n as usize).copied().unwrap_or_default());
            }
        }
        Ok(number)
    }

    /// The mesh so far, if it has triangles; the next one begins empty.
    pub(super) fn take_mesh(&mut self) -> Option<Mesh> {
        self.vertices = HashMap::new();
        let mut mesh = std::mem::take(&mut self.mesh);
        mesh.positions.shrink_to_fit();
        mesh.triangles.shrink_to_fit();
        mesh.materials.shrink_to_fit();
        (!mesh.triangles.is_empty()).then_some(mesh)
    }
}

/// Triangles of a polygon: a fan of a convex quadrilateral, cut ears of everything else.
fn cut(points: &[DVec3]) -> (Vec<[u32; 3]>, Option<&'static str>) {
    let normal = vector_area(points);
    let flat = flatten(points, normal);
    if let [a, b, c, d] = flat[..]
        && [[d, a, b], [a, b, c], [b, c, d], [c, d, a]].iter().all(|[a, b, c]| turn(*a, *b, *c) > 0.0)
    {
        return (vec![[0, 1, 2], [0, 2, 3]], None);
    }
    let made = triangulate(&flat, &[points.len()]);
    let odd = (!made.simple).then_some("polygons whose outline crosses itself");
    (made.triangles, odd)
}

fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - b)
}
