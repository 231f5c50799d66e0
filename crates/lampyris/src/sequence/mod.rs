//! Low-discrepancy sequences as pure functions of (index, dimension, seed), one file each [Keller97, §3.1].
//!
//! There is no sampler object and no state: any number in a picture can be recomputed on any machine, in any order.
//! Every sample lies in [0, 1), strictly below 1 as an `f32`. Which decision reads which dimension is written down in
//! [`ledger`]; what the numbers are mapped to is `sampling`'s business.

pub mod discrepancy;
pub mod faure;
mod generator;
pub mod halton;
pub mod hammersley;
mod hash;
pub mod inversive;
pub mod lattice;
pub mod lcg;
pub mod ledger;
pub mod radical_inverse;
pub mod sobol;

pub use generator::{Generator, STRIDE};
pub use halton::{halton, jittered_halton, scrambled_halton};
pub use hammersley::{hammersley, jittered_hammersley};
pub use hash::{hash, mix, uniform, unit_f32};
pub use radical_inverse::{next_radical_inverse, radical_inverse, scrambled_radical_inverse};

use serde::{Deserialize, Serialize};

/// Points that [`Sequence::JitteredHalton`] stratifies together: its jitter fills the cells of this many.
pub const JITTER_BLOCK: u32 = 1024;

/// The sequences a picture can be made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Sequence {
    /// [`halton()`]; the seed does nothing.
    Halton,
    /// [`scrambled_halton`].
    ScrambledHalton,
    /// [`jittered_halton`] in blocks of [`JITTER_BLOCK`] points.
    JitteredHalton,
    /// [`sobol::sobol_xor`].
    SobolXor,
    /// [`sobol::sobol_owen`].
    #[default]
    SobolOwen,
}

impl Sequence {
    /// All of them, in the order of a list for people.
    pub const ALL: [Sequence; 5] = [
        Sequence::SobolOwen,
        Sequence::SobolXor,
        Sequence::ScrambledHalton,
        Sequence::JitteredHalton,
        Sequence::Halton,
    ];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Sequence::Halton => "halton",
            Sequence::ScrambledHalton => "scrambled-halton",
            Sequence::JitteredHalton => "jittered-halton",
            Sequence::SobolXor => "sobol-xor",
            Sequence::SobolOwen => "sobol-owen",
        }
    }

    /// What it is, in a line.
    pub const fn about(self) -> &'static str {
        match self {
            Sequence::Halton => {
                "Halton's sequence as Keller's 1997 report has it; deterministic, for few bounces"
            }
            Sequence::ScrambledHalton => "Halton's sequence with randomly permuted digits",
            Sequence::JitteredHalton => "Halton's sequence moved at random within its cells (1997 report)",
            Sequence::SobolXor => "Sobol's sequence under an exclusive-or (Wald 2002)",
            Sequence::SobolOwen => "Sobol's sequence under Owen's scramble, in groups of four dimensions",
        }
    }

    /// True if another seed gives independent numbers: only then do randomisations exist. A jitter within cells does
    /// not make them independent.
    pub const fn is_randomised(self) -> bool {
        !matches!(self, Sequence::Halton | Sequence::JitteredHalton)
    }

    /// The sequence of that name, if there is one.
    pub fn by_name(name: &str) -> Option<Sequence> {
        Sequence::ALL.into_iter().find(|s| s.name() == name)
    }

    /// Coordinate `dimension` of point `index`, in [0, 1). Any dimension works: the Halton family has
    /// [`halton::DIMENSIONS`] and plain random numbers above, Sobol' is padded.
    pub fn sample(self, index: u32, dimension: u32, seed: u32) -> f32 {
        match self {
            Sequence::Halton => halton(index, dimension),
            Sequence::ScrambledHalton => scrambled_halton(index, dimension, seed),
            Sequence::JitteredHalton => jittered_halton(index, dimension, JITTER_BLOCK, seed),
            Sequence::SobolXor => sobol::sobol_xor(index, dimension, seed),
            Sequence::SobolOwen => sobol::sobol_owen(index, dimension, seed),
        }
    }

    /// Coordinates `dimension` and `dimension` + 1 of point `index`: the same numbers as two calls of
    /// [`Sequence::sample`], for less.
    pub fn pair(self, index: u32, dimension: u32, seed: u32) -> [f32; 2] {
        match self {
            Sequence::SobolOwen => sobol::sobol_owen_pair(index, dimension, seed),
            _ => [self.sample(index, dimension, seed), self.sample(index, dimension + 1, seed)],
        }
    }
}
