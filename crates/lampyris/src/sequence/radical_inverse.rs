//! The radical inverse Φ_b, which mirrors the digits of a number at the point: direct, incremental and with permuted
//! digits [Keller97, §3.1; HW64].
//! Everything here is one-dimensional; points are made of it in `halton` and `hammersley`.

use super::hash::{hash, round_down, unit_f32};

/// Φ_b(i) = Σ a_j(i) b^(−j−1) in [0, 1), rounded down [Keller97, Fig. 2].
///
/// `base` ≥ 2. The digits are mirrored in integers and divided once, so the value is the exact one cut to 24 bits;
/// the paper's `f = 1/b` with integers is a misprint, and its running sum would round at each digit.
pub fn radical_inverse(base: u32, i: u32) -> f32 {
    round_down(radical_inverse_f64(base, i))
}

/// Φ_b(i) rounded to nearest in double precision, where it still is below 1.
pub fn radical_inverse_f64(base: u32, i: u32) -> f64 {
    if base == 2 {
        return f64::from(i.reverse_bits()) / 4_294_967_296.0;
    }
    let (mut rest, mut mirrored, mut scale) = (i, 0u64, 1u64);
    while rest > 0 {
        mirrored = mirrored * u64::from(base) + u64::from(rest % base);
        scale *= u64::from(base);
        rest /= base;
    }
    mirrored as f64 / scale as f64
}

/// Φ_b(i) of a long index, in [0, 1): rounded digit by digit, from the least on. `base` ≥ 2.
pub fn radical_inverse_u64(base: u32, i: u64) -> f64 {
    let scale = 1.0 / f64::from(base);
    let (mut rest, mut value, mut weight) = (i, 0.0, scale);
    while rest > 0 {
        value += (rest % u64::from(base)) as f64 * weight;
        weight *= scale;
        rest /= u64::from(base);
    }
    value.min(1.0_f64.next_down())
}

/// Φ_b(i + 1) from x = Φ_b(i), without knowing i [Keller97, Fig. 3; HW64].
///
/// It is cheap but has state, and two limits. Rounding accumulates and is never corrected: in base 3 the error is 2e-12
/// after 10⁵ steps, 2e-11 after 10⁶, 2e-7 after 3·10⁷ (base 2 is exact). And the 1e-10 by which a carry is recognised
/// must stay well below the grid b^−m, so it fails beyond some 10⁹ points. [`radical_inverse`] knows neither limit.
pub fn next_radical_inverse(base: u32, x: f64) -> f64 {
    let inverse = 1.0 / f64::from(base);
    let room = 1.0 - x - 1e-10;
    if inverse < room {
        return x + inverse;
    }
    let (mut above, mut h) = (inverse, inverse * inverse);
    while h >= room {
        above = h;
        h *= inverse;
    }
    x + above + h - 1.0
}

/// Φ_b(i) with every digit sent through a random permutation of its own, one for each (seed, base, position).
///
/// The leading zeros count as digits, down to 2⁻³²: they are permuted too, which shifts the whole sequence and frees
/// it of the point 0. In base 2 the permutations are one exclusive-or. `base` ≥ 2.
pub fn scrambled_radical_inverse(base: u32, i: u32, seed: u32) -> f32 {
    if base == 2 {
        return unit_f32(i.reverse_bits() ^ hash(seed, base));
    }
    round_down(scrambled_radical_inverse_f64(base, i, seed))
}

/// [`scrambled_radical_inverse`] in double precision.
pub fn scrambled_radical_inverse_f64(base: u32, i: u32, seed: u32) -> f64 {
    let seed = hash(seed, base);
    if base == 2 {
        return f64::from(i.reverse_bits() ^ seed) / 4_294_967_296.0;
    }
    let (mut rest, mut mirrored, mut scale, mut position) = (i, 0u64, 1u64, 0);
    while scale < 1 << 32 {
        let digit = permute_digit(base, rest % base, hash(seed, position));
        mirrored = mirrored * u64::from(base) + u64::from(digit);
        scale *= u64::from(base);
        rest /= base;
        position += 1;
    }
    mirrored as f64 / scale as f64
}

/// The image of `digit` < `base` under the random permutation of 0 … base − 1 that belongs to `key`.
///
/// A bijection of the next power of two, applied again until the image is a digit: no table is kept.
fn permute_digit(base: u32, digit: u32, key: u32) -> u32 {
    let mask = base.next_power_of_two() - 1;
    let half = (32 - mask.leading_zeros()).div_ceil(2);
    let mut x = digit;
    loop {
        let mut k = key;
        for _ in 0..4 {
            k = hash(k, 0x51ed);
            x = x.wrapping_mul(k | 1).wrapping_add(k >> 16) & mask;
            x ^= x >> half;
        }
        if x < base {
            return x;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_permuted_and_all_permutations_of_three_occur_alike() {
        let mut count = [0u32; 27];
        let seeds = 6000;
        for seed in 0..seeds {
            let p = [0, 1, 2].map(|d| permute_digit(3, d, hash(seed, 1)));
            count[(p[0] * 9 + p[1] * 3 + p[2]) as usize] += 1;
        }
        let seen: Vec<f64> = count.iter().filter(|&&c| c > 0).map(|&c| f64::from(c)).collect();
        assert_eq!(seen.len(), 6);
        let expected = f64::from(seeds) / 6.0;
        let chi2: f64 = seen.iter().map(|c| (c - expected) * (c - expected) / expected).sum();
        assert!(chi2 < 20.5, "χ² of 5 degrees of freedom at level 0.001: {chi2}");
        for base in [5, 7, 53, 311] {
            let mut seen = vec![false; base as usize];
            (0..base).for_each(|d| seen[permute_digit(base, d, 99) as usize] = true);
            assert!(seen.iter().all(|&s| s));
        }
    }
}
