//! MGF materials as the scene's: photometric shares in, a BSDF and a radiance out.
//! Shares that sum above one, and colours so saturated that a channel would, are reduced until energy is kept.
//! A complex index of refraction is kept in the file's words only: metals reflect as `rs` says.

use crate::chromaticity::Chromaticity;
use crate::color::Rgb;
use crate::material::{Bsdf, Dielectric, Diffuse, Material, Sides, Ward};
use std::f64::consts::FRAC_1_PI;

/// What a material may scatter at most, in sum and in each channel.
const MOST: f64 = 0.9999;

/// A share of light in a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Share {
    /// ρ, τ or ε, photometric.
    pub(super) amount: f64,
    /// The colour that was current when it was set.
    pub(super) color: Chromaticity,
}

impl Share {
    fn rgb(&self, scale: f64) -> Rgb {
        self.color.rgb(self.amount * scale)
    }

    fn bits(&self) -> [u64; 3] {
        [self.amount, self.color.x, self.color.y].map(f64::to_bits)
    }
}

/// The material context: the entities `sides rd td ed rs ts ir`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Surface {
    pub(super) two_sided: bool,
    pub(super) rd: Share,
    pub(super) td: Share,
    /// Amount in lm/m² from each side.
    pub(super) ed: Share,
    pub(super) rs: Share,
    pub(super) ts: Share,
    /// RMS facet slopes of `rs` and `ts`.
    pub(super) alpha: [f64; 2],
    /// Index of refraction, real and imaginary.
    pub(super) ir: [f64; 2],
}

impl Default for Surface {
    fn default() -> Self {
        let none = Share::default();
        Surface {
            two_sided: true,
            rd: none,
            td: none,
            ed: none,
            rs: none,
            ts: none,
            alpha: [0.0; 2],
            ir: [1.0, 0.0],
        }
    }
}

/// A surface's value as something to look up.
pub(super) type Key = [u64; 20];

impl Surface {
    /// Equal for equal values.
    pub(super) fn key(&self) -> Key {
        let mut key = [0; 20];
        for (slot, share) in key[..15].chunks_exact_mut(3).zip([self.rd, self.td, self.ed, self.rs, self.ts])
        {
            slot.copy_from_slice(&share.bits());
        }
        for (slot, v) in key[15..19].iter_mut().zip(self.alpha.into_iter().chain(self.ir)) {
            *slot = v.to_bits();
        }
        key[19] = self.two_sided.into();
        key
    }

    /// Smooth glass, one side of a solid body: what passes is sharp, nothing is diffuse.
    fn is_solid_dielectric(&self) -> bool {
        let diffuse = self.rd.amount + self.td.amount;
        !self.two_sided && self.ir[0] > 1.1 && self.ir[1] == 0.0 && self.ts.amount > 0.25 && diffuse == 0.0
    }

    /// The scene's material, and what had to be mended.
    pub(super) fn to_material(&self, name: &str) -> (Material, Option<&'static str>) {
        let (bsdf, mended) =
            if self.is_solid_dielectric() { (self.dielectric(), None) } else { self.opaque_or_thin() };
        let sides = match (&bsdf, self.two_sided) {
            (Bsdf::Dielectric(_), _) | (_, true) => Sides::Both,
            (_, false) => Sides::FrontOnly,
        };
        // L = M/π of a Lambertian emitter.
        let emission = self.ed.rgb(FRAC_1_PI);
        (Material { emission, sides, ..Material::new(name, bsdf) }, mended)
    }

    /// `ts` is what a pane of 5 mm lets through at normal incidence, its first reflections excluded; light that
    /// crosses such a pane passes two interfaces, so each takes the root of what the glass itself transmits.
    fn dielectric(&self) -> Bsdf {
        let inside = self.ts.rgb(1.0) + self.rs.rgb(1.0);
        let transmittance = inside.map(|v| v.clamp(0.0, 1.0).sqrt());
        Bsdf::Dielectric(Dielectric::new(self.ir[0] as f32, transmittance))
    }

