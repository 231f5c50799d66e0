//! How far, how exact, how long still: one line on standard error, where that is a terminal.

use crate::cli::EstimateArgs;
use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

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
