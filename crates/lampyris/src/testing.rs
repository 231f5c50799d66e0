//! Statistics for tests: does a sampler follow its density, and is a mean what theory says?
//!
//! χ² for directions on the sphere, Student's t for means over replicates, Šidák's correction for many tests, running
//! moments. Written from the textbook definitions (incomplete gamma and beta functions by series and continued
//! fraction); public because integrators and back ends are tested with it from outside. No light is known here.

use glam::Vec3;

/// Running mean and variance (Welford), mergeable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    squares: f64,
}

impl Moments {
    /// Adds an observation.
    pub fn push(&mut self, x: f64) {
        self.count += 1;
        let d = x - self.mean;
        self.mean += d / self.count as f64;
        self.squares += d * (x - self.mean);
    }

    /// Number of observations.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean; 0 of none.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Unbiased variance; 0 of fewer than two.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { 0.0 } else { self.squares / (self.count - 1) as f64 }
    }

    /// Standard error of the mean.
    pub fn standard_error(&self) -> f64 {
        (self.variance() / self.count.max(1) as f64).sqrt()
    }

    /// Two-sided p-value of "the mean is `expected`" by Student's t. The observations must be independent: for
    /// low-discrepancy sequences these are differently scrambled replicates, never single samples.
    pub fn p_value(&self, expected: f64) -> f64 {
        let difference = self.mean - expected;
        match self.standard_error() {
            0.0 => f64::from(u8::from(difference == 0.0)),
            e => student_p_value(difference / e, (self.count - 1) as f64),
        }
    }

    /// Two-sided p-value of "both means are the same" by Welch's t-test, variances unequal.
    pub fn p_value_against(&self, other: &Moments) -> f64 {
        let (a, b) = (self.standard_error().powi(2), other.standard_error().powi(2));
        if a + b == 0.0 {
            return f64::from(u8::from(self.mean == other.mean));
        }
        let freedom = (a + b).powi(2) / (a * a / (self.count - 1) as f64 + b * b / (other.count - 1) as f64);
        student_p_value((self.mean - other.mean) / (a + b).sqrt(), freedom)
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(observations: I) -> Moments {
        let mut moments = Moments::default();
        observations.into_iter().for_each(|x| moments.push(x));
        moments
    }
}

/// The level of each of `tests` independent tests that together reject truth with probability `level`.
pub fn sidak(level: f64, tests: usize) -> f64 {
    -libm::expm1(libm::log1p(-level) / tests as f64)
}

/// Two-sided p-value of Student's t.
pub fn student_p_value(t: f64, freedom: f64) -> f64 {
    incomplete_beta(0.5 * freedom, 0.5, freedom / (freedom + t * t))
}

