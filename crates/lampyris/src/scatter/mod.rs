//! The random walk of 1996: light leaves the lamps, and at every surface is scattered by all that the surface does with
//! light [Keller96, §4.3; docs/light-transport.md, "The walk of 1996"].
//!
//! A path is a pure function of world, [`Rules`] and its number: all of its decisions are coordinates of one point of one
//! sequence (`sequence::ledger::scatter`). What happens where it arrives is the caller's business: photons are stored, light
//! is added to surface elements. The flux of an arrival is that of a path that were the only one; who takes the mean
//! over all paths from number 0 on has the light of the scene.
//!
//! It differs from `particle`, whose paths are dealt to lamps by fixed shares, thin out by generations and leave virtual
//! lights: here lamps are chosen by power, and generations are cut off or end by roulette, as the paper has it.

mod bounce;
mod start;

use crate::color::Rgb;
use crate::geometry::{Hit, Ray};
use crate::sequence::Generator;
use crate::world::{Surface, World};
use bounce::{Bounce, Die};
use glam::Vec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

pub use start::Lamps;

/// Paths that one thread walks at a time: what [`RandomWalk::paths`] returns is cut by this number and by no other.
pub const RUN: u32 = 1024;

/// Paths whose arrivals are held in memory before somebody sums them.
const WAVE: u32 = 64 * RUN;

/// Arrivals after which every path ends: of paths that lose nothing on their way one in 10⁸ lives to be cut off.
pub const MAX_ARRIVALS: u32 = 1024;

/// M of [Keller96, Table 1]: its points have 2M + 2 = 16 dimensions.
pub const PAPER_REFLECTIONS: u32 = 7;

/// How light is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rules {
    /// Where numbers come from.
    pub generator: Generator,
    /// What its randomisation is drawn by.
    pub seed: u32,
    /// How directions are found.
    pub inversion: Inversion,
    /// How paths end.
    pub ending: Ending,
}

/// How much of the integrand is inverted: what is not becomes a weight [Keller96, eqs. 4.5–4.7].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inversion {
    /// Nothing: θ and φ are uniform (4.5).
    Nothing,
    /// The projection term: directions by the cosine (4.6). Rows of Table 2 without *inv.*
    Cosine,
    /// The whole BSDF: a lobe by composition, a direction by inversion of the lobe (4.7).
    #[default]
    Bsdf,
}

/// How a path ends, unless it leaves the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Ending {
    /// With its M-th arrival: Σ_{j≤M} Tʲ L₀, a little too little.
    After(u32),
    /// By absorption, a part of the composition: unbiased.
    #[default]
    Roulette,
}

impl Default for Rules {
    /// Owen's scramble of Sobol's sequence, inverted, ended by roulette.
    fn default() -> Rules {
        Rules {
            generator: Generator::SobolOwen,
            seed: 0,
            inversion: Inversion::default(),
            ending: Ending::default(),
        }
    }
}

impl Rules {
    /// As the paper walks: seven reflections, and points of sixteen dimensions.
    pub fn paper(generator: Generator, seed: u32) -> Rules {
        let generator = generator.in_dimensions(2 * PAPER_REFLECTIONS + 2);
        Rules { generator, seed, inversion: Inversion::Bsdf, ending: Ending::After(PAPER_REFLECTIONS) }
    }
}

/// Light that comes to a surface.
#[derive(Clone, Copy, Debug)]
pub struct Arrival<'w> {
    /// Number of the path.
    pub path: u32,
    /// The emitter that its light is from.
    pub emitter: u32,
    /// How often it was scattered before.
    pub bounces: u32,
    /// Whether a dull lobe scattered it at least once.
    pub diffused: bool,
    /// Whether a sharp lobe scattered it last.
    pub sharp: bool,
    /// Flux, of a path that were the only one [lm].
    pub flux: Rgb,
    /// Which triangle, and where in it.
    pub hit: Hit,
    /// The surface, seen from where the light came.
    pub surface: Surface<'w>,
}

impl Arrival<'_> {
    /// Where [m, world].
    pub fn position(&self) -> Vec3 {
        self.surface.position
    }

    /// Unit geometric normal on the side that the light came to.
    pub fn normal(&self) -> Vec3 {
        self.surface.normal
    }

    /// Unit direction that it came from.
    pub fn from(&self) -> Vec3 {
        self.surface.wo
    }

    /// The flux that the BSDF sees [lm]: another one only under bent normals; `None` where the two normals disagree about
    /// the side, and nothing is reflected.
    pub fn lit(&self) -> Option<Rgb> {
        self.surface.flux_density().map(|density| self.flux * density)
    }

    /// Whether it comes over sharp lobes alone: as a caustic, once at least.
    pub fn is_caustic(&self) -> bool {
        self.sharp && !self.diffused
    }
}

