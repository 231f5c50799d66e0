//! Edges deserve eye rays, not light rays: where surfaces meet within a pixel or beside it, further eye rays find which,
//! and borrow the light of neighbours on the same surface. A ray that finds no neighbour to borrow from is dropped.

use super::seen::{NORMAL, POSITION, SLACK, rest};
use super::{FACING, Filter, Seen, Smooth};
use crate::color::Rgb;
use crate::eye::{LANES, Packet, Rect, Sampling, Tile};
use crate::geometry::lane;
use crate::sequence;
use glam::Vec3;

/// Further rays for a pixel at an edge: with its first they make a lattice of five.
const FURTHER: u32 = 4;

/// Looks again at the pixels of row `y` where surfaces meet, and makes what they show the mean of all looks. `row`, of each
/// layer, already holds their first. Returns the rays it took.
pub(super) fn refine(
    filter: &Filter<'_>,
    seen: &Seen,
    smooth: &Smooth,
    y: u32,
    row: &mut [&mut [Rgb]],
) -> u64 {
    let columns: Vec<u32> = (0..seen.width).filter(|x| smooth.edge(*x, y)).collect();
    if columns.is_empty() {
        return 0;
    }
    let rect = Rect { x: 0, y, width: seen.width, height: 1 };
    let packets = columns.chunks(LANES).map(|chunk| {
        let pixels = std::array::from_fn(|k| chunk.get(k).copied().unwrap_or(u32::MAX));
        Packet::new(filter.world, rect, pixels)
    });
    let mut tile = Tile { rect, packets: packets.collect(), rays: 0 };
    let width = seen.width as usize;
    let mut counts = vec![0.0; width];
    let mut sums = vec![Rgb::BLACK; width * row.len()];
    let mut rays = 0;
    for look in 1..=FURTHER {
        let shift = |by: u32| (by * look) as f32 / (FURTHER + 1) as f32;
        let [u, v] = filter.sampling.offset;
        let offset = [(u + shift(1)).fract(), (v + shift(2)).fract()];
        let seed = sequence::hash(filter.sampling.seed, look);
        filter.eye.look(&Sampling { offset, seed, ..filter.sampling }, &mut tile);
        rays += tile.rays;
        for p in &tile.packets {
            let mut kept = 0u16;
            for k in p.lanes() {
                let (x, live) = (p.pixels[k], p.live >> k & 1 == 1);
                let (near, count) = if live { neighbours(seen, p, k, x, y) } else { Default::default() };
                if live && count == 0 {
                    continue;
                }
                let borrow = p.throughput[k] * p.reflectance[k] * (1.0 / count.max(1) as f32);
                kept |= 1 << k;
                counts[x as usize] += 1.0;
                for (layer, sums) in sums.chunks_mut(width).enumerate() {
                    let light = near[..count].iter().map(|(x, y)| smooth.at(layer, *x, *y));
                    let light = light.fold(Rgb::BLACK, |sum, light| sum + light);
                    sums[x as usize] += borrow * light + seen.color(rest(layer), seen.index(x, y));
                }
            }
            for gleam in p.gleams.iter().filter(|gleam| kept >> gleam.lane & 1 == 1) {
                if let Some(layer) = (filter.layer_of)(gleam.emitter) {
                    sums[layer * width + p.pixels[gleam.lane] as usize] += gleam.radiance;
                }
            }
        }
    }
    for (layer, (row, sums)) in row.iter_mut().zip(sums.chunks(width)).enumerate() {
        for x in &columns {
            let k = *x as usize;
            let first = smooth.shown(seen, layer, *x, y);
            row[k] += (first + sums[k]) * (1.0 / (1.0 + counts[k])) - first;
        }
    }
    rays
}

/// Of the pixel and its neighbours those that see the surface of a lane, and how many they are.
fn neighbours(seen: &Seen, p: &Packet<'_>, k: usize, x: u32, y: u32) -> ([(u32, u32); 9], usize) {
    let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
    let (mut found, mut count) = ([(0, 0); 9], 0);
    for y in y.saturating_sub(1)..(y + 2).min(seen.height) {
        for x in x.saturating_sub(1)..(x + 2).min(seen.width) {
            let there = seen.index(x, y);
            let off: Vec3 = seen.vector(POSITION, there) - position;
            let slack = 2.0 * seen.planes[SLACK][there];
            if seen.vector(NORMAL, there).dot(normal) > FACING && off.dot(normal).abs() <= slack {
                found[count] = (x, y);
                count += 1;
            }
        }
    }
    (found, count)
}
