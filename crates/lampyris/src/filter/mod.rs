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
use seen::{ALIKE, EMISSION, LIT, NORMAL, POSITION, REST, SLACK, TINT, load};

/// Adds what a batch shows to `shown`, row by row of the picture: the light of `seen` filtered over boxes as wide as the
/// interleaving, with the settings' further eye rays where surfaces meet.
///
/// Returns the eye rays it took.
pub fn show(
    world: &World,
    eye: &Eye,
    settings: &Settings,
    sampling: &Sampling,
    seen: &Seen,
    shown: &mut [Rgb],
) -> u64 {
    let smooth = Smooth::new(world.tracer().kernel(), seen, settings.interleave);
    let again = Again::new((world, eye), sampling, settings.edges, (seen, &smooth));
    let width = seen.width as usize;
    let rows = shown.par_chunks_mut(width).enumerate();
    rows.map(|(y, row)| {
        for (x, pixel) in row.iter_mut().enumerate() {
            *pixel += smooth.shown(seen, seen.index(x as u32, y as u32));
        }
        again.refine(y as u32, row)
    })
    .sum()
}

/// Irradiance over π of every pixel, as its neighbours agree on it.
struct Smooth {
    /// Laid out as [`Seen`]; 0 where nothing is reflected.
    light: [Vec<f32>; 3],
    /// 1 where surfaces meet, row by row of the picture with margins.
    edge: Vec<f32>,
}

impl Smooth {
    fn new(kernel: Kernel, seen: &Seen, interleave: [u32; 2]) -> Smooth {
        let mut light = [0, 1, 2].map(|_| vec![0.0; seen.len()]);
        let mut edge = vec![0.0; seen.len()];
        let [red, green, blue] = &mut light;
        let rows = |plane| seen.rows_mut(plane);
        let reach = interleave.map(|n| n as i32 / 2);
        rows(red).zip(rows(green)).zip(rows(blue)).zip(rows(&mut edge)).enumerate().for_each(
            |(y, (((red, green), blue), edge))| {
                kernel.run(Row { seen, y: y as u32, reach, light: [red, green, blue], edge });
            },
        );
        Smooth { light, edge }
    }

    /// What a pixel shows by its one sample.
    fn shown(&self, seen: &Seen, at: usize) -> Rgb {
        let of = |first: usize| seen.color(first, at);
        of(EMISSION) + of(REST) + of(TINT) * self.at(at)
    }

    fn at(&self, at: usize) -> Rgb {
        Rgb::new(self.light[0][at], self.light[1][at], self.light[2][at])
    }
}

/// The box filter of one row of the picture.
struct Row<'a> {
    seen: &'a Seen,
    y: u32,
    /// Neighbours to each side that may count, in x and y.
    reach: [i32; 2],
    light: [&'a mut [f32]; 3],
    edge: &'a mut [f32],
}

impl Wide for Row<'_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        let Row { seen, y, reach, light: [red, green, blue], edge } = self;
        let start = seen.index(0, y);
        for x in (0..seen.width as usize).step_by(LANES) {
            let (light, uneven) = chunk(seen, start + x, reach);
            let at = seen.index(0, 0) % seen.stride() + x;
            red[at..at + LANES].copy_from_slice(&light[0]);
            green[at..at + LANES].copy_from_slice(&light[1]);
            blue[at..at + LANES].copy_from_slice(&light[2]);
            edge[at..at + LANES].copy_from_slice(&uneven);
        }
    }
}

/// Sixteen pixels from `at` on: their light, and 1 for those beside another surface.
#[inline(always)]
fn chunk(seen: &Seen, at: usize, reach: [i32; 2]) -> ([[f32; LANES]; 3], [f32; LANES]) {
    let own = |plane: usize| load(&seen.planes[plane], at);
    let (px, py, pz) = (own(POSITION), own(POSITION + 1), own(POSITION + 2));
    let (nx, ny, nz) = (own(NORMAL), own(NORMAL + 1), own(NORMAL + 2));
    let (slack, alike) = (own(SLACK), own(ALIKE));
    let mut light = [[0.0; LANES]; 3];
    let mut tint = [[0.0; LANES]; 3];
    let mut edge = [0.0; LANES];
    let [wide, high] = reach;
    for dy in -high..=high {
        for dx in -wide..=wide {
            let there = at.wrapping_add_signed(dy as isize * seen.stride() as isize + dx as isize);
            let of = |plane: usize| load(&seen.planes[plane], there);
            let (qx, qy, qz) = (of(POSITION), of(POSITION + 1), of(POSITION + 2));
            let (mx, my, mz) = (of(NORMAL), of(NORMAL + 1), of(NORMAL + 2));
            let other = of(ALIKE);
            let far = dx.abs().max(dy.abs()) as f32;
            let mut counts = [0.0; LANES];
            for k in 0..LANES {
                let facing = nx[k] * mx[k] + ny[k] * my[k] + nz[k] * mz[k];
                let off = (qx[k] - px[k]) * nx[k] + (qy[k] - py[k]) * ny[k] + (qz[k] - pz[k]) * nz[k];
                let same = facing > FACING && off.abs() <= slack[k] * far;
                counts[k] = if same { 1.0 } else { 0.0 };
                let beside = far <= 1.0 && !(same && other[k] == alike[k]);
                edge[k] = if beside { 1.0 } else { edge[k] };
            }
            for channel in 0..3 {
                let (lit, reflects) = (of(LIT + channel), of(TINT + channel));
                for k in 0..LANES {
                    light[channel][k] += counts[k] * lit[k];
                    tint[channel][k] += counts[k] * reflects[k];
                }
            }
        }
    }
    for (light, tint) in light.iter_mut().zip(&tint) {
        for k in 0..LANES {
            light[k] = if tint[k] > 0.0 { light[k] / tint[k] } else { 0.0 };
        }
    }
    (light, edge)
}

/// Least cosine between the normals of neighbours that share light.
const FACING: f32 = 0.9;
