//! A bounding volume hierarchy eight children wide over blocks of eight triangles, and the kernels that walk it.
//! Built by binned SAH [Wald 2007], walked as Embree does [Wald et al. 2014]: eight boxes or eight triangles at once,
//! or sixteen rays of one origin. Which kernel walks is a matter of speed only: all give the same bits.

/// An array of three, written out: what a closure given to `array::map` does is not compiled for AVX2 unless it
/// happens to be inlined.
macro_rules! three {
    ($i:ident => $value:expr) => {
        [
            {
                let $i = 0;
                $value
            },
            {
                let $i = 1;
                $value
            },
            {
                let $i = 2;
                $value
            },
        ]
    };
}

mod build;
mod graft;
mod packet;
mod portable;
#[cfg(target_arch = "x86_64")]
mod simd_avx2;
#[cfg(target_arch = "x86_64")]
mod simd_block;
#[cfg(target_arch = "x86_64")]
mod simd_lanes;
#[cfg(target_arch = "x86_64")]
mod simd_packet;
mod slab;
#[cfg(test)]
mod tests;
mod triangle;

pub(super) use build::{Bounds, Item, build};
pub(super) use graft::Grafted;
pub(super) use packet::PacketBest;
pub(super) use slab::Slab;
pub(super) use triangle::Plane;

use super::packet::{LANES, lane, lanes};
use super::screen::Screen;
use super::tracer::sound_direction;
use super::{Hit, Ray};
use glam::{Affine3A, Vec3};
use rayon::prelude::*;
use std::sync::OnceLock;
use triangle::{Crossing, Shear, crossing, pierced};

/// Children of a node and triangles of a block.
pub(super) const WIDTH: usize = 8;

/// Entries that a walk may have to put off: seven a level, and the builder bounds the levels, those above grafts too.
const STACK: usize = (WIDTH - 1) * (build::MAX_DEPTH + graft::DEPTH) + 1;

/// An unused child.
const NONE: u32 = u32::MAX;
/// Set in a child that is a leaf: the other bits are its number.
const LEAF: u32 = 1 << 31;

/// Boxes and numbers of up to eight children.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(super) struct Node {
    /// Lower x, y, z, then upper x, y, z; an unused child is an inside-out box.
    bounds: [[f32; WIDTH]; 6],
    child: [u32; WIDTH],
}

/// The hierarchy alone: what its leaves hold is the business of whoever built it.
#[derive(Clone, Debug, Default)]
pub(super) struct Hierarchy {
    nodes: Vec<Node>,
    bounds: Bounds,
}

/// Eight triangles, corner by corner and axis by axis. Unfilled places hold NaN, which nothing hits.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(super) struct Block {
    /// `corners[3 * corner + axis]`
    corners: [[f32; WIDTH]; 9],
    instance: [u32; WIDTH],
    triangle: [u32; WIDTH],
    /// Bit set: rays that meet the back pass through.
    culled: u8,
    /// Bit set: the transform mirrors, the front is seen clockwise.
    mirrored: u8,
    /// Bit set: the tree's screen is asked whether the triangle is there at all.
    screened: u8,
    /// Places that are filled.
    count: u8,
}

/// One triangle on its way into a tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Primitive {
    pub(super) corners: [Vec3; 3],
    pub(super) instance: u32,
    pub(super) triangle: u32,
    pub(super) culled: bool,
    pub(super) mirrored: bool,
    pub(super) screened: bool,
}

/// A hierarchy over triangles.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    hierarchy: Hierarchy,
    blocks: Vec<Block>,
    screen: Screen,
}

/// The place of an instance whose mesh is shared: its triangles are moved into the world as they are met, by the
/// operations that move the triangles of an unshared mesh beforehand; so sharing changes no bit of a hit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) instance: u32,
    pub(super) transform: Affine3A,
    pub(super) mirrored: bool,
}

/// A line made ready for triangles, always in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) origin: Vec3,
    pub(super) direction: Vec3,
    pub(super) shear: Shear,
}

impl Line {
    #[inline(always)]
    pub(super) fn new(ray: &Ray) -> Line {
        Line { origin: ray.origin, direction: ray.direction, shear: Shear::new(ray.direction) }
    }
}

