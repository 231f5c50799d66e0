//! Material libraries: lines of factors and picture names, gathered for each `newmtl`.

use super::material::{Source, Surface};
use super::{numbers, too_long};
use crate::color::Rgb;
use crate::error::Result;
use crate::import::Limits;
use crate::import::files::Root;
use crate::import::image::{Gate, Refusal};
use crate::import::lines::{Place, TooLong, next_line, words};
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::import::report::quote;
use crate::material::Map;
use crate::scene::Scene;
use crate::texture::{Encoding, Filter, Pixels, Texture, Wrap};
use glam::Affine2;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Where a library's materials go.
pub(super) struct Into<'a> {
    pub(super) scene: &'a mut Scene,
    pub(super) names: &'a mut HashMap<String, u32>,
    pub(super) root: &'a Root,
    pub(super) limits: &'a Limits,
    /// Counts what pictures take.
    pub(super) gate: &'a mut Gate,
    /// Pictures met before, and what became of them.
    pub(super) images: &'a mut HashMap<PathBuf, Option<u32>>,
}

impl Into<'_> {
    /// Reads a library's bytes.
    pub(super) fn read(&mut self, file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<()> {
        let shown = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut open: Option<(String, Surface)> = None;
        let mut place = Place::default();
        loop {
            let line = match next_line(bytes, &mut place, self.limits.line_bytes as usize) {
                Ok(Some(line)) => line,
                Ok(None) => break,
                Err(TooLong(number)) => return Err(too_long(file, number, self.limits)),
            };
            let place = format!("{shown}, line {}", line.number);
            let text = line.text.trim();
            let Some(keyword) = words(text).next().filter(|w| !w.starts_with('#')) else { continue };
            let rest = text[keyword.len()..].trim();
            if keyword == "newmtl" {
                self.close(open.take(), file, &place, notes)?;
                open = Some((rest.to_owned(), Surface::default()));
            } else if let Some((_, surface)) = &mut open {
                match set(surface, keyword, rest) {
                    Set::Done => {}
                    Set::Unknown => notes.warn(&place, &format!("{} is not read", quote(keyword))),
                    Set::Broken => notes.warn(&place, &format!("{} without its numbers", quote(keyword))),
                }
            } else {
                notes.warn(&place, "a line before the first newmtl");
            }
        }
        self.close(open.take(), file, &shown, notes)
    }

    /// A material is complete.
    fn close(
        &mut self,
        done: Option<(String, Surface)>,
        file: &Path,
        place: &str,
        notes: &mut Notes,
    ) -> Result<()> {
        let Some((name, surface)) = done else { return Ok(()) };
        if self.names.contains_key(&name) {
            notes.warn(place, "a material defined twice; the first is used");
            return Ok(());
        }
        let (mut material, mended) = surface.to_material(clipped(&name));
        if let Some(mended) = mended {
            notes.warn(place, mended);
        }
        let mut map = |source: &Option<Source>, encoding| match source {
            Some(source) => self.map(source, encoding, file, place, notes),
            None => Ok(None),
        };
        material.maps.color = map(&surface.map_kd, Encoding::Srgb)?;
        material.maps.emission = map(&surface.map_ke, Encoding::Srgb)?;
        material.maps.alpha = map(&surface.map_d, Encoding::Linear)?;
        material.maps.normal = map(&surface.norm, Encoding::Linear)?.map(|m| (m, 1.0));
        if let (None, Some(bump)) = (&surface.norm, &surface.bump)
            && let Some(bumpy) = map(&surface.bump, Encoding::Linear)?
        {
            // The same word names heights and normals; the first are grey.
            let image = self.scene.textures[bumpy.texture as usize].image as usize;
            if is_grey(&self.scene.images[image].pixels) {
                notes.warn(place, "pictures of heights (map_Bump) are not read; give normals");
            } else {
                material.maps.normal = Some((bumpy, bump.multiplier));
            }
        }
        self.names.insert(name, self.scene.materials.len() as u32);
        self.scene.materials.push(material);
        Ok(())
    }

    /// A picture as a texture; a warning where it cannot be had.
    fn map(
        &mut self,
        source: &Source,
        encoding: Encoding,
        file: &Path,
        place: &str,
        notes: &mut Notes,
    ) -> Result<Option<Map>> {
        let image = match self.image(source, file) {
            Ok(Some(image)) => image,
            Ok(None) => return Ok(None),
            Err(Refusal::Unreadable(why)) => {
                notes.warn(place, &format!("{why}; the material's factors stand for it"));
                return Ok(None);
            }
            Err(over) => return Err(over.into_error(file)),
        };
        let wrap = if source.clamp { Wrap::Clamp } else { Wrap::Repeat };
        let texture = Texture { image, encoding, wrap: [wrap; 2], filter: Filter::Linear };
        let textures = &mut self.scene.textures;
        let number = textures.iter().position(|t| *t == texture).unwrap_or_else(|| {
            textures.push(texture);
            textures.len() - 1
        });
        Ok(Some(Map { texture: number as u32, set: 0, transform: Affine2::IDENTITY }))
    }

    /// The number of a picture; `None` for one that was refused before.
    fn image(&mut self, source: &Source, file: &Path) -> std::result::Result<Option<u32>, Refusal> {
        let path = self.root.resolve(file, &source.file).map_err(Refusal::Unreadable)?;
        if let Some(known) = self.images.get(&path) {
            return Ok(*known);
        }
        self.images.insert(path.clone(), None);
        let bytes = self.root.read(&path).map_err(|e| Refusal::Unreadable(e.to_string()))?;
        let named = |why| Refusal::Unreadable(format!("{}: {why}", quote(&source.file)));
        let admitted = self.gate.admit(&bytes).map_err(|refusal| match refusal {
            Refusal::Unreadable(why) => named(why),
            over => over,
        })?;
        let image = admitted.decode(clipped(&source.file)).map_err(named)?;
        let number = self.scene.images.len() as u32;
        self.scene.images.push(image);
        self.images.insert(path, Some(number));
        Ok(Some(number))
    }
}

