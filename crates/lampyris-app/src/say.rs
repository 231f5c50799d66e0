//! Words to the user. Standard output holds results alone, standard error everything else.
//! A closed or full stream is an error value or silence, never a panic.

use crate::failure::Failure;
use serde::Serialize;
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

/// A result to standard output.
pub(crate) fn result(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // The reader has seen enough.
        Err(e) if e.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done.map_err(Failure::Output),
    }
}

/// One JSON value and a line break to standard output.
pub(crate) fn json(value: &impl Serialize) -> Result<(), Failure> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| Failure::Output(e.into()))?;
    text.push('\n');
    result(&text)
}

/// A line to standard error, if there is anybody to read it.
pub(crate) fn note(text: &str) {
    // Nobody can be told that nobody can be told.
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// What the parser of arguments has to say: help goes to standard output, complaints to standard error.
pub(crate) fn usage(text: &clap::Error) -> ExitCode {
    match (text.print(), text.use_stderr()) {
        (Err(e), false) if e.kind() != ErrorKind::BrokenPipe => Failure::Output(e).code(),
        (_, false) => ExitCode::SUCCESS,
        (_, true) => ExitCode::from(2),
    }
}
