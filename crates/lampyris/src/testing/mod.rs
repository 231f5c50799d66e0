//! Statistics for tests: does a sampler follow its density, and is a mean what theory says?
//!
//! χ² for directions on the sphere, Student's t for means over replicates, Šidák's correction for many tests, running
//! moments. Public because integrators and back ends are tested with it from outside. No light is known here.
//!
//! ```
//! use lampyris::testing::{Moments, sidak};
//! // Sixteen replicates, each with a seed of its own; one of 100 tests at the common level of 1 %.
//! let means: Moments = (0..16).map(|seed| f64::from(lampyris::sequence::uniform(seed, 0, 0))).collect();
//! assert!(means.p_value(0.5) > sidak(0.01, 100));
//! ```

mod chi_square;
mod special;

pub use chi_square::{SphereBins, chi_square_p_value, chi_square_test};
pub use special::{incomplete_beta, incomplete_gamma};

/// Running mean and variance (Welford).
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
}
