//! The Halton sequence: Φ of the d-th prime in dimension d, plain, with scrambled digits, or jittered in its cells
//! [Keller97, §3.1, §4.1].
//! Beyond [`DIMENSIONS`] there are no primes left here and the numbers are plain random ones.

use super::hash::{round_down, uniform};
use super::radical_inverse::{radical_inverse, radical_inverse_f64, scrambled_radical_inverse};

/// Number of dimensions with a prime of their own.
pub const DIMENSIONS: u32 = PRIMES.len() as u32;

const PRIMES: [u32; 64] = {
    let mut primes = [2; 64];
    let (mut found, mut candidate) = (1, 3);
    while found < primes.len() {
        let mut k = 0;
        while k < found && candidate % primes[k] != 0 {
            k += 1;
        }
        if k == found {
            primes[found] = candidate;
            found += 1;
        }
        candidate += 2;
    }
    primes
};

/// The prime of a dimension, where there is one.
pub fn base(dimension: u32) -> Option<u32> {
    PRIMES.get(dimension as usize).copied()
}

/// Φ of the dimension's prime. Above about 14 dimensions neighbouring ones are visibly correlated (17 and 19 are
/// collinear for 16 points): there take [`scrambled_halton`].
pub fn halton(i: u32, dimension: u32) -> f32 {
    base(dimension).map_or_else(|| uniform(0, i, dimension), |b| radical_inverse(b, i))
}

/// As [`halton`] with permuted digits, the permutations drawn by `seed`.
pub fn scrambled_halton(i: u32, dimension: u32, seed: u32) -> f32 {
    base(dimension).map_or_else(|| uniform(seed, i, dimension), |b| scrambled_radical_inverse(b, i, seed))
}

/// The Halton point moved at random within its cell, of size b⁻ᵐ with bᵐ⁻¹ < n ≤ bᵐ [Keller97, §4.1].
///
/// `n` ≥ 1 is the number of points that belong together: for bounce j of the quasi-random walk ⌈ρ̄ʲN⌉. For i < n this
/// is the paper's Φ_b + ξ b⁻ᵐ; later points take the cell that they lie in, so every aligned run of bᵐ points has one
/// in each cell, and none leaves [0, 1).
pub fn jittered_halton(i: u32, dimension: u32, n: u32, seed: u32) -> f32 {
    let xi = uniform(seed, i, dimension);
    base(dimension).map_or(xi, |b| {
        let mut cells = 1u64;
        while cells < u64::from(n) {
            cells *= u64::from(b);
        }
        // The lowest m digits of i name the cell.
        let cell = radical_inverse_f64(b, (u64::from(i) % cells) as u32);
        round_down(cell + f64::from(xi) / cells as f64).min(1.0f32.next_down())
    })
}
