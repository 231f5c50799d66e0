//! Final gather: light that a dull vertex reflects just before x, by rays that look what the scene around reflects [Keller96,
//! §4.3]. It covers what *vpl* and *compensation* do, without virtual lights and without a clamp.
//!
//! What is looked up, the mean of an element or the photons around a point, is biased where light is uneven; how much that is
//! shown directly is a matter of the lobes at x: a matt one averages over many elements, glossy ones see photons.

use super::{Integrator, Pass};
use crate::coarse::{Coarse, Wants};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::geometry::Ray;
use crate::irradiance::evenly;
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::Surface;
use std::f32::consts::FRAC_1_PI;

/// Paths L (S|D)* D D S* E, the first D of them by its mean.
pub(super) struct FinalGather;

impl Integrator for FinalGather {
    fn name(&self) -> &'static str {
        "final-gather"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* D D S* E, by a coarse solution"
    }

    fn wants(&self) -> Wants {
        Wants { reflected: true, ..Wants::default() }
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        let Some(coarse) = pass.coarse else { return };
        let mut found = vec![Rgb::BLACK; out.len()];
        for p in &tile.packets {
            for k in p.lanes() {
                if let Some(x) = p.visible(k) {
                    found.fill(Rgb::BLACK);
                    if let Some((rest, share)) = interpolate(pass, &x.surface, &mut found) {
                        // Where light counts for little, fewer rays look for it.
                        let count = pass.settings.gather.rays as f32 * tile.stake * share;
                        let numbers = p.numbers[k].branch(b'g'.into());
                        gather(
                            pass,
                            coarse,
                            &rest,
                            (numbers, count.ceil().max(1.0) as u32),
                            &mut found,
                            rays,
                        );
                    }
                    for (out, found) in out.iter_mut().zip(&found) {
                        out[p.pixels[k] as usize] += x.throughput * *found;
                    }
                }
            }
        }
    }
}

/// Sets the radiance that `x` reflects evenly, group by group, where it is known from points around. Returns what is left for rays
/// to find, with the share of them that it is worth.
fn interpolate<'w>(pass: &Pass<'w>, x: &Surface<'w>, out: &mut [Rgb]) -> Option<(Surface<'w>, f32)> {
    let Some((irradiance, (even, rest))) = pass.irradiance.zip(evenly(x)) else { return Some((*x, 1.0)) };
    if !irradiance.at(&even, out) {
        return Some((*x, 1.0));
    }
    let factor = even.finish.dull * FRAC_1_PI;
    out.iter_mut().for_each(|out| *out *= factor);
    let [of_all, of_rest] = [Some(*x), rest].map(|x| x.map_or(0.0, |x| x.albedo(Class::Dull).luminance()));
    rest.filter(|_| of_rest > 0.0).map(|rest| (rest, of_rest / of_all))
}

/// Adds the radiance at `x` that so many rays find.
fn gather<'w>(
    pass: &Pass<'w>,
    coarse: &Coarse<'_>,
    x: &Surface<'w>,
    (numbers, count): (Numbers, u32),
    out: &mut [Rgb],
    rays: &mut Rays,
) {
    let factor = Rgb::grey(1.0 / count as f32);
    for ray in 0..count {
        let index = numbers.index.wrapping_mul(count).wrapping_add(ray);
        look(pass, coarse, x, Numbers { index, ..numbers }, factor, out, rays);
    }
}

/// Adds `factor` times the radiance at `x` that one ray finds, group by group.
fn look<'w>(
    pass: &Pass<'w>,
    coarse: &Coarse<'_>,
    x: &Surface<'w>,
    numbers: Numbers,
    mut factor: Rgb,
    out: &mut [Rgb],
    rays: &mut Rays,
) {
    let world = pass.world;
    let mut x = *x;
    let by_photons = x.finish.lambertian.is_none() && coarse.has_photons();
    for level in 0..pass.settings.gather.levels {
        let [u, v, _, lobe] = numbers.four(ledger::direction(level));
        let Some(s) = x.sample(Class::Dull, [u, v], lobe) else { return };
        let ray = Ray::new(x.spawn(s.wi), s.wi);
        factor *= s.weight;
        rays.gather += 1;
        let hit = world.tracer().closest(&ray);
        if level > 0 {
            // L₀(y), which photons bring to a glossy vertex if they light it.
            let t_max = hit.as_ref().map_or(f32::INFINITY, |hit| hit.t);
            world.glows(ray.origin, ray.direction, t_max, |glow| {
                let clear = x.clear_to(ray.direction, glow.distance, None);
                shine(pass, glow.emitter, factor * clear * glow.radiance, out);
            });
        }
        let Some(hit) = hit else { return };
        let y = world.surface(s.wi, &hit);
        factor *= y.clear_from(ray.origin, Some(&x));
        if level > 0
            && !y.emission().is_black()
            && let Some(emitter) = world.emitter_of(&y)
        {
            shine(pass, emitter, factor * y.emission(), out);
        }
        if !by_photons {
            return coarse.add_mean(world, &hit, &y, factor, out);
        }
        let last = level + 1 == pass.settings.gather.levels;
        match y.parted().filter(|_| !last && y.finish.lambertian.is_none()) {
            None => return coarse.add_lit(&y, factor, out),
            Some([even, glossy]) => {
                coarse.add_lit(&even, factor, out);
                x = glossy;
            }
        }
    }
}

fn shine(pass: &Pass<'_>, emitter: u32, radiance: Rgb, out: &mut [Rgb]) {
    if let Some((place, tint)) = pass.place_of(emitter) {
        out[place] += radiance * tint;
    }
}
