//! Light that reaches the first dull vertex over a sharp one, L (S|D)* S D S* E, unless that is a single planar mirror
//! (the part *mirror*): by photons that lie around it, of any kind of light.
//!
//! Meters have no photons, which stay at surfaces. They take the oracle, the part *caustic-path*, which cannot find
//! caustics of point, spot and directional lights.

use super::{Integrator, Pass, caustic_path};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::geometry::{lane, lanes};
use crate::settings::Rays;
use crate::world::Surface;
use std::f32::consts::FRAC_1_PI;

/// Paths L (S|D)* S D S* E, less *mirror*'s.
pub(super) struct Caustic;

impl Integrator for Caustic {
    fn name(&self) -> &'static str {
        "caustic"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* S D S* E, less mirror"
    }

    fn gathers_photons(&self) -> bool {
        true
    }

    fn is_smooth(&self) -> bool {
        false
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Rgb], rays: &mut Rays) {
        let Some(photons) = pass.photons else {
            return caustic_path::tile(pass, tile, out, rays);
        };
        for p in &tile.packets {
            let plain = p.live & p.lambertian;
            for k in lanes(plain) {
                let e = photons.irradiance(lane(&p.position, k), lane(&p.geometric, k));
                out[p.pixels[k] as usize] += p.throughput[k] * p.reflectance[k] * e * FRAC_1_PI;
            }
            for k in lanes(p.live & !plain) {
                if let Some(x) = p.visible(k) {
                    out[p.pixels[k] as usize] += x.throughput * photons.radiance(&x.surface);
                }
            }
        }
    }
}

/// Radiance that the dull lobes of `x`, a point of the scene, send on of light that comes over a sharp vertex, by paths
/// that are not *mirror*'s: by photons where there are any, else by the oracle.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, rays: &mut u64) -> Rgb {
    match pass.photons {
        Some(photons) => photons.radiance(x),
        None => caustic_path::at(pass.world, x, numbers, rays),
    }
}
