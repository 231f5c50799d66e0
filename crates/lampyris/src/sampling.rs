//! Maps from the unit square to what is sampled: hemisphere, sphere, cone, disc, triangle.
//! Each is area-preserving and continuous where it can be, so that low discrepancy survives it.

use glam::Vec3;
use std::f32::consts::{FRAC_PI_4, TAU};

/// Cosine-distributed on the upper hemisphere, density cos θ/π [sr⁻¹]: Malley's lift of the concentric disc map.
pub fn cosine_hemisphere(u: [f32; 2]) -> Vec3 {
    let [x, y] = concentric_disc(u);
    Vec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt())
}

/// cosᵈ-distributed about +z, density [`cosine_power_pdf`] [sr⁻¹]: the beam of a spot light [Keller97, §4.2]. Exponent
/// d ≥ 0; d = 1 is [`cosine_hemisphere`]. `Frame::to_world` turns it about another axis.
pub fn cosine_power(u: [f32; 2], exponent: f32) -> Vec3 {
    let [x, y] = concentric_disc(u);
    // r² is uniform on [0, 1], and cos θ = (1 − r²)^(1/(d + 1)) inverts the distribution of the cosine.
    let r2 = (x * x + y * y).min(1.0);
    // Computed as 1 − cos θ, for the cosine of a narrow beam has no digits left.
    let gap = -libm::expm1f(libm::log1pf(-r2) / (exponent + 1.0));
    let stretch = if r2 > 0.0 { (gap * (2.0 - gap) / r2).sqrt() } else { 0.0 };
    Vec3::new(x * stretch, y * stretch, 1.0 - gap)
}

/// (d + 1)/2π · cosᵈ θ [sr⁻¹], none behind.
pub fn cosine_power_pdf(cos: f32, exponent: f32) -> f32 {
    if cos > 0.0 { (exponent + 1.0) / TAU * libm::powf(cos, exponent) } else { 0.0 }
}

/// Uniform on the unit sphere, density 1/4π [sr⁻¹].
pub fn uniform_sphere(u: [f32; 2]) -> Vec3 {
    uniform_cone(u, -1.0)
}

/// Uniform on the cap cos θ ≥ `cos_max` about +z, density 1/(2π(1 − cos_max)) [sr⁻¹].
pub fn uniform_cone(u: [f32; 2], cos_max: f32) -> Vec3 {
    uniform_cap(u, 1.0 - cos_max)
}

/// [`uniform_cone`] by the cap's height 1 − `cos_max`, of which a narrow cone's cosine has no digits left.
pub fn uniform_cap(u: [f32; 2], height: f32) -> Vec3 {
    let gap = u[0] * height;
    let r = (gap * (2.0 - gap)).max(0.0).sqrt();
    let (sin, cos) = libm::sincosf(TAU * u[1]);
    Vec3::new(r * cos, r * sin, 1.0 - gap)
}

/// Uniform on the unit disc by the concentric map [Shirley and Chiu 1997].
pub fn concentric_disc(u: [f32; 2]) -> [f32; 2] {
    let (a, b) = (2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0);
    if a == 0.0 && b == 0.0 {
        return [0.0, 0.0];
    }
    let (r, phi) =
        if a.abs() > b.abs() { (a, FRAC_PI_4 * (b / a)) } else { (b, 2.0 * FRAC_PI_4 - FRAC_PI_4 * (a / b)) };
    let (sin, cos) = libm::sincosf(phi);
    [r * cos, r * sin]
}

/// Uniform on a triangle: barycentric weights of its second and third vertex.
pub fn triangle(u: [f32; 2]) -> [f32; 2] {
    let r = u[0].sqrt();
    [1.0 - r, u[1] * r]
}
