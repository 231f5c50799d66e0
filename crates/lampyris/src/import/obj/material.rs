//! What MTL says of a surface, as the scene's material.
//!
//! The format comes from a shading formula of 1990 without units: Ke is taken as radiance, Kd and Ks as shares of the
//! light, Ns as the width of a lobe, `illum` as the choice between matt, mirror and glass.

use crate::color::Rgb;
use crate::import::BRIGHTEST;
use crate::material::{Bsdf, Coverage, Dielectric, Diffuse, Material, Pbr, Sides, Ward};

/// What a surface may reflect at most, in each channel.
const MOST: f32 = 0.9999;

/// A picture that a material names.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Source {
    pub(super) file: String,
    pub(super) clamp: bool,
    /// `-bm`, the strength of a bump.
    pub(super) multiplier: f32,
}

impl Source {
    /// Options, then a file name that may have blanks. `None` where no name is left.
    pub(super) fn parse(text: &str) -> Option<Source> {
        let mut source = Source { file: String::new(), clamp: false, multiplier: 1.0 };
        let mut rest = text;
        loop {
            let (option, mut left) = first_word(rest);
            let (least, most) = match option {
                "-o" | "-s" | "-t" => (1, 3),
                "-mm" => (2, 2),
                "-blendu" | "-blendv" | "-bm" | "-boost" | "-cc" | "-clamp" | "-imfchan" | "-texres"
                | "-type" => (1, 1),
                // No option: a name, which may begin like one.
                _ => break,
            };
            for k in 0..most {
                let (word, after) = first_word(left);
                let number = word.parse::<f32>().ok();
                if word.is_empty() || (k >= least && number.is_none()) {
                    break;
                }
                match (option, number) {
                    ("-clamp", _) => source.clamp = word == "on",
                    ("-bm", Some(v)) if v.is_finite() => source.multiplier = v,
                    _ => {}
                }
                left = after;
            }
            rest = left;
        }
        // Exporters of one system write its separator.
        source.file = rest.trim().replace('\\', "/");
        (!source.file.is_empty()).then_some(source)
    }
}

/// The first word of a text, and what follows it.
fn first_word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    text.split_at(text.find(char::is_whitespace).unwrap_or(text.len()))
}

/// A material as its lines say.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    pub(super) kd: Rgb,
    pub(super) ks: Rgb,
    pub(super) ke: Rgb,
    /// Filter on light that passes the whole body.
    pub(super) tf: Rgb,
    /// Exponent of the highlight.
    pub(super) ns: f32,
    /// Index of refraction.
    pub(super) ni: Option<f32>,
    /// Coverage.
    pub(super) d: f32,
    pub(super) illum: u32,
    /// Roughness and metalness, where the file has them.
    pub(super) pr: Option<f32>,
    pub(super) pm: Option<f32>,
    pub(super) map_kd: Option<Source>,
    pub(super) map_ke: Option<Source>,
    pub(super) map_d: Option<Source>,
    pub(super) norm: Option<Source>,
    pub(super) bump: Option<Source>,
}

impl Default for Surface {
    fn default() -> Self {
        Surface {
            kd: Rgb::grey(0.8),
            ks: Rgb::BLACK,
            ke: Rgb::BLACK,
            tf: Rgb::WHITE,
            ns: 0.0,
            ni: None,
            d: 1.0,
            illum: 2,
            pr: None,
            pm: None,
            map_kd: None,
            map_ke: None,
            map_d: None,
            norm: None,
            bump: None,
        }
    }
}

impl Surface {
    /// True if it names any.
    pub(super) fn has_pictures(&self) -> bool {
        [&self.map_kd, &self.map_ke, &self.map_d, &self.norm, &self.bump].iter().any(|map| map.is_some())
    }

    /// The scene's material, without its textures, and what had to be mended.
    pub(super) fn to_material(&self, name: &str) -> (Material, Option<&'static str>) {
        let glass = matches!(self.illum, 4 | 6 | 7 | 9) && self.pr.is_none() && self.pm.is_none();
        let (bsdf, mended) = if glass { (self.glass(), None) } else { self.opaque() };
        let d = self.d.clamp(0.0, 1.0);
        let coverage = if !glass && (d < 1.0 || self.map_d.is_some()) {
            Coverage::Blend { factor: d }
        } else {
            Coverage::Full
        };
        let material = Material::new(name, bsdf);
        (
            Material {
                emission: self.ke.map(|v| v.min(BRIGHTEST)),
                sides: Sides::EmitFront,
                coverage,
                ..material
            },
            mended,
        )
    }

