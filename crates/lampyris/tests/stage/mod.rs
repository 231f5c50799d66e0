//! A small stage with one of everything that edits can touch, and random edits of it.
#![allow(dead_code, unreachable_pub, reason = "each test takes what it needs")]

#[path = "../support/mod.rs"]
pub mod support;

use glam::{Affine2, Affine3A, EulerRot, Quat, Vec2, Vec3};
use lampyris::Rgb;
use lampyris::light::{Beam, Light, LightKind, State};
use lampyris::material::{Bsdf, Coverage, Diffuse, Map, Maps, Material, Pbr, Sides, Ward};
use lampyris::scene::{Camera, Edit, Instance, Scene};
use lampyris::sequence::{hash, unit_f32};
use lampyris::texture::{Encoding, Filter, Image, Pixels, Texture, Wrap};
use support::{Build, diffuse, glass, gloss};

/// Numbers by chance, the same for the same seed.
pub struct Chance {
    seed: u32,
    count: u32,
}

impl Chance {
    pub fn new(seed: u32) -> Chance {
        Chance { seed, count: 0 }
    }

    fn bits(&mut self) -> u32 {
        self.count += 1;
        hash(self.seed, self.count)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f32 {
        unit_f32(self.bits())
    }

    /// Less than `n`.
    pub fn below(&mut self, n: usize) -> usize {
        self.bits() as usize % n
    }

    pub fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    pub fn point(&mut self) -> Vec3 {
        Vec3::new(self.within(-0.1, 2.1), self.within(-0.1, 2.1), self.within(-0.1, 2.1))
    }

    pub fn direction(&mut self) -> Vec3 {
        lampyris::sampling::uniform_sphere([self.unit(), self.unit()])
    }

    fn color(&mut self, most: f32) -> Rgb {
        Rgb::new(self.unit(), self.unit(), self.unit()) * most
    }
}

fn map() -> Option<Map> {
    Some(Map { texture: 0, set: 0, transform: Affine2::IDENTITY })
}

/// A room with a missing wall, a block, three balls of one mesh, a panel glowing on both sides, one that glows by a
/// picture, a leaf that is there in part, a mirror; lamps of all kinds, and a sky.
pub fn stage() -> Scene {
    let mut b = Build(Scene { environment: Rgb::new(0.2, 0.3, 0.5), ..Default::default() });
    let wall = b.grey(0.6);
    let floor = b.material(gloss(0.3, 0.3, 0.1), 0.0, Sides::Both);
    let clear = b.material(glass(), 0.0, Sides::Both);
    let panel = b.material(diffuse(0.2), 10.0, Sides::Both);
    let shown = b.material(diffuse(0.3), 5.0, Sides::EmitFront);
    let leaf = b.material(diffuse(0.5), 0.0, Sides::FrontOnly);
    let mirror = b.material(gloss(0.0, 0.9, 0.0), 0.0, Sides::Both);
    b.0.materials[shown as usize].maps = Maps { emission: map(), ..Maps::default() };
    b.0.materials[leaf as usize].coverage = Coverage::Blend { factor: 0.9 };
    b.0.materials[leaf as usize].maps = Maps { alpha: map(), ..Maps::default() };
    let pixels = (0..16u8).map(|k| [k * 16, 255 - k * 9, 40 + k * 3, 255 - 12 * k]).collect();
    b.0.images.push(Image { name: String::new(), width: 4, height: 4, pixels: Pixels::Byte(pixels) });
    b.0.textures.push(Texture {
        image: 0,
        encoding: Encoding::Srgb,
        wrap: [Wrap::Repeat; 2],
        filter: Filter::Linear,
    });
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, mirror, floor, wall, wall, wall]);
    b.0.instances.pop();
    b.block(Vec3::splat(0.2), Vec3::new(0.6, 0.9, 0.5), wall);
    b.sphere(Vec3::ZERO, 0.25, 1, false, |_| clear).normals = Vec::new();
    let ball = b.0.meshes.len() as u32 - 1;
    let normals = b.0.meshes[ball as usize].positions.iter().map(|p| p.normalize()).collect();
    b.0.meshes[ball as usize].normals = normals;
    b.0.instances.pop();
    for x in [0.5, 1.0, 1.5] {
        let transform = Affine3A::from_translation(Vec3::new(x, 0.4, 1.4));
        b.0.instances.push(Instance { name: String::new(), mesh: ball, transform });
    }
    for (height, material) in [(1.95, panel), (1.2, shown), (0.7, leaf)] {
        b.quad(Vec3::new(0.7, height, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, material);
        let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        b.0.meshes.last_mut().expect("a quad").uvs[0] = corners.to_vec();
    }
    b.bulb(Vec3::new(0.3, 1.7, 0.4), 20.0);
    b.bulb(Vec3::new(1.3, 1.7, 0.4), 0.0);
    let position = Vec3::new(1.5, 1.5, 1.5);
    let beam = Beam::Cosine { exponent: 5.0 };
    b.light(LightKind::Spot { position, direction: Vec3::NEG_Y, intensity: Rgb::grey(3.0), beam });
    b.light(LightKind::Sphere { center: Vec3::new(0.4, 1.5, 1.6), radius: 0.05, radiance: Rgb::grey(80.0) });
    b.light(LightKind::Directional { direction: Vec3::NEG_Z, illuminance: Rgb::grey(2.0) });
    let (eye, target) = (Vec3::new(1.8, 1.2, 1.8), Vec3::new(0.3, 0.4, 0.3));
    b.0.view = Some(Camera { name: String::new(), eye, target, up: Vec3::Y, fov_y: 70.0 });
    b.0
}

