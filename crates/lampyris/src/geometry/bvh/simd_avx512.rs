//! Sixteen rays of one origin with AVX-512: a node's eight boxes against the whole packet by interval arithmetic
//! [Boulos et al. 2006], survivors lane by lane; a block's eight triangles against the packet's beam, survivors lane by
//! lane. Same operations as `triangle.rs` on every lane that counts, none fused, so the bits are those of single rays.
//! Unsafe here: loads and stores through references of the right size, and stack entries that were written.

use super::packet::{Packet, PacketBest};
use super::triangle::{Crossing, Plane, TINY, in_front, separates};
use super::{Block, End, Hierarchy, Kernel, LEAF, STACK, Tree, WIDTH};
use crate::geometry::packet::{LANES, lane, lanes};
use crate::geometry::screen::Screen;
use glam::Vec3;
use std::arch::x86_64::*;
use std::mem::MaybeUninit;

/// Fewer rays than this go one by one.
const FEW: u32 = 3;

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
pub(super) fn occluded16(
    tree: &Tree,
    origin: Vec3,
    directions: &[[f32; LANES]; 3],
    targets: &[[f32; LANES]; 3],
    live: u16,
) -> u16 {
    let mut blocked = 0;
    Packet::split(origin, directions, live, &tree.bounds(), |packet| {
        blocked |= if packet.live.count_ones() >= FEW {
            occluded(tree, packet, targets)
        } else {
            tree.occluded16(Kernel::Avx2, origin, directions, targets, packet.live)
        };
    });
    blocked
}

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
pub(super) fn closest16(
    tree: &Tree,
    origin: Vec3,
    directions: &[[f32; LANES]; 3],
    live: u16,
    best: &mut PacketBest,
) {
    Packet::split(origin, directions, live, &tree.bounds(), |packet| {
        if packet.live.count_ones() >= FEW {
            closest(tree, packet, best);
        } else {
            tree.closest16(Kernel::Avx2, origin, directions, packet.live, best);
        }
    });
}

/// Lanes of `packet` whose segments to `targets` are blocked.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn occluded(tree: &Tree, packet: &Packet, targets: &[[f32; LANES]; 3]) -> u16 {
    let kz = packet.axes[2];
    let start = _mm512_set1_ps(packet.origin[kz]);
    let end = _mm512_abs_ps(_mm512_sub_ps(load16(&targets[kz]), start));
    let beam = Beam::new(packet, _mm512_mask_reduce_max_ps(packet.live, end));
    let mut alive = packet.live;
    let limit = _mm512_add_ps(_mm512_set1_ps(1.0), load16(&packet.slack));
    walk(&tree.hierarchy, packet, limit, &mut alive, |leaf, mut mask, _, alive| {
        let block = &tree.blocks[leaf as usize];
        let (relative, survivors) = beam.cull(block);
        for i in lanes(u16::from(survivors)) {
            let tested = test(&relative, i, packet, mask, block.screened);
            if tested.pierced | tested.unsure == 0 {
                continue;
            }
            let before = tested.z_range.map(|z| _mm512_cmp_ps_mask::<_CMP_LT_OQ>(_mm512_set1_ps(z), end));
            let mut hit = tested.pierced & before[0] & visible(block, i, packet, tested.det);
            let unclear = hit & !(if tested.z_range[0] > 0.0 { before[1] } else { 0 });
            if unclear != 0 {
                let plane = Plane::new(&block.corners(i), packet.origin);
                for l in lanes(unclear).filter(|&l| !separates(&plane, lane(targets, l))) {
                    hit &= !(1 << l);
                }
            }
            for l in lanes(tested.unsure) {
                hit |=
                    u16::from(block.blocks(i, &packet.line(l), End::Point(lane(targets, l)), &tree.screen))
                        << l;
            }
            mask &= !hit;
            *alive &= !hit;
            if mask == 0 {
                return false;
            }
        }
        false
    });
    packet.live & !alive
}

