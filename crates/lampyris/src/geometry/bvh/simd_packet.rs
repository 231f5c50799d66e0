//! Sixteen rays of one origin walk the tree together: a node's eight boxes against the whole packet by interval
//! arithmetic [Boulos et al. 2006], survivors lane by lane. The lanes of a packet agree on the axis and sign of their
//! shear, so that the corners of a triangle relative to the origin serve all of them; sixteen rays make one such packet
//! mostly and six at most. Unsafe here: tokens for machines that the caller knows, and stack entries that were written.

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

/// [`Tree::occluded16`] by AVX-512.
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,bmi1,popcnt")]
pub(super) fn occluded_avx512(
    tree: &Tree,
    origin: Vec3,
    targets: &[[f32; LANES]; 3],
    live: u16,
    first: &mut u32,
) -> u16 {
    // SAFETY: the features of this function.
    occluded(unsafe { Avx512::new() }, tree, origin, targets, live, first)
}

/// [`Tree::occluded16`] by AVX2.
#[target_feature(enable = "avx2,bmi1,popcnt")]
pub(super) fn occluded_avx2(
    tree: &Tree,
    origin: Vec3,
    targets: &[[f32; LANES]; 3],
    live: u16,
    first: &mut u32,
) -> u16 {
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
fn occluded<M: Machine>(
    m: M,
    tree: &Tree,
    origin: Vec3,
    targets: &[[f32; LANES]; 3],
    live: u16,
    first: &mut u32,
) -> u16 {
    let mut directions = Aligned([[0.0; LANES]; 3]);
    for axis in 0..3 {
        let d = m.sub(m.load(&targets[axis]), m.splat(origin[axis]));
        m.store(&mut directions.0[axis], d);
    }
    let directions = &directions.0;
    let mut families = Families::new(m, directions, live);
    // Of one origin, whatever the direction.
    let slab = Slab::new(origin, Vec3::ONE, &tree.hierarchy.bounds, 0.0);
    let mut stopped = 0;
    while let Some((live, kz)) = families.next() {
        if live.count_ones() < FEW {
            stopped |= tree.occluded_one_by_one(Kernel::Avx2, origin, targets, live);
            continue;
        }
        let packet = Packet::new(m, origin, directions, live, &slab, kz);
        stopped |= occluded_packet(m, tree, &packet, targets, first);
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
    let mut families = Families::new(m, directions, live);
    // Of one origin, whatever the direction.
    let slab = Slab::new(origin, Vec3::ONE, &tree.hierarchy.bounds, 0.0);
    while let Some((live, kz)) = families.next() {
        if live.count_ones() < FEW {
            tree.closest_one_by_one(Kernel::Avx2, origin, directions, live, best);
            continue;
        }
        let packet = Packet::new(m, origin, directions, live, &slab, kz);
        closest_packet(m, tree, &packet, best);
    }
}

/// Lanes of the packet whose segments to `targets` are blocked. The block `first` is asked before all others, and gives
/// way to the one that blocked last.
#[inline(always)]
fn occluded_packet<M: Machine>(
    m: M,
    tree: &Tree,
    packet: &Packet<'_, M>,
    targets: &[[f32; LANES]; 3],
    first: &mut u32,
) -> u16 {
    let kz = packet.axes[2];
    // The largest axis of the way to a target, as computed, is that of its direction.
    let heights = m.abs(m.load(&packet.directions[kz]));
    let ends = Ends { targets, heights };
    let reach = m.most(m.blend(packet.live, heights, m.splat(0.0)));
    let beam = Beam::new(m, packet, reach);
    let limit = m.add(m.splat(1.0), packet.slack);
    let mut alive = packet.live;
    let asked = std::mem::replace(first, NONE);
    if let Some(block) = tree.blocks.get(asked as usize) {
        let hit = blocked(m, block, &beam, packet, &ends, alive, &tree.screen);
        if hit != 0 {
            *first = asked;
        }
        alive &= !hit;
        if alive == 0 {
            return packet.live;
        }
    }
    let mut stack = Stack::new();
    let mut walk = Walk::new(m, &mut stack, limit, alive);
    while let Some((leaf, mask)) = walk.next(m, tree, packet) {
        let block = &tree.blocks[leaf as usize];
        let hit = blocked(m, block, &beam, packet, &ends, mask, &tree.screen);
        if hit != 0 {
            *first = leaf;
            walk.alive &= !hit;
        }
    }
    packet.live & !walk.alive
}

/// Offers what the lanes of the packet meet in the tree.
#[inline(always)]
fn closest_packet<M: Machine>(m: M, tree: &Tree, packet: &Packet<'_, M>, best: &mut PacketBest) {
    let beam = Beam::new(m, packet, f32::INFINITY);
    let limit = m.add(m.load(&best.t), packet.slack);
    let mut stack = Stack::new();
    let mut walk = Walk::new(m, &mut stack, limit, packet.live);
    while let Some((leaf, mask)) = walk.next(m, tree, packet) {
        let block = &tree.blocks[leaf as usize];
        if offer(m, block, &beam, packet, mask, &tree.screen, best) {
            walk.limit(m, m.add(m.load(&best.t), packet.slack));
        }
    }
}

/// At the start of a cache line, so that no vector lies across two.
#[repr(C, align(64))]
struct Aligned([[f32; LANES]; 3]);

/// The lanes by the largest axis of their directions, as [`super::triangle::largest_axis`] has it, and by sign.
struct Families {
    rest: u16,
    axes: [u16; 3],
    negative: [u16; 3],
}

impl Families {
    /// Lanes of `live` that a ray can follow.
    #[inline(always)]
    fn new<M: Machine>(m: M, directions: &[[f32; LANES]; 3], live: u16) -> Families {
        let d = three!(a => m.load(&directions[a]));
        let size = three!(a => m.abs(d[a]));
        // As `sound_direction`: the sum lets no NaN pass.
        let length = m.add(m.add(size[0], size[1]), size[2]);
        let sound = m.le(m.splat(f32::MIN_POSITIVE), length) & m.le(length, m.splat(1.0 / f32::MIN_POSITIVE));
        let second = m.lt(size[0], size[1]);
        let third = m.lt(m.max(size[0], size[1]), size[2]);
        let zero = m.splat(0.0);
        Families {
            rest: live & sound,
            axes: [!second & !third, second & !third, third],
            negative: three!(a => m.lt(d[a], zero)),
        }
    }

    /// Lanes of one family, and its axis.
    #[inline(always)]
    fn next(&mut self) -> Option<(u16, usize)> {
        if self.rest == 0 {
            return None;
        }
        let one = self.rest & self.rest.wrapping_neg();
        let kz = usize::from(self.axes[1] & one != 0) + 2 * usize::from(self.axes[2] & one != 0);
        let negative = self.negative[kz];
        let same = if negative & one != 0 { negative } else { !negative };
        let family = self.rest & self.axes[kz] & same;
        self.rest &= !family;
        Some((family, kz))
    }
}

/// Rays of one origin and one family; lanes outside `live` repeat a live one, so that bounds over all lanes are bounds
/// of the packet.
pub(super) struct Packet<'a, M: Machine> {
    pub(super) sx: M::F,
    pub(super) sy: M::F,
    pub(super) sz: M::F,
    inverse: [M::F; 3],
    slack: M::F,
    /// Least and largest of `inverse`.
    least: [f32; 3],
    most: [f32; 3],
    /// Axes along which all lanes agree in sign: the planes of a box come near before far.
    agreed: [bool; 3],
    /// As in [`Slab`].
    origins: [[f32; 3]; 2],
    pub(super) origin: Vec3,
    pub(super) directions: &'a [[f32; LANES]; 3],
    /// kx, ky, kz
    pub(super) axes: [usize; 3],
    pub(super) negative: bool,
    live: u16,
}

impl<'a, M: Machine> Packet<'a, M> {
    #[inline(always)]
    fn new(m: M, origin: Vec3, directions: &'a [[f32; LANES]; 3], live: u16, slab: &Slab, kz: usize) -> Self {
        let [kx, ky] = [[1, 2], [2, 0], [0, 1]][kz];
        let any = lane(directions, live.trailing_zeros() as usize);
        let axes = [kx, ky, kz];
        let d = three!(k => m.blend(live, m.load(&directions[axes[k]]), m.splat(any[axes[k]])));
        let one = m.splat(1.0);
        let sz = m.div(one, d[2]);
        // As `Slab::inverse`.
        let least = m.mul(m.abs(d[2]), m.splat(Slab::LEAST));
        let mut all = [sz; 3];
        all[kx] = m.div(one, m.copysign(m.max(least, m.abs(d[0])), d[0]));
        all[ky] = m.div(one, m.copysign(m.max(least, m.abs(d[1])), d[1]));
        let (least, most) = (three!(a => m.least(all[a])), three!(a => m.most(all[a])));
        Packet {
            sx: m.mul(d[0], sz),
            sy: m.mul(d[1], sz),
            sz,
            inverse: all,
            slack: m.mul(m.splat(slab.widening), m.abs(sz)),
            least,
            most,
            agreed: three!(a => least[a] > 0.0 || most[a] < 0.0),
            origins: slab.origin,
            origin,
            directions,
            axes,
            negative: any[kz] < 0.0,
            live,
        }
    }

    /// One lane.
    pub(super) fn line(&self, i: usize) -> Line {
        Line::new(&Ray::new(self.origin, lane(self.directions, i)))
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
struct Stack([MaybeUninit<(u32, u16, f32)>; STACK]);

impl Stack {
    #[inline(always)]
    fn new() -> Stack {
        Stack([const { MaybeUninit::uninit() }; STACK])
    }
}

/// A packet on its way through a tree, nearest boxes first.
struct Walk<'s, M: Machine> {
    stack: &'s mut [MaybeUninit<(u32, u16, f32)>; STACK],
    depth: usize,
    limit: M::F,
    farthest: f32,
    /// Lanes that still seek.
    alive: u16,
}

impl<'s, M: Machine> Walk<'s, M> {
    #[inline(always)]
    fn new(m: M, stack: &'s mut Stack, limit: M::F, alive: u16) -> Walk<'s, M> {
        stack.0[0].write((0, alive, 0.0));
        let mut walk = Walk { stack: &mut stack.0, depth: 1, limit, farthest: 0.0, alive };
        walk.limit(m, limit);
        walk
    }

    /// How far lanes look from now on.
    #[inline(always)]
    fn limit(&mut self, m: M, limit: M::F) {
        self.limit = limit;
        self.farthest = m.most(m.blend(self.alive, limit, m.splat(0.0)));
    }

    /// The next leaf, and the lanes that meet its box.
    #[inline(always)]
    fn next(&mut self, m: M, tree: &Tree, packet: &Packet<'_, M>) -> Option<(u32, u16)> {
        while self.depth > 0 {
            self.depth -= 1;
            // SAFETY: entries below the old `depth` were written.
            let (child, met, enter) = unsafe { self.stack[self.depth].assume_init() };
            let mask = met & self.alive;
            if mask == 0 || enter > self.farthest {
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
    fn open(&mut self, m: M, tree: &Tree, packet: &Packet<'_, M>, node: u32, mask: u16) {
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
            let met = mask & self.spans(m, packet, &planes, i);
            if met == 0 || node.child[i] == NONE {
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

    /// Lanes that meet box `i`, as [`Slab::span`].
    #[inline(always)]
    fn spans(&self, m: M, packet: &Packet<'_, M>, planes: &[[f32; WIDTH]; 6], i: usize) -> u16 {
        let mut enter = m.splat(0.0);
        let mut leave = m.splat(f32::INFINITY);
        for a in 0..3 {
            let near = m.mul(m.splat(planes[a][i]), packet.inverse[a]);
            let far = m.mul(m.splat(planes[a + 3][i]), packet.inverse[a]);
            let (near, far) =
                if packet.agreed[a] { (near, far) } else { (m.min(near, far), m.max(near, far)) };
            enter = m.max(enter, near);
            leave = m.min(leave, far);
        }
        m.le(enter, m.min(m.mul(leave, m.splat(super::slab::STRETCH)), self.limit))
    }
}
