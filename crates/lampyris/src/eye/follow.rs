//! An eye path through mirrors, glass and polish, one vertex after another.

use super::Numbers;
use crate::color::Rgb;
use crate::geometry::{Hit, Ray};
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::{Finish, Surface, World};

/// Sharp vertices after which an eye path is continued by roulette.
const CERTAIN_VERTICES: u32 = 6;

/// Sharp vertices after which an eye path ends. Glass with facets may hold light for hundreds of them.
const MAX_VERTICES: u32 = 1024;

/// The surest roulette: of paths that lose nothing on their way one in 10⁸ lives to be cut off.
const SUREST: f32 = 0.98;

/// How an eye path came to its first dull vertex.
pub(super) struct Ended<'w> {
    /// The vertex, seen along the last ray.
    pub(super) surface: Surface<'w>,
    /// What that ray met.
    pub(super) hit: Hit,
    /// What radiance of that vertex is multiplied by on its way to the eye.
    pub(super) throughput: Rgb,
}

/// What becomes of an eye path at a vertex, and the weight of having chosen so.
pub(super) enum Next {
    /// Nothing is reflected.
    Lost,
    /// The vertex is the one to shade, by its dull lobes.
    Ends(f32),
    /// It goes on over the sharp lobes.
    GoesOn(f32),
}

/// Chooses between the classes of lobes at vertex number `vertex`.
#[inline]
pub(super) fn next(finish: &Finish, numbers: Numbers, vertex: u32) -> Next {
    let (sharp, dull) = finish.weights();
    if sharp + dull <= 0.0 {
        return Next::Lost;
    }
    if sharp == 0.0 {
        return Next::Ends(1.0);
    }
    let go_on = sharp / (sharp + dull);
    if numbers.one(ledger::class(vertex)) >= go_on {
        Next::Ends(1.0 / (1.0 - go_on))
    } else {
        Next::GoesOn(1.0 / go_on)
    }
}

/// Follows an eye path through sharp lobes to its first dull vertex, telling of what glows on the way: which emitter, and
/// what of its light the eye sees [cd/m²].
pub(super) fn follow<'w>(
    world: &'w World,
    mut ray: Ray,
    first: Option<Hit>,
    numbers: Numbers,
    mut gleam: impl FnMut(u32, Rgb),
    rays: &mut Rays,
) -> Option<Ended<'w>> {
    let mut throughput = Rgb::WHITE;
    // Density with which the current ray was chosen; infinite if no light could have been sampled instead.
    let mut pdf = f32::INFINITY;
    let mut hit = first;
    let mut last: Option<Surface<'_>> = None;
    for vertex in 0..MAX_VERTICES {
        let t_max = hit.map_or(f32::INFINITY, |h| h.t);
        world.glows(ray.origin, ray.direction, t_max, |glow| {
            let clear = last.map_or(Rgb::WHITE, |s| s.clear_to(ray.direction, glow.distance, None));
            gleam(glow.emitter, throughput * clear * glow.radiance * balance(pdf, glow.pdf));
        });
        let at = hit?;
        let surface = world.surface(ray.direction, &at);
        throughput *= surface.clear_from(ray.origin, last.as_ref());
        if !surface.emission().is_black()
            && let Some(emitter) = world.emitter_of(&surface)
        {
            let weight =
                if pdf.is_finite() { balance(pdf, world.pdf_toward(&surface, ray.origin)) } else { 1.0 };
            gleam(emitter, throughput * surface.emission() * weight);
        }
        match next(&surface.finish, numbers, vertex) {
            Next::Lost => return None,
            Next::Ends(weight) => {
                return Some(Ended { surface, hit: at, throughput: throughput * weight });
            }
            Next::GoesOn(weight) => throughput *= weight,
        }
        highlight(world, &surface, numbers, vertex, rays, |emitter, light| {
            gleam(emitter, throughput * light)
        });
        let [u, v, _, lobe] = numbers.four(ledger::direction(vertex));
        let scatter = surface.sample(Class::Sharp, [u, v], lobe)?;
        throughput *= scatter.weight;
        pdf = scatter.pdf;
        if vertex >= CERTAIN_VERTICES {
            let stay = throughput.max_channel().clamp(0.0, SUREST);
            if numbers.one(ledger::roulette(vertex)) >= stay {
                return None;
            }
            throughput *= 1.0 / stay;
        }
        ray = Ray::new(surface.spawn(scatter.wi), scatter.wi);
        rays.eye += 1;
        last = Some(surface);
        hit = world.tracer().closest(&ray);
    }
    None
}

/// Lights reflected by polish that is no delta lobe, by next-event estimation.
fn highlight(
    world: &World,
    surface: &Surface<'_>,
    numbers: Numbers,
    vertex: u32,
    rays: &mut Rays,
    mut gleam: impl FnMut(u32, Rgb),
) {
    let [u, v, choice, _] = numbers.four(ledger::light_point(vertex));
    for (emitter, share) in world.choose_emitters(choice) {
        let Some(arrival) = world.emitters()[emitter as usize].toward(surface.position, [u, v]) else {
            continue;
        };
        let value = surface.eval(Class::Sharp, surface.wo, arrival.wi) * surface.cosine(arrival.wi);
        if value.is_black() {
            continue;
        }
        rays.eye += 1;
        if world.unblocked(surface.spawn(arrival.wi), &arrival) {
            let weight = balance(share * arrival.pdf, surface.pdf(Class::Sharp, arrival.wi));
            let clear = surface.clear_to(arrival.wi, arrival.distance(surface.position), None);
            gleam(emitter, value * clear * arrival.weight * (weight / share));
        }
    }
}

/// The balance heuristic [Veach 1997, eq. 9.12]; a technique of infinite density (a delta) takes all.
pub(crate) fn balance(own: f32, other: f32) -> f32 {
    if own.is_infinite() { 1.0 } else { own / (own + other) }
}
