//! The dimension ledger: which random decision reads which dimension of the sequence.
//! Light paths, eye paths and photons have sequences (seeds) of their own, so their numbers may coincide. Decisions that must
//! be stratified together lie in one group of four, which Owen-scrambled Sobol' keeps a net ([`super::sobol`]).
//!
//! | light path | dimensions | group |
//! |---|---|---|
//! | point on the light | 0, 1 | 0 |
//! | direction of emission | 2, 3 | 0 |
//! | bounce j ≥ 1: direction | 4j, 4j + 1 | j |
//! | bounce j ≥ 1: choice of class and lobe | 4j + 2 | j |
//! | bounce j ≥ 1: Russian roulette | 4j + 3 | j |
//!
//! | eye path | dimensions | group |
//! |---|---|---|
//! | place in the pixel | 0, 1 | 0 |
//! | first of a packet: which virtual lights, or images of them, it picks | 2 | 0 |
//! | (free) | 3 | 0 |
//! | vertex k ≥ 0: direction | 8k + 4, 8k + 5 | 2k + 1 |
//! | vertex k ≥ 0: choice of class; where the path splits instead, whether the second is followed | 8k + 6 | 2k + 1 |
//! | vertex k ≥ 0: choice of lobe in the class | 8k + 7 | 2k + 1 |
//! | vertex k ≥ 0: point on the light | 8k + 8, 8k + 9 | 2k + 2 |
//! | vertex k ≥ 0: choice of the light | 8k + 10 | 2k + 2 |
//! | vertex k ≥ 0: Russian roulette | 8k + 11 | 2k + 2 |
//!
//! | caustic photon | dimensions | group |
//! |---|---|---|
//! | point on the light, or (first alone) vertex of the walk | 0, 1 | 0 |
//! | direction toward the body | 2, 3 | 0 |
//! | choice of the body | 4 | 1 |
//! | (free) | 5, 6, 7 | 1 |
//! | sharp vertex k ≥ 0: direction | 4k + 8, 4k + 9 | k + 2 |
//! | sharp vertex k ≥ 0: choice of lobe | 4k + 10 | k + 2 |
//! | sharp vertex k ≥ 0: Russian roulette | 4k + 11 | k + 2 |
//!
//! | path of the walk of 1996 | dimensions |
//! |---|---|
//! | light, and point on it | 0, 1 |
//! | direction of emission | 2, 3 |
//! | bounce 1 ≤ j ≤ 6: absorption, class and, with the rest of the number, direction | 2j + 2, 2j + 3 |
//! | bounce 1 ≤ j ≤ 6: choice of lobe where a class has several | j + 15 |
//! | (free) | 22, 23 |
//! | bounce j ≥ 7: absorption, class, direction | 4j − 4, 4j − 3 |
//! | bounce j ≥ 7: choice of lobe | 4j − 2 |
//! | (free) | 4j − 1 |
//!
//! The first sixteen are those of [Keller96, §4.4], since low dimensions are the better ones.
//!
//! A decision named with two dimensions returns the first of them. Which images a weak mirror makes in an eye pass, plain
//! random numbers of the pass decide, one an image (`integrator/mirror.rs`).

/// Decisions of a light path.
pub mod light {
    /// Point on the light, two dimensions.
    pub const POINT: u32 = 0;
    /// Direction of emission, two dimensions.
    pub const EMISSION: u32 = 2;

    /// Direction scattered at bounce j ≥ 1, two dimensions.
    pub const fn direction(j: u32) -> u32 {
        4 * j
    }

    /// Choice of class and lobe at bounce j ≥ 1.
    pub const fn choice(j: u32) -> u32 {
        4 * j + 2
    }

    /// Russian roulette after bounce j ≥ 1.
    pub const fn roulette(j: u32) -> u32 {
        4 * j + 3
    }
}

/// Decisions of an eye path.
pub mod eye {
    /// Place in the pixel, two dimensions.
    pub const PIXEL: u32 = 0;
    /// Which of many virtual lights the packet picks that the pixel is the first of.
    pub const PICK: u32 = 2;

