//! The back end of the machine at hand: tiles in parallel on a pool of threads.
//!
//! A tile's pixels are summed by one thread in a fixed order, so the picture does not know how many threads there are.

use crate::backend::{Backend, Batch, Rays, Settings, Statistics};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::eye::{Eye, Rect, Sampling, Tile};
use crate::filter::{self, Glimpse, Seen};
use crate::frame::{Auxiliary, Frame};
use crate::geometry::{lane, lanes};
use crate::integrator::{self, Integrator, Pass};
use crate::particle::{Plan, Walk};
use crate::photon::Photons;
use crate::scene::{Edit, Scene};
use crate::sequence::{self, jittered_hammersley};
use crate::world::{Changes, World};
use rayon::prelude::*;
use std::ops::Range;

/// Least edge of a tile [pixels]: its visible points and sums stay in the nearest cache.
const TILE: u32 = 48;

/// How far from each other's tangent plane the vertices of neighbouring pixels may lie and still be of one surface
/// [edges of a pixel].
const SLACK: f32 = 1.7;

/// The least edge for n interleaved pixels: whole packets of each class.
fn tile_edge(n: u32) -> u32 {
    TILE.div_ceil(4 * n) * 4 * n
}

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
    /// What the last batch saw, if it is to be filtered.
    seen: Option<Seen>,
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
        // Meters have no neighbours.
        let filter = settings.filter && matches!(eye, Eye::Camera(_));
        let settings = Settings { filter, ..settings.clone() };
        self.job = Some(Job {
            plan: Plan::new(&world, &settings),
            frame: Frame::new(width, height, &names, &settings),
            seen: settings.filter.then(|| Seen::new(width, height)),
            statistics: Statistics::default(),
            settings,
            world,
            eye,
            integrators,
        });
        Ok(())
    }

    /// Starts afresh in the world in use.
    pub fn restart(&mut self, eye: Eye, settings: &Settings) -> Result<()> {
        let world = self.job.take().ok_or_else(nothing)?.world;
        self.begin_world(world, eye, settings)
    }

    /// The world in use, once `begin` was called.
    pub fn world(&self) -> Option<&World> {
        self.job.as_ref().map(|j| &j.world)
    }

    /// Changes the world in use, on the threads of this back end. What has been summed is of the world before: it is the
    /// caller's to [`Cpu::restart`].
    ///
    /// # Errors
    /// As [`World::apply`], and [`Error::BadSetting`] before `begin`.
    pub fn edit(&mut self, edit: &Edit) -> Result<Changes> {
        let Cpu { pool, job } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
        pool.install(|| job.world.apply(edit))
    }

    fn job(&mut self) -> Result<&mut Job> {
        self.job.as_mut().ok_or_else(nothing)
    }
}

fn nothing() -> Error {
    Error::BadSetting("nothing to render: call begin first".into())
}

impl Backend for Cpu {
    fn begin(&mut self, scene: Scene, eye: Eye, settings: &Settings) -> Result<()> {
        settings.check()?;
        let world = self.install(|| World::new(scene));
        self.begin_world(world, eye, settings)
    }

    fn add(&mut self, batch: Batch) -> Result<()> {
        let Cpu { pool, job } = self;
        let job = job.as_mut().ok_or_else(nothing)?;
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
    glimpse: Option<Glimpse>,
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
        let width = self.eye.size().0;
        let passes = self.settings.eye_passes();
        let rects = self.rects(batch);
        let run = passes.div_ceil(PIECES.div_ceil(rects.len().max(1) as u32));
        let pieces: Vec<(Rect, Range<u32>)> = rects
            .into_iter()
            .flat_map(|rect| (0..passes).step_by(run as usize).map(move |p| (rect, p..passes.min(p + run))))
            .collect();
        let sampling = self.sampling(batch, 0);
        let done: Vec<Summed> = pieces
            .par_iter()
            .map(|(rect, numbers)| self.render(*rect, numbers.clone(), batch, &walk, photons.as_ref()))
            .collect();

        if let (Some(seen), Some(shown)) = (&mut self.seen, self.frame.shown_mut()) {
            seen.assemble(&done.iter().filter_map(|piece| piece.glimpse.as_ref()).collect::<Vec<_>>());
            let further = filter::show(&self.world, &self.eye, &self.settings, &sampling, seen, shown);
            self.statistics.rays.eye += further;
        }
        let replicate = batch.index % self.settings.replicates;
        let mut tiles: Vec<(Rect, Vec<Vec<Rgb>>)> = Vec::with_capacity(done.len());
        for piece in done {
            note(&piece, width, &mut self.statistics, &mut self.frame);
            match tiles.last_mut().filter(|(rect, _)| *rect == piece.rect) {
                Some((_, parts)) => {
                    let pairs = parts.iter_mut().flatten().zip(piece.parts.iter().flatten());
                    pairs.for_each(|(sum, v)| *sum += *v);
                }
                None => tiles.push((piece.rect, piece.parts)),
            }
        }
        // A batch is summed by itself before it is added: others may then merge it to the same bits.
        self.frame.add(replicate, &tiles);
        self.frame.count(replicate);
        if let Some(sums) = self.frame.auxiliary_mut() {
            sums.samples += passes;
        }
        self.statistics.rays.particle += walk.rays + photons.as_ref().map_or(0, |p| p.rays);
        self.statistics.vpls += (walk.lights.len() + walk.vpls.len()) as u64;
    }

