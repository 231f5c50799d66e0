//! Material libraries: lines of factors and picture names, gathered for each `newmtl`.

use super::material::{Source, Surface};
use super::pictures::{Pictures, Wish};
use super::{numbers, too_long};
use crate::color::Rgb;
use crate::error::Result;
use crate::import::Limits;
use crate::import::files::Root;
use crate::import::lines::{Place, TooLong, next_line, words};
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::import::report::quote;
use crate::scene::Scene;
use std::collections::HashMap;
use std::path::Path;

/// Where a library's materials go.
pub(super) struct Into<'a> {
    pub(super) scene: &'a mut Scene,
    pub(super) names: &'a mut HashMap<String, u32>,
    pub(super) root: &'a Root,
    pub(super) limits: &'a Limits,
    pub(super) pictures: &'a mut Pictures,
}

impl Into<'_> {
    /// Reads a library's bytes.
    pub(super) fn read(&mut self, file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<()> {
        let shown = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut open: Option<(String, Surface)> = None;
        let mut wishes = Vec::new();
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
                wishes.extend(self.close(open.take(), place, notes));
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
        wishes.extend(self.close(open.take(), shown, notes));
        self.pictures.grant(wishes, file, self.root, self.scene, notes)
    }

    /// A material is complete, but for the pictures that it wishes.
    fn close(&mut self, done: Option<(String, Surface)>, place: String, notes: &mut Notes) -> Option<Wish> {
        let (name, surface) = done?;
        if self.names.contains_key(&name) {
            notes.warn(place, "a material defined twice; the first is used");
            return None;
        }
        let (made, mended) = surface.to_material(clipped(&name));
        if let Some(mended) = mended {
            notes.warn(&place, mended);
        }
        let material = self.scene.materials.len() as u32;
        self.names.insert(name, material);
        self.scene.materials.push(made);
        surface.has_pictures().then_some(Wish { material, surface, place })
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
