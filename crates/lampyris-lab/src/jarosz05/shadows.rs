//! §2.2.1: shadow photons in place of shadow rays.

use super::JAROSZ05;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::stage::{CORNELL, found_view, picture};
use crate::statistics::{mean, relative_square};
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::world::World;

pub(crate) const SHADOWS: Experiment = Experiment {
    name: "jarosz05-shadow-photons",
    title: "Shadow photons",
    paper: JAROSZ05,
    place: "§2, §2.2.1, after Jensen and Christensen 1995",
    claim: "It is possible to use the shadow photon information within the global photon map to optimize shadow ray calculations.",
    seconds: [6.0, 60.0],
    run: shadows,
};

fn shadows(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([120, 90], [480, 360]);
    let batches = effort.of(2, 4);
    let mut table = Table::new(
        format!(
            "{} × {} pixels, {batches} batches of 64 light points a pixel, and what was shot for them once",
            size[0], size[1]
        ),
        [
            "scene",
            "shadow rays of a pixel",
            "with shadow photons",
            "rays of the photons, of a pixel",
            "error of pixels [%]",
            "mean over that by rays",
        ],
    );
    let (mut found, mut images) = (Findings::default(), Vec::new());
    let rooms = [("cornell.mgf", "the Cornell box"), ("office.mgf", "the office")];
    for (number, (file, name)) in rooms.into_iter().enumerate() {
        let mut cpu = Cpu::new(None)?;
        let scene = effort.scene(file)?;
        let world = cpu.install(|| World::new(scene));
        let view = if number == 0 { CORNELL.view(size) } else { found_view(&cpu, &world, size) };
        cpu.begin_world(world, Eye::Camera(view.clone()), &settings("direct"))?;
        let pixels = f64::from(size[0] * size[1] * batches);
        let mut light = Vec::new();
        for part in ["direct", "direct-map"] {
            cpu.restart(Eye::Camera(view.clone()), &settings(part))?;
            (0..batches).try_for_each(|index| effort.add(&mut cpu, Batch { index }))?;
            light.push((cpu.frame()?.mean(), cpu.statistics().rays));
            effort.step(2 * number + light.len(), 2 * rooms.len())?;
        }
        let [(truth, all), (ours, left)] = &light[..] else { continue };
        let (over, error) = (mean(ours) / mean(truth), relative_square(ours, truth).sqrt());
        table.row([
            name.to_owned(),
            digits(all.shadow as f64 / pixels),
            digits(left.shadow as f64 / pixels),
            digits((left.particle - all.particle) as f64 / pixels * f64::from(batches)),
            digits(100.0 * error),
            format!("{over:.5}"),
        ]);
        let share = left.shadow as f64 / all.shadow as f64;
        let kept = Comparison::new(format!("{name}: shadow rays left, over all"), "", share);
        found.compare(if number == 0 { kept.demand(Demand::AtMost(0.5)) } else { kept });
        found.compare(
            Comparison::new(format!("{name}: mean light over that by rays"), "", over)
                .demand(Demand::Within(0.999, 1.001)),
        );
        let exposure = Exposure::Ev(Exposure::Auto.ev(truth));
        for ((picture_of, _), by) in light.iter().zip(["by rays", "by shadow photons where they are sure"]) {
            let image =
                Image::of_light(format!("{name}, {by}"), picture(&view, picture_of.clone()), exposure);
            images.push(image.zoomed(effort.of(3, 1)));
        }
    }
    found.show(table);
    found.show(images);
    found.gap("The thesis gives no figures. A point is sure where eight photons or more are all light, or all shadow; elsewhere a ray tells. The office's panels lie in frames, so that few points see them whole, and thin boards let shadow photons through.");
    found.gap(
        "Rays are saved, not time: looking up 64 photons takes longer than the shadow rays of a packet.",
    );
    Ok(found)
}

fn settings(part: &str) -> Settings {
    Settings {
        parts: vec![part.into()],
        paths: 64,
        light_points: Some(64),
        passes: Some(1),
        ..Settings::default()
    }
}
