//! What a limit on the length of paths takes from `vpl`: the light of virtual lights too many bounces away. Added to `vpl` it
//! is what `vpl` is without a limit.

use super::{Integrator, Pass, gather};
use crate::color::Rgb;
use crate::eye::Tile;
use crate::particle::CUT_OFF;
use crate::settings::Rays;

/// The longer ones of the paths of *vpl*.
pub(super) struct CutOff;

impl Integrator for CutOff {
    fn name(&self) -> &'static str {
        CUT_OFF
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* D D S* E, min(G, b), of more segments than the limit"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        gather::tile_of_vpls(pass, tile, |lights| lights.beyond, out, &mut rays.shadow);
    }
}
