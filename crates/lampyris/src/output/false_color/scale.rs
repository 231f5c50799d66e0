//! From values to places on a legend, and the round numbers to write beside it.

use serde::{Deserialize, Serialize};

/// How a legend runs from its low end to its high one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Scale {
    /// Equal steps are equal differences.
    #[default]
    Linear,
    /// Equal steps are equal factors.
    Log,
}

/// A value beside a legend.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tick {
    /// The value: 1, 2 or 5 times a power of ten, or a multiple of such a step.
    pub value: f64,
    /// Where it stands, 0 at the low end to 1 at the high one.
    pub place: f32,
}

/// Most values beside a legend.
const MOST: usize = 100;

impl Scale {
    /// Where a finite value lies between the ends, 0 to 1.
    pub(super) fn place(self, value: f32, low: f32, high: f32) -> f32 {
        let [value, low, high] = [value, low, high].map(f64::from);
        let place = match self {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log if value <= low => 0.0,
            Scale::Log => libm::log(value / low) / libm::log(high / low),
        };
        place.clamp(0.0, 1.0) as f32
    }

    pub(super) fn ticks(self, low: f32, high: f32, count: usize) -> Vec<Tick> {
        let count = count.clamp(2, MOST);
        let [from, to] = [low, high].map(f64::from);
        if !(from < to && (to - from).is_finite()) || (self == Scale::Log && from <= 0.0) {
            return Vec::new();
        }
        let values = match self {
            Scale::Linear => multiples(from, to, count),
            // Less than a decade is read off like a ruler.
            Scale::Log if to / from < 10.0 => multiples(from, to, count),
            Scale::Log => decades(from, to, count),
        };
        let tick = |value: f64| Tick { value, place: self.place(value as f32, low, high) };
        values.into_iter().map(tick).collect()
    }
}

/// Multiples of the least step of 1, 2 or 5 times a power of ten of which there are no more than `count`.
fn multiples(from: f64, to: f64, count: usize) -> Vec<f64> {
    let rough = (to - from) / count as f64;
    let tens = libm::floor(libm::log10(rough)) as i32;
    let fits = |(ones, tens): &(f64, i32)| {
        let inside = |v: f64| (from..=to).contains(&v);
        let all: Vec<f64> =
            numbers(from, to, *ones, *tens, count + 2).into_iter().filter(|v| inside(*v)).collect();
        (all.len() <= count).then_some(all)
    };
    let steps = (tens..=tens + 2).flat_map(|tens| [1.0, 2.0, 5.0].map(|ones| (ones, tens)));
    steps.into_iter().find_map(|step| fits(&step)).unwrap_or_default()
}

/// The first multiples of a step from an end on, by whole numbers so that they are round.
fn numbers(from: f64, to: f64, ones: f64, tens: i32, most: usize) -> Vec<f64> {
    let times = |k: f64| scaled(k * ones, tens);
    let first = libm::ceil(from / times(1.0) - 1e-9);
    let all = (0..most).map(|k| times(first + k as f64));
    all.take_while(|v| *v <= to).collect()
}

/// A whole number times a power of ten, to the nearest number there is.
fn scaled(whole: f64, tens: i32) -> f64 {
    let power = libm::pow(10.0, f64::from(tens.abs()));
    if tens < 0 { whole / power } else { whole * power }
}

/// 1, 2 and 5 times powers of ten; of more than `count` the powers alone, and of these every second, third …
fn decades(from: f64, to: f64, count: usize) -> Vec<f64> {
    let first = libm::floor(libm::log10(from)) as i32;
    let last = libm::ceil(libm::log10(to)) as i32;
    let inside = |ones: &'static [f64], every: usize| -> Vec<f64> {
        let powers = (first..=last).filter(|tens| tens.rem_euclid(every as i32) == 0);
        let all = powers.flat_map(|tens| ones.iter().map(move |one| scaled(*one, tens)));
        all.filter(|v| (from..=to).contains(v)).collect()
    };
    let dense = inside(&[1.0, 2.0, 5.0], 1);
    if dense.len() <= count {
        return dense;
    }
    (1..).map(|every| inside(&[1.0], every)).find(|all| all.len() <= count).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(scale: Scale, low: f32, high: f32, count: usize) -> Vec<f64> {
        scale.ticks(low, high, count).into_iter().map(|t| t.value).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(values(Scale::Linear, 0.0, 1000.0, 6), [0.0, 200.0, 400.0, 600.0, 800.0, 1000.0]);
        assert_eq!(values(Scale::Linear, 3.0, 47.0, 5), [10.0, 20.0, 30.0, 40.0]);
        assert_eq!(values(Scale::Linear, -0.25, 0.25, 6), [-0.2, -0.1, 0.0, 0.1, 0.2]);
        assert_eq!(values(Scale::Log, 10.0, 1000.0, 8), [10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0]);
        assert_eq!(values(Scale::Log, 1.0, 1e6, 8), [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6]);
        assert_eq!(values(Scale::Log, 1e-3, 1e9, 7), [1e-2, 1.0, 1e2, 1e4, 1e6, 1e8]);
        assert_eq!(
            values(Scale::Log, 200.0, 900.0, 8),
            [200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0, 900.0]
        );
    }

    /// Whatever the ends: not too many, not one alone, in order, and where they say.
    #[test]
    fn ticks_stand_where_they_say() {
        for scale in [Scale::Linear, Scale::Log] {
            for a in -20..20 {
                for b in 1..40 {
                    let low = libm::powf(10.0, a as f32 * 0.31);
                    let high = low * libm::powf(10.0, b as f32 * 0.17);
                    for count in [3, 5, 8, 20] {
                        let ticks = scale.ticks(low, high, count);
                        assert!(!ticks.is_empty() && ticks.len() <= count, "{low} {high}: {ticks:?}");
                        assert!(ticks.windows(2).all(|two| two[0].place < two[1].place));
                        for tick in &ticks {
                            assert!((0.0..=1.0).contains(&tick.place));
                            assert_eq!(tick.place, scale.place(tick.value as f32, low, high));
                        }
                    }
                }
            }
        }
        for (low, high) in
            [(1.0, 1.0), (2.0, 1.0), (f32::NAN, 1.0), (f32::MIN, f32::MAX), (0.0, f32::INFINITY)]
        {
            assert!(Scale::Linear.ticks(low, high, 5).len() <= 5);
        }
        assert!(Scale::Log.ticks(0.0, 1.0, 5).is_empty());
    }
}
