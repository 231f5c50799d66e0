//! How each way of Lampyris to the whole light converges to that of the oracle.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::stage::{CORNELL, RING, oracle_by, picture};
use crate::statistics::{mean, relative_square_between, slope};
use lampyris::Rgb;
use lampyris::backend::{Absorption, Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::integrator;
use lampyris::output::Exposure;
use lampyris::scene::{Scene, View};
use lampyris::world::World;

pub(crate) const CONVERGENCE: Experiment = Experiment {
    name: "convergence",
    title: "Every integrator against the oracle",
    paper: "Lampyris",
    place: "the partition of path space, docs/light-transport.md",
    claim: "All parts together are the light of the path tracer, without bias but for the blur of caustics that shrinks from batch to \
            batch: the relative mean square error falls as one over the batches, or faster.",
    seconds: [12.0, 90.0],
    run: convergence,
};

/// A name, its parts and how its particles thin out.
type Way = (&'static str, Vec<String>, Absorption);

fn ways() -> Vec<Way> {
    let whole = || integrator::WHOLE.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>();
    let without = |name: &str| whole().into_iter().filter(|n| n != name).collect::<Vec<_>>();
    let by_paths = || without("caustic").into_iter().chain(["caustic-path".to_owned()]).collect::<Vec<_>>();
    let by_shadows = || without("direct").into_iter().chain(["direct-map".to_owned()]).collect::<Vec<_>>();
    let full_solution = || integrator::FULL_SOLUTION.iter().map(|n| (*n).to_owned()).collect();
    vec![
        ("all parts", whole(), Absorption::Fractional),
        ("all, by roulette", whole(), Absorption::Roulette),
        ("all, ⌊ρ̄ʲN⌋", whole(), Absorption::Paper),
        ("caustics by paths", by_paths(), Absorption::Fractional),
        ("direct light by shadow photons", by_shadows(), Absorption::Fractional),
        ("not compensated", without("compensation"), Absorption::Fractional),
        ("full solution of 1996", full_solution(), Absorption::Fractional),
        ("path", vec!["path".into()], Absorption::Fractional),
    ]
}

fn convergence(effort: &Effort<'_>) -> Result<Findings> {
    let edge = effort.of(24, 64);
    let most = effort.of(32, 256);
    let scenes = [("cornell.mgf", CORNELL), ("ring.mgf", RING)];
    let mut found = Findings::default();
    for (number, (file, look)) in scenes.into_iter().enumerate() {
        let scene = effort.scene(file)?;
        let view = look.view([edge, edge]);
        // Known twice: what noise the oracle itself has is then no error of ours.
        let half = |seed| oracle_by(effort, &scene, &view, (effort.of(1024, 8192), seed));
        let halves = [half(9_001)?, half(9_002)?];
        let truth: Vec<Rgb> = halves[0].iter().zip(&halves[1]).map(|(a, b)| (*a + *b) * 0.5).collect();
        // What errors are told over knows nothing of theirs, and has less of its own.
        let over = all_parts(effort, &scene, &view, most)?;
        let lit = is_lit(&truth);
        let steps = 2 * (ways().len() + 1);
        effort.step(number * (ways().len() + 1) + 1, steps)?;
        let mut plot = Plot::new(
            format!("{file}, {edge} × {edge} pixels, against the path tracer"),
            Axis::log("batches of 16 light paths and eye paths"),
            Axis::log("relative mean square error"),
        );
        let mut table = Table::new(
            format!("{file}: relative mean square error, and the mean of the picture over the oracle's"),
            ["way", "first batch", "last batch", "exponent", "mean over the oracle's"],
        );
        let mut images = Vec::new();
        let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
        for (way, (name, parts, absorption)) in ways().into_iter().enumerate() {
            let settings = Settings { parts, absorption, paths: 16, photons: 1 << 12, ..Settings::default() };
            let mut cpu = Cpu::new(None)?;
            let world = cpu.install(|| World::new(scene.clone()));
            cpu.begin_world(world, Eye::Camera(view.clone()), &settings)?;
            let mut points = Vec::new();
            for index in 0..most {
                effort.add(&mut cpu, Batch { index })?;
                if (index + 1).is_power_of_two() {
                    let ours = kept(&cpu.frame()?.mean(), &lit);
                    let [a, b] = [0, 1].map(|half: usize| kept(&halves[half], &lit));
                    points.push([
                        f64::from(index + 1),
                        relative_square_between(&ours, [&a, &b], &kept(&over, &lit)),
                    ]);
                }
            }
            let ours = cpu.frame()?.mean();
            let ratio = mean(&kept(&ours, &lit)) / mean(&kept(&truth, &lit));
            let power = slope(&points);
            table.row([
                name.into(),
                digits(points[0][1]),
                digits(points[points.len() - 1][1]),
                digits(power),
                format!("{ratio:.4}"),
            ]);
            if way == 0 {
                let what = format!("{file}, {name}: exponent of the error over batches");
                found.compare(
                    Comparison::new(what, "", power)
                        .paper(-1.0)
                        .says("by chance")
                        .demand(Demand::AtMost(-0.8)),
                );
            }
            if way == 0 {
                let what = format!("{file}, {name}: mean over the oracle's");
                found.compare(Comparison::new(what, "", ratio).demand(Demand::Within(0.98, 1.02)));
                images.push(
                    Image::of_light(format!("{name}, {most} batches"), picture(&view, ours), exposure)
                        .zoomed(if edge < 50 { 8 } else { 4 }),
                );
            }
            plot = plot.with(Series::line(name, points));
            effort.step(number * (ways().len() + 1) + way + 2, steps)?;
        }
        images.push(
            Image::of_light("the oracle `path`", picture(&view, truth), exposure).zoomed(if edge < 50 {
                8
            } else {
                4
            }),
        );
        found.show(plot);
        found.show(table);
        found.show(images);
    }
    found.gap("⌊ρ̄ʲN⌋, what is not compensated, shadow photons and the full solution of 1996 are biased: their curves level off. What noise the oracle has itself is taken out: each error is the product of the differences from two of its pictures.");
    Ok(found)
}

/// The picture by all parts in so many batches.
fn all_parts(effort: &Effort<'_>, scene: &Scene, view: &View, batches: u32) -> Result<Vec<Rgb>> {
    let mut cpu = Cpu::new(None)?;
    let settings = Settings { paths: 16, photons: 1 << 12, seed: 9_003, ..Settings::default() };
    effort.render(&mut cpu, (scene.clone(), Eye::Camera(view.clone())), &settings, batches)?;
    Ok(cpu.frame()?.mean())
}

/// Where light falls; lamps and their edges are left out, where pixels differ by what their samples happen to see of the lamp.
fn is_lit(truth: &[Rgb]) -> Vec<bool> {
    let mut sorted: Vec<f32> = truth.iter().map(|c| c.luminance()).collect();
    sorted.sort_by(f32::total_cmp);
    let most = 4.0 * sorted[sorted.len() * 9 / 10];
    truth.iter().map(|c| c.luminance() > 0.0 && c.luminance() < most).collect()
}

fn kept(picture: &[Rgb], lit: &[bool]) -> Vec<Rgb> {
    picture.iter().zip(lit).filter(|(_, lit)| **lit).map(|(c, _)| *c).collect()
}
