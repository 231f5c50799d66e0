//! What surfaces do with light: a closed set of BSDFs, one file each.
//!
//! All directions are unit vectors in the local frame whose +z is the shading normal on the side of `wo`
//! (a dielectric alone keeps its outward normal as +z, so that `wo.z < 0` means inside); both point away from the
//! surface. Lobes fall into two classes, by one threshold for the whole program: see [`Class`].
//! No light source and no ray is known here.

mod dielectric;
mod diffuse;
mod energy;
mod exp;
mod ggx;
mod maps;
mod pbr;
mod sound;
mod ward;

pub use dielectric::{Dielectric, fresnel};
pub use diffuse::Diffuse;
pub use maps::{Coverage, Map, Maps};
pub use pbr::Pbr;
pub use sound::glows_soundly;
pub use ward::{DELTA_ALPHA, Glossy, Ward};
pub(crate) use ward::{lobe, sharpness};

use crate::color::Rgb;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// Roughness below which a glossy lobe counts as [`Class::Sharp`]: Ward's RMS facet slope, GGX's α.
pub const SHARP_ALPHA: f32 = 0.15;

/// The two classes of lobes that partition path space (docs/light-transport.md): S and D of Heckbert's notation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// S: delta lobes and lobes smoother than [`SHARP_ALPHA`]. Eye paths and particles pass through them.
    Sharp,
    /// D: everything else. Virtual point lights are deposited on them, and gathered by them.
    Dull,
}

/// A direction drawn from a class of lobes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// The direction drawn.
    pub wi: Vec3,
    /// f_r·|cos θ_i| / pdf: what the path's throughput is multiplied by.
    pub weight: Rgb,
    /// Density of `wi` within the class [sr⁻¹]; infinite for a delta lobe, which no other technique can find.
    pub pdf: f32,
}

/// What a path carries, seen from the end where it started. It matters where light changes its medium.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    /// Eye paths carry radiance backwards: `wo` points to the eye, and refraction scales by (η_o/η_i)².
    Radiance,
    /// Particles carry flux: `wo` points to the light, and refraction scales nothing.
    Flux,
}

/// A surface's named material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name in the file.
    pub name: String,
    /// Scattering.
    pub bsdf: Bsdf,
    /// Emitted radiance [cd/m²], the same in all directions, from each side that `sides` grants.
    pub emission: Rgb,
    /// From which sides the surface is there at all.
    pub sides: Sides,
    /// How much of it is there.
    pub coverage: Coverage,
    /// Textures that multiply the factors of `bsdf`, `emission` and `coverage`.
    pub maps: Maps,
}

impl Material {
    /// A whole surface that does not glow, alike from both sides, without textures.
    pub fn new(name: impl Into<String>, bsdf: Bsdf) -> Material {
        Material {
            name: name.into(),
            bsdf,
            emission: Rgb::BLACK,
            sides: Sides::Both,
            coverage: Coverage::Full,
            maps: Maps::default(),
        }
    }
}

/// Which sides of a surface exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Sides {
    /// MGF `sides 1`: from behind it is invisible, light passes, and nothing is emitted there.
    FrontOnly,
    /// glTF's single-sided emitter: blocks and scatters on both sides, emits from its front alone.
    EmitFront,
    /// Alike from both sides, emission included.
    Both,
}

/// The closed set of scattering functions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Bsdf {
    /// Lambertian reflection and transmission.
    Diffuse(Diffuse),
    /// A diffuse base with a glossy or mirror lobe in reflection, and one in transmission.
    Ward(Ward),
    /// Interface of a solid transparent body.
    Dielectric(Dielectric),
    /// glTF's metal, plastic and thin glass.
    Pbr(Pbr),
}

/// Whether the surface reflects between the two directions, rather than transmits; z = 0 counts as above.
fn same_side(wo: Vec3, wi: Vec3) -> bool {
    (wo.z >= 0.0) == (wi.z >= 0.0)
}