/// Offers what the lanes of `packet` meet in the tree.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn closest(tree: &Tree, packet: &Packet, best: &mut PacketBest) {
    let beam = Beam::new(packet, f32::INFINITY);
    let slack = load16(&packet.slack);
    let mut alive = packet.live;
    let limit = _mm512_add_ps(load16(&best.t), slack);
    walk(&tree.hierarchy, packet, limit, &mut alive, |leaf, mask, limit, _| {
        let block = &tree.blocks[leaf as usize];
        let (relative, survivors) = beam.cull(block);
        let mut nearer = false;
        for i in lanes(u16::from(survivors)) {
            let tested = test(&relative, i, packet, mask, block.screened);
            let near = tested.pierced & visible(block, i, packet, tested.det);
            if near | tested.unsure == 0 {
                continue;
            }
            nearer |= offer(block, i, packet, &tested, near, &tree.screen, best);
        }
        if nearer {
            *limit = _mm512_add_ps(load16(&best.t), slack);
        }
        nearer
    });
}

#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn offer(
    block: &Block,
    i: usize,
    packet: &Packet,
    tested: &Tested,
    near: u16,
    screen: &Screen,
    best: &mut PacketBest,
) -> bool {
    let inverse = _mm512_div_ps(_mm512_set1_ps(1.0), tested.det);
    let b = three!(k => _mm512_mul_ps(tested.e[k], inverse));
    let z = three!(k => _mm512_set1_ps(tested.z[k]));
    let along = _mm512_add_ps(
        _mm512_add_ps(_mm512_mul_ps(b[0], z[0]), _mm512_mul_ps(b[1], z[1])),
        _mm512_mul_ps(b[2], z[2]),
    );
    let t = _mm512_max_ps(_mm512_mul_ps(load16(&packet.sz), along), _mm512_set1_ps(f32::MIN_POSITIVE));
    let mut near = near & _mm512_cmp_ps_mask::<_CMP_LE_OQ>(t, load16(&best.t));
    if near != 0 && tested.z_range[0] <= 0.0 {
        let plane = Plane::new(&block.corners(i), packet.origin);
        for l in lanes(near).filter(|&l| !in_front(&plane, lane(&packet.directions, l))) {
            near &= !(1 << l);
        }
    }
    let nearer = near & _mm512_cmp_ps_mask::<_CMP_LT_OQ>(t, load16(&best.t));
    let ties = near & !nearer;
    if ties != 0 {
        let (t, u, v) = (store16(t), store16(b[1]), store16(b[2]));
        for l in lanes(ties) {
            best.offer(l, Crossing { t: t[l], u: u[l], v: v[l] }, block.instance[i], block.triangle[i]);
        }
    }
    blend(&mut best.t, nearer, t);
    blend(&mut best.u, nearer, b[1]);
    blend(&mut best.v, nearer, b[2]);
    blend_u32(&mut best.instance, nearer, block.instance[i]);
    blend_u32(&mut best.triangle, nearer, block.triangle[i]);
    best.found |= nearer;
    for l in lanes(tested.unsure) {
        if let Some(crossing) = block.crossing(i, &packet.line(l), screen) {
            best.offer(l, crossing, block.instance[i], block.triangle[i]);
        }
    }
    nearer | tested.unsure != 0
}

