//! How far, how exact, how long still: one line on standard error, where that is a terminal.

use crate::cli::EstimateArgs;
use indicatif::{ProgressBar, ProgressStyle};
use lampyris_lab::Experiment;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// The line.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    /// A line for the work that the arguments ask for; none if `quiet`.
    pub(crate) fn new(args: &EstimateArgs, filtered: bool, quiet: bool) -> Progress {
        let bar = match (quiet, args.planned_batches(filtered)) {
            (true, _) => ProgressBar::hidden(),
            (_, None) => ProgressBar::new_spinner(),
            (_, Some(batches)) => ProgressBar::new(batches.into()),
        };
        let template =
            if bar.length().is_some() { "{bar:24} {pos}/{len} {msg}" } else { "{pos} batches {msg}" };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        Progress(bar)
    }

    /// `done` batches are; `error` is half the relative 95 % interval of the picture's mean.
    pub(crate) fn step(&self, done: u32, error: f32, left: Duration) {
        self.0.set_position(done.into());
        self.0.set_message(format!("{}, {} left", error_text(error), clock(left)));
    }

    /// Takes the line away.
    pub(crate) fn end(&self) {
        self.0.finish_and_clear();
    }
}

/// The line of a walkthrough.
pub(crate) struct FrameProgress(ProgressBar);

impl FrameProgress {
    /// A line for so many frames; none if `quiet`.
    pub(crate) fn new(frames: u32, quiet: bool) -> FrameProgress {
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(frames.into()) };
        if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} frames {msg}") {
            bar.set_style(style);
        }
        FrameProgress(bar)
    }

    /// `done` frames are, of `seconds` in the median.
    pub(crate) fn step(&self, done: u32, seconds: f32) {
        self.0.set_position(done.into());
        self.0.set_message(format!("of {seconds:.3} s"));
    }

    /// Takes the line away.
    pub(crate) fn end(&self) {
        self.0.finish_and_clear();
    }
}

/// The line of the laboratory: experiments count by how long they are known to take.
pub(crate) struct LabProgress {
    bar: ProgressBar,
    quick: usize,
    start: Instant,
    /// Seconds that experiments should have taken: of those that are done, and of the one at hand.
    at: Mutex<[f64; 2]>,
    all: f64,
}

impl LabProgress {
    /// A line for these experiments; none if `quiet`.
    pub(crate) fn new(experiments: &[&Experiment], quick: bool, quiet: bool) -> LabProgress {
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(1000) };
        if let Ok(style) = ProgressStyle::with_template("{bar:24} {msg}") {
            bar.set_style(style);
        }
        let quick = usize::from(!quick);
        let all = experiments.iter().map(|e| e.seconds[quick]).sum();
        LabProgress { bar, quick, start: Instant::now(), at: Mutex::default(), all }
    }

    /// The next experiment begins.
    pub(crate) fn begin(&self, experiment: &Experiment) {
        if let Ok(mut at) = self.at.lock() {
            *at = [at[0] + at[1], experiment.seconds[self.quick]];
        }
        self.bar.set_prefix(experiment.name);
        self.step(0.0);
    }

    /// A share of the experiment at hand is done.
    pub(crate) fn step(&self, share: f64) {
        let Ok([before, own]) = self.at.lock().map(|at| *at) else { return };
        let done = before + own * share;
        // Until something is known of this machine, it is as fast as the one that the estimates are from.
        let pace = if done > 1.0 { self.start.elapsed().as_secs_f64() / done } else { 1.0 };
        let left = Duration::try_from_secs_f64((self.all - done) * pace).unwrap_or_default();
        self.bar.set_position((1000.0 * done / self.all.max(1e-3)) as u64);
        self.bar.set_message(format!("{}, {} left", self.bar.prefix(), clock(left)));
    }

    /// Takes the line away.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}

/// An error for people.
pub(crate) fn error_text(error: f32) -> String {
    if error.is_finite() { format!("error {:.2} %", error * 100.0) } else { "error not yet known".into() }
}

fn clock(time: Duration) -> String {
    let seconds = time.as_secs();
    format!("{}:{:02}", seconds / 60, seconds % 60)
}

/// What is being done before there is anything to count; the line is gone when this is.
pub(crate) struct Phase(ProgressBar);

impl Phase {
    /// Begins with `what`; says nothing if `quiet`, nor where standard error is no terminal.
    pub(crate) fn begin(what: &'static str, quiet: bool) -> Phase {
        let spinner = if quiet { ProgressBar::hidden() } else { ProgressBar::new_spinner() };
        spinner.set_message(what);
        spinner.enable_steady_tick(Duration::from_millis(100));
        Phase(spinner)
    }

    /// Goes on with `what`.
    pub(crate) fn then(&self, what: &'static str) {
        self.0.set_message(what);
    }
}

impl Drop for Phase {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