impl Bsdf {
    /// f_r of the lobes of `class` [sr⁻¹], without the cosine, for light that arrives from `wi` and leaves toward `wo`.
    /// Delta lobes evaluate to black.
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        match self {
            Bsdf::Diffuse(m) => m.eval(class, wo, wi),
            Bsdf::Ward(m) => m.eval(class, wo, wi),
            Bsdf::Pbr(m) => m.eval(class, wo, wi),
            Bsdf::Dielectric(m) => m.eval(class, wo, wi),
        }
    }

    /// Draws a direction from the lobes of `class`; `None` where they reflect nothing.
    ///
    /// `u` places the direction, `choice` picks the lobe within the class; all in [0, 1). Of all materials only
    /// [`Dielectric`] asks for `transport`: the others are symmetric in `wo` and `wi`.
    pub fn sample(
        &self,
        class: Class,
        wo: Vec3,
        u: [f32; 2],
        choice: f32,
        transport: Transport,
    ) -> Option<Scatter> {
        match self {
            Bsdf::Diffuse(m) => m.sample(class, wo, u, choice),
            Bsdf::Ward(m) => m.sample(class, wo, u, choice),
            Bsdf::Pbr(m) => m.sample(class, wo, u, choice),
            Bsdf::Dielectric(m) => m.sample(class, wo, u, choice, transport),
        }
    }

    /// Of the numbers `choice` in [0, 1) with which `sample` draws from the sharp lobes by `u`, the share, from 0 on, for which
    /// it draws a reflection.
    pub fn reflected_sharply(&self, wo: Vec3, u: [f32; 2]) -> f32 {
        match self {
            Bsdf::Diffuse(_) => 1.0,
            Bsdf::Ward(m) => m.reflected_sharply(wo),
            Bsdf::Pbr(m) => m.reflected_sharply(wo),
            Bsdf::Dielectric(m) => m.reflected_share(wo, u),
        }
    }

    /// Density with which `sample` draws `wi` [sr⁻¹]; delta lobes have none, hence 0.
    pub fn pdf(&self, class: Class, wo: Vec3, wi: Vec3) -> f32 {
        match self {
            Bsdf::Diffuse(m) => m.pdf(class, wo, wi),
            Bsdf::Ward(m) => m.pdf(class, wo, wi),
            Bsdf::Pbr(m) => m.pdf(class, wo, wi),
            Bsdf::Dielectric(m) => m.pdf(class, wo, wi),
        }
    }

    /// Share of the light arriving from `wo` that the lobes of `class` send on (directional albedo), to a few per
    /// cent: it steers choices and fills the albedo channels, no estimate depends on its exactness. It is exactly
    /// black only if the class is empty. What rough glass loses between its facets it does not tell.
    pub fn albedo(&self, class: Class, wo: Vec3) -> Rgb {
        match self {
            Bsdf::Diffuse(m) => m.albedo(class),
            Bsdf::Ward(m) => m.albedo(class, wo),
            Bsdf::Pbr(m) => m.albedo(class, wo),
            Bsdf::Dielectric(m) => m.albedo(class, wo),
        }
    }

    /// Share of the light that the delta lobe of a mirror or pane reflects, met at an angle of this cosine from either
    /// side; black without such a lobe. Solid glass does not count: its two sides differ.
    pub fn mirror_reflectance(&self, cosine: f32) -> Rgb {
        match self {
            Bsdf::Ward(m) => m.mirror_reflectance(),
            Bsdf::Pbr(m) => m.mirror_reflectance(cosine),
            Bsdf::Diffuse(_) | Bsdf::Dielectric(_) => Rgb::BLACK,
        }
    }

    /// True if nothing is sharp but the lobe of [`Self::mirror_reflectance`], and that of an opaque mirror.
    pub fn only_mirrors(&self) -> bool {
        match self {
            Bsdf::Ward(m) => m.only_mirrors(),
            Bsdf::Pbr(m) => m.only_mirrors(),
            Bsdf::Diffuse(_) => true,
            Bsdf::Dielectric(m) => m.is_dull(),
        }
    }

    /// The reflectance of the dull class if it is a pure Lambertian reflector: the gather then needs no `eval`.
    pub fn lambertian(&self) -> Option<Rgb> {
        match self {
            Bsdf::Diffuse(m) => m.lambertian(),
            Bsdf::Ward(m) => m.lambertian(),
            Bsdf::Pbr(m) => m.lambertian(),
            Bsdf::Dielectric(m) => (!m.is_dull()).then_some(Rgb::BLACK),
        }
    }

    /// What the dull class is if it is one reflecting lobe of Ward's over a Lambertian reflector: the gather then works out
    /// sixteen at once.
    pub fn glossy(&self) -> Option<Glossy> {
        match self {
            Bsdf::Ward(m) => m.glossy(),
            Bsdf::Diffuse(_) | Bsdf::Pbr(_) | Bsdf::Dielectric(_) => None,
        }
    }

    /// True if dull lobes may send light to the far side of the surface.
    pub fn transmits(&self) -> bool {
        match self {
            Bsdf::Diffuse(m) => !m.transmittance.is_black(),
            Bsdf::Ward(m) => !m.base.transmittance.is_black() || !m.transmission.is_black(),
            Bsdf::Pbr(m) => m.transmits(),
            // Even where nothing passes: its outward normal makes either side a receiver.
            Bsdf::Dielectric(m) => m.is_dull(),
        }
    }

    /// True where the local frame keeps the outward normal instead of turning to the side of `wo`.
    pub fn is_solid_interface(&self) -> bool {
        matches!(self, Bsdf::Dielectric(_))
    }
}
