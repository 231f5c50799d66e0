//! Instant radiosity: light reflected by a dull vertex just before x, by virtual point lights, their geometry term
//! clamped [Keller97, §3]. What the clamp takes is the part *compensation*.

use super::{Integrator, Pass, gather};
use crate::color::Rgb;
use crate::eye::Tile;
use crate::settings::Rays;

/// Paths L (S|D)* D D S* E, up to the clamp.
pub(super) struct VirtualLights;

impl Integrator for VirtualLights {
    fn name(&self) -> &'static str {
        "vpl"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* D D S* E, min(G, b)"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        gather::tile_of_vpls(pass, tile, |lights| (lights.vpls, lights.beacons), out, &mut rays.shadow);
    }
}
