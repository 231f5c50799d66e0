//! How even the points of the generators are, over their number and their dimensions.

use super::KELLER96;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::statistics::slope;
use lampyris::sequence::Generator;
use lampyris::sequence::discrepancy::{PointSet, random_star_l2_squared};

pub(crate) const DISCREPANCY: Experiment = Experiment {
    name: "keller96-discrepancy",
    title: "Discrepancy of the generators",
    paper: KELLER96,
    place: "§2 and §4.4",
    claim: "Random points have a discrepancy of O(√(log log N / N)), low-discrepancy points one of O(logˢ N / N).",
    seconds: [2.0, 60.0],
    run: discrepancy,
};

fn discrepancy(effort: &Effort<'_>) -> Result<Findings> {
    let most: u32 = effort.of(512, 4096);
    let seeds = effort.of(16, 32);
    let dimensions = [2, 4, 8, 16];
    let counts: Vec<u32> = (4..).map(|e| 1 << e).take_while(|n| *n <= most).collect();
    let mut found = Findings::default();
    let mut table = Table::new(
        format!(
            "L2 star discrepancy of {most} points over that of random ones in the mean; of {seeds} seeds"
        ),
        ["generator", "s = 2", "s = 4", "s = 8", "s = 16", "exponent over N, s = 2"],
    );
    let mut flat = Plot::new("In 2 dimensions", Axis::log("points, N"), Axis::log("L2 star discrepancy"));
    let mut deep = Plot::new("In 8 dimensions", Axis::log("points, N"), Axis::log("L2 star discrepancy"));
    for (number, generator) in Generator::ALL.into_iter().enumerate() {
        let mut cells = Vec::new();
        let mut power = 0.0;
        for s in dimensions {
            let of = |n: u32| {
                let square = |seed| PointSet::of(generator, s, seed, n).star_l2().powi(2);
                ((0..seeds).map(square).sum::<f64>() / f64::from(seeds)).sqrt()
            };
            let points: Vec<[f64; 2]> = match s {
                2 | 8 => counts.iter().map(|n| [f64::from(*n), of(*n)]).collect(),
                _ => vec![[f64::from(most), of(most)]],
            };
            let random = random_star_l2_squared(s, most).sqrt();
            cells.push(points.last().map_or(f64::NAN, |p| p[1]) / random);
            match s {
                2 => {
                    power = slope(&points);
                    flat = flat.with(Series::line(generator.name(), points));
                }
                8 => deep = deep.with(Series::line(generator.name(), points)),
                _ => {}
            }
            effort.go_on_or_stop()?;
        }
        table.row([
            generator.name().into(),
            digits(cells[0]),
            digits(cells[1]),
            digits(cells[2]),
            digits(cells[3]),
            digits(power),
        ]);
        if generator == Generator::Halton {
            let what = "discrepancy in 16 dimensions, Halton over random points";
            found.compare(Comparison::new(what, "", cells[3]).says("low discrepancy"));
        }
        if matches!(generator, Generator::Congruential | Generator::Halton | Generator::SobolOwen) {
            let what = format!("exponent of the discrepancy over N in 2 dimensions, {}", generator.name());
            let (paper, most) = if generator.is_random() { (-0.5, -0.4) } else { (-1.0, -0.75) };
            let comparison = Comparison::new(what, "", power).paper(paper).says("but for logarithms");
            found.compare(comparison.demand(Demand::AtMost(most)));
        }
        effort.step(number + 1, Generator::ALL.len())?;
    }
    found.show(flat);
    found.show(deep);
    found.show(table);
    found.gap(
        "The paper states orders, not discrepancies, and walks in 16 dimensions, where no sequence of some thousand points is much more \
         even than random ones, and Halton's plain one is far less: neighbouring bases run side by side. What walks gain comes from \
         their first dimensions.",
    );
    Ok(found)
}
