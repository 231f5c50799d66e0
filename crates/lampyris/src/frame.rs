//! Sums of batches: one plane a part, one a randomisation. The only mutable thing that outlives a batch.
//! No filter ever writes into them; what filtered batches show is summed beside. Means and errors are asked for, never
//! stored.

use crate::color::Rgb;
use crate::eye::Rect;
use crate::settings::Settings;
use crate::testing::student_quantile;
use rayon::prelude::*;

/// The sums of a picture, or of a list of meters (then one row).
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Name and plane of each part's sum over all batches.
    parts: Vec<(String, Vec<Rgb>)>,
    /// Luminance, Σ over the batches of randomisation k, all parts together.
    replicates: Vec<Vec<f32>>,
    /// Batches added to each randomisation.
    batches: Vec<u32>,
    /// Σ over the batches of what each shows, if filtered.
    shown: Option<Vec<Rgb>>,
    auxiliary: Option<Auxiliary>,
}

/// Means of what the eye meets first, pixel by pixel.
#[derive(Clone, Debug, Default)]
pub struct Auxiliary {
    /// Sum of directional albedos.
    pub albedo: Vec<Rgb>,
    /// Sum of shading normals, as (x, y, z).
    pub normal: Vec<Rgb>,
    /// Sum of distances to the first surface [m]; 0 where the eye looks into the void.
    pub depth: Vec<f32>,
    /// 1 + number of the instance seen at the pixel's first sample; 0 for the void.
    pub object: Vec<u32>,
    /// Samples in the sums.
    pub samples: u32,
}

impl Auxiliary {
    pub(crate) fn new(pixels: usize) -> Auxiliary {
        Auxiliary {
            albedo: vec![Rgb::BLACK; pixels],
            normal: vec![Rgb::BLACK; pixels],
            depth: vec![0.0; pixels],
            object: vec![0; pixels],
            samples: 0,
        }
    }

    /// Adds pixel `from` of `other` to pixel `at`.
    pub(crate) fn add(&mut self, at: usize, other: &Auxiliary, from: usize) {
        self.albedo[at] += other.albedo[from];
        self.normal[at] += other.normal[from];
        self.depth[at] += other.depth[from];
        if self.object[at] == 0 {
            self.object[at] = other.object[from];
        }
    }
}

impl Frame {
    /// An empty frame.
    pub fn new(width: u32, height: u32, parts: &[&str], settings: &Settings) -> Frame {
        let pixels = width as usize * height as usize;
        Frame {
            width,
            height,
            parts: parts.iter().map(|n| ((*n).to_owned(), vec![Rgb::BLACK; pixels])).collect(),
            replicates: vec![vec![0.0; pixels]; settings.replicates as usize],
            batches: vec![0; settings.replicates as usize],
            shown: settings.filter.then(|| vec![Rgb::BLACK; pixels]),
            auxiliary: settings.auxiliary.then(|| Auxiliary::new(pixels)),
        }
    }

    /// Batches added so far.
    pub fn batches(&self) -> u32 {
        self.batches.iter().sum()
    }

    /// Names of the parts.
    pub fn part_names(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().map(|(n, _)| n.as_str())
    }

    /// The mean of one part over all batches, row by row from the top; `None` if it was not rendered.
    pub fn part(&self, name: &str) -> Option<Vec<Rgb>> {
        let scale = 1.0 / self.batches().max(1) as f32;
        let (_, plane) = self.parts.iter().find(|(n, _)| n == name)?;
        Some(plane.iter().map(|s| *s * scale).collect())
    }

    /// The picture: the mean of all parts together.
    pub fn mean(&self) -> Vec<Rgb> {
        let scale = 1.0 / self.batches().max(1) as f32;
        let mut mean = vec![Rgb::BLACK; self.width as usize * self.height as usize];
        for (_, plane) in &self.parts {
            mean.iter_mut().zip(plane).for_each(|(m, s)| *m += *s * scale);
        }
        mean
    }

    /// The picture to show: the mean of the filtered batches, if they were, as long as the error of the mean itself would
    /// be visible. The one turns into the other by degrees.
    pub fn shown(&self) -> Vec<Rgb> {
        let mut mean = self.mean();
        let Some(filtered) = &self.shown else { return mean };
        let share = filtered_share(self.visible_error());
        let scale = 1.0 / self.batches().max(1) as f32;
        let mix = |(m, s): (&mut Rgb, &Rgb)| *m = *m * (1.0 - share) + *s * (share * scale);
        mean.iter_mut().zip(filtered).for_each(mix);
        mean
    }

    /// The mean over all pixels of the squared relative error that the spread of the randomisations promises, dark pixels
    /// measured against a tenth of the mean; infinite before two of them have a batch.
    fn visible_error(&self) -> f64 {
        let used = || (0..self.batches.len()).filter(|k| self.batches[*k] > 0);
        let count = used().count();
        if count < 2 {
            return f64::INFINITY;
        }
        let n = self.batches() as f32;
        let means: Vec<f32> = (0..self.replicates[0].len())
            .map(|at| used().map(|k| self.replicates[k][at]).sum::<f32>() / n)
            .collect();
        let tenth = 0.1 * means.iter().map(|m| f64::from(*m)).sum::<f64>() / means.len().max(1) as f64;
        let floor = (tenth * tenth) as f32;
        let error = |(at, mean): (usize, &f32)| {
            let squares = used().map(|k| {
                let nk = self.batches[k] as f32;
                nk * (self.replicates[k][at] / nk - mean).powi(2)
            });
            let variance = squares.sum::<f32>() / ((count - 1) as f32 * n);
            f64::from(variance / (mean * mean + floor).max(f32::MIN_POSITIVE))
        };
        means.iter().enumerate().map(error).sum::<f64>() / means.len().max(1) as f64
    }

