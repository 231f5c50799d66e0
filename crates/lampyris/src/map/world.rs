//! Maps of a world: the global one, of a walk that scatters light by all that surfaces do [Keller96, §4.3], and that of the
//! caustics of lamps, of photons aimed at what reflects sharply [Jarosz05, §2.1, §4.1.1]. Photons start in proportion to power,
//! and carry what they stand for: a map needs no scale.
//!
//! [Jarosz05, §2.1] keeps in the global map only light that was reflected dully before. That is what a look at the map itself
//! lacks beside direct light and caustics. But a final gather from x asks for what y reflects, and y reflects direct light and
//! caustics, too: for it every photon is kept.

use super::PhotonMap;
use super::photon::{Past, Photon};
use crate::color::Rgb;
use crate::material::Class;
use crate::photon;
use crate::scatter::{Arrival, RandomWalk, Rules};
use crate::sequence;
use crate::world::{Surface, World};
use std::ops::Range;

/// Which light a map keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keep {
    /// All that comes to surfaces other than mirrors and clear glass.
    #[default]
    Every,
    /// Of it, what a dull lobe reflected before: neither direct light nor caustics of lamps.
    Reflected,
    /// What comes to dull surfaces over sharp lobes alone, once at least: L S⁺ D.
    Caustic,
    /// What comes to dull surfaces straight from a lamp.
    Direct,
}

/// How maps of a world are filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shots {
    /// Light paths for the global map.
    pub paths: u32,
    /// Of them which is kept there.
    pub keep: Keep,
    /// Photons shot for the caustics of lamps.
    pub caustics: u32,
    /// Whether caustics have the light over a single planar mirror, which is the part *mirror* of the partition.
    pub mirrored: bool,
    /// How light is followed, by which numbers.
    pub rules: Rules,
    /// Which block of the sequences: maps of other blocks are of other light paths.
    pub block: u32,
}

impl Default for Shots {
    /// 2¹⁸ of each, for gathering.
    fn default() -> Shots {
        let (paths, caustics) = (1 << 18, 1 << 18);
        Shots { paths, keep: Keep::Every, caustics, mirrored: false, rules: Rules::default(), block: 0 }
    }
}

/// The maps of a world.
#[derive(Clone, Debug)]
pub struct Maps {
    /// Of the walk.
    pub global: PhotonMap,
    /// Caustics of lamps.
    pub caustic: PhotonMap,
    /// Rays that both took.
    pub rays: u64,
}

impl Keep {
    /// Whether this light is kept.
    pub fn wants(self, light: &Arrival<'_>) -> bool {
        let dull = || !light.surface.finish.dull.is_black();
        match self {
            Keep::Every => answers(&light.surface),
            Keep::Reflected => light.diffused && answers(&light.surface),
            Keep::Caustic => light.is_caustic() && dull(),
            Keep::Direct => light.bounces == 0 && dull(),
        }
    }
}

/// Whether an estimate at a surface finds anything: it has a lobe that is no delta. If all are sharp their peak tells.
fn answers(x: &Surface<'_>) -> bool {
    let mirrored = || x.shading * (2.0 * x.shading.dot(x.wo)) - x.wo;
    !x.finish.dull.is_black() || !x.eval(Class::Sharp, mirrored(), x.wo).is_black()
}

impl Maps {
    /// Fills both maps with the light of all emitters, each multiplied by a tint; black leaves it out.
    pub fn new(world: &World, shots: &Shots, tint: impl Fn(u32) -> Rgb) -> Maps {
        // So many blocks of paths as there are numbers for.
        let block = shots.block % (u32::MAX / shots.paths.max(1));
        let paths = block * shots.paths..(block + 1) * shots.paths;
        let seed = sequence::hash(shots.rules.seed, u32::from(b'c'));
        let (caustics, shot) =
            photon::from_lights(world, shots.caustics, &tint, (shots.block, seed), shots.mirrored);
        let caustic = PhotonMap::new(caustics.iter().map(Photon::from).collect());
        let walk = RandomWalk::tinted(world, shots.rules, tint);
        let (global, walked) = PhotonMap::of_walk(&walk, paths, |light| shots.keep.wants(light));
        Maps { global, caustic, rays: shot + walked }
    }
}

impl PhotonMap {
    /// The light of so many paths of a walk, of it that which is wanted, and the rays that it took.
    pub fn of_walk(
        walk: &RandomWalk<'_>,
        paths: Range<u32>,
        wanted: impl Fn(&Arrival<'_>) -> bool + Sync,
    ) -> (PhotonMap, u64) {
        let share = 1.0 / paths.len().max(1) as f32;
        let store = |photons: &mut Vec<Photon>, light: &Arrival<'_>| {
            if wanted(light) {
                photons.extend(Photon::of(light, share));
            }
        };
        let mut photons = Vec::new();
        let rays = walk.in_waves(paths, store, |run| photons.extend(run));
        (PhotonMap::new(photons), rays)
    }
}

impl Photon {
    /// Light that came to a surface, of a path that is such a share of all; `None` where its surface sees none of it.
    pub fn of(light: &Arrival<'_>, share: f32) -> Option<Photon> {
        let past = Past { dull: light.diffused, sharp_last: light.sharp, shadow: false };
        let lit = light.lit()?;
        Some(Photon::new(light.position(), light.normal(), light.from(), lit * share, past))
    }
}

impl From<&photon::Photon> for Photon {
    /// Of a caustic photon, of whose past no more is known.
    fn from(p: &photon::Photon) -> Photon {
        let past = Past { sharp_last: true, ..Past::default() };
        Photon::new(p.position, p.normal, p.wi, p.flux, past)
    }
}
