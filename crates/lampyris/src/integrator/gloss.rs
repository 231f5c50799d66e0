//! Sixteen glossy points at once: Ward's dull lobe over a Lambertian reflector, at the points of a packet, at the light, or
//! at both. The half vector is taken apart into what is along the normal and what lies in the surface, so that no frame is
//! needed; `Surface::eval` is the clear version for one point, and the gather is tested against it.

use crate::color::Rgb;
use crate::eye::{LANES, Packet};
use crate::geometry::{Wide, lane, lanes};
use crate::material::{Glossy, lobe, sharpness};
use crate::particle::Vpl;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// Least cosine of a leaving direction, as in [`crate::world::Surface`].
const GRAZING: f32 = 1e-4;

/// One value of each lane for each colour or axis.
pub(super) type Three = [[f32; LANES]; 3];

/// A direction in parts: what lies in the surface, and the cosine.
fn parts(direction: Vec3, normal: Vec3) -> (Vec3, f32) {
    let cosine = direction.dot(normal);
    (direction - normal * cosine, cosine)
}

/// The glossy points of a packet.
pub(super) struct GlossyPoints {
    /// Which lanes they are.
    pub(super) of: u16,
    /// The direction toward the eye in parts.
    tangent: Three,
    height: [f32; LANES],
    sharpness: [f32; LANES],
}

impl GlossyPoints {
    pub(super) fn new(p: &Packet<'_>) -> GlossyPoints {
        let zero = [0.0; LANES];
        let mut points = GlossyPoints { of: 0, tangent: [zero; 3], height: zero, sharpness: zero };
        for k in lanes(p.glossy) {
            let normal = lane(&p.shading, k);
            if normal.dot(lane(&p.geometric, k)) < 0.0 {
                continue;
            }
            let (tangent, cosine) = parts(p.toward_eye(k), normal);
            (0..3).for_each(|axis| points.tangent[axis][k] = tangent[axis]);
            points.height[k] = cosine.abs().max(GRAZING);
            points.sharpness[k] = sharpness(p.gloss[k].alpha);
            points.of |= 1 << k;
        }
        points
    }
}

/// What a light sends out: alike in all directions, and by a lobe.
pub(super) struct Law {
    /// Intensity [cd], or radiance × area.
    pub(super) even: Rgb,
    lobe: Option<Lobe>,
}

/// The lobe of a glossy virtual light.
struct Lobe {
    normal: Vec3,
    /// The direction toward the particle's origin in parts.
    tangent: Vec3,
    height: f32,
    sharpness: f32,
    /// Flux times specular reflectance.
    value: Rgb,
}

impl Law {
    /// `factor` times the light's law; `None` if its material is of another kind.
    pub(super) fn new(light: &Vpl<'_>, factor: f32) -> Option<Law> {
        let flux = light.intensity * factor;
        let Some(y) = &light.gloss else { return Some(Law { even: flux, lobe: None }) };
        let Glossy { base, specular, alpha } = y.finish.bsdf.glossy()?;
        if y.shading.dot(y.normal) < 0.0 {
            return None;
        }
        let (tangent, height) = parts(y.wo, y.shading);
        let value = flux * specular;
        let lobe = Lobe { normal: y.shading, tangent, height, sharpness: sharpness(alpha), value };
        Some(Law { even: flux * base * FRAC_1_PI, lobe: Some(lobe) })
    }

    pub(super) fn has_lobe(&self) -> bool {
        self.lobe.is_some()
    }
}

/// Adds a light's light to some lanes: plainly, and times each point's lobe.
pub(super) struct Shed<'a, 'w> {
    pub(super) plain: &'a mut Three,
    pub(super) glossy: &'a mut Three,
    pub(super) packet: &'a Packet<'w>,
    pub(super) points: &'a GlossyPoints,
    pub(super) light: Vec3,
    pub(super) law: &'a Law,
    pub(super) g: &'a [f32; LANES],
    pub(super) of: u16,
}

impl Wide for Shed<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        let Shed { plain, glossy, packet: p, points, light, law, g, of } = self;
        // Unit directions toward the light.
        let away = |axis: usize, k: usize| light[axis] - p.position[axis][k];
        let mut reciprocal = [0.0; LANES];
        for (k, reciprocal) in reciprocal.iter_mut().enumerate() {
            let d = [away(0, k), away(1, k), away(2, k)];
            *reciprocal = 1.0 / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        }
        let mut wi = [[0.0; LANES]; 3];
        for (axis, wi) in wi.iter_mut().enumerate() {
            (0..LANES).for_each(|k| wi[k] = away(axis, k) * reciprocal[k]);
        }
        let mut at_light = [0.0; LANES];
        if let Some(lobe) = &law.lobe {
            lobe.toward(&wi, &mut at_light);
        }
        let mut at_point = [0.0; LANES];
        if of & points.of != 0 {
            points.toward(&p.shading, &wi, &mut at_point);
        }
        let value = law.lobe.as_ref().map_or(Rgb::BLACK, |lobe| lobe.value);
        let (even, value) = ([law.even.r, law.even.g, law.even.b], [value.r, value.g, value.b]);
        for channel in 0..3 {
            for k in 0..LANES {
                let counts = of >> k & 1 == 1;
                let shed = (even[channel] + value[channel] * at_light[k]) * g[k];
                plain[channel][k] += if counts { shed } else { 0.0 };
                glossy[channel][k] += if counts { shed * at_point[k] } else { 0.0 };
            }
        }
    }
}

