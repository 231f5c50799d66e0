//! Sixteen rays of one origin made ready for boxes and triangles. The lanes of a packet agree on the axis and sign of
//! their shear (`split` sees to it), so the corners of a triangle relative to the origin serve all of them, and the
//! bits are those of single rays.

use super::triangle::Crossing;
use super::{Best, Bounds, Line, Shear, Slab};
use crate::geometry::packet::{LANES, lane};
use glam::Vec3;

/// Rays of one origin; lanes outside `live` repeat a live one, so that bounds over all lanes are bounds of the packet.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Packet {
    pub(super) sx: [f32; LANES],
    pub(super) sy: [f32; LANES],
    pub(super) sz: [f32; LANES],
    pub(super) inverse: [[f32; LANES]; 3],
    pub(super) slack: [f32; LANES],
    /// Least and largest of `inverse`.
    pub(super) inverse_range: [[f32; 3]; 2],
    /// As in [`Slab`].
    pub(super) origins: [[f32; 3]; 2],
    pub(super) origin: Vec3,
    pub(super) directions: [[f32; LANES]; 3],
    /// kx, ky, kz
    pub(super) axes: [usize; 3],
    pub(super) negative: bool,
    pub(crate) live: u16,
}

impl Packet {
    #[expect(clippy::needless_range_loop, reason = "lanes run through several arrays")]
    #[inline(always)]
    fn new(origin: Vec3, directions: &[[f32; LANES]; 3], live: u16, bounds: &Bounds, kz: usize) -> Packet {
        let axes = [(kz + 1) % 3, (kz + 2) % 3, kz];
        let any = live.trailing_zeros() as usize;
        let mut directions = *directions;
        if live != u16::MAX {
            for axis in &mut directions {
                let filling = axis[any];
                for (i, d) in axis.iter_mut().enumerate() {
                    *d = if live >> i & 1 == 1 { *d } else { filling };
                }
            }
        }
        let slab = Slab::new(origin, lane(&directions, any), bounds, 0.0);
        let d = &directions;
        let mut packet = Packet {
            sx: [0.0; LANES],
            sy: [0.0; LANES],
            sz: [0.0; LANES],
            inverse: [[0.0; LANES]; 3],
            slack: [0.0; LANES],
            inverse_range: [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]],
            origins: slab.origin,
            origin,
            directions,
            axes,
            negative: d[kz][any] < 0.0,
            live,
        };
        for i in 0..LANES {
            let along = d[kz][i];
            packet.sz[i] = 1.0 / along;
            packet.sx[i] = d[axes[0]][i] * packet.sz[i];
            packet.sy[i] = d[axes[1]][i] * packet.sz[i];
            packet.slack[i] = slab.widening * packet.sz[i].abs();
        }
        for axis in 0..3 {
            for i in 0..LANES {
                packet.inverse[axis][i] = Slab::inverse(d[axis][i], d[kz][i].abs());
            }
            let all = packet.inverse[axis];
            packet.inverse_range[0][axis] =
                all.iter().fold(f32::INFINITY, |a, b| if *b < a { *b } else { a });
            packet.inverse_range[1][axis] =
                all.iter().fold(f32::NEG_INFINITY, |a, b| if *b > a { *b } else { a });
        }
        packet
    }

    /// One lane.
    pub(super) fn line(&self, i: usize) -> Line {
        let [kx, ky, kz] = self.axes;
        let (sx, sy, sz) = (self.sx[i], self.sy[i], self.sz[i]);
        let shear = Shear { kx, ky, kz, sx, sy, sz, negative: self.negative };
        Line { origin: self.origin, direction: lane(&self.directions, i), shear }
    }

    /// Packets of lanes with one shear: mostly one, at most six. All directions must be sound.
    #[inline(always)]
    pub(super) fn split(
        origin: Vec3,
        directions: &[[f32; LANES]; 3],
        live: u16,
        bounds: &Bounds,
        mut each: impl FnMut(&Packet),
    ) {
        let shears = shears(directions);
        let mut rest = live;
        while rest != 0 {
            let shear = shears[rest.trailing_zeros() as usize];
            let same = mask(|i| shears[i] == shear) & rest;
            rest &= !same;
            each(&Packet::new(origin, directions, same, bounds, shear as usize / 2));
        }
    }
}

/// 2·kz, plus one if the direction is negative along it; the axis as by [`super::triangle::largest_axis`].
#[inline(always)]
fn shears(directions: &[[f32; LANES]; 3]) -> [u32; LANES] {
    let mut shears = [0; LANES];
    let [x, y, z] = directions;
    for i in 0..LANES {
        let a = [x[i].abs(), y[i].abs(), z[i].abs()];
        let first = a[0] >= a[1] && a[0] >= a[2];
        let (axis, d) = if a[1] >= a[2] { (2, y[i]) } else { (4, z[i]) };
        let (axis, d) = if first { (0, x[i]) } else { (axis, d) };
        shears[i] = axis + u32::from(d < 0.0);
    }
    shears
}

/// The lanes for which something holds.
#[inline(always)]
pub(crate) fn mask(holds: impl Fn(usize) -> bool) -> u16 {
    (0..LANES).fold(0, |mask, i| mask | u16::from(holds(i)) << i)
}

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
