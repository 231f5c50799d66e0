//! Sixteen numbers at once by AVX-512, or by AVX2 in two halves: what `simd_packet.rs` and `simd_block.rs` are
//! written in. No operation is fused, so both give the bits of plain Rust.
//! Unsafe here: instructions that a token of the machine stands for, and loads and stores through references of the
//! right size.

use crate::geometry::packet::LANES;
use std::arch::x86_64::*;

/// Eight numbers; both machines have them.
pub(super) type F8 = __m256;

/// A machine that is known to be there: its instructions on sixteen lanes. Comparisons are false for NaN; minima and
/// maxima yield their second operand then.
pub(super) trait Machine: Copy {
    /// Sixteen f32.
    type F: Copy;

    fn splat(self, x: f32) -> Self::F;
    fn load(self, from: &[f32; LANES]) -> Self::F;
    fn store(self, to: &mut [f32; LANES], a: Self::F);
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    fn div(self, a: Self::F, b: Self::F) -> Self::F;
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    fn max(self, a: Self::F, b: Self::F) -> Self::F;
    fn abs(self, a: Self::F) -> Self::F;
    /// The sizes of `a` with the signs of `b`.
    fn copysign(self, a: Self::F, b: Self::F) -> Self::F;
    fn lt(self, a: Self::F, b: Self::F) -> u16;
    fn le(self, a: Self::F, b: Self::F) -> u16;
    fn eq(self, a: Self::F, b: Self::F) -> u16;
    /// Lanes of `a` where the mask is set, of `b` elsewhere.
    fn blend(self, mask: u16, a: Self::F, b: Self::F) -> Self::F;
    /// Puts `a` into the lanes where the mask is set.
    fn blend_u32(self, mask: u16, a: u32, to: &mut [u32; LANES]);
    /// The smallest lane.
    fn least(self, a: Self::F) -> f32;
    /// The largest lane.
    fn most(self, a: Self::F) -> f32;
    /// Lanes where `normal · (from − point)` is above zero, and where it is below, in f64.
    fn sides(self, normal: [f64; 3], from: [f64; 3], points: &[[f32; LANES]; 3]) -> [u16; 2];
    /// The same machine for eight numbers.
    fn eight(self) -> Avx2;
}

/// Instructions that a token stands for.
macro_rules! known {
    ($call:expr) => {
        // SAFETY: whoever made the token knew that the machine has the instructions; references are of the right size.
        unsafe { $call }
    };
}

/// Proof of AVX-512 F, VL, DQ, BW and of what they imply.
#[derive(Clone, Copy)]
pub(super) struct Avx512(());

/// Proof of AVX2.
#[derive(Clone, Copy)]
pub(super) struct Avx2(());

impl Avx512 {
    /// # Safety
    /// The machine must have the instructions.
    #[inline(always)]
    pub(super) unsafe fn new() -> Avx512 {
        Avx512(())
    }
}

impl Avx2 {
    /// # Safety
    /// The machine must have the instructions.
    #[inline(always)]
    pub(super) unsafe fn new() -> Avx2 {
        Avx2(())
    }
}

impl Machine for Avx512 {
    type F = __m512;

