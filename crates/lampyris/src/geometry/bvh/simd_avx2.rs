//! One ray against eight boxes or eight triangles at once with AVX2 [Wald et al. 2014]. Same operations in the same
//! order as `triangle.rs`, none of them fused, so the bits of hits are the same; edge functions that need f64 go there.
//! Unsafe here: loads and stores through references of the right size, and stack entries that were written.

use super::slab::STRETCH;
use super::triangle::{Crossing, TINY};
use super::{Best, Block, End, Hierarchy, LEAF, Line, Node, Placed, STACK, Slab, Tree, WIDTH};
use crate::geometry::Ray;
use crate::geometry::screen::Screen;
use glam::Vec3;
use std::arch::x86_64::*;
use std::mem::MaybeUninit;

#[target_feature(enable = "avx2,bmi1,popcnt")]
pub(super) fn closest(tree: &Tree, ray: &Ray, placed: Option<(&Placed, &Slab)>, best: &mut Best) {
    let (line, slab) = (Line::new(ray), tree.slab(ray, placed));
    let lanes = Lanes::new(&line, slab.reach(placed.is_some()));
    walk::<false>(&tree.hierarchy, &slab, best.t, |leaf| {
        let block = &tree.blocks[leaf as usize];
        let moved;
        let block = match placed {
            Some((place, _)) => {
                moved = block.placed(place);
                &moved
            }
            None => block,
        };
        offer(block, &lanes, &line, &tree.screen, best);
        best.t
    });
}

#[target_feature(enable = "avx2,bmi1,popcnt")]
pub(super) fn occluded(tree: &Tree, ray: &Ray, end: End, placed: Option<(&Placed, &Slab)>) -> bool {
    let (line, slab) = (Line::new(ray), tree.slab(ray, placed));
    let lanes = Lanes::new(&line, slab.reach(placed.is_some()));
    let t_max = match end {
        End::Distance(t) => t,
        End::Point(_) => 1.0,
    };
    let mut hit = false;
    walk::<true>(&tree.hierarchy, &slab, t_max, |leaf| {
        let block = &tree.blocks[leaf as usize];
        let moved;
        let block = match placed {
            Some((place, _)) => {
                moved = block.placed(place);
                &moved
            }
            None => block,
        };
        hit = blocks(block, &lanes, &line, end, &tree.screen);
        if hit { f32::NEG_INFINITY } else { t_max }
    });
    hit
}

/// `portable::walk`, eight boxes at a time. How many boxes are met is unpredictable, so nothing branches on it beyond
/// none, one or more: the nearest is the least of keys, and the others are sorted by a network while it is fetched.
/// Walks for `ANY` hit do not sort: their limit never changes.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn walk<const ANY: bool>(hierarchy: &Hierarchy, slab: &Slab, t_max: f32, mut visit: impl FnMut(u32) -> f32) {
    if hierarchy.nodes.is_empty() {
        return;
    }
    // Vectors of eight are pushed whole, so the last may hang over.
    let mut children = [MaybeUninit::<u32>::uninit(); STACK + WIDTH];
    let mut keys = [MaybeUninit::<u32>::uninit(); STACK + WIDTH];
    let mut depth = 0;
    let mut limit = t_max + slab.slack;
    let boxes = Boxes::new(slab);
    let mut child = 0;
    loop {
        if child & LEAF != 0 {
            let t_max = visit(child & !LEAF);
            if ANY && t_max < 0.0 {
                return;
            }
            limit = t_max + slab.slack;
        } else {
            let node = &hierarchy.nodes[child as usize];
            let (enter, leave) = boxes.spans(node);
            let leave = _mm256_min_ps(leave, _mm256_set1_ps(limit));
            let met = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave));
            let hits = _mm256_movemask_ps(_mm256_castsi256_ps(met)) as u32;
            if hits != 0 {
                let stored = load_u32(&node.child);
                child = node.child[hits.trailing_zeros() as usize];
                if !ANY && hits & (hits - 1) == 0 {
                    continue;
                }
                if ANY {
                    let others = _mm256_permutevar8x32_epi32(stored, front(hits & (hits - 1)));
                    push(&mut children, depth, others);
                } else {
                    let key = keyed(enter);
                    let lane = least(_mm256_or_si256(key, _mm256_andnot_si256(met, ones()))) & LANE;
                    child = node.child[lane as usize];
                    let sorted = sorted(_mm256_and_si256(key, met), hits);
                    push(&mut keys, depth, sorted);
                    push(&mut children, depth, _mm256_permutevar8x32_epi32(stored, sorted));
                }
                depth += hits.count_ones() as usize - 1;
                continue;
            }
        }
        loop {
            if depth == 0 {
                return;
            }
            depth -= 1;
            // SAFETY: entries below the old `depth` were written.
            let next = unsafe { children[depth].assume_init() };
            // SAFETY: as above, unless `ANY`.
            if ANY || f32::from_bits(unsafe { keys[depth].assume_init() } & !LANE) <= limit {
                child = next;
                break;
            }
        }
    }
}

