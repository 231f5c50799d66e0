//! Plain Rust compiled once for each [`Kernel`] and chosen while running: loops over the lanes of a packet fill the
//! vectors that the machine has, with no change of a bit, for the compiler may neither reorder nor fuse arithmetic.
//! Unsafe here: calls of functions for instructions that the machine was found to have.

use super::{Kernel, LANES};

/// Work worth compiling for each kernel: a struct of borrowed inputs, consumed by `run`.
///
/// Mark `run` and what it calls in its loops `#[inline(always)]`: what is not inlined keeps the instructions that every
/// machine has. Of zeros of two signs `f32::min` and `f32::max` may return either, then and now; compare instead where
/// the sign shows.
pub trait Wide {
    /// What the work yields.
    type Out;

    /// Does the work.
    fn run(self) -> Self::Out;
}

impl Kernel {
    /// Does the work with the instructions of this kernel; if the machine lacks it, of the best it has.
    #[inline]
    pub fn run<W: Wide>(self, work: W) -> W::Out {
        match self.min(Kernel::detect()) {
            Kernel::Portable => work.run(),
            // SAFETY: a kernel not above the detected one is there.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2 => unsafe { avx2(work) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx512 => unsafe { avx512(work) },
            #[cfg(not(target_arch = "x86_64"))]
            _ => work.run(),
        }
    }
}

/// The sum over all lanes, in halves: an order that vectors keep.
#[inline(always)]
pub(crate) fn sum_of_lanes(values: &[f32; LANES]) -> f32 {
    let eight: [f32; 8] = std::array::from_fn(|k| values[k] + values[k + 8]);
    let four: [f32; 4] = std::array::from_fn(|k| eight[k] + eight[k + 4]);
    (four[0] + four[2]) + (four[1] + four[3])
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi1,popcnt")]
fn avx2<W: Wide>(work: W) -> W::Out {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,bmi1,popcnt")]
fn avx512<W: Wide>(work: W) -> W::Out {
    work.run()
}

/// Lanes above zero. Ask it of what [`Wide`] work returns: within, it would narrow the vectors that lead to it.
#[inline]
pub fn positive(values: &[f32; LANES]) -> u16 {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: every machine of the architecture has these instructions.
    return unsafe { sse2_positive(values) };
    #[cfg(not(target_arch = "x86_64"))]
    return (0..LANES).fold(0, |mask, k| mask | u16::from(values[k] > 0.0) << k);
}

#[cfg(target_arch = "x86_64")]
#[inline]
#[target_feature(enable = "sse2")]
fn sse2_positive(v: &[f32; LANES]) -> u16 {
    use std::arch::x86_64::*;
    let four = |i: usize| {
        let above = _mm_cmpgt_ps(_mm_setr_ps(v[i], v[i + 1], v[i + 2], v[i + 3]), _mm_setzero_ps());
        _mm_castps_si128(above)
    };
    let eight = |i: usize| _mm_packs_epi32(four(i), four(i + 4));
    _mm_movemask_epi8(_mm_packs_epi16(eight(0), eight(8))) as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::uniform;

    /// Sums of products, which fusing would round once instead of twice, a quotient, a root and a mask.
    struct Terms<'a> {
        x: &'a [[f32; LANES]; 3],
        n: [f32; 3],
    }

    impl Wide for Terms<'_> {
        type Out = ([f32; LANES], u16);

        #[inline(always)]
        fn run(self) -> ([f32; LANES], u16) {
            let ([x, y, z], n) = (self.x, self.n);
            let mut out = [0.0; LANES];
            for k in 0..LANES {
                let d2 = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
                let cos = x[k] * n[0] + y[k] * n[1] + z[k] * n[2];
                out[k] = cos / (d2 * d2.sqrt());
            }
            (out, (0..LANES).fold(0, |above, k| above | u16::from(out[k] > 0.5) << k))
        }
    }

    #[test]
    fn positive_lanes_are_those_above_zero() {
        let numbers = [0.0, -0.0, 1.0, -1.0, f32::NAN, f32::INFINITY, -f32::INFINITY, 1e-45, -1e-45];
        for i in 0..1000 {
            let draw = |k: usize| numbers[(uniform(3, i, k as u32) * numbers.len() as f32) as usize];
            let values: [f32; LANES] = std::array::from_fn(draw);
            let mask = positive(&values);
            for (k, value) in values.iter().enumerate() {
                assert_eq!(mask >> k & 1 == 1, *value > 0.0, "{value}");
            }
        }
    }

    #[test]
    fn kernels_agree_to_the_bit() {
        let kernels = [Kernel::Portable, Kernel::Avx2, Kernel::Avx512];
        let mut some_fuse = false;
        for i in 0..2000 {
            let number = |k: u32| (uniform(7, i, k) - 0.5) * libm::exp2f(40.0 * (uniform(8, i, k) - 0.5));
            let x = [0, 1, 2].map(|a| std::array::from_fn(|k| number(16 * a + k as u32)));
            let n = [50, 51, 52].map(number);
            let plain = Terms { x: &x, n }.run();
            for kernel in kernels {
                let (out, above) = kernel.run(Terms { x: &x, n });
                assert_eq!(out.map(f32::to_bits), plain.0.map(f32::to_bits), "{kernel:?}");
                assert_eq!(above, plain.1, "{kernel:?}");
            }
            // The numbers are such that fusing would show.
            let exact = f64::from(x[0][0]) * f64::from(n[0]) + f64::from(x[1][0] * n[1]);
            some_fuse |= exact as f32 != x[0][0] * n[0] + x[1][0] * n[1];
        }
        assert!(some_fuse);
    }
}
