//! One ray against eight boxes or eight triangles at once with AVX2 [Wald et al. 2014]. Same operations in the same
//! order as `triangle.rs`, none of them fused, so the bits are the same; lanes that need f64 go there.
//! Unsafe here: loads and stores through references of the right size, and stack entries that were written.

use super::triangle::{Crossing, Plane, TINY, in_front, separates};
use super::{Best, Block, End, Hierarchy, LEAF, Placed, Prepared, STACK, Slab, Tree, WIDTH};
use std::arch::x86_64::*;
use std::mem::MaybeUninit;

#[target_feature(enable = "avx2")]
pub(super) fn closest(tree: &Tree, ray: &Prepared, placed: Option<&Placed>, best: &mut Best) {
    let lanes = Lanes::new(ray);
    walk(&tree.hierarchy, &ray.slab, best.t, |leaf| {
        let block = &tree.blocks[leaf as usize];
        let moved;
        let block = match placed {
            Some(place) => {
                moved = block.placed(place);
                &moved
            }
            None => block,
        };
        offer(block, &lanes, ray, best);
        best.t
    });
}

#[target_feature(enable = "avx2")]
pub(super) fn occluded(tree: &Tree, ray: &Prepared, end: End, placed: Option<&Placed>) -> bool {
    let lanes = Lanes::new(ray);
    let t_max = match end {
        End::Distance(t) => t,
        End::Point(_) => 1.0,
    };
    let mut hit = false;
    walk(&tree.hierarchy, &ray.slab, t_max, |leaf| {
        let block = &tree.blocks[leaf as usize];
        let moved;
        let block = match placed {
            Some(place) => {
                moved = block.placed(place);
                &moved
            }
            None => block,
        };
        hit = blocks(block, &lanes, ray, end);
        if hit { f32::NEG_INFINITY } else { t_max }
    });
    hit
}

/// `portable::walk`, eight boxes at a time.
#[inline]
#[target_feature(enable = "avx2")]
fn walk(hierarchy: &Hierarchy, slab: &Slab, t_max: f32, mut visit: impl FnMut(u32) -> f32) {
    if hierarchy.nodes.is_empty() {
        return;
    }
    let mut stack = [MaybeUninit::<(u32, f32)>::uninit(); STACK];
    let mut depth = 0;
    let mut limit = t_max + slab.slack;
    let upper_first = slab.inverse.map(|i| usize::from(i < 0.0));
    let inverse = slab.inverse.map(|i| _mm256_set1_ps(i));
    let near_origin = [0, 1, 2].map(|a| _mm256_set1_ps(slab.origin[upper_first[a]][a]));
    let far_origin = [0, 1, 2].map(|a| _mm256_set1_ps(slab.origin[1 - upper_first[a]][a]));
    let stretch = _mm256_set1_ps(super::slab::STRETCH);
    let mut child = 0;
    loop {
        if child & LEAF != 0 {
            limit = visit(child & !LEAF) + slab.slack;
        } else {
            let node = &hierarchy.nodes[child as usize];
            let mut enter = _mm256_setzero_ps();
            let mut leave = _mm256_set1_ps(f32::INFINITY);
            for a in 0..3 {
                let near = load(&node.bounds[a + 3 * upper_first[a]]);
                let far = load(&node.bounds[a + 3 * (1 - upper_first[a])]);
                enter = _mm256_max_ps(_mm256_mul_ps(_mm256_sub_ps(near, near_origin[a]), inverse[a]), enter);
                leave = _mm256_min_ps(_mm256_mul_ps(_mm256_sub_ps(far, far_origin[a]), inverse[a]), leave);
            }
            leave = _mm256_min_ps(_mm256_mul_ps(leave, stretch), _mm256_set1_ps(limit));
            let mut hits = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave)) as u32;
            if hits != 0 {
                let nearest = hits.trailing_zeros() as usize;
                hits &= hits - 1;
                child = node.child[nearest];
                if hits == 0 {
                    continue;
                }
                let enter = store(enter);
                let mut current = (child, enter[nearest]);
                let first = depth;
                while hits != 0 {
                    let i = hits.trailing_zeros() as usize;
                    hits &= hits - 1;
                    let mut entry = (node.child[i], enter[i]);
                    if entry.1 < current.1 {
                        std::mem::swap(&mut entry, &mut current);
                    }
                    let mut at = depth;
                    // SAFETY: entries below `depth` were written.
                    while at > first && unsafe { stack[at - 1].assume_init() }.1 < entry.1 {
                        stack[at] = stack[at - 1];
                        at -= 1;
                    }
                    stack[at].write(entry);
                    depth += 1;
                }
                child = current.0;
                continue;
            }
        }
        loop {
            if depth == 0 {
                return;
            }
            depth -= 1;
            // SAFETY: entries below the old `depth` were written.
            let (next, enter) = unsafe { stack[depth].assume_init() };
            if enter <= limit {
                child = next;
                break;
            }
        }
    }
}

