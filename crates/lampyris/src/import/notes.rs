//! What there is to say about a file: warnings with the element they are about, and errors made the same way.

use crate::error::Error;
use crate::import::report::Report;
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Warnings so far, and the file's name.
pub(super) struct Notes {
    file: PathBuf,
    shown: String,
    report: Report,
}

impl Notes {
    /// None yet, about `file`.
    pub(super) fn new(file: &Path) -> Notes {
        let shown = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Notes { file: file.into(), shown, report: Report::default() }
    }

    /// Notes that something was ignored or mended.
    pub(super) fn warn(&mut self, place: impl Display, kind: &str) {
        self.report.warn(kind, || format!("{}:{place}", self.shown));
    }

    /// The file is broken.
    pub(super) fn bad(&self, place: impl Display, reason: impl Into<String>) -> Error {
        Error::BadInput { file: self.file.clone(), place: place.to_string(), reason: reason.into() }
    }

    /// The file asks for too much; no error if it does not.
    pub(super) fn limit(
        &self,
        place: impl Display,
        what: &str,
        asked: u64,
        limit: u64,
        option: &'static str,
    ) -> Result<(), Error> {
        if asked <= limit {
            return Ok(());
        }
        let what = format!("{what} ({asked})");
        Err(Error::OverLimit { file: self.file.clone(), place: place.to_string(), what, limit, option })
    }

    /// One line for each kind.
    pub(super) fn into_lines(self) -> Vec<String> {
        self.report.into_lines()
    }
}
