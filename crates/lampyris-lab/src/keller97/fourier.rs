//! Figure 7: three patterns and their Fourier transforms.

use super::patterns::{HAMMERSLEY, JITTERED_HAMMERSLEY, Pattern};
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::Plot;
use lampyris::sequence::uniform;
use rayon::prelude::*;

pub(crate) const FIGURE_7: Experiment = Experiment {
    name: "keller97-figure-7",
    title: "Patterns and their Fourier transforms",
    paper: KELLER97,
    place: "Figure 7, §4.1",
    claim: "Poisson disk, jittered Hammersley and Hammersley for N = 16, and their Fourier transforms for N = 64: Hammersley's \
            grid has high aliasing amplitudes; jittered it maps high frequencies to noise, reproduces low ones correctly, and \
            comes near to the properties of the Poisson disk.",
    seconds: [1.0, 8.0],
    run: figure_7,
};

/// No two points nearer than a distance on the torus, by throwing darts: the distance gives way where none finds a place.
const POISSON_DISK: Pattern = Pattern {
    name: "Poisson disk",
    points: |n, seed| {
        let mut distance = 0.78 * (2.0 / (3.0_f64.sqrt() * f64::from(n))).sqrt();
        let mut points: Vec<[f64; 2]> = Vec::new();
        for dart in 0.. {
            if points.len() as u32 >= n {
                break;
            }
            let at = [0, 1].map(|d| f64::from(uniform(seed, dart, d)));
            let far = |p: &[f64; 2]| {
                let [x, y] = [0, 1].map(|d| (p[d] - at[d]).abs()).map(|d| d.min(1.0 - d));
                x * x + y * y >= distance * distance
            };
            if points.iter().all(far) {
                points.push(at);
            } else if dart % 1000 == 999 {
                distance *= 0.98;
            }
        }
        points
    },
};

/// Frequencies to either side.
const REACH: i32 = 72;

fn figure_7(effort: &Effort<'_>) -> Result<Findings> {
    const N: u32 = 64;
    let draws = effort.of(8, 64);
    let patterns = [POISSON_DISK, JITTERED_HAMMERSLEY, HAMMERSLEY];
    let mut found = Findings::default();
    for pattern in &patterns {
        found.show(Plot::of_points(
            format!("{}, N = 16", pattern.name),
            "x₁",
            "x₂",
            &(pattern.points)(16, 1),
        ));
    }
    let mut table = Table::new(
        format!("power |Σ exp(−2πi k·x)|²/N for N = {N}, 1 for random points; the mean of {draws} draws"),
        ["pattern", "largest power, |k| ≤ 72", "mean power, |k| < 4"],
    );
    let mut images = Vec::new();
    let mut largest = Vec::new();
    let mut low = Vec::new();
    for pattern in &patterns {
        let power = periodogram(pattern, N, draws);
        let peak = power.iter().copied().fold(0.0, f64::max);
        let inner: Vec<f64> = frequencies()
            .zip(&power)
            .filter(|([x, y], _)| (1..16).contains(&(x * x + y * y)))
            .map(|(_, power)| *power)
            .collect();
        let inner = inner.iter().sum::<f64>() / inner.len() as f64;
        table.row([pattern.name.into(), digits(peak), digits(inner)]);
        let shown: Vec<f64> = power.iter().map(|p| (p / 4.0).clamp(0.0, 1.0)).collect();
        let caption =
            format!("{}: power from 0 (black) to 4 and more (white), |k₁|, |k₂| ≤ {REACH}", pattern.name);
        images.push(Image::of_numbers(caption, (2 * REACH + 1) as u32, &shown).zoomed(2));
        largest.push(peak);
        low.push(inner);
        effort.step(images.len(), patterns.len())?;
    }
    found.show(images);
    found.show(table);
    found.compare(
        Comparison::new("largest power, Hammersley over jittered Hammersley", "", largest[2] / largest[1])
            .says("high aliasing amplitudes, attenuated")
            .demand(Demand::AtLeast(2.0)),
    );
    found.compare(
        Comparison::new("mean power at low frequencies, jittered Hammersley", "", low[1])
            .says("low frequencies are reproduced correctly")
            .demand(Demand::AtMost(0.3)),
    );
    found.compare(
        Comparison::new("mean power at low frequencies, Poisson disk", "", low[0])
            .says("the properties to come near to"),
    );
    found.gap("The report shows amplitudes as grey without a scale, and says neither the least distance of its Poisson disk nor how it was found.");
    Ok(found)
}

fn frequencies() -> impl Iterator<Item = [i32; 2]> {
    (-REACH..=REACH).flat_map(|y| (-REACH..=REACH).map(move |x| [x, y]))
}

/// Row by row; nothing at frequency 0, where every pattern has N.
fn periodogram(pattern: &Pattern, n: u32, draws: u32) -> Vec<f64> {
    let drawn: Vec<Vec<[f64; 2]>> = (0..draws).map(|seed| (pattern.points)(n, seed)).collect();
    let power = |[kx, ky]: [i32; 2]| {
        if (kx, ky) == (0, 0) {
            return 0.0;
        }
        let one = |points: &Vec<[f64; 2]>| {
            let wave = |p: &[f64; 2]| {
                libm::sincos(std::f64::consts::TAU * (f64::from(kx) * p[0] + f64::from(ky) * p[1]))
            };
            let (sin, cos) = points.iter().map(wave).fold((0.0, 0.0), |s, w| (s.0 + w.0, s.1 + w.1));
            (sin * sin + cos * cos) / f64::from(n)
        };
        drawn.iter().map(one).sum::<f64>() / f64::from(draws)
    };
    let places: Vec<[i32; 2]> = frequencies().collect();
    places.into_par_iter().map(power).collect()
}
