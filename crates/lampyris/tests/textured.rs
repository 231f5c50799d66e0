//! Textures as light meets them, against closed forms: means of pictures, normals, holes, and the parts that must
//! still add up.

mod support;

use glam::{Affine2, Vec2, Vec3, Vec4};
use lampyris::Rgb;
use lampyris::geometry::Ray;
use lampyris::light::LightKind;
use lampyris::material::{Bsdf, Class, Coverage, Map, Pbr, Sides};
use lampyris::texture::{Encoding, Filter, Image, Pixels, Texture, Wrap};
use lampyris::world::World;
use std::f64::consts::PI;
use support::{
    Build, FAST, ORACLE, close, diffuse, lux, meter, parts_equal_path, render, settings, spread, view,
};

/// Adds an image with a texture of its own, and a map of the first coordinates.
fn map(b: &mut Build, width: u32, pixels: Vec<[u8; 4]>, encoding: Encoding, filter: Filter) -> Map {
    let image = b.0.images.len() as u32;
    let height = pixels.len() as u32 / width;
    b.0.images.push(Image { name: String::new(), width, height, pixels: Pixels::Byte(pixels) });
    b.0.textures.push(Texture { image, encoding, wrap: [Wrap::Repeat; 2], filter });
    Map { texture: b.0.textures.len() as u32 - 1, set: 0, transform: Affine2::IDENTITY }
}

/// A parallelogram whose texture coordinates run from 0 to 1 along `a` and `b`.
fn painted(b: &mut Build, corner: Vec3, along: Vec3, down: Vec3, material: u32) {
    b.quad(corner, along, down, material);
    b.0.meshes.last_mut().unwrap().uvs[0] = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
}

fn checkers(n: u32) -> Vec<[u8; 4]> {
    (0..n * n).map(|k| if (k % n + k / n).is_multiple_of(2) { [255; 4] } else { [0, 0, 0, 255] }).collect()
}

/// The world's surface where a ray downward from above meets it.
fn below(world: &World, x: f32, z: f32) -> lampyris::world::Surface<'_> {
    world.closest(&Ray::new(Vec3::new(x, 1.0, z), Vec3::NEG_Y)).expect("a floor")
}

const FLOOR: [Vec3; 3] = [Vec3::ZERO, Vec3::Z, Vec3::X];

/// The floor from (0, 0, 0) with the first coordinate along z, the second along x; its front is up.
fn floor(b: &mut Build, material: u32) {
    painted(b, FLOOR[0], FLOOR[1], FLOOR[2], material);
}

/// A material's colour is factor × texture × vertex colour, at the place the map's transform says.
#[test]
fn factors_multiply() {
    let mut b = Build::default();
    let colors = map(
        &mut b,
        2,
        vec![[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255; 4]],
        Encoding::Srgb,
        Filter::Nearest,
    );
    let m = b.grey(0.5);
    let turned = Map { transform: Affine2::from_translation(Vec2::new(0.5, 0.0)), ..colors };
    b.0.materials[m as usize].maps.color = Some(turned);
    floor(&mut b, m);
    b.0.meshes[0].colors =
        vec![Vec4::new(1.0, 1.0, 1.0, 1.0), Vec4::new(0.5, 0.5, 0.5, 1.0), Vec4::splat(0.5), Vec4::ONE];
    let world = World::new(b.0);
    // z is the first coordinate, shifted by half the picture; vertex colours fall from 1 to ½ along it.
    for (x, z, pixel) in [
        (0.2, 0.2, Rgb::new(0.0, 1.0, 0.0)),
        (0.2, 0.7, Rgb::new(1.0, 0.0, 0.0)),
        (0.7, 0.7, Rgb::new(0.0, 0.0, 1.0)),
        (0.8, 0.3, Rgb::WHITE),
    ] {
        let surface = below(&world, x, z);
        let expected = pixel * (0.5 * (1.0 - 0.5 * z));
        let off = surface.finish.lambertian.expect("diffuse") - expected;
        assert!(off.to_array().iter().all(|c| c.abs() < 1e-5), "{x} {z}: {off:?}");
    }
    let mean = f64::from(world.mean_reflectance());
    close(
        "mean reflectance without vertex colours",
        mean,
        0.5 * (1.0 + 0.2126 + 0.7152 + 0.0722) / 4.0,
        1e-5,
    );
}

