//! Wavefront OBJ with its material libraries (docs/formats.md says what is read and how it maps).
//! The format states neither a unit nor an upward direction: metres and +y are taken.

mod faces;
mod library;
mod material;
mod pictures;

use super::files::Root;
use super::lines::{Place, TooLong, next_line, words};
use super::name::clipped;
use super::notes::Notes;
use super::report::quote;
use super::{Limits, Loaded, Options};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::material::{Bsdf, Diffuse, Material, Sides};
use crate::scene::{Instance, Scene};
use faces::{Corner, Faces};
use glam::{Affine3A, Vec2, Vec3};
use pictures::Pictures;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Loads an `.obj` file and the libraries it names.
pub(super) fn load(path: &Path, options: &Options) -> Result<Loaded> {
    let (root, file) = Root::new(path, options)?;
    let bytes = root.read(&file)?;
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let mut reader = Reader {
        limits: &options.limits,
        notes: Notes::new(&file),
        root,
        file: &file,
        scene: Scene { up: Some(Vec3::Y), ..Scene::default() },
        materials: HashMap::new(),
        libraries: Vec::new(),
        pictures: Pictures::new(options.limits),
        current: None,
        object: String::new(),
        group: String::new(),
        stem: clipped(&stem).to_owned(),
        objects: 0,
        faces: Faces::default(),
    };
    reader.run(&bytes)?;
    Ok(Loaded { scene: reader.scene, warnings: reader.notes.into_lines() })
}

/// The reader's state between two lines.
struct Reader<'a> {
    limits: &'a Limits,
    notes: Notes,
    root: Root,
    file: &'a Path,
    scene: Scene,
    /// Materials by name; a name defined twice means the first.
    materials: HashMap<String, u32>,
    libraries: Vec<PathBuf>,
    pictures: Pictures,
    /// Material of the faces that follow.
    current: Option<u32>,
    object: String,
    group: String,
    stem: String,
    objects: u64,
    faces: Faces,
}

