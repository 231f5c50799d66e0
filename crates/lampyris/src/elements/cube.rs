//! The closed cube of [Keller96, Table 1], traced like any scene: walls that emit ¼ and reflect half look ½ everywhere, so
//! that every patch says how wrong it is.

use super::{Criterion, ElementLight, Elements, converge};
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::material::{Bsdf, Diffuse, Material, Sides};
use crate::scatter::{Ending, PAPER_REFLECTIONS, RandomWalk, Rules};
use crate::scene::{Instance, Mesh, Scene};
use crate::sequence::Generator;
use crate::world::World;
use glam::{Affine3A, Vec3};

/// L₀ [cd/m²].
const EMITTED: f32 = 0.25;

/// ρ_d.
const REFLECTANCE: f32 = 0.5;

/// The cube, and its walls cut into K equal right triangles.
pub struct ClosedCube {
    world: World,
    elements: Elements,
}

/// A column of Table 1.
#[derive(Clone, Debug)]
pub struct CubeRun {
    /// N; `None` where four million were not enough.
    pub paths: Option<u32>,
    /// Δ_a against ½, in which the light of longer paths is missing [cd/m²].
    pub deviation: f64,
    /// Δ_aw: with equal areas Δ_a/√K [cd/m²].
    pub weighted: f64,
    /// Δ after each step.
    pub changes: Vec<f64>,
}

impl ClosedCube {
    /// With K = 12, 24, 48, 96 … patches: its twelve triangles, halved again and again. Others are an error.
    pub fn new(patches: u32) -> Result<ClosedCube> {
        let halves = patches / 12;
        if !patches.is_multiple_of(12) || !halves.is_power_of_two() {
            let reason = format!("a cube of {patches} patches: there are 12, 24, 48, 96 …");
            return Err(Error::BadSetting(reason));
        }
        let world = World::new(scene());
        let elements = Elements::halved(&world, halves.trailing_zeros())?;
        Ok(ClosedCube { world, elements })
    }

    /// Its patches.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// The cube made traceable.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Paths until the rule of Table 1 holds, and how wrong the patches then are.
    pub fn run(&self, generator: Generator, seed: u32) -> CubeRun {
        let walk = RandomWalk::new(&self.world, Rules::paper(generator, seed));
        let done = converge(&walk, &self.elements, &Criterion::default());
        let k = self.elements.len() as f64;
        let deviation = self.deviation(&done.light, 0.5);
        CubeRun { paths: done.paths, deviation, weighted: deviation / k.sqrt(), changes: done.changes }
    }

    /// How wrong the patches are after so many paths, in the mean square, against the light of paths of seven reflections,
    /// ½ (1 − 2⁻⁸) [cd/m²].
    pub fn error(&self, generator: Generator, seed: u32, paths: u32) -> f64 {
        let walk = RandomWalk::new(&self.world, Rules::paper(generator, seed));
        let truth = 0.5 * (1.0 - 0.5_f64.powi(PAPER_REFLECTIONS as i32 + 1));
        self.deviation(&ElementLight::of(&walk, &self.elements, 0..paths), truth)
    }

    /// Mean radiance of all patches after so many paths that end by `ending` [cd/m²].
    pub fn mean(&self, generator: Generator, seed: u32, ending: Ending, paths: u32) -> f64 {
        let walk = RandomWalk::new(&self.world, Rules { ending, ..Rules::paper(generator, seed) });
        let light = ElementLight::of(&walk, &self.elements, 0..paths);
        self.radiances(&light).sum::<f64>() / self.elements.len() as f64
    }

    fn deviation(&self, light: &ElementLight, truth: f64) -> f64 {
        let squares: f64 = self.radiances(light).map(|l| (l - truth) * (l - truth)).sum();
        (squares / self.elements.len() as f64).sqrt()
    }

    /// Emission included.
    fn radiances(&self, light: &ElementLight) -> impl Iterator<Item = f64> {
        (0..self.elements.len() as u32).map(|k| f64::from(EMITTED) + light.exact(&self.elements, k)[1])
    }
}

/// The unit cube, all walls in one mesh: a single light.
fn scene() -> Scene {
    let corner = |k: u32| Vec3::new((k & 1) as f32, (k >> 1 & 1) as f32, (k >> 2 & 1) as f32);
    // Counter-clockwise as seen from within.
    let walls = [[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]];
    let halves = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]];
    let mesh = Mesh {
        positions: (0..8).map(corner).collect(),
        triangles: walls.into_iter().flat_map(halves).collect(),
        materials: vec![0; 12],
        ..Mesh::default()
    };
    let wall = Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(REFLECTANCE)));
    Scene {
        meshes: vec![mesh],
        instances: vec![Instance { name: "cube".into(), mesh: 0, transform: Affine3A::IDENTITY }],
        materials: vec![Material {
            emission: Rgb::grey(EMITTED),
            sides: Sides::FrontOnly,
            ..Material::new("wall", wall)
        }],
        ..Scene::default()
    }
}