#[test]
fn maps_of_roughness_and_metal() {
    let mut b = Build::default();
    let numbers = map(&mut b, 2, vec![[0, 51, 255, 9], [0, 255, 0, 9]], Encoding::Linear, Filter::Nearest);
    let m = b.material(Bsdf::Pbr(Pbr { roughness: 0.5, metallic: 0.8, ..Pbr::default() }), 0.0, Sides::Both);
    b.0.materials[m as usize].maps.roughness = Some(numbers);
    floor(&mut b, m);
    let world = World::new(b.0);
    let at = |z| match below(&world, 0.5, z).finish.bsdf {
        Bsdf::Pbr(p) => (p.roughness, p.metallic),
        other => panic!("{other:?}"),
    };
    let (polished, rough) = (at(0.2), at(0.8));
    assert!((polished.0 - 0.1).abs() < 1e-6 && (polished.1 - 0.8).abs() < 1e-6, "{polished:?}");
    assert!((rough.0 - 0.5).abs() < 1e-6 && rough.1 == 0.0, "{rough:?}");
}

/// Parallel light on a floor of checkers, 1 m square: back at a meter 1 m above arrives E ρ̄ F, where the four quarters of
/// the floor have F = 2/π · X/√(1+X²) · atan(X/√(1+X²)) · 2 with X = ½.
#[test]
fn checkers_reflect_their_mean() {
    let mut b = Build::default();
    let m = b.grey(0.8);
    let checkers = map(&mut b, 64, checkers(64), Encoding::Srgb, Filter::Linear);
    b.0.materials[m as usize].maps.color = Some(checkers);
    floor(&mut b, m);
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::grey(100.0) });
    let slope = 0.5 / libm::sqrt(1.25);
    let expected = 100.0 * 0.8 * 0.5 * (4.0 / PI * slope * libm::atan(slope));
    let desk = [meter(Vec3::new(0.5, 1.0, 0.5), Vec3::NEG_Y)];
    for parts in [FAST, ORACLE] {
        let draw = |seed| lux(&b.0, &desk, &settings(parts, 1 << 9, 1 << 9, seed), 8)[0];
        support::close_mean("checkers", 8, expected, 0.015, draw);
    }
}

/// A ramp of linear bytes under a distant lamp: each pixel's radiance is E ρ(x)/π.
#[test]
fn a_ramp_under_parallel_light() {
    let mut b = Build::default();
    let bytes = (0..=255u8).map(|v| [v, v, v, 255]).collect();
    let ramp = map(&mut b, 256, bytes, Encoding::Linear, Filter::Linear);
    let m = b.grey(1.0);
    b.0.materials[m as usize].maps.color = Some(ramp);
    floor(&mut b, m);
    b.light(LightKind::Directional { direction: Vec3::NEG_Y, illuminance: Rgb::grey(100.0) });
    let s = settings(&["direct"], 64, 64, 0);
    // A column of pixels from above, along z.
    let eye = view(Vec3::new(0.5, 50.0, 0.5), Vec3::new(0.5, 0.0, 0.5), 1.0, 1, 16);
    let picture = render(&b.0, eye.clone(), &s, 1);
    let world = World::new(b.0);
    let lampyris::eye::Eye::Camera(view) = eye else { panic!("a camera") };
    for (k, pixel) in picture.iter().enumerate() {
        let ray = view.ray(0.5, k as f32 + 0.5);
        let z = world.closest(&ray).expect("the floor").position.z;
        let expected = 100.0 / PI * f64::from((z * 256.0 - 0.5) / 255.0);
        close("ramp", f64::from(pixel.luminance()), expected, 0.01);
    }
}

/// Normals by picture: a map that leans to red turns the normal along the first coordinate, one that leans to green
/// against the second; strength scales both; given tangents say the same as coordinates; mirrored instances too.
#[test]
fn normals_lean_as_their_map_says() {
    for (pixel, strength, lean) in [
        ([255, 128, 255, 255], 1.0, Vec3::new(0.0, 1.0, 1.0)),
        ([128, 255, 255, 255], 1.0, Vec3::new(-1.0, 1.0, 0.0)),
        ([255, 128, 255, 255], 0.5, Vec3::new(0.0, 1.0, 0.5)),
        ([128, 128, 255, 255], 1.0, Vec3::Y),
    ] {
        for (given, mirror) in [(false, 1.0), (true, 1.0), (false, -1.0), (true, -1.0)] {
            let mut b = Build::default();
            let normals = map(&mut b, 1, vec![pixel], Encoding::Linear, Filter::Linear);
            let m = b.grey(0.5);
            b.0.materials[m as usize].maps.normal = Some((normals, strength));
            floor(&mut b, m);
            if given {
                // Along +z; the bitangent n × t is y × z = x, up in the picture is −x.
                b.0.meshes[0].tangents = vec![Vec4::new(0.0, 0.0, 1.0, -1.0); 4];
            }
            b.0.instances[0].transform = glam::Affine3A::from_scale(Vec3::new(mirror, 1.0, 1.0));
            let world = World::new(b.0);
            let surface = below(&world, 0.5 * mirror, 0.5);
            let expected = (lean * Vec3::new(mirror, 1.0, 1.0)).normalize();
            assert!(
                (surface.shading - expected).length() < 0.01,
                "{pixel:?} {given} {mirror}: {}",
                surface.shading
            );
            assert_eq!(surface.normal, Vec3::Y);
        }
    }
}

