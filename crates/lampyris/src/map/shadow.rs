//! Shadow photons: where a lamp's light goes, and where it would go if nothing were in its way [Jensen and Christensen 1995,
//! as Jarosz05, §2.2.1 has it]. Every photon goes on behind what it meets; from the second surface on it leaves shadow.
//! Where only light lies a point sees the lamp, where only shadow lies it does not; a shadow ray has to find out elsewhere.
//! An estimate, with the errors of one: whoever wants exact light asks by rays everywhere.

use super::PhotonMap;
use super::photon::{Past, Photon};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sequence::ledger::light as ledger;
use crate::sequence::sobol;
use crate::world::World;
use glam::Vec3;
use rayon::prelude::*;

/// Surfaces behind which a photon leaves no more shadow.
const DEEPEST: u32 = 64;

/// Photons that a point must find to be sure.
const ENOUGH: u32 = 8;

/// Light and shadow of one emitter.
#[derive(Clone, Debug)]
pub struct Shadows {
    map: PhotonMap,
}

/// What is known of the way from a point to a lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// Light alone lies there.
    Lit,
    /// Shadow alone.
    Hidden,
    /// Both, or too little.
    Unsure,
}

impl Shadows {
    /// Shoots so many photons of an emitter, the first of their sequence by a seed; and counts rays.
    pub fn new(world: &World, emitter: u32, count: u32, seed: u32) -> (Shadows, u64) {
        let runs: Vec<(Vec<Photon>, u64)> = match world.emitters().get(emitter as usize) {
            Some(lamp) if !lamp.is_dark() => (0..count)
                .into_par_iter()
                .fold_chunks(1024, <(Vec<Photon>, u64)>::default, |(mut photons, rays), k| {
                    let [u, v, s, t] = sobol::sobol_owen_four(k, ledger::POINT, seed);
                    let start = lamp.emit([u, v, s, t], world.bounds());
                    let ray = Ray::new(start.origin, start.direction);
                    let more = leave(world, ray, start.flux * (1.0 / count as f32), &mut photons);
                    (photons, rays + more)
                })
                .collect(),
            _ => Vec::new(),
        };
        let rays = runs.iter().map(|(_, rays)| rays).sum();
        let photons = runs.into_iter().flat_map(|(run, _)| run).collect();
        (Shadows { map: PhotonMap::new(photons) }, rays)
    }

    /// The photons, those of light and those of shadow.
    pub fn map(&self) -> &PhotonMap {
        &self.map
    }

    /// What the photons within `radius` [m] know of the way to the lamp from the side of a surface that the unit `normal`
    /// points to.
    pub fn seen(&self, x: Vec3, normal: Vec3, radius: f32) -> Seen {
        let (mut light, mut shadow) = (0, 0);
        self.map.on_surface_while(x, normal, radius, |photon| {
            if photon.past().shadow {
                shadow += 1
            } else {
                light += 1
            }
            light == 0 || shadow == 0
        });
        match (light, shadow) {
            (ENOUGH.., 0) => Seen::Lit,
            (0, ENOUGH..) => Seen::Hidden,
            _ => Seen::Unsure,
        }
    }
}

/// Leaves light at the first surface and shadow behind it; counts rays.
fn leave(world: &World, mut ray: Ray, flux: Rgb, photons: &mut Vec<Photon>) -> u64 {
    for depth in 0..DEEPEST {
        let Some(y) = world.closest(&ray) else { return u64::from(depth) + 1 };
        if !y.finish.dull.is_black()
            && let Some(arrived) = y.flux_density()
        {
            let past = Past { shadow: depth > 0, ..Past::default() };
            photons.push(Photon::new(y.position, y.normal, y.wo, flux * arrived, past));
        }
        ray = Ray::new(y.spawn(ray.direction), ray.direction);
    }
    u64::from(DEEPEST)
}
