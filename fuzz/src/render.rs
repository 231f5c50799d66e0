//! Small scenes become pictures of 8 × 8 pixels, whose every value must be finite.

use glam::{Affine2, Affine3A, Vec2, Vec3};
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::material::{Bsdf, Map, Material, Pbr};
use lampyris::scene::{Instance, Mesh, Scene, View, find_view};
use lampyris::texture::{Encoding, Filter, Image, Texture, Wrap};
use lampyris::world::World;
use std::cell::RefCell;

/// Triangles and pixels up to which a scene is rendered.
const TRIANGLES: usize = 2000;
const PIXELS: u64 = 4096;

/// Radii of scenes of which all estimates must be finite [m]: squares of others leave the range of numbers.
const SIZES: (f32, f32) = (1e-3, 1e6);

thread_local! {
    /// One thread, kept: more of them would only make runs differ.
    static CPU: RefCell<Cpu> = RefCell::new(Cpu::new(Some(1)).expect("a thread"));
}

/// Does something on the thread that renders.
pub(crate) fn install<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    CPU.with_borrow(|cpu| cpu.install(work))
}

/// Renders a small scene, by the parts or by the oracle.
pub(crate) fn render(scene: Scene, choice: usize) {
    let triangles = |mesh: u32| scene.meshes.get(mesh as usize).map_or(0, |mesh| mesh.triangles.len());
    let small = |image: &Image| u64::from(image.width) * u64::from(image.height) <= PIXELS;
    if scene.instances.iter().map(|i| triangles(i.mesh)).sum::<usize>() > TRIANGLES
        || !scene.images.iter().all(small)
    {
        return;
    }
    let mut settings = Settings { paths: 4, auxiliary: true, ..Settings::default() };
    if choice % 2 == 1 {
        settings.parts = vec!["path".into()];
    }
    CPU.with_borrow_mut(|cpu| {
        let camera = scene.cameras.first().cloned();
        let world = cpu.install(|| World::new(scene));
        let find = || find_view(world.scene(), &|ray| world.tracer().closest(ray), 1.0).camera;
        let ordinary = (SIZES.0..SIZES.1).contains(&world.bounds().radius);
        let camera = camera.unwrap_or_else(|| cpu.install(find));
        cpu.begin_world(world, Eye::Camera(View::new(&camera, 8, 8)), &settings).expect("settings");
        cpu.add(Batch { index: 0 }).expect("a job");
        assert!(!ordinary || cpu.statistics().non_finite == 0, "an estimate that is no number");
        assert!(cpu.frame().expect("a job").mean().iter().all(|pixel| pixel.is_finite()));
    });
}

/// Renders a square that wears a picture, under a sky of the same.
pub(crate) fn render_in_light_of(image: Image, choice: usize) {
    let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mut material = Material::new("picture", Bsdf::Pbr(Pbr::default()));
    material.maps.color = Some(Map { texture: 0, set: 0, transform: Affine2::IDENTITY });
    let texture =
        Texture { image: 0, encoding: Encoding::Srgb, wrap: [Wrap::Repeat; 2], filter: Filter::Linear };
    let scene = Scene {
        meshes: vec![Mesh {
            positions: corners.map(|c| c.extend(0.0)).to_vec(),
            uvs: [corners.to_vec(), Vec::new()],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            materials: vec![0, 0],
            ..Mesh::default()
        }],
        instances: vec![Instance { name: "square".into(), mesh: 0, transform: Affine3A::IDENTITY }],
        materials: vec![material],
        images: vec![image],
        textures: vec![texture],
        environment: Rgb::WHITE,
        environment_image: Some(0),
        up: Some(Vec3::Z),
        ..Scene::default()
    };
    render(scene, choice);
}
