//! An eye path through mirrors, glass and polish, one vertex after another.
//!
//! At the first surface it splits, once [Wald et al. 2002, §4]. Where that is dull as well as sharp, the first path ends on
//! its dull lobes and a second one goes on over the sharp ones; where it reflects and passes light sharply, the first goes
//! through and the second is reflected. At later vertices chance decides.

use super::Numbers;
use crate::color::Rgb;
use crate::geometry::{Hit, Ray};
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::{Finish, Surface, World};
use glam::Vec3;

/// Sharp vertices after which an eye path is continued by roulette.
const CERTAIN_VERTICES: u32 = 6;

/// Sharp vertices after which an eye path ends. Glass with facets may hold light for hundreds of them.
const MAX_VERTICES: u32 = 1024;

/// The surest roulette: of paths that lose nothing on their way one in 10⁸ lives to be cut off.
const SUREST: f32 = 0.98;

/// Second paths that have a smaller share of what the first surface reflects are followed by chance, in proportion, where a
/// pixel has one sample; where it has n at once, those of a share n times as large.
const WORTH: f32 = 0.1;

/// How an eye path came to its first dull vertex.
pub(super) struct Ended<'w> {
    /// The vertex, seen along the last ray.
    pub(super) surface: Surface<'w>,
    /// What that ray met.
    pub(super) hit: Hit,
    /// What radiance of that vertex is multiplied by on its way to the eye.
    pub(super) throughput: Rgb,
}

/// The two ways on from the first surface.
struct Fork {
    /// Whether the first path ends there, by the dull lobes.
    ends: bool,
    /// Of the numbers in [0, 1) that choose a sharp lobe, the second path has those below; the first has the rest, unless it
    /// ends.
    second: f32,
}

impl Fork {
    /// `None` where nothing is reflected.
    fn of(surface: &Surface<'_>, numbers: Numbers) -> Option<Fork> {
        let (sharp, dull) = surface.finish.weights();
        match (sharp > 0.0, dull > 0.0) {
            (false, false) => None,
            (any, true) => Some(Fork { ends: true, second: if any { 1.0 } else { 0.0 } }),
            (true, false) => {
                let reflected = surface.reflected_sharply(numbers.pair(ledger::direction(0)));
                Some(Fork { ends: false, second: if reflected < 1.0 { reflected } else { 0.0 } })
            }
        }
    }
}

/// Follows an eye path through sharp lobes to its first dull vertex, telling of what glows on the way: which emitter, and
/// what of its light the eye sees [cd/m²]. Returns where it ends, and whether a second path leaves its first surface.
pub(super) fn first<'w>(
    world: &'w World,
    ray: Ray,
    hit: Option<Hit>,
    numbers: Numbers,
    gleam: &mut impl FnMut(u32, Rgb),
    rays: &mut Rays,
) -> (Option<Ended<'w>>, bool) {
    let mut line = Line { world, numbers, throughput: Rgb::WHITE, pdf: f32::INFINITY };
    let Some((surface, hit)) = line.arrive(&ray, hit, None, gleam) else { return (None, false) };
    let Some(fork) = Fork::of(&surface, numbers) else { return (None, false) };
    let ended = if fork.ends {
        Some(Ended { surface, hit, throughput: line.throughput })
    } else {
        let ray = line.leave(&surface, 0, [fork.second, 1.0], gleam, rays);
        ray.and_then(|ray| line.follow(surface, ray, gleam, rays))
    };
    (ended, fork.second > 0.0)
}

/// Tells of what glows along a ray from the eye before it meets something, but for what glows there itself.
pub(super) fn passing(world: &World, ray: &Ray, hit: Option<Hit>, gleam: &mut impl FnMut(u32, Rgb)) {
    let t_max = hit.map_or(f32::INFINITY, |hit| hit.t);
    world.glows(ray.origin, ray.direction, t_max, |glow| gleam(glow.emitter, glow.radiance));
}

/// Whether the second path that leaves the first surface of an eye path, one of `samples`, is to be followed: then its weight.
pub(super) fn second_weight(surface: &Surface<'_>, numbers: Numbers, samples: u32) -> Option<f32> {
    let fork = Fork::of(surface, numbers)?;
    weight(&surface.finish, fork.second, surface.albedo(Class::Sharp), numbers, samples)
}

/// [`second_weight`] where the first path ends on an opaque surface seen under this cosine, before anything else is known of
/// it: most second paths of many samples are not followed.
pub(super) fn second_weight_seen(
    finish: &Finish,
    cosine: f32,
    numbers: Numbers,
    samples: u32,
) -> Option<f32> {
    let cosine = cosine.clamp(1e-4, 1.0);
    let wo = Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
    weight(finish, 1.0, finish.bsdf.albedo(Class::Sharp, wo), numbers, samples)
}

/// By the share `second` of the sharp lobes, and what those reflect.
fn weight(finish: &Finish, second: f32, albedo: Rgb, numbers: Numbers, samples: u32) -> Option<f32> {
    let sharp = albedo.max_channel();
    let share = second * sharp / (sharp + finish.weights().1);
    let probability = (share / (WORTH * samples as f32).min(1.0)).min(1.0);
    (numbers.one(ledger::class(0)) < probability).then(|| 1.0 / probability)
}

