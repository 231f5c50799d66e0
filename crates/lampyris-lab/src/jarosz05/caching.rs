//! The irradiance cache that the thesis gathers with: its rays and its errors beside those of a gather from every pixel.

use super::JAROSZ05;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::stage::{CORNELL, found_view, picture};
use crate::statistics::{mean, median_relative, relative_square};
use lampyris::backend::{Backend, Batch, Gather, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::scene::View;
use lampyris::world::World;

pub(crate) const CACHING: Experiment = Experiment {
    name: "jarosz05-irradiance-cache",
    title: "Irradiance between points",
    paper: JAROSZ05,
    place: "§2, Table 1 b) and d), after Ward and others 1988 and Ward and Heckbert 1992",
    claim: "Other enhancements include irradiance caching or irradiance gradients at Lambertian surfaces instead of standard path \
            tracing: final gathers are performed using an irradiance cache.",
    seconds: [12.0, 150.0],
    run: caching,
};

/// Rays of a plain gather, from each pixel.
const PLAIN: [u32; 4] = [4, 16, 64, 256];

/// Accuracies of the cache, by records of so many rays of a pixel.
const ACCURACIES: [f32; 4] = [0.1, 0.2, 0.4, 0.8];
const RAYS: u32 = 16;

/// What came of one way to gather.
struct Gathered {
    /// Rays of a pixel, eye rays not counted.
    rays: f64,
    records: u64,
    /// Root of the relative mean square error, and the median error.
    errors: [f64; 2],
}

fn caching(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([120, 90], [320, 240]);
    let mut found = Findings::default();
    for (number, (file, name)) in
        [("cornell.mgf", "the Cornell box"), ("office.mgf", "the office")].into_iter().enumerate()
    {
        room(effort, &mut found, size, [number, 2], (file, name))?;
    }
    found.gap("The thesis does not say how its cache is set. Here records lie by geometry, from coarse to fine over the picture, and are made before it is drawn; R is at most twice the least distance.");
    found.gap("The truth is a gather by many more rays of the same coarse solution along the same eye paths, so that errors are those of the gather alone.");
    Ok(found)
}

/// One room, the `k`-th of so many.
fn room(
    effort: &Effort<'_>,
    found: &mut Findings,
    size: [u32; 2],
    [k, of]: [usize; 2],
    (file, name): (&str, &str),
) -> Result<()> {
    let mut cpu = Cpu::new(None)?;
    let scene = effort.scene(file)?;
    let world = cpu.install(|| World::new(scene));
    let view = if k == 0 { CORNELL.view(size) } else { found_view(&cpu, &world, size) };
    let steps = of * (1 + PLAIN.len() + ACCURACIES.len());
    let mut done = k * steps / of;
    let mut step = || {
        done += 1;
        effort.step(done, steps)
    };
    cpu.begin_world(world, Eye::Camera(view.clone()), &settings(1, None))?;
    let (truth, _) = gather(effort, &mut cpu, &view, &settings(effort.of(512, 1024), None))?;
    step()?;
    let mut table = Table::new(
        format!("{name}, {} × {} pixels, one batch, indirect light alone", size[0], size[1]),
        [
            "gather",
            "rays of a pixel",
            "records",
            "root of the relative mean square error [%]",
            "median error [%]",
        ],
    );
    let mut measure = |caption: String, settings: &Settings| -> Result<(Vec<lampyris::Rgb>, Gathered)> {
        let (light, spent) = gather(effort, &mut cpu, &view, settings)?;
        let errors = [relative_square(&light, &truth).sqrt(), median_relative(&light, &truth)];
        let gathered = Gathered { rays: spent.0, records: spent.1, errors };
        let Gathered { rays, records, errors: [square, median] } = &gathered;
        let records = if *records > 0 { records.to_string() } else { "–".into() };
        table.row([caption, digits(*rays), records, digits(100.0 * square), digits(100.0 * median)]);
        Ok((light, gathered))
    };
    let (mut plain, mut cached, mut shown) = (Vec::new(), Vec::new(), Vec::new());
    for rays in PLAIN {
        let (light, gathered) = measure(format!("{rays} rays from each pixel"), &settings(rays, None))?;
        if rays == RAYS {
            shown.push((format!("{name}: {RAYS} rays from each pixel"), light));
        }
        plain.push(gathered);
        step()?;
    }
    for accuracy in ACCURACIES {
        let (light, gathered) = measure(format!("cache, a = {accuracy}"), &settings(RAYS, Some(accuracy)))?;
        if accuracy == 0.2 {
            shown.push((format!("{name}: irradiance cache, a = {accuracy}"), light));
        }
        cached.push(gathered);
        step()?;
    }
    let curve = |all: &[Gathered]| all.iter().map(|g| [g.rays, 100.0 * g.errors[1]]).collect::<Vec<_>>();
    let plot = Plot::new(name.to_owned(), Axis::log("rays of a pixel"), Axis::log("median error [%]"));
    found.show(
        plot.with(Series::line("from each pixel", curve(&plain)))
            .with(Series::line("irradiance cache", curve(&cached))),
    );
    found.show(table);
    let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
    shown.push((format!("{name}: the truth"), truth));
    let images = shown.into_iter().map(|(caption, light)| {
        Image::of_light(caption, picture(&view, light), exposure).zoomed(effort.of(3, 1))
    });
    found.show(images.collect::<Vec<_>>());
    // The cache of a = 0.2 beside the plain gather of as small a median error, whose errors fall with the root of its rays.
    let own = &cached[1];
    let [.., many] = &plain[..] else { return Ok(()) };
    let as_good = many.rays * (many.errors[1] / own.errors[1]).powi(2);
    found.compare(
        Comparison::new(
            format!("{name}: rays of the cache, a = 0.2, over those of a plain gather of its median error"),
            "",
            own.rays / as_good,
        )
        .demand(Demand::AtMost(0.25)),
    );
    let batches = effort.of(16, 32);
    let mut over = |cache| mean_light(effort, &mut cpu, &view, &settings(RAYS, cache), batches);
    let over = over(Some(0.2))? / over(None)?;
    let what =
        format!("{name}: mean light of {batches} batches by the cache, a = 0.2, over that from each pixel");
    found.compare(Comparison::new(what, "", over).demand(Demand::Within(0.99, 1.01)));
    Ok(())
}

/// The mean of a picture of so many batches.
fn mean_light(
    effort: &Effort<'_>,
    cpu: &mut Cpu,
    view: &View,
    settings: &Settings,
    batches: u32,
) -> Result<f64> {
    cpu.restart(Eye::Camera(view.clone()), settings)?;
    (0..batches).try_for_each(|index| effort.add(cpu, Batch { index }))?;
    Ok(mean(&cpu.frame()?.mean()))
}

/// One batch: the picture, rays of a pixel, and records.
fn gather(
    effort: &Effort<'_>,
    cpu: &mut Cpu,
    view: &View,
    settings: &Settings,
) -> Result<(Vec<lampyris::Rgb>, (f64, u64))> {
    cpu.restart(Eye::Camera(view.clone()), settings)?;
    effort.add(cpu, Batch { index: 0 })?;
    let spent = cpu.statistics();
    let pixels = f64::from(view.width * view.height);
    Ok((cpu.frame()?.mean(), (spent.rays.gather as f64 / pixels, spent.records)))
}

fn settings(rays: u32, cache: Option<f32>) -> Settings {
    Settings {
        parts: vec!["final-gather".into()],
        gather: Gather { rays, paths: 1 << 14, cache, ..Gather::default() },
        passes: Some(1),
        ..Settings::default()
    }
}
