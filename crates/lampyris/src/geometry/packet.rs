//! Sixteen rays of one origin at once: eye rays of a 4×4 tile, or segments from a virtual point light to the points
//! that a tile sees. Sharing the origin is what makes a packet fast [Wald et al. 2002]; the answers are those of
//! single rays, bit for bit.

use super::bvh::{End, PacketBest};
use super::tracer::{sound_direction, sound_origin};
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
}

/// What blocked last, to be asked first: one for each light. Any will do, even of another tracer.
#[derive(Clone, Copy, Debug)]
pub struct Occluder(u32);

impl Default for Occluder {
    /// Nothing.
    fn default() -> Occluder {
        Occluder(u32::MAX)
    }
}

impl Tracer {
    /// [`Tracer::closest`] for the lanes of `live`: half-lines from `origin` along `directions` (x, y, z of each).
    pub fn closest16(&self, origin: Vec3, directions: &[[f32; LANES]; 3], live: u16) -> Hits16 {
        let live = if sound_origin(origin) { live } else { 0 };
        let mut best = PacketBest::none();
        self.flat.tree.closest16(self.kernel, origin, directions, live, &mut best);
        if self.has_placed() {
            for i in lanes(live).filter(|&i| sound_direction(lane(directions, i))) {
                let mut single = best.lane(i);
                self.closest_placed(&Ray::new(origin, lane(directions, i)), &mut single);
                best.set(i, &single);
            }
        }
        for i in lanes(!best.found) {
            best.t[i] = 0.0;
        }
        let PacketBest { t, u, v, instance, triangle, found } = best;
        Hits16 { hit: found, t, u, v, instance, triangle }
    }

    /// [`Tracer::blocked`] for the lanes of `live`: which of the open segments from `origin` to `targets` are blocked.
    /// Fast if the targets are near each other; for shadows that makes the light the origin.
    pub fn occluded16(&self, origin: Vec3, targets: &[[f32; LANES]; 3], live: u16) -> u16 {
        let [blocked] = self.occluded_parts(origin, [targets], [live], &mut Occluder::default());
        blocked
    }

    /// [`Tracer::occluded16`] for several packets of one origin, whose targets may be near each other: those of some lanes,
    /// part by part. Faster where the segments resemble those that `occluder` was last given with: one light and neighbouring
    /// points. The answer does not depend on it.
    pub fn occluded_parts<const P: usize>(
        &self,
        origin: Vec3,
        targets: [&[[f32; LANES]; 3]; P],
        live: [u16; P],
        occluder: &mut Occluder,
    ) -> [u16; P] {
        let live = if sound_origin(origin) { live } else { [0; P] };
        let mut blocked = self.flat.tree.occluded_parts(self.kernel, origin, targets, live, &mut occluder.0);
        if self.has_placed() {
            for ((blocked, targets), live) in blocked.iter_mut().zip(targets).zip(live) {
                for i in lanes(live & !*blocked) {
                    let ray = Ray::between(origin, lane(targets, i));
                    let stops = sound_direction(ray.direction)
                        && self.placed_stop(&ray, End::Point(lane(targets, i)));
                    *blocked |= u16::from(stops) << i;
                }
            }
        }
        blocked
    }
}

/// Numbers of the bits set.
pub(crate) fn lanes(mask: u16) -> impl Iterator<Item = usize> {
    let mut rest = mask;
    std::iter::from_fn(move || {
        let i = rest.trailing_zeros() as usize;
        rest &= rest.wrapping_sub(1);
        (i < LANES).then_some(i)
    })
}

/// One lane of a packet of vectors.
pub(crate) fn lane(vectors: &[[f32; LANES]; 3], i: usize) -> Vec3 {
    Vec3::new(vectors[0][i], vectors[1][i], vectors[2][i])
}
