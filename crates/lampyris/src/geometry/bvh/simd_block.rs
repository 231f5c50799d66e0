//! Eight triangles against sixteen rays of one origin: those that the whole beam misses go at once, the others meet
//! all rays one after the other. Same operations as `triangle.rs` on every lane that counts, so the bits are those of
//! single rays.

use super::packet::PacketBest;
use super::simd_lanes::{F8, Machine};
use super::simd_packet::{Packet, Part};
use super::triangle::{Crossing, Plane, TINY};
use super::{Block, End, WIDTH};
use crate::geometry::packet::{LANES, lane, lanes};
use crate::geometry::screen::Screen;

/// The shears of all lanes in an interval, against eight triangles at once.
pub(super) struct Beam {
    axes: [usize; 3],
    origin: [F8; 3],
    /// Least and largest sx, sy.
    shears: [[F8; 2]; 2],
    sign: F8,
    end: F8,
}

/// Corners relative to the origin: `[3 * corner + k]`, k along kx, ky, kz.
type Relative = [[f32; WIDTH]; 9];

impl Beam {
    /// Rays as far as `end` along their largest axis.
    #[inline(always)]
    pub(super) fn new<M: Machine, const P: usize>(m: M, packet: &Packet<M, P>, end: f32) -> Beam {
        let eight = m.eight();
        let first = &packet.parts[0];
        let [mut low, mut high] = [[first.sx, first.sy]; 2];
        for part in &packet.parts[1..] {
            low = [m.min(low[0], part.sx), m.min(low[1], part.sy)];
            high = [m.max(high[0], part.sx), m.max(high[1], part.sy)];
        }
        Beam {
            axes: packet.axes,
            origin: three!(k => eight.splat8(packet.origin[packet.axes[k]])),
            shears: [
                [eight.splat8(m.least(low[0])), eight.splat8(m.most(high[0]))],
                [eight.splat8(m.least(low[1])), eight.splat8(m.most(high[1]))],
            ],
            sign: eight.splat8(if packet.negative { -0.0 } else { 0.0 }),
            end: eight.splat8(end),
        }
    }

    /// Triangles that some lane might pierce. Rounding is monotone, so what is outside for the least and the largest
    /// shear, to the same side, is outside for all between, by the very numbers that the lanes would compute.
    #[inline(always)]
    fn cull<M: Machine>(&self, m: M, block: &Block, relative: &mut Relative) -> u8 {
        let eight = m.eight();
        let zero = eight.splat8(0.0);
        let mut p = [zero; 9];
        for c in 0..3 {
            for k in 0..3 {
                let corner = eight.load8(&block.corners[3 * c + self.axes[k]]);
                p[3 * c + k] = eight.sub8(corner, self.origin[k]);
                eight.store8(&mut relative[3 * c + k], p[3 * c + k]);
            }
        }
        let ahead = three!(k => eight.xor8(p[3 * k + 2], self.sign));
        let least = eight.min8(eight.min8(ahead[0], ahead[1]), ahead[2]);
        let most = eight.max8(eight.max8(ahead[0], ahead[1]), ahead[2]);
        // False for NaN, which fills unused places.
        let mut met = eight.lt8(zero, most) & eight.lt8(least, self.end);
        for k in 0..2 {
            let [low, high] = self.shears[k];
            let x = three!(c => eight.sub8(p[3 * c + k], eight.mul8(low, p[3 * c + 2])));
            let y = three!(c => eight.sub8(p[3 * c + k], eight.mul8(high, p[3 * c + 2])));
            let lower = three!(c => eight.min8(x[c], y[c]));
            let upper = three!(c => eight.max8(x[c], y[c]));
            met &= eight.le8(eight.min8(eight.min8(lower[0], lower[1]), lower[2]), zero);
            met &= eight.le8(zero, eight.max8(eight.max8(upper[0], upper[1]), upper[2]));
        }
        met
    }
}

/// One triangle against sixteen lines.
struct Tested<M: Machine> {
    e: [M::F; 3],
    det: M::F,
    z: [f32; 3],
    /// Least and largest height along the rays.
    z_range: [f32; 2],
    /// Lanes that pierce for certain, and lanes that need f64 or a screen to tell.
    pierced: u16,
    unsure: u16,
}

