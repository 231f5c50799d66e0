//! Final gather: light that a dull vertex reflects just before x, by rays that look what elements of the scene reflect
//! [Keller96, §4.3, "Indirect Diffuse Illumination"]. It covers what *vpl* and *compensation* do, without virtual lights and
//! without a clamp, and takes the mean of an element for its light: there it is biased, and by no more.

use super::{Integrator, Pass};
use crate::coarse::Coarse;
use crate::color::Rgb;
use crate::eye::{Numbers, Tile};
use crate::geometry::Ray;
use crate::material::Class;
use crate::sequence::ledger::eye as ledger;
use crate::settings::Rays;
use crate::world::Surface;

/// Paths L (S|D)* D D S* E, where light leaves the first D of them evenly.
pub(super) struct FinalGather;

impl Integrator for FinalGather {
    fn name(&self) -> &'static str {
        "final-gather"
    }

    fn paths(&self) -> &'static str {
        "L (S|D)* D D S* E, by means of elements"
    }

    fn reads_elements(&self) -> bool {
        true
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        let Some(coarse) = pass.coarse else { return };
        // Where light counts for little, fewer rays look for it.
        let count = (pass.settings.gather.rays as f32 * tile.stake).ceil().max(1.0) as u32;
        let mut found = vec![Rgb::BLACK; out.len()];
        for p in &tile.packets {
            for k in p.lanes() {
                if let Some(x) = p.visible(k) {
                    found.fill(Rgb::BLACK);
                    let numbers = p.numbers[k].branch(b'g'.into());
                    at(pass, coarse, &x.surface, numbers, count, &mut found);
                    rays.gather += u64::from(count);
                    for (out, found) in out.iter_mut().zip(&found) {
                        out[p.pixels[k] as usize] += x.throughput * *found;
                    }
                }
            }
        }
    }
}

/// Adds the radiance at one point that so many rays find, group by group.
fn at(pass: &Pass<'_>, coarse: &Coarse<'_>, x: &Surface<'_>, numbers: Numbers, count: u32, out: &mut [Rgb]) {
    let world = pass.world;
    for k in 0..count {
        let numbers = Numbers { index: numbers.index.wrapping_mul(count).wrapping_add(k), ..numbers };
        let [u, v, _, lobe] = numbers.four(ledger::direction(0));
        let Some(s) = x.sample(Class::Dull, [u, v], lobe) else { continue };
        let ray = Ray::new(x.spawn(s.wi), s.wi);
        let Some(hit) = world.tracer().closest(&ray) else { continue };
        let y = world.surface(s.wi, &hit);
        let factor = s.weight * y.clear_from(ray.origin, Some(x)) * (1.0 / count as f32);
        coarse.add(world, &hit, y.front, factor, out);
    }
}