    /// Light that crosses the body passes two interfaces, each of which takes the root of the filter.
    fn glass(&self) -> Bsdf {
        let ior = self.ni.filter(|n| *n >= 1.0).unwrap_or(1.5);
        Bsdf::Dielectric(Dielectric::new(ior, self.tf.map(|v| v.min(1.0).sqrt())))
    }

    fn opaque(&self) -> (Bsdf, Option<&'static str>) {
        let whole = |c: Rgb| c.map(|v| v.min(1.0));
        if self.pr.is_some() || self.pm.is_some() {
            let pbr = Pbr {
                base_color: whole(self.kd),
                metallic: self.pm.unwrap_or(0.0).clamp(0.0, 1.0),
                roughness: self.pr.unwrap_or(1.0).clamp(0.0, 1.0),
                ior: self.ni.filter(|n| *n >= 1.0).unwrap_or(1.5),
                ..Pbr::default()
            };
            return (Bsdf::Pbr(pbr), None);
        }
        // The models 0 and 1 have no highlight, whatever Ks says.
        let ks = if self.illum < 2 { Rgb::BLACK } else { self.ks };
        let most = (self.kd + ks).max_channel();
        let scale = if most > 1.0 { MOST / most } else { 1.0 };
        let mended = (most > 1.0).then_some("Kd and Ks sum to more than 1; scaled down");
        let base = Diffuse::opaque(self.kd * scale);
        if ks.is_black() {
            return (Bsdf::Diffuse(base), mended);
        }
        // A lobe of cosⁿ about the half vector has facet slopes of about √(2/(n + 2)); 3 and 5 are mirrors.
        let alpha = if matches!(self.illum, 3 | 5) { 0.0 } else { (2.0 / (self.ns.max(0.0) + 2.0)).sqrt() };
        let (specular, transmission) = (ks * scale, Rgb::BLACK);
        (Bsdf::Ward(Ward { base, specular, alpha, transmission, transmission_alpha: 0.0 }), mended)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &str) -> Option<String> {
        Source::parse(text).map(|s| s.file)
    }

    #[test]
    fn options_come_before_names_with_blanks() {
        assert_eq!(file("oak floor.png").unwrap(), "oak floor.png");
        assert_eq!(file("-s 2 2 2 -o 0.5 -clamp on  oak floor.png").unwrap(), "oak floor.png");
        assert_eq!(file("-mm 0 1 7.png").unwrap(), "7.png");
        assert_eq!(file("-o 1 2 3 4.png").unwrap(), "4.png");
        assert_eq!(file("tex\\wood.png").unwrap(), "tex/wood.png");
        assert_eq!(file("-odd.png").unwrap(), "-odd.png");
        assert_eq!([file(""), file("-bm"), file("-bm 1")], [None, None, None]);
        let bump = Source::parse("-bm 0.25 -clamp on n.png").unwrap();
        assert_eq!((bump.multiplier, bump.clamp), (0.25, true));
    }

    #[test]
    fn models_choose_between_matt_gloss_mirror_and_glass() {
        let base = Surface { ks: Rgb::grey(0.1), ns: 198.0, ..Surface::default() };
        let bsdf = |illum| Surface { illum, ..base.clone() }.to_material("m").0.bsdf;
        assert!(matches!(bsdf(1), Bsdf::Diffuse(_)));
        assert!(matches!(bsdf(2), Bsdf::Ward(w) if (w.alpha - 0.1).abs() < 1e-6));
        assert!(matches!(bsdf(3), Bsdf::Ward(w) if w.alpha == 0.0));
        assert!(matches!(bsdf(7), Bsdf::Dielectric(d) if d.ior == 1.5));
    }

    #[test]
    fn energy_is_kept() {
        let bright = Surface { kd: Rgb::grey(0.8), ks: Rgb::grey(0.8), illum: 2, ..Surface::default() };
        let (m, mended) = bright.to_material("m");
        let Bsdf::Ward(w) = m.bsdf else { panic!("{m:?}") };
        assert!(mended.is_some() && (w.base.reflectance + w.specular).max_channel() <= 1.0);
    }
}
