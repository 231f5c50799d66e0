//! What the pixels of a view show, where in the picture something lies, and photons in their pixels.

use crate::stage::Look;
use glam::Vec3;
use lampyris::Rgb;
use lampyris::geometry::Ray;
use lampyris::map::{Estimate, PhotonMap, Reader};
use lampyris::material::Class;
use lampyris::photon::Photon;
use lampyris::scene::View;
use lampyris::world::{Surface, World};
use rayon::prelude::*;
use std::ops::Range;

/// How far a photon may lie from where the eye looking at it meets a surface, as a share of the way.
const SAME: f32 = 1e-3;

/// A view with what the middle of each pixel shows, as a Z-buffer has it.
pub(crate) struct Seen<'w> {
    pub(crate) world: &'w World,
    pub(crate) view: View,
    /// Row by row; nothing where no surface with a dull lobe is seen.
    pub(crate) surfaces: Vec<Option<Surface<'w>>>,
    /// Unit vectors rightwards, downwards and forwards.
    axes: [Vec3; 3],
}

impl<'w> Seen<'w> {
    pub(crate) fn new(world: &'w World, look: Look, size: [u32; 2]) -> Seen<'w> {
        let view = look.view(size);
        let forward = (Vec3::from(look.target) - Vec3::from(look.eye)).normalize();
        let right = forward.cross(look.up).normalize();
        let dull = |x: &Surface<'w>| !x.finish.dull.is_black();
        let middle = |k: u32| view.ray((k % view.width) as f32 + 0.5, (k / view.width) as f32 + 0.5);
        let pixels = (0..view.width * view.height).into_par_iter();
        let surfaces = pixels.map(|k| world.closest(&middle(k)).filter(dull)).collect();
        Seen { world, view, surfaces, axes: [right, forward.cross(right), forward] }
    }

    /// Where a point lies in the picture [pixels from the upper left corner]; nowhere if it is not before the eye.
    pub(crate) fn project(&self, p: Vec3) -> Option<[f32; 2]> {
        let [right, down, forward] = self.axes;
        let way = p - self.view.eye();
        let depth = way.dot(forward);
        let per_pixel = 1.0 / (depth * self.view.pixel_size());
        let [width, height] = [self.view.width, self.view.height].map(|n| n as f32);
        (depth > 0.0)
            .then(|| [0.5 * width + way.dot(right) * per_pixel, 0.5 * height + way.dot(down) * per_pixel])
    }

    /// Columns and rows of the pixels that show anything of a ball; none if part of it is behind the eye.
    pub(crate) fn covered(&self, center: Vec3, radius: f32) -> [Range<u32>; 2] {
        let mut bounds = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
        for corner in 0..8 {
            let signs = [0, 1, 2].map(|bit| if corner >> bit & 1 == 1 { radius } else { -radius });
            let Some(at) = self.project(center + Vec3::from(signs)) else { return [0..0, 0..0] };
            for ([low, high], at) in bounds.iter_mut().zip(at) {
                (*low, *high) = (low.min(at), high.max(at));
            }
        }
        let within = |[low, high]: [f32; 2], end: u32| low as u32..(high.max(0.0) as u32 + 1).min(end);
        let [across, down] = bounds;
        [within(across, self.view.width), within(down, self.view.height)]
    }

    /// The radiance estimate at the middle of each pixel [cd/m²].
    pub(crate) fn estimated(&self, map: &PhotonMap, estimate: Estimate) -> Vec<Rgb> {
        let read = |reader: &mut Reader<'_>, x: &Option<Surface<'_>>| {
            x.as_ref().map_or(Rgb::BLACK, |x| reader.radiance(x))
        };
        self.surfaces.par_iter().map_init(|| Reader::new(map, estimate), read).collect()
    }

    /// Radiance of the light that photons brought, each in the pixel that it lies in and in no other [cd/m²]: a mean over pixels,
    /// without bias, since nothing around a photon counts as if it lay there.
    pub(crate) fn traced(&self, photons: &[Photon]) -> Vec<Rgb> {
        let (eye, forward) = (self.view.eye(), self.axes[2]);
        let found = |photon: &Photon| {
            let pixel = self.pixel(photon.position)?;
            let way = photon.position - eye;
            let distance2 = way.length_squared();
            let direction = way / distance2.sqrt();
            let x = self.world.closest(&Ray::new(eye, direction))?;
            if (x.position - photon.position).length_squared() > SAME * SAME * distance2 {
                return None;
            }
            // Pixels that a square metre of the surface takes up.
            let edge = self.view.pixel_size();
            let pixels = x.normal.dot(x.wo) / (distance2 * direction.dot(forward).powi(3) * edge * edge);
            Some((pixel, x.eval(Class::Dull, x.wo, photon.wi) * photon.flux * pixels))
        };
        let found: Vec<(usize, Rgb)> = photons.par_iter().filter_map(found).collect();
        let mut out = vec![Rgb::BLACK; self.surfaces.len()];
        found.into_iter().for_each(|(pixel, light)| out[pixel] += light);
        out
    }

    /// The pixel that a point lies in.
    pub(crate) fn pixel(&self, p: Vec3) -> Option<usize> {
        let [x, y] = self.project(p)?;
        let inside = x >= 0.0 && y >= 0.0 && x < self.view.width as f32 && y < self.view.height as f32;
        inside.then(|| y as usize * self.view.width as usize + x as usize)
    }

    /// Whether the eye sees a point on the side of a surface that `normal` points to.
    pub(crate) fn shows(&self, p: Vec3, normal: Vec3) -> bool {
        let way = self.view.eye() - p;
        // Lifted off its surface, by less than a thousandth of what the picture is far away.
        let off = p + normal * (1e-4 * way.length());
        way.dot(normal) > 0.0 && !self.world.tracer().blocked(off, self.view.eye())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::{CORNELL, tests::shipped};
    use lampyris::sequence::uniform;

    #[test]
    fn what_a_ray_goes_through_lies_at_its_pixel() {
        let world = shipped("cornell.mgf");
        let seen = Seen::new(&world, CORNELL, [40, 30]);
        for (x, y) in [(0.0, 0.0), (40.0, 30.0), (7.25, 21.5), (39.0, 1.0)] {
            let ray = seen.view.ray(x, y);
            let [u, v] = seen.project(ray.origin + ray.direction * 3.0).unwrap();
            assert!((u - x).abs() < 1e-3 && (v - y).abs() < 1e-3, "{x} {y}: {u} {v}");
            assert_eq!(seen.project(ray.origin - ray.direction), None);
        }
    }

    /// Pixels whose middle shows something of a ball are among those that it covers.
    #[test]
    fn a_ball_covers_what_it_covers() {
        let world = shipped("cornell.mgf");
        let seen = Seen::new(&world, CORNELL, [60, 60]);
        let (center, radius) = (Vec3::new(1.2, 0.6, 2.0), 0.7_f32);
        let [columns, rows] = seen.covered(center, radius);
        let mut some = 0;
        for k in 0..3600 {
            let ray = seen.view.ray((k % 60) as f32 + 0.5, (k / 60) as f32 + 0.5);
            let along = (center - ray.origin).dot(ray.direction);
            if (ray.origin + ray.direction * along - center).length() < radius {
                assert!(columns.contains(&(k % 60)) && rows.contains(&(k / 60)));
                some += 1;
            }
        }
        assert!(some > 50 && columns.len() * rows.len() < 4 * some, "{some} {columns:?} {rows:?}");
        let behind = seen.covered(Vec3::new(2.78, 2.73, -8.0), 0.5);
        assert_eq!(behind, [0..0, 0..0]);
    }

    /// One lumen strewn over a patch of the floor of 4 m² lights it by ¼ lx: of 10⁵ photons some twenty thousand lie in the
    /// pixels asked, whose sum is known to 0.7 %.
    #[test]
    fn photons_in_their_pixels_have_the_light_of_their_density() {
        const COUNT: u32 = 100_000;
        let world = shipped("cornell.mgf");
        let seen = Seen::new(&world, CORNELL, [80, 80]);
        let place = |k| [0, 1].map(|d| uniform(11, k, d));
        let photon = |k| {
            let [u, v] = place(k);
            let position = Vec3::new(0.2 + 2.0 * u, 0.0, 0.2 + 2.0 * v);
            Photon { position, flux: Rgb::grey(1.0 / COUNT as f32), wi: Vec3::Y, normal: Vec3::Y, emitter: 0 }
        };
        let light = seen.traced(&(0..COUNT).map(photon).collect::<Vec<_>>());
        let (mut sum, mut expected) = (0.0, 0.0);
        for (light, x) in light.iter().zip(&seen.surfaces) {
            let Some(x) = x.as_ref().filter(|x| x.normal.y > 0.9 && x.position.y < 1e-3) else { continue };
            let inside = |c: f32| (0.4..2.0).contains(&c);
            if inside(x.position.x) && inside(x.position.z) {
                sum += f64::from(light.g);
                expected += f64::from(x.finish.dull.g) * std::f64::consts::FRAC_1_PI * 0.25;
            }
        }
        assert!(expected > 1.0 && (sum / expected - 1.0).abs() < 0.03, "{sum} {expected}");
    }
}
