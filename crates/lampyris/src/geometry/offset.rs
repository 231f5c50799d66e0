//! Where rays leave a surface: far enough from it that no rounding puts them behind it again, and no farther.
//! [Pharr et al. 2016, §3.9.4–5], whose bound is doubled so that it also covers the rounded corners of
//! coplanar neighbours. It knows of triangles only, not of curved surfaces that they may stand for.

use glam::Vec3;

/// More than twice γ(7), the relative error of a point made of weighted corners.
pub(crate) const ERROR: f32 = 16.0 * f32::EPSILON / 2.0;

/// A point of a triangle, and how far along the normal rays must start from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The point [m, world], off the plane of the triangle by its rounding error.
    pub position: Vec3,
    /// Bound of the rounding error, axis by axis.
    pub error: Vec3,
}

impl SurfacePoint {
    /// The point with weight `u` of the second and `v` of the third corner.
    #[inline]
    pub fn new(corners: &[Vec3; 3], u: f32, v: f32) -> SurfacePoint {
        let [a, b, c] = [corners[0] * (1.0 - u - v), corners[1] * u, corners[2] * v];
        SurfacePoint { position: a + b + c, error: (a.abs() + b.abs() + c.abs()) * ERROR }
    }

    /// Start of rays that leave on the side to which the unit geometric `normal` points: segments between such points
    /// never touch the triangles they start and end on.
    #[inline]
    pub fn spawn(&self, normal: Vec3) -> Vec3 {
        let shift = normal * self.error.dot(normal.abs());
        let p = self.position;
        Vec3::new(away(p.x, shift.x), away(p.y, shift.y), away(p.z, shift.z))
    }
}

/// `p + shift`, rounded on in the direction of the shift; without branches, for many points at once.
#[inline(always)]
pub(crate) fn away(p: f32, shift: f32) -> f32 {
    let moved = p + shift;
    let outward = (shift > 0.0) == (moved > 0.0);
    let bits = moved.to_bits();
    let next = if outward { bits.wrapping_add(1) } else { bits.wrapping_sub(1) };
    // Beside zero lies the least float of the shift's sign.
    let next = if moved == 0.0 { 1 | (shift.to_bits() & (1 << 31)) } else { next };
    f32::from_bits(if shift == 0.0 { bits } else { next })
}

#[cfg(test)]
mod tests {
    use super::away;
    use crate::sequence::uniform;

    #[test]
    fn away_is_the_next_float() {
        let numbers =
            [0.0, -0.0, 1.0, -1.0, f32::MIN_POSITIVE, -f32::MIN_POSITIVE, 1e-45, -1e-45, 3.5e7, -2e-9];
        let many = (0..1000).map(|i| (uniform(1, i, 0) - 0.5) * 100.0);
        for p in numbers.into_iter().chain(many) {
            for shift in numbers.into_iter().chain([1e-7, -1e-7, p, -p]) {
                let moved = p + shift;
                let want = if shift > 0.0 {
                    moved.next_up()
                } else if shift < 0.0 {
                    moved.next_down()
                } else {
                    moved
                };
                assert_eq!(away(p, shift).to_bits(), want.to_bits(), "{p} {shift}");
            }
        }
    }
}
