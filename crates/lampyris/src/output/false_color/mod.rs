//! False colour: values, one a pixel, as a picture of at most 256 colours whose legend is known. Nothing here knows light:
//! luminance and illuminance are numbers alike, and what is no number is hatched.

mod lines;
mod palette;
mod scale;

pub use lines::{Segment, iso_lines};
pub use palette::Palette;
pub use scale::{Scale, Tick};

use crate::error::{Error, Result};
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, SrgbRenderingIntent};
use serde::{Deserialize, Serialize};

/// Colours of a smooth palette; those above are for lines and hatching.
const SHADES: u8 = 248;

/// Colours beside the palette's, by what they are for.
const DARK_LINE: u8 = 252;
const BRIGHT_LINE: u8 = 253;
const HATCH: u8 = 254;
const HATCHED: u8 = 255;

/// Half the width of lines, thin and thick [pixels].
const THIN: f32 = 0.55;
const THICK: f32 = 1.4;

/// How values become colours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FalseColor {
    /// What is shown in the first colour, and all below it.
    pub low: f32,
    /// What is shown in the last colour, and all above it.
    pub high: f32,
    /// What lies between them.
    pub scale: Scale,
    /// So many steps of one colour each, 2 to 64, instead of a smooth run.
    pub steps: Option<u8>,
    /// Which colours.
    pub palette: Palette,
    /// Values at which lines are drawn, and whether thick.
    pub lines: Vec<(f32, bool)>,
}

/// A picture by numbers of colours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Painted {
    /// Width [pixels].
    pub width: u32,
    /// Height [pixels].
    pub height: u32,
    /// The colours, sRGB.
    pub colors: Vec<[u8; 3]>,
    /// The number of each pixel's colour, row by row.
    pub pixels: Vec<u8>,
}

impl FalseColor {
    /// Paints values, row by row from the top; those that are not finite are hatched.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a legend whose ends make no sense, more than 64 steps or 256 lines, and for values that do not
    /// fill the picture.
    pub fn paint(&self, values: &[f32], [width, height]: [u32; 2]) -> Result<Painted> {
        self.check()?;
        let whole = u64::from(width) * u64::from(height);
        if values.len() as u64 != whole || whole == 0 {
            return Err(bad(format!("{} values for a picture of {width} × {height}", values.len())));
        }
        let shade = |(k, value): (usize, &f32)| match self.place(*value) {
            Some(place) => self.shade(place),
            None => {
                let (x, y) = (k % width as usize, k / width as usize);
                if (x + y) % 8 < 2 { HATCH } else { HATCHED }
            }
        };
        let mut pixels: Vec<u8> = values.iter().enumerate().map(shade).collect();
        let colors = self.colors();
        for (value, thick) in &self.lines {
            for segment in iso_lines(values, [width, height], *value) {
                lines::draw(segment, if *thick { THICK } else { THIN }, [width, height], |pixel| {
                    let below = pixels[pixel];
                    let bright = below < SHADES && luma(colors[usize::from(below)]) > 110;
                    if below < SHADES {
                        pixels[pixel] = if bright { DARK_LINE } else { BRIGHT_LINE };
                    }
                });
            }
        }
        Ok(Painted { width, height, colors, pixels })
    }

    /// Where a value lies on the legend, 0 to 1; `None` for what is no number.
    pub fn place(&self, value: f32) -> Option<f32> {
        value.is_finite().then(|| self.scale.place(value, self.low, self.high))
    }

    /// The colour of a place on the legend, sRGB.
    pub fn color(&self, place: f32) -> [u8; 3] {
        self.palette.color(f32::from(self.shade(place)) / f32::from(SHADES - 1))
    }

    /// The values to write beside the legend, 1, 2 and 5 times powers of ten, about `count` of them.
    pub fn ticks(&self, count: usize) -> Vec<Tick> {
        self.scale.ticks(self.low, self.high, count)
    }

    fn check(&self) -> Result<()> {
        let ordered = self.low < self.high && (self.high - self.low).is_finite();
        if !ordered || (self.scale == Scale::Log && self.low <= 0.0) {
            return Err(bad(
                "its ends are two numbers, the lower one first, and above 0 where it is logarithmic".into(),
            ));
        }
        if self.steps.is_some_and(|steps| !(2..=64).contains(&steps)) || self.lines.len() > 256 {
            return Err(bad("it has 2 to 64 steps and at most 256 lines".into()));
        }
        Ok(())
    }

    fn shade(&self, place: f32) -> u8 {
        let last = f32::from(SHADES - 1);
        let place = place.clamp(0.0, 1.0);
        match self.steps.map(f32::from) {
            // The first step has the first colour, the last the last.
            Some(steps) => ((place * steps).floor().min(steps - 1.0) / (steps - 1.0) * last).round() as u8,
            None => (place * last).round() as u8,
        }
    }

