//! Lampyris computes how light fills a scene: global illumination by virtual point lights, in photometric units.
//!
//! *Lampyris* is the glow-worm, and so is the idea: the light that has been reflected is represented by a swarm of
//! small lights left where particles met the walls [Keller97, §3]. This page is a guided tour; ARCHITECTURE.md says why
//! the parts are cut as they are, docs/light-transport.md has the equations.
//!
//! # The words
//!
//! A **particle** leaves a light and travels. Where it meets a surface is a **vertex**; a vertex that shines on
//! others is a **virtual point light** (VPL). From the other end an **eye** (a camera's view, or a list of
//! illuminance meters) looks into the scene: the first dull surface on its ray is a **visible point**. An
//! **integrator** shades visible points by one **part** of all light paths, and the parts add up. A **batch** is the
//! unit of work: N light paths and the **eye passes** that gather them, named by one number. A **back end** is a
//! machine that renders batches, a **frame** the sums of them, and a **picture** what is written to a file.
//!
//! # 1. A scene
//!
//! Scenes come from files, or are written down: a floor, a lamp of 100 cd, and a meter two metres below it. All
//! lengths are metres, all light is photometric, so the meter must read 100 cd / (2 m)² = 25 lx.
//!
//! ```
//! use glam::{Affine3A, Vec3};
//! use lampyris::backend::{Backend, Batch, Settings};
//! use lampyris::eye::{Eye, Meter};
//! use lampyris::light::{Light, LightKind};
//! use lampyris::material::{Bsdf, Diffuse, Material};
//! use lampyris::scene::{Instance, Mesh, Scene};
//! use lampyris::{Rgb, cpu::Cpu};
//!
//! let corner = |x: f32, y: f32| Vec3::new(x, y, 0.0);
//! let scene = Scene {
//!     meshes: vec![Mesh {
//!         positions: vec![corner(-5.0, -5.0), corner(5.0, -5.0), corner(5.0, 5.0), corner(-5.0, 5.0)],
//!         triangles: vec![[0, 1, 2], [0, 2, 3]],
//!         materials: vec![0, 0],
//!         ..Mesh::default()
//!     }],
//!     instances: vec![Instance { name: "floor".into(), mesh: 0, transform: Affine3A::IDENTITY }],
//!     materials: vec![Material::new("grey", Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.5))))],
//!     lights: vec![Light::new(
//!         "lamp",
//!         LightKind::Point { position: Vec3::new(0.0, 0.0, 2.75), intensity: Rgb::grey(100.0) },
//!     )],
//!     ..Scene::default()
//! };
//! let desk = Meter { position: Vec3::new(0.0, 0.0, 0.75), normal: Vec3::Z };
//!
//! let mut cpu = Cpu::new(None)?;
//! cpu.begin(scene, Eye::Meters(vec![desk]), &Settings::default())?;
//! cpu.add(Batch { index: 0 })?;
//! // A meter is a white surface: its radiance is the illuminance over π.
//! let lux = cpu.frame()?.mean()[0].luminance() * std::f32::consts::PI;
//! assert!((lux - 25.0).abs() < 1e-3, "{lux}");
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # 2. The world
//!
//! A [`world::World`] is a scene made traceable. It also knows what the walk of particles needs: which emitters there
//! are, what share of the paths each gets, how much surface there is and how much that reflects on average.
//!
//! ```
//! # use lampyris::{import, world::World};
//! # use std::path::Path;
//! let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! let loaded = import::load(Path::new(file), &import::Options::default())?;
//! assert!(loaded.warnings.is_empty());
//! let world = World::new(loaded.scene);
//! assert_eq!(world.emitters().len(), 1);
//! let lumens = world.emitters()[0].power(world.bounds()).luminance();
//! assert!((lumens - 53.54).abs() < 0.01, "{lumens}");
//! assert!(world.mean_reflectance() > 0.5 && world.mean_reflectance() < 0.7);
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # 3. The walk
//!
//! [`particle::Walk`] sends the particles of a batch through the world and keeps their vertices. In the mean, generation j has
//! N qʲ of them, each already divided by that number. The walk depends on nothing but its arguments: the same batch
//! gives the same lights on any machine, today and next year.
//!
//! ```
//! # use lampyris::{import, world::World};
//! # use std::path::Path;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! # let world = World::new(import::load(Path::new(file), &import::Options::default())?.scene);
//! use lampyris::backend::{Batch, Settings};
//! use lampyris::particle::{Plan, Walk};
//!
//! let settings = Settings { paths: 256, ..Settings::default() };
//! let plan = Plan::new(&world, &settings);
//! let walk = Walk::new(&world, &settings, &plan, Batch { index: 7 });
//! assert_eq!(walk.lights.len(), 256); // points of the lamp: generation 0
//! assert!(walk.vpls.len() > 256); // vertices on walls and blocks: generations 1 and up
//!
//! let again = Walk::new(&world, &settings, &plan, Batch { index: 7 });
//! assert_eq!(walk.vpls[5].position, again.vpls[5].position);
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # 4. A picture
//!
//! A back end begins with a scene, an eye and settings, and adds batches for as long as one likes. How many is the
//! caller's decision, and so is the time: no thread, no clock and no callback hides in here.
//!
//! ```
//! # use lampyris::import;
//! # use std::path::Path;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! # let scene = import::load(Path::new(file), &import::Options::default())?.scene;
//! use lampyris::backend::{Backend, Batch, Settings};
//! use lampyris::scene::{Camera, View};
//! use lampyris::{cpu::Cpu, eye::Eye};
//!
//! let camera = Camera {
//!     name: "front".into(),
//!     eye: [2.78, 2.73, -8.0].into(),
//!     target: [2.78, 2.73, 0.0].into(),
//!     up: [0.0, 1.0, 0.0].into(),
//!     fov_y: 39.3,
//! };
//! let settings = Settings { paths: 16, ..Settings::default() };
//! let mut cpu = Cpu::new(None)?;
//! cpu.begin(scene, Eye::Camera(View::new(&camera, 24, 24)), &settings)?;
//! for index in 0..4 {
//!     cpu.add(Batch { index })?;
//! }
//! let picture = cpu.frame()?.mean(); // cd/m², row by row from the top
//! assert_eq!(picture.len(), 24 * 24);
//! // The red wall is at large x, hence on the left of a view along +z; the green one is opposite.
//! let (left, right) = (picture[12 * 24 + 1], picture[12 * 24 + 22]);
//! assert!(left.r > left.g && right.g > right.r);
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # 5. Parts and errors
//!
//! Every part is kept apart, so one can see what is direct light and what is not. Batches belong in turn to a few
//! independent randomisations, whose spread says how far the mean may be from the truth.
//!
//! ```
//! # use lampyris::backend::{Backend, Batch, Settings};
//! # use lampyris::{cpu::Cpu, eye::{Eye, Meter}, import};
//! # use std::path::Path;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! # let scene = import::load(Path::new(file), &import::Options::default())?.scene;
//! # let floor = Meter { position: [3.5, 0.001, 1.0].into(), normal: [0.0, 1.0, 0.0].into() };
//! let mut cpu = Cpu::new(None)?;
//! cpu.begin(scene, Eye::Meters(vec![floor]), &Settings::default())?;
//! for index in 0..16 {
//!     cpu.add(Batch { index })?;
//! }
//! let frame = cpu.frame()?;
//! let lux = |part: &str| frame.part(part).map(|plane| plane[0].luminance() * std::f32::consts::PI);
//! let (direct, indirect) = (lux("direct").unwrap(), lux("vpl").unwrap() + lux("compensation").unwrap());
//! assert!(direct > indirect && indirect > 0.0);
//! // Half the 95 % interval, relative to the reading.
//! let error = frame.relative_error() * frame.student_factor();
//! assert!(error > 0.0 && error < 0.2, "{error}");
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! What cannot be done is an [`Error`] that says what to change; a file or an argument never makes the library panic.
//!
//! ```
//! use lampyris::integrator;
//! let error = integrator::select(&["direct", "path"]).err().unwrap();
//! assert!(error.to_string().contains("counts twice"));
//! ```
//!
//! # 6. To look at it
//!
//! `output` writes OpenEXR, PNG and Radiance HDR. A terminal does too:
//!
//! ```
//! # use lampyris::backend::{Backend, Batch, Settings};
//! # use lampyris::scene::{Camera, View};
//! # use lampyris::{cpu::Cpu, eye::Eye, import};
//! # use std::path::Path;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! # let scene = import::load(Path::new(file), &import::Options::default())?.scene;
//! # let (eye, target, up) = ([2.78, 2.73, -8.0].into(), [2.78, 2.73, 0.0].into(), [0.0, 1.0, 0.0].into());
//! # let view = View::new(&Camera { name: String::new(), eye, target, up, fov_y: 39.3 }, 48, 48);
//! # let mut cpu = Cpu::new(None)?;
//! # cpu.begin(scene, Eye::Camera(view), &Settings { paths: 32, ..Settings::default() })?;
//! # cpu.add(Batch { index: 0 })?;
//! let picture = cpu.frame()?.mean();
//! let ink = |luminance: f32| b" .:-=+*#%@"[(luminance.max(0.0).sqrt() * 16.0).min(9.0) as usize] as char;
//! // Characters are twice as high as wide: every other row will do.
//! let text: Vec<String> = (picture.chunks(48).step_by(2))
//!     .map(|row| row.iter().map(|pixel| ink(pixel.luminance())).collect())
//!     .collect();
//! println!("{}", text.join("\n"));
//! assert!(text[3].contains('@'), "the lamp is in the ceiling");
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # 7. To work in it
//!
//! A [`session::Session`] is a scene that is edited while its picture grows. An [`scene::Edit`] says what shall be; it
//! takes effect in the next step, can be taken back, and the log of all of them replays to the same picture.
//!
//! ```
//! # use lampyris::{Rgb, backend::Settings, import, scene::Camera};
//! # use std::path::Path;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.mgf");
//! # let mut scene = import::load(Path::new(file), &import::Options::default())?.scene;
//! # let (eye, target, up) = ([2.78, 2.73, -8.0].into(), [2.78, 2.73, 0.0].into(), [0.0, 1.0, 0.0].into());
//! use lampyris::scene::Edit;
//! use lampyris::session::Session;
//!
//! scene.view = Some(Camera { name: "front".into(), eye, target, up, fov_y: 39.3 });
//! let lamp = scene.materials.iter().position(|m| !m.emission.is_black()).unwrap();
//! let settings = Settings { paths: 16, ..Settings::default() };
//! let mut session = Session::open(scene, [24, 24], &settings, None)?;
//! session.settle(2)?;
//! let full = session.frame()?.mean();
//!
//! let emission = session.scene()?.materials[lamp].emission * 0.5;
//! let changes = session.edit(&Edit::Emission { material: lamp as u32, emission })?;
//! assert!(!changes.geometry && changes.emitters == [0]); // no particle takes another way
//! session.settle(2)?;
//! let half = session.frame()?.mean();
//! assert!(full.iter().zip(&half).all(|(f, h)| (f.g - 2.0 * h.g).abs() <= 1e-3 * f.g));
//!
//! session.undo()?;
//! session.settle(2)?;
//! assert_eq!(session.frame()?.mean(), full); // to the bit
//! # Ok::<(), lampyris::Error>(())
//! ```
//!
//! # Features
//!
//! `pictures` (default): the module `output`, with the crates `exr` and `png`. Without it the library needs nothing
//! but arithmetic, threads and serialisation.

/// The programs of README.md, so that they are compiled.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;

/// The programs of CONTRIBUTING.md, so that they are compiled.
#[cfg(doctest)]
#[doc = include_str!("../../../CONTRIBUTING.md")]
pub struct Contributing;

mod atomic;
pub mod backend;
pub mod chromaticity;
pub mod coarse;
pub mod color;
pub mod cpu;
pub mod document;
pub mod elements;
pub mod error;
pub mod eye;
pub mod filter;
pub mod frame;
pub mod geometry;
pub mod import;
pub mod integrator;
pub mod irradiance;
pub mod light;
pub mod map;
pub mod material;
pub mod measuring;
#[cfg(feature = "pictures")]
pub mod output;
pub mod particle;
pub mod photon;
pub mod sampling;
pub mod scatter;
pub mod scene;
pub mod sequence;
pub mod session;
mod settings;
pub mod testing;
pub mod texture;
pub mod world;

pub use color::Rgb;
pub use error::{Error, Result};
