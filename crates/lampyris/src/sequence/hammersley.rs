//! The Hammersley points: i/n, then the Halton sequence [Keller97, §4.1, Fig. 7].
//! They need n beforehand, and a prefix of them is not uniform: fit for pixel offsets, unfit to drive a walk.

use super::halton::{halton, jittered_halton};
use super::hash::{round_down, uniform};

/// Point i < n: i/n in dimension 0, Φ of the prime before it in the others.
pub fn hammersley(i: u32, n: u32, dimension: u32) -> f32 {
    match dimension {
        0 => round_down(f64::from(i % n) / f64::from(n)),
        d => halton(i, d - 1),
    }
}

/// As [`hammersley`], each point moved at random within its raster cell [Keller97, §4.1].
pub fn jittered_hammersley(i: u32, n: u32, dimension: u32, seed: u32) -> f32 {
    match dimension {
        0 => round_down((f64::from(i % n) + f64::from(uniform(seed, i, u32::MAX))) / f64::from(n)),
        d => jittered_halton(i, d - 1, n, seed),
    }
}
