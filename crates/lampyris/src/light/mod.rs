//! Light sources that are no surfaces of the scene: a closed set.
//! They are sampled and found by rays but block none. Emissive surfaces are objects with an emitting
//! [`crate::material::Material`]; the world gathers them as lights of their own.

mod emitter;
mod sky;
mod surface;

pub use emitter::{Arrival, Bounds, Departure, Emitter, LightPoint, Shine};
pub use sky::Sky;
pub use surface::{EmissiveSide, GlowingTriangle};

use crate::color::Rgb;
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// A named light source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Name in the file, or one given by the importer.
    pub name: String,
    /// What it is.
    pub kind: LightKind,
    /// Whether it shines.
    #[serde(default)]
    pub state: State,
}

/// Whether a light shines, and whether it is there at all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum State {
    /// It shines.
    #[default]
    On,
    /// It is there, and dark.
    Off,
    /// It was taken away; its number stays, so that no other light's changes.
    Away,
}

impl Light {
    /// A light that shines.
    pub fn new(name: impl Into<String>, kind: LightKind) -> Light {
        Light { name: name.into(), kind, state: State::On }
    }

    /// Centre and radius of a light at a finite place; `None` for parallel light.
    pub fn extent(&self) -> Option<(Vec3, f32)> {
        match self.kind {
            LightKind::Point { position, .. } | LightKind::Spot { position, .. } => Some((position, 0.0)),
            LightKind::Sphere { center, radius, .. } | LightKind::Disc { center, radius, .. } => {
                Some((center, radius))
            }
            LightKind::Directional { .. } => None,
        }
    }

    /// [`LightKind::is_sound`]. Other lights are left out: one number missing would poison the whole picture.
    pub fn is_sound(&self) -> bool {
        self.kind.is_sound()
    }
}

impl LightKind {
    /// True if every number is finite, every direction a unit vector, and every size what its field asks for.
    pub fn is_sound(&self) -> bool {
        let unit = |v: Vec3| (v.length_squared() - 1.0).abs() < 1e-3;
        match *self {
            LightKind::Point { position, intensity } => position.is_finite() && intensity.is_finite(),
            LightKind::Spot { position, direction, intensity, beam } => {
                position.is_finite() && unit(direction) && intensity.is_finite() && beam.is_sound()
            }
            LightKind::Directional { direction, illuminance } => unit(direction) && illuminance.is_finite(),
            LightKind::Sphere { center, radius, radiance } => {
                center.is_finite() && radius > 0.0 && radius.is_finite() && radiance.is_finite()
            }
            LightKind::Disc { center, normal, radius, radiance } => {
                let placed = center.is_finite() && unit(normal);
                placed && radius > 0.0 && radius.is_finite() && radiance.is_finite()
            }
        }
    }

    /// How bright it is: its intensity [cd], illuminance [lx] or radiance [cd/m²].
    pub fn brightness(&self) -> Rgb {
        match *self {
            LightKind::Point { intensity, .. } | LightKind::Spot { intensity, .. } => intensity,
            LightKind::Directional { illuminance, .. } => illuminance,
            LightKind::Sphere { radiance, .. } | LightKind::Disc { radiance, .. } => radiance,
        }
    }

    /// The same light as bright as that.
    #[must_use]
    pub fn with_brightness(mut self, brightness: Rgb) -> LightKind {
        match &mut self {
            LightKind::Point { intensity: own, .. }
            | LightKind::Spot { intensity: own, .. }
            | LightKind::Directional { illuminance: own, .. }
            | LightKind::Sphere { radiance: own, .. }
            | LightKind::Disc { radiance: own, .. } => *own = brightness,
        }
        self
    }
}

impl Beam {
    /// True if its numbers lie where their fields say.
    fn is_sound(self) -> bool {
        match self {
            Beam::Cone { cos_inner, cos_outer } => {
                -1.0 <= cos_outer && cos_outer < cos_inner && cos_inner <= 1.0
            }
            Beam::Cosine { exponent } => exponent >= 0.0 && exponent.is_finite(),
        }
    }
}

/// The closed set of light sources. Directions are unit vectors in world space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum LightKind {
    /// The same intensity in all directions.
    Point {
        /// Where [m].
        position: Vec3,
        /// Luminous intensity [cd].
        intensity: Rgb,
    },
    /// Intensity about an axis.
    Spot {
        /// Where [m].
        position: Vec3,
        /// The axis, away from the lamp.
        direction: Vec3,
        /// Luminous intensity on the axis [cd].
        intensity: Rgb,
        /// How the intensity falls off the axis.
        beam: Beam,
    },
    /// Parallel light from infinity.
    Directional {
        /// The way the light travels.
        direction: Vec3,
        /// Illuminance on a plane facing it [lx].
        illuminance: Rgb,
    },
    /// A glowing sphere seen from outside.
    Sphere {
        /// Centre [m].
        center: Vec3,
        /// Radius [m], > 0.
        radius: f32,
        /// Radiance [cd/m²].
        radiance: Rgb,
    },
    /// A glowing disc, on the side of its normal.
    Disc {
        /// Centre [m].
        center: Vec3,
        /// Which side glows.
        normal: Vec3,
        /// Radius [m], > 0.
        radius: f32,
        /// Radiance [cd/m²].
        radiance: Rgb,
    },
}

/// The angular profile of a spot light, 1 on the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Beam {
    /// Full inside `cos_inner`, none outside `cos_outer`, smooth between (glTF's `KHR_lights_punctual`: the square
    /// of a linear ramp in the cosine).
    Cone {
        /// Cosine of the half-angle up to which the intensity is full.
        cos_inner: f32,
        /// Cosine of the half-angle from which on it is zero, < `cos_inner`.
        cos_outer: f32,
    },
    /// cosᵈ of the angle off the axis, none behind [Keller97, §4.2].
    Cosine {
        /// d ≥ 0.
        exponent: f32,
    },
}
