//! Keller's quasi-random walk: particles leave the lights, bounce, and at every dull vertex leave a virtual point
//! light [Keller97, §3.2; docs/light-transport.md, "The walk"].
//! Each light has its own sub-sequence and a fixed share of the paths; a vertex' flux is already divided by the
//! expected number of particles of its generation. Nothing here knows of pixels.

mod reflected;

pub use reflected::Reflected;

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::light::Shine;
use crate::material::{Bsdf, Class};
use crate::sequence::{self, ledger::light as ledger, radical_inverse};
use crate::settings::{Absorption, Batch, Settings};
use crate::world::{Surface, World};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::FRAC_1_PI;

/// A point that shines on others: a sampled point of a light, or a vertex of the walk.
#[derive(Clone, Copy, Debug)]
pub struct Vpl<'w> {
    /// Where shadow rays start [m]; the direction toward a distant light.
    pub position: Vec3,
    /// Its angular law. Vertices are Lambertian area elements even where their BSDF is not: the law is then the
    /// geometry's part alone.
    pub shine: Shine,
    /// Radiance × area [cd] of a Lambertian, intensity [cd] of a point, illuminance [lx] of a distant light;
    /// flux [lm] where `gloss` evaluates the BSDF.
    pub intensity: Rgb,
    /// b: the geometry term is clamped to this [m⁻²] (docs/light-transport.md, "Clamping").
    pub bound: f32,
    /// The vertex itself where its dull lobes are not Lambertian; its `wo` is where the particle came from.
    pub gloss: Option<Surface<'w>>,
    /// The emitter that its light is from.
    pub emitter: u32,
}

/// What picking among virtual lights asks of each, in half a cache line.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(32))]
pub struct Beacon {
    /// Where it is [m].
    pub position: Vec3,
    /// Brightness: of all channels, whatever their sign; nothing only where the light gives nothing.
    pub weight: f32,
    /// Its normal.
    pub normal: Vec3,
    /// b [m⁻²].
    pub bound: f32,
}

/// What settings and world fix for all batches: counts, survival and bounds.
#[derive(Clone, Debug)]
pub struct Plan {
    /// q, the survival from one generation to the next.
    pub survival: f32,
    /// b for vertices of the walk [m⁻²].
    pub bound: f32,
    /// b for the points of the emitters of each layer [m⁻²]: one for all of a layer, since each path carries the same
    /// light, an N-th of what the file's lamps had, whose place is known to within the emitters' mean area, Σ p_ℓ A_ℓ / Σ p_ℓ.
    pub emitter_bounds: Vec<f32>,
    /// The least of them.
    pub emitter_bound: f32,
    absorption: Absorption,
    /// Of each emitter, the layer that its light is summed in.
    layers: Vec<usize>,
    /// Of each emitter, what its light is multiplied by before it is summed.
    tints: Vec<Rgb>,
    /// x₀ of each emitter: its expected (or floored) number of paths.
    starts: Vec<f64>,
    /// Of these, the share that leaves a light point: generation 0 thins out like any other.
    pointing: f64,
}

/// The lights of one batch, sorted by the class of pixels that gathers them.
#[derive(Clone, Debug, Default)]
pub struct Walk<'w> {
    /// Points of the lights: generation 0.
    pub lights: Vec<Vpl<'w>>,
    /// Vertices: generations 1 and up.
    pub vpls: Vec<Vpl<'w>>,
    /// Of each vertex, in their order.
    beacons: Vec<Beacon>,
    /// Where the lights of each class begin, and at last where they end.
    light_starts: Vec<usize>,
    vpl_starts: Vec<usize>,
    /// Where in each class those begin that lie beyond the limit of [`Settings::longest`].
    cuts: Vec<usize>,
    /// Of each class the images of its vertices within the limit, mirror by mirror.
    reflected: Vec<Vec<Reflected>>,
    /// Rays that the particles took.
    pub rays: u64,
}

impl Plan {
    /// Counts and bounds: functions of settings and geometry only, never of a picture. Each light group of the world is
    /// summed apart.
    pub fn new(world: &World, settings: &Settings) -> Plan {
        let groups = (0..world.emitters().len() as u32).map(|emitter| world.group_of(emitter));
        Plan::by_layers(world, settings, groups.collect(), world.groups())
    }

