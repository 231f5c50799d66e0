//! The shortest way from a scene file to a picture: load, look, add batches, save.
//! `cargo run --release --example 1_first_picture -- scenes/office.mgf office.png`

use lampyris::backend::{Backend, Batch, Settings};
use lampyris::output::{Display, Picture, save};
use lampyris::scene::{View, find_view};
use lampyris::{cpu::Cpu, eye::Eye, import, world::World};
use std::path::Path;

fn main() -> lampyris::Result<()> {
    let args: Vec<String> = std::env::args().collect();
    let [_, scene, out] = args.as_slice() else {
        return Err(lampyris::Error::BadSetting("give a scene and a picture's name".into()));
    };
    let loaded = import::load(Path::new(scene), &import::Options::default())?;
    let mut cpu = Cpu::new(None)?;
    let world = cpu.install(|| World::new(loaded.scene));
    let camera = find_view(world.scene(), &|ray| world.tracer().closest(ray), 1.5).camera;
    cpu.begin_world(world, Eye::Camera(View::new(&camera, 480, 320)), &Settings::default())?;
    for index in 0..4 {
        cpu.add(Batch { index })?;
    }
    let picture = Picture::new(480, 320, cpu.frame()?.mean());
    save(Path::new(out), &picture, &Display::default())
}
