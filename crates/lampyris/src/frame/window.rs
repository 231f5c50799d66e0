//! The last N batches of light that changes, for walkthroughs [Keller97, §4.3]: an image is kept when a light or an object
//! moves, and each new one replaces the oldest. Those of one state of the scene are kept as their sum, which counts less with
//! each that is replaced; so nothing is ever subtracted, and there are never more planes than changes among N batches.
//!
//! For display alone, like all that is shown. Seen from elsewhere old images are worth nothing: then there are none.

use super::{Frame, Layer};
use crate::color::Rgb;
use std::collections::VecDeque;

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
    sum: Vec<Rgb>,
    /// How many they were.
    of: u32,
    /// How many of them are among the last N.
    left: u32,
}

impl Window {
    /// 1 over the number of batches that are shown of light as it is.
    pub(super) fn scale(&self) -> f32 {
        1.0 / self.batches.max(1) as f32
    }

    /// The share of light as it is.
    pub(super) fn own(&self) -> f32 {
        if self.past.is_empty() { 1.0 } else { self.batches as f32 / self.shown() as f32 }
    }

    /// Light as it was, in its shares.
    pub(super) fn past(&self, color: Rgb) -> impl Iterator<Item = (&[Rgb], Rgb)> {
        let all = self.shown() as f32;
        self.past.iter().map(move |past| {
            let share = past.left as f32 / all;
            (past.sum.as_slice(), color * (share / past.of as f32))
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
        let sum = self.shown.take().filter(|_| batches > 0 && most > 1);
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
            let own = &mut self.layers[*layer];
            if own.batches() == 0 && own.window.batches > 0 {
                let past = own.leave(self.window);
                let color = own.color;
                let window = Window { batches: 0, past };
                self.layers[*layer] = Layer { color, window, ..self.empty() };
            }
        }
    }

    /// What a layer shows has a batch more.
    pub(crate) fn count_shown(&mut self, layer: usize) {
        self.layers[layer].window.count(self.window);
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
