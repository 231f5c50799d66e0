//! The bias of the full solution, tile by tile: over the size of elements, and over the radius within which particles count.

use super::KELLER96;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, signed};
use crate::plot::{Axis, Plot, Series};
use crate::seen::Seen;
use crate::stage::{CORNELL, RING, picture};
use crate::statistics::{blocks, mean, slope};
use lampyris::Rgb;
use lampyris::backend::{Backend, Batch, Gather, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::integrator::{FULL_SOLUTION, WHOLE};
use lampyris::map::{Estimate, Kernel, Photon, PhotonMap, Reach};
use lampyris::material::{Bsdf, Diffuse, Ward};
use lampyris::output::Exposure;
use lampyris::photon;
use lampyris::scene::{Scene, View};
use lampyris::world::World;

pub(crate) const FULL: Experiment = Experiment {
    name: "keller96-full-solution",
    title: "The bias of the full solution",
    paper: KELLER96,
    place: "§4.2, §4.3",
    claim: "L₀ + T_fd L₀ + T_fd T_fd L + T_fs L + T_fd T_fs L is the full solution, by means of elements and by particles in balls.",
    seconds: [12.0, 200.0],
    run: full,
};

pub(crate) const RADIUS: Experiment = Experiment {
    name: "keller96-radius",
    title: "The bias of particles in balls",
    paper: KELLER96,
    place: "§4.2, equation 4.4, §4.3",
    claim: "Radiance is estimated by the particles in a ball around the point, over the area of its section, which is approximately what \
            the ball covers of the surface. Where glossy light is seen, and for caustics, this is all there is.",
    seconds: [10.0, 120.0],
    run: radius,
};

/// Edge of a tile [pixels].
const TILE: u32 = 16;

/// A picture twice, by numbers that have nothing to do with each other: errors of one half do not know those of the other.
type Halves = [Vec<Rgb>; 2];

/// What renders halves.
struct Stage<'a> {
    effort: &'a Effort<'a>,
    cpu: Cpu,
    view: View,
}

impl<'a> Stage<'a> {
    fn new(effort: &'a Effort<'a>, scene: Scene, size: [u32; 2], settings: &Settings) -> Result<Stage<'a>> {
        let mut cpu = Cpu::new(None)?;
        let world = cpu.install(|| World::new(scene));
        let view = CORNELL.view(size);
        cpu.begin_world(world, Eye::Camera(view.clone()), settings)?;
        Ok(Stage { effort, cpu, view })
    }

    /// Of so many batches each.
    fn halves(&mut self, settings: &Settings, batches: u32) -> Result<Halves> {
        let Stage { effort, cpu, view } = self;
        let mut half = |seed| -> Result<Vec<Rgb>> {
            cpu.restart(Eye::Camera(view.clone()), &Settings { seed, ..settings.clone() })?;
            (0..batches).try_for_each(|index| effort.add(cpu, Batch { index }))?;
            Ok(cpu.frame()?.mean())
        };
        Ok([half(1)?, half(2)?])
    }

    /// How far a world's [`Gather::radius`] of one is [m].
    fn reach(&self) -> f32 {
        self.cpu.world().map_or(1.0, |world| world.bounds().radius)
    }
}

/// Both halves together.
fn whole([a, b]: &Halves) -> Vec<Rgb> {
    a.iter().zip(b).map(|(a, b)| (*a + *b) * 0.5).collect()
}

/// How much brighter than the truth a picture is; of 1.
struct Bias {
    /// As a whole.
    mean: f64,
    /// The least and the most of the tiles, noise included.
    tiles: [f64; 2],
    /// Of the tiles in the mean square, without what is noise: each square is the product of two halves.
    square: f64,
}

impl Bias {
    /// Tiles that have less light than `least` of what they have in the mean are held against that.
    fn new(ours: &Halves, truth: &Halves, size: [u32; 2], least: f64) -> Bias {
        let of = |ours: &[Rgb], truth: &[Rgb]| biases(ours, truth, size, least);
        let tiles = of(&whole(ours), &whole(truth));
        let fold = |pick: fn(f64, f64) -> f64| tiles.iter().copied().fold(0.0, pick);
        let [a, b] = [0, 1].map(|half| of(&ours[half], &truth[half]));
        let square = a.iter().zip(&b).map(|(a, b)| a * b).sum::<f64>() / a.len().max(1) as f64;
        Bias {
            mean: mean(&whole(ours)) / mean(&whole(truth)) - 1.0,
            tiles: [fold(f64::min), fold(f64::max)],
            square: square.max(0.0).sqrt(),
        }
    }

