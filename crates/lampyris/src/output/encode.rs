//! The encoding of sRGB for a whole picture: [`srgb`], bit for bit, by a table instead of a power.

use super::srgb;

/// Cells of the table. The curve is steepest in the dark, 12.92 · 255 steps for one of light: no cell sees two steps.
const CELLS: usize = 8192;

/// What each display light is encoded as.
pub(super) struct Encoder {
    /// The code at the lower end of each cell, and of full light.
    codes: Vec<u8>,
    /// The least display light of each code; beyond the last nothing.
    least: Vec<f32>,
}

impl Encoder {
    pub(super) fn new() -> Encoder {
        let mut least: Vec<f32> = (0..=255).map(least_of).collect();
        least.push(f32::INFINITY);
        let mut code = 0;
        let mut code_at = |light: f32| {
            while least[usize::from(code) + 1] <= light {
                code += 1;
            }
            code
        };
        let codes = (0..=CELLS).map(|cell| code_at(cell as f32 / CELLS as f32)).collect();
        Encoder { codes, least }
    }

    /// As [`srgb`], of light that is a number.
    #[inline]
    pub(super) fn encode(&self, linear: f32) -> u8 {
        let v = linear.clamp(0.0, 1.0);
        let code = self.codes[(v * CELLS as f32) as usize];
        code + u8::from(v >= self.least[usize::from(code) + 1])
    }
}

/// The least light that [`srgb`] encodes so; the bits of positive numbers ascend as they do.
fn least_of(code: u8) -> f32 {
    let (mut below, mut above) = (0, 1.0_f32.to_bits());
    while below < above {
        let middle = below + (above - below) / 2;
        if srgb(f32::from_bits(middle)) < code {
            below = middle + 1;
        } else {
            above = middle;
        }
    }
    f32::from_bits(above)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At every step of the curve, on both sides of it, and everywhere between.
    #[test]
    fn the_table_is_the_curve() {
        let encoder = Encoder::new();
        let steps = (0..=255).map(least_of).flat_map(|v| [v.next_down(), v, v.next_up()]);
        let between = (0..200_000).map(|k| k as f32 / 190_000.0 - 0.01);
        let cells =
            (0..=CELLS).map(|k| k as f32 / CELLS as f32).flat_map(|v| [v.next_down(), v, v.next_up()]);
        for v in steps.chain(between).chain(cells).chain([-0.0, f32::INFINITY, f32::NEG_INFINITY, 1e-40]) {
            assert_eq!(encoder.encode(v), srgb(v), "{v}");
        }
    }
}