/// Follows that path, with its weight, to its first dull vertex; `numbers` are those of the first path, `own` those of this
/// one. Tells of what glows as [`first`] does, after the first surface.
pub(super) fn second<'w>(
    world: &'w World,
    (origin, surface): (Vec3, Surface<'w>),
    weight: f32,
    [numbers, own]: [Numbers; 2],
    gleam: &mut impl FnMut(u32, Rgb),
    rays: &mut Rays,
) -> Option<Ended<'w>> {
    let throughput = surface.clear_from(origin, None) * weight;
    let mut line = Line { world, numbers, throughput, pdf: f32::INFINITY };
    let below = Fork::of(&surface, numbers)?.second;
    let ray = line.leave(&surface, 0, [0.0, below], gleam, rays)?;
    line.numbers = own;
    line.follow(surface, ray, gleam, rays)
}

/// An eye path on its way.
struct Line<'w> {
    world: &'w World,
    numbers: Numbers,
    /// What the radiance it meets is multiplied by on its way to the eye.
    throughput: Rgb,
    /// Density with which the current ray was chosen; infinite if no light could have been sampled instead.
    pdf: f32,
}

impl<'w> Line<'w> {
    /// Goes on by chance from a ray that left `last`, the first surface.
    fn follow(
        mut self,
        mut last: Surface<'w>,
        mut ray: Ray,
        gleam: &mut impl FnMut(u32, Rgb),
        rays: &mut Rays,
    ) -> Option<Ended<'w>> {
        for vertex in 1..MAX_VERTICES {
            let hit = self.world.tracer().closest(&ray);
            let (surface, hit) = self.arrive(&ray, hit, Some(&last), gleam)?;
            let (sharp, dull) = surface.finish.weights();
            if sharp + dull <= 0.0 {
                return None;
            }
            let go_on = sharp / (sharp + dull);
            // All numbers are less than 1.
            if self.numbers.one(ledger::class(vertex)) >= go_on {
                return Some(Ended { surface, hit, throughput: self.throughput * (1.0 / (1.0 - go_on)) });
            }
            self.throughput *= 1.0 / go_on;
            ray = self.leave(&surface, vertex, [0.0, 1.0], gleam, rays)?;
            last = surface;
        }
        None
    }

    /// Tells of what glows along a ray and where it ends; returns what it meets.
    fn arrive(
        &mut self,
        ray: &Ray,
        hit: Option<Hit>,
        last: Option<&Surface<'_>>,
        gleam: &mut impl FnMut(u32, Rgb),
    ) -> Option<(Surface<'w>, Hit)> {
        let (world, pdf) = (self.world, self.pdf);
        let t_max = hit.map_or(f32::INFINITY, |h| h.t);
        world.glows(ray.origin, ray.direction, t_max, |glow| {
            let clear = last.map_or(Rgb::WHITE, |s| s.clear_to(ray.direction, glow.distance, None));
            gleam(glow.emitter, self.throughput * clear * glow.radiance * balance(pdf, glow.pdf));
        });
        let hit = hit?;
        let surface = world.surface(ray.direction, &hit);
        self.throughput *= surface.clear_from(ray.origin, last);
        if !surface.emission().is_black()
            && let Some(emitter) = world.emitter_of(&surface)
        {
            let weight =
                if pdf.is_finite() { balance(pdf, world.pdf_toward(&surface, ray.origin)) } else { 1.0 };
            gleam(emitter, self.throughput * surface.emission() * weight);
        }
        Some((surface, hit))
    }

    /// Leaves a vertex over those sharp lobes that numbers in a range choose, with what they are of all.
    fn leave(
        &mut self,
        surface: &Surface<'w>,
        vertex: u32,
        [from, to]: [f32; 2],
        gleam: &mut impl FnMut(u32, Rgb),
        rays: &mut Rays,
    ) -> Option<Ray> {
        // The lobes may be shared out: one path tells of the lights that they all reflect.
        if to == 1.0 {
            let throughput = self.throughput;
            highlight(self.world, surface, self.numbers, vertex, rays, |emitter, light| {
                gleam(emitter, throughput * light);
            });
        }
        let [u, v, _, lobe] = self.numbers.four(ledger::direction(vertex));
        let choice = (from + (to - from) * lobe).min(1.0f32.next_down());
        let scatter = surface.sample(Class::Sharp, [u, v], choice)?;
        self.throughput *= scatter.weight * (to - from);
        self.pdf = scatter.pdf;
        if vertex >= CERTAIN_VERTICES {
            let stay = self.throughput.max_channel().clamp(0.0, SUREST);
            if self.numbers.one(ledger::roulette(vertex)) >= stay {
                return None;
            }
            self.throughput *= 1.0 / stay;
        }
        rays.eye += 1;
        Some(Ray::new(surface.spawn(scatter.wi), scatter.wi))
    }
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
