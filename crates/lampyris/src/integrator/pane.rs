//! A planar mirror as sixteen points look through it: what lies behind is seen as through a window.

use super::pick::Window;
use crate::eye::{LANES, Packet};
use crate::geometry::{Kernel, Wide, lane, lanes};
use crate::world::Mirror;
use glam::Vec3;

/// A mirror, and where the points of a packet are in its coordinates.
pub(super) struct Pane<'a> {
    mirror: &'a Mirror,
    places: [[f32; LANES]; 3],
    /// The box around those of live lanes.
    bounds: [Vec3; 2],
}

impl<'a> Pane<'a> {
    pub(super) fn new(kernel: Kernel, mirror: &'a Mirror, p: &Packet<'_>) -> Pane<'a> {
        let places = kernel.run(Places { mirror, points: &p.position });
        let around = |[low, high]: [Vec3; 2], k: usize| {
            let place = lane(&places, k);
            [low.min(place), high.max(place)]
        };
        let bounds = lanes(p.live).fold([Vec3::INFINITY, Vec3::NEG_INFINITY], around);
        Pane { mirror, places, bounds }
    }

    /// The box around all points, in the mirror's coordinates.
    pub(super) fn bounds(&self) -> [Vec3; 2] {
        self.bounds
    }

    /// False only if none of the points sees an image at `position` through the mirror.
    pub(super) fn may_show_any(&self, position: Vec3) -> bool {
        self.mirror.may_be_crossed_from(self.bounds, self.mirror.local(position))
    }
}

impl Window for Pane<'_> {
    #[inline(always)]
    fn place(&self, light: Vec3) -> Vec3 {
        self.mirror.local(light)
    }

    #[inline(always)]
    fn may_show(&self, k: usize, light: Vec3) -> bool {
        let [x, y, z] = &self.places;
        self.mirror.may_be_crossed_between(Vec3::new(x[k], y[k], z[k]), light)
    }
}

struct Places<'a> {
    mirror: &'a Mirror,
    points: &'a [[f32; LANES]; 3],
}

impl Wide for Places<'_> {
    type Out = [[f32; LANES]; 3];

    #[inline(always)]
    fn run(self) -> [[f32; LANES]; 3] {
        let [x, y, z] = self.points;
        let mut places = [[0.0; LANES]; 3];
        for k in 0..LANES {
            let place = self.mirror.local(Vec3::new(x[k], y[k], z[k]));
            (places[0][k], places[1][k], places[2][k]) = (place.x, place.y, place.z);
        }
        places
    }
}
