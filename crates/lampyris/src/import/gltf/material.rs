//! Materials: metal, plastic and panes as [`Pbr`], glass with a thickness as [`Dielectric`].
//! Numbers out of range are brought into it. A texture whose picture cannot be had multiplies by one.

use super::json;
use crate::color::Rgb;
use crate::import::BRIGHTEST;
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::material::{Bsdf, Coverage, Dielectric, Map, Maps, Material, Pbr, Sides};
use crate::texture::{Encoding, Filter, Texture, Wrap};
use glam::{Affine2, Mat2, Vec2};
use std::collections::HashMap;

/// Least share of light that a body lets through along its attenuation distance; less has no logarithm.
const LEAST: f32 = 1e-6;

/// A material of the document as primitives wear it.
#[derive(Clone, Copy, Default)]
pub(super) struct Worn {
    /// Its number in the scene.
    pub(super) number: u32,
    /// Whether it has a normal map, which asks for tangents.
    pub(super) bumpy: bool,
}

/// Makes the scene's textures from those of the document, each once for each meaning of its bytes.
pub(super) struct Textures<'a> {
    document: &'a json::Document,
    /// For each image of the document the scene's, if it could be decoded.
    images: &'a [Option<u32>],
    numbers: HashMap<(u32, bool), u32>,
    pub(super) textures: Vec<Texture>,
}

/// Which images the materials look at.
pub(super) fn images_used(document: &json::Document) -> Vec<bool> {
    let mut used = vec![false; document.images.len()];
    for info in document.materials.iter().flat_map(infos) {
        let source = document.textures.get(info.index as usize).and_then(|t| t.source);
        if let Some(u) = source.and_then(|s| used.get_mut(s as usize)) {
            *u = true;
        }
    }
    used
}

fn infos(m: &json::Material) -> impl Iterator<Item = &json::TextureInfo> {
    let (pbr, ext) = (m.pbr_metallic_roughness.as_ref(), m.extensions.as_ref());
    [
        m.normal_texture.as_deref(),
        m.emissive_texture.as_deref(),
        pbr.and_then(|p| p.base_color_texture.as_ref()),
        pbr.and_then(|p| p.metallic_roughness_texture.as_ref()),
        ext.and_then(|e| e.specular.specular_texture.as_ref()),
        ext.and_then(|e| e.specular.specular_color_texture.as_ref()),
        ext.and_then(|e| e.transmission.transmission_texture.as_ref()),
    ]
    .into_iter()
    .flatten()
}

