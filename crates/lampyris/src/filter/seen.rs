//! What one batch saw, pixel by pixel: light that varies slowly over a surface, what multiplies it, and where it fell.

use crate::color::Rgb;
use crate::eye::{LANES, Rect};
use glam::Vec3;
use rayon::prelude::*;

/// Radiance that neighbours may share, by channel [cd/m²].
pub(super) const LIT: usize = 0;
/// What the first dull vertex reflects of irradiance over π, times the eye path's throughput, by channel.
pub(super) const TINT: usize = 3;
/// Radiance that neighbours may not share, by channel [cd/m²].
pub(super) const REST: usize = 6;
/// What glowed along the eye path, by channel [cd/m²].
pub(super) const EMISSION: usize = 9;
/// Where the vertex is, x y z [m].
pub(super) const POSITION: usize = 12;
/// Its shading normal, x y z; zero where there is no vertex.
pub(super) const NORMAL: usize = 15;
/// How far from its tangent plane a vertex of the next pixel may lie [m].
pub(super) const SLACK: usize = 18;
/// A number that tells surfaces of one instance and material from others.
pub(super) const ALIKE: usize = 19;
/// Numbers of a pixel.
pub(super) const COUNT: usize = 20;

/// Beside a picture: as many pixels as are worked on at once.
const MARGIN: usize = LANES;
/// Above and below: the largest filter reaches 4 rows.
const ROWS: usize = 4;

/// The planes of a picture, each number of a pixel in a plane of its own, with margins in which nothing is.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Pixels in a row.
    pub(super) width: u32,
    /// Rows.
    pub(super) height: u32,
    pub(super) planes: Vec<Vec<f32>>,
}

/// What was seen in a rectangle of the picture.
#[derive(Clone, Debug)]
pub struct Glimpse {
    rect: Rect,
    /// The planes of the rectangle one after another, each row by row.
    values: Vec<f32>,
}

impl Glimpse {
    /// Nothing, in a rectangle.
    pub fn new(rect: Rect) -> Glimpse {
        Glimpse { rect, values: vec![0.0; COUNT * (rect.width * rect.height) as usize] }
    }

    /// Notes the vertex of pixel `k`: where it is, its normal, what tells it from other surfaces, what it multiplies light
    /// by, and how far from its tangent plane a vertex of the next pixel may lie [m].
    pub fn place(&mut self, k: usize, position: Vec3, normal: Vec3, alike: u32, tint: Rgb, slack: f32) {
        self.set(POSITION, k, position.to_array());
        self.set(NORMAL, k, normal.to_array());
        self.set(TINT, k, tint.to_array());
        // Numbers below 2²⁴ are exact.
        self.set(SLACK, k, [slack, (alike >> 8) as f32]);
    }

    /// Notes the light of pixel `k`: what neighbours may share, what they may not, and what glowed on the way.
    pub fn light(&mut self, k: usize, lit: Rgb, rest: Rgb, emission: Rgb) {
        self.set(LIT, k, lit.to_array());
        self.set(REST, k, rest.to_array());
        self.set(EMISSION, k, emission.to_array());
    }

    /// Consecutive planes at a pixel.
    fn set<const N: usize>(&mut self, first: usize, k: usize, values: [f32; N]) {
        let pixels = (self.rect.width * self.rect.height) as usize;
        (first..).zip(values).for_each(|(plane, v)| self.values[plane * pixels + k] = v);
    }

    fn plane(&self, number: usize) -> &[f32] {
        let pixels = (self.rect.width * self.rect.height) as usize;
        &self.values[number * pixels..(number + 1) * pixels]
    }
}

impl Seen {
    /// Nothing, in a picture of that size.
    pub fn new(width: u32, height: u32) -> Seen {
        let mut seen = Seen { width, height, planes: Vec::new() };
        let length = seen.len();
        seen.planes = vec![vec![0.0; length]; COUNT];
        seen
    }

    /// Puts pieces of the picture together.
    pub fn assemble(&mut self, pieces: &[&Glimpse]) {
        let (stride, first) = (self.stride(), self.index(0, 0));
        self.planes.par_iter_mut().enumerate().for_each(|(number, plane)| {
            for piece in pieces {
                let rect = piece.rect;
                for (row, values) in piece.plane(number).chunks(rect.width as usize).enumerate() {
                    let at = first + (rect.y as usize + row) * stride + rect.x as usize;
                    plane[at..at + values.len()].copy_from_slice(values);
                }
            }
        });
    }

    /// Three planes at a place.
    pub(super) fn color(&self, first: usize, at: usize) -> Rgb {
        Rgb::new(self.planes[first][at], self.planes[first + 1][at], self.planes[first + 2][at])
    }

    /// Where in a plane a pixel lies.
    pub(super) fn index(&self, x: u32, y: u32) -> usize {
        (y as usize + ROWS) * self.stride() + MARGIN + x as usize
    }

    /// From a pixel to the one below it.
    pub(super) fn stride(&self) -> usize {
        (self.width as usize).next_multiple_of(LANES) + 2 * MARGIN
    }

    /// Numbers in a plane.
    pub(super) fn len(&self) -> usize {
        (self.height as usize + 2 * ROWS) * self.stride()
    }

    /// The rows of the picture in a plane of this layout, margins beside them included.
    pub(super) fn rows_mut<'p>(
        &self,
        plane: &'p mut [f32],
    ) -> impl IndexedParallelIterator<Item = &'p mut [f32]> {
        let stride = self.stride();
        let end = (self.height as usize + ROWS) * stride;
        plane[ROWS * stride..end].par_chunks_mut(stride)
    }
}

/// Sixteen numbers of a plane.
#[inline(always)]
pub(super) fn load(plane: &[f32], at: usize) -> &[f32; LANES] {
    plane[at..].first_chunk().expect("margins are wide enough")
}
