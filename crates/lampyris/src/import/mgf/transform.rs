//! MGF transforms: flags applied to the object in the order written, with repetitions (`-i`) and arrays (`-a`).
//! Matrices act on column vectors here, so that a later flag multiplies from the left.
//! Nesting, and the repetition of an array's block, is the reader's.

use super::args::{Reason, number};
use crate::import::report::quote;
use glam::{DAffine3, DMat3, DVec3};

/// A run of flags between `-i` and `-a`, and how it repeats.
#[derive(Clone, Copy)]
struct Run {
    matrix: DAffine3,
    repeat: Repeat,
}

#[derive(Clone, Copy)]
enum Repeat {
    /// Applied this many times.
    Times(u64),
    /// This many instances, the k-th with k applications.
    Array(u64),
}

/// A parsed transform.
#[derive(Clone)]
pub(super) struct Transform {
    runs: Vec<Run>,
}

impl Transform {
    /// From the words after `xf`, or after a file name.
    pub(super) fn parse(words: &[&str]) -> Reason<Transform> {
        let mut runs = vec![Run { matrix: DAffine3::IDENTITY, repeat: Repeat::Times(1) }];
        let mut words = words.iter();
        while let Some(&flag) = words.next() {
            let mut next =
                || words.next().copied().ok_or_else(|| format!("{} lacks an argument", quote(flag)));
            let mut value = || number(next()?);
            let turn = |axis: usize, degrees: f64| {
                let (sin, cos) = libm::sincos(degrees.to_radians());
                let (mut y, mut z) = (DVec3::ZERO, DVec3::ZERO);
                let mut x = DVec3::ZERO;
                x[axis] = 1.0;
                (y[(axis + 1) % 3], y[(axis + 2) % 3]) = (cos, sin);
                (z[(axis + 1) % 3], z[(axis + 2) % 3]) = (-sin, cos);
                let mut columns = [DVec3::ZERO; 3];
                (columns[axis], columns[(axis + 1) % 3], columns[(axis + 2) % 3]) = (x, y, z);
                DAffine3::from_mat3(DMat3::from_cols(columns[0], columns[1], columns[2]))
            };
            let scale =
                |factors: DVec3| match factors.min_element().abs().min(factors.max_element().abs()) > 0.0 {
                    true => Ok(DAffine3::from_scale(factors)),
                    false => Err(format!("{} 0 would flatten the object to nothing", quote(flag))),
                };
            let matrix = match flag {
                "-t" => DAffine3::from_translation(DVec3::new(value()?, value()?, value()?)),
                "-rx" => turn(0, value()?),
                "-ry" => turn(1, value()?),
                "-rz" => turn(2, value()?),
                "-s" => scale(DVec3::splat(value()?))?,
                // RenderPark's dialect.
                "-sx" => scale(DVec3::new(value()?, 1.0, 1.0))?,
                "-sy" => scale(DVec3::new(1.0, value()?, 1.0))?,
                "-sz" => scale(DVec3::new(1.0, 1.0, value()?))?,
                "-mx" => DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
                "-my" => DAffine3::from_scale(DVec3::new(1.0, -1.0, 1.0)),
                "-mz" => DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0)),
                "-i" | "-a" => {
                    let word = next()?;
                    let least = if flag == "-a" { 1 } else { 0 };
                    let count = word.parse::<u64>().ok().filter(|n| *n >= least);
                    let count = count.ok_or_else(|| {
                        format!("{flag} takes a whole number from {least} on, found {}", quote(word))
                    })?;
                    let repeat = if flag == "-a" { Repeat::Array(count) } else { Repeat::Times(count) };
                    runs.push(Run { matrix: DAffine3::IDENTITY, repeat });
                    continue;
                }
                _ => return Err(format!("unknown transform {}", quote(flag))),
            };
            if let Some(run) = runs.last_mut() {
                run.matrix = matrix * run.matrix;
            }
        }
        Ok(Transform { runs })
    }

    /// How many instances its arrays make in all, 1 without any; capped at the largest number there is.
    pub(super) fn instances(&self) -> u64 {
        self.runs.iter().fold(1, |n: u64, run| match run.repeat {
            Repeat::Array(count) => n.saturating_mul(count),
            Repeat::Times(_) => n,
        })
    }

    /// The matrix of an instance, `instance < instances()`; the last array runs fastest.
    pub(super) fn matrix(&self, instance: u64) -> DAffine3 {
        let mut rest = instance;
        let mut total = DAffine3::IDENTITY;
        // From the last run to the first: what is applied later stands further left.
        for run in self.runs.iter().rev() {
            let times = match run.repeat {
                Repeat::Times(times) => times,
                Repeat::Array(count) => {
                    let index = rest % count;
                    rest /= count;
                    index
                }
            };
            total *= power(run.matrix, times);
        }
        total
    }
}