#[inline]
#[target_feature(enable = "avx2")]
fn load(a: &[f32; WIDTH]) -> __m256 {
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_loadu_ps(a.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx2")]
fn store(a: __m256) -> [f32; WIDTH] {
    let mut out = [0.0; WIDTH];
    // SAFETY: the reference is valid for eight f32.
    unsafe { _mm256_storeu_ps(out.as_mut_ptr(), a) };
    out
}

/// The ray in all lanes, axes in the order of its shear.
struct Lanes {
    axes: [usize; 3],
    origin: [__m256; 3],
    sx: __m256,
    sy: __m256,
    /// Sign bit of the direction along kz.
    sign: __m256,
}

impl Lanes {
    #[inline]
    #[target_feature(enable = "avx2")]
    fn new(ray: &Prepared) -> Lanes {
        let s = &ray.line.shear;
        let axes = [s.kx, s.ky, s.kz];
        Lanes {
            axes,
            origin: axes.map(|a| _mm256_set1_ps(ray.line.origin[a])),
            sx: _mm256_set1_ps(s.sx),
            sy: _mm256_set1_ps(s.sy),
            sign: _mm256_set1_ps(if s.negative { -0.0 } else { 0.0 }),
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
    /// Lanes pierced for certain, and lanes that need f64 to tell.
    pierced: u32,
    unsure: u32,
}

/// A copy for each of its two callers (`ANY` or closest hit), so that it is inlined: the registers stay where they are.
#[inline]
#[target_feature(enable = "avx2")]
fn test<const ANY: bool>(block: &Block, lanes: &Lanes) -> Tested {
    let p = |c: usize, k: usize| _mm256_sub_ps(load(&block.corners[3 * c + lanes.axes[k]]), lanes.origin[k]);
    let z = [p(0, 2), p(1, 2), p(2, 2)];
    let x = [0, 1, 2].map(|c| _mm256_sub_ps(p(c, 0), _mm256_mul_ps(lanes.sx, z[c])));
    let y = [0, 1, 2].map(|c| _mm256_sub_ps(p(c, 1), _mm256_mul_ps(lanes.sy, z[c])));
    let edge = |b: usize, c: usize| _mm256_sub_ps(_mm256_mul_ps(x[b], y[c]), _mm256_mul_ps(y[b], x[c]));
    let e = [edge(2, 1), edge(0, 2), edge(1, 0)];
    let zero = _mm256_setzero_ps();
    let least = _mm256_min_ps(_mm256_min_ps(e[0], e[1]), e[2]);
    let most = _mm256_max_ps(_mm256_max_ps(e[0], e[1]), e[2]);
    let opposed =
        _mm256_and_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(least, zero), _mm256_cmp_ps::<_CMP_GT_OQ>(most, zero));
    let det = _mm256_add_ps(_mm256_add_ps(e[0], e[1]), e[2]);
    let size = _mm256_andnot_ps(_mm256_set1_ps(-0.0), det);
    let none = |a: __m256| _mm256_cmp_ps::<_CMP_EQ_OQ>(a, zero);
    let unsure = _mm256_or_ps(
        _mm256_or_ps(none(e[0]), none(e[1])),
        _mm256_or_ps(none(e[2]), _mm256_cmp_ps::<_CMP_LT_OQ>(size, _mm256_set1_ps(TINY))),
    );
    let ahead = z.map(|z| _mm256_xor_ps(z, lanes.sign));
    let z_range = [
        _mm256_min_ps(_mm256_min_ps(ahead[0], ahead[1]), ahead[2]),
        _mm256_max_ps(_mm256_max_ps(ahead[0], ahead[1]), ahead[2]),
    ];
    // Ordered: false for NaN, which fills unused places.
    let ahead = _mm256_cmp_ps::<_CMP_GT_OQ>(z_range[1], zero);
    let possible = _mm256_movemask_ps(_mm256_andnot_ps(opposed, ahead)) as u32;
    let unsure = _mm256_movemask_ps(unsure) as u32;
    Tested { e, det, z, z_range, pierced: possible & !unsure, unsure: possible & unsure }
}

#[inline]
#[target_feature(enable = "avx2")]
fn offer(block: &Block, lanes: &Lanes, ray: &Prepared, best: &mut Best) {
    let tested = test::<false>(block, lanes);
    if tested.pierced != 0 {
        let (t, u, v) = distances(&tested, ray.line.shear.sz);
        let near = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(t, _mm256_set1_ps(best.t))) as u32;
        let candidates = tested.pierced & near;
        if candidates != 0 {
            let straddling = straddling(&tested);
            let positive = positive(&tested);
            let (t, u, v) = (store(t), store(u), store(v));
            for i in bits(candidates) {
                let front = (positive >> i & 1 == 1) != ray.line.shear.negative;
                let plane = || in_front(&Plane::new(&block.corners(i), ray.line.origin), ray.line.direction);
                if t[i] <= best.t && !block.passes(i, front) && (straddling >> i & 1 == 0 || plane()) {
                    let crossing = Crossing { t: t[i], u: u[i], v: v[i] };
                    best.offer(crossing, block.instance[i], block.triangle[i]);
                }
            }
        }
    }
    for i in bits(tested.unsure) {
        block.offer(i, &ray.line, best);
    }
}

/// t and the weights of the second and third corner.
#[inline]
#[target_feature(enable = "avx2")]
fn distances(tested: &Tested, sz: f32) -> (__m256, __m256, __m256) {
    let inverse = _mm256_div_ps(_mm256_set1_ps(1.0), tested.det);
    let b = tested.e.map(|e| _mm256_mul_ps(e, inverse));
    let z = tested.z;
    let along = _mm256_add_ps(
        _mm256_add_ps(_mm256_mul_ps(b[0], z[0]), _mm256_mul_ps(b[1], z[1])),
        _mm256_mul_ps(b[2], z[2]),
    );
    let t = _mm256_mul_ps(_mm256_set1_ps(sz), along);
    (_mm256_max_ps(t, _mm256_set1_ps(f32::MIN_POSITIVE)), b[1], b[2])
}

#[inline]
#[target_feature(enable = "avx2")]
fn blocks(block: &Block, lanes: &Lanes, ray: &Prepared, end: End) -> bool {
    let tested = test::<true>(block, lanes);
    if tested.pierced | tested.unsure == 0 {
        return false;
    }
    let (candidates, clear) = match end {
        End::Distance(t_max) => {
            let (t, _, _) = distances(&tested, ray.line.shear.sz);
            let near = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(t, _mm256_set1_ps(t_max))) as u32;
            (tested.pierced & near, !straddling(&tested))
        }
        End::Point(target) => {
            let kz = ray.line.shear.kz;
            let end = _mm256_set1_ps((target[kz] - ray.line.origin[kz]).abs());
            let before =
                tested.z_range.map(|z| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(z, end)) as u32);
            (tested.pierced & before[0], before[1] & !straddling(&tested))
        }
    };
    let positive = positive(&tested);
    bits(candidates).any(|i| {
        let front = (positive >> i & 1 == 1) != ray.line.shear.negative;
        let plane = || Plane::new(&block.corners(i), ray.line.origin);
        let certain = || match end {
            End::Distance(_) => in_front(&plane(), ray.line.direction),
            End::Point(target) => separates(&plane(), target),
        };
        !block.passes(i, front) && (clear >> i & 1 == 1 || certain())
    }) || bits(tested.unsure).any(|i| block.blocks(i, &ray.line, end))
}

/// Lanes with a corner not ahead of the origin.
#[inline]
#[target_feature(enable = "avx2")]
fn straddling(tested: &Tested) -> u32 {
    !_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(tested.z_range[0], _mm256_setzero_ps())) as u32
}

#[inline]
#[target_feature(enable = "avx2")]
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