    /// [`Plan::new`] where each emitter is summed apart. Each has a whole number of light paths, one at least: of lamps told
    /// apart the weakest is seen in every batch, and what comes straight from a point is exact.
    pub fn by_emitters(world: &World, settings: &Settings) -> Plan {
        let count = world.emitters().len();
        let plan = Plan::by_layers(world, settings, (0..count).collect(), count);
        Plan { starts: plan.starts.iter().map(|x0| x0.ceil()).collect(), ..plan }
    }

    /// [`Plan::new`] where all light is summed in one layer, that of each group in a colour of its own, white where none is
    /// given.
    pub fn melted(world: &World, settings: &Settings, colors: &[Rgb]) -> Plan {
        let count = world.emitters().len();
        let tint = |emitter| colors.get(world.group_of(emitter)).copied().unwrap_or(Rgb::WHITE);
        let tints = (0..count as u32).map(tint).collect();
        Plan { tints, ..Plan::by_layers(world, settings, vec![0; count], 1) }
    }

    /// The same layers in the same colours by other settings.
    pub fn again(&self, world: &World, settings: &Settings) -> Plan {
        let plan = Plan::by_layers(world, settings, self.layers.clone(), self.layers());
        Plan { tints: self.tints.clone(), ..plan }
    }

    fn by_layers(world: &World, settings: &Settings, layers: Vec<usize>, count: usize) -> Plan {
        let n = f64::from(settings.paths);
        let mean = world.mean_reflectance();
        let survival = match settings.absorption {
            // Survive often: the variance of generation j grows like (ρ²/q)ʲ where a niche is brighter than ρ̄.
            Absorption::Fractional => mean.clamp(0.7, 0.95),
            Absorption::Paper | Absorption::Roulette => mean.clamp(0.01, 0.99),
        };
        let starts: Vec<f64> = world
            .shares()
            .iter()
            .map(|p| match settings.absorption {
                Absorption::Paper if *p > 0.0 => (n * f64::from(*p)).floor().max(1.0),
                _ => n * f64::from(*p),
            })
            .collect();
        let bound_of = |area: f64, count: f64| {
            let r2 = f64::from(settings.clamp * settings.clamp) * area / count;
            if r2 > 0.0 { (1.0 / r2) as f32 } else { f32::INFINITY }
        };
        let q = f64::from(survival);
        let points = settings.light_points.map_or(n, |l| f64::from(l).min(n));
        let mut emitting = vec![[0.0; 2]; count];
        for (layer, (e, p)) in layers.iter().zip(world.emitters().iter().zip(world.shares())) {
            if !e.is_dark() {
                let [area, share] = &mut emitting[*layer];
                *area += f64::from(*p) * f64::from(e.area());
                *share += f64::from(*p);
            }
        }
        let mean = |[area, share]: &[f64; 2]| if *share > 0.0 { area / share } else { 0.0 };
        let emitter_bounds: Vec<f32> = emitting.iter().map(|of| bound_of(mean(of), points)).collect();
        Plan {
            survival,
            bound: bound_of(f64::from(world.area()), n * q / (1.0 - q)),
            emitter_bound: emitter_bounds.iter().copied().fold(f32::INFINITY, f32::min),
            emitter_bounds,
            tints: vec![Rgb::WHITE; layers.len()],
            layers,
            absorption: settings.absorption,
            starts,
            pointing: points / n,
        }
    }

    /// How many layers there are.
    pub fn layers(&self) -> usize {
        self.emitter_bounds.len()
    }

    /// The layer that the light of an emitter is summed in.
    #[inline]
    pub fn layer_of(&self, emitter: u32) -> usize {
        self.layers[emitter as usize]
    }

    /// What the light of an emitter is multiplied by before it is summed: white, unless layers are melted into one.
    #[inline]
    pub fn tint(&self, emitter: u32) -> Rgb {
        self.tints[emitter as usize]
    }

    /// True if an emitter gives nothing to what is summed: what would leave it carries nothing.
    pub fn is_dark(&self, world: &World, emitter: u32) -> bool {
        world.emitters()[emitter as usize].is_dark() || self.tint(emitter) == Rgb::BLACK
    }

    /// x_j: the number of particles of generation j that the weights assume.
    fn expected(&self, emitter: usize, generation: u32) -> f64 {
        let x0 = self.starts[emitter];
        let thinned = x0 * f64::from(self.survival).powi(generation as i32);
        match self.absorption {
            Absorption::Fractional => thinned,
            Absorption::Paper => thinned.floor(),
            Absorption::Roulette => x0,
        }
    }
}

