//! What a frame shows, taken out of it: to be mixed in other colours while the next batch is already being added, on
//! another thread, in milliseconds.
//!
//! A still shares the frame's planes; who adds a batch to them copies those that a still holds, once. So a still is
//! taken at once, however large the picture is, and costs a copy of the layers that the next batch is for.

use super::layer::Plane;
use super::{Frame, Progress};
use crate::color::Rgb;
use crate::geometry::{Kernel, Wide};
use rayon::prelude::*;
use std::sync::Arc;

/// What a frame shows at one moment. Copies are cheap.
#[derive(Clone, Debug)]
pub struct Still {
    blend: Blend,
    batches: u32,
    relative_error: f32,
    progress: Vec<Progress>,
}

/// Layers and what stands in for some of them.
#[derive(Clone, Debug)]
pub(super) struct Blend {
    pub(super) size: [u32; 2],
    pub(super) layers: Vec<Shown>,
    pub(super) held: Vec<Standing>,
}

/// What is shown of a layer.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    /// Its colour in the frame.
    pub(super) color: Rgb,
    pub(super) terms: Vec<Term>,
}

/// What stands in for some layers.
#[derive(Clone, Debug)]
pub(super) struct Standing {
    /// Which layers, and the colours in which their light is held.
    pub(super) layers: Vec<(usize, Rgb)>,
    /// How much of it is shown.
    pub(super) share: f32,
    pub(super) plane: Plane,
}

/// A plane and how much of it counts.
#[derive(Clone, Debug)]
pub(super) struct Term {
    plane: Plane,
    weight: f32,
    /// How many of its first pixels have another weight.
    head: usize,
    head_weight: f32,
}

impl Term {
    /// A plane with the weight of all its pixels but the first `head`, and with theirs.
    pub(super) fn new(plane: &Plane, [weight, head_weight]: [f32; 2], head: usize) -> Term {
        Term { plane: Arc::clone(plane), weight, head, head_weight }
    }

    /// All of a plane alike.
    pub(super) fn whole(plane: &Plane, weight: f32) -> Term {
        Term::new(plane, [weight; 2], 0)
    }

    /// What it gives to a pixel.
    pub(super) fn at(&self, pixel: usize) -> Rgb {
        self.plane[pixel] * if pixel < self.head { self.head_weight } else { self.weight }
    }

    fn is_nothing(&self) -> bool {
        self.weight == 0.0 && (self.head_weight == 0.0 || self.head == 0)
    }
}

impl Still {
    /// Width and height [pixels].
    pub fn size(&self) -> [u32; 2] {
        self.blend.size
    }

    /// Batches that all layers have.
    pub fn batches(&self) -> u32 {
        self.batches
    }

    /// Of the mean luminance, in the frame's colours.
    pub fn relative_error(&self) -> f32 {
        self.relative_error
    }

    /// How far each layer is.
    pub fn progress(&self) -> &[Progress] {
        &self.progress
    }

    /// How many layers there are.
    pub fn layers(&self) -> usize {
        self.blend.layers.len()
    }

    /// The colours that the layers had in the frame.
    pub fn colors(&self) -> Vec<Rgb> {
        self.blend.layers.iter().map(|layer| layer.color).collect()
    }

    /// What is shown if the layers have these colours, those of the frame where colours are missing [cd/m²]: row by row from
    /// the top. In the frame's own colours it is [`Frame::shown`], to the bit. How much of each layer is shown filtered was
    /// decided in the frame's colours.
    pub fn mix(&self, colors: &[Rgb]) -> Vec<Rgb> {
        self.blend.mix(|number| colors.get(number).copied())
    }

    /// The same in few pixels, each the mean of some of those that it covers, 16 of them at most: a thumbnail, made in as many
    /// steps as it has pixels, however large the picture is.
    pub fn small(&self, colors: &[Rgb], size: [u32; 2]) -> Vec<Rgb> {
        self.blend.small(|number| colors.get(number).copied(), size)
    }

    /// What is shown of the batches of one layer, in white [cd/m²]; `None` if there is none of that number. What stands in
    /// for layers is in none of them.
    pub fn layer(&self, number: usize) -> Option<Vec<Rgb>> {
        let layer = self.blend.layers.get(number)?;
        Some(sum(self.blend.size, layer.terms.iter().map(|term| (term, Rgb::WHITE))))
    }
}

