//! Edges deserve eye rays, not light rays: where surfaces meet within a pixel or beside it, further eye rays find which,
//! and borrow the light of neighbours on the same surface. A ray that finds no neighbour to borrow from is dropped.

use super::seen::{NORMAL, POSITION, REST};
use super::{FACING, Seen, Smooth};
use crate::color::Rgb;
use crate::eye::{Eye, LANES, Packet, Rect, Sampling, Tile};
use crate::geometry::{lane, lanes};
use crate::sequence;
use crate::world::World;
use glam::Vec3;

/// Looks `further` times again at the pixels of row `y` where surfaces meet, and makes what they show the mean of all
/// looks, which with the first make a lattice. `row` already holds their first. Returns the rays it took.
pub(super) fn refine(
    world: &World,
    eye: &Eye,
    further: u32,
    sampling: &Sampling,
    seen: &Seen,
    smooth: &Smooth,
    y: u32,
    row: &mut [Rgb],
) -> u64 {
    if further == 0 {
        return 0;
    }
    let columns: Vec<u32> = (0..seen.width).filter(|x| smooth.edge[seen.index(*x, y)] > 0.0).collect();
    if columns.is_empty() {
        return 0;
    }
    let rect = Rect { x: 0, y, width: seen.width, height: 1 };
    let packets = columns.chunks(LANES).map(|chunk| {
        let pixels = std::array::from_fn(|k| chunk.get(k).copied().unwrap_or(u32::MAX));
        Packet::new(world, rect, pixels)
    });
    let mut tile = Tile { rect, packets: packets.collect(), rays: 0 };
    let mut found = vec![(Rgb::BLACK, 0.0); seen.width as usize];
    let mut rays = 0;
    for look in 1..=further {
        let shift = |by: u32| (by * look) as f32 / (further + 1) as f32;
        let [u, v] = sampling.offset;
        let offset = [(u + shift(1)).fract(), (v + shift(2)).fract()];
        let seed = sequence::hash(sampling.seed, look);
        eye.look(&Sampling { offset, seed, ..*sampling }, &mut tile);
        rays += tile.rays;
        for p in &tile.packets {
            for k in p.lanes() {
                let at = seen.index(p.pixels[k], y);
                let Some(reflected) = borrowed(seen, smooth, p, k, at) else { continue };
                let (sum, count) = &mut found[p.pixels[k] as usize];
                *sum += p.emission[k] + reflected + seen.color(REST, at);
                *count += 1.0;
            }
        }
    }
    for x in columns {
        let (sum, count) = found[x as usize];
        let first = smooth.shown(seen, seen.index(x, y));
        row[x as usize] += (first + sum) * (1.0 / (1.0 + count)) - first;
    }
    rays
}

/// What the vertex of a lane reflects of the light of pixels around `at` that see its surface.
fn borrowed(seen: &Seen, smooth: &Smooth, p: &Packet<'_>, k: usize, at: usize) -> Option<Rgb> {
    if lanes(p.live).all(|live| live != k) {
        return Some(Rgb::BLACK);
    }
    let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
    let (mut sum, mut count) = (Rgb::BLACK, 0.0);
    for dy in -1..=1_isize {
        for dx in -1..=1_isize {
            let there = at.wrapping_add_signed(dy * seen.stride() as isize + dx);
            let off: Vec3 = seen.vector(POSITION, there) - position;
            let slack = 2.0 * seen.planes[super::SLACK][there];
            if seen.vector(NORMAL, there).dot(normal) > FACING && off.dot(normal).abs() <= slack {
                sum += smooth.at(there);
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| p.throughput[k] * p.reflectance[k] * sum * (1.0 / count))
}
