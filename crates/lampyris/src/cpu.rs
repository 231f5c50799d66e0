//! The back end of the machine at hand: tiles in parallel on a pool of threads.
//!
//! A tile's pixels are summed by one thread in a fixed order, so the picture does not know how many threads there are.

use crate::backend::{Backend, Batch, Rays, Settings, Statistics};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::eye::{Eye, Rect, Sampling, Tile};
use crate::frame::{Auxiliary, Frame};
use crate::integrator::{self, Integrator, Pass};
use crate::particle::{Plan, Walk};
use crate::photon::Photons;
use crate::scene::Scene;
use crate::sequence::{self, jittered_hammersley};
use crate::world::World;
use rayon::prelude::*;
use std::ops::Range;

/// Edge of a tile [pixels]: its visible points and sums stay in the nearest cache.
const TILE: u32 = 16;

/// All cores of this machine, or as many threads as one likes.
pub struct Cpu {
    pool: rayon::ThreadPool,
    job: Option<Job>,
}

/// What `begin` was given.
struct Job {
    world: World,
    eye: Eye,
    settings: Settings,
    plan: Plan,
    integrators: Vec<&'static dyn Integrator>,
    frame: Frame,
    statistics: Statistics,
}

impl Cpu {
    /// A back end on `threads` threads; on all cores where `None`.
    ///
    /// # Errors
    /// [`Error::BadSetting`] if the system refuses the threads.
    pub fn new(threads: Option<usize>) -> Result<Cpu> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .build()
            .map_err(|e| Error::BadSetting(format!("cannot start the threads: {e}; ask for fewer")))?;
        Ok(Cpu { pool, job: None })
    }

    /// Does something on the threads of this back end, [`World::new`] for instance.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// [`Backend::begin`] with a world that is already built, where a view had to be found in it first.
    pub fn begin_world(&mut self, world: World, eye: Eye, settings: &Settings) -> Result<()> {
        settings.check()?;
        let integrators = integrator::select(&settings.parts)?;
        let names: Vec<&str> = integrators.iter().map(|i| i.name()).collect();
        let (width, height) = eye.size();
        self.job = Some(Job {
            plan: Plan::new(&world, settings),
            frame: Frame::new(width, height, &names, settings.replicates, settings.auxiliary),
            statistics: Statistics::default(),
            settings: settings.clone(),
            world,
            eye,
            integrators,
        });
        Ok(())
    }

    /// The world in use, once `begin` was called.
    pub fn world(&self) -> Option<&World> {
        self.job.as_ref().map(|j| &j.world)
    }

    fn job(&mut self) -> Result<&mut Job> {
        self.job.as_mut().ok_or_else(|| Error::BadSetting("nothing to render: call begin first".into()))
    }
}

impl Backend for Cpu {
    fn begin(&mut self, scene: Scene, eye: Eye, settings: &Settings) -> Result<()> {
        settings.check()?;
        let world = self.install(|| World::new(scene));
        self.begin_world(world, eye, settings)
    }

    fn add(&mut self, batch: Batch) -> Result<()> {
        let Cpu { pool, job } = self;
        let job =
            job.as_mut().ok_or_else(|| Error::BadSetting("nothing to render: call begin first".into()))?;
        pool.install(|| job.add(batch));
        Ok(())
    }

    fn frame(&mut self) -> Result<&Frame> {
        self.job().map(|j| &j.frame)
    }

    fn statistics(&self) -> Statistics {
        self.job.as_ref().map(|j| j.statistics).unwrap_or_default()
    }
}

/// Pieces of work that a batch is cut into at least, however small the picture: a handful of meters keeps all threads
/// busy. A fixed number, since cuts decide the last bits of sums.
const PIECES: u32 = 64;

/// What some eye passes in one tile add to the frame.
struct Summed {
    rect: Rect,
    parts: Vec<Vec<Rgb>>,
    auxiliary: Option<Auxiliary>,
    rays: Rays,
    non_finite: u64,
}

