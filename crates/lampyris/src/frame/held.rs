//! What stands in for layers that are solved anew although their light, all together, is what it was: those among which
//! lamps changed places. Each of their batches takes the place of one before, until all of those are replaced; so a
//! picture does not fall back when a lamp is taken out of a group.
//!
//! Colours that change meanwhile are seen as soon as a layer has a batch: what is held stays as it is, and the layer's own
//! light is added in the colour that it has more or less now. For display alone: sums and errors know nothing of it.

use super::Frame;
use super::layer::{Layer, Plane};
use super::still::Standing;
use crate::color::Rgb;
use std::sync::Arc;

/// What some layers showed together.
#[derive(Clone, Debug)]
pub(super) struct Held {
    /// The layers that have this light now, in the order of their numbers, and the colours in which it is held.
    layers: Vec<(usize, Rgb)>,
    /// The mean of what they showed, in these colours.
    shown: Plane,
    /// Batches of which it is the mean.
    batches: u32,
}

impl Held {
    pub(super) fn layers(&self) -> impl Iterator<Item = usize> {
        self.layers.iter().map(|(number, _)| *number)
    }

    pub(super) fn is_for(&self, layer: usize) -> bool {
        self.layers().any(|number| number == layer)
    }

    pub(super) fn batches(&self) -> u32 {
        self.batches
    }

    /// How much of it is still shown.
    pub(super) fn share(&self, layers: &[Layer]) -> f32 {
        let new = self.layers().map(|number| layers[number].batches()).min().unwrap_or(0);
        1.0 - new.min(self.batches) as f32 / self.batches as f32
    }
}

impl Frame {
    /// What is shown of all that is held.
    pub(super) fn standing(&self) -> Vec<Standing> {
        let of = |held: &Held| Standing {
            layers: held.layers.clone(),
            share: held.share(&self.layers),
            plane: Arc::clone(&held.shown),
        };
        self.held.iter().map(of).collect()
    }

    /// Lamps changed places among some layers, the last of which may be one more: all of them begin anew, and what they
    /// showed stands in for them, unless the lamps have another colour in their new place.
    pub(crate) fn regroup(&mut self, layers: &[usize]) {
        let held = self.hold(layers);
        layers.iter().for_each(|layer| self.restart(*layer));
        self.held.extend(held);
    }

    /// The light of a layer is about to be another one. What is held for others with it goes on without it, as long as a
    /// batch tells what it was.
    pub(super) fn release(&mut self, layer: usize) {
        let Some(at) = self.held.iter().position(|held| held.is_for(layer)) else { return };
        let own = &self.layers[layer];
        let color = self.held[at].layers.iter().find(|(number, _)| *number == layer).map(|(_, color)| *color);
        let Some(color) = color.filter(|_| own.batches() > 0) else {
            self.held.remove(at);
            return;
        };
        let light = self.light_of(layer, color);
        let held = &mut self.held[at];
        Arc::make_mut(&mut held.shown).iter_mut().zip(light).for_each(|(shown, v)| *shown += -v);
        held.layers.retain(|(number, _)| *number != layer);
        self.held.retain(|held| !held.layers.is_empty());
    }

    /// Nothing stands in for anything from now on, and nothing past is shown.
    pub(crate) fn let_go(&mut self) {
        self.held.clear();
        self.close_window();
    }

    /// What some layers show, with those that are held together with one of them.
    fn hold(&self, layers: &[usize]) -> Option<Held> {
        let before: Vec<&Held> =
            self.held.iter().filter(|held| layers.iter().any(|layer| held.is_for(*layer))).collect();
        let mut numbers: Vec<usize> =
            layers.iter().copied().chain(before.iter().flat_map(|held| held.layers())).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let color = self.layers.get(*layers.first()?)?.color;
        let old = || layers.iter().filter_map(|layer| self.layers.get(*layer));
        // What is dimmed and has no batch since is not shown as it should be.
        let known = |number: usize| {
            let layer = &self.layers[number];
            let held = before.iter().find_map(|held| held.layers.iter().find(|(own, _)| *own == number));
            layer.batches() > 0 || held.is_some_and(|(_, color)| *color == layer.color)
        };
        let there = || numbers.iter().copied().filter(|number| *number < self.layers.len());
        if old().any(|layer| layer.color != color) || !there().all(known) {
            return None;
        }
        let free = there().filter(|number| !before.iter().any(|held| held.is_for(*number)));
        let batches = free.map(|number| self.layers[number].batches());
        let batches = batches.chain(before.iter().map(|held| held.batches)).min()?;
        let colored = |number: &usize| (*number, self.layers.get(*number).map_or(color, |own| own.color));
        Some(Held {
            layers: numbers.iter().map(colored).collect(),
            shown: Arc::new(self.blend().mix_of(|number| numbers.contains(&number), |_| None)),
            batches,
        })
    }
}
