//! How far a frame can be trusted: the spread of its randomisations, and how much of each layer is shown filtered by it.

use super::Frame;
use super::layer::{Blocks, Layer, Replicate, probe};
use super::still::{Standing, own_color};
use crate::color::Rgb;
use crate::testing::student_quantile;
use rayon::prelude::*;

/// Randomisations that settings may ask for.
const MOST_REPLICATES: usize = 64;

impl Frame {
    /// How much of each layer is shown filtered: by the mean over pixels of its variance, as the spread of its
    /// randomisations promises it, over the square of the whole picture, dark pixels measured against a tenth of the mean;
    /// as if all layers varied like it. All of it before two randomisations have a batch. One pixel of each block stands
    /// for all.
    pub(super) fn filtered_shares(&self) -> Vec<f32> {
        let Some(first) = self.layers.first().filter(|_| self.filtered) else {
            return vec![0.0; self.layers.len()];
        };
        let held = self.standing();
        let mut means = vec![0.0; first.replicates[0].probes.len()];
        for (number, layer) in self.layers.iter().enumerate() {
            let color = own_color(&held, number, layer.color);
            for (at, mean) in means.iter_mut().enumerate() {
                let sum = layer.replicates.iter().fold(Rgb::BLACK, |sum, r| sum + r.probes[at]);
                *mean += f64::from((color * sum).luminance() * layer.scale());
            }
        }
        for Standing { plane, share, .. } in &held {
            for (at, mean) in means.iter_mut().enumerate() {
                let pixel = self.probe(at).map_or(Rgb::BLACK, |pixel| plane[pixel]);
                *mean += f64::from((pixel * *share).luminance());
            }
        }
        let tenth = 0.1 * means.iter().sum::<f64>() / means.len().max(1) as f64;
        let share = |layer: &Layer| {
            let alone = std::slice::from_ref(layer);
            let used = used(alone);
            if used.len() < 2 {
                return 1.0;
            }
            let error = |(at, mean): (usize, &f64)| {
                let (_, variance) = moments(alone, &used, |replicate| replicate.probes[at]);
                variance / (mean * mean + tenth * tenth).max(1e-30)
            };
            let error = means.iter().enumerate().map(error).sum::<f64>() / means.len().max(1) as f64;
            filtered_share(error * self.layers.len() as f64)
        };
        self.layers.par_iter().map(share).collect()
    }

    /// Where the pixel lies that stands for a block; `None` where that is outside of the picture.
    fn probe(&self, block: usize) -> Option<usize> {
        let Blocks { edge, columns, .. } = self.blocks();
        let [x, y] = probe(block, edge);
        let (x, y) = ((block % columns) as u32 * edge + x, (block / columns) as u32 * edge + y);
        (x < self.width && y < self.height).then_some(y as usize * self.width as usize + x as usize)
    }

    /// Standard error of the luminance of one pixel's mean, from the spread of the randomisations [cd/m²]; in a picture of
    /// more than one row, of the mean over the block of 8 × 8 pixels around it. Infinite before each of two has a batch.
    pub fn standard_error(&self, pixel: usize) -> f32 {
        let (used, Blocks { edge, columns, .. }) = (used(&self.layers), self.blocks());
        if used.len() < 2 {
            return f32::INFINITY;
        }
        let (x, y) = (pixel as u32 % self.width, pixel as u32 / self.width);
        let at = (y / edge) as usize * columns + (x / edge) as usize;
        let size = |length: u32, at: u32| edge.min(length - at / edge * edge);
        let pixels = size(self.width, x) * size(self.height, y);
        let (_, variance) = moments(&self.layers, &used, |replicate| replicate.blocks[at]);
        (variance.sqrt() / f64::from(pixels)) as f32
    }

    /// Standard error of the picture's mean luminance, relative to it.
    pub fn relative_error(&self) -> f32 {
        let used = used(&self.layers);
        if used.len() < 2 {
            return f32::INFINITY;
        }
        let sum = |replicate: &Replicate| {
            let [r, g, b] = [|c: &Rgb| c.r, |c: &Rgb| c.g, |c: &Rgb| c.b]
                .map(|channel| replicate.blocks.iter().map(|c| f64::from(channel(c))).sum::<f64>() as f32);
            Rgb::new(r, g, b)
        };
        let (mean, variance) = moments(&self.layers, &used, sum);
        if mean == 0.0 { 0.0 } else { (variance.sqrt() / mean).abs() as f32 }
    }

    /// Half the width of Student's 95 % interval, in standard errors.
    pub fn student_factor(&self) -> f32 {
        let used = used(&self.layers).len();
        if used < 2 { f32::INFINITY } else { student_quantile(0.05, used as f64 - 1.0) as f32 }
    }
}

