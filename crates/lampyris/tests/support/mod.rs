//! Scenes built in code whose light is known, and the shortest ways to measure it.
//! One builder, a handful of shapes, meters; no scene file is read here.
#![allow(dead_code, unreachable_pub, reason = "each test takes what it needs")]

use glam::{Affine3A, Vec3};
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::light::{Light, LightKind};
use lampyris::material::{Bsdf, Dielectric, Diffuse, Material, Sides, Ward};
use lampyris::scene::{Camera, Instance, Mesh, Scene, View};
use lampyris::sequence::sobol::sobol_owen_pair;
use lampyris::testing::{Moments, sidak};
use std::f32::consts::{PI, TAU};

/// The fast parts, by the names of `Settings::default`, and the oracle.
pub const FAST: &[&str] = lampyris::integrator::WHOLE;
/// The fast parts without the one that has a bias at finite radius: caustics by the oracle in place of photons. So each
/// point can be compared; the light of the photons has tests of its own.
pub const UNBIASED: &[&str] =
    &["emission", "direct", "vpl", "compensation", "mirror", lampyris::integrator::CAUSTIC_ORACLE];
pub const ORACLE: &[&str] = &["path"];

/// A scene in the making.
#[derive(Clone, Default)]
pub struct Build(pub Scene);

pub fn diffuse(rho: f32) -> Bsdf {
    Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(rho)))
}

/// Grey gloss over a grey base.
pub fn gloss(base: f32, specular: f32, alpha: f32) -> Bsdf {
    Bsdf::Ward(Ward {
        base: Diffuse::opaque(Rgb::grey(base)),
        specular: Rgb::grey(specular),
        alpha,
        transmission: Rgb::BLACK,
        transmission_alpha: 0.0,
    })
}

pub fn glass() -> Bsdf {
    Bsdf::Dielectric(Dielectric::new(1.5, Rgb::WHITE))
}

impl Build {
    /// A material; emission in cd/m².
    pub fn material(&mut self, bsdf: Bsdf, emission: f32, sides: Sides) -> u32 {
        let name = self.0.materials.len().to_string();
        self.0.materials.push(Material { emission: Rgb::grey(emission), sides, ..Material::new(name, bsdf) });
        self.0.materials.len() as u32 - 1
    }

    /// A Lambertian that emits nothing.
    pub fn grey(&mut self, rho: f32) -> u32 {
        self.material(diffuse(rho), 0.0, Sides::Both)
    }

    /// A black surface that glows on its front alone.
    pub fn glow(&mut self, radiance: f32) -> u32 {
        self.material(diffuse(0.0), radiance, Sides::EmitFront)
    }

    /// Triangles of one material each.
    pub fn mesh(&mut self, positions: Vec<Vec3>, triangles: Vec<[u32; 3]>, materials: Vec<u32>) -> &mut Mesh {
        let mesh = self.0.meshes.len() as u32;
        let name = mesh.to_string();
        self.0.instances.push(Instance { name, mesh, transform: Affine3A::IDENTITY });
        self.0.meshes.push(Mesh { positions, triangles, materials, ..Mesh::default() });
        self.0.meshes.last_mut().expect("just pushed")
    }

    /// A parallelogram at `corner`; its front faces `a` × `b`.
    pub fn quad(&mut self, corner: Vec3, a: Vec3, b: Vec3, material: u32) {
        let positions = vec![corner, corner + a, corner + a + b, corner + b];
        self.mesh(positions, vec![[0, 1, 2], [0, 2, 3]], vec![material; 2]);
    }

    /// A box whose faces look inward; materials of −x, +x, −y, +y, −z, +z.
    pub fn room(&mut self, lo: Vec3, hi: Vec3, m: [u32; 6]) {
        let d = hi - lo;
        let (x, y, z) = (Vec3::X * d.x, Vec3::Y * d.y, Vec3::Z * d.z);
        self.quad(lo, y, z, m[0]);
        self.quad(lo + x, z, y, m[1]);
        self.quad(lo, z, x, m[2]);
        self.quad(lo + y, x, z, m[3]);
        self.quad(lo, x, y, m[4]);
        self.quad(lo + z, y, x, m[5]);
    }

    /// A box whose faces look outward.
    pub fn block(&mut self, lo: Vec3, hi: Vec3, material: u32) {
        let d = hi - lo;
        let (x, y, z) = (Vec3::X * d.x, Vec3::Y * d.y, Vec3::Z * d.z);
        self.quad(lo, z, y, material);
        self.quad(lo + x, y, z, material);
        self.quad(lo, x, z, material);
        self.quad(lo + y, z, x, material);
        self.quad(lo, y, x, material);
        self.quad(lo + z, x, y, material);
    }

