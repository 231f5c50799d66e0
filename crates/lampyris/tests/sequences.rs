//! What the theory of low discrepancy promises, asserted of each sequence.

use lampyris::sequence::radical_inverse::radical_inverse_f64;
use lampyris::sequence::sobol::{self, sobol_owen, sobol_owen_four, sobol_owen_pair};
use lampyris::sequence::{
    Sequence, halton, hammersley, jittered_halton, jittered_hammersley, next_radical_inverse,
    radical_inverse, scrambled_halton, uniform, unit_f32,
};

const EXTREME: [u32; 8] = [0, 1, 2, 0x7fff_ffff, 0x8000_0000, 0xffff_fffe, u32::MAX, 4_000_000_007];

#[test]
fn first_values_are_those_of_the_literature() {
    let phi = |b, n: u32| (0..n).map(|i| radical_inverse(b, i)).collect::<Vec<_>>();
    assert_eq!(phi(2, 8), [0.0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875]);
    for (x, k) in phi(3, 9).iter().zip([0, 3, 6, 1, 4, 7, 2, 5, 8]) {
        assert!((x - k as f32 / 9.0).abs() < 1e-7 && *x <= k as f32 / 9.0);
    }
    assert_eq!((halton(5, 0), halton(1, 2)), (0.625, 0.2f32.next_down()), "bases 2 and 5, rounded down");
    assert_eq!((hammersley(3, 16, 0), hammersley(3, 16, 1)), (0.1875, 0.75));
    // Joe and Kuo's points in natural order, by hand from the recurrence of m: dimension 2 has m = 1, 3, 3.
    let s = |d| (0..8).map(|i| unit_f32(sobol::sobol(i, d))).collect::<Vec<_>>();
    assert_eq!(s(0), [0.0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875]);
    assert_eq!(s(1), [0.0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875]);
    assert_eq!(s(2), [0.0, 0.5, 0.75, 0.25, 0.375, 0.875, 0.625, 0.125]);
    // Point 2^k is direction number k: all 16 dimensions against the published sequence [1/64].
    let published = [
        (4, [8, 40, 24, 8, 8, 24, 40, 40, 40, 56, 40, 8, 40, 24, 8, 8]),
        (8, [4, 60, 36, 20, 44, 12, 52, 20, 20, 44, 4, 12, 20, 36, 60, 52]),
        (16, [2, 34, 58, 62, 62, 50, 22, 34, 10, 38, 2, 22, 62, 14, 42, 54]),
        (32, [1, 51, 23, 29, 55, 9, 37, 9, 53, 37, 27, 43, 35, 49, 21, 49]),
    ];
    for (i, row) in published {
        let ours: Vec<u32> = (0..16).map(|d| sobol::sobol(i, d) >> 26).collect();
        assert_eq!(ours, row, "point {i}");
    }
    assert_eq!(s(3), [0.0, 0.5, 0.75, 0.25, 0.125, 0.625, 0.875, 0.375]);
}

#[test]
fn every_sample_lies_below_one() {
    for sequence in Sequence::ALL {
        for i in EXTREME.into_iter().chain(0..300) {
            for d in (0..70).chain([1000, u32::MAX - 1]) {
                for seed in [0, 1, u32::MAX] {
                    let x = sequence.sample(i, d, seed);
                    assert!((0.0..1.0).contains(&x), "{} {i} {d} {seed}: {x}", sequence.name());
                }
            }
        }
    }
    for base in [2, 3, 5, 7, 65_537, u32::MAX] {
        for i in EXTREME {
            assert!((0.0..1.0).contains(&radical_inverse(base, i)));
        }
    }
    for n in [1, 2, 1000, u32::MAX] {
        for d in 0..66 {
            for i in [0, n / 2, n - 1] {
                assert!((0.0..1.0).contains(&hammersley(i, n, d)));
                assert!((0.0..1.0).contains(&jittered_hammersley(i, n, d, 7)));
                assert!((0.0..1.0).contains(&jittered_halton(i, d, n, 7)));
            }
        }
    }
    assert!(unit_f32(u32::MAX) < 1.0);
}

/// Index of the cell of `x` in a grid of `cells`; a sample rounded down may lie one step below its cell.
fn cell(x: f32, cells: u32) -> usize {
    (f64::from(x.next_up()) * f64::from(cells)) as usize
}

/// Whether `points` has exactly one point in each cell of the grid a × b.
fn one_in_each(points: &[[f32; 2]], a: u32, b: u32) -> bool {
    let mut seen = vec![0; (a * b) as usize];
    points.iter().for_each(|p| seen[cell(p[0], a) * b as usize + cell(p[1], b)] += 1);
    seen.iter().all(|&c| c == 1)
}

