//! Incomplete gamma and beta functions by series and continued fraction, for the tails of χ² and Student's t.
//! From the textbook definitions [Abramowitz and Stegun 1964, 6.5.29, 6.5.31, 26.5.8]; arguments of statistics only.

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
