//! Figures 1, 4 and 7: what sampling patterns look like, and their Fourier transforms.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::statistics::{least_distance, mean_of, star_discrepancy};
use lampyris::sequence::{halton, hammersley, jittered_hammersley, uniform};

/// Points of the unit square: how many, and of which draw.
pub(super) struct Pattern {
    pub(super) name: &'static str,
    pub(super) points: fn(u32, u32) -> Vec<[f64; 2]>,
}

pub(super) const RANDOM: Pattern =
    Pattern { name: "random", points: |n, seed| of(n, |i, d| uniform(seed, i, d)) };

pub(super) const HALTON: Pattern = Pattern { name: "Halton", points: |n, _| of(n, halton) };

pub(super) const HAMMERSLEY: Pattern =
    Pattern { name: "Hammersley", points: |n, _| of(n, |i, d| hammersley(i, n, d)) };

pub(super) const JITTERED_HAMMERSLEY: Pattern = Pattern {
    name: "jittered Hammersley",
    points: |n, seed| of(n, |i, d| jittered_hammersley(i, n, d, seed)),
};

/// One point at random in each cell of a square grid; of numbers that are no squares the cells of the next square below,
/// and the rest anywhere.
pub(super) const JITTERED: Pattern = Pattern {
    name: "jittered",
    points: |n, seed| {
        let edge = n.isqrt();
        let cell = |i: u32| [i % edge, i / edge];
        let place = |i: u32, d: usize| match i < edge * edge {
            true => (f64::from(cell(i)[d]) + f64::from(uniform(seed, i, d as u32))) / f64::from(edge),
            false => f64::from(uniform(seed, i, d as u32)),
        };
        (0..n).map(|i| [place(i, 0), place(i, 1)]).collect()
    },
};

fn of(n: u32, coordinate: impl Fn(u32, u32) -> f32) -> Vec<[f64; 2]> {
    (0..n).map(|i| [0, 1].map(|d| f64::from(coordinate(i, d)))).collect()
}

pub(crate) const FIGURE_1: Experiment = Experiment {
    name: "keller97-figure-1",
    title: "Uniform sampling patterns",
    paper: KELLER97,
    place: "Figure 1, §3.1",
    claim: "Two-dimensional uniform sampling patterns, random, jittered and Halton, for N = 64 samples: not randomness but \
            uniformity matters. The discrepancy of Halton points is O(log² N / N), that of random ones O(√(log log N / N)).",
    seconds: [0.2, 2.0],
    run: figure_1,
};

fn figure_1(effort: &Effort<'_>) -> Result<Findings> {
    const N: u32 = 64;
    let draws = effort.of(16, 256);
    let mut found = Findings::default();
    let mut table = Table::new(
        format!("{N} points; of random patterns the mean of {draws} draws"),
        ["pattern", "star discrepancy", "least distance (torus)"],
    );
    let mut discrepancies = Vec::new();
    for pattern in [RANDOM, JITTERED, HALTON] {
        let drawn: Vec<Vec<[f64; 2]>> = (0..draws).map(|seed| (pattern.points)(N, seed)).collect();
        let discrepancy = mean_of(&drawn.iter().map(|p| star_discrepancy(p)).collect::<Vec<_>>());
        let distance = mean_of(&drawn.iter().map(|p| least_distance(p)).collect::<Vec<_>>());
        table.row([pattern.name.into(), digits(discrepancy), digits(distance)]);
        discrepancies.push(discrepancy);
        found.show(Plot::of_points(format!("{}, N = {N}", pattern.name), "x₁", "x₂", &drawn[0]));
        effort.step(discrepancies.len(), 3)?;
    }
    found.show(table);
    found.compare(
        Comparison::new("star discrepancy, random over Halton", "", discrepancies[0] / discrepancies[2])
            .says("low-discrepancy points are more uniform")
            .demand(Demand::AtLeast(1.5)),
    );
    found.compare(
        Comparison::new("star discrepancy, jittered over Halton", "", discrepancies[1] / discrepancies[2])
            .says("no figure"),
    );
    found.gap("The report has pictures and orders of convergence, no discrepancies of its patterns.");
    Ok(found)
}

pub(crate) const FIGURE_4: Experiment = Experiment {
    name: "keller97-figure-4",
    title: "Diffuse scattering by random and by Halton samples",
    paper: KELLER97,
    place: "Figure 4, §3.2",
    claim: "Directions distributed by the cosine, from pseudo-random and from Halton samples for N = 16: the deterministic \
            low-discrepancy samples are more uniformly distributed.",
    seconds: [0.1, 1.0],
    run: figure_4,
};

/// The report's direction of emission reads the third and the fourth prime.
const DIRECTION: [u32; 2] = [2, 3];

fn figure_4(effort: &Effort<'_>) -> Result<Findings> {
    const N: u32 = 16;
    let draws = effort.of(64, 1024);
    let mut found = Findings::default();
    let halton = directions(N, halton);
    let random: Vec<Vec<[f64; 2]>> =
        (0..draws).map(|seed| directions(N, |i, d| uniform(seed, i, d))).collect();
    let title = |name: &str| format!("{name}, N = {N}, seen from above");
    for (name, points) in [("random", &random[0]), ("Halton", &halton)] {
        let mut plot = Plot::of_points(title(name), "x", "y", points);
        plot.x = Axis::linear("x").from_to(-1.0, 1.0);
        plot.y = Axis::linear("y").from_to(-1.0, 1.0);
        let circle = (0..=96).map(|k| libm::sincos(std::f64::consts::TAU * f64::from(k) / 96.0));
        found.show(plot.with(Series::dashes("", circle.map(|(y, x)| [x, y]).collect())));
    }
    effort.step(1, 2)?;
    let tilt = |points: &[[f64; 2]]| {
        let [x, y] = [0, 1].map(|d| mean_of(&points.iter().map(|p| p[d]).collect::<Vec<_>>()));
        (x * x + y * y).sqrt()
    };
    let squares: Vec<f64> = random.iter().map(|points| tilt(points).powi(2)).collect();
    let (ours, random) = (tilt(&halton), mean_of(&squares).sqrt());
    found.compare(
        Comparison::new("tilt of the mean direction, random over Halton", "", random / ours)
            .says("obviously more uniform")
            .demand(Demand::AtLeast(1.5)),
    );
    found.show(format!(
        "The directions' mean should point along the normal. Sideways it has {} with Halton samples, {} with random ones (root of the \
         mean square of {draws} draws; 1 is the radius of the circle).",
        digits(ours),
        digits(random)
    ));
    found.gap("Which primes the figure uses is not said; here they are the third and the fourth, as §3.2 has them for the first direction.");
    Ok(found)
}

/// Directions about the normal, seen along it.
fn directions(n: u32, coordinate: impl Fn(u32, u32) -> f32) -> Vec<[f64; 2]> {
    let direction = |i| {
        let [u, v] = DIRECTION.map(|d| f64::from(coordinate(i, d)));
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * v);
        [u.sqrt() * cos, u.sqrt() * sin]
    };
    (0..n).map(direction).collect()
}
