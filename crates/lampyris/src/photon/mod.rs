//! Caustic photons: light that comes to a dull surface over sharp ones [Jarosz05; Wald et al. 2002].
//!
//! Photons leave the lights and the vertices of the walk, aimed at what reflects or refracts sharply (`aim`). Each
//! follows sharp lobes alone and stays at every dull surface that it meets after one of them (`follow`). A density
//! estimate tells what a point receives ([`Grid`]); its radius shrinks from batch to batch, so that the mean of all
//! batches has no bias in the end [Knaus and Zwicker 2011]. Photons over a single planar mirror are left out: that light
//! is the part *mirror*. Nothing here knows of pixels; a map follows from world, settings, walk and batch.

mod aim;
mod follow;
mod grid;

pub use grid::Grid;

use crate::color::Rgb;
use crate::light::Emitter;
use crate::particle::{Plan, Vpl, Walk};
use crate::sequence::{self, ledger::photon as ledger};
use crate::settings::{Batch, Settings};
use crate::world::{Surface, World};
use aim::Aim;
use follow::{Numbers, follow};
use glam::Vec3;
use rayon::prelude::*;
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

/// Photons that a thread traces at a time.
const RUN: usize = 256;

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
    Light(&'a Emitter),
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
}

impl Photons {
    /// Traces and sorts the photons of a batch: those of the light groups given, of which the batch's walks are at hand.
    /// No photon of a group depends on which others are given.
    pub fn new(
        world: &World,
        settings: &Settings,
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
            let plan = Plan::new(world, &settings);
            let walk = |group: &usize| Walk::of_group(world, &settings, &plan, batch, *group);
            groups.iter().map(walk).collect::<Vec<_>>()
        });
        let places: Vec<Option<usize>> = (0..world.emitters().len() as u32)
            .map(|emitter| groups.iter().position(|group| *group == world.group_of(emitter)))
            .collect();
        let (walks, classes) = own.as_deref().map_or((walks, settings.classes()), |own| (own, 1));
        let lights = lights(world, settings, &places, block, sequence::hash(seed, u32::from(b'k')));
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

/// Photons that start on the emitters that have a place: each its share of them, at least one where it has any; none where
/// it is dark.
fn lights<'a, 'w>(
    world: &'a World,
    settings: &Settings,
    places: &[Option<usize>],
    block: u32,
    seed: u32,
) -> Vec<Source<'a, 'w>> {
    let source = |(emitter, (light, share)): (u32, (&'a Emitter, &f32))| {
        let silent = light.is_dark() || places[emitter as usize].is_none();
        let share = if silent { 0.0 } else { f64::from(*share) };
        let count = (f64::from(settings.photons) * share).ceil() as u32;
        Source {
            emitter,
            origin: Origin::Light(light),
            count,
            first: block.wrapping_mul(count),
            seed: sequence::hash(seed, emitter),
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
    for (vpl, emitter) in walks.iter().flat_map(|walk| walk.vpls.iter().zip(&walk.sources)) {
        let running = &mut running[*emitter as usize];
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
        }
    };
    number.map(source).collect()
}

/// Traces all photons of some sources, and counts the rays.
fn trace(world: &World, sources: &[Source<'_, '_>]) -> (Vec<Photon>, u64) {
    let numbers: Vec<(usize, Vec<u32>)> = sources.iter().map(Source::order).enumerate().collect();
    let runs: Vec<(usize, &[u32])> =
        numbers.iter().flat_map(|(k, order)| order.chunks(RUN).map(|run| (*k, run))).collect();
    let done: Vec<(Vec<Photon>, u64)> = runs
        .par_iter()
        .map(|(source, run)| {
            let mut photons = Vec::with_capacity(run.len());
            let rays = run.iter().map(|i| sources[*source].photon(world, *i, &mut photons)).sum();
            (photons, rays)
        })
        .collect();
    let rays = done.iter().map(|(_, rays)| rays).sum();
    let mut photons = Vec::with_capacity(done.iter().map(|(photons, _)| photons.len()).sum());
    done.into_iter().for_each(|(run, _)| photons.extend(run));
    (photons, rays)
}

impl Source<'_, '_> {
    fn numbers(&self, i: u32) -> Numbers {
        Numbers { index: self.first.wrapping_add(i), seed: self.seed }
    }

    /// The numbers of its photons, those that take similar ways side by side: the next photon meets boxes and triangles
    /// that the last one has left in the caches.
    fn order(&self) -> Vec<u32> {
        let mut order: Vec<(u16, u32)> = (0..self.count)
            .into_par_iter()
            .with_min_len(RUN)
            .map(|i| {
                let [u, _, s, t] = self.numbers(i).four(ledger::POINT);
                let key = match self.origin {
                    Origin::Light(_) => cell(s, t),
                    Origin::Vertices(..) => (u * 65536.0) as u16,
                };
                (key, i)
            })
            .collect();
        order.par_sort_unstable();
        order.into_iter().map(|(_, i)| i).collect()
    }

    /// Traces the i-th photon; counts the rays.
    fn photon(&self, world: &World, i: u32, photons: &mut Vec<Photon>) -> u64 {
        let numbers = self.numbers(i);
        let [u, v, s, t] = numbers.four(ledger::POINT);
        let point;
        let (source, weight) = match &self.origin {
            Origin::Light(emitter) => {
                let p = emitter.point([u, v]);
                let (position, shine, intensity) = (p.position, p.shine, p.intensity);
                point = Vpl { position, shine, intensity, bound: f32::INFINITY, gloss: None };
                (&point, 1.0)
            }
            Origin::Vertices(running, classes) => {
                let total = running.last().map_or(0.0, |(sum, _)| *sum);
                let k = running.partition_point(|(sum, _)| *sum <= f64::from(u) * total);
                let Some((sum, vertex)) = running.get(k) else { return 0 };
                let own = sum - if k == 0 { 0.0 } else { running[k - 1].0 };
                (*vertex, (total / (own * classes)) as f32)
            }
        };
        let aim = Aim::new(world, source);
        let weight = weight / self.count as f32;
        let Some(shot) = aim.shoot(numbers.one(ledger::BODY), [s, t]) else { return 0 };
        follow(world, &shot, source, [weight, weight * aim.flux()], numbers, self.emitter, photons)
    }
}

/// The place of a point of the unit square on a curve through 128 × 128 cells whose neighbours are neighbours mostly: the
/// bits of both coordinates in turn.
fn cell(s: f32, t: f32) -> u16 {
    let spread = |x: f32| (0..7).fold(0, |all, bit| all | ((x * 128.0) as u16 >> bit & 1) << (2 * bit));
    spread(s) | spread(t) << 1
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