impl<'a> Textures<'a> {
    /// None yet.
    pub(super) fn new(document: &'a json::Document, images: &'a [Option<u32>]) -> Textures<'a> {
        Textures { document, images, numbers: HashMap::new(), textures: Vec::new() }
    }

    /// A texture as a material lays it.
    fn map(
        &mut self,
        info: Option<&json::TextureInfo>,
        encoding: Encoding,
        place: &str,
        notes: &mut Notes,
    ) -> Option<Map> {
        let info = info?;
        let transform = info.extensions.transform.as_ref();
        let set = transform.and_then(|t| t.tex_coord).unwrap_or(info.tex_coord);
        if set > 1 {
            notes.warn(place, "a third set of texture coordinates is not read; its textures are left out");
            return None;
        }
        let Some(known) = self.document.textures.get(info.index as usize) else {
            notes.warn(place, "a texture that does not exist");
            return None;
        };
        let Some(source) = known.source else {
            notes.warn(format!("texture {}", info.index), "a texture without a picture that could be read");
            return None;
        };
        // A picture that failed was warned of when it did.
        let image = self.images.get(source as usize).copied().flatten()?;
        let key = (info.index, encoding == Encoding::Srgb);
        let textures = &mut self.textures;
        let texture = *self.numbers.entry(key).or_insert_with(|| {
            let none = json::Sampler::default();
            let sampler = known.sampler.and_then(|s| self.document.samplers.get(s as usize)).unwrap_or(&none);
            let wrap = [sampler.wrap_s, sampler.wrap_t].map(|code| match code {
                33071 => Wrap::Clamp,
                33648 => Wrap::Mirror,
                _ => Wrap::Repeat,
            });
            let filter = if sampler.mag_filter == Some(9728) { Filter::Nearest } else { Filter::Linear };
            textures.push(Texture { image, encoding, wrap, filter });
            textures.len() as u32 - 1
        });
        Some(Map { texture, set, transform: transform.map_or(Affine2::IDENTITY, placed) })
    }

    /// The materials that are worn, and those with a name, so that an edit can put them on.
    pub(super) fn materials(&mut self, worn: &[bool], notes: &mut Notes) -> (Vec<Material>, Vec<Worn>) {
        let mut made = Vec::new();
        let mut surfaces = vec![Worn::default(); worn.len()];
        for (k, m) in self.document.materials.iter().enumerate().filter(|(k, m)| worn[*k] || m.name.is_some())
        {
            let material = self.material(k, m, notes);
            surfaces[k] = Worn { number: made.len() as u32, bumpy: material.maps.normal.is_some() };
            made.push(material);
        }
        (made, surfaces)
    }

    fn material(&mut self, index: usize, m: &json::Material, notes: &mut Notes) -> Material {
        let place = format!("material {index}");
        let none = Box::default();
        let ext: &json::MaterialExtensions = m.extensions.as_ref().unwrap_or(&none);
        let plain = Box::default();
        let pbr: &json::MetallicRoughness = m.pbr_metallic_roughness.as_ref().unwrap_or(&plain);
        let [r, g, b, alpha] = pbr.base_color_factor.map(share);
        let mut surface = Pbr {
            base_color: Rgb::new(r, g, b),
            metallic: share(pbr.metallic_factor),
            roughness: share(pbr.roughness_factor),
            ior: ext.ior.ior,
            specular: share(ext.specular.specular_factor),
            specular_color: color(ext.specular.specular_color_factor),
            transmission: share(ext.transmission.transmission_factor),
        };
        if !(surface.ior >= 1.0 && surface.ior.is_finite()) {
            notes.warn(&place, "an index of refraction below 1; 1.5 is used");
            surface.ior = 1.5;
        }
        if ext.unlit {
            notes.warn(&place, "KHR_materials_unlit: its colour reflects light, as paint does");
            (surface.metallic, surface.specular, surface.transmission) = (0.0, 0.0, 0.0);
        }
        let solid =
            ext.volume.thickness_factor > 0.0 && surface.transmission * (1.0 - surface.metallic) > 0.5;
        if solid && surface.transmission * (1.0 - surface.metallic) < 1.0 {
            notes.warn(&place, "glass with a thickness that lets pass only a share; the rest is absorbed");
        }
        let mut maps = self.maps(m, pbr, ext, &place, notes);
        if solid && (maps.roughness.is_some() || maps.transmission.is_some()) {
            notes.warn(&place, "textures of roughness or transmission on solid glass; left out");
            (maps.roughness, maps.transmission) = (None, None);
        }
        if ext.unlit {
            (maps.roughness, maps.normal, maps.transmission) = (None, None, None);
        }
        let name = m.name.as_deref().map_or(place.clone(), |n| clipped(n).to_owned());
        let bsdf = if solid { Bsdf::Dielectric(glass(&surface, &ext.volume)) } else { Bsdf::Pbr(surface) };
        Material {
            emission: (color(m.emissive_factor) * unsigned(ext.strength.emissive_strength))
                .map(|v| v.min(BRIGHTEST)),
            sides: if m.double_sided { Sides::Both } else { Sides::EmitFront },
            coverage: match m.alpha_mode {
                json::AlphaMode::Opaque | json::AlphaMode::Other => Coverage::Full,
                json::AlphaMode::Mask => Coverage::Mask { factor: alpha, cutoff: unsigned(m.alpha_cutoff) },
                json::AlphaMode::Blend => Coverage::Blend { factor: alpha },
            },
            maps,
            ..Material::new(name, bsdf)
        }
    }

    fn maps(
        &mut self,
        m: &json::Material,
        pbr: &json::MetallicRoughness,
        ext: &json::MaterialExtensions,
        place: &str,
        notes: &mut Notes,
    ) -> Maps {
        use Encoding::{Linear, Srgb};
        let mut map = |info, encoding| self.map(info, encoding, place, notes);
        let normal = map(m.normal_texture.as_deref(), Linear);
        let scale = m.normal_texture.as_ref().map_or(1.0, |n| n.scale);
        Maps {
            color: map(pbr.base_color_texture.as_ref(), Srgb),
            roughness: map(pbr.metallic_roughness_texture.as_ref(), Linear),
            normal: normal.map(|n| (n, if scale.is_finite() { scale } else { 1.0 })),
            emission: map(m.emissive_texture.as_deref(), Srgb),
            specular: map(ext.specular.specular_texture.as_ref(), Linear),
            specular_color: map(ext.specular.specular_color_texture.as_ref(), Srgb),
            transmission: map(ext.transmission.transmission_texture.as_ref(), Linear),
            alpha: None,
        }
    }
}