fn lamp(c: &mut Chance) -> LightKind {
    let (at, along) = (c.point(), c.direction());
    // One in four is dark.
    let bright = if c.below(4) == 0 { Rgb::BLACK } else { c.color(20.0) };
    match c.below(6) {
        0 | 1 => LightKind::Point { position: at, intensity: bright },
        2 => {
            let beam = Beam::Cone { cos_inner: 0.9, cos_outer: c.within(0.1, 0.8) };
            LightKind::Spot { position: at, direction: along, intensity: bright, beam }
        }
        3 => LightKind::Directional { direction: along, illuminance: bright },
        4 => LightKind::Sphere { center: at, radius: c.within(0.01, 0.1), radiance: bright },
        _ => LightKind::Disc { center: at, normal: along, radius: c.within(0.01, 0.2), radiance: bright },
    }
}

fn transform(c: &mut Chance) -> Affine3A {
    let turn = Quat::from_euler(EulerRot::XYZ, c.within(-3.0, 3.0), c.within(-3.0, 3.0), c.within(-3.0, 3.0));
    let scale = match c.below(4) {
        0 => Vec3::ONE,
        1 => Vec3::new(-1.0, 1.0, 1.0),
        _ => Vec3::new(c.within(0.3, 1.2), c.within(0.3, 1.2), c.within(0.3, 1.2)),
    };
    let turn = if c.below(3) == 0 { Quat::IDENTITY } else { turn };
    Affine3A::from_scale_rotation_translation(scale, turn, c.point() - 0.5)
}

fn material(c: &mut Chance, old: &Material) -> Material {
    let bsdf = match c.below(6) {
        0 => glass(),
        1 => gloss(0.1, 0.8, if c.below(2) == 0 { 0.0 } else { 0.2 }),
        2 => Bsdf::Ward(Ward {
            base: Diffuse::opaque(c.color(0.4)),
            specular: c.color(0.2),
            alpha: 0.1,
            transmission: c.color(0.3),
            transmission_alpha: 0.0,
        }),
        3 => Bsdf::Pbr(Pbr { base_color: c.color(1.0), metallic: c.unit(), ..Pbr::default() }),
        _ => Bsdf::Diffuse(Diffuse { reflectance: c.color(0.7), transmittance: c.color(0.3) }),
    };
    let emission = if c.below(3) == 0 { c.color(8.0) } else { Rgb::BLACK };
    let sides = [Sides::Both, Sides::Both, Sides::EmitFront, Sides::FrontOnly][c.below(4)];
    let coverage = match c.below(8) {
        0 => Coverage::Blend { factor: c.unit() },
        1 => Coverage::Mask { factor: c.unit(), cutoff: 0.5 },
        _ => Coverage::Full,
    };
    let mapped = |c: &mut Chance| if c.below(5) == 0 { map() } else { None };
    let maps = Maps { color: mapped(c), emission: mapped(c), alpha: mapped(c), ..Maps::default() };
    Material { name: old.name.clone(), bsdf, emission, sides, coverage, maps }
}

/// Something that somebody may do to a scene.
pub fn some_edit(scene: &Scene, c: &mut Chance) -> Edit {
    let light = c.below(scene.lights.len()) as u32;
    let instance = c.below(scene.instances.len()) as u32;
    let number = c.below(scene.materials.len());
    let mesh = c.below(scene.meshes.len()) as u32;
    match c.below(100) {
        0..15 => Edit::Light { light, kind: lamp(c) },
        15..25 => {
            // Dimmed or coloured, and nothing else.
            let kind = scene.lights[light as usize].kind.clone();
            Edit::Light { light, kind: kind.with_brightness(c.color(30.0)) }
        }
        25..35 => Edit::Switch { light, state: [State::On, State::Off, State::Away][c.below(3)] },
        35..37 if scene.lights.len() < 12 => Edit::AddLight { light: Light::new("new", lamp(c)) },
        37..60 => Edit::Move { instance, transform: transform(c) },
        60..64 => Edit::Mesh { instance, mesh: None },
        64..72 => Edit::Mesh { instance, mesh: Some(mesh) },
        72..74 if scene.instances.len() < 24 => {
            let instance = Instance { name: "new".into(), mesh, transform: transform(c) };
            Edit::AddInstance { instance }
        }
        74..84 => {
            let emission = if c.below(3) == 0 { Rgb::BLACK } else { c.color(10.0) };
            Edit::Emission { material: number as u32, emission }
        }
        84..94 => {
            Edit::Material { material: number as u32, to: Box::new(material(c, &scene.materials[number])) }
        }
        _ => {
            let camera = scene.view.clone().map(|camera| Camera { eye: c.point(), ..camera });
            Edit::View { camera }
        }
    }
}
