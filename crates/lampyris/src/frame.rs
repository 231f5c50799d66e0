//! Sums of batches, a layer for each light group. The only mutable thing that outlives a batch.
//! No filter ever writes into them; what filtered batches show is summed beside. Means and errors are asked for, never
//! stored.
//!
//! A layer counts its own batches, and its light is weighted when it is looked at: to dim or colour a lamp costs sums over
//! layers, and no ray. What tells the error, the randomisations, is kept for blocks of 8 × 8 pixels.

mod held;
mod window;

use crate::color::Rgb;
use crate::eye::Rect;
use crate::geometry::{Kernel, Wide};
use crate::sequence;
use crate::settings::Settings;
use crate::testing::student_quantile;
use held::Held;
use rayon::prelude::*;
use window::Window;

/// The sums of a picture, or of a list of meters (then one row).
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Names of the parts that have planes of their own.
    parts: Vec<String>,
    layers: Vec<Layer>,
    /// What stands in for layers that are solved anew; no layer has two.
    held: Vec<Held>,
    /// Randomisations.
    replicates: usize,
    filtered: bool,
    /// Batches that are shown while light changes.
    window: u32,
    auxiliary: Option<Auxiliary>,
}

/// The light of one group.
#[derive(Clone, Debug, Default)]
struct Layer {
    /// What it is multiplied by.
    color: Rgb,
    /// Sum over all batches: a plane for each part, or one of all parts together.
    planes: Vec<Vec<Rgb>>,
    /// The sums of each randomisation.
    replicates: Vec<Replicate>,
    /// Σ over the batches of what each shows, if filtered.
    shown: Option<Vec<Rgb>>,
    /// How many these are, and what was shown before.
    window: Window,
}

/// What a randomisation's spread is known by.
#[derive(Clone, Debug, Default)]
struct Replicate {
    /// Sums of blocks of pixels, row by row.
    blocks: Vec<Rgb>,
    /// Sums of one pixel of each block.
    probes: Vec<Rgb>,
    /// Batches added.
    batches: u32,
}

/// Rectangles of a picture with the planes of their values, row by row.
pub type Tiles = Vec<(Rect, Vec<Vec<Rgb>>)>;

/// How far a layer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Batches that it has.
    pub batches: u32,
    /// Batches that it will have when it has caught up with the layer that has most, and with what stands in for it.
    pub of: u32,
    /// Until then what is shown is also of the sums before its lamps changed groups ([`Edit::Regroup`]).
    ///
    /// [`Edit::Regroup`]: crate::scene::Edit::Regroup
    pub held: bool,
}

