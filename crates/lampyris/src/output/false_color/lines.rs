//! Lines of equal value, by marching squares: between the middles of four neighbouring pixels the value is taken to run
//! straight along each edge, and a line joins the places where it passes.

/// A piece of a line [pixels from the upper left corner of the picture].
pub type Segment = [[f32; 2]; 2];

/// The line on which values, row by row, are `level`: one segment or two for each four neighbours that lie on both sides of
/// it. Where one of them is no number there is none.
pub fn iso_lines(values: &[f32], [width, height]: [u32; 2], level: f32) -> Vec<Segment> {
    let mut segments = Vec::new();
    let (columns, rows) = (width as usize, height as usize);
    if !level.is_finite() || values.len() < columns.saturating_mul(rows) {
        return segments;
    }
    for y in 1..rows {
        for x in 1..columns {
            // Clockwise from the upper left, and back to it.
            let at = |dx: usize, dy: usize| (values[(y - 1 + dy) * columns + x - 1 + dx], [dx, dy]);
            let corners = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
            if corners.iter().any(|(v, _)| !v.is_finite()) {
                continue;
            }
            let above = corners.map(|(v, _)| v >= level);
            if above == [true; 4] || above == [false; 4] {
                continue;
            }
            let origin = [x as f32 - 0.5, y as f32 - 0.5];
            let crossing = |k: usize| {
                let ((a, from), (b, to)) = (corners[k], corners[(k + 1) % 4]);
                let t = ((f64::from(level) - f64::from(a)) / (f64::from(b) - f64::from(a))) as f32;
                std::array::from_fn(|axis| {
                    let (from, to) = (from[axis] as f32, to[axis] as f32);
                    origin[axis] + from + (to - from) * t
                })
            };
            let crossed: Vec<usize> = (0..4).filter(|k| above[*k] != above[(*k + 1) % 4]).collect();
            match *crossed.as_slice() {
                [a, b] => segments.push([crossing(a), crossing(b)]),
                [a, b, c, d] => {
                    // A saddle: what the middle is decides which corners hang together.
                    let middle = corners.iter().map(|(v, _)| f64::from(*v)).sum::<f64>() / 4.0;
                    let cuts_first = (middle >= f64::from(level)) != above[0];
                    let pairs = if cuts_first { [[d, a], [b, c]] } else { [[a, b], [c, d]] };
                    segments.extend(pairs.map(|[from, to]| [crossing(from), crossing(to)]));
                }
                _ => {}
            }
        }
    }
    segments
}

/// Calls `mark` for each pixel whose middle is nearer to a segment than `reach`.
pub(super) fn draw([a, b]: Segment, reach: f32, [width, height]: [u32; 2], mut mark: impl FnMut(usize)) {
    let range = |axis: usize, end: u32| {
        let low = (a[axis].min(b[axis]) - reach - 0.5).floor().max(0.0) as u32;
        let high = (a[axis].max(b[axis]) + reach + 0.5).ceil().max(0.0) as u32;
        low.min(end)..high.min(end)
    };
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0] * along[0] + along[1] * along[1];
    for y in range(1, height) {
        for x in range(0, width) {
            let to = [x as f32 + 0.5 - a[0], y as f32 + 0.5 - a[1]];
            let t = if length > 0.0 {
                ((to[0] * along[0] + to[1] * along[1]) / length).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let off = [to[0] - along[0] * t, to[1] - along[1] * t];
            if off[0] * off[0] + off[1] * off[1] < reach * reach {
                mark(y as usize * width as usize + x as usize);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(width: u32, height: u32, value: impl Fn(f32, f32) -> f32) -> Vec<f32> {
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        pixels.map(|(x, y)| value(x as f32 + 0.5, y as f32 + 0.5)).collect()
    }

    /// Of a slope the line is straight and exactly where it should be, and has no gap.
    #[test]
    fn lines_of_a_slope_are_exact() {
        for (a, b) in [(1.0f32, 0.0f32), (0.0, 1.0), (0.7, 0.3), (-0.4, 0.9)] {
            let value = |x: f32, y: f32| a * x + b * y;
            let level = value(8.2, 6.3);
            let segments = iso_lines(&plane(16, 12, value), [16, 12], level);
            assert!(segments.len() >= 10);
            for end in segments.iter().flatten() {
                assert!((value(end[0], end[1]) - level).abs() < 1e-4, "{end:?}");
            }
            assert_eq!(loose_ends(&segments), 2);
        }
    }

    /// Ends that no other segment shares.
    fn loose_ends(segments: &[Segment]) -> usize {
        let ends: Vec<[f32; 2]> = segments.iter().flatten().copied().collect();
        let near = |a: &[f32; 2], b: &[f32; 2]| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-4;
        ends.iter().filter(|e| ends.iter().filter(|o| near(e, o)).count() == 1).count()
    }

    #[test]
    fn lines_of_a_cone_are_circles() {
        let value = |x: f32, y: f32| ((x - 15.3) * (x - 15.3) + (y - 14.1) * (y - 14.1)).sqrt();
        let segments = iso_lines(&plane(32, 30, value), [32, 30], 9.0);
        assert_eq!(loose_ends(&segments), 0, "it closes");
        let length: f32 = segments
            .iter()
            .map(|[a, b]| ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt())
            .sum();
        assert!((length / (std::f32::consts::TAU * 9.0) - 1.0).abs() < 0.01, "{length}");
        assert!(segments.iter().flatten().all(|end| (value(end[0], end[1]) - 9.0).abs() < 0.02));
        // Drawn, it is a ring.
        let mut pixels = vec![false; 32 * 30];
        segments.iter().for_each(|s| draw(*s, 1.0, [32, 30], |k| pixels[k] = true));
        let distances = plane(32, 30, |x, y| (value(x, y) - 9.0).abs());
        for (drawn, off) in pixels.iter().zip(distances) {
            assert!(if off < 0.95 { *drawn } else { off < 1.05 || !*drawn }, "{off} {drawn}");
        }
    }

    #[test]
    fn saddles_and_holes_are_no_trouble() {
        let saddle = [1.0, 0.0, 0.0, 1.0];
        for (level, expected) in [(0.4, [[0.6, 1.4], [1.4, 0.6]]), (0.6, [[0.6, 0.6], [1.4, 1.4]])] {
            let segments = iso_lines(&saddle, [2, 2], level);
            let middles: Vec<[f32; 2]> =
                segments.iter().map(|[a, b]| [(a[0] + b[0]) * 0.5, (a[1] + b[1]) * 0.5]).collect();
            assert_eq!(segments.len(), 2);
            let near = |m: &[f32; 2], e: [f32; 2]| (m[0] - e[0]).abs() < 0.21 && (m[1] - e[1]).abs() < 0.21;
            assert!(expected.iter().all(|e| middles.iter().any(|m| near(m, *e))), "{level}: {middles:?}");
        }
        assert!(iso_lines(&[1.0, f32::NAN, 0.0, 1.0], [2, 2], 0.5).is_empty());
        assert!(iso_lines(&[1.0; 4], [2, 2], 1.0).is_empty(), "nothing is below");
        assert!(iso_lines(&[1.0], [9, 9], 0.5).is_empty() && iso_lines(&[], [0, 0], 0.5).is_empty());
    }
}
