//! Directions in two bytes or one: the sphere as an octahedron, unfolded to a square, on a grid of odd width, so that the
//! axes and thus most walls are exact. [Jarosz05, §2.4.1] has longitude and latitude, whose cells are half as large again
//! at the equator and crowd at the poles.
//!
//! With H steps from the middle of the square to its edge, directions lie on a lattice whose holes are widest in the
//! middle of an octant: there equal steps d = 1/H are hexagons of circumradius √(2/3) d at distance 1/√3 from the centre,
//! so nothing is farther than √2/H from its code.

use glam::Vec3;

/// Steps of directions in two bytes: to within √2/127 rad, which is 0.64°.
const FINE: f32 = 127.0;

/// Steps of normals in one byte: to within √2/7 rad, which is 11.6°.
const COARSE: f32 = 7.0;

/// A unit vector to within 0.64°, exact along the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Direction([u8; 2]);

/// A unit vector to within 11.6°, exact along the axes: enough to tell the sides of a wall apart, and walls that meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CoarseNormal(u8);

impl Direction {
    /// Largest angle between a vector and what is kept of it [rad]; the tenth of a per cent covers higher orders and rounding.
    pub const ERROR: f32 = 1.001 * std::f32::consts::SQRT_2 / FINE;
}

impl CoarseNormal {
    /// Largest angle between a vector and what is kept of it [rad].
    pub const ERROR: f32 = 1.001 * std::f32::consts::SQRT_2 / COARSE;
}

impl From<Vec3> for Direction {
    /// Of a vector of any length.
    fn from(v: Vec3) -> Direction {
        Direction(nearest(v, FINE).map(|step| (step + FINE) as u8))
    }
}

impl From<Direction> for Vec3 {
    fn from(d: Direction) -> Vec3 {
        fold(d.0.map(|code| (f32::from(code) - FINE) / FINE))
    }
}

impl From<Vec3> for CoarseNormal {
    /// Of a vector of any length.
    fn from(v: Vec3) -> CoarseNormal {
        let [x, y] = nearest(v, COARSE).map(|step| step + COARSE);
        CoarseNormal((x + y * (2.0 * COARSE + 1.0)) as u8)
    }
}

impl From<CoarseNormal> for Vec3 {
    fn from(n: CoarseNormal) -> Vec3 {
        let width = 2 * COARSE as u8 + 1;
        fold([n.0 % width, n.0 / width].map(|code| (f32::from(code) - COARSE) / COARSE))
    }
}

/// The steps from the middle of the square that come nearest to a direction: one of the four corners of the cell around it.
fn nearest(v: Vec3, half: f32) -> [f32; 2] {
    let low = unfold(v).map(|c| (c * half).floor());
    let mut best = (f32::NEG_INFINITY, low);
    for (i, j) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
        let steps = [(low[0] + i).min(half), (low[1] + j).min(half)];
        let cosine = fold(steps.map(|s| s / half)).dot(v);
        if cosine > best.0 {
            best = (cosine, steps);
        }
    }
    best.1
}

/// A direction as a point of the square [−1, 1]².
fn unfold(v: Vec3) -> [f32; 2] {
    let v = v / (v.x.abs() + v.y.abs() + v.z.abs()).max(f32::MIN_POSITIVE);
    let below = |a: f32, b: f32| if v.z < 0.0 { (1.0 - b.abs()) * 1.0_f32.copysign(a) } else { a };
    [below(v.x, v.y), below(v.y, v.x)].map(|c| c.clamp(-1.0, 1.0))
}

/// The unit vector of a point of the square.
fn fold([x, y]: [f32; 2]) -> Vec3 {
    let z = 1.0 - x.abs() - y.abs();
    // Below the equator the corners are turned over the edges of the inner square.
    let under = (-z).max(0.0);
    Vec3::new(x - under.copysign(x), y - under.copysign(y), z).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest angle over the points of ever finer grids within each cell of the code, whole sphere [rad].
    fn worst<T: From<Vec3> + Copy>(half: f32, parts: i32) -> f32
    where
        Vec3: From<T>,
    {
        let steps = half as i32 * parts;
        let mut worst = 0.0_f32;
        for i in -steps..=steps {
            for j in -steps..=steps {
                let v = fold([i, j].map(|k| k as f32 / steps as f32));
                let kept = Vec3::from(T::from(v));
                assert!((kept.length() - 1.0).abs() < 1e-6);
                // The chord keeps small angles that a cosine has no digits for.
                worst = worst.max(2.0 * libm::asinf(0.5 * (kept - v).length()));
            }
        }
        worst
    }

    /// Every cell of the code is tried at its corners, at its middle, and where three cells meet, the farthest from any code.
    #[test]
    fn no_direction_is_farther_than_the_bound() {
        let fine = worst::<Direction>(FINE, 6);
        assert!(fine <= Direction::ERROR && fine > 0.99 * Direction::ERROR, "{fine}");
        let coarse = worst::<CoarseNormal>(COARSE, 60);
        assert!(coarse <= CoarseNormal::ERROR && coarse > 0.97 * CoarseNormal::ERROR, "{coarse}");
    }

    #[test]
    fn every_code_is_its_own() {
        for x in 0..=254_u8 {
            for y in 0..=254_u8 {
                let v = Vec3::from(Direction([x, y]));
                // Along the edges two codes are one direction, to within rounding; others are ten thousand times as far apart.
                assert!((Vec3::from(Direction::from(v)) - v).length() < 1e-6, "{v}");
            }
        }
        for code in 0..225 {
            let v = Vec3::from(CoarseNormal(code));
            assert!((Vec3::from(CoarseNormal::from(v)) - v).length() < 1e-6, "{v}");
        }
    }

    #[test]
    fn axes_are_exact_and_nonsense_is_a_direction() {
        for axis in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z] {
            assert_eq!(Vec3::from(Direction::from(axis * 7.5)), axis);
            assert_eq!(Vec3::from(CoarseNormal::from(axis)), axis);
        }
        for v in [Vec3::ZERO, Vec3::NAN, Vec3::INFINITY, Vec3::splat(f32::MIN_POSITIVE), Vec3::MAX] {
            assert!(Vec3::from(Direction::from(v)).is_normalized(), "{v}");
            assert!(Vec3::from(CoarseNormal::from(v)).is_normalized(), "{v}");
        }
    }
}
