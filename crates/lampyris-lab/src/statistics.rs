//! Figures of points and of pictures.

use lampyris::Rgb;
use lampyris::sequence::discrepancy::PointSet;

/// Star discrepancy of points in the unit square; nothing where they are too many.
pub(crate) fn star_discrepancy(points: &[[f64; 2]]) -> f64 {
    PointSet::new(2, points.concat()).star().unwrap_or(f64::NAN)
}

/// The least distance between two of the points on the torus.
pub(crate) fn least_distance(points: &[[f64; 2]]) -> f64 {
    let mut least = f64::INFINITY;
    for (k, p) in points.iter().enumerate() {
        for q in &points[..k] {
            let [dx, dy] = [0, 1].map(|d| (p[d] - q[d]).abs()).map(|d| d.min(1.0 - d));
            least = least.min((dx * dx + dy * dy).sqrt());
        }
    }
    least
}

/// Root of the mean square difference of luminances.
pub(crate) fn rms(ours: &[Rgb], truth: &[Rgb]) -> f64 {
    let square = |(a, b): (&Rgb, &Rgb)| f64::from(a.luminance() - b.luminance()).powi(2);
    (ours.iter().zip(truth).map(square).sum::<f64>() / truth.len().max(1) as f64).sqrt()
}

/// Mean of (a − b)²/(b² + ε) of luminances, ε a hundredth of the squared mean: dark pixels count like bright ones.
pub(crate) fn relative_square(ours: &[Rgb], truth: &[Rgb]) -> f64 {
    let floor = 0.01 * mean(truth).powi(2);
    let of = |(a, b): (&Rgb, &Rgb)| {
        let (a, b) = (f64::from(a.luminance()), f64::from(b.luminance()));
        (a - b).powi(2) / (b * b + floor)
    };
    ours.iter().zip(truth).map(of).sum::<f64>() / truth.len().max(1) as f64
}

/// The same against a truth that is known twice, each time with noise of its own, over the squares of a third picture: none of
/// their noise is left in the mean of (a − b)(a − b').
pub(crate) fn relative_square_between(ours: &[Rgb], truths: [&[Rgb]; 2], over: &[Rgb]) -> f64 {
    let floor = 0.01 * mean(over).powi(2);
    let luminance = |light: &Rgb| f64::from(light.luminance());
    let of = |((a, over), (b, c)): ((&Rgb, &Rgb), (&Rgb, &Rgb))| {
        let product = (luminance(a) - luminance(b)) * (luminance(a) - luminance(c));
        product / (luminance(over).powi(2) + floor)
    };
    let pairs = ours.iter().zip(over).zip(truths[0].iter().zip(truths[1]));
    pairs.map(of).sum::<f64>() / ours.len().max(1) as f64
}

/// The median of |a − b|/b of luminances where there is light: what happens at edges, in few pixels, does not show.
pub(crate) fn median_relative(ours: &[Rgb], truth: &[Rgb]) -> f64 {
    let pairs = ours.iter().zip(truth).map(|(a, b)| (f64::from(a.luminance()), f64::from(b.luminance())));
    let mut errors: Vec<f64> = pairs.filter(|(_, b)| *b > 0.0).map(|(a, b)| (a - b).abs() / b).collect();
    errors.sort_by(f64::total_cmp);
    errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Means of square blocks of `edge` pixels in a picture of `width`; what is left over at its edges is left out.
pub(crate) fn blocks(picture: &[Rgb], width: usize, edge: usize) -> Vec<Rgb> {
    let (across, down) = (width / edge, picture.len() / width / edge);
    let of = |block: usize| {
        let first = block / across * edge * width + block % across * edge;
        let pixels = (0..edge * edge).map(|k| picture[first + k / edge * width + k % edge]);
        pixels.fold(Rgb::BLACK, |sum, light| sum + light) * (1.0 / (edge * edge) as f32)
    };
    (0..across * down).map(of).collect()
}

/// Mean luminance.
pub(crate) fn mean(picture: &[Rgb]) -> f64 {
    picture.iter().map(|c| f64::from(c.luminance())).sum::<f64>() / picture.len().max(1) as f64
}

/// The mean of numbers.
pub(crate) fn mean_of(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Pearson's correlation of numbers and as many others.
pub(crate) fn correlation(xs: &[f64], ys: &[f64]) -> f64 {
    let (x, y) = (mean_of(xs), mean_of(ys));
    let across: f64 = xs.iter().zip(ys).map(|(a, b)| (a - x) * (b - y)).sum();
    let along = |values: &[f64], mean: f64| values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
    across / (along(xs, x) * along(ys, y)).sqrt()
}

/// p of a fit of value ~ nᵖ by least squares of logarithms.
pub(crate) fn slope(points: &[[f64; 2]]) -> f64 {
    let logs: Vec<[f64; 2]> =
        points.iter().filter(|p| p[0] > 0.0 && p[1] > 0.0).map(|p| p.map(libm::log)).collect();
    let n = logs.len() as f64;
    let [x, y] = [0, 1].map(|d| logs.iter().map(|p| p[d]).sum::<f64>() / n);
    let along = logs.iter().map(|p| (p[0] - x) * (p[1] - y)).sum::<f64>();
    along / logs.iter().map(|p| (p[0] - x).powi(2)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_go_around() {
        assert!((least_distance(&[[0.05, 0.5], [0.95, 0.5], [0.5, 0.5]]) - 0.1).abs() < 1e-12);
    }

    /// Of a picture of known noise the error is its noise alone, though its truths have ten times that: the standard error of
    /// the estimate from 40 000 pixels is a twelfth over their root, 0.0004.
    #[test]
    fn noise_of_the_truth_is_no_error() {
        let noisy = |seed, width: f32| -> Vec<Rgb> {
            let noise = |k| width * (lampyris::sequence::uniform(seed, k, 0) - 0.5);
            (0..40_000).map(|k| Rgb::grey(1.0 + noise(k))).collect()
        };
        let (ours, over, [b, c]) = (noisy(1, 0.3), noisy(4, 0.1), [noisy(2, 1.0), noisy(3, 1.0)]);
        let (variance, found) = (0.09 / 12.0, relative_square_between(&ours, [&b, &c], &over));
        assert!((found - variance).abs() < 0.0016, "{found} for {variance}");
        assert!(relative_square(&ours, &b) > 10.0 * variance);
    }

    #[test]
    fn blocks_are_means() {
        let picture: Vec<Rgb> = (0..15).map(|k| Rgb::grey(k as f32)).collect();
        let means: Vec<f32> = blocks(&picture, 5, 2).iter().map(|c| c.g).collect();
        assert_eq!(means, [3.0, 5.0]);
    }

    #[test]
    fn lines_correlate_and_crosses_do_not() {
        let x = [1.0, 2.0, 3.0, 4.0];
        for (y, expected) in
            [([3.0, 5.0, 7.0, 9.0], 1.0), ([4.0, 3.0, 2.0, 1.0], -1.0), ([1.0, -1.0, -1.0, 1.0], 0.0)]
        {
            assert!((correlation(&x, &y) - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn a_power_has_its_exponent() {
        let points: Vec<[f64; 2]> = (1..9).map(f64::from).map(|n| [n, 3.0 / (n * n)]).collect();
        assert!((slope(&points) + 2.0).abs() < 1e-12);
    }
}
