//! Sixteen rays of one origin, or several parts of sixteen, walk the tree together: a node's eight boxes against the whole
//! packet by interval arithmetic [Boulos et al. 2006], survivors lane by lane. The lanes of a packet agree on the axis and
//! sign of their shear, so that the corners of a triangle relative to the origin serve all of them; what comes in makes one
//! such packet mostly and six at most. Unsafe here: tokens for machines that the caller knows, and stack entries that were written.

use super::packet::PacketBest;
use super::simd_block::{Beam, Ends, blocked, offer};
use super::simd_lanes::{Avx2, Avx512, Machine};
use super::{Kernel, LEAF, Line, NONE, STACK, Slab, Tree, WIDTH};
use crate::geometry::Ray;
use crate::geometry::packet::{LANES, lane, lanes};
use glam::Vec3;
use std::mem::MaybeUninit;

/// Fewer rays than this go one by one.
const FEW: u32 = 4;

/// [`Tree::occluded_parts`] by AVX-512.
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,bmi1,popcnt")]
pub(super) fn occluded_avx512<const P: usize>(
    tree: &Tree,
    origin: Vec3,
    targets: [&[[f32; LANES]; 3]; P],
    live: [u16; P],
    first: &mut u32,
) -> [u16; P] {
    // SAFETY: the features of this function.
    occluded(unsafe { Avx512::new() }, tree, origin, targets, live, first)
}

/// [`Tree::occluded_parts`] by AVX2.
#[target_feature(enable = "avx2,bmi1,popcnt")]
pub(super) fn occluded_avx2<const P: usize>(
    tree: &Tree,
    origin: Vec3,
    targets: [&[[f32; LANES]; 3]; P],
    live: [u16; P],
    first: &mut u32,
) -> [u16; P] {
    // SAFETY: the features of this function.
    occluded(unsafe { Avx2::new() }, tree, origin, targets, live, first)
}

/// [`Tree::closest16`] by AVX-512.
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,bmi1,popcnt")]
pub(super) fn closest_avx512(
    tree: &Tree,
    origin: Vec3,
    directions: &[[f32; LANES]; 3],
    live: u16,
    best: &mut PacketBest,
) {
    // SAFETY: the features of this function.
    closest(unsafe { Avx512::new() }, tree, origin, directions, live, best);
}

/// [`Tree::closest16`] by AVX2.
#[target_feature(enable = "avx2,bmi1,popcnt")]
pub(super) fn closest_avx2(
    tree: &Tree,
    origin: Vec3,
    directions: &[[f32; LANES]; 3],
    live: u16,
    best: &mut PacketBest,
) {
    // SAFETY: the features of this function.
    closest(unsafe { Avx2::new() }, tree, origin, directions, live, best);
}

#[inline(always)]
fn occluded<M: Machine, const P: usize>(
    m: M,
    tree: &Tree,
    origin: Vec3,
    targets: [&[[f32; LANES]; 3]; P],
    live: [u16; P],
    first: &mut u32,
) -> [u16; P] {
    let mut directions = Aligned([[[0.0; LANES]; 3]; P]);
    for (directions, targets) in directions.0.iter_mut().zip(targets) {
        for axis in 0..3 {
            let d = m.sub(m.load(&targets[axis]), m.splat(origin[axis]));
            m.store(&mut directions[axis], d);
        }
    }
    let directions = &directions.0;
    let mut families = Families::new(m, directions, live);
    // Of one origin, whatever the direction.
    let slab = Slab::new(origin, Vec3::ONE, &tree.hierarchy.bounds, 0.0);
    let mut stopped = [0; P];
    while let Some((live, kz)) = families.next() {
        let mut count = 0;
        for of in live {
            count += of.count_ones();
        }
        if count < FEW {
            for p in 0..P {
                stopped[p] |= tree.occluded_one_by_one(Kernel::Avx2, origin, targets[p], live[p]);
            }
            continue;
        }
        let packet = Packet::new(m, origin, directions, live, &slab, kz);
        let blocked = occluded_packet(m, tree, &packet, targets, first);
        for p in 0..P {
            stopped[p] |= blocked[p];
        }
    }
    stopped
}

