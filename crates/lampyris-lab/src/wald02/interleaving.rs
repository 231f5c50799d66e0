//! Figure 3: interleaved sampling and the discontinuity buffer, by the same number of rays.

use super::WALD02;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::stage::{CORNELL, picture};
use crate::statistics::median_relative;
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::scene::View;
use lampyris::world::World;

pub(crate) const FIGURE_3: Experiment = Experiment {
    name: "wald02-figure-3",
    title: "Interleaved sampling and the discontinuity buffer",
    paper: WALD02,
    place: "Figure 3, §4.2 and §4.3",
    claim: "Close-ups by the same number of rays: a) one set of point lights, b) 25 sets interleaved, c) and d) with discontinuity \
            buffers. Choosing the filter size appropriate to the interleaving factor completely removes the structured noise.",
    seconds: [6.0, 110.0],
    run: figure_3,
};

/// Light points and virtual lights that light a pixel.
const LIGHTS: u32 = 4;
const VPLS: f64 = 18.0;

/// The truth has so many times so many more of both.
const MORE: u32 = 4;

fn figure_3(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([256, 256], [400, 400]);
    let draws = effort.of(3, 16);
    let mut cpu = Cpu::new(None)?;
    let scene = effort.scene("cornell.mgf")?;
    let world = cpu.install(|| World::new(scene));
    let view = CORNELL.view(size);
    let per_path = points_a_path(&world);
    cpu.begin_world(world, Eye::Camera(view.clone()), &settings(per_path, 1, false))?;
    // The truth of what all of them estimate: a) unfiltered, by many batches of many paths, under the same clamp.
    let one = settings(per_path, 1, false);
    let more = Settings {
        paths: MORE * MORE * one.paths,
        light_points: one.light_points.map(|n| MORE * MORE * n),
        clamp: MORE as f32 * one.clamp,
        seed: 77,
        ..one
    };
    let truth = many(effort, &mut cpu, &view, &more)?;
    effort.step(1, 6)?;
    let cases = [
        ("a) one set", 1, false),
        ("b) 25 sets, unfiltered", 5, false),
        ("c) 9 sets, buffer 3 × 3", 3, true),
        ("d) 25 sets, buffer 5 × 5", 5, true),
    ];
    let mut found = Findings::default();
    let mut table = Table::new(
        format!(
            "one frame of the Cornell box, {} × {} pixels, against many batches; the mean of {draws} frames",
            size[0], size[1]
        ),
        ["", "shadow rays a pixel", "median relative error of pixels [%]"],
    );
    let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
    let (mut images, mut errors) = (Vec::new(), Vec::new());
    for (number, (name, edge, filter)) in cases.into_iter().enumerate() {
        let (mut error, mut rays) = (0.0, 0.0);
        for draw in 0..draws {
            let settings = Settings { seed: draw, ..settings(per_path, edge, filter) };
            cpu.restart(Eye::Camera(view.clone()), &settings)?;
            effort.add(&mut cpu, Batch { index: 0 })?;
            let shown = cpu.frame()?.shown();
            error += 100.0 * median_relative(&shown, &truth) / f64::from(draws);
            rays += cpu.statistics().rays.shadow as f64 / f64::from(size[0] * size[1]) / f64::from(draws);
            if draw == 0 {
                images.push(Image::of_light(name, picture(&view, shown), exposure));
            }
        }
        table.row([name.into(), digits(rays), digits(error)]);
        errors.push(error);
        effort.step(number + 2, 6)?;
    }
    images.push(Image::of_light("many batches", picture(&view, truth), exposure));
    found.show(images);
    found.show(table);
    found.compare(
        Comparison::new("error of d) over that of a)", "", errors[3] / errors[0])
            .says("much better visual quality")
            .demand(Demand::AtMost(0.7)),
    );
    found.compare(
        Comparison::new("error of d) over that of b)", "", errors[3] / errors[1])
            .says("completely removes the structured noise")
            .demand(Demand::AtMost(0.5)),
    );
    found.compare(Comparison::new("error of c) over that of d)", "", errors[2] / errors[3]));
    found.gap("Picture c) of the paper has a filter smaller than the interleaving. Here the buffer has the size of the interleaving always, so c) is 3 × 3 of both.");
    found.gap("Of the scene in the close-ups nothing is published. The Cornell box is smooth and dull, so that little but the light of the sets differs between the pictures.");
    found.gap("The paper shows close-ups and no errors.");
    Ok(found)
}

/// So many paths that VPLS virtual lights light a pixel, whatever the number of sets. The clamp is that of one set: its radius
/// falls as one over the root of the paths, and each picture would be of another light.
fn settings(per_path: f64, edge: u32, filter: bool) -> Settings {
    let sets = edge * edge;
    Settings {
        parts: ["direct", "vpl"].map(String::from).into(),
        paths: (f64::from(sets) * VPLS / per_path).round().max(f64::from(sets * LIGHTS)) as u32,
        passes: Some(1),
        interleave: [edge, edge],
        light_points: Some(sets * LIGHTS),
        clamp: edge as f32 * Settings::default().clamp,
        filter,
        edges: 0,
        ..Settings::default()
    }
}

/// Virtual lights that a path leaves in the mean.
fn points_a_path(world: &World) -> f64 {
    let settings = Settings { paths: 1024, passes: Some(1), ..Settings::default() };
    let plan = lampyris::particle::Plan::new(world, &settings);
    lampyris::particle::Walk::new(world, &settings, &plan, Batch { index: 0 }).vpls.len() as f64 / 1024.0
}

fn many(effort: &Effort<'_>, cpu: &mut Cpu, view: &View, settings: &Settings) -> Result<Vec<Rgb>> {
    cpu.restart(Eye::Camera(view.clone()), settings)?;
    for index in 0..effort.of(40, 500) {
        effort.add(cpu, Batch { index })?;
    }
    Ok(cpu.frame()?.mean())
}