    /// A geodesic sphere of 20·4^`levels` triangles that has a true sphere's area, each triangle with the material
    /// that its centre's direction is given; fronts outward, or inward where `inside`.
    pub fn sphere(
        &mut self,
        center: Vec3,
        radius: f32,
        levels: u32,
        inside: bool,
        material: impl Fn(Vec3) -> u32,
    ) -> &mut Mesh {
        let (points, mut triangles) = geodesic(levels);
        let area: f32 = triangles.iter().map(|t| area(t.map(|v| points[v as usize]))).sum();
        let stretch = radius * (4.0 * PI / area).sqrt();
        let materials = triangles
            .iter()
            .map(|t| material(t.map(|v| points[v as usize]).into_iter().sum::<Vec3>().normalize()))
            .collect();
        if inside {
            triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        let positions = points.iter().map(|p| center + *p * stretch).collect();
        self.mesh(positions, triangles, materials)
    }

    /// A disc of 256 triangles that has a true disc's area, facing `normal`.
    pub fn disc(&mut self, center: Vec3, normal: Vec3, radius: f32, material: u32) {
        const STEPS: u32 = 256;
        let step = TAU / STEPS as f32;
        let radius = radius * (PI / (0.5 * STEPS as f32 * libm::sinf(step))).sqrt();
        let frame = lampyris::geometry::Frame::new(normal);
        let rim = (0..STEPS).map(|k| {
            let (sin, cos) = libm::sincosf(step * k as f32);
            center + (frame.s * cos + frame.t * sin) * radius
        });
        let positions = std::iter::once(center).chain(rim).collect();
        let triangles = (0..STEPS).map(|k| [0, 1 + k, 1 + (k + 1) % STEPS]).collect();
        self.mesh(positions, triangles, vec![material; STEPS as usize]);
    }

    pub fn light(&mut self, kind: LightKind) {
        self.0.lights.push(Light::new(self.0.lights.len().to_string(), kind));
    }

    /// An isotropic lamp of a luminous flux [lm].
    pub fn bulb(&mut self, position: Vec3, flux: f32) {
        self.light(LightKind::Point { position, intensity: Rgb::grey(flux / (4.0 * PI)) });
    }
}

/// An icosahedron, its triangles divided by four so many times, on the unit sphere.
fn geodesic(levels: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let g = 0.5 * (1.0 + 5f32.sqrt());
    let mut points: Vec<Vec3> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([Vec3::new(0.0, a, b), Vec3::new(a, b, 0.0), Vec3::new(b, 0.0, a)]);
    }
    let edge = |i: usize, j: usize| (points[i] - points[j]).length() < 2.1;
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in 0..12 {
            for k in 0..12 {
                // Each face once, its smallest corner first, counter-clockwise from outside.
                let face = i < j && i < k && edge(i, j) && edge(j, k) && edge(k, i);
                if face && (points[j] - points[i]).cross(points[k] - points[i]).dot(points[i]) > 0.0 {
                    triangles.push([i as u32, j as u32, k as u32]);
                }
            }
        }
    }
    for _ in 0..levels {
        let mut finer = Vec::new();
        let mut middles = std::collections::HashMap::new();
        for [a, b, c] in triangles {
            let mut middle = |i: u32, j: u32| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    points.push(0.5 * (points[i as usize] + points[j as usize]));
                    points.len() as u32 - 1
                })
            };
            let (d, e, f) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
        }
        triangles = finer;
    }
    points.iter_mut().for_each(|p| *p = p.normalize());
    (points, triangles)
}

fn area([a, b, c]: [Vec3; 3]) -> f32 {
    0.5 * (b - a).cross(c - a).length()
}

/// Settings of a few parts: N light paths, all gathered in `passes` eye passes.
pub fn settings(parts: &[&str], paths: u32, passes: u32, seed: u32) -> Settings {
    Settings {
        parts: parts.iter().map(|n| (*n).to_owned()).collect(),
        paths,
        passes: Some(passes),
        seed,
        ..Settings::default()
    }
}

/// The mean of some batches, pixel by pixel; asserts that nothing was left out.
pub fn render(scene: &Scene, eye: Eye, settings: &Settings, batches: u32) -> Vec<Rgb> {
    let mut cpu = Cpu::new(None).expect("threads");
    cpu.begin(scene.clone(), eye, settings).expect("sound settings");
    for index in 0..batches {
        cpu.add(Batch { index }).expect("a batch");
    }
    assert_eq!(cpu.statistics().non_finite, 0, "estimates that were not finite");
    cpu.frame().expect("begun").mean()
}