    #[inline(always)]
    fn splat(self, x: f32) -> __m512 {
        known!(_mm512_set1_ps(x))
    }
    #[inline(always)]
    fn load(self, from: &[f32; LANES]) -> __m512 {
        known!(_mm512_loadu_ps(from.as_ptr()))
    }
    #[inline(always)]
    fn store(self, to: &mut [f32; LANES], a: __m512) {
        known!(_mm512_storeu_ps(to.as_mut_ptr(), a))
    }
    #[inline(always)]
    fn add(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_add_ps(a, b))
    }
    #[inline(always)]
    fn sub(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_mul_ps(a, b))
    }
    #[inline(always)]
    fn div(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_div_ps(a, b))
    }
    #[inline(always)]
    fn min(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_min_ps(a, b))
    }
    #[inline(always)]
    fn max(self, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_max_ps(a, b))
    }
    #[inline(always)]
    fn abs(self, a: __m512) -> __m512 {
        known!(_mm512_abs_ps(a))
    }
    #[inline(always)]
    fn copysign(self, a: __m512, b: __m512) -> __m512 {
        let sign = self.splat(-0.0);
        known!(_mm512_or_ps(_mm512_andnot_ps(sign, a), _mm512_and_ps(sign, b)))
    }
    #[inline(always)]
    fn lt(self, a: __m512, b: __m512) -> u16 {
        known!(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b))
    }
    #[inline(always)]
    fn le(self, a: __m512, b: __m512) -> u16 {
        known!(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b))
    }
    #[inline(always)]
    fn eq(self, a: __m512, b: __m512) -> u16 {
        known!(_mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, b))
    }
    #[inline(always)]
    fn blend(self, mask: u16, a: __m512, b: __m512) -> __m512 {
        known!(_mm512_mask_blend_ps(mask, b, a))
    }
    #[inline(always)]
    fn blend_u32(self, mask: u16, a: u32, to: &mut [u32; LANES]) {
        known!(_mm512_mask_storeu_epi32(to.as_mut_ptr().cast(), mask, _mm512_set1_epi32(a as i32)))
    }
    #[inline(always)]
    fn least(self, a: __m512) -> f32 {
        let halves = known!((_mm512_castps512_ps256(a), _mm512_extractf32x8_ps::<1>(a)));
        let eight = self.eight();
        eight.least8(eight.min8(halves.0, halves.1))
    }
    #[inline(always)]
    fn most(self, a: __m512) -> f32 {
        let halves = known!((_mm512_castps512_ps256(a), _mm512_extractf32x8_ps::<1>(a)));
        let eight = self.eight();
        eight.most8(eight.max8(halves.0, halves.1))
    }
    #[inline(always)]
    fn sides(self, normal: [f64; 3], from: [f64; 3], points: &[[f32; LANES]; 3]) -> [u16; 2] {
        let mut sides = [0; 2];
        for half in [0, 8] {
            // Eight f32 from the first or the ninth of sixteen.
            let point =
                three!(a => known!(_mm512_cvtps_pd(_mm256_loadu_ps(points[a].as_ptr().wrapping_add(half)))));
            let term = three!(a => known!(
                _mm512_mul_pd(_mm512_set1_pd(normal[a]), _mm512_sub_pd(_mm512_set1_pd(from[a]), point[a]))
            ));
            let sum = known!(_mm512_add_pd(_mm512_add_pd(term[0], term[1]), term[2]));
            let zero = known!(_mm512_setzero_pd());
            sides[0] |= u16::from(known!(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(sum, zero))) << half;
            sides[1] |= u16::from(known!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(sum, zero))) << half;
        }
        sides
    }
    #[inline(always)]
    fn eight(self) -> Avx2 {
        Avx2(())
    }
}

/// Both halves by one operation on eight.
macro_rules! halves {
    ($operation:ident($($a:expr),+)) => {
        (known!($operation($($a.0),+)), known!($operation($($a.1),+)))
    };
}

/// Both halves of a comparison as one mask.
macro_rules! compared {
    ($predicate:ident($a:expr, $b:expr)) => {{
        let low = known!(_mm256_movemask_ps(_mm256_cmp_ps::<$predicate>($a.0, $b.0)));
        let high = known!(_mm256_movemask_ps(_mm256_cmp_ps::<$predicate>($a.1, $b.1)));
        (low | high << 8) as u16
    }};
}

impl Machine for Avx2 {
    type F = (__m256, __m256);

    #[inline(always)]
    fn splat(self, x: f32) -> Self::F {
        (self.splat8(x), self.splat8(x))
    }
    #[inline(always)]
    fn load(self, from: &[f32; LANES]) -> Self::F {
        known!((_mm256_loadu_ps(from.as_ptr()), _mm256_loadu_ps(from.as_ptr().add(8))))
    }
    #[inline(always)]
    fn store(self, to: &mut [f32; LANES], a: Self::F) {
        known!({
            _mm256_storeu_ps(to.as_mut_ptr(), a.0);
            _mm256_storeu_ps(to.as_mut_ptr().add(8), a.1);
        })
    }
    #[inline(always)]
    fn add(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_add_ps(a, b))
    }
    #[inline(always)]
    fn sub(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_mul_ps(a, b))
    }
    #[inline(always)]
    fn div(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_div_ps(a, b))
    }
    #[inline(always)]
    fn min(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_min_ps(a, b))
    }
    #[inline(always)]
    fn max(self, a: Self::F, b: Self::F) -> Self::F {
        halves!(_mm256_max_ps(a, b))
    }
    #[inline(always)]
    fn abs(self, a: Self::F) -> Self::F {
        let sign = self.splat(-0.0);
        halves!(_mm256_andnot_ps(sign, a))
    }
    #[inline(always)]
    fn copysign(self, a: Self::F, b: Self::F) -> Self::F {
        let sign = self.splat(-0.0);
        let (positive, negative) = (halves!(_mm256_andnot_ps(sign, a)), halves!(_mm256_or_ps(sign, a)));
        halves!(_mm256_blendv_ps(positive, negative, b))
    }
    #[inline(always)]
    fn lt(self, a: Self::F, b: Self::F) -> u16 {
        compared!(_CMP_LT_OQ(a, b))
    }
    #[inline(always)]
    fn le(self, a: Self::F, b: Self::F) -> u16 {
        compared!(_CMP_LE_OQ(a, b))
    }
    #[inline(always)]
    fn eq(self, a: Self::F, b: Self::F) -> u16 {
        compared!(_CMP_EQ_OQ(a, b))
    }
    #[inline(always)]
    fn blend(self, mask: u16, a: Self::F, b: Self::F) -> Self::F {
        let chosen = (self.chosen8(mask), self.chosen8(mask >> 8));
        halves!(_mm256_blendv_ps(b, a, chosen))
    }
    #[inline(always)]
    fn blend_u32(self, mask: u16, a: u32, to: &mut [u32; LANES]) {
        known!({
            let (low, high) = (to.as_mut_ptr().cast(), to.as_mut_ptr().add(8).cast());
            let a = _mm256_set1_epi32(a as i32);
            _mm256_maskstore_epi32(low, _mm256_castps_si256(self.chosen8(mask)), a);
            _mm256_maskstore_epi32(high, _mm256_castps_si256(self.chosen8(mask >> 8)), a);
        })
    }
    #[inline(always)]
    fn least(self, a: Self::F) -> f32 {
        self.least8(self.min8(a.0, a.1))
    }
    #[inline(always)]
    fn most(self, a: Self::F) -> f32 {
        self.most8(self.max8(a.0, a.1))
    }
    #[inline(always)]
    fn sides(self, normal: [f64; 3], from: [f64; 3], points: &[[f32; LANES]; 3]) -> [u16; 2] {
        let mut sides = [0; 2];
        for quarter in [0, 4, 8, 12] {
            // Four f32 from every fourth of sixteen.
            let point =
                three!(a => known!(_mm256_cvtps_pd(_mm_loadu_ps(points[a].as_ptr().wrapping_add(quarter)))));
            let term = three!(a => known!(
                _mm256_mul_pd(_mm256_set1_pd(normal[a]), _mm256_sub_pd(_mm256_set1_pd(from[a]), point[a]))
            ));
            let sum = known!(_mm256_add_pd(_mm256_add_pd(term[0], term[1]), term[2]));
            let zero = known!(_mm256_setzero_pd());
            let above = known!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(sum, zero)));
            let below = known!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(sum, zero)));
            sides[0] |= (above as u16) << quarter;
            sides[1] |= (below as u16) << quarter;
        }
        sides
    }
    #[inline(always)]
    fn eight(self) -> Avx2 {
        self
    }
}

