//! Table 1 and the scenes of §5.1: frames a second, everything worked out anew in each.

use super::WALD02;
use super::workload::{WORKLOADS, Workload};
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use lampyris::backend::{Backend, Batch};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::{Exposure, Picture};
use lampyris::scene::View;
use lampyris::world::World;
use std::path::Path;
use std::time::Instant;

pub(crate) const TABLE_1: Experiment = Experiment {
    name: "wald02-table-1",
    title: "Frames a second over threads",
    paper: WALD02,
    place: "Table 1, §5.3",
    claim: "The algorithm almost perfectly scales over 1 to 16 clients of two processors Athlon MP 1800+ each, at 640 × 480 pixels: \
            room with table 0.4 to 5.3, room with egg 0.3 to 5.4, office 0.2 to 2.4 frames a second.",
    seconds: [8.0, 30.0],
    run: table_1,
};

pub(crate) const SCENES: Experiment = Experiment {
    name: "wald02-scenes",
    title: "Five rooms at interactive rates",
    paper: WALD02,
    place: "§5.1, Figures 4 to 7",
    claim: "At 640 × 480 pixels: table 3.3, egg 2.5, “Invisible Date” 2.6 and office 2.2 frames a second on 8 clients of two processors, \
            conference room 1.7 on 12.",
    seconds: [10.0, 30.0],
    run: scenes,
};

const SIZE: [u32; 2] = [640, 480];

/// Frames a second, shadow rays a pixel, and the picture of the last frame.
fn measure(effort: &Effort<'_>, file: &str, threads: usize, frames: u32) -> Result<(f64, f64, Picture)> {
    let mut cpu = Cpu::new(Some(threads))?;
    let scene = effort.scene(file)?;
    let world = cpu.install(|| World::new(scene));
    let workload = Workload::of(Path::new(file));
    let settings = workload.settings(&world);
    let camera = cpu.install(|| workload.camera(&world, SIZE[0] as f32 / SIZE[1] as f32));
    cpu.begin_world(world, Eye::Camera(View::new(&camera, SIZE[0], SIZE[1])), &settings)?;
    effort.add(&mut cpu, Batch { index: 0 })?;
    let mut times = Vec::new();
    for index in 1..=frames {
        let start = Instant::now();
        effort.add(&mut cpu, Batch { index })?;
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let pixels = f64::from(SIZE[0] * SIZE[1]) * f64::from(frames + 1);
    let rays = cpu.statistics().rays.shadow as f64 / pixels;
    let shown = Picture::new(SIZE[0], SIZE[1], cpu.frame()?.shown());
    Ok((1.0 / times[times.len() / 2], rays, shown))
}

fn table_1(effort: &Effort<'_>) -> Result<Findings> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut threads: Vec<usize> = [1, 2, 4, 8, 16, 32].into_iter().filter(|n| *n < cores).collect();
    threads.push(cores);
    let frames = effort.of(2, 15);
    // Of the paper: clients of two processors each.
    let clients = [1.0, 2.0, 4.0, 8.0, 16.0];
    let rooms = [
        ("table.mgf", "Room with table", [0.4, 0.8, 1.6, 3.2, 5.3]),
        ("egg.mgf", "Room with egg", [0.3, 0.7, 1.4, 2.7, 5.4]),
        ("office.mgf", "Office", [0.2, 0.3, 0.6, 1.2, 2.4]),
    ];
    let mut found = Findings::default();
    let mut table = Table::new(
        "frames a second at 640 × 480",
        ["scene", "ours, by threads", "paper, by 1, 2, 4, 8 and 16 clients of two processors"],
    );
    let mut plot = Plot::new(
        "Frames a second over processors",
        Axis::log("threads, or processors of the paper"),
        Axis::log("frames a second"),
    );
    for (room, (file, name, paper)) in rooms.into_iter().enumerate() {
        let mut rates = Vec::new();
        for (number, n) in threads.iter().enumerate() {
            rates.push(measure(effort, file, *n, frames)?.0);
            effort.step(room * threads.len() + number + 1, rooms.len() * threads.len())?;
        }
        let ours = threads.iter().zip(&rates).map(|(n, rate)| format!("{n}: {}", digits(*rate)));
        table.row([
            file.into(),
            ours.collect::<Vec<_>>().join(", "),
            paper.map(|rate: f64| rate.to_string()).join(", "),
        ]);
        let points = threads.iter().zip(&rates).map(|(n, rate)| [*n as f64, *rate]).collect();
        let theirs = clients.iter().zip(paper).map(|(n, rate)| [2.0 * n, rate]).collect();
        plot = plot.with(Series::line(format!("ours, {file}"), points)).with(Series::dashes(name, theirs));
        let (first, last) = (rates[0], rates[rates.len() - 1]);
        let what = format!("{name}: {cores} threads here over 16 clients there");
        let comparison = Comparison::new(what, "fps", last).paper(paper[4]);
        found.compare(if file == "office.mgf" {
            comparison.demand(Demand::AtLeast(2.4))
        } else {
            comparison
        });
        if cores > 1 {
            let efficiency = last / first / cores as f64;
            let theirs = paper[4] / paper[0] / 16.0;
            let what = format!("{name}: efficiency of {cores} threads, theirs of 16 clients");
            found.compare(Comparison::new(what, "", efficiency).paper(theirs));
        }
    }
    found.show(table);
    found.show(plot);
    found.gap("The scenes were not published. Those that ship are drawn after them, with more triangles where the paper has few.");
    found.gap("Table 1 has 1.2 frames a second for the office on 8 clients, §5.1.3 has 2.2.");
    found.gap("Above 5 frames a second the paper's server is the limit. Over many machines nothing is measured here as yet.");
    Ok(found)
}

fn scenes(effort: &Effort<'_>) -> Result<Findings> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let frames = effort.of(2, 15);
    let paper = |file: &str| match file {
        "table.mgf" => ("Room with table", 3.3, 16.0, 22.0),
        "egg.mgf" => ("Room with egg", 2.5, 16.0, 30.0),
        "foyer.mgf" => ("Invisible Date", 2.6, 16.0, 13.0),
        "office.mgf" => ("Office", 2.2, 16.0, 22.0),
        _ => ("Conference room", 1.7, 24.0, 25.0),
    };
    let mut found = Findings::default();
    let mut table = Table::new(
        format!("640 × 480 pixels, {cores} threads here"),
        [
            "scene",
            "theirs",
            "frames a second",
            "theirs, processors",
            "shadow rays a pixel",
            "theirs",
            "a thread over a processor",
        ],
    );
    let mut images = Vec::new();
    for workload in WORKLOADS {
        let (name, rate, processors, samples) = paper(workload.file);
        let (ours, rays, shown) = measure(effort, workload.file, cores, frames)?;
        table.row([
            workload.file.into(),
            name.into(),
            digits(ours),
            format!("{rate} on {processors}"),
            digits(rays),
            format!("{samples}"),
            digits(ours / cores as f64 / (rate / processors)),
        ]);
        found.compare(
            Comparison::new(format!("{name}: {cores} threads over {processors} processors"), "fps", ours)
                .paper(rate),
        );
        images.push(Image::of_light(
            format!("{} after {} frames", workload.file, frames + 1),
            shown,
            Exposure::Auto,
        ));
        effort.step(images.len(), WORKLOADS.len())?;
    }
    found.show(table);
    found.show(images.into_iter().map(Image::halved).collect::<Vec<_>>());
    found.gap(
        "Pairs whose cosines rule out any light need no shadow ray: rays a pixel are fewer than samples.",
    );
    Ok(found)
}
