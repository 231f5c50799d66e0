//! Illuminance of what a camera sees. A picture holds what surfaces send to the eye and not what they receive, so there are
//! two ways, and both leave out what has no answer: mirrors, clear glass and the void.
//!
//! A meter on the surface behind each pixel ([`receivers`]) reads it exactly, on surfaces of any kind, and takes a picture of
//! its own. Or what is seen is divided by what the surface reflects ([`illuminance`]), which takes nothing. That is exact on
//! matt surfaces, and nearly so on what is hardly glossy ([`readable`]): a gloss shows the lamp that it mirrors, as if the
//! floor were brighter there.

use crate::color::Rgb;
use crate::eye::Meter;
use crate::geometry::Ray;
use crate::material::{Class, Material};
use crate::scene::{Scene, View};
use crate::world::World;
use std::f32::consts::PI;

/// Least reflectance by which anything is divided: beneath it noise is all that is left.
const LEAST: f32 = 0.01;

/// Most that a readable surface reflects sharply, met at a right angle.
const GLOSS: f32 = 0.06;

/// The meters that lie on what is seen in the middle of each pixel, row by row, on the side of the eye; `None` where
/// nothing is, and on what has no dull lobes.
pub fn receivers(world: &World, view: &View) -> Vec<Option<Meter>> {
    let pixels = (0..view.height).flat_map(|y| (0..view.width).map(move |x| (x, y)));
    let meter = |(x, y): (u32, u32)| {
        let ray = view.ray(x as f32 + 0.5, y as f32 + 0.5);
        // Of a section what is cut off is not there.
        let start = ray.origin + ray.direction * view.skipped(ray.direction);
        let surface = world.closest(&Ray::new(start, ray.direction))?;
        let dull = !surface.albedo(Class::Dull).is_black();
        dull.then(|| Meter { position: surface.spawn(surface.normal), normal: surface.normal })
    };
    pixels.map(meter).collect()
}

/// E = π L/ρ in each channel, and of these the luminance [lx]: what a matt surface receives that sends out `radiance` [cd/m²]
/// and reflects `albedo`; `None` where a channel is hardly reflected.
pub fn illuminance(radiance: Rgb, albedo: Rgb) -> Option<f32> {
    let received = Rgb::new(radiance.r / albedo.r, radiance.g / albedo.g, radiance.b / albedo.b) * PI;
    let reflected = albedo.to_array().iter().all(|c| *c >= LEAST);
    Some(received.luminance()).filter(|lux| reflected && lux.is_finite())
}

/// Whether what is seen of a material tells what it receives: it sends on, in all directions alike, nearly all that it sends on
/// at all, and nothing of its own.
pub fn is_readable(m: &Material) -> bool {
    let albedo = |class| m.bsdf.albedo(class, glam::Vec3::Z).luminance();
    albedo(Class::Sharp) <= GLOSS && albedo(Class::Dull) > 0.0 && !m.bsdf.transmits() && m.emission.is_black()
}

/// Of each instance whether all of its surfaces are readable.
pub fn readable(scene: &Scene) -> Vec<bool> {
    let plain: Vec<bool> = scene.materials.iter().map(is_readable).collect();
    let all = |worn: &[u32]| worn.iter().all(|m| plain.get(*m as usize) == Some(&true));
    let meshes: Vec<bool> = scene.meshes.iter().map(|mesh| all(&mesh.materials)).collect();
    scene.instances.iter().map(|i| meshes.get(i.mesh as usize) == Some(&true)).collect()
}
