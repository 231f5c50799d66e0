//! Illuminance of what is seen, by meters and from the picture, against the closed form; and grids in a rendered scene.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::frame::Frame;
use lampyris::light::LightKind;
use lampyris::material::Sides;
use lampyris::measuring::{BORDER, Estimate, Rectangle, illuminance, readable, receivers};
use lampyris::scene::{Camera, Scene, View};
use lampyris::world::World;
use std::f32::consts::PI;
use support::{Build, diffuse, glass, gloss};

const LAMP: Vec3 = Vec3::new(0.3, -0.2, 2.0);
const CANDELA: f32 = 100.0;

/// A lamp over a coloured floor, seen from above; beside it a mirror.
fn floor() -> Scene {
    let mut b = Build(Scene::default());
    let paint =
        lampyris::material::Bsdf::Diffuse(lampyris::material::Diffuse::opaque(Rgb::new(0.7, 0.4, 0.1)));
    let paint = b.material(paint, 0.0, Sides::Both);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    let polish = b.material(gloss(0.3, 0.1, 0.05), 0.0, Sides::Both);
    let pane = b.material(glass(), 0.0, Sides::Both);
    let lit = b.material(diffuse(0.5), 0.0, Sides::Both);
    b.quad(Vec3::new(-2.0, -2.0, 0.0), Vec3::X * 4.0, Vec3::Y * 4.0, paint);
    for (k, material) in [mirror, polish, pane, lit].into_iter().enumerate() {
        b.quad(Vec3::new(5.0 + k as f32, 0.0, 0.0), Vec3::X, Vec3::Y, material);
    }
    b.light(LightKind::Point { position: LAMP, intensity: Rgb::new(0.5, 1.0, 1.5) * CANDELA });
    b.0
}

fn frame(scene: Scene, eye: Eye) -> Frame {
    let settings = Settings {
        parts: vec!["direct".into()],
        auxiliary: true,
        ..support::settings(&["direct"], 16, 1, 1)
    };
    let mut cpu = Cpu::new(Some(2)).expect("threads");
    cpu.begin(scene, eye, &settings).expect("sound");
    (0..4).for_each(|index| cpu.add(Batch { index }).expect("a batch"));
    cpu.frame().expect("begun").clone()
}

/// I cos θ/d² of the lamp's luminance.
fn expected(at: Vec3) -> f32 {
    let to = LAMP - at;
    let candela = Rgb::new(0.5, 1.0, 1.5).luminance() * CANDELA;
    candela * to.z / (to.length() * to.length_squared())
}

#[test]
fn what_is_seen_tells_what_is_received() {
    let scene = floor();
    let camera = Camera {
        name: String::new(),
        eye: Vec3::new(0.0, 0.0, 3.0),
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_y: 10.0,
    };
    let view = View::new(&camera, 24, 18);
    let world = World::new(scene.clone());
    let meters: Vec<Meter> = receivers(&world, &view).into_iter().map(|m| m.expect("a floor")).collect();
    let read = frame(scene.clone(), Eye::Meters(meters.clone())).mean();
    let seen = frame(scene, Eye::Camera(view));
    let auxiliary = seen.auxiliary().expect("asked for");
    let scale = 1.0 / auxiliary.samples as f32;
    for (k, meter) in meters.iter().enumerate() {
        assert!(meter.normal == Vec3::Z && meter.position.z >= 0.0 && meter.position.z < 1e-4);
        let truth = expected(meter.position);
        let by_meter = read[k].luminance() * PI;
        assert!((by_meter / truth - 1.0).abs() < 1e-4, "pixel {k}: {by_meter} {truth}");
        // Over a pixel of 3 cm the light changes by a little.
        let divided = illuminance(seen.mean()[k], auxiliary.albedo[k] * scale).expect("a colour");
        assert!((divided / truth - 1.0).abs() < 0.01, "pixel {k}: {divided} {truth}");
    }
}

#[test]
fn what_has_no_answer_has_none() {
    let mut scene = floor();
    assert_eq!(readable(&scene), [true, false, false, false, true]);
    scene.materials[4].emission = Rgb::WHITE;
    // As much gloss as glazed paint has is little beside the rest.
    scene.materials[2].bsdf = gloss(0.3, 0.05, 0.05);
    assert_eq!(readable(&scene), [true, false, true, false, false]);
    let world = World::new(scene);
    let look = |x: f32| {
        let eye = Vec3::new(x, 0.5, 3.0);
        let camera = Camera { name: String::new(), eye, target: eye - Vec3::Z, up: Vec3::Y, fov_y: 1.0 };
        receivers(&world, &View::new(&camera, 1, 1))[0]
    };
    let met = [0.5, 5.5, 6.5, 7.5, 8.5, 20.0].map(|x| look(x).is_some());
    assert_eq!(met, [true, false, true, false, true, false]);
    // A section sees what lies behind the plane: from beneath the floor, nothing.
    let eye = Vec3::new(0.5, 0.5, -3.0);
    let camera = Camera { name: String::new(), eye, target: eye + Vec3::Z, up: Vec3::Y, fov_y: 1.0 };
    let sections = [2.9, 3.1].map(|near| receivers(&world, &View::new(&camera, 1, 1).cut(near))[0]);
    assert_eq!(sections.map(|meter| meter.map(|m| m.normal)), [Some(Vec3::NEG_Z), None]);
    assert_eq!(illuminance(Rgb::WHITE, Rgb::new(0.5, 0.5, 0.001)), None);
    assert_eq!(illuminance(Rgb::WHITE, Rgb::BLACK), None);
    let lux = illuminance(Rgb::new(0.2, 0.4, 0.1), Rgb::new(0.2, 0.4, 0.1)).expect("a colour");
    assert!((lux - PI).abs() < 1e-5);
}

/// A grid under a lamp: its figures are those of the closed form at its points.
#[test]
fn a_grid_reads_the_closed_form() {
    let edges = [Vec3::X * 4.0, Vec3::Y * 4.0];
    let corner = Vec3::new(-2.0, -2.0, 0.01);
    let surface = Rectangle { corner, edges, normal: Vec3::Z, border: BORDER, maintenance: 0.8 };
    let grid = surface.grid().expect("a surface");
    assert_eq!([grid.columns, grid.rows], [7, 7]);
    let read = frame(floor(), Eye::Meters(grid.meters.clone())).mean();
    let readings: Vec<Estimate> =
        read.iter().map(|v| Estimate { value: f64::from(v.luminance() * PI), error: Some(0.0) }).collect();
    let found = grid.statistics(&readings).expect("a reading each");
    let truth: Vec<f64> = grid.meters.iter().map(|m| 0.8 * f64::from(expected(m.position))).collect();
    let mean = truth.iter().sum::<f64>() / truth.len() as f64;
    let least = truth.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((found.mean.value / mean - 1.0).abs() < 1e-4 && (found.least.value / least - 1.0).abs() < 1e-4);
    assert!((found.uniformity.value / (least / mean) - 1.0).abs() < 1e-4);
}
