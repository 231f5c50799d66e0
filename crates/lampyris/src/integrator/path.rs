//! The oracle: a plain path tracer with next-event estimation and multiple importance sampling [Veach 1997].
//!
//! It sorts every contribution by the same partition as the fast parts, so that each of them has its own truth.
//! It covers every path but point, spot and directional lights over sharp vertices before x, even over a planar mirror:
//! no path from the eye can find them.

use super::{Integrator, Pass};
use crate::color::Rgb;
use crate::eye::{Eye, Numbers, Tile, balance};
use crate::geometry::Ray;
use crate::material::{Class, Scatter};
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::{Surface, World};

/// Vertices after which a path is continued by roulette.
const CERTAIN_VERTICES: u32 = 4;

/// Vertices after which a path ends. Roulette leaves one in 10⁹ of them where ρ ≤ 0.95.
const MAX_VERTICES: u32 = 1024;

/// Every path, by the oracle.
pub(super) struct Path;

impl Integrator for Path {
    fn name(&self) -> &'static str {
        "path"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* E, less L_point S+ D S* E"
    }

    fn is_smooth(&self) -> bool {
        false
    }

    fn starts_at_the_eye(&self) -> bool {
        true
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        for packet in &tile.packets {
            for k in packet.lanes() {
                let pixel = packet.pixels[k];
                let start = match pass.eye {
                    Eye::Camera(view) => {
                        let (x, y) =
                            (tile.rect.x + pixel % tile.rect.width, tile.rect.y + pixel / tile.rect.width);
                        let offset = pass.sampling.offset;
                        Start::Ray(view.ray(x as f32 + offset[0], y as f32 + offset[1]))
                    }
                    Eye::Meters(_) => match packet.visible(k) {
                        Some(meter) => Start::Surface(meter.surface),
                        None => continue,
                    },
                };
                let numbers = packet.numbers[k].branch(b'p'.into());
                trace(pass.world, start, Scope::Everything, numbers, rays, |emitter, _, light| {
                    if let Some((place, tint)) = pass.place_of(emitter) {
                        out[place][pixel as usize] += light * tint;
                    }
                });
            }
        }
    }
}

/// Where a path begins.
pub(super) enum Start<'w> {
    /// At the eye.
    Ray(Ray),
    /// At a surface that the eye sees.
    Surface(Surface<'w>),
}

/// Which paths are followed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scope {
    /// All.
    Everything,
    /// From the first dull vertex over a sharp one that is no single planar mirror: the part *caustic* alone.
    Caustics,
}

/// What a path from the eye has met so far: light found now belongs to the part of the same row in the partition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum History {
    /// S*.
    Sharp,
    /// S* x, the first dull vertex.
    First,
    /// S* x D …
    Dull,
    /// S* x M, a planar mirror.
    Folded,
    /// S* x M D …
    Mirror,
    /// S* x S …, S* x M S …
    Caustic,
}

impl History {
    fn after(self, class: Class) -> History {
        match (self, class) {
            (History::Sharp, Class::Sharp) => History::Sharp,
            (History::Sharp, Class::Dull) => History::First,
            (History::First, Class::Dull) => History::Dull,
            (History::Folded, Class::Dull) => History::Mirror,
            (History::First | History::Folded, Class::Sharp) => History::Caustic,
            (settled, _) => settled,
        }
    }

    /// [`Self::after`] a surface that scattered light so, which may be a planar mirror.
    fn over(self, x: &Surface<'_>, class: Class, s: &Scatter) -> History {
        let reflected = s.pdf.is_infinite() && x.normal.dot(s.wi) > 0.0;
        if self == History::First && x.mirror.is_some() && reflected {
            return History::Folded;
        }
        self.after(class)
    }
}