/// One particle's numbers.
struct Path {
    emitter: usize,
    /// Alive in generation j while this is below x_j.
    rank: f64,
    index: u32,
    seed: u32,
    class: u32,
}

impl<'w> Walk<'w> {
    /// Walks all particles of a batch. The result depends on nothing but its arguments.
    pub fn new(world: &'w World, settings: &Settings, plan: &Plan, batch: Batch) -> Walk<'w> {
        Walk::from_emitters(world, settings, plan, batch, |_| true)
    }

    /// The particles that [`Walk::new`] has from the emitters of one layer.
    pub fn of_layer(
        world: &'w World,
        settings: &Settings,
        plan: &Plan,
        batch: Batch,
        layer: usize,
    ) -> Walk<'w> {
        Walk::from_emitters(world, settings, plan, batch, |emitter| plan.layer_of(emitter) == layer)
    }

    fn from_emitters(
        world: &'w World,
        settings: &Settings,
        plan: &Plan,
        batch: Batch,
        wanted: impl Fn(u32) -> bool,
    ) -> Walk<'w> {
        let paths = start_paths(world, settings, plan, batch, wanted);
        let traced: Vec<Traced<'w>> =
            paths.par_iter().with_min_len(16).map(|p| trace(world, settings, plan, p)).collect();
        let mut walk = Walk::default();
        let mut by_class: Vec<Vec<usize>> = vec![Vec::new(); settings.classes() as usize];
        for (k, path) in paths.iter().enumerate() {
            by_class[path.class as usize].push(k);
        }
        for members in by_class {
            walk.light_starts.push(walk.lights.len());
            walk.vpl_starts.push(walk.vpls.len());
            for &k in &members {
                walk.lights.extend(traced[k].light);
                walk.leave(&traced[k].vertices);
                walk.rays += traced[k].rays;
            }
            walk.cuts.push(walk.vpls.len());
            let beacons = &walk.beacons[walk.vpl_starts[walk.cuts.len() - 1]..];
            let image = |(number, mirror)| Reflected::new(number, mirror, beacons);
            walk.reflected.push((0..).zip(world.mirrors()).map(image).collect());
            members.iter().for_each(|k| walk.leave(&traced[*k].beyond));
        }
        walk.light_starts.push(walk.lights.len());
        walk.vpl_starts.push(walk.vpls.len());
        walk
    }

    fn leave(&mut self, vertices: &[Vpl<'w>]) {
        self.vpls.extend_from_slice(vertices);
        self.beacons.extend(vertices.iter().map(Beacon::from));
    }

    /// The lights of a class.
    pub fn lights_of(&self, class: u32) -> &[Vpl<'w>] {
        &self.lights[self.light_starts[class as usize]..self.light_starts[class as usize + 1]]
    }

    /// The vertices of a class, for light and for picking.
    pub fn vpls_of(&self, class: u32) -> (&[Vpl<'w>], &[Beacon]) {
        self.range(self.vpl_starts[class as usize]..self.cuts[class as usize])
    }

    /// Their images, an entry for each mirror.
    pub fn reflected_of(&self, class: u32) -> &[Reflected] {
        &self.reflected[class as usize]
    }

    /// Those whose light would take longer paths than [`Settings::longest`] allows, where the part *cut-off* asks for them.
    pub fn beyond_of(&self, class: u32) -> (&[Vpl<'w>], &[Beacon]) {
        self.range(self.cuts[class as usize]..self.vpl_starts[class as usize + 1])
    }

    fn range(&self, range: std::ops::Range<usize>) -> (&[Vpl<'w>], &[Beacon]) {
        (&self.vpls[range.clone()], &self.beacons[range])
    }

    /// The vertices within the limit.
    pub fn within(&self) -> impl Iterator<Item = &Vpl<'w>> {
        self.vpl_starts.iter().zip(&self.cuts).flat_map(|(start, cut)| &self.vpls[*start..*cut])
    }
}

/// The part that has the light of longer paths than allowed.
pub const CUT_OFF: &str = "cut-off";

/// Without a clamp weights must stay finite all the same [m⁻²].
const FARTHEST_BOUND: f32 = 1e12;

impl From<&Vpl<'_>> for Beacon {
    /// Of a vertex: an area element.
    fn from(vpl: &Vpl<'_>) -> Beacon {
        let Rgb { r, g, b } = vpl.intensity;
        let normal = if let Shine::Lambert(normal) = vpl.shine { normal } else { Vec3::ZERO };
        Beacon {
            position: vpl.position,
            weight: r.abs() + g.abs() + b.abs(),
            normal,
            bound: vpl.bound.min(FARTHEST_BOUND),
        }
    }
}

/// Deals the batch's paths to emitters, sequence indices and classes.
///
/// Each of the K interleaved pixels has a run of consecutive indices of its own, the batch the runs one after another. Path
/// i of the k-th run has rank (i + frac(ξ + k/K)) K: the mean number of ranks below x is x/K in each run, and x in all of
/// them to within one. The runs rotate from batch to batch, so that a pixel comes by every residue of the sequence
/// [Wald et al. 2002, §4.2]; within a run the paths are dealt to the eye passes.
fn start_paths(
    world: &World,
    settings: &Settings,
    plan: &Plan,
    batch: Batch,
    wanted: impl Fn(u32) -> bool,
) -> Vec<Path> {
    let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
    let seed = sequence::hash(settings.seed, replicate);
    // Unscrambled sequences know no randomisations: there every batch takes the next block of the one sequence.
    let block_in_sequence = if settings.sequence.is_randomised() { block } else { batch.index };
    let passes = settings.eye_passes();
    let runs = settings.interleave[0] * settings.interleave[1];
    // Neighbours in the sequence spread over the passes, or survivors, a prefix, would sit in a corner of the pixel.
    let stride = golden_stride(passes);
    let first_run = sequence::hash(seed, 0x5eed_0ff5).wrapping_add(block) % runs;
    let common = threshold(seed, block);
    let mut paths = Vec::with_capacity(settings.paths as usize + world.emitters().len());
    for emitter in 0..world.emitters().len() {
        if !wanted(emitter as u32) || plan.is_dark(world, emitter as u32) {
            // Its paths would carry nothing. Those of others are the same with or without them.
            continue;
        }
        let x0 = plan.expected(emitter, 0);
        let seed = sequence::hash(seed, emitter as u32 + 1);
        let first_pass = sequence::hash(seed, block ^ 0x5eed_0ff5);
        // Lamps of small shares take turns among the runs.
        let shift = match settings.absorption {
            Absorption::Paper => 0.0,
            _ => (common + GOLDEN * emitter as f64).fract(),
        };
        let start = block_in_sequence.wrapping_mul(x0.ceil() as u32);
        let mut count = 0;
        for run in 0..runs {
            let offset = (f64::from(run) + shift * f64::from(runs)) % f64::from(runs);
            for i in 0.. {
                let rank = f64::from(i) * f64::from(runs) + offset;
                if rank >= x0 {
                    break;
                }
                let pass = (u64::from(count) * u64::from(stride) + u64::from(first_pass)) % u64::from(passes);
                let class = pass as u32 * runs + (run + first_run) % runs;
                paths.push(Path { emitter, rank, index: start.wrapping_add(count), seed, class });
                count += 1;
            }
        }
    }
    paths
}

/// The golden ratio's fraction: its multiples spread evenly over the unit interval.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// ξ in (0, 1), never 0: drawn once, then shifted by the radical inverse of the block, so that the
/// thresholds of successive batches are stratified.
fn threshold(seed: u32, block: u32) -> f64 {
    let shift = f64::from(sequence::uniform(seed, 0, 0));
    let xi = (shift + f64::from(radical_inverse(2, block))).fract();
    ((xi * 16_777_216.0).floor() + 0.5) / 16_777_216.0
}

/// A stride near count/φ that shares no divisor with `count`.
fn golden_stride(count: u32) -> u32 {
    let gcd = |mut a: u32, mut b: u32| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let near = (f64::from(count) * GOLDEN) as u32;
    (near.max(1)..).find(|s| gcd(*s, count) == 1).unwrap_or(1)
}

struct Traced<'w> {
    light: Option<Vpl<'w>>,
    vertices: Vec<Vpl<'w>>,
    /// Those that paths of the allowed length do not reach.
    beyond: Vec<Vpl<'w>>,
    rays: u64,
}

