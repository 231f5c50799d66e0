//! Edges deserve eye rays, not light rays: where surfaces meet within a pixel or beside it, further eye rays find which,
//! and borrow the light of neighbours on the same surface. A ray that finds no neighbour to borrow from is dropped.
//!
//! All looks at one pixel and at the next ones go in one packet: nothing is nearer to a look than another of the same pixel.

use super::seen::{NORMAL, POSITION, REST};
use super::{FACING, Seen, Smooth};
use crate::color::Rgb;
use crate::eye::{Eye, LANES, Packet, Rect, Sampling};
use crate::geometry::{Kernel, Wide, lane, sum_of_lanes};
use crate::sequence;
use crate::world::World;
use glam::Vec3;

/// Who looks again, and at what.
pub(super) struct Again<'a> {
    world: &'a World,
    eye: &'a Eye,
    first: &'a Sampling,
    /// With the first they make a lattice.
    further: Vec<Sampling>,
    seen: &'a Seen,
    smooth: &'a Smooth,
}

impl<'a> Again<'a> {
    /// So many further looks at each pixel where surfaces meet.
    pub(super) fn new(
        (world, eye): (&'a World, &'a Eye),
        first: &'a Sampling,
        further: u32,
        (seen, smooth): (&'a Seen, &'a Smooth),
    ) -> Again<'a> {
        Again { world, eye, first, further: further_looks(first, further), seen, smooth }
    }

    /// Makes what the pixels of row `y` show the mean of all looks; `row` already holds their first. Returns the rays it
    /// took.
    pub(super) fn refine(&self, y: u32, row: &mut [Rgb]) -> u64 {
        let Again { world, eye, first, further, seen, smooth } = self;
        let edges = (0..seen.width).filter(|x| smooth.edge[seen.index(*x, y)] > 0.0);
        let looks: Vec<(u32, &Sampling)> = edges.flat_map(|x| further.iter().map(move |s| (x, s))).collect();
        let rect = Rect { x: 0, y, width: seen.width, height: 1 };
        let kernel = world.tracer().kernel();
        let (mut mean, mut around) = (Mean::default(), Around::default());
        let mut rays = 0;
        for chunk in looks.chunks(LANES) {
            let column = |k: usize| chunk.get(k).map_or(u32::MAX, |look| look.0);
            let mut packet = Packet::new(world, rect, std::array::from_fn(column));
            let samplings = std::array::from_fn(|k| chunk.get(k).map_or(*first, |look| look.1));
            rays += eye.look_by(&samplings, &mut packet);
            for (k, (x, _)) in chunk.iter().enumerate() {
                let at = seen.index(*x, y);
                if mean.of != Some(*x) {
                    mean.close(row);
                    mean = Mean::of(*x, smooth.shown(seen, at));
                    around = Around::new(seen, smooth, at);
                }
                if let Some(reflected) = borrowed(kernel, &around, &packet, k) {
                    mean.add(packet.emission[k] + reflected + seen.color(REST, at));
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
#[derive(Default)]
struct Mean {
    /// Its column.
    of: Option<u32>,
    first: Rgb,
    sum: Rgb,
    count: f32,
}

impl Mean {
    fn of(column: u32, first: Rgb) -> Mean {
        Mean { of: Some(column), first, sum: first, count: 1.0 }
    }

    fn add(&mut self, look: Rgb) {
        self.sum += look;
        self.count += 1.0;
    }

    /// Puts it in the place of the first look.
    fn close(&self, row: &mut [Rgb]) {
        if let Some(x) = self.of {
            row[x as usize] += self.sum * (1.0 / self.count) - self.first;
        }
    }
}

/// What the nine pixels around an edge saw, side by side; the lanes left over face nowhere.
#[derive(Default)]
struct Around {
    position: [[f32; LANES]; 3],
    normal: [[f32; LANES]; 3],
    slack: [f32; LANES],
    light: [[f32; LANES]; 3],
}

impl Around {
    fn new(seen: &Seen, smooth: &Smooth, at: usize) -> Around {
        let mut around = Around::default();
        for row in 0..3 {
            let start = at + row * seen.stride() - seen.stride() - 1;
            let copy = |into: &mut [f32; LANES], plane: &[f32]| {
                into[3 * row..3 * row + 3].copy_from_slice(&plane[start..start + 3]);
            };
            for axis in 0..3 {
                copy(&mut around.position[axis], &seen.planes[POSITION + axis]);
                copy(&mut around.normal[axis], &seen.planes[NORMAL + axis]);
                copy(&mut around.light[axis], &smooth.light[axis]);
            }
            copy(&mut around.slack, &seen.planes[super::SLACK]);
        }
        around
    }
}

/// What the vertex of a lane reflects of the light of pixels around it that see its surface.
fn borrowed(kernel: Kernel, around: &Around, p: &Packet<'_>, k: usize) -> Option<Rgb> {
    if p.live >> k & 1 == 0 {
        return Some(Rgb::BLACK);
    }
    let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
    let light = kernel.run(Borrow { around, position, normal })?;
    Some(p.throughput[k] * p.reflectance[k] * light)
}

/// Irradiance over π at a point, as those agree on it that see its surface; `None` where nobody does.
struct Borrow<'a> {
    around: &'a Around,
    position: Vec3,
    normal: Vec3,
}

impl Wide for Borrow<'_> {
    type Out = Option<Rgb>;

    #[inline(always)]
    fn run(self) -> Option<Rgb> {
        let Borrow { around, position, normal } = self;
        let ([x, y, z], [nx, ny, nz]) = (&around.position, &around.normal);
        let mut same = [0.0; LANES];
        for k in 0..LANES {
            let facing = nx[k] * normal.x + ny[k] * normal.y + nz[k] * normal.z;
            let off = (x[k] - position.x) * normal.x
                + (y[k] - position.y) * normal.y
                + (z[k] - position.z) * normal.z;
            let sees = (facing > FACING) & (off.abs() <= 2.0 * around.slack[k]);
            same[k] = if sees { 1.0 } else { 0.0 };
        }
        let count = sum_of_lanes(&same);
        if count == 0.0 {
            return None;
        }
        let mean = |of: &[f32; LANES]| {
            let counted: [f32; LANES] = std::array::from_fn(|k| of[k] * same[k]);
            sum_of_lanes(&counted) / count
        };
        let [r, g, b] = &around.light;
        Some(Rgb::new(mean(r), mean(g), mean(b)))
    }
}
