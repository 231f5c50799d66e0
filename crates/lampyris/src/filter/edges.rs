//! Edges deserve eye rays, not light rays: where surfaces meet within a pixel or beside it, further eye rays find which,
//! and borrow the light of neighbours on the same surface. A ray that finds no neighbour to borrow from is dropped.
//!
//! All looks at one pixel and at the next ones go in one packet: nothing is nearer to a look than another of the same pixel.

use super::seen::{NORMAL, POSITION, SLACK, rest};
use super::{FACING, Filter, Seen, Smooth};
use crate::color::Rgb;
use crate::eye::{LANES, Packet, Rect, Sampling};
use crate::geometry::{Kernel, Wide, lane, sum_of_lanes};
use crate::sequence;
use glam::Vec3;

/// Who looks again, and at what.
pub(super) struct Again<'a> {
    filter: &'a Filter<'a>,
    /// With the first they make a lattice.
    further: Vec<Sampling>,
    seen: &'a Seen,
    smooth: &'a Smooth,
}

impl<'a> Again<'a> {
    pub(super) fn new(filter: &'a Filter<'a>, seen: &'a Seen, smooth: &'a Smooth) -> Again<'a> {
        Again { filter, further: further_looks(&filter.sampling, filter.settings.edges), seen, smooth }
    }

    /// Makes what the pixels of row `y` show the mean of all looks; `row`, of each layer, already holds their first. Returns
    /// the rays it took.
    pub(super) fn refine(&self, y: u32, row: &mut [&mut [Rgb]]) -> u64 {
        let Again { filter, further, seen, smooth } = self;
        let edges = (0..seen.width).filter(|x| smooth.edge(*x, y));
        let looks: Vec<(u32, &Sampling)> = edges.flat_map(|x| further.iter().map(move |s| (x, s))).collect();
        let rect = Rect { x: 0, y, width: seen.width, height: 1 };
        let kernel = filter.world.tracer().kernel();
        let mut mean = Mean::none(row.len());
        let mut around = Around::none(row.len());
        let mut rays = 0;
        let mut packet = Packet::new(filter.world);
        for chunk in looks.chunks(LANES) {
            packet.place(rect, std::array::from_fn(|k| chunk.get(k).map_or(u32::MAX, |look| look.0)));
            let samplings = std::array::from_fn(|k| chunk.get(k).map_or(&filter.sampling, |look| look.1));
            rays += filter.eye.look_by(&samplings, &mut packet);
            for (k, (x, _)) in chunk.iter().enumerate() {
                if mean.of != Some(*x) {
                    mean.close(row);
                    mean.begin(*x, |layer| smooth.shown(seen, layer, *x, y));
                    around.look(seen, smooth, *x, y);
                }
                let Some(shares) = around.shares(kernel, &packet, k) else { continue };
                let factor = packet.throughput[k] * packet.reflectance[k];
                mean.add(|layer| {
                    factor * around.light(layer, &shares) + seen.color(rest(layer), seen.index(*x, y))
                });
                for gleam in packet.gleams.iter().filter(|gleam| gleam.lane == k) {
                    if let Some((layer, tint)) = (filter.layer_of)(gleam.emitter) {
                        mean.sums[layer] += gleam.radiance * tint;
                    }
                }
            }
        }
        mean.close(row);
        rays
    }
}

fn further_looks(first: &Sampling, further: u32) -> Vec<Sampling> {
    let look = |number: u32| {
        let shift = |by: u32| (by * number) as f32 / (further + 1) as f32;
        let [u, v] = first.offset;
        let offset = [(u + shift(1)).fract(), (v + shift(2)).fract()];
        Sampling { offset, seed: sequence::hash(first.seed, number), ..*first }
    };
    (1..=further).map(look).collect()
}

/// What the looks at one pixel show in the mean.
struct Mean {
    /// Its column.
    of: Option<u32>,
    /// Of each layer.
    first: Vec<Rgb>,
    sums: Vec<Rgb>,
    count: f32,
}

impl Mean {
    /// Of no pixel yet, by the light of so many layers.
    fn none(layers: usize) -> Mean {
        Mean { of: None, first: vec![Rgb::BLACK; layers], sums: vec![Rgb::BLACK; layers], count: 0.0 }
    }

