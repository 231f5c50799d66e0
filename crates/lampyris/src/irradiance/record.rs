//! A point whose irradiance is known, and what it says of others [Ward et al. 1988].

use super::hemisphere::{Hemisphere, Light};
use crate::color::Rgb;
use crate::world::Surface;
use glam::Vec3;
use std::f32::consts::SQRT_2;

/// How far off a record's plane a point of the same surface may lie by rounding [reaches of the record].
const PLANE: f32 = 0.002;

/// Light at its own place counts as if it were found so far from it [R]: a weight without end is none.
const CLOSE: f32 = 1e-4;

/// A point of a surface, on the side that the eye sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// x [m].
    pub(super) position: Vec3,
    /// n, the shading normal.
    pub(super) normal: Vec3,
    /// The geometric normal.
    pub(super) geometric: Vec3,
}

/// A record without its light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// x_i and n_i.
    pub(super) place: Place,
    /// R_i, how far away things are, within bounds [m].
    pub(super) distance: f32,
}

impl From<&Surface<'_>> for Place {
    fn from(x: &Surface<'_>) -> Place {
        let normal = if x.shading.dot(x.normal) >= 0.0 { x.shading } else { -x.shading };
        Place { position: x.position, normal, geometric: x.normal }
    }
}

impl Record {
    /// Weight at a point, 1/(|x − x_i|/R_i + √(1 − n · n_i)) less the 1/a from which on it counts at all, so that it fades out
    /// [Ward et al. 1988]. `None` where it does not count, and where the point lies above or below it, as far as the
    /// surface's own bend does not explain that: there each sees what is hidden from the other.
    pub(super) fn weight(&self, accuracy: f32, x: &Place) -> Option<f32> {
        let way = x.position - self.place.position;
        let turn = (1.0 - x.normal.dot(self.place.normal)).max(0.0).sqrt();
        let off = way.length() / self.distance + turn;
        if off >= accuracy {
            return None;
        }
        let [sum, bend] = [x.geometric + self.place.geometric, x.geometric - self.place.geometric];
        let height = 0.5 * way.dot(sum).abs();
        let flat = PLANE * accuracy * self.distance + 0.5 * way.length() * bend.length();
        (height <= flat).then(|| 1.0 / off.max(CLOSE) - 1.0 / accuracy)
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
