//! From arguments to settings, and batch after batch until enough is known, time is up or the user has seen enough.

use crate::cli::EstimateArgs;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use lampyris::Error;
use lampyris::backend::{Absorption, Backend, Batch, Gather, Settings, Source};
use lampyris::integrator;
use lampyris::sequence::Sequence;
use std::time::{Duration, Instant};

/// Light paths that share an eye pass unless `--spp` says otherwise. One pass a path, as in the 1997 report, spends most
/// of the time on eye rays: sixteen a pass halve the error at equal time (docs/performance.md).
const PATHS_PER_EYE_PASS: u32 = 16;

/// Light paths times pixels in one batch, as far as the bounds on the paths allow: the batches of a large picture stay
/// short, so that neither Ctrl-C nor the end of `--time` is long in coming. A function of the picture's size alone: time
/// never decides what a batch is.
const WORK: u64 = 10_000_000;
const PICTURE_PATHS: (u64, u64) = (16, 64);

/// Light paths times pixels that a batch may have for each second that `--time` grants: a picture in a hurry begins with
/// a small one. Textured surfaces are shaded one by one, and cost several times as much.
const WORK_A_SECOND: f64 = 5e7;
const TEXTURED_WORK_A_SECOND: f64 = 3e6;
const HURRIED_PATHS: u64 = 4;
const METER_PATHS: (u64, u64) = (64, 1024);

/// The settings that the arguments ask for, for a picture of that size of a scene with or without textures; `filter` as
/// the user said.
pub(crate) fn for_picture(
    args: &EstimateArgs,
    filter: Option<bool>,
    (width, height): (u32, u32),
    textured: bool,
) -> Result<Settings, Failure> {
    let shaped = args.paths.is_some() || args.spp.is_some() || args.parts != ["all"];
    if filter.unwrap_or(!shaped) {
        return settings(args, Settings::interactive());
    }
    let pixels = u64::from(width) * u64::from(height);
    let speed = if textured { TEXTURED_WORK_A_SECOND } else { WORK_A_SECOND };
    let in_time = args.time.map_or(u64::MAX, |t| (t.as_secs_f64() * speed) as u64 / pixels.max(1));
    let (least, most) = PICTURE_PATHS;
    let least = least.min(in_time.max(HURRIED_PATHS));
    let paths = paths(pixels, (least, most.min(in_time).max(least)));
    settings(args, Settings { paths, ..Settings::default() })
}

/// The settings that the arguments ask for, for so many meters.
pub(crate) fn for_meters(args: &EstimateArgs, meters: usize) -> Result<Settings, Failure> {
    settings(args, Settings { paths: paths(meters as u64, METER_PATHS), ..Settings::default() })
}

/// A power of two.
fn paths(pixels: u64, (least, most): (u64, u64)) -> u32 {
    1 << (WORK / pixels.max(1)).clamp(least, most).ilog2()
}

/// What the arguments say, `otherwise` where they say nothing.
fn settings(args: &EstimateArgs, otherwise: Settings) -> Result<Settings, Failure> {
    let mut parts = Vec::new();
    for name in &args.parts {
        match name.as_str() {
            "all" => parts.extend(integrator::WHOLE.iter().map(|n| (*n).to_owned())),
            "full-solution" => parts.extend(integrator::FULL_SOLUTION.iter().map(|n| (*n).to_owned())),
            _ => parts.push(name.clone()),
        }
    }
    parts.dedup();
    if args.no_compensate {
        parts.retain(|p| p != "compensation");
    }
    let paths = args.paths.unwrap_or(otherwise.paths);
    // The oracle uses no light paths: there a batch of N means N samples.
    let shared = if parts == ["path"] { paths } else { paths.div_ceil(PATHS_PER_EYE_PASS) };
    let settings = Settings {
        parts,
        paths,
        passes: Some(args.spp.or(otherwise.passes).unwrap_or(shared)),
        interleave: args.interleave.map_or(otherwise.interleave, |(n, m)| [n, m]),
        light_points: args.light_points.or(otherwise.light_points),
        picks: args.picks.or(otherwise.picks),
        longest: args.longest,
        photons: args.photons.unwrap_or(otherwise.photons),
        gather: Gather {
            rays: args.gather_rays,
            paths: args.gather_paths,
            source: source(&args.gather_source)?,
            element: args.element,
            radius: args.gather_radius,
            levels: args.gather_levels,
            cache: args.gather_cache,
        },
        clamp: args.clamp.unwrap_or(otherwise.clamp),
        absorption: args.absorption.as_deref().map_or(Ok(otherwise.absorption), absorption)?,
        sequence: args.sequence.as_deref().map_or(Ok(otherwise.sequence), sequence)?,
        seed: args.seed.unwrap_or(otherwise.seed),
        ..otherwise
    };
    settings.check()?;
    Ok(settings)
}

