//! A batch's photons in three steps: all are shot, sorted by the way they will take, and followed. Photons that fly side
//! by side meet boxes and triangles that the ones before have left in the caches.

use super::aim::{Aim, Shot};
use super::follow::{Numbers, follow};
use super::{Origin, Photon, Source};
use crate::geometry::Ray;
use crate::particle::Vpl;
use crate::sequence::ledger::photon as ledger;
use crate::world::{Body, Surface, World};
use glam::Vec3;
use rayon::prelude::*;

/// Photons that a thread shoots, or follows, at a time.
const RUN: usize = 256;

/// Bits of a coordinate of the way to a body.
const FINE: u32 = 6;

/// A photon that has set out.
#[derive(Clone, Copy, Debug)]
struct Flight<'a, 'w> {
    shot: Shot,
    /// The surface that it leaves, if that can matter to its light.
    from: Option<&'a Surface<'w>>,
    /// Flux that roulette tends to leave it with [lm].
    ordinary: f32,
    /// The place of its source, and its number there.
    source: u32,
    number: u32,
}

/// Traces all photons of some sources, and counts the rays.
pub(super) fn trace(world: &World, sources: &[Source<'_, '_>]) -> (Vec<Photon>, u64) {
    let numbers: Vec<(u32, u32)> =
        (0..).zip(sources).flat_map(|(k, source)| source.order().into_iter().map(move |i| (k, i))).collect();
    let shoot = |(source, number): &(u32, u32)| sources[*source as usize].shoot(world, *source, *number);
    let flights: Vec<Option<Flight<'_, '_>>> = numbers.par_iter().with_min_len(RUN).map(shoot).collect();
    let bodies = world.bodies().all();
    let way = |flight: &Option<Flight<'_, '_>>| {
        flight.map_or(u32::MAX, |f| way(&f.shot.ray, f.shot.body, &bodies[f.shot.body as usize]))
    };
    let mut order: Vec<(u32, u32)> =
        flights.par_iter().zip(0..flights.len() as u32).with_min_len(RUN).map(|(f, k)| (way(f), k)).collect();
    order.par_sort_unstable();
    let done: Vec<(Vec<Photon>, u64)> = order
        .par_chunks(RUN)
        .map(|run| {
            let mut photons = Vec::with_capacity(run.len());
            // All at once: they lie about in memory.
            let flights: Vec<Option<Flight<'_, '_>>> =
                run.iter().map(|(_, k)| flights[*k as usize]).collect();
            let flights = flights.iter().flatten();
            let rays = flights.map(|f| sources[f.source as usize].follow(world, f, &mut photons)).sum();
            (photons, rays)
        })
        .collect();
    let rays = done.iter().map(|(_, rays)| rays).sum();
    let mut photons = Vec::with_capacity(done.iter().map(|(photons, _)| photons.len()).sum());
    done.into_iter().for_each(|(run, _)| photons.extend(run));
    (photons, rays)
}

impl<'a, 'w> Source<'a, 'w> {
    fn numbers(&self, i: u32) -> Numbers {
        Numbers { index: self.first.wrapping_add(i), seed: self.seed }
    }

    /// The numbers of its photons, those of one vertex side by side: vertices are many, and lie about in memory.
    fn order(&self) -> Vec<u32> {
        let numbers = (0..self.count).into_par_iter().with_min_len(RUN);
        match self.origin {
            Origin::Light(..) => numbers.collect(),
            Origin::Vertices(..) => {
                let keyed = |i| ((self.numbers(i).one(ledger::POINT) * 65536.0) as u16, i);
                let mut order: Vec<(u16, u32)> = numbers.map(keyed).collect();
                order.par_sort_unstable();
                order.into_iter().map(|(_, i)| i).collect()
            }
        }
    }

    /// A photon of the source at `place` in its list, unless it carries nothing.
    fn shoot(&self, world: &'w World, place: u32, number: u32) -> Option<Flight<'a, 'w>> {
        let numbers = self.numbers(number);
        let [u, v, s, t] = numbers.four(ledger::POINT);
        let point;
        let (source, from, weight) = match &self.origin {
            Origin::Light(emitter, tint) => {
                let p = emitter.point([u, v]);
                let (position, shine, intensity) = (p.position, p.shine, p.intensity * *tint);
                let (bound, emitter) = (f32::INFINITY, self.emitter);
                point = Vpl { position, shine, intensity, bound, gloss: None, emitter };
                (&point, None, 1.0)
            }
            Origin::Vertices(running, classes) => {
                let total = running.last().map_or(0.0, |(sum, _)| *sum);
                let k = running.partition_point(|(sum, _)| *sum <= f64::from(u) * total);
                let (sum, vertex) = running.get(k)?;
                let own = sum - if k == 0 { 0.0 } else { running[k - 1].0 };
                (*vertex, vertex.gloss.as_ref(), (total / (own * classes)) as f32)
            }
        };
        let aim = Aim::new(world, source);
        let weight = weight / self.count as f32;
        let mut shot = aim.shoot(|| numbers.one(ledger::BODY), [s, t])?;
        shot.flux *= weight;
        Some(Flight { shot, from, ordinary: weight * aim.flux(), source: place, number })
    }

    /// Adds what stays of a photon; counts the rays.
    fn follow(&self, world: &'w World, flight: &Flight<'_, 'w>, photons: &mut Vec<Photon>) -> u64 {
        let Flight { shot, from, ordinary, number, .. } = flight;
        follow(world, shot, *from, *ordinary, self.numbers(*number), (self.emitter, self.mirrored), photons)
    }
}

/// Where rays that take similar ways to a body lie close together: the body, then by turns the bits of where its sphere
/// is met and of the direction.
fn way(ray: &Ray, number: u32, body: &Body) -> u32 {
    let away = ray.origin - body.center;
    let across = away - ray.direction * away.dot(ray.direction);
    let back = (body.radius * body.radius - across.length_squared()).max(0.0).sqrt();
    let [a, b] = square(across - ray.direction * back);
    let [c, d] = square(ray.direction);
    let coordinates = [a, b, c, d].map(|x| (x * (1 << FINE) as f32) as u32);
    (0..FINE).rev().fold(number, |key, bit| coordinates.iter().fold(key, |key, x| key << 1 | (x >> bit & 1)))
}

/// A direction of any length as a point of the unit square, by the octahedron unfolded.
fn square(v: Vec3) -> [f32; 2] {
    let v = v / (v.x.abs() + v.y.abs() + v.z.abs()).max(f32::MIN_POSITIVE);
    let fold = |a: f32, b: f32| if v.z < 0.0 { (1.0 - b.abs()) * a.signum() } else { a };
    [fold(v.x, v.y), fold(v.y, v.x)].map(|x| 0.5 + 0.499 * x)
}
