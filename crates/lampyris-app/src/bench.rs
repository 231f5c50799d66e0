//! `lampyris bench`: how many frames a second this machine makes, everything worked out anew in each.
//!
//! Mode `wald` is the workload of [Wald et al. 2002, §5.1]: 3 × 3 interleaved, every virtual light of a class traced from
//! every pixel, or picked where its eye path split, a 3 × 3 discontinuity buffer. Mode `picked` is a frame as it is shown
//! by default. Phases are measured by leaving out what follows them: the walk alone; with eye rays; with the gather; with
//! the filter.

use crate::cli::BenchArgs;
use crate::failure::Failure;
use crate::{interrupt, say};
use lampyris::Error;
use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::import::{self, Options};
use lampyris::particle::{Plan, Walk};
use lampyris::scene::View;
use lampyris::world::World;
use lampyris_lab::workload::{WORKLOADS, Workload};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// What `--json` prints of one measurement; milliseconds are wall time.
#[derive(Serialize)]
struct Row {
    scene: PathBuf,
    mode: &'static str,
    threads: u32,
    fps: f64,
    ms_walk: f64,
    ms_eye: f64,
    ms_gather: f64,
    ms_filter: f64,
    /// Millions of rays a second, over the phase that traces them.
    mrays_eye: f64,
    mrays_shadow: f64,
    shadow_rays_per_pixel: f64,
    /// Light points and virtual lights of a frame.
    vpls: f64,
}

/// Measures and prints.
pub(crate) fn bench(args: &BenchArgs) -> Result<ExitCode, Failure> {
    let own = |w: &'static Workload| (args.scenes.join(w.file), w);
    let scenes: Vec<(PathBuf, &Workload)> = match args.scene.as_slice() {
        [] => WORKLOADS.iter().map(own).collect(),
        given => given.iter().map(|file| (file.clone(), Workload::of(file))).collect(),
    };
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get() as u32);
    let threads = match args.threads.as_slice() {
        [] if cores == 1 => vec![1],
        [] => vec![1, cores],
        given => given.to_vec(),
    };
    interrupt::rendering();
    let mut rows = Vec::new();
    for (file, workload) in &scenes {
        for threads in &threads {
            if interrupt::asked() {
                break;
            }
            let mut machine = Machine::new(file, workload, *threads, args)?;
            let nothing = || Error::BadSetting("nothing to measure".into());
            let settings = workload.settings(machine.backend.world().ok_or_else(nothing)?);
            rows.push(machine.measure("wald", settings)?);
            if args.picked {
                rows.push(machine.measure("picked", Settings::interactive())?);
            }
        }
    }
    if args.json {
        say::json(&rows)?
    } else {
        say::result(&table(&rows))?
    }
    Ok(ExitCode::SUCCESS)
}

/// A scene on a number of threads.
struct Machine<'a> {
    backend: Cpu,
    eye: Eye,
    file: &'a Path,
    threads: u32,
    args: &'a BenchArgs,
}

impl<'a> Machine<'a> {
    fn new(
        file: &'a Path,
        workload: &Workload,
        threads: u32,
        args: &'a BenchArgs,
    ) -> Result<Machine<'a>, Failure> {
        let mut backend = Cpu::new(Some(threads as usize))?;
        let scene = import::load(file, &Options::default())?.scene;
        let world = backend.install(|| World::new(scene));
        let (width, height) = args.size;
        let aspect = width as f32 / height as f32;
        let camera = backend.install(|| workload.camera(&world, aspect));
        let eye = Eye::Camera(View::new(&camera, width, height));
        backend.begin_world(world, eye.clone(), &Settings::interactive())?;
        Ok(Machine { backend, eye, file, threads, args })
    }

    fn measure(&mut self, mode: &'static str, whole: Settings) -> Result<Row, Failure> {
        let bare = Settings { filter: false, ..whole.clone() };
        let eyes = Settings { parts: vec!["emission".into()], ..bare.clone() };
        let ms_walk = self.walk(&eyes);
        let to_eye = self.frames(&eyes)?.0;
        let to_gather = self.frames(&bare)?.0;
        let (ms, per_frame) = self.frames(&whole)?;
        let pixels = f64::from(self.args.size.0) * f64::from(self.args.size.1);
        let (ms_eye, ms_gather) = ((to_eye - ms_walk).max(0.0), (to_gather - to_eye).max(0.0));
        Ok(Row {
            scene: self.file.to_owned(),
            mode,
            threads: self.threads,
            fps: 1000.0 / ms,
            ms_walk,
            ms_eye,
            ms_gather,
            ms_filter: (ms - to_gather).max(0.0),
            mrays_eye: per_frame.eye / ms_eye / 1000.0,
            mrays_shadow: per_frame.shadow / ms_gather / 1000.0,
            shadow_rays_per_pixel: per_frame.shadow / pixels,
            vpls: per_frame.vpls,
        })
    }

    /// Milliseconds of a walk, in the median.
    fn walk(&mut self, settings: &Settings) -> f64 {
        let Some(world) = self.backend.world() else { return 0.0 };
        let plan = Plan::new(world, settings);
        median((0..self.args.frames).map(|index| {
            let start = Instant::now();
            let walk = self.backend.install(|| Walk::new(world, settings, &plan, Batch { index }));
            std::hint::black_box(walk);
            start.elapsed().as_secs_f64() * 1000.0
        }))
    }

    /// Milliseconds of a frame, in the median, and what one took.
    fn frames(&mut self, settings: &Settings) -> Result<(f64, PerFrame), Failure> {
        self.backend.restart(self.eye.clone(), settings)?;
        self.backend.add(Batch { index: 0 })?;
        let mut times = Vec::new();
        for index in 1..=self.args.frames {
            let start = Instant::now();
            self.backend.add(Batch { index })?;
            times.push(start.elapsed().as_secs_f64() * 1000.0);
        }
        let done = self.backend.statistics();
        let each = |count: u64| count as f64 / f64::from(self.args.frames + 1);
        let per_frame =
            PerFrame { eye: each(done.rays.eye), shadow: each(done.rays.shadow), vpls: each(done.vpls) };
        Ok((median(times.into_iter()), per_frame))
    }
}

/// Rays and lights of a frame in the mean.
struct PerFrame {
    eye: f64,
    shadow: f64,
    vpls: f64,
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

fn table(rows: &[Row]) -> String {
    let head = [
        "scene",
        "mode",
        "threads",
        "fps",
        "walk",
        "eye",
        "gather",
        "filter",
        "Mrays/s",
        "rays/pixel",
        "VPLs",
    ];
    let line = |cells: Vec<String>| {
        let (first, rest) = cells.split_first().map_or(("", &[][..]), |(f, r)| (f.as_str(), r));
        format!("{first:<28}") + &rest.iter().map(|c| format!("{c:>11}")).collect::<String>() + "\n"
    };
    let mut text = line(head.map(String::from).into());
    for r in rows {
        let scene = r.scene.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let numbers = [
            r.fps,
            r.ms_walk,
            r.ms_eye,
            r.ms_gather,
            r.ms_filter,
            r.mrays_shadow,
            r.shadow_rays_per_pixel,
            r.vpls,
        ];
        let mut cells = vec![scene, r.mode.into(), r.threads.to_string()];
        cells.extend(numbers.map(|n| format!("{n:.1}")));
        text += &line(cells);
    }
    text + "Phases in milliseconds; rays: between points and lights.\n"
}
