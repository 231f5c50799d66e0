//! A ray and what it hits.

use glam::Vec3;

/// A half-line or segment: points `origin + t·direction` for 0 < t < `t_max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Start [m, world]. Rays that leave a surface start at `Surface::spawn`, never on it.
    pub origin: Vec3,
    /// Direction; any length, t is counted in it.
    pub direction: Vec3,
    /// End of the segment, in lengths of `direction`; infinite for a half-line.
    pub t_max: f32,
}

impl Ray {
    /// A half-line.
    pub fn new(origin: Vec3, direction: Vec3) -> Ray {
        Ray { origin, direction, t_max: f32::INFINITY }
    }

    /// The open segment from `a` to `b`.
    pub fn between(a: Vec3, b: Vec3) -> Ray {
        Ray { origin: a, direction: b - a, t_max: 1.0 }
    }

    /// The point at parameter `t`.
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }
}

/// The nearest meeting of a ray and a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance in lengths of the ray's direction.
    pub t: f32,
    /// Barycentric weight of the triangle's second vertex.
    pub u: f32,
    /// Barycentric weight of the triangle's third vertex.
    pub v: f32,
    /// Which instance of the scene.
    pub instance: u32,
    /// Which triangle of the instance's mesh.
    pub triangle: u32,
}
