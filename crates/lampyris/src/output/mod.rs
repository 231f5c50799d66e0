//! Pictures out. One table by extension: a new format is one file and one row.
//!
//! A format turns a [`Picture`] into the bytes of a file, and [`save`] brings them to the disk whole or not at all.
//! Nothing here changes a picture: exposure and tone curves act on what is displayed, OpenEXR holds cd/m².

mod despeckle;
mod encode;
mod exposure;
mod exr;
pub mod false_color;
mod hdr;
mod picture;
mod png;
mod tone;
pub mod y4m;

pub use exposure::Exposure;
pub use picture::{Layer, Picture, Plane};
pub use tone::{ToneCurve, srgb};

use crate::atomic;
use crate::color::Rgb;
use crate::error::{Error, Result};
use despeckle::despeckle;
use encode::Encoder;
use rayon::prelude::*;
use std::path::Path;

/// How scene light becomes display light, in the formats that hold what a display shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Display {
    /// Which luminance is shown as white.
    pub exposure: Exposure,
    /// The curve after the exposure; where `None`, the one that suits the format (PNG: filmic, HDR: linear).
    pub tone: Option<ToneCurve>,
    /// PNG: bring single speckles down to their neighbours.
    pub despeckle: bool,
}

impl Default for Display {
    fn default() -> Self {
        Display { exposure: Exposure::default(), tone: None, despeckle: true }
    }
}

/// A row of the table.
pub struct Format {
    /// Extension in lower case, without the dot.
    pub extension: &'static str,
    /// What it is called, and what it holds.
    pub name: &'static str,
    /// The bytes of a whole file, or why there are none.
    encode: fn(&Picture, &Display) -> std::result::Result<Vec<u8>, String>,
}

/// Every format that can be written.
pub const FORMATS: &[Format] = &[
    Format { extension: "exr", name: "OpenEXR: cd/m², all layers", encode: exr::encode },
    Format { extension: "png", name: "PNG: 8-bit sRGB through exposure and tone curve", encode: png::encode },
    Format { extension: "hdr", name: "Radiance RGBE: exposed, recoverable", encode: hdr::encode },
];

/// The format that a file's name asks for.
pub fn format_of(path: &Path) -> Result<&'static Format> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    FORMATS.iter().find(|f| f.extension == extension).ok_or_else(|| {
        let known: Vec<_> = FORMATS.iter().map(|f| f.extension).collect();
        Error::BadSetting(format!(
            "no picture format has the extension \"{extension}\" of {}; known: {}",
            path.display(),
            known.join(", ")
        ))
    })
}

/// Writes a picture in the format of the file's extension. The file is afterwards either the whole new picture or
/// exactly what it was before.
pub fn save(path: &Path, picture: &Picture, display: &Display) -> Result<()> {
    let format = format_of(path)?;
    let cannot = |reason: String| Error::CannotWrite { file: path.into(), reason };
    picture.check().map_err(cannot)?;
    let bytes = (format.encode)(picture, display).map_err(cannot)?;
    atomic::write(path, &bytes).map_err(|e| cannot(e.to_string()))
}

/// What a display shows of a picture: 8-bit sRGB, filmic where no curve is named.
pub fn display(picture: &Picture, options: &Display) -> Vec<[u8; 3]> {
    let factor = options.exposure.factor(&picture.radiance);
    let curve = options.tone.unwrap_or_default();
    let encoder = Encoder::new();
    let encode = |&c: &Rgb| curve.apply(c * factor).to_array().map(|v| encoder.encode(v));
    if options.despeckle {
        despeckle(picture.width, picture.height, &picture.radiance).par_iter().map(encode).collect()
    } else {
        picture.radiance.par_iter().map(encode).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides_and_its_case_does_not() {
        assert_eq!(format_of(Path::new("a.EXR")).unwrap().extension, "exr");
        for bad in ["a", "a.jpg", ".png", ""] {
            assert!(matches!(format_of(Path::new(bad)), Err(Error::BadSetting(_))), "{bad:?}");
        }
    }

    #[test]
    fn a_layer_of_the_wrong_size_is_an_error() {
        let mut picture = Picture::new(2, 2, vec![Rgb::WHITE; 4]);
        picture.layers.push(Layer { name: "depth".into(), plane: Plane::Depth(vec![1.0; 3]) });
        let path = std::env::temp_dir().join("lampyris-never-written.exr");
        let error = save(&path, &picture, &Display::default()).unwrap_err();
        assert!(error.to_string().contains("depth"), "{error}");
        assert!(!path.exists());
    }
}