#[inline(always)]
fn closest<M: Machine>(
    m: M,
    tree: &Tree,
    origin: Vec3,
    directions: &[[f32; LANES]; 3],
    live: u16,
    best: &mut PacketBest,
) {
    let directions = std::array::from_ref(directions);
    let mut families = Families::new(m, directions, [live]);
    // Of one origin, whatever the direction.
    let slab = Slab::new(origin, Vec3::ONE, &tree.hierarchy.bounds, 0.0);
    while let Some((live, kz)) = families.next() {
        if live[0].count_ones() < FEW {
            tree.closest_one_by_one(Kernel::Avx2, origin, &directions[0], live[0], best);
            continue;
        }
        let packet = Packet::new(m, origin, directions, live, &slab, kz);
        closest_packet(m, tree, &packet, best);
    }
}

/// Lanes of the packet whose segments to `targets` are blocked. The block `first` is asked before all others, and gives
/// way to the one that blocked last.
#[inline(always)]
fn occluded_packet<M: Machine, const P: usize>(
    m: M,
    tree: &Tree,
    packet: &Packet<'_, M, P>,
    targets: [&[[f32; LANES]; 3]; P],
    first: &mut u32,
) -> [u16; P] {
    let kz = packet.axes[2];
    let zero = m.splat(0.0);
    let (mut heights, mut limit, mut live, mut farthest) = ([zero; P], [zero; P], [0; P], zero);
    for (p, part) in packet.parts.iter().enumerate() {
        // The largest axis of the way to a target, as computed, is that of its direction.
        heights[p] = m.abs(m.load(&part.directions[kz]));
        limit[p] = m.add(m.splat(1.0), part.slack);
        live[p] = part.live;
        farthest = m.max(farthest, m.blend(part.live, heights[p], zero));
    }
    let ends = Ends { targets, heights };
    let beam = Beam::new(m, packet, m.most(farthest));
    let mut alive = live;
    let asked = std::mem::replace(first, NONE);
    if let Some(block) = tree.blocks.get(asked as usize) {
        if blocked(m, block, &beam, packet, &ends, live, &mut alive, &tree.screen) {
            *first = asked;
        }
        if none(&alive) {
            return live;
        }
    }
    let mut stack = Stack::new();
    let mut walk = Walk::new(m, &mut stack, limit, alive);
    while let Some((leaf, mask)) = walk.next(m, tree, packet) {
        let block = &tree.blocks[leaf as usize];
        if blocked(m, block, &beam, packet, &ends, mask, &mut walk.alive, &tree.screen) {
            *first = leaf;
        }
    }
    for (live, alive) in live.iter_mut().zip(walk.alive) {
        *live &= !alive;
    }
    live
}

/// Offers what the lanes of the packet meet in the tree.
#[inline(always)]
fn closest_packet<M: Machine>(m: M, tree: &Tree, packet: &Packet<'_, M, 1>, best: &mut PacketBest) {
    let part = &packet.parts[0];
    let beam = Beam::new(m, packet, f32::INFINITY);
    let limit = m.add(m.load(&best.t), part.slack);
    let mut stack = Stack::new();
    let mut walk = Walk::new(m, &mut stack, [limit], [part.live]);
    while let Some((leaf, [mask])) = walk.next(m, tree, packet) {
        let block = &tree.blocks[leaf as usize];
        if offer(m, block, &beam, packet, mask, &tree.screen, best) {
            walk.limit(m, [m.add(m.load(&best.t), part.slack)]);
        }
    }
}

/// At the start of a cache line, so that no vector lies across two.
#[repr(C, align(64))]
struct Aligned<const P: usize>([[[f32; LANES]; 3]; P]);

/// No lane of any part.
#[inline(always)]
fn none<const P: usize>(masks: &[u16; P]) -> bool {
    let mut all = 0;
    for mask in masks {
        all |= mask;
    }
    all == 0
}

/// The lanes by the largest axis of their directions, as [`super::triangle::largest_axis`] has it, and by sign.
struct Families<const P: usize> {
    rest: [u16; P],
    axes: [[u16; P]; 3],
    negative: [[u16; P]; 3],
}

