//! Radiance's RGBE pictures [Ward 1991], plain or run-length encoded in either way.
//! Values are taken as they stand: a line EXPOSURE is not divided out, since most files have none and mean no unit.
//! Only the usual order of pixels, from the upper left, is read.

use super::{Decoded, Size};
use crate::texture::Pixels;

/// Bytes that a header may have.
const HEADER: usize = 1 << 20;

/// Dimensions, from the line below the header.
pub(super) fn size(bytes: &[u8]) -> Result<Size, String> {
    header(bytes).map(|(size, _)| size)
}

fn header(bytes: &[u8]) -> Result<(Size, &[u8]), String> {
    let mut rest = bytes;
    let mut line = || {
        let end = rest.iter().take(HEADER).position(|b| *b == b'\n').ok_or("its header has no end")?;
        let (line, after) = rest.split_at(end);
        rest = &after[1..];
        Ok::<_, String>(line)
    };
    loop {
        let line = line()?;
        if line.is_empty() {
            break;
        }
        if line.starts_with(b"FORMAT=") && line != b"FORMAT=32-bit_rle_rgbe" {
            return Err("its format is not 32-bit_rle_rgbe".into());
        }
    }
    let size = std::str::from_utf8(line()?).unwrap_or_default();
    let words: Vec<&str> = size.split_ascii_whitespace().take(5).collect();
    let &["-Y", height, "+X", width] = words.as_slice() else {
        return Err("its rows do not run from the upper left corner".into());
    };
    match (width.parse(), height.parse()) {
        (Ok(width), Ok(height)) => Ok((Size { width, height, depth: 12 }, rest)),
        _ => Err("its size is no number".into()),
    }
}

pub(super) fn decode(bytes: &[u8]) -> Decoded {
    let (size, mut rest) = header(bytes)?;
    let (width, height) = (size.width as usize, size.height as usize);
    let mut pixels = Vec::with_capacity(width * height);
    let mut row = vec![[0u8; 4]; width];
    for _ in 0..height {
        rest = scanline(rest, &mut row).ok_or("the file is cut off, or a run is longer than its row")?;
        pixels.extend(row.iter().map(linear));
    }
    Ok(((size.width as u32, size.height as u32), Pixels::Float(pixels)))
}

/// Mantissas were cut off when they were written: the middle of what each stands for.
fn linear([r, g, b, e]: &[u8; 4]) -> [f32; 3] {
    if *e == 0 {
        return [0.0; 3];
    }
    let scale = libm::ldexpf(1.0, i32::from(*e) - 136);
    [r, g, b].map(|m| (f32::from(*m) + 0.5) * scale)
}

/// Fills a row from the front of `bytes`, and returns what is left.
fn scanline<'a>(bytes: &'a [u8], row: &mut [[u8; 4]]) -> Option<&'a [u8]> {
    let (start, rest) = bytes.split_first_chunk::<4>()?;
    let [a, b, high, low] = *start;
    if (a, b) == (2, 2) && high < 128 && usize::from(high) << 8 | usize::from(low) == row.len() {
        return channels(rest, row);
    }
    old(bytes, row)
}

/// One channel after the other: runs (128 + length, value) and pieces (length, values…).
fn channels<'a>(mut bytes: &'a [u8], row: &mut [[u8; 4]]) -> Option<&'a [u8]> {
    for channel in 0..4 {
        let mut at = 0;
        while at < row.len() {
            let (&count, rest) = bytes.split_first()?;
            let run = count > 128;
            let count = usize::from(if run { count - 128 } else { count });
            let values = rest.get(..if run { 1 } else { count })?;
            for (k, pixel) in row.get_mut(at..at + count)?.iter_mut().enumerate() {
                pixel[channel] = *values.get(if run { 0 } else { k })?;
            }
            bytes = &rest[values.len()..];
            // An empty piece leads nowhere, but each costs a byte.
            at += count;
        }
    }
    Some(bytes)
}

/// Whole pixels; (1, 1, 1, n) repeats the one before, and a sequence of them is a number in base 256.
fn old<'a>(mut bytes: &'a [u8], row: &mut [[u8; 4]]) -> Option<&'a [u8]> {
    let (mut at, mut shift) = (0, 0);
    while at < row.len() {
        let (&pixel, rest) = bytes.split_first_chunk::<4>()?;
        bytes = rest;
        if pixel[..3] == [1, 1, 1] {
            let count = usize::from(pixel[3]).checked_shl(shift)?;
            let last = *row.get(at.checked_sub(1)?)?;
            row.get_mut(at..at.checked_add(count)?)?.fill(last);
            at += count;
            // More than 24 bits are longer than any row.
            shift = (shift + 8).min(24);
        } else {
            row[at] = pixel;
            at += 1;
            shift = 0;
        }
    }
    Some(bytes)
}
