//! From arguments to settings, and batch after batch until enough is known, time is up or the user has seen enough.

use crate::cli::EstimateArgs;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use lampyris::Error;
use lampyris::backend::{Absorption, Backend, Batch, Settings};
use lampyris::integrator;
use lampyris::sequence::Sequence;
use std::time::{Duration, Instant};

/// Light paths that share an eye pass unless `--spp` says otherwise. One pass a path, as in the 1997 report, spends most
/// of the time on eye rays: eight a pass halve the error at equal time (docs/performance.md).
const PATHS_PER_EYE_PASS: u32 = 8;

/// Batches where neither their number nor a time is given: each randomisation has several.
const BATCHES: u32 = 8;

/// The settings that the arguments ask for.
pub(crate) fn settings(args: &EstimateArgs) -> Result<Settings, Failure> {
    let defaults = Settings::default();
    let mut parts = Vec::new();
    for name in &args.parts {
        match name.as_str() {
            "all" => parts.extend(integrator::WHOLE.iter().map(|n| (*n).to_owned())),
            _ => parts.push(name.clone()),
        }
    }
    parts.dedup();
    if args.no_compensate {
        parts.retain(|p| p != "compensation");
    }
    let paths = args.paths.unwrap_or(defaults.paths);
    let settings = Settings {
        parts,
        paths,
        passes: Some(args.spp.unwrap_or(paths.div_ceil(PATHS_PER_EYE_PASS))),
        clamp: args.clamp.unwrap_or(defaults.clamp),
        absorption: args.absorption.as_deref().map_or(Ok(defaults.absorption), absorption)?,
        sequence: args.sequence.as_deref().map_or(Ok(defaults.sequence), sequence)?,
        seed: args.seed.unwrap_or(defaults.seed),
        ..defaults
    };
    settings.check()?;
    Ok(settings)
}

fn absorption(name: &str) -> Result<Absorption, Error> {
    let known = Absorption::ALL.iter().map(|(n, _)| *n);
    let found = Absorption::ALL.iter().find(|(n, _)| *n == name).map(|(_, a)| *a);
    found.ok_or_else(|| unknown("absorption", name, known))
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
    start: Instant,
    progress: &Progress,
) -> Result<bool, Failure> {
    let batches = args.batches.unwrap_or(if args.time.is_some() { u32::MAX } else { BATCHES });
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
