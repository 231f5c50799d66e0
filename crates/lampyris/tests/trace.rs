//! What the tracer promises beside being watertight: no surface is hit by the rays that leave it, sharing a mesh
//! changes no bit, one-sided triangles let rays pass from behind, and nothing bad in the input does harm.

#![expect(clippy::needless_range_loop, reason = "lanes run through several arrays")]

mod common;

use common::{Rng, kernels, shapes, tracer};
use glam::{Affine3A, Mat3, Quat, Vec3};
use lampyris::geometry::{LANES, MeshGeometry, Placement, Ray, Screen, SurfacePoint, Tracer};

fn signed(rng: &mut Rng) -> Vec3 {
    rng.vector() * 2.0 - 1.0
}

fn normal(corners: &[Vec3; 3]) -> Vec3 {
    let [a, b, c] = corners.map(|c| c.to_array().map(f64::from));
    let (e, f) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    Vec3::from_array(n.map(|n| (n / length) as f32))
}

/// [pbrt's test `Triangle.Reintersect`]: coordinates from 1e-8 to 1e8, rays to all sides from each point.
#[test]
fn rays_never_hit_the_surface_they_leave() {
    let mut rng = Rng::new(7);
    let mut rays = 0;
    while rays < 1_000_000 {
        let mut coordinate = || 10f32.powi(rng.below(17) as i32 - 8) * (rng.unit() * 2.0 - 1.0);
        let corners = [0; 3].map(|_| Vec3::new(coordinate(), coordinate(), coordinate()));
        let mesh =
            MeshGeometry { positions: &corners, triangles: &[[0, 1, 2]], one_sided: &[], screened: &[] };
        let tracer = Tracer::build(&[mesh], &[Placement { mesh: 0, transform: Affine3A::IDENTITY }]);
        let n = normal(&corners);
        for _ in 0..100 {
            let (a, b) = (rng.unit(), rng.unit());
            let (u, v) = if a + b < 1.0 { (a, b) } else { (1.0 - a, 1.0 - b) };
            let n = if rng.below(2) == 0 { n } else { -n };
            let d = signed(&mut rng).normalize_or(n);
            let d = if d.dot(n) < 0.0 { d - n * (2.0 * d.dot(n)) } else { d };
            let start = SurfacePoint::new(&corners, u, v).spawn(n);
            assert_eq!(tracer.closest(&Ray::new(start, d)), None, "{corners:?} {u} {v} {d}");
            rays += 1;
        }
    }
}

/// Floors and walls of many triangles, turned at random so that no coordinate is round.
#[test]
fn points_of_a_room_see_each_other() {
    let mut rng = Rng::new(8);
    for offset in [Vec3::ZERO, Vec3::new(148_376.0, 1_234.0, -223_423.0)] {
        let turn = Quat::from_axis_angle(signed(&mut rng).normalize(), 1.0 + rng.unit());
        let mut room = shapes(100.0, Vec3::ZERO).swap_remove(1);
        for p in &mut room.positions {
            *p = turn * *p + offset;
        }
        for kernel in kernels() {
            let tracer = tracer(&room).with_kernel(kernel).expect("available");
            let point = |rng: &mut Rng, wall: usize| {
                let per_wall = room.triangles.len() / 6;
                let triangle = room.triangles[wall * per_wall + rng.below(per_wall)];
                let corners = triangle.map(|v| room.positions[v as usize]);
                let (a, b) = (rng.unit(), rng.unit());
                let (u, v) = if a + b < 1.0 { (a, b) } else { (1.0 - a, 1.0 - b) };
                // Not in the corners of the room: within its rounding a point there may lie behind the next wall.
                let (u, v) = (0.05 + 0.85 * u, 0.05 + 0.85 * v);
                SurfacePoint::new(&corners, u, v).spawn(normal(&corners))
            };
            for i in 0..20_000 {
                let wall = i % 6;
                let from = point(&mut rng, wall);
                let mut targets = [[0.0; LANES]; 3];
                for lane in 0..LANES {
                    // On the same wall or another: a room is convex.
                    let other = if lane % 2 == 0 { wall } else { rng.below(6) };
                    let to = point(&mut rng, other);
                    assert!(!tracer.blocked(from, to), "{kernel:?} {from} {to}");
                    for axis in 0..3 {
                        targets[axis][lane] = to[axis];
                    }
                }
                assert_eq!(tracer.occluded16(from, &targets, u16::MAX), 0, "{kernel:?}");
            }
        }
    }
}

#[test]
fn sharing_a_mesh_changes_no_bit() {
    sharing(1.0, Vec3::ZERO);
    sharing(0.1, Vec3::new(1_483.0, 12.0, -2_234.0));
    sharing(1e4, Vec3::new(-7e4, 0.0, 0.0));
}

