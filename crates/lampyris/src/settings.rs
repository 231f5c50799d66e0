//! What a picture is made of, as numbers: settings, the unit of work, and counts of what was done.
//! All of it can be written down and sent elsewhere; a machine that has it makes the same bits. What the names of
//! parts mean, and whether settings make sense, is decided in `backend`.

use crate::sequence::Sequence;
use serde::{Deserialize, Serialize};

/// Everything that decides a picture beside scene and eye. Equal settings give equal bits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Names of the integrators to add up, see `integrator::ALL`.
    pub parts: Vec<String>,
    /// N, light paths started in one batch.
    pub paths: u32,
    /// Eye passes of one batch; `None` for one a light path [Keller97, §4.1].
    pub passes: Option<u32>,
    /// n × m: neighbouring pixels that share one batch's light paths among them, so that each is lit by a class of them
    /// [Wald et al. 2002, §4.2]. 1 × 1 lights every pixel by all.
    pub interleave: [u32; 2],
    /// Light points in one batch, drawn from the starts of its paths; `None` for all of them.
    pub light_points: Option<u32>,
    /// Virtual lights that each packet of pixels picks by what they would give it unshadowed, all where there are fewer; packets
    /// of second eye paths their share of that. `None` for all, whatever the paths.
    pub picks: Option<u32>,
    /// Segments of the longest paths whose light is counted, from the lamp to the eye; `None` for all of them. A limit is a
    /// bias: it takes the light of longer paths from `vpl`, and counts for `vpl` alone. What it takes is the part *cut-off*.
    pub longest: Option<u32>,
    /// How generations of particles thin out.
    pub absorption: Absorption,
    /// Where the numbers of the walk come from.
    pub sequence: Sequence,
    /// c: the clamping radius is c·√(A/M) for M expected virtual lights on an area A; 0 clamps nothing.
    pub clamp: f32,
    /// r ≥ 2, independent randomisations among which the batches alternate; their spread is the error.
    pub replicates: u32,
    /// Caustic photons that leave the lights in one batch, dealt to them like light paths; as many again leave the vertices
    /// of the walk. None are traced where nothing is sharp.
    pub photons: u32,
    /// How the part *final-gather* finds light.
    pub gather: Gather,
    /// Another seed, another picture of the same mean.
    pub seed: u32,
    /// Also keep what is to be shown: each batch averaged between neighbours, see [`crate::filter`].
    pub filter: bool,
    /// N: while light changes from batch to batch, what is shown is the mean of the last N, each of the scene as it was then
    /// [Keller97, §4.3]; 1 shows those since the last change alone. It asks for `filter`.
    pub window: u32,
    /// Further eye rays, for what is to be shown, in each pixel where surfaces meet.
    pub edges: u32,
    /// Also average albedo, normal, depth and object number of what the eye meets first.
    pub auxiliary: bool,
}

impl Settings {
    /// Eye passes of one batch.
    pub fn eye_passes(&self) -> u32 {
        self.passes.unwrap_or(self.paths)
    }

    /// Classes that the light paths of a batch are dealt to: a number for each eye pass and each pixel of the n × m.
    pub fn classes(&self) -> u32 {
        self.eye_passes() * self.interleave[0] * self.interleave[1]
    }
}

/// How light is found by final gathering.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gather {
    /// SCR, rays that look from each visible point in an eye pass.
    pub rays: u32,
    /// Light paths of the walk of 1996 that light the elements in one batch, dealt to the light groups by their shares.
    pub paths: u32,
    /// What the rays look up.
    pub source: Source,
    /// The longest edge of an element [m].
    pub element: f32,
    /// r, how far photons may lie from the point that they light [radii of the scene]; a quarter of it where illuminance is kept
    /// at photons.
    pub radius: f32,
    /// Glossy surfaces one behind the other: light is followed over the lobes of all but the last, which photons light.
    pub levels: u32,
    /// a in (0, 1], how much of the light may change between points whose irradiance is known and those that it is
    /// interpolated at, where surfaces reflect evenly [Ward et al. 1988]; `None` gathers at each point.
    pub cache: Option<f32>,
}

impl Default for Gather {
    fn default() -> Gather {
        let source = Source::Elements;
        Gather { rays: 16, paths: 1 << 15, source, element: 0.3, radius: 0.02, levels: 1, cache: None }
    }
}

/// What tells the rays of a final gather how much a surface reflects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Source {
    /// The mean of the surface element [Keller96, §4.3].
    Elements,
    /// The illuminance kept at the nearest photon [Christensen 1999].
    Photons,
}

impl Source {
    /// All of them with their names on the command line.
    pub const ALL: &[(&'static str, Source)] =
        &[("elements", Source::Elements), ("photons", Source::Photons)];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Source::Elements => "elements",
            Source::Photons => "photons",
        }
    }
}

/// How generations of particles thin out along the walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Absorption {
    /// Generation j has N·p·qʲ particles in the mean, by a random threshold: unbiased at any N.
    Fractional,
    /// Generation j has ⌊N·p·ρ̄ʲ⌋ particles [Keller97, §3.2]: loses the tail of the series in every batch.
    Paper,
    /// Each particle is absorbed by chance, in proportion to what its surface absorbs [Keller97, §4.3].
    Roulette,
}

impl Absorption {
    /// All forms with their names on the command line.
    pub const ALL: &[(&'static str, Absorption)] = &[
        ("fractional", Absorption::Fractional),
        ("paper", Absorption::Paper),
        ("roulette", Absorption::Roulette),
    ];
}

/// A unit of work that any machine can reproduce: the b-th block of the settings' sequences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Batch {
    /// Counts from 0; batch b belongs to randomisation b mod r and is its ⌊b/r⌋-th.
    pub index: u32,
}

/// What was done so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Statistics {
    /// Rays traced, by purpose.
    pub rays: Rays,
    /// Light points and virtual point lights made.
    pub vpls: u64,
    /// Points whose irradiance was found, to be interpolated ([`Gather::cache`]).
    pub records: u64,
    /// Estimates that were not finite and were left out; anything but 0 is a bug.
    pub non_finite: u64,
}

/// Rays by purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rays {
    /// From the eye, through mirrors and glass too.
    pub eye: u64,
    /// Of the particles, caustic photons among them.
    pub particle: u64,
    /// Between a point and a light or virtual light, by way of a mirror too.
    pub shadow: u64,
    /// Short rays that pay back what clamping took, and the shadow rays at their ends.
    pub compensation: u64,
    /// Of final gathering, without those of its light paths.
    pub gather: u64,
    /// Of the path tracer, for `path` and `caustic-path`.
    pub path: u64,
}

impl std::ops::AddAssign for Rays {
    fn add_assign(&mut self, o: Rays) {
        self.eye += o.eye;
        self.particle += o.particle;
        self.shadow += o.shadow;
        self.compensation += o.compensation;
        self.gather += o.gather;
        self.path += o.path;
    }
}
