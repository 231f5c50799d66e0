//! `lampyris play`: a walkthrough by a script, each frame as a session shows it first after an edit.

mod flicker;
mod json;
mod reel;
pub(crate) mod script;
mod stage;

pub(crate) use stage::{lamp_names, object_names};

use crate::cli::PlayArgs;
use crate::estimate::absorption;
use crate::failure::{Failure, INTERRUPTED};
use crate::progress::FrameProgress;
use crate::{interrupt, memory, say, scene_file, viewing};
use flicker::{Flicker, Meter};
use lampyris::Error;
use lampyris::backend::{Rays, Settings};
use lampyris::cpu::Cpu;
use lampyris::output::{Exposure, Picture};
use lampyris::scene::Scene;
use lampyris::session::Session;
use lampyris::world::World;
use lampyris_lab::workload::Workload;
use reel::Reel;
use script::Script;
use serde::Serialize;
use stage::Stage;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// What `--json` prints.
#[derive(Serialize)]
struct Report {
    script: PathBuf,
    scene: PathBuf,
    outputs: Vec<PathBuf>,
    size: (u32, u32),
    /// Frames done.
    frames: u32,
    seconds: Seconds,
    /// Of all frames; what flicker takes to measure is not counted.
    rays: Rays,
    exposure: f32,
    flicker: Option<Flicker>,
    peak_memory_bytes: Option<u64>,
    interrupted: bool,
    warnings: Vec<String>,
}

/// Wall-clock time [s]. A frame: its edits, its batches, and mixing what is shown; writing comes on top.
#[derive(Serialize)]
struct Seconds {
    load: f32,
    frame_median: f32,
    frame_worst: f32,
    total: f32,
}

/// Plays and writes.
pub(crate) fn play(args: &PlayArgs) -> Result<ExitCode, Failure> {
    let start = Instant::now();
    let script = Script::read(&args.script)?;
    let size = args.size.unwrap_or(script.size);
    let new_reel = |path: &PathBuf| Reel::new(path, script.frames, script.fps);
    let mut reels = args.output.iter().map(new_reel).collect::<Result<Vec<_>, Error>>()?;
    if args.json && reels.iter().any(|reel| matches!(reel, Reel::Stream { .. })) {
        return Err(Error::BadSetting("standard output takes a film or a report, not both".into()).into());
    }
    let file = scene_of(args, &script)?;
    let loaded = scene_file::read(&file, &args.reading, args.quiet)?;
    let loaded_at = Instant::now();

    let layers = args.groups.or(loaded.document.layers);
    let mut player = Player::new(args, &script, size, &file, (loaded.scene, layers))?;
    let mut meter = match args.flicker {
        Some(batches) => Some(Meter::new(player.twin(size, args.threads)?, batches)),
        None => None,
    };
    let progress = FrameProgress::new(script.frames, args.quiet);
    let mut display = args.display.display();
    let mut times = Vec::new();
    let mut rays = Rays::default();
    interrupt::rendering();
    for number in 0..script.frames {
        if interrupt::asked() {
            break;
        }
        let begun = Instant::now();
        let before = player.arrange(number)?;
        player.step(number)?;
        let picture = Picture::new(size.0, size.1, player.session.frame()?.shown());
        times.push(begun.elapsed().as_secs_f32());
        rays += since(player.session.statistics().rays, before);
        // One exposure for all frames: else all would brighten as a lamp leaves the picture.
        display.exposure = Exposure::Ev(display.exposure.ev(&picture.radiance));
        for reel in &mut reels {
            reel.write(number, &picture, &display)?;
        }
        if let Some(meter) = &mut meter {
            meter.add(number, player.session.frame()?, 1.0 / display.exposure.factor(&[]))?;
        }
        progress.step(number + 1, median(&times));
    }
    progress.end();
    let interrupted = interrupt::asked();

    let flicker = meter.as_ref().map(Meter::result);
    let report = Report {
        script: args.script.clone(),
        scene: file,
        outputs: args.output.clone(),
        size,
        frames: times.len() as u32,
        seconds: Seconds {
            load: (loaded_at - start).as_secs_f32(),
            frame_median: median(&times),
            frame_worst: times.iter().copied().fold(0.0, f32::max),
            total: start.elapsed().as_secs_f32(),
        },
        rays,
        exposure: display.exposure.ev(&[]),
        flicker,
        peak_memory_bytes: memory::peak(),
        interrupted,
        warnings: loaded.warnings,
    };
    if !args.quiet {
        say::note(&text(&report));
    }
    if args.json {
        say::json(&report)?;
    }
    Ok(if interrupted { ExitCode::from(INTERRUPTED) } else { ExitCode::SUCCESS })
}

