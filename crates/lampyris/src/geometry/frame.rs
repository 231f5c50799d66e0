//! An orthonormal frame about a normal, without branches that jump near a pole.

use glam::Vec3;

/// Right-handed orthonormal axes; the third is the normal. BSDFs see directions in such a frame, normal = +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First tangent.
    pub s: Vec3,
    /// Second tangent.
    pub t: Vec3,
    /// Normal.
    pub n: Vec3,
}

impl Frame {
    /// From a unit normal [Duff et al. 2017].
    pub fn new(n: Vec3) -> Frame {
        let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        Frame {
            s: Vec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            t: Vec3::new(b, sign + n.y * n.y * a, -n.y),
            n,
        }
    }

    /// World → local.
    pub fn to_local(&self, w: Vec3) -> Vec3 {
        Vec3::new(w.dot(self.s), w.dot(self.t), w.dot(self.n))
    }

    /// Local → world.
    pub fn to_world(&self, l: Vec3) -> Vec3 {
        self.s * l.x + self.t * l.y + self.n * l.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orthonormal_everywhere() {
        for i in 0..2000 {
            let z = 1.0 - 2.0 * (i as f32 + 0.5) / 2000.0;
            let (sin, cos) = libm::sincosf(i as f32 * 2.4);
            let r = (1.0 - z * z).max(0.0).sqrt();
            let f = Frame::new(Vec3::new(r * cos, r * sin, z));
            assert!(f.s.dot(f.t).abs() < 1e-5 && f.s.dot(f.n).abs() < 1e-5 && f.t.dot(f.n).abs() < 1e-5);
            assert!((f.s.cross(f.t) - f.n).length() < 1e-5);
            let w = Vec3::new(0.3, -0.5, 0.9);
            assert!((f.to_world(f.to_local(w)) - w).length() < 1e-5);
        }
    }
}
