//! glTF's metallic-roughness surface [Khronos 2021, appendix B]: a metal, a plastic and a thin pane in one, mixed by
//! factors; GGX facets over a diffuse base, and the same lobe mirrored through the pane, which refracts nothing.
//!
//! Metal and plastic have Schlick's Fresnel term, the pane has Fresnel's own with all reflections between its faces.
//! The base gets what the facets of the plastic leave, (1 − E(cos θ_o)) (1 − E(cos θ_i)) / (1 − Ē) with their albedo E
//! and its mean [Kelemen and Szirmay-Kalos 2001]: reciprocal, and a white plastic loses nothing. `energy` mends metal
//! and pane. Everything is symmetric in `wo` and `wi`.

use super::dielectric::fresnel_polarised;
use super::energy::Energy;
use super::ggx::Ggx;
use super::{Class, Scatter, same_side};
use crate::color::Rgb;
use crate::sampling::cosine_hemisphere;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::f32::consts::FRAC_1_PI;

/// The factors of the model, each of which a texture may multiply.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pbr {
    /// Diffuse reflectance of the plastic, reflectance at normal incidence of the metal, tint of the pane.
    pub base_color: Rgb,
    /// 0 plastic or pane, 1 metal.
    pub metallic: f32,
    /// Perceptual roughness: its square is GGX's α.
    pub roughness: f32,
    /// Index of refraction of plastic and pane.
    pub ior: f32,
    /// Strength of their reflection: at 0 the plastic is purely diffuse.
    pub specular: f32,
    /// Colour of their reflection at normal incidence.
    pub specular_color: Rgb,
    /// 0 plastic, 1 a thin pane that refracts nothing.
    pub transmission: f32,
}

impl Default for Pbr {
    /// glTF's defaults.
    fn default() -> Pbr {
        Pbr {
            base_color: Rgb::WHITE,
            metallic: 1.0,
            roughness: 1.0,
            ior: 1.5,
            specular: 1.0,
            specular_color: Rgb::WHITE,
            transmission: 0.0,
        }
    }
}

