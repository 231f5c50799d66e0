//! What is asked of places by EN 12464-1, Light and lighting: Lighting of work places, Part 1 (2011): maintained mean
//! illuminance and uniformity on the task. A choice of common ones in words of our own; whoever plans looks up the edition
//! that is in force.

use super::statistics::{Statistics, Verdict};

/// What is asked of a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// What is done there.
    pub name: &'static str,
    /// Least mean illuminance [lx].
    pub illuminance: f64,
    /// Least U₀.
    pub uniformity: f64,
}

const fn target(name: &'static str, illuminance: f64, uniformity: f64) -> Target {
    Target { name, illuminance, uniformity }
}

/// Common places, by what is asked of them.
pub const TARGETS: &[Target] = &[
    target("corridor", 100.0, 0.4),
    target("stairs", 100.0, 0.4),
    target("entrance hall", 100.0, 0.4),
    target("store room", 100.0, 0.4),
    target("canteen", 200.0, 0.4),
    target("washroom", 200.0, 0.4),
    target("archive", 200.0, 0.4),
    target("filing and copying", 300.0, 0.4),
    target("shop floor", 300.0, 0.4),
    target("reception desk", 300.0, 0.6),
    target("classroom", 300.0, 0.6),
    target("reading and writing at a desk", 500.0, 0.6),
    target("work at screens", 500.0, 0.6),
    target("meeting room", 500.0, 0.6),
    target("till", 500.0, 0.6),
    target("technical drawing", 750.0, 0.7),
];

impl Target {
    /// Whether a surface has the light and the uniformity that are asked for.
    pub fn judge(&self, of: &Statistics) -> [Verdict; 2] {
        [of.mean.reaches(self.illuminance), of.uniformity.reaches(self.uniformity)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measuring::Estimate;

    #[test]
    fn a_desk_is_judged_by_both() {
        let desk =
            TARGETS.iter().find(|t| t.name.contains("desk") && t.illuminance == 500.0).expect("a desk");
        let of = |all: &[f64]| {
            let readings: Vec<Estimate> =
                all.iter().map(|v| Estimate { value: *v, error: Some(1.0) }).collect();
            desk.judge(&Statistics::of(&readings, 1.0).expect("some"))
        };
        assert_eq!(of(&[520.0, 560.0]), [Verdict::Met, Verdict::Met]);
        assert_eq!(of(&[1000.0, 100.0]), [Verdict::Met, Verdict::Missed]);
        assert_eq!(of(&[400.0, 400.0]), [Verdict::Missed, Verdict::Met]);
        assert_eq!(of(&[500.0, 500.0])[0], Verdict::Open);
        assert!(TARGETS.windows(2).all(|two| two[0].illuminance <= two[1].illuminance));
    }
}