/// Calls `visit` with leaves and the lanes that meet their boxes, nearest first; `visit` says whether limits changed.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn walk(
    hierarchy: &Hierarchy,
    packet: &Packet,
    mut limit: __m512,
    alive: &mut u16,
    mut visit: impl FnMut(u32, u16, &mut __m512, &mut u16) -> bool,
) {
    if hierarchy.nodes.is_empty() {
        return;
    }
    let mut stack = [MaybeUninit::<(u32, u16, f32)>::uninit(); STACK];
    let mut depth = 0;
    let inverse = three!(a => load16(&packet.inverse[a]));
    let [least, most] = packet.inverse_range;
    let mut farthest = _mm512_mask_reduce_max_ps(*alive, limit);
    let (mut child, mut mask) = (0, *alive);
    loop {
        if child & LEAF != 0 {
            if visit(child & !LEAF, mask, &mut limit, alive) {
                farthest = _mm512_mask_reduce_max_ps(*alive, limit);
            }
            if *alive == 0 {
                return;
            }
        } else {
            let node = &hierarchy.nodes[child as usize];
            let (mut enter, mut leave) = (_mm256_setzero_ps(), _mm256_set1_ps(f32::INFINITY));
            let mut planes = [[0.0; WIDTH]; 6];
            for a in 0..3 {
                let lower = _mm256_sub_ps(load8(&node.bounds[a]), _mm256_set1_ps(packet.origins[0][a]));
                let upper = _mm256_sub_ps(load8(&node.bounds[a + 3]), _mm256_set1_ps(packet.origins[1][a]));
                let (near, far) = if least[a] > 0.0 {
                    (lower, upper)
                } else if most[a] < 0.0 {
                    (upper, lower)
                } else {
                    planes[a] = store8(lower);
                    planes[a + 3] = store8(upper);
                    continue;
                };
                planes[a] = store8(near);
                planes[a + 3] = store8(far);
                let (least, most) = (_mm256_set1_ps(least[a]), _mm256_set1_ps(most[a]));
                enter = _mm256_max_ps(
                    enter,
                    _mm256_min_ps(_mm256_mul_ps(near, least), _mm256_mul_ps(near, most)),
                );
                leave =
                    _mm256_min_ps(leave, _mm256_max_ps(_mm256_mul_ps(far, least), _mm256_mul_ps(far, most)));
            }
            leave = _mm256_mul_ps(leave, _mm256_set1_ps(super::slab::STRETCH));
            leave = _mm256_min_ps(leave, _mm256_set1_ps(farthest));
            let boxes = _mm256_cmp_ps_mask::<_CMP_LE_OQ>(enter, leave);
            let enter = store8(enter);
            let first = depth;
            for i in lanes(u16::from(boxes)) {
                let met = mask & spans(&planes, i, &inverse, least, most, limit);
                if met == 0 || node.child[i] == super::NONE {
                    continue;
                }
                let mut at = depth;
                // SAFETY: entries below `depth` were written.
                while at > first && unsafe { stack[at - 1].assume_init() }.2 < enter[i] {
                    stack[at] = stack[at - 1];
                    at -= 1;
                }
                stack[at].write((node.child[i], met, enter[i]));
                depth += 1;
            }
        }
        loop {
            if depth == 0 {
                return;
            }
            depth -= 1;
            // SAFETY: entries below the old `depth` were written.
            let (next, met, enter) = unsafe { stack[depth].assume_init() };
            if enter <= farthest && met & *alive != 0 {
                (child, mask) = (next, met & *alive);
                break;
            }
        }
    }
}

/// Lanes that meet box `i`. Where all lanes agree in sign the planes come near before far.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn spans(
    planes: &[[f32; WIDTH]; 6],
    i: usize,
    inverse: &[__m512; 3],
    least: [f32; 3],
    most: [f32; 3],
    limit: __m512,
) -> u16 {
    let (mut enter, mut leave) = (_mm512_setzero_ps(), _mm512_set1_ps(f32::INFINITY));
    for a in 0..3 {
        let near = _mm512_mul_ps(_mm512_set1_ps(planes[a][i]), inverse[a]);
        let far = _mm512_mul_ps(_mm512_set1_ps(planes[a + 3][i]), inverse[a]);
        let mixed = !(least[a] > 0.0 || most[a] < 0.0);
        let (near, far) =
            if mixed { (_mm512_min_ps(near, far), _mm512_max_ps(near, far)) } else { (near, far) };
        enter = _mm512_max_ps(enter, near);
        leave = _mm512_min_ps(leave, far);
    }
    leave = _mm512_mul_ps(leave, _mm512_set1_ps(super::slab::STRETCH));
    _mm512_cmp_ps_mask::<_CMP_LE_OQ>(enter, _mm512_min_ps(leave, limit))
}

