//! What several experiments share: a world with an eye on it, and instant radiosity as the report of 1997 has it.

use crate::effort::Effort;
use crate::error::Result;
use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Absorption, Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::light::Shine;
use lampyris::material::{Bsdf, Class, Material};
use lampyris::output::Picture;
use lampyris::particle::{Plan, Vpl, Walk};
use lampyris::scene::{Camera, Scene, View, find_view};
use lampyris::sequence::{Sequence, jittered_hammersley};
use lampyris::world::{Surface, World};
use rayon::prelude::*;

/// The Cornell box as its file's comment looks at it.
pub(crate) const CORNELL: Look =
    Look { eye: [2.78, 2.73, -8.0], target: [2.78, 2.73, 0.0], up: Vec3::Y, fov_y: 39.3 };

/// The still life of caustics as its file's comment looks at it.
pub(crate) const RING: Look =
    Look { eye: [0.03, -0.62, 0.28], target: [0.0, 0.0, 0.05], up: Vec3::Z, fov_y: 34.0 };

/// Where to look from [m, degrees].
#[derive(Clone, Copy)]
pub(crate) struct Look {
    pub(crate) eye: [f32; 3],
    pub(crate) target: [f32; 3],
    pub(crate) up: Vec3,
    pub(crate) fov_y: f32,
}

impl Look {
    /// The view on so many pixels.
    pub(crate) fn view(self, [width, height]: [u32; 2]) -> View {
        let (eye, target) = (self.eye.into(), self.target.into());
        View::new(&Camera { name: String::new(), eye, target, up: self.up, fov_y: self.fov_y }, width, height)
    }
}

/// What a scene's own camera sees, or one for which a place is found.
pub(crate) fn found_view(cpu: &Cpu, world: &World, [width, height]: [u32; 2]) -> View {
    let closest = |ray: &lampyris::geometry::Ray| world.tracer().closest(ray);
    let camera = match world.scene().cameras.first() {
        Some(camera) => camera.clone(),
        None => cpu.install(|| find_view(world.scene(), &closest, width as f32 / height as f32).camera),
    };
    View::new(&camera, width, height)
}

/// The oracle's picture: so many samples a pixel of the path tracer.
pub(crate) fn oracle(effort: &Effort<'_>, scene: &Scene, view: &View, samples: u32) -> Result<Vec<Rgb>> {
    oracle_by(effort, scene, view, (samples, 9_001))
}

/// The same by another seed.
pub(crate) fn oracle_by(
    effort: &Effort<'_>,
    scene: &Scene,
    view: &View,
    (samples, seed): (u32, u32),
) -> Result<Vec<Rgb>> {
    let mut cpu = Cpu::new(None)?;
    let paths = samples.min(16);
    let settings = Settings { parts: vec!["path".into()], paths, seed, ..Settings::default() };
    effort.render(&mut cpu, (scene.clone(), Eye::Camera(view.clone())), &settings, samples / paths)?;
    Ok(cpu.frame()?.mean())
}

/// The same scene with the diffuse part alone of what is glossy or a mirror by Ward's model.
pub(crate) fn without_gloss(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for material in &mut scene.materials {
        if let Bsdf::Ward(ward) = material.bsdf {
            material.bsdf = Bsdf::Diffuse(ward.base);
        }
    }
    scene
}

/// The same scene with everything whose name ends so made of a material.
pub(crate) fn made_of(scene: &Scene, name: &str, material: Material) -> Scene {
    let mut scene = scene.clone();
    let number = scene.materials.len() as u32;
    scene.materials.push(material);
    let Scene { meshes, instances, .. } = &mut scene;
    for instance in instances.iter().filter(|i| i.name.ends_with(name)) {
        meshes[instance.mesh as usize].materials.fill(number);
    }
    scene
}

/// What of a picture shows, in the middle of a pixel, things whose name ends so.
pub(crate) fn of_thing(world: &World, view: &View, picture: &[Rgb], name: &str) -> Vec<Rgb> {
    let shows = |k: u32| {
        let ray = view.ray((k % view.width) as f32 + 0.5, (k / view.width) as f32 + 0.5);
        let instances = &world.scene().instances;
        world.closest(&ray).is_some_and(|x| instances[x.instance as usize].name.ends_with(name))
    };
    (0..).zip(picture).filter(|(k, _)| shows(*k)).map(|(_, c)| *c).collect()
}

/// A picture of light.
pub(crate) fn picture(view: &View, radiance: Vec<Rgb>) -> Picture {
    Picture::new(view.width, view.height, radiance)
}

/// Settings of the report's walk: Halton points, ⌊ρ̄ʲN⌋ particles in generation j, no clamp. Each path is a class.
pub(crate) fn of_1997(paths: u32) -> Settings {
    Settings {
        paths,
        passes: None,
        absorption: Absorption::Paper,
        sequence: Sequence::Halton,
        clamp: 0.0,
        ..Settings::default()
    }
}