impl Job {
    fn add(&mut self, batch: Batch) {
        let walk = Walk::new(&self.world, &self.settings, &self.plan, batch);
        // Meters hang in the air, where no photon stays: they take the oracle.
        let useful = matches!(self.eye, Eye::Camera(_)) && self.world.has_sharp_surfaces();
        let photons = (useful && integrator::gather_photons(&self.integrators))
            .then(|| Photons::new(&self.world, &self.settings, &walk, batch));
        let (width, height) = self.eye.size();
        let passes = self.settings.eye_passes();
        let tiles = width.div_ceil(TILE) * height.div_ceil(TILE);
        let run = passes.div_ceil(PIECES.div_ceil(tiles.max(1)));
        let pieces: Vec<(Rect, Range<u32>)> = (0..height)
            .step_by(TILE as usize)
            .flat_map(|y| (0..width).step_by(TILE as usize).map(move |x| (x, y)))
            .map(|(x, y)| Rect { x, y, width: TILE.min(width - x), height: TILE.min(height - y) })
            .flat_map(|rect| (0..passes).step_by(run as usize).map(move |p| (rect, p..passes.min(p + run))))
            .collect();
        let done: Vec<Summed> = pieces
            .par_iter()
            .map(|(rect, numbers)| self.render(*rect, numbers.clone(), batch, &walk, photons.as_ref()))
            .collect();

        // A batch is summed by itself before it is added: others may then merge it to the same bits.
        let scale = 1.0 / passes as f32;
        let replicate = batch.index % self.settings.replicates;
        let mut done = done.into_iter().peekable();
        while let Some(mut tile) = done.next() {
            tile.parts.iter_mut().flatten().for_each(|v| *v *= scale);
            note(&tile, width, &mut self.statistics, &mut self.frame);
            while let Some(more) = done.next_if(|more| more.rect == tile.rect) {
                let pairs = tile.parts.iter_mut().flatten().zip(more.parts.iter().flatten());
                pairs.for_each(|(sum, v)| *sum += *v * scale);
                note(&more, width, &mut self.statistics, &mut self.frame);
            }
            self.frame.add(replicate, tile.rect, &tile.parts);
        }
        self.frame.count(replicate);
        if let Some(sums) = self.frame.auxiliary_mut() {
            sums.samples += passes;
        }
        self.statistics.rays.particle += walk.rays + photons.as_ref().map_or(0, |p| p.rays);
        self.statistics.vpls += (walk.lights.len() + walk.vpls.len()) as u64;
    }

    /// Some eye passes of a batch in one tile.
    fn render(
        &self,
        rect: Rect,
        numbers: Range<u32>,
        batch: Batch,
        walk: &Walk<'_>,
        photons: Option<&Photons>,
    ) -> Summed {
        let pixels = (rect.width * rect.height) as usize;
        let mut parts = vec![vec![Rgb::BLACK; pixels]; self.integrators.len()];
        let mut once = vec![Rgb::BLACK; pixels];
        let mut auxiliary = self.settings.auxiliary.then(|| Auxiliary::new(pixels));
        let mut rays = Rays::default();
        let mut non_finite = 0;
        let mut tile = self.eye.tile(&self.world, rect);
        for number in numbers {
            let sampling = self.sampling(batch, number);
            self.eye.look(&sampling, &mut tile);
            rays.eye += tile.rays;
            let pass = Pass {
                world: &self.world,
                settings: &self.settings,
                plan: &self.plan,
                eye: &self.eye,
                lights: walk.lights_of(number),
                vpls: walk.vpls_of(number),
                photons,
                sampling,
            };
            for (integrator, sum) in self.integrators.iter().zip(&mut parts) {
                once.fill(Rgb::BLACK);
                integrator.add(&pass, &tile, &mut once, &mut rays);
                for (s, v) in sum.iter_mut().zip(&once) {
                    if v.is_finite() {
                        *s += *v;
                    } else {
                        non_finite += 1;
                    }
                }
            }
            if let Some(sums) = &mut auxiliary {
                note_first(&tile, sums);
            }
        }
        Summed { rect, parts, auxiliary, rays, non_finite }
    }

    /// The sample that an eye pass takes: a jittered Hammersley point for its number, both coordinates shifted
    /// mod 1 by numbers drawn anew in each batch, without which the survivors among the paths, a prefix, would only
    /// see one side of each pixel.
    fn sampling(&self, batch: Batch, number: u32) -> Sampling {
        let settings = &self.settings;
        let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
        let seed = sequence::hash(sequence::hash(settings.seed, replicate), u32::from(b'e'));
        let passes = settings.eye_passes();
        let jitter = sequence::hash(seed, block);
        let offset = [0, 1].map(|d| {
            let shifted = jittered_hammersley(number, passes, d, jitter) + sequence::uniform(seed, block, d);
            shifted.fract()
        });
        Sampling { offset, index: block.wrapping_mul(passes).wrapping_add(number), seed }
    }
}

/// What a piece of work counted, and what its paths met first.
fn note(piece: &Summed, width: u32, statistics: &mut Statistics, frame: &mut Frame) {
    statistics.rays += piece.rays;
    statistics.non_finite += piece.non_finite;
    if let (Some(sums), Some(part)) = (frame.auxiliary_mut(), &piece.auxiliary) {
        (0..part.depth.len()).for_each(|k| sums.add(place(piece.rect, width, k), part, k));
    }
}

/// Adds what the paths of a tile met first.
fn note_first(tile: &Tile<'_>, sums: &mut Auxiliary) {
    for packet in &tile.packets {
        for k in packet.lanes() {
            let Some(first) = packet.first(k) else { continue };
            let at = packet.pixels[k] as usize;
            sums.albedo[at] += first.albedo;
            sums.normal[at] += Rgb::new(first.normal.x, first.normal.y, first.normal.z);
            sums.depth[at] += first.depth;
            if sums.object[at] == 0 {
                sums.object[at] = first.instance + 1;
            }
        }
    }
}

/// Where in the picture, row by row, a tile's pixel lies.
fn place(rect: Rect, width: u32, k: usize) -> usize {
    let (x, y) = rect.pixel(k as u32);
    y as usize * width as usize + x as usize
}
