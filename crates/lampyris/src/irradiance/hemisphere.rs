//! What a point sees by a hemisphere cut into cells of equal weight: irradiance, how it changes where the point is turned or
//! moved, and how far away things are in the harmonic mean [Ward and Heckbert 1992].
//!
//! Between the cells the light is taken to be of one value each, which ends at edges that stand still in space: a point that
//! moves sees the nearer one of two neighbours pass before the other. All sums have this one picture, that of a turning point
//! too: its cells count by the mean of tan θ in them, where the paper takes the tangent of each ray, which has no bound.

use crate::color::Rgb;
use crate::geometry::Frame;
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// M × N cells: rings from the zenith to the horizon, and sectors; what of their geometry the sums need.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// sin θ and cos θ of the circles that bound the rings, M + 1 of them.
    circles: Vec<[f32; 2]>,
    /// Mean of tan θ over each ring, as rays meet it.
    tangents: Vec<f32>,
    /// Unit vectors in the middle of the sectors, û, and where they begin.
    sectors: Vec<[Vec2; 2]>,
}

/// Light of one group, with its gradients along the world's axes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Light {
    /// E [lx].
    pub(super) irradiance: Rgb,
    /// ∇_r E, about each axis [lx]: light gained by a turn of one radian.
    pub(super) turned: [Rgb; 3],
    /// ∇_t E [lx/m].
    pub(super) moved: [Rgb; 3],
}

/// What rays through the cells found.
#[derive(Clone, Debug)]
pub(super) struct Hemisphere<'c> {
    cells: &'c Cells,
    frame: Frame,
    /// Light groups.
    groups: usize,
    /// 1/r of each cell, ring by ring [m⁻¹]; 0 where a ray met nothing.
    near: Vec<f32>,
    /// Radiance of each cell, group by group.
    radiance: Vec<Rgb>,
}

impl Cells {
    /// At least so many, about as wide as high: N ≈ π M.
    pub(super) fn of(rays: u32) -> Cells {
        let rings = ((rays as f32 / PI).sqrt().round() as usize).max(2);
        let sectors = (rays as usize).div_ceil(rings).max(3);
        let circle = |j: usize| {
            let s2 = j as f32 / rings as f32;
            [s2.sqrt(), (1.0 - s2).sqrt()]
        };
        let circles: Vec<[f32; 2]> = (0..=rings).map(circle).collect();
        // ∫ tan θ · 2 sin θ cos θ dθ = θ − sin θ cos θ, and a ring has 1/M of all rays.
        let up_to = |[sin, cos]: [f32; 2]| libm::atan2f(sin, cos) - sin * cos;
        let tangents = circles.windows(2).map(|two| rings as f32 * (up_to(two[1]) - up_to(two[0]))).collect();
        let unit = |turns: f32| {
            let (sin, cos) = libm::sincosf(TAU * turns / sectors as f32);
            Vec2::new(cos, sin)
        };
        let sectors = (0..sectors).map(|k| [unit(k as f32 + 0.5), unit(k as f32)]).collect();
        Cells { circles, tangents, sectors }
    }

    /// How many.
    pub(super) fn count(&self) -> usize {
        self.tangents.len() * self.sectors.len()
    }

    /// Unit direction about +z of a ray through a cell, by two numbers in [0, 1): θ = sin⁻¹ √((j + X)/M), φ = 2π (k + Y)/N
    /// [Ward and Heckbert 1992].
    fn direction(&self, cell: usize, [x, y]: [f32; 2]) -> Vec3 {
        let (rings, sectors) = (self.tangents.len(), self.sectors.len());
        let s2 = (((cell / sectors) as f32 + x) / rings as f32).min(1.0);
        let (sin, cos) = libm::sincosf(TAU * ((cell % sectors) as f32 + y) / sectors as f32);
        let r = s2.sqrt();
        Vec3::new(r * cos, r * sin, (1.0 - s2).sqrt())
    }
}

impl<'c> Hemisphere<'c> {
    /// Looks through all cells about a normal, in each by two `numbers` in [0, 1); `look` sets what comes from a direction,
    /// group by group [cd/m²], and returns 1/r of what it met.
    pub(super) fn look(
        cells: &'c Cells,
        normal: Vec3,
        groups: usize,
        numbers: impl Fn(usize) -> [f32; 2],
        mut look: impl FnMut(Vec3, &mut [Rgb]) -> f32,
    ) -> Hemisphere<'c> {
        let frame = Frame::new(normal);
        let mut radiance = vec![Rgb::BLACK; cells.count() * groups];
        let look = |cell| {
            let direction = frame.to_world(cells.direction(cell, numbers(cell)));
            look(direction, &mut radiance[cell * groups..(cell + 1) * groups])
        };
        let near = (0..cells.count()).map(look).collect();
        Hemisphere { cells, frame, groups, near, radiance }
    }

    /// Harmonic mean of the distances [m]; infinite where nothing is met.
    pub(super) fn distance(&self) -> f32 {
        self.near.len() as f32 / self.near.iter().sum::<f32>()
    }

    /// The light of one group.
    pub(super) fn light(&self, group: usize) -> Light {
        let (rings, sectors) = (self.cells.tangents.len(), self.cells.sectors.len());
        let at = |j: usize, k: usize| {
            let cell = j * sectors + k;
            (self.radiance[cell * self.groups + group], self.near[cell])
        };
        // How the light changes from one cell to the next, by the nearer of the two.
        let edge = |(light, near): (Rgb, f32), (before, near_before): (Rgb, f32)| {
            (light - before) * near.max(near_before)
        };
        let share = PI / (rings * sectors) as f32;
        let mut light = Light::default();
        for (k, [middle, start]) in self.cells.sectors.iter().enumerate() {
            let before = (k + sectors - 1) % sectors;
            let (mut ring, mut turn, mut inward, mut around) =
                (Rgb::BLACK, Rgb::BLACK, Rgb::BLACK, Rgb::BLACK);
            for j in 0..rings {
                let [[sin, cos], [sin_after, _]] = [self.cells.circles[j], self.cells.circles[j + 1]];
                ring += at(j, k).0;
                turn += at(j, k).0 * self.cells.tangents[j];
                if j > 0 {
                    inward += edge(at(j, k), at(j - 1, k)) * (sin * cos * cos);
                }
                around += edge(at(j, k), at(j, before)) * (sin_after - sin);
            }
            light.irradiance += ring * share;
            // v̂ = û turned by a right angle.
            self.add(&mut light.turned, middle.perp(), turn * share);
            self.add(&mut light.moved, *middle, inward * (TAU / sectors as f32));
            self.add(&mut light.moved, start.perp(), around);
        }
        light
    }

    /// Adds a vector in the surface's plane times a colour.
    fn add(&self, sum: &mut [Rgb; 3], direction: Vec2, factor: Rgb) {
        let world = (self.frame.s * direction.x + self.frame.t * direction.y).to_array();
        sum.iter_mut().zip(world).for_each(|(sum, along)| *sum += factor * along);
    }
}