/// A matrix applied `times` times, by repeated squaring.
fn power(mut matrix: DAffine3, mut times: u64) -> DAffine3 {
    let mut total = DAffine3::IDENTITY;
    while times > 0 {
        if times % 2 == 1 {
            total = matrix * total;
        }
        times /= 2;
        if times > 0 {
            matrix = matrix * matrix;
        }
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Transform {
        Transform::parse(&text.split(' ').collect::<Vec<_>>()).unwrap()
    }

    fn assert_same(a: &str, b: &str) {
        let (a, b) = (parse(a).matrix(0), parse(b).matrix(0));
        for p in [DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0), DVec3::new(-7.0, 0.5, 11.0)] {
            let (a, b) = (a.transform_point3(p), b.transform_point3(p));
            assert!((a - b).length() < 1e-12, "{a} {b}");
        }
    }

    #[test]
    fn rotations_add_up() {
        assert_same("-rx 20 -rx -50", "-rx -30");
        assert_same("-i 7 -ry 11", "-ry 77");
        assert_same("-i 3 -t 1 0 0 -i 1 -rz 90", "-t 3 0 0 -rz 90");
    }

    #[test]
    fn rotations_turn_counter_clockwise_about_their_axis() {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        for (i, flag) in ["-rx 90", "-ry 90", "-rz 90"].into_iter().enumerate() {
            let turned = parse(flag).matrix(0).transform_point3(axes[(i + 1) % 3]);
            assert!((turned - axes[(i + 2) % 3]).length() < 1e-12, "{flag}: {turned}");
        }
    }

    #[test]
    fn a_rotation_between_translations_has_its_axis_elsewhere() {
        let m = parse("-t -15 0 35 -ry -20 -t 15 0 -35").matrix(0);
        let pivot = DVec3::new(15.0, 3.0, -35.0);
        assert!((m.transform_point3(pivot) - pivot).length() < 1e-12);
        let turned = m.transform_vector3(DVec3::Z);
        let angle = 20f64.to_radians();
        assert!((turned - DVec3::new(-libm::sin(angle), 0.0, libm::cos(angle))).length() < 1e-12);
    }

    #[test]
    fn arrays_of_three_dimensions() {
        let t = parse("-a 3 -t 1 0 0 -a 4 -t 0 1 0 -a 5 -t 0 0 1 -i 1 -t 15 30 45");
        assert_eq!(t.instances(), 60);
        let mut seen: Vec<[i64; 3]> = (0..60)
            .map(|k| t.matrix(k).transform_point3(DVec3::ZERO).to_array().map(|v| v.round() as i64))
            .collect();
        seen.sort();
        let mut want = Vec::new();
        for x in 15..=17 {
            for y in 30..=33 {
                want.extend((45..=49).map(|z| [x, y, z]));
            }
        }
        assert_eq!(seen, want);
    }

    #[test]
    fn counts_beyond_all_numbers_are_capped() {
        assert_eq!(parse("-a 18446744073709551615 -a 3").instances(), u64::MAX);
        assert!(parse("-i 18446744073709551615 -rx 1").matrix(0).is_finite());
    }

    #[test]
    fn wrong_transforms_are_refused() {
        for bad in [
            "-t 1 2",
            "-rx",
            "-rx a",
            "-q",
            "-s 0",
            "-a 0",
            "-a -1",
            "-a 1.5",
            "-i -1",
            "t",
            "-sx 0",
            "-t nan 0 0",
        ] {
            assert!(Transform::parse(&bad.split(' ').collect::<Vec<_>>()).is_err(), "{bad}");
        }
    }
}
