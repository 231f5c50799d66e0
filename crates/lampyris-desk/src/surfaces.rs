//! What the surfaces behind the pixels of a picture reflect, where that tells what they receive.

use lampyris::Rgb;
use lampyris::frame::Auxiliary;

/// What the surface behind a pixel reflects in the mean, if it is readable.
fn albedo(seen: &Auxiliary, readable: &[bool], pixel: usize) -> Option<Rgb> {
    let instance = seen.object.get(pixel)?.checked_sub(1)?;
    let scale = 1.0 / seen.samples.max(1) as f32;
    readable.get(instance as usize).filter(|readable| **readable).map(|_| seen.albedo[pixel] * scale)
}

/// The same of all pixels, black where there is none.
pub(crate) fn albedos(seen: &Auxiliary, readable: &[bool]) -> Vec<Rgb> {
    (0..seen.object.len()).map(|pixel| albedo(seen, readable, pixel).unwrap_or(Rgb::BLACK)).collect()
}