/// No normal of any map lies behind its triangle.
#[test]
fn normals_stay_in_front() {
    let mut b = Build::default();
    let wild = (0..4096u32).map(|k| [(k % 16 * 17) as u8, (k / 16 % 16 * 17) as u8, (k / 256 * 17) as u8, 0]);
    let normals = map(&mut b, 64, wild.collect(), Encoding::Linear, Filter::Nearest);
    let m = b.grey(0.5);
    b.0.materials[m as usize].maps.normal = Some((normals, 1.0));
    floor(&mut b, m);
    let world = World::new(b.0);
    for i in 0..5000 {
        let [x, z] = spread(i, 1);
        let n = below(&world, x * 0.99 + 0.005, z * 0.99 + 0.005).shading;
        assert!(n.y >= 0.0499 && (n.length() - 1.0).abs() < 1e-5, "{n}");
    }
}

/// Rays down on a floor of a coverage: how many of 4000 go through.
fn passed(coverage: Coverage, alpha: Option<Vec<[u8; 4]>>, vertex: Option<f32>) -> u32 {
    let mut b = Build::default();
    let m = b.grey(0.5);
    b.0.materials[m as usize].coverage = coverage;
    if let Some(pixels) = alpha {
        let map = map(&mut b, 2, pixels, Encoding::Srgb, Filter::Nearest);
        b.0.materials[m as usize].maps.color = Some(map);
    }
    floor(&mut b, m);
    if let Some(alpha) = vertex {
        b.0.meshes[0].colors = vec![Vec4::new(1.0, 1.0, 1.0, alpha); 4];
    }
    let world = World::new(b.0);
    let through = |i| {
        let [x, z] = spread(i, 2);
        let (from, to) = (Vec3::new(x, 1.0, z), Vec3::new(x, -1.0, z));
        let open = world.closest(&Ray::between(from, to)).is_none();
        assert_eq!(open, !world.tracer().blocked(from, to));
        u32::from(open)
    };
    (0..4000).map(through).sum()
}

#[test]
fn coverage_is_the_share_of_rays_that_are_stopped() {
    let stripes = || Some(vec![[9, 9, 9, 127], [9, 9, 9, 128]]);
    let near = |count: u32, expected: f64| {
        // Five standard deviations of a count of independent rays.
        let sigma = (4000.0 * expected * (1.0 - expected)).sqrt();
        assert!((f64::from(count) - 4000.0 * expected).abs() <= 5.0 * sigma, "{count} for {expected}");
    };
    // Half of the floor has an alpha of 127/255 < ½ ≤ 128/255.
    let half = passed(Coverage::Mask { factor: 1.0, cutoff: 0.5 }, stripes(), None);
    assert!((1998..=2002).contains(&half), "{half}");
    assert_eq!(passed(Coverage::Mask { factor: 0.5, cutoff: 0.5 }, None, None), 0);
    assert_eq!(passed(Coverage::Mask { factor: 0.49, cutoff: 0.5 }, None, None), 4000);
    assert_eq!(passed(Coverage::Mask { factor: 1.0, cutoff: 0.5 }, None, Some(0.4)), 4000);
    assert_eq!(passed(Coverage::Full, stripes(), Some(0.1)), 0);
    assert_eq!(passed(Coverage::Blend { factor: 1.0 }, None, None), 0);
    assert_eq!(passed(Coverage::Blend { factor: 0.0 }, None, None), 4000);
    near(passed(Coverage::Blend { factor: 0.25 }, None, None), 0.75);
    near(passed(Coverage::Blend { factor: 0.5 }, stripes(), None), 0.75);
    near(passed(Coverage::Blend { factor: 0.5 }, stripes(), Some(0.5)), 0.875);
}

/// A screen of α = ½ between lamp and meter halves the light of an extended lamp.
#[test]
fn a_half_there_screen_halves_the_light() {
    let scene = |screen: bool| {
        let mut b = Build::default();
        let glow = b.glow(100.0);
        b.quad(Vec3::new(-0.5, 2.0, -0.5), Vec3::X, Vec3::Z, glow);
        if screen {
            let m = b.grey(0.0);
            b.0.materials[m as usize].coverage = Coverage::Blend { factor: 0.5 };
            painted(&mut b, Vec3::new(-2.0, 1.0, -2.0), Vec3::Z * 4.0, Vec3::X * 4.0, m);
        }
        b
    };
    let desk = [meter(Vec3::ZERO, Vec3::Y)];
    for parts in [FAST, ORACLE] {
        let draw = |seed| lux(&scene(true).0, &desk, &settings(parts, 1 << 9, 1 << 9, seed), 8)[0];
        let open = lux(&scene(false).0, &desk, &settings(parts, 1 << 9, 1 << 9, 0), 8)[0];
        support::close_mean("screen", 8, 0.5 * open, 0.02, draw);
    }
}

