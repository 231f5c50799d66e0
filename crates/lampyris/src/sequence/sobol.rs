//! The Sobol' sequence with two scrambles: exclusive-or [Wald et al. 2002] and Owen's, by hashing [Laine and
//! Karras 2011; Burley 2020].
//! Dimensions beyond the table are padded: groups of them repeat it under an index shuffled for each group.

use super::hash::{hash, unit_f32};

/// Number of dimensions in the table of direction numbers.
pub const DIMENSIONS: u32 = 16;

/// Dimensions that share one shuffled index, and so are stratified together, in [`sobol_owen`].
pub const GROUP: u32 = 4;

/// Degree s, coefficients a and first direction numbers m of the primitive polynomials of dimensions 1 … 15, as
/// tabulated by [Joe and Kuo 2008]; dimension 0 is Φ₂ and has none.
const POLYNOMIALS: [(usize, u32, [u32; 6]); 15] = [
    (1, 0, [1, 0, 0, 0, 0, 0]),
    (2, 1, [1, 3, 0, 0, 0, 0]),
    (3, 1, [1, 3, 1, 0, 0, 0]),
    (3, 2, [1, 1, 1, 0, 0, 0]),
    (4, 1, [1, 1, 3, 3, 0, 0]),
    (4, 4, [1, 3, 5, 13, 0, 0]),
    (5, 2, [1, 1, 5, 5, 17, 0]),
    (5, 4, [1, 1, 5, 5, 5, 0]),
    (5, 7, [1, 1, 7, 11, 19, 0]),
    (5, 11, [1, 1, 5, 1, 1, 0]),
    (5, 13, [1, 1, 1, 3, 11, 0]),
    (5, 14, [1, 3, 5, 5, 31, 0]),
    (6, 1, [1, 3, 3, 9, 7, 49]),
    (6, 13, [1, 1, 1, 15, 21, 21]),
    (6, 16, [1, 3, 1, 13, 27, 49]),
];

/// Direction numbers v_k of each dimension, the binary point left of the top bit.
static DIRECTIONS: [[u32; 32]; DIMENSIONS as usize] = {
    let mut v = [[0; 32]; DIMENSIONS as usize];
    let mut k = 0;
    while k < 32 {
        v[0][k] = 1 << (31 - k);
        k += 1;
    }
    let mut d = 1;
    while d < v.len() {
        let (s, a, m) = POLYNOMIALS[d - 1];
        let mut k = 0;
        while k < 32 {
            v[d][k] = if k < s {
                m[k] << (31 - k)
            } else {
                let mut x = v[d][k - s] ^ (v[d][k - s] >> s);
                let mut j = 1;
                while j < s {
                    if a >> (s - 1 - j) & 1 == 1 {
                        x ^= v[d][k - j];
                    }
                    j += 1;
                }
                x
            };
            k += 1;
        }
        d += 1;
    }
    v
};

/// XOR of the direction numbers that each nibble of an index selects, for four dimensions side by side:
/// `[group][nibble's place][nibble][dimension in the group]`.
static NIBBLES: [[[[u32; 4]; 16]; 8]; DIMENSIONS as usize / 4] = {
    let mut table = [[[[0; 4]; 16]; 8]; DIMENSIONS as usize / 4];
    // A constant's loops must be written out.
    let mut at = 0;
    while at < DIMENSIONS as usize * 8 * 16 * 4 {
        let (dimension, place, nibble, bit) = (at / 512, at / 64 % 8, at / 4 % 16, at % 4);
        if nibble >> bit & 1 == 1 {
            table[dimension / 4][place][nibble][dimension % 4] ^= DIRECTIONS[dimension][4 * place + bit];
        }
        at += 1;
    }
    table
};

/// Point `index` of the Sobol' sequence [2⁻³²], natural order (no Gray code); `dimension` < [`DIMENSIONS`].
pub fn sobol(index: u32, dimension: u32) -> u32 {
    let (group, d) = ((dimension / 4) as usize, (dimension % 4) as usize);
    (0..8).fold(0, |x, place| x ^ NIBBLES[group][place][(index >> (4 * place) & 15) as usize][d])
}

