//! Radiance's RGBE pictures [Ward 1991], run-length encoded by scanline.
//! Three mantissas share an exponent, so that a channel 256 times darker than the brightest is lost and negative ones
//! are 0. With the linear curve, values divided by `EXPOSURE` are W/(sr·m²) at 179 lm/W, as Radiance's tools expect.

use super::{Display, Picture, ToneCurve};
use crate::color::Rgb;

/// Luminous efficacy that Radiance counts with [lm/W].
const EFFICACY: f32 = 179.0;

/// Widths outside this range cannot be told from other encodings and stay plain.
const ENCODABLE: std::ops::RangeInclusive<u32> = 8..=32767;

/// The bytes of the file.
pub(super) fn encode(picture: &Picture, display: &Display) -> Result<Vec<u8>, String> {
    let factor = display.exposure.factor(&picture.radiance);
    let curve = display.tone.unwrap_or(ToneCurve::Linear);
    let mut bytes = header(picture, curve, factor).into_bytes();
    for row in picture.radiance.chunks_exact(picture.width as usize) {
        let row: Vec<[u8; 4]> = row.iter().map(|&c| rgbe(curve.apply(c * factor))).collect();
        if ENCODABLE.contains(&picture.width) {
            bytes.extend([2, 2, (picture.width >> 8) as u8, picture.width as u8]);
            for k in 0..4 {
                run_lengths(&row.iter().map(|p| p[k]).collect::<Vec<u8>>(), &mut bytes);
            }
        } else {
            bytes.extend(row.as_flattened());
        }
    }
    Ok(bytes)
}

fn header(picture: &Picture, curve: ToneCurve, factor: f32) -> String {
    // A line break would end the line, and an empty line the header.
    let lines: String = picture
        .metadata
        .iter()
        .map(|(key, value)| format!("# {key}: {value}").replace(['\n', '\r'], " ") + "\n")
        .collect();
    let exposure = match curve {
        ToneCurve::Linear => format!("EXPOSURE={}\n", EFFICACY * factor),
        // What a curve has bent is no multiple of a radiance any more.
        _ => format!("# tone: {}\n", curve.name()),
    };
    format!(
        "#?RADIANCE\n{lines}{exposure}PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\n\
         FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
        picture.height, picture.width
    )
}

/// `c` comes from a tone curve: finite and not negative. The shared exponent is the brightest channel's, biased by 128; mantissas are cut off, readers add half a step.
fn rgbe(c: Rgb) -> [u8; 4] {
    let brightest = c.max_channel();
    if brightest < 1e-32 {
        return [0; 4];
    }
    let (_, exponent) = libm::frexpf(brightest);
    let scale = libm::ldexpf(1.0, 8 - exponent);
    let [r, g, b] = c.to_array().map(|v| (v * scale) as u8);
    [r, g, b, (exponent + 128) as u8]
}

/// Runs of four and more as (128 + length, value), everything between as (length, values…).
fn run_lengths(values: &[u8], bytes: &mut Vec<u8>) {
    let mut start = 0;
    let mut i = 0;
    while i < values.len() {
        let run = values[i..].iter().take(127).take_while(|&&v| v == values[i]).count();
        if run >= 4 {
            literals(&values[start..i], bytes);
            bytes.extend([128 + run as u8, values[i]]);
            start = i + run;
        }
        i += run;
    }
    literals(&values[start..], bytes);
}

fn literals(values: &[u8], bytes: &mut Vec<u8>) {
    for chunk in values.chunks(128) {
        bytes.push(chunk.len() as u8);
        bytes.extend(chunk);
    }
}

#[cfg(test)]
mod tests {
    use super::super::Exposure;
    use super::*;

    fn decoded(bytes: &[u8]) -> image::Rgb32FImage {
        image::load_from_memory_with_format(bytes, image::ImageFormat::Hdr).unwrap().to_rgb32f()
    }

    #[test]
    fn another_reader_finds_the_light() {
        for (width, height) in [(5, 3), (64, 4), (300, 2)] {
            // Long runs, short runs and noise in one row.
            let value = |i: u32| {
                let noise = i.wrapping_mul(2_654_435_761) >> 24;
                Rgb::new(if i % 90 < 40 { 3.0 } else { noise as f32 }, (i / 3) as f32, 0.001)
            };
            let radiance: Vec<Rgb> = (0..width * height).map(value).collect();
            let display = Display { exposure: Exposure::Ev(1.0), ..Display::default() };
            let image = decoded(&encode(&Picture::new(width, height, radiance.clone()), &display).unwrap());
            for (c, p) in radiance.iter().zip(image.pixels()) {
                for k in 0..3 {
                    let (expected, got) = (c[k] * 0.02, p.0[k]);
                    assert!((expected - got).abs() <= c.max_channel() * 0.02 / 128.0, "{expected} {got}");
                }
            }
        }
    }

    #[test]
    fn extremes_fit() {
        for v in [0.0, -1.0, 1e-40, 1e-30, 1e30, f32::MAX, f32::INFINITY, f32::NAN] {
            let [.., e] = rgbe(ToneCurve::Linear.apply(Rgb::grey(v)));
            assert_eq!(e == 0, v.is_nan() || v < 1e-31, "{v}");
        }
        assert_eq!(rgbe(Rgb::new(1.0, 0.5, 0.0)), [128, 64, 0, 129]);
    }

    #[test]
    fn metadata_cannot_end_the_header() {
        let mut picture = Picture::new(1, 1, vec![Rgb::WHITE]);
        picture.metadata.push(("scene".into(), "a\n\n-Y 9 +X 9\n".into()));
        let bytes = encode(&picture, &Display { exposure: Exposure::Ev(0.0), ..Display::default() }).unwrap();
        assert_eq!(decoded(&bytes).dimensions(), (1, 1));
        assert!(String::from_utf8_lossy(&bytes).contains("EXPOSURE=1.79\n"));
    }
}
