//! By what the light paths are dealt to the emitters: the flux that each had when it first shone. It is part of the
//! scene, since an edit must not deal anew: dimming or moving one lamp changes no other lamp's paths, an added one
//! brings its own, and one that is taken away takes only its own along.

use crate::color::Rgb;
use serde::{Deserialize, Serialize};

/// The emitters that ever shone in a scene, in the order in which they first did; an emitter's place is its number.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Φ_file, the flux of all that shone first [lm], by which shares are counted; 0 as long as nothing has.
    pub flux: f64,
    /// Who they are.
    pub shares: Vec<Share>,
}

/// What one emitter's share of the light paths is fixed at.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Share {
    /// Which emitter.
    pub source: Source,
    /// Φ_ref/Φ_file, what it has of the N paths of a batch: at most 1, however bright it was; 0 as long as it is dark.
    pub share: f32,
    /// Which of the scene's light groups it belongs to.
    #[serde(default)]
    pub group: u16,
}

/// Lamps whose light is summed by itself, so that level and colour may be set afterwards without a ray.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// The luminaire's name in the file, or the material's.
    pub name: String,
    /// What its light is multiplied by when it is shown, channel by channel: level and colour in one.
    pub color: Rgb,
}

impl Group {
    /// Most groups that a scene may have. Lamps added beyond them share the last.
    pub const MOST: usize = 64;
}

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Source {
    /// A light of the scene, by its number.
    Light(u32),
    /// One side of the triangles of an instance that are of one material.
    Side {
        /// Which instance.
        instance: u32,
        /// Which material.
        material: u32,
        /// The back instead of the front.
        back: bool,
    },
    /// What surrounds the scene.
    Environment,
}