/// One path and its connections to the lights: calls `found` with each emitter that it finds, the part that its light
/// belongs to, and the light [cd/m²].
pub(super) fn trace(
    world: &World,
    start: Start<'_>,
    scope: Scope,
    numbers: Numbers,
    rays: &mut Rays,
    mut found: impl FnMut(u32, History, Rgb),
) {
    let found = &mut found;
    let mut throughput = Rgb::WHITE;
    let mut history = History::Sharp;
    // Density with which the current ray was chosen; infinite if next-event estimation cannot have found the same.
    let mut pdf = f32::INFINITY;
    let mut surface = match start {
        Start::Ray(ray) => arrive(world, ray, None, pdf, history, &mut throughput, found, rays),
        Start::Surface(surface) => Some(surface),
    };
    for vertex in 0..MAX_VERTICES {
        let Some(x) = surface else { break };
        let allowed = |class| match (scope, vertex, class) {
            (Scope::Caustics, 0, Class::Sharp) | (Scope::Caustics, 1, Class::Dull) => 0.0,
            (Scope::Caustics, _, Class::Dull) if history == History::Folded => 0.0,
            (_, _, Class::Sharp) => x.finish.weights().0,
            (_, _, Class::Dull) => x.finish.weights().1,
        };
        let (sharp, dull) = (allowed(Class::Sharp), allowed(Class::Dull));
        if sharp + dull <= 0.0 {
            break;
        }
        let probability = |class| (if class == Class::Sharp { sharp } else { dull }) / (sharp + dull);
        for class in [Class::Sharp, Class::Dull] {
            if probability(class) > 0.0 {
                connect(world, &x, class, probability(class), numbers, vertex, rays, |emitter, lit| {
                    found(emitter, history.after(class), throughput * lit);
                });
            }
        }
        let class = if numbers.one(ledger::class(vertex)) < probability(Class::Sharp) {
            Class::Sharp
        } else {
            Class::Dull
        };
        let u = numbers.pair(ledger::direction(vertex));
        let Some(s) = x.sample(class, u, numbers.one(ledger::lobe(vertex))) else { break };
        throughput *= s.weight * (1.0 / probability(class));
        history = history.over(&x, class, &s);
        pdf = s.pdf * probability(class);
        if vertex >= CERTAIN_VERTICES {
            let stay = throughput.max_channel().clamp(0.0, 0.98);
            if numbers.one(ledger::roulette(vertex)) >= stay {
                break;
            }
            throughput *= 1.0 / stay;
        }
        let ray = Ray::new(x.spawn(s.wi), s.wi);
        surface = arrive(world, ray, Some(&x), pdf, history, &mut throughput, found, rays);
    }
}

/// Traces a ray from `start`, or from the eye, and counts what glows along it and at its end.
#[allow(clippy::too_many_arguments, reason = "the state of one path")]
fn arrive<'w>(
    world: &'w World,
    ray: Ray,
    start: Option<&Surface<'w>>,
    pdf: f32,
    history: History,
    throughput: &mut Rgb,
    found: &mut impl FnMut(u32, History, Rgb),
    rays: &mut Rays,
) -> Option<Surface<'w>> {
    rays.path += 1;
    let met = world.closest(&ray);
    let t_max = met.as_ref().map_or(f32::INFINITY, |y| (y.position - ray.origin).length());
    world.glows(ray.origin, ray.direction, t_max, |glow| {
        let clear = start.map_or(Rgb::WHITE, |s| s.clear_to(ray.direction, glow.distance, None));
        found(glow.emitter, history, *throughput * clear * glow.radiance * balance(pdf, glow.pdf));
    });
    if let Some(y) = &met {
        *throughput *= y.clear_from(ray.origin, start);
    }
    let glowing = met.as_ref().filter(|y| !y.emission().is_black());
    if let Some((y, emitter)) = glowing.and_then(|y| Some((y, world.emitter_of(y)?))) {
        let weight = if pdf.is_finite() { balance(pdf, world.pdf_toward(y, ray.origin)) } else { 1.0 };
        found(emitter, history, *throughput * y.emission() * weight);
    }
    met
}

/// Light that one class of lobes at `x` sends on, by a sampled point of each light chosen.
#[allow(clippy::too_many_arguments, reason = "the state of one path")]
fn connect(
    world: &World,
    x: &Surface<'_>,
    class: Class,
    probability: f32,
    numbers: Numbers,
    vertex: u32,
    rays: &mut Rays,
    mut found: impl FnMut(u32, Rgb),
) {
    for (k, share) in world.choose_emitters(numbers.one(ledger::light(vertex))) {
        let emitter = &world.emitters()[k as usize];
        let Some(arrival) = emitter.toward(x.position, numbers.pair(ledger::light_point(vertex))) else {
            continue;
        };
        let value = x.eval(class, x.wo, arrival.wi) * x.cosine(arrival.wi);
        if value.is_black() {
            continue;
        }
        rays.path += 1;
        if world.unblocked(x.spawn(arrival.wi), &arrival) {
            let clear = x.clear_to(arrival.wi, arrival.distance(x.position), None);
            let weight = balance(share * arrival.pdf, probability * x.pdf(class, arrival.wi));
            found(k, value * clear * arrival.weight * (weight / share));
        }
    }
}