/// Edge of a block of pixels.
const BLOCK: u32 = 8;

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
    /// An empty frame of so many layers. In each of them the parts named have a plane of their own; if none is, there is one
    /// for all of them.
    pub fn new(width: u32, height: u32, parts: &[&str], settings: &Settings, layers: usize) -> Frame {
        let pixels = width as usize * height as usize;
        let mut frame = Frame {
            width,
            height,
            parts: parts.iter().map(|n| (*n).to_owned()).collect(),
            layers: Vec::new(),
            held: Vec::new(),
            replicates: settings.replicates as usize,
            filtered: settings.filter,
            window: settings.window,
            auxiliary: settings.auxiliary.then(|| Auxiliary::new(pixels)),
        };
        frame.layers = vec![frame.empty(); layers];
        frame
    }

    /// A layer without batches.
    fn empty(&self) -> Layer {
        let plane = || vec![Rgb::BLACK; self.width as usize * self.height as usize];
        let [columns, rows] = self.blocks();
        let blocks = vec![Rgb::BLACK; columns * rows];
        let replicate = Replicate { probes: blocks.clone(), blocks, batches: 0 };
        Layer {
            color: Rgb::WHITE,
            planes: (0..self.parts.len().max(1)).map(|_| plane()).collect(),
            replicates: vec![replicate; self.replicates],
            shown: self.filtered.then(plane),
            window: Window::default(),
        }
    }

    /// Empties a layer, or adds one of the next number. What stood in for it does not any more.
    pub(crate) fn restart(&mut self, layer: usize) {
        self.held.retain(|held| !held.is_for(layer));
        let empty = self.empty();
        match self.layers.get_mut(layer) {
            Some(own) => *own = Layer { color: own.color, ..empty },
            None => self.layers.push(empty),
        }
    }

    /// What each layer is multiplied by from now on: level and colour of its lamps.
    pub fn set_mix(&mut self, colors: &[Rgb]) {
        self.layers.iter_mut().zip(colors).for_each(|(layer, color)| layer.color = *color);
    }

    /// Blocks in a row, and rows of them. Meters, all in one row, are a block each.
    fn blocks(&self) -> [usize; 2] {
        let edge = self.block();
        [self.width.div_ceil(edge) as usize, self.height.div_ceil(edge) as usize]
    }

    fn block(&self) -> u32 {
        if self.height == 1 { 1 } else { BLOCK }
    }

    /// Batches that all layers have.
    pub fn batches(&self) -> u32 {
        self.layers.iter().map(Layer::batches).min().unwrap_or(0)
    }

    /// How many layers there are.
    pub fn layers(&self) -> usize {
        self.layers.len()
    }

    /// Batches of one layer.
    pub fn batches_of(&self, layer: usize) -> u32 {
        self.layers.get(layer).map_or(0, Layer::batches)
    }

    /// How far each layer is.
    pub fn progress(&self) -> Vec<Progress> {
        let most = self.layers.iter().map(Layer::batches).max().unwrap_or(0);
        let of = |(number, layer): (usize, &Layer)| {
            let held = self.held.iter().find(|held| held.is_for(number));
            let of = held.map_or(most, |held| held.batches().max(most));
            Progress { batches: layer.batches(), of, held: held.is_some() }
        };
        self.layers.iter().enumerate().map(of).collect()
    }

    /// Names of the parts that can be told apart: none where lamps are.
    pub fn part_names(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().map(String::as_str)
    }

    /// The mean of one part over all batches, row by row from the top; `None` if it has no plane.
    pub fn part(&self, name: &str) -> Option<Vec<Rgb>> {
        let number = self.parts.iter().position(|n| n == name)?;
        let [layer] = self.layers.as_slice() else { return None };
        let scale = layer.color * layer.scale();
        Some(layer.planes.get(number)?.iter().map(|s| *s * scale).collect())
    }

    /// The mean of one layer over all its batches, in its colour; `None` if there is none of that number.
    pub fn layer(&self, number: usize) -> Option<Vec<Rgb>> {
        let layer = self.layers.get(number)?;
        Some(self.sum(layer.mean(layer.color)))
    }

    /// What [`Frame::shown`] has of the batches of one layer; `None` if there is none of that number.
    pub fn shown_layer(&self, number: usize) -> Option<Vec<Rgb>> {
        let (layer, share) = (self.layers.get(number)?, self.filtered_shares()[number]);
        Some(self.sum(layer.mix(layer.color, share)))
    }

    /// The picture: the mean of all layers together.
    pub fn mean(&self) -> Vec<Rgb> {
        self.sum(self.layers.iter().flat_map(|layer| layer.mean(layer.color)))
    }

    /// The picture to show: of each layer the mean of the filtered batches, if they were, as long as the error of the mean
    /// itself would be visible. The one turns into the other by degrees. Layers whose lamps changed groups are held until
    /// they have caught up with what they were ([`Frame::progress`]).
    pub fn shown(&self) -> Vec<Rgb> {
        self.shown_of(|_| true)
    }

    /// What is shown of some layers: of all or none of those that are held together.
    fn shown_of(&self, wanted: impl Fn(usize) -> bool) -> Vec<Rgb> {
        let shares = self.filtered_shares();
        let own = (0..).zip(self.layers.iter().zip(shares)).filter(|(number, _)| wanted(*number));
        let own = own.flat_map(|(number, (layer, share))| layer.mix(self.color(number), share));
        let held = self.held.iter().filter(|held| held.layers().any(&wanted));
        self.sum(own.chain(held.map(|held| held.plane(&self.layers))))
    }

    /// What a layer's own batches are multiplied by where it is shown.
    fn color(&self, layer: usize) -> Rgb {
        let held = self.held.iter().find_map(|held| held.color(layer, &self.layers));
        self.layers[layer].color - held.unwrap_or(Rgb::BLACK)
    }

    /// The sum of planes, each times a colour.
    fn sum<'p>(&self, planes: impl Iterator<Item = (&'p [Rgb], Rgb)>) -> Vec<Rgb> {
        let planes: Vec<(&[Rgb], Rgb)> = planes.filter(|(_, by)| !by.is_black()).collect();
        let mut sum = vec![Rgb::BLACK; self.width as usize * self.height as usize];
        let kernel = Kernel::detect();
        sum.par_chunks_mut(RUN).enumerate().for_each(|(k, sum)| {
            kernel.run(Mix { planes: &planes, start: k * RUN, sum });
        });
        sum
    }

    /// How much of each layer is shown filtered: by the mean over pixels of its variance, as the spread of its
    /// randomisations promises it, over the square of the whole picture, dark pixels measured against a tenth of the mean;
    /// as if all layers varied like it. All of it before two randomisations have a batch. One pixel of each block stands
    /// for all.
    fn filtered_shares(&self) -> Vec<f32> {
        let Some(first) = self.layers.first().filter(|_| self.filtered) else {
            return vec![0.0; self.layers.len()];
        };
        let mut means = vec![0.0; first.replicates[0].probes.len()];
        for (number, layer) in self.layers.iter().enumerate() {
            let color = self.color(number);
            for (at, mean) in means.iter_mut().enumerate() {
                let sum = layer.replicates.iter().fold(Rgb::BLACK, |sum, r| sum + r.probes[at]);
                *mean += f64::from((color * sum).luminance() * layer.scale());
            }
        }
        for (plane, by) in self.held.iter().map(|held| held.plane(&self.layers)) {
            for (at, mean) in means.iter_mut().enumerate() {
                let pixel = self.probe(at).map_or(Rgb::BLACK, |pixel| plane[pixel]);
                *mean += f64::from((pixel * by).luminance());
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
        let ([columns, _], edge) = (self.blocks(), self.block());
        let [x, y] = probe(block, edge);
        let (x, y) = ((block % columns) as u32 * edge + x, (block / columns) as u32 * edge + y);
        (x < self.width && y < self.height).then_some(y as usize * self.width as usize + x as usize)
    }

    /// Standard error of the luminance of one pixel's mean, from the spread of the randomisations [cd/m²]; in a picture of
    /// more than one row, of the mean over the block of 8 × 8 pixels around it. Infinite before each of two has a batch.
    pub fn standard_error(&self, pixel: usize) -> f32 {
        let (used, edge) = (used(&self.layers), self.block());
        if used.len() < 2 {
            return f32::INFINITY;
        }
        let (x, y) = (pixel as u32 % self.width, pixel as u32 / self.width);
        let at = (y / edge) as usize * self.blocks()[0] + (x / edge) as usize;
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

    /// What the eye met first, if it was asked for.
    pub fn auxiliary(&self) -> Option<&Auxiliary> {
        self.auxiliary.as_ref()
    }

    /// Adds a batch of randomisation `replicate` to some layers, each with its rectangles of the picture and their values:
    /// of the parts in the order of `part_names`, or of all of them together, row by row.
    pub fn add(&mut self, replicate: u32, layers: &[(usize, Tiles)]) {
        let ([columns, _], edge, width) = (self.blocks(), self.block(), self.width as usize);
        let asked = self.layers.par_iter_mut().enumerate().filter_map(|(number, layer)| {
            layers.iter().find(|(own, _)| *own == number).map(|(_, tiles)| (layer, tiles))
        });
        asked.for_each(|(layer, tiles)| layer.add(replicate, tiles, (columns, edge, width)));
    }

    /// A batch of randomisation `replicate` is complete in a layer: every pixel of it was added once.
    pub fn count(&mut self, layer: usize, replicate: u32) {
        self.layers[layer].replicates[replicate as usize].batches += 1;
        self.count_shown(layer);
        let layers = &self.layers;
        self.held.retain(|held| held.share(layers) > 0.0);
    }

    /// What is shown of some layers, whose numbers ascend.
    pub(crate) fn shown_mut(&mut self, layers: &[usize]) -> Vec<&mut Vec<Rgb>> {
        let asked = (0..).zip(&mut self.layers).filter(|(number, _)| layers.contains(number));
        asked.filter_map(|(_, layer)| layer.shown.as_mut()).collect()
    }

    /// What the eye met first it may meet no longer.
    pub(crate) fn forget_first(&mut self) {
        let pixels = self.width as usize * self.height as usize;
        self.auxiliary = self.auxiliary.take().map(|_| Auxiliary::new(pixels));
    }

    pub(crate) fn auxiliary_mut(&mut self) -> Option<&mut Auxiliary> {
        self.auxiliary.as_mut()
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
    let n: f64 = used.iter().map(|k| of(k).0).sum();
    let mean = used.iter().map(of).map(|(n, m)| n * m).sum::<f64>() / n;
    let squares = used.iter().map(of).map(|(n, m)| n * (m - mean).powi(2));
    (mean, squares.sum::<f64>() / (used.len() - 1) as f64 / n)
}

impl Layer {
    /// Adds a batch, in a picture of so many columns of blocks, of that edge, and of that width.
    fn add(&mut self, replicate: u32, tiles: &Tiles, (columns, edge, width): (usize, u32, usize)) {
        let Layer { planes, replicates, .. } = self;
        let Replicate { blocks, probes, .. } = &mut replicates[replicate as usize];
        let rows = |rect: &Rect| {
            let left = rect.x;
            (rect.y..rect.y + rect.height).map(move |y| (left, y))
        };
        let add_planes = || {
            planes.par_iter_mut().enumerate().for_each(|(number, sum)| {
                for (rect, values) in tiles {
                    for ((x, y), values) in rows(rect).zip(values[number].chunks(rect.width as usize)) {
                        let at = y as usize * width + x as usize;
                        sum[at..at + values.len()].iter_mut().zip(values).for_each(|(s, v)| *s += *v);
                    }
                }
            });
        };
        let add_blocks = || {
            for (rect, values) in tiles {
                for ((left, y), row) in
                    values.iter().flat_map(|v| rows(rect).zip(v.chunks(rect.width as usize)))
                {
                    let mut x = left;
                    while x < left + rect.width {
                        let end = ((x / edge + 1) * edge).min(left + rect.width);
                        let at = (y / edge) as usize * columns + (x / edge) as usize;
                        let [px, py] = probe(at, edge);
                        let (px, values) =
                            (x / edge * edge + px, &row[(x - left) as usize..(end - left) as usize]);
                        values.iter().for_each(|v| blocks[at] += *v);
                        if y % edge == py && (x..end).contains(&px) {
                            probes[at] += values[(px - x) as usize];
                        }
                        x = end;
                    }
                }
            }
        };
        rayon::join(add_planes, add_blocks);
    }

    fn batches(&self) -> u32 {
        self.replicates.iter().map(|r| r.batches).sum()
    }

    fn scale(&self) -> f32 {
        1.0 / self.batches().max(1) as f32
    }

    /// The planes whose sum is its mean, in a colour.
    fn mean(&self, color: Rgb) -> impl Iterator<Item = (&[Rgb], Rgb)> {
        let by = color * self.scale();
        self.planes.iter().map(move |plane| (plane.as_slice(), by))
    }

    /// The same where a share of it is of what its batches show, and with what is shown of those before.
    fn mix(&self, color: Rgb, share: f32) -> impl Iterator<Item = (&[Rgb], Rgb)> {
        let own = color * self.window.own();
        let by = own * (share * self.window.scale());
        let shown = self.shown.iter().map(move |plane| (plane.as_slice(), by));
        self.mean(own * (1.0 - share)).chain(shown).chain(self.window.past(color))
    }
}

/// Pixels that are summed at a time: their sum stays in the nearest cache while all planes are added to it.
const RUN: usize = 1 << 11;

/// Adds a run of planes, each times a colour.
struct Mix<'a> {
    planes: &'a [(&'a [Rgb], Rgb)],
    /// Where the run begins.
    start: usize,
    sum: &'a mut [Rgb],
}

impl Wide for Mix<'_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        for (plane, by) in self.planes {
            for (sum, v) in self.sum.iter_mut().zip(&plane[self.start..]) {
                sum.r += v.r * by.r;
                sum.g += v.g * by.g;
                sum.b += v.b * by.b;
            }
        }
    }
}

/// Which pixel of a block stands for all: another in each, or interleaving would always see the same class.
fn probe(block: usize, edge: u32) -> [u32; 2] {
    let number = sequence::hash(block as u32, u32::from(b'p'));
    [number % edge, number / edge % edge]
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