/// The argument's scene, or the script's.
fn scene_of(args: &PlayArgs, script: &Script) -> Result<PathBuf, Error> {
    let beside = |file: &PathBuf| args.script.parent().unwrap_or(Path::new("")).join(file);
    let named = args.scene.clone().or_else(|| script.scene.as_ref().map(beside));
    let mend = "no scene: name it in the script, \"scene\": \"room.mgf\", or behind it";
    named.ok_or_else(|| Error::BadSetting(mend.into()))
}

/// A session that follows a script.
struct Player {
    session: Session,
    settings: Settings,
    stage: Stage,
    /// Batches of each frame.
    settle: u32,
    script: PathBuf,
}

impl Player {
    fn new(
        args: &PlayArgs,
        script: &Script,
        size: (u32, u32),
        file: &Path,
        (scene, layers): (Scene, Option<u32>),
    ) -> Result<Player, Failure> {
        let threads = args.threads.map(|n| n as usize);
        let cpu = Cpu::new(threads)?;
        let mut world = cpu.install(|| World::new(scene));
        cpu.install(|| layers.map_or(Ok(()), |most| world.separate(most as usize)))?;
        let aspect = size.0 as f32 / size.1 as f32;
        let chosen = cpu.install(|| viewing::choose(&args.view, &world, aspect))?;
        let settings = if args.wald { Workload::of(file).settings(&world) } else { Settings::interactive() };
        let window = args.window.unwrap_or(script.window);
        let settings =
            Settings { seed: args.seed, window, absorption: absorption(&args.absorption)?, ..settings };
        let stage = Stage::new(script, &args.script, world.scene(), &chosen.camera)?;
        if let Some(frame) = (0..script.frames).find(|frame| !stage.camera(*frame).is_sound()) {
            let reason =
                "the camera looks nowhere: eye and target must differ, and up must not point along them";
            return Err(bad_frame(&args.script, frame, reason).into());
        }
        let scene = Scene { view: Some(stage.camera(0)), ..world.scene().clone() };
        let session = Session::open(scene, size.into(), &settings, threads)?;
        Ok(Player { session, settings, stage, settle: args.settle, script: args.script.clone() })
    }

    /// Another that follows the same script.
    fn twin(&self, size: (u32, u32), threads: Option<u32>) -> Result<Player, Failure> {
        let scene = self.session.scene()?.clone();
        let session = Session::open(scene, size.into(), &self.settings, threads.map(|n| n as usize))?;
        let stage = self.stage.clone();
        Ok(Player {
            session,
            settings: self.settings.clone(),
            stage,
            settle: self.settle,
            script: self.script.clone(),
        })
    }

    /// Makes the scene what it shall be at a frame. Returns the rays that its picture has already.
    fn arrange(&mut self, frame: u32) -> Result<Rays, Error> {
        for edit in self.stage.edits(frame) {
            self.session.edit(&edit).map_err(|error| match error {
                Error::BadSetting(reason) => bad_frame(&self.script, frame, &reason),
                other => other,
            })?;
        }
        Ok(self.session.statistics().rays)
    }

    /// The batches of a frame. The first has a whole window of them, as if all had been still before.
    fn step(&mut self, frame: u32) -> Result<(), Error> {
        let first = if frame == 0 { self.settings.window } else { 1 };
        (0..self.settle.max(first)).try_for_each(|_| self.session.step())
    }
}

fn bad_frame(script: &Path, frame: u32, reason: &str) -> Error {
    Error::BadInput { file: script.into(), place: format!("frame {frame}"), reason: reason.into() }
}

fn since(now: Rays, before: Rays) -> Rays {
    Rays {
        eye: now.eye - before.eye,
        particle: now.particle - before.particle,
        shadow: now.shadow - before.shadow,
        compensation: now.compensation - before.compensation,
        gather: now.gather - before.gather,
        path: now.path - before.path,
    }
}

fn median(times: &[f32]) -> f32 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f32::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

fn text(report: &Report) -> String {
    let names: Vec<_> = report.outputs.iter().map(|p| p.display().to_string()).collect();
    let Seconds { frame_median, frame_worst, total, .. } = report.seconds;
    let mut text = format!(
        "{}: {} frames of {frame_median:.3} s, {frame_worst:.3} s at worst, {total:.1} s in all",
        names.join(", "),
        report.frames
    );
    if let Some(f) = &report.flicker {
        for (kind, pair) in [("unfiltered", f.unfiltered), ("displayed", Some(f.displayed))] {
            let Some(pair) = pair else { continue };
            text += &format!(
                "\nflicker {kind}: {:.3} % a frame, {:.3} % at worst, {:.3} % if every frame drew anew, {:.1} times; off by {:.3} %",
                pair.session * 100.0,
                pair.worst * 100.0,
                pair.independent * 100.0,
                pair.ratio,
                pair.error * 100.0
            );
        }
    }
    text
}
