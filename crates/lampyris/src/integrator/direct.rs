//! Direct light: L D E with any sharp vertices before the eye.
//!
//! Light points stand for extended lights; close to a surface their geometry term is clamped, and a short ray by the
//! BSDF pays back exactly what the clamp took, so that a lamp 1 mm under a ceiling makes no spikes and loses nothing.

use super::{Integrator, Pass, STRIDE, gather, turn_of};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::geometry::Ray;
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::Surface;

/// Light points that stand for all of them where a single point is shaded.
const LIGHTS: usize = 2;

/// Paths L D S* E.
pub(super) struct Direct;

impl Integrator for Direct {
    fn name(&self) -> &'static str {
        "direct"
    }

    fn paths(&self) -> &'static str {
        "L D S* E"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Rgb], rays: &mut Rays) {
        gather::tile(pass, tile, pass.lights, out, &mut rays.shadow);
        let reach = 1.0 / pass.plan.emitter_bound.sqrt();
        if reach == 0.0 {
            return;
        }
        for packet in tile.packets.iter().filter(|p| pass.world.may_glow_near(p.extent(), reach)) {
            for k in packet.lanes() {
                let numbers = packet.numbers[k];
                if turn_of(pass, numbers.seed)
                    && let Some(x) = packet.visible(k)
                {
                    let near = near_light(pass, &x.surface, numbers.branch(b'd'.into()), rays);
                    out[packet.pixels[k] as usize] += x.throughput * near * STRIDE as f32;
                }
            }
        }
    }
}

/// Radiance at one point by all direct light: the clear, scalar form.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, rays: &mut Rays) -> Rgb {
    let u = numbers.one(ledger::light(0));
    let far = gather::from_some_lights(pass.world, x, pass.lights, LIGHTS, u, &mut rays.compensation);
    far + near_light(pass, x, numbers, rays)
}

/// What clamping took from lights nearby: (G − b)⁺/G of the light that a short ray meets.
fn near_light(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, rays: &mut Rays) -> Rgb {
    let (world, b) = (pass.world, pass.plan.emitter_bound);
    if b == f32::INFINITY {
        return Rgb::BLACK;
    }
    // G > b only within 1/√b.
    let reach = 1.0 / b.sqrt();
    if !world.may_glow_near([x.position, x.position], reach) {
        return Rgb::BLACK;
    }
    let u = numbers.pair(ledger::direction(0));
    let Some(s) = x.sample(Class::Dull, u, numbers.one(ledger::lobe(0))) else { return Rgb::BLACK };
    let ray = Ray { origin: x.spawn(s.wi), direction: s.wi, t_max: reach };
    rays.compensation += 1;
    let met = world.closest(&ray);
    let cos_x = x.cosine(s.wi);
    let taken = |distance: f32, cos_y: f32| {
        let g = cos_x * cos_y / (distance * distance);
        if g > b { 1.0 - b / g } else { 0.0 }
    };
    let mut sum = Rgb::BLACK;
    let t_max = met.as_ref().map_or(reach, |y| (y.position - ray.origin).length());
    world.glows(ray.origin, ray.direction, t_max, |glow| {
        let clear = x.clear_to(s.wi, glow.distance, None);
        sum += clear * glow.radiance * taken(glow.distance, glow.cosine);
    });
    if let Some(y) = met.filter(|y| !y.emission().is_black()) {
        let seen = y.emission() * y.clear_from(ray.origin, Some(x));
        sum += seen * taken((y.position - x.position).length(), y.normal.dot(y.wo).abs());
    }
    sum * s.weight
}
