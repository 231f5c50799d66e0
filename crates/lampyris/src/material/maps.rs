//! Which textures multiply which factors of a material, and how much of the surface is there at all.

use glam::Affine2;
use serde::{Deserialize, Serialize};

/// A texture laid on a surface by one of its sets of texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Map {
    /// Which texture of the scene.
    pub texture: u32,
    /// Which of the mesh's two sets of coordinates.
    pub set: u32,
    /// Applied to the coordinates before the look-up.
    pub transform: Affine2,
}

/// The textures of a material. What is absent multiplies by one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Maps {
    /// Red, green and blue: the base colour. Alpha: the coverage.
    pub color: Option<Map>,
    /// Green: roughness. Blue: metalness.
    pub roughness: Option<Map>,
    /// The shading normal in the frame of tangent, bitangent and normal, each component in [0, 1] for [−1, 1].
    /// With it the factor on the first two of them.
    pub normal: Option<(Map, f32)>,
    /// Emitted radiance.
    pub emission: Option<Map>,
    /// Alpha: strength of the reflection of a dielectric.
    pub specular: Option<Map>,
    /// Its colour at normal incidence.
    pub specular_color: Option<Map>,
    /// Red: transmission.
    pub transmission: Option<Map>,
    /// Red: the coverage, where it has an image of its own.
    pub alpha: Option<Map>,
}

/// How much of a surface is there. What is not there, no ray meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Coverage {
    /// All of it.
    #[default]
    Full,
    /// Where factor × map reaches the cutoff.
    Mask {
        /// In [0, 1].
        factor: f32,
        /// In [0, 1].
        cutoff: f32,
    },
    /// The share factor × map, as a screen of holes finer than any ray.
    Blend {
        /// In [0, 1].
        factor: f32,
    },
}
