//! How uneven points are: the star discrepancy, the worst error over all boxes at the origin, and the L2 star discrepancy, the
//! error over these boxes in the mean square [Keller96, §2; Warnock 1972].

use super::Generator;

/// Boxes that the exact star discrepancy may look at.
const MOST_BOXES: f64 = 1e9;

/// Points of the unit cube in some dimensions.
#[derive(Clone, Debug)]
pub struct PointSet {
    dimensions: usize,
    /// Point by point.
    coordinates: Vec<f64>,
}

impl PointSet {
    /// From the coordinates of all points, one point after another; what is left over is cut off. `dimensions` ≥ 1.
    pub fn new(dimensions: usize, mut coordinates: Vec<f64>) -> PointSet {
        let dimensions = dimensions.max(1);
        coordinates.truncate(coordinates.len() / dimensions * dimensions);
        PointSet { dimensions, coordinates }
    }

    /// The first `count` points of a generator in so many dimensions.
    pub fn of(generator: Generator, dimensions: u32, seed: u32, count: u32) -> PointSet {
        let generator = generator.in_dimensions(dimensions);
        let point = |i| (0..dimensions).map(move |d| generator.point(i, d, seed));
        PointSet::new(dimensions as usize, (0..count).flat_map(point).collect())
    }

    /// N.
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dimensions
    }

    /// True if there are no points.
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// D*, exactly: one of the boxes whose corners lie at coordinates of points is the worst, with or without its rim. That
    /// are about Nˢ⁻¹ scans of N points in s dimensions; `None` where they are too many, or there are no points.
    pub fn star(&self) -> Option<f64> {
        let (n, s) = (self.len(), self.dimensions);
        if n == 0 || s as f64 * libm::log(n as f64 + 1.0) > libm::log(MOST_BOXES) {
            return None;
        }
        // In the order of the last coordinate, which is scanned.
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|a, b| self.at(*a, s - 1).total_cmp(&self.at(*b, s - 1)));
        let all: Vec<(usize, bool)> = order.into_iter().map(|i| (i, true)).collect();
        Some(self.worst(0, 1.0, &all))
    }

    /// The worst of all boxes that have the edges already chosen, of volume `volume`, among the points within: each with
    /// whether it lies within without the rim.
    fn worst(&self, dimension: usize, volume: f64, points: &[(usize, bool)]) -> f64 {
        let at = |i: usize| self.at(i, dimension);
        if dimension + 1 == self.dimensions {
            return self.scan(volume, points);
        }
        let mut edges: Vec<f64> = points.iter().map(|(i, _)| at(*i)).collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        if edges.last() != Some(&1.0) {
            edges.push(1.0);
        }
        let mut worst = 0.0_f64;
        for edge in edges {
            let inside = points.iter().filter(|(i, _)| at(*i) <= edge);
            // The faces at 1 bound no box: what lies on them lies within.
            let inside: Vec<(usize, bool)> =
                inside.map(|(i, open)| (*i, *open && (at(*i) < edge || edge == 1.0))).collect();
            worst = worst.max(self.worst(dimension + 1, volume * edge, &inside));
        }
        worst
    }

    /// The last coordinate: edges at each of its values in turn, and at 1.
    fn scan(&self, volume: f64, points: &[(usize, bool)]) -> f64 {
        let n = self.len() as f64;
        let (mut worst, mut open, mut closed) = (0.0_f64, 0.0, 0.0);
        let mut rest = points;
        while let Some((first, _)) = rest.first() {
            let edge = self.at(*first, self.dimensions - 1);
            worst = worst.max(volume * edge - open / n);
            let end = rest.partition_point(|(i, _)| self.at(*i, self.dimensions - 1) <= edge);
            closed += end as f64;
            worst = worst.max(closed / n - volume * edge);
            open += rest[..end].iter().filter(|(_, open)| *open).count() as f64;
            rest = &rest[end..];
        }
        worst.max(volume - open / n)
    }

    /// √∫ (volume − share of the points)² over the corners of all boxes at the origin, by Warnock's sum over pairs; 0 without
    /// points.
    pub fn star_l2(&self) -> f64 {
        let (n, s) = (self.len(), self.dimensions as i32);
        if n == 0 {
            return 0.0;
        }
        let points: Vec<&[f64]> = self.coordinates.chunks_exact(self.dimensions).collect();
        let single: f64 = points.iter().map(|p| p.iter().map(|x| 1.0 - x * x).product::<f64>()).sum();
        let pair = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| 1.0 - x.max(*y)).product::<f64>();
        let mut double = 0.0;
        for (k, p) in points.iter().enumerate() {
            let others: f64 = points[..k].iter().map(|q| pair(p, q)).sum();
            double += 2.0 * others + pair(p, p);
        }
        let n = n as f64;
        let square = 3.0_f64.powi(-s) - 2.0_f64.powi(1 - s) * single / n + double / (n * n);
        square.max(0.0).sqrt()
    }

    fn at(&self, point: usize, dimension: usize) -> f64 {
        self.coordinates[point * self.dimensions + dimension]
    }
}

