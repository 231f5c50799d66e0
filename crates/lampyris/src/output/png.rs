//! PNG: what a display shows, 8-bit sRGB, with the metadata as text chunks.

use super::{Display, Picture, ToneCurve, display};
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, SrgbRenderingIntent};

/// The bytes of the file.
pub(super) fn encode(picture: &Picture, options: &Display) -> Result<Vec<u8>, String> {
    let pixels = display(picture, options).into_flattened();
    write(picture, &pixels, options.tone.unwrap_or_default(), options.despeckle).map_err(|e| e.to_string())
}

fn write(picture: &Picture, pixels: &[u8], curve: ToneCurve, calm: bool) -> Result<Vec<u8>, EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.set_source_srgb(SrgbRenderingIntent::RelativeColorimetric);
    let tone = ("tone".to_string(), curve.name().to_string());
    let calm = ("despeckled".to_string(), calm.to_string());
    for (key, value) in picture.metadata.iter().chain([&tone, &calm]) {
        encoder.add_itxt_chunk(key.clone(), value.clone())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::super::Exposure;
    use super::*;
    use crate::color::Rgb;

    fn three() -> Picture {
        let radiance = vec![Rgb::grey(-1.0), Rgb::grey(18.0), Rgb::new(100.0, 0.0, 1e9)];
        let mut picture = Picture::new(3, 1, radiance);
        picture.metadata.push(("scene".into(), "büro.mgf".into()));
        picture
    }

    #[test]
    fn pixels_of_each_curve() {
        // Middle grey: 0.18, 0.152542 and 0.266899 encode to 117.6, 109.0 and 141.3 of 255.
        for (curve, middle) in
            [(ToneCurve::Linear, 118), (ToneCurve::Reinhard, 109), (ToneCurve::Filmic, 141)]
        {
            let options = Display { exposure: Exposure::Ev(0.0), tone: Some(curve), despeckle: false };
            let bytes = encode(&three(), &options).unwrap();
            let image = image::load_from_memory(&bytes).unwrap().to_rgb8();
            assert_eq!(image.get_pixel(0, 0).0, [0, 0, 0], "{curve:?}");
            assert_eq!(image.get_pixel(1, 0).0, [middle; 3], "{curve:?}");
            assert_eq!(image.get_pixel(2, 0).0[2], 255, "{curve:?}");
        }
    }

    #[test]
    fn metadata_and_colour_space_are_stated() {
        let bytes = encode(&three(), &Display::default()).unwrap();
        let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        assert_eq!(reader.info().srgb, Some(SrgbRenderingIntent::RelativeColorimetric));
        let text: Vec<_> =
            reader.info().utf8_text.iter().map(|t| (t.keyword.clone(), t.get_text().unwrap())).collect();
        assert_eq!(text[0], ("scene".to_string(), "büro.mgf".to_string()));
        assert_eq!(text[1].1, "filmic");
    }
}
