//! Photons drawn: as discs and as points.

use crate::seen::Seen;
use glam::Vec3;
use lampyris::Rgb;
use lampyris::map::{Kernel, Photon};
use lampyris::material::Class;
use lampyris::world::Surface;
use rayon::prelude::*;
use std::f32::consts::FRAC_1_PI;

/// How much farther away than the surface a disc may be and be drawn still, as a share of the way: discs lie in surfaces.
const OFFSET: f32 = 1e-4;

/// Rows of the picture that a thread draws at a time.
const ROWS: usize = 8;

impl Seen<'_> {
    /// Every photon as a disc that lies on its surface, its flux over the area of the disc, as far as nothing is before it
    /// [Jarosz05, §3.2.2 and eq. 13]. What a disc hides it shines on: where it leaves its surface that is the haze of §5.2.
    pub(super) fn discs(&self, photons: &[Photon], kernel: Kernel, radius: f32) -> Vec<Rgb> {
        let width = self.view.width as usize;
        let covered: Vec<_> = photons.par_iter().map(|p| self.covered(p.position(), radius)).collect();
        let mut out = vec![Rgb::BLACK; self.surfaces.len()];
        out.par_chunks_mut(ROWS * width).enumerate().for_each(|(band, out)| {
            let first = band * ROWS;
            let rows = first as u32..(first + out.len() / width) as u32;
            for (photon, [columns, of_disc]) in photons.iter().zip(&covered) {
                let disc = Disc::new(photon, kernel, radius);
                for y in of_disc.start.max(rows.start)..of_disc.end.min(rows.end) {
                    for x in columns.clone() {
                        let pixel = y as usize * width + x as usize;
                        if let Some(surface) = &self.surfaces[pixel] {
                            out[pixel - first * width] += disc.light(surface, self.view.eye());
                        }
                    }
                }
            }
        });
        out
    }

    /// Every photon that the eye sees in the pixel that it lies in, all alike, so bright that the picture has a mean luminance.
    pub(super) fn points(&self, photons: &[Photon], mean: f64) -> Vec<Rgb> {
        let shown = |p: &&Photon| self.shows(p.position(), p.normal().into());
        let pixel = |p: &Photon| self.pixel(p.position());
        let pixels: Vec<usize> = photons.par_iter().filter(shown).filter_map(pixel).collect();
        let mut out = vec![Rgb::BLACK; self.surfaces.len()];
        let each = Rgb::grey((mean * out.len() as f64 / pixels.len().max(1) as f64) as f32);
        pixels.into_iter().for_each(|pixel| out[pixel] += each);
        out
    }
}

/// A photon with room around it.
struct Disc<'a> {
    photon: &'a Photon,
    center: Vec3,
    normal: Vec3,
    kernel: Kernel,
    radius2: f32,
}

impl Disc<'_> {
    fn new(photon: &Photon, kernel: Kernel, radius: f32) -> Disc<'_> {
        Disc {
            photon,
            center: photon.position(),
            normal: photon.normal().into(),
            kernel,
            radius2: radius * radius,
        }
    }

    /// Radiance that a pixel whose middle shows a surface gains by it [cd/m²].
    fn light(&self, x: &Surface<'_>, eye: Vec3) -> Rgb {
        let cosine = self.normal.dot(x.wo);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        let way = self.normal.dot(eye - self.center) / cosine;
        let away = eye - x.wo * way - self.center;
        let distance2 = away.length_squared();
        if distance2 > self.radius2 || way <= 0.0 || way > (1.0 + OFFSET) * (eye - x.position).length() {
            return Rgb::BLACK;
        }
        let per_area = FRAC_1_PI / self.radius2;
        let brdf = x.eval(Class::Dull, x.wo, self.photon.wi());
        brdf * self.photon.flux() * (self.kernel.weight(distance2 / self.radius2) * per_area)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::{CORNELL, tests::shipped};
    use lampyris::map::{Estimate, Past, PhotonMap, Reach};
    use lampyris::sequence::uniform;

    /// Photons strewn over the floor: on a plane the estimate of fixed radius is the sum of the discs, by every kernel. Sums of
    /// some dozen terms in two orders differ by less than 1e-5 of them, and where a ray of 10 m ends is rounded to 1e-5 of the
    /// radius, which changes a weight by less than 1e-4. At a rim rounding may put a photon in or out: of 10⁶ pairs of
    /// photon and pixel one or two.
    #[test]
    fn a_fixed_radius_is_a_disc_for_each_photon() {
        let world = shipped("cornell.mgf");
        let seen = Seen::new(&world, CORNELL, [96, 96]);
        let photon = |k: u32| {
            let [u, v, w] = [0, 1, 2].map(|d| uniform(3, k, d));
            let from = Vec3::new(w - 0.5, 1.0, 0.3).normalize();
            let flux = Rgb::new(1.0, 0.5 + 0.5 * w, 0.2);
            Photon::new(Vec3::new(5.0 * u, 0.0, 5.0 * v), Vec3::Y, from, flux, Past::default())
        };
        let map = PhotonMap::new((0..2000).map(photon).collect());
        for kernel in Kernel::ALL {
            let estimate = Estimate { kernel, reach: Reach::Within(0.4) };
            let estimated = seen.estimated(&map, estimate);
            let discs = seen.discs(map.photons(), kernel, 0.4);
            let floor = |k: &usize| {
                seen.surfaces[*k].as_ref().is_some_and(|x| x.normal == Vec3::Y && x.position.y < 1e-3)
            };
            let pixels: Vec<usize> = (0..estimated.len()).filter(floor).collect();
            // What a photon of weight 1 adds to a white floor.
            let one = FRAC_1_PI * FRAC_1_PI / (0.4 * 0.4);
            let off = |k: &&usize| {
                let [a, b] = [discs[**k].g, estimated[**k].g];
                (a - b).abs() > 1e-5 * b + 1e-4 * one
            };
            let lit = pixels.iter().filter(|k| estimated[**k].g > 0.0).count();
            let differ = pixels.iter().filter(off).count();
            assert!(lit > 500 && differ <= 2, "{kernel:?}: {differ} of {lit}");
        }
    }

    /// Points keep the light that they are given, and lie where their photons do.
    #[test]
    fn points_lie_where_photons_do() {
        let world = shipped("cornell.mgf");
        let seen = Seen::new(&world, CORNELL, [50, 50]);
        let at = Vec3::new(4.5, 0.0, 0.5);
        let photon = |p, n| Photon::new(p, n, n, Rgb::WHITE, Past::default());
        // The second lies behind a wall, the third on a side that is turned away.
        let photons =
            [photon(at, Vec3::Y), photon(Vec3::new(1.0, 1.0, 7.0), Vec3::NEG_Z), photon(at, Vec3::NEG_Y)];
        let points = seen.points(&photons, 3.0);
        let [x, y] = seen.project(at).unwrap().map(|c| c as usize);
        for (k, light) in points.iter().enumerate() {
            assert_eq!(light.g > 0.0, k == 50 * y + x, "{k}");
        }
        assert!((points[50 * y + x].g - 3.0 * 2500.0).abs() < 0.01);
    }
}
