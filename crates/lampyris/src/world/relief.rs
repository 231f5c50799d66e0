//! Normal maps: a texture's normals turned into the frame of a triangle.
//!
//! The frame is that of glTF: red points along the texture's first coordinate, green against its second (up, as the
//! picture is looked at), blue along the shading normal. A map's normal is kept on the front side of the triangle, as
//! far as [`LEAST`]: behind it everything would be black. Where one looks from does not matter for it: paths from the
//! light and from the eye must find the same surface.

use crate::material::Map;
use crate::scene::Spot;
use glam::{Affine3A, Vec2, Vec3};

/// Least cosine between a map's normal and the triangle's.
const LEAST: f32 = 0.05;

/// The unit normal that a map makes of `shading`; both on the front side, whose geometric normal is `normal`.
pub(super) fn bent(
    spot: &Spot<'_>,
    (map, strength): &(Map, f32),
    transform: &Affine3A,
    corners: &[Vec3; 3],
    normal: Vec3,
    shading: Vec3,
) -> Vec3 {
    let Some([r, g, b, _]) = spot.look(map) else { return shading };
    let Some((along, up)) = frame(spot, map, transform, corners, shading) else { return shading };
    let local = Vec3::new((2.0 * r - 1.0) * strength, (2.0 * g - 1.0) * strength, 2.0 * b - 1.0);
    let bent = (along * local.x + up * local.y + shading * local.z).normalize_or(shading);
    in_front(bent, normal)
}

/// Unit tangent and bitangent at right angles to the shading normal; `None` where the coordinates have no direction.
fn frame(
    spot: &Spot<'_>,
    map: &Map,
    transform: &Affine3A,
    corners: &[Vec3; 3],
    shading: Vec3,
) -> Option<(Vec3, Vec3)> {
    if let Some((tangent, sign)) = spot.tangent() {
        let along = transform.transform_vector3(tangent);
        let along = (along - shading * shading.dot(along)).try_normalize()?;
        let mirror = if transform.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        return Some((along, shading.cross(along) * (sign * mirror)));
    }
    let [a, b, c] = spot.corners(map)?;
    let (e, f) = (corners[1] - corners[0], corners[2] - corners[0]);
    let (d, g): (Vec2, Vec2) = (b - a, c - a);
    let area = d.perp_dot(g);
    let along = (e * g.y - f * d.y) * area.signum();
    let down = (f * d.x - e * g.x) * area.signum();
    let along = (along - shading * shading.dot(along)).try_normalize()?;
    let up = shading.cross(along);
    (area != 0.0).then_some((along, if up.dot(down) > 0.0 { -up } else { up }))
}

/// The nearest direction whose cosine with `normal` is [`LEAST`] or more.
fn in_front(bent: Vec3, normal: Vec3) -> Vec3 {
    let cosine = bent.dot(normal);
    if cosine >= LEAST {
        return bent;
    }
    let aside = (bent - normal * cosine).normalize_or_zero();
    (aside * (1.0 - LEAST * LEAST).sqrt() + normal * LEAST).normalize_or(normal)
}
