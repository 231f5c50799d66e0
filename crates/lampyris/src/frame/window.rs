//! The last N batches of light that changes, for walkthroughs [Keller97, §4.3]: an image is kept when a light or an object
//! moves, and each new one replaces the oldest. Those of one state of the scene are kept as their sum, which counts less with
//! each that is replaced; so nothing is ever subtracted, and there are never more planes than changes among N batches.
//!
//! For display alone, like all that is shown. Seen from elsewhere old images are worth nothing: then there are none.

use super::Frame;
use super::layer::{Layer, Plane, scale_ahead};
use super::still::Term;
use std::collections::VecDeque;
use std::sync::Arc;

/// What is shown of a layer, batch by batch.
#[derive(Clone, Debug, Default)]
pub(super) struct Window {
    /// Batches in the sum of what is shown.
    batches: u32,
    /// Sums before the light changed, the oldest first.
    past: VecDeque<Past>,
}

/// Batches of light as it was.
#[derive(Clone, Debug)]
struct Past {
    /// Σ of what they showed.
    sum: Plane,
    /// How many they were.
    of: u32,
    /// How many of them are among the last N.
    left: u32,
}

impl Window {
    /// 1 over the number of batches that are shown of light as it is, and of those that a batch has reached that was given
    /// up.
    pub(super) fn scales(&self) -> [f32; 2] {
        [1.0 / self.batches.max(1) as f32, scale_ahead(self.batches)]
    }

    /// The share of light as it is.
    pub(super) fn own(&self) -> f32 {
        if self.past.is_empty() { 1.0 } else { self.batches as f32 / self.shown() as f32 }
    }

    /// Light as it was, in its shares.
    pub(super) fn past(&self) -> impl Iterator<Item = Term> {
        let all = self.shown() as f32;
        self.past.iter().map(move |past| {
            let share = past.left as f32 / all;
            Term::whole(&past.sum, share / past.of as f32)
        })
    }

    /// Batches that are shown.
    fn shown(&self) -> u32 {
        self.batches + self.past.iter().map(|past| past.left).sum::<u32>()
    }

    /// A batch more takes the place of the oldest of `most`.
    fn count(&mut self, most: u32) {
        self.batches += 1;
        while self.shown() > most
            && let Some(oldest) = self.past.front_mut()
        {
            oldest.left -= 1;
            if oldest.left == 0 {
                self.past.pop_front();
            }
        }
    }
}

impl Layer {
    /// What it shows as light that was, if a window has room for more than the present.
    fn leave(&mut self, most: u32) -> VecDeque<Past> {
        let Window { batches, mut past } = std::mem::take(&mut self.window);
        let mut sum = self.shown.take().filter(|_| batches > 0 && most > 1);
        if let Some(sum) = sum.as_mut().filter(|_| self.ahead[1] > 0) {
            let back = batches as f32 * scale_ahead(batches);
            Arc::make_mut(sum)[..self.ahead[1]].iter_mut().for_each(|v| *v *= back);
        }
        past.extend(sum.map(|sum| Past { sum, of: batches, left: batches.min(most) }));
        past
    }
}

impl Frame {
    /// The light of a layer, or of one of the next number, is another one from now on: its sums begin anew. What its last
    /// batches showed stays within the window.
    pub(crate) fn change(&mut self, layer: usize) {
        self.release(layer);
        let past = self.layers.get_mut(layer).map(|own| own.leave(self.window)).unwrap_or_default();
        self.restart(layer);
        self.layers[layer].window.past = past;
    }

    /// Batches are about to be added to some layers: what was only shown until now is past.
    pub(crate) fn begin(&mut self, layers: &[usize]) {
        for layer in layers {
            let own = &self.layers[*layer];
            if own.batches() == 0 && (own.window.batches > 0 || own.ahead[1] > 0) {
                self.abandon(*layer);
            }
        }
    }

    /// The sums of a layer begin anew, although its light is what it was. What is shown of it stays within the window.
    pub(crate) fn abandon(&mut self, layer: usize) {
        let own = &mut self.layers[layer];
        let past = own.leave(self.window);
        let (color, window) = (own.color, Window { batches: 0, past });
        self.layers[layer] = Layer { color, window, ..self.empty() };
    }

    /// What a layer shows has a batch more.
    pub(crate) fn count_shown(&mut self, layer: usize) {
        let own = &mut self.layers[layer];
        own.window.count(self.window);
        own.ahead = [0; 2];
    }

    /// What is shown is of the sums alone from now on.
    pub(super) fn close_window(&mut self) {
        for layer in 0..self.layers.len() {
            self.layers[layer].window.past.clear();
            if self.layers[layer].batches() == 0 {
                self.restart(layer);
            }
        }
    }
}