fn trace<'w>(world: &'w World, settings: &Settings, plan: &Plan, path: &Path) -> Traced<'w> {
    let emitter = &world.emitters()[path.emitter];
    let number = |dimension: u32| settings.sequence.sample(path.index, dimension, path.seed);
    let pair = |dimension: u32| settings.sequence.pair(path.index, dimension, path.seed);
    let roulette = settings.absorption == Absorption::Roulette;
    // A class sees one of C shares of the paths: what it gathers stands for all of them.
    let share = settings.classes() as f32;
    let tint = plan.tints[path.emitter];

    let (place, turn) = (pair(ledger::POINT), pair(ledger::EMISSION));
    let pointing = plan.expected(path.emitter, 0) * plan.pointing;
    let light = (path.rank < pointing).then(|| {
        let point = emitter.point(place);
        Vpl {
            position: point.position,
            shine: point.shine,
            intensity: point.intensity * (share / pointing as f32) * tint,
            bound: plan.emitter_bounds[plan.layers[path.emitter]],
            gloss: None,
            emitter: path.emitter as u32,
        }
    });

    let mut vertices = Vec::new();
    let mut rays = 0;
    let start = emitter.emit([place[0], place[1], turn[0], turn[1]], world.bounds());
    let mut ray = Ray::new(start.origin, start.direction);
    let mut flux = start.flux * tint;
    let mut last: Option<Surface<'w>> = None;
    // A vertex of generation j is j + 2 segments from the eye at least.
    let limit = settings.longest.map_or(u32::MAX, |most| most.saturating_sub(2));
    let mut beyond = Vec::new();
    for generation in 1..=if settings.parts.iter().any(|part| part == CUT_OFF) { u32::MAX } else { limit } {
        let expected = plan.expected(path.emitter, generation);
        if path.rank >= expected {
            break;
        }
        rays += 1;
        let Some(y) = world.closest(&ray) else { break };
        flux *= y.clear_from(ray.origin, last.as_ref());
        let vertices = if generation <= limit { &mut vertices } else { &mut beyond };
        let flux_of_all = flux * (share / expected as f32);
        deposit(&y, flux_of_all, (path.emitter as u32, plan.bound), vertices);

        let (s, d) = y.finish.weights();
        if s + d <= 0.0 {
            break;
        }
        // One number chooses the class and, rescaled, the lobe within it.
        let choice = number(ledger::choice(generation)) * (s + d);
        let (class, probability, choice) =
            if choice < d { (Class::Dull, d, choice / d) } else { (Class::Sharp, s, (choice - d) / s) };
        let u = pair(ledger::direction(generation));
        let Some(scatter) = y.scatter_flux(class, u, choice.min(1.0 - f32::EPSILON)) else { break };
        let mut weight = scatter.weight * ((s + d) / probability);
        if roulette {
            let stay = weight.max_channel().clamp(0.0, 1.0);
            if number(ledger::roulette(generation)) >= stay {
                break;
            }
            weight *= 1.0 / stay;
        }
        flux *= weight;
        if flux.is_black() {
            break;
        }
        ray = Ray::new(y.spawn(scatter.wi), scatter.wi);
        last = Some(y);
    }
    Traced { light, vertices, beyond, rays }
}

