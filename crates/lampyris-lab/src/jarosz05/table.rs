//! Table 1: what the phases of photon mapping take, for four kinds of picture.

use super::JAROSZ05;
use super::phases::{Phases, Picture, caustic_photons, global_photons, median};
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::seen::Seen;
use crate::stage::{RING, picture};
use lampyris::backend::{Backend, Batch, Gather, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::world::World;
use std::time::Instant;

pub(crate) const TABLE_1: Experiment = Experiment {
    name: "jarosz05-table-1",
    title: "Photon mapping by phases",
    paper: JAROSZ05,
    place: "Table 1, §3.1",
    claim: "In a Cornell box on a Pentium II of 400 MHz: balancing takes about 1 % of the time of a picture, and is negligible; range search \
            takes 52 % of one with caustics alone, and 47 % of one with a final gather from irradiance kept at photons.",
    seconds: [8.0, 60.0],
    run: table_1,
};

/// A row of the table: its picture, the parts that render it here, and what the thesis has.
struct Row {
    caption: &'static str,
    parts: &'static [&'static str],
    thesis: Line,
}

/// Photons of caustics, their tracing and balancing; global ones, and theirs; range search; total [s].
type Line = [f64; 8];

const ROWS: [Row; 4] = [
    Row {
        caption: "a) direct light",
        parts: &["emission", "direct"],
        thesis: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 16.15],
    },
    Row {
        caption: "b) with a final gather",
        parts: &["emission", "direct", "final-gather"],
        thesis: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 115.0],
    },
    Row {
        caption: "c) with caustics",
        parts: &["emission", "direct", "caustic-map"],
        thesis: [100_000.0, 11.796, 0.632, 0.0, 0.0, 0.0, 31.4, 60.0],
    },
    Row {
        caption: "d) with both",
        parts: &["emission", "direct", "final-gather", "caustic-map"],
        thesis: [100_000.0, 11.575, 0.673, 50_000.0, 2.527, 0.342, 114.4, 244.5],
    },
];

const COLUMNS: [&str; 9] = [
    "",
    "caustic photons",
    "tracing [s]",
    "balancing [s]",
    "global photons",
    "tracing [s]",
    "balancing [s]",
    "range search [s]",
    "total [s]",
];

/// How far caustic photons may lie from what they light, and global ones from where somebody looks for one [m].
const RADIUS: f32 = 0.004;
const WITHIN: f32 = 0.05;

/// Of the irradiance cache that rows b and d gather with.
const ACCURACY: f32 = 0.2;

fn table_1(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([320, 240], [640, 480]);
    let runs = effort.of(3, 9);
    let mut cpu = Cpu::new(None)?;
    let scene = effort.scene("ring.mgf")?;
    let world = cpu.install(|| World::new(scene));
    let [.., Row { thesis, .. }] = &ROWS;
    let plan = cpu.install(|| Picture {
        caustics: number_for(thesis[0], |n| caustic_photons(&world, n).len()),
        paths: number_for(thesis[3], |n| global_photons(&world, n).len()),
        rays: effort.of(4, 16),
        radius: RADIUS,
        within: WITHIN,
        runs,
    });
    let phases = cpu.install(|| Phases::new(&Seen::new(&world, RING, size), plan));
    effort.step(1, 1 + ROWS.len())?;
    let view = RING.view(size);
    let bounds = world.bounds().radius;
    cpu.begin_world(world, Eye::Camera(view.clone()), &settings(&ROWS[0], plan, bounds))?;
    let (mut totals, mut pictures) = (Vec::new(), Vec::new());
    for row in &ROWS {
        cpu.restart(Eye::Camera(view.clone()), &settings(row, plan, bounds))?;
        let mut times = Vec::new();
        for index in 0..runs {
            let start = Instant::now();
            effort.add(&mut cpu, Batch { index })?;
            times.push(start.elapsed().as_secs_f64());
        }
        totals.push(median(times));
        pictures.push(cpu.frame()?.mean());
        effort.step(1 + totals.len(), 1 + ROWS.len())?;
    }
    let ours = lines(&phases, &totals);
    let mut found = Findings::default();
    compare(&mut found, &ours);
    found.show(side_by_side(
        &ours,
        format!("{} × {} pixels of ring.mgf, medians of {runs}", size[0], size[1]),
    ));
    found.show(alone(&phases));
    let exposure = Exposure::Ev(Exposure::Auto.ev(&pictures[3]));
    let image = |(row, light): (&Row, _)| Image::of_light(row.caption, picture(&view, light), exposure);
    found.show(ROWS.iter().zip(pictures).map(image).collect::<Vec<_>>());
    found.gap("The thesis gives neither the size of its picture nor what its Cornell box holds, nor rays, radii and the settings of its irradiance cache. Its counts are taken for what its maps hold.");
    found.gap("The gather of rows b and d interpolates between the points of an irradiance cache, as in the thesis, and looks up surface elements instead of irradiance kept at photons. So in row d the global map, and what the ends of a gather from every pixel ask of it, are measured by themselves and come on top.");
    found.gap("Light that walls reflect onto sharp surfaces makes caustics here as well; the walk that finds them is in the totals of c and d. Times are those of all threads of the machine.");
    Ok(found)
}

