//! What the pixels of a view show, and where in the picture something lies.

use crate::stage::Look;
use glam::Vec3;
use lampyris::scene::View;
use lampyris::world::{Surface, World};
use rayon::prelude::*;
use std::ops::Range;

/// A view with what the middle of each pixel shows, as a Z-buffer has it.
pub(super) struct Seen<'w> {
    pub(super) world: &'w World,
    pub(super) view: View,
    /// Row by row; nothing where no surface with a dull lobe is seen.
    pub(super) surfaces: Vec<Option<Surface<'w>>>,
    /// Unit vectors rightwards, downwards and forwards.
    axes: [Vec3; 3],
}

impl<'w> Seen<'w> {
    pub(super) fn new(world: &'w World, look: Look, size: [u32; 2]) -> Seen<'w> {
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
    pub(super) fn project(&self, p: Vec3) -> Option<[f32; 2]> {
        let [right, down, forward] = self.axes;
        let way = p - self.view.eye();
        let depth = way.dot(forward);
        let per_pixel = 1.0 / (depth * self.view.pixel_size());
        let [width, height] = [self.view.width, self.view.height].map(|n| n as f32);
        (depth > 0.0)
            .then(|| [0.5 * width + way.dot(right) * per_pixel, 0.5 * height + way.dot(down) * per_pixel])
    }

    /// Columns and rows of the pixels that show anything of a ball; none if part of it is behind the eye.
    pub(super) fn covered(&self, center: Vec3, radius: f32) -> [Range<u32>; 2] {
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

    /// Whether the eye sees a point on the side of a surface that `normal` points to.
    pub(super) fn shows(&self, p: Vec3, normal: Vec3) -> bool {
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
}