/// E of the square of [`PointSet::star_l2`] for independent random points: (2⁻ˢ − 3⁻ˢ)/N.
pub fn random_star_l2_squared(dimensions: u32, count: u32) -> f64 {
    let s = dimensions as i32;
    (2.0_f64.powi(-s) - 3.0_f64.powi(-s)) / f64::from(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::radical_inverse::radical_inverse_f64;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12, "{a} for {b}");
    }

    #[test]
    fn one_point() {
        for p in [vec![0.3], vec![0.0], vec![0.9, 0.2], vec![0.5, 0.25, 0.75], vec![0.1; 5]] {
            let s = p.len() as i32;
            let product = |f: &dyn Fn(f64) -> f64| p.iter().map(|x| f(*x)).product::<f64>();
            let most = p.iter().copied().fold(0.0, f64::max);
            let set = PointSet::new(p.len(), p.clone());
            near(set.star().unwrap(), most.max(1.0 - product(&|x| x)));
            let l2 =
                3.0_f64.powi(-s) - 2.0_f64.powi(1 - s) * product(&|x| 1.0 - x * x) + product(&|x| 1.0 - x);
            near(set.star_l2(), l2.sqrt());
        }
    }

    /// Centres of mˢ cells: 1 − (1 − 1/2m)ˢ; in one dimension the L2 is 1/(√12 m).
    #[test]
    fn regular_grids() {
        for (m, s) in [(1, 1), (16, 1), (7, 2), (4, 3), (2, 5)] {
            let coordinate = |i: usize, d: usize| (i / usize::pow(m, d as u32) % m) as f64;
            let points =
                (0..m.pow(s)).flat_map(|i| (0..s as usize).map(move |d| (coordinate(i, d) + 0.5) / m as f64));
            let grid = PointSet::new(s as usize, points.collect());
            near(grid.star().unwrap(), 1.0 - (1.0 - 0.5 / m as f64).powi(s as i32));
            if s == 1 {
                near(grid.star_l2(), 1.0 / (12.0_f64.sqrt() * m as f64));
            }
        }
    }

    /// In one dimension D* is 1/2N + max |x_i − (2i − 1)/2N| over the points in order.
    #[test]
    fn one_dimension() {
        for n in [3, 50, 64] {
            let set = PointSet::of(Generator::Inversive, 1, 5, n);
            let mut x = set.coordinates.clone();
            x.sort_by(f64::total_cmp);
            let off = (0..).zip(&x).map(|(i, x)| (x - (f64::from(i) + 0.5) / f64::from(n)).abs());
            near(set.star().unwrap(), 0.5 / f64::from(n) + off.fold(0.0, f64::max));
        }
    }

    /// Hammersley's 2ᵐ points in the plane [Halton and Zaremba 1969].
    #[test]
    fn hammersley_has_the_l2_of_the_literature() {
        for m in 0..11 {
            let n = 1_u32 << m;
            let points = (0..n).flat_map(|i| [f64::from(i) / f64::from(n), radical_inverse_f64(2, i)]);
            let set = PointSet::new(2, points.collect());
            let (k, p) = (f64::from(m), 0.5_f64.powi(m));
            let square = k * k / 64.0 + 29.0 * k / 192.0 + 3.0 / 8.0 - k * p / 16.0 + p / 4.0 - p * p / 72.0;
            assert!((set.star_l2() * f64::from(n) / square.sqrt() - 1.0).abs() < 1e-6, "m = {m}");
        }
    }

    /// Against all boxes one by one.
    #[test]
    fn the_star_is_that_of_every_box() {
        for (s, n) in [(2, 20), (3, 9), (4, 5)] {
            for generator in Generator::ALL {
                let set = PointSet::of(generator, s, 3, n);
                let s = s as usize;
                let edges = |d: usize| (0..set.len()).map(|i| set.at(i, d)).chain([1.0]).collect::<Vec<_>>();
                let edges: Vec<Vec<f64>> = (0..s).map(edges).collect();
                let mut worst = 0.0_f64;
                for k in 0..(n as usize + 1).pow(s as u32) {
                    let edge: Vec<f64> = (0..s)
                        .map(|d| edges[d][k / (n as usize + 1).pow(d as u32) % (n as usize + 1)])
                        .collect();
                    let volume: f64 = edge.iter().product();
                    let share = |within: &dyn Fn(f64, f64) -> bool| {
                        let count = (0..set.len()).filter(|i| (0..s).all(|d| within(set.at(*i, d), edge[d])));
                        count.count() as f64 / f64::from(n)
                    };
                    worst = worst.max(volume - share(&|x, e| x < e || e == 1.0));
                    worst = worst.max(share(&|x, e| x <= e) - volume);
                }
                near(set.star().unwrap(), worst);
            }
        }
    }

    /// The random ones err as random points do; the others half as much at most. (In the sixteen dimensions of the walk a
    /// thousand points of base 17 are too few to tell.)
    #[test]
    fn low_discrepancy_is_low() {
        const N: u32 = 1024;
        for s in [2, 4, 8] {
            let expected = random_star_l2_squared(s, N);
            for generator in Generator::ALL {
                let seeds = 8_u32;
                let square = |seed: u32| PointSet::of(generator, s, seed + 1, N).star_l2().powi(2);
                let ratio = (0..seeds).map(square).sum::<f64>() / f64::from(seeds) / expected;
                let name = generator.name();
                match generator.is_random() {
                    // A few seeds: the mean of squares has a long tail.
                    true => assert!((0.4..2.5).contains(&ratio), "{name}, s = {s}: {ratio}"),
                    false => assert!(ratio < 0.5, "{name}, s = {s}: {ratio}"),
                }
            }
        }
    }
}