fn sharing(scale: f32, offset: Vec3) {
    let mut rng = Rng::new(9);
    let shape = shapes(1.0, Vec3::ZERO).swap_remove(0);
    let one_sided: Vec<bool> = shape.triangles.iter().map(|_| rng.below(3) == 0).collect();
    let mesh = MeshGeometry {
        positions: &shape.positions,
        triangles: &shape.triangles,
        one_sided: &one_sided,
        screened: &[],
    };
    let transforms: Vec<Affine3A> = (0..12)
        .map(|i| {
            let mirror = if i % 3 == 0 { -1.0 } else { 1.0 };
            let stretch = Vec3::new(mirror * (0.3 + rng.unit()), 0.2 + rng.unit(), 0.1 + 2.0 * rng.unit());
            let turn = Quat::from_axis_angle(signed(&mut rng).normalize(), rng.unit() * 6.0);
            let at = signed(&mut rng) * (4.0 * scale) + offset;
            Affine3A::from_scale_rotation_translation(stretch * scale, turn, at)
        })
        .collect();
    let place = |mesh: fn(u32) -> u32| -> Vec<Placement> {
        transforms.iter().zip(0..).map(|(t, i)| Placement { mesh: mesh(i), transform: *t }).collect()
    };
    for kernel in kernels() {
        let shared = Tracer::build(&[mesh], &place(|_| 0)).with_kernel(kernel).expect("available");
        let flat = Tracer::build(&[mesh; 12], &place(|i| i)).with_kernel(kernel).expect("available");
        assert_eq!(shared.report(), flat.report());
        assert!(shared.memory() * 4 < flat.memory());
        let mut hits = 0;
        for _ in 0..3_000 {
            let origin = signed(&mut rng) * (6.0 * scale) + offset;
            let towards = signed(&mut rng) * (4.0 * scale) + offset;
            let targets: [[f32; LANES]; 3] =
                [0, 1, 2].map(|a| [0; LANES].map(|_| towards[a] + 0.3 * scale * rng.unit()));
            let directions = [0, 1, 2].map(|a| targets[a].map(|t| t - origin[a]));
            let met = flat.closest16(origin, &directions, u16::MAX);
            assert_eq!(shared.closest16(origin, &directions, u16::MAX), met);
            let blocked = flat.occluded16(origin, &targets, u16::MAX);
            assert_eq!(shared.occluded16(origin, &targets, u16::MAX), blocked);
            hits += met.hit.count_ones();
            let single = shared.closest(&Ray::new(origin, towards - origin));
            assert_eq!(single, flat.closest(&Ray::new(origin, towards - origin)));
        }
        assert!(hits > 1_500, "{hits}");
    }
}

#[test]
fn the_back_of_a_one_sided_triangle_lets_pass() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh =
        MeshGeometry { positions: &positions, triangles: &[[0, 1, 2]], one_sided: &[true], screened: &[] };
    let mirror = Affine3A::from_scale(Vec3::new(1.0, 1.0, -1.0));
    for kernel in kernels() {
        for (transform, front) in [(Affine3A::IDENTITY, 1.0), (mirror, -1.0)] {
            let one = Tracer::build(&[mesh], &[Placement { mesh: 0, transform }]);
            let far = Affine3A::from_translation(Vec3::splat(50.0));
            let two = [Placement { mesh: 0, transform }, Placement { mesh: 0, transform: far }];
            let two = Tracer::build(&[mesh], &two);
            for tracer in [one, two].map(|t| t.with_kernel(kernel).expect("available")) {
                for z in [1.0, -1.0f32] {
                    let (from, to) = (Vec3::new(0.2, 0.3, z), Vec3::new(0.2, 0.3, -z));
                    let seen = z == front;
                    assert_eq!(tracer.closest(&Ray::between(from, to)).is_some(), seen);
                    assert_eq!(tracer.blocked(from, to), seen);
                    let targets = to.to_array().map(|x| [x; LANES]);
                    assert_eq!(tracer.occluded16(from, &targets, 0x0ff0), if seen { 0x0ff0 } else { 0 });
                    let directions = (to - from).to_array().map(|x| [x; LANES]);
                    assert_eq!(
                        tracer.closest16(from, &directions, 0xf00f).hit,
                        if seen { 0xf00f } else { 0 }
                    );
                }
            }
        }
    }
}