    /// Standard error of the luminance of one pixel's mean, from the spread of the randomisations [cd/m²];
    /// infinite before each of two has a batch.
    pub fn standard_error(&self, pixel: usize) -> f32 {
        self.spread(|k| self.replicates[k][pixel].into()) as f32
    }

    /// Standard error of the picture's mean luminance, relative to it.
    pub fn relative_error(&self) -> f32 {
        let sums: Vec<f64> = self.replicates.iter().map(|p| p.iter().map(|s| f64::from(*s)).sum()).collect();
        let mean = sums.iter().sum::<f64>() / f64::from(self.batches().max(1));
        if mean == 0.0 { 0.0 } else { (self.spread(|k| sums[k]) / mean).abs() as f32 }
    }

    /// Half the width of Student's 95 % interval, in standard errors.
    pub fn student_factor(&self) -> f32 {
        let used = self.batches.iter().filter(|n| **n > 0).count();
        if used < 2 { f32::INFINITY } else { student_quantile(0.05, used as f64 - 1.0) as f32 }
    }

    /// What the eye met first, if it was asked for.
    pub fn auxiliary(&self) -> Option<&Auxiliary> {
        self.auxiliary.as_ref()
    }

    /// Adds a batch of randomisation `replicate`: rectangles of the picture, each with the values of the parts in the order
    /// of `part_names`, row by row.
    pub fn add(&mut self, replicate: u32, tiles: &[(Rect, Vec<Vec<Rgb>>)]) {
        let Frame { width, parts, replicates, .. } = self;
        let luminance = &mut replicates[replicate as usize];
        let places = |rect: &Rect| {
            let (left, width) = (rect.x as usize, *width as usize);
            (rect.y as usize..(rect.y + rect.height) as usize).map(move |row| row * width + left)
        };
        let add_parts = || {
            parts.par_iter_mut().enumerate().for_each(|(number, (_, sum))| {
                for (rect, values) in tiles {
                    let rows = values[number].chunks(rect.width as usize);
                    for (at, values) in places(rect).zip(rows) {
                        sum[at..at + values.len()].iter_mut().zip(values).for_each(|(s, v)| *s += *v);
                    }
                }
            });
        };
        let add_luminance = || {
            for (rect, values) in tiles {
                for values in values {
                    for (at, values) in places(rect).zip(values.chunks(rect.width as usize)) {
                        let pairs = luminance[at..at + values.len()].iter_mut().zip(values);
                        pairs.for_each(|(s, v)| *s += v.luminance());
                    }
                }
            }
        };
        rayon::join(add_parts, add_luminance);
    }

    /// A batch of randomisation `replicate` is complete: every pixel of it was added once.
    pub fn count(&mut self, replicate: u32) {
        self.batches[replicate as usize] += 1;
    }

    pub(crate) fn shown_mut(&mut self) -> Option<&mut Vec<Rgb>> {
        self.shown.as_mut()
    }

    pub(crate) fn auxiliary_mut(&mut self) -> Option<&mut Auxiliary> {
        self.auxiliary.as_mut()
    }

    /// Standard error of Σ/n from the sums of the randomisations, of n_k batches each: the variance of one batch is
    /// estimated by Σ n_k (m_k − m)² / (r − 1).
    fn spread(&self, sum: impl Fn(usize) -> f64) -> f64 {
        let used: Vec<usize> = (0..self.batches.len()).filter(|k| self.batches[*k] > 0).collect();
        if used.len() < 2 {
            return f64::INFINITY;
        }
        let n: f64 = f64::from(self.batches());
        let mean = used.iter().map(|k| sum(*k)).sum::<f64>() / n;
        let squares = used.iter().map(|k| {
            let nk = f64::from(self.batches[*k]);
            nk * (sum(*k) / nk - mean).powi(2)
        });
        (squares.sum::<f64>() / (used.len() - 1) as f64 / n).sqrt()
    }
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

    #[test]
    fn the_interval_is_students() {
        let mut frame = Frame::new(1, 1, &["direct"], &Settings { replicates: 4, ..Settings::default() });
        for (k, v) in (0..).zip([1.0, 2.0, 3.0, 4.0]) {
            frame.add(k, &[(Rect { x: 0, y: 0, width: 1, height: 1 }, vec![vec![Rgb::grey(v)]])]);
            frame.count(k);
        }
        // Four values of variance 5/3, three degrees of freedom: the tables say 3.182.
        assert!((frame.standard_error(0) - (5.0f32 / 12.0).sqrt()).abs() < 1e-6);
        assert!((frame.student_factor() - 3.182_446).abs() < 1e-5);
    }
}
