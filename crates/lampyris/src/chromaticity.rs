//! Hue and saturation alone, as CIE 1931 chromaticity relative to equal-energy white: MGF's colours, and lamps by their
//! temperature. Spectra are integrated with the CIE 1931 2° observer, black bodies follow Planck's law. Mixing weighs tristimulus
//! values, which for colours weighted by luminance is exactly mixing their spectra, so no spectrum is kept.

use crate::color::Rgb;

/// A chromaticity (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chromaticity {
    /// x
    pub x: f64,
    /// y
    pub y: f64,
}

impl Default for Chromaticity {
    fn default() -> Self {
        Chromaticity { x: 1.0 / 3.0, y: 1.0 / 3.0 }
    }
}

impl Chromaticity {
    /// From tristimulus values; `None` without luminance.
    fn from_xyz([x, y, z]: [f64; 3]) -> Option<Chromaticity> {
        let sum = x + y + z;
        (y > 0.0 && sum > 0.0 && sum.is_finite()).then(|| Chromaticity { x: x / sum, y: y / sum })
    }

    /// Of a spectrum of relative power, given at evenly spaced wavelengths from `first` to `last` [nm] and zero
    /// elsewhere; `None` if its luminance is not positive. At least two values, `first < last`.
    pub fn from_spectrum(first: f64, last: f64, values: &[f64]) -> Option<Chromaticity> {
        let intervals = values.len() - 1;
        let at = |wavelength: f64| {
            let t = (wavelength - first) / (last - first) * intervals as f64;
            if !(0.0..=intervals as f64).contains(&t) {
                return 0.0;
            }
            let i = (t as usize).min(intervals - 1);
            let f = t - i as f64;
            values[i] * (1.0 - f) + values[i + 1] * f
        };
        Chromaticity::integrate(at)
    }

    /// Of a black body at a temperature in kelvin, > 0.
    pub fn from_temperature(kelvin: f64) -> Option<Chromaticity> {
        // c₂ = hc/k [nm·K]; relative to 780 nm, where least is lost at low temperatures.
        let exponent = |nm: f64| 1.438_776_877e7 / (nm * kelvin);
        Chromaticity::integrate(|nm| {
            let scale = libm::exp(exponent(780.0) - exponent(nm));
            // Planck: λ⁻⁵ / (e^u − 1), with e^(u₇₈₀ − u) / (1 − e^−u) in its place.
            libm::pow(560.0 / nm, 5.0) * scale / -libm::expm1(-exponent(nm))
        })
    }

    /// Of a black body at a temperature in kelvin, > 0, moved off the curve of black bodies by Duv (CIE 1960 u, v; positive toward
    /// green), as lamps that are no black bodies are told by.
    pub fn from_temperature_and_tint(kelvin: f64, duv: f64) -> Option<Chromaticity> {
        let body = Chromaticity::from_temperature(kelvin)?;
        if duv == 0.0 {
            return Some(body);
        }
        let [below, above] = [0.999, 1.001].map(|step| Chromaticity::from_temperature(kelvin * step));
        let ([u, v], [u0, v0], [u1, v1]) = (body.uv(), below?.uv(), above?.uv());
        // Along the curve, hotter bodies lie to its lower u; a quarter turn from there is toward green.
        let (du, dv) = (u1 - u0, v1 - v0);
        let length = (du * du + dv * dv).sqrt();
        let (u, v) = (u + duv * dv / length, v - duv * du / length);
        let sum = 2.0 * u - 8.0 * v + 4.0;
        Some(Chromaticity { x: 3.0 * u / sum, y: 2.0 * v / sum })
    }

    /// CIE 1960 u and v.
    fn uv(self) -> [f64; 2] {
        let sum = -2.0 * self.x + 12.0 * self.y + 3.0;
        [4.0 * self.x / sum, 6.0 * self.y / sum]
    }