/// All paths of a world by some rules.
#[derive(Clone)]
pub struct RandomWalk<'w> {
    world: &'w World,
    rules: Rules,
    lamps: Lamps,
}

impl<'w> RandomWalk<'w> {
    /// The walk of a world's lamps as bright as they are now.
    pub fn new(world: &'w World, rules: Rules) -> RandomWalk<'w> {
        RandomWalk { world, rules, lamps: Lamps::new(world, |_| Rgb::WHITE) }
    }

    /// The same with the light of each emitter multiplied; black leaves it out.
    pub fn tinted(world: &'w World, rules: Rules, tint: impl Fn(u32) -> Rgb) -> RandomWalk<'w> {
        RandomWalk { world, rules, lamps: Lamps::new(world, tint) }
    }

    /// Whose light it is.
    pub fn world(&self) -> &'w World {
        self.world
    }

    /// How it is followed.
    pub fn rules(&self) -> Rules {
        self.rules
    }

    /// Whom paths start from.
    pub fn lamps(&self) -> &Lamps {
        &self.lamps
    }

    /// Walks path `number` and hands every arrival to `take`, in their order. Returns the rays that it took.
    pub fn path(&self, number: u32, mut take: impl FnMut(&Arrival<'w>)) -> u32 {
        let Rules { generator, seed, inversion, ending } = self.rules;
        let die = Die { generator, index: number, seed };
        let Some(start) = self.lamps.start(self.world, &die) else { return 0 };
        let most = match ending {
            Ending::After(reflections) => reflections.min(MAX_ARRIVALS),
            Ending::Roulette => MAX_ARRIVALS,
        };
        let mut ray = Ray::new(start.origin, start.direction);
        let (mut flux, mut diffused, mut sharp) = (start.flux, false, false);
        let mut last: Option<Surface<'w>> = None;
        for bounces in 0..most {
            let Some(hit) = self.world.tracer().closest(&ray) else { return bounces + 1 };
            let surface = self.world.surface(ray.direction, &hit);
            flux *= surface.clear_from(ray.origin, last.as_ref());
            take(&Arrival {
                path: number,
                emitter: start.emitter,
                bounces,
                diffused,
                sharp,
                flux,
                hit,
                surface,
            });
            if bounces + 1 == most {
                return most;
            }
            let roulette = ending == Ending::Roulette;
            let Some(Bounce { direction, weight, dull }) =
                bounce::scatter(&surface, inversion, roulette, &die, bounces + 1)
            else {
                return bounces + 1;
            };
            flux *= weight;
            if flux.is_black() {
                return bounces + 1;
            }
            (diffused, sharp) = (diffused | dull, !dull);
            ray = Ray::new(surface.spawn(direction), direction);
            last = Some(surface);
        }
        0
    }

    /// Walks paths on all threads. Each run of [`RUN`] numbers, the first one cut at a multiple of it, gathers what `take` adds to
    /// a `T` of its own; they are returned in the order of their numbers, each with the rays that it took, and depend on
    /// no number of threads.
    pub fn paths<T: Default + Send>(
        &self,
        numbers: Range<u32>,
        take: impl Fn(&mut T, &Arrival<'w>) + Sync,
    ) -> Vec<(T, u64)> {
        let Range { start, end } = numbers;
        let first = start / RUN;
        let runs: Vec<Range<u32>> = (first..end.div_ceil(RUN).max(first))
            .map(|k| (k * RUN).max(start)..k.saturating_add(1).saturating_mul(RUN).min(end))
            .collect();
        let walk = |numbers: Range<u32>| {
            let mut gathered = T::default();
            let rays = numbers.map(|i| u64::from(self.path(i, |a| take(&mut gathered, a)))).sum();
            (gathered, rays)
        };
        runs.into_par_iter().map(walk).collect()
    }

    /// [`Self::paths`] of any number, of which a few runs at a time are held in memory: hands what each run gathered to `then`,
    /// in the order of their numbers. Returns the rays that all of them took.
    pub fn in_waves<T: Default + Send>(
        &self,
        numbers: Range<u32>,
        take: impl Fn(&mut T, &Arrival<'w>) + Sync,
        mut then: impl FnMut(T),
    ) -> u64 {
        let mut all = 0;
        for start in numbers.clone().step_by(WAVE as usize) {
            let wave = start..numbers.end.min(start.saturating_add(WAVE));
            for (gathered, rays) in self.paths(wave, &take) {
                then(gathered);
                all += rays;
            }
        }
        all
    }
}
