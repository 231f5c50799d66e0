//! How much a walkthrough flickers: Σ |(Lₜ − Lₜ₋₁) − (Rₜ − Rₜ₋₁)| / Σ Rₜ over frames and pixels, for luminances L of the frames
//! and R of the same frames converged. What R does by itself is motion; what is left is flicker.
//!
//! Once for light as it was gathered, and once as it is displayed: filtered, and clipped at display white. Beside the
//! frames stand others of as many batches whose random numbers are drawn anew in each, as a measure of what it is worth
//! that a session's are not.

use super::Player;
use crate::failure::Failure;
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::frame::Frame;
use serde::Serialize;

/// Shares of the light, a frame in the mean.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Flicker {
    /// Batches of each converged frame.
    reference_batches: u32,
    /// Nothing with a window of past batches, which are filtered.
    pub(crate) unfiltered: Option<Pair>,
    pub(crate) displayed: Pair,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Pair {
    pub(crate) session: f64,
    /// The session's worst frame.
    pub(crate) worst: f64,
    /// With random numbers drawn anew in each frame.
    pub(crate) independent: f64,
    pub(crate) ratio: f64,
    /// Σ |Lₜ − Rₜ| / Σ Rₜ: how far the session's frames are from converged ones.
    pub(crate) error: f64,
}

/// The measurement while frames come.
pub(crate) struct Meter {
    /// Plays the same script beside the frames that are shown.
    shadow: Player,
    reference_batches: u32,
    /// Of the session and of independent frames, unfiltered and displayed.
    changes: [Changes; 4],
}

/// Seeds that no frame of a session has: of converged frames, and of the first independent one.
const REFERENCE: u32 = 0x5eed_0001;
const INDEPENDENT: u32 = 0x5eed_0002;

impl Meter {
    pub(crate) fn new(shadow: Player, reference_batches: u32) -> Meter {
        Meter { shadow, reference_batches, changes: Default::default() }
    }

    /// Takes a frame of the session; `white` is what is displayed as white [cd/m²].
    ///
    /// # Errors
    /// Those of the back end.
    pub(crate) fn add(&mut self, number: u32, shown: &Frame, white: f32) -> Result<(), Failure> {
        let Meter { shadow, reference_batches, changes } = self;
        shadow.arrange(number)?;
        let settings = shadow.settings.clone();
        let seeded = |seed: u32| Settings { seed: settings.seed ^ seed, ..settings.clone() };
        shadow.session.set(&seeded(INDEPENDENT.wrapping_add(number)))?;
        shadow.session.settle(shadow.settle)?;
        let independent = luminances(shadow.session.frame()?, white);
        shadow.session.set(&seeded(REFERENCE))?;
        shadow.session.settle(*reference_batches)?;
        let truth = luminances(shadow.session.frame()?, white);
        // A converged frame needs no filter.
        let truth = [truth[0].clone(), clipped(truth[0].iter().copied(), white)];
        let frames = [luminances(shown, white), independent].concat();
        for (k, (change, frame)) in changes.iter_mut().zip(frames).enumerate() {
            change.add(frame, &truth[k % 2]);
        }
        Ok(())
    }

    /// What it came to; NaN for a single frame.
    pub(crate) fn result(&self) -> Flicker {
        let pair = |kind: usize| {
            let (session, independent) = (self.changes[kind].share(), self.changes[2 + kind].share());
            let Changes { worst, off, all, .. } = self.changes[kind];
            Pair { session, worst, independent, ratio: independent / session, error: off / all }
        };
        let unfiltered = (self.shadow.settings.window == 1).then(|| pair(0));
        Flicker { reference_batches: self.reference_batches, unfiltered, displayed: pair(1) }
    }
}

/// Unfiltered and displayed.
fn luminances(frame: &Frame, white: f32) -> [Vec<f32>; 2] {
    let of = |picture: Vec<Rgb>| picture.into_iter().map(|c| c.luminance());
    [of(frame.mean()).collect(), clipped(of(frame.shown()), white)]
}

fn clipped(luminances: impl Iterator<Item = f32>, white: f32) -> Vec<f32> {
    luminances.map(|l| l.clamp(0.0, white)).collect()
}

/// A sum over frames.
#[derive(Default)]
struct Changes {
    /// L − R of the frame before.
    before: Option<Vec<f32>>,
    change: f64,
    light: f64,
    /// The greatest share of a frame.
    worst: f64,
    /// Σ |L − R| and Σ R of all frames, the first too.
    off: f64,
    all: f64,
}

impl Changes {
    fn add(&mut self, frame: Vec<f32>, truth: &[f32]) {
        let off: Vec<f32> = frame.iter().zip(truth).map(|(l, r)| l - r).collect();
        let light: f64 = truth.iter().map(|r| f64::from(*r)).sum();
        self.off += off.iter().map(|o| f64::from(o.abs())).sum::<f64>();
        self.all += light;
        if let Some(before) = &self.before {
            let change: f64 = off.iter().zip(before).map(|(a, b)| f64::from((a - b).abs())).sum();
            self.change += change;
            self.light += light;
            self.worst = self.worst.max(change / light);
        }
        self.before = Some(off);
    }

    fn share(&self) -> f64 {
        self.change / self.light
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motion_is_no_flicker_and_noise_is() {
        let mut changes = Changes::default();
        for (frame, truth) in [([1.0, 3.0], [1.0, 2.0]), ([2.0, 6.0], [2.0, 5.0]), ([3.0, 5.0], [3.0, 5.0])] {
            changes.add(frame.to_vec(), &truth);
        }
        // Only the second pixel of the third frame changes otherwise than the truth: by 1, where Σ R is 7 + 8.
        assert!((changes.share() - 1.0 / 15.0).abs() < 1e-9);
        assert_eq!(changes.worst, 1.0 / 8.0);
        // Two pixels are off by 1, of all the light of three frames.
        assert_eq!(changes.off / changes.all, 2.0 / 18.0);
    }
}
