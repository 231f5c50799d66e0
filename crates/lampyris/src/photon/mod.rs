//! Caustic photons: light that comes to a dull surface over sharp ones [Jarosz05; Wald et al. 2002].
//!
//! Photons leave the lights and the vertices of the walk, aimed at what reflects or refracts sharply (`aim`), those that
//! fly alike one after the other (`flight`). Each follows sharp lobes alone and stays at every dull surface that it meets
//! after one of them (`follow`). A density estimate tells what a point receives ([`Grid`]); its radius shrinks from batch
//! to batch, so that the mean of all batches has no bias in the end [Knaus and Zwicker 2011]. Photons over a single planar
//! mirror are left out: that light is the part *mirror*. Nothing here knows of pixels; a map follows from world, settings,
//! walk and batch.

mod aim;
mod flight;
mod follow;
mod grid;

pub use grid::Grid;

use crate::color::Rgb;
use crate::light::Emitter;
use crate::particle::{Plan, Vpl, Walk};
use crate::sequence;
use crate::settings::{Batch, Settings};
use crate::world::{Surface, World};
use aim::Aim;
use flight::trace;
use glam::Vec3;
use std::f32::consts::PI;

/// Photons from lights for each light path whose vertices send photons: if the batch has fewer paths, photons have a walk
/// of their own, or the few vertices near a body would throw their images onto the walls.
const PER_PATH: u32 = 4;

/// The first radius, in mean distances between photons if all of a kind lay evenly in the shadows of the bodies.
const RADIUS: [f32; 2] = [3.0, 8.0];

/// The largest first radius, in radii of the scene.
const WIDEST: f32 = 0.05;

/// α of progressive photon mapping: the share of each batch's photons that is kept as the radius shrinks.
const KEPT: f64 = 2.0 / 3.0;

/// Light that came to a dull surface over a sharp one.
#[derive(Clone, Copy, Debug)]
pub struct Photon {
    /// Where it lies [m].
    pub position: Vec3,
    /// Flux, as the BSDF there sees it [lm].
    pub flux: Rgb,
    /// Unit direction that it came from.
    pub wi: Vec3,
    /// Unit geometric normal on the side that it came from.
    pub normal: Vec3,
    /// The emitter that its light is from.
    pub emitter: u32,
}

/// The photons of one batch.
#[derive(Clone, Debug)]
pub struct Photons {
    /// From the lights: L S⁺ x.
    pub near: Grid,
    /// From vertices of the walk: L (S|D)* D S⁺ x.
    pub far: Grid,
    /// Of each emitter, which of the walks it is in.
    places: Vec<Option<usize>>,
    /// Rays that it took.
    pub rays: u64,
}

