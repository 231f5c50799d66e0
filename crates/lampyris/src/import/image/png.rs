//! PNG: dimensions from the first chunk; decoding by the crate `png`, without profiles and texts.

use super::{Decoded, Size, take};

/// Dimensions, from the chunk IHDR that every file begins with.
pub(super) fn size(bytes: &[u8]) -> Result<Size, String> {
    let rest = bytes.get(8..).unwrap_or_default();
    let (head, rest) = take::<8>(rest)?;
    if &head[4..] != b"IHDR" {
        return Err("it does not begin with its header".into());
    }
    let (width, rest) = take(rest)?;
    let (height, _) = take(rest)?;
    // Grey takes half as much again for a moment.
    Ok(Size { width: u32::from_be_bytes(width).into(), height: u32::from_be_bytes(height).into(), depth: 4 })
}

/// Bytes that the decoder may hold beside the pixels: a few rows and chunks.
#[cfg(feature = "pictures")]
const WORKING: usize = 4 << 20;

#[cfg(feature = "pictures")]
pub(super) fn decode(bytes: &[u8], (width, height): (u32, u32)) -> Decoded {
    use crate::texture::Pixels;
    use png::{BitDepth, ColorType, Decoder, Limits, Transformations};

    let mut decoder = Decoder::new_with_limits(std::io::Cursor::new(bytes), Limits { bytes: WORKING });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::ALPHA | Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(|e| e.to_string())?;
    if (reader.info().width, reader.info().height) != (width, height) {
        return Err("it has two headers".into());
    }
    let mut pixels = vec![[0u8; 4]; width as usize * height as usize];
    match reader.output_color_type() {
        (ColorType::Rgba, BitDepth::Eight) => {
            reader.next_frame(pixels.as_flattened_mut()).map_err(|e| e.to_string())?;
        }
        (ColorType::GrayscaleAlpha, BitDepth::Eight) => {
            let mut grey = vec![[0u8; 2]; pixels.len()];
            reader.next_frame(grey.as_flattened_mut()).map_err(|e| e.to_string())?;
            for (pixel, [value, alpha]) in pixels.iter_mut().zip(grey) {
                *pixel = [value, value, value, alpha];
            }
        }
        (color, depth) => return Err(format!("pixels of {color:?} in {depth:?} bits cannot be read")),
    }
    Ok(((width, height), Pixels::Byte(pixels)))
}

#[cfg(not(feature = "pictures"))]
pub(super) fn decode(_: &[u8], _: (u32, u32)) -> Decoded {
    Err("read with the feature `pictures` only".into())
}