/// Illuminance [lx] at meters, luminance of the channels.
pub fn lux(scene: &Scene, meters: &[Meter], settings: &Settings, batches: u32) -> Vec<f64> {
    let mean = render(scene, Eye::Meters(meters.to_vec()), settings, batches);
    mean.iter().map(|v| f64::from(v.luminance()) * std::f64::consts::PI).collect()
}

pub fn meter(position: Vec3, normal: Vec3) -> Meter {
    Meter { position, normal }
}

/// A view of so many pixels.
pub fn view(eye: Vec3, target: Vec3, fov_y: f32, width: u32, height: u32) -> Eye {
    let up = if (target - eye).normalize().y.abs() > 0.99 { Vec3::Z } else { Vec3::Y };
    Eye::Camera(View::new(&Camera { name: String::new(), eye, target, up, fov_y }, width, height))
}

/// The i-th of a low-discrepancy set of points in the unit square.
pub fn spread(i: u32, seed: u32) -> [f32; 2] {
    sobol_owen_pair(i, 0, seed)
}

/// Figures for the documentation, with `--nocapture`.
#[allow(clippy::print_stdout, reason = "the test harness shows it only when asked")]
pub fn say(what: std::fmt::Arguments<'_>) {
    println!("{what}");
}

/// Asserts that the parts, caustics by the oracle, sum to `path` in both halves of a picture of 16 × 12 pixels, in all of it, and at two meters;
/// `seeds` randomisations of each, whose noise stays below 5 %.
pub fn parts_equal_path(scene: &Scene, camera: &Eye, desks: &[Meter; 2], seeds: u32) {
    let sums = |parts: &[&str], paths, passes, seed| {
        let s = settings(parts, paths, passes, seed);
        let picture = render(scene, camera.clone(), &s, 4);
        let half =
            |k: usize| picture[96 * k..96 * (k + 1)].iter().map(|c| f64::from(c.luminance())).sum::<f64>();
        [vec![half(0), half(1), half(0) + half(1)], lux(scene, desks, &s, 4)].concat()
    };
    let mut sides = [vec![Moments::default(); 5], vec![Moments::default(); 5]];
    for seed in 0..seeds {
        for (moments, all) in sides
            .iter_mut()
            .zip([sums(UNBIASED, 1 << 8, 1 << 5, 2 * seed), sums(ORACLE, 1, 1 << 6, 2 * seed + 1)])
        {
            moments.iter_mut().zip(all).for_each(|(m, v)| m.push(v));
        }
    }
    for (k, (fast, path)) in sides[0].iter().zip(&sides[1]).enumerate() {
        let p = fast.p_value_against(path);
        let noise = fast.standard_error().max(path.standard_error()) / path.mean();
        say(format_args!(
            "{k}: fast/path {:+.2e}, noise {noise:.1e}, p {p:.3}",
            fast.mean() / path.mean() - 1.0
        ));
        assert!(p > sidak(0.01, 5) && noise < 0.05, "{k}: p = {p}, noise {noise}");
    }
}

/// Who renders by these settings.
pub fn who(settings: &Settings) -> &'static str {
    if settings.parts == ORACLE { "path" } else { "fast" }
}

/// Asserts |measured/expected − 1| ≤ `tolerance` and returns the deviation.
pub fn close(what: &str, measured: f64, expected: f64, tolerance: f64) -> f64 {
    let off = measured / expected - 1.0;
    say(format_args!("{what}: {measured:.6}, off by {off:+.1e}"));
    assert!(off.abs() <= tolerance, "{what}: {measured} for {expected}, off by {off:.2e} > {tolerance:.0e}");
    off
}

/// [`close`] for the mean of `draws` seeds, whose own error must leave the tolerance its meaning: three standard
/// errors fit into it.
pub fn close_mean(
    what: &str,
    draws: u32,
    expected: f64,
    tolerance: f64,
    draw: impl FnMut(u32) -> f64,
) -> f64 {
    let all: Moments = (0..draws).map(draw).collect();
    let error = all.standard_error() / expected;
    assert!(3.0 * error < tolerance, "{what}: noise of {error:.1e} hides what is tested to {tolerance:.0e}");
    close(&format!("{what} (± {error:.1e})"), all.mean(), expected, tolerance)
}
