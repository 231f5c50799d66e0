//! Light that reaches the first dull vertex over a sharp one, L (S|D)* S D S* E, unless that is a single planar mirror
//! (the part *mirror*): by the oracle restricted to these paths. Beside photons it is unbiased in every batch, and far
//! noisier; caustics of point, spot and directional lights cannot be found this way and are missing.

use super::path::{History, Scope, Start, trace};
use super::{Costly, Integrator, Pass};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::settings::Rays;
use crate::world::Surface;

/// Paths L (S|D)* S D S* E, less *mirror*'s.
pub(super) struct CausticPath;

impl Integrator for CausticPath {
    fn name(&self) -> &'static str {
        "caustic-path"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* S D S* E, less mirror, and less L_point S+ D S* E"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        self::tile(pass, tile, out, rays);
    }
}

/// What every point of a tile receives.
pub(super) fn tile<'w>(pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
    if !pass.world.bodies().make_caustics() {
        return;
    }
    let costly = Costly { purpose: b's', phase: 2, stake: tile.stake };
    costly.add(pass, tile.packets.iter(), out, |x, numbers, found| {
        at(pass, x, numbers, found, &mut rays.path);
    });
}

/// Adds the radiance that the dull lobes of `x` send on of light that comes over a sharp vertex, by
/// paths that are not *mirror*'s, group by group.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, out: &mut [Rgb], rays: &mut u64) {
    if !pass.world.bodies().make_caustics() {
        return;
    }
    let mut traced = Rays::default();
    trace(
        pass.world,
        Start::Surface(*x),
        Scope::Caustics,
        numbers,
        &mut traced,
        |emitter, history, light| {
            if let (History::Caustic, Some((place, tint))) = (history, pass.place_of(emitter)) {
                out[place] += light * tint;
            }
        },
    );
    *rays += traced.path;
}
