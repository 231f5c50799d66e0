//! A pinhole camera, and a camera with a picture size.

use crate::geometry::Ray;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// Where one stands, what one looks at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Name in the file.
    pub name: String,
    /// Eye point [m].
    pub eye: Vec3,
    /// A point on the viewing axis [m].
    pub target: Vec3,
    /// Upward direction, not parallel to the axis.
    pub up: Vec3,
    /// Vertical field of view [degrees].
    pub fov_y: f32,
}

impl Camera {
    /// True if every number is finite, the axis has a direction that is not the upward one, and the field of view lies
    /// between 0° and 180°.
    pub fn is_sound(&self) -> bool {
        let finite = self.eye.is_finite() && self.target.is_finite() && self.up.is_finite();
        let axis = (self.target - self.eye).try_normalize();
        let across = axis.zip(self.up.try_normalize()).map_or(0.0, |(a, up)| a.cross(up).length());
        finite && across > 1e-6 && self.fov_y > 0.0 && self.fov_y < 180.0
    }
}

/// A camera made ready for a picture of a size.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Picture width [pixels].
    pub width: u32,
    /// Picture height [pixels].
    pub height: u32,
    eye: Vec3,
    corner: Vec3,
    right: Vec3,
    down: Vec3,
    forward: Vec3,
    near: f32,
}

impl View {
    /// A camera's view on `width` × `height` pixels.
    pub fn new(camera: &Camera, width: u32, height: u32) -> View {
        let forward = (camera.target - camera.eye).normalize_or(Vec3::NEG_Z);
        let side = forward.cross(camera.up).normalize_or(forward.any_orthonormal_vector());
        let up = side.cross(forward);
        let half = libm::tanf(camera.fov_y.to_radians() * 0.5);
        let (w, h) = (width as f32, height as f32);
        let right = side * (2.0 * half / h);
        let down = -up * (2.0 * half / h);
        let corner = forward - right * (0.5 * w) - down * (0.5 * h);
        View { width, height, eye: camera.eye, corner, right, down, forward, near: 0.0 }
    }

    /// The same view, for which nothing is there up to the plane at that distance from the eye [m]: a section, whose light is
    /// that of the whole.
    #[must_use]
    pub fn cut(self, near: f32) -> View {
        View { near, ..self }
    }

    /// How far along a ray of unit direction nothing is seen [m].
    pub fn skipped(&self, direction: Vec3) -> f32 {
        if self.near > 0.0 { self.near / direction.dot(self.forward).max(1e-3) } else { 0.0 }
    }

    /// The eye point [m].
    pub fn eye(&self) -> Vec3 {
        self.eye
    }

    /// Edge of a pixel at distance 1, in the middle of the picture.
    pub fn pixel_size(&self) -> f32 {
        self.right.length()
    }

    /// True if something is cut off.
    pub fn is_cut(&self) -> bool {
        self.near > 0.0
    }

    /// The ray through picture point (x, y) [pixels from the upper left corner]; unit direction.
    pub fn ray(&self, x: f32, y: f32) -> Ray {
        Ray::new(self.eye, (self.corner + self.right * x + self.down * y).normalize())
    }

    /// Directions of [`View::ray`] through many picture points, x y z of each; equal to it to the bit.
    pub fn directions<const N: usize>(&self, x: &[f32; N], y: &[f32; N]) -> [[f32; N]; 3] {
        let mut d: [[f32; N]; 3] = std::array::from_fn(|axis| {
            std::array::from_fn(|k| self.corner[axis] + self.right[axis] * x[k] + self.down[axis] * y[k])
        });
        for k in 0..N {
            let reciprocal = 1.0 / (d[0][k] * d[0][k] + d[1][k] * d[1][k] + d[2][k] * d[2][k]).sqrt();
            d.iter_mut().for_each(|axis| axis[k] *= reciprocal);
        }
        d
    }
}
