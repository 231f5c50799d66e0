//! A photon in twenty bytes [Jarosz05, §2.4.1; Keller96, §4.3]: where it lies to the last bit, what it carries to a per cent
//! and exactly in the mean, where it came from to 0.64°, and in a byte that the thesis leaves free which side of the surface
//! it lies on.

use super::direction::{CoarseNormal, Direction};
use super::power::Power;
use crate::color::Rgb;
use crate::sequence;
use glam::Vec3;

/// What happened to light before it came to lie somewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Past {
    /// Reflected by a dull lobe at least once: no direct light, and no caustic of a lamp.
    pub dull: bool,
    /// Reflected or refracted by a sharp lobe at last.
    pub sharp_last: bool,
    /// It would lie here, were nothing in its way.
    pub shadow: bool,
}

/// Light that came to a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    position: [f32; 3],
    power: Power,
    from: Direction,
    normal: CoarseNormal,
    flags: u8,
}

/// Where in the flags the signs of the three channels lie.
const SIGNS: u8 = 0;
const DULL: u8 = 1 << 3;
const SHARP_LAST: u8 = 1 << 4;
const SHADOW: u8 = 1 << 5;
/// Where the axis that the tree is split along lies.
const AXIS: u8 = 6;

impl Photon {
    /// Light of `flux` [lm] that came from the unit direction `wi` to the side of a surface that the unit `normal` points to.
    /// The place decides how the flux is rounded, so equal light gives equal bits.
    pub fn new(position: Vec3, normal: Vec3, wi: Vec3, flux: Rgb, past: Past) -> Photon {
        let seed = position.to_array().into_iter().fold(0, |seed, c| sequence::hash(seed, c.to_bits()));
        let round = [0, 1, 2].map(|k| sequence::unit_f32(sequence::hash(seed, k)));
        let bit = |set: bool, bit: u8| if set { bit } else { 0 };
        let signs: u8 =
            (0..3_u8).map(|k| bit(flux[usize::from(k)].is_sign_negative(), 1 << (SIGNS + k))).sum();
        let flags = bit(past.dull, DULL) | bit(past.sharp_last, SHARP_LAST) | bit(past.shadow, SHADOW);
        Photon {
            position: position.to_array(),
            power: Power::new(flux, round),
            from: wi.into(),
            normal: normal.into(),
            flags: signs | flags,
        }
    }

    /// Where it lies [m].
    #[inline]
    pub fn position(&self) -> Vec3 {
        self.position.into()
    }

    /// What it carries [lm], each channel to within [`Power::ERROR`] of the largest, and exact in the mean.
    #[inline]
    pub fn flux(&self) -> Rgb {
        let Rgb { r, g, b } = self.power.channels();
        let signed = |k: u8, c: f32| if self.flags >> (SIGNS + k) & 1 == 1 { -c } else { c };
        Rgb::new(signed(0, r), signed(1, g), signed(2, b))
    }

    /// Unit direction that it came from, to within [`Direction::ERROR`].
    #[inline]
    pub fn wi(&self) -> Vec3 {
        self.from.into()
    }

    /// The normal on the side that it came from, as far as it is kept.
    #[inline]
    pub fn normal(&self) -> CoarseNormal {
        self.normal
    }

    /// What happened to it before.
    pub fn past(&self) -> Past {
        let is = |bit: u8| self.flags & bit != 0;
        Past { dull: is(DULL), sharp_last: is(SHARP_LAST), shadow: is(SHADOW) }
    }

    /// The axis along which the tree is split at it.
    #[inline]
    pub(super) fn axis(&self) -> usize {
        usize::from(self.flags >> AXIS)
    }

    /// The same photon where the tree is split along an axis, 0 to 2.
    pub(super) fn splitting(self, axis: u8) -> Photon {
        Photon { flags: self.flags & ((1 << AXIS) - 1) | axis << AXIS, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_photon_is_twenty_bytes() {
        assert_eq!(size_of::<Photon>(), 20);
    }

    #[test]
    fn nothing_is_mixed_up() {
        for flags in 0..8_u8 {
            let past = Past { dull: flags & 1 != 0, sharp_last: flags & 2 != 0, shadow: flags & 4 != 0 };
            for signs in 0..8_u8 {
                let sign = |k: u8| if signs >> k & 1 == 1 { -1.0 } else { 1.0 };
                let flux = Rgb::new(128.0 * sign(0), 64.0 * sign(1), 3.0 * sign(2));
                let position = Vec3::new(1.0 + f32::EPSILON, -2e-30, 3e30);
                let wi = Vec3::new(0.6, -0.64, 0.48);
                for axis in 0..3 {
                    let p = Photon::new(position, Vec3::NEG_Y, wi, flux, past).splitting(2).splitting(axis);
                    assert_eq!((p.position(), p.flux(), p.past()), (position, flux, past));
                    assert_eq!((p.axis(), Vec3::from(p.normal())), (usize::from(axis), Vec3::NEG_Y));
                    assert!(p.wi().angle_between(wi) <= Direction::ERROR);
                }
            }
        }
    }

    /// The mean of what photons of equal flux keep is that flux: rounding by chance has a standard deviation of half a step
    /// at most, so the mean of 10⁵ errs by less than 4 · (1/256)/√10⁵ of the largest channel in all but 1 of 15 000 cases.
    #[test]
    fn many_equal_photons_carry_what_they_should() {
        const COUNT: u32 = 100_000;
        let flux = Rgb::new(0.001_234, -0.000_777, 0.000_05);
        let mut sum = [0.0_f64; 3];
        for k in 0..COUNT {
            let position = Vec3::new(k as f32 * 0.001, 0.3, (k % 317) as f32 * 0.01);
            let kept = Photon::new(position, Vec3::Y, Vec3::Y, flux, Past::default()).flux();
            (0..3).for_each(|c| sum[c] += f64::from(kept[c]));
        }
        for (c, sum) in sum.iter().enumerate() {
            let error = (sum / f64::from(COUNT) - f64::from(flux[c])).abs() / f64::from(flux.r);
            assert!(error < 4.0 / 256.0 / f64::from(COUNT).sqrt(), "channel {c}: {error}");
        }
    }
}
