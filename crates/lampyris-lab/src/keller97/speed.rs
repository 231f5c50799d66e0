//! Figures 10 and 12: time.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::stage::{CORNELL, Look, found_view, of_1997, picture};
use glam::Vec3;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::scene::Scene;
use lampyris::world::World;
use std::time::Instant;

pub(crate) const FIGURE_10: Experiment = Experiment {
    name: "keller97-figure-10",
    title: "The time of 296 point lights",
    paper: KELLER97,
    place: "Figure 10, §5",
    claim: "128 paths, that is 296 images of 720 × 576 pixels, of a scene of 402 quadrangles in 24 seconds on a Silicon Graphics Onyx \
            with Reality Engine² and a processor R8000 of 75 MHz.",
    seconds: [6.0, 40.0],
    run: figure_10,
};

pub(crate) const FIGURE_12: Experiment = Experiment {
    name: "keller97-figure-12",
    title: "The conference room",
    paper: KELLER97,
    place: "Figure 12, §5",
    claim: "A conference room of 39 584 primitives by 128 paths: independent of the number of extended lights, which is 248.",
    seconds: [10.0, 60.0],
    run: figure_12,
};

const SIZE: [u32; 2] = [720, 576];
const IMAGES: f64 = 296.0;
const SECONDS: f64 = 24.0;

/// One pass over the picture for all points: the shadow rays are the work, as the images were.
fn one_pass(paths: u32) -> Settings {
    Settings {
        parts: vec!["emission".into(), "direct".into(), "vpl".into()],
        passes: Some(1),
        ..of_1997(paths)
    }
}

/// So many paths that there are so many points; and how many there are.
fn paths_for(world: &World, points: f64) -> u32 {
    let tried = points_of(world, 1024) / 1024.0;
    (points / tried.max(1.0)).round().max(1.0) as u32
}

fn points_of(world: &World, paths: u32) -> f64 {
    let settings = one_pass(paths);
    let plan = lampyris::particle::Plan::new(world, &settings);
    let walk = lampyris::particle::Walk::new(world, &settings, &plan, Batch { index: 0 });
    (walk.lights.len() + walk.vpls.len()) as f64
}

/// Median seconds of a batch.
fn seconds(effort: &Effort<'_>, cpu: &mut Cpu, runs: u32) -> Result<f64> {
    let mut times = Vec::new();
    for index in 0..runs {
        let start = Instant::now();
        effort.add(cpu, Batch { index })?;
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

fn figure_10(effort: &Effort<'_>) -> Result<Findings> {
    let runs = effort.of(1, 5);
    let mut found = Findings::default();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut table = Table::new(
        format!("{} × {} pixels, {threads} threads, the median of {runs}", SIZE[0], SIZE[1]),
        [
            "scene",
            "triangles",
            "paths",
            "point lights",
            "seconds",
            "seconds for 296",
            "million shadow rays a second",
        ],
    );
    let office = Look { eye: [0.35, 0.35, 1.5], target: [4.05, 3.70, 0.9], up: Vec3::Z, fov_y: 55.0 };
    let mut images = Vec::new();
    for (name, look, goal) in [("cornell.mgf", CORNELL, Some(2.5)), ("office.mgf", office, None)] {
        let mut cpu = Cpu::new(None)?;
        let scene = effort.scene(name)?;
        let world = cpu.install(|| World::new(scene));
        let paths = paths_for(&world, IMAGES);
        let points = points_of(&world, paths);
        let triangles = triangles(world.scene());
        let view = look.view(SIZE);
        cpu.begin_world(world, Eye::Camera(view.clone()), &one_pass(paths))?;
        let time = seconds(effort, &mut cpu, runs)?;
        let rays = cpu.statistics().rays.shadow as f64 / f64::from(runs);
        let scaled = time * IMAGES / points;
        table.row([
            name.into(),
            triangles.to_string(),
            paths.to_string(),
            format!("{points:.0}"),
            digits(time),
            digits(scaled),
            digits(rays / time / 1e6),
        ]);
        let what = format!("{IMAGES:.0} point lights, {name}");
        let comparison = Comparison::new(what, "s", scaled).paper(SECONDS);
        found.compare(goal.map_or(comparison.clone(), |goal| comparison.demand(Demand::AtMost(goal))));
        let exposure = Exposure::Auto;
        let caption = format!("{name}, {points:.0} point lights");
        images.push(Image::of_light(caption, picture(&view, cpu.frame()?.mean()), exposure).halved());
        effort.step(images.len(), 2)?;
    }
    found.show(table);
    found.show(images);
    found.gap("The greyscale scene of Figure 10, by Peter Shirley, is not at hand. The Cornell box has fewer surfaces, the office ninety times as many triangles as 402 quadrangles.");
    found.gap("What the walk took, and whether the images were antialiased, is not said. Here one eye ray a pixel is shared by all lights, and the time is that of the whole picture.");
    Ok(found)
}

fn triangles(scene: &Scene) -> usize {
    let of = |mesh: u32| scene.meshes.get(mesh as usize).map_or(0, |mesh| mesh.triangles.len());
    scene.instances.iter().map(|instance| of(instance.mesh)).sum()
}

fn figure_12(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([360, 240], [720, 480]);
    let mut found = Findings::default();
    let conference = Look { eye: [0.39, 6.83, 1.6], target: [6.99, 3.02, 0.84], up: Vec3::Z, fov_y: 65.0 };
    let own = effort.scene("conference.mgf")?;
    let mut table = Table::new(
        format!("{} × {} pixels, 128 paths", size[0], size[1]),
        ["scene", "triangles", "lamps", "point lights", "seconds"],
    );
    let mut images = Vec::new();
    let original = effort.further_scene("mgf/conference.mgf")?;
    let scenes = [("conference.mgf", Ok(own), Some(conference)), ("the original", original, None)];
    for (name, scene, look) in scenes {
        let scene = match scene {
            Ok(scene) => scene,
            Err(why) => {
                found.show(why);
                continue;
            }
        };
        let mut cpu = Cpu::new(None)?;
        let world = cpu.install(|| World::new(scene));
        let view = match look {
            Some(look) => look.view(size),
            None => found_view(&cpu, &world, size),
        };
        // Each of many lamps has less than one path: chance must decide which has one, or none would.
        let settings = Settings { absorption: lampyris::backend::Absorption::Fractional, ..one_pass(128) };
        let settings = Settings { sequence: lampyris::sequence::Sequence::SobolOwen, ..settings };
        let plan = lampyris::particle::Plan::new(&world, &settings);
        let walk = lampyris::particle::Walk::new(&world, &settings, &plan, Batch { index: 0 });
        let points = walk.lights.len() + walk.vpls.len();
        let (lamps, triangles) = (world.emitters().len(), triangles(world.scene()));
        cpu.begin_world(world, Eye::Camera(view.clone()), &settings)?;
        let time = seconds(effort, &mut cpu, 1)?;
        table.row([name.into(), triangles.to_string(), lamps.to_string(), points.to_string(), digits(time)]);
        found.compare(Comparison::new(format!("lamps, {name}"), "", lamps as f64).paper(248.0));
        let caption = format!("{name}, 128 paths");
        images.push(Image::of_light(caption, picture(&view, cpu.frame()?.mean()), Exposure::Auto));
        effort.step(images.len(), 2)?;
    }
    found.show(table);
    found.show(images);
    found.gap("The report gives no time for this picture, which it traced by rays.");
    found.gap("Its 248 lights are the panels of the original's lamps. The room that ships is drawn after the one of Wald and others, with 104.");
    Ok(found)
}
