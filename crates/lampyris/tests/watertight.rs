//! No ray leaves a closed mesh [Woop et al. 2013]: aimed at edges and vertices, where tests that are not watertight
//! leak most, and at random; at the origin, far from it, tiny and huge; by every kernel this machine has.

#![expect(clippy::needless_range_loop, reason = "lanes run through several arrays")]

mod common;

use common::{Rng, Shape, kernels, shapes, tracer};
use glam::Vec3;
use lampyris::geometry::{Kernel, LANES, Ray, Tracer};
use rayon::prelude::*;

/// Scales and offsets of the meshes: the second is the far point of Embree's own test.
const PLACES: [(f32, Vec3); 4] = [
    (1.0, Vec3::ZERO),
    (1.0, Vec3::new(148_376.0, 1_234.0, -223_423.0)),
    (1e-4, Vec3::ZERO),
    (1e4, Vec3::ZERO),
];

/// A point on the mesh: a corner, a point of an edge, or of a face.
fn target(shape: &Shape, rng: &mut Rng) -> Vec3 {
    let triangle = shape.triangles[rng.below(shape.triangles.len())];
    let [a, b, c] = triangle.map(|v| shape.positions[v as usize]);
    let (u, v) = (rng.unit(), rng.unit());
    match rng.below(3) {
        0 => a,
        1 => a + (b - a) * u,
        _ => a + (b - a) * (u * (1.0 - v)) + (c - a) * v,
    }
}

/// Rays that leave a mesh from points inside.
fn leaks(tracer: &Tracer, shape: &Shape, rays: usize, seed: u32) -> usize {
    let mut rng = Rng::new(seed);
    let mut leaks = 0;
    for _ in 0..rays.div_ceil(LANES) {
        let inside = shape.centre + (rng.vector() - Vec3::splat(0.5)) * (shape.inside * 2.0);
        let mut directions = [[0.0; LANES]; 3];
        // Every other packet is narrow, as those of a renderer are.
        let narrow = rng.below(2) == 0;
        let around = target(shape, &mut rng);
        for i in 0..LANES {
            let at = if narrow && i % 2 == 1 {
                around + (rng.vector() - 0.5) * shape.inside
            } else {
                target(shape, &mut rng)
            };
            let d = at - inside;
            let d = if i == 0 { Vec3::AXES[rng.below(3)] * (if narrow { 1.0 } else { -1.0 }) } else { d };
            for axis in 0..3 {
                directions[axis][i] = d[axis];
            }
        }
        let met = tracer.closest16(inside, &directions, u16::MAX);
        leaks += met.hit.count_zeros() as usize;
        for i in 0..LANES {
            let ray = Ray::new(inside, Vec3::new(directions[0][i], directions[1][i], directions[2][i]));
            let hit = tracer.closest(&ray);
            leaks += usize::from(hit.is_none() || !tracer.occluded(&ray));
            if let Some(hit) = hit {
                assert_eq!((met.t[i], met.u[i], met.v[i]), (hit.t, hit.u, hit.v), "packet = single");
                assert_eq!(
                    (met.instance[i], met.triangle[i]),
                    (hit.instance, hit.triangle),
                    "packet = single"
                );
            }
        }
    }
    leaks
}

/// Traces `rays_each` for each shape, place and kernel; returns how many in all.
fn trace_all(rays_each: usize) -> usize {
    let mut all = Vec::new();
    for (scale, offset) in PLACES {
        for shape in shapes(scale, offset) {
            for kernel in kernels() {
                // The oracle is slow: it gets a tenth.
                let rays = if kernel == Kernel::Portable { rays_each / 10 } else { rays_each };
                all.push((shape.clone(), kernel, rays));
            }
        }
    }
    all.par_iter().enumerate().for_each(|(i, (shape, kernel, rays))| {
        let tracer = tracer(shape).with_kernel(*kernel).expect("available");
        let found = leaks(&tracer, shape, *rays, i as u32);
        assert_eq!(found, 0, "{} with {kernel:?} at {}", shape.name, shape.centre);
    });
    all.iter().map(|(_, _, rays)| rays).sum()
}

#[test]
fn nothing_leaks() {
    assert!(trace_all(400_000) > 400_000);
}

#[test]
#[ignore = "long: 10^8 rays"]
fn nothing_leaks_at_length() {
    let kernels = kernels().len();
    assert!(
        trace_all(100_000_000 / (shapes(1.0, Vec3::ZERO).len() * PLACES.len() * (kernels - 1).max(1)))
            > 50_000_000
    );
}
