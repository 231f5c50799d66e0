//! A point whose irradiance is known, and what it says of others [Ward et al. 1988].

use super::hemisphere::{Hemisphere, Light};
use crate::color::Rgb;
use glam::Vec3;
use std::f32::consts::SQRT_2;

/// How far below a record's surface a point may lie and still be lit by what the record sees [reaches of the record].
const BELOW: f32 = 0.002;

/// Light at its own place counts as if it were found so far from it [R]: a weight without end is none.
const CLOSE: f32 = 1e-4;

/// A record without its light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// x_i [m].
    pub(super) position: Vec3,
    /// n_i, on the side that is lit.
    pub(super) normal: Vec3,
    /// R_i, the harmonic mean of the distances, within bounds [m].
    pub(super) distance: f32,
}

impl Record {
    /// Weight at a point, 1/(|x − x_i|/R_i + √(1 − n · n_i)) less the 1/a from which on it counts at all, so that it fades out
    /// [Ward et al. 1988]; `None` where it does not count, and where the record lies in front of the point: it may see what
    /// is hidden from there.
    pub(super) fn weight(&self, accuracy: f32, position: Vec3, normal: Vec3) -> Option<f32> {
        let way = position - self.position;
        let turn = (1.0 - normal.dot(self.normal)).max(0.0).sqrt();
        let off = way.length() / self.distance + turn;
        let below = -0.5 * way.dot(normal + self.normal);
        (off < accuracy && below <= BELOW * accuracy * self.distance)
            .then(|| 1.0 / off.max(CLOSE) - 1.0 / accuracy)
    }

    /// What a hemisphere tells of each group. Gradients are kept so small that within the record's reach none takes away more
    /// light than there is: the noise of the rays would make them steeper.
    pub(super) fn lights(&self, accuracy: f32, seen: &Hemisphere<'_>, groups: usize) -> Vec<Light> {
        let limited = |group| {
            let light = seen.light(group, accuracy * self.distance);
            let most = light.irradiance.map(|e| e.abs() / accuracy);
            // |n_i × n| ≤ √2 √(1 − n · n_i).
            let [turned, moved] =
                [(light.turned, SQRT_2), (light.moved, self.distance)].map(|(gradient, reach)| {
                    let length =
                        |channel: usize| Vec3::from_array(gradient.map(|g| g[channel])).length() * reach;
                    let scale =
                        |channel: usize| (most[channel] / length(channel).max(f32::MIN_POSITIVE)).min(1.0);
                    let scale = Rgb::new(scale(0), scale(1), scale(2));
                    gradient.map(|g| g * scale)
                });
            Light { turned, moved, ..light }
        };
        (0..groups).map(limited).collect()
    }
}
