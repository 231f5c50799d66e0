//! Whether the numbers of a material make sense: what importers see to, asked of materials that come from elsewhere.

use super::{Bsdf, Coverage, Diffuse, Map, Material};
use crate::color::{BRIGHTEST, Rgb};

/// Rounding that sums of shares are granted.
const ROUNDING: f32 = 1e-4;

impl Material {
    /// True if every number is finite and lies where its field says, and no surface sends back more light than it
    /// receives.
    pub fn is_sound(&self) -> bool {
        let maps = &self.maps;
        let normal = maps.normal.as_ref().map(|(map, _)| map);
        let all = [&maps.color, &maps.roughness, &maps.emission, &maps.specular, &maps.specular_color];
        let rest = [&maps.transmission, &maps.alpha];
        let laid = |m: &Map| m.transform.is_finite();
        glows_soundly(self.emission)
            && self.bsdf.is_sound()
            && match self.coverage {
                Coverage::Full => true,
                Coverage::Mask { factor, cutoff } => share(factor) && share(cutoff),
                Coverage::Blend { factor } => share(factor),
            }
            && all.into_iter().chain(rest).flatten().chain(normal).all(laid)
            && maps.normal.as_ref().is_none_or(|(_, strength)| strength.is_finite())
    }
}

/// True if a surface may emit this radiance [cd/m²].
pub fn glows_soundly(emission: Rgb) -> bool {
    emission.is_finite() && emission.map(f32::abs).max_channel() <= BRIGHTEST
}

impl Bsdf {
    fn is_sound(&self) -> bool {
        let rough = |alpha: f32| alpha >= 0.0 && alpha.is_finite();
        let tints = |c: Rgb| shares([c]);
        match *self {
            Bsdf::Diffuse(Diffuse { reflectance, transmittance }) => shares([reflectance, transmittance]),
            Bsdf::Ward(m) => {
                shares([m.base.reflectance, m.base.transmittance, m.specular, m.transmission])
                    && rough(m.alpha)
                    && rough(m.transmission_alpha)
            }
            Bsdf::Dielectric(m) => {
                let clear = m.attenuation.is_finite() && m.attenuation.to_array().iter().all(|s| *s >= 0.0);
                m.ior > 0.0 && m.ior.is_finite() && tints(m.transmittance) && rough(m.alpha) && clear
            }
            Bsdf::Pbr(m) => {
                let strong = m.specular_color.to_array().iter().all(|s| *s >= 0.0 && s.is_finite());
                let ior = m.ior >= 1.0 && m.ior.is_finite();
                let mixed = [m.metallic, m.roughness, m.specular, m.transmission].into_iter().all(share);
                tints(m.base_color) && ior && mixed && strong
            }
        }
    }
}

fn share(v: f32) -> bool {
    (0.0..=1.0).contains(&v)
}

/// Finite colours that sum to 1 at most; a saturated one may have a negative channel.
fn shares<const N: usize>(colors: [Rgb; N]) -> bool {
    let sum = colors.into_iter().fold(Rgb::BLACK, |a, b| a + b);
    colors.iter().all(|c| c.is_finite()) && sum.max_channel() <= 1.0 + ROUNDING
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Dielectric, Pbr};

    #[test]
    fn impossible_numbers_are_told() {
        let with = |bsdf| Material::new("", bsdf);
        let diffuse = |r: f32, t: f32| {
            with(Bsdf::Diffuse(Diffuse { reflectance: Rgb::grey(r), transmittance: Rgb::grey(t) }))
        };
        let glass = |ior| with(Bsdf::Dielectric(Dielectric::new(ior, Rgb::WHITE)));
        let pbr = |metallic| with(Bsdf::Pbr(Pbr { metallic, ..Pbr::default() }));
        let glow = |e| Material { emission: Rgb::grey(e), ..diffuse(0.5, 0.0) };
        let holes = |factor| Material { coverage: Coverage::Blend { factor }, ..diffuse(0.5, 0.0) };
        for sound in [diffuse(0.5, 0.5), diffuse(1.0, 0.0), glass(1.5), pbr(0.3), glow(1e6), holes(0.5)] {
            assert!(sound.is_sound(), "{sound:?}");
        }
        let nan = f32::NAN;
        let broken = [diffuse(0.8, 0.3), diffuse(nan, 0.0), glass(0.0), glass(nan), pbr(1.1), pbr(nan)];
        for broken in broken.into_iter().chain([glow(nan), glow(1e19), holes(-0.1), holes(nan)]) {
            assert!(!broken.is_sound(), "{broken:?}");
        }
    }
}
