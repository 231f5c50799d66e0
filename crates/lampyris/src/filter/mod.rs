//! The discontinuity buffer [Wald et al. 2002, §4.3]: neighbours that see the same surface share what light they gathered.
//!
//! Radiance and reflectance are added up over a box as wide as the interleaving, so that each class is in it once; the
//! ratio of the sums is the irradiance, and the pixel's own reflectance multiplies it, so that textures stay sharp. A
//! neighbour counts if it lies near the pixel's tangent plane and faces the same way: slopes seen at a grazing angle
//! and curved surfaces pass, which a comparison of distances does not let through.
//!
//! For display alone: what is averaged between neighbours never enters the sums of a frame. Each batch is filtered by
//! itself, with the surfaces that it saw, before it is added to what is shown.

mod edges;
mod seen;
#[cfg(test)]
mod tests;

pub use seen::{Glimpse, Seen};

use crate::color::Rgb;
use crate::eye::{Eye, LANES, Sampling};
use crate::geometry::{Kernel, Wide};
use crate::settings::Settings;
use crate::world::World;
use edges::Again;
use rayon::prelude::*;
use seen::{ALIKE, MARGIN, NORMAL, POSITION, SLACK, TINT, emission, lit, load, rest};
use std::ops::Range;

/// What is the same for a whole batch.
pub struct Filter<'a> {
    /// The scene.
    pub world: &'a World,
    /// What looks.
    pub eye: &'a Eye,
    /// The batch's sample of each pixel.
    pub sampling: Sampling,
    /// The interleaving, and how many further eye rays there are at edges.
    pub settings: &'a Settings,
    /// Of each emitter the layer that it belongs to, if what glows along eye paths is asked for.
    pub layer_of: &'a (dyn Fn(u32) -> Option<(usize, Rgb)> + Sync),
}

impl Filter<'_> {
    /// Adds what a batch shows to the planes of its layers, row by row of the picture: the light of the next `band` of rows,
    /// filtered over boxes of n × m, with further eye rays where surfaces meet. The last rows wait for the next band.
    ///
    /// Returns the eye rays it took.
    pub fn show(
        &self,
        seen: &mut Seen,
        band: Range<u32>,
        glimpses: &[&Glimpse],
        shown: &mut [&mut Vec<Rgb>],
    ) -> u64 {
        let rows = seen.append(band, glimpses);
        let seen = &*seen;
        let smooth = Smooth::new(self.world.tracer().kernel(), seen, rows.clone(), self.settings);
        let width = seen.width as usize;
        let mut planes: Vec<_> = shown
            .iter_mut()
            .map(|plane| plane[rows.start as usize * width..rows.end as usize * width].chunks_mut(width))
            .collect();
        let by_row: Vec<(u32, Vec<&mut [Rgb]>)> =
            rows.map(|y| (y, planes.iter_mut().filter_map(Iterator::next).collect())).collect();
        let again = Again::new(self, seen, &smooth);
        let done = by_row.into_par_iter().map(|(y, mut row)| {
            for (layer, row) in row.iter_mut().enumerate() {
                smooth.show(seen, layer, y, row);
            }
            again.refine(y, &mut row)
        });
        done.sum()
    }
}

/// Irradiance over π of the pixels of some rows, as their neighbours agree on it.
struct Smooth {
    /// The first of the rows.
    top: u32,
    layers: usize,
    stride: usize,
    /// Row by row: a row of each channel of each layer, 0 where nothing is reflected, and at last one that is 1 where
    /// surfaces meet. Rows have the margins of [`Seen`].
    values: Vec<f32>,
}

impl Smooth {
    /// Of `rows` of the picture, and of the rows above and below.
    fn new(kernel: Kernel, seen: &Seen, rows: Range<u32>, settings: &Settings) -> Smooth {
        let (layers, stride) = (seen.layers(), seen.stride());
        let (top, end) = (rows.start.saturating_sub(1), (rows.end + 1).min(seen.height));
        let row = (3 * layers + 1) * stride;
        let mut values = vec![0.0; if rows.is_empty() { 0 } else { (end - top) as usize * row }];
        let reach = settings.interleave.map(|n| n as i32 / 2);
        let edges = settings.edges > 0;
        values.par_chunks_mut(row).zip(top..end).for_each(|(values, y)| {
            kernel.run(Row { seen, y, reach, edges, layers, values });
        });
        Smooth { top, layers, stride, values }
    }

    /// Adds what the pixels of a row show of a layer, as [`Smooth::shown`] says.
    fn show(&self, seen: &Seen, layer: usize, y: u32, row: &mut [Rgb]) {
        let start = seen.index(0, y);
        let three = |first: usize| [0, 1, 2].map(|c| &seen.planes[first + c][start..start + row.len()]);
        let (glow, own, tint) = (three(emission(layer)), three(rest(layer)), three(TINT));
        let light = [0, 1, 2].map(|c| &self.values[self.row(3 * layer + c, y)..][..row.len()]);
        for (x, pixel) in row.iter_mut().enumerate() {
            let of = |c: usize| glow[c][x] + own[c][x] + tint[c][x] * light[c][x];
            *pixel += Rgb::new(of(0), of(1), of(2));
        }
    }

    /// What a pixel shows of a layer by its one sample.
    fn shown(&self, seen: &Seen, layer: usize, x: u32, y: u32) -> Rgb {
        let at = seen.index(x, y);
        let of = |first: usize| seen.color(first, at);
        of(emission(layer)) + of(rest(layer)) + of(TINT) * self.at(layer, x, y)
    }

