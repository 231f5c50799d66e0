//! Colours for values, all from formulas. Lightness is that of CIELAB (CIE 15:2004) under D65, for the primaries of
//! Rec. ITU-R BT.709.

use super::super::srgb;
use serde::{Deserialize, Serialize};

/// Which colours a legend runs through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Palette {
    /// From dark blue by purple and orange to light yellow: a parabola in CIELAB walked at constant speed, so that equal steps
    /// look equal. Every step is lighter than the last, so that it needs no eye for hues and survives a grey copy.
    #[default]
    Even,
    /// All hues from blue to red, of full saturation. Usual, and uneven: greens look alike, and who does not tell red from green
    /// reads it wrongly.
    Rainbow,
    /// From black to white by even lightness.
    Grey,
    /// For values of both signs: from blue by light grey to orange, straight through CIELAB, so that what is as far from the
    /// middle is as dark. Blue and yellow tell the signs apart, which nearly everybody does who takes red for green.
    Diverging,
}

impl Palette {
    /// Every palette.
    pub const ALL: [Palette; 4] = [Palette::Even, Palette::Rainbow, Palette::Grey, Palette::Diverging];

    /// The colour at a place from 0 to 1, sRGB.
    pub fn color(self, place: f32) -> [u8; 3] {
        let place = f64::from(place.clamp(0.0, 1.0));
        let linear = match self {
            Palette::Even => from_lab(parabola(even(place))),
            Palette::Rainbow => return rainbow(place),
            Palette::Grey => from_lab([100.0 * place, 0.0, 0.0]),
            Palette::Diverging => from_lab(diverging(place)),
        };
        linear.map(|c| srgb(c as f32))
    }
}

/// L*, a*, b* at the ends of the parabola, and where its tangents there meet.
const DARK: [f64; 3] = [14.0, 22.0, -42.0];
const BENT: [f64; 3] = [50.0, 74.0, 6.0];
const LIGHT: [f64; 3] = [93.0, -14.0, 70.0];

fn parabola(t: f64) -> [f64; 3] {
    let s = 1.0 - t;
    std::array::from_fn(|k| s * s * DARK[k] + 2.0 * s * t * BENT[k] + t * t * LIGHT[k])
}

/// L*, a*, b* of values far below the middle, at it, and far above it.
const BELOW: [f64; 3] = [38.0, 22.0, -58.0];
const MIDDLE: [f64; 3] = [94.0, 0.0, 0.0];
const ABOVE: [f64; 3] = [38.0, 42.0, 46.0];

fn diverging(place: f64) -> [f64; 3] {
    let off = 2.0 * place - 1.0;
    let end = if off < 0.0 { BELOW } else { ABOVE };
    std::array::from_fn(|k| MIDDLE[k] + (end[k] - MIDDLE[k]) * off.abs())
}

/// How far along the parabola a share of its length has been walked.
fn even(place: f64) -> f64 {
    const STEPS: usize = 64;
    let at = |k: usize| parabola(k as f64 / STEPS as f64);
    let mut walked = [0.0; STEPS + 1];
    for k in 0..STEPS {
        walked[k + 1] = walked[k] + distance(at(k), at(k + 1));
    }
    let wanted = place * walked[STEPS];
    let k = walked.partition_point(|w| *w < wanted).clamp(1, STEPS);
    let within = (wanted - walked[k - 1]) / (walked[k] - walked[k - 1]);
    (k as f64 - 1.0 + within) / STEPS as f64
}

/// ΔE of 1976.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
}

/// X, Y and Z of D65.
const WHITE: [f64; 3] = [0.950_47, 1.0, 1.088_83];

/// Linear Rec. 709 of a colour in CIELAB.
fn from_lab([l, a, b]: [f64; 3]) -> [f64; 3] {
    let middle = (l + 16.0) / 116.0;
    let inverse = |f: f64| {
        let edge = 6.0 / 29.0;
        if f > edge { f * f * f } else { 3.0 * edge * edge * (f - 4.0 / 29.0) }
    };
    let f = [middle + a / 500.0, middle, middle - b / 200.0];
    let [x, y, z]: [f64; 3] = std::array::from_fn(|k| WHITE[k] * inverse(f[k]));
    [
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266 * x + 1.876_010_8 * y + 0.041_556 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    ]
}