/// Of what, so that about so many photons stay.
fn number_for(photons: f64, stay: impl Fn(u32) -> usize) -> u32 {
    let tried = 1 << 14;
    (photons * f64::from(tried) / stay(tried).max(1) as f64).round() as u32
}

/// How a row is rendered; all that the gather of rows b and d does is decided here.
fn settings(row: &Row, plan: Picture, bounds: f32) -> Settings {
    let gather = Gather {
        rays: plan.rays,
        paths: plan.paths,
        element: 0.03,
        radius: plan.radius / bounds,
        cache: Some(ACCURACY),
        ..Gather::default()
    };
    let parts = row.parts.iter().map(|part| (*part).to_owned()).collect();
    Settings { parts, photons: plan.caustics, gather, paths: 64, passes: Some(1), ..Settings::default() }
}

/// What row d takes beyond that: the renderer's gather looks up elements, and does without the global map.
fn on_top(phases: &Phases) -> f64 {
    phases.global.tracing + phases.global.balancing + phases.keeping + phases.looking
}

/// The rows as they were measured.
fn lines(phases: &Phases, totals: &[f64]) -> [Line; 4] {
    let Phases { caustic, global, searching, keeping, looking, .. } = phases;
    let none = [0.0; 3];
    let caustic = [caustic.photons as f64, caustic.tracing, caustic.balancing];
    let global = [global.photons as f64, global.tracing, global.balancing];
    let line = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3], search, total| [a, b, c, d, e, f, search, total];
    [
        line(none, none, 0.0, totals[0]),
        line(none, none, 0.0, totals[1]),
        line(caustic, none, *searching, totals[2]),
        line(caustic, global, searching + keeping + looking, totals[3] + on_top(phases)),
    ]
}

fn compare(found: &mut Findings, ours: &[Line; 4]) {
    let theirs = [0, 1, 2, 3].map(|row: usize| ROWS[row].thesis);
    let of = |what: &str, unit: &str, figure: &dyn Fn(&[Line; 4]) -> f64| {
        Comparison::new(what, unit, figure(ours)).paper(figure(&theirs))
    };
    let negligible = |comparison: Comparison| comparison.says("negligible").demand(Demand::AtMost(5.0));
    found.compare(of("caustic photons traced a second", "thousand", &|t| 1e-3 * t[2][0] / t[2][1]));
    found.compare(of("global photons traced a second", "thousand", &|t| 1e-3 * t[3][3] / t[3][4]));
    found.compare(of("caustic photons balanced a second", "thousand", &|t| 1e-3 * t[2][0] / t[2][2]));
    found
        .compare(negligible(of("share of balancing in the time of c)", "%", &|t| 100.0 * t[2][2] / t[2][7])));
    let both = |t: &[Line; 4]| 100.0 * (t[3][2] + t[3][5]) / t[3][7];
    found.compare(negligible(of("share of balancing in the time of d)", "%", &both)));
    found.compare(of("share of range search in the time of c)", "%", &|t| 100.0 * t[2][6] / t[2][7]));
    found.compare(of("share of range search in the time of d)", "%", &|t| 100.0 * t[3][6] / t[3][7]));
    for (row, name) in [(1, "b)"), (2, "c)"), (3, "d)")] {
        found.compare(of(&format!("time of {name} over that of a)"), "", &|t| t[row][7] / t[0][7]));
    }
}

fn side_by_side(ours: &[Line; 4], title: String) -> Table {
    let mut table = Table::new(title, COLUMNS);
    let cells = |caption: String, line: &Line| {
        let mut cells = line.map(|v| if v > 0.0 { digits(v) } else { "–".into() }).to_vec();
        cells.insert(0, caption);
        cells
    };
    for (row, line) in ROWS.iter().zip(ours) {
        table.rows.push(cells(format!("{}, thesis", row.caption), &row.thesis));
        table.rows.push(cells("ours".into(), line));
    }
    table
}

/// What the thesis has no column for.
fn alone(phases: &Phases) -> Table {
    let Phases { caustic, searching, grid: [sorting, in_the_grid], keeping, looking, ends, .. } = phases;
    let mut table = Table::new(
        "the same photons in the tree and in the grid, and what a gather asks",
        ["what", "time [s]"],
    );
    let mut row = |what: String, time: f64| table.row([what, digits(time)]);
    row(format!("{} caustic photons balanced", caustic.photons), caustic.balancing);
    row("sorted into the hashed grid that the part `caustic` uses".into(), *sorting);
    row("range search in the tree, in the middle of each pixel".into(), *searching);
    row("in the grid".into(), *in_the_grid);
    row("illuminance kept at every fourth global photon".into(), *keeping);
    row(format!("looked up at {ends} ends of rays"), *looking);
    table
}
