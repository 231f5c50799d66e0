//! Figure 11 and the lecture's glossy pictures: what point lights make of gloss.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::slides::LECTURE;
use crate::stage::{CORNELL, Literal, made_of, of_1997, of_thing, oracle, picture, without_gloss};
use crate::statistics::{mean, rms};
use lampyris::Rgb;
use lampyris::backend::{Absorption, Backend, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::material::{Bsdf, Class, Diffuse, Material, Ward};
use lampyris::output::Exposure;
use lampyris::particle::Plan;
use lampyris::scene::Scene;
use lampyris::sequence::Sequence;
use lampyris::world::World;

pub(crate) const FIGURE_11: Experiment = Experiment {
    name: "keller97-figure-11",
    title: "Highlights by the full BRDF",
    paper: KELLER97,
    place: "Figure 11, §4.2",
    claim: "T_mn uses the full BRDF f_r in the lighting pass, which enables specular highlights on the floor, for N = 128.",
    seconds: [5.0, 120.0],
    run: figure_11,
};

pub(crate) const GLOSS: Experiment = Experiment {
    name: "lecture-gloss",
    title: "Glossy surfaces under point lights",
    paper: LECTURE,
    place: "“Glossy BRDF”",
    claim: "Pictures of a glossy surface with α = 0.25 and α = 0.1, where single lights become visible as highlights.",
    seconds: [10.0, 320.0],
    run: gloss,
};

/// The Cornell box with a floor of Ward's gloss.
fn glossy(scene: &Scene, alpha: f32) -> Scene {
    let base = Diffuse::opaque(Rgb::grey(0.3));
    let ward =
        Ward { base, specular: Rgb::grey(0.3), alpha, transmission: Rgb::BLACK, transmission_alpha: 0.0 };
    made_of(scene, "floor", Material::new("glossy floor", Bsdf::Ward(ward)))
}

fn figure_11(effort: &Effort<'_>) -> Result<Findings> {
    let edge = effort.of(80, 240);
    let view = CORNELL.view([edge, edge]);
    let scene = glossy(&effort.scene("cornell.mgf")?, 0.18);
    let world = World::new(scene.clone());
    let truth = oracle(effort, &scene, &view, effort.of(256, 2048))?;
    effort.step(1, 3)?;
    let full = Literal::new(&world, &view).picture(effort, &of_1997(128), 0)?;
    effort.step(2, 3)?;
    let diffuse = without_gloss(&scene);
    let diffuse_world = World::new(diffuse);
    let dull = Literal::new(&diffuse_world, &view).picture(effort, &of_1997(128), 0)?;
    let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
    let zoom = if edge < 100 { 3 } else { 1 };
    let mut found = Findings::default();
    let floor = |picture: &[Rgb]| of_thing(&world, &view, picture, "floor");
    let (true_floor, full_floor, dull_floor) = (floor(&truth), floor(&full), floor(&dull));
    found.compare(
        Comparison::new(
            "mean luminance of the floor, full BRDF over the path tracer",
            "",
            mean(&full_floor) / mean(&true_floor),
        )
        .paper(1.0)
        .says("no figure; 1 would be right"),
    );
    found.compare(
        Comparison::new("the same without the glossy lobe", "", mean(&dull_floor) / mean(&true_floor))
            .paper(1.0),
    );
    found.compare(Comparison::new(
        "RMS error of the floor over its mean, full BRDF",
        "%",
        100.0 * rms(&full_floor, &true_floor) / mean(&true_floor),
    ));
    found.show(vec![
        Image::of_light("full BRDF, 128 paths", picture(&view, full), exposure).zoomed(zoom),
        Image::of_light("the diffuse part alone, 128 paths", picture(&view, dull), exposure).zoomed(zoom),
        Image::of_light("the oracle `path`", picture(&view, truth), exposure).zoomed(zoom),
    ]);
    found.gap("The report does not describe its floor. Here it is the Cornell box's with Ward's lobe, ρ_d = 0.3, ρ_s = 0.3, α = 0.18.");
    Ok(found)
}

fn gloss(effort: &Effort<'_>) -> Result<Findings> {
    let edge = effort.of(56, 160);
    let view = CORNELL.view([edge, edge]);
    let box_of = effort.scene("cornell.mgf")?;
    let zoom = if edge < 100 { 3 } else { 1 };
    let mut found = Findings::default();
    // One walk is a draw: what the mean is off by is told from several others.
    let draws = effort.of(3, 24);
    let mut table = Table::new(
        format!("the floor against the path tracer [%]; the mean deviates over {draws} walks"),
        ["α", "estimate", "deviation of the mean", "RMS error over the mean"],
    );
    let alphas = [0.25, 0.1];
    for (number, alpha) in alphas.into_iter().enumerate() {
        let scene = glossy(&box_of, alpha);
        let world = World::new(scene.clone());
        let truth = oracle(effort, &scene, &view, effort.of(192, 4096))?;
        let true_floor = of_thing(&world, &view, &truth, "floor");
        effort.step(2 * number + 1, 2 * alphas.len())?;
        let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
        let all: &'static [Class] = &[Class::Dull, Class::Sharp];
        // By what the clamp would be of a walk of that size.
        let bound = Plan::new(&world, &Settings { paths: 128, passes: Some(1), ..Settings::default() }).bound;
        let mut images = Vec::new();
        let cases: [(&str, f32, &'static [Class]); 3] = [
            ("128 paths, whole BRDF", f32::INFINITY, all),
            ("128 paths, clamped", bound, all),
            ("128 paths, without the lobe that counts as sharp", f32::INFINITY, &[Class::Dull]),
        ];
        for (name, bound, classes) in cases {
            if classes.len() == 1 && alpha >= lampyris::material::SHARP_ALPHA {
                continue;
            }
            let literal = Literal { classes, bound, ..Literal::new(&world, &view) };
            let light = literal.picture(effort, &of_1997(128), 0)?;
            let mut bias = 0.0;
            for batch in 0..draws {
                let settings = Settings {
                    absorption: Absorption::Fractional,
                    sequence: Sequence::SobolOwen,
                    ..of_1997(128)
                };
                let drawn = literal.picture(effort, &settings, batch)?;
                bias += mean(&of_thing(&world, &view, &drawn, "floor")) / f64::from(draws);
            }
            let bias = 100.0 * (bias / mean(&true_floor) - 1.0);
            let floor = of_thing(&world, &view, &light, "floor");
            let error = 100.0 * rms(&floor, &true_floor) / mean(&true_floor);
            table.row([alpha.to_string(), name.into(), digits(bias), digits(error)]);
            if name.ends_with("whole BRDF") {
                found.compare(
                    Comparison::new(format!("error of the floor, point lights, α = {alpha}"), "%", error)
                        .says("single lights show as highlights"),
                );
            }
            images.push(
                Image::of_light(format!("α = {alpha}: {name}"), picture(&view, light), exposure).zoomed(zoom),
            );
        }
        let mut cpu = Cpu::new(None)?;
        let settings = Settings { paths: 128, passes: Some(16), ..Settings::default() };
        effort.render(&mut cpu, (scene, Eye::Camera(view.clone())), &settings, effort.of(4, 32))?;
        let ours = cpu.frame()?.mean();
        let floor = of_thing(&world, &view, &ours, "floor");
        let (bias, error) = (
            100.0 * (mean(&floor) / mean(&true_floor) - 1.0),
            100.0 * rms(&floor, &true_floor) / mean(&true_floor),
        );
        let batches = effort.of(4, 32);
        table.row([
            alpha.to_string(),
            format!("ours, all parts, {batches} batches of 128"),
            digits(bias),
            digits(error),
        ]);
        found.compare(
            Comparison::new(format!("bias of our floor, all parts, α = {alpha}"), "%", bias)
                .demand(Demand::Within(-2.0, 2.0)),
        );
        images.push(
            Image::of_light(format!("α = {alpha}: all parts of Lampyris"), picture(&view, ours), exposure)
                .zoomed(zoom),
        );
        images.push(
            Image::of_light(format!("α = {alpha}: the oracle `path`"), picture(&view, truth), exposure)
                .zoomed(zoom),
        );
        found.show(images);
        effort.step(2 * number + 2, 2 * alphas.len())?;
    }
    found.show(table);
    found.gap("The lecture has pictures without numbers. Lampyris gathers lobes of α ≥ 0.15 from point lights and follows sharper ones from the eye.");
    Ok(found)
}
