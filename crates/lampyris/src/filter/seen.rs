//! What one batch saw, pixel by pixel: light that varies slowly over a surface, what multiplies it, and where it fell.
//!
//! The rows of a picture come in bands, from the top. A band is stored behind the last rows of the one before, and a row
//! can be filtered once those that its box reaches are there.

use crate::color::Rgb;
use crate::eye::{LANES, Rect};
use glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;

/// What the first dull vertex reflects of irradiance over π, times the eye path's throughput, by channel.
pub(super) const TINT: usize = 0;
/// Where the vertex is, x y z [m].
pub(super) const POSITION: usize = 3;
/// Its shading normal, x y z; zero where there is no vertex.
pub(super) const NORMAL: usize = 6;
/// How far from its tangent plane a vertex of the next pixel may lie [m].
pub(super) const SLACK: usize = 9;
/// A number that tells surfaces of one instance and material from others, 0 where nothing is seen.
pub(super) const ALIKE: usize = 10;
/// Where the light of the first layer begins, then that of the next.
const LIGHT: usize = 11;
/// Numbers of a layer's light: what neighbours may share, what they may not, what glowed along the eye path, by channel
/// [cd/m²].
const OF_LAYER: usize = 9;

/// Beside a picture: as many pixels as are worked on at once.
pub(super) const MARGIN: usize = LANES;
/// The largest filter reaches 4 rows up and down; at edges the filtered light of the next row is asked for too.
pub(super) const REACH: u32 = 5;
/// Rows kept of what came before.
const KEPT: u32 = 2 * REACH;

/// What neighbours may share of a layer's light.
pub(super) fn lit(layer: usize) -> usize {
    LIGHT + OF_LAYER * layer
}

/// What they may not share.
pub(super) fn rest(layer: usize) -> usize {
    lit(layer) + 3
}

/// What glowed along the eye path.
pub(super) fn emission(layer: usize) -> usize {
    lit(layer) + 6
}

/// The planes of a band, each number of a pixel in a plane of its own, with margins in which nothing is.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Pixels in a row.
    pub(super) width: u32,
    /// Rows of the picture.
    pub(super) height: u32,
    /// The rows of the picture that the band holds, without those kept.
    band: Range<u32>,
    /// Rows that are done with.
    done: u32,
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
    /// Nothing, in a rectangle, by the light of so many layers.
    pub fn new(rect: Rect, layers: usize) -> Glimpse {
        Glimpse { rect, values: vec![0.0; lit(layers) * (rect.width * rect.height) as usize] }
    }

    /// Notes the vertex of pixel `k`: where it is, its normal, what it multiplies light by, and how far from its tangent
    /// plane a vertex of the next pixel may lie [m].
    pub fn place(&mut self, k: usize, position: Vec3, normal: Vec3, tint: Rgb, slack: f32) {
        self.set(POSITION, k, position.to_array());
        self.set(NORMAL, k, normal.to_array());
        self.set(TINT, k, tint.to_array());
        self.set(SLACK, k, [slack]);
    }

    /// Notes what tells the surface that pixel `k` sees from others.
    pub fn surface(&mut self, k: usize, number: u32) {
        // Numbers up to 2²⁴ are exact.
        self.set(ALIKE, k, [((number >> 8) + 1) as f32]);
    }

    /// Adds light of a layer that neighbours may share, of all pixels row by row.
    pub fn add_shared(&mut self, layer: usize, light: &[Rgb]) {
        self.add(lit(layer), light);
    }

    /// Adds light of a layer that they may not share.
    pub fn add_own(&mut self, layer: usize, light: &[Rgb]) {
        self.add(rest(layer), light);
    }

    fn add(&mut self, first: usize, light: &[Rgb]) {
        let pixels = (self.rect.width * self.rect.height) as usize;
        let mut planes = self.values[first * pixels..].chunks_mut(pixels);
        let three = [planes.next(), planes.next(), planes.next()];
        for (channel, plane) in three.into_iter().flatten().enumerate() {
            plane.iter_mut().zip(light).for_each(|(sum, v)| *sum += v[channel]);
        }
    }

    /// Notes that something of a layer glowed on the way to pixel `k`.
    pub fn gleam(&mut self, layer: usize, k: usize, radiance: Rgb) {
        let pixels = (self.rect.width * self.rect.height) as usize;
        (emission(layer)..).zip(radiance.to_array()).for_each(|(at, v)| self.values[at * pixels + k] += v);
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
    /// Nothing as yet of a picture of that size, by the light of so many layers.
    pub fn new((width, height): (u32, u32), layers: usize) -> Seen {
        Seen { width, height, band: 0..0, done: 0, planes: vec![Vec::new(); lit(layers)] }
    }

    /// Rows of the picture that are filtered.
    pub fn done(&self) -> u32 {
        self.done
    }

    /// Goes on without a layer: those behind it take its place.
    pub fn forget(&mut self, layer: usize) {
        self.planes.drain(lit(layer)..lit(layer + 1));
    }

    /// Layers of light.
    pub(super) fn layers(&self) -> usize {
        (self.planes.len() - LIGHT) / OF_LAYER
    }

    /// Puts pieces of the next rows of the picture together, of the first after the last. Returns which rows can be
    /// filtered now.
    pub(super) fn append(&mut self, band: Range<u32>, pieces: &[&Glimpse]) -> Range<u32> {
        let stride = self.stride();
        let first = band.start == 0;
        let held = (self.band.end - self.band.start) as usize * stride;
        let kept = KEPT as usize * stride;
        let last = band.end == self.height;
        if first {
            self.done = 0;
        }
        self.band = band;
        let (length, top) = (self.len(), self.band.start);
        let corner = self.index(0, top);
        self.planes.par_iter_mut().enumerate().for_each(|(number, plane)| {
            if first {
                plane.clear();
            } else {
                plane.copy_within(held..held + kept, 0);
            }
            plane.resize(length, 0.0);
            for piece in pieces {
                let rect = piece.rect;
                for (row, values) in piece.plane(number).chunks(rect.width as usize).enumerate() {
                    let at = corner + ((rect.y - top) as usize + row) * stride + rect.x as usize;
                    plane[at..at + values.len()].copy_from_slice(values);
                }
            }
            if last {
                plane[length - REACH as usize * stride..].fill(0.0);
            }
        });
        let end = if last { self.height } else { self.band.end.saturating_sub(REACH).max(self.done) };
        std::mem::replace(&mut self.done, end)..end
    }

    /// Three planes at a place.
    pub(super) fn color(&self, first: usize, at: usize) -> Rgb {
        Rgb::new(self.planes[first][at], self.planes[first + 1][at], self.planes[first + 2][at])
    }

    /// Where in a plane a pixel of the band lies, or one of the rows kept or missing around it.
    pub(super) fn index(&self, x: u32, y: u32) -> usize {
        (y + KEPT - self.band.start) as usize * self.stride() + MARGIN + x as usize
    }

    /// From a pixel to the one below it.
    pub(super) fn stride(&self) -> usize {
        (self.width as usize).next_multiple_of(LANES) + 2 * MARGIN
    }

    /// Numbers in a plane.
    fn len(&self) -> usize {
        (self.band.end - self.band.start + KEPT + REACH) as usize * self.stride()
    }
}

/// Sixteen numbers of a plane.
#[inline(always)]
pub(super) fn load(plane: &[f32], at: usize) -> &[f32; LANES] {
    plane[at..].first_chunk().expect("margins are wide enough")
}