impl<const P: usize> Families<P> {
    /// Lanes of `live` that a ray can follow.
    #[inline(always)]
    fn new<M: Machine>(m: M, directions: &[[[f32; LANES]; 3]; P], live: [u16; P]) -> Families<P> {
        let mut families = Families { rest: live, axes: [[0; P]; 3], negative: [[0; P]; 3] };
        for (p, directions) in directions.iter().enumerate() {
            let d = three!(a => m.load(&directions[a]));
            let size = three!(a => m.abs(d[a]));
            // As `sound_direction`: the sum lets no NaN pass.
            let length = m.add(m.add(size[0], size[1]), size[2]);
            let least = m.splat(f32::MIN_POSITIVE);
            families.rest[p] &= m.le(least, length) & m.le(length, m.splat(1.0 / f32::MIN_POSITIVE));
            let second = m.lt(size[0], size[1]);
            let third = m.lt(m.max(size[0], size[1]), size[2]);
            let zero = m.splat(0.0);
            let axes = [!second & !third, second & !third, third];
            for a in 0..3 {
                families.axes[a][p] = axes[a];
                families.negative[a][p] = m.lt(d[a], zero);
            }
        }
        families
    }

    /// Lanes of one family, and its axis.
    #[inline(always)]
    fn next(&mut self) -> Option<([u16; P], usize)> {
        let mut found = 0;
        while found < P && self.rest[found] == 0 {
            found += 1;
        }
        if found == P {
            return None;
        }
        let one = self.rest[found] & self.rest[found].wrapping_neg();
        let kz =
            usize::from(self.axes[1][found] & one != 0) + 2 * usize::from(self.axes[2][found] & one != 0);
        let flip = if self.negative[kz][found] & one != 0 { 0 } else { u16::MAX };
        let mut family = [0; P];
        for (p, family) in family.iter_mut().enumerate() {
            *family = self.rest[p] & self.axes[kz][p] & (self.negative[kz][p] ^ flip);
            self.rest[p] &= !*family;
        }
        Some((family, kz))
    }
}

/// Rays of one origin and one family, sixteen to a part.
pub(super) struct Packet<'a, M: Machine, const P: usize> {
    pub(super) parts: [Part<'a, M>; P],
    /// Least and largest of `inverse`.
    least: [f32; 3],
    most: [f32; 3],
    /// Axes along which all lanes agree in sign: the planes of a box come near before far.
    agreed: [bool; 3],
    /// As in [`Slab`].
    origins: [[f32; 3]; 2],
    pub(super) origin: Vec3,
    /// kx, ky, kz
    pub(super) axes: [usize; 3],
    pub(super) negative: bool,
}

/// Sixteen of them; lanes outside `live` repeat a live one of the packet, so that bounds over all lanes are bounds of the
/// packet.
#[derive(Clone, Copy)]
pub(super) struct Part<'a, M: Machine> {
    pub(super) sx: M::F,
    pub(super) sy: M::F,
    pub(super) sz: M::F,
    inverse: [M::F; 3],
    slack: M::F,
    pub(super) directions: &'a [[f32; LANES]; 3],
    live: u16,
}

impl<'a, M: Machine> Part<'a, M> {
    /// By the axes kx, ky, kz; `any` is a live lane's direction.
    #[inline(always)]
    fn new(
        m: M,
        directions: &'a [[f32; LANES]; 3],
        live: u16,
        any: Vec3,
        slab: &Slab,
        [kx, ky, kz]: [usize; 3],
    ) -> Self {
        let axes = [kx, ky, kz];
        let d = three!(k => m.blend(live, m.load(&directions[axes[k]]), m.splat(any[axes[k]])));
        let one = m.splat(1.0);
        let sz = m.div(one, d[2]);
        // As `Slab::inverse`.
        let least = m.mul(m.abs(d[2]), m.splat(Slab::LEAST));
        let mut inverse = [sz; 3];
        inverse[kx] = m.div(one, m.copysign(m.max(least, m.abs(d[0])), d[0]));
        inverse[ky] = m.div(one, m.copysign(m.max(least, m.abs(d[1])), d[1]));
        let slack = m.mul(m.splat(slab.widening), m.abs(sz));
        Part { sx: m.mul(d[0], sz), sy: m.mul(d[1], sz), sz, inverse, slack, directions, live }
    }
}