/// The ray in all lanes, for boxes: planes by axis, the near ones first.
struct Boxes {
    /// Where the near planes and the far ones lie among the bounds of a node.
    planes: [[usize; 3]; 2],
    inverse: [[__m256; 3]; 2],
    origin: [[__m256; 3]; 2],
}

impl Boxes {
    #[inline]
    #[target_feature(enable = "avx2,bmi1,popcnt")]
    fn new(slab: &Slab) -> Boxes {
        // By sign bits, as branches would be fooled by every other ray.
        let upper_first = three!(a => (slab.inverse[a].to_bits() >> 31) as usize);
        let inverse = three!(a => _mm256_set1_ps(slab.inverse[a]));
        let stretched = three!(a => _mm256_mul_ps(inverse[a], _mm256_set1_ps(STRETCH)));
        let origin = |at: usize, a: usize| _mm256_set1_ps(slab.origin[at][a]);
        let near = three!(a => _mm256_blendv_ps(origin(0, a), origin(1, a), inverse[a]));
        let far = three!(a => _mm256_blendv_ps(origin(1, a), origin(0, a), inverse[a]));
        Boxes {
            planes: [three!(a => a + 3 * upper_first[a]), three!(a => a + 3 * (1 - upper_first[a]))],
            inverse: [inverse, stretched],
            origin: [near, far],
        }
    }

    /// As [`Slab::span`].
    #[inline]
    #[target_feature(enable = "avx2,bmi1,popcnt")]
    fn spans(&self, node: &Node) -> (__m256, __m256) {
        let at = |side: usize, a: usize| {
            let plane = load(&node.bounds[self.planes[side][a] % 6]);
            _mm256_mul_ps(_mm256_sub_ps(plane, self.origin[side][a]), self.inverse[side][a])
        };
        // A distance that is not a number gives way, being the first operand.
        let enter = _mm256_max_ps(at(0, 0), _mm256_setzero_ps());
        let enter = _mm256_max_ps(at(0, 2), _mm256_max_ps(at(0, 1), enter));
        let leave = _mm256_min_ps(at(1, 0), _mm256_set1_ps(f32::INFINITY));
        let leave = _mm256_min_ps(at(1, 2), _mm256_min_ps(at(1, 1), leave));
        (enter, leave)
    }
}

/// The bits of a distance that hold a lane instead: smaller by less than 2⁻²⁰ of it, never larger.
const LANE: u32 = WIDTH as u32 - 1;

