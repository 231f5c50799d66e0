//! An integrator of one's own: how open each point is within half a metre, known as ambient occlusion.
//! `cargo run --release --example 2_own_integrator -- scenes/office.mgf open.png`

use lampyris::backend::{Rays, Settings};
use lampyris::eye::{Eye, Rect, Sampling, Tile};
use lampyris::integrator::{Integrator, Pass};
use lampyris::output::{Display, Picture, save};
use lampyris::scene::{View, find_view};
use lampyris::{Rgb, geometry::Ray, import, material::Class, particle::Plan, world::World};
use std::path::Path;

struct Openness;

impl Integrator for Openness {
    fn name(&self) -> &'static str {
        "openness"
    }

    fn paths(&self) -> &'static str {
        "none: no light, the shape alone"
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        for packet in &tile.packets {
            for k in packet.lanes() {
                let Some(x) = packet.visible(k) else { continue };
                let numbers = packet.numbers[k].branch(b'o'.into());
                let Some(s) = x.surface.sample(Class::Dull, numbers.pair(4), numbers.one(7)) else {
                    continue;
                };
                rays.shadow += 1;
                let ray = Ray { origin: x.surface.spawn(s.wi), direction: s.wi, t_max: 0.5 };
                let open = if pass.world.tracer().occluded(&ray) { 0.0 } else { 1.0 };
                // As far as this knows, all light is of one group.
                out[0][packet.pixels[k] as usize] += Rgb::grey(open);
            }
        }
    }
}

/// What the CPU back end does with the integrators of the table, reduced to one tile and no threads.
fn main() -> lampyris::Result<()> {
    let args: Vec<String> = std::env::args().collect();
    let [_, scene, out] = args.as_slice() else {
        return Err(lampyris::Error::BadSetting("give a scene and a picture's name".into()));
    };
    let world = World::new(import::load(Path::new(scene), &import::Options::default())?.scene);
    let camera = find_view(world.scene(), &|ray| world.tracer().closest(ray), 1.5).camera;
    let (width, height, passes) = (240, 160, 16);
    let (eye, settings) = (Eye::Camera(View::new(&camera, width, height)), Settings::default());
    let plan = Plan::new(&world, &settings);
    let mut tile = eye.tiles(&world, Rect { x: 0, y: 0, width, height }, [1, 1]).remove(0);
    let mut sum = [vec![Rgb::BLACK; (width * height) as usize]];
    for index in 0..passes {
        let sampling = Sampling { offset: [0.5; 2], index, seed: 0 };
        eye.look(&sampling, &mut tile);
        let (world, settings, plan, eye) = (&world, &settings, &plan, &eye);
        let (photons, coarse, irradiance) = (None, None, None);
        let pass = Pass { world, settings, plan, eye, lights: &[], photons, coarse, irradiance, sampling };
        Openness.add(&pass, &tile, &mut sum, &mut Rays::default());
    }
    let [sum] = sum;
    let mean = sum.into_iter().map(|v| v * (1.0 / passes as f32)).collect();
    save(Path::new(out), &Picture::new(width, height, mean), &Display::default())
}