#[test]
fn bad_input_is_left_out_and_counted() {
    let (nan, inf) = (f32::NAN, f32::INFINITY);
    let positions =
        [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(nan, 0.0, 0.0), Vec3::new(0.0, inf, 0.0), Vec3::splat(1e19)];
    let triangles = [[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 5], [0, 0, 1], [1, 1, 1], [0, 1, 99], [0, 1, 2]];
    let mesh = MeshGeometry { positions: &positions, triangles: &triangles, one_sided: &[], screened: &[] };
    let place = |mesh: u32, transform: Affine3A| Placement { mesh, transform };
    let singular = Affine3A::from_mat3(Mat3::from_diagonal(Vec3::new(1.0, 0.0, 1.0)));
    let broken = Affine3A::from_translation(Vec3::new(nan, 0.0, 0.0));
    let tracer = Tracer::build(
        &[mesh],
        &[place(0, singular), place(0, broken), place(7, Affine3A::IDENTITY), place(0, Affine3A::IDENTITY)],
    );
    let report = tracer.report();
    assert_eq!((report.triangles, report.dropped_triangles, report.dropped_instances), (2, 6, 3));
    let down = Ray::new(Vec3::new(0.25, 0.25, 1.0), Vec3::NEG_Z);
    let hit = tracer.closest(&down).expect("there is a triangle");
    // The two equal triangles tie: the first wins.
    assert_eq!((hit.t, hit.instance, hit.triangle), (1.0, 3, 0));
    for bad in [nan, inf, -inf] {
        for axis in Vec3::AXES {
            for ray in [
                Ray { origin: down.origin + axis * bad, ..down },
                Ray { direction: down.direction + axis * bad, ..down },
                Ray { direction: Vec3::ZERO, ..down },
                Ray { t_max: nan, ..down },
            ] {
                assert_eq!(tracer.closest(&ray), None);
                assert!(!tracer.occluded(&ray));
                let directions = ray.direction.to_array().map(|x| [x; LANES]);
                assert!(ray.t_max.is_nan() || tracer.closest16(ray.origin, &directions, u16::MAX).hit == 0);
            }
        }
    }
    let empty = Tracer::build(&[], &[]);
    assert_eq!(empty.closest(&down), None);
    assert_eq!(empty.occluded16(Vec3::ZERO, &[[1.0; LANES]; 3], u16::MAX), 0);
    assert_eq!(empty.bounds(), None);
}

/// Where a mesh is shared, its instances lie in their own trees: one that reaches farther than rays do is left out as a whole, and
/// nothing else is lost. So it is when an instance is moved there, and back.
#[test]
fn what_reaches_too_far_is_left_out() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(0.3, 0.2, 0.5)];
    let triangles = [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let mesh =
        || MeshGeometry { positions: &positions, triangles: &triangles, one_sided: &[], screened: &[] };
    let here = Placement { mesh: 0, transform: Affine3A::IDENTITY };
    let far = |matrix: Mat3| Placement { mesh: 0, transform: Affine3A::from_mat3(matrix) };
    let sheared = Mat3::from_cols(Vec3::new(1.0, 0.0, 2.2e31), Vec3::NEG_Y, Vec3::Z);
    let mut rng = Rng::new(3);
    for matrix in [sheared, Mat3::from_diagonal(Vec3::new(1e30, 1e-20, 1.0))] {
        for kernel in kernels() {
            let tracer = Tracer::build(&[mesh()], &[here, far(matrix)]);
            assert_eq!((tracer.report().triangles, tracer.report().dropped_instances), (4, 1));
            let tracer = tracer.with_kernel(kernel).expect("available");
            let mut moved = Tracer::build(&[mesh()], &[here, here]).with_kernel(kernel).expect("available");
            moved.replace(1, Some(&far(matrix)), &[]);
            let alone = Tracer::build(&[mesh()], &[here]).with_kernel(kernel).expect("available");
            for _ in 0..2000 {
                let size = 10f32.powi(rng.below(36) as i32 - 18);
                let ray = Ray::new(signed(&mut rng) * size, signed(&mut rng));
                let hit = alone.closest(&ray);
                for other in [&tracer, &moved] {
                    assert_eq!(other.closest(&ray), hit);
                    assert_eq!(other.occluded(&ray), alone.occluded(&ray));
                    let directions = ray.direction.to_array().map(|x| [x; LANES]);
                    let packet = other.closest16(ray.origin, &directions, u16::MAX);
                    assert_eq!(packet.hit != 0, hit.is_some());
                }
            }
        }
    }
}

/// Which hits of the test go through, from the bits of all that is known of them.
fn holed(instance: u32, triangle: u32, u: f32, v: f32) -> bool {
    let mix = |a: u32, b: u32| (a ^ b).wrapping_mul(0x9e37_79b9).rotate_left(15);
    [instance, triangle, u.to_bits(), v.to_bits()].into_iter().fold(1, mix).count_ones() % 2 == 0
}

