//! A lamp's colour: by temperature and tint, by red, green and blue, by chromaticity, or as in the file. Whatever decides it,
//! it has luminance 1, so that colours do not change lumens.

use crate::patch::{ColorPatch, Mode, swap};
use lampyris::Rgb;
use lampyris::chromaticity::Chromaticity;
use serde::Serialize;

/// A colour, with what each mode has.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Color {
    pub(crate) mode: Mode,
    pub(crate) kelvin: f32,
    pub(crate) tint: f32,
    pub(crate) rgb: [f32; 3],
    pub(crate) xy: [f32; 2],
}

/// Temperatures that lamps have [K], and how far they lie beside the black bodies [Duv × 1000].
const KELVIN: std::ops::RangeInclusive<f32> = 1000.0..=40_000.0;
const TINT: std::ops::RangeInclusive<f32> = -50.0..=50.0;

impl Color {
    /// The file's, with what comes near it in the other modes.
    pub(crate) fn of_file(file: Rgb) -> Color {
        let brightest = file.max_channel().max(1e-6);
        let rgb = file.to_array().map(|c| (c / brightest).max(0.0));
        let (kelvin, xy) = nearest(file);
        Color { mode: Mode::File, kelvin, tint: 0.0, rgb, xy }
    }

    /// The colour, of luminance 1; `None` for the file's.
    pub(crate) fn light(&self) -> Option<Rgb> {
        match self.mode {
            Mode::File => None,
            Mode::Kelvin => Some(of_kelvin(self.kelvin, self.tint)),
            Mode::Rgb => {
                let [r, g, b] = self.rgb;
                let color = Rgb::new(r, g, b);
                Some(color * (1.0 / color.luminance()))
            }
            Mode::Xy => Some(Rgb::from_xy_e(self.xy[0].into(), self.xy[1].into(), 1.0)),
        }
    }

    /// All of it, as a patch.
    pub(crate) fn whole(&self) -> ColorPatch {
        let Color { mode, kelvin, tint, rgb, xy } = *self;
        ColorPatch { mode: Some(mode), kelvin: Some(kelvin), tint: Some(tint), rgb: Some(rgb), xy: Some(xy) }
    }

    /// Changes what a patch says; returns what takes it back.
    pub(crate) fn apply(&mut self, patch: &ColorPatch) -> Result<ColorPatch, String> {
        let mut new = *self;
        let inverse = ColorPatch {
            mode: swap(&mut new.mode, &patch.mode),
            kelvin: swap(&mut new.kelvin, &patch.kelvin),
            tint: swap(&mut new.tint, &patch.tint),
            rgb: swap(&mut new.rgb, &patch.rgb),
            xy: swap(&mut new.xy, &patch.xy),
        };
        if !KELVIN.contains(&new.kelvin) {
            return Err("a colour temperature lies between 1000 and 40000 K".into());
        }
        if !TINT.contains(&new.tint) {
            return Err("a tint lies between -50 and 50".into());
        }
        let [x, y] = new.xy;
        if !(x >= 0.0 && y >= 0.01 && x + y <= 1.0) {
            return Err("there is no colour of this x and y".into());
        }
        let channels = new.rgb.iter().all(|c| (0.0..=1e4).contains(c));
        if !channels || new.rgb.iter().all(|c| *c < 1e-3) {
            return Err("red, green and blue are not negative, and not all of them nothing".into());
        }
        *self = new;
        Ok(inverse)
    }
}

fn of_kelvin(kelvin: f32, tint: f32) -> Rgb {
    let c =
        Chromaticity::from_temperature_and_tint(kelvin.into(), f64::from(tint) * 1e-3).unwrap_or_default();
    Rgb::from_xy_e(c.x, c.y, 1.0)
}

/// The temperature of the black body whose red and blue are most like a colour's [K], and the body's chromaticity.
fn nearest(color: Rgb) -> (f32, [f32; 2]) {
    let ratio = |c: Rgb| c.r.max(1e-4) / c.b.max(1e-4);
    // Hotter bodies are bluer, always.
    let (mut low, mut high) = (1000.0_f32, 20_000.0_f32);
    for _ in 0..24 {
        let middle = 2.0 / (1.0 / low + 1.0 / high);
        if ratio(of_kelvin(middle, 0.0)) > ratio(color) { low = middle } else { high = middle }
    }
    let kelvin = (low / 10.0).round() * 10.0;
    let c = Chromaticity::from_temperature(kelvin.into()).unwrap_or_default();
    (kelvin, [c.x as f32, c.y as f32])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_colour_has_luminance_one() {
        let mut color = Color::of_file(of_kelvin(2700.0, 0.0));
        assert!((color.kelvin - 2700.0).abs() <= 10.0, "{}", color.kelvin);
        for (mode, kelvin) in
            [(Mode::Kelvin, 1800.0), (Mode::Kelvin, 9000.0), (Mode::Rgb, 3000.0), (Mode::Xy, 3000.0)]
        {
            (color.mode, color.kelvin) = (mode, kelvin);
            assert!((color.light().unwrap().luminance() - 1.0).abs() < 1e-5, "{color:?}");
        }
    }

    #[test]
    fn modes_keep_their_values() {
        let mut color = Color::of_file(Rgb::WHITE);
        let before = color;
        let to = |mode| ColorPatch { mode: Some(mode), ..ColorPatch::default() };
        let first = color.apply(&ColorPatch { kelvin: Some(2200.0), ..to(Mode::Kelvin) }).unwrap();
        color.apply(&to(Mode::Rgb)).unwrap();
        color.apply(&to(Mode::Kelvin)).unwrap();
        assert_eq!(color.kelvin, 2200.0);
        color.apply(&first).unwrap();
        assert_eq!(color, before);
        for bad in [f32::NAN, 0.0, 1e9] {
            assert!(color.apply(&ColorPatch { kelvin: Some(bad), ..ColorPatch::default() }).is_err());
        }
        assert!(color.apply(&ColorPatch { rgb: Some([0.0; 3]), ..ColorPatch::default() }).is_err());
        assert_eq!(color, before);
    }
}
