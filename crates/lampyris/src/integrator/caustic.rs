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

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        let Some(photons) = pass.photons else {
            return caustic_path::tile(pass, tile, out, rays);
        };
        let mut found = vec![Rgb::BLACK; out.len()];
        for p in &tile.packets {
            let plain = p.live & p.lambertian;
            let mut add = |k: usize, found: &[Rgb], factor: Rgb| {
                let at = p.pixels[k] as usize;
                out.iter_mut().zip(found).for_each(|(out, found)| out[at] += factor * *found);
            };
            for k in lanes(plain) {
                found.fill(Rgb::BLACK);
                photons.irradiance(lane(&p.position, k), lane(&p.geometric, k), &mut found);
                add(k, &found, p.throughput[k] * p.reflectance[k] * FRAC_1_PI);
            }
            for k in lanes(p.live & !plain) {
                if let Some(x) = p.visible(k) {
                    found.fill(Rgb::BLACK);
                    photons.radiance(&x.surface, &mut found);
                    add(k, &found, x.throughput);
                }
            }
        }
    }
}

/// Adds the radiance that the dull lobes of `x`, a point of the scene, send on of light that comes over
/// a sharp vertex, by paths that are not *mirror*'s, group by group: by photons where there are any, else by the oracle.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, out: &mut [Rgb], rays: &mut u64) {
    match pass.photons {
        Some(photons) => photons.radiance(x, out),
        None => caustic_path::at(pass, x, numbers, out, rays),
    }
}
