//! Integer hashing: seeds for scrambles, and plain random numbers as a function of their place.
//! The mixing is multiply–xorshift, the finaliser of MurmurHash3. It is no cryptography and keeps no state.

/// Mixes the bits of a word; a bijection of `u32` that moves each input bit into each output bit.
pub fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x85eb_ca6b);
    x ^= x >> 13;
    x = x.wrapping_mul(0xc2b2_ae35);
    x ^ (x >> 16)
}

/// A random word for the pair (seed, x); for a fixed seed a bijection in `x`. Chain it for more arguments:
/// `hash(hash(seed, a), b)`.
pub fn hash(seed: u32, x: u32) -> u32 {
    // The golden ratio keeps seed 0, a fixed point of `mix`, from being no seed at all.
    mix(mix(seed.wrapping_add(0x9e37_79b9)) ^ x)
}

/// A plain random number in [0, 1) for each (seed, index, dimension).
pub fn uniform(seed: u32, index: u32, dimension: u32) -> f32 {
    unit_f32(hash(hash(seed, dimension), index))
}

/// x·2⁻³² rounded down to 24 bits: below 1 even for `u32::MAX`, where rounding to nearest would give 1.
pub fn unit_f32(x: u32) -> f32 {
    (x >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// The largest `f32` not above `x`: what keeps a number below 1 below 1.
pub(super) fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}
