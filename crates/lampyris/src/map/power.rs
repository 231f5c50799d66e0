//! Flux in four bytes: three mantissas and one exponent [Ward 1991], after [Keller96, §4.3], whose particles are kept so.
//!
//! The format truncates, which loses half a step of every particle; rounding to the nearest step would lose nothing on
//! average only if fluxes were all different, but photons of one lamp are alike, and all would err the same way. Here chance
//! rounds, up or down to the next step with the probabilities that make the mean exact. The numbers for it are the caller's.

use crate::color::Rgb;

/// What the stored exponent is ahead of that of the largest channel.
const BIAS: i32 = 127;

/// Largest and least magnitude that is kept; beyond, a channel is this or nothing.
const RANGE: [f32; 2] = [1e-34, 1e38];

/// Magnitudes of three channels: each to within 1/127 of the largest of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Power([u8; 4]);

impl Power {
    /// Largest error of a channel, in units of the largest channel.
    pub const ERROR: f32 = 1.0 / 127.0;

    /// Keeps magnitudes; numbers in [0, 1), uniform and independent, round each channel. What is not a number is nothing.
    pub fn new(channels: Rgb, round: [f32; 3]) -> Power {
        let sound = channels.map(|c| if c.is_nan() { 0.0 } else { c.abs().min(RANGE[1]) });
        let most = sound.max_channel();
        if most < RANGE[0] {
            return Power::default();
        }
        // The largest lies in [2^(e − 1), 2^e), and its mantissa must not be rounded up to 256.
        let e = (most.to_bits() >> 23) as i32 - 126;
        let e = if most * exp2(8 - e) > 255.0 { e + 1 } else { e };
        let scaled = sound * exp2(8 - e);
        let mantissa = |k: usize| (scaled[k] + round[k]).floor().min(255.0) as u8;
        Power([mantissa(0), mantissa(1), mantissa(2), (e + BIAS) as u8])
    }

    /// The magnitudes.
    pub fn channels(self) -> Rgb {
        let [r, g, b, e] = self.0;
        let step = if e == 0 { 0.0 } else { exp2(i32::from(e) - BIAS - 8) };
        Rgb::new(f32::from(r), f32::from(g), f32::from(b)) * step
    }
}

/// 2ⁿ where that is a normal number.
fn exp2(n: i32) -> f32 {
    f32::from_bits(((n + 127).clamp(1, 254) as u32) << 23)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: u32 = 64;

    fn values() -> impl Iterator<Item = Rgb> {
        (0..4000_u32).map(|k| {
            let scale = libm::powf(10.0, k as f32 * 0.0175 - 33.0);
            Rgb::new(1.0, 0.37 + 1e-4 * k as f32, 0.002 + 2e-4 * k as f32) * scale
        })
    }

    #[test]
    fn no_channel_errs_by_more_than_the_bound() {
        for v in values() {
            for step in 0..STEPS {
                let u = (step as f32 + 0.5) / STEPS as f32;
                let error = Power::new(v, [u, 0.0, 1.0 - f32::EPSILON / 2.0]).channels() - v;
                let worst = error.map(f32::abs).max_channel();
                assert!(worst <= Power::ERROR * v.max_channel(), "{v:?}: {error:?}");
            }
        }
    }

    /// Over all numbers that round, the mean is the value: its error is that of so many steps of u, 1/64 of a step in all.
    #[test]
    fn rounding_loses_nothing_in_the_mean() {
        for v in values() {
            let kept = |step: u32| {
                let u = (step as f32 + 0.5) / STEPS as f32;
                Power::new(v, [u, (u + 0.3) % 1.0, 1.0 - u]).channels()
            };
            let mean = (0..STEPS).fold(Rgb::BLACK, |sum, step| sum + kept(step) * (1.0 / STEPS as f32));
            let bound = v.max_channel() * (Power::ERROR / STEPS as f32 + 1e-6);
            assert!((mean - v).map(f32::abs).max_channel() <= bound, "{v:?}: {mean:?}");
        }
    }

    #[test]
    fn what_fits_is_exact_and_extremes_are_sound() {
        for m in 1..=255_u8 {
            for e in [-90, -3, 0, 20, 100] {
                let v = Rgb::new(255.0, f32::from(m), 0.0) * exp2(e);
                assert_eq!(Power::new(v, [0.999; 3]).channels(), v);
            }
        }
        assert_eq!(Power::new(Rgb::BLACK, [0.999; 3]).channels(), Rgb::BLACK);
        assert_eq!(Power::new(Rgb::grey(1e-36), [0.999; 3]).channels(), Rgb::BLACK);
        assert_eq!(Power::new(Rgb::grey(f32::NAN), [0.999; 3]).channels(), Rgb::BLACK);
        assert_eq!(Power::new(Rgb::new(-2.0, 1.0, 0.0), [0.0; 3]).channels(), Rgb::new(2.0, 1.0, 0.0));
        assert!(Power::new(Rgb::grey(f32::INFINITY), [0.999; 3]).channels().is_finite());
    }
}
