//! `lampyris render`: from a scene file to pictures.

use crate::cli::{EstimateArgs, RenderArgs};
use crate::failure::{Failure, INTERRUPTED};
use crate::progress::{Phase, Progress, error_text};
use crate::{estimate, interrupt, memory, say, scene_file, viewing};
use glam::Vec3;
use lampyris::backend::{Absorption, Backend, Gather, Rays, Settings, Statistics};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::frame::Frame;
use lampyris::output::{self, Layer, Picture, Plane};
use lampyris::scene::{Camera, Scene, View};
use lampyris::world::World;
use lampyris::{Error, Rgb};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// Parts of the layer `direct`; all others are `indirect`.
const DIRECT: [&str; 2] = ["emission", "direct"];

/// What `--json` prints.
#[derive(Serialize)]
struct Report {
    scene: PathBuf,
    outputs: Vec<PathBuf>,
    size: (u32, u32),
    view: Look,
    seconds: Seconds,
    rays: Rays,
    vpls: u64,
    records: u64,
    batches: u32,
    /// Half the 95 % interval of the picture's mean, relative to it.
    error: f32,
    exposure: f32,
    peak_memory_bytes: Option<u64>,
    non_finite: u64,
    interrupted: bool,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct Look {
    eye: [f32; 3],
    target: [f32; 3],
    up: [f32; 3],
    fov: f32,
    found: bool,
    /// What a found view shows of all that can be seen of the room, in shares; null where it was given.
    seen: Option<Sight>,
}

#[derive(Serialize)]
struct Sight {
    furniture: f32,
    walls: f32,
}

/// Wall-clock time by phase [s].
#[derive(Serialize)]
struct Seconds {
    load: f32,
    build: f32,
    view: f32,
    render: f32,
    write: f32,
    total: f32,
}

/// Renders and writes.
pub(crate) fn render(args: &RenderArgs) -> Result<ExitCode, Failure> {
    let start = Instant::now();
    let outputs = outputs(args)?;
    let asked = if args.frame {
        EstimateArgs { batches: Some(1), ..args.estimate.clone() }
    } else {
        args.estimate.clone()
    };
    // Bad arguments are told of before anything is read.
    estimate::for_picture(&asked, args.filter, args.size, false)?;
    let loaded = scene_file::load(&args.scene, args.quiet)?;
    let textured = !loaded.scene.textures.is_empty();
    let settings = estimate::for_picture(&asked, args.filter, args.size, textured)?;
    let settings = Settings { auxiliary: args.aov, ..settings };
    let loaded_at = Instant::now();

    let mut backend = Cpu::new(asked.threads.map(|n| n as usize))?;
    let phase = Phase::begin("building the tree", args.quiet);
    // A document's lamps are sorted already, or are to be as it says.
    let layers = args.groups.or(loaded.document.layers);
    let world = backend.install(|| {
        let mut world = World::new(loaded.scene);
        layers.map_or(Ok(()), |most| world.separate(most as usize))?;
        Ok::<_, Error>(world)
    })?;
    let built_at = Instant::now();

    let (width, height) = args.size;
    let aspect = width as f32 / height as f32;
    phase.then("looking for a view");
    let chosen = backend.install(|| viewing::choose(&args.view, &world, aspect))?;
    drop(phase);
    if chosen.seen.is_some() && !args.quiet {
        say::note(&format!("view: {}", viewing::arguments(&chosen.camera, args.view.near)));
    }
    let viewed_at = Instant::now();

    let view = View::new(&chosen.camera, width, height).cut(args.view.near.unwrap_or(0.0));
    backend.begin_world(world, Eye::Camera(view), &settings)?;
    let progress = Progress::new(&asked, settings.filter, args.quiet);
    let interrupted = estimate::run(&mut backend, &asked, settings.filter, start, &progress)?;
    let rendered_at = Instant::now();

    let Statistics { rays, vpls, records, non_finite } = backend.statistics();
    let groups = backend.world().map_or(Vec::new(), |world| group_names(world.scene()));
    let layers = backend.world().map_or(1, World::groups);
    let frame = backend.frame()?;
    let metadata = metadata(args, &settings, &chosen.camera, layers, frame.batches());
    let picture = picture(frame, metadata, &groups, args.aov);
    let display = args.display.display();
    let written = outputs.iter().map(|path| interrupt::writing(|| output::save(path, &picture, &display)));
    // Each file is tried: a full disk under one says nothing of the others.
    let failed = written.fold(None, |failed, done| failed.or(done.err()));
    if let Some(error) = failed {
        return Err(error.into());
    }
    let error = frame.relative_error() * frame.student_factor();
    let seconds = Seconds {
        load: (loaded_at - start).as_secs_f32(),
        build: (built_at - loaded_at).as_secs_f32(),
        view: (viewed_at - built_at).as_secs_f32(),
        render: (rendered_at - viewed_at).as_secs_f32(),
        write: rendered_at.elapsed().as_secs_f32(),
        total: start.elapsed().as_secs_f32(),
    };
    if !args.quiet {
        let names: Vec<_> = outputs.iter().map(|p| p.display().to_string()).collect();
        let (batches, total) = (frame.batches(), seconds.total);
        say::note(&format!("{}: {batches} batches, {}, {total:.1} s", names.join(", "), error_text(error)));
    }
    if args.json {
        let c = &chosen.camera;
        say::json(&Report {
            scene: args.scene.file.clone(),
            outputs,
            size: args.size,
            view: Look {
                eye: c.eye.into(),
                target: c.target.into(),
                up: c.up.into(),
                fov: c.fov_y,
                found: chosen.seen.is_some(),
                seen: chosen.seen.map(|s| Sight { furniture: s.furniture, walls: s.walls }),
            },
            seconds,
            rays,
            vpls,
            records,
            batches: frame.batches(),
            error,
            exposure: display.exposure.ev(&picture.radiance),
            peak_memory_bytes: memory::peak(),
            non_finite,
            interrupted,
            warnings: loaded.warnings,
        })?;
    }
    Ok(if interrupted { ExitCode::from(INTERRUPTED) } else { ExitCode::SUCCESS })
}

/// The files to write, found writable as far as that can be known before the work.
fn outputs(args: &RenderArgs) -> Result<Vec<PathBuf>, Error> {
    if args.output.is_empty() {
        let stem = args.scene.file.file_stem().unwrap_or("picture".as_ref());
        return Ok(vec![Path::new(stem).with_extension("png")]);
    }
    for path in &args.output {
        output::format_of(path)?;
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            let reason = format!("there is no folder {}", folder.display());
            return Err(Error::CannotWrite { file: path.clone(), reason });
        }
    }
    Ok(args.output.clone())
}

