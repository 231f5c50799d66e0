//! The generators that the papers compare, and those of today, as one closed set of pure functions of (index, dimension,
//! seed) [Keller96, §4.4]. Pictures are made of [`super::Sequence`]; this is what the walk of 1996 is driven by.
//!
//! What a seed does differs, and experiments that average over seeds should know:
//!
//! | generator | seed |
//! |---|---|
//! | congruential | what `srand48` is given: the start of the stream |
//! | inversive | the start of the stream |
//! | Halton | the start of the sequence, far apart; 0 begins at point 0 |
//! | permuted Halton | the permutations, one for each digit of each base |
//! | Faure | the start of the sequence; 0 begins at point b⁴ − 1 |
//! | Sobol' | the scramble of each dimension: an exclusive-or, or Owen's |
//! | lattice | the shift of each dimension, modulo 1 |
//!
//! The random ones take the numbers of a path side by side from one stream, [`STRIDE`] for each path.

use super::halton;
use super::hash::{hash, mix};
use super::radical_inverse::{radical_inverse_u64, scrambled_radical_inverse_f64};
use super::{faure, inversive, lattice, lcg, sobol};
use serde::{Deserialize, Serialize};

/// Numbers of a stream that belong to one point: a prime, since leaps by powers of two are what a congruential generator
/// does worst. A point of more dimensions shares them with the next.
pub const STRIDE: u64 = 4099;

/// Where numbers come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Generator {
    /// `drand48`: [`lcg::drand48`].
    Congruential,
    /// [`inversive::inversive`].
    Inversive,
    /// Halton's sequence as it is, in 64 dimensions.
    Halton,
    /// With a random permutation for each digit.
    PermutedHalton,
    /// [`faure::faure`] in so many dimensions.
    Faure {
        /// s: the base is the first prime from here on.
        dimensions: u32,
    },
    /// [`sobol::sobol_xor_word`].
    SobolXor,
    /// [`sobol::sobol_owen_wide_word`].
    SobolOwen,
    /// [`lattice::lattice`].
    Lattice,
}

impl Generator {
    /// All of them, in the order of a table: two random ones, then those of low discrepancy; Faure's in the sixteen dimensions
    /// of [Keller96, Table 1].
    pub const ALL: [Generator; 8] = [
        Generator::Congruential,
        Generator::Inversive,
        Generator::Halton,
        Generator::PermutedHalton,
        Generator::Faure { dimensions: 16 },
        Generator::SobolXor,
        Generator::SobolOwen,
        Generator::Lattice,
    ];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Generator::Congruential => "congruential",
            Generator::Inversive => "inversive",
            Generator::Halton => "halton",
            Generator::PermutedHalton => "permuted-halton",
            Generator::Faure { .. } => "faure",
            Generator::SobolXor => "sobol-xor",
            Generator::SobolOwen => "sobol-owen",
            Generator::Lattice => "lattice",
        }
    }

    /// The generator of that name, if there is one; Faure's in sixteen dimensions.
    pub fn by_name(name: &str) -> Option<Generator> {
        Generator::ALL.into_iter().find(|g| g.name() == name)
    }

    /// The same generator for points of `s` dimensions: only Faure's asks.
    pub const fn in_dimensions(self, s: u32) -> Generator {
        match self {
            Generator::Faure { .. } => Generator::Faure { dimensions: s },
            other => other,
        }
    }

    /// True if the numbers pretend to be independent.
    pub const fn is_random(self) -> bool {
        matches!(self, Generator::Congruential | Generator::Inversive)
    }

    /// Coordinate `dimension` of point `index`, in [0, 1). Beyond the dimensions that Halton's and Faure's sequences have,
    /// numbers are plain random ones.
    pub fn point(self, index: u32, dimension: u32, seed: u32) -> f64 {
        let in_stream = u64::from(index) * STRIDE + u64::from(dimension);
        match self {
            Generator::Congruential => lcg::drand48(in_stream, seed),
            Generator::Inversive => {
                let start = u64::from(hash(seed, 1)) << 32 | u64::from(hash(seed, 2));
                inversive::inversive(in_stream, start)
            }
            Generator::Halton => match halton::base(dimension) {
                Some(base) => radical_inverse_u64(base, start(seed) + u64::from(index)),
                None => random(index, dimension, seed),
            },
            Generator::PermutedHalton => match halton::base(dimension) {
                Some(base) => scrambled_radical_inverse_f64(base, index, seed),
                None => random(index, dimension, seed),
            },
            Generator::Faure { dimensions } => {
                let base = faure::base(dimensions);
                if dimension >= base {
                    return random(index, dimension, seed);
                }
                let skipped = u64::from(base).pow(4) - 1;
                faure::faure(skipped + start(seed) + u64::from(index), dimension, base)
            }
            Generator::SobolXor => fraction(sobol::sobol_xor_word(index, dimension, seed)),
            Generator::SobolOwen => fraction(sobol::sobol_owen_wide_word(index, dimension, seed)),
            Generator::Lattice => fraction(lattice::lattice(index, dimension, seed)),
        }
    }
}

/// Where a sequence without a scramble begins; 0 for the seed 0.
fn start(seed: u32) -> u64 {
    u64::from(mix(seed))
}

fn random(index: u32, dimension: u32, seed: u32) -> f64 {
    fraction(hash(hash(seed, dimension), index))
}

fn fraction(word: u32) -> f64 {
    f64::from(word) / 4_294_967_296.0
}
