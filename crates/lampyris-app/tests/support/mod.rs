//! What tests of the program share: running it, folders of their own, and our scenes.

#![allow(dead_code, reason = "each file of tests uses some of it")]

pub(crate) mod desk;
pub(crate) mod dice;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a run left.
pub(crate) struct Run {
    /// Exit code.
    pub(crate) code: i32,
    /// Standard output.
    pub(crate) out: String,
    /// Standard error.
    pub(crate) err: String,
}

impl Run {
    /// Standard output, which must be one JSON value.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|e| panic!("{e}: {} {}", self.out, self.err))
    }
}

/// The program with its arguments separated by blanks, in a folder.
pub(crate) fn command(folder: &Folder, args: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lampyris"));
    command.args(args.split_whitespace()).current_dir(&folder.0);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs the program to its end.
pub(crate) fn run(folder: &Folder, args: &str) -> Run {
    let output = command(folder, args).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Run { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
}

/// A folder of a test's own, gone at the end.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    /// An empty folder that holds copies of our small scenes.
    pub(crate) fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("lampyris-app-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        for scene in ["cornell.mgf", "cube.mgf"] {
            let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(scene);
            std::fs::copy(from, path.join(scene)).unwrap();
        }
        Folder(path)
    }

    /// Puts a file into it.
    pub(crate) fn put(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    /// The bytes of a file in it.
    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Names of the files beside the scenes.
    pub(crate) fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let names = entries.map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.filter(|n| n != "cornell.mgf" && n != "cube.mgf").collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Left behind at worst.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