/// The best hit so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Best {
    pub(super) t: f32,
    pub(super) u: f32,
    pub(super) v: f32,
    pub(super) instance: u32,
    pub(super) triangle: u32,
    pub(super) found: bool,
}

impl Best {
    pub(super) fn none(t_max: f32) -> Best {
        Best { t: t_max, u: 0.0, v: 0.0, instance: 0, triangle: 0, found: false }
    }

    pub(super) fn hit(&self) -> Option<Hit> {
        let Best { t, u, v, instance, triangle, found } = *self;
        found.then_some(Hit { t, u, v, instance, triangle })
    }

    /// Equal distances are decided by number, so that the tree cannot show.
    fn offer(&mut self, c: Crossing, instance: u32, triangle: u32) {
        let wins = c.t < self.t
            || (c.t == self.t && self.found && (instance, triangle) < (self.instance, self.triangle));
        if wins {
            *self = Best { t: c.t, u: c.u, v: c.v, instance, triangle, found: true };
        }
    }
}

/// What a ray asks of the triangles.
#[derive(Clone, Copy, Debug)]
pub(super) enum End {
    /// Is anything nearer than this?
    Distance(f32),
    /// Is anything between the origin and this point?
    Point(Vec3),
}

/// Which code walks the tree; each needs what those before it need.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kernel {
    /// Plain Rust, the oracle of the others.
    Portable,
    /// Eight boxes or triangles at once, sixteen rays of one origin in two halves.
    Avx2,
    /// Sixteen rays of one origin at once.
    Avx512,
}

impl Kernel {
    /// The fastest that this machine has.
    #[inline]
    pub fn detect() -> Kernel {
        static FOUND: OnceLock<Kernel> = OnceLock::new();
        *FOUND.get_or_init(Kernel::look)
    }

    #[cfg(target_arch = "x86_64")]
    fn look() -> Kernel {
        let narrow = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("popcnt");
        let wide = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512bw");
        match (narrow, wide) {
            (true, true) => Kernel::Avx512,
            (true, false) => Kernel::Avx2,
            _ => Kernel::Portable,
        }
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn look() -> Kernel {
        Kernel::Portable
    }

    /// Does this machine have it?
    pub fn available(self) -> bool {
        self <= Kernel::detect()
    }
}

impl Tree {
    /// Over those of `count` triangles that `primitive` grants. It is asked twice for each, since a list of all of them
    /// would be larger than the tree.
    pub(super) fn new(
        count: u32,
        primitive: impl Fn(u32) -> Option<Primitive> + Sync,
        screen: &Screen,
    ) -> Tree {
        let mut items = Vec::with_capacity(count as usize);
        items
            .extend((0..count).filter_map(|index| {
                primitive(index).map(|p| Item { bounds: Bounds::of(&p.corners), index })
            }));
        let (hierarchy, leaves) = build(&mut items, WIDTH);
        // The boxes make room for the blocks.
        let order: Vec<u32> = items.iter().map(|i| i.index).collect();
        drop(items);
        let block = |leaf: &build::Leaf| {
            let order = &order[leaf.start as usize..leaf.end as usize];
            Block::new(order.iter().filter_map(|i| primitive(*i)))
        };
        Tree { hierarchy, blocks: leaves.par_iter().map(block).collect(), screen: screen.clone() }
    }

    /// Triangles in it.
    pub(super) fn triangles(&self) -> u64 {
        self.blocks.iter().map(|b| u64::from(b.count)).sum()
    }

    pub(super) fn bounds(&self) -> Bounds {
        self.hierarchy.bounds
    }

    pub(super) fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    pub(super) fn memory(&self) -> usize {
        self.hierarchy.memory() + size_of_val(&self.blocks[..])
    }

    /// Asks another screen for holes.
    pub(super) fn ask(&mut self, screen: &Screen) {
        self.screen = screen.clone();
    }

