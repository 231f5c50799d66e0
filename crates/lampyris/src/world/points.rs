//! Sixteen plain surface points at once: what `World::surface` and `Surface::spawn` find one by one, to the bit, laid
//! out for the gather. Flat facets alone; a bent normal is a matter of one lane.

use super::World;
use crate::geometry::{ERROR, Hits16, LANES, Wide, away, lanes};
use glam::Vec3;

/// One value of each lane for each axis.
type Vectors = [[f32; LANES]; 3];

/// Points of flat facets seen along rays.
pub struct Points {
    /// Where rays leave on the side from which the point is seen [m].
    pub position: Vectors,
    /// Unit geometric normals on that side.
    pub normal: Vectors,
    /// 1 where that is the front, else −1.
    pub side: [f32; LANES],
}

impl World {
    /// The points that sixteen rays meet, as if all facets were flat; lanes outside `of` hold nothing of use.
    pub fn points16(&self, directions: &Vectors, hits: &Hits16, of: u16) -> Points {
        let (mut corners, mut mirror) = ([[[0.0_f32; LANES]; 3]; 3], [1.0_f32; LANES]);
        // Neighbours often meet the same triangle.
        let (mut last, mut facet, mut turn) = ((u32::MAX, u32::MAX), [Vec3::ZERO; 3], 1.0);
        for k in lanes(of) {
            let (instance, triangle) = (hits.instance[k], hits.triangle[k]);
            if last != (instance, triangle) {
                last = (instance, triangle);
                facet = self.facets.corners(instance, triangle);
                turn = self.facets.mirror(instance);
            }
            for (corner, all) in facet.iter().zip(&mut corners) {
                (0..3).for_each(|axis| all[axis][k] = corner[axis]);
            }
            mirror[k] = turn;
        }
        self.tracer.kernel().run(Place { directions, hits, corners: &corners, mirror: &mirror })
    }
}

/// Points on sixteen triangles.
struct Place<'a> {
    directions: &'a Vectors,
    hits: &'a Hits16,
    corners: &'a [Vectors; 3],
    mirror: &'a [f32; LANES],
}

impl Wide for Place<'_> {
    type Out = Points;

    #[inline(always)]
    fn run(self) -> Points {
        let Place { directions: [dx, dy, dz], hits, corners, mirror } = self;
        let mut normal = normals(corners);
        for axis in &mut normal {
            (0..LANES).for_each(|k| axis[k] *= mirror[k]);
        }
        let side: [f32; LANES] = std::array::from_fn(|k| {
            let toward = -dx[k] * normal[0][k] + -dy[k] * normal[1][k] + -dz[k] * normal[2][k];
            if toward >= 0.0 { 1.0 } else { -1.0 }
        });
        let (mut position, mut error) = ([[0.0_f32; LANES]; 3], [[0.0_f32; LANES]; 3]);
        for axis in 0..3 {
            for k in 0..LANES {
                let (u, v) = (hits.u[k], hits.v[k]);
                let a = corners[0][axis][k] * (1.0 - u - v);
                let (b, c) = (corners[1][axis][k] * u, corners[2][axis][k] * v);
                position[axis][k] = a + b + c;
                error[axis][k] = (a.abs() + b.abs() + c.abs()) * ERROR;
                normal[axis][k] *= side[k];
            }
        }
        let reach: [f32; LANES] = std::array::from_fn(|k| {
            error[0][k] * normal[0][k].abs()
                + error[1][k] * normal[1][k].abs()
                + error[2][k] * normal[2][k].abs()
        });
        for axis in 0..3 {
            for k in 0..LANES {
                position[axis][k] = away(position[axis][k], normal[axis][k] * reach[k]);
            }
        }
        Points { position, normal, side }
    }
}

/// Unit normals, as by `normalize_or_zero` of the cross product of two edges.
#[inline(always)]
fn normals(corners: &[Vectors; 3]) -> Vectors {
    let mut normal = [[0.0; LANES]; 3];
    let edge = |end: usize, axis: usize, k: usize| corners[end][axis][k] - corners[0][axis][k];
    for k in 0..LANES {
        let (bx, by, bz) = (edge(1, 0, k), edge(1, 1, k), edge(1, 2, k));
        let (cx, cy, cz) = (edge(2, 0, k), edge(2, 1, k), edge(2, 2, k));
        let (x, y, z) = (by * cz - cy * bz, bz * cx - cz * bx, bx * cy - cx * by);
        let reciprocal = 1.0 / (x * x + y * y + z * z).sqrt();
        let sound = reciprocal < f32::INFINITY && reciprocal > 0.0;
        let scale = |v: f32| if sound { v * reciprocal } else { 0.0 };
        normal.iter_mut().zip([x, y, z]).for_each(|(axis, v)| axis[k] = scale(v));
    }
    normal
}

#[cfg(test)]
mod tests {
    use crate::geometry::LANES;
    use crate::import::{self, Options};
    use crate::scene::{Camera, View};
    use crate::world::World;
    use glam::Vec3;
    use std::path::Path;

    #[test]
    fn sixteen_points_are_single_points() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
        let world = World::new(import::load(Path::new(file), &Options::default()).unwrap().scene);
        let bounds = world.bounds();
        let mut compared = 0;
        for k in 0..16 {
            let target = bounds.center + Vec3::new(k as f32 - 8.0, (k * 5 % 16) as f32 - 8.0, (k % 3) as f32);
            let camera = Camera { name: String::new(), eye: bounds.center, target, up: Vec3::Y, fov_y: 70.0 };
            let view = View::new(&camera, 16, 16);
            for row in 0..16 {
                let (x, y) = (std::array::from_fn(|i| i as f32 + 0.3), [row as f32 + 0.6; LANES]);
                let directions = view.directions(&x, &y);
                let hits = world.tracer().closest16(view.eye(), &directions, u16::MAX);
                let points = world.points16(&directions, &hits, hits.hit);
                for i in 0..LANES {
                    let Some(hit) = hits.get(i) else { continue };
                    let ray = view.ray(x[i], y[i]);
                    assert_eq!(ray.direction, Vec3::from(directions.map(|axis| axis[i])));
                    let s = world.surface(ray.direction, &hit);
                    assert_eq!(s.spawn(s.wo), Vec3::from(points.position.map(|axis| axis[i])));
                    assert_eq!(s.normal, Vec3::from(points.normal.map(|axis| axis[i])));
                    assert_eq!(s.front, points.side[i] == 1.0);
                    compared += 1;
                }
            }
        }
        assert!(compared > 2000, "{compared}");
    }
}
