//! What a surface does with a path: composition and inversion, or directions that know nothing of it and weights that do
//! [Keller96, §4.1, eqs. 4.5–4.7].
//!
//! Composition is done with one number: the part of the unit interval that it falls into says whether the light is
//! absorbed (by roulette), or which class of lobes scatters it; stretched to the unit interval again, it is the first
//! coordinate of the direction. So a bounce takes two dimensions, as in the paper. A third chooses among several lobes of
//! one class, where there are such.

use super::Inversion;
use crate::color::Rgb;
use crate::geometry::Frame;
use crate::material::{Bsdf, Class, DELTA_ALPHA};
use crate::sampling::cosine_hemisphere;
use crate::sequence::Generator;
use crate::sequence::ledger::scatter as ledger;
use crate::world::Surface;
use glam::Vec3;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// Bounces after which a path ends by roulette however white surfaces are.
const CERTAIN_BOUNCES: u32 = 8;

/// The surest roulette from then on.
const SUREST: f32 = 0.98;

/// The numbers of one path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Die {
    pub(super) generator: Generator,
    pub(super) index: u32,
    pub(super) seed: u32,
}

/// Where a path goes on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounce {
    pub(super) direction: Vec3,
    /// Factor on the flux.
    pub(super) weight: Rgb,
    /// Whether a dull lobe scattered it.
    pub(super) dull: bool,
}

impl Die {
    pub(super) fn number(&self, dimension: u32) -> f64 {
        self.generator.point(self.index, dimension, self.seed)
    }
}

/// A number in [0, 1) as the maps of directions take it.
pub(super) fn unit(x: f64) -> f32 {
    (x as f32).clamp(0.0, 1.0_f32.next_down())
}

/// Bounce number `bounce`, from 1 on; `None` where the light is absorbed.
pub(super) fn scatter(
    y: &Surface<'_>,
    inversion: Inversion,
    roulette: bool,
    die: &Die,
    bounce: u32,
) -> Option<Bounce> {
    let (sharp, dull) = y.finish.weights();
    if sharp + dull <= 0.0 {
        return None;
    }
    let stay = match roulette {
        false => 1.0,
        true if bounce <= CERTAIN_BOUNCES => (sharp + dull).min(1.0),
        true => (sharp + dull).min(SUREST),
    };
    let at = ledger::direction(bounce);
    let (u, v) = (die.number(at) / f64::from(stay), unit(die.number(at + 1)));
    if u >= 1.0 {
        return None;
    }
    if inversion != Inversion::Bsdf && may_be_weighed(&y.finish.bsdf) {
        let (direction, pdf) = blind(y, inversion, [unit(u), v]);
        return weigh(y, direction, pdf).map(|weight| Bounce {
            direction,
            weight: weight * (1.0 / stay),
            dull: dull > 0.0,
        });
    }
    let share = f64::from(dull) / f64::from(sharp + dull);
    let (class, probability, u) = if u < share {
        (Class::Dull, share, u / share)
    } else {
        (Class::Sharp, 1.0 - share, (u - share) / (1.0 - share))
    };
    let lobe = if chooses_lobes(y, class) { unit(die.number(ledger::lobe(bounce))) } else { 0.0 };
    let drawn = y.scatter_flux(class, [unit(u), v], lobe)?;
    let weight = drawn.weight * (1.0 / (probability * f64::from(stay))) as f32;
    Some(Bounce { direction: drawn.wi, weight, dull: class == Class::Dull })
}

/// Whether a number chooses among lobes of the class: of Lambert's reflection alone there is but one.
fn chooses_lobes(y: &Surface<'_>, class: Class) -> bool {
    class == Class::Sharp || y.finish.lambertian.is_none()
}

/// Whether no lobe is a delta, which directions that know nothing of it never find. Bodies of glass and materials of facets
/// are inverted always.
fn may_be_weighed(bsdf: &Bsdf) -> bool {
    let soft = |value: Rgb, alpha: f32| value.is_black() || alpha >= DELTA_ALPHA;
    match bsdf {
        Bsdf::Diffuse(_) => true,
        Bsdf::Ward(m) => soft(m.specular, m.alpha) && soft(m.transmission, m.transmission_alpha),
        Bsdf::Dielectric(_) | Bsdf::Pbr(_) => false,
    }
}

/// A direction on the side of arrival, or on either where light passes, and its density [sr⁻¹].
fn blind(y: &Surface<'_>, inversion: Inversion, [u, v]: [f32; 2]) -> (Vec3, f32) {
    let both = transmits(&y.finish.bsdf);
    let (side, u) = match both {
        false => (1.0, u),
        true if u < 0.5 => (1.0, 2.0 * u),
        true => (-1.0, 2.0 * u - 1.0),
    };
    let (local, pdf) = match inversion {
        Inversion::Nothing => {
            let (sin, cos) = libm::sincosf(FRAC_PI_2 * u);
            let (s, c) = libm::sincosf(TAU * v);
            (Vec3::new(sin * c, sin * s, cos), 1.0 / (FRAC_PI_2 * TAU * sin))
        }
        Inversion::Cosine | Inversion::Bsdf => {
            let up = cosine_hemisphere([u, v]);
            (up, up.z / PI)
        }
    };
    let direction = Frame::new(y.normal * side).to_world(local);
    (direction, if both { 0.5 * pdf } else { pdf })
}

fn transmits(bsdf: &Bsdf) -> bool {
    match bsdf {
        Bsdf::Diffuse(m) => !m.transmittance.is_black(),
        Bsdf::Ward(m) => !m.base.transmittance.is_black() || !m.transmission.is_black(),
        Bsdf::Dielectric(_) | Bsdf::Pbr(_) => false,
    }
}

/// f_r cos θ / pdf of all lobes for flux from `wo` that goes on in `direction`, bent normals included; `None` where nothing does.
fn weigh(y: &Surface<'_>, direction: Vec3, pdf: f32) -> Option<Rgb> {
    let arrived = y.flux_density()?;
    // Of light that goes on to `direction` the BSDF sees the geometric cosine there, and of what arrives the bent one.
    let cos = y.normal.dot(direction).abs();
    let f = [Class::Dull, Class::Sharp].map(|class| y.eval(class, direction, y.wo));
    let weight = (f[0] + f[1]) * (arrived * cos / pdf);
    (pdf > 0.0 && !weight.is_black()).then_some(weight)
}