    /// Cells of a table: mean, least, most, in the mean square [%].
    fn cells(&self) -> [String; 4] {
        let [mean, least, most] = [self.mean, self.tiles[0], self.tiles[1]].map(|bias| signed(100.0 * bias));
        [mean, least, most, format!("{:.2}", 100.0 * self.square)]
    }
}

/// How much brighter each tile is.
fn biases(ours: &[Rgb], truth: &[Rgb], [width, height]: [u32; 2], least: f64) -> Vec<f64> {
    let sum = |picture: &[Rgb], (left, top): (u32, u32)| {
        let pixels = (0..TILE * TILE).map(|k| (top + k / TILE) * width + left + k % TILE);
        pixels.map(|k| f64::from(picture[k as usize].luminance())).sum::<f64>()
    };
    let corners = (0..height / TILE).flat_map(|y| (0..width / TILE).map(move |x| (x * TILE, y * TILE)));
    let pairs: Vec<[f64; 2]> = corners.map(|corner| [sum(ours, corner), sum(truth, corner)]).collect();
    let least = least * pairs.iter().map(|pair| pair[1]).sum::<f64>() / pairs.len().max(1) as f64;
    let held = pairs.into_iter().filter(|[_, truth]| truth.max(least) > 0.0);
    held.map(|[ours, truth]| (ours - truth) / truth.max(least)).collect()
}

/// The largest of one square over that before it: below one where each step falls.
fn worst_step(squares: &[[f64; 2]]) -> f64 {
    squares.windows(2).map(|pair| pair[1][1] / pair[0][1]).fold(0.0, f64::max)
}

fn named(parts: &[&str]) -> Vec<String> {
    parts.iter().map(|part| (*part).to_owned()).collect()
}

const COLUMNS: [&str; 4] =
    ["mean [%]", "least tile [%]", "most [%]", "in the mean square, without noise [%]"];

fn full(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([64, 64], [256, 256]);
    // At the edge of a lamp chance decides how much of it a pixel sees.
    let parts = |parts: &[&'static str]| {
        named(&parts.iter().copied().filter(|p| *p != "emission").collect::<Vec<_>>())
    };
    let exact = Settings { parts: parts(WHOLE), paths: 1024, passes: Some(16), ..Settings::default() };
    let mut stage = Stage::new(effort, effort.scene("cornell.mgf")?, size, &exact)?;
    // The same batches of both: they look at the same places in each pixel.
    let batches = effort.of(4, 32);
    let truth = stage.halves(&exact, batches)?;
    let sizes = [2.4, 1.2, 0.6, 0.3];
    effort.step(1, sizes.len() + 1)?;
    let [a, b, c, d] = COLUMNS;
    let mut table = Table::new(
        format!("the Cornell box, 5.5 m wide, tiles of {TILE} × {TILE} pixels; bias of luminance"),
        ["elements [m]", a, b, c, d],
    );
    let mut found = Findings::default();
    let (mut images, mut squares) = (Vec::new(), Vec::new());
    let exposure = Exposure::Ev(Exposure::Auto.ev(&whole(&truth)));
    let zoom = effort.of(3, 1);
    for (number, element) in sizes.into_iter().enumerate() {
        let gather = Gather { rays: 4, paths: 1 << 15, element, ..Gather::default() };
        let ours =
            stage.halves(&Settings { parts: parts(FULL_SOLUTION), gather, ..exact.clone() }, batches)?;
        let bias = Bias::new(&ours, &truth, size, 0.0);
        let [a, b, c, d] = bias.cells();
        table.row([element.to_string(), a, b, c, d]);
        squares.push([f64::from(element), bias.square]);
        if number + 1 == sizes.len() {
            found.compare(
                Comparison::new(
                    "mean over that of the unbiased parts, elements of 0.3 m",
                    "",
                    1.0 + bias.mean,
                )
                .demand(Demand::Within(0.99, 1.01)),
            );
        }
        let light = picture(&stage.view, whole(&ours));
        images.push(Image::of_light(format!("elements of {element} m"), light, exposure).zoomed(zoom));
        effort.step(number + 2, sizes.len() + 1)?;
    }
    found.compare(
        Comparison::new(
            "bias of tiles by elements half as large over that before, worst of 3 steps",
            "",
            worst_step(&squares),
        )
        .demand(Demand::AtMost(1.0)),
    );
    let light = picture(&stage.view, whole(&truth));
    images.push(Image::of_light("the unbiased parts", light, exposure).zoomed(zoom));
    found.show(table);
    found.show(images);
    found.gap("How fine the elements are, the paper does not say: it takes the triangles of the scene as they come.");
    found.gap("Light leaves an element evenly here, whatever its gloss; what gloss sees, photons light.");
    Ok(found)
}