/// Hues from 240° to 0° of full value and saturation.
fn rainbow(place: f64) -> [u8; 3] {
    let sixths = 4.0 * (1.0 - place);
    let channel = |middle: f64| {
        let off = (sixths - middle).abs();
        let off = off.min(6.0 - off);
        ((2.0 - off).clamp(0.0, 1.0) * 255.0).round() as u8
    };
    [channel(0.0), channel(2.0), channel(4.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIELAB of linear Rec. 709.
    fn to_lab([r, g, b]: [f64; 3]) -> [f64; 3] {
        let x = 0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b;
        let y = 0.212_672_9 * r + 0.715_152_2 * g + 0.072_175 * b;
        let z = 0.019_333_9 * r + 0.119_192 * g + 0.950_304_1 * b;
        let f =
            |t: f64| if t > 216.0 / 24389.0 { libm::cbrt(t) } else { (24389.0 / 27.0 * t + 16.0) / 116.0 };
        let [x, y, z] = [f(x / WHITE[0]), f(y / WHITE[1]), f(z / WHITE[2])];
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// CIELAB of what a display shows.
    fn seen(color: [u8; 3]) -> [f64; 3] {
        to_lab(color.map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
        }))
    }

    #[test]
    fn the_even_palette_is_even_and_lighter_at_every_step() {
        let steps = 40;
        let places = (0..=steps).map(|k| f64::from(k) / f64::from(steps));
        let exact: Vec<_> = places.clone().map(|place| to_lab(from_lab(parabola(even(place))))).collect();
        let lengths: Vec<f64> = exact.windows(2).map(|two| distance(two[0], two[1])).collect();
        let mean = lengths.iter().sum::<f64>() / f64::from(steps);
        assert!(mean > 3.0 && lengths.iter().all(|d| (d / mean - 1.0).abs() < 0.01), "{mean}: {lengths:?}");
        // Rounded to 256 steps of each channel, colours stay in their places by a quarter of a step.
        let labs: Vec<_> = places.map(|place| seen(Palette::Even.color(place as f32))).collect();
        assert!(labs.iter().zip(&exact).all(|(a, b)| distance(*a, *b) < mean / 4.0));
        assert!(labs.windows(2).all(|two| two[1][0] > two[0][0] + 0.8), "{labs:?}");
        for k in 0..=1000 {
            let color = from_lab(parabola(f64::from(k) / 1000.0));
            assert!(
                color.iter().all(|c| (0.0..=1.0).contains(c)),
                "{k}: {color:?}: out of what displays show"
            );
        }
    }

    /// What is as far from the middle is as dark, the further the darker, blue below and yellow above.
    #[test]
    fn signs_are_told_apart() {
        let steps = 40;
        let at = |k: i32| seen(Palette::Diverging.color(0.5 + 0.5 * k as f32 / steps as f32));
        let [light, a, b] = at(0);
        assert!((light - 94.0).abs() < 0.5 && a.abs() < 0.5 && b.abs() < 0.5);
        for k in 1..=steps {
            let ([below, _, blue], [above, _, yellow]) = (at(-k), at(k));
            let lightness = 94.0 - 56.0 * f64::from(k) / f64::from(steps);
            assert!(
                (below - lightness).abs() < 0.6 && (above - lightness).abs() < 0.6,
                "{k}: {below} {above}"
            );
            assert!(blue < at(1 - k)[2] && yellow > at(k - 1)[2], "{k}");
        }
        for k in 0..=1000 {
            let color = from_lab(diverging(f64::from(k) / 1000.0));
            assert!(
                color.iter().all(|c| (0.0..=1.0).contains(c)),
                "{k}: {color:?}: out of what displays show"
            );
        }
    }

    #[test]
    fn grey_is_even_and_the_rainbow_has_its_corners() {
        let steps = 20;
        for k in 0..=steps {
            let [l, a, b] = seen(Palette::Grey.color(k as f32 / steps as f32));
            assert!((l - 5.0 * f64::from(k)).abs() < 0.4 && a.abs() < 0.1 && b.abs() < 0.1);
        }
        let corners = [0.0, 0.25, 0.5, 0.75, 1.0].map(|place| Palette::Rainbow.color(place));
        assert_eq!(corners, [[0, 0, 255], [0, 255, 255], [0, 255, 0], [255, 255, 0], [255, 0, 0]]);
        assert!(Palette::ALL.iter().all(|p| p.color(-1.0) == p.color(0.0) && p.color(9.0) == p.color(1.0)));
    }
}
