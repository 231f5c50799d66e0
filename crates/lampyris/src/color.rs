//! The one colour space: linear Rec. 709 primaries with D65 white.
//! Radiance is in cd/m² per channel, flux in lm, so that Y = 0.2126 R + 0.7152 G + 0.0722 B is photometric.
//! Channels may be negative (colours outside the gamut) until a picture is displayed; nothing here clamps.

use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Div, Index, Mul, MulAssign, Neg, Sub};

/// Brightest that a light or surface may be [cd/m², cd or lx]: a hundred million suns, so that fluxes are still finite.
pub const BRIGHTEST: f32 = 1e18;

/// Three channels of linear light, or a reflectance per channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[repr(C)]
#[serde(deny_unknown_fields)]
pub struct Rgb {
    /// Rec. 709 red.
    pub r: f32,
    /// Rec. 709 green.
    pub g: f32,
    /// Rec. 709 blue.
    pub b: f32,
}

impl Rgb {
    /// No light.
    pub const BLACK: Rgb = Rgb::grey(0.0);
    /// Unit luminance at the white point.
    pub const WHITE: Rgb = Rgb::grey(1.0);

    /// From its channels.
    pub const fn new(r: f32, g: f32, b: f32) -> Rgb {
        Rgb { r, g, b }
    }

    /// The same value in each channel: a D65 grey of luminance `v`.
    pub const fn grey(v: f32) -> Rgb {
        Rgb { r: v, g: v, b: v }
    }

    /// Photometric luminance Y [unit of the channels].
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// The largest channel.
    pub fn max_channel(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }

    /// True where every channel is zero: nothing to add, no ray to trace.
    pub fn is_black(self) -> bool {
        self.r == 0.0 && self.g == 0.0 && self.b == 0.0
    }

    /// True where every channel is a finite number.
    pub fn is_finite(self) -> bool {
        self.r.is_finite() & self.g.is_finite() & self.b.is_finite()
    }

    /// Each channel through `f`.
    pub fn map(self, f: impl Fn(f32) -> f32) -> Rgb {
        Rgb::new(f(self.r), f(self.g), f(self.b))
    }

    /// The channels as an array.
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// From CIE 1931 chromaticity (x, y) relative to *equal-energy* white (as MGF means its colours) and luminance Y:
    /// adapted to D65 by Bradford, then scaled so that the luminance is exactly Y.
    ///
    /// The neutral x = y = 1/3 becomes `Rgb::grey(Y)`; saturated colours may leave the gamut and then have negative
    /// channels. Bradford alone would change Y of saturated colours by a few per cent, and with it a lamp's lumens.
    pub fn from_xy_e(x: f64, y: f64, luminance: f64) -> Rgb {
        // A colour on the line y = 0 has no luminance at all: keep the neutral rather than divide by zero.
        if y <= 0.0 {
            return Rgb::grey(luminance as f32);
        }
        let xyz = [x / y, 1.0, (1.0 - x - y) / y];
        let row = |m: [f64; 3]| m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2];
        let [r, g, b] = E_TO_REC709.map(row);
        let s = luminance / (0.2126 * r + 0.7152 * g + 0.0722 * b);
        Rgb::new((r * s) as f32, (g * s) as f32, (b * s) as f32)
    }
}

/// XYZ under equal-energy white → linear Rec. 709 under D65: (XYZ → RGB from the primaries) · (Bradford E → D65).
/// Each row sums to 1, so that the neutral keeps three equal channels.
const E_TO_REC709: [[f64; 3]; 3] = [
    [3.146_657_654_135_7, -1.666_463_754_510_8, -0.480_193_899_624_9],
    [-0.995_521_605_780_7, 1.955_756_733_809_1, 0.039_764_871_971_6],
    [0.063_594_802_938_8, -0.214_563_222_224_7, 1.150_968_419_285_9],
];

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, o: Rgb) -> Rgb {
        Rgb::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, o: Rgb) {
        *self = *self + o;
    }
}

impl Sub for Rgb {
    type Output = Rgb;
    fn sub(self, o: Rgb) -> Rgb {
        Rgb::new(self.r - o.r, self.g - o.g, self.b - o.b)
    }
}

impl Neg for Rgb {
    type Output = Rgb;
    fn neg(self) -> Rgb {
        Rgb::new(-self.r, -self.g, -self.b)
    }
}

impl Mul for Rgb {
    type Output = Rgb;
    fn mul(self, o: Rgb) -> Rgb {
        Rgb::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Rgb;
    fn mul(self, s: f32) -> Rgb {
        Rgb::new(self.r * s, self.g * s, self.b * s)
    }
}

impl MulAssign for Rgb {
    fn mul_assign(&mut self, o: Rgb) {
        *self = *self * o;
    }
}

impl MulAssign<f32> for Rgb {
    fn mul_assign(&mut self, s: f32) {
        *self = *self * s;
    }
}

impl Div<f32> for Rgb {
    type Output = Rgb;
    fn div(self, s: f32) -> Rgb {
        Rgb::new(self.r / s, self.g / s, self.b / s)
    }
}

impl Index<usize> for Rgb {
    type Output = f32;
    fn index(&self, i: usize) -> &f32 {
        match i {
            0 => &self.r,
            1 => &self.g,
            _ => &self.b,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_energy_neutral_is_grey() {
        let c = Rgb::from_xy_e(1.0 / 3.0, 1.0 / 3.0, 0.7);
        for k in 0..3 {
            assert!((c[k] - 0.7).abs() < 1e-6, "{c:?}");
        }
    }

    #[test]
    fn luminance_is_kept_by_saturated_colours() {
        // Macbeth red and blue under equal energy; blue leaves no gamut, red has a channel well above the others.
        for (x, y) in [(0.5805, 0.3238), (0.2026, 0.1369), (0.3007, 0.4822), (0.7, 0.3)] {
            assert!((Rgb::from_xy_e(x, y, 0.25).luminance() - 0.25).abs() < 1e-6);
        }
        assert!(
            Rgb::from_xy_e(0.7, 0.3, 1.0).g < 0.0,
            "outside the gamut a channel is negative, not clamped"
        );
    }
}
