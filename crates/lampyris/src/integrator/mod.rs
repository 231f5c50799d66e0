//! Integrators: summands, each one part of path space (docs/light-transport.md, "The partition").
//!
//! An integrator shades the visible points of a tile for one eye pass. Parts with disjoint paths add up to the whole;
//! `path` alone covers everything and is the oracle. To add one: a file with an `impl Integrator`, a `mod` line and a
//! row in [`ALL`].

mod caustic;
mod caustic_map;
mod caustic_path;
mod compensation;
mod cut_off;
mod direct;
mod direct_map;
mod emission;
mod final_gather;
pub mod gather;
mod gloss;
mod mirror;
mod pane;
mod path;
mod pick;
mod short;
mod vpl;

use crate::coarse::{Coarse, Wants};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::eye::{Eye, Numbers, Packet, Sampling, Tile};
use crate::irradiance::Irradiance;
use crate::particle::{Beacon, Plan, Reflected, Vpl};
use crate::photon::Photons;
use crate::settings::{Rays, Settings};
use crate::world::{Surface, World};

/// What all tiles of one eye pass share.
#[derive(Clone, Copy)]
pub struct Pass<'w> {
    /// The scene made traceable.
    pub world: &'w World,
    /// The settings of the picture.
    pub settings: &'w Settings,
    /// Bounds and counts.
    pub plan: &'w Plan,
    /// What looks.
    pub eye: &'w Eye,
    /// The light of this pass, one entry for each light group that is asked for.
    pub lights: &'w [Lights<'w>],
    /// Caustic photons of the batch; `None` where the oracle does their work.
    pub photons: Option<&'w Photons>,
    /// What surfaces reflect, for final gathering; `None` where no part reads it.
    pub coarse: Option<&'w Coarse<'w>>,
    /// Irradiance by the coarse solution at some points of the batch; `None` where it is not interpolated.
    pub irradiance: Option<&'w Irradiance>,
    /// Which sample of each pixel.
    pub sampling: Sampling,
}

/// The light of one light group, or of whatever else is summed apart, as far as one class of pixels gathers it.
#[derive(Clone, Copy)]
pub struct Lights<'w> {
    /// Which group: the layer of [`Plan::layer_of`].
    pub group: usize,
    /// Its share of the samples that a point takes of all light: of light paths it has as many.
    pub share: f32,
    /// Light points: an unbiased stand-in for its light sources.
    pub points: &'w [Vpl<'w>],
    /// Virtual point lights: an unbiased stand-in for all reflected light.
    pub vpls: &'w [Vpl<'w>],
    /// The same for picking among them.
    pub beacons: &'w [Beacon],
    /// Images of the virtual lights, an entry for each mirror.
    pub reflected: &'w [Reflected],
    /// Virtual lights of longer paths than allowed, where they are asked for.
    pub beyond: (&'w [Vpl<'w>], &'w [Beacon]),
}

impl Lights<'_> {
    /// How many of `of` of its virtual lights the packets of a tile pick in the mean; `None` for all.
    fn picks(&self, settings: &Settings, of: &[Vpl<'_>], tile: &Tile<'_>) -> Option<f32> {
        let all = of.len() as f32;
        let most = (settings.picks? as f32 * self.share).min(all) * tile.stake;
        (most < all).then_some(most)
    }

    /// A number in [0, 1) as this group uses it: groups of small shares take turns.
    fn turned(&self, u: f32) -> f32 {
        (u + GOLDEN * self.group as f32).fract()
    }
}

/// The golden ratio's fraction: its multiples spread evenly over the unit interval.
const GOLDEN: f32 = 0.618_034;

impl<'w> Pass<'w> {
    /// Which of the [`Pass::lights`] an emitter belongs to, and what its light is multiplied by.
    fn place_of(&self, emitter: u32) -> Option<(usize, Rgb)> {
        let group = self.plan.layer_of(emitter);
        let place = self.lights.iter().position(|lights| lights.group == group);
        place.map(|place| (place, self.plan.tint(emitter)))
    }

    /// Each group's light with the sum that it is to be added to.
    fn zip<'o, T>(
        &self,
        out: &'o mut [T],
    ) -> impl Iterator<Item = (&'w Lights<'w>, &'o mut T)> + use<'w, 'o, T> {
        self.lights.iter().zip(out)
    }
}

/// TRAIT 2 of two: an algorithm, covering one part of path space.
pub trait Integrator: Send + Sync {
    /// Name on the command line and in files.
    fn name(&self) -> &'static str;
    /// The paths it covers, in the notation of docs/light-transport.md.
    fn paths(&self) -> &'static str;
    /// True if its light varies slowly over a surface, so that what is shown may be averaged between neighbours.
    fn is_smooth(&self) -> bool {
        true
    }

    /// Whether it follows eye paths of its own from the eye on, each through a pixel of the tile: what others see by second
    /// paths it has seen already.
    fn starts_at_the_eye(&self) -> bool {
        false
    }

    /// Whether it asks for [`Pass::photons`].
    fn gathers_photons(&self) -> bool {
        false
    }

    /// What it asks for of [`Pass::coarse`].
    fn wants(&self) -> Wants {
        Wants::default()
    }

    /// Adds the radiance [cd/m²] that reaches each pixel of the tile in this pass over the tile's eye paths; `out` has a plane for each of
    /// [`Pass::lights`], row by row.
    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays);
}

