//! Pictures that scenes are made of: PNG, JPEG, Radiance HDR and OpenEXR, told apart by their first bytes.
//! A file of a thousand bytes can ask for a gigabyte. So the few numbers that say how much a picture will need are
//! read here first, and no decoder sees a file that asks for more than the limits grant. Admitting is cheap and in the
//! order of the file, so that the limits mean the same on any machine; what was admitted is then decoded by all cores.
//!
//! PNG and JPEG become 8 bits a channel (the upper ones of 16), HDR and OpenEXR linear floats from 0 to
//! 10¹² without alpha; what is no finite number is black. Profiles and other metadata are skipped. A PNG that moves
//! gives its first picture.

mod jpeg;
mod openexr;
mod png;
mod radiance;

use super::Limits;
use crate::error::Error;
use crate::texture::{Image, Pixels};
use rayon::prelude::*;
use std::borrow::Cow;
use std::path::Path;

/// Longest side of a picture [pixels].
const LONGEST: u64 = 65_536;

/// Bytes beyond which a picture must not be more than [`EXPANSION`] times its file: flat colours compress well, but no
/// wall is a gigabyte of one colour.
const SUSPICIOUS: u64 = 64 << 20;

/// Largest ratio of decoded bytes to those of the file, beyond [`SUSPICIOUS`].
const EXPANSION: u64 = 2000;

/// Largest value of a pixel: six hundred suns. It multiplies what a scene says.
const LARGEST: f32 = 1e12;

/// Why a picture is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It cannot be read; a scene can do without it.
    Unreadable(String),
    /// It needs more than a limit allows.
    OverLimit {
        /// What would be exceeded, with the figure.
        what: String,
        /// The limit in force.
        limit: u64,
        /// The option of the program that raises it.
        option: &'static str,
    },
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Refusal::Unreadable(reason) => f.write_str(reason),
            Refusal::OverLimit { what, limit, option } => {
                write!(f, "{what} exceeds the limit of {limit}; raise it with {option}")
            }
        }
    }
}

impl Refusal {
    /// The error of a file that cannot do without the picture.
    pub(super) fn into_error(self, file: &Path) -> Error {
        match self {
            Refusal::Unreadable(reason) => Error::CannotRead { file: file.into(), reason },
            Refusal::OverLimit { what, limit, option } => {
                Error::OverLimit { file: file.into(), place: "0".into(), what, limit, option }
            }
        }
    }
}

/// Counts what the pictures of one scene take.
#[derive(Clone, Debug)]
pub struct Gate {
    limits: Limits,
    taken: u64,
}

/// A picture that a scene looks at.
#[derive(Clone, Debug)]
pub struct Source<'a> {
    /// What the scene's image will be called.
    pub name: String,
    /// The file, or why it cannot be had.
    pub bytes: Result<Cow<'a, [u8]>, String>,
}

/// A picture that may be decoded.
#[derive(Clone, Copy, Debug)]
pub struct Admitted<'a> {
    bytes: &'a [u8],
    format: Format,
    size: Size,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Jpeg,
    Radiance,
    OpenExr,
}

/// What a header asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Size {
    width: u64,
    height: u64,
    /// Bytes a pixel, while it is decoded or afterwards, whichever is more.
    depth: u64,
}

impl Gate {
    /// For one scene.
    pub fn new(limits: Limits) -> Gate {
        Gate { limits, taken: 0 }
    }

    /// Looks at a picture's header alone.
    ///
    /// # Errors
    /// A [`Refusal`] for what is no picture, no known one, or too large.
    pub fn admit<'a>(&mut self, bytes: &'a [u8]) -> Result<Admitted<'a>, Refusal> {
        let format = recognise(bytes).map_err(Refusal::Unreadable)?;
        let size = match format {
            Format::Png => png::size(bytes),
            Format::Jpeg => jpeg::size(bytes),
            Format::Radiance => radiance::size(bytes),
            Format::OpenExr => openexr::size(bytes),
        };
        let size = size.map_err(|reason| Refusal::Unreadable(format!("{}: {reason}", format.name())))?;
        self.taken = self.taken.saturating_add(self.check(size, bytes.len() as u64)?);
        Ok(Admitted { bytes, format, size })
    }

    /// All pictures of a list, each or why it cannot be read. The result depends on their order and on nothing else.
    ///
    /// # Errors
    /// Place in the list and [`Refusal`] of the first that needs more than a limit allows; then none is decoded.
    pub fn decode(&mut self, sources: &[Source<'_>]) -> Result<Vec<Result<Image, String>>, (usize, Refusal)> {
        let mut admitted = Vec::with_capacity(sources.len());
        for (k, source) in sources.iter().enumerate() {
            admitted.push(match &source.bytes {
                Err(why) => Err(why.clone()),
                Ok(bytes) => match self.admit(bytes) {
                    Ok(picture) => Ok(picture),
                    Err(Refusal::Unreadable(why)) => Err(why),
                    Err(over) => return Err((k, over)),
                },
            });
        }
        let pairs = admitted.into_par_iter().zip(sources);
        Ok(pairs.map(|(picture, source)| picture.and_then(|p| p.decode(&source.name))).collect())
    }

    /// The bytes that a picture needs, if they may be had.
    fn check(&self, size: Size, file: u64) -> Result<u64, Refusal> {
        let Size { width, height, depth } = size;
        if width == 0 || height == 0 || width > LONGEST || height > LONGEST {
            let reason = format!("{width} × {height} pixels; sides from 1 to {LONGEST} can be read");
            return Err(Refusal::Unreadable(reason));
        }
        let pixels = width * height;
        if pixels > self.limits.image_pixels {
            return Err(Refusal::OverLimit {
                what: format!("a picture of {width} × {height} pixels"),
                limit: self.limits.image_pixels,
                option: "--max-image-pixels",
            });
        }
        let bytes = pixels.saturating_mul(depth);
        if bytes > SUSPICIOUS && bytes / EXPANSION > file {
            let reason = format!("{width} × {height} pixels in {file} bytes: no honest picture is so dense");
            return Err(Refusal::Unreadable(reason));
        }
        if bytes > self.limits.image_bytes.saturating_sub(self.taken) {
            return Err(Refusal::OverLimit {
                what: format!("{} bytes of decoded pictures", self.taken.saturating_add(bytes)),
                limit: self.limits.image_bytes,
                option: "--max-image-bytes",
            });
        }
        Ok(bytes)
    }
}

