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

/// R_i is at most so many times the least of the distances.
const OPEN: f32 = 2.0;

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

    /// Harmonic mean of the distances [m], but at most twice the least: of what is narrow the mean does not know, the floor before
    /// a step for one, and light changes beside it all the same. Infinite where nothing is met.
    pub(super) fn distance(&self) -> f32 {
        let mean = self.near.len() as f32 / self.near.iter().sum::<f32>();
        mean.min(OPEN / self.near.iter().copied().fold(0.0, f32::max))
    }

    /// The light of one group. What is nearer than `least` [m] counts as if it were there: over such a way its edge would have
    /// passed.
    pub(super) fn light(&self, group: usize, least: f32) -> Light {
        let (rings, sectors) = (self.cells.tangents.len(), self.cells.sectors.len());
        let at = |j: usize, k: usize| {
            let cell = j * sectors + k;
            (self.radiance[cell * self.groups + group], self.near[cell])
        };
        // How the light changes from one cell to the next, by the nearer of the two.
        let edge = |(light, near): (Rgb, f32), (before, near_before): (Rgb, f32)| {
            (light - before) * near.max(near_before).min(1.0 / least)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::uniform;

    /// A window of one brightness in the plane z = 2, between x = ±1 and y = ±½, over ground that is black.
    const HALF: [f32; 2] = [1.0, 0.5];
    const HEIGHT: f32 = 2.0;

    fn window(from: Vec3) -> impl FnMut(Vec3, &mut [Rgb]) -> f32 {
        move |direction, out| {
            let t = (HEIGHT - from.z) / direction.z;
            let at = from + direction * t;
            if t > 0.0 && at.x.abs() < HALF[0] && at.y.abs() < HALF[1] {
                out[0] = Rgb::new(1.0, 2.0, 0.0);
                return 1.0 / t;
            }
            0.0
        }
    }

    /// Irradiance by that window: the sum over its edges of the angle that each spans, along its normal
    /// (Lambert's formula for polygons).
    fn exact(at: Vec3, normal: Vec3) -> f64 {
        let corner =
            |x: f32, y: f32| (Vec3::new(x * HALF[0], y * HALF[1], HEIGHT) - at).as_dvec3().normalize();
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let edges = (0..4).map(|k| [corners[k], corners[(k + 1) % 4]]);
        let of =
            |[a, b]: [glam::DVec3; 2]| libm::acos(a.dot(b)) * a.cross(b).normalize().dot(normal.as_dvec3());
        0.5 * edges.map(of).sum::<f64>()
    }

    fn light(rays: u32, at: Vec3, normal: Vec3) -> Light {
        let cells = Cells::of(rays);
        let jitter = |cell| [0, 1].map(|d| uniform(5, cell as u32, d));
        Hemisphere::look(&cells, normal, 1, jitter, window(at)).light(0, 0.0)
    }

    /// Places beneath and beside the window, and normals that see all of it.
    fn places() -> impl Iterator<Item = (Vec3, Vec3)> {
        let places = [(0.0, 0.0), (0.7, 0.2), (-1.4, 0.6), (2.0, -1.0)];
        let normals = [Vec3::Z, Vec3::new(0.3, -0.2, 1.0).normalize()];
        places.into_iter().flat_map(move |(x, y)| normals.map(|n| (Vec3::new(x, y, 0.0), n)))
    }

    #[test]
    fn gradients_are_those_of_a_window_in_closed_form() {
        for (at, normal) in places() {
            let light = light(1 << 20, at, normal);
            let e = exact(at, normal);
            let off = f64::from(light.irradiance.r) / e - 1.0;
            assert!(off.abs() < 2e-3, "{at} {normal}: {off}");
            let frame = Frame::new(normal);
            for axis in [frame.s, frame.t] {
                let difference = |f: &dyn Fn(f32) -> f64| (f(1e-2) - f(-1e-2)) / 2e-2;
                let moved = difference(&|h| exact(at + axis * h, normal));
                let turned = difference(&|h| exact(at, (normal + axis.cross(normal) * h).normalize()));
                let along = |g: [Rgb; 3], c: usize| f64::from(Vec3::from_array(g.map(|g| g[c])).dot(axis));
                for (channel, times) in [(0, 1.0), (1, 2.0), (2, 0.0)] {
                    let [of_move, of_turn] = [light.moved, light.turned].map(|g| along(g, channel));
                    assert!(
                        (of_move - times * moved).abs() < 0.02 * e,
                        "{at} {normal} {axis}: {of_move} {moved}"
                    );
                    assert!(
                        (of_turn - times * turned).abs() < 0.01 * e,
                        "{at} {normal} {axis}: {of_turn} {turned}"
                    );
                }
            }
        }
    }

    /// Under a bright half of the sky E = π/2, and a turn toward it gains ½ ∫ sin² θ dθ dφ = π/2 as well.
    #[test]
    fn a_half_lit_sky_turns_by_as_much_as_it_lights() {
        for rays in [64, 126, 1000] {
            let cells = Cells::of(rays);
            assert!((rays as usize..rays as usize + 20).contains(&cells.count()));
            let normal = Vec3::new(0.36, 0.48, 0.8);
            let frame = Frame::new(normal);
            let sky = |direction: Vec3, out: &mut [Rgb]| {
                out[1] = if direction.dot(frame.t) > 0.0 { Rgb::WHITE } else { Rgb::BLACK };
                0.0
            };
            let seen = Hemisphere::look(&cells, normal, 2, |_| [0.5; 2], sky);
            let [dark, light] = [0, 1].map(|group| seen.light(group, 0.0));
            assert!(dark.irradiance.is_black() && dark.turned.iter().all(|g| g.is_black()));
            let half = std::f32::consts::FRAC_PI_2;
            // A sector more or less lies on the border: π/N of the light, π²/2N of the gradient.
            let step = 1.0 / cells.sectors.len() as f32;
            assert!((light.irradiance.g / half - 1.0).abs() < 1.2 * step, "{}", light.irradiance.g);
            let turned = Vec3::from_array(light.turned.map(|g| g.g));
            let toward = normal.cross(frame.t);
            assert!((turned.dot(toward) / half - 1.0).abs() < 2.0 * step, "{turned} {toward}");
            assert!(turned.dot(frame.t).abs() < 5.0 * step && turned.dot(normal).abs() < 1e-4, "{turned}");
            assert!(light.moved.iter().all(|g| g.is_black()), "what is endlessly far away does not pass");
            assert_eq!(seen.distance(), f32::INFINITY);
        }
    }

    /// Even light has no gradient, whatever the distances; and these have a harmonic mean, or the bound by the least.
    #[test]
    fn even_light_does_not_change() {
        let cells = Cells::of(126);
        let distance = |k: usize| if k == 0 { 0.75 } else { 1.0 + (k % 3) as f32 };
        let mut k = 0;
        let seen = Hemisphere::look(
            &cells,
            Vec3::Y,
            1,
            |_| [0.3, 0.8],
            |_, out| {
                out[0] = Rgb::grey(0.7);
                k += 1;
                1.0 / distance(k - 1)
            },
        );
        let light = seen.light(0, 0.0);
        assert!((light.irradiance.r / (0.7 * PI) - 1.0).abs() < 1e-5);
        let largest =
            light.turned.iter().chain(&light.moved).map(|g| g.max_channel().abs()).fold(0.0, f32::max);
        assert!(largest < 1e-5, "{largest}");
        let count = cells.count();
        let mean = count as f32 / (0..count).map(|k| 1.0 / distance(k)).sum::<f32>();
        assert!(mean > 1.5, "the nearest bounds it");
        assert!((seen.distance() - 1.5).abs() < 1e-5, "{}", seen.distance());
    }
}
