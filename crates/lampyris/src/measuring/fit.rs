//! Levels that bring meters to their targets. Light adds up, so a meter reads Σ a_j x_j of the levels x of light groups that
//! give it a_j at level 1; levels are not negative, and lamps have a most. Hence least squares with bounds, by active sets
//! [Lawson and Hanson 1974, ch. 23], with upper bounds too.

use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};

/// Most levels and meters of a fit.
const MOST: (usize, usize) = (64, 1000);

/// Pull that is always there: of levels that no meter tells apart it keeps those nearest to what is.
const LEAST_PULL: f64 = 1e-8;

/// Slope, as a share of the targets, that counts as none.
const FLAT: f64 = 1e-12;

/// What is wanted of levels.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// Of each meter what each level gives it at 1 [lx].
    pub rows: Vec<Vec<f64>>,
    /// Of each meter what it should read [lx].
    pub targets: Vec<f64>,
    /// The levels as they are, from 0.
    pub present: Vec<f64>,
    /// The greatest that each level may have; infinite where nothing bounds it.
    pub most: Vec<f64>,
    /// How strongly levels are held where they are, against what they do to the meters: 0 not at all, 1 as strongly.
    pub pull: f64,
}

/// Where a level stands.
#[derive(Clone, Copy, PartialEq)]
enum At {
    Zero,
    Most,
    Between,
}

impl Fit {
    /// The levels that minimise Σ (reading − target)² + pull · Σ (what each level's change gives all meters)². What gives no
    /// meter anything stays as it is.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for lists that do not fit together, numbers that make no sense, and more than 64 levels or 1000
    /// meters.
    pub fn solve(&self) -> Result<Vec<f64>> {
        self.check()?;
        let count = self.present.len();
        let norm = |j: usize| self.rows.iter().map(|row| row[j] * row[j]).sum::<f64>().sqrt();
        let norms: Vec<f64> = (0..count).map(norm).collect();
        let known = |j: &usize| norms[*j] > 0.0;
        let used: Vec<usize> = (0..count).filter(known).collect();
        // In units of what each level does, all levels are alike.
        let pull = self.pull.max(LEAST_PULL);
        let product = |j: usize, k: usize| {
            let both = self.rows.iter().map(|row| (row[j] / norms[j]) * (row[k] / norms[k])).sum::<f64>();
            if j == k { both + pull } else { both }
        };
        let toward = |j: usize| {
            let meters = self.rows.iter().zip(&self.targets).map(|(row, target)| row[j] / norms[j] * target);
            meters.sum::<f64>() + pull * self.present[j] * norms[j]
        };
        let square: Vec<Vec<f64>> =
            used.iter().map(|j| used.iter().map(|k| product(*j, *k)).collect()).collect();
        let right: Vec<f64> = used.iter().map(|j| toward(*j)).collect();
        let most: Vec<f64> = used.iter().map(|j| self.most[*j] * norms[*j]).collect();
        let mut levels: Vec<f64> =
            self.present.iter().zip(&self.most).map(|(x, most)| x.min(*most)).collect();
        for (k, x) in bounded(&square, &right, &most).into_iter().enumerate() {
            let j = used[k];
            // At a bound it is that bound, whatever its unit rounds to.
            levels[j] = if x == most[k] { self.most[j] } else { (x / norms[j]).clamp(0.0, self.most[j]) };
        }
        Ok(levels)
    }

    fn check(&self) -> Result<()> {
        let bad = |what: &str| Err(Error::BadSetting(format!("cannot set the mix: {what}")));
        let (levels, meters) = (self.present.len(), self.rows.len());
        if levels > MOST.0 || meters > MOST.1 {
            return bad("there may be 64 levels and 1000 meters");
        }
        if meters != self.targets.len()
            || levels != self.most.len()
            || self.rows.iter().any(|r| r.len() != levels)
        {
            return bad("each meter needs a target and a reading for each level, each level a bound");
        }
        // Squares of larger ones leave the range of numbers.
        let sound = |v: &f64| v.abs() < 1e100;
        let held = self.present.iter().all(|x| *x >= 0.0 && sound(x)) && (0.0..1e6).contains(&self.pull);
        let lit = self.rows.iter().flatten().chain(&self.targets).all(sound);
        if !held || !lit || !self.most.iter().all(|most| *most >= 0.0) {
            return bad("a number makes no sense");
        }
        Ok(())
    }
}