/// Randomisations of which each of some layers has a batch.
fn used(layers: &[Layer]) -> Vec<usize> {
    let count = layers.first().map_or(0, |layer| layer.replicates.len());
    let has = |k: &usize| layers.iter().all(|layer| layer.replicates[*k].batches > 0);
    (0..count).filter(has).collect()
}

/// Luminance of the mean of some layers together, and its variance, of what `sum` tells of each randomisation, from n_k
/// batches each: the variance of one batch is estimated by Σ n_k (m_k − m)² / (r − 1). Where layers have more batches or
/// less, n_k is the least of them.
fn moments(layers: &[Layer], used: &[usize], sum: impl Fn(&Replicate) -> Rgb) -> (f64, f64) {
    let of = |k: &usize| {
        let replicates = || layers.iter().map(|layer| (layer.color, &layer.replicates[*k]));
        let least = replicates().map(|(_, r)| r.batches).min().unwrap_or(0);
        let mean =
            |(color, r): (Rgb, &Replicate)| f64::from((color * sum(r)).luminance()) / f64::from(r.batches);
        (f64::from(least), replicates().map(mean).sum::<f64>())
    };
    let mut all = [(0.0, 0.0); MOST_REPLICATES];
    let all = &mut all[..used.len().min(MOST_REPLICATES)];
    all.iter_mut().zip(used).for_each(|(found, k)| *found = of(k));
    mean_and_variance(all)
}

/// The mean of all batches, and its variance, of two randomisations or more: of each how many batches it has, and their
/// mean.
pub(crate) fn mean_and_variance(all: &[(f64, f64)]) -> (f64, f64) {
    let n: f64 = all.iter().map(|(n, _)| n).sum();
    let mean = all.iter().map(|(n, m)| n * m).sum::<f64>() / n;
    let squares = all.iter().map(|(n, m)| n * (m - mean).powi(2));
    (mean, squares.sum::<f64>() / (all.len() - 1) as f64 / n)
}

/// Squared relative errors between which the unfiltered mean takes over: what filtering leaves lies about the smaller.
const EXCHANGE: [f64; 2] = [5e-5, 2e-4];

/// How much of the filtered picture is shown at an estimated squared relative error of the unfiltered.
fn filtered_share(error: f64) -> f32 {
    let [low, high] = EXCHANGE;
    ((error - low) / (high - low)).clamp(0.0, 1.0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eye::Rect;
    use crate::settings::Settings;

    #[test]
    fn the_interval_is_students() {
        let mut frame = Frame::new(1, 1, &["direct"], &Settings { replicates: 4, ..Settings::default() }, 1);
        for (k, v) in (0..).zip([1.0, 2.0, 3.0, 4.0]) {
            frame.add(k, &[(0, vec![(Rect { x: 0, y: 0, width: 1, height: 1 }, vec![vec![Rgb::grey(v)]])])]);
            frame.count(0, k);
        }
        // Four values of variance 5/3, three degrees of freedom: the tables say 3.182.
        assert!((frame.standard_error(0) - (5.0f32 / 12.0).sqrt()).abs() < 1e-6);
        assert!((frame.student_factor() - 3.182_446).abs() < 1e-5);
    }

    /// A layer that began anew is shown filtered, and the others stay as they are.
    #[test]
    fn layers_are_shown_each_by_its_own_error() {
        let settings = Settings { replicates: 4, filter: true, ..Settings::default() };
        let mut frame = Frame::new(8, 8, &[], &settings, 3);
        let rect = Rect { x: 0, y: 0, width: 8, height: 8 };
        let batch = |value: f32| vec![(rect, vec![vec![Rgb::grey(value); 64]])];
        for (k, noise) in (0..4).zip([0.01, -0.01, 0.01, -0.01]) {
            frame.add(k, &[(0, batch(1.0)), (2, batch(1.0 + noise))]);
            [0, 2].into_iter().for_each(|layer| frame.count(layer, k));
        }
        assert_eq!(frame.filtered_shares(), [0.0, 1.0, 0.0]);
        frame.add(0, &[(1, batch(1.0))]);
        frame.count(1, 0);
        assert_eq!(frame.filtered_shares(), [0.0, 1.0, 0.0]);
        frame.restart(2);
        for (k, noise) in (0..4).zip([0.03, -0.03, 0.03, -0.03]) {
            frame.add(k, &[(2, batch(1.0 + noise))]);
            frame.count(2, k);
        }
        // Batches of variance .0012, of their mean .0003; three layers, over a picture of 3 and a tenth of its mean.
        let error = 3.0 * 0.0003 / (3.0_f64.powi(2) + 0.3_f64.powi(2));
        let expected = ((error - EXCHANGE[0]) / (EXCHANGE[1] - EXCHANGE[0])) as f32;
        let shares = frame.filtered_shares();
        assert!(shares[0] == 0.0 && shares[1] == 1.0 && (shares[2] - expected).abs() < 1e-3, "{shares:?}");
    }
}
