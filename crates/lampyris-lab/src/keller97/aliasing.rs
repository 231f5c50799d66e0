//! Figure 8: how fast pixels converge with the samples of four patterns.

use super::patterns::{JITTERED, JITTERED_HAMMERSLEY, Pattern, RANDOM};
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Image};
use crate::plot::{Axis, Plot, Series};
use crate::statistics::{rms, slope};
use lampyris::Rgb;
use lampyris::material::Class;
use lampyris::output::{Exposure, Picture};
use lampyris::scene::View;
use lampyris::sequence::uniform;
use lampyris::world::World;
use rayon::prelude::*;

pub(crate) const FIGURE_8: Experiment = Experiment {
    name: "keller97-figure-8",
    title: "Convergence of pixel samples by pattern",
    paper: KELLER97,
    place: "Figure 8, §4.1",
    claim: "The RMS error over the sampling rate N = 1 … 64, against a master of 640 samples, of a textured scene: the \
            two-dimensional jittered Hammersley sequence converges even faster than jittered or N-rooks sampling.",
    seconds: [4.0, 40.0],
    run: figure_8,
};

/// One point in each row and in each column.
const ROOKS: Pattern = Pattern {
    name: "N-rooks",
    points: |n, seed| {
        let mut columns: Vec<u32> = (0..n).collect();
        columns.sort_by_key(|i| uniform(seed, *i, 2).to_bits());
        let place = |i: u32, row: u32, d| (f64::from(row) + f64::from(uniform(seed, i, d))) / f64::from(n);
        columns.iter().zip(0..).map(|(column, i)| [place(i, i, 0), place(i, *column, 1)]).collect()
    },
};

fn figure_8(effort: &Effort<'_>) -> Result<Findings> {
    let world = World::new(effort.scene("parlour/parlour.gltf")?);
    let size = effort.of([80, 60], [240, 180]);
    let draws = effort.of(3, 8);
    let Some(camera) = world.scene().cameras.first() else {
        return Err(lampyris::Error::BadSetting("the parlour has no camera".into()).into());
    };
    let view = View::new(camera, size[0], size[1]);
    let rates = [1, 4, 9, 16, 25, 36, 49, 64];
    let patterns = [RANDOM, ROOKS, JITTERED, JITTERED_HAMMERSLEY];
    let master = sampled(&world, &view, &(JITTERED_HAMMERSLEY.points)(640, 4711));
    let mut plot = Plot::new(
        format!("Error of {} × {} pixels", size[0], size[1]),
        Axis::log("samples a pixel, N"),
        Axis::log("RMS error of the shade, 0 to 1"),
    );
    let mut curves = Vec::new();
    for pattern in &patterns {
        let mut points = Vec::new();
        for rate in rates {
            let square = |seed| rms(&sampled(&world, &view, &(pattern.points)(rate, seed)), &master).powi(2);
            let error = ((0..draws).map(square).sum::<f64>() / f64::from(draws)).sqrt();
            points.push([f64::from(rate), error]);
            effort.step(curves.len() * rates.len() + points.len(), patterns.len() * rates.len())?;
        }
        plot = plot.with(Series::line(pattern.name, points.clone()));
        curves.push(points);
    }
    let first = curves[0][0][1];
    let theory = |power: f64| [1.0, 64.0].map(|n: f64| [n, first * libm::pow(n, power)]).to_vec();
    plot = plot.with(Series::dashes("N^-0.5", theory(-0.5))).with(Series::dashes("N^-0.75", theory(-0.75)));
    let mut found = Findings::default();
    found.show(plot);
    let bright = |picture: &[Rgb]| {
        let light = picture.iter().map(|c| *c * 100.0).collect();
        Picture::new(size[0], size[1], light)
    };
    found.show(vec![
        Image::of_light("the master: 640 samples a pixel", bright(&master), Exposure::Ev(0.0)).zoomed(2),
        Image::of_light(
            "jittered Hammersley, 4 samples",
            bright(&sampled(&world, &view, &(JITTERED_HAMMERSLEY.points)(4, 0))),
            Exposure::Ev(0.0),
        )
        .zoomed(2),
    ]);
    // From 16 samples on: below, a pattern of few points has little to be good at.
    let over = |other: usize| {
        let logs = curves[3].iter().zip(&curves[other]).filter(|(own, _)| own[0] >= 16.0);
        let logs: Vec<f64> = logs.map(|(own, other)| libm::log(own[1] / other[1])).collect();
        libm::exp(logs.iter().sum::<f64>() / logs.len() as f64)
    };
    for (number, pattern) in patterns.iter().enumerate().take(3) {
        let what = format!("error of jittered Hammersley over {}, N ≥ 16", pattern.name);
        let says = if number == 0 { "" } else { "converges even faster" };
        found.compare(Comparison::new(what, "", over(number)).says(says).demand(Demand::AtMost(1.0)));
    }
    for (number, paper) in [(0, -0.5), (3, -0.75)] {
        let what = format!("exponent of the error, {}", patterns[number].name);
        let says = "as theory has it for discontinuous functions";
        found.compare(Comparison::new(what, "", slope(&curves[number])).paper(paper).says(says));
    }
    found.gap("The figure's curves and axes are not labelled in the text; the four patterns here are the ones that it names, and random.");
    found.gap("The report's textured scene is not published. Here it is the parlour that ships; what is sampled is the share of light that surfaces reflect, times the cosine, so that nothing but the pixel is integrated.");
    Ok(found)
}

/// The mean of the shade at these places of every pixel, the same in all of them as an accumulation buffer has it.
fn sampled(world: &World, view: &View, places: &[[f64; 2]]) -> Vec<Rgb> {
    let pixel = |k: u32| {
        let (x, y) = ((k % view.width) as f32, (k / view.width) as f32);
        let shade = |place: &[f64; 2]| {
            let ray = view.ray(x + place[0] as f32, y + place[1] as f32);
            world.closest(&ray).map_or(Rgb::BLACK, |s| s.albedo(Class::Dull) * s.cosine(s.wo))
        };
        places.iter().map(shade).fold(Rgb::BLACK, |sum, shade| sum + shade) * (1.0 / places.len() as f32)
    };
    (0..view.width * view.height).into_par_iter().map(pixel).collect()
}