impl Reader<'_> {
    fn run(&mut self, bytes: &[u8]) -> Result<()> {
        let mut place = Place::default();
        loop {
            match next_line(bytes, &mut place, self.limits.line_bytes as usize) {
                Ok(None) => break,
                Ok(Some(line)) => self.line(&line.text, line.number)?,
                Err(TooLong(number)) => return Err(too_long(self.file, number, self.limits)),
            }
        }
        self.finish_object();
        Ok(())
    }

    fn line(&mut self, text: &str, number: u64) -> Result<()> {
        let place = format_args!("line {number}");
        let mut rest = words(text);
        let Some(keyword) = rest.next().filter(|w| !w.starts_with('#')) else { return Ok(()) };
        match keyword {
            "v" => {
                let (p, given) = numbers::<3>(rest);
                if given < 3 {
                    return Err(self.notes.bad(place, "a vertex needs three numbers"));
                }
                if given >= 6 {
                    self.notes.warn(place, "colours at vertices are not read");
                }
                self.faces.positions.push(Vec3::from_array(p));
            }
            // Pictures begin at the lower left here, at the upper left in the scene.
            "vt" => {
                let ([u, v], _) = numbers::<2>(rest);
                let finite = |v: f32| if v.is_finite() { v } else { 0.0 };
                self.faces.uvs.push(Vec2::new(finite(u), 1.0 - finite(v)));
            }
            "vn" => {
                let n = Vec3::from_array(numbers::<3>(rest).0);
                self.faces.normals.push(n.normalize_or_zero());
            }
            "f" => self.face(rest, number)?,
            "o" => {
                self.begin(number)?;
                self.object = clipped(text.trim()[1..].trim()).to_owned();
                self.group.clear();
            }
            "g" => {
                self.begin(number)?;
                self.group = clipped(text.trim()[1..].trim()).to_owned();
            }
            "usemtl" => {
                let name = text.trim()[6..].trim();
                self.current = self.materials.get(name).copied();
                if self.current.is_none() {
                    self.notes.warn(place, &format!("material {} is not defined; grey is used", quote(name)));
                }
            }
            "mtllib" => self.library(text.trim()[6..].trim(), number)?,
            // Smoothing needs normals of the file's own; without them faces are flat.
            "s" => {}
            "p" | "l" => self.notes.warn(place, "points and lines are not drawn"),
            other => self.notes.warn(place, &format!("{} is not read", quote(other))),
        }
        Ok(())
    }

    /// A new object or group begins.
    fn begin(&mut self, number: u64) -> Result<()> {
        self.finish_object();
        self.objects += 1;
        let place = format_args!("line {number}");
        self.notes.limit(
            place,
            "the number of objects and groups",
            self.objects,
            self.limits.objects,
            "--max-objects",
        )
    }

    /// The faces since the last object or group become a mesh and its instance.
    fn finish_object(&mut self) {
        let Some(mesh) = self.faces.take_mesh() else { return };
        let name = match (self.object.as_str(), self.group.as_str()) {
            ("", "") => self.stem.clone(),
            (object, "") => object.to_owned(),
            ("", group) => group.to_owned(),
            (object, group) => clipped(&format!("{object}/{group}")).to_owned(),
        };
        let mesh_number = self.scene.meshes.len() as u32;
        self.scene.meshes.push(mesh);
        self.scene.instances.push(Instance { name, mesh: mesh_number, transform: Affine3A::IDENTITY });
    }

    fn face<'w>(&mut self, corners: impl Iterator<Item = &'w str>, number: u64) -> Result<()> {
        let place = format_args!("line {number}");
        self.faces.outline.clear();
        for word in corners {
            let corner = Corner::parse(word, &self.faces).map_err(|e| self.notes.bad(place, e))?;
            self.faces.outline.push(corner);
        }
        let count = self.faces.outline.len() as u64;
        if count < 3 {
            self.notes.warn(place, "faces of fewer than three corners; left out");
            return Ok(());
        }
        let polygon = "the number of a polygon's vertices";
        self.notes.limit(place, polygon, count, self.limits.polygon, "--max-polygon")?;
        let total = self.faces.triangles.saturating_add(count - 2);
        self.notes.limit(
            place,
            "the number of triangles",
            total,
            self.limits.triangles,
            "--max-triangles",
        )?;
        let material = match self.current {
            Some(material) => material,
            None => self.grey(),
        };
        if let Some(odd) = self.faces.add(material).map_err(|e| self.notes.bad(place, e))? {
            self.notes.warn(place, odd);
        }
        Ok(())
    }

    /// The material of faces that have none.
    fn grey(&mut self) -> u32 {
        let next = self.scene.materials.len() as u32;
        // No `usemtl` can name it: names there are trimmed.
        let number = *self.materials.entry(" ".into()).or_insert(next);
        if number == next {
            let bsdf = Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.5)));
            self.scene.materials.push(Material { sides: Sides::EmitFront, ..Material::new("default", bsdf) });
        }
        number
    }

    /// Reads a library: one file whose name may have blanks, or several.
    fn library(&mut self, names: &str, number: u64) -> Result<()> {
        let place = format_args!("line {number}");
        let whole = self.root.resolve(self.file, names);
        let found = match whole {
            Ok(path) => vec![Ok(path)],
            Err(why) if words(names).count() < 2 => vec![Err(why)],
            Err(_) => words(names).map(|name| self.root.resolve(self.file, name)).collect(),
        };
        for path in found {
            let path = match path {
                Ok(path) => path,
                Err(why) => {
                    self.notes.warn(place, &format!("a material library is missing: {why}"));
                    continue;
                }
            };
            if self.libraries.contains(&path) {
                continue;
            }
            self.libraries.push(path.clone());
            let (count, limit) = (self.libraries.len() as u64, self.limits.libraries);
            self.notes.limit(place, "the number of material libraries", count, limit, "--max-libraries")?;
            let bytes = self.root.read(&path)?;
            let mut into = library::Into {
                scene: &mut self.scene,
                names: &mut self.materials,
                root: &self.root,
                limits: self.limits,
                pictures: &mut self.pictures,
            };
            into.read(&path, &bytes, &mut self.notes)?;
        }
        Ok(())
    }
}

/// The first numbers among words, 0 for those missing, and how many numbers there are.
fn numbers<'w, const N: usize>(words: impl Iterator<Item = &'w str>) -> ([f32; N], usize) {
    let mut out = [0.0; N];
    let mut given = 0;
    for value in words.map_while(|w| w.parse::<f32>().ok()) {
        if let Some(slot) = out.get_mut(given) {
            *slot = value;
        }
        given += 1;
    }
    (out, given)
}

fn too_long(file: &Path, number: u64, limits: &Limits) -> Error {
    Error::OverLimit {
        file: file.into(),
        place: format!("line {number}"),
        what: "the length of the line".into(),
        limit: limits.line_bytes,
        option: "--max-line-bytes",
    }
}
