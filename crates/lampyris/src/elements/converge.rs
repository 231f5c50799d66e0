//! How many paths are enough: the termination rule of [Keller96, §4.3].
//!
//! Every ΔN paths the radiances of all elements are compared with those of ΔN paths before:
//!
//! Δ(N₁, N₂) = √(Σ d(L̄_k(N₁), L̄_k(N₂))² |A_k| / (K Σ |A_k|)) / Σ L_{0,k} |A_k|
//!
//! and paths are enough as soon as Δ < ε has held T times in a row. d is the distance of two colours as vectors. The paper
//! prints no K under the root, but with it alone its figures come out, as its Δ_aw has it; and it says nothing of lamps
//! that are no surfaces: here L₀ |A| is luminous flux over π, of whatever shines.
//!
//! The rule watches how much an estimate changes, not how wrong it is: a sequence of low discrepancy errs less than
//! a random one that stops with it (docs/light-transport.md).

use super::{ElementLight, Elements};
use crate::color::Rgb;
use crate::scatter::RandomWalk;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Steps that are walked at once, before each is looked at in its turn.
const WAVE: u32 = 8;

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Criterion {
    /// ε [m⁻²].
    pub epsilon: f64,
    /// ΔN.
    pub step: u32,
    /// T.
    pub times: u32,
    /// Paths after which to give up.
    pub most: u32,
}

impl Default for Criterion {
    /// That of [Keller96, Table 1]: ε = 10⁻⁴, ΔN = 1000, T = 2; four million paths at most.
    fn default() -> Criterion {
        Criterion { epsilon: 1e-4, step: 1000, times: 2, most: 4_000_000 }
    }
}

impl Criterion {
    /// The same for a scene of another size: ε is one over an area, and 10⁻⁴ is what Table 1 asks of a cube of 6 m².
    pub fn scaled_to(self, elements: &Elements) -> Criterion {
        Criterion { epsilon: self.epsilon * 6.0 / elements.total_area().max(f64::MIN_POSITIVE), ..self }
    }
}

/// What a walk came to.
#[derive(Clone, Debug)]
pub struct Converged {
    /// N, where the rule stopped it; `None` where it gave up.
    pub paths: Option<u32>,
    /// The light of all paths until then.
    pub light: ElementLight,
    /// Δ(n ΔN, (n + 1) ΔN) for n = 1, 2, … [m⁻²].
    pub changes: Vec<f64>,
}

/// Walks paths from number 0 on until they are enough. The same bits on any number of threads.
pub fn converge(walk: &RandomWalk<'_>, elements: &Elements, criterion: &Criterion) -> Converged {
    let Criterion { epsilon, step, times, most } = *criterion;
    let step = step.max(1);
    let mut done = Converged { paths: None, light: ElementLight::new(elements), changes: Vec::new() };
    let mut before: Option<Vec<[f64; 3]>> = None;
    let (mut held, mut walked) = (0, 0);
    let scale = 1.0 / (emitted(walk) * (elements.len() as f64 * elements.total_area()).sqrt());
    while walked < most / step {
        let wave = walked..walked.saturating_add(WAVE).min(most / step);
        let pieces: Vec<(Vec<(u32, Rgb)>, u64)> =
            wave.into_par_iter().map(|n| piece(walk, elements, n * step, step)).collect();
        for (left, rays) in pieces {
            walked += 1;
            done.light.add(&left, step, rays);
            let now: Vec<[f64; 3]> =
                (0..elements.len() as u32).map(|k| done.light.exact(elements, k)).collect();
            if let Some(before) = &before {
                let change = distance(before, &now, elements) * scale;
                done.changes.push(change);
                held = if change < epsilon { held + 1 } else { 0 };
                if held >= times {
                    done.paths = Some(walked * step);
                    return done;
                }
            }
            before = Some(now);
        }
    }
    done
}

fn piece(walk: &RandomWalk<'_>, elements: &Elements, first: u32, count: u32) -> (Vec<(u32, Rgb)>, u64) {
    let (mut left, mut rays) = (Vec::new(), 0);
    for number in first..first + count {
        rays += u64::from(walk.path(number, |arrival| {
            elements.lit_by(walk.world(), arrival, |element, flux| left.push((element, flux)));
        }));
    }
    (left, rays)
}

/// √Σ d² |A_k|.
fn distance(before: &[[f64; 3]], now: &[[f64; 3]], elements: &Elements) -> f64 {
    let pairs = (0..).zip(before.iter().zip(now));
    let squares = pairs.map(|(k, (a, b))| {
        let d2: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
        d2 * f64::from(elements.area(k))
    });
    squares.sum::<f64>().sqrt()
}

/// Σ L₀ |A| [cd].
fn emitted(walk: &RandomWalk<'_>) -> f64 {
    let bounds = walk.world().bounds();
    let power = |(number, _): (u32, f64)| {
        f64::from(walk.world().emitters()[number as usize].power(bounds).luminance())
    };
    walk.lamps().shares().map(power).sum::<f64>() / PI
}
