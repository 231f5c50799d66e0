//! §4.3: final gathering with and without the discontinuity buffer.

use super::KELLER96;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::stage::{found_view, picture};
use crate::statistics::{median_relative, relative_square};
use lampyris::backend::{Backend, Batch, Gather, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::output::Exposure;
use lampyris::world::World;

pub(crate) const GATHERING: Experiment = Experiment {
    name: "keller96-gathering",
    title: "Final gathering with the discontinuity buffer",
    paper: KELLER96,
    place: "§4.3, indirect diffuse illumination",
    claim: "The discontinuity buffer augments the sample number by using the samples of neighbouring pixels, and so reduces the \
            calls to h(x, ω) by roughly the factor 8.",
    seconds: [14.0, 120.0],
    run: gathering,
};

/// Rays of a pixel; the plain gather with most of them is what the buffer is held against.
const RAYS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

fn gathering(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([120, 90], [320, 240]);
    let scene = effort.scene("office.mgf")?;
    let mut cpu = Cpu::new(None)?;
    let world = cpu.install(|| World::new(scene));
    let view = found_view(&cpu, &world, size);
    let eye = || Eye::Camera(view.clone());
    let of = |rays: u32, filter: bool| Settings {
        parts: vec!["final-gather".into()],
        gather: Gather { rays, paths: effort.of(1 << 16, 1 << 20), ..Gather::default() },
        passes: Some(1),
        interleave: if filter { [5, 5] } else { [1, 1] },
        filter,
        ..Settings::default()
    };
    cpu.begin_world(world, eye(), &of(64, false))?;
    let batches = effort.of(16, 64);
    for index in 0..batches {
        effort.add(&mut cpu, Batch { index: index + 1 })?;
        effort.step(index as usize + 1, batches as usize + 14)?;
    }
    let truth = cpu.frame()?.mean();
    let plot = Plot::new(
        format!("the office, {} × {} pixels, one batch, indirect light alone", size[0], size[1]),
        Axis::log("rays of a pixel"),
        Axis::log("root of the relative mean square error"),
    );
    let mut table = Table::new(
        "the same in figures, and the median of the relative error [%]",
        ["rays of a pixel", "plain", "with the buffer", "plain, median", "with the buffer, median"],
    );
    let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
    let (mut images, mut curves, mut medians) =
        (Vec::new(), [Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
    for (number, rays) in RAYS.into_iter().enumerate() {
        for ((curve, medians), filter) in curves.iter_mut().zip(&mut medians).zip([false, true]) {
            cpu.restart(eye(), &of(rays, filter))?;
            effort.add(&mut cpu, Batch { index: 0 })?;
            let shown = cpu.frame()?.shown();
            curve.push([f64::from(rays), relative_square(&shown, &truth).sqrt()]);
            medians.push([f64::from(rays), 100.0 * median_relative(&shown, &truth)]);
            if (rays == 64 && !filter) || (rays == 16 && filter) {
                let name = format!("{rays} rays{}", if filter { " and the buffer" } else { ", plain" });
                images.push(Image::of_light(name, picture(&view, shown), exposure).zoomed(2));
            }
        }
        let of = |curve: &[[f64; 2]]| digits(curve[number][1]);
        let [[plain, buffered], [plain_median, buffered_median]] =
            [&curves, &medians].map(|two| [of(&two[0]), of(&two[1])]);
        table.row([rays.to_string(), plain, buffered, plain_median, buffered_median]);
        effort.step(batches as usize + 2 * number + 2, batches as usize + 14)?;
    }
    let saved = |[plain, buffered]: &[Vec<[f64; 2]>; 2]| crossing(buffered, plain[RAYS.len() - 1][1]) / 64.0;
    let (saved, saved_in_the_middle) = (saved(&curves), saved(&medians));
    images.push(Image::of_light("the truth", picture(&view, truth), exposure).zoomed(2));
    let mut found = Findings::default();
    let [plain, buffered] = curves;
    let plot = plot.with(Series::line("plain", plain));
    found.show(plot.with(Series::line("with the buffer", buffered)));
    found.show(table);
    found.show(images);
    found.compare(
        Comparison::new("rays with the buffer for the error of 64 rays without, over 64", "", saved)
            .paper(1.0 / 8.0)
            .demand(Demand::AtMost(0.25)),
    );
    found.compare(
        Comparison::new("the same by the median of errors", "", saved_in_the_middle)
            .paper(1.0 / 8.0)
            .demand(Demand::AtMost(0.25)),
    );
    found.gap("The kernel is not given, nor the scene, nor how errors were compared. Here it is 5 × 5 pixels, weighted by planes and normals, with further eye rays where surfaces meet.");
    found.gap("Some of the noise is that of eye paths on the polished floor, in few pixels, which more rays do not take away and the buffer does: the median tells what is saved more truly.");
    found.gap("What is shown by the buffer has a bias at edges that no number of rays takes away; progressive pictures give it up as their sums become exact.");
    Ok(found)
}

/// Where a falling curve of powers comes down to a value: beyond its ends by the slope there.
fn crossing(curve: &[[f64; 2]], value: f64) -> f64 {
    let logs: Vec<[f64; 2]> = curve.iter().map(|p| p.map(libm::log)).collect();
    let value = libm::log(value);
    let last = logs.len() - 2;
    let k = (0..last).find(|k| logs[k + 1][1] <= value).unwrap_or(last);
    let ([x0, y0], [x1, y1]) = (logs[k], logs[k + 1]);
    libm::exp(x0 + (value - y0) / (y1 - y0) * (x1 - x0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_crossed_where_it_is() {
        let curve: Vec<[f64; 2]> = (0..5).map(|k| f64::from(1 << k)).map(|n| [n, 3.0 / n.sqrt()]).collect();
        for n in [0.3, 1.0, 2.5, 16.0, 40.0_f64] {
            assert!((crossing(&curve, 3.0 / n.sqrt()) / n - 1.0).abs() < 1e-12, "{n}");
        }
    }
}