#[inline(always)]
fn test<M: Machine>(
    m: M,
    relative: &Relative,
    i: usize,
    part: &Part<M>,
    negative: bool,
    mask: u16,
    screened: u8,
) -> Tested<M> {
    let z = three!(c => relative[3 * c + 2][i]);
    let along = three!(c => m.splat(z[c]));
    let x = three!(c => m.sub(m.splat(relative[3 * c][i]), m.mul(part.sx, along[c])));
    let y = three!(c => m.sub(m.splat(relative[3 * c + 1][i]), m.mul(part.sy, along[c])));
    let e = [
        m.sub(m.mul(x[2], y[1]), m.mul(y[2], x[1])),
        m.sub(m.mul(x[0], y[2]), m.mul(y[0], x[2])),
        m.sub(m.mul(x[1], y[0]), m.mul(y[1], x[0])),
    ];
    let zero = m.splat(0.0);
    let least = m.min(m.min(e[0], e[1]), e[2]);
    let most = m.max(m.max(e[0], e[1]), e[2]);
    let possible = mask & !(m.lt(least, zero) & m.lt(zero, most));
    let det = m.add(m.add(e[0], e[1]), e[2]);
    let ahead = three!(c => if negative { -z[c] } else { z[c] });
    let z_range = [ahead[0].min(ahead[1]).min(ahead[2]), ahead[0].max(ahead[1]).max(ahead[2])];
    let mut unsure = 0;
    if possible != 0 {
        let tiny = m.lt(m.abs(det), m.splat(TINY));
        let asked = if screened >> i & 1 == 1 { u16::MAX } else { 0 };
        unsure = possible & (m.eq(e[0], zero) | m.eq(e[1], zero) | m.eq(e[2], zero) | tiny | asked);
    }
    Tested { e, det, z, z_range, pierced: possible & !unsure, unsure }
}

/// Lanes that do not meet the back of a one-sided triangle.
#[inline(always)]
fn visible<M: Machine>(m: M, block: &Block, i: usize, negative: bool, det: M::F) -> u16 {
    if block.culled >> i & 1 == 0 {
        return u16::MAX;
    }
    let positive = m.lt(m.splat(0.0), det);
    let flipped = negative != (block.mirrored >> i & 1 == 1);
    if flipped { !positive } else { positive }
}

/// Where segments end, part by part.
pub(super) struct Ends<'a, M: Machine, const P: usize> {
    pub(super) targets: [&'a [[f32; LANES]; 3]; P],
    /// How far along kz.
    pub(super) heights: [M::F; P],
}

/// Takes the lanes of `mask` away from those alive whose segments the block interrupts; tells whether there were any.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "all that the hot loop holds in registers")]
pub(super) fn blocked<M: Machine, const P: usize>(
    m: M,
    block: &Block,
    beam: &Beam,
    packet: &Packet<M, P>,
    ends: &Ends<'_, M, P>,
    mut mask: [u16; P],
    alive: &mut [u16; P],
    screen: &Screen,
) -> bool {
    let mut relative = [[0.0; WIDTH]; 9];
    let survivors = beam.cull(m, block, &mut relative);
    let mut any = false;
    for i in lanes(u16::from(survivors)) {
        let mut rest = 0;
        for p in 0..P {
            if P > 1 && mask[p] == 0 {
                continue;
            }
            let tested = test(m, &relative, i, &packet.parts[p], packet.negative, mask[p], block.screened);
            if tested.pierced | tested.unsure != 0 {
                let hit = interrupted(m, block, i, packet, p, ends, &tested, screen);
                any |= hit != 0;
                alive[p] &= !hit;
                mask[p] &= !hit;
            }
            rest |= mask[p];
        }
        if rest == 0 {
            break;
        }
    }
    any
}

