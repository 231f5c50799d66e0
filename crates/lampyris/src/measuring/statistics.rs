//! Many readings in a few numbers, each with how far it may be off. Meters of one picture see the same light paths and err
//! together, so errors are never taken to cancel: what is stated holds however they hang together.

use serde::{Deserialize, Serialize};

/// A number and half its 95 % interval, where that is known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// ±.
    pub error: Option<f64>,
}

/// What is said of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// How many points.
    pub count: usize,
    /// Mean illuminance [lx].
    pub mean: Estimate,
    /// Least illuminance [lx].
    pub least: Estimate,
    /// Greatest illuminance [lx].
    pub greatest: Estimate,
    /// U₀: least over mean.
    pub uniformity: Estimate,
    /// U_d: least over greatest.
    pub diversity: Estimate,
}

/// Whether something is as great as it should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Verdict {
    /// It is, wherever in its interval the truth lies.
    Met,
    /// It is not.
    Missed,
    /// The interval lies across; more batches will tell.
    Open,
}

impl Estimate {
    /// Where the number may lie; a reading without an error may lie anywhere.
    fn interval(self) -> Option<[f64; 2]> {
        self.error.filter(|e| e.is_finite()).map(|e| [self.value - e, self.value + e])
    }

    /// A number with an interval that need not be even about it.
    fn within(value: f64, interval: Option<[f64; 2]>) -> Estimate {
        let error = interval.map(|[low, high]| (value - low).max(high - value)).filter(|e| e.is_finite());
        Estimate { value, error }
    }

    /// Whether it is `target` at least.
    pub fn reaches(self, target: f64) -> Verdict {
        match self.interval() {
            Some([low, _]) if low >= target => Verdict::Met,
            Some([_, high]) if high < target => Verdict::Missed,
            _ => Verdict::Open,
        }
    }
}

impl Statistics {
    /// Of readings, each multiplied by `factor`; `None` if there are none.
    pub fn of(readings: &[Estimate], factor: f64) -> Option<Statistics> {
        let count = readings.len();
        let scaled = |e: &Estimate| Estimate { value: e.value * factor, error: e.error.map(|e| e * factor) };
        let readings: Vec<Estimate> = readings.iter().map(scaled).collect();
        let intervals: Option<Vec<[f64; 2]>> = readings.iter().map(|r| r.interval()).collect();
        // Each of the three is monotonic in every reading: its interval is that of the ends.
        let estimate = |figure: &dyn Fn(&mut dyn Iterator<Item = f64>) -> f64| {
            let value = figure(&mut readings.iter().map(|r| r.value));
            let end = |k: usize| intervals.as_ref().map(|all| figure(&mut all.iter().map(|i| i[k])));
            (value, end(0).zip(end(1)).map(|(low, high)| [low, high]))
        };
        let mean = estimate(&|all| all.sum::<f64>() / count as f64);
        let least = estimate(&|all| all.fold(f64::INFINITY, f64::min));
        let greatest = estimate(&|all| all.fold(f64::NEG_INFINITY, f64::max));
        let whole = |(value, interval)| Estimate::within(value, interval);
        (count > 0).then(|| Statistics {
            count,
            mean: whole(mean),
            least: whole(least),
            greatest: whole(greatest),
            uniformity: quotient(least, mean),
            diversity: quotient(least, greatest),
        })
    }
}

/// A quotient of at most 1 of numbers that are not negative, each with its interval; 0 where nothing is lit.
fn quotient((a, a_within): (f64, Option<[f64; 2]>), (b, b_within): (f64, Option<[f64; 2]>)) -> Estimate {
    let divide = |a: f64, b: f64| if b > 0.0 { (a / b).clamp(0.0, 1.0) } else { 0.0 };
    let ends = a_within.zip(b_within).map(|(a, b)| {
        // With a divisor that may be 0 the quotient may be anything.
        let high = if b[0] > 0.0 { divide(a[1], b[0]) } else { 1.0 };
        [divide(a[0], b[1]), high]
    });
    Estimate::within(divide(a, b), ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn readings(all: &[(f64, f64)]) -> Vec<Estimate> {
        all.iter().map(|(value, error)| Estimate { value: *value, error: Some(*error) }).collect()
    }

    #[test]
    fn figures_are_what_their_names_say() {
        let s = Statistics::of(&readings(&[(100.0, 0.0), (300.0, 0.0), (200.0, 0.0)]), 0.5).expect("some");
        let values = [s.mean, s.least, s.greatest, s.uniformity, s.diversity];
        assert_eq!(values.map(|e| e.value), [100.0, 50.0, 150.0, 0.5, 1.0 / 3.0]);
        assert!(values.iter().all(|e| e.error == Some(0.0)) && s.count == 3);
        assert_eq!(Statistics::of(&[], 1.0), None);
    }

    /// Whatever the readings really are within their errors, the figures lie within theirs.
    #[test]
    fn errors_hold_for_all_truths() {
        let given = [(100.0, 5.0), (104.0, 20.0), (300.0, 30.0), (90.0, 2.0)];
        let s = Statistics::of(&readings(&given), 1.0).expect("some");
        for corner in 0..81 {
            let truth: Vec<(f64, f64)> = (0..4)
                .map(|k| (given[k].0 + given[k].1 * (f64::from(corner / 3i32.pow(k as u32) % 3) - 1.0), 0.0))
                .collect();
            let t = Statistics::of(&readings(&truth), 1.0).expect("some");
            let pairs = [
                (s.mean, t.mean),
                (s.least, t.least),
                (s.greatest, t.greatest),
                (s.uniformity, t.uniformity),
                (s.diversity, t.diversity),
            ];
            for (stated, true_) in pairs {
                assert!((stated.value - true_.value).abs() <= stated.error.expect("known") + 1e-12);
            }
        }
        assert_eq!(s.mean.error, Some(57.0 / 4.0));
    }

    #[test]
    fn unknown_errors_stay_unknown_and_darkness_has_no_uniformity() {
        let mut all = readings(&[(100.0, 5.0), (50.0, 5.0)]);
        all[1].error = None;
        let s = Statistics::of(&all, 1.0).expect("some");
        assert!([s.mean, s.least, s.uniformity].iter().all(|e| e.error.is_none()));
        assert_eq!(s.mean.reaches(1.0), Verdict::Open);
        all[1].error = Some(f64::INFINITY);
        assert_eq!(Statistics::of(&all, 1.0).expect("some").mean.error, None);
        let dark = Statistics::of(&readings(&[(0.0, 0.0); 3]), 1.0).expect("some");
        assert_eq!((dark.uniformity.value, dark.diversity.value), (0.0, 0.0));
    }

    #[test]
    fn verdicts_wait_for_the_interval() {
        let e = Estimate { value: 500.0, error: Some(10.0) };
        assert_eq!(
            [490.0, 491.0, 510.0, 511.0].map(|t| e.reaches(t)),
            [Verdict::Met, Verdict::Open, Verdict::Open, Verdict::Missed]
        );
    }
}
