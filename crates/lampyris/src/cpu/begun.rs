//! Batches that were begun and given up, because somebody wants to see something else first. The rows that were drawn stay,
//! and the rest follows: light groups that an edit leaves alone lose nothing when a batch ends early.
//!
//! An edit that changes the light of a group empties its layer, and what was begun for it is forgotten. The light of the
//! others takes the same paths as before, so that they have the same bits in the end as if nothing had happened.

use super::film::Film;
use crate::filter::Seen;
use crate::frame::Auxiliary;
use crate::settings::Batch;

/// How far a batch is.
pub(super) struct Begun {
    pub(super) batch: Batch,
    /// Whether it is added to the sums, or only to what is shown.
    pub(super) kept: bool,
    /// Whether it is noted what the eye meets first.
    pub(super) note: bool,
    /// The light groups that the batch is added to, in the order of their numbers.
    pub(super) groups: Vec<usize>,
    /// Bands of tiles that are done.
    pub(super) bands: usize,
    /// Pixels up to the last of them.
    pub(super) pixels: usize,
    /// What neighbours of the next band see, if it is filtered.
    pub(super) seen: Option<Seen>,
}

impl Film {
    /// A batch for the groups that have the fewest: what is left of one that was given up, or a new one.
    pub(super) fn begin(&mut self, batch: Batch, kept: bool) -> Begun {
        let Film { begun, frame, .. } = self;
        begun.iter_mut().for_each(|begun| begun.keep(|group| frame.is_torn(group)));
        begun.retain(|begun| !begun.groups.is_empty());
        loop {
            let fewest = frame.batches();
            let due = |group: &usize| frame.batches_of(*group) == fewest;
            let groups: Vec<usize> = (0..frame.layers()).filter(due).collect();
            let Some(at) = begun.iter().position(|begun| begun.groups.iter().all(due)) else {
                // What the eye meets has nothing to do with light: it is noted once.
                let samples = fewest * self.settings.eye_passes();
                let new = |sums: &Auxiliary| sums.samples == samples;
                let note = kept && frame.auxiliary().is_some_and(new);
                let seen = self.settings.filter.then(|| Seen::new(self.eye.size(), groups.len()));
                return Begun { batch, kept, note, groups, bands: 0, pixels: 0, seen };
            };
            let begun = begun.swap_remove(at);
            if begun.batch == batch && begun.kept == kept {
                return begun;
            }
            begun.groups.iter().for_each(|group| frame.abandon(*group));
        }
    }

    /// Keeps what was done of a batch.
    pub(super) fn give_up(&mut self, begun: Begun) {
        let (width, _) = self.eye.size();
        let shown = begun.seen.as_ref().map_or(0, |seen| seen.done() as usize * width as usize);
        let added = if begun.kept { begun.pixels } else { 0 };
        self.frame.tear(&begun.groups, [added, shown]);
        if begun.note && begun.bands > 0 {
            // Who asks what the eye meets first waits for whole batches.
            begun.groups.iter().for_each(|group| self.frame.abandon(*group));
            self.frame.forget_first();
        } else if added + shown > 0 {
            self.begun.push(begun);
        }
    }

    /// Forgets what was begun for groups that have `batches` or more: their layers begin anew.
    pub(super) fn forget_begun(&mut self, batches: u32) {
        let Film { begun, frame, .. } = self;
        let due = |begun: &mut Begun| begun.groups.iter().any(|group| frame.batches_of(*group) >= batches);
        let forgotten: Vec<usize> = begun.extract_if(.., due).flat_map(|begun| begun.groups).collect();
        for group in forgotten {
            if frame.is_torn(group) {
                frame.abandon(group);
            }
        }
    }
}

impl Begun {
    /// Goes on for some of its groups.
    fn keep(&mut self, wanted: impl Fn(usize) -> bool) {
        for place in (0..self.groups.len()).rev() {
            if !wanted(self.groups[place]) {
                self.groups.remove(place);
                self.seen.iter_mut().for_each(|seen| seen.forget(place));
            }
        }
    }
}
