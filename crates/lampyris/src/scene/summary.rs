//! A scene in figures: how much geometry, how much light. What `lampyris info` prints and what tests of importers assert.
//! Sums run in double precision over the triangles as placed in the world; nothing is traced.

use super::Scene;
use crate::light::State;
use crate::material::Sides;
use glam::Vec3;
use std::collections::HashSet;
use std::f64::consts::PI;

/// A scene's figures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Triangles, each as often as its mesh is placed.
    pub triangles: u64,
    /// Distinct names among the materials.
    pub materials: usize,
    /// Lowest and highest corner of the box around all triangles [m]; `None` without any.
    pub bounds: Option<[Vec3; 2]>,
    /// Area of all triangles, one side counted [m²].
    pub area: f64,
    /// Area of the triangles that emit, one side counted [m²].
    pub emitting_area: f64,
    /// Σ π·L·A over all sides that emit [lm], L the mean luminance; lights that are no surfaces not counted.
    pub power_lm: f64,
    /// Σ π·L·A with each emitting triangle counted once [lm].
    pub power_lm_front: f64,
    /// Lights that are no surfaces, and groups of emitting triangles: one for each pair of instance and material.
    pub lights: usize,
}

impl Scene {
    /// The scene in figures. Triangles that name no vertex or no material of the scene are left out.
    pub fn summary(&self) -> Summary {
        let names: HashSet<&str> = self.materials.iter().map(|m| m.name.as_str()).collect();
        let lights = self.lights.iter().filter(|l| l.state != State::Away).count();
        let mut sum = Summary { materials: names.len(), lights, ..Summary::default() };
        for (number, instance) in (0..).zip(&self.instances) {
            let Some(mesh) = self.meshes.get(instance.mesh as usize) else { continue };
            let mut emitting = HashSet::new();
            for ((k, triangle), &material) in (0..).zip(&mesh.triangles).zip(&mesh.materials) {
                let corner = |k: usize| mesh.positions.get(triangle[k] as usize);
                let (Some(&a), Some(&b), Some(&c)) = (corner(0), corner(1), corner(2)) else { continue };
                let Some(surface) = self.materials.get(material as usize) else { continue };
                let [a, b, c] = [a, b, c].map(|p| instance.transform.transform_point3(p));
                let area = 0.5 * (b.as_dvec3() - a.as_dvec3()).cross(c.as_dvec3() - a.as_dvec3()).length();
                sum.triangles += 1;
                sum.area += area;
                let [low, high] = sum.bounds.unwrap_or([a, a]);
                sum.bounds = Some([low.min(a).min(b).min(c), high.max(a).max(b).max(c)]);
                if !surface.emission.is_black() {
                    let radiance = self.mean_emission(number, k, surface).luminance();
                    let power = PI * f64::from(radiance) * area;
                    sum.emitting_area += area;
                    sum.power_lm_front += power;
                    sum.power_lm += if surface.sides == Sides::Both { 2.0 * power } else { power };
                    emitting.insert(material);
                }
            }
            sum.lights += emitting.len();
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::material::{Bsdf, Diffuse, Material};
    use crate::scene::{Instance, Mesh};
    use glam::Affine3A;

    #[test]
    fn power_counts_sides_and_places() {
        let material = |sides| Material {
            emission: Rgb::grey(100.0),
            sides,
            ..Material::new("lamp", Bsdf::Diffuse(Diffuse::opaque(Rgb::BLACK)))
        };
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            triangles: vec![[0, 1, 2], [0, 1, 2]],
            materials: vec![0, 1],
            ..Mesh::default()
        };
        let place = |scale| Instance {
            name: String::new(),
            mesh: 0,
            transform: Affine3A::from_scale(Vec3::splat(scale)),
        };
        let scene = Scene {
            meshes: vec![mesh],
            instances: vec![place(1.0), place(2.0)],
            materials: vec![material(Sides::Both), material(Sides::EmitFront)],
            ..Scene::default()
        };
        let s = scene.summary();
        assert_eq!((s.triangles, s.materials, s.lights), (4, 1, 4));
        assert_eq!(s.bounds, Some([Vec3::ZERO, Vec3::new(2.0, 2.0, 0.0)]));
        // Areas ½ and 2, both twice.
        assert!((s.emitting_area - 5.0).abs() < 1e-6 && (s.area - 5.0).abs() < 1e-6);
        assert!((s.power_lm_front - PI * 500.0).abs() < 1e-3);
        assert!((s.power_lm - PI * 750.0).abs() < 1e-3);
    }
}
