//! Looking around in a photon map: all photons in a ball, and the nearest ones [Jarosz05, §2.5].
//!
//! A range of photons is left out if the cell that it lies in is farther away than the radius. The distance of a cell is
//! summed over its three axes as that of a photon is, axis by axis in the same order, and rounding is monotonic: so what is
//! found is what a look at all photons would find, to the bit.

use super::PhotonMap;
use super::photon::Photon;
use super::tree::LEAF;
use glam::Vec3;

/// Ranges that wait: one a level, and halving 2³² photons down to leaves takes 27.
const STACK: usize = 32;

/// A range of photons that has to be looked at.
#[derive(Clone, Copy, Default)]
struct Span {
    start: u32,
    end: u32,
    /// From the nearest point of its cell to the place asked about, axis by axis [m].
    off: Vec3,
}

/// The nearest photons of a place, at most so many: a heap with the farthest on top. Of photons at one distance those that
/// come first in the map count as nearer.
#[derive(Clone, Debug, Default)]
pub struct Nearest {
    most: usize,
    /// Squares of distances, whose bits are ordered as they are, above the photons' places in the map.
    found: Vec<u64>,
}

impl Nearest {
    /// Of so many; memory is taken as they are found, and kept for the next search.
    pub fn new(most: usize) -> Nearest {
        Nearest { most, found: Vec::new() }
    }

    /// True if there are as many as were asked for.
    pub fn is_full(&self) -> bool {
        self.found.len() == self.most
    }

    /// Places in the map with the squares of distances [m²], the farthest first, the others in no order.
    pub fn found(&self) -> impl ExactSizeIterator<Item = (u32, f32)> {
        self.found.iter().map(|key| (*key as u32, f32::from_bits((key >> 32) as u32)))
    }

    /// Takes a photon if it is among the nearest so far; what it must be nearer than from now on, given the limit until now.
    #[inline]
    fn offer(&mut self, number: u32, distance2: f32, limit: f32) -> f32 {
        let key = u64::from(distance2.to_bits()) << 32 | u64::from(number);
        if self.found.len() < self.most {
            self.found.push(key);
            if self.found.len() < self.most {
                return limit;
            }
            (0..self.most / 2).rev().for_each(|k| self.sink(k));
        } else {
            if self.found.first().is_none_or(|farthest| *farthest <= key) {
                return limit;
            }
            self.found[0] = key;
            self.sink(0);
        }
        f32::from_bits((self.found[0] >> 32) as u32)
    }

    /// Moves an entry down to where none below it is larger.
    #[inline]
    fn sink(&mut self, mut k: usize) {
        let heap = self.found.as_mut_slice();
        let key = heap[k];
        loop {
            let mut child = 2 * k + 1;
            if child + 1 < heap.len() && heap[child + 1] > heap[child] {
                child += 1;
            }
            if child >= heap.len() || heap[child] <= key {
                break;
            }
            heap[k] = heap[child];
            k = child;
        }
        heap[k] = key;
    }
}

impl PhotonMap {
    /// Calls `take` with each photon not farther than `radius` [m] from `x`, its place in the map, and the square of its
    /// distance [m²].
    #[inline]
    pub fn within(&self, x: Vec3, radius: f32, mut take: impl FnMut(u32, &Photon, f32)) {
        self.within_while(x, radius, |number, photon, distance2| {
            take(number, photon, distance2);
            true
        });
    }

    /// [`Self::within`] as long as `take` says.
    #[inline]
    pub(super) fn within_while(&self, x: Vec3, radius: f32, mut take: impl FnMut(u32, &Photon, f32) -> bool) {
        let limit = radius * radius;
        // Nothing is nearer than at a negative distance.
        self.visit(
            x,
            limit,
            |number, photon, distance2| if take(number, photon, distance2) { limit } else { -1.0 },
        );
    }

    /// Finds the photons that lie nearest to `x`, not farther than `radius` [m], among those that `wanted` accepts by place in
    /// the map, photon, and square of the distance.
    #[inline]
    pub fn nearest(
        &self,
        x: Vec3,
        radius: f32,
        nearest: &mut Nearest,
        mut wanted: impl FnMut(u32, &Photon, f32) -> bool,
    ) {
        nearest.found.clear();
        if nearest.most == 0 {
            return;
        }
        let mut limit = radius * radius;
        self.visit(x, limit, |number, photon, distance2| {
            if wanted(number, photon, distance2) {
                limit = nearest.offer(number, distance2, limit);
            }
            limit
        });
    }

    /// The place in the map of the photon nearest to `x`, not farther than `radius` [m], among those that `wanted` accepts; of
    /// equal ones the first.
    pub fn closest(&self, x: Vec3, radius: f32, mut wanted: impl FnMut(u32, &Photon) -> bool) -> Option<u32> {
        let mut best = (radius * radius, u32::MAX);
        self.visit(x, best.0, |number, photon, distance2| {
            if (distance2, number) < best && wanted(number, photon) {
                best = (distance2, number);
            }
            best.0
        });
        (best.1 != u32::MAX).then_some(best.1)
    }

    /// Calls `take` with each photon whose squared distance from `x` is at most the limit, which `take` may lower.
    #[inline(always)]
    fn visit(&self, x: Vec3, mut limit: f32, mut take: impl FnMut(u32, &Photon, f32) -> f32) {
        let photons = self.photons.as_slice();
        let [low, high] = self.extent;
        let mut stack = [Span::default(); STACK];
        let mut waiting = 1;
        stack[0] = Span { start: 0, end: photons.len() as u32, off: x - x.clamp(low, high) };
        while waiting > 0 {
            waiting -= 1;
            let Span { mut start, mut end, off } = stack[waiting];
            if off.length_squared() > limit {
                continue;
            }
            while (end - start) as usize > LEAF {
                let middle = start + (end - start) / 2;
                let node = &photons[middle as usize];
                let d = x - node.position();
                let distance2 = d.length_squared();
                if distance2 <= limit {
                    limit = take(middle, node, distance2);
                }
                let axis = node.axis().min(2);
                let mut beyond = off;
                beyond[axis] = d[axis];
                let far;
                (far, start, end) = if d[axis] < 0.0 {
                    ((middle + 1, end), start, middle)
                } else {
                    ((start, middle), middle + 1, end)
                };
                if beyond.length_squared() <= limit {
                    stack[waiting] = Span { start: far.0, end: far.1, off: beyond };
                    waiting += 1;
                }
            }
            for (number, photon) in (start..).zip(&photons[start as usize..end as usize]) {
                let distance2 = (x - photon.position()).length_squared();
                if distance2 <= limit {
                    limit = take(number, photon, distance2);
                }
            }
        }
    }
}
