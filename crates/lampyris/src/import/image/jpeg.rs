//! JPEG: dimensions from the first frame header; decoding by the crate `zune-jpeg`, without SIMD, so that the bits of
//! a pixel are the same on every machine.

use super::{Decoded, Size, take};

/// Dimensions, from the first marker that starts a frame.
pub(super) fn size(bytes: &[u8]) -> Result<Size, String> {
    let mut rest = bytes.get(2..).unwrap_or_default();
    loop {
        let ([mark, code], after) = take::<2>(rest)?;
        if mark != 0xff {
            return Err("a marker is missing".into());
        }
        match code {
            // Filling, and markers that stand alone.
            0xff => rest = &rest[1..],
            0x01 | 0xd0..=0xd8 => rest = after,
            0xc0..=0xcf if !matches!(code, 0xc4 | 0xc8 | 0xcc) => {
                // Length, precision, height, width, components.
                let ([_, _, _, h1, h0, w1, w0, _], _) = take::<8>(after)?;
                let (width, height) = (u16::from_be_bytes([w1, w0]), u16::from_be_bytes([h1, h0]));
                // Progressive frames keep a 16-bit coefficient for each of up to four components as well.
                let depth = if code == 0xc2 { 12 } else { 4 };
                return Ok(Size { width: width.into(), height: height.into(), depth });
            }
            0xd9 | 0xda => return Err("it has no frame".into()),
            _ => {
                let (length, _) = take(after)?;
                let length = usize::from(u16::from_be_bytes(length));
                rest = after.get(length.max(2)..).ok_or("the file is cut off")?;
            }
        }
    }
}

/// Passes over a progressive picture; encoders make about ten.
#[cfg(feature = "pictures")]
const SCANS: usize = 64;

#[cfg(feature = "pictures")]
pub(super) fn decode(bytes: &[u8], (width, height): (u32, u32)) -> Decoded {
    use crate::texture::Pixels;
    use zune_jpeg::JpegDecoder;
    use zune_jpeg::zune_core::{bytestream::ZCursor, colorspace::ColorSpace, options::DecoderOptions};

    let options = DecoderOptions::default()
        .set_use_unsafe(false)
        .set_max_width(width as usize)
        .set_max_height(height as usize)
        .jpeg_set_max_scans(SCANS)
        .jpeg_set_out_colorspace(ColorSpace::RGBA);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(|e| e.to_string())?;
    let pixels = width as usize * height as usize;
    if decoder.output_buffer_size() != Some(4 * pixels) {
        return Err("its colours cannot be read".into());
    }
    let mut pixels = vec![[0u8; 4]; pixels];
    decoder.decode_into(pixels.as_flattened_mut()).map_err(|e| e.to_string())?;
    Ok(((width, height), Pixels::Byte(pixels)))
}

#[cfg(not(feature = "pictures"))]
pub(super) fn decode(_: &[u8], _: (u32, u32)) -> Decoded {
    Err("read with the feature `pictures` only".into())
}