impl GlossyPoints {
    /// The lobe of each point for light from `wi`.
    #[inline(always)]
    fn toward(&self, normal: &Three, wi: &Three, out: &mut [f32; LANES]) {
        for k in 0..LANES {
            let cosine = wi[0][k] * normal[0][k] + wi[1][k] * normal[1][k] + wi[2][k] * normal[2][k];
            let h = [0, 1, 2].map(|a| self.tangent[a][k] + (wi[a][k] - normal[a][k] * cosine));
            let tangential2 = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
            out[k] = lobe(self.sharpness[k], tangential2, self.height[k] + cosine.abs());
        }
    }
}

impl Lobe {
    /// The lobe toward points that see the light at `wi`.
    #[inline(always)]
    fn toward(&self, wi: &Three, out: &mut [f32; LANES]) {
        let (n, t) = (self.normal.to_array(), self.tangent.to_array());
        for k in 0..LANES {
            let cosine = -(wi[0][k] * n[0] + wi[1][k] * n[1] + wi[2][k] * n[2]);
            let h = [0, 1, 2].map(|a| t[a] + (-wi[a][k] - n[a] * cosine));
            let tangential2 = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
            let leaving = if cosine.abs() > GRAZING { cosine.abs() } else { GRAZING };
            out[k] = lobe(self.sharpness, tangential2, self.height + leaving);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Frame, Kernel};
    use crate::material::{Class, Diffuse, Ward};
    use crate::sampling::uniform_sphere;
    use crate::sequence::uniform;

    /// The lobes of sixteen points, and that of a light toward them.
    struct Lobes<'a> {
        points: &'a GlossyPoints,
        normal: &'a Three,
        light: &'a Lobe,
        wi: &'a Three,
    }

    impl Wide for Lobes<'_> {
        type Out = [[f32; LANES]; 2];

        #[inline(always)]
        fn run(self) -> [[f32; LANES]; 2] {
            let mut out = [[0.0; LANES]; 2];
            self.points.toward(self.normal, self.wi, &mut out[0]);
            self.light.toward(self.wi, &mut out[1]);
            out
        }
    }

    fn direction(i: u32, k: usize, purpose: u32) -> Vec3 {
        uniform_sphere([uniform(purpose, i, 2 * k as u32), uniform(purpose, i, 2 * k as u32 + 1)])
    }

    /// On the side of `normal`.
    fn above(normal: Vec3, w: Vec3) -> Vec3 {
        if w.dot(normal) < 0.0 { -w } else { w }
    }

    fn ward(alpha: f32) -> Ward {
        let black = Diffuse { reflectance: Rgb::BLACK, transmittance: Rgb::BLACK };
        let (specular, transmission) = (Rgb::WHITE, Rgb::BLACK);
        Ward { base: black, specular, alpha, transmission, transmission_alpha: 0.0 }
    }

    fn alone(alpha: f32, normal: Vec3, wo: Vec3, wi: Vec3) -> f32 {
        let frame = Frame::new(normal);
        ward(alpha).eval(Class::Dull, frame.to_local(wo), frame.to_local(wi)).r
    }

    #[test]
    fn sixteen_lobes_are_single_lobes_and_kernels_agree() {
        for i in 0..2000 {
            let alpha = 0.15 + 0.8 * uniform(9, i, 0);
            let zero = [0.0; LANES];
            let mut points = GlossyPoints {
                of: 0,
                tangent: [zero; 3],
                height: zero,
                sharpness: [sharpness(alpha); LANES],
            };
            let (mut normal, mut wi, mut wo) = ([zero; 3], [zero; 3], [Vec3::ZERO; LANES]);
            let light_normal = direction(i, 0, 1);
            for k in 0..LANES {
                let toward = -above(light_normal, direction(i, k, 2));
                let n = above(toward, direction(i, k, 3));
                wo[k] = above(n, direction(i, k, 4));
                let (tangent, cosine) = parts(wo[k], n);
                points.height[k] = cosine;
                for axis in 0..3 {
                    (points.tangent[axis][k], normal[axis][k], wi[axis][k]) =
                        (tangent[axis], n[axis], toward[axis]);
                }
            }
            let arrived = above(light_normal, direction(i, 0, 5));
            let (tangent, height) = parts(arrived, light_normal);
            let value = Rgb::WHITE;
            let light = Lobe { normal: light_normal, tangent, height, sharpness: sharpness(alpha), value };
            let lobes = |kernel: Kernel| {
                kernel.run(Lobes { points: &points, normal: &normal, light: &light, wi: &wi })
            };
            let plain = lobes(Kernel::Portable);
            for kernel in [Kernel::Avx2, Kernel::Avx512] {
                assert_eq!(lobes(kernel).map(|l| l.map(f32::to_bits)), plain.map(|l| l.map(f32::to_bits)));
            }
            for k in 0..LANES {
                let toward = lane(&wi, k);
                let at_point = alone(alpha, lane(&normal, k), wo[k], toward);
                let at_light = alone(alpha, light_normal, arrived, -toward);
                for (found, expected, cosine) in [
                    (plain[0][k], at_point, points.height[k]),
                    (plain[1][k], at_light, light_normal.dot(toward).abs()),
                ] {
                    // Below the least cosine the clear version is asked by `Surface` with that one.
                    let near = (found - expected).abs() <= 1e-4 * expected + 1e-5;
                    assert!(near || cosine < GRAZING, "{found} for {expected}");
                }
            }
        }
    }
}
