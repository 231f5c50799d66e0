//! What a surface receives, and reflects, by the photons around a point: Σ f_r Φ k(d/r)/(πr²) over those that lie on that
//! surface [Keller96, §4.2; Jarosz05, eq. 9].
//!
//! The radius is fixed [Keller96], or that of the n-th nearest photon [Jarosz05, §2.3]. That photon sets the radius and is
//! not counted itself: given r, the n − 1 inside lie as if they were all that is known, and 1/r² of the n-th has the mean
//! that makes (n − 1)/(πr²) the density; n/(πr²) would be too bright by n/(n − 1). A limit of the radius,
//! which holds where it meets K < n photons, keeps the mean: the nearest bring P(K ≥ n − 1) of it, the limit P(K ≤ n − 2).
//!
//! Photons on other surfaces are no matter of this one, and do not count toward n: those on the other side of a thin wall,
//! on walls that meet this one, or that lie steeply above or below.

use super::PhotonMap;
use super::direction::CoarseNormal;
use super::kernel::Kernel;
use super::photon::Photon;
use super::search::Nearest;
use crate::color::Rgb;
use crate::material::Class;
use crate::world::Surface;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// Cosine between normals from which on they are of one surface: 45°, to within what a photon keeps of its own.
const SAME_SIDE: f32 = 0.7;

/// Sine of the angle, seen from the point, between a photon and the plane, up to which it lies on the same surface: 30°.
const SAME_PLANE: f32 = 0.5;

/// Which photons tell the light at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// All that are not farther away [m].
    Within(f32),
    /// So many of the nearest, of those not farther than a radius [m].
    Nearest {
        /// How many, of which the farthest tells the area alone; more than one.
        count: u32,
        /// Where there are fewer, the radius is this.
        within: f32,
    },
}

/// How light is estimated from photons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// How much they count.
    pub kernel: Kernel,
    /// Which of them.
    pub reach: Reach,
}

/// Reads light from a map; each thread has its own.
#[derive(Clone, Debug)]
pub struct Reader<'m> {
    map: &'m PhotonMap,
    estimate: Estimate,
    nearest: Nearest,
}

/// Where light is asked for.
#[derive(Clone, Copy)]
struct Place {
    position: Vec3,
    normal: Vec3,
    code: CoarseNormal,
    /// Photons on the other side count too: the surface transmits light.
    both_sides: bool,
}

impl Place {
    fn new(position: Vec3, normal: Vec3) -> Place {
        Place { position, normal, code: normal.into(), both_sides: false }
    }

    /// Whether a photon lies on the surface.
    #[inline]
    fn holds(&self, photon: &Photon, distance2: f32) -> bool {
        let above = (photon.position() - self.position).dot(self.normal);
        if above * above > SAME_PLANE * SAME_PLANE * distance2 {
            return false;
        }
        if photon.normal() == self.code {
            return true;
        }
        let cosine = Vec3::from(photon.normal()).dot(self.normal);
        if self.both_sides { cosine.abs() >= SAME_SIDE } else { cosine >= SAME_SIDE }
    }
}

impl PhotonMap {
    /// Calls `take` with each photon within `radius` [m] on the side of a surface that the unit `normal` points to.
    pub fn on_surface(&self, x: Vec3, normal: Vec3, radius: f32, mut take: impl FnMut(&Photon)) {
        self.on_surface_while(x, normal, radius, |photon| {
            take(photon);
            true
        });
    }

    /// [`Self::on_surface`] as long as `take` says.
    pub(super) fn on_surface_while(
        &self,
        x: Vec3,
        normal: Vec3,
        radius: f32,
        mut take: impl FnMut(&Photon) -> bool,
    ) {
        let place = Place::new(x, normal);
        self.within_while(x, radius, |_, photon, distance2| !place.holds(photon, distance2) || take(photon));
    }
}

impl<'m> Reader<'m> {
    /// Reads a map so.
    pub fn new(map: &'m PhotonMap, estimate: Estimate) -> Reader<'m> {
        let most = match estimate.reach {
            Reach::Within(_) => 0,
            // More than there are would not be found, and would cost memory.
            Reach::Nearest { count, .. } => (count.max(2) as usize).min(map.photons().len() + 1),
        };
        Reader { map, estimate, nearest: Nearest::new(most) }
    }

    /// The map that is read.
    pub fn map(&self) -> &'m PhotonMap {
        self.map
    }

    /// Illuminance of the side of a surface that the unit `normal` points to [lx].
    pub fn irradiance(&mut self, x: Vec3, normal: Vec3) -> Rgb {
        self.sum(&Place::new(x, normal), Photon::flux)
    }

    /// Radiance that the dull lobes of `x` send toward its `wo` [cd/m²].
    pub fn radiance(&mut self, x: &Surface<'_>) -> Rgb {
        match x.finish.lambertian {
            Some(rho) => rho * FRAC_1_PI * self.irradiance(x.position, x.normal),
            None => self.reflected(x, |wi| x.eval(Class::Dull, x.wo, wi)),
        }
    }

    /// Radiance that all lobes of `x` send toward its `wo`, save those that are mirrors or clear glass [cd/m²]: by the full f_r
    /// [Keller96, §4.3, specular effects at the maximum level].
    pub fn full_radiance(&mut self, x: &Surface<'_>) -> Rgb {
        self.reflected(x, |wi| x.eval(Class::Dull, x.wo, wi) + x.eval(Class::Sharp, x.wo, wi))
    }

    fn reflected(&mut self, x: &Surface<'_>, f_r: impl Fn(Vec3) -> Rgb) -> Rgb {
        let place = Place::new(x.position, x.normal);
        self.sum(&Place { both_sides: x.finish.transmits, ..place }, |p| f_r(p.wi()) * p.flux())
    }

    /// Σ light · k/(πr²) over the photons of a place.
    fn sum(&mut self, place: &Place, light: impl Fn(&Photon) -> Rgb) -> Rgb {
        let Estimate { kernel, reach } = self.estimate;
        let mut sum = Rgb::BLACK;
        let radius = match reach {
            Reach::Within(radius) => radius,
            Reach::Nearest { within, .. } => within,
        };
        let radius2 = (radius * radius).max(Kernel::LEAST_RADIUS2);
        if let Reach::Within(_) = reach {
            let per_square = 1.0 / radius2;
            self.map.within(place.position, radius, |_, photon, distance2| {
                if place.holds(photon, distance2) {
                    sum += light(photon) * kernel.weight(distance2 * per_square);
                }
            });
            return sum * Kernel::per_area(radius2);
        }
        let Reader { map, nearest, .. } = self;
        map.nearest(place.position, radius, nearest, |_, photon, distance2| place.holds(photon, distance2));
        let full = nearest.is_full();
        let farthest = nearest.found().next().map_or(0.0, |(_, distance2)| distance2);
        let radius2 = if full { farthest.max(Kernel::LEAST_RADIUS2) } else { radius2 };
        let per_square = 1.0 / radius2;
        for (number, distance2) in nearest.found().skip(usize::from(full)) {
            sum += light(&map.photons()[number as usize]) * kernel.weight(distance2 * per_square);
        }
        sum * Kernel::per_area(radius2)
    }
}