/// Distances that are not negative as integers of the same order, each with its lane in its last bits.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn keyed(enter: __m256) -> __m256i {
    let rounded = _mm256_andnot_si256(_mm256_set1_epi32(LANE as i32), _mm256_castps_si256(enter));
    _mm256_or_si256(rounded, _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7))
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn ones() -> __m256i {
    _mm256_set1_epi32(-1)
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn least(keys: __m256i) -> u32 {
    let m = _mm_min_epu32(_mm256_castsi256_si128(keys), _mm256_extracti128_si256::<1>(keys));
    let m = _mm_min_epu32(m, _mm_shuffle_epi32::<0b01_00_11_10>(m));
    let m = _mm_min_epu32(m, _mm_shuffle_epi32::<0b10_11_00_01>(m));
    _mm_cvtsi128_si32(m) as u32
}

/// For each mask its lanes, in order, then the others.
static FRONT: [u64; 256] = {
    let mut all = [0; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut at, mut i) = (0, 0);
        while i < 2 * WIDTH {
            if (mask >> (i % WIDTH) & 1 == 1) == (i < WIDTH) {
                all[mask] |= ((i % WIDTH) as u64) << (8 * at);
                at += 1;
            }
            i += 1;
        }
        mask += 1;
    }
    all
};

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn front(mask: u32) -> __m256i {
    _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(FRONT[mask as usize & 255] as i64))
}

/// Keys of the lanes in `mask`, the largest first; the other keys must be zero. [Batcher 1968]
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn sorted(keys: __m256i, mask: u32) -> __m256i {
    let k = _mm256_permutevar8x32_epi32(keys, front(mask));
    let k = ordered::<0b1010_1010>(k, _mm256_shuffle_epi32::<0b10_11_00_01>(k));
    let k = ordered::<0b1100_1100>(k, _mm256_shuffle_epi32::<0b01_00_11_10>(k));
    let k = ordered::<0b0100_0100>(k, _mm256_shuffle_epi32::<0b11_01_10_00>(k));
    // Four at most lie in the lower half, and the upper holds nothing.
    if mask.count_ones() <= 4 {
        return k;
    }
    let k = ordered::<0b1111_0000>(k, _mm256_permute2x128_si256::<1>(k, k));
    let k =
        ordered::<0b0011_0000>(k, _mm256_permutevar8x32_epi32(k, _mm256_setr_epi32(0, 1, 4, 5, 2, 3, 6, 7)));
    ordered::<0b0101_0100>(k, _mm256_permutevar8x32_epi32(k, _mm256_setr_epi32(0, 2, 1, 4, 3, 6, 5, 7)))
}

