//! The mean diffusely reflected radiance of each element: every particle that hits it adds its flux, attenuated by what the
//! dull lobes of the surface reflect [Keller96, §4.3, "Indirect Diffuse Illumination"].

use super::Elements;
use crate::color::Rgb;
use crate::material::{Bsdf, Class, Diffuse, Ward};
use crate::scatter::{Arrival, RandomWalk};
use crate::world::{Surface, World};
use std::f64::consts::PI;
use std::ops::Range;

/// What paths have left on the elements of a world.
#[derive(Clone, Debug, Default)]
pub struct ElementLight {
    /// Flux that each sends on diffusely, summed over the paths [lm].
    sums: Vec<[f64; 3]>,
    /// N.
    paths: u64,
    rays: u64,
}

impl ElementLight {
    /// Of no path yet.
    pub fn new(elements: &Elements) -> ElementLight {
        ElementLight { sums: vec![[0.0; 3]; elements.len()], paths: 0, rays: 0 }
    }

    /// The light of some paths of a walk, on all threads; the same bits on any number of them.
    pub fn of(walk: &RandomWalk<'_>, elements: &Elements, numbers: Range<u32>) -> ElementLight {
        let mut light = ElementLight::new(elements);
        let world = walk.world();
        let take = |left: &mut Vec<(u32, Rgb)>, arrival: &Arrival<'_>| {
            elements.lit_by(world, arrival, |element, flux| left.push((element, flux)));
        };
        let count = numbers.len() as u32;
        let rays = walk.in_waves(numbers, take, |left| light.add(&left, 0, 0));
        light.add(&[], count, rays);
        light
    }

    /// Adds what so many more paths left, in its order, and the rays that they took.
    pub(crate) fn add(&mut self, left: &[(u32, Rgb)], paths: u32, rays: u64) {
        for (element, flux) in left {
            let sum = &mut self.sums[*element as usize];
            let flux = [flux.r, flux.g, flux.b].map(f64::from);
            (0..3).for_each(|c| sum[c] += flux[c]);
        }
        self.paths += u64::from(paths);
        self.rays += rays;
    }

    /// N: the paths so far.
    pub fn paths(&self) -> u64 {
        self.paths
    }

    /// The rays that they took.
    pub fn rays(&self) -> u64 {
        self.rays
    }

    /// L̄_{A_k}: mean radiance that the element reflects, and lets through, diffusely [cd/m²]; its emission apart.
    pub fn radiance(&self, elements: &Elements, element: u32) -> Rgb {
        let [r, g, b] = self.exact(elements, element).map(|x| x as f32);
        Rgb::new(r, g, b)
    }

    /// [`Self::radiance`] of all, for lookups by [`Elements::at`].
    pub fn radiances(&self, elements: &Elements) -> Vec<Rgb> {
        (0..elements.len() as u32).map(|k| self.radiance(elements, k)).collect()
    }

    /// In double precision; nothing where there is no area.
    pub(super) fn exact(&self, elements: &Elements, element: u32) -> [f64; 3] {
        let per = PI * f64::from(elements.area(element)) * self.paths as f64;
        self.sums[element as usize].map(|sum| if per > 0.0 { sum / per } else { 0.0 })
    }
}

impl Elements {
    /// Calls `add` with each element on which an arrival leaves light, and the flux that it sends on diffusely, of a path that
    /// were the only one [lm]: on the side of arrival, and on the other where light passes.
    pub fn lit_by(&self, world: &World, arrival: &Arrival<'_>, mut add: impl FnMut(u32, Rgb)) {
        let Some(flux) = arrival.lit() else { return };
        let front = arrival.surface.front;
        let [reflected, passed] = shares(&arrival.surface);
        for (share, front) in [(reflected, front), (passed, !front)] {
            if let (false, Some(element)) = (share.is_black(), self.at(world, &arrival.hit, front)) {
                add(element, flux * share);
            }
        }
    }
}

/// What the dull lobes send back to the side of `wo` of light that comes from there, and what to the other. Of rough glass,
/// half each. The same they send toward `wo` of light that is even on a side, by reciprocity.
pub(crate) fn shares(y: &Surface<'_>) -> [Rgb; 2] {
    if let Some(rho) = y.finish.lambertian {
        return [rho, Rgb::BLACK];
    }
    let all = y.albedo(Class::Dull);
    match y.finish.bsdf {
        Bsdf::Diffuse(m) => [m.reflectance, m.transmittance],
        Bsdf::Ward(m) => {
            let base = Diffuse { transmittance: Rgb::BLACK, ..m.base };
            let opaque = Ward { base, transmission: Rgb::BLACK, ..m };
            let cosine = y.cosine(y.wo).min(1.0);
            let sine = (1.0 - cosine * cosine).sqrt();
            let back = opaque.albedo(Class::Dull, glam::Vec3::new(sine, 0.0, cosine));
            [back, (all + back * -1.0).map(|x| x.max(0.0))]
        }
        Bsdf::Dielectric(_) | Bsdf::Pbr(_) if y.finish.transmits => [all * 0.5; 2],
        Bsdf::Dielectric(_) | Bsdf::Pbr(_) => [all, Rgb::BLACK],
    }
}