/// How often r is halved, and photons are taken four times.
const HALVINGS: u32 = 3;

fn radius(effort: &Effort<'_>) -> Result<Findings> {
    let mut found = Findings::default();
    let mut plot = Plot::new(
        "Bias of tiles, by four times the photons for half the radius",
        Axis::log("radius r [m]"),
        Axis::log("bias in the mean square, without noise [%]"),
    );
    let [a, b, c, d] = COLUMNS;
    let mut table = Table::new(
        format!("bias of luminance of tiles of {TILE} × {TILE} pixels"),
        ["light", "r [m]", "paths, or photons shot", a, b, c, d],
    );
    for (name, sweep) in [("gloss", of_gloss(effort)?), ("caustics", of_caustics(effort)?)] {
        let Sweep { steps, images } = sweep;
        let squares: Vec<[f64; 2]> =
            steps.iter().map(|(r, _, bias)| [f64::from(*r), 100.0 * bias.square]).collect();
        for (radius, photons, bias) in &steps {
            let [a, b, c, d] = bias.cells();
            table.row([name.into(), format!("{radius}"), photons.to_string(), a, b, c, d]);
        }
        let what = format!(
            "{name}: bias of tiles by half the radius over that by the whole, worst of {HALVINGS} steps"
        );
        found.compare(Comparison::new(what, "", worst_step(&squares)).demand(Demand::AtMost(1.0)));
        found.compare(Comparison::new(
            format!("{name}: exponent of the bias over the radius"),
            "",
            slope(&squares),
        ));
        plot = plot.with(Series::line(name, squares));
        found.show(images);
    }
    found.show(plot);
    found.show(table);
    found.gap("The paper does not say how large its balls are. At edges part of a ball's section covers no surface, and where light has an edge it covers both sides: there the bias falls as r, elsewhere as r².");
    found.gap("Four times the photons within half the radius are as many in each ball: what falls is the bias, and the noise of tiles, not that of single pixels.");
    found.gap("Caustics are dark nearly everywhere: their tiles are held against the light of the mean tile, where they have less.");
    Ok(found)
}

/// What a sweep found: radius [m], paths of all batches or photons shot, bias; and its pictures.
struct Sweep {
    steps: Vec<(f32, u32, Bias)>,
    images: Vec<Image>,
}

/// A final gather in a box of gloss, which sees light by photons, against virtual lights and their compensation.
fn of_gloss(effort: &Effort<'_>) -> Result<Sweep> {
    let size = effort.of([64, 64], [128, 128]);
    let parts = ["vpl", "compensation"].map(String::from).into();
    let exact = Settings { parts, paths: 1024, passes: Some(8), ..Settings::default() };
    let mut stage = Stage::new(effort, varnished(effort.scene("cornell.mgf")?), size, &exact)?;
    let truth = stage.halves(&exact, effort.of(16, 64))?;
    let exposure = Exposure::Ev(Exposure::Auto.ev(&whole(&truth)));
    let mut sweep = Sweep { steps: Vec::new(), images: Vec::new() };
    let zoom = effort.of(3, 2);
    for step in 0..=HALVINGS {
        let radius = 0.64 / (1 << step) as f32;
        let (paths, batches) = (effort.of(1 << 10, 1 << 12) << (2 * step), effort.of(4, 8));
        let gather = Gather { rays: 2, paths, radius: radius / stage.reach(), ..Gather::default() };
        let parts = vec!["final-gather".into()];
        let ours = stage.halves(&Settings { parts, gather, ..exact.clone() }, batches)?;
        let light = picture(&stage.view, whole(&ours));
        sweep
            .images
            .push(Image::of_light(format!("final gather, r = {radius} m"), light, exposure).zoomed(zoom));
        sweep.steps.push((radius, 2 * batches * paths, Bias::new(&ours, &truth, size, 0.0)));
        effort.step(step as usize + 1, 2 * HALVINGS as usize + 3)?;
    }
    let light = picture(&stage.view, whole(&truth));
    sweep.images.push(Image::of_light("virtual lights, compensated", light, exposure).zoomed(zoom));
    Ok(sweep)
}

