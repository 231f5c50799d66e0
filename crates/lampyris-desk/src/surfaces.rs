//! Of which surfaces a picture tells what they receive: those that send on, in all directions alike, nearly all that they send
//! on at all. What is seen of them, divided by what they reflect, is their illuminance, to as much as their gloss is.

use lampyris::Rgb;
use lampyris::frame::Auxiliary;
use lampyris::material::{Class, Material};
use lampyris::scene::Scene;

/// Most that a readable surface reflects sharply, met at a right angle.
const GLOSS: f32 = 0.06;

/// Whether a surface of a material is readable.
pub(crate) fn is_readable(m: &Material) -> bool {
    let albedo = |class| m.bsdf.albedo(class, glam::Vec3::Z).luminance();
    albedo(Class::Sharp) <= GLOSS && albedo(Class::Dull) > 0.0 && !m.bsdf.transmits() && m.emission.is_black()
}

/// Of each instance whether all of its surfaces are readable.
pub(crate) fn readable(scene: &Scene) -> Vec<bool> {
    let plain: Vec<bool> = scene.materials.iter().map(is_readable).collect();
    let all = |worn: &[u32]| worn.iter().all(|m| plain.get(*m as usize) == Some(&true));
    let meshes: Vec<bool> = scene.meshes.iter().map(|mesh| all(&mesh.materials)).collect();
    scene.instances.iter().map(|i| meshes.get(i.mesh as usize) == Some(&true)).collect()
}

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