/// A layer of the network: lanes in `LESSER` keep the smaller of two keys, the others the larger.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn ordered<const LESSER: i32>(keys: __m256i, partners: __m256i) -> __m256i {
    _mm256_blend_epi32::<LESSER>(_mm256_max_epu32(keys, partners), _mm256_min_epu32(keys, partners))
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn push(stack: &mut [MaybeUninit<u32>; STACK + WIDTH], depth: usize, values: __m256i) {
    debug_assert!(depth <= STACK);
    // SAFETY: the builder bounds the levels such that no walk puts off more than `STACK`.
    unsafe { _mm256_storeu_si256(stack.as_mut_ptr().add(depth).cast(), values) };
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn load_u32(a: &[u32; WIDTH]) -> __m256i {
    // SAFETY: the reference is valid for eight u32.
    unsafe { _mm256_loadu_si256(a.as_ptr().cast()) }
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn load(a: &[f32; WIDTH]) -> __m256 {
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_loadu_ps(a.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn store(a: __m256) -> [f32; WIDTH] {
    let mut out = [0.0; WIDTH];
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_storeu_ps(out.as_mut_ptr(), a) };
    out
}

/// Let u = 2⁻²⁴ and r bound the distances of corners from the origin along each axis. Sheared corners lie within 2 r and
/// err by 7 u r at most, their edge functions e by 72 u r², the sum of e · z by 240 u r³, and what is computed for height
/// times determinant departs from that sum by 200 u r³. This is three times as much.
const DOUBT: f32 = 1536.0 * f32::EPSILON / 2.0;

/// The ray in all lanes, axes in the order of its shear.
struct Lanes {
    axes: [usize; 3],
    origin: [__m256; 3],
    sx: __m256,
    sy: __m256,
    /// Sign bit of the direction along kz.
    sign: __m256,
    /// Heights times determinants below this may have the wrong sign.
    doubt: __m256,
}

impl Lanes {
    #[inline]
    #[target_feature(enable = "avx2,bmi1,popcnt")]
    fn new(line: &Line, reach: f32) -> Lanes {
        let s = &line.shear;
        let axes = [s.kx, s.ky, s.kz];
        // As an array: a vector's index becomes branches.
        let origin = line.origin.to_array();
        Lanes {
            axes,
            origin: three!(k => _mm256_set1_ps(origin[axes[k]])),
            sx: _mm256_set1_ps(s.sx),
            sy: _mm256_set1_ps(s.sy),
            sign: _mm256_set1_ps(if s.negative { -0.0 } else { 0.0 }),
            // Of products below the normal numbers nothing is known.
            doubt: _mm256_set1_ps(reach * reach * reach * DOUBT + f32::MIN_POSITIVE),
        }
    }
}

/// Eight triangles against the line.
struct Tested {
    e: [__m256; 3],
    det: __m256,
    z: [__m256; 3],
    /// Least and largest height along the ray.
    z_range: [__m256; 2],
    /// Lanes pierced for certain, and lanes that need f64 or a screen to tell.
    pierced: u32,
    unsure: u32,
}

/// A copy for each of its two callers (`ANY` or closest hit), so that it is inlined: the registers stay where they are.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn test<const ANY: bool>(block: &Block, lanes: &Lanes) -> Option<Tested> {
    let p = |c: usize, k: usize| _mm256_sub_ps(load(&block.corners[3 * c + lanes.axes[k]]), lanes.origin[k]);
    let z = [p(0, 2), p(1, 2), p(2, 2)];
    let x = three!(c => _mm256_sub_ps(p(c, 0), _mm256_mul_ps(lanes.sx, z[c])));
    let y = three!(c => _mm256_sub_ps(p(c, 1), _mm256_mul_ps(lanes.sy, z[c])));
    let edge = |b: usize, c: usize| _mm256_sub_ps(_mm256_mul_ps(x[b], y[c]), _mm256_mul_ps(y[b], x[c]));
    let e = [edge(2, 1), edge(0, 2), edge(1, 0)];
    let zero = _mm256_setzero_ps();
    let least = _mm256_min_ps(_mm256_min_ps(e[0], e[1]), e[2]);
    let most = _mm256_max_ps(_mm256_max_ps(e[0], e[1]), e[2]);
    // Ordered: false for NaN, which fills unused places.
    let agreed =
        _mm256_or_ps(_mm256_cmp_ps::<_CMP_GE_OQ>(least, zero), _mm256_cmp_ps::<_CMP_LE_OQ>(most, zero));
    if _mm256_movemask_ps(agreed) == 0 {
        return None;
    }
    let det = _mm256_add_ps(_mm256_add_ps(e[0], e[1]), e[2]);
    let size = _mm256_andnot_ps(_mm256_set1_ps(-0.0), det);
    let none = |a: __m256| _mm256_cmp_ps::<_CMP_EQ_OQ>(a, zero);
    // A zero among agreeing signs is the least or the most of them, whichever is nearer to zero.
    let unsure = _mm256_or_ps(
        _mm256_or_ps(none(least), none(most)),
        _mm256_cmp_ps::<_CMP_LT_OQ>(size, _mm256_set1_ps(TINY)),
    );
    let ahead = three!(c => _mm256_xor_ps(z[c], lanes.sign));
    let z_range = [
        _mm256_min_ps(_mm256_min_ps(ahead[0], ahead[1]), ahead[2]),
        _mm256_max_ps(_mm256_max_ps(ahead[0], ahead[1]), ahead[2]),
    ];
    let ahead = _mm256_cmp_ps::<_CMP_GT_OQ>(z_range[1], zero);
    let possible = _mm256_movemask_ps(_mm256_and_ps(agreed, ahead)) as u32;
    let unsure = _mm256_movemask_ps(unsure) as u32 | u32::from(block.screened);
    Some(Tested { e, det, z, z_range, pierced: possible & !unsure, unsure: possible & unsure })
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn offer(block: &Block, lanes: &Lanes, line: &Line, screen: &Screen, best: &mut Best) {
    let Some(tested) = test::<false>(block, lanes) else { return };
    if tested.pierced != 0 {
        let (t, u, v, along) = distances(&tested, line.shear.sz);
        let near = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(t, _mm256_set1_ps(best.t))) as u32;
        let mut candidates = tested.pierced & near & visible(block, &tested, line);
        if candidates & straddling(&tested) != 0 {
            candidates &= !straddling(&tested) | ahead(block, lanes, &tested, along, candidates, line);
        }
        if candidates != 0 {
            let (t, u, v) = (store(t), store(u), store(v));
            for i in bits(candidates) {
                let crossing = Crossing { t: t[i], u: u[i], v: v[i] };
                best.offer(crossing, block.instance[i], block.triangle[i]);
            }
        }
    }
    for i in bits(tested.unsure) {
        block.offer(i, line, screen, best);
    }
}

/// t, the weights of the second and third corner, and the height of the meeting.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn distances(tested: &Tested, sz: f32) -> (__m256, __m256, __m256, __m256) {
    let inverse = _mm256_div_ps(_mm256_set1_ps(1.0), tested.det);
    let b = three!(c => _mm256_mul_ps(tested.e[c], inverse));
    let z = tested.z;
    let along = _mm256_add_ps(
        _mm256_add_ps(_mm256_mul_ps(b[0], z[0]), _mm256_mul_ps(b[1], z[1])),
        _mm256_mul_ps(b[2], z[2]),
    );
    let t = _mm256_mul_ps(_mm256_set1_ps(sz), along);
    (_mm256_max_ps(t, _mm256_set1_ps(f32::MIN_POSITIVE)), b[1], b[2], along)
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn blocks(block: &Block, lanes: &Lanes, line: &Line, end: End, screen: &Screen) -> bool {
    let Some(tested) = test::<true>(block, lanes) else { return false };
    let pierced = tested.pierced & visible(block, &tested, line);
    let (candidates, doubtful, beyond) = match end {
        _ if pierced == 0 => (0, 0, Beyond::Towards(line.direction)),
        End::Distance(t_max) => {
            let (t, _, _, _) = distances(&tested, line.shear.sz);
            let near = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(t, _mm256_set1_ps(t_max))) as u32;
            (pierced & near, straddling(&tested), Beyond::Towards(line.direction))
        }
        End::Point(target) => {
            let kz = line.shear.kz;
            let end = _mm256_set1_ps((target.to_array()[kz] - line.origin.to_array()[kz]).abs());
            let before = |z: __m256| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(z, end)) as u32;
            let straddling = straddling(&tested) | !before(tested.z_range[1]);
            (pierced & before(tested.z_range[0]), straddling, Beyond::At(target))
        }
    };
    let doubtful = candidates & doubtful;
    candidates != doubtful
        || (doubtful != 0 && doubtful & sides(block, doubtful, line.origin, beyond) != 0)
        || bits(tested.unsure).any(|i| block.blocks(i, line, end, screen))
}