/// Leaves virtual point lights at a vertex: one on each side to which its dull lobes send light.
fn deposit<'w>(y: &Surface<'w>, flux: Rgb, (emitter, bound): (u32, f32), vertices: &mut Vec<Vpl<'w>>) {
    let Some(arrived) = y.flux_density() else { return };
    let flux = flux * arrived;
    let mut leave = |normal: Vec3, intensity: Rgb, gloss: Option<Surface<'w>>| {
        let position = y.spawn(normal);
        if !intensity.is_black() {
            let shine = Shine::Lambert(normal);
            vertices.push(Vpl { position, shine, intensity, bound, gloss, emitter });
        }
    };
    match &y.finish.bsdf {
        // I_k = ρ Φ / π: radiance × area toward the normal [Keller97, eq. 2, with π f_d = ρ_d].
        Bsdf::Diffuse(m) => {
            leave(y.normal, flux * m.reflectance * FRAC_1_PI, None);
            leave(-y.normal, flux * m.transmittance * FRAC_1_PI, None);
        }
        _ => match y.finish.lambertian {
            Some(rho) => leave(y.normal, flux * rho * FRAC_1_PI, None),
            None => {
                leave(y.normal, flux, Some(*y));
                if y.finish.transmits {
                    leave(-y.normal, flux, Some(*y));
                }
            }
        },
    }
}
