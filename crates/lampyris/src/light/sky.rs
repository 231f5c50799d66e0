//! An environment by picture: longitude from left to right, latitude from top to bottom. It is sampled by luminance ×
//! solid angle, row first and column then, uniformly in solid angle within a pixel; its light is mixed between pixels
//! as in any texture. A pixel's share follows from the mean of what is mixed in it, so that light next to the sun is
//! found often enough.

use crate::color::Rgb;
use crate::texture::{Encoding, Filter, Image, Pixels, Texture, Wrap};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Share of the choices that falls on all directions alike: what is dark in the picture is still found.
const EVEN: f64 = 0.02;

/// A picture around the scene.
#[derive(Clone, Debug)]
pub struct Sky {
    /// Radiance [cd/m²], finite and not negative.
    image: Image,
    /// Rightward, upward and forward, where the picture's middle lies.
    frame: [Vec3; 3],
    /// Running shares of the rows, up to and including each.
    rows: Vec<f32>,
    /// Running shares of the pixels of each row.
    columns: Vec<f32>,
    /// ∫ L dω [lx].
    light: Rgb,
}

/// How pixels are mixed: round about in longitude, to the poles in latitude.
const TEXTURE: Texture = Texture {
    image: 0,
    encoding: Encoding::Linear,
    wrap: [Wrap::Repeat, Wrap::Clamp],
    filter: Filter::Linear,
};

impl Sky {
    /// From a picture, bytes in sRGB, whose radiance is multiplied by `factor`. Its upper edge lies along the unit vector
    /// `up`; with +y for that its middle lies at −z and its right quarter at +x. `None` where no light is in it.
    pub fn new(picture: &Image, factor: Rgb, up: Vec3) -> Option<Sky> {
        if !picture.is_sound() {
            return None;
        }
        let (width, height) = (picture.width as usize, picture.height as usize);
        let sane = |v: f32| if v.is_finite() { v.max(0.0) } else { 0.0 };
        let radiance = |k: usize| {
            let [r, g, b, _] = picture.pixel(Encoding::Srgb, k);
            (Rgb::new(r, g, b) * factor).map(sane).to_array()
        };
        let pixels: Vec<[f32; 3]> = (0..width * height).map(radiance).collect();
        let (mut rows, mut columns) = (Vec::with_capacity(height), Vec::with_capacity(width * height));
        let (mut shares, mut light) = (Vec::with_capacity(width), [0.0f64; 3]);
        let mut sum = 0.0;
        for y in 0..height {
            let around = [y.saturating_sub(1), y, (y + 1).min(height - 1)];
            // Each row's share of the picture, counted across, mixed with its neighbours'.
            let across = |x: usize| -> [f64; 3] {
                std::array::from_fn(|c| {
                    let at = |row: usize| f64::from(pixels[row * width + x][c]);
                    0.125 * at(around[0]) + 0.75 * at(around[1]) + 0.125 * at(around[2])
                })
            };
            shares.clear();
            let solid_angle = f64::from(TAU) / width as f64 * (edge(y, height) - edge(y + 1, height));
            let mut row = 0.0;
            for x in 0..width {
                let (left, here, right) =
                    (across((x + width - 1) % width), across(x), across((x + 1) % width));
                let mean: [f64; 3] =
                    std::array::from_fn(|c| 0.125 * left[c] + 0.75 * here[c] + 0.125 * right[c]);
                light.iter_mut().zip(mean).for_each(|(sum, m)| *sum += m * solid_angle);
                row += 0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2];
                shares.push(row);
            }
            let even = |x: usize| (x + 1) as f64 / width as f64;
            let share = |(x, s): (usize, &f64)| {
                (if row > 0.0 { (1.0 - EVEN) * s / row + EVEN * even(x) } else { even(x) }) as f32
            };
            columns.extend(shares.iter().enumerate().map(share));
            sum += row * solid_angle;
            rows.push(sum);
        }
        if sum <= 0.0 || !sum.is_finite() {
            return None;
        }
        let share = |(y, s): (usize, &f64)| {
            ((1.0 - EVEN) * s / sum + EVEN * 0.5 * (1.0 - edge(y + 1, height))) as f32
        };
        let right = (Vec3::X - up * up.x).try_normalize().unwrap_or(Vec3::Z);
        let [r, g, b] = light.map(|v| v as f32);
        Some(Sky {
            image: Image { name: String::new(), pixels: Pixels::Float(pixels), ..*picture },
            frame: [right, up, up.cross(right)],
            rows: rows.iter().enumerate().map(share).collect(),
            columns,
            light: Rgb::new(r, g, b),
        })
    }

    /// ∫ L dω [lx]: four times what the mean of all surfaces under it would receive.
    pub fn light(&self) -> Rgb {
        self.light
    }

    /// Radiance from a direction [cd/m²].
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        let [r, g, b, _] = TEXTURE.at(&self.image, self.place(direction));
        Rgb::new(r, g, b)
    }

    /// Density of [`Sky::sample`] [sr⁻¹].
    pub fn pdf(&self, direction: Vec3) -> f32 {
        let place = self.place(direction);
        let pixel = |v: f32, count: u32| ((v * count as f32) as usize).min(count as usize - 1);
        self.density(pixel(place.x, self.image.width), pixel(place.y, self.image.height))
    }

    /// A direction and its density.
    pub fn sample(&self, u: [f32; 2]) -> (Vec3, f32) {
        let width = self.image.width as usize;
        let (y, down) = choose(&self.rows, u[1]);
        let (x, along) = choose(&self.columns[y * width..(y + 1) * width], u[0]);
        let height = self.rows.len();
        let (above, below) = (edge(y, height) as f32, edge(y + 1, height) as f32);
        let cos = above + (below - above) * down;
        let (s, c) = libm::sincosf(TAU * ((x as f32 + along) / width as f32 - 0.5));
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let [right, up, forward] = self.frame;
        (right * (sin * s) + up * cos + forward * (sin * c), self.density(x, y))
    }

    /// Where in the picture a direction lies.
    fn place(&self, direction: Vec3) -> Vec2 {
        let [x, y, z] = self.frame.map(|axis| axis.dot(direction));
        Vec2::new(0.5 + libm::atan2f(x, z) / TAU, libm::acosf(y.clamp(-1.0, 1.0)) / PI)
    }

    fn density(&self, x: usize, y: usize) -> f32 {
        let width = self.image.width as usize;
        let share = |all: &[f32], k: usize| all[k] - if k == 0 { 0.0 } else { all[k - 1] };
        let row = share(&self.rows, y);
        let column = share(&self.columns[y * width..(y + 1) * width], x);
        let solid_angle =
            f64::from(TAU) / width as f64 * (edge(y, self.rows.len()) - edge(y + 1, self.rows.len()));
        (f64::from(row * column) / solid_angle) as f32
    }
}

/// Cosine of the upper edge of row `y`.
fn edge(y: usize, height: usize) -> f64 {
    libm::cos(std::f64::consts::PI * y as f64 / height as f64)
}

/// Which of the running shares a number falls into, and where in it, again in [0, 1).
fn choose(cumulative: &[f32], u: f32) -> (usize, f32) {
    let k = cumulative.partition_point(|c| *c <= u).min(cumulative.len() - 1);
    let below = if k == 0 { 0.0 } else { cumulative[k - 1] };
    (k, ((u - below) / (cumulative[k] - below)).clamp(0.0, 1.0 - f32::EPSILON))
}