    /// Σ w·(X, Y, Z) of colours scaled to unit luminance; `None` if nothing with luminance is left.
    pub fn mix(parts: &[(f64, Chromaticity)]) -> Option<Chromaticity> {
        let mut sum = [0.0; 3];
        for &(weight, c) in parts {
            // On y = 0 there is no unit luminance: the neutral stands in, as in `Rgb::from_xy_e`.
            let c = if c.y > 0.0 { c } else { Chromaticity::default() };
            sum[0] += weight * c.x / c.y;
            sum[1] += weight;
            sum[2] += weight * (1.0 - c.x - c.y) / c.y;
        }
        Chromaticity::from_xyz(sum)
    }

    /// Scene colour of luminance `y`.
    pub fn rgb(self, y: f64) -> Rgb {
        Rgb::from_xy_e(self.x, self.y, y)
    }

    /// ∫ spectrum · observer, at 1 nm with the observer's table interpolated linearly.
    fn integrate(spectrum: impl Fn(f64) -> f64) -> Option<Chromaticity> {
        let mut xyz = [0.0; 3];
        let mut white = [0.0; 3];
        for nm in 380..=780_usize {
            let (row, f) = ((nm - 380) / 10, ((nm - 380) % 10) as f64 / 10.0);
            let next = (row + 1).min(OBSERVER.len() - 1);
            let power = spectrum(nm as f64);
            for k in 0..3 {
                let sensitivity = OBSERVER[row][k] * (1.0 - f) + OBSERVER[next][k] * f;
                xyz[k] += power * sensitivity;
                white[k] += sensitivity;
            }
        }
        // The tabulated observer's white is (1/3, 1/3) to four digits: make a flat spectrum neutral exactly.
        Chromaticity::from_xyz([xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]])
    }
}