/// The shears of all lanes in an interval, against eight triangles at once.
struct Beam {
    axes: [usize; 3],
    origin: [__m256; 3],
    /// Least and largest sx, sy.
    shears: [[__m256; 2]; 2],
    sign: __m256,
    end: __m256,
}

/// Corners relative to the origin: `[3 * corner + k]`, k along kx, ky, kz.
type Relative = [[f32; WIDTH]; 9];

impl Beam {
    #[inline]
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
    fn new(packet: &Packet, end: f32) -> Beam {
        let range = |s: &[f32; LANES]| {
            let s = load16(s);
            [_mm256_set1_ps(_mm512_reduce_min_ps(s)), _mm256_set1_ps(_mm512_reduce_max_ps(s))]
        };
        Beam {
            axes: packet.axes,
            origin: three!(k => _mm256_set1_ps(packet.origin[packet.axes[k]])),
            shears: [range(&packet.sx), range(&packet.sy)],
            sign: _mm256_set1_ps(if packet.negative { -0.0 } else { 0.0 }),
            end: _mm256_set1_ps(end),
        }
    }

    /// Triangles that some lane might pierce. Rounding is monotone, so what is outside for the least and the largest
    /// shear, to the same side, is outside for all between, by the very numbers that the lanes would compute.
    #[inline]
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
    fn cull(&self, block: &Block) -> (Relative, u8) {
        let mut relative = [[0.0; WIDTH]; 9];
        let zero = _mm256_setzero_ps();
        let mut p = [zero; 9];
        for c in 0..3 {
            for k in 0..3 {
                p[3 * c + k] = _mm256_sub_ps(load8(&block.corners[3 * c + self.axes[k]]), self.origin[k]);
                relative[3 * c + k] = store8(p[3 * c + k]);
            }
        }
        let ahead = three!(k => _mm256_xor_ps(p[3 * k + 2], self.sign));
        let least = _mm256_min_ps(_mm256_min_ps(ahead[0], ahead[1]), ahead[2]);
        let most = _mm256_max_ps(_mm256_max_ps(ahead[0], ahead[1]), ahead[2]);
        // Ordered: false for NaN, which fills unused places.
        let mut met = _mm256_cmp_ps_mask::<_CMP_GT_OQ>(most, zero);
        met &= _mm256_cmp_ps_mask::<_CMP_LT_OQ>(least, self.end);
        for (k, shears) in self.shears.iter().enumerate() {
            let (mut lowest, mut highest) =
                (_mm256_set1_ps(f32::INFINITY), _mm256_set1_ps(f32::NEG_INFINITY));
            for c in 0..3 {
                for s in shears {
                    let x = _mm256_sub_ps(p[3 * c + k], _mm256_mul_ps(*s, p[3 * c + 2]));
                    lowest = _mm256_min_ps(lowest, x);
                    highest = _mm256_max_ps(highest, x);
                }
            }
            met &= _mm256_cmp_ps_mask::<_CMP_LE_OQ>(lowest, zero);
            met &= _mm256_cmp_ps_mask::<_CMP_GE_OQ>(highest, zero);
        }
        (relative, met)
    }
}

/// One triangle against sixteen lines.
struct Tested {
    e: [__m512; 3],
    det: __m512,
    z: [f32; 3],
    /// Least and largest height along the rays.
    z_range: [f32; 2],
    /// Lanes that pierce for certain, and lanes that need f64 or a screen to tell.
    pierced: u16,
    unsure: u16,
}

