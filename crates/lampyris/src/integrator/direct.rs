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
pub(super) const LIGHTS: f32 = 2.0;

/// Paths L D S* E.
pub(super) struct Direct;

impl Integrator for Direct {
    fn name(&self) -> &'static str {
        "direct"
    }

    fn paths(&self) -> &'static str {
        "L D S* E"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        gather::tile_of_points(pass, tile, gather::Unknown, out, &mut rays.shadow);
        tile_of_near(pass, tile, out, rays);
    }
}

/// Adds what clamping took from lights near the points of a tile.
pub(super) fn tile_of_near(pass: &Pass<'_>, tile: &Tile<'_>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
    let reach = 1.0 / pass.plan.emitter_bound.sqrt();
    if reach == 0.0 {
        return;
    }
    let near = tile.packets.iter().filter(|p| pass.world.may_glow_near(p.extent(), reach));
    let costly = Costly { purpose: b'd', phase: 0, stake: tile.stake };
    costly.add(pass, near, out, |x, numbers, found| {
        near_light(pass, x, Way::Straight, numbers, found, rays);
    });
}

/// Adds the radiance at one point by all direct light, group by group: the clear, scalar form.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, out: &mut [Rgb], rays: &mut Rays) {
    let u = numbers.one(ledger::light(0));
    for (lights, out) in pass.zip(out) {
        let (most, u) = (LIGHTS * lights.share, lights.turned(u));
        let rays = &mut rays.compensation;
        *out += gather::from_some_lights(pass.world, x, lights.points, most, u, rays);
    }
    near_light(pass, x, Way::Straight, numbers, out, rays);
}

/// Adds what clamping took from lights nearby, group by group: (G − b)⁺/G of the light that a short
/// ray meets. It reaches as far as any group's bound asks, and finds for each group what a ray of its own would.
pub(super) fn near_light(
    pass: &Pass<'_>,
    x: &Surface<'_>,
    way: Way,
    numbers: Numbers,
    out: &mut [Rgb],
    rays: &mut Rays,
) {
    let (world, bounds) = (pass.world, &pass.plan.emitter_bounds);
    let reach = 1.0 / pass.plan.emitter_bound.sqrt();
    if reach == 0.0 || !world.may_glow_near([x.position, x.position], reach) {
        return;
    }
    let Some(s) = Short::new(world, x, way, reach, numbers, 0, &mut rays.compensation) else { return };
    let mut add = |emitter: u32, radiance: Rgb, taken: &dyn Fn(f32) -> f32| {
        if let Some((place, tint)) = pass.place_of(emitter) {
            let taken = taken(bounds[pass.lights[place].group]);
            out[place] += s.weight * radiance * tint * taken;
        }
    };
    let t_max = s.met.as_ref().map_or(s.ray.t_max, |y| (y.position - s.ray.origin).length());
    world.glows(s.ray.origin, s.ray.direction, t_max, |glow| {
        let radiance = s.clear_to(glow.distance) * glow.radiance;
        add(glow.emitter, radiance, &|b| s.taken(glow.distance, glow.cosine, b));
    });
    let glowing = s.met.as_ref().filter(|y| !y.emission().is_black());
    if let Some((y, emitter)) = glowing.and_then(|y| Some((y, world.emitter_of(y)?))) {
        add(emitter, s.clear_from(y) * y.emission(), &|b| s.taken_from(y, b));
    }
}