    fn colors(&self) -> Vec<[u8; 3]> {
        let shades = (0..SHADES).map(|k| self.palette.color(f32::from(k) / f32::from(SHADES - 1)));
        let rest = [[0; 3], [0; 3], [0; 3], [0; 3], [10; 3], [245; 3], [96; 3], [128; 3]];
        shades.chain(rest).collect()
    }
}

impl Painted {
    /// The bytes of a PNG, by its palette.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a picture whose pixels were changed to no picture.
    pub fn png(&self) -> Result<Vec<u8>> {
        self.encode().map_err(|e| bad(e.to_string()))
    }

    fn encode(&self) -> std::result::Result<Vec<u8>, EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_palette(self.colors.concat());
        encoder.set_compression(Compression::Fast);
        encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(bytes)
    }
}

/// How bright a colour looks, roughly, 0 to 255.
fn luma([r, g, b]: [u8; 3]) -> u32 {
    (2 * u32::from(r) + 7 * u32::from(g) + u32::from(b)) / 10
}

fn bad(what: String) -> Error {
    Error::BadSetting(format!("cannot show false colours: {what}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn legend() -> FalseColor {
        FalseColor {
            low: 0.0,
            high: 100.0,
            scale: Scale::Linear,
            steps: None,
            palette: Palette::Even,
            lines: Vec::new(),
        }
    }

    #[test]
    fn values_become_the_colours_of_the_legend() {
        let values: Vec<f32> = (-20..=120).map(|k| k as f32).collect();
        let size = [values.len() as u32, 1];
        for steps in [None, Some(2), Some(5), Some(64)] {
            let legend = FalseColor { steps, ..legend() };
            let painted = legend.paint(&values, size).expect("values");
            let mut shown: Vec<[u8; 3]> =
                painted.pixels.iter().map(|p| painted.colors[usize::from(*p)]).collect();
            for (value, shown) in values.iter().zip(&shown) {
                assert_eq!(*shown, legend.color(legend.place(*value).expect("a number")));
            }
            assert!(shown[..21].iter().all(|c| *c == legend.color(0.0)));
            assert!(shown[120..].iter().all(|c| *c == legend.color(1.0)));
            shown.dedup();
            assert_eq!(shown.len(), steps.map_or(101, usize::from));
        }
    }

    #[test]
    fn what_is_no_number_is_hatched_and_takes_no_line() {
        let mut values = vec![10.0; 256];
        values[128..].fill(90.0);
        for hole in (0..256).filter(|k| k % 16 < 8) {
            values[hole] = if hole % 2 == 0 { f32::NAN } else { f32::INFINITY };
        }
        let painted =
            FalseColor { lines: vec![(50.0, true)], ..legend() }.paint(&values, [16, 16]).expect("values");
        for (k, pixel) in painted.pixels.iter().enumerate() {
            assert_eq!(*pixel >= HATCH, k % 16 < 8, "{k}");
        }
        // The line lies between the rows 7 and 8, whose middles are at 7.5 and 8.5.
        let line = |row: usize| {
            painted.pixels[row * 16 + 12] == BRIGHT_LINE || painted.pixels[row * 16 + 12] == DARK_LINE
        };
        let rows: Vec<usize> = (0..16).filter(|row| line(*row)).collect();
        assert_eq!(rows, [7, 8]);
    }

    #[test]
    fn the_file_holds_the_colours() {
        let values: Vec<f32> = (0..12 * 9).map(|k| if k == 5 { f32::NAN } else { k as f32 }).collect();
        let painted =
            FalseColor { lines: vec![(44.0, false)], ..legend() }.paint(&values, [12, 9]).expect("values");
        let image = image::load_from_memory(&painted.png().expect("a picture")).expect("a PNG").to_rgb8();
        assert_eq!(image.dimensions(), (12, 9));
        for (pixel, number) in image.pixels().zip(&painted.pixels) {
            assert_eq!(pixel.0, painted.colors[usize::from(*number)]);
        }
    }

    #[test]
    fn senseless_legends_are_refused() {
        let nan = f32::NAN;
        let ends = |low: f32, high: f32, scale: Scale| FalseColor { low, high, scale, ..legend() };
        let broken = [
            ends(1.0, 1.0, Scale::Linear),
            ends(2.0, 1.0, Scale::Linear),
            ends(nan, 1.0, Scale::Linear),
            ends(0.0, f32::INFINITY, Scale::Linear),
            ends(0.0, 1.0, Scale::Log),
            FalseColor { steps: Some(1), ..legend() },
            FalseColor { steps: Some(65), ..legend() },
            FalseColor { lines: vec![(1.0, false); 257], ..legend() },
        ];
        assert!(broken.iter().all(|legend| legend.paint(&[1.0], [1, 1]).is_err()));
        assert!(legend().paint(&[1.0], [2, 1]).is_err() && legend().paint(&[], [0, 0]).is_err());
        assert!(
            FalseColor { lines: vec![(nan, true), (f32::INFINITY, false)], ..legend() }
                .paint(&[1.0; 4], [2, 2])
                .is_ok()
        );
    }
}
