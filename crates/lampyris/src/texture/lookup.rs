//! Looking up a place: (0, 0) is the upper left corner of the picture, (1, 1) the lower right one, and the centre of
//! pixel i lies at (i + ½)/width. Bytes are made linear before they are mixed.

use super::{Encoding, Filter, Image, Pixels, Texture, Wrap, srgb};
use glam::Vec2;

/// Pixels that stand for all of them in a mean.
const SAMPLES: usize = 1 << 16;

impl Image {
    /// True if there are as many pixels as the size says, and any. Other images are as absent.
    pub fn is_sound(&self) -> bool {
        let pixels = match &self.pixels {
            Pixels::Byte(p) => p.len(),
            Pixels::Float(p) => p.len(),
        };
        pixels > 0 && pixels as u64 == u64::from(self.width) * u64::from(self.height)
    }

    /// One pixel: linear red, green, blue and alpha.
    pub(crate) fn pixel(&self, encoding: Encoding, k: usize) -> [f32; 4] {
        match &self.pixels {
            Pixels::Float(p) => {
                let [r, g, b] = p[k];
                [r, g, b, 1.0]
            }
            Pixels::Byte(p) => {
                let [r, g, b, a] = p[k];
                let unit = |v: u8| f32::from(v) * (1.0 / 255.0);
                match encoding {
                    Encoding::Srgb => [srgb::linear(r), srgb::linear(g), srgb::linear(b), unit(a)],
                    Encoding::Linear => [r, g, b, a].map(unit),
                }
            }
        }
    }

    /// The mean of the pixels, of very many of them by a regular choice; the image must be sound.
    pub fn mean(&self, encoding: Encoding) -> [f32; 4] {
        let count = self.width as usize * self.height as usize;
        // Odd, lest the choice be every other column.
        let step = if count > SAMPLES { (count / SAMPLES) | 1 } else { 1 };
        let mut sum = [0.0f64; 4];
        let mut n = 0.0;
        for k in (0..count).step_by(step) {
            let pixel = self.pixel(encoding, k);
            sum.iter_mut().zip(pixel).for_each(|(s, v)| *s += f64::from(v));
            n += 1.0;
        }
        sum.map(|s| (s / n) as f32)
    }

    /// The least value of a channel (0 red … 3 alpha) in the whole image: a bound for every look-up.
    pub fn least(&self, encoding: Encoding, channel: usize) -> f32 {
        match &self.pixels {
            Pixels::Byte(p) => {
                let least = p.iter().map(|p| p[channel]).min().unwrap_or_default();
                let coded = encoding == Encoding::Srgb && channel < 3;
                if coded { srgb::linear(least) } else { f32::from(least) * (1.0 / 255.0) }
            }
            Pixels::Float(_) if channel == 3 => 1.0,
            Pixels::Float(p) => p.iter().map(|p| p[channel]).fold(f32::INFINITY, f32::min),
        }
    }
}

impl Texture {
    /// The value at a place; `image` must be sound and the texture's own.
    pub fn at(&self, image: &Image, uv: Vec2) -> [f32; 4] {
        let size = [image.width, image.height];
        let pixel =
            |x: u32, y: u32| image.pixel(self.encoding, y as usize * image.width as usize + x as usize);
        // Places in pixels, wrapped while they are exact; what is no number lies in the corner.
        let place = [0, 1].map(|axis| wrapped(uv[axis], self.wrap[axis]) * f64::from(size[axis]));
        if self.filter == Filter::Nearest {
            let [x, y] = [0, 1].map(|axis| (place[axis] as u32).min(size[axis] - 1));
            return pixel(x, y);
        }
        let [(x0, x1, fx), (y0, y1, fy)] =
            [0, 1].map(|axis| between(place[axis], size[axis], self.wrap[axis]));
        let (a, b, c, d) = (pixel(x0, y0), pixel(x1, y0), pixel(x0, y1), pixel(x1, y1));
        std::array::from_fn(|k| {
            let (upper, lower) = (a[k] * (1.0 - fx) + b[k] * fx, c[k] * (1.0 - fx) + d[k] * fx);
            upper * (1.0 - fy) + lower * fy
        })
    }
}

/// A coordinate brought into [0, 1].
fn wrapped(x: f32, wrap: Wrap) -> f64 {
    let x = if x.is_finite() { f64::from(x) } else { 0.0 };
    match wrap {
        Wrap::Repeat => x - x.floor(),
        Wrap::Mirror => {
            let x = x - 2.0 * (0.5 * x).floor();
            if x > 1.0 { 2.0 - x } else { x }
        }
        Wrap::Clamp => x.clamp(0.0, 1.0),
    }
}

/// The two pixels whose centres a place lies between, and how far it is from the first to the second.
fn between(place: f64, size: u32, wrap: Wrap) -> (u32, u32, f32) {
    let below = (place - 0.5).floor();
    let along = (place - 0.5 - below) as f32;
    let last = size - 1;
    // `place` is from 0 to `size`, so only the pixels just outside need a neighbour from elsewhere.
    let first = if below >= 0.0 {
        (below as u32).min(last)
    } else if wrap == Wrap::Repeat {
        last
    } else {
        0
    };
    let second = match below + 1.0 {
        next if next <= f64::from(last) => next as u32,
        _ if wrap == Wrap::Repeat => 0,
        _ => last,
    };
    (first, second, along)
}
