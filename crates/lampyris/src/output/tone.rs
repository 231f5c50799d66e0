//! Tone curves: from exposed light (1 = display white) to display light in [0, 1].
//! Global operators only [Reinhard et al. 2002; Narkowicz 2015]. Only display formats pass here; negative channels end
//! here and nowhere earlier.

use crate::color::Rgb;

/// No display tells brighter light apart, and its square is still a number.
const BRIGHTEST: f32 = 1e12;

/// The closed set of curves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ToneCurve {
    /// Y = X. Brighter than white is clipped.
    Linear,
    /// Y = X / (1 + X) on the luminance, the colour kept [Reinhard et al. 2002, eq. 3].
    Reinhard,
    /// Y = X (2.51 X + 0.03) / (X (2.43 X + 0.59) + 0.14) on each channel, a rational fit to the film-like curve of the
    /// Academy's reference rendering transform [Narkowicz 2015]: a soft toe, and shoulders that turn to white.
    #[default]
    Filmic,
}

impl ToneCurve {
    /// Every curve.
    pub const ALL: [ToneCurve; 3] = [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            ToneCurve::Linear => "linear",
            ToneCurve::Reinhard => "reinhard",
            ToneCurve::Filmic => "filmic",
        }
    }

    /// The formula, in words for `lampyris list`.
    pub fn formula(self) -> &'static str {
        match self {
            ToneCurve::Linear => "Y = X, clipped at white",
            ToneCurve::Reinhard => "Y = X / (1 + X) on the luminance",
            ToneCurve::Filmic => "Y = X (2.51 X + 0.03) / (X (2.43 X + 0.59) + 0.14) on each channel",
        }
    }

    /// The curve of a name.
    pub fn from_name(name: &str) -> Option<ToneCurve> {
        ToneCurve::ALL.into_iter().find(|c| c.name() == name)
    }

    /// Display light of exposed light; linear, not yet encoded. Channels are ≥ 0, but only [`srgb`] clips at 1.
    pub fn apply(self, exposed: Rgb) -> Rgb {
        // What is no number compares with none, and is no light.
        let c = exposed.map(|v| if v > 0.0 { v.min(BRIGHTEST) } else { 0.0 });
        match self {
            ToneCurve::Linear => c,
            ToneCurve::Reinhard => c / (1.0 + c.luminance()),
            ToneCurve::Filmic => c.map(|x| x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)),
        }
    }
}

/// The encoding of sRGB (IEC 61966-2-1) for one channel of display light, to the nearest of 256 steps.
pub fn srgb(linear: f32) -> u8 {
    let v = linear.clamp(0.0, 1.0);
    let encoded = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * libm::powf(v, 1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        // Filmic: 0.18·(2.51·0.18 + 0.03)/(0.18·(2.43·0.18 + 0.59) + 0.14) = 0.086724/0.324932; at 1: 2.54/3.16.
        let table = [
            (ToneCurve::Linear, [0.18, 1.0]),
            (ToneCurve::Reinhard, [0.18 / 1.18, 0.5]),
            (ToneCurve::Filmic, [0.086_724 / 0.324_932, 2.54 / 3.16]),
        ];
        for (curve, expected) in table {
            for (x, y) in [0.18, 1.0].into_iter().zip(expected) {
                let got = curve.apply(Rgb::grey(x));
                assert!((got.g - y).abs() < 1e-6 && got.r == got.b, "{curve:?}({x}) = {got:?}, not {y}");
            }
        }
    }

    #[test]
    fn every_curve_rises_from_black_and_stays_finite() {
        for curve in ToneCurve::ALL {
            assert_eq!(curve.apply(Rgb::new(-3.0, f32::NAN, f32::NEG_INFINITY)), Rgb::BLACK);
            let mut last = 0.0;
            for i in 1..240 {
                let y = curve.apply(Rgb::grey(libm::exp2f(i as f32 * 0.1 - 12.0))).r;
                assert!(y >= last, "{curve:?} falls at step {i}");
                last = y;
            }
            for huge in [1e20, f32::MAX, f32::INFINITY] {
                let y = curve.apply(Rgb::grey(huge)).r;
                assert!(y >= last && y.is_finite(), "{curve:?}({huge}) = {y}");
            }
            assert_eq!(ToneCurve::from_name(curve.name()), Some(curve));
        }
    }

    #[test]
    fn reinhard_keeps_the_chromaticity() {
        let c = Rgb::new(2.0, 1.0, 0.5);
        let d = ToneCurve::Reinhard.apply(c);
        assert!((d.r / d.g - 2.0).abs() < 1e-6 && (d.g / d.b - 2.0).abs() < 1e-6);
    }

    #[test]
    fn srgb_steps() {
        // 0.5 encodes to 0.735357·255 = 187.5; middle grey 0.18 to 0.461356·255 = 117.6 (IEC 61966-2-1).
        for (v, step) in [(0.0, 0), (0.002, 7), (0.18, 118), (0.5, 188), (1.0, 255), (9.0, 255), (-1.0, 0)] {
            assert_eq!(srgb(v), step, "{v}");
        }
        assert_eq!(srgb(f32::NAN), 0);
    }
}
