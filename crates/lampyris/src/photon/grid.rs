//! Photons in a hash grid [Wald et al. 2002]: cells as wide as the kernel, sorted by counting, and a density estimate
//! from the eight cells nearest to a point.

use super::Photon;
use crate::color::Rgb;
use crate::material::Class;
use crate::world::Surface;
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::{FRAC_1_PI, PI};

/// Fewest buckets; the steps between rows of cells are chosen for multiples of it.
const BUCKETS: usize = 16;

/// Buckets from a cell to the next along y and z. Along x it is one, so that two cells are one run of photons. Modulo 16
/// the steps are 3 and 9: the sums ±1 ± 3 ± 9 and their parts lie within ±13, so no two of eight neighbours share a
/// bucket, and no photon is found twice.
const STEPS: [u32; 2] = [0x9e37_79b3, 0x85eb_ca69];

/// Cosine between the normals of photon and receiver from which on they lie on one surface.
const SAME_SIDE: f32 = 0.7;

/// Distance of a photon from the receiver's plane, in kernel radii, up to which it lies on the same surface.
const SAME_PLANE: f32 = 0.25;

/// Photons sorted by cell.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Of the kernel [m].
    radius: f32,
    per_cell: f32,
    /// The corner that cells are counted from.
    origin: Vec3,
    /// The box around all photons.
    extent: [Vec3; 2],
    mask: u32,
    /// Where each bucket begins in `photons`; one more at the end.
    starts: Vec<u32>,
    photons: Vec<Photon>,
}

impl Grid {
    /// Sorts photons for a kernel of `radius` [m]. Cells are counted from `origin`, which lies below and beside everything:
    /// in what order photons are found depends on nothing but those that are found.
    pub fn new(photons: Vec<Photon>, origin: Vec3, radius: f32) -> Grid {
        let nothing = || [Vec3::INFINITY, Vec3::NEG_INFINITY];
        let union = |[lo, hi]: [Vec3; 2], [low, high]: [Vec3; 2]| [lo.min(low), hi.max(high)];
        let extent = photons.par_iter().map(|p| [p.position; 2]).reduce(nothing, union);
        // Several for each photon: few cells share one, and a query looks at few photons from elsewhere.
        let buckets = (4 * photons.len()).next_power_of_two().max(BUCKETS);
        let mut grid = Grid {
            radius,
            per_cell: 0.5 / radius,
            origin,
            extent,
            mask: buckets as u32 - 1,
            starts: vec![0; buckets + 1],
            photons: Vec::new(),
        };
        let keys: Vec<u32> = photons.par_iter().map(|p| grid.bucket(grid.cell(p.position, 0.0))).collect();
        for key in &keys {
            grid.starts[*key as usize + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut grid.starts {
            sum += *start;
            *start = sum;
        }
        // Each bucket is filled in the order of the photons: the sum of a query does not depend on anything else.
        let mut next = grid.starts.clone();
        let mut order = vec![0_u32; photons.len()];
        for (k, key) in (0..).zip(&keys) {
            let place = &mut next[*key as usize];
            order[*place as usize] = k;
            *place += 1;
        }
        grid.photons = order.par_iter().map(|k| photons[*k as usize]).collect();
        grid
    }

    /// Of the kernel [m].
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// All photons, by bucket.
    pub fn photons(&self) -> &[Photon] {
        &self.photons
    }

    /// Radiance that the dull lobes of `x` send toward its `wo` of the light that the photons around it brought, each by
    /// itself with its emitter [cd/m²]: f_r Φ k(d/r)/(πr²) with Epanechnikov's kernel k = 2 (1 − d²/r²).
    pub fn radiance(&self, x: &Surface<'_>, mut add: impl FnMut(u32, Rgb)) {
        match x.finish.lambertian {
            Some(rho) => {
                let rho = rho * FRAC_1_PI;
                self.irradiance(x.position, x.normal, |emitter, light| add(emitter, rho * light));
            }
            None => self.near(x.position, x.normal, |p, weight| {
                add(p.emitter, x.eval(Class::Dull, x.wo, p.wi) * p.flux * weight);
            }),
        }
    }

    /// Illuminance of the side of a surface that `normal` points to, photon by photon with its emitter [lx].
    pub fn irradiance(&self, x: Vec3, normal: Vec3, mut add: impl FnMut(u32, Rgb)) {
        self.near(x, normal, |p, weight| {
            if p.normal.dot(normal) > 0.0 {
                add(p.emitter, p.flux * weight);
            }
        });
    }

    /// Calls `take` with each photon within the radius that lies on the surface of `normal` at `x`, on either side of
    /// it, and its weight k/(πr²) [m⁻²].
    fn near(&self, x: Vec3, normal: Vec3, mut take: impl FnMut(&Photon, f32)) {
        let [low, high] = self.extent;
        let r = self.radius;
        if x.cmplt(low - r).any() || x.cmpgt(high + r).any() {
            return;
        }
        let scale = 2.0 / (PI * r * r);
        let per_square = 1.0 / (r * r);
        let [i, j, k] = self.cell(x, 0.5);
        for row in 0..4 {
            let start = self.bucket([i, j.wrapping_add(row & 1), k.wrapping_add(row >> 1)]) as usize;
            let next = (start + 1) & self.mask as usize;
            // The two cells of a row are neighbours in the list, save where it ends.
            let runs =
                if next > start { [start..next + 1, 0..0] } else { [start..start + 1, next..next + 1] };
            for run in runs.into_iter().filter(|run| !run.is_empty()) {
                for p in &self.photons[self.starts[run.start] as usize..self.starts[run.end] as usize] {
                    let d = p.position - x;
                    let away = 1.0 - d.length_squared() * per_square;
                    if away > 0.0
                        && d.dot(normal).abs() <= SAME_PLANE * r
                        && p.normal.dot(normal).abs() >= SAME_SIDE
                    {
                        take(p, scale * away);
                    }
                }
            }
        }
    }

    /// The cell of a point, or of the point that lies `before` cells before it on each axis. Cells are counted from one
    /// cell below the origin.
    fn cell(&self, p: Vec3, before: f32) -> [u32; 3] {
        let at = (p - self.origin) * self.per_cell + (1.0 - before);
        at.to_array().map(|c| c as u32)
    }

    fn bucket(&self, [i, j, k]: [u32; 3]) -> u32 {
        let row = j.wrapping_mul(STEPS[0]).wrapping_add(k.wrapping_mul(STEPS[1]));
        i.wrapping_add(row) & self.mask
    }
}
