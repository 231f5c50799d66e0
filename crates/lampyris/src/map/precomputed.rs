//! Illuminance kept at photons: every k-th photon of a map has the estimate at its place in an array beside the map, and a
//! look-up finds the nearest of them that lies on the same surface [Christensen 1999]. For final gathering, which asks
//! so often that it is worth while, and forgives steps.
//!
//! At its own place a photon finds itself, one photon more than elsewhere; but a look-up comes to it because nothing lies
//! nearer, and in the disc that is empty one photon would lie in the mean. With a constant kernel the two cancel exactly:
//! what look-ups find is right in the mean. Kernels that weigh the middle more are too bright by less than their peak's
//! share of one photon.

use super::PhotonMap;
use super::estimate::{Estimate, Reader};
use crate::color::Rgb;
use glam::Vec3;
use rayon::prelude::*;

/// Photons that a thread estimates at a time.
const RUN: usize = 256;

/// Least cosine between the normal asked for and the photon's, which is known to within 11.6°.
const SIMILAR: f32 = 0.8;

/// A map with illuminance at its photons.
#[derive(Clone, Debug)]
pub struct Precomputed {
    map: PhotonMap,
    every: u32,
    /// At photons 0, k, 2k … [lx].
    values: Vec<Rgb>,
}

impl Precomputed {
    /// Estimates at every k-th photon, at least every one.
    pub fn new(map: PhotonMap, every: u32, estimate: Estimate) -> Precomputed {
        let every = every.max(1);
        let count = map.photons().len().div_ceil(every as usize) as u32;
        let read = |reader: &mut Reader<'_>, k: u32| {
            let photon = &map.photons()[(k * every) as usize];
            reader.irradiance(photon.position(), photon.normal().into())
        };
        let numbers = (0..count).into_par_iter().with_min_len(RUN);
        let values = numbers.map_init(|| Reader::new(&map, estimate), read).collect();
        Precomputed { map, every, values }
    }

    /// The map.
    pub fn map(&self) -> &PhotonMap {
        &self.map
    }

    /// What is kept, from the first photon on, at every so many [lx].
    pub fn values(&self) -> (&[Rgb], u32) {
        (&self.values, self.every)
    }

    /// Illuminance of the side of a surface that the unit `normal` points to [lx], as it was found at the nearest place not
    /// farther than `radius` [m]; `None` if there is none.
    pub fn irradiance(&self, x: Vec3, normal: Vec3, radius: f32) -> Option<Rgb> {
        let number = self.map.closest(x, radius, |number, photon| {
            number.is_multiple_of(self.every) && Vec3::from(photon.normal()).dot(normal) >= SIMILAR
        })?;
        self.values.get((number / self.every) as usize).copied()
    }
}
