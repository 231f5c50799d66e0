//! Faure's sequence: the digits of the index, as coefficients of a polynomial over the field of b elements, are those of
//! the polynomial shifted by d, mirrored at the point, in dimension d [Faure 1982; Keller96, §4.4].
//! In s dimensions its base b is the first prime from s on; it is then a (0, s)-sequence: any aligned run of bᵐ points has
//! one in each box of volume b⁻ᵐ.

/// Digits that an index of 64 bits has at most, in base 2.
const MOST_DIGITS: usize = 64;

/// The first prime from `s` on, the base for s dimensions: 2 at least.
pub fn base(s: u32) -> u32 {
    let prime = |n: &u32| (2..).take_while(|k| k * k <= *n).all(|k| !n.is_multiple_of(k));
    (s.clamp(2, 65_521)..).find(prime).unwrap_or(2)
}

/// Coordinate `dimension` < `base` of point `i` [0, 1). `base` is a prime below 2¹⁶. The first b⁴ − 1 points are better left
/// out: they fill the diagonals first.
pub fn faure(i: u64, dimension: u32, base: u32) -> f64 {
    let mut digits = [0_u32; MOST_DIGITS];
    let (mut rest, mut count) = (i, 0);
    while rest > 0 {
        digits[count] = (rest % u64::from(base)) as u32;
        rest /= u64::from(base);
        count += 1;
    }
    // Horner's scheme again and again: coefficient k of p(x + d) is Σ C(j, k) dʲ⁻ᵏ aⱼ.
    for low in 0..count {
        for k in (low..count.saturating_sub(1)).rev() {
            digits[k] = (digits[k] + dimension * digits[k + 1]) % base;
        }
    }
    let scale = 1.0 / f64::from(base);
    let value = digits[..count].iter().rev().fold(0.0, |x, digit| (x + f64::from(*digit)) * scale);
    value.min(1.0_f64.next_down())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bases_are_the_first_primes_that_do() {
        let told = [(0, 2), (2, 2), (3, 3), (4, 5), (8, 11), (16, 17), (17, 17), (24, 29), (64, 67)];
        told.iter().for_each(|(s, b)| assert_eq!(base(*s), *b));
    }

    /// Dimension 0 is the radical inverse; in base 3 dimensions 1 and 2 are those of the literature.
    #[test]
    fn first_points() {
        let ninths = |d| (0..9).map(|i| (faure(i, d, 3) * 9.0).round() as u32).collect::<Vec<_>>();
        assert_eq!(ninths(0), [0, 3, 6, 1, 4, 7, 2, 5, 8]);
        assert_eq!(ninths(1), [0, 3, 6, 4, 7, 1, 8, 2, 5]);
        assert_eq!(ninths(2), [0, 3, 6, 7, 1, 4, 5, 8, 2]);
    }

    /// A (0, s)-sequence: every elementary box holds one point of every aligned run.
    #[test]
    fn every_box_has_its_point() {
        for (s, m) in [(2, 6), (3, 4), (5, 3)] {
            let b = base(s);
            let count = u64::from(b).pow(m);
            for run in [0, 1, 7] {
                for (d, e) in (0..s).flat_map(|d| (0..d).map(move |e| (d, e))) {
                    for split in 0..=m {
                        let (across, down) = (u64::from(b).pow(split), u64::from(b).pow(m - split));
                        let mut seen = vec![false; count as usize];
                        for i in run * count..(run + 1) * count {
                            // The tiny summand undoes the rounding of thirds and fifths.
                            let cell = |d, n: u64| (faure(i, d, b) * n as f64 + 1e-9) as u64;
                            seen[(cell(d, across) * down + cell(e, down)) as usize] = true;
                        }
                        assert!(seen.iter().all(|s| *s), "base {b}, run {run}, {d} × {e}, {split}");
                    }
                }
            }
        }
    }
}
