//! The light of one group: exact sums, what tells their spread, and what is shown of it.
//!
//! Planes are shared with stills until a batch is added: only then, and only where a still is alive, they are copied.

use super::still::Term;
use super::window::Window;
use super::{BLOCK, Tiles};
use crate::color::Rgb;
use crate::eye::Rect;
use crate::sequence;
use rayon::prelude::*;
use std::sync::Arc;

/// Numbers of a whole picture, row by row.
pub(super) type Plane = Arc<Vec<Rgb>>;

/// The light of one group.
#[derive(Clone, Debug, Default)]
pub(super) struct Layer {
    /// What it is multiplied by.
    pub(super) color: Rgb,
    /// Sum over all batches: a plane for each part, or one of all parts together.
    pub(super) planes: Vec<Plane>,
    /// The sums of each randomisation.
    pub(super) replicates: Vec<Replicate>,
    /// That of the randomisation to which a batch is being added, until it is complete.
    pub(super) open: Option<Replicate>,
    /// Σ over the batches of what each shows, if filtered.
    pub(super) shown: Option<Plane>,
    /// How many these are, and what was shown before.
    pub(super) window: Window,
    /// How many of the first pixels a batch has reached that was given up: of the sums, and of what is shown. They have a
    /// batch more than is counted.
    pub(super) ahead: [usize; 2],
}

/// What a randomisation's spread is known by.
#[derive(Clone, Debug, Default)]
pub(super) struct Replicate {
    /// Sums of blocks of pixels, row by row.
    pub(super) blocks: Vec<Rgb>,
    /// Sums of one pixel of each block.
    pub(super) probes: Vec<Rgb>,
    /// Batches added.
    pub(super) batches: u32,
}

/// Where the blocks of a picture lie.
#[derive(Clone, Copy)]
pub(super) struct Blocks {
    /// Of the picture [pixels].
    pub(super) width: u32,
    /// Edge of a block [pixels].
    pub(super) edge: u32,
    /// Blocks in a row.
    pub(super) columns: usize,
    /// Rows of them.
    pub(super) rows: usize,
}

impl Blocks {
    /// Those of a picture. Meters, all in one row, are a block each.
    pub(super) fn new(width: u32, height: u32) -> Blocks {
        let edge = if height == 1 { 1 } else { BLOCK };
        let [columns, rows] = [width, height].map(|length| length.div_ceil(edge) as usize);
        Blocks { width, edge, columns, rows }
    }
}

impl Layer {
    /// Adds some rectangles of a batch.
    pub(super) fn add(&mut self, replicate: u32, tiles: &Tiles, of: Blocks) {
        let Layer { planes, replicates, open, .. } = self;
        let Replicate { blocks, probes, .. } =
            open.get_or_insert_with(|| replicates[replicate as usize].clone());
        let rows = |rect: &Rect| {
            let left = rect.x;
            (rect.y..rect.y + rect.height).map(move |y| (left, y))
        };
        let add_planes = || {
            planes.par_iter_mut().enumerate().for_each(|(number, sum)| {
                let sum = Arc::make_mut(sum);
                for (rect, values) in tiles {
                    for ((x, y), values) in rows(rect).zip(values[number].chunks(rect.width as usize)) {
                        let at = y as usize * of.width as usize + x as usize;
                        sum[at..at + values.len()].iter_mut().zip(values).for_each(|(s, v)| *s += *v);
                    }
                }
            });
        };
        let add_blocks = || {
            let Blocks { edge, columns, .. } = of;
            for (rect, values) in tiles {
                for ((left, y), row) in
                    values.iter().flat_map(|v| rows(rect).zip(v.chunks(rect.width as usize)))
                {
                    let mut x = left;
                    while x < left + rect.width {
                        let end = ((x / edge + 1) * edge).min(left + rect.width);
                        let at = (y / edge) as usize * columns + (x / edge) as usize;
                        let [px, py] = probe(at, edge);
                        let (px, values) =
                            (x / edge * edge + px, &row[(x - left) as usize..(end - left) as usize]);
                        values.iter().for_each(|v| blocks[at] += *v);
                        if y % edge == py && (x..end).contains(&px) {
                            probes[at] += values[(px - x) as usize];
                        }
                        x = end;
                    }
                }
            }
        };
        rayon::join(add_planes, add_blocks);
    }

    /// Every pixel of a batch was added once.
    pub(super) fn count(&mut self, replicate: u32) {
        let own = &mut self.replicates[replicate as usize];
        let batches = own.batches + 1;
        *own = Replicate { batches, ..self.open.take().unwrap_or_else(|| own.clone()) };
    }

    pub(super) fn batches(&self) -> u32 {
        self.replicates.iter().map(|r| r.batches).sum()
    }

    pub(super) fn scale(&self) -> f32 {
        1.0 / self.batches().max(1) as f32
    }

    /// The planes whose sum is so much of its mean.
    pub(super) fn mean(&self, share: f32) -> impl Iterator<Item = Term> {
        let weights = [self.scale(), scale_ahead(self.batches())].map(|scale| share * scale);
        self.planes.iter().map(move |plane| Term::new(plane, weights, self.ahead[0]))
    }

    /// The same where a share of it is of what its batches show, and with what is shown of those before.
    pub(super) fn mix(&self, share: f32) -> impl Iterator<Item = Term> {
        let own = self.window.own();
        let weights = self.window.scales().map(|scale| own * (share * scale));
        let shown = self.shown.iter().map(move |plane| Term::new(plane, weights, self.ahead[1]));
        self.mean(own * (1.0 - share)).chain(shown).chain(self.window.past())
    }
}

/// 1 over the batches of pixels that have one more than is counted. Before any is complete they show nothing.
pub(super) fn scale_ahead(batches: u32) -> f32 {
    if batches == 0 { 0.0 } else { 1.0 / (batches + 1) as f32 }
}

/// Which pixel of a block stands for all: another in each, or interleaving would always see the same class.
pub(super) fn probe(block: usize, edge: u32) -> [u32; 2] {
    let number = sequence::hash(block as u32, u32::from(b'p'));
    [number % edge, number / edge % edge]
}