/// The t that is exceeded in absolute value with probability `p`.
pub fn student_quantile(p: f64, freedom: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while student_p_value(high, freedom) > p && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if student_p_value(middle, freedom) > p { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Probability that χ² of so many degrees of freedom is at least `chi2`.
pub fn chi_square_p_value(chi2: f64, freedom: f64) -> f64 {
    1.0 - incomplete_gamma(0.5 * freedom, 0.5 * chi2)
}

/// p-value of observed against expected counts, cells pooled until each expects five; `fitted` parameters cost a
/// degree of freedom each beside the total's.
pub fn chi_square_test(observed: &[f64], expected: &[f64], fitted: usize) -> f64 {
    let mut cells: Vec<(f64, f64)> = expected.iter().copied().zip(observed.iter().copied()).collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut chi2, mut used, mut pool) = (0.0, 0usize, (0.0, 0.0));
    let mut rest: f64 = cells.iter().map(|c| c.0).sum();
    for (e, o) in cells {
        rest -= e;
        pool = (pool.0 + e, pool.1 + o);
        // The last cells stay together if what follows could not make a cell of its own.
        if pool.0 >= 5.0 && (rest >= 5.0 || rest <= 1e-9) {
            chi2 += (pool.1 - pool.0).powi(2) / pool.0;
            used += 1;
            pool = (0.0, 0.0);
        }
    }
    // What lies in cells that expect nothing at all must not be forgotten.
    if pool.0 + pool.1 > 1e-6 {
        chi2 += (pool.1 - pool.0).powi(2) / pool.0.max(1e-9);
        used += 1;
    }
    match used.saturating_sub(1 + fitted) {
        0 => f64::from(u8::from(chi2 < 1e-6)),
        freedom => chi_square_p_value(chi2, freedom as f64),
    }
}

/// A partition of the sphere about an axis: `rings` × `sectors`, each hemisphere cut at its own rings.
#[derive(Clone, Copy, Debug)]
pub struct SphereBins {
    /// Rings of one hemisphere.
    pub rings: usize,
    /// Sectors of each ring.
    pub sectors: usize,
    /// Rings lie at 1 − |cos θ| = t^power for t = 0 … 1: 1 makes equal areas, more is finer at the poles.
    pub power: i32,
    /// The pole, a unit vector.
    pub axis: Vec3,
}

impl SphereBins {
    /// 16 × 32 cells of equal area on each hemisphere about +z.
    pub const EVEN: SphereBins = SphereBins { rings: 16, sectors: 32, power: 1, axis: Vec3::Z };

    /// p-value of "`sample` follows `pdf`" [sr⁻¹] from `samples` calls with their number. `None` is a sample lost: what
    /// `pdf` lacks to an integral of 1 must be lost just as often.
    pub fn test(
        &self,
        samples: u32,
        mut sample: impl FnMut(u32) -> Option<Vec3>,
        pdf: impl Fn(Vec3) -> f32,
    ) -> f64 {
        let mut observed = vec![0.0; 2 * self.rings * self.sectors + 1];
        let lost = observed.len() - 1;
        for i in 0..samples {
            observed[sample(i).map_or(lost, |w| self.bin(w))] += 1.0;
        }
        let mut expected: Vec<f64> =
            self.integrals(|w| f64::from(pdf(w))).iter().map(|p| p * f64::from(samples)).collect();
        expected.push((f64::from(samples) - expected.iter().sum::<f64>()).max(0.0));
        chi_square_test(&observed, &expected, 0)
    }

    /// ∫ f dω over the whole sphere.
    pub fn integral(&self, f: impl Fn(Vec3) -> f64) -> f64 {
        self.integrals(f).iter().sum()
    }

    /// ∫ f dω over each bin.
    pub fn integrals(&self, f: impl Fn(Vec3) -> f64) -> Vec<f64> {
        let mut integrals = Vec::with_capacity(2 * self.rings * self.sectors);
        let (r, s) = (self.rings as f64, self.sectors as f64);
        for k in 0..2 * self.rings * self.sectors {
            let (side, ring) = (k / self.sectors / self.rings, k / self.sectors % self.rings);
            let side = if side == 0 { 1.0 } else { -1.0 };
            let g = |t: f64, phi: f64| f(self.direction(side, t, phi)) * self.jacobian(t);
            let (t, phi) = (ring as f64 / r, (k % self.sectors) as f64 * std::f64::consts::TAU / s);
            integrals.push(cubature(&g, [t, phi], [1.0 / r, std::f64::consts::TAU / s]));
        }
        integrals
    }

    fn direction(&self, side: f64, t: f64, phi: f64) -> Vec3 {
        let gap = t.powi(self.power);
        let (sin, cos) = libm::sincos(phi);
        let r = (gap * (2.0 - gap)).max(0.0).sqrt();
        let [s, u, n] = self.axes();
        s * (r * cos) as f32 + u * (r * sin) as f32 + n * (side * (1.0 - gap)) as f32
    }

    /// |dω/(dt dφ)|.
    fn jacobian(&self, t: f64) -> f64 {
        f64::from(self.power) * t.powi(self.power - 1)
    }

    fn bin(&self, w: Vec3) -> usize {
        let [s, u, n] = self.axes();
        let (x, y) = (f64::from(w.dot(s)), f64::from(w.dot(u)));
        let z = f64::from(w.dot(n));
        // 1 − |cos θ| from the sine: the cosine of a narrow lobe has no digits left.
        let gap = (x * x + y * y) / (1.0 + z.abs());
        let t = libm::pow(gap.max(0.0), 1.0 / f64::from(self.power));
        let ring = ((t * self.rings as f64) as usize).min(self.rings - 1);
        let turn = libm::atan2(y, x) / std::f64::consts::TAU;
        let sector = ((turn - turn.floor()) * self.sectors as f64) as usize;
        let side = usize::from(z < 0.0);
        (side * self.rings + ring) * self.sectors + sector.min(self.sectors - 1)
    }

    fn axes(&self) -> [Vec3; 3] {
        let frame = crate::geometry::Frame::new(self.axis);
        [frame.s, frame.t, frame.n]
    }
}

/// ∫ g over the rectangle at `origin` with `size`: Gauss's rule with 3 × 3 nodes against its own on four quarters,
/// until they agree to 1e-7 of the unit integral or the quarters are 4⁻⁷ of the whole.
fn cubature(g: &impl Fn(f64, f64) -> f64, origin: [f64; 2], size: [f64; 2]) -> f64 {
    fn gauss(g: &impl Fn(f64, f64) -> f64, [x, y]: [f64; 2], [w, h]: [f64; 2]) -> f64 {
        // √0.6, the outer node.
        let nodes = [
            (-0.774_596_669_241_483_4, 5.0 / 18.0),
            (0.0, 8.0 / 18.0),
            (0.774_596_669_241_483_4, 5.0 / 18.0),
        ];
        let mut sum = 0.0;
        for (a, wa) in nodes {
            for (b, wb) in nodes {
                sum += wa * wb * g(x + 0.5 * w * (1.0 + a), y + 0.5 * h * (1.0 + b));
            }
        }
        sum * w * h
    }
    fn refine(
        g: &impl Fn(f64, f64) -> f64,
        [x, y]: [f64; 2],
        [w, h]: [f64; 2],
        whole: f64,
        depth: u32,
    ) -> f64 {
        let half = [0.5 * w, 0.5 * h];
        let corners = [[x, y], [x + half[0], y], [x, y + half[1]], [x + half[0], y + half[1]]];
        let parts = corners.map(|c| gauss(g, c, half));
        let sum: f64 = parts.iter().sum();
        // The first division is always tried: a narrow peak may hide between the nodes.
        if depth == 0 || (depth < 7 && (sum - whole).abs() < 1e-7) {
            return sum;
        }
        corners.iter().zip(parts).map(|(c, p)| refine(g, *c, half, p, depth - 1)).sum()
    }
    refine(g, origin, size, gauss(g, origin, size), 7)
}

/// Regularised lower incomplete gamma function P(a, x): series below a + 1, Lentz's continued fraction above.
pub fn incomplete_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let front = libm::exp(a * libm::log(x) - x - libm::lgamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        while term > sum * 1e-16 {
            n += 1.0;
            term *= x / n;
            sum += term;
        }
        return sum * front;
    }
    let fraction = continued_fraction(|n| match n {
        0 => (1.0, x + 1.0 - a),
        n => (-f64::from(n) * (f64::from(n) - a), x + 1.0 - a + 2.0 * f64::from(n)),
    });
    1.0 - front * fraction
}