/// The CIE 1931 2° standard observer, 380 nm to 780 nm by 10 nm (x̄, ȳ, z̄).
const OBSERVER: [[f64; 3]; 41] = [
    [0.001_368, 0.000_039, 0.006_450],
    [0.004_243, 0.000_120, 0.020_050],
    [0.014_310, 0.000_396, 0.067_850],
    [0.043_510, 0.001_210, 0.207_400],
    [0.134_380, 0.004_000, 0.645_600],
    [0.283_900, 0.011_600, 1.385_600],
    [0.348_280, 0.023_000, 1.747_060],
    [0.336_200, 0.038_000, 1.772_110],
    [0.290_800, 0.060_000, 1.669_200],
    [0.195_360, 0.090_980, 1.287_640],
    [0.095_640, 0.139_020, 0.812_950],
    [0.032_010, 0.208_020, 0.465_180],
    [0.004_900, 0.323_000, 0.272_000],
    [0.009_300, 0.503_000, 0.158_200],
    [0.063_270, 0.710_000, 0.078_250],
    [0.165_500, 0.862_000, 0.042_160],
    [0.290_400, 0.954_000, 0.020_300],
    [0.433_450, 0.994_950, 0.008_750],
    [0.594_500, 0.995_000, 0.003_900],
    [0.762_100, 0.952_000, 0.002_100],
    [0.916_300, 0.870_000, 0.001_650],
    [1.026_300, 0.757_000, 0.001_100],
    [1.062_200, 0.631_000, 0.000_800],
    [1.002_600, 0.503_000, 0.000_340],
    [0.854_450, 0.381_000, 0.000_190],
    [0.642_400, 0.265_000, 0.000_050],
    [0.447_900, 0.175_000, 0.000_020],
    [0.283_500, 0.107_000, 0.0],
    [0.164_900, 0.061_000, 0.0],
    [0.087_400, 0.032_000, 0.0],
    [0.046_770, 0.017_000, 0.0],
    [0.022_700, 0.008_210, 0.0],
    [0.011_359, 0.004_102, 0.0],
    [0.005_790, 0.002_091, 0.0],
    [0.002_899, 0.001_047, 0.0],
    [0.001_440, 0.000_520, 0.0],
    [0.000_690, 0.000_249, 0.0],
    [0.000_332, 0.000_120, 0.0],
    [0.000_166, 0.000_060, 0.0],
    [0.000_083, 0.000_030, 0.0],
    [0.000_042, 0.000_015, 0.0],
];

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(c: Option<Chromaticity>, x: f64, y: f64, tolerance: f64) {
        let c = c.unwrap();
        assert!((c.x - x).abs() <= tolerance && (c.y - y).abs() <= tolerance, "{c:?} against {x}, {y}");
    }

    #[test]
    fn black_bodies_lie_on_the_published_locus() {
        for (kelvin, x, y) in [(2856.0, 0.4476, 0.4075), (3000.0, 0.4370, 0.4041), (6500.0, 0.3135, 0.3237)] {
            assert_near(Chromaticity::from_temperature(kelvin), x, y, 0.0005);
        }
    }

    /// Duv is a distance, and green lies on its positive side.
    #[test]
    fn tints_leave_the_locus_at_right_angles() {
        for kelvin in [2200.0, 2700.0, 4000.0, 6500.0, 20_000.0] {
            let body = Chromaticity::from_temperature(kelvin).unwrap();
            for duv in [-0.02, -0.006, 0.003, 0.02] {
                let tinted = Chromaticity::from_temperature_and_tint(kelvin, duv).unwrap();
                let ([u, v], [u0, v0]) = (tinted.uv(), body.uv());
                let moved = ((u - u0).powi(2) + (v - v0).powi(2)).sqrt();
                assert!((moved - duv.abs()).abs() < 1e-9, "{kelvin} K: {moved}");
                assert_eq!(v > v0, duv > 0.0);
                // No black body is nearer by more than the step along the curve leaves open.
                for step in [0.98, 0.99, 1.01, 1.02] {
                    let [ub, vb] = Chromaticity::from_temperature(kelvin * step).unwrap().uv();
                    assert!((u - ub).powi(2) + (v - vb).powi(2) > moved * moved * 0.999);
                }
            }
        }
    }

    #[test]
    fn black_bodies_have_a_colour_at_any_temperature() {
        for kelvin in [1.0, 100.0, 1e5, 1e12] {
            let c = Chromaticity::from_temperature(kelvin).unwrap();
            assert!(c.x > 0.0 && c.y > 0.0 && c.x + c.y < 1.0001, "{kelvin} K: {c:?}");
        }
    }

    #[test]
    fn a_flat_spectrum_is_neutral() {
        assert_near(Chromaticity::from_spectrum(380.0, 780.0, &[3.0, 3.0]), 1.0 / 3.0, 1.0 / 3.0, 1e-12);
    }

    #[test]
    fn a_narrow_band_lies_on_the_spectral_locus() {
        // 600 nm: x = .6270, y = .3725; 520 nm: .0743, .8338 (CIE).
        assert_near(Chromaticity::from_spectrum(599.5, 600.5, &[1.0, 1.0]), 0.6270, 0.3725, 0.0001);
        assert_near(Chromaticity::from_spectrum(519.5, 520.5, &[1.0, 1.0]), 0.0743, 0.8338, 0.0001);
    }

    #[test]
    fn spectra_without_light_have_no_colour() {
        assert_eq!(Chromaticity::from_spectrum(380.0, 780.0, &[0.0, 0.0]), None);
        assert_eq!(Chromaticity::from_spectrum(380.0, 780.0, &[1.0, -2.0]), None);
        assert_eq!(Chromaticity::from_spectrum(900.0, 950.0, &[1.0, 1.0]), None);
    }

    #[test]
    fn the_nominal_primaries_mix_to_white() {
        let c = |x, y| Chromaticity { x, y };
        let mixed =
            Chromaticity::mix(&[(0.265, c(0.64, 0.33)), (0.670, c(0.29, 0.60)), (0.065, c(0.15, 0.06))]);
        assert_near(mixed, 0.3331, 0.3330, 0.0005);
        assert_eq!(Chromaticity::mix(&[(1.0, c(0.3, 0.3)), (-1.0, c(0.3, 0.3))]), None);
    }
}