/// Eight lanes.
impl Avx2 {
    /// Brings the cache lines of a value near, if there is one: the pointer may be any.
    #[inline(always)]
    pub(super) fn prefetch<T>(self, at: *const T) {
        for line in 0..size_of::<T>().div_ceil(64) {
            known!(_mm_prefetch::<_MM_HINT_T0>(at.cast::<i8>().wrapping_add(64 * line)));
        }
    }
    /// All bits of the lanes set in the lower half of a mask.
    #[inline(always)]
    fn chosen8(self, mask: u16) -> F8 {
        known!({
            let lanes = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let mask = _mm256_set1_epi32(i32::from(mask));
            _mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_and_si256(mask, lanes), lanes))
        })
    }
    #[inline(always)]
    pub(super) fn splat8(self, x: f32) -> F8 {
        known!(_mm256_set1_ps(x))
    }
    #[inline(always)]
    pub(super) fn load8(self, from: &[f32; 8]) -> F8 {
        known!(_mm256_loadu_ps(from.as_ptr()))
    }
    #[inline(always)]
    pub(super) fn store8(self, to: &mut [f32; 8], a: F8) {
        known!(_mm256_storeu_ps(to.as_mut_ptr(), a))
    }
    #[inline(always)]
    pub(super) fn sub8(self, a: F8, b: F8) -> F8 {
        known!(_mm256_sub_ps(a, b))
    }
    #[inline(always)]
    pub(super) fn mul8(self, a: F8, b: F8) -> F8 {
        known!(_mm256_mul_ps(a, b))
    }
    #[inline(always)]
    pub(super) fn min8(self, a: F8, b: F8) -> F8 {
        known!(_mm256_min_ps(a, b))
    }
    #[inline(always)]
    pub(super) fn max8(self, a: F8, b: F8) -> F8 {
        known!(_mm256_max_ps(a, b))
    }
    #[inline(always)]
    pub(super) fn xor8(self, a: F8, b: F8) -> F8 {
        known!(_mm256_xor_ps(a, b))
    }
    #[inline(always)]
    pub(super) fn le8(self, a: F8, b: F8) -> u8 {
        known!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b))) as u8
    }
    #[inline(always)]
    pub(super) fn lt8(self, a: F8, b: F8) -> u8 {
        known!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b))) as u8
    }
    #[inline(always)]
    fn least8(self, a: F8) -> f32 {
        known!({
            let a = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
            let a = _mm_min_ps(a, _mm_movehl_ps(a, a));
            _mm_cvtss_f32(_mm_min_ss(a, _mm_shuffle_ps::<1>(a, a)))
        })
    }
    #[inline(always)]
    fn most8(self, a: F8) -> f32 {
        known!({
            let a = _mm_max_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
            let a = _mm_max_ps(a, _mm_movehl_ps(a, a));
            _mm_cvtss_f32(_mm_max_ss(a, _mm_shuffle_ps::<1>(a, a)))
        })
    }
}