#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn test(relative: &Relative, i: usize, packet: &Packet, mask: u16, screened: u8) -> Tested {
    let z = three!(k => relative[3 * k + 2][i]);
    let (sx, sy) = (load16(&packet.sx), load16(&packet.sy));
    let shear = |k: usize, s: __m512, z: f32| {
        _mm512_sub_ps(_mm512_set1_ps(relative[k][i]), _mm512_mul_ps(s, _mm512_set1_ps(z)))
    };
    let x = [shear(0, sx, z[0]), shear(3, sx, z[1]), shear(6, sx, z[2])];
    let y = [shear(1, sy, z[0]), shear(4, sy, z[1]), shear(7, sy, z[2])];
    let edge = |b: usize, c: usize| _mm512_sub_ps(_mm512_mul_ps(x[b], y[c]), _mm512_mul_ps(y[b], x[c]));
    let e = [edge(2, 1), edge(0, 2), edge(1, 0)];
    let zero = _mm512_setzero_ps();
    let least = _mm512_min_ps(_mm512_min_ps(e[0], e[1]), e[2]);
    let most = _mm512_max_ps(_mm512_max_ps(e[0], e[1]), e[2]);
    let opposed =
        _mm512_cmp_ps_mask::<_CMP_LT_OQ>(least, zero) & _mm512_cmp_ps_mask::<_CMP_GT_OQ>(most, zero);
    let possible = mask & !opposed;
    let det = _mm512_add_ps(_mm512_add_ps(e[0], e[1]), e[2]);
    let ahead = z.map(|z| if packet.negative { -z } else { z });
    let z_range = [ahead[0].min(ahead[1]).min(ahead[2]), ahead[0].max(ahead[1]).max(ahead[2])];
    let mut unsure = 0;
    if possible != 0 {
        let none = |a: __m512| _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, zero);
        let tiny = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(_mm512_abs_ps(det), _mm512_set1_ps(TINY));
        let asked = if screened >> i & 1 == 1 { u16::MAX } else { 0 };
        unsure = possible & (none(e[0]) | none(e[1]) | none(e[2]) | tiny | asked);
    }
    Tested { e, det, z, z_range, pierced: possible & !unsure, unsure }
}

/// Lanes that do not meet the back of a one-sided triangle.
#[inline]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn visible(block: &Block, i: usize, packet: &Packet, det: __m512) -> u16 {
    if block.culled >> i & 1 == 0 {
        return u16::MAX;
    }
    let positive = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(det, _mm512_setzero_ps());
    let flipped = packet.negative != (block.mirrored >> i & 1 == 1);
    if flipped { !positive } else { positive }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn load16(a: &[f32; LANES]) -> __m512 {
    // SAFETY: the reference is valid for sixteen f32.
    unsafe { _mm512_loadu_ps(a.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn store16(a: __m512) -> [f32; LANES] {
    let mut out = [0.0; LANES];
    // SAFETY: the reference is valid for sixteen f32.
    unsafe { _mm512_storeu_ps(out.as_mut_ptr(), a) };
    out
}

#[inline]
#[target_feature(enable = "avx512f")]
fn blend(to: &mut [f32; LANES], mask: u16, from: __m512) {
    // SAFETY: the reference is valid for sixteen f32.
    unsafe { _mm512_mask_storeu_ps(to.as_mut_ptr(), mask, from) };
}

#[inline]
#[target_feature(enable = "avx512f")]
fn blend_u32(to: &mut [u32; LANES], mask: u16, from: u32) {
    // SAFETY: the reference is valid for sixteen u32.
    unsafe { _mm512_mask_storeu_epi32(to.as_mut_ptr().cast(), mask, _mm512_set1_epi32(from as i32)) };
}

#[inline]
#[target_feature(enable = "avx2")]
fn load8(a: &[f32; WIDTH]) -> __m256 {
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_loadu_ps(a.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx2")]
fn store8(a: __m256) -> [f32; WIDTH] {
    let mut out = [0.0; WIDTH];
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_storeu_ps(out.as_mut_ptr(), a) };
    out
}
