//! OpenEXR: windows, channels and blocks from the headers; decoding by the crate `exr`, which trusts all of them.
//! Read is the first layer with R, G and B, or with Y; of levels the largest. The picture is the data window, wherever
//! it lies in the display window.

use super::{Decoded, Size, take};

const PARTS: usize = 64;
const CHANNELS: usize = 256;
/// Bytes of all headers.
const HEADERS: usize = 1 << 20;
/// Bytes of a block that may be larger than the picture.
const BLOCK: u64 = 16 << 20;
/// Farthest coordinate of a window.
const FARTHEST: i32 = 1 << 24;

/// What one header says, as far as it has been said.
#[derive(Default)]
struct Part {
    data: Option<[i64; 2]>,
    /// Bytes of all channels of a pixel.
    depth: u64,
    compression: u8,
    tile: Option<[u64; 2]>,
}

/// The largest size that any part asks for. Tables of blocks that could not even lie in the file are refused.
pub(super) fn size(bytes: &[u8]) -> Result<Size, String> {
    let (_, rest) = take::<4>(bytes)?;
    let (version, rest) = take(rest)?;
    let version = u32::from_le_bytes(version);
    let multipart = version & 0x1000 != 0;
    if version & 0xff != 2 {
        return Err(format!("version {} cannot be read", version & 0xff));
    }
    if version & 0x800 != 0 {
        return Err("deep pixels cannot be read".into());
    }
    let mut headers = &rest[..rest.len().min(HEADERS)];
    let mut most = Size { width: 0, height: 0, depth: 12 };
    for _ in 0..PARTS {
        headers = part(headers, bytes.len() as u64, &mut most)?;
        // An empty header ends those of several parts.
        if !multipart || headers.first() == Some(&0) {
            return Ok(most);
        }
    }
    Err(format!("it has more than {PARTS} parts"))
}

/// Reads one header; what follows it.
fn part<'a>(mut bytes: &'a [u8], file: u64, most: &mut Size) -> Result<&'a [u8], String> {
    let mut part = Part::default();
    let mut known: Vec<&[u8]> = Vec::new();
    loop {
        let (name, rest) = text(bytes)?;
        if name.is_empty() {
            part.check(file, most)?;
            return Ok(rest);
        }
        let (kind, rest) = text(rest)?;
        // Of these the decoder reads on where they should end.
        if kind.is_empty() {
            return Err("an attribute has no type".into());
        }
        let (length, rest) = take(rest)?;
        let length = usize::try_from(i32::from_le_bytes(length)).map_err(|_| "an attribute is too short")?;
        let value = rest.get(..length).ok_or("an attribute is longer than the headers may be")?;
        bytes = &rest[length..];
        // Which of two would be believed is the decoder's secret.
        if matches!(
            name,
            b"dataWindow" | b"displayWindow" | b"channels" | b"compression" | b"tiles" | b"type"
        ) {
            if known.contains(&name) {
                return Err("an attribute is there twice".into());
            }
            known.push(name);
        }
        match name {
            b"dataWindow" => part.data = Some(window(value)?),
            b"displayWindow" => drop(window(value)?),
            b"channels" => part.depth = channels(value)?,
            b"compression" => part.compression = take::<1>(value)?.0[0],
            b"tiles" => {
                let (width, rest) = take(value)?;
                let (height, _) = take(rest)?;
                part.tile = Some([u32::from_le_bytes(width), u32::from_le_bytes(height)].map(u64::from));
            }
            b"type" if value.starts_with(b"deep") => return Err("deep pixels cannot be read".into()),
            _ => {}
        }
    }
}

impl Part {
    fn check(&self, file: u64, most: &mut Size) -> Result<(), String> {
        let [width, height] = self.data.ok_or("a data window is missing")?;
        let (Ok(width), Ok(height)) = (u64::try_from(width), u64::try_from(height)) else {
            return Err("its data window is inside out".into());
        };
        let [w, h] = self.tile.unwrap_or([width, lines(self.compression)]);
        if w == 0 || h == 0 || w.max(h) > FARTHEST.unsigned_abs().into() {
            return Err(format!("blocks of {w} × {h} pixels cannot be read"));
        }
        // The decoder makes room for one block at once, and believes each block how long it is.
        let bytes = |w: u64, h: u64| w.saturating_mul(h).saturating_mul(self.depth);
        if bytes(w, h) > BLOCK.max(bytes(width, height)) {
            return Err(format!("blocks of {w} × {h} pixels for {width} × {height}"));
        }
        let blocks = width.div_ceil(w).saturating_mul(height.div_ceil(h));
        if blocks > file / 8 + 1 {
            return Err(format!("{blocks} blocks do not lie in {file} bytes"));
        }
        most.width = most.width.max(width);
        most.height = most.height.max(height);
        most.depth = most.depth.max(self.depth);
        Ok(())
    }
}

