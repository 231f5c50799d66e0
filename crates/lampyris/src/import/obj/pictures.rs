//! The pictures that a library's materials name: found and read in the order of the file, decoded by all cores, and then
//! given to the materials in their order, so that warnings and numbers do not depend on who was done first.

use super::material::{Source, Surface};
use crate::error::Result;
use crate::import::Limits;
use crate::import::files::Root;
use crate::import::image::{self, Gate};
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::import::report::quote;
use crate::material::Map;
use crate::scene::Scene;
use crate::texture::{Encoding, Filter, Pixels, Texture, Wrap};
use glam::Affine2;
use std::borrow::Cow;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A material that names pictures.
pub(super) struct Wish {
    /// Its number in the scene.
    pub(super) material: u32,
    pub(super) surface: Surface,
    /// Where its lines end, for warnings.
    pub(super) place: String,
}

impl Wish {
    /// The pictures that it takes: what is a bump beside normals is not looked at.
    fn sources(&self) -> impl Iterator<Item = &Source> {
        let s = &self.surface;
        [&s.map_kd, &s.map_ke, &s.map_d, if s.norm.is_some() { &s.norm } else { &s.bump }]
            .into_iter()
            .flatten()
    }
}

/// What became of a picture: its number in the scene, or why there is none, until that was told.
type Fate = std::result::Result<u32, Option<String>>;

/// The pictures of all libraries of a scene.
pub(super) struct Pictures {
    /// Counts what they take.
    gate: Gate,
    /// Those met before.
    fates: HashMap<PathBuf, Fate>,
}

impl Pictures {
    /// None yet.
    pub(super) fn new(limits: Limits) -> Pictures {
        Pictures { gate: Gate::new(limits), fates: HashMap::new() }
    }

    /// Gives the materials of the library `file` their pictures; a warning where one cannot be had.
    pub(super) fn grant(
        &mut self,
        wishes: Vec<Wish>,
        file: &Path,
        root: &Root,
        scene: &mut Scene,
        notes: &mut Notes,
    ) -> Result<()> {
        let mut found = HashMap::new();
        for source in wishes.iter().flat_map(Wish::sources) {
            let name = source.file.as_str();
            found.entry(name).or_insert_with(|| root.resolve(file, name));
        }
        self.decode(&wishes, &found, root, file, scene)?;
        for wish in &wishes {
            let s = &wish.surface;
            let mut map = |source: &Option<Source>, encoding| {
                let source = source.as_ref()?;
                let fate = match found.get(source.file.as_str())? {
                    Ok(path) => match self.fates.get_mut(path)? {
                        Ok(image) => Ok(*image),
                        Err(why) => Err(why.take()?),
                    },
                    Err(why) => Err(why.clone()),
                };
                let warn =
                    |why| notes.warn(&wish.place, &format!("{why}; the material's factors stand for it"));
                Some(look_up(source, fate.map_err(warn).ok()?, encoding, &mut scene.textures))
            };
            let color = map(&s.map_kd, Encoding::Srgb);
            let emission = map(&s.map_ke, Encoding::Srgb);
            let alpha = map(&s.map_d, Encoding::Linear);
            let normal = map(&s.norm, Encoding::Linear).map(|m| (m, 1.0));
            let bumpy = s.bump.as_ref().filter(|_| s.norm.is_none());
            let bumpy = bumpy.and_then(|bump| Some((map(&s.bump, Encoding::Linear)?, bump.multiplier)));
            // The same word names heights and normals; the first are grey.
            let bumpy = bumpy.filter(|(map, _)| {
                let grey = is_grey(&scene.images[scene.textures[map.texture as usize].image as usize].pixels);
                if grey {
                    notes.warn(&wish.place, "pictures of heights (map_Bump) are not read; give normals");
                }
                !grey
            });
            let maps = &mut scene.materials[wish.material as usize].maps;
            (maps.color, maps.emission, maps.alpha) = (color, emission, alpha);
            maps.normal = normal.or(bumpy);
        }
        Ok(())
    }

    /// Reads and decodes the pictures that were not met before.
    fn decode(
        &mut self,
        wishes: &[Wish],
        found: &HashMap<&str, std::result::Result<PathBuf, String>>,
        root: &Root,
        file: &Path,
        scene: &mut Scene,
    ) -> Result<()> {
        let (mut paths, mut sources) = (Vec::new(), Vec::new());
        for source in wishes.iter().flat_map(Wish::sources) {
            let name = source.file.as_str();
            let Some(Ok(path)) = found.get(name) else { continue };
            if self.fates.contains_key(path) {
                continue;
            }
            self.fates.insert(path.clone(), Err(None));
            let bytes = root.read(path).map(Cow::Owned).map_err(|e| e.to_string());
            paths.push(path);
            sources.push(image::Source { name: clipped(name).to_owned(), bytes });
        }
        let decoded = self.gate.decode(&sources).map_err(|(_, over)| over.into_error(file))?;
        for ((path, source), made) in paths.into_iter().zip(&sources).zip(decoded) {
            let fate = match made {
                Ok(image) => {
                    scene.images.push(image);
                    Ok(scene.images.len() as u32 - 1)
                }
                Err(why) if source.bytes.is_err() => Err(Some(why)),
                Err(why) => Err(Some(format!("{}: {why}", quote(&source.name)))),
            };
            self.fates.insert(path.clone(), fate);
        }
        Ok(())
    }
}

/// A picture as a texture of the scene.
fn look_up(source: &Source, image: u32, encoding: Encoding, textures: &mut Vec<Texture>) -> Map {
    let wrap = if source.clamp { Wrap::Clamp } else { Wrap::Repeat };
    let texture = Texture { image, encoding, wrap: [wrap; 2], filter: Filter::Linear };
    let number = textures.iter().position(|t| *t == texture).unwrap_or_else(|| {
        textures.push(texture);
        textures.len() - 1
    });
    Map { texture: number as u32, set: 0, transform: Affine2::IDENTITY }
}

fn is_grey(pixels: &Pixels) -> bool {
    match pixels {
        Pixels::Byte(p) => p.iter().all(|[r, g, b, _]| r == g && g == b),
        Pixels::Float(p) => p.iter().all(|[r, g, b]| r == g && g == b),
    }
}
