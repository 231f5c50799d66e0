//! The gather of sixteen points at once is the scalar one to the rounding of `f32`: random cameras and meters, every
//! kind of light, vertices dull, glossy and translucent, smooth normals.

mod support;

use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::Batch;
use lampyris::eye::{Eye, Rect, Sampling};
use lampyris::integrator::gather::{from_light, packet};
use lampyris::light::{Beam, LightKind, Shine};
use lampyris::material::{Bsdf, Diffuse, Sides};
use lampyris::particle::{Plan, Vpl, Walk};
use lampyris::scene::Scene;
use lampyris::sequence::uniform;
use lampyris::world::World;
use support::{Build, FAST, diffuse, gloss, meter, say, settings, view};

/// Everything that shines or is shone on.
fn scene() -> Scene {
    let mut b = Build(Scene { environment: Rgb::new(0.2, 0.3, 0.5), ..Default::default() });
    let wall = b.material(Bsdf::Diffuse(Diffuse::opaque(Rgb::new(0.6, 0.5, 0.4))), 0.0, Sides::Both);
    let floor = b.material(gloss(0.3, 0.3, 0.2), 0.0, Sides::Both);
    let polish = b.material(gloss(0.3, 0.3, 0.1), 0.0, Sides::Both);
    let curtain = Diffuse { reflectance: Rgb::grey(0.3), transmittance: Rgb::grey(0.4) };
    let curtain = b.material(Bsdf::Diffuse(curtain), 0.0, Sides::Both);
    let glow = b.material(diffuse(0.3), 10.0, Sides::Both);
    b.room(Vec3::ZERO, Vec3::splat(2.0), [wall, wall, floor, wall, wall, wall]);
    b.0.instances.pop();
    b.block(Vec3::new(1.2, 0.0, 0.2), Vec3::new(1.6, 0.9, 0.6), polish);
    b.quad(Vec3::new(0.2, 0.3, 1.0), Vec3::X * 0.5, Vec3::Y, curtain);
    b.quad(Vec3::new(0.7, 1.9, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, glow);
    let center = Vec3::new(0.7, 0.4, 0.6);
    let ball = b.sphere(center, 0.35, 1, false, |_| wall);
    ball.normals = ball.positions.iter().map(|p| (*p - center).normalize()).collect();
    b.bulb(Vec3::new(0.3, 1.4, 1.6), 30.0);
    let spot = |beam| LightKind::Spot {
        position: Vec3::new(1.5, 1.5, 1.5),
        direction: Vec3::new(-0.6, -0.8, 0.0),
        intensity: Rgb::grey(3.0),
        beam,
    };
    b.light(spot(Beam::Cosine { exponent: 5.0 }));
    b.light(spot(Beam::Cone { cos_inner: 0.95, cos_outer: 0.7 }));
    b.light(LightKind::Directional { direction: Vec3::new(0.0, -0.6, -0.8), illuminance: Rgb::grey(2.0) });
    b.light(LightKind::Sphere { center: Vec3::new(1.6, 1.2, 1.2), radius: 0.1, radiance: Rgb::grey(9.0) });
    let normal = Vec3::new(0.0, -0.8, -0.6);
    b.light(LightKind::Disc {
        center: Vec3::new(0.4, 1.7, 1.7),
        normal,
        radius: 0.2,
        radiance: Rgb::grey(9.0),
    });
    b.0
}

/// Light by light and lane by lane. Rounding may move a shadow's edge: such lanes are counted, and must be rare; all
/// others agree to 1e-4 at worst (the packet measures distances from where shadow rays start) and to 1e-5 in the mean.
#[test]
fn sixteen_at_once_equal_one_by_one() {
    let world = World::new(scene());
    let s = settings(FAST, 200, 1, 5);
    let plan = Plan::new(&world, &s);
    let walk = Walk::new(&world, &s, &plan, Batch { index: 0 });
    let lights: Vec<&Vpl<'_>> = walk.lights.iter().chain(&walk.vpls).collect();
    assert!(walk.vpls.iter().any(|v| v.gloss.is_some()), "glossy vertices");
    let (mut compared, mut flipped, mut worst, mut sum, mut off) = (0u64, 0u64, 0.0f64, 0.0, 0.0);
    for k in 0..24 {
        let random = |d| uniform(3, k, d);
        let inside = Vec3::new(random(0), random(1), random(2)) * 1.8 + 0.1;
        let target = Vec3::new(random(3), random(4), random(5)) * 1.8 + 0.1;
        let eye = if k % 4 == 3 {
            let way = |i: u32| lampyris::sampling::uniform_sphere([uniform(4, i, 0), uniform(4, i, 1)]);
            let at = |i: u32| Vec3::new(uniform(4, i, 2), uniform(4, i, 3), uniform(4, i, 4)) * 1.9 + 0.05;
            Eye::Meters((0..16).map(|i| meter(at(i + 16 * k), way(i + 16 * k))).collect())
        } else {
            view(inside, target, 50.0, 8, 8)
        };
        let (width, height) = eye.size();
        let mut tile = eye.tiles(&world, Rect { x: 0, y: 0, width, height }, [1, 1]).remove(0);
        eye.look(&Sampling { offset: [0.5, 0.5], index: k, seed: 7 }, &mut tile);
        for p in &tile.packets {
            for light in &lights {
                let mut rays = 0;
                let together = packet(&world, p, std::slice::from_ref(light), &mut rays);
                for lane in p.lanes() {
                    let Some(x) = p.visible(lane) else { continue };
                    let alone = from_light(&world, &x.surface, light, &mut rays);
                    let (a, b) = (f64::from(together[lane].luminance()), f64::from(alone.luminance()));
                    compared += u64::from(a > 0.0 || b > 0.0);
                    if (a == 0.0) != (b == 0.0) {
                        flipped += 1;
                        continue;
                    }
                    sum += b;
                    off += (a - b).abs();
                    // Of what would come without cosines: at grazing angles these have few digits left.
                    let d2 = match light.shine {
                        Shine::Distant => 1.0,
                        _ => (light.position - x.surface.position).length_squared(),
                    };
                    let head_on = f64::from(light.intensity.luminance() / d2) / std::f64::consts::PI;
                    worst = worst.max((a - b).abs() / (b + head_on));
                }
            }
        }
    }
    say(format_args!(
        "{compared} pairs lit: worst {worst:.1e}, mean {:.1e}, shadows apart {flipped}",
        off / sum
    ));
    assert!(compared > 50_000, "{compared} pairs prove little");
    assert!(flipped * 2000 < compared, "{flipped} shadows apart of {compared}");
    assert!(off / sum < 1e-5, "off by {} in the mean", off / sum);
    assert!(worst < 1e-4, "off by {worst} at worst");
}
