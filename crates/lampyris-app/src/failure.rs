//! Why a command ends without success, and the exit code that tells a script so.

use lampyris::Error;
use std::fmt;
use std::process::ExitCode;

/// The code after Ctrl-C, by the custom of shells: 128 + SIGINT.
pub(crate) const INTERRUPTED: u8 = 130;

/// What went wrong, in one line.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The library says it.
    Library(Error),
    /// The desk says it.
    Desk(lampyris_desk::Error),
    /// The laboratory says it.
    Lab(lampyris_lab::Error),
    /// Standard output does not take what was asked for.
    Output(std::io::Error),
}

impl Failure {
    /// 2 usage, 3 bad input, 4 output failed, 5 over a limit.
    pub(crate) fn code(&self) -> ExitCode {
        ExitCode::from(match self {
            Failure::Library(Error::BadSetting(_)) => 2,
            Failure::Library(Error::BadInput { .. } | Error::CannotRead { .. }) => 3,
            Failure::Library(Error::CannotWrite { .. }) | Failure::Output(_) => 4,
            Failure::Lab(lampyris_lab::Error::CannotWrite { .. }) => 4,
            Failure::Lab(lampyris_lab::Error::Unknown { .. }) => 2,
            Failure::Library(Error::OverLimit { .. }) => 5,
            Failure::Desk(lampyris_desk::Error::CannotListen { .. } | lampyris_desk::Error::Exposed(_)) => 2,
            Failure::Library(_) | Failure::Desk(_) | Failure::Lab(_) => 1,
        })
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure::Library(error)
    }
}

impl From<lampyris_desk::Error> for Failure {
    fn from(error: lampyris_desk::Error) -> Failure {
        match error {
            lampyris_desk::Error::Library(error) => Failure::Library(error),
            other => Failure::Desk(other),
        }
    }
}

impl From<lampyris_lab::Error> for Failure {
    fn from(error: lampyris_lab::Error) -> Failure {
        match error {
            lampyris_lab::Error::Library(error) => Failure::Library(error),
            other => Failure::Lab(other),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // One line, whatever a file's name holds.
            Failure::Library(error) => write!(f, "{}", error.to_string().replace(['\n', '\r'], " ")),
            Failure::Desk(error) => error.fmt(f),
            Failure::Lab(error) => write!(f, "{}", error.to_string().replace(['\n', '\r'], " ")),
            Failure::Output(error) => write!(f, "cannot write to standard output: {error}"),
        }
    }
}
