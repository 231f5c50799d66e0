//! Virtual lights as they appear behind a planar mirror [Keller97, §4.2], laid out for a look at sixteen at once.

use super::Beacon;
use crate::geometry::{Kernel, LANES, Wide, lanes, positive};
use crate::world::Mirror;
use glam::Vec3;

/// The images of a class's virtual lights in one mirror.
#[derive(Clone, Debug)]
pub struct Reflected {
    /// The mirror's number.
    pub mirror: u8,
    /// For picking, in the order of the lights. Those that shine away from the mirror have none.
    images: Vec<Beacon>,
    /// The number in its class of the light that each is of.
    of: Vec<u32>,
    /// Where they are in the mirror's coordinates, sixteen to an entry, x y z. What is left over lies in the plane.
    places: Vec<[[f32; LANES]; 3]>,
}

impl Reflected {
    /// The images of some lights in mirror number `number`.
    pub fn new(number: u8, mirror: &Mirror, beacons: &[Beacon]) -> Reflected {
        let before = |b: &Beacon| b.weight > 0.0 && mirror.may_be_before(b.position, b.normal);
        let of: Vec<u32> = (0..).zip(beacons).filter(|(_, b)| before(b)).map(|(k, _)| k).collect();
        let image = |k: &u32| {
            let b = beacons[*k as usize];
            let (position, normal) = (mirror.image(b.position), mirror.turned(b.normal));
            Beacon { position, normal, weight: b.weight * mirror.strength(), bound: b.bound }
        };
        let images: Vec<Beacon> = of.iter().map(image).collect();
        let mut places = vec![[[0.0; LANES]; 3]; images.len().div_ceil(LANES)];
        for (k, image) in images.iter().enumerate() {
            let place = mirror.local(image.position);
            (0..3).for_each(|axis| places[k / LANES][axis][k % LANES] = place[axis]);
        }
        Reflected { mirror: number, images, of, places }
    }

    /// Those images that some point of a box, in the mirror's coordinates, may see through the rectangle around the mirror,
    /// each with the number of its light in the class: none is left out that any point sees.
    pub fn seen_from(&self, kernel: Kernel, mirror: &Mirror, points: [Vec3; 2]) -> (Vec<Beacon>, Vec<u32>) {
        let (mut images, mut of) = (Vec::new(), Vec::new());
        for (run, places) in self.places.iter().enumerate() {
            for k in lanes(positive(&kernel.run(Seen { mirror, points, places }))) {
                images.push(self.images[run * LANES + k]);
                of.push(self.of[run * LANES + k]);
            }
        }
        (images, of)
    }
}

/// 1 for each of sixteen places that may be seen, else 0.
struct Seen<'a> {
    mirror: &'a Mirror,
    points: [Vec3; 2],
    places: &'a [[f32; LANES]; 3],
}

impl Wide for Seen<'_> {
    type Out = [f32; LANES];

    #[inline(always)]
    fn run(self) -> [f32; LANES] {
        let [x, y, z] = self.places;
        let mut seen = [0.0; LANES];
        for k in 0..LANES {
            let may = self.mirror.may_be_crossed_from(self.points, Vec3::new(x[k], y[k], z[k]));
            seen[k] = if may { 1.0 } else { 0.0 };
        }
        seen
    }
}