/// Lanes of a part whose segments one triangle interrupts.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "all that the hot loop holds in registers")]
fn interrupted<M: Machine, const P: usize>(
    m: M,
    block: &Block,
    i: usize,
    packet: &Packet<M, P>,
    p: usize,
    ends: &Ends<'_, M, P>,
    tested: &Tested<M>,
    screen: &Screen,
) -> u16 {
    let [nearest, farthest] = tested.z_range;
    let mut hit = tested.pierced & m.lt(m.splat(nearest), ends.heights[p]);
    hit &= visible(m, block, i, packet.negative, tested.det);
    let clear = if nearest > 0.0 { m.lt(m.splat(farthest), ends.heights[p]) } else { 0 };
    let doubtful = hit & !clear;
    if doubtful != 0 {
        let plane = Plane::new(&block.corners(i), packet.origin);
        let [above, below] = m.sides(plane.normal, plane.corner, ends.targets[p]);
        hit &= !doubtful
            | if plane.height > 0.0 { below } else { 0 }
            | if plane.height < 0.0 { above } else { 0 };
    }
    for l in lanes(tested.unsure) {
        let end = End::Point(lane(ends.targets[p], l));
        hit |= u16::from(block.blocks(i, &packet.line(p, l), end, screen)) << l;
    }
    hit
}

/// Offers what the lanes of `mask` meet in the block; tells whether anything was near enough.
#[inline(always)]
pub(super) fn offer<M: Machine>(
    m: M,
    block: &Block,
    beam: &Beam,
    packet: &Packet<M, 1>,
    mask: u16,
    screen: &Screen,
    best: &mut PacketBest,
) -> bool {
    let mut relative = [[0.0; WIDTH]; 9];
    let survivors = beam.cull(m, block, &mut relative);
    let mut nearer = false;
    for i in lanes(u16::from(survivors)) {
        let part = &packet.parts[0];
        let tested = test(m, &relative, i, part, packet.negative, mask, block.screened);
        if tested.pierced | tested.unsure == 0 {
            continue;
        }
        nearer |= offer_one(m, block, i, packet, &tested, screen, best);
    }
    nearer
}

#[inline(always)]
fn offer_one<M: Machine>(
    m: M,
    block: &Block,
    i: usize,
    packet: &Packet<M, 1>,
    tested: &Tested<M>,
    screen: &Screen,
    best: &mut PacketBest,
) -> bool {
    let inverse = m.div(m.splat(1.0), tested.det);
    let b = three!(k => m.mul(tested.e[k], inverse));
    let along = m.add(
        m.add(m.mul(b[0], m.splat(tested.z[0])), m.mul(b[1], m.splat(tested.z[1]))),
        m.mul(b[2], m.splat(tested.z[2])),
    );
    let t = m.max(m.mul(packet.parts[0].sz, along), m.splat(f32::MIN_POSITIVE));
    let so_far = m.load(&best.t);
    let mut near = tested.pierced & m.le(t, so_far) & visible(m, block, i, packet.negative, tested.det);
    if near != 0 && tested.z_range[0] <= 0.0 {
        let plane = Plane::new(&block.corners(i), packet.origin);
        let [below, above] = m.sides(plane.normal, [0.0; 3], packet.parts[0].directions);
        near &= if plane.height > 0.0 { above } else { 0 } | if plane.height < 0.0 { below } else { 0 };
    }
    let nearer = near & m.lt(t, so_far);
    let ties = near & !nearer;
    if ties != 0 {
        let mut crossings = [[0.0; LANES]; 3];
        m.store(&mut crossings[0], t);
        m.store(&mut crossings[1], b[1]);
        m.store(&mut crossings[2], b[2]);
        for l in lanes(ties) {
            let [t, u, v] = three!(k => crossings[k][l]);
            best.offer(l, Crossing { t, u, v }, block.instance[i], block.triangle[i]);
        }
    }
    if nearer != 0 {
        m.store(&mut best.t, m.blend(nearer, t, so_far));
        let (u, v) = (m.load(&best.u), m.load(&best.v));
        m.store(&mut best.u, m.blend(nearer, b[1], u));
        m.store(&mut best.v, m.blend(nearer, b[2], v));
        m.blend_u32(nearer, block.instance[i], &mut best.instance);
        m.blend_u32(nearer, block.triangle[i], &mut best.triangle);
        best.found |= nearer;
    }
    for l in lanes(tested.unsure) {
        if let Some(crossing) = block.crossing(i, &packet.line(0, l), screen) {
            best.offer(l, crossing, block.instance[i], block.triangle[i]);
        }
    }
    nearer | tested.unsure != 0
}
