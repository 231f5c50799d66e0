//! What a batch leaves that was given up: the first rows of some layers have it, the others do not. Nothing of it is lost;
//! it is completed later, and until then the rows that have it are weighted by what they have.
//!
//! Counts, randomisations and errors know of whole batches alone.

use super::Frame;

impl Frame {
    /// A batch was given up that some layers have in so many of their first pixels: of the sums, and of what is shown.
    pub(crate) fn tear(&mut self, layers: &[usize], ahead: [usize; 2]) {
        layers.iter().for_each(|layer| self.layers[*layer].ahead = ahead);
    }

    /// Whether a layer has part of a batch.
    pub(crate) fn is_torn(&self, layer: usize) -> bool {
        self.layers.get(layer).is_some_and(|own| own.ahead != [0; 2])
    }
}
