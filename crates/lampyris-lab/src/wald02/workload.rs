//! The workload of §5.1: 3 × 3 interleaved, every virtual light of a class traced from every pixel, a 3 × 3 discontinuity
//! buffer, and of each scene the samples that the paper gives the one of its kind.

use glam::Vec3;
use lampyris::backend::{Batch, Settings};
use lampyris::geometry::Ray;
use lampyris::particle::{Plan, Walk};
use lampyris::scene::{Camera, find_view};
use lampyris::world::World;
use std::path::Path;

/// The workload of a scene: samples a pixel on lights and on surfaces, caustic photons, and the longest path.
pub struct Workload {
    /// Name of the scene's file.
    pub file: &'static str,
    light_points: u32,
    vpls: u32,
    /// In all, where there is glass.
    photons: u32,
    longest: Option<u32>,
    /// Eye, target and vertical field of view [m, degrees], z up; else the scene's camera or a found view.
    view: Option<([f32; 3], [f32; 3], f32)>,
}

/// The scenes that ship.
pub const WORKLOADS: &[Workload] = &[
    Workload { file: "office.mgf", photons: 4000, ..OTHERS },
    Workload {
        file: "table.mgf",
        photons: 500,
        longest: Some(4),
        view: Some(([4.53, 0.39, 1.6], [1.74, 2.53, 1.25], 65.0)),
        ..OTHERS
    },
    Workload {
        file: "egg.mgf",
        light_points: 10,
        vpls: 20,
        photons: 3000,
        longest: Some(4),
        view: Some(([4.35, 0.92, 1.6], [1.87, 3.4, 1.25], 65.0)),
    },
    Workload {
        file: "foyer.mgf",
        vpls: 9,
        photons: 500,
        longest: Some(4),
        view: Some(([2.5, 0.45, 1.6], [4.3, 4.6, 1.35], 66.0)),
        ..OTHERS
    },
    Workload {
        file: "conference.mgf",
        light_points: 5,
        vpls: 20,
        longest: Some(4),
        view: Some(([0.39, 6.83, 1.6], [6.99, 3.02, 0.84], 65.0)),
        ..OTHERS
    },
];

/// Of scenes that do not ship.
const OTHERS: Workload =
    Workload { file: "", light_points: 4, vpls: 18, photons: 0, longest: None, view: None };

impl Workload {
    /// That of a scene of ours, by the file's name, or the usual one.
    pub fn of(file: &Path) -> &'static Workload {
        let name = file.file_name();
        WORKLOADS.iter().find(|w| name == Some(w.file.as_ref())).unwrap_or(&OTHERS)
    }

    /// Where from the scene is looked at: as said here, by the scene's camera, or from where it shows best. To be called on
    /// the threads that may search.
    pub fn camera(&self, world: &World, aspect: f32) -> Camera {
        match (self.view, world.scene().cameras.first()) {
            (Some((eye, target, fov_y)), _) => {
                Camera { name: String::new(), eye: eye.into(), target: target.into(), up: Vec3::Z, fov_y }
            }
            (None, Some(camera)) => camera.clone(),
            _ => find_view(world.scene(), &|ray: &Ray| world.tracer().closest(ray), aspect).camera,
        }
    }

    /// So many paths that a class has the virtual lights asked for in the mean.
    pub fn settings(&self, world: &World) -> Settings {
        const CLASSES: u32 = 9;
        let glass = world.scene().materials.iter().any(|m| m.bsdf.is_solid_interface());
        let caustics = (glass && self.photons > 0).then_some("caustic");
        let settings = Settings {
            parts: ["emission", "direct", "vpl"].into_iter().chain(caustics).map(String::from).collect(),
            photons: self.photons.max(1),
            paths: CLASSES * 64,
            passes: Some(1),
            interleave: [3, 3],
            light_points: Some(CLASSES * self.light_points),
            // More than there are: only where eye paths split, the second ones pick.
            picks: Some(1 << 16),
            longest: self.longest,
            filter: true,
            edges: 0,
            ..Settings::default()
        };
        let plan = Plan::new(world, &settings);
        let tried: usize =
            (0..4).map(|index| Walk::new(world, &settings, &plan, Batch { index }).vpls.len()).sum();
        let per_path = tried as f64 / f64::from(4 * settings.paths);
        let paths = f64::from(CLASSES * self.vpls) / per_path.max(1e-3);
        let paths = (paths.round() as u32).max(CLASSES * self.light_points);
        Settings { paths, ..settings }
    }
}