fn is_grey(pixels: &Pixels) -> bool {
    match pixels {
        Pixels::Byte(p) => p.iter().all(|[r, g, b, _]| r == g && g == b),
        Pixels::Float(p) => p.iter().all(|[r, g, b]| r == g && g == b),
    }
}

/// What became of a line.
enum Set {
    Done,
    Unknown,
    Broken,
}

/// A line of a material.
fn set(s: &mut Surface, keyword: &str, rest: &str) -> Set {
    let color = |slot: &mut Rgb| {
        let ([r, g, b], given) = numbers::<3>(words(rest));
        // One number stands for three.
        let (g, b) = if given == 1 { (r, r) } else { (g, b) };
        let value = Rgb::new(r, g, b);
        let good = given > 0 && value.is_finite();
        if good {
            *slot = value.map(|v| v.max(0.0));
        }
        good
    };
    let number = |slot: &mut f32| {
        // `d -halo 0.5` is a number too.
        let ([v], given) = numbers::<1>(words(rest.trim_start_matches("-halo")));
        let good = given > 0 && v.is_finite();
        if good {
            *slot = v;
        }
        good
    };
    let optional = |slot: &mut Option<f32>| {
        let mut v = 0.0;
        let good = number(&mut v);
        if good {
            *slot = Some(v);
        }
        good
    };
    let picture = |slot: &mut Option<Source>| {
        *slot = Source::parse(rest);
        slot.is_some()
    };
    let good = match keyword {
        "Kd" => color(&mut s.kd),
        "Ks" => color(&mut s.ks),
        "Ke" => color(&mut s.ke),
        "Tf" => color(&mut s.tf),
        "Ns" => number(&mut s.ns),
        "Ni" => optional(&mut s.ni),
        "d" => number(&mut s.d),
        "Tr" => {
            let mut tr = 0.0;
            let good = number(&mut tr);
            if good {
                s.d = 1.0 - tr;
            }
            good
        }
        "illum" => {
            let mut model = 0.0;
            let good = number(&mut model);
            s.illum = model as u32;
            good
        }
        "Pr" => optional(&mut s.pr),
        "Pm" => optional(&mut s.pm),
        "map_Kd" => picture(&mut s.map_kd),
        "map_Ke" => picture(&mut s.map_ke),
        "map_d" => picture(&mut s.map_d),
        "norm" | "map_Norm" => picture(&mut s.norm),
        "map_Bump" | "map_bump" | "bump" => picture(&mut s.bump),
        // Light from everywhere is computed here; sharpness belongs to reflections from pictures.
        "Ka" | "map_Ka" | "sharpness" => true,
        _ => return Set::Unknown,
    };
    if good { Set::Done } else { Set::Broken }
}