/// The estimate from a caustic map, against photons each in its own pixel.
fn of_caustics(effort: &Effort<'_>) -> Result<Sweep> {
    // Tiles of one size in both: how much they differ depends on that.
    let size = [192, 144];
    let cpu = Cpu::new(None)?;
    let scene = effort.scene("ring.mgf")?;
    let world = cpu.install(|| World::new(scene));
    // Four places in a pixel: the middle alone would miss what edges do to it.
    let seen = cpu.install(|| Seen::new(&world, RING, size.map(|n| 2 * n)));
    let view = RING.view(size);
    let coarse = |light: Vec<Rgb>| blocks(&light, 2 * size[0] as usize, 2);
    let shoot = |count, seed| photon::from_lights(&world, count, &|_| Rgb::WHITE, (0, seed), true).0;
    let many = effort.of(1 << 21, 1 << 23);
    let truth = [3, 4].map(|seed| coarse(cpu.install(|| seen.traced(&shoot(many, seed)))));
    // Caustics are far brighter than what the middle of such a picture is.
    let exposure = Exposure::Ev(Exposure::Auto.ev(&whole(&truth)) - 4.0);
    let mut sweep = Sweep { steps: Vec::new(), images: Vec::new() };
    for step in 0..=HALVINGS {
        let radius = 0.016 / (1 << step) as f32;
        let count = effort.of(1 << 13, 1 << 15) << (2 * step);
        let estimate = Estimate { kernel: Kernel::Constant, reach: Reach::Within(radius) };
        let half = |seed| {
            let map = PhotonMap::new(shoot(count, seed).iter().map(Photon::from).collect());
            seen.estimated(&map, estimate)
        };
        let ours = [1, 2].map(|seed| coarse(cpu.install(|| half(seed))));
        let light = picture(&view, whole(&ours));
        sweep.images.push(Image::of_light(format!("caustic map, r = {} mm", 1e3 * radius), light, exposure));
        sweep.steps.push((radius, 2 * count, Bias::new(&ours, &truth, size, 1.0)));
        effort.step((HALVINGS + step) as usize + 2, 2 * HALVINGS as usize + 3)?;
    }
    let light = picture(&view, whole(&truth));
    sweep.images.push(Image::of_light("each photon in its pixel", light, exposure));
    Ok(sweep)
}

/// The scene with a glossy coat on all that is matt: every point is then lit by photons.
fn varnished(mut scene: Scene) -> Scene {
    for material in &mut scene.materials {
        if let Bsdf::Diffuse(diffuse) = material.bsdf {
            let base = Diffuse::opaque(diffuse.reflectance * 0.8);
            material.bsdf = Bsdf::Ward(Ward {
                base,
                specular: Rgb::grey(0.1),
                alpha: 0.3,
                transmission: Rgb::BLACK,
                transmission_alpha: 0.0,
            });
        }
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of pictures whose tiles are too bright or too dark by a tenth, with noise that differs from half to half, the bias is told;
    /// of others nothing. The noise of a tile is 0.018 in each picture, so products of two halves are known to (√2 0.018)²
    /// over the root of 256 tiles, 4e-5, the root of four times which is 0.013.
    #[test]
    fn noise_is_no_bias() {
        let size = [16 * TILE, 16 * TILE];
        let tile = |k: u32| (k % size[0] / TILE + k / size[0] / TILE) % 2;
        let of = |seed, bias: f32| -> Vec<Rgb> {
            let light = |k| 1.0 + if tile(k) == 0 { bias } else { -bias };
            let noise = |k| lampyris::sequence::uniform(seed, k, 0) - 0.5;
            (0..size[0] * size[1]).map(|k| Rgb::grey(light(k) + noise(k))).collect()
        };
        let truth = [of(1, 0.0), of(2, 0.0)];
        let none = Bias::new(&[of(3, 0.0), of(4, 0.0)], &truth, size, 0.0);
        assert!(none.square < 0.013 && none.mean.abs() < 0.005, "{} {}", none.square, none.mean);
        let same = Bias::new(&[of(3, 0.0), of(3, 0.0)], &[of(1, 0.0), of(1, 0.0)], size, 0.0);
        assert!(same.square > 0.02, "{}: noise that halves share is taken for bias", same.square);
        let some = Bias::new(&[of(5, 0.1), of(6, 0.1)], &truth, size, 0.0);
        assert!((some.square - 0.1).abs() < 0.005 && some.mean.abs() < 0.005, "{}", some.square);
        assert!(some.tiles[0] < -0.09 && some.tiles[1] > 0.09);
    }

    #[test]
    fn the_worst_step_is_found() {
        assert_eq!(worst_step(&[[4.0, 8.0], [2.0, 4.0], [1.0, 3.0]]), 0.75);
    }
}
