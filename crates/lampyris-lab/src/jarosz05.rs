//! Table 1 of Jarosz' thesis: the phases of photon mapping, as far as they exist here.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Findings, Image, Table, digits};
use crate::stage::{Look, picture};
use glam::Vec3;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::particle::{Plan, Walk};
use lampyris::photon::Photons;
use lampyris::world::World;
use std::time::Instant;

pub(crate) const TABLE_1: Experiment = Experiment {
    name: "jarosz05-table-1",
    title: "Photon mapping by phases",
    paper: "W. Jarosz, Interactive Global Illumination for Improved Lighting Design Workflow, 2005",
    place: "Table 1, §3.1",
    claim: "In a Cornell box on a Pentium II of 400 MHz: 100 000 caustic photons are traced in 11.8 s and balanced in 0.63 s; their range \
            search takes 31.4 s, 52 % of a picture of 60 s.",
    seconds: [3.0, 15.0],
    run: table_1,
};

fn table_1(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([320, 240], [640, 480]);
    let runs = effort.of(3, 9);
    let look = Look { eye: [0.03, -0.62, 0.28], target: [0.0, 0.0, 0.05], up: Vec3::Z, fov_y: 34.0 };
    let view = look.view(size);
    let mut cpu = Cpu::new(None)?;
    let scene = effort.scene("ring.mgf")?;
    let world = cpu.install(|| World::new(scene));
    // Half of the photons leave the light, half the vertices of the walk.
    let parts = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>();
    let settings = Settings {
        parts: parts(&["emission", "direct", "caustic"]),
        photons: 50_000,
        paths: 64,
        passes: Some(1),
        ..Settings::default()
    };
    let plan = Plan::new(&world, &settings);
    let groups: Vec<usize> = (0..plan.layers()).collect();
    let mut tracing = Vec::new();
    let mut kept = 0;
    for index in 0..runs {
        let start = Instant::now();
        let photons = cpu.install(|| {
            let walks: Vec<Walk<'_>> = groups
                .iter()
                .map(|g| Walk::of_layer(&world, &settings, &plan, Batch { index }, *g))
                .collect();
            Photons::new(&world, &settings, &plan, &groups, &walks, Batch { index })
        });
        tracing.push(start.elapsed().as_secs_f64());
        kept = photons.near.photons().len() + photons.far.photons().len();
    }
    effort.step(1, 3)?;
    let eye = Eye::Camera(view.clone());
    cpu.begin_world(world, eye.clone(), &settings)?;
    let with = frame(effort, &mut cpu, runs)?;
    let caustics = cpu.frame()?.mean();
    effort.step(2, 3)?;
    let bare = Settings { parts: parts(&["emission", "direct"]), ..settings };
    cpu.restart(eye, &bare)?;
    let without = frame(effort, &mut cpu, runs)?;
    let traced = median(tracing);
    let search = (with - without - traced).max(0.0);
    let mut table = Table::new(
        format!(
            "{} × {} pixels of ring.mgf, 50 000 photons from the light and as many from walls, of which {kept} are kept [s]",
            size[0], size[1]
        ),
        ["phase", "thesis, 100 000 caustic photons", "ours"],
    );
    table.row(["tracing, and sorting into the grid".into(), "11.796 and 0.632".into(), digits(traced)]);
    table.row(["range search, by difference".into(), "31.4".into(), digits(search)]);
    table.row(["the whole picture".into(), "60".into(), digits(with)]);
    table.row(["without caustics".into(), "16.15".into(), digits(without)]);
    let mut found = Findings::default();
    found.compare(Comparison::new("tracing and sorting 100 000 photons", "s", traced).paper(11.796 + 0.632));
    found.compare(
        Comparison::new("photons traced and sorted a second", "", 100_000.0 / traced)
            .paper(100_000.0 / 12.428),
    );
    found.compare(
        Comparison::new("share of the range search in the picture", "%", 100.0 * search / with).paper(52.0),
    );
    found.show(table);
    found.show(vec![Image::of_light(
        "light of the lamp and its caustics",
        picture(&view, caustics),
        Exposure::Auto,
    )]);
    found.gap("The thesis does not give the size of its picture, and its Cornell box holds other things. Final gather and the global map (rows b and d) are not measured here.");
    found.gap("Lampyris finds photons by a hashed grid, so nothing is balanced; the time is that of all threads of the machine.");
    Ok(found)
}

fn frame(effort: &Effort<'_>, cpu: &mut Cpu, runs: u32) -> Result<f64> {
    let mut times = Vec::new();
    for index in 0..runs {
        let start = Instant::now();
        effort.add(cpu, Batch { index })?;
        times.push(start.elapsed().as_secs_f64());
    }
    Ok(median(times))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