impl Pbr {
    /// f_r [sr⁻¹] of the lobes of `class`; mirrors evaluate to black.
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        let base = if class == Class::Dull { self.paint(wo, wi) } else { Rgb::BLACK };
        let ggx = self.ggx();
        if ggx.class() != class || ggx.is_delta() {
            return base;
        }
        let reflected = same_side(wo, wi);
        if !(if reflected { self.reflects() } else { self.passes() }) {
            return base;
        }
        let (wo, wi) = (up(wo), up(wi));
        let (lobe, _) = ggx.reflection(wo, wi);
        let energy = Energy::new(ggx.alpha);
        let boost = 1.0 / (energy.damping(wo.z) * energy.damping(wi.z));
        let facet = 0.5 * (wo + wi).length();
        let value = if reflected { self.mirrored(facet, boost) } else { self.transmitted(facet, boost) };
        base + value * lobe
    }

    /// Draws from the lobes of `class`, each picked by its albedo toward `wo`; `None` also where a facet sends the
    /// light below the surface. A delta lobe yields its value over the probability of its pick, any other the whole
    /// class.
    pub fn sample(&self, class: Class, wo: Vec3, u: [f32; 2], choice: f32) -> Option<Scatter> {
        let [mirror, pass, base] = self.picks(class, wo);
        let total = mirror + pass + base;
        if total <= 0.0 {
            return None;
        }
        let pick = choice * total;
        let above = up(wo);
        let ggx = self.ggx();
        // Sums rounded in another order may leave a rest where the class has no such lobe.
        let painted = base > 0.0 && pick >= mirror + pass;
        let reflected = painted || (mirror > 0.0 && (pick < mirror || pass <= 0.0));
        let side = if reflected == (wo.z >= 0.0) { 1.0 } else { -1.0 };
        let wi = if painted {
            cosine_hemisphere(u)
        } else if ggx.is_delta() {
            let (value, p) = if reflected {
                (self.mirrored(above.z, 1.0), mirror)
            } else {
                (self.transmitted(above.z, 1.0), pass)
            };
            let wi = Vec3::new(-wo.x, -wo.y, side * above.z);
            return Some(Scatter { wi, weight: value * (total / p), pdf: f32::INFINITY });
        } else {
            ggx.reflect(above, u)?
        };
        let wi = Vec3::new(wi.x, wi.y, side * wi.z);
        let pdf = self.pdf(class, wo, wi);
        (pdf > 0.0).then(|| Scatter { wi, weight: self.eval(class, wo, wi) * (wi.z.abs() / pdf), pdf })
    }

    /// Density of `sample` [sr⁻¹]; it integrates to less than 1 where delta lobes take a share or samples are lost.
    pub fn pdf(&self, class: Class, wo: Vec3, wi: Vec3) -> f32 {
        let [mirror, pass, base] = self.picks(class, wo);
        let total = mirror + pass + base;
        if total <= 0.0 {
            return 0.0;
        }
        let reflected = same_side(wo, wi);
        let (wo, wi) = (up(wo), up(wi));
        let gloss = if reflected { mirror } else { pass };
        let ggx = self.ggx();
        let lobe = if gloss > 0.0 && !ggx.is_delta() { gloss * ggx.reflection(wo, wi).1 } else { 0.0 };
        let base = if reflected { base * wi.z * FRAC_1_PI } else { 0.0 };
        (lobe + base) / total
    }

    /// The chance of `sample` to pick reflection among the sharp lobes.
    pub fn reflected_sharply(&self, wo: Vec3) -> f32 {
        let [mirror, pass, _] = self.picks(Class::Sharp, wo);
        if pass > 0.0 { mirror / (mirror + pass) } else { 1.0 }
    }

    /// Directional albedo of the lobes of `class`.
    pub fn albedo(&self, class: Class, wo: Vec3) -> Rgb {
        self.albedos(class, wo).into_iter().fold(Rgb::BLACK, |sum, a| sum + a)
    }

    /// What the delta lobe reflects under an angle of this cosine; black where facets are rough.
    pub fn mirror_reflectance(&self, cosine: f32) -> Rgb {
        if self.ggx().is_delta() && self.reflects() { self.mirrored(cosine, 1.0) } else { Rgb::BLACK }
    }

    /// True if nothing is sharp but a delta lobe in reflection.
    pub fn only_mirrors(&self) -> bool {
        self.ggx().class() == Class::Dull || (self.ggx().is_delta() && !self.passes())
    }

    /// The base's reflectance where no lobe of the dull class and no gloss accompanies it.
    pub fn lambertian(&self) -> Option<Rgb> {
        let base = self.base_color * self.shares().plastic;
        let gloss = self.ggx().class() == Class::Dull && (self.reflects() || self.passes());
        (!gloss && (base.is_black() || self.specular <= 0.0)).then_some(base)
    }

    /// True if the pane is rough enough for its lobe to be dull.
    pub fn transmits(&self) -> bool {
        self.ggx().class() == Class::Dull && self.passes()
    }

    fn ggx(&self) -> Ggx {
        let roughness = self.roughness.clamp(0.0, 1.0);
        Ggx { alpha: roughness * roughness }
    }

    fn shares(&self) -> Shares {
        let (metal, clear) = (self.metallic.clamp(0.0, 1.0), self.transmission.clamp(0.0, 1.0));
        Shares { metal, plastic: (1.0 - metal) * (1.0 - clear), pane: (1.0 - metal) * clear }
    }

    /// Whether facets reflect at all: a metal does, however black, close to the horizon.
    fn reflects(&self) -> bool {
        self.metallic > 0.0 || self.specular > 0.0
    }

    fn passes(&self) -> bool {
        self.shares().pane > 0.0 && !self.base_color.is_black()
    }

    /// Reflectance of plastic and pane at normal incidence, one interface.
    fn normal_reflectance(&self) -> Rgb {
        let r = (self.ior - 1.0) / (self.ior + 1.0);
        self.specular_color.map(|c| (r * r * c).min(1.0)) * self.specular
    }

    /// f_r of the base.
    fn paint(&self, wo: Vec3, wi: Vec3) -> Rgb {
        let color = self.base_color * self.shares().plastic;
        if color.is_black() || !same_side(wo, wi) {
            return Rgb::BLACK;
        }
        if self.specular <= 0.0 {
            return color * FRAC_1_PI;
        }
        let energy = Energy::new(self.ggx().alpha);
        let (single, grazing) = energy.means();
        let left = |cos| self.left(energy.single(cos), energy.grazing(cos));
        let mean = self.left(single, grazing).max(f32::MIN_POSITIVE);
        color * (left(wo.z.abs()) * left(wi.z.abs()) / mean * FRAC_1_PI)
    }

    /// 1 − E: what the plastic's facets leave to the base, in the channel that they leave least. A share for all
    /// channels, or red gloss would make a white base look green.
    fn left(&self, single: f32, grazing: f32) -> f32 {
        let taken = self.normal_reflectance() * (single - grazing) + Rgb::grey(self.specular * grazing);
        (1.0 - taken.max_channel()).clamp(0.0, 1.0)
    }

    /// What a facet reflects at the cosine `facet`; `boost` is what it is worth with light from other facets. Where the
    /// metal is dark so is that light, and the plastic gives it to its base.
    fn mirrored(&self, facet: f32, boost: f32) -> Rgb {
        let Shares { metal, plastic, pane } = self.shares();
        let s = schlick(facet);
        let mut sum = Rgb::BLACK;
        if metal > 0.0 {
            sum += self.base_color.map(|f0| (f0 + (1.0 - f0) * s) * (1.0 + f0 * (boost - 1.0))) * metal;
        }
        if plastic > 0.0 {
            sum += (self.normal_reflectance() * (1.0 - s) + Rgb::grey(self.specular * s)) * plastic;
        }
        if pane > 0.0 {
            sum += self.pane(facet) * (pane * boost);
        }
        sum
    }

    /// What a facet of the pane lets pass.
    fn transmitted(&self, facet: f32, boost: f32) -> Rgb {
        self.base_color * (Rgb::WHITE - self.pane(facet)) * (self.shares().pane * boost)
    }

    /// R' = 2R/(1 + R) of a clear sheet, all reflections between its two faces summed; 1 − R' = (1 − R)/(1 + R) passes.
    /// The polarisations are summed apart and averaged, for within the sheet they stay apart.
    fn pane(&self, cos: f32) -> Rgb {
        let both = if self.ior > 0.0 { fresnel_polarised(cos, 1.0 / self.ior).0 } else { [1.0; 2] };
        let s = schlick(cos);
        let sheet = |f: f32, tint: f32| {
            let r = (self.specular * f * (tint + (1.0 - tint) * s)).clamp(0.0, 1.0);
            2.0 * r / (1.0 + r)
        };
        self.specular_color.map(|tint| 0.5 * (sheet(both[0], tint) + sheet(both[1], tint)))
    }

    fn picks(&self, class: Class, wo: Vec3) -> [f32; 3] {
        self.albedos(class, wo).map(|a| a.max_channel().max(0.0))
    }

    /// Albedos of the lobes of `class`: reflected, transmitted, the base.
    fn albedos(&self, class: Class, wo: Vec3) -> [Rgb; 3] {
        /// Even gloss that reflects only close to the horizon must be found.
        const LEAST: f32 = 1e-3;
        let (cos, ggx) = (wo.z.abs().min(1.0), self.ggx());
        let Shares { metal, plastic, pane } = self.shares();
        let mut all = [Rgb::BLACK; 3];
        if ggx.class() == class && (self.reflects() || self.passes()) {
            let energy = Energy::new(ggx.alpha);
            let (single, grazing) =
                if ggx.is_delta() { (1.0, schlick(cos)) } else { (energy.single(cos), energy.grazing(cos)) };
            // Schlick's term in the mean, and the facet that has it.
            let s = grazing / single;
            let facet = if ggx.is_delta() { cos } else { 1.0 - libm::powf(s.max(0.0), 0.2) };
            if self.reflects() {
                let of_metal =
                    |f0: f32| (1.0 - f0) * (f0 * (single - grazing) + grazing) + f0 * (f0 + (1.0 - f0) * s);
                let of_plastic =
                    self.normal_reflectance() * (single - grazing) + Rgb::grey(self.specular * grazing);
                let mut sum = self.base_color.map(of_metal) * metal + of_plastic * plastic;
                if pane > 0.0 {
                    sum += self.pane(facet) * pane;
                }
                all[0] = sum.map(|v| v.max(LEAST));
            }
            if self.passes() {
                all[1] = self.transmitted(facet, 1.0);
            }
        }
        if class == Class::Dull && plastic > 0.0 {
            let energy = Energy::new(ggx.alpha);
            all[2] = self.base_color * (plastic * self.left(energy.single(cos), energy.grazing(cos)));
        }
        all
    }
}

/// How much of a surface is which; together 1.
struct Shares {
    metal: f32,
    plastic: f32,
    pane: f32,
}

/// (1 − cos)⁵.
fn schlick(cos: f32) -> f32 {
    let gap = (1.0 - cos).clamp(0.0, 1.0);
    let square = gap * gap;
    square * square * gap
}

/// The direction mirrored to the upper side.
fn up(w: Vec3) -> Vec3 {
    Vec3::new(w.x, w.y, w.z.abs())
}
