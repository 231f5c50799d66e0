//! The linear congruential generator of `drand48`: Xₙ₊₁ = (a Xₙ + c) mod 2⁴⁸, with leaps [Keller96, §4.4].
//! It stands for the random numbers of the papers; nothing else here is made of it.

/// a, as POSIX fixes it.
const MULTIPLIER: u64 = 0x5_DEEC_E66D;

/// c.
const INCREMENT: u64 = 0xB;

const MASK: u64 = (1 << 48) - 1;

/// The maps that leap over 2ᵏ numbers, each as its factor and its summand.
static LEAPS: [[u64; 2]; 48] = {
    let mut leaps = [[MULTIPLIER, INCREMENT]; 48];
    let mut k = 1;
    while k < 48 {
        let [a, c] = leaps[k - 1];
        leaps[k] = [a.wrapping_mul(a) & MASK, a.wrapping_mul(c).wrapping_add(c) & MASK];
        k += 1;
    }
    leaps
};

/// What call number `n`, counted from 0, of `drand48` returns after `srand48(seed)`: in [0, 1), of 48 bits. The period is
/// 2⁴⁸, to which `n` is taken.
pub fn drand48(n: u64, seed: u32) -> f64 {
    let mut x = u64::from(seed) << 16 | 0x330E;
    let mut rest = n.wrapping_add(1) & MASK;
    while rest != 0 {
        let [a, c] = LEAPS[rest.trailing_zeros() as usize];
        x = a.wrapping_mul(x).wrapping_add(c) & MASK;
        rest &= rest - 1;
    }
    x as f64 / (1_u64 << 48) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_generator_of_the_system() {
        // Of the C library, after srand48(0).
        let told = [0.170_828_036_106_289_72, 0.749_901_980_484_963_8, 0.096_371_655_623_567_42];
        for (n, x) in (0..).zip(told) {
            assert!((drand48(n, 0) - x).abs() < 1e-15, "{n}: {}", drand48(n, 0));
        }
    }

    #[test]
    fn leaps_are_steps() {
        for seed in [0, 1, 0xffff_ffff] {
            let mut x = u64::from(seed) << 16 | 0x330E;
            for n in 0..5000 {
                x = (MULTIPLIER.wrapping_mul(x).wrapping_add(INCREMENT)) & MASK;
                assert_eq!(drand48(n, seed).to_bits(), (x as f64 / (1_u64 << 48) as f64).to_bits(), "{n}");
            }
            for n in [1 << 40, (1 << 48) - 2, 123_456_789_012] {
                assert_eq!(drand48(n, seed), drand48(n + (1 << 48), seed));
            }
        }
    }
}