pub(crate) fn absorption(name: &str) -> Result<Absorption, Error> {
    let known = Absorption::ALL.iter().map(|(n, _)| *n);
    let found = Absorption::ALL.iter().find(|(n, _)| *n == name).map(|(_, a)| *a);
    found.ok_or_else(|| unknown("absorption", name, known))
}

fn source(name: &str) -> Result<Source, Error> {
    let found = Source::ALL.iter().find(|(n, _)| *n == name).map(|(_, source)| *source);
    found.ok_or_else(|| unknown("source of --gather-source", name, Source::ALL.iter().map(|(n, _)| *n)))
}

fn sequence(name: &str) -> Result<Sequence, Error> {
    Sequence::by_name(name).ok_or_else(|| unknown("sequence", name, Sequence::ALL.iter().map(|s| s.name())))
}

fn unknown(what: &str, name: &str, known: impl Iterator<Item = &'static str>) -> Error {
    let known: Vec<_> = known.collect();
    Error::BadSetting(format!("no {what} is called \"{name}\"; known: {}", known.join(", ")))
}

/// Adds batches, at least one; true if the user interrupted. `start` is when loading began.
pub(crate) fn run(
    backend: &mut dyn Backend,
    args: &EstimateArgs,
    filtered: bool,
    start: Instant,
    progress: &Progress,
) -> Result<bool, Failure> {
    let batches = args.planned_batches(filtered).unwrap_or(u32::MAX);
    let begun = Instant::now();
    interrupt::rendering();
    for index in 0..batches {
        let mean = begun.elapsed() / index.max(1);
        if index > 0 && (interrupt::asked() || overruns(args.time, start, mean)) {
            break;
        }
        backend.add(Batch { index })?;
        let frame = backend.frame()?;
        let left = time_left(args, start, begun.elapsed() / (index + 1), batches - index - 1);
        progress.step(index + 1, frame.relative_error() * frame.student_factor(), left);
    }
    progress.end();
    Ok(interrupt::asked())
}

/// Whether one more batch of that length would end after the time asked for.
fn overruns(time: Option<Duration>, start: Instant, batch: Duration) -> bool {
    time.is_some_and(|t| start.elapsed() + batch > t)
}

fn time_left(args: &EstimateArgs, start: Instant, batch: Duration, batches: u32) -> Duration {
    let by_number = batch.saturating_mul(batches);
    args.time.map_or(by_number, |t| by_number.min(t.saturating_sub(start.elapsed())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_shrink_as_pictures_grow_and_stay_within_bounds() {
        let of = |w: u64, h: u64| paths(w * h, PICTURE_PATHS);
        assert_eq!(
            [of(1, 1), of(240, 160), of(640, 480), of(1920, 1080), of(8192, 8192)],
            [64, 64, 32, 16, 16]
        );
        assert_eq!([1, 16, 10_000, 1 << 26].map(|n| paths(n, METER_PATHS)), [1024, 1024, 512, 64]);
    }
}
