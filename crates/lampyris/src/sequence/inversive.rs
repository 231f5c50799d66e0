//! The explicit inversive congruential generator: xₙ = (a n + b)⁻¹ mod p, over p [Niederreiter 1992; Keller96, §4.4].
//!
//! The modulus is the prime p = 2⁶¹ − 1: beside 2³¹ − 1, which is usual, no experiment comes round to its beginning. The
//! inverse of 0 is 0. By its nature it needs no leaps: it is a function of the index.

/// p.
pub const MODULUS: u64 = (1 << 61) - 1;

/// a: large, since the inverses of small numbers are fractions of small denominators.
const MULTIPLIER: u64 = 0x1E37_79B9_7F4A_7C15;

/// Number `n` in [0, 1); `b` is taken to the modulus, and n goes round with period p.
pub fn inversive(n: u64, b: u64) -> f64 {
    let x = (u128::from(MULTIPLIER) * u128::from(n % MODULUS) + u128::from(b)) % u128::from(MODULUS);
    // Of 61 bits, of which a double keeps 53: cut, so that none becomes 1.
    (inverse(x as u64) >> 8) as f64 / (1_u64 << 53) as f64
}

/// x⁻¹ mod p by Euclid's algorithm; 0 for 0. `x` < p.
fn inverse(x: u64) -> u64 {
    let (mut r, mut s) = ((MODULUS as i64, x as i64), (0_i64, 1_i64));
    while r.1 > 1 {
        let q = r.0 / r.1;
        r = (r.1, r.0 - q * r.1);
        s = (s.1, s.0 - q * s.1);
    }
    if r.1 == 0 { 0 } else { s.1.rem_euclid(MODULUS as i64) as u64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_are_inverse() {
        assert_eq!((inverse(0), inverse(1), inverse(2)), (0, 1, 1 << 60));
        for x in
            (1..3000).chain((1..3000).map(|k| MODULUS - k)).chain((1..3000).map(|k| k * 0x5555_5555_5555))
        {
            let product = u128::from(x) * u128::from(inverse(x)) % u128::from(MODULUS);
            assert_eq!(product, 1, "{x}");
        }
    }

    #[test]
    fn numbers_lie_below_one_and_come_round() {
        for n in [0, 1, 2, MODULUS - 1, u64::MAX] {
            for b in [0, 1, u64::MAX] {
                assert!((0.0..1.0).contains(&inversive(n, b)));
                assert_eq!(inversive(n % MODULUS, b), inversive(n, b));
            }
        }
        // All remainders but 0 have different inverses.
        let some: std::collections::BTreeSet<u64> = (1..5000).map(inverse).collect();
        assert_eq!(some.len(), 4999);
    }
}
