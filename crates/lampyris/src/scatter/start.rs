//! Where paths start: an emitter in proportion to its power, by inversion of the running sum, a place on it and a direction
//! by inversion of theirs. Every path carries the same luminous flux, save where a picture says how a lamp glows.

use super::bounce::{Die, unit};
use crate::color::Rgb;
use crate::sequence::ledger::scatter as ledger;
use crate::world::World;
use glam::Vec3;

/// The lamps that shine, each with the running share of the paths.
#[derive(Clone, Debug)]
pub struct Lamps {
    numbers: Vec<u32>,
    /// Up to and including each; the last is 1.
    cumulative: Vec<f64>,
    tints: Vec<Rgb>,
}

/// A path's beginning.
pub(super) struct Start {
    pub(super) emitter: u32,
    pub(super) origin: Vec3,
    pub(super) direction: Vec3,
    pub(super) flux: Rgb,
}

impl Lamps {
    /// Those of a world by their luminous power, times the luminance of a tint each.
    pub(super) fn new(world: &World, tint: impl Fn(u32) -> Rgb) -> Lamps {
        let mut lamps = Lamps { numbers: Vec::new(), cumulative: Vec::new(), tints: Vec::new() };
        let mut sum = 0.0;
        for (number, emitter) in (0..).zip(world.emitters()) {
            let tint = tint(number);
            let power = emitter.importance(world.bounds()) * tint.luminance();
            if power > 0.0 && power.is_finite() {
                sum += f64::from(power);
                lamps.numbers.push(number);
                lamps.cumulative.push(sum);
                lamps.tints.push(tint);
            }
        }
        lamps.cumulative.iter_mut().for_each(|c| *c /= sum);
        lamps
    }

    /// Numbers of the emitters, each with its share of the paths.
    pub fn shares(&self) -> impl Iterator<Item = (u32, f64)> {
        let share = |k: usize| self.cumulative[k] - if k == 0 { 0.0 } else { self.cumulative[k - 1] };
        self.numbers.iter().enumerate().map(move |(k, number)| (*number, share(k)))
    }

    /// The beginning of a path; `None` if nothing shines.
    pub(super) fn start(&self, world: &World, die: &Die) -> Option<Start> {
        let u = die.number(ledger::POINT);
        let k = self.cumulative.partition_point(|c| *c <= u).min(self.numbers.len().checked_sub(1)?);
        let below = if k == 0 { 0.0 } else { self.cumulative[k - 1] };
        let share = self.cumulative[k] - below;
        // The rest of the number places the point: composition takes no dimension of its own.
        let place = [unit((u - below) / share), unit(die.number(ledger::POINT + 1))];
        let turn = [ledger::EMISSION, ledger::EMISSION + 1].map(|d| unit(die.number(d)));
        let emitter = self.numbers[k];
        let start =
            world.emitters()[emitter as usize].emit([place[0], place[1], turn[0], turn[1]], world.bounds());
        let flux = start.flux * self.tints[k] * ((1.0 / share) as f32);
        Some(Start { emitter, origin: start.origin, direction: start.direction, flux })
    }
}