/// Rows of a block, by the number of the compression.
fn lines(compression: u8) -> u64 {
    match compression {
        0..=2 => 1,
        3 | 5 => 16,
        4 | 6..=8 => 32,
        _ => 256,
    }
}

/// Width and height of a window, not negative unless it is inside out.
fn window(value: &[u8]) -> Result<[i64; 2], String> {
    let mut corners = [0i32; 4];
    let mut rest = value;
    for c in &mut corners {
        let (bytes, after) = take(rest)?;
        (*c, rest) = (i32::from_le_bytes(bytes), after);
    }
    if corners.iter().any(|c| c.unsigned_abs() > FARTHEST.unsigned_abs()) {
        return Err("a window lies too far out".into());
    }
    let [x0, y0, x1, y1] = corners.map(i64::from);
    Ok([x1 - x0 + 1, y1 - y0 + 1])
}

/// Bytes of all channels of a pixel.
fn channels(mut list: &[u8]) -> Result<u64, String> {
    let mut depth = 0;
    for _ in 0..=CHANNELS {
        let (name, rest) = text(list)?;
        if name.is_empty() {
            return Ok(depth);
        }
        let (kind, rest) = take::<16>(rest)?;
        depth += if kind[0] == 1 { 2 } else { 4 };
        list = rest;
    }
    Err(format!("it has more than {CHANNELS} channels"))
}

/// Bytes up to the next zero, and what follows it.
fn text(bytes: &[u8]) -> Result<(&[u8], &[u8]), String> {
    let end = bytes.iter().take(256).position(|b| *b == 0).ok_or("a name has no end")?;
    Ok((&bytes[..end], &bytes[end + 1..]))
}

#[cfg(feature = "pictures")]
pub(super) fn decode(bytes: &[u8], admitted: (u32, u32)) -> Decoded {
    use crate::texture::Pixels;
    use exr::math::Vec2;
    use exr::prelude::*;

    struct Canvas {
        width: usize,
        height: usize,
        pixels: Vec<[f32; 3]>,
    }
    // What is larger than was admitted stays empty.
    let canvas = |size: Vec2<usize>| {
        let Vec2(width, height) =
            if size.0 <= admitted.0 as usize && size.1 <= admitted.1 as usize { size } else { Vec2(0, 0) };
        Canvas { width, height, pixels: vec![[0.0; 3]; width * height] }
    };
    let put = |canvas: &mut Canvas, at: Vec2<usize>, color: [f32; 3]| {
        let row = at.1.checked_mul(canvas.width).and_then(|start| start.checked_add(at.0));
        if let Some(pixel) = row.and_then(|k| canvas.pixels.get_mut(k)) {
            *pixel = color;
        }
    };
    let source = || std::io::Cursor::new(bytes);
    let colors = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            move |size, _| canvas(size),
            move |c: &mut Canvas, at, (r, g, b): (f32, f32, f32)| put(c, at, [r, g, b]),
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(source());
    let canvas = match colors {
        Ok(image) => image.layer_data.channel_data.pixels,
        Err(first) => {
            let grey = read()
                .no_deep_data()
                .largest_resolution_level()
                .specific_channels()
                .required("Y")
                .collect_pixels(
                    move |size, _| canvas(size),
                    move |c: &mut Canvas, at, (y,): (f32,)| put(c, at, [y; 3]),
                )
                .first_valid_layer()
                .all_attributes()
                .non_parallel()
                .from_buffered(source());
            grey.map_err(|_| first.to_string())?.layer_data.channel_data.pixels
        }
    };
    if canvas.pixels.is_empty() {
        return Err("a layer larger than the headers say".into());
    }
    Ok(((canvas.width as u32, canvas.height as u32), Pixels::Float(canvas.pixels)))
}

#[cfg(not(feature = "pictures"))]
pub(super) fn decode(_: &[u8], _: (u32, u32)) -> Decoded {
    Err("read with the feature `pictures` only".into())
}
