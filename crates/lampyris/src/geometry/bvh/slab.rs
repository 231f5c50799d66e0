//! The line of a ray against boxes, by slabs [Kay and Kajiya 1986], made conservative in two ways: distances are padded
//! for their own rounding [Ize 2013], and the boxes are widened by what the shear of the watertight triangle test may
//! move a corner. A box is never missed that holds a triangle the ray hits; some are entered for nothing.

use super::build::Bounds;
use super::triangle::largest_axis;
use glam::Vec3;

/// Far distances are stretched by 1 + 2·γ(3). [Ize 2013]
pub(super) const STRETCH: f32 = 1.0 + 2.0 * (3.0 * f32::EPSILON / 2.0) * 1.000_001;

/// Fraction of the largest distance to a corner by which shear and rounding may move it: the shear moves x by at most
/// 2⁻²⁴·(2|x| + 5|z|) ≤ 9·2⁻²⁴ of it, computed distances err as much along z; doubled for the rounding of the rest.
const WIDENING: f32 = 18.0 * f32::EPSILON;

/// A line prepared for boxes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slab {
    /// Origin for the planes of the lower and of the upper corners: apart by the widening.
    pub(super) origin: [[f32; 3]; 2],
    /// 1 / direction, never infinite.
    pub(super) inverse: [f32; 3],
    /// By how much a computed distance may fall short of its box.
    pub(super) slack: f32,
    /// By how much boxes are widened.
    pub(super) widening: f32,
}

impl Slab {
    /// `bounds` hold all boxes; `error` bounds what `origin` lacks in precision.
    #[inline(always)]
    pub(crate) fn new(origin: Vec3, direction: Vec3, bounds: &Bounds, error: f32) -> Slab {
        let reach = (bounds.lower - origin).abs().max((bounds.upper - origin).abs()).max_element();
        let widening = reach * WIDENING + error;
        // The sum is rounded too.
        let apart = Vec3::splat(widening) + origin.abs() * f32::EPSILON;
        let d = direction.to_array();
        let kz = largest_axis(d);
        let inverse = d.map(|component| Slab::inverse(component, d[kz].abs()));
        Slab {
            origin: [(origin + apart).to_array(), (origin - apart).to_array()],
            inverse,
            widening,
            slack: widening * inverse[kz].abs(),
        }
    }

    /// A direction almost in the plane of a slab counts as this much of the largest: within the widening of any box.
    pub(super) const LEAST: f32 = 1.0 / 18_446_744_073_709_551_616.0;

    #[inline(always)]
    fn inverse(component: f32, largest: f32) -> f32 {
        let least = largest * Slab::LEAST;
        let size = component.abs();
        1.0 / if size < least { least } else { size }.copysign(component)
    }

    /// Bounds the distance to any corner along each axis; nothing is known of those that are moved.
    #[inline(always)]
    pub(super) fn reach(&self, moved: bool) -> f32 {
        if moved { f32::INFINITY } else { self.widening * (1.0 / WIDENING) * (1.0 + 4.0 * f32::EPSILON) }
    }

    /// Distances at which the line enters and leaves a box; it misses where the first exceeds the second.
    pub(super) fn span(&self, lower: [f32; 3], upper: [f32; 3]) -> (f32, f32) {
        let (mut enter, mut leave) = (0f32, f32::INFINITY);
        for axis in 0..3 {
            let to_lower = (lower[axis] - self.origin[0][axis]) * self.inverse[axis];
            let to_upper = (upper[axis] - self.origin[1][axis]) * self.inverse[axis];
            let (near, far) =
                if self.inverse[axis] < 0.0 { (to_upper, to_lower) } else { (to_lower, to_upper) };
            enter = if near > enter { near } else { enter };
            leave = if far < leave { far } else { leave };
        }
        (enter, leave * STRETCH)
    }
}