    /// The picture cut into tiles, elsewhere in each batch: what pixels of a tile have in common must not show.
    fn rects(&self, batch: Batch) -> Vec<Rect> {
        let (width, height) = self.eye.size();
        let seed = sequence::hash(sequence::hash(self.settings.seed, u32::from(b't')), batch.index);
        let cuts = |size: u32, axis: usize| {
            let n = self.settings.interleave[axis];
            let edge = tile_edge(n);
            // Tiles begin at multiples of n, or classes would not meet.
            let first = n * (sequence::hash(seed, axis as u32) % (edge / n) + 1);
            let starts: Vec<u32> = std::iter::once(0).chain((first..size).step_by(edge as usize)).collect();
            let ends: Vec<u32> = starts[1..].iter().copied().chain([size]).collect();
            starts.into_iter().zip(ends).map(|(start, end)| (start, end - start)).collect::<Vec<_>>()
        };
        let columns = cuts(width, 0);
        let rows = cuts(height, 1);
        let rects = rows.iter().flat_map(|(y, height)| {
            columns.iter().map(move |(x, width)| Rect { x: *x, y: *y, width: *width, height: *height })
        });
        rects.collect()
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
        let mut tiles = self.eye.tiles(&self.world, rect, self.settings.interleave);
        for number in numbers {
            let sampling = self.sampling(batch, number);
            for tile in &mut tiles {
                self.eye.look(&sampling, tile);
                rays.eye += tile.rays;
            }
            let first = number * tiles.len() as u32;
            let passes: Vec<Pass<'_>> = (first..first + tiles.len() as u32)
                .map(|class| Pass {
                    world: &self.world,
                    settings: &self.settings,
                    plan: &self.plan,
                    eye: &self.eye,
                    lights: walk.lights_of(class),
                    vpls: walk.vpls_of(class),
                    photons,
                    beacons: walk.beacons_of(class),
                    sampling,
                })
                .collect();
            for (integrator, sum) in self.integrators.iter().zip(&mut parts) {
                once.fill(Rgb::BLACK);
                for (pass, tile) in passes.iter().zip(&tiles) {
                    integrator.add(pass, tile, &mut once, &mut rays);
                }
                for (s, v) in sum.iter_mut().zip(&once) {
                    if v.is_finite() {
                        *s += *v;
                    } else {
                        non_finite += 1;
                    }
                }
            }
            if let Some(sums) = &mut auxiliary {
                tiles.iter().for_each(|tile| note_first(tile, sums));
            }
        }
        let scale = 1.0 / self.settings.eye_passes() as f32;
        parts.iter_mut().flatten().for_each(|v| *v *= scale);
        let glimpse = self.seen.is_some().then(|| self.glimpse(rect, &tiles, &parts));
        Summed { rect, parts, auxiliary, glimpse, rays, non_finite }
    }

    /// What a batch of one eye pass saw in a tile.
    fn glimpse(&self, rect: Rect, tiles: &[Tile<'_>], parts: &[Vec<Rgb>]) -> Glimpse {
        let mut glimpse = Glimpse::new(rect);
        let of = |smooth: bool| -> Vec<&[Rgb]> {
            let kind = |i: &&dyn Integrator| i.name() != "emission" && i.is_smooth() == smooth;
            let pairs = self.integrators.iter().zip(parts);
            pairs.filter(|(i, _)| kind(i)).map(|(_, part)| part.as_slice()).collect()
        };
        let (smooth, rest) = (of(true), of(false));
        let sum = |parts: &[&[Rgb]], at: usize| parts.iter().fold(Rgb::BLACK, |s, part| s + part[at]);
        for p in tiles.iter().flat_map(|tile| &tile.packets) {
            for k in p.lanes() {
                let at = p.pixels[k] as usize;
                glimpse.light(at, sum(&smooth, at), sum(&rest, at), p.emission[k]);
            }
            for k in lanes(p.live) {
                let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
                let tint = p.throughput[k] * p.reflectance[k];
                let slack = self.eye.pixel_size(position) * SLACK;
                glimpse.place(p.pixels[k] as usize, position, normal, p.alike(k), tint, slack);
            }
        }
        glimpse
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
