//! Figures 5 and 9: the quasi-random walk as a graph, and the picture that each of its points makes, for N = 9.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Image, Table};
use crate::plot::{Axis, Plot, Series};
use crate::stage::{CORNELL, Literal, of_1997, picture};
use lampyris::Rgb;
use lampyris::backend::Batch;
use lampyris::output::Exposure;
use lampyris::particle::{Plan, Walk};
use lampyris::world::World;

pub(crate) const FIGURE_5: Experiment = Experiment {
    name: "keller97-figure-5",
    title: "The integration scheme of the quasi-random walk",
    paper: KELLER97,
    place: "Figure 5 and §3.2; the numbers of §5",
    claim: "Of N particles ⌊ρ̄ʲN⌋ are in generation j, always the first ones; the number M of points stays below N/(1 − ρ̄). \
            128 paths make 296 images.",
    seconds: [0.2, 0.5],
    run: figure_5,
};

pub(crate) const FIGURE_9: Experiment = Experiment {
    name: "keller97-figure-9",
    title: "The pictures that are accumulated for N = 9",
    paper: KELLER97,
    place: "Figure 9, §5",
    claim: "The single images created by the point lights of nine paths, in the order of Figure 5. Close to a point light the image \
            is overmodulated; weighted by 1/N this is hardly perceivable in the sum.",
    seconds: [1.0, 5.0],
    run: figure_9,
};

fn figure_5(effort: &Effort<'_>) -> Result<Findings> {
    let world = World::new(effort.scene("cornell.mgf")?);
    let mean = f64::from(world.mean_reflectance());
    let mut found = Findings::default();
    let mut table = Table::new(
        format!("points of the walk in the Cornell box, ρ̄ = {mean:.3}"),
        ["N", "particles of generation 0, 1, …", "M, all points", "bound N/(1 − ρ̄)"],
    );
    for paths in [9_u32, 128] {
        let settings = of_1997(paths);
        let plan = Plan::new(&world, &settings);
        let walk = Walk::new(&world, &settings, &plan, Batch { index: 0 });
        let of_path = |class| 1 + walk.vpls_of(class).0.len();
        let longest = (0..paths).map(of_path).max().unwrap_or(0);
        let counts: Vec<String> =
            (0..longest).map(|j| (0..paths).filter(|p| of_path(*p) > j).count().to_string()).collect();
        let all = walk.lights.len() + walk.vpls.len();
        let bound = f64::from(paths) / (1.0 - mean);
        table.row([paths.to_string(), counts.join(", "), all.to_string(), format!("{bound:.1}")]);
        if paths == 9 {
            let mut plot = Plot::new(
                "Points of nine paths",
                Axis::linear("path, i").from_to(-0.5, 8.5).of_whole(),
                Axis::linear("generation, j").from_to(-0.5, longest as f64 - 0.5).of_whole(),
            );
            for path in 0..paths {
                let line = (0..of_path(path)).map(|j| [f64::from(path), j as f64]).collect();
                plot = plot.with(Series::line(if path == 0 { "paths and their points" } else { "" }, line));
            }
            found.show(plot);
        } else {
            found.compare(
                Comparison::new("points of 128 paths", "", all as f64)
                    .paper(296.0)
                    .says("in a scene with ρ̄ ≈ 0.57 by that number")
                    .demand(Demand::Within(128.0, bound)),
            );
        }
        effort.step(usize::from(paths == 9), 2)?;
    }
    found.show(table);
    found.gap("The report does not tell the mean reflectance of its scenes. Particles that leave the open box end sooner here than the scheme has it; those of a closed room do not.");
    Ok(found)
}

fn figure_9(effort: &Effort<'_>) -> Result<Findings> {
    let world = World::new(effort.scene("cornell.mgf")?);
    let edge = effort.of(72, 160);
    let view = CORNELL.view([edge, edge]);
    let settings = of_1997(9);
    let plan = Plan::new(&world, &settings);
    let walk = Walk::new(&world, &settings, &plan, Batch { index: 0 });
    let literal = Literal::new(&world, &view);
    let whole = literal.picture(effort, &settings, 0)?;
    // One exposure for all: each picture is shown as bright as if it were the whole.
    let exposure = Exposure::Ev(Exposure::Auto.ev(&whole));
    let mut found = Findings::default();
    let mut images = vec![Image::of_light("the sum", picture(&view, whole.clone()), exposure)];
    let all = walk.lights.len() + walk.vpls.len();
    let mut brightest: f64 = 0.0;
    for path in 0..9 {
        let points = walk.lights_of(path).iter().chain(walk.vpls_of(path).0);
        for (generation, point) in points.enumerate() {
            let light = literal.light_of(std::slice::from_ref(point));
            let largest = light.iter().map(|c| f64::from(c.luminance()) / 9.0).fold(0.0, f64::max);
            brightest = brightest.max(largest);
            let caption = format!("i = {path}, j = {generation}");
            let scaled: Vec<Rgb> = light.into_iter().map(|c| c * (all as f32 / 9.0)).collect();
            images.push(Image::of_light(caption, picture(&view, scaled), exposure));
            effort.step(images.len(), all + 1)?;
        }
    }
    let mean = crate::statistics::mean(&whole);
    let places: Vec<Image> =
        images.drain(..).map(|image| image.zoomed(if edge < 100 { 2 } else { 1 })).collect();
    found.show(format!("Point lights: {all}. Each picture is as bright as if its light were all there is."));
    found.show(places);
    found.compare(
        Comparison::new("brightest pixel of a single image over the mean of the sum", "", brightest / mean)
            .says("hardly perceivable"),
    );
    found.gap("“Hardly perceivable” holds for the frame buffer of 1997, which clips. Without clipping a pixel close to a point light takes any value: the lecture's “structured hotspots”.");
    Ok(found)
}