/// Lanes that do not meet the back of a one-sided triangle.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn visible(block: &Block, tested: &Tested, line: &Line) -> u32 {
    let negative = if line.shear.negative { u32::MAX } else { 0 };
    let front = positive(tested) ^ negative ^ u32::from(block.mirrored);
    front | !u32::from(block.culled)
}

/// Triangles met ahead of the origin, at least among `mask`. Where the height of the meeting leaves no doubt it tells.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn ahead(block: &Block, lanes: &Lanes, tested: &Tested, along: __m256, mask: u32, line: &Line) -> u32 {
    let size = _mm256_andnot_ps(_mm256_set1_ps(-0.0), _mm256_mul_ps(along, tested.det));
    let sure = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(size, lanes.doubt)) as u32;
    let front = !_mm256_movemask_ps(_mm256_xor_ps(along, lanes.sign)) as u32;
    let rest = mask & !sure & straddling(tested);
    let exact = if rest == 0 { 0 } else { sides(block, rest, line.origin, Beyond::Towards(line.direction)) };
    (sure & front) | (rest & exact)
}

/// Where the other side of a plane is looked for.
#[derive(Clone, Copy)]
enum Beyond {
    Towards(Vec3),
    At(Vec3),
}

/// Triangles whose planes lie between the origin and there: [`in_front`] and [`separates`] for four lanes at once, at
/// least for those of `mask`.
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn sides(block: &Block, mask: u32, origin: Vec3, beyond: Beyond) -> u32 {
    let mut between = 0;
    for half in [0, 4] {
        if mask >> half & 0b1111 == 0 {
            continue;
        }
        let at = |k: usize| {
            // SAFETY: four f32 from the first or the fifth of eight.
            _mm256_cvtps_pd(unsafe { _mm_loadu_ps(block.corners[k].as_ptr().add(half)) })
        };
        let a = [at(0), at(1), at(2)];
        let e = three!(k => _mm256_sub_pd(at(3 + k), a[k]));
        let f = three!(k => _mm256_sub_pd(at(6 + k), a[k]));
        let cross = |i: usize, j: usize| _mm256_sub_pd(_mm256_mul_pd(e[i], f[j]), _mm256_mul_pd(e[j], f[i]));
        let normal = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let from = |p: Vec3| three!(k => _mm256_sub_pd(a[k], _mm256_set1_pd(f64::from(p[k]))));
        let height = dot(normal, from(origin));
        // Both signs of one product are asked for without multiplying, which might underflow.
        let same = |a: __m256d, b: __m256d| {
            let zero = _mm256_setzero_pd();
            let both = |x, y| _mm256_and_pd(x, y);
            let above = both(_mm256_cmp_pd::<_CMP_GT_OQ>(a, zero), _mm256_cmp_pd::<_CMP_GT_OQ>(b, zero));
            let below = both(_mm256_cmp_pd::<_CMP_LT_OQ>(a, zero), _mm256_cmp_pd::<_CMP_LT_OQ>(b, zero));
            _mm256_movemask_pd(_mm256_or_pd(above, below)) as u32
        };
        between |= (match beyond {
            Beyond::Towards(d) => same(height, dot(normal, three!(k => _mm256_set1_pd(f64::from(d[k]))))),
            Beyond::At(target) => {
                same(height, _mm256_xor_pd(dot(normal, from(target)), _mm256_set1_pd(-0.0)))
            }
        }) << half;
    }
    between
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn dot(a: [__m256d; 3], b: [__m256d; 3]) -> __m256d {
    _mm256_add_pd(
        _mm256_add_pd(_mm256_mul_pd(a[0], b[0]), _mm256_mul_pd(a[1], b[1])),
        _mm256_mul_pd(a[2], b[2]),
    )
}

/// Lanes with a corner not ahead of the origin.
#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn straddling(tested: &Tested) -> u32 {
    !_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(tested.z_range[0], _mm256_setzero_ps())) as u32
}

#[inline]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn positive(tested: &Tested) -> u32 {
    !_mm256_movemask_ps(tested.det) as u32
}

fn bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        (mask != 0).then(|| {
            let i = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            i
        })
    })
}