impl Admitted<'_> {
    /// Width and height as the header has them [pixels].
    pub fn size(&self) -> (u32, u32) {
        (self.size.width as u32, self.size.height as u32)
    }

    /// The picture.
    ///
    /// # Errors
    /// What is wrong with the file, in words.
    pub fn decode(&self, name: &str) -> Result<Image, String> {
        // Foreign decoders met hostile files before, but a panic of theirs must not be one of ours.
        let decoded = std::panic::catch_unwind(|| match self.format {
            Format::Png => png::decode(self.bytes, self.size()),
            Format::Jpeg => jpeg::decode(self.bytes, self.size()),
            Format::Radiance => radiance::decode(self.bytes),
            Format::OpenExr => openexr::decode(self.bytes, self.size()),
        });
        let failed = |reason| format!("{}: {reason}", self.format.name());
        let ((width, height), mut pixels) =
            decoded.unwrap_or_else(|_| Err("its decoder gave up".into())).map_err(failed)?;
        if let Pixels::Float(pixels) = &mut pixels {
            let bounded = |v: f32| if v.is_finite() { v.clamp(0.0, LARGEST) } else { 0.0 };
            pixels.as_flattened_mut().iter_mut().for_each(|v| *v = bounded(*v));
        }
        Ok(Image { name: name.into(), width, height, pixels })
    }
}

/// Width, height and pixels.
type Decoded = Result<((u32, u32), Pixels), String>;

impl Format {
    fn name(self) -> &'static str {
        match self {
            Format::Png => "PNG",
            Format::Jpeg => "JPEG",
            Format::Radiance => "Radiance HDR",
            Format::OpenExr => "OpenEXR",
        }
    }
}

/// The format of a file, or the name of one that is known but not read.
fn recognise(bytes: &[u8]) -> Result<Format, String> {
    let starts = |with: &[u8]| bytes.starts_with(with);
    let foreign = if starts(b"\x89PNG\r\n\x1a\n") {
        return Ok(Format::Png);
    } else if starts(b"\xff\xd8\xff") {
        return Ok(Format::Jpeg);
    } else if starts(b"#?RADIANCE") || starts(b"#?RGBE") {
        return Ok(Format::Radiance);
    } else if starts(b"\x76\x2f\x31\x01") {
        return Ok(Format::OpenExr);
    } else if starts(b"\xabKTX 20\xbb") {
        "KTX2"
    } else if starts(b"\xabKTX 11\xbb") {
        "KTX"
    } else if starts(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        "WebP"
    } else if starts(b"DDS ") {
        "DDS"
    } else if starts(b"GIF8") {
        "GIF"
    } else if starts(b"BM") {
        "BMP"
    } else if starts(b"II*\0") || starts(b"MM\0*") {
        "TIFF"
    } else if bytes.get(4..12) == Some(b"ftypavif") {
        "AVIF"
    } else {
        return Err("no picture that can be read; known: PNG, JPEG, Radiance HDR, OpenEXR".into());
    };
    Err(format!("{foreign} cannot be read; known: PNG, JPEG, Radiance HDR, OpenEXR"))
}

/// The next `N` bytes of a file, and what follows them.
fn take<const N: usize>(bytes: &[u8]) -> Result<([u8; N], &[u8]), String> {
    bytes
        .split_first_chunk()
        .map(|(head, rest)| (*head, rest))
        .ok_or_else(|| "the file is cut off".to_owned())
}
