//! Bias compensation: pays back what clamping takes from virtual lights close by [Kollig and Keller 2004].
//!
//! G = min(G, b) + (G − b)⁺. The second term matters only within 1/√b: a short ray by the BSDF finds the vertex y
//! there, and its reflected light counts with weight (G − b)/G. A ray that meets a sharp lobe returns nothing: such
//! paths are *caustic*'s.

use super::short::{Short, Way};
use super::{Costly, Integrator, Pass, caustic, direct, gather, mirror};
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::scene::Group;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::Surface;

/// Vertices after which even the surest roulette ends.
const MAX_VERTICES: u32 = 64;

/// Virtual lights that stand for all of them at the end of a short ray.
const VPLS: f32 = 2.0;

/// Paths L (S|D)* D D S* E, beyond the clamp.
pub(super) struct Compensation;

impl Integrator for Compensation {
    fn name(&self) -> &'static str {
        "compensation"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* D D S* E, (G - b)+"
    }

    fn gathers_photons(&self) -> bool {
        true
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        if pass.plan.bound == f32::INFINITY {
            return;
        }
        let costly = Costly { purpose: b'c', phase: 1, stake: tile.stake };
        costly.add(pass, tile.packets.iter(), out, |x, numbers, found| {
            beyond_clamp(pass, *x, Way::Straight, numbers, found, rays);
        });
    }
}

/// Adds C(x, ω_o) with its recursion C(y) unrolled, continued by roulette, group by group; `way` is that of the first ray.
/// All groups share the rays: where they go has nothing to do with light.
pub(super) fn beyond_clamp<'w>(
    pass: &Pass<'w>,
    mut x: Surface<'w>,
    mut way: Way,
    numbers: Numbers,
    out: &mut [Rgb],
    rays: &mut Rays,
) {
    let (world, b) = (pass.world, pass.plan.bound);
    if b == f32::INFINITY {
        return;
    }
    let reach = 1.0 / b.sqrt();
    let (mut groups, mut more) = ([Rgb::BLACK; Group::MOST], Vec::new());
    let reflected = match groups.get_mut(..out.len()) {
        Some(groups) => groups,
        None => {
            more.resize(out.len(), Rgb::BLACK);
            &mut more
        }
    };
    let mut throughput = Rgb::WHITE;
    for vertex in 0..MAX_VERTICES {
        let Some(s) = Short::new(world, &x, way, reach, numbers, vertex, &mut rays.compensation) else {
            break;
        };
        let Some(y) = s.met else { break };
        let taken = s.taken_from(&y, b);
        if taken == 0.0 || y.finish.dull.is_black() {
            break;
        }
        throughput *= s.weight * s.clear_from(&y) * taken;
        // L_r(y): direct light, light over sharp vertices, clamped virtual lights, and what the clamp takes in turn.
        let branch = numbers.branch(vertex + 1);
        reflected.fill(Rgb::BLACK);
        direct::at(pass, &y, branch, reflected, rays);
        mirror::at(pass, &y, branch.branch(b'm'.into()), reflected, rays);
        caustic::at(pass, &y, branch, reflected, &mut rays.compensation);
        let u = numbers.one(ledger::light(vertex));
        for (lights, reflected) in pass.zip(&mut *reflected) {
            let (most, u) = (VPLS * lights.share, lights.turned(u));
            let rays = &mut rays.compensation;
            *reflected += gather::from_some_vpls(world, &y, lights, most, u, rays);
        }
        out.iter_mut().zip(&*reflected).for_each(|(out, reflected)| *out += throughput * *reflected);
        let stay = throughput.max_channel().clamp(0.0, 1.0);
        if numbers.one(ledger::roulette(vertex)) >= stay {
            break;
        }
        throughput *= 1.0 / stay;
        (x, way) = (y, Way::Either);
    }
}