    fn begin(&mut self, column: u32, first: impl Fn(usize) -> Rgb) {
        (self.of, self.count) = (Some(column), 1.0);
        self.first.iter_mut().enumerate().for_each(|(layer, v)| *v = first(layer));
        self.sums.copy_from_slice(&self.first);
    }

    fn add(&mut self, look: impl Fn(usize) -> Rgb) {
        self.sums.iter_mut().enumerate().for_each(|(layer, sum)| *sum += look(layer));
        self.count += 1.0;
    }

    /// Puts the mean in the place of the first look.
    fn close(&self, row: &mut [&mut [Rgb]]) {
        if let Some(x) = self.of {
            for (row, (sum, first)) in row.iter_mut().zip(self.sums.iter().zip(&self.first)) {
                row[x as usize] += *sum * (1.0 / self.count) - *first;
            }
        }
    }
}

/// What the nine pixels around an edge saw, side by side; the lanes left over face nowhere.
struct Around {
    position: [[f32; LANES]; 3],
    normal: [[f32; LANES]; 3],
    slack: [f32; LANES],
    /// Of each layer.
    light: Vec<[[f32; LANES]; 3]>,
}

impl Around {
    /// Nothing yet, of so many layers.
    fn none(layers: usize) -> Around {
        let none = || [[0.0; LANES]; 3];
        Around { position: none(), normal: none(), slack: [0.0; LANES], light: vec![none(); layers] }
    }

    /// Looks at the nine pixels.
    fn look(&mut self, seen: &Seen, smooth: &Smooth, x: u32, y: u32) {
        let copy = |into: &mut [f32; LANES], row: usize, three: &[f32]| {
            into[3 * row..3 * row + 3].copy_from_slice(three);
        };
        for row in 0..3 {
            let start = seen.index(x, y) + row * seen.stride() - seen.stride() - 1;
            let of = |plane: usize| &seen.planes[plane][start..start + 3];
            for axis in 0..3 {
                copy(&mut self.position[axis], row, of(POSITION + axis));
                copy(&mut self.normal[axis], row, of(NORMAL + axis));
            }
            copy(&mut self.slack, row, of(SLACK));
            // Above and below the picture nothing is, and nobody asks.
            let Some(y) = (y + row as u32).checked_sub(1).filter(|y| *y < seen.height) else { continue };
            for (layer, light) in self.light.iter_mut().enumerate() {
                for (channel, light) in light.iter_mut().enumerate() {
                    copy(light, row, smooth.three(3 * layer + channel, x, y));
                }
            }
        }
    }

    /// What each of the nine has of the mean of those that see the surface of a lane's vertex; nothing where it has none,
    /// `None` where nobody sees it.
    fn shares(&self, kernel: Kernel, p: &Packet<'_>, k: usize) -> Option<[f32; LANES]> {
        if p.live >> k & 1 == 0 {
            return Some([0.0; LANES]);
        }
        let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
        let same = kernel.run(Same { around: self, position, normal });
        let count = sum_of_lanes(&same);
        (count > 0.0).then(|| same.map(|s| s / count))
    }

    /// Irradiance over π of a layer in that mean.
    fn light(&self, layer: usize, shares: &[f32; LANES]) -> Rgb {
        let mean = |channel: usize| {
            let light = &self.light[layer][channel];
            sum_of_lanes(&std::array::from_fn(|k| light[k] * shares[k]))
        };
        Rgb::new(mean(0), mean(1), mean(2))
    }
}

/// 1 for each of the nine pixels that sees the surface of a point, else 0.
struct Same<'a> {
    around: &'a Around,
    position: Vec3,
    normal: Vec3,
}

impl Wide for Same<'_> {
    type Out = [f32; LANES];

    #[inline(always)]
    fn run(self) -> [f32; LANES] {
        let Same { around, position, normal } = self;
        let ([x, y, z], [nx, ny, nz]) = (&around.position, &around.normal);
        std::array::from_fn(|k| {
            let facing = nx[k] * normal.x + ny[k] * normal.y + nz[k] * normal.z;
            let off = (x[k] - position.x) * normal.x
                + (y[k] - position.y) * normal.y
                + (z[k] - position.z) * normal.z;
            let sees = (facing > FACING) & (off.abs() <= 2.0 * around.slack[k]);
            if sees { 1.0 } else { 0.0 }
        })
    }
}