impl Blend {
    /// All of it, where layers have other colours than in the frame if `color` says so.
    pub(super) fn mix(&self, color: impl Fn(usize) -> Option<Rgb>) -> Vec<Rgb> {
        self.mix_of(|_| true, color)
    }

    /// All of it in few pixels.
    fn small(&self, color: impl Fn(usize) -> Option<Rgb>, [width, height]: [u32; 2]) -> Vec<Rgb> {
        let terms = self.terms(|_| true, color);
        // The middles of the parts into which a small pixel is cut, as pixels of the picture.
        let samples = |small: u32, count: u32, all: u32| {
            let parts = (all / count.max(1)).clamp(1, PARTS);
            let middle = move |part: u32| {
                let (of, whole) = (u64::from(2 * count * parts), u64::from(all));
                (u64::from(2 * (small * parts + part) + 1) * whole / of) as usize
            };
            (0..parts).map(middle)
        };
        let [whole_width, whole_height] = self.size;
        let pixel = |small: (u32, u32)| {
            let (mut sum, mut count) = (Rgb::BLACK, 0);
            for y in samples(small.1, height, whole_height) {
                for x in samples(small.0, width, whole_width) {
                    let at = y * whole_width as usize + x;
                    sum = terms.iter().fold(sum, |sum, (term, color)| sum + term.at(at) * *color);
                    count += 1;
                }
            }
            sum * (1.0 / count as f32)
        };
        (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(pixel).collect()
    }

    /// Some layers: of those that are held together all or none.
    pub(super) fn mix_of(
        &self,
        wanted: impl Fn(usize) -> bool,
        color: impl Fn(usize) -> Option<Rgb>,
    ) -> Vec<Rgb> {
        sum(self.size, self.terms(wanted, color).iter().map(|(term, color)| (term, *color)))
    }

    /// What some layers are the sum of, each with its colour.
    fn terms(
        &self,
        wanted: impl Fn(usize) -> bool,
        color: impl Fn(usize) -> Option<Rgb>,
    ) -> Vec<(Term, Rgb)> {
        let own = self.layers.iter().enumerate().filter(|(number, _)| wanted(*number));
        let own = own.flat_map(|(number, layer)| {
            let color = own_color(&self.held, number, color(number).unwrap_or(layer.color));
            layer.terms.iter().map(move |term| (term.clone(), color))
        });
        let held = self.held.iter().filter(|held| held.layers.iter().any(|(number, _)| wanted(*number)));
        own.chain(held.map(|held| (Term::whole(&held.plane, held.share), Rgb::WHITE))).collect()
    }
}

/// Parts of a pixel of a thumbnail each way, of which one pixel of the picture each is looked at.
const PARTS: u32 = 4;

/// What a layer's own batches are multiplied by where the layer has that colour.
pub(super) fn own_color(held: &[Standing], layer: usize, color: Rgb) -> Rgb {
    let stands = |held: &Standing| {
        let (_, color) = held.layers.iter().find(|(number, _)| *number == layer)?;
        Some(*color * held.share)
    };
    color - held.iter().find_map(stands).unwrap_or(Rgb::BLACK)
}

impl Frame {
    /// What is shown now, whatever becomes of the frame.
    pub fn still(&self) -> Still {
        Still {
            blend: self.blend(),
            batches: self.batches(),
            relative_error: self.relative_error(),
            progress: self.progress(),
        }
    }

    pub(super) fn blend(&self) -> Blend {
        let layers = self.layers.iter().zip(self.filtered_shares()).map(|(layer, share)| {
            let terms = layer.mix(share).filter(|term| !term.is_nothing()).collect();
            Shown { color: layer.color, terms }
        });
        Blend { size: [self.width, self.height], layers: layers.collect(), held: self.standing() }
    }
}

/// The sum of planes, each times a colour, of a picture of that size.
pub(super) fn sum<'t>([width, height]: [u32; 2], terms: impl Iterator<Item = (&'t Term, Rgb)>) -> Vec<Rgb> {
    let runs = terms.flat_map(|(term, color)| {
        let Term { plane, weight, head, head_weight } = term;
        [(0, *head, *head_weight), (*head, plane.len(), *weight)].map(|(start, end, weight)| Run {
            plane,
            start,
            end,
            by: color * weight,
        })
    });
    let runs: Vec<Run<'_>> = runs.filter(|run| run.start < run.end && !run.by.is_black()).collect();
    let mut sum = vec![Rgb::BLACK; width as usize * height as usize];
    let kernel = Kernel::detect();
    sum.par_chunks_mut(PIECE).enumerate().for_each(|(k, sum)| {
        kernel.run(Mix { runs: &runs, start: k * PIECE, sum });
    });
    sum
}

