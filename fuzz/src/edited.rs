//! A small scene to be edited: things of one name, of two, of none.

use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::light::{Light, LightKind};
use lampyris::material::{Bsdf, Diffuse, Material};
use lampyris::scene::{Camera, Instance, Mesh, Scene};

/// Three squares, one of which glows, and two lamps.
pub(crate) fn scene() -> Scene {
    let square = |material: u32| Mesh {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::ONE - Vec3::Z, Vec3::Y],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![material; 2],
        ..Mesh::default()
    };
    let object = |name: &str, mesh: u32, height: f32| Instance {
        name: name.into(),
        mesh,
        transform: Affine3A::from_translation(Vec3::Z * height),
    };
    let grey = |name: &str| Material::new(name, Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.5))));
    let lamp = |name: &str, x: f32| {
        let position = Vec3::new(x, 0.5, 0.5);
        Light::new(name, LightKind::Point { position, intensity: Rgb::new(3.0, 2.0, 1.0) })
    };
    let (eye, target) = (Vec3::new(-1.0, -1.0, 1.0), Vec3::new(0.5, 0.5, 0.5));
    Scene {
        meshes: vec![square(0), square(1)],
        instances: vec![object("a", 0, 0.0), object("a", 1, 1.0), object("", 0, 0.3)],
        materials: vec![grey("m"), Material { emission: Rgb::new(9.0, 8.0, 5.0), ..grey("m") }],
        lights: vec![lamp("l", 0.2), lamp("l#2", 0.8)],
        cameras: vec![Camera { name: String::new(), eye, target, up: Vec3::Z, fov_y: 60.0 }],
        ..Scene::default()
    }
}
