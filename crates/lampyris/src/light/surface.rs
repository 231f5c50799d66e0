//! One side of an emissive surface: any number of triangles, sampled uniformly by area.

use crate::color::Rgb;
use crate::geometry::SurfacePoint;
use crate::sampling;
use glam::Vec3;

/// The triangles of one instance and material that glow, on one of their sides.
#[derive(Clone, Debug)]
pub struct EmissiveSide {
    /// Radiance [cd/m²].
    pub radiance: Rgb,
    /// Total area [m²].
    pub area: f32,
    triangles: Vec<GlowingTriangle>,
    /// Running share of the area, up to and including each triangle.
    cumulative: Vec<f32>,
}

/// A triangle in world space.
#[derive(Clone, Copy, Debug)]
pub struct GlowingTriangle {
    /// Its vertices [m].
    pub vertices: [Vec3; 3],
    /// Unit normal of the side that glows.
    pub normal: Vec3,
}

impl EmissiveSide {
    /// From triangles of non-zero area; `None` if there are none.
    pub fn new(radiance: Rgb, triangles: Vec<GlowingTriangle>) -> Option<EmissiveSide> {
        let mut sum = 0.0_f64;
        let mut cumulative: Vec<f64> = Vec::with_capacity(triangles.len());
        for t in &triangles {
            let [a, b, c] = t.vertices;
            sum += 0.5 * f64::from((b - a).cross(c - a).length());
            cumulative.push(sum);
        }
        (sum > 0.0).then(|| EmissiveSide {
            radiance,
            area: sum as f32,
            cumulative: cumulative.iter().map(|c| (c / sum) as f32).collect(),
            triangles,
        })
    }

    /// The box around all triangles.
    pub fn extent(&self) -> [Vec3; 2] {
        let corners = self.triangles.iter().flat_map(|t| t.vertices);
        corners.fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)])
    }

    /// The point that `u` places, off the surface by its rounding, and the normal there.
    pub fn point(&self, u: [f32; 2]) -> (Vec3, Vec3) {
        let k = self.cumulative.partition_point(|c| *c <= u[0]).min(self.triangles.len() - 1);
        let below = if k == 0 { 0.0 } else { self.cumulative[k - 1] };
        // The same number places the point within its triangle: rescaled, it is uniform again.
        let rest = ((u[0] - below) / (self.cumulative[k] - below)).clamp(0.0, 1.0 - f32::EPSILON);
        let t = &self.triangles[k];
        let [v, w] = sampling::triangle([rest, u[1]]);
        (SurfacePoint::new(&t.vertices, v, w).spawn(t.normal), t.normal)
    }
}