/// The first four dimensions of [`sobol`].
fn sobol_four(index: u32) -> [u32; 4] {
    let mut x = [0; 4];
    for (place, table) in NIBBLES[0].iter().enumerate() {
        let row = &table[(index >> (4 * place) & 15) as usize];
        (0..4).for_each(|d| x[d] ^= row[d]);
    }
    x
}

/// Owen's scramble of the binary fraction x: each bit is flipped at random depending on the bits above it.
pub fn owen(x: u32, seed: u32) -> u32 {
    laine_karras(x.reverse_bits(), seed).reverse_bits()
}

/// A permutation in which a bit depends only on the bits below it.
fn laine_karras(mut x: u32, seed: u32) -> u32 {
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

/// Sobol' with Owen's scramble, padded in groups of four dimensions: the default of everything here.
///
/// Dimensions 4g … 4g + 3 are the first four of Sobol' at an index that Owen's scramble shuffles for the group: any
/// aligned run of 2ᵐ indices stays a net in each group, while the groups are independent of each other.
pub fn sobol_owen(index: u32, dimension: u32, seed: u32) -> f32 {
    unit_f32(owen_in_group(group_index(index, dimension, seed), dimension, seed))
}

/// Owen's scramble of the whole table [2⁻³²]: the first [`DIMENSIONS`] are one sequence and stratified together, where
/// [`sobol_owen`] knows groups of four; beyond them it repeats under a shuffled index.
pub fn sobol_owen_wide_word(index: u32, dimension: u32, seed: u32) -> u32 {
    let index = match dimension / DIMENSIONS {
        0 => index,
        group => owen(index, hash(!seed, group)),
    };
    owen(sobol(index, dimension % DIMENSIONS), hash(seed, dimension))
}

/// Two consecutive dimensions of [`sobol_owen`], cheaper where `dimension` is even; equal to it to the bit.
pub fn sobol_owen_pair(index: u32, dimension: u32, seed: u32) -> [f32; 2] {
    if dimension % GROUP == GROUP - 1 {
        return [sobol_owen(index, dimension, seed), sobol_owen(index, dimension + 1, seed)];
    }
    let shuffled = group_index(index, dimension, seed);
    [dimension, dimension + 1].map(|d| unit_f32(owen_in_group(shuffled, d, seed)))
}

/// The four dimensions of [`sobol_owen`] from `dimension` on, a multiple of [`GROUP`]; equal to it to the bit.
pub fn sobol_owen_four(index: u32, dimension: u32, seed: u32) -> [f32; 4] {
    let mut x = sobol_four(group_index(index, dimension, seed));
    for (x, d) in x.iter_mut().zip(dimension..) {
        *x = owen(*x, hash(seed, d));
    }
    x.map(unit_f32)
}

fn group_index(index: u32, dimension: u32, seed: u32) -> u32 {
    // The complement keeps the seeds of groups apart from those of dimensions.
    owen(index, hash(!seed, dimension / GROUP))
}

fn owen_in_group(shuffled: u32, dimension: u32, seed: u32) -> u32 {
    owen(sobol(shuffled, dimension % GROUP), hash(seed, dimension))
}

/// Sobol' with one random word exclusive-ored onto each dimension, as in [Wald et al. 2002].
///
/// The first [`DIMENSIONS`] are the sequence itself; beyond them it repeats under a shuffled index. Cheap, but the
/// net keeps its fixed structure: the error of smooth integrands does not gain what Owen's scramble gains.
pub fn sobol_xor(index: u32, dimension: u32, seed: u32) -> f32 {
    unit_f32(sobol_xor_word(index, dimension, seed))
}

/// [`sobol_xor`] with all of its bits [2⁻³²].
pub fn sobol_xor_word(index: u32, dimension: u32, seed: u32) -> u32 {
    let index = match dimension / DIMENSIONS {
        0 => index,
        // A mere exclusive-or of the index would be one of the value: the group would repeat the first.
        group => owen(index, hash(!seed, group)),
    };
    sobol(index, dimension % DIMENSIONS) ^ hash(seed, dimension)
}
