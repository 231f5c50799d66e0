//! Undo to the beginning: a log of gestures on disk, in memory only where each begins.

use crate::error::{Error, Result};
use crate::patch::Patch;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::Path;

/// One step of undo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Gesture {
    pub(crate) label: String,
    pub(crate) forward: Patch,
    pub(crate) inverse: Patch,
}

/// The log.
pub(crate) struct History {
    file: File,
    /// Where each gesture begins, and where the last ends [bytes].
    starts: Vec<u64>,
    /// What the last gestures are called that are done and not undone.
    done: usize,
    labels: [Option<String>; 2],
}

impl History {
    /// An empty log, in a file of its own that goes with it.
    pub(crate) fn new() -> Result<History> {
        let mut random = [0; 8];
        getrandom::fill(&mut random)
            .map_err(|e| Error::System { what: "random numbers", reason: e.to_string() })?;
        let (own, random) = (std::process::id(), u64::from_le_bytes(random));
        let path = std::env::temp_dir().join(format!("lampyris-undo-{own}-{random:x}"));
        let reason = |e: std::io::Error| format!("{}: {e}", path.display());
        let file =
            fleeting(&path).map_err(|e| Error::System { what: "a file for undo", reason: reason(e) })?;
        Ok(History { file, starts: vec![0], done: 0, labels: [None, None] })
    }

    /// A gesture more; those that were undone are forgotten.
    pub(crate) fn push(&mut self, gesture: &Gesture) -> std::io::Result<()> {
        self.starts.truncate(self.done + 1);
        let start = self.starts[self.done];
        let mut line = serde_json::to_vec(gesture)?;
        line.push(b'\n');
        self.file.set_len(start)?;
        self.file.seek(SeekFrom::Start(start))?;
        self.file.write_all(&line)?;
        self.starts.push(start + line.len() as u64);
        self.done += 1;
        self.labels = [Some(gesture.label.clone()), None];
        Ok(())
    }

    /// The last gesture, undone from now on.
    pub(crate) fn undo(&mut self) -> std::io::Result<Option<Gesture>> {
        if self.done == 0 {
            return Ok(None);
        }
        let gesture = self.read(self.done - 1)?;
        self.done -= 1;
        let before = if self.done == 0 { None } else { Some(self.read(self.done - 1)?.label) };
        self.labels = [before, Some(gesture.label.clone())];
        Ok(Some(gesture))
    }

    /// The gesture that was undone last, done again from now on.
    pub(crate) fn redo(&mut self) -> std::io::Result<Option<Gesture>> {
        if self.done + 1 == self.starts.len() {
            return Ok(None);
        }
        let gesture = self.read(self.done)?;
        self.done += 1;
        let next = if self.done + 1 == self.starts.len() { None } else { Some(self.read(self.done)?.label) };
        self.labels = [Some(gesture.label.clone()), next];
        Ok(Some(gesture))
    }

    /// Forgets everything.
    pub(crate) fn clear(&mut self) {
        self.starts.truncate(1);
        (self.done, self.labels) = (0, [None, None]);
    }

    /// What would be undone, and what redone.
    pub(crate) fn labels(&self) -> &[Option<String>; 2] {
        &self.labels
    }

    /// How many steps can be undone.
    pub(crate) fn steps(&self) -> usize {
        self.done
    }

    fn read(&mut self, number: usize) -> std::io::Result<Gesture> {
        self.file.seek(SeekFrom::Start(self.starts[number]))?;
        let mut line = String::new();
        BufReader::new(&self.file).read_line(&mut line)?;
        Ok(serde_json::from_str(&line)?)
    }
}

/// A new file of which nothing is left when the program ends, however it ends.
fn fleeting(path: &Path) -> std::io::Result<File> {
    let mut options = File::options();
    options.read(true).write(true).create_new(true);
    // Windows takes it away with its last handle; elsewhere it needs no name as long as it is open.
    #[cfg(windows)]
    std::os::windows::fs::OpenOptionsExt::custom_flags(&mut options, 0x0400_0000);
    let file = options.open(path)?;
    #[cfg(not(windows))]
    std::fs::remove_file(path)?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gesture(number: u32) -> Gesture {
        let patch = |level: u32| -> Patch {
            serde_json::from_str(&format!("{{\"lamps\":{{\"0\":{{\"level\":{level}}}}}}}")).unwrap()
        };
        Gesture { label: format!("step {number}"), forward: patch(number), inverse: patch(number + 1) }
    }

    #[test]
    fn back_to_the_beginning_and_forth() {
        let mut history = History::new().unwrap();
        (0..100).for_each(|k| history.push(&gesture(k)).unwrap());
        for k in (0..100).rev() {
            assert_eq!(history.labels()[0], Some(format!("step {k}")));
            assert_eq!(history.undo().unwrap(), Some(gesture(k)));
        }
        assert_eq!((history.undo().unwrap(), history.labels()[0].clone()), (None, None));
        for k in 0..50 {
            assert_eq!(history.labels()[1], Some(format!("step {k}")));
            assert_eq!(history.redo().unwrap(), Some(gesture(k)));
        }
        // A new one takes the place of those undone.
        history.push(&gesture(1000)).unwrap();
        assert_eq!((history.redo().unwrap(), history.steps()), (None, 51));
        assert_eq!(history.undo().unwrap(), Some(gesture(1000)));
        assert_eq!(history.undo().unwrap(), Some(gesture(49)));
    }

    /// Who kills the program leaves no file behind: it has no name from the first.
    #[cfg(unix)]
    #[test]
    fn nothing_is_left() {
        let mut history = History::new().unwrap();
        assert_eq!(std::os::unix::fs::MetadataExt::nlink(&history.file.metadata().unwrap()), 0);
        history.push(&gesture(0)).unwrap();
        assert_eq!(history.undo().unwrap(), Some(gesture(0)));
    }
}