    fn opaque_or_thin(&self) -> (Bsdf, Option<&'static str>) {
        let shares = [self.rd, self.td, self.rs, self.ts];
        let sum: f64 = shares.iter().map(|s| s.amount).sum();
        let scale = if sum > 1.0 { MOST / sum } else { 1.0 };
        let mut colors = shares.map(|s| s.rgb(scale));
        let total = colors.into_iter().fold(Rgb::BLACK, |a, b| a + b).max_channel() as f64;
        let mut mended =
            (sum > 1.0).then_some("reflectances and transmittances sum to more than 1; scaled down");
        if total > 1.0 {
            // Towards the grey of the same luminance, until the strongest channel keeps its energy.
            let grey = sum * scale;
            let t = ((MOST - grey) / (total - grey)).clamp(0.0, 1.0) as f32;
            for (color, share) in colors.iter_mut().zip(shares) {
                let grey = Rgb::grey((share.amount * scale) as f32);
                *color = grey + (*color - grey) * t;
            }
            // A grey of exactly 1 leaves its channel by a rounding error only.
            if total > 1.0001 {
                mended = mended
                    .or(Some("a colour too saturated for its reflectance; made paler at the same luminance"));
            }
        }
        let [reflectance, transmittance, specular, transmission] = colors;
        let base = Diffuse { reflectance, transmittance };
        let bsdf = if self.rs.amount == 0.0 && self.ts.amount == 0.0 {
            Bsdf::Diffuse(base)
        } else {
            let [alpha, transmission_alpha] = self.alpha.map(|a| a as f32);
            Bsdf::Ward(Ward { base, specular, alpha, transmission, transmission_alpha })
        };
        (bsdf, mended)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn neutral(amount: f64) -> Share {
        Share { amount, color: Chromaticity::default() }
    }

    fn reflected(m: &Material) -> Rgb {
        match &m.bsdf {
            Bsdf::Diffuse(d) => d.reflectance + d.transmittance,
            Bsdf::Ward(w) => w.base.reflectance + w.base.transmittance + w.specular + w.transmission,
            Bsdf::Dielectric(d) => d.transmittance,
            Bsdf::Pbr(_) => panic!("{m:?}"),
        }
    }

    #[test]
    fn sums_above_one_are_scaled_and_told() {
        for (rd, rs, told) in [(0.5, 0.5, false), (0.6, 0.3, false), (0.8, 0.4, true), (1.0, 1.0, true)] {
            let s = Surface { rd: neutral(rd), rs: neutral(rs), ..Surface::default() };
            let (m, mended) = s.to_material("m");
            assert_eq!(mended.is_some(), told, "{rd} + {rs}");
            let want = if told { MOST } else { rd + rs };
            assert!((f64::from(reflected(&m).luminance()) - want).abs() < 1e-6);
            assert!(reflected(&m).max_channel() <= 1.0 + 1e-6);
        }
    }

    #[test]
    fn saturated_colours_keep_their_luminance_and_the_energy() {
        let red = Share { amount: 0.5, color: Chromaticity { x: 0.7, y: 0.3 } };
        let s = Surface { rd: red, rs: neutral(0.2), ..Surface::default() };
        let (m, mended) = s.to_material("m");
        assert!(mended.is_some());
        assert!((reflected(&m).luminance() - 0.7).abs() < 1e-6);
        assert!((reflected(&m).max_channel() - MOST as f32).abs() < 1e-6);
        assert!(reflected(&m).r > reflected(&m).g);
    }

    #[test]
    fn emittance_becomes_radiance_per_side() {
        let s = Surface { ed: neutral(87_712.0), two_sided: false, ..Surface::default() };
        let (m, _) = s.to_material("bulb");
        assert!((m.emission.luminance() - 27_919.6).abs() < 0.5, "{}", m.emission.luminance());
        assert_eq!(m.sides, Sides::FrontOnly);
    }

    #[test]
    fn glass_is_solid_with_one_side_and_thin_with_two() {
        let solid = Surface {
            ts: neutral(0.85),
            rs: neutral(0.08),
            ir: [1.52, 0.0],
            two_sided: false,
            ..Surface::default()
        };
        let (m, _) = solid.to_material("glass");
        assert_eq!(m.sides, Sides::Both);
        let Bsdf::Dielectric(d) = m.bsdf else { panic!("{:?}", m.bsdf) };
        assert!((d.transmittance.luminance() - 0.93f32.sqrt()).abs() < 1e-6);
        let thin = Surface { two_sided: true, ..solid.clone() };
        assert!(matches!(thin.to_material("").0.bsdf, Bsdf::Ward(w) if w.transmission_alpha == 0.0));
        let metal = Surface { ir: [1.52, 3.0], ..solid };
        assert!(matches!(metal.to_material("").0.bsdf, Bsdf::Ward(_)));
    }

    #[test]
    fn keys_tell_every_field_apart() {
        let base = Surface::default();
        let mut keys = vec![base.key()];
        let edits: [fn(&mut Surface); 12] = [
            |s| s.two_sided = false,
            |s| s.rd.amount = 0.1,
            |s| s.td.amount = 0.1,
            |s| s.ed.amount = 0.1,
            |s| s.rs.amount = 0.1,
            |s| s.ts.amount = 0.1,
            |s| s.ts.color.x = 0.1,
            |s| s.ts.color.y = 0.1,
            |s| s.alpha[0] = 0.1,
            |s| s.alpha[1] = 0.1,
            |s| s.ir[0] = 2.0,
            |s| s.ir[1] = 2.0,
        ];
        for edit in edits {
            let mut s = base.clone();
            edit(&mut s);
            assert!(!keys.contains(&s.key()));
            keys.push(s.key());
        }
    }
}
