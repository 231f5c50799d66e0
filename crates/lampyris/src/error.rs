//! What can go wrong, sorted by what the user can do about it.
//! Bugs panic nowhere: anything that depends on a file or an argument ends here.

use std::path::PathBuf;

/// Every failure of the library. The message names the file, the place and the mend.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A scene file is broken: mend the file at the place named.
    #[error("{}:{place}: {reason}", file.display())]
    BadInput {
        /// The file that holds the fault (an included file, where the fault is there).
        file: PathBuf,
        /// Where in the file: a line number, or an offset in a binary format.
        place: String,
        /// What is wrong there, and how to mend it.
        reason: String,
    },
    /// A file could not be read: check its path and rights.
    #[error("cannot read {}: {reason}", file.display())]
    CannotRead {
        /// The file asked for.
        file: PathBuf,
        /// Why, in words.
        reason: String,
    },
    /// A picture could not be written: check space, path and rights. What was there before is intact.
    #[error("cannot write {}: {reason}", file.display())]
    CannotWrite {
        /// The file asked for.
        file: PathBuf,
        /// Why, in words.
        reason: String,
    },
    /// The scene needs more than a limit allows: raise the limit named, if the scene is trusted.
    #[error("{}:{place}: {what} exceeds the limit of {limit}; raise it with {option}", file.display())]
    OverLimit {
        /// The file that asks for too much.
        file: PathBuf,
        /// Where in the file.
        place: String,
        /// What would be exceeded, with the figure that was asked for where it is known.
        what: String,
        /// The limit in force.
        limit: u64,
        /// The option of the program that raises it.
        option: &'static str,
    },
    /// A setting makes no sense: change it.
    #[error("{0}")]
    BadSetting(String),
}

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;
