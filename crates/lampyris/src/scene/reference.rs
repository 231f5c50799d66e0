//! By what the light paths are dealt to the emitters: the flux that each had when it first shone. It is part of the
//! scene, since an edit must not deal anew: dimming or moving one lamp changes no other lamp's paths, an added one
//! brings its own, and one that is taken away takes only its own along.

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