    fn at(&self, layer: usize, x: u32, y: u32) -> Rgb {
        let channel = |c: usize| self.values[self.row(3 * layer + c, y) + x as usize];
        Rgb::new(channel(0), channel(1), channel(2))
    }

    /// A pixel of a plane between its neighbours.
    fn three(&self, plane: usize, x: u32, y: u32) -> &[f32] {
        let at = self.row(plane, y) + x as usize;
        &self.values[at - 1..at + 2]
    }

    /// Whether surfaces meet at a pixel.
    fn edge(&self, x: u32, y: u32) -> bool {
        self.values[self.row(3 * self.layers, y) + x as usize] > 0.0
    }

    /// Where the first pixel of a row lies, of one of the planes.
    fn row(&self, plane: usize, y: u32) -> usize {
        ((y - self.top) as usize * (3 * self.layers + 1) + plane) * self.stride + MARGIN
    }
}

/// The box filter of one row of the picture.
struct Row<'a> {
    seen: &'a Seen,
    y: u32,
    /// Neighbours to each side that may count, in x and y.
    reach: [i32; 2],
    /// Whether somebody asks where surfaces meet.
    edges: bool,
    layers: usize,
    /// Where it goes, as in [`Smooth`].
    values: &'a mut [f32],
}

impl Wide for Row<'_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        let Row { seen, y, reach, edges, layers, values } = self;
        let (start, stride) = (seen.index(0, y), seen.stride());
        let mut near = Near::none();
        for x in (0..seen.width as usize).step_by(LANES) {
            let to = MARGIN + x;
            let mut plane = |number: usize, found: &[f32; LANES]| {
                values[number * stride + to..][..LANES].copy_from_slice(found);
            };
            near.find(seen, start + x, reach, edges);
            for layer in 0..layers {
                for (channel, tint) in near.tint.iter().enumerate() {
                    plane(3 * layer + channel, &near.light(seen, lit(layer) + channel, tint));
                }
            }
            plane(3 * layers, &near.edge);
        }
    }
}

/// Most pixels that a box may hold.
const MOST: usize = 81;

/// The neighbours of sixteen pixels.
struct Near {
    /// Where the neighbours of the first lie, as many as the box holds.
    at: [usize; MOST],
    count: usize,
    /// 1 where a pixel shares light with that neighbour, else 0.
    shares: [[f32; LANES]; MOST],
    /// What all of those reflect, by channel.
    tint: [[f32; LANES]; 3],
    /// 1 beside another surface.
    edge: [f32; LANES],
}

impl Near {
    /// Of no pixels yet.
    fn none() -> Near {
        Near {
            at: [0; MOST],
            count: 0,
            shares: [[0.0; LANES]; MOST],
            tint: [[0.0; LANES]; 3],
            edge: [0.0; LANES],
        }
    }

    /// Those of sixteen pixels from `at` on.
    #[inline(always)]
    fn find(&mut self, seen: &Seen, at: usize, [wide, high]: [i32; 2], edges: bool) {
        let own = |plane: usize| load(&seen.planes[plane], at);
        let (px, py, pz) = (own(POSITION), own(POSITION + 1), own(POSITION + 2));
        let (nx, ny, nz) = (own(NORMAL), own(NORMAL + 1), own(NORMAL + 2));
        let (slack, alike) = (own(SLACK), own(ALIKE));
        (self.count, self.tint, self.edge) = (0, [[0.0; LANES]; 3], [0.0; LANES]);
        for dy in -high..=high {
            for dx in -wide..=wide {
                let there = at.wrapping_add_signed(dy as isize * seen.stride() as isize + dx as isize);
                let of = |plane: usize| load(&seen.planes[plane], there);
                let (qx, qy, qz) = (of(POSITION), of(POSITION + 1), of(POSITION + 2));
                let (mx, my, mz) = (of(NORMAL), of(NORMAL + 1), of(NORMAL + 2));
                let far = dx.abs().max(dy.abs()) as f32;
                let mut counts = [0.0; LANES];
                for k in 0..LANES {
                    let facing = nx[k] * mx[k] + ny[k] * my[k] + nz[k] * mz[k];
                    let off = (qx[k] - px[k]) * nx[k] + (qy[k] - py[k]) * ny[k] + (qz[k] - pz[k]) * nz[k];
                    let same = (facing > FACING) & (off.abs() <= slack[k] * far);
                    counts[k] = if same { 1.0 } else { 0.0 };
                }
                if edges && far <= 1.0 {
                    let other = of(ALIKE);
                    for k in 0..LANES {
                        let meet = (other[k] != alike[k]) | (counts[k] == 0.0);
                        self.edge[k] = if meet { 1.0 } else { self.edge[k] };
                    }
                }
                for (channel, tint) in self.tint.iter_mut().enumerate() {
                    let reflects = of(TINT + channel);
                    for k in 0..LANES {
                        tint[k] += counts[k] * reflects[k];
                    }
                }
                (self.at[self.count], self.shares[self.count]) = (there, counts);
                self.count += 1;
            }
        }
    }

    /// The light of one plane that they share, over what they reflect.
    #[inline(always)]
    fn light(&self, seen: &Seen, plane: usize, tint: &[f32; LANES]) -> [f32; LANES] {
        let mut light = [0.0; LANES];
        for (there, shares) in self.at[..self.count].iter().zip(&self.shares) {
            let lit = load(&seen.planes[plane], *there);
            for k in 0..LANES {
                light[k] += shares[k] * lit[k];
            }
        }
        for k in 0..LANES {
            light[k] = if tint[k] > 0.0 { light[k] / tint[k] } else { 0.0 };
        }
        light
    }
}

/// Least cosine between the normals of neighbours that share light.
const FACING: f32 = 0.9;
