//! Choosing before tracing: of many virtual lights, sixteen pixels trace the few that would give them most if nothing
//! stood between. What they would give is a few instructions, a ray is hundreds.
//!
//! A comb of n equal teeth lies over the running sum of the weights w_k, at random. Its teeth meet light k n w_k/Σw times in
//! the mean, and each meeting counts Σw/(n w_k): unbiased as long as whatever gives light has a weight, and without
//! variance where what is given is in proportion to it.

use crate::eye::{LANES, Packet};
use crate::geometry::{Kernel, Wide, sum_of_lanes};
use crate::particle::Beacon;
use glam::Vec3;

/// Lights that one comb goes over. A longer list is cut, and the teeth are shared out.
const RUN: usize = 512;

/// What a light shines through on its way to a point.
pub(super) trait Window {
    /// Where a light is, in coordinates of the window's own.
    fn place(&self, light: Vec3) -> Vec3;

    /// Whether point `k` of a packet may see a light at that place.
    fn may_show(&self, k: usize, light: Vec3) -> bool;
}

/// Nothing: all of it can be seen.
pub(super) struct Open;

impl Window for Open {
    #[inline(always)]
    fn place(&self, light: Vec3) -> Vec3 {
        light
    }

    #[inline(always)]
    fn may_show(&self, _: usize, _: Vec3) -> bool {
        true
    }
}

/// Calls `each` with the numbers of the lights that a packet traces, about `most` of them, and the factors that make them
/// stand for all; `u` in [0, 1) places the comb, and of less than one light decides whether there is any.
pub(super) fn pick(
    kernel: Kernel,
    p: &Packet<'_>,
    (beacons, window): (&[Beacon], &impl Window),
    most: f32,
    u: f32,
    mut each: impl FnMut(usize, f32),
) {
    let runs = beacons.len().div_ceil(RUN).max(1);
    let length = beacons.len().div_ceil(runs).max(1);
    let teeth = most / runs as f32;
    let points = Points::new(p);
    let mut weights = [0.0; RUN];
    for (number, run) in beacons.chunks(length).enumerate() {
        let weights = &mut weights[..run.len()];
        let total = kernel.run(Weigh { points: &points, run, window, weights });
        comb(weights, total, teeth, u, |k, factor| each(number * length + k, factor));
    }
}

/// [`pick`] for a single point that reflects light from the side of `normal`, or from both where it `transmits`. Of a long
/// list every n-th is weighed, from one that `u` chooses.
pub(super) fn pick_for_point(
    kernel: Kernel,
    (x, normal, transmits): (Vec3, Vec3, bool),
    beacons: &[Beacon],
    most: f32,
    u: f32,
    mut each: impl FnMut(usize, f32),
) {
    let step = beacons.len().div_ceil(RUN).max(1);
    let chosen = u * step as f32;
    let first = (chosen as usize).min(step - 1);
    let mut weights = [0.0; RUN];
    let weights = &mut weights[..beacons[first..].len().div_ceil(step)];
    let total = kernel.run(WeighForPoint { x, normal, transmits, beacons: &beacons[first..], step, weights });
    // The same number places the comb: what is left of it is uniform again.
    comb(weights, total, most, chosen.fract(), |k, factor| each(first + k * step, factor * step as f32));
}

/// Lays so many teeth, in the mean, over the running sum of weights, which is `total`.
fn comb(weights: &[f32], total: f32, teeth: f32, u: f32, mut each: impl FnMut(usize, f32)) {
    if !(total > 0.0 && total < f32::INFINITY) {
        return;
    }
    let gap = total / teeth;
    let (mut tooth, mut sum) = (u * gap, 0.0);
    for (k, weight) in weights.iter().enumerate() {
        sum += weight;
        let mut met = 0.0;
        while tooth < sum {
            met += 1.0;
            tooth += gap;
        }
        if met > 0.0 {
            each(k, met * gap / weight);
        }
    }
}

/// The points of a packet, and from which sides they can be lit.
#[repr(C, align(64))]
struct Points<'p, 'w> {
    /// 0 where light from behind is lost, −1 where it passes.
    behind: [f32; LANES],
    /// 1 where there is a point, else 0.
    live: [f32; LANES],
    packet: &'p Packet<'w>,
}

impl<'p, 'w> Points<'p, 'w> {
    fn new(packet: &'p Packet<'w>) -> Points<'p, 'w> {
        let of =
            |mask: u16, yes: f32, no: f32| std::array::from_fn(|k| if mask >> k & 1 == 1 { yes } else { no });
        Points { behind: of(packet.opaque, 0.0, -1.0), live: of(packet.live, 1.0, 0.0), packet }
    }
}

/// min(G, b) of a light at a point; `behind` as in [`Points`].
#[inline(always)]
fn bounded_term(beacon: &Beacon, x: Vec3, normal: Vec3, behind: f32) -> f32 {
    let d = beacon.position - x;
    let (cos_x, cos_y) = (d.dot(normal), -d.dot(beacon.normal));
    let d2 = d.length_squared();
    let passes = cos_x * behind;
    let cos_x = if cos_x > passes { cos_x } else { passes };
    let g = cos_x * cos_y / (d2 * d2);
    let bounded = if g < beacon.bound { g } else { beacon.bound };
    if cos_y > 0.0 && d2 > 0.0 { bounded } else { 0.0 }
}

/// What each light would give all points together through a window, but for visibility and what they are made of.
struct Weigh<'a, 'p, 'w, W: Window> {
    points: &'a Points<'p, 'w>,
    run: &'a [Beacon],
    window: &'a W,
    weights: &'a mut [f32],
}

impl<W: Window> Wide for Weigh<'_, '_, '_, W> {
    type Out = f32;

    #[inline(always)]
    fn run(self) -> f32 {
        let Points { behind, live, packet } = self.points;
        let ([x, y, z], [nx, ny, nz]) = (&packet.position, &packet.shading);
        let mut total = 0.0;
        for (weight, beacon) in self.weights.iter_mut().zip(self.run) {
            *weight = 0.0;
            if beacon.weight == 0.0 {
                continue;
            }
            let place = self.window.place(beacon.position);
            let mut terms = [0.0; LANES];
            for k in 0..LANES {
                let at = Vec3::new(x[k], y[k], z[k]);
                let term = bounded_term(beacon, at, Vec3::new(nx[k], ny[k], nz[k]), behind[k]);
                let may_show = self.window.may_show(k, place);
                terms[k] = if may_show { term * live[k] } else { 0.0 };
            }
            *weight = sum_of_lanes(&terms) * beacon.weight;
            total += *weight;
        }
        total
    }
}

/// What every n-th light would give one point, but for visibility and what the point is made of.
struct WeighForPoint<'a> {
    x: Vec3,
    normal: Vec3,
    transmits: bool,
    beacons: &'a [Beacon],
    step: usize,
    weights: &'a mut [f32],
}

impl Wide for WeighForPoint<'_> {
    type Out = f32;

    #[inline(always)]
    fn run(self) -> f32 {
        let behind = if self.transmits { -1.0 } else { 0.0 };
        let mut total = 0.0;
        for (weight, beacon) in self.weights.iter_mut().zip(self.beacons.iter().step_by(self.step)) {
            *weight = bounded_term(beacon, self.x, self.normal, behind) * beacon.weight;
            total += *weight;
        }
        total
    }
}
