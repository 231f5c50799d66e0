//! Light that reaches the first dull vertex over a sharp one: L (S|D)* S D S* E, by the oracle restricted to these
//! paths. Caustics of point, spot and directional lights cannot be found this way and are missing.

use super::path::{Scope, Start, trace};
use super::{Integrator, Pass, STRIDE, turn_of};
use crate::color::Rgb;
use crate::eye::Tile;
use crate::settings::Rays;

/// Paths L (S|D)* S D S* E.
pub(super) struct Caustic;

impl Integrator for Caustic {
    fn name(&self) -> &'static str {
        "caustic"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* S D S* E, less those of point, spot and directional lights before S+ x"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Rgb], rays: &mut Rays) {
        if !pass.world.has_sharp_surfaces() {
            return;
        }
        for packet in &tile.packets {
            for k in packet.lanes() {
                let numbers = packet.numbers[k];
                if let Some(x) = packet.visible(k).filter(|_| turn_of(pass, numbers.seed >> 16)) {
                    let start = Start::Surface(x.surface);
                    let found = trace(pass.world, start, Scope::Caustics, numbers.branch(b's'.into()), rays);
                    out[packet.pixels[k] as usize] += x.throughput * found.caustic * STRIDE as f32;
                }
            }
        }
    }
}