    /// Offers `best` what a ray of the world meets. If the tree is that of a shared mesh, it also needs the place of the
    /// instance and the ray against the boxes of that mesh. Rays are made ready in the kernels, where it costs least.
    #[inline]
    pub(super) fn closest(
        &self,
        kernel: Kernel,
        ray: &Ray,
        placed: Option<(&Placed, &Slab)>,
        best: &mut Best,
    ) {
        match kernel {
            // SAFETY: a tracer holds only kernels that the machine was found to have.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2 | Kernel::Avx512 => unsafe { simd_avx2::closest(self, ray, placed, best) },
            _ => portable::closest(self, ray, placed, best),
        }
    }

    /// Does a ray meet anything before its end? Otherwise as [`Tree::closest`].
    #[inline]
    pub(super) fn occluded(
        &self,
        kernel: Kernel,
        ray: &Ray,
        end: End,
        placed: Option<(&Placed, &Slab)>,
    ) -> bool {
        match kernel {
            // SAFETY: as in `closest`.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2 | Kernel::Avx512 => unsafe { simd_avx2::occluded(self, ray, end, placed) },
            _ => portable::occluded(self, ray, end, placed),
        }
    }
}

/// Sixteen rays of one origin; directions that no ray can follow meet nothing.
impl Tree {
    pub(super) fn closest16(
        &self,
        kernel: Kernel,
        origin: Vec3,
        directions: &[[f32; LANES]; 3],
        live: u16,
        best: &mut PacketBest,
    ) {
        match kernel {
            // SAFETY: as in `closest`.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx512 => unsafe { simd_packet::closest_avx512(self, origin, directions, live, best) },
            // SAFETY: as in `closest`.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2 => unsafe { simd_packet::closest_avx2(self, origin, directions, live, best) },
            _ => self.closest_one_by_one(kernel, origin, directions, live, best),
        }
    }

    fn closest_one_by_one(
        &self,
        kernel: Kernel,
        origin: Vec3,
        directions: &[[f32; LANES]; 3],
        live: u16,
        best: &mut PacketBest,
    ) {
        for i in lanes(live) {
            let ray = Ray::new(origin, lane(directions, i));
            if sound_direction(ray.direction) {
                let mut single = best.lane(i);
                self.closest(kernel, &ray, None, &mut single);
                best.set(i, &single);
            }
        }
    }

    /// Of each part, lanes whose segments to `targets` are blocked. Kernels that walk with all lanes ask the block of number
    /// `first` before the others, and leave there the one that blocked last.
    pub(super) fn occluded_parts<const P: usize>(
        &self,
        kernel: Kernel,
        origin: Vec3,
        targets: [&[[f32; LANES]; 3]; P],
        live: [u16; P],
        first: &mut u32,
    ) -> [u16; P] {
        match kernel {
            // SAFETY: as in `closest`.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx512 => unsafe { simd_packet::occluded_avx512(self, origin, targets, live, first) },
            // SAFETY: as in `closest`.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2 => unsafe { simd_packet::occluded_avx2(self, origin, targets, live, first) },
            _ => {
                *first = NONE;
                std::array::from_fn(|p| self.occluded_one_by_one(kernel, origin, targets[p], live[p]))
            }
        }
    }

    fn occluded_one_by_one(
        &self,
        kernel: Kernel,
        origin: Vec3,
        targets: &[[f32; LANES]; 3],
        live: u16,
    ) -> u16 {
        lanes(live).fold(0, |blocked, i| {
            let target = lane(targets, i);
            let ray = Ray::between(origin, target);
            let hit = sound_direction(ray.direction) && self.occluded(kernel, &ray, End::Point(target), None);
            blocked | u16::from(hit) << i
        })
    }

    /// A ray against the boxes of the tree.
    #[inline(always)]
    fn slab(&self, ray: &Ray, placed: Option<(&Placed, &Slab)>) -> Slab {
        match placed {
            Some((_, slab)) => *slab,
            None => Slab::new(ray.origin, ray.direction, &self.bounds(), 0.0),
        }
    }
}

impl Node {
    /// Without children.
    const EMPTY: Node = Node {
        bounds: [
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
        ],
        child: [NONE; WIDTH],
    };

