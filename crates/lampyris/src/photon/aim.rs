//! Photons aimed at sharp bodies: from a point that shines, into the cone around the sphere of one of them
//! [Jarosz05], chosen by the light that may go there. From within a sphere, or where a cone would be wider than what the
//! source sends out at all, the photon leaves as any particle would.

use crate::color::Rgb;
use crate::geometry::{Frame, Ray};
use crate::light::Shine;
use crate::material::Class;
use crate::particle::Vpl;
use crate::sampling::{concentric_disc, cosine_hemisphere, uniform_cap, uniform_sphere};
use crate::world::{Body, MOST_BODIES, World};
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, PI, TAU};

/// A photon that sets out, were it the only one of its source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shot {
    pub(super) ray: Ray,
    /// Flux over the probabilities of body and direction [lm].
    pub(super) flux: Rgb,
    /// The body that it must meet first.
    pub(super) body: u32,
}

/// A point that shines, and what of its light may meet each sharp body.
pub(super) struct Aim<'a, 'w> {
    world: &'w World,
    source: &'a Vpl<'w>,
    /// Running sum over the bodies of bound × worth.
    running: [f32; MOST_BODIES],
}

/// How to reach a body.
enum Reach {
    /// By directions within a cone, given by its axis and its height 1 − cos α.
    Cone(Vec3, f32),
    /// By all directions in which the source shines.
    Everywhere,
    /// By parallel light through the disc across its sphere.
    Across,
}

impl<'a, 'w> Aim<'a, 'w> {
    /// Looks from a source at all bodies.
    pub(super) fn new(world: &'w World, source: &'a Vpl<'w>) -> Aim<'a, 'w> {
        let brightness = source.intensity.max_channel().max(0.0) * albedo(source);
        let mut running = [0.0; MOST_BODIES];
        let mut sum = 0.0;
        for (body, running) in world.bodies().all().iter().zip(&mut running) {
            sum += brightness * body.worth * reach(source, body).1;
            *running = sum;
        }
        Aim { world, source, running }
    }

    /// Flux that may meet sharp bodies, times what they are worth [lm]. It steers choices alone.
    pub(super) fn flux(&self) -> f32 {
        self.world.bodies().all().len().checked_sub(1).map_or(0.0, |last| self.running[last])
    }

    /// A photon: `choice` picks the body, `turn` the direction; `None` where the source does not shine that way.
    pub(super) fn shoot(&self, choice: impl FnOnce() -> f32, turn: [f32; 2]) -> Option<Shot> {
        let bodies = self.world.bodies().all();
        let sum = self.flux();
        // One body is no choice.
        let reached = if bodies.len() > 1 { choice() * sum } else { 0.0 };
        let k = self.running[..bodies.len()].partition_point(|r| *r <= reached);
        let body = bodies.get(k)?;
        let share = (self.running[k] - if k == 0 { 0.0 } else { self.running[k - 1] }) / sum;
        let (ray, flux) = shoot(self.world, self.source, body, turn)?;
        let flux = flux * (1.0 / share);
        (!flux.is_black()).then_some(Shot { ray, flux, body: k as u32 })
    }
}

/// How to reach a body from a source, and a bound of ∫ (angular law) dω over the ways there; parallel light is counted
/// by area [m²].
fn reach(source: &Vpl<'_>, body: &Body) -> (Reach, f32) {
    if let Shine::Distant = source.shine {
        return (Reach::Across, PI * body.radius * body.radius);
    }
    let everywhere = match source.shine {
        Shine::Lambert(n) if !body.may_be_before(source.position, n) => return (Reach::Everywhere, 0.0),
        Shine::Lambert(_) => PI,
        Shine::Beam(_, beam) => beam.solid_angle(),
        Shine::Isotropic | Shine::Distant => 2.0 * TAU,
    };
    let d = body.center - source.position;
    let (d2, r2) = (d.length_squared(), body.radius * body.radius);
    if d2 <= r2 {
        return (Reach::Everywhere, everywhere);
    }
    let axis = d / d2.sqrt();
    let sin2 = r2 / d2;
    let cos = (1.0 - sin2).sqrt();
    let height = sin2 / (1.0 + cos);
    // The largest cosine with an axis of the source within the cone: cos(θ − α), or 1 if the axis lies in it.
    let nearest = |n: Vec3| {
        let c = n.dot(axis);
        if c >= cos { 1.0 } else { c * cos + ((1.0 - c * c).max(0.0) * sin2).sqrt() }
    };
    let peak = match source.shine {
        Shine::Lambert(n) => nearest(n).max(0.0),
        Shine::Beam(axis, beam) => beam.profile(nearest(axis)),
        Shine::Isotropic | Shine::Distant => 1.0,
    };
    let bound = TAU * height * peak;
    if bound < everywhere { (Reach::Cone(axis, height), bound) } else { (Reach::Everywhere, everywhere) }
}

/// A ray toward a body and the flux that it stands for.
fn shoot(world: &World, source: &Vpl<'_>, body: &Body, turn: [f32; 2]) -> Option<(Ray, Rgb)> {
    let (direction, law) = match (reach(source, body).0, source.shine) {
        (Reach::Across, _) | (_, Shine::Distant) => {
            let travel = -source.position;
            let f = Frame::new(travel);
            let [x, y] = concentric_disc(turn);
            // From outside of everything: whatever stands before the body keeps the light off it.
            let back = travel * (2.0 * world.bounds().radius);
            let start = body.center + (f.s * x + f.t * y) * body.radius - back;
            return Some((Ray::new(start, travel), source.intensity * (PI * body.radius * body.radius)));
        }
        (Reach::Cone(axis, height), shine) => {
            let direction = Frame::new(axis).to_world(uniform_cap(turn, height));
            let profile = match shine {
                Shine::Lambert(n) => n.dot(direction).max(0.0),
                Shine::Beam(axis, beam) => beam.profile(axis.dot(direction)),
                Shine::Isotropic | Shine::Distant => 1.0,
            };
            (direction, profile * TAU * height)
        }
        (Reach::Everywhere, Shine::Lambert(n)) => (Frame::new(n).to_world(cosine_hemisphere(turn)), PI),
        (Reach::Everywhere, Shine::Beam(axis, beam)) => {
            (Frame::new(axis).to_world(beam.sample(turn)), beam.solid_angle())
        }
        (Reach::Everywhere, Shine::Isotropic) => (uniform_sphere(turn), 2.0 * TAU),
    };
    let intensity = match &source.gloss {
        Some(y) => source.intensity * y.eval(Class::Dull, direction, y.wo),
        None => source.intensity,
    };
    (law > 0.0).then(|| (Ray::new(source.position, direction), intensity * law))
}

/// What a glossy vertex, whose `intensity` is a flux, sends on per solid angle, roughly; 1 for others.
fn albedo(source: &Vpl<'_>) -> f32 {
    let albedo = |dull: Rgb| dull.max_channel().max(0.0) * FRAC_1_PI;
    source.gloss.as_ref().map_or(1.0, |y| albedo(y.finish.dull))
}
