//! Direct light with fewer shadow rays: where shadow photons say that a lamp is seen whole, or not at all, no ray is traced
//! [Jarosz05, §2.2.1]. The light is that of *direct*, by the same light points; only who is sure asks for no ray.

use super::gather::{self, PARTS, Sight};
use super::{Integrator, Pass, direct};
use crate::coarse::{Coarse, Wants};
use crate::color::Rgb;
use crate::eye::{Packet, Tile};
use crate::geometry::{lane, lanes};
use crate::map::Seen;
use crate::particle::Vpl;
use crate::settings::Rays;

/// Paths L D S* E.
pub(super) struct DirectMap;

impl Integrator for DirectMap {
    fn name(&self) -> &'static str {
        "direct-map"
    }

    fn paths(&self) -> &'static str {
        "L D S* E, by shadow photons where they are sure"
    }

    fn wants(&self) -> Wants {
        Wants { shadows: true, ..Wants::default() }
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        let Some(coarse) = pass.coarse else { return };
        gather::tile_of_points(pass, tile, ByPhotons::new(coarse), out, &mut rays.shadow);
        direct::tile_of_near(pass, tile, out, rays);
    }
}

/// What shadow photons say of some packets and one emitter, each point being asked for once.
#[derive(Clone, Copy)]
struct ByPhotons<'c> {
    coarse: &'c Coarse<'c>,
    emitter: u32,
    /// Of each packet, the lanes that were asked for.
    known: [u16; PARTS],
    /// Those of them that see the lamp.
    lit: [u16; PARTS],
    /// Those that do not.
    hidden: [u16; PARTS],
}

impl<'c> ByPhotons<'c> {
    /// Nothing was asked for.
    fn new(coarse: &'c Coarse<'c>) -> ByPhotons<'c> {
        ByPhotons { coarse, emitter: u32::MAX, known: [0; PARTS], lit: [0; PARTS], hidden: [0; PARTS] }
    }
}

impl Sight for ByPhotons<'_> {
    fn of(&mut self, number: usize, packet: &Packet<'_>, light: &Vpl<'_>, of: u16) -> [u16; 2] {
        if light.emitter != self.emitter {
            *self = ByPhotons { emitter: light.emitter, ..ByPhotons::new(self.coarse) };
        }
        for k in lanes(of & !self.known[number]) {
            let (x, normal) = (lane(&packet.position, k), lane(&packet.geometric, k));
            match self.coarse.seen(light.emitter, x, normal) {
                Seen::Lit => self.lit[number] |= 1 << k,
                Seen::Hidden => self.hidden[number] |= 1 << k,
                Seen::Unsure => {}
            }
        }
        self.known[number] |= of;
        [of & self.lit[number], of & !self.lit[number] & !self.hidden[number]]
    }
}
