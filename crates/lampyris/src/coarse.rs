//! A coarse solution of all reflected light, for final gathering to look up: in each batch the walk of 1996 leaves its light on
//! surface elements, each light group's apart [Keller96, §4.3].
//!
//! Lookups are linear in this light, so the mean of pictures by many coarse batches is the picture by one large one; what stays
//! is that elements are of one brightness each.

use crate::color::Rgb;
use crate::elements::{ElementLight, Elements};
use crate::geometry::Hit;
use crate::particle::Plan;
use crate::scatter::{RandomWalk, Rules};
use crate::sequence;
use crate::settings::{Batch, Settings};
use crate::world::World;

/// What surfaces reflect, element by element, in one batch.
#[derive(Clone, Debug)]
pub struct Coarse<'e> {
    elements: &'e Elements,
    /// Of each group that was asked for, the radiance of every element [cd/m²].
    layers: Vec<Vec<Rgb>>,
    /// Rays that it took.
    pub rays: u64,
}

impl<'e> Coarse<'e> {
    /// Walks the paths of a batch: those of the plan's layers given. The light of no layer depends on which others are.
    pub fn new(
        world: &World,
        elements: &'e Elements,
        settings: &Settings,
        plan: &Plan,
        groups: &[usize],
        batch: Batch,
    ) -> Coarse<'e> {
        let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
        let seed = sequence::hash(sequence::hash(settings.seed, replicate), u32::from(b'c'));
        let mut coarse = Coarse { elements, layers: Vec::new(), rays: 0 };
        for group in groups {
            let is_its = |emitter: u32| plan.layer_of(emitter) == *group && !plan.is_dark(world, emitter);
            let shares = (0..).zip(world.shares()).filter(|(emitter, _)| is_its(*emitter));
            let share: f64 = shares.map(|(_, share)| f64::from(*share)).sum();
            let count = (f64::from(settings.gather.paths) * share).ceil() as u32;
            let rules = Rules { seed: sequence::hash(seed, *group as u32), ..Rules::default() };
            let tint = |emitter| if is_its(emitter) { plan.tint(emitter) } else { Rgb::BLACK };
            let walk = RandomWalk::tinted(world, rules, tint);
            let first = block.wrapping_mul(count);
            let light = ElementLight::of(&walk, elements, first..first.saturating_add(count));
            coarse.rays += light.rays();
            coarse.layers.push(light.radiances(elements));
        }
        coarse
    }

    /// Adds to each group's sum `factor` times the radiance that a side of a surface reflects diffusely [cd/m²].
    #[inline]
    pub fn add(&self, world: &World, hit: &Hit, front: bool, factor: Rgb, out: &mut [Rgb]) {
        if let Some(element) = self.elements.at(world, hit, front) {
            for (out, layer) in out.iter_mut().zip(&self.layers) {
                *out += factor * layer[element as usize];
            }
        }
    }
}