/// Minimises xᵀ G x/2 − cᵀ x for 0 ≤ x ≤ most, G positive definite.
fn bounded(square: &[Vec<f64>], right: &[f64], most: &[f64]) -> Vec<f64> {
    let count = right.len();
    let mut x = vec![0.0; count];
    let mut at: Vec<At> = most.iter().map(|m| if *m > 0.0 { At::Zero } else { At::Most }).collect();
    let flat = FLAT * right.iter().map(|r| r * r).sum::<f64>().sqrt();
    let dot = |j: usize, x: &[f64]| square[j].iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
    // Each round lowers the sum of squares; the bound is for rounding, which could keep two sets in turn.
    for _ in 0..16 * count {
        // The level that gains most by leaving its bound.
        let gain = |j: &usize| {
            let slope = right[*j] - dot(*j, &x);
            match at[*j] {
                At::Zero => slope,
                At::Most if most[*j] > 0.0 => -slope,
                _ => 0.0,
            }
        };
        let best = (0..count).max_by(|a, b| gain(a).total_cmp(&gain(b))).filter(|j| gain(j) > flat);
        let Some(freed) = best else { break };
        at[freed] = At::Between;
        // Toward the least of the free ones, as far as the first bound; again, without what it met.
        while at.contains(&At::Between) {
            let goal = free_least(square, right, &x, &at);
            let step = |j: usize| match at[j] {
                At::Between if goal[j] < 0.0 => x[j] / (x[j] - goal[j]),
                At::Between if goal[j] > most[j] => (most[j] - x[j]) / (goal[j] - x[j]),
                _ => 1.0,
            };
            let steps: Vec<f64> = (0..count).map(step).collect();
            let whole = steps.iter().copied().fold(1.0, f64::min).max(0.0);
            for j in (0..count).filter(|j| at[*j] == At::Between).collect::<Vec<_>>() {
                x[j] += (goal[j] - x[j]) * whole;
                if whole < 1.0 && steps[j] <= whole {
                    at[j] = if goal[j] < 0.0 { At::Zero } else { At::Most };
                    x[j] = if goal[j] < 0.0 { 0.0 } else { most[j] };
                }
            }
            if whole == 1.0 {
                break;
            }
        }
    }
    x
}

