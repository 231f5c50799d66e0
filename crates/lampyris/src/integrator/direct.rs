//! Direct light: L D E with any sharp vertices before the eye.
//!
//! Light points stand for extended lights; close to a surface their geometry term is clamped, and a short ray by the
//! BSDF pays back exactly what the clamp took, so that a lamp 1 mm under a ceiling makes no spikes and loses nothing.

use super::short::{Short, Way};
use super::{Costly, Integrator, Pass, gather};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::Surface;

/// Light points that stand for all of them where a single point is shaded.
pub(super) const LIGHTS: usize = 2;

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
        let near = tile.packets.iter().filter(|p| pass.world.may_glow_near(p.extent(), reach));
        let costly = Costly { purpose: b'd', phase: 0 };
        costly.add(pass, near, out, |x, numbers| near_light(pass, x, Way::Straight, numbers, rays));
    }
}

/// Radiance at one point by all direct light: the clear, scalar form.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, rays: &mut Rays) -> Rgb {
    let u = numbers.one(ledger::light(0));
    let far = gather::from_some_lights(pass.world, x, pass.lights, LIGHTS, u, &mut rays.compensation);
    far + near_light(pass, x, Way::Straight, numbers, rays)
}

/// What clamping took from lights nearby: (G − b)⁺/G of the light that a short ray meets.
pub(super) fn near_light(
    pass: &Pass<'_>,
    x: &Surface<'_>,
    way: Way,
    numbers: Numbers,
    rays: &mut Rays,
) -> Rgb {
    let (world, b) = (pass.world, pass.plan.emitter_bound);
    if b == f32::INFINITY {
        return Rgb::BLACK;
    }
    let reach = 1.0 / b.sqrt();
    if !world.may_glow_near([x.position, x.position], reach) {
        return Rgb::BLACK;
    }
    let Some(s) = Short::new(world, x, way, reach, numbers, 0, &mut rays.compensation) else {
        return Rgb::BLACK;
    };
    let mut sum = Rgb::BLACK;
    let t_max = s.met.as_ref().map_or(s.ray.t_max, |y| (y.position - s.ray.origin).length());
    world.glows(s.ray.origin, s.ray.direction, t_max, |glow| {
        sum += s.clear_to(glow.distance) * glow.radiance * s.taken(glow.distance, glow.cosine, b);
    });
    if let Some(y) = s.met.as_ref().filter(|y| !y.emission().is_black()) {
        sum += s.clear_from(y) * y.emission() * s.taken_from(y, b);
    }
    sum * s.weight
}