/// Every integrator: one table for program, tests and documentation.
pub static ALL: &[&dyn Integrator] = &[
    &emission::Emission,
    &direct::Direct,
    &direct_map::DirectMap,
    &vpl::VirtualLights,
    &cut_off::CutOff,
    &compensation::Compensation,
    &final_gather::FinalGather,
    &mirror::Mirror,
    &caustic::Caustic,
    &caustic_map::CausticMap,
    &caustic_path::CausticPath,
    &path::Path,
];

/// The parts that make the whole picture, each path once.
pub const WHOLE: &[&str] = &["emission", "direct", "vpl", "compensation", "mirror", "caustic"];

/// The parts of the full solution of 1996: reflected light by final gathering, caustics from a photon map.
pub const FULL_SOLUTION: &[&str] = &["emission", "direct", "final-gather", "caustic-map"];

/// Parts that cover the same paths: one and any other of a row.
const RIVALS: &[(&str, &[&str])] = &[
    ("direct-map", &["direct"]),
    ("final-gather", &["vpl", "cut-off", "compensation"]),
    ("caustic-map", &["mirror", "caustic", CAUSTIC_ORACLE]),
    (CAUSTIC_ORACLE, &["caustic"]),
];

/// The part that finds caustics without photons, for every part that asks for them.
pub const CAUSTIC_ORACLE: &str = "caustic-path";

/// The integrators of the names given, in the order of [`ALL`].
///
/// # Errors
/// [`Error::BadSetting`] for an unknown name, for none at all, and for parts that would count paths twice: `path` beside
/// any other, and for two ways to find the same light.
pub fn select<S: AsRef<str>>(names: &[S]) -> Result<Vec<&'static dyn Integrator>> {
    for name in names {
        if !ALL.iter().any(|i| i.name() == name.as_ref()) {
            let known: Vec<_> = ALL.iter().map(|i| i.name()).collect();
            return Err(Error::BadSetting(format!(
                "no part is called \"{}\"; known: all, {}",
                name.as_ref(),
                known.join(", ")
            )));
        }
    }
    let chosen: Vec<_> =
        ALL.iter().copied().filter(|i| names.iter().any(|n| n.as_ref() == i.name())).collect();
    if chosen.is_empty() {
        return Err(Error::BadSetting("choose at least one part".into()));
    }
    if chosen.len() > 1 && chosen.iter().any(|i| i.name() == "path") {
        return Err(Error::BadSetting(
            "\"path\" covers every path: beside it any other part counts twice".into(),
        ));
    }
    let has = |name: &str| chosen.iter().any(|i| i.name() == name);
    for (part, others) in RIVALS.iter().filter(|(part, _)| has(part)) {
        if let Some(other) = others.iter().find(|other| has(other)) {
            return Err(Error::BadSetting(format!(
                "\"{part}\" covers the paths of \"{other}\": choose one of them"
            )));
        }
    }
    Ok(chosen)
}

/// Whether photons are of use to these parts: to some of them, unless the oracle is asked for in their place.
pub fn gather_photons(parts: &[&dyn Integrator]) -> bool {
    parts.iter().any(|i| i.gathers_photons()) && parts.iter().all(|i| i.name() != CAUSTIC_ORACLE)
}

/// What these parts ask for of a coarse solution.
pub fn wants(parts: &[&dyn Integrator]) -> Wants {
    let any = |of: fn(Wants) -> bool| parts.iter().any(|part| of(part.wants()));
    Wants {
        reflected: any(|wants| wants.reflected),
        caustics: any(|wants| wants.caustics),
        shadows: any(|wants| wants.shadows),
    }
}

/// Of each pixel's eye passes, every `STRIDE`-th does the work of a costly integrator, for all of them.
const STRIDE: u32 = 2;

/// A costly part of the light that each pixel gathers in the passes whose turn it is.
pub(crate) struct Costly {
    /// Tells its random numbers from those of others.
    pub(crate) purpose: u8,
    /// Which byte of a pixel's seed is its phase: turns come at random, so that the mean is exact.
    pub(crate) phase: u32,
    /// [`Tile::stake`]: where light counts for little, turns are rarer.
    pub(crate) stake: f32,
}

impl Costly {
    /// Passes for each of which one does the work. Powers of two, which a byte falls into evenly.
    fn stride(&self) -> u32 {
        match self.stake {
            s if s <= 0.25 => 4 * STRIDE,
            s if s <= 0.5 => 2 * STRIDE,
            _ => STRIDE,
        }
    }

    /// Adds the radiance that `at` finds at the visible points of some packets [cd/m²], group by group, where it is their
    /// turn.
    pub(crate) fn add<'p, 'w: 'p>(
        &self,
        pass: &Pass<'_>,
        packets: impl Iterator<Item = &'p Packet<'w>>,
        out: &mut [Vec<Rgb>],
        mut at: impl FnMut(&Surface<'w>, Numbers, &mut [Rgb]),
    ) {
        let mut found = vec![Rgb::BLACK; out.len()];
        let stride = self.stride();
        for p in packets {
            for k in p.lanes() {
                let numbers = p.numbers[k];
                let turn = pass.sampling.index.wrapping_add(numbers.seed >> (8 * self.phase));
                if turn.is_multiple_of(stride)
                    && let Some(x) = p.visible(k)
                {
                    found.fill(Rgb::BLACK);
                    at(&x.surface, numbers.branch(self.purpose.into()), &mut found);
                    for (out, found) in out.iter_mut().zip(&found) {
                        out[p.pixels[k] as usize] += x.throughput * *found * stride as f32;
                    }
                }
            }
        }
    }
}
