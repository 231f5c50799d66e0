//! Scene files in. One table by extension: a new format is one file and one row.

pub(crate) mod files;
mod gltf;
pub mod image;
mod lines;
mod mgf;
mod name;
mod notes;
mod obj;
mod point_tree;
mod polygon;
mod report;

use crate::color::BRIGHTEST;
use crate::error::{Error, Result};
use crate::scene::Scene;
use crate::texture::Image;
use image::Gate;
use std::path::{Path, PathBuf};

/// A scene, and what was odd about its file.
#[derive(Clone, Debug, Default)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// What was ignored or mended, each as `file:line: what` and once for each kind with its count.
    pub warnings: Vec<String>,
}

/// How to load.
#[derive(Clone, Debug)]
pub struct Options {
    /// The folder beneath which every file must lie; the scene's own folder where `None`.
    pub root: Option<PathBuf>,
    /// Bounds on what a file may ask for.
    pub limits: Limits,
    /// Facets around a full circle where a format has curved shapes: a multiple of 4, from 4 to 4096.
    pub circle_steps: u32,
}

/// Facets around a circle unless asked otherwise, as many as the usual converters of MGF make.
pub const CIRCLE_STEPS: u32 = 20;

impl Default for Options {
    fn default() -> Self {
        Options { root: None, limits: Limits::default(), circle_steps: CIRCLE_STEPS }
    }
}

/// Bounds on what a file may ask for; each has an option of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes in one file.
    pub file_bytes: u64,
    /// Triangles in the whole scene.
    pub triangles: u64,
    /// Files included within each other.
    pub include_depth: u64,
    /// Entities read in all, repetitions by arrays and includes counted.
    pub entities: u64,
    /// Product of the array sizes in force at one place.
    pub array: u64,
    /// Vertices of one polygon.
    pub polygon: u64,
    /// Bytes of JSON in one glTF file.
    pub json_bytes: u64,
    /// Nodes of a glTF file; its meshes; its accessors.
    pub nodes: u64,
    /// Nodes within each other.
    pub depth: u64,
    /// Meshes placed by nodes.
    pub instances: u64,
    /// Objects and groups of an OBJ file.
    pub objects: u64,
    /// Material libraries of an OBJ file.
    pub libraries: u64,
    /// Bytes in one line of OBJ or MTL.
    pub line_bytes: u64,
    /// Pixels of one picture.
    pub image_pixels: u64,
    /// Bytes of all pictures, decoded.
    pub image_bytes: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            file_bytes: 4 << 30,
            triangles: 50_000_000,
            include_depth: 16,
            entities: 50_000_000,
            array: 10_000_000,
            polygon: 65_536,
            json_bytes: 256 << 20,
            nodes: 1_000_000,
            depth: 1024,
            instances: 10_000_000,
            objects: 1_000_000,
            libraries: 64,
            line_bytes: lines::LINE_BYTES as u64,
            image_pixels: 1 << 28,
            image_bytes: 4 << 30,
        }
    }
}

/// A row of the table.
pub struct Format {
    /// Extensions in lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// What it is called.
    pub name: &'static str,
    /// The reader.
    pub load: fn(&Path, &Options) -> Result<Loaded>,
}

/// Every format that can be read.
pub const FORMATS: &[Format] = &[
    Format { extensions: &["gltf", "glb"], name: "glTF 2.0", load: gltf::load },
    Format { extensions: &["mgf"], name: "Materials and Geometry Format", load: mgf::load },
    Format { extensions: &["obj"], name: "Wavefront OBJ with MTL", load: obj::load },
];

/// Reads a picture that no scene names, as an environment.
///
/// # Errors
/// [`Error::CannotRead`] for what is no picture, [`Error::OverLimit`] for one that is too large.
pub fn picture(path: &Path, options: &Options) -> Result<Image> {
    let (root, file) = files::Root::new(path, &Options { root: None, ..options.clone() })?;
    let bytes = root.read(&file)?;
    let admitted = Gate::new(options.limits).admit(&bytes).map_err(|refusal| refusal.into_error(path))?;
    let name = path.file_name().map(|n| n.to_string_lossy()).unwrap_or_default();
    admitted.decode(&name).map_err(|reason| Error::CannotRead { file: path.into(), reason })
}

/// Loads a scene file by its extension.
pub fn load(path: &Path, options: &Options) -> Result<Loaded> {
    let steps = options.circle_steps;
    if !(4..=4096).contains(&steps) || !steps.is_multiple_of(4) {
        return Err(Error::BadSetting(format!(
            "{steps} facets a circle: give a multiple of 4 from 4 to 4096"
        )));
    }
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    match FORMATS.iter().find(|f| f.extensions.contains(&extension.as_str())) {
        Some(format) => (format.load)(path, options),
        None => {
            let known: Vec<_> = FORMATS.iter().flat_map(|f| f.extensions).copied().collect();
            Err(Error::CannotRead {
                file: path.into(),
                reason: format!("no reader for the extension \"{extension}\"; known: {}", known.join(", ")),
            })
        }
    }
}
