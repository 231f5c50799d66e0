//! A photon's way over sharp lobes, one vertex after another.
//!
//! It stays at each dull surface after a sharp one, and goes on by that surface's sharp lobes alone: light that is
//! reflected dully there is the walk's, whose vertices send photons of their own.

use super::Photon;
use super::aim::Shot;
use crate::geometry::Ray;
use crate::material::{Class, Scatter};
use crate::sequence::ledger::photon as ledger;
use crate::sequence::sobol;
use crate::world::{Surface, World};

/// Sharp vertices after which a photon goes on by roulette however bright it is.
const CERTAIN_VERTICES: u32 = 6;

/// The surest roulette from then on: of photons that lose nothing on their way one in 10⁸ lives to be cut off.
const SUREST: f32 = 0.98;

/// Sharp vertices after which a photon ends.
const MAX_VERTICES: u32 = 1024;

/// The random numbers of one photon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers {
    pub(super) index: u32,
    pub(super) seed: u32,
}

impl Numbers {
    pub(super) fn one(self, dimension: u32) -> f32 {
        sobol::sobol_owen(self.index, dimension, self.seed)
    }

    /// The group of dimensions that `dimension` begins.
    pub(super) fn four(self, dimension: u32) -> [f32; 4] {
        sobol::sobol_owen_four(self.index, dimension, self.seed)
    }
}

/// Follows a shot from the surface `start`, if that matters to its light, and adds what stays; counts the rays. Roulette
/// tends to leave photons with `ordinary` [lm]. The light is an emitter's; what comes over a single planar mirror stays only
/// where `mirrored`.
pub(super) fn follow<'w>(
    world: &'w World,
    shot: &Shot,
    start: Option<&Surface<'w>>,
    ordinary: f32,
    numbers: Numbers,
    (emitter, mirrored): (u32, bool),
    photons: &mut Vec<Photon>,
) -> u64 {
    let mut ray = shot.ray;
    let mut flux = shot.flux;
    let mut last = None;
    let mut folded = false;
    for vertex in 0..MAX_VERTICES {
        let Some(y) = world.closest(&ray) else { return u64::from(vertex) + 1 };
        flux *= y.clear_from(ray.origin, last.as_ref().or(start));
        if vertex == 0 && world.bodies().of(&y) != Some(shot.body) {
            return 1;
        }
        if vertex > 0
            && !folded
            && !y.finish.dull.is_black()
            && let Some(arrived) = y.flux_density()
        {
            let flux = flux * arrived;
            photons.push(Photon { position: y.position, flux, wi: y.wo, normal: y.normal, emitter });
        }
        if y.finish.weights().0 <= 0.0 {
            return u64::from(vertex) + 1;
        }
        let [u, v, lobe, survive] = numbers.four(ledger::vertex(vertex));
        let Some(s) = y.scatter_flux(Class::Sharp, [u, v], lobe) else { return u64::from(vertex) + 1 };
        folded = vertex == 0 && !mirrored && over_mirror(&y, &s);
        flux *= s.weight;
        let most = if vertex < CERTAIN_VERTICES { 1.0 } else { SUREST };
        let stay = (flux.max_channel() / ordinary).clamp(0.0, most);
        if survive >= stay {
            return u64::from(vertex) + 1;
        }
        flux *= 1.0 / stay;
        ray = Ray::new(y.spawn(s.wi), s.wi);
        last = Some(y);
    }
    u64::from(MAX_VERTICES)
}

/// Whether a planar mirror reflected the light: what follows at once is the part *mirror*.
fn over_mirror(y: &Surface<'_>, s: &Scatter) -> bool {
    y.mirror.is_some() && s.pdf.is_infinite() && y.normal.dot(s.wi) > 0.0
}
