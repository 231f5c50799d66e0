//! Sixteen rays of one origin at once: eye rays of a 4×4 tile, or segments from a virtual point light to the points
//! that a tile sees. Sharing the origin is what makes a packet fast [Wald et al. 2002]; the answers are those of
//! single rays, bit for bit.

use super::{Hit, Ray, Tracer};
use glam::Vec3;

/// Rays in a packet.
pub const LANES: usize = 16;

/// What sixteen rays meet first; lanes outside `hit` hold zeros.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hits16 {
    /// Lanes that hit anything.
    pub hit: u16,
    /// Distance in lengths of the ray's direction.
    pub t: [f32; LANES],
    /// Barycentric weight of the triangle's second vertex.
    pub u: [f32; LANES],
    /// Barycentric weight of the triangle's third vertex.
    pub v: [f32; LANES],
    /// Which instance of the scene.
    pub instance: [u32; LANES],
    /// Which triangle of the instance's mesh.
    pub triangle: [u32; LANES],
}

impl Hits16 {
    /// What lane `i` meets.
    pub fn get(&self, i: usize) -> Option<Hit> {
        (self.hit >> i & 1 == 1).then(|| Hit {
            t: self.t[i],
            u: self.u[i],
            v: self.v[i],
            instance: self.instance[i],
            triangle: self.triangle[i],
        })
    }

    /// Nothing met.
    pub const NONE: Hits16 = Hits16 {
        hit: 0,
        t: [0.0; LANES],
        u: [0.0; LANES],
        v: [0.0; LANES],
        instance: [0; LANES],
        triangle: [0; LANES],
    };
}

impl Tracer {
    /// [`Tracer::closest`] for the lanes of `live`: half-lines from `origin` along `directions` (x, y, z of each).
    pub fn closest16(&self, origin: Vec3, directions: &[[f32; LANES]; 3], live: u16) -> Hits16 {
        let mut hits = Hits16::NONE;
        for i in lanes(live) {
            if let Some(hit) = self.closest(&Ray::new(origin, lane(directions, i))) {
                hits.hit |= 1 << i;
                hits.t[i] = hit.t;
                hits.u[i] = hit.u;
                hits.v[i] = hit.v;
                hits.instance[i] = hit.instance;
                hits.triangle[i] = hit.triangle;
            }
        }
        hits
    }

    /// [`Tracer::blocked`] for the lanes of `live`: which of the open segments from `origin` to `targets` are blocked.
    /// Fast if the targets are near each other; for shadows that makes the light the origin.
    pub fn occluded16(&self, origin: Vec3, targets: &[[f32; LANES]; 3], live: u16) -> u16 {
        lanes(live).filter(|&i| self.blocked(origin, lane(targets, i))).fold(0, |hit, i| hit | 1 << i)
    }
}

/// Numbers of the bits set.
pub(super) fn lanes(mask: u16) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |i| mask >> i & 1 == 1)
}

/// One lane of a packet of vectors.
pub(super) fn lane(vectors: &[[f32; LANES]; 3], i: usize) -> Vec3 {
    Vec3::new(vectors[0][i], vectors[1][i], vectors[2][i])
}
