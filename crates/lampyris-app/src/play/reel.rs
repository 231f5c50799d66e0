//! Where the frames of a walkthrough go: a picture each, or a film.

use crate::failure::Failure;
use crate::interrupt;
use lampyris::Error;
use lampyris::output::{self, Display, Picture, y4m};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Digits that a frame's number may be given.
const DIGITS: usize = 9;

/// The files of one `-o`.
pub(crate) enum Reel {
    /// A name for each frame: what stands before its number, digits, what stands behind.
    Pictures(String, usize, String),
    /// One file for all; opened at the first frame.
    Film { path: PathBuf, rate: u32, file: Option<File> },
    /// A film to standard output.
    Stream { rate: u32, begun: bool },
}

impl Reel {
    /// What an `-o` means.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a name without a number where there are several frames, and for an unknown format.
    pub(crate) fn new(path: &Path, frames: u32, rate: u32) -> Result<Reel, Error> {
        if path.as_os_str() == "-" {
            return Ok(Reel::Stream { rate, begun: false });
        }
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            let reason = format!("there is no folder {}", folder.display());
            return Err(Error::CannotWrite { file: path.into(), reason });
        }
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("y4m")) {
            return Ok(Reel::Film { path: path.into(), rate, file: None });
        }
        output::format_of(path).map_err(|e| Error::BadSetting(format!("{e}; for films: y4m")))?;
        match path.to_str().and_then(pattern) {
            Some((before, digits, after)) => Ok(Reel::Pictures(before, digits, after)),
            None if frames == 1 => Ok(Reel::Pictures(path.display().to_string(), 0, String::new())),
            None => Err(Error::BadSetting(format!(
                "{} has no place for the frame's number; write %04d there, as in frame_%04d.png",
                path.display()
            ))),
        }
    }

    /// Writes a frame, whole or not at all.
    ///
    /// # Errors
    /// [`Error::CannotWrite`], and [`Failure::Output`] where standard output takes no more.
    pub(crate) fn write(&mut self, number: u32, picture: &Picture, display: &Display) -> Result<(), Failure> {
        let (width, height) = (picture.width, picture.height);
        match self {
            Reel::Pictures(before, 0, _) => {
                Ok(interrupt::writing(|| output::save(before.as_ref(), picture, display))?)
            }
            Reel::Pictures(before, digits, after) => {
                let name = format!("{before}{number:0digits$}{after}", digits = *digits);
                Ok(interrupt::writing(|| output::save(name.as_ref(), picture, display))?)
            }
            Reel::Film { path, rate, file } => {
                let bytes = y4m::frame(&output::display(picture, display));
                let written = interrupt::writing(|| match file {
                    Some(file) => file.write_all(&bytes),
                    None => {
                        let new = file.insert(File::create(&path)?);
                        new.write_all(&[y4m::header(width, height, *rate), bytes].concat())
                    }
                });
                written.map_err(|e| Error::CannotWrite { file: path.clone(), reason: e.to_string() }.into())
            }
            Reel::Stream { rate, begun } => {
                let header = if *begun { Vec::new() } else { y4m::header(width, height, *rate) };
                let bytes = [header, y4m::frame(&output::display(picture, display))].concat();
                *begun = true;
                let mut out = std::io::stdout().lock();
                out.write_all(&bytes).and_then(|()| out.flush()).map_err(Failure::Output)
            }
        }
    }
}

/// A name around its one `%d` or `%04d`.
fn pattern(name: &str) -> Option<(String, usize, String)> {
    let (before, rest) = name.split_once('%')?;
    let (digits, after) = rest.split_once('d')?;
    let digits = if digits.is_empty() { 1 } else { digits.parse().ok()? };
    ((1..=DIGITS).contains(&digits) && !after.contains('%')).then(|| (before.into(), digits, after.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_frames() {
        let of = |name: &str| pattern(name).map(|(a, n, b)| format!("{a}{:0n$}{b}", 7));
        assert_eq!(of("a/frame_%04d.png").as_deref(), Some("a/frame_0007.png"));
        assert_eq!(of("%d.exr").as_deref(), Some("7.exr"));
        for bad in ["frame.png", "%.png", "%xd.png", "%99d.png", "%04d_%04d.png", "100%.png"] {
            assert_eq!(of(bad), None, "{bad}");
        }
        let refused =
            |name: &str, frames| Reel::new(Path::new(name), frames, 25).err().map(|e| e.to_string());
        assert_eq!(refused("frame.png", 1), None);
        assert!(refused("frame.png", 2).is_some_and(|e| e.contains("%04d")));
        assert!(refused("a_%d.mov", 2).is_some_and(|e| e.contains("y4m")));
    }
}
