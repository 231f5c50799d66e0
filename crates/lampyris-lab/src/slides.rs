//! The lecture on instant radiosity: its pictures of sequences.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Table, digits};
use crate::plot::Plot;
use crate::statistics::{self, mean_of, star_discrepancy};
use lampyris::sequence::{halton, scrambled_halton, sobol, uniform};

pub(crate) const LECTURE: &str = "I. Boyadzhiev and K. Matzen, Instant Radiosity, a lecture";

pub(crate) const HALTON: Experiment = Experiment {
    name: "lecture-halton",
    title: "The Halton sequence in bases 17 and 19",
    paper: LECTURE,
    place: "“Curse of dimensionality”",
    claim: "With the primes 17 and 19 the first 16 pairs of points have perfect linear correlation. Permuting the digits mends it, \
            or taking the Sobol' sequence.",
    seconds: [0.5, 3.0],
    run: curse,
};

/// The dimensions of the primes 17 and 19.
const DIMENSIONS: [u32; 2] = [6, 7];

fn curse(effort: &Effort<'_>) -> Result<Findings> {
    let seeds = effort.of(64, 1024);
    let of = |n: u32, coordinate: &dyn Fn(u32, u32) -> f32| -> Vec<[f64; 2]> {
        (0..n).map(|i| DIMENSIONS.map(|d| f64::from(coordinate(i, d)))).collect()
    };
    let scrambled = |n, seed| of(n, &|i, d| scrambled_halton(i, d, seed));
    let random = |n, seed| of(n, &|i, d| uniform(seed, i, d));
    let net = |i: u32, d: u32| lampyris::sequence::unit_f32(sobol::sobol(i, d));
    let correlation = |points: &[[f64; 2]]| {
        let [x, y] = [0, 1].map(|d| points.iter().map(|p| p[d]).collect::<Vec<_>>());
        statistics::correlation(&x, &y)
    };
    let mut found = Findings::default();
    for (name, points) in [
        ("Halton", of(600, &halton)),
        ("scrambled Halton", scrambled(600, 1)),
        ("pseudo-random", random(600, 1)),
        ("Sobol', dimensions 7 and 8", of(600, &net)),
    ] {
        found.show(Plot::of_points(format!("{name}, 600 points"), "base 17", "base 19", &points));
    }
    found.show(Plot::of_points("Halton, the first 16", "base 17", "base 19", &of(16, &halton)));
    found.show(Plot::of_points("scrambled, the first 16", "base 17", "base 19", &scrambled(16, 1)));
    effort.step(1, 2)?;
    let mut table = Table::new(
        format!("of scrambled and random points the mean of {seeds} seeds"),
        ["points", "correlation of the first 16, without sign", "star discrepancy of 600"],
    );
    let plain = [correlation(&of(16, &halton)), star_discrepancy(&of(600, &halton))];
    let some = effort.of(4, 32).min(seeds);
    let mean = |points: &dyn Fn(u32, u32) -> Vec<[f64; 2]>| {
        let correlations: Vec<f64> = (0..seeds).map(|seed| correlation(&points(16, seed)).abs()).collect();
        let discrepancies: Vec<f64> = (0..some).map(|seed| star_discrepancy(&points(600, seed))).collect();
        [mean_of(&correlations), mean_of(&discrepancies)]
    };
    let (mended, random) = (mean(&scrambled), mean(&random));
    let sobol = [correlation(&of(16, &net)).abs(), star_discrepancy(&of(600, &net))];
    let rows =
        [("Halton", plain), ("scrambled Halton", mended), ("pseudo-random", random), ("Sobol'", sobol)];
    for (name, [correlation, discrepancy]) in rows {
        table.row([name.into(), digits(correlation), digits(discrepancy)]);
    }
    found.show(table);
    found.compare(
        Comparison::new("correlation of the first 16, Halton", "", plain[0])
            .paper(1.0)
            .says("perfect")
            .demand(Demand::AtLeast(0.999)),
    );
    found.compare(
        Comparison::new("correlation of the first 16, scrambled", "", mended[0])
            .says("avoided")
            .demand(Demand::AtMost(0.4)),
    );
    found.compare(
        Comparison::new("star discrepancy of 600, Halton over scrambled", "", plain[1] / mended[1])
            .demand(Demand::AtLeast(1.0)),
    );
    found.gap("The lecture counts “perfect correlation” for the first 16 points with one index of 17; from index 17 on the lines break, and return every 17 × 19 points.");
    Ok(found)
}
