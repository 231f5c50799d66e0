//! glTF's metallic-roughness surface: a metal, a plastic and a thin pane in one, mixed by factors.

use super::Diffuse;
use crate::color::Rgb;
use serde::{Deserialize, Serialize};

/// The factors of the model, each of which a texture may multiply.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pbr {
    /// Diffuse reflectance of the plastic, reflectance at normal incidence of the metal, tint of the pane.
    pub base_color: Rgb,
    /// 0 plastic or pane, 1 metal.
    pub metallic: f32,
    /// Perceptual roughness: its square is GGX's α.
    pub roughness: f32,
    /// Index of refraction of plastic and pane.
    pub ior: f32,
    /// Strength of their reflection: at 0 the plastic is purely diffuse.
    pub specular: f32,
    /// Colour of their reflection at normal incidence.
    pub specular_color: Rgb,
    /// 0 plastic, 1 a thin pane that refracts nothing.
    pub transmission: f32,
}

impl Default for Pbr {
    /// glTF's defaults.
    fn default() -> Pbr {
        Pbr {
            base_color: Rgb::WHITE,
            metallic: 1.0,
            roughness: 1.0,
            ior: 1.5,
            specular: 1.0,
            specular_color: Rgb::WHITE,
            transmission: 0.0,
        }
    }
}

impl Pbr {
    pub(super) fn base(&self) -> Diffuse {
        Diffuse::opaque(self.base_color)
    }
}