/// The points that shine for one emitter: itself, or vertices of the walk.
enum Origin<'a, 'w> {
    /// With what its light is multiplied by.
    Light(&'a Emitter, Rgb),
    /// Vertices with the running sum of the flux that they send toward sharp bodies, each of the light that a single
    /// class would see: so many times too bright.
    Vertices(Vec<(f64, &'a Vpl<'w>)>, f64),
}

/// Photons of one kind of one emitter.
struct Source<'a, 'w> {
    emitter: u32,
    origin: Origin<'a, 'w>,
    count: u32,
    /// Number in its sequence of the first of them.
    first: u32,
    seed: u32,
    /// Whether light over a single planar mirror stays, too.
    mirrored: bool,
}

impl Photons {
    /// Traces and sorts the photons of a batch: those of the plan's layers given, of which the batch's walks are at hand.
    /// No photon of a group depends on which others are given.
    pub fn new(
        world: &World,
        settings: &Settings,
        plan: &Plan,
        groups: &[usize],
        walks: &[Walk<'_>],
        batch: Batch,
    ) -> Photons {
        let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
        let seed = sequence::hash(settings.seed, replicate);
        let paths = settings.photons.div_ceil(PER_PATH);
        let own = (settings.paths < paths).then(|| {
            let seed = sequence::hash(settings.seed, u32::from(b'v'));
            let alone =
                Settings { passes: Some(1), interleave: [1, 1], light_points: None, ..settings.clone() };
            let settings = Settings { paths, seed, ..alone };
            let plan = plan.again(world, &settings);
            let walk = |group: &usize| Walk::of_layer(world, &settings, &plan, batch, *group);
            groups.iter().map(walk).collect::<Vec<_>>()
        });
        let places: Vec<Option<usize>> = (0..world.emitters().len() as u32)
            .map(|emitter| groups.iter().position(|group| *group == plan.layer_of(emitter)))
            .collect();
        let (walks, classes) = own.as_deref().map_or((walks, settings.classes()), |own| (own, 1));
        let tint = |emitter: u32| places[emitter as usize].map_or(Rgb::BLACK, |_| plan.tint(emitter));
        let lights = lights(world, settings.photons, &tint, block, sequence::hash(seed, u32::from(b'k')));
        let vertices =
            vertices(world, settings, (walks, classes), block, sequence::hash(seed, u32::from(b'w')));
        let kinds = [(lights, RADIUS[0]), (vertices, RADIUS[1])];
        let shrunk = shrunk(block).sqrt() as f32;
        let mut rays = own.iter().flatten().map(|walk| walk.rays).sum();
        let [near, far] = kinds.map(|(sources, radius)| {
            let (photons, traced) = trace(world, &sources);
            rays += traced;
            let bounds = world.bounds();
            let origin = bounds.center - bounds.radius;
            Grid::new(photons, origin, radius * spacing(world, settings.photons) * shrunk)
        });
        Photons { near, far, places, rays }
    }

    /// Adds the illuminance that photons bring to the side of a surface that `normal` points to [lx], group by group.
    pub fn irradiance(&self, x: Vec3, normal: Vec3, out: &mut [Rgb]) {
        for grid in [&self.near, &self.far] {
            grid.irradiance(x, normal, |emitter, light| self.add(emitter, light, out));
        }
    }

    /// Adds the radiance that the dull lobes of `x` send toward its `wo` of the light that photons brought [cd/m²], group by
    /// group.
    pub fn radiance(&self, x: &Surface<'_>, out: &mut [Rgb]) {
        for grid in [&self.near, &self.far] {
            grid.radiance(x, |emitter, light| self.add(emitter, light, out));
        }
    }

    #[inline]
    fn add(&self, emitter: u32, light: Rgb, out: &mut [Rgb]) {
        if let Some(place) = self.places[emitter as usize] {
            out[place] += light;
        }
    }
}

/// Traces photons from the lights alone, L S⁺ x: of all together `count`, block after block, the light of each emitter
/// multiplied by a tint, by a seed. Those over a single planar mirror come along where `mirrored`. Returns the rays that it took,
/// too.
pub fn from_lights(
    world: &World,
    count: u32,
    tint: &dyn Fn(u32) -> Rgb,
    (block, seed): (u32, u32),
    mirrored: bool,
) -> (Vec<Photon>, u64) {
    let sources = lights(world, count, tint, block, seed).into_iter();
    trace(world, &sources.map(|source| Source { mirrored, ..source }).collect::<Vec<_>>())
}

/// Photons that start on the emitters: each its share of them, at least one where it has any; none where it is dark, or its
/// tint black.
fn lights<'a, 'w>(
    world: &'a World,
    count: u32,
    tint: &dyn Fn(u32) -> Rgb,
    block: u32,
    seed: u32,
) -> Vec<Source<'a, 'w>> {
    let source = |(emitter, (light, share)): (u32, (&'a Emitter, &f32))| {
        let tint = tint(emitter);
        let silent = light.is_dark() || tint == Rgb::BLACK;
        let share = if silent { 0.0 } else { f64::from(*share) };
        let count = (f64::from(count) * share).ceil() as u32;
        Source {
            emitter,
            origin: Origin::Light(light, tint),
            count,
            first: block.wrapping_mul(count),
            seed: sequence::hash(seed, emitter),
            mirrored: false,
        }
    };
    (0..).zip(world.emitters().iter().zip(world.shares())).map(source).collect()
}

/// Photons that start at vertices of the walk, for each emitter by the light that its vertices send toward bodies.
fn vertices<'a, 'w>(
    world: &World,
    settings: &Settings,
    (walks, classes): (&'a [Walk<'w>], u32),
    block: u32,
    seed: u32,
) -> Vec<Source<'a, 'w>> {
    let mut running: Vec<Vec<(f64, &Vpl<'w>)>> = vec![Vec::new(); world.emitters().len()];
    for vpl in walks.iter().flat_map(Walk::within) {
        let running = &mut running[vpl.emitter as usize];
        let flux = f64::from(Aim::new(world, vpl).flux());
        if flux > 0.0 {
            running.push((running.last().map_or(0.0, |(sum, _)| *sum) + flux, vpl));
        }
    }
    let number = (0..).zip(running).filter(|(_, running)| !running.is_empty());
    let source = |(emitter, running): (u32, Vec<(f64, &'a Vpl<'w>)>)| {
        let share = f64::from(world.shares()[emitter as usize]);
        let count = (f64::from(settings.photons) * share).ceil() as u32;
        Source {
            emitter,
            origin: Origin::Vertices(running, f64::from(classes)),
            count,
            first: block.wrapping_mul(count),
            seed: sequence::hash(seed, emitter),
            mirrored: false,
        }
    };
    number.map(source).collect()
}

/// Mean distance between so many photons, were they spread evenly in the shadows of all sharp bodies, each by what it is
/// worth [m]; within bounds that the scene sets.
fn spacing(world: &World, count: u32) -> f32 {
    let shadow: f32 = world.bodies().all().iter().map(|b| PI * b.radius * b.radius * b.worth).sum();
    let size = world.bounds().radius;
    (shadow / count.max(1) as f32).sqrt().clamp(1e-6 * size, WIDEST * size)
}

/// r²/r₁² in a randomisation's batch number `block`, from 0: Π (i + α)/(i + 1) over i = 1 … `block` [Knaus and Zwicker
/// 2011], by Γ functions.
fn shrunk(block: u32) -> f64 {
    let b = f64::from(block);
    libm::exp(libm::lgamma(b + 1.0 + KEPT) - libm::lgamma(1.0 + KEPT) - libm::lgamma(b + 2.0))
}
