//! Photon maps: light that came to surfaces, in a balanced 3d-tree of twenty bytes a photon, and what it tells of any point
//! [Keller96; Jarosz05, §2].
//!
//! A map ([`PhotonMap`]) is made once, of a world or of a batch, and read by any number of threads ([`Reader`]), by one of three
//! kernels over a fixed radius or the nearest photons (`kernel`, `estimate`). For those who ask very often illuminance is kept at
//! the photons themselves ([`Precomputed`]). The caustic photons of a batch in their hash grid are another matter
//! ([`crate::photon`]): there the radius is known beforehand. Nothing here knows of pixels.
//!
//! ```
//! use glam::Vec3;
//! use lampyris::map::{Estimate, Kernel, Maps, Precomputed, Reach, Reader, Shots};
//! use lampyris::{Rgb, geometry::Ray, import, world::World};
//!
//! let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! let world = World::new(import::load(file.as_ref(), &import::Options::default())?.scene);
//! let shots = Shots { paths: 1 << 14, ..Shots::default() };
//! let maps = Maps::new(&world, &shots, |_emitter| Rgb::WHITE);
//! assert!(maps.caustic.photons().is_empty()); // nothing is sharp here
//!
//! let floor = world.closest(&Ray::new(Vec3::new(3.5, 1.0, 1.0), Vec3::NEG_Y)).unwrap();
//! let estimate = Estimate { kernel: Kernel::Constant, reach: Reach::Nearest { count: 100, within: 1.0 } };
//! let mut reader = Reader::new(&maps.global, estimate);
//! let lux = reader.irradiance(floor.position, floor.normal).luminance();
//! let radiance = reader.radiance(&floor); // toward floor.wo [cd/m²]
//! assert!(lux > 0.5 && lux < 5.0 && radiance.luminance() > 0.1 * lux, "{lux} lx, {radiance:?}");
//!
//! let kept = Precomputed::new(maps.global, 4, estimate);
//! let near = kept.irradiance(floor.position, floor.normal, 0.5).unwrap();
//! assert!((near.luminance() / lux - 1.0).abs() < 0.5, "{near:?} for {lux}");
//! # Ok::<(), lampyris::Error>(())
//! ```

mod direction;
mod estimate;
mod kernel;
mod photon;
mod power;
mod precomputed;
mod search;
mod shadow;
#[cfg(test)]
mod tests;
mod tree;
mod world;

pub use direction::{CoarseNormal, Direction};
pub use estimate::{Estimate, Reach, Reader};
pub use kernel::Kernel;
pub use photon::{Past, Photon};
pub use power::Power;
pub use precomputed::Precomputed;
pub use search::Nearest;
pub use shadow::{Seen, Shadows};
pub use world::{Keep, Maps, Shots};

use crate::color::Rgb;
use glam::Vec3;

/// Photons in a balanced 3d-tree.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotonMap {
    /// In the order of the tree.
    photons: Vec<Photon>,
    /// The box around all of them.
    extent: [Vec3; 2],
}

impl PhotonMap {
    /// Sorts photons; those that lie nowhere are left out, and all beyond 2³². Equal photons in equal order give equal bits on
    /// any number of threads.
    pub fn new(mut photons: Vec<Photon>) -> PhotonMap {
        photons.retain(|p| p.position().is_finite());
        photons.truncate(u32::MAX as usize);
        PhotonMap { extent: tree::extent(&photons), photons: tree::balanced(&photons) }
    }

    /// All photons, in the order of the tree; the place in it is a photon's number.
    pub fn photons(&self) -> &[Photon] {
        &self.photons
    }

    /// The box around them; of an empty map nothing, from +∞ to −∞.
    pub fn extent(&self) -> [Vec3; 2] {
        self.extent
    }

    /// What all of them carry [lm].
    pub fn flux(&self) -> Rgb {
        let mut sum = [0.0_f64; 3];
        for photon in &self.photons {
            let flux = photon.flux();
            (0..3).for_each(|k| sum[k] += f64::from(flux[k]));
        }
        let [r, g, b] = sum.map(|c| c as f32);
        Rgb::new(r, g, b)
    }
}
