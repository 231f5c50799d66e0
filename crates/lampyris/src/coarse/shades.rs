//! Shadow photons of the lamps of a world, shot once for all batches and dealt to the lamps like light paths, by the flux that
//! they first had: who sheds little light has few light points, and few shadow rays to be saved.
//!
//! A radius of its own makes each lamp's photons as sure as any other's: it is that of the disc in which [`WITHIN`] of them
//! would lie, were those that were shot spread evenly over all surfaces. It shrinks as photons are more, and penumbras, where
//! both kinds lie, are told apart more sharply. Lamps whose discs would be wide have no photons, and are asked by rays.

use crate::map::{Seen, Shadows};
use crate::sequence;
use crate::settings::Settings;
use crate::world::World;
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::PI;

/// Photons shot for a world, in units of the caustic photons of one batch.
const BATCHES: f32 = 32.0;

/// Photons in a disc of the radius, were all spread evenly.
const WITHIN: f32 = 64.0;

/// The largest radius [radii of the scene].
const WIDEST: f32 = 0.05;

/// Who sees which lamps.
#[derive(Clone, Debug, Default)]
pub(super) struct Shades {
    /// Of each emitter that has some, its photons and the radius in which they are looked up [m].
    of: Vec<Option<(Shadows, f32)>>,
    /// Rays that they took.
    pub(super) rays: u64,
}

impl Shades {
    /// Shoots the photons of all lamps.
    pub(super) fn new(world: &World, settings: &Settings) -> Shades {
        let mut shades = Shades::default();
        let all: Vec<u32> = (0..world.emitters().len() as u32).collect();
        shades.renew(world, settings, &all);
        shades
    }

    /// Shoots those of some lamps anew.
    pub(super) fn renew(&mut self, world: &World, settings: &Settings, emitters: &[u32]) {
        self.of.resize(world.emitters().len(), None);
        let shot: Vec<_> = emitters.par_iter().map(|emitter| shoot(world, settings, *emitter)).collect();
        for (emitter, shot) in emitters.iter().zip(shot) {
            self.rays += shot.as_ref().map_or(0, |(_, _, rays)| *rays);
            self.of[*emitter as usize] = shot.map(|(shadows, radius, _)| (shadows, radius));
        }
    }

    /// What is known of the way from the side of a surface that `normal` points to, to an emitter.
    #[inline]
    pub(super) fn seen(&self, emitter: u32, x: Vec3, normal: Vec3) -> Seen {
        match self.of.get(emitter as usize) {
            Some(Some((shadows, radius))) => shadows.seen(x, normal, *radius),
            _ => Seen::Unsure,
        }
    }
}

/// The photons of a lamp, their radius, and the rays that they took; `None` where they would lie too far apart.
fn shoot(world: &World, settings: &Settings, emitter: u32) -> Option<(Shadows, f32, u64)> {
    let share = world.shares()[emitter as usize];
    let count = (BATCHES * settings.photons as f32 * share).ceil();
    let radius = (WITHIN * world.area() / (PI * count.max(1.0))).sqrt();
    if radius > WIDEST * world.bounds().radius || world.emitters()[emitter as usize].is_dark() {
        return None;
    }
    let seed = sequence::hash(sequence::hash(settings.seed, u32::from(b's')), emitter);
    let (shadows, rays) = Shadows::new(world, emitter, count as u32, seed);
    Some((shadows, radius, rays))
}