/// Screens of all sorts of meshes, shared or not: all kernels and all ways to ask give the answer of a walk that steps
/// from hit to hit through the whole surfaces.
#[test]
fn screens_are_the_same_to_every_ray() {
    let mut rng = Rng::new(11);
    let shape = shapes(1.0, Vec3::ZERO).swap_remove(0);
    let flags = |one: usize, rng: &mut Rng| -> Vec<bool> {
        shape.triangles.iter().map(|_| rng.below(3) == one).collect()
    };
    let (one_sided, screened) = (flags(0, &mut rng), flags(1, &mut rng));
    let mesh = MeshGeometry {
        positions: &shape.positions,
        triangles: &shape.triangles,
        one_sided: &one_sided,
        screened: &screened,
    };
    let transforms: Vec<Affine3A> = (0..6)
        .map(|i| {
            let mirror = if i % 2 == 0 { -1.0 } else { 1.0 };
            let turn = Quat::from_axis_angle(signed(&mut rng).normalize(), rng.unit() * 6.0);
            Affine3A::from_scale_rotation_translation(
                Vec3::new(mirror, 0.7, 1.2),
                turn,
                signed(&mut rng) * 2.0,
            )
        })
        .collect();
    let place = |mesh: fn(u32) -> u32| -> Vec<Placement> {
        transforms.iter().zip(0..).map(|(t, i)| Placement { mesh: mesh(i), transform: *t }).collect()
    };
    let screen = Screen::new(holed);
    let with_holes = |meshes: &[MeshGeometry<'_>], places: &[Placement], kernel| {
        Tracer::with_screen(meshes, places, &screen).with_kernel(kernel).expect("available")
    };
    let oracle = with_holes(&[mesh; 6], &place(|i| i), kernels()[0]);
    // Of single triangles: what a screen asks of them, the ray's own hits say.
    let whole = MeshGeometry { screened: &[], ..mesh };
    let alone: Vec<Tracer> = (transforms.iter())
        .flat_map(|t| (0..shape.triangles.len()).map(move |k| (t, k)))
        .map(|(t, k)| {
            let one =
                MeshGeometry { triangles: &shape.triangles[k..=k], one_sided: &one_sided[k..=k], ..whole };
            Tracer::build(&[one], &[Placement { mesh: 0, transform: *t }])
        })
        .collect();
    let stepwise = |ray: &Ray| -> Option<(f32, u32, u32)> {
        let hits = alone.iter().enumerate().filter_map(|(k, tracer)| {
            let count = shape.triangles.len();
            let (instance, triangle) = ((k / count) as u32, (k % count) as u32);
            let hit = tracer.closest(ray)?;
            let open = screened[triangle as usize] && holed(instance, triangle, hit.u, hit.v);
            (!open).then_some((hit.t, instance, triangle))
        });
        hits.min_by(|a, b| a.partial_cmp(b).expect("finite"))
    };
    let tracers: Vec<_> = kernels()
        .into_iter()
        .map(|kernel| {
            let flat = with_holes(&[mesh; 6], &place(|i| i), kernel);
            (kernel, [flat, with_holes(&[mesh], &place(|_| 0), kernel)])
        })
        .collect();
    let (mut met, mut passed) = (0, 0);
    let all = Tracer::build(&[whole; 6], &place(|i| i));
    for i in 0..2_000 {
        let origin = signed(&mut rng) * 4.0;
        let towards = signed(&mut rng) * 2.0;
        let targets: [[f32; LANES]; 3] = [0, 1, 2].map(|a| [0; LANES].map(|_| towards[a] + 0.3 * rng.unit()));
        let directions = [0, 1, 2].map(|a| targets[a].map(|t| t - origin[a]));
        let ray = Ray::new(origin, towards - origin);
        let expected = oracle.closest(&ray);
        if i < 200 {
            assert_eq!(expected.map(|h| (h.t, h.instance, h.triangle)), stepwise(&ray));
        }
        met += u32::from(expected.is_some());
        passed += u32::from(expected != all.closest(&ray));
        let sixteen = oracle.closest16(origin, &directions, u16::MAX);
        let blocked = oracle.occluded16(origin, &targets, u16::MAX);
        for l in 0..LANES {
            let target = Vec3::new(targets[0][l], targets[1][l], targets[2][l]);
            assert_eq!(sixteen.get(l), oracle.closest(&Ray::new(origin, target - origin)));
            assert_eq!(blocked >> l & 1 == 1, oracle.blocked(origin, target));
        }
        for (kernel, tracers) in &tracers {
            for tracer in tracers {
                assert_eq!(tracer.closest(&ray), expected, "{kernel:?}");
                assert_eq!(tracer.closest16(origin, &directions, u16::MAX), sixteen, "{kernel:?}");
                assert_eq!(tracer.occluded16(origin, &targets, u16::MAX), blocked, "{kernel:?}");
                assert_eq!(tracer.occluded(&ray), expected.is_some());
                assert_eq!(tracer.blocked(origin, towards), oracle.blocked(origin, towards));
            }
        }
    }
    assert!(met > 1_000 && passed > 100, "{met} {passed}");
}