impl<'a, M: Machine, const P: usize> Packet<'a, M, P> {
    #[inline(always)]
    fn new(
        m: M,
        origin: Vec3,
        directions: &'a [[[f32; LANES]; 3]; P],
        live: [u16; P],
        slab: &Slab,
        kz: usize,
    ) -> Self {
        let [kx, ky] = [[1, 2], [2, 0], [0, 1]][kz];
        let axes = [kx, ky, kz];
        let mut first = 0;
        while first + 1 < P && live[first] == 0 {
            first += 1;
        }
        let any = lane(&directions[first], live[first].trailing_zeros() as usize);
        let mut parts = [Part::new(m, &directions[0], live[0], any, slab, axes); P];
        let (mut least, mut most) = (parts[0].inverse, parts[0].inverse);
        for p in 1..P {
            parts[p] = Part::new(m, &directions[p], live[p], any, slab, axes);
            least = three!(a => m.min(least[a], parts[p].inverse[a]));
            most = three!(a => m.max(most[a], parts[p].inverse[a]));
        }
        let (least, most) = (three!(a => m.least(least[a])), three!(a => m.most(most[a])));
        Packet {
            parts,
            least,
            most,
            agreed: three!(a => least[a] > 0.0 || most[a] < 0.0),
            origins: slab.origin,
            origin,
            axes,
            negative: any[kz] < 0.0,
        }
    }

    /// One lane of a part.
    pub(super) fn line(&self, p: usize, i: usize) -> Line {
        Line::new(&Ray::new(self.origin, lane(self.parts[p].directions, i)))
    }
}

impl Tree {
    /// Tells the machine that a child will be needed soon.
    #[inline(always)]
    fn fetch(&self, eight: Avx2, child: u32) {
        let at = (child & !LEAF) as usize;
        if child & LEAF == 0 {
            eight.prefetch(self.hierarchy.nodes.as_ptr().wrapping_add(at));
        } else {
            eight.prefetch(self.blocks.as_ptr().wrapping_add(at));
        }
    }
}

/// Children put off: the lanes that meet them, and the distance.
struct Stack<const P: usize>([MaybeUninit<(u32, [u16; P], f32)>; STACK]);

impl<const P: usize> Stack<P> {
    #[inline(always)]
    fn new() -> Stack<P> {
        Stack([const { MaybeUninit::uninit() }; STACK])
    }
}

/// A packet on its way through a tree, nearest boxes first.
struct Walk<'s, M: Machine, const P: usize> {
    stack: &'s mut [MaybeUninit<(u32, [u16; P], f32)>; STACK],
    depth: usize,
    limit: [M::F; P],
    farthest: f32,
    /// Lanes that still seek.
    alive: [u16; P],
}

