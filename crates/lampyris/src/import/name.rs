//! Names as scenes keep them: of bounded length, since nested ones would otherwise grow with the square of their depth.

/// Longest name of an object or a material [bytes].
pub(super) const NAME_BYTES: usize = 255;

/// As much of a name as is kept.
pub(super) fn clipped(name: &str) -> &str {
    let end = (0..=NAME_BYTES.min(name.len())).rev().find(|&i| name.is_char_boundary(i)).unwrap_or(0);
    &name[..end]
}
