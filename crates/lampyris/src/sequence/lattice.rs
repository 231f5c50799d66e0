//! An extensible rank-1 lattice of Korobov's form: point i is Φ₂(i) (1, a, a², …) modulo 1, shifted [Hickernell et al. 2000].
//! Any first 2ᵐ points are a lattice, and points may be added without end. It is exact in words of 32 bits: Φ₂(i) is
//! the index with its bits mirrored.

use super::hash::hash;

/// a, of [Hickernell et al. 2000] for base 2.
pub const GENERATOR: u32 = 17797;

/// Coordinate `dimension` of point `i` [2⁻³²], shifted by a random number for each dimension.
pub fn lattice(i: u32, dimension: u32, seed: u32) -> u32 {
    let z = GENERATOR.wrapping_pow(dimension);
    i.reverse_bits().wrapping_mul(z).wrapping_add(hash(seed, dimension))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_are_groups_and_every_coordinate_is_even() {
        let bare = |i, d| lattice(i, d, 3).wrapping_sub(hash(3, d));
        for m in [1, 4, 7] {
            for d in 0..40 {
                // One point in each interval of 2⁻ᵐ, whatever the shift.
                let mut cells: Vec<u32> = (0..1 << m).map(|i| lattice(i, d, 3) >> (32 - m)).collect();
                cells.sort_unstable();
                assert_eq!(cells, (0..1 << m).collect::<Vec<_>>(), "{m}, {d}");
            }
            let points: std::collections::BTreeSet<[u32; 3]> =
                (0..1 << m).map(|i| [0, 1, 7].map(|d| bare(i, d))).collect();
            for (p, q) in points.iter().flat_map(|p| points.iter().map(move |q| (p, q))) {
                assert!(points.contains(&std::array::from_fn(|d| p[d].wrapping_add(q[d]))));
            }
        }
    }
}
