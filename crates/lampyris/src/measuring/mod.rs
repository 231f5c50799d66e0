//! Measuring as lighting designers do: what an instrument of each kind reads, points spread over a surface, and what is said
//! of all of them together. Meters go into [`crate::eye::Eye::Meters`]; what they read comes back as numbers.

mod fit;
mod grid;
mod seen;
mod statistics;
mod targets;

pub use fit::Fit;
pub use grid::{BORDER, Grid, MOST, Rectangle, spacing};
pub use seen::{illuminance, is_readable, readable, receivers};
pub use statistics::{Estimate, Statistics, Verdict};
pub use targets::{TARGETS, Target};

use crate::eye::Meter;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::f32::consts::TAU;

/// Lux in a footcandle, which is one lumen on a square foot of 0.3048² m².
pub const FOOTCANDLE: f64 = 1.0 / (0.3048 * 0.3048);

/// What an instrument at a point takes in.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Kind {
    /// Illuminance of the surface that it lies on.
    Surface {
        /// Unit normal of the side that is lit.
        normal: Vec3,
    },
    /// Illuminance of a level plane, from above.
    Horizontal,
    /// Illuminance of an upright plane.
    Vertical {
        /// Where it faces; its upright part does not count.
        toward: Vec3,
    },
    /// Mean illuminance of an upright cylinder, as a face among people has it.
    Cylindrical,
    /// Illuminance of a plane that faces a point, as the eye of a camera.
    Toward {
        /// The point [m].
        eye: Vec3,
    },
}

/// Upright planes that stand for a cylinder. Their number is odd: then light from one direction comes out as that of twice
/// as many, 1 % too low to 0.5 % too high.
const SIDES: u32 = 9;

impl Kind {
    /// The plain meters that stand for an instrument at `position`, in a scene with this upward direction; what it reads is
    /// the mean of theirs. None where it faces nowhere.
    pub fn meters(self, position: Vec3, up: Vec3) -> Vec<Meter> {
        let up = up.normalize_or(Vec3::Z);
        let facing =
            |normal: Option<Vec3>| normal.map(|normal| Meter { position, normal }).into_iter().collect();
        match self {
            Kind::Surface { normal } => facing(normal.try_normalize()),
            Kind::Horizontal => facing(Some(up)),
            Kind::Vertical { toward } => facing(level(toward, up)),
            Kind::Toward { eye } => facing((eye - position).try_normalize()),
            Kind::Cylindrical => {
                let x = up.any_orthonormal_vector();
                let y = up.cross(x);
                let normal = |k: u32| {
                    let (sine, cosine) = libm::sincosf(TAU * k as f32 / SIDES as f32);
                    x * cosine + y * sine
                };
                (0..SIDES).map(|k| Meter { position, normal: normal(k) }).collect()
            }
        }
    }

    /// What an instrument reads whose meters read this: their mean. Meters at one point err alike, since they see the same
    /// light paths, so their errors are not taken to cancel.
    pub fn reading(meters: &[Estimate]) -> Estimate {
        Statistics::of(meters, 1.0).map_or(Estimate { value: 0.0, error: None }, |statistics| statistics.mean)
    }
}

/// A direction without its upright part.
fn level(direction: Vec3, up: Vec3) -> Option<Vec3> {
    let flat = direction - up * direction.dot(up);
    // What is left of a direction that points straight up is rounding.
    let enough = flat.length_squared() > 1e-8 * direction.length_squared();
    flat.try_normalize().filter(|_| enough)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A single far source above a meter: what each kind makes of it is a cosine.
    #[test]
    fn kinds_weigh_directions_as_they_should() {
        let up = Vec3::new(0.0, 1.0, 0.0);
        let at = Vec3::new(3.0, 1.0, 2.0);
        for k in 0..200 {
            let around = k as f32 * 0.1;
            let height = -0.9 + 0.009 * k as f32;
            let flat = (1.0 - height * height).sqrt();
            let (sine, cosine) = libm::sincosf(around);
            let toward = Vec3::new(flat * cosine, height, flat * sine);
            let read = |kind: Kind| {
                let meters = kind.meters(at, up);
                assert!(meters.iter().all(|m| m.position == at && (m.normal.length() - 1.0).abs() < 1e-5));
                meters.iter().map(|m| m.normal.dot(toward).max(0.0)).sum::<f32>() / meters.len() as f32
            };
            let close = |a: f32, b: f32, off: f32| assert!((a - b).abs() <= off, "{a} {b}");
            close(read(Kind::Horizontal), height.max(0.0), 1e-5);
            close(read(Kind::Surface { normal: toward * 3.0 }), 1.0, 1e-5);
            close(read(Kind::Toward { eye: at + toward * 7.0 }), 1.0, 1e-5);
            close(read(Kind::Vertical { toward }), flat, 1e-5);
            let cylinder = flat / std::f32::consts::PI;
            close(read(Kind::Cylindrical), cylinder, 0.0103 * cylinder);
        }
        assert!(Kind::Vertical { toward: up * 5.0 }.meters(at, up).is_empty());
        assert!(Kind::Toward { eye: at }.meters(at, up).is_empty());
        assert!(Kind::Surface { normal: Vec3::ZERO }.meters(at, up).is_empty());
        assert!((FOOTCANDLE - 10.763_910_4).abs() < 1e-7);
    }
}
