//! The lecture's pictures of 10, 100 and 1000 samples, and what clamping takes.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::slides::LECTURE;
use crate::stage::{CORNELL, Literal, of_1997, oracle, picture};
use crate::statistics::{mean, rms, slope};
use lampyris::Rgb;
use lampyris::backend::Settings;
use lampyris::output::Exposure;
use lampyris::particle::Plan;
use lampyris::world::World;

pub(crate) const ARTIFACTS: Experiment = Experiment {
    name: "lecture-artifacts",
    title: "10, 100 and 1000 samples",
    paper: LECTURE,
    place: "“10 samples” to “1000 samples”, “Artifacts”",
    claim: "Unlike path tracing no noise, but structured hotspots by the singularity of the form factor. Clamping the contribution of \
            samples is no longer unbiased, and loses energy around edges.",
    seconds: [8.0, 180.0],
    run: artifacts,
};

fn artifacts(effort: &Effort<'_>) -> Result<Findings> {
    let edge = effort.of(60, 200);
    let view = CORNELL.view([edge, edge]);
    let scene = effort.scene("cornell.mgf")?;
    let world = World::new(scene.clone());
    let truth = oracle(effort, &scene, &view, effort.of(256, 4096))?;
    effort.step(1, 7)?;
    let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
    let zoom = if edge < 100 { 3 } else { 1 };
    let mut found = Findings::default();
    let plain = |picture: &[Rgb]| Literal::new(&world, &view).without_lamps(picture);
    let plain_truth = plain(&truth);
    let mut images = Vec::new();
    let mut table = Table::new(
        "one walk of the report against the path tracer, pixels that show the lamp left out [%; the last a factor]",
        [
            "paths",
            "RMS error over the mean",
            "the same, clamped",
            "light taken by the clamp",
            "brightest pixel over the true one",
        ],
    );
    let (mut free, mut clamped, mut taken) = (Vec::new(), Vec::new(), Vec::new());
    for (number, paths) in [10_u32, 100, 1000].into_iter().enumerate() {
        let literal = Literal::new(&world, &view);
        let light = literal.picture(effort, &of_1997(paths), 0)?;
        // What the clamp would be by our settings.
        let bound = Plan::new(&world, &Settings { paths, passes: Some(1), ..Settings::default() }).bound;
        let held = Literal { bound, ..Literal::new(&world, &view) }.picture(effort, &of_1997(paths), 0)?;
        let relative = |picture: &[Rgb]| 100.0 * rms(&plain(picture), &plain_truth) / mean(&plain_truth);
        let lost = 100.0 * (1.0 - mean(&plain(&held)) / mean(&plain(&light)));
        let most =
            |picture: &[Rgb]| plain(picture).iter().map(|c| f64::from(c.luminance())).fold(0.0, f64::max);
        let (a, b) = (relative(&light), relative(&held));
        table.row([
            paths.to_string(),
            digits(a),
            digits(b),
            digits(lost),
            digits(most(&light) / most(&truth)),
        ]);
        free.push([f64::from(paths), a]);
        clamped.push([f64::from(paths), b]);
        taken.push([f64::from(paths), lost]);
        let mut show = |what: String, light| {
            images.push(Image::of_light(what, picture(&view, light), exposure).zoomed(zoom))
        };
        show(format!("{paths} paths"), light);
        show(format!("{paths} paths, clamped"), held);
        effort.step(2 * number + 3, 7)?;
    }
    images.push(Image::of_light("the oracle `path`", picture(&view, truth.clone()), exposure).zoomed(zoom));
    found.show(images);
    found.show(table);
    let plot = Plot::new(
        "Error of one walk, and what the clamp takes",
        Axis::log("paths, N"),
        Axis::log("of the mean luminance [%]"),
    );
    found.show(
        plot.with(Series::line("RMS error", free.clone()))
            .with(Series::line("RMS error, clamped", clamped))
            .with(Series::line("taken by the clamp", taken.clone())),
    );
    found.compare(
        Comparison::new("exponent of the error, 10 to 1000 paths", "", slope(&free))
            .says("1000 samples look converged")
            .demand(Demand::AtMost(-0.4)),
    );
    for (n, lost) in taken.iter().map(|p| (p[0], p[1])) {
        found.compare(
            Comparison::new(format!("light taken by the clamp, {n} paths"), "%", lost)
                .says("loss of energy around edges"),
        );
    }
    found.gap("The lecture does not say how it clamps. The bound here is that of Lampyris, which falls with the number of points; Lampyris pays back what is taken by short rays (the part `compensation`).");
    Ok(found)
}
