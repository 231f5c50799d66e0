//! Where placed triangles go: one mesh and one instance for each occurrence of an object that has surfaces.
//! Keeps the stack of object names and the table of materials in use.
//! Coordinates leave double precision here.

use super::material::{Key, Surface};
use super::shapes::Patch;
use crate::import::name::{NAME_BYTES, clipped};
use crate::material::Material;
use crate::scene::{Instance, Mesh, Scene};
use glam::{Affine3A, DAffine3, DVec3, Vec3};
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// Farthest coordinate [m]; squares of it stay within single precision.
const FARTHEST: f64 = 1e18;

/// An open object.
struct Object {
    /// Length of the enclosing objects' name.
    outer: usize,
    mesh: Option<usize>,
}

/// The scene that grows.
pub(super) struct Sink {
    scene: Scene,
    /// The open objects; the first stands for what lies outside any.
    objects: Vec<Object>,
    path: String,
    stem: String,
    materials: HashMap<(Rc<str>, Key), u32>,
    used: HashSet<Rc<str>>,
    pub(super) triangles: u64,
}

impl Sink {
    /// An empty scene; surfaces outside any object go to one named `stem`.
    pub(super) fn new(stem: &str) -> Sink {
        Sink {
            scene: Scene::default(),
            objects: vec![Object { outer: 0, mesh: None }],
            path: String::new(),
            stem: clipped(stem).into(),
            materials: HashMap::new(),
            used: HashSet::new(),
            triangles: 0,
        }
    }

    /// How many objects are open.
    pub(super) fn depth(&self) -> usize {
        self.objects.len() - 1
    }

    /// Opens an object; true if its name had to be cut.
    pub(super) fn open(&mut self, name: &str) -> bool {
        let outer = self.path.len();
        let whole = if self.path.is_empty() { name.to_string() } else { format!("/{name}") };
        let room = NAME_BYTES - outer;
        let cut = (0..=room.min(whole.len())).rev().find(|&i| whole.is_char_boundary(i)).unwrap_or(0);
        self.path.push_str(&whole[..cut]);
        self.objects.push(Object { outer, mesh: None });
        cut < whole.len()
    }

    /// Closes the innermost object.
    pub(super) fn close(&mut self) {
        if self.depth() > 0
            && let Some(object) = self.objects.pop()
        {
            self.path.truncate(object.outer);
        }
    }

    /// The scene's number for a material, and what was mended if it is new.
    pub(super) fn material(&mut self, name: &Rc<str>, surface: &Surface) -> (u32, Option<&'static str>) {
        let key = (name.clone(), surface.key());
        if let Some(&index) = self.materials.get(&key) {
            return (index, None);
        }
        let shown = if name.is_empty() { "(unnamed)" } else { clipped(name) };
        let (material, mended) = surface.to_material(shown);
        (self.add_material(key, material), mended)
    }

    fn add_material(&mut self, key: (Rc<str>, Key), material: Material) -> u32 {
        let index = self.scene.materials.len() as u32;
        self.scene.materials.push(material);
        self.used.insert(key.0.clone());
        self.materials.insert(key, index);
        index
    }

    /// Adds triangles to the innermost object; fails if one would lie beyond all bounds.
    pub(super) fn add(&mut self, patch: &Patch, place: &DAffine3, material: u32) -> Result<(), String> {
        let mirrored = place.matrix3.determinant() < 0.0;
        let mut positions = Vec::with_capacity(patch.vertices.len());
        for vertex in &patch.vertices {
            let p = place.transform_point3(vertex.point);
            if !p.is_finite() || p.abs().max_element() > FARTHEST {
                return Err(format!("a point lies farther than {FARTHEST:e} m from the origin"));
            }
            positions.push(p.as_vec3());
        }
        let mesh = self.mesh();
        let base = mesh.positions.len();
        if u32::try_from(base + positions.len()).is_err() {
            return Err("one object has more than 2^32 vertices; split it into several".into());
        }
        if patch.vertices.iter().any(|v| v.normal != DVec3::ZERO) || !mesh.normals.is_empty() {
            // The matrix of cofactors takes normals along, mirrored ones turned: undo that, a face's sense is its own.
            let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
            let sense = if mirrored { -1.0 } else { 1.0 };
            mesh.normals.resize(base, Vec3::ZERO);
            mesh.normals.extend(patch.vertices.iter().map(|v| {
                let n = v.normal;
                let turned = (y.cross(z) * n.x + z.cross(x) * n.y + x.cross(y) * n.z) * sense;
                turned.normalize_or_zero().as_vec3()
            }));
        }
        mesh.positions.extend(positions);
        mesh.triangles.extend(patch.triangles.iter().map(|&t| {
            let [a, b, c] = t.map(|i| i + base as u32);
            if mirrored { [a, c, b] } else { [a, b, c] }
        }));
        mesh.materials.resize(mesh.triangles.len(), material);
        self.triangles += patch.triangles.len() as u64;
        Ok(())
    }

    /// The scene, completed by the named materials that no surface wears, so that an edit can put them on.
    pub(super) fn finish<'a>(mut self, named: impl Iterator<Item = (&'a Rc<str>, &'a Surface)>) -> Scene {
        for (name, surface) in named {
            if !self.used.contains(name) {
                self.material(name, surface);
            }
        }
        self.scene
    }

    /// The innermost object's mesh, made at its first surface.
    fn mesh(&mut self) -> &mut Mesh {
        let scene = &mut self.scene;
        let innermost = self.objects.len() - 1;
        let index = *self.objects[innermost].mesh.get_or_insert_with(|| {
            let name = if innermost == 0 { self.stem.clone() } else { self.path.clone() };
            scene.instances.push(Instance {
                name,
                mesh: scene.meshes.len() as u32,
                transform: Affine3A::IDENTITY,
            });
            scene.meshes.push(Mesh::default());
            scene.meshes.len() - 1
        });
        &mut scene.meshes[index]
    }
}
