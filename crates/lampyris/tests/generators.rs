//! What the generators of the walk of 1996 owe: numbers in the unit interval, streams that are those of their authors, strata
//! that hold one point each, and seeds that change them.

use lampyris::sequence::{Generator, STRIDE, inversive, lcg, scrambled_halton};
use lampyris::testing::{chi_square_test, sidak};
use std::collections::BTreeSet;

/// Faure's in other dimensions too.
fn all() -> impl Iterator<Item = Generator> {
    let faure = [2, 3, 8, 24].map(|dimensions| Generator::Faure { dimensions });
    Generator::ALL.into_iter().chain(faure)
}

#[test]
fn every_number_lies_in_the_unit_interval() {
    for generator in all() {
        for i in (0..200).chain([0x7fff_ffff, 0x8000_0000, u32::MAX - 1, u32::MAX]) {
            for d in (0..70).chain([1000, 4098, 5000, u32::MAX]) {
                for seed in [0, 1, u32::MAX] {
                    let x = generator.point(i, d, seed);
                    assert!((0.0..1.0).contains(&x), "{generator:?} {i} {d} {seed}: {x}");
                }
            }
        }
    }
}

#[test]
fn names_are_names() {
    let names: BTreeSet<&str> = Generator::ALL.iter().map(|g| g.name()).collect();
    assert_eq!(names.len(), Generator::ALL.len());
    Generator::ALL.iter().for_each(|g| assert_eq!(Generator::by_name(g.name()), Some(*g)));
    assert_eq!(Generator::by_name("mersenne-twister"), None);
    assert_eq!(Generator::Faure { dimensions: 16 }.in_dimensions(3), Generator::Faure { dimensions: 3 });
}

/// Paths take their numbers from one stream, one after another and without overlap.
#[test]
fn random_numbers_are_those_of_one_stream() {
    for (i, d) in [(0, 0), (0, 5), (3, 7), (u32::MAX, 15)] {
        let n = u64::from(i) * STRIDE + u64::from(d);
        assert_eq!(Generator::Congruential.point(i, d, 9), lcg::drand48(n, 9));
    }
    assert_eq!(Generator::Inversive.point(0, STRIDE as u32, 3), Generator::Inversive.point(1, 0, 3));
    assert!((0..1000).all(|n| inversive::inversive(n, 5) != inversive::inversive(n + 1, 5)));
}

/// Counts of points in the cells of a grid of a × b; rounding is kept from the lower edges.
fn counts(
    generator: Generator,
    [d, e]: [u32; 2],
    run: std::ops::Range<u32>,
    seed: u32,
    [a, b]: [u32; 2],
) -> Vec<u32> {
    let mut counts = vec![0; (a * b) as usize];
    for i in run {
        let cell = |d, n: u32| ((generator.point(i, d, seed) + 1e-13) * f64::from(n)) as usize;
        counts[cell(d, a) * b as usize + cell(e, b)] += 1;
    }
    counts
}

/// Halton's points, started anywhere: of any ab consecutive ones, a and b powers of the bases, one lies in each cell.
#[test]
fn halton_holds_its_strata_wherever_it_starts() {
    for (d, e, a, b) in [(0, 1, 16, 9), (1, 2, 27, 5), (2, 3, 25, 7), (0, 15, 8, 53)] {
        for seed in [0, 1, 77] {
            for generator in [Generator::Halton, Generator::PermutedHalton] {
                for start in [0, 1000 * a * b] {
                    let counts = counts(generator, [d, e], start..start + a * b, seed, [a, b]);
                    assert!(counts.iter().all(|c| *c == 1), "{generator:?}, {d} × {e}, seed {seed}");
                }
            }
        }
    }
    // The same digits that pictures are made of.
    for (i, d) in (0..500).flat_map(|i| (0..64).map(move |d| (i, d))) {
        let (x, y) = (Generator::PermutedHalton.point(i, d, 4), f64::from(scrambled_halton(i, d, 4)));
        assert!(x >= y && x - y < 1e-7, "{i}, {d}: {x} {y}");
    }
}

/// Sobol's sixteen dimensions keep under both scrambles what they are: nets in the first two, quality 5 in neighbours, and
/// each dimension even for itself, far beyond sixteen too. So does the lattice, dimension by dimension.
#[test]
fn powers_of_two_hold_their_strata() {
    for generator in [Generator::SobolXor, Generator::SobolOwen] {
        for start in [0, 3 << 10] {
            for k in 0..=10 {
                let counts = counts(generator, [0, 1], start..start + 1024, 5, [1 << k, 1 << (10 - k)]);
                assert!(counts.iter().all(|c| *c == 1), "{generator:?}, {k}");
            }
            for (d, k) in (0..15).flat_map(|d| (0..=5).map(move |k| (d, k))) {
                let counts = counts(generator, [d, d + 1], start..start + 1024, 5, [1 << k, 1 << (5 - k)]);
                assert!(counts.iter().all(|c| *c == 32), "{generator:?}, {d}, {k}");
            }
        }
    }
    for generator in [Generator::SobolXor, Generator::SobolOwen, Generator::Lattice] {
        for d in 0..60 {
            let counts = counts(generator, [d, d], 512..768, 5, [256, 1]);
            assert!(counts.iter().all(|c| *c == 1), "{generator:?}, {d}");
        }
    }
}

/// Over the seeds every number is uniform, that of the first point as that of any other: means over seeds have no bias.
#[test]
fn numbers_are_uniform_over_the_seeds() {
    const SEEDS: u32 = 1600;
    let mut p_values = Vec::new();
    for generator in Generator::ALL {
        for (i, d) in [0, 1, 100, 65_535].into_iter().flat_map(|i| [0, 1, 5, 15, 30].map(|d| (i, d))) {
            let mut bins = [0.0; 16];
            (0..SEEDS).for_each(|seed| bins[(generator.point(i, d, seed) * 16.0) as usize] += 1.0);
            p_values.push(chi_square_test(&bins, &[f64::from(SEEDS) / 16.0; 16], 0));
            assert!(*p_values.last().unwrap() > 1e-6, "{generator:?}, point {i}, dimension {d}: {bins:?}");
        }
    }
    let least = p_values.iter().copied().fold(1.0, f64::min);
    assert!(least > sidak(0.01, p_values.len()), "{least}");
}
