//! One side of an emissive surface: any number of triangles, sampled by area, or, where a texture says how they glow,
//! by area × mean luminance; within a triangle uniformly.

use crate::color::Rgb;
use crate::geometry::SurfacePoint;
use crate::sampling;
use glam::Vec3;
use std::f32::consts::PI;
use std::sync::Arc;

/// Radiance of a point of a triangle, by the triangle's number in its mesh and the weights of its second and third
/// corner [cd/m²].
type Glow = dyn Fn(u32, f32, f32) -> Rgb + Send + Sync;

/// Weight of a triangle whose mean seems black, in units of the mean of all: none may be left out for good, since means
/// are taken over a few points.
const LEAST: f32 = 0.05;

/// The triangles of one instance and material that glow, on one of their sides.
#[derive(Clone, Debug)]
pub struct EmissiveSide {
    /// Radiance, the mean over the area [cd/m²].
    pub radiance: Rgb,
    /// Total area [m²].
    pub area: f32,
    triangles: Vec<GlowingTriangle>,
    /// Running share of the choices, up to and including each triangle.
    cumulative: Vec<f32>,
    paint: Option<Paint>,
}

/// A triangle in world space.
#[derive(Clone, Copy, Debug)]
pub struct GlowingTriangle {
    /// Its vertices [m].
    pub vertices: [Vec3; 3],
    /// Unit normal of the side that glows.
    pub normal: Vec3,
}

/// What a texture changes.
#[derive(Clone)]
struct Paint {
    glow: Arc<Glow>,
    /// Numbers of the triangles in their mesh, ascending.
    numbers: Vec<u32>,
    /// Area of each triangle over its share of the choices [m²].
    areas: Vec<f32>,
    /// Luminous flux that choosing counts with [lm].
    importance: f32,
}

impl std::fmt::Debug for Paint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Paint").field("numbers", &self.numbers).field("areas", &self.areas).finish()
    }
}

/// A point of a side that glows.
#[derive(Clone, Copy, Debug)]
pub(super) struct SidePoint {
    /// Off the surface by its rounding [m].
    pub(super) position: Vec3,
    pub(super) normal: Vec3,
    /// Radiance there [cd/m²].
    pub(super) radiance: Rgb,
    /// One over the density of the choice [m²].
    pub(super) area: f32,
}

impl EmissiveSide {
    /// From triangles of non-zero area; `None` if there are none.
    pub fn new(radiance: Rgb, triangles: Vec<GlowingTriangle>) -> Option<EmissiveSide> {
        let areas: Vec<f64> = triangles.iter().map(GlowingTriangle::area).collect();
        let (cumulative, sum) = shares(&areas);
        (sum > 0.0).then(|| EmissiveSide { radiance, area: sum as f32, cumulative, triangles, paint: None })
    }

    /// From triangles that glow differently from place to place: with their numbers in their mesh (ascending), their mean
    /// radiances, to a few per cent, the luminance that a texture multiplies, and what each point sends out.
    pub fn painted(
        triangles: Vec<GlowingTriangle>,
        numbers: Vec<u32>,
        means: &[Rgb],
        factor: f32,
        glow: impl Fn(u32, f32, f32) -> Rgb + Send + Sync + 'static,
    ) -> Option<EmissiveSide> {
        let areas: Vec<f64> = triangles.iter().map(GlowingTriangle::area).collect();
        let (_, area) = shares(&areas);
        let sum = |of: &dyn Fn(Rgb) -> f32| -> f64 {
            areas.iter().zip(means).map(|(a, m)| a * f64::from(of(*m))).sum()
        };
        let [r, g, b] = [sum(&|m| m.r), sum(&|m| m.g), sum(&|m| m.b)].map(|s| (s / area) as f32);
        let radiance = Rgb::new(r, g, b);
        let least = LEAST * radiance.luminance() + 1e-3 * factor;
        let weigh = |(a, m): (&f64, &Rgb)| a * f64::from(m.luminance().max(0.0) + least);
        let weights: Vec<f64> = areas.iter().zip(means).map(weigh).collect();
        let (cumulative, total) = shares(&weights);
        let share = |k: usize| cumulative[k] - if k == 0 { 0.0 } else { cumulative[k - 1] };
        let paint = Paint {
            glow: Arc::new(glow),
            numbers,
            areas: areas.iter().enumerate().map(|(k, a)| *a as f32 / share(k)).collect(),
            importance: total as f32 * PI,
        };
        (total > 0.0).then(|| EmissiveSide {
            radiance,
            area: area as f32,
            cumulative,
            triangles,
            paint: Some(paint),
        })
    }

    /// The same side, what each point sends out asked elsewhere, if it is painted; of the same answers.
    pub fn ask(&mut self, glow: impl Fn(u32, f32, f32) -> Rgb + Send + Sync + 'static) {
        if let Some(paint) = &mut self.paint {
            paint.glow = Arc::new(glow);
        }
    }

    /// True if a texture says how it glows.
    pub fn is_painted(&self) -> bool {
        self.paint.is_some()
    }

    /// Luminous flux that its share of the paths should follow [lm]; more than nothing where there may be light.
    pub(super) fn importance(&self) -> f32 {
        let power = || (self.radiance * (PI * self.area)).luminance().max(0.0);
        self.paint.as_ref().map_or_else(power, |p| p.importance)
    }

    /// The box around all triangles.
    pub fn extent(&self) -> [Vec3; 2] {
        let corners = self.triangles.iter().flat_map(|t| t.vertices);
        corners.fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)])
    }

    /// The point that `u` places.
    pub(super) fn point(&self, u: [f32; 2]) -> SidePoint {
        let k = self.cumulative.partition_point(|c| *c <= u[0]).min(self.triangles.len() - 1);
        let below = if k == 0 { 0.0 } else { self.cumulative[k - 1] };
        // The same number places the point within its triangle: rescaled, it is uniform again.
        let rest = ((u[0] - below) / (self.cumulative[k] - below)).clamp(0.0, 1.0 - f32::EPSILON);
        let t = &self.triangles[k];
        let [v, w] = sampling::triangle([rest, u[1]]);
        let position = SurfacePoint::new(&t.vertices, v, w).spawn(t.normal);
        let (radiance, area) = match &self.paint {
            Some(paint) => ((paint.glow)(paint.numbers[k], v, w), paint.areas[k]),
            None => (self.radiance, self.area),
        };
        SidePoint { position, normal: t.normal, radiance, area }
    }

    /// One over the density with which `point` chooses a point of a triangle of the mesh [m²].
    pub fn area_around(&self, triangle: u32) -> f32 {
        match &self.paint {
            Some(paint) => paint.numbers.binary_search(&triangle).map_or(f32::INFINITY, |k| paint.areas[k]),
            None => self.area,
        }
    }
}

impl GlowingTriangle {
    fn area(&self) -> f64 {
        let [a, b, c] = self.vertices;
        0.5 * f64::from((b - a).cross(c - a).length())
    }
}

/// Running shares of weights, and their sum.
fn shares(weights: &[f64]) -> (Vec<f32>, f64) {
    let mut sum = 0.0_f64;
    let running: Vec<f64> = weights
        .iter()
        .map(|w| {
            sum += w;
            sum
        })
        .collect();
    (running.iter().map(|c| (c / sum) as f32).collect(), sum)
}
