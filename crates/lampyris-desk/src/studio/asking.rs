//! What lies behind a pixel, and what a ray meets.

use super::Stage;
use crate::event::Found;
use crate::screen::Frame;
use lampyris::Rgb;
use lampyris::geometry::Ray;
use lampyris::material::Class;
use lampyris::measuring::{Estimate, illuminance, is_readable};
use lampyris::scene::View;

impl Stage {
    /// What lies behind a pixel of a frame that was shown.
    pub(super) fn behind(
        &mut self,
        frame: &Frame,
        at: [f32; 2],
        compared: Option<&[Vec<Rgb>; 2]>,
    ) -> Option<Found> {
        let [width, height] = frame.size;
        let view = View::new(&frame.look.camera(), width, height).cut(frame.look.near);
        let mut ray = view.ray(at[0], at[1]);
        ray.origin += ray.direction * view.skipped(ray.direction);
        let mut found = self.met(&ray)?;
        if !self.session.is_current() || *frame.look != *self.look {
            return Some(found);
        }
        // The same place in the picture as it is now, whatever size the frame had.
        let place = [0, 1].map(|axis| (at[axis] * self.size[axis] as f32 / frame.size[axis] as f32) as u32);
        let pixel = place[1] as usize * self.size[0] as usize + place[0] as usize;
        let sums = self.session.frame().ok()?;
        let (radiance, factor) = (sums.at(pixel)?, sums.student_factor() * sums.standard_error(pixel));
        if sums.batches() == 0 {
            return Some(found);
        }
        let mixed = |colors: &Vec<Rgb>| illuminance(sums.at_in(pixel, colors)?, found.albedo?);
        found.change = compared.and_then(|[now, then]| Some(f64::from(mixed(now)? - mixed(then)?)));
        let luminance = f64::from(radiance.luminance());
        let error = Some(f64::from(factor)).filter(|error| error.is_finite());
        found.luminance = Some(Estimate { value: luminance, error });
        let lux = found.albedo.and_then(|albedo| illuminance(radiance, albedo)).map(f64::from);
        let scale = |lux: f64| error.filter(|_| luminance > 0.0).map(|error| error / luminance * lux);
        found.lux = lux.map(|lux| Estimate { value: lux, error: scale(lux) });
        Some(found)
    }

    /// What a ray meets first.
    pub(super) fn met(&self, ray: &Ray) -> Option<Found> {
        let world = self.session.world().ok()?;
        let surface = world.closest(ray)?;
        Some(Found {
            point: surface.position,
            normal: surface.normal,
            instance: surface.instance,
            material: surface.material,
            emitter: world.emitter_of(&surface),
            albedo: is_readable(&world.scene().materials[surface.material as usize])
                .then(|| surface.albedo(Class::Dull) + surface.albedo(Class::Sharp)),
            lux: None,
            luminance: None,
            change: None,
        })
    }
}