/// A room with a papered wall, rough relief on the floor, a curtain half there and a masked grid: the parts add up to
/// the path tracer, meter by meter and in the whole picture.
#[test]
fn parts_add_up_with_textures_and_holes() {
    const SEEDS: u32 = 12;
    let mut b = Build::default();
    let paper = map(&mut b, 8, checkers(8), Encoding::Srgb, Filter::Linear);
    let bumps = (0..64u32).map(|k| [(k * 37 % 160 + 48) as u8, (k * 91 % 160 + 48) as u8, 255, 255]);
    let bumps = map(&mut b, 8, bumps.collect(), Encoding::Linear, Filter::Linear);
    let holes = (0..16u32).map(|k| [200, 180, 90, if k % 3 == 0 { 0 } else { 255 }]).collect();
    let holes = map(&mut b, 4, holes, Encoding::Srgb, Filter::Nearest);
    let wall = b.grey(0.5);
    let papered = b.grey(0.8);
    b.0.materials[papered as usize].maps.color = Some(paper);
    let relief = b.grey(0.6);
    b.0.materials[relief as usize].maps.normal = Some((bumps, 1.0));
    let curtain = b.grey(0.7);
    b.0.materials[curtain as usize].coverage = Coverage::Blend { factor: 0.4 };
    let grid = b.grey(0.9);
    b.0.materials[grid as usize].coverage = Coverage::Mask { factor: 1.0, cutoff: 0.5 };
    b.0.materials[grid as usize].maps.color = Some(holes);
    b.room(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 3.0, 2.0), [wall; 6]);
    painted(&mut b, Vec3::new(-2.0, 0.02, -2.0), Vec3::Z * 4.0, Vec3::X * 4.0, relief);
    painted(&mut b, Vec3::new(-1.98, 0.0, -2.0), Vec3::Y * 3.0, Vec3::Z * 4.0, papered);
    painted(&mut b, Vec3::new(0.7, 0.0, -1.5), Vec3::Y * 2.5, Vec3::Z * 2.0, curtain);
    painted(&mut b, Vec3::new(-1.0, 1.2, -1.0), Vec3::Z * 1.5, Vec3::X * 1.5, grid);
    let glow = b.glow(10.0);
    b.quad(Vec3::new(-0.6, 2.9, -0.6), Vec3::X * 1.2, Vec3::Z * 1.2, glow);
    let camera = view(Vec3::new(0.3, 1.6, 1.9), Vec3::new(0.0, 1.0, -1.0), 60.0, 16, 12);
    let desks = [meter(Vec3::new(0.0, 0.7, 0.0), Vec3::Y), meter(Vec3::new(1.2, 1.0, 0.0), Vec3::NEG_X)];
    parts_equal_path(&b.0, &camera, &desks, SEEDS);
}

/// What has no image, no coordinates or a broken image is as without a map.
#[test]
fn missing_pieces_multiply_by_one() {
    let whole = |spoil: fn(&mut Build)| {
        let mut b = Build::default();
        let dark = map(&mut b, 1, vec![[0, 0, 0, 0]], Encoding::Srgb, Filter::Linear);
        let m = b.material(diffuse(0.5), 1.0, Sides::Both);
        b.0.materials[m as usize].maps.color = Some(dark);
        b.0.materials[m as usize].maps.emission = Some(dark);
        floor(&mut b, m);
        spoil(&mut b);
        let world = World::new(b.0);
        let surface = below(&world, 0.5, 0.5);
        (surface.finish.bsdf.albedo(Class::Dull, Vec3::Z).r, surface.emission().r)
    };
    assert_eq!(whole(|_| {}), (0.0, 0.0));
    assert_eq!(whole(|b| b.0.textures[0].image = 7), (0.5, 1.0));
    assert_eq!(whole(|b| b.0.textures.clear()), (0.5, 1.0));
    assert_eq!(whole(|b| b.0.meshes[0].uvs[0].truncate(1)), (0.5, 1.0));
    assert_eq!(whole(|b| b.0.images[0].width = 3), (0.5, 1.0));
    assert_eq!(whole(|b| b.0.materials[0].maps.color.as_mut().unwrap().set = 9).0, 0.5);
}
