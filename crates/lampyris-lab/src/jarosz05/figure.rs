//! Figure 9: previews by points and by discs beside the full rendering.

use super::JAROSZ05;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Image, Table, digits};
use crate::seen::Seen;
use crate::stage::{Look, RING, picture};
use crate::statistics::{blocks, correlation, mean, relative_square};
use glam::Vec3;
use lampyris::Rgb;
use lampyris::backend::{Backend, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::map::{Estimate, Kernel, Photon, PhotonMap, Reach};
use lampyris::output::Exposure;
use lampyris::photon;
use lampyris::scene::Scene;
use lampyris::world::World;
use std::time::Instant;

pub(crate) const FIGURE_9: Experiment = Experiment {
    name: "jarosz05-figure-9",
    title: "Photons as points and as discs",
    paper: JAROSZ05,
    place: "Figure 9, §3.2.2, §5.3",
    claim: "A radiance estimate of fixed radius corresponds exactly to each photon splatted as a disc of that radius. Points show where \
            photons are, not how bright. Between previews and full renderings global illumination keeps a high level of correspondence.",
    seconds: [3.0, 15.0],
    run: figure_9,
};

/// A name, where from, and r [m]: the whole still life, and the heart in its ring.
const SHOTS: [(&str, Look, f32); 2] = [
    ("the still life", RING, 0.004),
    (
        "inside the ring",
        Look { eye: [-0.01, -0.27, 0.2], target: [-0.01, -0.085, 0.0], up: Vec3::Z, fov_y: 34.0 },
        0.002,
    ),
];

/// Edge of the blocks by which points are compared [pixels].
const BLOCK: usize = 8;

fn figure_9(effort: &Effort<'_>) -> Result<Findings> {
    let size = effort.of([360, 270], [480, 360]);
    let cpu = Cpu::new(None)?;
    let scene = effort.scene("ring.mgf")?;
    let world = cpu.install(|| World::new(scene.clone()));
    let count = effort.of(1 << 19, 1 << 20);
    let (shot, _) = cpu.install(|| photon::from_lights(&world, count, &|_| Rgb::WHITE, (0, 1), true));
    let (balancing, map) = timed(|| cpu.install(|| PhotonMap::new(shot.iter().map(Photon::from).collect())));
    let mut found = Findings::default();
    let mut table = Table::new(
        format!(
            "{} photons of caustics, {} × {} pixels, beside the estimate",
            map.photons().len(),
            size[0],
            size[1]
        ),
        [
            "seen",
            "r [mm]",
            "discs: correlation",
            "relative mean square difference",
            "pixels of the table that differ [%]",
            "points: correlation",
            "the same by blocks of 8 × 8 pixels",
        ],
    );
    let mut times =
        Table::new("time of one picture's light [ms]", ["seen", "balancing", "estimate", "discs", "points"]);
    for (number, (name, look, radius)) in SHOTS.into_iter().enumerate() {
        let seen = cpu.install(|| Seen::new(&world, look, size));
        let estimate = Estimate { kernel: Kernel::Constant, reach: Reach::Within(radius) };
        let (searching, estimated) = timed(|| cpu.install(|| seen.estimated(&map, estimate)));
        let (splatting, discs) = timed(|| cpu.install(|| seen.discs(map.photons(), estimate.kernel, radius)));
        let (drawing, points) = timed(|| cpu.install(|| seen.points(map.photons(), mean(&estimated))));
        let row = Compared::new(&seen, &estimated, &discs, &points);
        table.row([
            name.into(),
            digits(1e3 * f64::from(radius)),
            format!("{:.5}", row.discs),
            digits(row.difference),
            digits(row.on_the_table),
            digits(row.points),
            digits(row.blocks),
        ]);
        times.row([
            name.into(),
            digits(1e3 * balancing),
            digits(1e3 * searching),
            digits(1e3 * splatting),
            digits(1e3 * drawing),
        ]);
        row.compare(name, &mut found);
        let local = local(effort, &scene, &seen)?;
        let whole =
            |light: Vec<Rgb>| -> Vec<Rgb> { light.iter().zip(&local).map(|(a, b)| *a + *b).collect() };
        let truth = whole(estimated);
        let exposure = Exposure::Ev(Exposure::Auto.ev(&truth));
        let image = |what: &str, light| {
            Image::of_light(format!("{name}: {what}"), picture(&seen.view, light), exposure)
        };
        found.show(vec![
            image("the radiance estimate", truth),
            image("photons as points", whole(points)),
            image("photons as discs", whole(discs)),
        ]);
        effort.step(number + 1, SHOTS.len())?;
    }
    found.show(table);
    found.show(times);
    found.gap("The figure's scenes are not published, nor r, nor the number of photons. Its differences in local illumination, of OpenGL's point lights and of shading between vertices, are not repeated: direct light is the renderer's in all pictures.");
    found.gap("Discs are drawn by the processor here, with a depth test for the middle of each pixel, and their sums are floating-point numbers: of the rounding of §5.1 nothing is seen. Where a disc leaves its surface it shines on what is behind it, the haze of §5.2; the estimate leaves such photons out.");
    Ok(found)
}

/// What previews have of the estimate.
struct Compared {
    /// Correlation of discs.
    discs: f64,
    difference: f64,
    /// Of the table's pixels the share that differs [%].
    on_the_table: f64,
    /// Correlation of points, pixel by pixel and by blocks.
    points: f64,
    blocks: f64,
}

impl Compared {
    fn new(seen: &Seen<'_>, estimated: &[Rgb], discs: &[Rgb], points: &[Rgb]) -> Compared {
        let luminance = |light: &[Rgb]| light.iter().map(|c| f64::from(c.luminance())).collect::<Vec<_>>();
        let alike = |a: &[Rgb], b: &[Rgb]| correlation(&luminance(a), &luminance(b));
        let flat: Vec<usize> = (0..estimated.len()).filter(|k| is_table(seen, *k)).collect();
        let differs = |k: &&usize| {
            let [a, b] = [discs, estimated].map(|light| light[**k].luminance());
            (a - b).abs() > 1e-3 * b
        };
        let width = seen.view.width as usize;
        Compared {
            discs: alike(discs, estimated),
            difference: relative_square(discs, estimated),
            on_the_table: 100.0 * flat.iter().filter(differs).count() as f64 / flat.len().max(1) as f64,
            points: alike(points, estimated),
            blocks: alike(&blocks(points, width, BLOCK), &blocks(estimated, width, BLOCK)),
        }
    }

    fn compare(&self, name: &str, found: &mut Findings) {
        found.compare(
            Comparison::new(format!("{name}: correlation of discs and estimate"), "", self.discs)
                .paper(1.0)
                .says("exactly")
                .demand(Demand::AtLeast(0.99)),
        );
        found.compare(
            Comparison::new(
                format!("{name}: pixels of the flat table where they differ by 0.1 %"),
                "%",
                self.on_the_table,
            )
            .paper(0.0)
            .says("exactly")
            .demand(Demand::AtMost(0.1)),
        );
        found.compare(
            Comparison::new(
                format!("{name}: correlation of points and estimate, by blocks"),
                "",
                self.blocks,
            )
            .says("location and general shape"),
        );
    }
}

/// Whether a pixel shows the table, which is flat.
fn is_table(seen: &Seen<'_>, pixel: usize) -> bool {
    seen.surfaces[pixel].as_ref().is_some_and(|x| x.normal == Vec3::Z && x.position.z.abs() < 1e-5)
}

/// The lamps and their direct light, by the renderer.
fn local(effort: &Effort<'_>, scene: &Scene, seen: &Seen<'_>) -> Result<Vec<Rgb>> {
    let mut cpu = Cpu::new(None)?;
    let parts = ["emission", "direct"].map(String::from).into();
    let settings = Settings { parts, paths: 64, passes: Some(16), ..Settings::default() };
    effort.render(&mut cpu, (scene.clone(), Eye::Camera(seen.view.clone())), &settings, 2)?;
    Ok(cpu.frame()?.mean())
}

/// How long it takes [s], and what comes of it.
fn timed<T>(make: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let made = make();
    (start.elapsed().as_secs_f64(), made)
}