/// Instant radiosity, particle by particle: every light a point, every pixel lit by all of them.
pub(crate) struct Literal<'a> {
    pub(crate) world: &'a World,
    pub(crate) view: &'a View,
    /// What surfaces do with the light of a point: their whole BSDF, or its dull lobes alone.
    pub(crate) classes: &'static [Class],
    /// The geometry term is clamped to this [m⁻²].
    pub(crate) bound: f32,
}

/// Subpixel offsets that take turns from light to light.
const OFFSETS: u32 = 4;

impl<'a> Literal<'a> {
    /// With the whole BSDF and without a clamp.
    pub(crate) fn new(world: &'a World, view: &'a View) -> Literal<'a> {
        Literal { world, view, classes: &[Class::Dull, Class::Sharp], bound: f32::INFINITY }
    }

    /// The light of a walk, and that of the lamps where they are seen.
    pub(crate) fn picture(&self, effort: &Effort<'_>, settings: &Settings, batch: u32) -> Result<Vec<Rgb>> {
        let plan = Plan::new(self.world, settings);
        let walk = Walk::new(self.world, settings, &plan, Batch { index: batch });
        let lights: Vec<Vpl<'_>> = walk.lights.iter().chain(&walk.vpls).copied().collect();
        // The lights of each class are as bright as if they were all.
        let share = 1.0 / settings.classes() as f32;
        let mut sum = self.lamps();
        for few in lights.chunks(64) {
            sum.iter_mut().zip(self.light_of(few)).for_each(|(sum, light)| *sum += light * share);
            effort.go_on_or_stop()?;
        }
        Ok(sum)
    }

    /// The light of points, without that of lamps seen directly.
    pub(crate) fn light_of(&self, lights: &[Vpl<'_>]) -> Vec<Rgb> {
        let pixel = |k: u32| {
            let seen: Vec<Option<Surface<'_>>> = (0..OFFSETS).map(|o| self.seen(k, o)).collect();
            let shade = |(number, light): (usize, &Vpl<'_>)| {
                seen[number % seen.len()].as_ref().map_or(Rgb::BLACK, |x| self.shade(x, light))
            };
            lights.iter().enumerate().map(shade).fold(Rgb::BLACK, |sum, light| sum + light)
        };
        (0..self.view.width * self.view.height).into_par_iter().map(pixel).collect()
    }

    /// What of a picture shows no lamp, not even at a pixel's edge.
    pub(crate) fn without_lamps(&self, picture: &[Rgb]) -> Vec<Rgb> {
        let is_plain = |k: u32| {
            let (x, y) = ((k % self.view.width) as f32, (k / self.view.width) as f32);
            let mut places =
                (0..9).map(|n| self.view.ray(x + (n % 3) as f32 * 0.5, y + (n / 3) as f32 * 0.5));
            places.all(|ray| self.world.closest(&ray).is_none_or(|s| s.emission().is_black()))
        };
        (0..).zip(picture).filter(|(k, _)| is_plain(*k)).map(|(_, c)| *c).collect()
    }

    fn lamps(&self) -> Vec<Rgb> {
        let pixel = |k: u32| {
            let seen = (0..OFFSETS).filter_map(|o| self.seen(k, o));
            seen.map(|x| x.emission()).fold(Rgb::BLACK, |sum, light| sum + light) * (1.0 / OFFSETS as f32)
        };
        (0..self.view.width * self.view.height).into_par_iter().map(pixel).collect()
    }

    fn seen(&self, pixel: u32, offset: u32) -> Option<Surface<'a>> {
        let [dx, dy] = [0, 1].map(|d| jittered_hammersley(offset, OFFSETS, d, 1));
        let (x, y) = ((pixel % self.view.width) as f32, (pixel / self.view.width) as f32);
        self.world.closest(&self.view.ray(x + dx, y + dy))
    }

    fn shade(&self, x: &Surface<'_>, light: &Vpl<'_>) -> Rgb {
        let Shine::Lambert(normal) = light.shine else { return Rgb::BLACK };
        let way = light.position - x.position;
        let square = way.length_squared();
        let wi = way / square.sqrt();
        let cosine = normal.dot(-wi);
        if cosine <= 0.0 || !square.is_normal() {
            return Rgb::BLACK;
        }
        let reflected = |class: &Class| x.eval(*class, x.wo, wi);
        let brdf = self.classes.iter().map(reflected).fold(Rgb::BLACK, |sum, f| sum + f);
        let term = (x.cosine(wi) * cosine / square).min(self.bound);
        if brdf.is_black() || term <= 0.0 || self.world.tracer().blocked(x.spawn(wi), light.position) {
            return Rgb::BLACK;
        }
        let intensity = light
            .gloss
            .as_ref()
            .map_or(light.intensity, |y| y.eval(Class::Dull, y.wo, -wi) * light.intensity);
        brdf * intensity * term
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use lampyris::import::{self, Options};
    use std::path::Path;

    /// The world of a scene that ships.
    pub(crate) fn shipped(name: &str) -> World {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name);
        World::new(import::load(&file, &Options::default()).expect("a scene").scene)
    }
}