#[test]
fn sobol_is_a_net_in_base_two_under_both_scrambles() {
    // The first two dimensions of a group form a (0, m, 2)-net over each aligned run of 2^m indices: one point in
    // every elementary interval of area 2^-m, whatever its shape.
    let pairs = [
        (Sequence::SobolOwen, 0),
        (Sequence::SobolOwen, 4),
        (Sequence::SobolOwen, 400),
        (Sequence::SobolXor, 0),
        (Sequence::SobolXor, 16),
    ];
    for (sequence, d) in pairs {
        for (m, seed) in [(1, 3), (4, 0), (7, 1), (10, 77)] {
            for start in [0, 5 << m, 1 << 20] {
                let points: Vec<_> = (start..start + (1 << m)).map(|i| sequence.pair(i, d, seed)).collect();
                for k in 0..=m {
                    assert!(one_in_each(&points, 1 << k, 1 << (m - k)), "{sequence:?} {d} m {m} k {k}");
                }
            }
        }
    }
}

#[test]
fn each_dimension_of_sobol_is_a_permutation_of_the_grid() {
    for sequence in [Sequence::SobolOwen, Sequence::SobolXor] {
        for d in 0..40 {
            let mut seen = [false; 256];
            (512..768).for_each(|i| seen[cell(sequence.sample(i, d, 5), 256)] = true);
            assert!(seen.iter().all(|&s| s), "{sequence:?} dimension {d}");
        }
    }
    // The 16 un-padded dimensions in pairs: never worse than quality t = 5 (the table's dimensions 10 and 11 are).
    for d in 0..15 {
        let points: Vec<_> = (0..1024).map(|i| [d, d + 1].map(|d| unit_f32(sobol::sobol(i, d)))).collect();
        for k in 0..=5u32 {
            let (a, b) = (1u32 << k, 1u32 << (5 - k));
            let mut count = [0; 32];
            points.iter().for_each(|p| count[cell(p[0], a) * b as usize + cell(p[1], b)] += 1);
            assert!(count.iter().all(|&c| c == 32), "dimensions {d}, {}: {a} × {b}", d + 1);
        }
    }
}

#[test]
fn halton_has_one_point_in_each_elementary_interval() {
    for (j, k) in [(0, 4), (2, 2), (3, 1), (5, 0)] {
        let (a, b) = (2u32.pow(j), 3u32.pow(k));
        for start in [0, 7 * a * b] {
            let run = start..start + a * b;
            let plain: Vec<_> = run.clone().map(|i| [halton(i, 0), halton(i, 1)]).collect();
            let scrambled: Vec<_> =
                run.map(|i| [scrambled_halton(i, 0, 9), scrambled_halton(i, 1, 9)]).collect();
            assert!(one_in_each(&plain, a, b), "{a} × {b}");
            assert!(one_in_each(&scrambled, a, b), "scrambled {a} × {b}");
        }
    }
    let diagonal: Vec<_> = (0..64).map(|i| [hammersley(i, 64, 0), hammersley(i, 64, 1)]).collect();
    for k in 0..=6 {
        assert!(one_in_each(&diagonal, 1 << k, 1 << (6 - k)), "Hammersley is a (0, m, 2)-net");
    }
}

#[test]
fn the_incremental_radical_inverse_follows_the_direct_one() {
    for base in [2, 3, 5, 7, 13, 53] {
        let (mut x, mut worst) = (0.0, 0.0f64);
        for i in 1..=100_000 {
            x = next_radical_inverse(base, x);
            worst = worst.max((x - radical_inverse_f64(base, i)).abs());
        }
        // Twenty times what base 3, the worst, was measured to accumulate.
        assert!(worst < 4e-11, "base {base}: {worst:e}");
    }
}

#[test]
fn jitter_stays_in_its_cell_and_moves_within_it() {
    for (d, base) in [(0, 2u32), (1, 3), (2, 5), (5, 13)] {
        for n in [1u32, 7, 64, 1000] {
            let cells = (0..).map(|m| base.pow(m)).find(|&c| c >= n).unwrap();
            let mut moved = 0.0;
            for i in 0..n {
                let x = jittered_halton(i, d, n, 3);
                let plain = halton(i, d);
                assert!(
                    (plain..plain + 1.001 / cells as f32).contains(&x.next_up()),
                    "base {base} n {n} i {i}"
                );
                moved += (x - plain) * cells as f32 / n as f32;
            }
            assert!(
                n < 64 || (moved - 0.5).abs() < 5.0 / (12.0 * n as f32).sqrt(),
                "mean shift {moved} cells"
            );
        }
    }
    for i in 0..50 {
        let x = jittered_hammersley(i, 50, 0, 1);
        assert!((x.next_up() * 50.0) as u32 == i);
    }
}

/// Root mean square error over seeds for the product of ½π sin(πx) over four dimensions, whose integral is 1.
fn rms_error(sequence: Sequence, n: u32, first_dimension: u32) -> f64 {
    use std::f64::consts::{FRAC_PI_2, PI};
    let seeds = 32;
    let square = |seed: u32| {
        let f = |i| {
            (0..4)
                .map(|d| f64::from(sequence.sample(i, first_dimension + d, seed)))
                .map(|x| FRAC_PI_2 * libm::sin(PI * x))
                .product::<f64>()
        };
        let error = (0..n).map(f).sum::<f64>() / f64::from(n) - 1.0;
        error * error
    };
    ((0..seeds).map(square).sum::<f64>() / f64::from(seeds)).sqrt()
}