    /// The node among others, whose nodes and leaves have so many before them.
    fn moved(&self, nodes: u32, leaves: u32) -> Node {
        let child = |child: u32| match child {
            NONE => NONE,
            leaf if leaf & LEAF != 0 => leaf + leaves,
            inner => inner + nodes,
        };
        Node { child: self.child.map(child), ..self.clone() }
    }
}

impl Hierarchy {
    pub(super) fn memory(&self) -> usize {
        size_of_val(&self.nodes[..])
    }

    /// Leaves whose boxes the ray meets before the distance that `visit` returns last.
    pub(super) fn walk(&self, slab: &Slab, t_max: f32, visit: impl FnMut(u32) -> f32) {
        portable::walk(self, slab, t_max, visit);
    }
}

impl Block {
    fn new(primitives: impl Iterator<Item = Primitive>) -> Block {
        let mut block = Block {
            corners: [[f32::NAN; WIDTH]; 9],
            instance: [0; WIDTH],
            triangle: [0; WIDTH],
            culled: 0,
            mirrored: 0,
            screened: 0,
            count: 0,
        };
        for (i, p) in primitives.enumerate() {
            for (corner, position) in p.corners.iter().enumerate() {
                for axis in 0..3 {
                    block.corners[3 * corner + axis][i] = position[axis];
                }
            }
            block.instance[i] = p.instance;
            block.triangle[i] = p.triangle;
            block.culled |= u8::from(p.culled) << i;
            block.mirrored |= u8::from(p.mirrored) << i;
            block.screened |= u8::from(p.screened) << i;
            block.count += 1;
        }
        block
    }

    fn corners(&self, i: usize) -> [Vec3; 3] {
        [0, 1, 2].map(|c| {
            Vec3::new(self.corners[3 * c][i], self.corners[3 * c + 1][i], self.corners[3 * c + 2][i])
        })
    }

    /// Does triangle `i` let a ray pass that meets its front (`front`) or back, as seen without mirrors?
    fn passes(&self, i: usize, counter_clockwise: bool) -> bool {
        let front = counter_clockwise != (self.mirrored >> i & 1 == 1);
        !front && self.culled >> i & 1 == 1
    }

    /// The block moved into the world, in the order of operations of [`Affine3A::transform_point3`].
    #[inline(never)]
    fn placed(&self, place: &Placed) -> Block {
        let mut moved = self.clone();
        let m = place.transform.matrix3;
        for corner in 0..3 {
            for axis in 0..3 {
                let (mx, my, mz) = (m.x_axis[axis], m.y_axis[axis], m.z_axis[axis]);
                for i in 0..WIDTH {
                    moved.corners[3 * corner + axis][i] = mx * self.corners[3 * corner][i]
                        + my * self.corners[3 * corner + 1][i]
                        + mz * self.corners[3 * corner + 2][i]
                        + place.transform.translation[axis];
                }
            }
        }
        moved.instance = [place.instance; WIDTH];
        moved.mirrored = if place.mirrored { u8::MAX } else { 0 };
        moved
    }

    /// Is there a hole in triangle `i`?
    #[inline(always)]
    fn open(&self, i: usize, u: f32, v: f32, screen: &Screen) -> bool {
        self.screened >> i & 1 == 1 && screen.open(self.instance[i], self.triangle[i], u, v)
    }

    /// Where the line meets triangle `i`, unless that lets it pass.
    fn crossing(&self, i: usize, line: &Line, screen: &Screen) -> Option<Crossing> {
        let (c, front) = crossing(&self.corners(i), line.origin, line.direction, &line.shear)?;
        (!self.passes(i, front) && !self.open(i, c.u, c.v, screen)).then_some(c)
    }

    fn offer(&self, i: usize, line: &Line, screen: &Screen, best: &mut Best) {
        if let Some(c) = self.crossing(i, line, screen) {
            best.offer(c, self.instance[i], self.triangle[i]);
        }
    }

    fn blocks(&self, i: usize, line: &Line, end: End, screen: &Screen) -> bool {
        match end {
            End::Distance(t_max) => self.crossing(i, line, screen).is_some_and(|c| c.t < t_max),
            End::Point(target) => pierced(&self.corners(i), line.origin, target, &line.shear)
                .is_some_and(|(front, [u, v])| !self.passes(i, front) && !self.open(i, u, v, screen)),
        }
    }
}
