//! Sums of batches, a layer for each light group. The only mutable thing that outlives a batch.
//! No filter ever writes into them; what filtered batches show is summed beside. Means and errors are asked for, never
//! stored.
//!
//! A layer counts its own batches, and its light is weighted when it is looked at: to dim or colour a lamp costs sums over
//! layers, and no ray. What tells the error, the randomisations, is kept for blocks of 8 × 8 pixels.

mod auxiliary;
mod held;
mod layer;
mod spread;
mod still;
mod torn;
mod window;

pub use auxiliary::Auxiliary;
pub(crate) use spread::mean_and_variance;
pub use still::Still;

use crate::color::Rgb;
use crate::eye::Rect;
use crate::settings::Settings;
use held::Held;
use layer::{Blocks, Layer, Replicate};
use rayon::prelude::*;
use std::sync::Arc;
use still::{Term, sum};
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
        let plane = Arc::new(vec![Rgb::BLACK; self.width as usize * self.height as usize]);
        let Blocks { columns, rows, .. } = self.blocks();
        let blocks = vec![Rgb::BLACK; columns * rows];
        let replicate = Replicate { probes: blocks.clone(), blocks, batches: 0 };
        Layer {
            color: Rgb::WHITE,
            shown: self.filtered.then(|| Arc::clone(&plane)),
            planes: vec![plane; self.parts.len().max(1)],
            replicates: vec![replicate; self.replicates],
            open: None,
            window: Window::default(),
            ahead: [0; 2],
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

    fn blocks(&self) -> Blocks {
        Blocks::new(self.width, self.height)
    }

    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
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
        let term = layer.mean(1.0).nth(number)?;
        Some(sum(self.size(), [(&term, layer.color)].into_iter()))
    }

    /// The sums of one layer that exists, of each part that has a plane.
    pub(crate) fn planes_of(&self, layer: usize) -> impl Iterator<Item = &[Rgb]> {
        self.layers[layer].planes.iter().map(|plane| plane.as_slice())
    }

    /// The mean of one layer over all its batches, in its colour; `None` if there is none of that number.
    pub fn layer(&self, number: usize) -> Option<Vec<Rgb>> {
        let layer = self.layers.get(number)?;
        let terms: Vec<Term> = layer.mean(1.0).collect();
        Some(sum(self.size(), terms.iter().map(|term| (term, layer.color))))
    }

    /// What [`Frame::shown`] has of the batches of one layer; `None` if there is none of that number.
    pub fn shown_layer(&self, number: usize) -> Option<Vec<Rgb>> {
        self.layers.get(number).map(|own| self.light_of(number, own.color))
    }

    /// What is shown of the batches of a layer that exists, in a colour.
    fn light_of(&self, layer: usize, color: Rgb) -> Vec<Rgb> {
        let terms: Vec<Term> = self.layers[layer].mix(self.filtered_shares()[layer]).collect();
        sum(self.size(), terms.iter().map(|term| (term, color)))
    }

    /// The picture: the mean of all layers together.
    pub fn mean(&self) -> Vec<Rgb> {
        let terms: Vec<(Term, Rgb)> =
            self.layers.iter().flat_map(|layer| layer.mean(1.0).map(|term| (term, layer.color))).collect();
        sum(self.size(), terms.iter().map(|(term, color)| (term, *color)))
    }

    /// One pixel of [`Frame::mean`], to rounding; `None` outside of the picture.
    pub fn at(&self, pixel: usize) -> Option<Rgb> {
        self.at_in(pixel, &[])
    }

    /// The same if the layers had these colours, their own where colours are missing.
    pub fn at_in(&self, pixel: usize, colors: &[Rgb]) -> Option<Rgb> {
        let inside = pixel < self.width as usize * self.height as usize;
        let of = |(number, layer): (usize, &Layer)| {
            let color = colors.get(number).copied().unwrap_or(layer.color);
            layer.mean(1.0).fold(Rgb::BLACK, |sum, term| sum + term.at(pixel)) * color
        };
        inside.then(|| self.layers.iter().enumerate().fold(Rgb::BLACK, |sum, layer| sum + of(layer)))
    }

    /// The picture to show: of each layer the mean of the filtered batches, if they were, as long as the error of the mean
    /// itself would be visible. The one turns into the other by degrees. Layers whose lamps changed groups are held until
    /// they have caught up with what they were ([`Frame::progress`]).
    pub fn shown(&self) -> Vec<Rgb> {
        self.blend().mix(|_| None)
    }

    /// What the eye met first, if it was asked for.
    pub fn auxiliary(&self) -> Option<&Auxiliary> {
        self.auxiliary.as_ref()
    }

    /// Adds a batch of randomisation `replicate` to some layers, each with its rectangles of the picture and their values:
    /// of the parts in the order of `part_names`, or of all of them together, row by row.
    pub fn add(&mut self, replicate: u32, layers: &[(usize, Tiles)]) {
        let blocks = self.blocks();
        let asked = self.layers.par_iter_mut().enumerate().filter_map(|(number, layer)| {
            layers.iter().find(|(own, _)| *own == number).map(|(_, tiles)| (layer, tiles))
        });
        asked.for_each(|(layer, tiles)| layer.add(replicate, tiles, blocks));
    }

    /// A batch of randomisation `replicate` is complete in a layer: every pixel of it was added once.
    pub fn count(&mut self, layer: usize, replicate: u32) {
        self.layers[layer].count(replicate);
        self.count_shown(layer);
        let layers = &self.layers;
        self.held.retain(|held| held.share(layers) > 0.0);
    }

    /// What is shown of some layers, whose numbers ascend.
    pub(crate) fn shown_mut(&mut self, layers: &[usize]) -> Vec<&mut Vec<Rgb>> {
        let asked = self.layers.par_iter_mut().enumerate().filter(|(number, _)| layers.contains(number));
        asked.filter_map(|(_, layer)| layer.shown.as_mut().map(Arc::make_mut)).collect()
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
