//! Caustics straight from a photon map [Keller96, §4.3; Jarosz05, §2]: what *caustic* and *mirror* cover, by photons of a fixed
//! radius in a balanced tree. Meters hang in the air, where no photon stays: they see none of it.

use super::{Integrator, Pass};
use crate::coarse::Wants;
use crate::color::Rgb;
use crate::eye::Tile;
use crate::settings::Rays;

/// Paths L (S|D)* S D S* E.
pub(super) struct CausticMap;

impl Integrator for CausticMap {
    fn name(&self) -> &'static str {
        "caustic-map"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* S D S* E, by photons of one radius"
    }

    fn is_smooth(&self) -> bool {
        false
    }

    fn wants(&self) -> Wants {
        Wants { caustics: true, ..Wants::default() }
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], _: &mut Rays) {
        let Some(coarse) = pass.coarse else { return };
        let mut found = vec![Rgb::BLACK; out.len()];
        for p in &tile.packets {
            for k in p.lanes() {
                if let Some(x) = p.visible(k) {
                    found.fill(Rgb::BLACK);
                    coarse.add_caustics(&x.surface, x.throughput, &mut found);
                    for (out, found) in out.iter_mut().zip(&found) {
                        out[p.pixels[k] as usize] += *found;
                    }
                }
            }
        }
    }
}
