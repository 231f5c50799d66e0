//! glTF files made for one test, piece by piece, and loading them from a folder of their own.
#![allow(dead_code, reason = "each test binary uses its own part")]

use lampyris::import::{Loaded, Options, load};
use lampyris::scene::Scene;
use lampyris::{Error, Result};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

#[path = "../folder/mod.rs"]
pub(crate) mod folder;

pub(crate) use folder::Folder;

/// A document and its binary chunk, while they grow.
#[derive(Clone)]
pub(crate) struct Glb {
    pub(crate) json: Value,
    pub(crate) binary: Vec<u8>,
}

impl Glb {
    pub(crate) fn new() -> Glb {
        let json = json!({"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [], "meshes": [], "nodes": []});
        Glb { json, binary: Vec::new() }
    }

    /// Appends to an array of the document; the element's number.
    pub(crate) fn add(&mut self, array: &str, element: Value) -> usize {
        if self.json[array].is_null() {
            self.json[array] = json!([]);
        }
        let items = self.json[array].as_array_mut().unwrap();
        items.push(element);
        items.len() - 1
    }

    pub(crate) fn view(&mut self, bytes: &[u8]) -> usize {
        while !self.binary.len().is_multiple_of(4) {
            self.binary.push(0);
        }
        let offset = self.binary.len();
        self.binary.extend_from_slice(bytes);
        self.add("bufferViews", json!({"buffer": 0, "byteOffset": offset, "byteLength": bytes.len()}))
    }

    pub(crate) fn accessor(&mut self, bytes: &[u8], component: u32, shape: &str, count: usize) -> usize {
        let view = self.view(bytes);
        self.add(
            "accessors",
            json!({"bufferView": view, "componentType": component, "type": shape, "count": count}),
        )
    }

    pub(crate) fn floats(&mut self, shape: &str, values: &[f32]) -> usize {
        let width = match shape {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            _ => 4,
        };
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(&bytes, 5126, shape, values.len() / width)
    }

    pub(crate) fn indices(&mut self, values: &[u32]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(&bytes, 5125, "SCALAR", values.len())
    }

    /// A mesh of one primitive, placed by a node without a transform.
    pub(crate) fn mesh(&mut self, primitive: Value) {
        let mesh = self.add("meshes", json!({"primitives": [primitive]}));
        self.add("nodes", json!({"mesh": mesh}));
    }

    /// The unit square in the xy plane as an indexed mesh with a material.
    pub(crate) fn square(&mut self, material: Value) {
        let position = self.floats("VEC3", &SQUARE);
        let indices = self.indices(&[0, 1, 2, 0, 2, 3]);
        let material = self.add("materials", material);
        self.mesh(json!({"attributes": {"POSITION": position}, "indices": indices, "material": material}));
    }

    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        if json["buffers"].is_null() {
            json["buffers"] = json!([{"byteLength": self.binary.len()}]);
        }
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        container(&text, Some(&self.binary))
    }

    pub(crate) fn load(&self) -> Result<Loaded> {
        load_bytes(&self.bytes(), &Options::default())
    }

    /// The loaded scene; it must give no warning.
    pub(crate) fn clean(&self) -> Scene {
        let loaded = self.load().unwrap();
        assert_eq!(loaded.warnings, Vec::<String>::new());
        loaded.scene
    }

    /// Place and reason of what must be broken input.
    pub(crate) fn bad(&self) -> (String, String) {
        match self.load() {
            Err(Error::BadInput { place, reason, .. }) => (place, reason),
            other => panic!("{}: {other:?}", self.json),
        }
    }
}

/// The corners of the unit square.
pub(crate) const SQUARE: [f32; 12] = [0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.];

/// A GLB of a JSON and a binary chunk.
pub(crate) fn container(json: &[u8], binary: Option<&[u8]>) -> Vec<u8> {
    let mut out = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    let mut chunk = |kind: &[u8], data: &[u8]| {
        out.extend((data.len().next_multiple_of(4) as u32).to_le_bytes());
        out.extend_from_slice(kind);
        out.extend_from_slice(data);
        out.resize(out.len().next_multiple_of(4), 0);
    };
    chunk(b"JSON", json);
    if let Some(binary) = binary {
        chunk(b"BIN\0", binary);
    }
    let length = (out.len() as u32).to_le_bytes();
    out[8..12].copy_from_slice(&length);
    out
}

pub(crate) fn load_bytes(bytes: &[u8], options: &Options) -> Result<Loaded> {
    let folder = Folder::new();
    load(&folder.write("main.glb", bytes), options)
}

/// The folder of published scenes.
pub(crate) fn scenes() -> PathBuf {
    Path::new(&std::env::var_os("LAMPYRIS_SCENES").expect("LAMPYRIS_SCENES names the folder of scenes"))
        .into()
}

/// Everything that a loaded scene promises, whatever its file was.
pub(crate) fn assert_sound(scene: &Scene) {
    for mesh in &scene.meshes {
        let n = mesh.positions.len();
        assert!(mesh.positions.iter().chain(&mesh.normals).all(|p| p.is_finite()));
        assert!(mesh.uvs.iter().flatten().all(|uv| uv.is_finite()));
        assert!(mesh.colors.iter().chain(&mesh.tangents).all(|c| c.is_finite()));
        assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < n));
        assert_eq!(mesh.triangles.len(), mesh.materials.len());
        assert!(mesh.materials.iter().all(|m| (*m as usize) < scene.materials.len()));
        let lengths = [
            mesh.normals.len(),
            mesh.uvs[0].len(),
            mesh.uvs[1].len(),
            mesh.tangents.len(),
            mesh.colors.len(),
        ];
        assert!(lengths.iter().all(|l| *l == 0 || *l == n), "{lengths:?} for {n}");
    }
    for instance in &scene.instances {
        assert!((instance.mesh as usize) < scene.meshes.len() && instance.transform.is_finite());
    }
    assert!(scene.lights.iter().all(lampyris::light::Light::is_sound));
    assert!(scene.materials.iter().all(|m| m.emission.is_finite()));
}
