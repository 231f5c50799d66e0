//! What glows directly before the eye, or is seen glowing through mirrors, glass and polish: paths without a dull
//! vertex, L S* E. The eye pass has found it already; this integrator hands it on.

use super::{Integrator, Pass};
use crate::color::Rgb;
use crate::eye::Tile;
use crate::settings::Rays;

/// Paths L S* E.
pub(super) struct Emission;

impl Integrator for Emission {
    fn name(&self) -> &'static str {
        "emission"
    }

    fn paths(&self) -> &'static str {
        "L S* E"
    }

    fn is_smooth(&self) -> bool {
        false
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], _rays: &mut Rays) {
        for packet in &tile.packets {
            for gleam in &packet.gleams {
                if let Some((place, tint)) = pass.place_of(gleam.emitter) {
                    out[place][packet.pixels[gleam.lane] as usize] += gleam.radiance * tint;
                }
            }
        }
    }
}
