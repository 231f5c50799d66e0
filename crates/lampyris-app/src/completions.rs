//! `lampyris completions`: a script that completes the arguments in a shell.

use crate::cli::{Cli, CompletionsArgs};
use crate::failure::Failure;
use crate::say;
use clap::CommandFactory;
use std::process::ExitCode;

/// Prints the script.
pub(crate) fn completions(args: &CompletionsArgs) -> Result<ExitCode, Failure> {
    // Into memory first: the generator panics where a stream is closed.
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "lampyris", &mut script);
    say::result(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