/// The least over the free ones, the others held where they are: by Cholesky's decomposition.
fn free_least(square: &[Vec<f64>], right: &[f64], x: &[f64], at: &[At]) -> Vec<f64> {
    let free: Vec<usize> = (0..x.len()).filter(|j| at[*j] == At::Between).collect();
    let held =
        |j: usize| (0..x.len()).filter(|k| at[*k] != At::Between).map(|k| square[j][k] * x[k]).sum::<f64>();
    let mut factor: Vec<Vec<f64>> = Vec::with_capacity(free.len());
    let mut solved: Vec<f64> = Vec::with_capacity(free.len());
    for (row, j) in free.iter().enumerate() {
        let mut line = vec![0.0; row + 1];
        for column in 0..row {
            let known: f64 = (0..column).map(|k| line[k] * factor[column][k]).sum();
            line[column] = (square[*j][free[column]] - known) / factor[column][column];
        }
        let left = square[*j][*j] - line.iter().map(|l| l * l).sum::<f64>();
        // Rounding can eat up what the pull has left of a level that others make up for.
        line[row] = left.max(LEAST_PULL * LEAST_PULL).sqrt();
        let known: f64 = solved.iter().zip(&line).map(|(s, l)| s * l).sum();
        solved.push((right[*j] - held(*j) - known) / line[row]);
        factor.push(line);
    }
    let mut goal = x.to_vec();
    for row in (0..free.len()).rev() {
        let known: f64 = (row + 1..free.len()).map(|k| factor[k][row] * goal[free[k]]).sum();
        goal[free[row]] = (solved[row] - known) / factor[row][row];
    }
    goal
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::{hash, unit_f32};

    fn random(seed: u32, levels: usize, meters: usize) -> Fit {
        let mut count = 0;
        let mut unit = move || {
            count += 1;
            f64::from(unit_f32(hash(seed, count)))
        };
        // Some see no light of some lamps, and lamps differ by powers of ten.
        let strengths: Vec<f64> = (0..levels).map(|_| libm::pow(10.0, 4.0 * unit())).collect();
        let mut lux = |j: usize| if unit() < 0.3 { 0.0 } else { unit() * strengths[j] };
        let rows: Vec<Vec<f64>> = (0..meters).map(|_| (0..levels).map(&mut lux).collect()).collect();
        let strong = seed % 3;
        let targets = (0..meters).map(|k| 300.0 + 100.0 * f64::from(hash(seed, k as u32) % 7)).collect();
        let bound = |j: usize| match strong {
            0 => f64::INFINITY,
            1 => 1.0,
            _ => 0.1 * f64::from(hash(seed, 99 + j as u32) % 20),
        };
        let most: Vec<f64> = (0..levels).map(bound).collect();
        let present = most.iter().map(|m| 0.5 * m.min(1.0)).collect();
        Fit { rows, targets, present, most, pull: [1e-6, 0.01, 1.0][seed as usize / 3 % 3] }
    }

    fn cost(fit: &Fit, x: &[f64]) -> f64 {
        let read = |row: &Vec<f64>| row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        let missed: f64 =
            fit.rows.iter().zip(&fit.targets).map(|(row, t)| (read(row) - t) * (read(row) - t)).sum();
        let norm = |j: usize| fit.rows.iter().map(|row| row[j] * row[j]).sum::<f64>();
        let moved = |j: usize| norm(j) * (x[j] - fit.present[j]) * (x[j] - fit.present[j]);
        missed + fit.pull.max(LEAST_PULL) * (0..x.len()).map(moved).sum::<f64>()
    }

    /// The conditions of Karush, Kuhn and Tucker, which hold at the least of a convex function and nowhere else: no slope
    /// where a level is free, uphill where it stands at a bound.
    #[test]
    fn slopes_are_those_of_the_least() {
        let (mut zeros, mut mosts, mut between) = (0, 0, 0);
        for seed in 0..300 {
            let (levels, meters) = (1 + seed as usize % 64, 1 + seed as usize * 7 % 120);
            let fit = random(seed, levels, meters);
            let x = fit.solve().expect("sound");
            let residuals: Vec<f64> = (fit.rows.iter().zip(&fit.targets))
                .map(|(row, target)| row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() - target)
                .collect();
            let size = fit.targets.iter().map(|t| t * t).sum::<f64>().sqrt();
            for j in 0..levels {
                let norm = fit.rows.iter().map(|row| row[j] * row[j]).sum::<f64>().sqrt();
                if norm == 0.0 {
                    assert_eq!(x[j], fit.present[j].min(fit.most[j]));
                    continue;
                }
                let slope = fit.rows.iter().zip(&residuals).map(|(row, r)| row[j] / norm * r).sum::<f64>()
                    + fit.pull * norm * (x[j] - fit.present[j]);
                let none = 1e-7 * size;
                assert!(x[j] >= 0.0 && x[j] <= fit.most[j]);
                match x[j] {
                    v if v == fit.most[j] => {
                        mosts += 1;
                        assert!(slope < none || fit.most[j] == 0.0, "{seed}: {slope} at the most");
                    }
                    0.0 => {
                        zeros += 1;
                        assert!(slope > -none, "{seed}: {slope} at zero");
                    }
                    _ => {
                        between += 1;
                        assert!(slope.abs() < none, "{seed}: {slope} at {}", x[j]);
                    }
                }
            }
        }
        assert!(zeros > 500 && mosts > 500 && between > 500, "{zeros} {mosts} {between}");
    }

    /// No choice of bounds gives less, all of them tried.
    #[test]
    fn nothing_is_less() {
        for seed in 0..60 {
            let fit = random(seed, 4, 6);
            let found = cost(&fit, &fit.solve().expect("sound"));
            for k in 0..4096u32 {
                let part = |j: usize| f64::from((k >> (3 * j)) & 7) / 7.0;
                let x: Vec<f64> = (0..4).map(|j| part(j) * fit.most[j].min(3.0)).collect();
                assert!(found <= cost(&fit, &x) * (1.0 + 1e-9), "{seed}: {found} at {x:?}");
            }
        }
    }

    #[test]
    fn known_cases() {
        let fit = |rows: &[&[f64]], targets: &[f64]| {
            let levels = rows[0].len();
            Fit {
                rows: rows.iter().map(|row| row.to_vec()).collect(),
                targets: targets.to_vec(),
                present: vec![1.0; levels],
                most: vec![f64::INFINITY; levels],
                pull: 0.0,
            }
        };
        // As exact as the least pull lets it be.
        let near = |found: Vec<f64>, expected: &[f64]| {
            assert!(
                found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-6 * b.max(1.0)),
                "{found:?} {expected:?}"
            );
        };
        near(fit(&[&[200.0, 0.0], &[0.0, 50.0]], &[500.0, 500.0]).solve().expect("sound"), &[2.5, 10.0]);
        // One that would have to take light away stays dark: (2, −1) without bounds, (1.5, 0) with.
        near(fit(&[&[1.0, 1.0], &[1.0, 0.0]], &[1.0, 2.0]).solve().expect("sound"), &[1.5, 0.0]);
        // The most of one is made up for by the other.
        let bounded = Fit { most: vec![1.0, 9.0], ..fit(&[&[300.0, 100.0]], &[600.0]) };
        let x = bounded.solve().expect("sound");
        near(vec![300.0 * x[0] + 100.0 * x[1]], &[600.0]);
        // Lamps that no meter tells apart share the work evenly; what no meter sees stays.
        near(fit(&[&[100.0, 100.0, 0.0]], &[300.0]).solve().expect("sound"), &[1.5, 1.5, 1.0]);
        // Held strongly, levels go half of the way.
        near(Fit { pull: 1.0, ..fit(&[&[100.0]], &[300.0]) }.solve().expect("sound"), &[2.0]);
        near(fit(&[&[100.0]], &[0.0]).solve().expect("sound"), &[0.0]);
        assert_eq!(Fit::default().solve().expect("nothing to do"), [0.0; 0]);
    }

    #[test]
    fn senseless_wishes_are_refused() {
        let good = random(1, 3, 4);
        let broken = [
            Fit { targets: vec![1.0; 3], ..good.clone() },
            Fit { most: vec![1.0; 2], ..good.clone() },
            Fit { rows: vec![vec![1.0; 2]; 4], ..good.clone() },
            Fit { targets: vec![f64::NAN; 4], ..good.clone() },
            Fit { rows: vec![vec![f64::INFINITY; 3]; 4], ..good.clone() },
            Fit { present: vec![-1.0; 3], ..good.clone() },
            Fit { most: vec![f64::NAN; 3], ..good.clone() },
            Fit { pull: -1.0, ..good.clone() },
            random(0, 65, 2),
            random(0, 2, 1001),
        ];
        assert!(broken.iter().all(|fit| matches!(fit.solve(), Err(Error::BadSetting(_)))));
        assert!(good.solve().is_ok());
    }
}