/// The interface of a solid body. The base colour tints each passage of it; inside, light that goes the attenuation
/// distance d keeps the attenuation colour c: σ = −ln c/d.
fn glass(surface: &Pbr, volume: &json::Volume) -> Dielectric {
    let distance = volume.attenuation_distance;
    let attenuation = if distance > 0.0 {
        color(volume.attenuation_color).map(|c| -libm::logf(c.clamp(LEAST, 1.0)) / distance)
    } else {
        Rgb::BLACK
    };
    Dielectric {
        alpha: surface.roughness * surface.roughness,
        attenuation,
        ..Dielectric::new(surface.ior, surface.base_color * (surface.transmission * (1.0 - surface.metallic)))
    }
}

/// Translation · rotation · scale. Angles turn from u towards −v, counter-clockwise where v points down the picture.
fn placed(t: &json::TextureTransform) -> Affine2 {
    let (sin, cos) = libm::sincosf(t.rotation);
    let turn = Mat2::from_cols(Vec2::new(cos, -sin), Vec2::new(sin, cos));
    let whole = Affine2 {
        matrix2: turn * Mat2::from_diagonal(Vec2::from_array(t.scale)),
        translation: Vec2::from_array(t.offset),
    };
    if whole.is_finite() { whole } else { Affine2::IDENTITY }
}

fn share(v: f32) -> f32 {
    if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) }
}

fn unsigned(v: f32) -> f32 {
    if v.is_finite() { v.max(0.0) } else { 0.0 }
}

fn color([r, g, b]: [f32; 3]) -> Rgb {
    Rgb::new(r, g, b).map(unsigned)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(text: &str) -> (Material, Vec<Texture>, Vec<String>) {
        let document: json::Document = serde_json::from_str(text).unwrap();
        let images = [Some(0), None];
        assert_eq!(images_used(&document), [true, true]);
        let (mut textures, mut notes) = (Textures::new(&document, &images), Notes::new("a.gltf".as_ref()));
        let (mut materials, worn) = textures.materials(&[true], &mut notes);
        assert_eq!((materials.len(), worn[0].bumpy), (1, true));
        (materials.remove(0), textures.textures, notes.into_lines())
    }

    #[test]
    fn textures_are_laid_as_the_file_says() {
        let (m, textures, warnings) = made(
            r#"{"images": [{}, {}], "samplers": [{"magFilter": 9728, "wrapS": 33071, "wrapT": 33648}],
            "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
            "materials": [{"normalTexture": {"index": 0, "scale": 0.5}, "emissiveTexture": {"index": 1},
                "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1},
                    "metallicRoughnessTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform":
                        {"offset": [0.5, 0.25], "scale": [2, 4], "rotation": 1.5707964, "texCoord": 0}}}},
                "extensions": {"KHR_materials_specular": {"specularTexture": {"index": 0, "texCoord": 2}}}}]}"#,
        );
        let wrap = [Wrap::Clamp, Wrap::Mirror];
        let nearest = |encoding| Texture { image: 0, encoding, wrap, filter: Filter::Nearest };
        assert_eq!(textures, [nearest(Encoding::Linear), nearest(Encoding::Srgb)], "once for each meaning");
        let plain = |texture, set| Map { texture, set, transform: Affine2::IDENTITY };
        assert_eq!((m.maps.normal, m.maps.color), (Some((plain(0, 0), 0.5)), Some(plain(1, 1))));
        assert_eq!((m.maps.emission, m.maps.specular), (None, None), "no picture; a third set");
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        // u to −v, v to u: a quarter turn counter-clockwise where v points down.
        let map = m.maps.roughness.unwrap();
        let at = |u, v| map.transform.transform_point2(Vec2::new(u, v));
        assert_eq!((map.texture, map.set), (0, 0));
        assert!(at(0.0, 0.0).distance(Vec2::new(0.5, 0.25)) < 1e-6);
        assert!(at(1.0, 0.0).distance(Vec2::new(0.5, -1.75)) < 1e-6);
        assert!(at(0.0, 1.0).distance(Vec2::new(4.5, 0.25)) < 1e-6);
    }
}