/// Pixels that are summed at a time: their sum stays in the nearest cache while all planes are added to it.
const PIECE: usize = 1 << 11;

/// Pixels of a plane that are multiplied by the same.
struct Run<'a> {
    plane: &'a [Rgb],
    start: usize,
    end: usize,
    by: Rgb,
}

/// Adds the pieces that runs have of some pixels.
struct Mix<'a> {
    runs: &'a [Run<'a>],
    /// Which pixel is the first.
    start: usize,
    sum: &'a mut [Rgb],
}

impl Wide for Mix<'_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        let end = self.start + self.sum.len();
        for Run { plane, start, end: last, by } in self.runs {
            let (from, to) = (self.start.max(*start), end.min(*last));
            if from >= to {
                continue;
            }
            for (sum, v) in self.sum[from - self.start..to - self.start].iter_mut().zip(&plane[from..to]) {
                sum.r += v.r * by.r;
                sum.g += v.g * by.g;
                sum.b += v.b * by.b;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eye::Rect;
    use crate::settings::Settings;

    /// A thumbnail in the picture's own size is the picture; in another, of one that is even, it is as even; and of a slope
    /// each of its pixels has the mean of those below.
    #[test]
    fn thumbnails_are_means() {
        let size = [48, 24];
        let mut frame = Frame::new(size[0], size[1], &[], &Settings::default(), 2);
        let rect = Rect { x: 0, y: 0, width: 48, height: 24 };
        let pixels = || (0..24u16).flat_map(|y| (0..48u16).map(move |x| (x, y)));
        let slope: Vec<Rgb> = pixels().map(|(x, y)| Rgb::grey(f32::from(x) + 64.0 * f32::from(y))).collect();
        for (layer, values) in [slope, vec![Rgb::new(1.0, 2.0, 3.0); 48 * 24]].into_iter().enumerate() {
            frame.add(0, &[(layer, vec![(rect, vec![values])])]);
            frame.count(layer, 0);
        }
        let still = frame.still();
        let colors = [Rgb::grey(0.5), Rgb::new(4.0, 2.0, 1.0)];
        assert_eq!(still.small(&colors, size), still.mix(&colors));
        assert_eq!(still.small(&[Rgb::BLACK, Rgb::WHITE], [7, 5]), vec![Rgb::new(1.0, 2.0, 3.0); 35]);
        // Four by four pixels each, all of them looked at.
        let small = still.small(&[Rgb::WHITE, Rgb::BLACK], [12, 6]);
        for (k, own) in small.iter().enumerate() {
            let (x, y) = ((k % 12) as f32, (k / 12) as f32);
            assert_eq!(*own, Rgb::grey(4.0 * x + 1.5 + 64.0 * (4.0 * y + 1.5)), "{k}");
        }
        assert_eq!(still.small(&colors, [0, 3]), []);
    }

    /// Whoever adds a batch copies the layers that it is for, as long as a still holds them, and no others.
    #[test]
    fn only_what_changes_is_copied() {
        let mut frame = Frame::new(4, 4, &[], &Settings::default(), 2);
        let rect = Rect { x: 0, y: 0, width: 4, height: 4 };
        let batch = |frame: &mut Frame, layer: usize| {
            frame.add(0, &[(layer, vec![(rect, vec![vec![Rgb::WHITE; 16]])])]);
            frame.count(layer, 0);
        };
        (0..2).for_each(|layer| batch(&mut frame, layer));
        let place = |frame: &Frame, layer: usize| Arc::as_ptr(&frame.layers[layer].planes[0]);
        let before = [0, 1].map(|layer| place(&frame, layer));
        let still = frame.still();
        batch(&mut frame, 1);
        assert_eq!([0, 1].map(|layer| place(&frame, layer) == before[layer]), [true, false]);
        assert_eq!(still.layer(1), Some(vec![Rgb::WHITE; 16]));
        drop(still);
        let before = place(&frame, 1);
        batch(&mut frame, 1);
        assert_eq!(place(&frame, 1), before);
    }
}
