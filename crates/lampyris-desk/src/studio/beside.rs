//! What is drawn beside the picture: small pictures while something moves, or what clamping takes of it.

use super::{REST, Stage, picture_settings};
use crate::error::Result;
use crate::wire::LEAST;
use lampyris::backend::Settings;
use lampyris::frame::Frame as Sums;
use lampyris::session::Sketch;
use std::time::Instant;

/// What a sketch shall take while something moves [s], the shares of the full edges that it may have, and pixels that it has at
/// least.
const QUICK: f32 = 0.06;
const EDGES: [f32; 6] = [0.75, 0.5, 0.375, 0.25, 0.1875, 0.125];
const FEWEST: f32 = 160.0 * 120.0;

/// A seed of which the first sample of all pixels lies at (0.507, 0.491) of them. A sketch that moves has one batch, and its
/// pixels are large: what is drawn over it would lie up to half of one beside what it is drawn over.
const CENTRED: u32 = 920;

/// Batches of what clamping takes, the share of the full edges that it is drawn with, and batches that the picture has before.
const CLAMPED: u32 = 32;
const CLAMPED_EDGE: f32 = 0.5;
pub(super) const BEFORE_CLAMPED: u32 = 2;

/// A batch that is soon done, of a picture that is soon another. Corners lack some of their light: to find it, by short rays
/// one by one, takes as long as a third of all the rest. Less is clamped in turn.
fn sketchy(survey: bool) -> Settings {
    let own = picture_settings(survey);
    let parts = own.parts.iter().filter(|part| *part != "compensation").cloned().collect();
    let clamp = 0.5 * own.clamp;
    let few = Settings { paths: 800, light_points: Some(25), picks: Some(4), photons: 1 << 11, ..own };
    Settings { parts, clamp, edges: 0, seed: CENTRED, ..few }
}

impl Stage {
    /// Something moves: there is to be a sketch, as large as can be drawn quickly. While it moves it keeps its size. Where the
    /// light of `all` groups is another one, they are sketched together.
    pub(super) fn begin_to_move(&mut self, all: bool) -> Result<()> {
        let rested = self.moved.is_none_or(|at| at.elapsed() > REST);
        self.moved = Some(Instant::now());
        let pixels = (self.size[0] * self.size[1]) as f32;
        let pixel = self.pixel[usize::from(all && !self.survey.layers)];
        let has = |edge: f32| pixels * edge * edge;
        let mut large = EDGES.iter().copied().filter(|edge| has(*edge) >= FEWEST);
        let edge = match pixel {
            // The first sketch of all tells how quick this machine is.
            0.0 => EDGES[2],
            _ => large
                .clone()
                .find(|edge| pixel * has(*edge) < QUICK)
                .or(large.next_back())
                .unwrap_or(EDGES[0]),
        };
        let sketch = self.size.map(|n| ((n as f32 * edge) as u32).max(LEAST));
        let melted = (all && !self.survey.layers).then(|| self.colors.clone());
        if self.clamped || (rested && sketch != self.sketch) || melted != self.melted {
            (self.sketch, self.melted) = (sketch, melted);
            self.begin_sketch()?;
        }
        Ok(())
    }

    /// What clamping takes is drawn in the place of a sketch, until something moves.
    pub(super) fn begin_clamped(&mut self) -> Result<()> {
        let size = self.size.map(|n| ((n as f32 * CLAMPED_EDGE) as u32).max(1));
        let own = picture_settings(false);
        let settings = Settings { parts: vec!["compensation".into()], filter: false, ..own };
        self.clamped = true;
        Ok(self.session.sketch(Some(Sketch { size, settings, melted: None }))?)
    }

    pub(super) fn begin_sketch(&mut self) -> Result<()> {
        self.clamped = false;
        let (size, melted) = (self.sketch, self.melted.clone());
        Ok(self.session.sketch(Some(Sketch { size, settings: sketchy(self.survey.surfaces), melted }))?)
    }

    /// Whether more is to be known of what clamping takes.
    pub(super) fn lacks_clamped(&self) -> bool {
        let batches = self.session.sketched().filter(|_| self.clamped).map_or(0, Sums::batches);
        self.survey.clamped && batches < CLAMPED
    }

    /// Whether what clamping takes is wanted has changed.
    pub(super) fn put_clamped_away(&mut self) -> Result<()> {
        if self.clamped {
            (self.clamped, self.sketch) = (false, [0; 2]);
            self.session.sketch(None)?;
        }
        Ok(())
    }
}
