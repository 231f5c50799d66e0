//! A machine that renders: the trait, and which settings make sense.
//!
//! A back end is given a scene, an eye and settings once, and then batches; the sums stay where they were made until
//! somebody asks for them. CPU, GPU and cluster are three of them (ARCHITECTURE.md says how each fits).

use crate::error::{Error, Result};
use crate::eye::Eye;
use crate::frame::Frame;
use crate::integrator;
use crate::scene::Scene;
use crate::sequence::Sequence;

pub use crate::settings::{Absorption, Batch, Gather, Rays, Settings, Source, Statistics};

impl Default for Settings {
    fn default() -> Self {
        Settings {
            parts: integrator::WHOLE.iter().map(|n| (*n).to_owned()).collect(),
            paths: 64,
            passes: None,
            interleave: [1, 1],
            light_points: None,
            picks: None,
            longest: None,
            absorption: Absorption::Fractional,
            sequence: Sequence::default(),
            clamp: 1.5,
            replicates: 4,
            photons: 1 << 15,
            gather: Gather::default(),
            seed: 0,
            filter: false,
            window: 1,
            edges: 4,
            auxiliary: false,
        }
    }
}

impl Settings {
    /// A batch that is a frame to look at: each pixel gathers from one class of 25, picks what matters to it, and is
    /// averaged with its neighbours (docs/performance.md says what errors that leaves, and when).
    pub fn interactive() -> Settings {
        Settings {
            paths: 2400,
            passes: Some(1),
            interleave: [5, 5],
            light_points: Some(50),
            picks: Some(8),
            clamp: 4.0,
            photons: 1 << 13,
            filter: true,
            ..Settings::default()
        }
    }

    /// Refuses settings that make no sense, with the mend.
    pub fn check(&self) -> Result<()> {
        let bad = |text: &str| Err(Error::BadSetting(text.to_owned()));
        if self.paths == 0 || self.paths > 1 << 22 {
            return bad("the number of light paths must be 1 to 4194304");
        }
        if self.passes.is_some_and(|p| p == 0 || p > 1 << 22) {
            return bad("the number of eye passes must be 1 to 4194304");
        }
        if self.interleave.iter().any(|n| !(1..=8).contains(n)) {
            return bad("pixels are interleaved 1 × 1 to 8 × 8");
        }
        if self.filter && self.eye_passes() != 1 {
            return bad("to be filtered, a batch must have one eye pass");
        }
        if !(1..=64).contains(&self.window) {
            return bad("the window must be 1 to 64 batches");
        }
        if self.window > 1 && !self.filter {
            return bad("a window is one of what is shown: turn the filter on");
        }
        if self.edges > 64 {
            return bad("further eye rays at edges must be at most 64");
        }
        if self.light_points == Some(0) || self.picks == Some(0) {
            return bad("light points and picked virtual lights must be at least 1");
        }
        if self.photons == 0 || self.photons > 1 << 24 {
            return bad("the number of photons must be 1 to 16777216");
        }
        let Gather { rays, paths, element, radius, levels, cache, .. } = self.gather;
        if !(1..=1 << 16).contains(&rays) || !(1..=1 << 24).contains(&paths) {
            return bad("final gathering takes 1 to 65536 rays a point and 1 to 16777216 light paths");
        }
        if element.is_nan() || element <= 0.0 {
            return bad("the edge of an element must be longer than nothing");
        }
        if !(radius > 0.0 && radius <= 1.0 && (1..=16).contains(&levels)) {
            return bad(
                "final gathering asks for photons within 0 to 1 radii of the scene, and 1 to 16 levels",
            );
        }
        if cache.is_some_and(|accuracy| !(accuracy > 0.0 && accuracy <= 1.0)) {
            return bad(
                "the accuracy of irradiance that final gathering interpolates must be above 0 and at most 1; try 0.2",
            );
        }
        if !(2..=64).contains(&self.replicates) {
            return bad("the number of randomisations must be 2 to 64");
        }
        if !(self.clamp >= 0.0 && self.clamp.is_finite()) {
            return bad("the clamping factor must be finite and not negative");
        }
        integrator::select(&self.parts).map(|_| ())
    }
}

/// TRAIT 1 of two: a machine.
pub trait Backend: Send {
    /// Starts afresh with a scene, an eye and settings; all sums return to zero.
    fn begin(&mut self, scene: Scene, eye: Eye, settings: &Settings) -> Result<()>;
    /// Renders one batch and adds it to the sums. The order of batches is the caller's and decides the last bits.
    fn add(&mut self, batch: Batch) -> Result<()>;
    /// The sums.
    fn frame(&mut self) -> Result<&Frame>;
    /// What was done since `begin`.
    fn statistics(&self) -> Statistics;
}
