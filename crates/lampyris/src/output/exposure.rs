//! Exposure: which luminance of the scene is display white.
//! The automatic one places the log-average luminance at the key 0.18 [Reinhard et al. 2002, eqs. 1 and 2] and ignores
//! the darkest and the brightest pixels, so that a lamp in the picture does not darken the room. It is no camera.

use crate::color::Rgb;

/// Luminance [cd/m²] that is display white at 0 EV: the customary white of a standard display.
const BASE: f32 = 100.0;

/// The display value that the log-average luminance gets.
const KEY: f64 = 0.18;

/// Share of the pixels left out at either end of the automatic exposure.
const TRIMMED: f64 = 0.05;

/// Which luminance is shown as white.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Exposure {
    /// Found from the picture.
    #[default]
    Auto,
    /// Exposure value: 100 cd/m² · 2^-EV is display white. One more doubles what is shown.
    Ev(f32),
}

impl Exposure {
    /// The factor from radiance [cd/m²] to exposed light, where 1 is display white.
    pub fn factor(self, radiance: &[Rgb]) -> f32 {
        match self {
            Exposure::Ev(ev) => libm::exp2f(ev) / BASE,
            Exposure::Auto => log_average(radiance).map_or(1.0 / BASE, |average| (KEY / average) as f32),
        }
    }

    /// The exposure value in force for a picture, automatic or not.
    pub fn ev(self, radiance: &[Rgb]) -> f32 {
        match self {
            Exposure::Ev(ev) => ev,
            Exposure::Auto => libm::log2f(self.factor(radiance) * BASE),
        }
    }
}

/// The geometric mean of the positive luminances [cd/m²], without the extremes; `None` for a black picture.
fn log_average(radiance: &[Rgb]) -> Option<f64> {
    let mut lit: Vec<f32> =
        radiance.iter().map(|c| c.luminance()).filter(|&y| y > 0.0 && y.is_finite()).collect();
    lit.sort_unstable_by(f32::total_cmp);
    let trimmed = (lit.len() as f64 * TRIMMED) as usize;
    let kept = &lit[trimmed..lit.len() - trimmed];
    let sum: f64 = kept.iter().map(|&y| libm::log(f64::from(y))).sum();
    (!kept.is_empty()).then(|| libm::exp(sum / kept.len() as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_ev_doubles() {
        assert_eq!(Exposure::Ev(0.0).factor(&[]), 0.01);
        assert_eq!(Exposure::Ev(3.0).factor(&[]), 0.08);
    }

    #[test]
    fn auto_puts_a_uniform_picture_at_the_key() {
        let factor = Exposure::Auto.factor(&[Rgb::grey(40.0); 64]);
        assert!((factor * 40.0 - 0.18).abs() < 1e-6);
        assert!((Exposure::Ev(Exposure::Auto.ev(&[Rgb::grey(40.0); 64])).factor(&[]) - factor).abs() < 1e-8);
    }

    #[test]
    fn lamps_and_black_pixels_do_not_move_auto() {
        let mut room = vec![Rgb::grey(40.0); 1000];
        let plain = Exposure::Auto.factor(&room);
        room[..30].fill(Rgb::grey(30_000.0));
        room[30..60].fill(Rgb::BLACK);
        room[60] = Rgb::grey(f32::NAN);
        room[61] = Rgb::grey(-5.0);
        assert_eq!(Exposure::Auto.factor(&room), plain);
    }

    #[test]
    fn a_black_picture_has_an_exposure() {
        assert_eq!(Exposure::Auto.factor(&[Rgb::BLACK; 4]), Exposure::Ev(0.0).factor(&[]));
        assert_eq!(Exposure::Auto.factor(&[]), 0.01);
    }
}