impl<'s, M: Machine, const P: usize> Walk<'s, M, P> {
    #[inline(always)]
    fn new(m: M, stack: &'s mut Stack<P>, limit: [M::F; P], alive: [u16; P]) -> Walk<'s, M, P> {
        stack.0[0].write((0, alive, 0.0));
        let mut walk = Walk { stack: &mut stack.0, depth: 1, limit, farthest: 0.0, alive };
        walk.limit(m, limit);
        walk
    }

    /// How far lanes look from now on.
    #[inline(always)]
    fn limit(&mut self, m: M, limit: [M::F; P]) {
        self.limit = limit;
        let zero = m.splat(0.0);
        let mut farthest = zero;
        for (alive, limit) in self.alive.iter().zip(limit) {
            farthest = m.max(farthest, m.blend(*alive, limit, zero));
        }
        self.farthest = m.most(farthest);
    }

    /// The next leaf, and the lanes that meet its box.
    #[inline(always)]
    fn next(&mut self, m: M, tree: &Tree, packet: &Packet<'_, M, P>) -> Option<(u32, [u16; P])> {
        while self.depth > 0 {
            self.depth -= 1;
            // SAFETY: entries below the old `depth` were written.
            let (child, mut mask, enter) = unsafe { self.stack[self.depth].assume_init() };
            for (mask, alive) in mask.iter_mut().zip(self.alive) {
                *mask &= alive;
            }
            if none(&mask) || enter > self.farthest {
                continue;
            }
            if child & LEAF != 0 {
                return Some((child & !LEAF, mask));
            }
            self.open(m, tree, packet, child, mask);
        }
        None
    }

    /// Puts the children of a node on the stack that lanes of `mask` meet.
    #[inline(always)]
    fn open(&mut self, m: M, tree: &Tree, packet: &Packet<'_, M, P>, node: u32, mask: [u16; P]) {
        let Some(node) = tree.hierarchy.nodes.get(node as usize) else { return };
        let eight = m.eight();
        let mut enter = eight.splat8(0.0);
        let mut leave = eight.splat8(f32::INFINITY);
        let mut planes = [[0.0; WIDTH]; 6];
        for a in 0..3 {
            let lower = eight.sub8(eight.load8(&node.bounds[a]), eight.splat8(packet.origins[0][a]));
            let upper = eight.sub8(eight.load8(&node.bounds[a + 3]), eight.splat8(packet.origins[1][a]));
            let (near, far) = if packet.most[a] < 0.0 { (upper, lower) } else { (lower, upper) };
            eight.store8(&mut planes[a], near);
            eight.store8(&mut planes[a + 3], far);
            if packet.agreed[a] {
                let (least, most) = (eight.splat8(packet.least[a]), eight.splat8(packet.most[a]));
                enter = eight.max8(enter, eight.min8(eight.mul8(near, least), eight.mul8(near, most)));
                leave = eight.min8(leave, eight.max8(eight.mul8(far, least), eight.mul8(far, most)));
            }
        }
        leave = eight.mul8(leave, eight.splat8(super::slab::STRETCH));
        leave = eight.min8(leave, eight.splat8(self.farthest));
        let boxes = eight.le8(enter, leave);
        let mut enters = [0.0; WIDTH];
        eight.store8(&mut enters, enter);
        let first = self.depth;
        for i in lanes(u16::from(boxes)) {
            let met = self.spans(m, packet, &planes, i, mask);
            if none(&met) || node.child[i] == NONE {
                continue;
            }
            let mut at = self.depth;
            // SAFETY: entries below `depth` were written.
            while at > first && unsafe { self.stack[at - 1].assume_init() }.2 < enters[i] {
                self.stack[at] = self.stack[at - 1];
                at -= 1;
            }
            self.stack[at].write((node.child[i], met, enters[i]));
            self.depth += 1;
            tree.fetch(eight, node.child[i]);
        }
    }

    /// Lanes of `mask` that meet box `i`, as [`Slab::span`].
    #[inline(always)]
    fn spans(
        &self,
        m: M,
        packet: &Packet<'_, M, P>,
        planes: &[[f32; WIDTH]; 6],
        i: usize,
        mut mask: [u16; P],
    ) -> [u16; P] {
        for ((part, limit), mask) in packet.parts.iter().zip(self.limit).zip(&mut mask) {
            if P > 1 && *mask == 0 {
                continue;
            }
            let inverse = &part.inverse;
            let mut enter = m.splat(0.0);
            let mut leave = m.splat(f32::INFINITY);
            for a in 0..3 {
                let near = m.mul(m.splat(planes[a][i]), inverse[a]);
                let far = m.mul(m.splat(planes[a + 3][i]), inverse[a]);
                let (near, far) =
                    if packet.agreed[a] { (near, far) } else { (m.min(near, far), m.max(near, far)) };
                enter = m.max(enter, near);
                leave = m.min(leave, far);
            }
            let leave = m.min(m.mul(leave, m.splat(super::slab::STRETCH)), limit);
            *mask &= m.le(enter, leave);
        }
        mask
    }
}
