//! What can go wrong in the laboratory.

use std::path::PathBuf;

/// Every failure of an experiment or a report.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The library says it: a scene, a setting or a picture.
    #[error(transparent)]
    Library(#[from] lampyris::Error),
    /// No experiment has that name.
    #[error("no experiment is called \"{name}\"; known: {known}, all")]
    Unknown {
        /// The name asked for.
        name: String,
        /// Those there are.
        known: String,
    },
    /// A file of the report cannot be written or read: check space, path and rights.
    #[error("cannot write {}: {reason}", file.display())]
    CannotWrite {
        /// The file.
        file: PathBuf,
        /// Why, in words.
        reason: String,
    },
    /// What was asked for ended before its time, on demand.
    #[error("interrupted")]
    Interrupted,
}

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;
