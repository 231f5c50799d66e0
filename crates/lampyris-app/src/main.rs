//! The program `lampyris`: pictures, measurements and figures of scenes from the command line.
//! It reads arguments, calls the library and says what came of it; no light is transported here.

mod bench;
mod cli;
mod completions;
mod estimate;
mod failure;
mod info;
mod interrupt;
mod lab;
mod list;
mod measure;
mod memory;
mod parse;
mod play;
mod progress;
mod render;
mod say;
mod scene_file;
mod view;
mod viewing;

use clap::Parser;
use cli::{Cli, Command};
use std::process::ExitCode;

fn main() -> ExitCode {
    let command = match Cli::try_parse() {
        Ok(cli) => cli.command,
        Err(text) => return say::usage(&text),
    };
    interrupt::watch();
    let done = match command {
        Command::Render(args) => render::render(&args),
        Command::Play(args) => play::play(&args),
        Command::Measure(args) => measure::measure(&args),
        Command::View(args) => view::view(*args),
        Command::Bench(args) => bench::bench(&args),
        Command::Info(args) => info::info(&args),
        Command::Lab(args) => lab::lab(&args.command),
        Command::List(args) => list::list(&args),
        Command::Completions(args) => completions::completions(&args),
    };
    done.unwrap_or_else(|failure| {
        say::note(&format!("error: {failure}"));
        failure.code()
    })
}