    /// Direction scattered at vertex k ≥ 0 (0 is the first seen), two dimensions.
    pub const fn direction(k: u32) -> u32 {
        8 * k + 4
    }

    /// Choice between the sharp and the dull class at vertex k.
    pub const fn class(k: u32) -> u32 {
        8 * k + 6
    }

    /// Choice of the lobe within the class at vertex k.
    pub const fn lobe(k: u32) -> u32 {
        8 * k + 7
    }

    /// Point on the light that vertex k is connected with, two dimensions.
    pub const fn light_point(k: u32) -> u32 {
        8 * k + 8
    }

    /// Choice of that light.
    pub const fn light(k: u32) -> u32 {
        8 * k + 10
    }

    /// Russian roulette after vertex k.
    pub const fn roulette(k: u32) -> u32 {
        8 * k + 11
    }
}

/// Decisions of a caustic photon.
pub mod photon {
    /// Point on the light, two dimensions; the first of them chooses a vertex of the walk.
    pub const POINT: u32 = 0;
    /// Direction toward the body, two dimensions.
    pub const DIRECTION: u32 = 2;
    /// Choice of the body.
    pub const BODY: u32 = 4;

    /// The four decisions of sharp vertex k ≥ 0 (0 is on the body): direction in two dimensions, choice of the lobe, and
    /// Russian roulette after it.
    pub const fn vertex(k: u32) -> u32 {
        4 * k + 8
    }
}

/// Decisions of a path of the walk of 1996.
pub mod scatter {
    /// The light and the point on it, two dimensions.
    pub const POINT: u32 = 0;
    /// Direction of emission, two dimensions.
    pub const EMISSION: u32 = 2;
    /// Bounces whose directions lie in the first sixteen dimensions.
    const PAPER: u32 = 6;

    /// Absorption, class and direction at bounce j ≥ 1, two dimensions.
    pub const fn direction(j: u32) -> u32 {
        if j <= PAPER { 2 * j + 2 } else { 4 * j - 4 }
    }

    /// Choice among the lobes of a class at bounce j ≥ 1.
    pub const fn lobe(j: u32) -> u32 {
        if j <= PAPER { j + 15 } else { 4 * j - 2 }
    }
}

#[cfg(test)]
mod tests {
    use super::{eye, light, photon, scatter};

    #[test]
    fn no_dimension_serves_two_decisions() {
        let mut used = vec![0, 1, 2, 3];
        assert_eq!((light::POINT, light::EMISSION), (0, 2));
        for j in 1..20 {
            used.extend([light::direction(j), light::direction(j) + 1, light::choice(j), light::roulette(j)]);
        }
        assert_eq!(used, (0..80).collect::<Vec<_>>());

        let mut used = vec![eye::PIXEL, 1, 2, 3];
        for k in 0..10 {
            used.extend([eye::direction(k), eye::direction(k) + 1, eye::class(k), eye::lobe(k)]);
            used.extend([eye::light_point(k), eye::light_point(k) + 1, eye::light(k), eye::roulette(k)]);
        }
        assert_eq!(used, (0..84).collect::<Vec<_>>());

        let mut used = vec![photon::POINT, 1, photon::DIRECTION, 3, photon::BODY, 5, 6, 7];
        used.extend((0..10).flat_map(|k| (0..4).map(move |d| photon::vertex(k) + d)));
        assert_eq!(used, (0..48).collect::<Vec<_>>());

        let mut used = vec![scatter::POINT, 1, scatter::EMISSION, 3, 22, 23];
        used.extend((7..20).map(|j| 4 * j - 1));
        for j in 1..20 {
            used.extend([scatter::direction(j), scatter::direction(j) + 1, scatter::lobe(j)]);
        }
        used.sort_unstable();
        assert_eq!(used, (0..76).collect::<Vec<_>>());
        assert!((1..=6).all(|j| scatter::direction(j) + 1 < 16), "sixteen dimensions are the paper's");
    }
}