/// Regularised incomplete beta function I_x(a, b).
pub fn incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return x.clamp(0.0, 1.0);
    }
    // The fraction converges fast only left of the mean.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - incomplete_beta(b, a, 1.0 - x);
    }
    let log_beta = libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b);
    let front = libm::exp(a * libm::log(x) + b * libm::log1p(-x) - log_beta) / a;
    let fraction = continued_fraction(|n| {
        let m = f64::from(n / 2);
        let numerator = match n {
            0 => 1.0,
            n if n % 2 == 0 => m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)),
            _ => -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0)),
        };
        (numerator, 1.0)
    });
    front * fraction
}

/// a₀/(b₀ + a₁/(b₁ + …)) for n ↦ (a_n, b_n), by Lentz's method.
fn continued_fraction(term: impl Fn(u32) -> (f64, f64)) -> f64 {
    const TINY: f64 = 1e-300;
    let apart_from_zero = |x: f64| if x.abs() < TINY { TINY } else { x };
    let (mut value, mut c, mut d) = (TINY, TINY, 0.0);
    for n in 0..10_000 {
        let (a, b) = term(n);
        d = 1.0 / apart_from_zero(b + a * d);
        c = apart_from_zero(b + a / c);
        value *= c * d;
        if n > 0 && (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_the_textbooks() {
        // Two degrees: exp(−x/2). One: erfc(√(x/2)).
        assert!((chi_square_p_value(3.0, 2.0) - libm::exp(-1.5)).abs() < 1e-14);
        assert!((chi_square_p_value(3.0, 1.0) - libm::erfc(1.5f64.sqrt())).abs() < 1e-14);
        assert!((chi_square_p_value(124.342, 100.0) - 0.05).abs() < 1e-5);
        // One degree: Cauchy. Two: 1 − t/√(2 + t²).
        assert!((student_p_value(1.0, 1.0) - 0.5).abs() < 1e-14);
        assert!((student_p_value(3.0, 2.0) - (1.0 - 3.0 / 11f64.sqrt())).abs() < 1e-14);
        assert!((student_quantile(0.05, 15.0) - 2.131_449_5).abs() < 1e-6);
        assert!((student_quantile(0.01, 30.0) - 2.749_995_7).abs() < 1e-6);
        assert!((sidak(0.01, 1) - 0.01).abs() < 1e-15);
        assert!((1.0 - (1.0 - sidak(0.01, 50)).powi(50) - 0.01).abs() < 1e-12);
    }

    #[test]
    fn moments_are_mean_and_variance() {
        let m: Moments = [1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0].into_iter().collect();
        assert_eq!((m.count(), m.mean(), m.variance()), (4, 1e9 + 10.0, 30.0));
        assert!((m.p_value(1e9 + 10.0) - 1.0).abs() < 1e-12);
        assert!(m.p_value(1e9) < 0.05 && m.p_value_against(&m) == 1.0);
    }

    #[test]
    fn chi_square_tells_right_from_wrong() {
        use crate::sampling::{cosine_hemisphere, uniform_sphere};
        use crate::sequence::uniform;
        let u = |i| [uniform(1, i, 0), uniform(1, i, 1)];
        let cosine = |w: Vec3| w.z.max(0.0) * std::f32::consts::FRAC_1_PI;
        assert!(SphereBins::EVEN.test(100_000, |i| Some(cosine_hemisphere(u(i))), cosine) > 0.01);
        assert!(SphereBins::EVEN.test(100_000, |i| Some(uniform_sphere(u(i))), cosine) < 1e-9);
        // A density 3 % too large, and losses that the density does not admit.
        let lossy = |i| (uniform(1, i, 2) < 0.97).then(|| cosine_hemisphere(u(i)));
        assert!(SphereBins::EVEN.test(100_000, lossy, cosine) < 1e-9);
        assert!(SphereBins::EVEN.test(100_000, lossy, |w| 0.97 * cosine(w)) > 0.01);
    }
}