/// What the layers of the light groups are called: names without what separates layers from channels, each once.
fn group_names(scene: &Scene) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for group in &scene.groups {
        let plain: String =
            group.name.chars().map(|c| if c == '.' || c.is_control() { '_' } else { c }).collect();
        let plain = format!("light {}", if plain.is_empty() { "unnamed" } else { &plain });
        let others = (2..).map(|k| format!("{plain} {k}"));
        names.extend(std::iter::once(plain.clone()).chain(others).find(|name| !names.contains(name)));
    }
    names
}

fn picture(frame: &Frame, metadata: Vec<(String, String)>, groups: &[String], aov: bool) -> Picture {
    let mut picture = Picture::new(frame.width, frame.height, frame.shown());
    picture.metadata = metadata;
    if aov {
        picture.layers = layers(frame);
    }
    for (number, name) in groups.iter().enumerate() {
        let plane = frame.shown_layer(number).map(Plane::Color);
        picture.layers.extend(plane.map(|plane| Layer { name: name.clone(), plane }));
    }
    picture
}

/// Further layers, as far as the parts rendered know them.
fn layers(frame: &Frame) -> Vec<Layer> {
    let mut layers = Vec::new();
    let mut layer = |name: &str, plane| layers.push(Layer { name: name.into(), plane });
    // The path tracer does not tell direct from indirect, nor do light groups.
    if frame.part_names().all(|n| n != "path") && frame.part_names().count() > 0 {
        let sum = |direct: bool| {
            let mut sum = vec![Rgb::BLACK; frame.width as usize * frame.height as usize];
            let names = frame.part_names().filter(|n| DIRECT.contains(n) == direct);
            names
                .filter_map(|n| frame.part(n))
                .for_each(|p| sum.iter_mut().zip(p).for_each(|(s, v)| *s += v));
            sum
        };
        layer("direct", Plane::Color(sum(true)));
        layer("indirect", Plane::Color(sum(false)));
    }
    layer("raw", Plane::Color(frame.mean()));
    if let Some(a) = frame.auxiliary() {
        let scale = 1.0 / a.samples.max(1) as f32;
        let unit = |n: &Rgb| Vec3::new(n.r, n.g, n.b).normalize_or_zero();
        layer("albedo", Plane::Color(a.albedo.iter().map(|c| *c * scale).collect()));
        layer("normal", Plane::Normal(a.normal.iter().map(unit).collect()));
        layer("depth", Plane::Depth(a.depth.iter().map(|d| d * scale).collect()));
        layer("object", Plane::Id(a.object.clone()));
    }
    layers
}

/// What repeats the picture to the bit; nothing that differs from run to run.
fn metadata(
    args: &RenderArgs,
    settings: &Settings,
    camera: &Camera,
    layers: usize,
    batches: u32,
) -> Vec<(String, String)> {
    let absorption = Absorption::ALL.iter().find(|(_, a)| *a == settings.absorption).map_or("", |(n, _)| n);
    let Gather { rays, paths, source, element, radius, levels, cache } = settings.gather;
    let cached = cache.map_or(String::new(), |accuracy| format!(", cached to {accuracy}"));
    let gather = format!(
        "{rays} rays, {paths} paths, by {}, elements of {element} m, radius {radius}, {levels} levels{cached}",
        source.name()
    );
    [
        ("software", format!("lampyris {}", env!("CARGO_PKG_VERSION"))),
        ("scene", args.scene.file.display().to_string()),
        ("view", viewing::arguments(camera, args.view.near)),
        ("parts", settings.parts.join(",")),
        ("paths", settings.paths.to_string()),
        ("photons", settings.photons.to_string()),
        ("gather", gather),
        ("spp", settings.eye_passes().to_string()),
        ("interleave", format!("{}x{}", settings.interleave[0], settings.interleave[1])),
        ("light points", or_all(settings.light_points)),
        ("picks", or_all(settings.picks)),
        ("filter", if settings.filter { "auto" } else { "off" }.to_string()),
        ("longest path", or_all(settings.longest)),
        ("light groups", args.groups.map_or(layers.to_string(), |n| n.to_string())),
        ("batches", batches.to_string()),
        ("seed", settings.seed.to_string()),
        ("sequence", settings.sequence.name().to_string()),
        ("absorption", absorption.to_string()),
        ("clamp", settings.clamp.to_string()),
        ("randomisations", settings.replicates.to_string()),
    ]
    .map(|(key, value)| (key.to_string(), value))
    .into()
}

fn or_all(number: Option<u32>) -> String {
    number.map_or("all".into(), |n| n.to_string())
}
