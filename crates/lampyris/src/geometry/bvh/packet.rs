//! What sixteen rays have met so far.

use super::Best;
use super::triangle::Crossing;
use crate::geometry::packet::LANES;

/// The best hits so far.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct PacketBest {
    pub(crate) t: [f32; LANES],
    pub(crate) u: [f32; LANES],
    pub(crate) v: [f32; LANES],
    pub(crate) instance: [u32; LANES],
    pub(crate) triangle: [u32; LANES],
    pub(crate) found: u16,
}

impl PacketBest {
    pub(crate) fn none() -> PacketBest {
        PacketBest {
            t: [f32::INFINITY; LANES],
            u: [0.0; LANES],
            v: [0.0; LANES],
            instance: [0; LANES],
            triangle: [0; LANES],
            found: 0,
        }
    }

    pub(crate) fn lane(&self, i: usize) -> Best {
        Best {
            t: self.t[i],
            u: self.u[i],
            v: self.v[i],
            instance: self.instance[i],
            triangle: self.triangle[i],
            found: self.found >> i & 1 == 1,
        }
    }

    pub(crate) fn set(&mut self, i: usize, best: &Best) {
        self.t[i] = best.t;
        self.u[i] = best.u;
        self.v[i] = best.v;
        self.instance[i] = best.instance;
        self.triangle[i] = best.triangle;
        self.found |= u16::from(best.found) << i;
    }

    pub(super) fn offer(&mut self, i: usize, crossing: Crossing, instance: u32, triangle: u32) {
        let mut best = self.lane(i);
        best.offer(crossing, instance, triangle);
        self.set(i, &best);
    }
}