#[test]
fn smooth_integrands_converge_faster_than_at_random() {
    for (sequence, d) in [
        (Sequence::SobolOwen, 0),
        (Sequence::SobolOwen, 8),
        (Sequence::SobolXor, 0),
        (Sequence::ScrambledHalton, 0),
        (Sequence::JitteredHalton, 0),
        (Sequence::Halton, 0),
    ] {
        let (few, many) = (rms_error(sequence, 256, d), rms_error(sequence, 16_384, d));
        let slope = (many / few).log2() / 6.0;
        // Random numbers: −½.
        assert!(slope < -0.8, "{sequence:?} from dimension {d}: {few:e} → {many:e}, slope {slope}");
    }
}

/// Pearson's correlation.
fn correlation(pairs: &[[f32; 2]]) -> f64 {
    let n = pairs.len() as f64;
    let mean = |k: usize| pairs.iter().map(|p| f64::from(p[k])).sum::<f64>() / n;
    let (a, b) = (mean(0), mean(1));
    let moment = |f: &dyn Fn(f64, f64) -> f64| {
        pairs.iter().map(|p| f(f64::from(p[0]) - a, f64::from(p[1]) - b)).sum::<f64>() / n
    };
    moment(&|x, y| x * y) / (moment(&|x, _| x * x) * moment(&|_, y| y * y)).sqrt()
}

#[test]
fn seeds_and_groups_are_uncorrelated() {
    let n = 4096;
    for sequence in [Sequence::ScrambledHalton, Sequence::SobolOwen] {
        for seed in 0..8 {
            for (d, e, other) in
                [(0, 0, seed + 100), (3, 3, seed + 1), (0, 4, seed), (1, 9, seed), (18, 19, seed)]
            {
                // At one index over many seeds, where both numbers must be independent random ones.
                let pairs: Vec<_> = (0..n)
                    .map(|k| {
                        [sequence.sample(5, d, seed + 1000 * k), sequence.sample(5, e, other + 1000 * k)]
                    })
                    .collect();
                let r = correlation(&pairs);
                // Standard deviation 1/64; 80 trials: 4.5 standard deviations are met by chance once in 1800 runs.
                assert!(r.abs() < 4.5 / 64.0, "{sequence:?} seed {seed} dimensions {d}, {e}: {r}");
            }
        }
    }
    // Along the index within one randomisation: groups of Owen's Sobol', and neighbours of high primes, which
    // Halton without scrambling leaves on a line.
    let along = |f: &dyn Fn(u32) -> [f32; 2], n: u32| correlation(&(0..n).map(f).collect::<Vec<_>>()).abs();
    assert!(along(&|i| [halton(i, 6), halton(i, 7)], 16) > 0.99, "17 and 19 are collinear");
    let mean =
        (0..64).map(|s| along(&|i| [scrambled_halton(i, 6, s), scrambled_halton(i, 7, s)], 16)).sum::<f64>()
            / 64.0;
    // Independent numbers have a mean |r| of √(2/16π) ≈ 0.21.
    assert!(mean < 0.3, "scrambled 17 and 19: mean |r| {mean}");
    assert!(along(&|i| [sobol_owen(i, 0, 1), sobol_owen(i, 4, 1)], n) < 4.5 / 64.0);
    assert!(along(&|i| [uniform(1, i, 0), uniform(1, i, 1)], n) < 4.5 / 64.0);
    assert!(along(&|i| [uniform(1, i, 0), uniform(2, i, 0)], n) < 4.5 / 64.0);
    assert!(along(&|i| [uniform(1, i, 0), uniform(1, i + 1, 0)], n) < 4.5 / 64.0);
}

#[test]
fn samples_are_pure_functions_and_pairs_are_two_samples() {
    for sequence in Sequence::ALL {
        assert_eq!(Sequence::by_name(sequence.name()), Some(sequence));
        let forwards: Vec<f32> = (0..200).map(|k| sequence.sample(k * 7919, k % 30, k / 50)).collect();
        let mut backwards: Vec<f32> =
            (0..200).rev().map(|k| sequence.sample(k * 7919, k % 30, k / 50)).collect();
        backwards.reverse();
        assert_eq!(forwards, backwards);
        for k in 0..200 {
            let [a, b] = sequence.pair(k * 31, k % 23, k);
            let two = (sequence.sample(k * 31, k % 23, k), sequence.sample(k * 31, k % 23 + 1, k));
            assert_eq!((a, b), two, "{sequence:?} {k}");
        }
    }
    assert_eq!(Sequence::by_name("drand48"), None);
    assert_eq!(sobol_owen_pair(9, 3, 1), [sobol_owen(9, 3, 1), sobol_owen(9, 4, 1)]);
    for (index, group, seed) in [(0, 0, 0), (1, 3, 7), (0xdead_beef, 5, 1), (u32::MAX, 2, u32::MAX)] {
        let first = 4 * group;
        let one_by_one = [0, 1, 2, 3].map(|d| sobol_owen(index, first + d, seed));
        assert_eq!(sobol_owen_four(index, first, seed), one_by_one);
    }
}
