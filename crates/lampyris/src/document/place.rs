//! Where a document lies while a scene is being edited: beside the scene, or, where that folder takes no files, in the user's
//! own. One program at a time writes there; what it writes is whole, or was never there.

use super::open::Opened;
use super::{Document, Environment, Reading};
use crate::atomic;
use crate::error::{Error, Result};
use std::ffi::{OsStr, OsString};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// How the name of a document ends.
pub(super) const SUFFIX: &str = ".lampyris.json";

/// A place that is this program's alone, until it is dropped.
pub struct Place {
    file: PathBuf,
    /// How the scene is read, in names that hold from here.
    reading: Reading,
    /// What lies there, as far as this program has read or written it.
    known: Option<Digest>,
    notes: Vec<String>,
    _lock: Lock,
}

/// By what two texts are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest {
    bytes: u64,
    /// FNV-1a.
    hash: u64,
}

impl Digest {
    pub(super) fn new(text: &[u8]) -> Digest {
        let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        Digest { bytes: text.len() as u64, hash: text.iter().fold(0xcbf2_9ce4_8422_2325, mix) }
    }

    fn of_file(file: &Path) -> Option<Digest> {
        std::fs::read(file).ok().map(|text| Digest::new(&text))
    }
}

/// Where the document of a scene lies: `office.mgf.lampyris.json` beside `office.mgf`.
pub fn beside(scene: &Path) -> PathBuf {
    let mut name = scene.file_name().unwrap_or_default().to_owned();
    name.push(SUFFIX);
    scene.with_file_name(name)
}

/// The user's folder for what programs keep: `$XDG_STATE_HOME/lampyris`, or `~/.local/state/lampyris`.
pub fn state_folder() -> Option<PathBuf> {
    let folder = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let state = folder("XDG_STATE_HOME").or_else(|| folder("LOCALAPPDATA"));
    state.or_else(|| folder("HOME").map(|home| home.join(".local/state"))).map(|state| state.join("lampyris"))
}

/// Where in the user's folder a document lies that has no room at `home`: by its name, and by where it would be.
pub(super) fn refuge(state: &Path, home: &Path) -> Option<PathBuf> {
    let home = std::path::absolute(home).ok()?;
    let folder = home.parent()?;
    let home = folder.canonicalize().unwrap_or_else(|_| folder.into()).join(home.file_name()?);
    // So that scenes of one name do not meet.
    let hash = Digest::new(home.as_os_str().as_encoded_bytes()).hash;
    let mut name = OsString::from(stem(&home)?);
    name.push(format!("-{hash:016x}{SUFFIX}"));
    Some(state.join(name))
}

/// A document's name without its ending.
fn stem(file: &Path) -> Option<&str> {
    let name = file.file_name()?.to_str()?;
    Some(name.strip_suffix(SUFFIX).unwrap_or(name))
}

impl Place {
    /// Claims the place for the edits of what was opened: where its document lies, or beside the scene; in the user's folder
    /// `state` if nothing can be written there, which [`Place::notes`] then says.
    ///
    /// # Errors
    /// [`Error::CannotWrite`] if another program has the place, or if there is none.
    pub fn claim(opened: &Opened, state: Option<&Path>) -> Result<Place> {
        let home = opened.document_file.clone().unwrap_or_else(|| beside(&opened.scene_file));
        let taken = |file: &Path| {
            let reason = "another program is editing it; close that first".into();
            Error::CannotWrite { file: file.into(), reason }
        };
        let refused = match Lock::new(&home) {
            Ok(lock) => return Place::new(home, lock, opened),
            Err(Refusal::Taken) => return Err(taken(&home)),
            Err(Refusal::Io(error)) => error,
        };
        let none = |why: &dyn std::fmt::Display| {
            let reason = format!("{refused}; nor is there another folder for it: {why}");
            Error::CannotWrite { file: home.clone(), reason }
        };
        let state = state.ok_or_else(|| none(&"neither XDG_STATE_HOME nor HOME is set"))?;
        std::fs::create_dir_all(state).map_err(|e| none(&e))?;
        let file = refuge(state, &home).ok_or_else(|| none(&"its name is not Unicode"))?;
        match Lock::new(&file) {
            Ok(lock) => {
                let mut place = Place::new(file, lock, opened)?;
                let (home, file) = (home.display(), place.file.display());
                place.notes.push(format!("cannot write {home}: {refused}; edits are kept in {file}"));
                Ok(place)
            }
            Err(Refusal::Taken) => Err(taken(&file)),
            Err(Refusal::Io(error)) => Err(none(&error)),
        }
    }

    fn new(file: PathBuf, lock: Lock, opened: &Opened) -> Result<Place> {
        sweep(&file);
        let mut notes = Vec::new();
        let unnamed = || Error::CannotWrite {
            file: file.clone(),
            reason: "the name of the scene's file is not Unicode; give it another".into(),
        };
        let scene = name_from(&file, &opened.scene_file).ok_or_else(unnamed)?;
        let environment = match &opened.environment {
            Some((picture, scale)) => {
                let name = name_from(&file, picture).ok_or_else(unnamed)?;
                if Path::new(&name).is_absolute() {
                    notes.push(format!(
                        "{name} lies outside the document's folder: name it again with --environment"
                    ));
                }
                Some(Environment { file: name, scale: *scale })
            }
            None => None,
        };
        let reading = Reading { file: scene, circle: opened.document.scene.circle, environment };
        let known = opened.digest.filter(|_| opened.document_file.as_deref() == Some(&file));
        Ok(Place { file, reading, known, notes, _lock: lock })
    }

    /// The document's file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// What the user should know of the place, a line each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Saves a document. What lies there and was neither opened nor written by this program, edits of an earlier time or of
    /// another hand, is kept under another name, which is returned.
    ///
    /// # Errors
    /// [`Error::CannotWrite`]; what was there before is intact.
    pub fn save(&mut self, document: &Document) -> Result<Option<PathBuf>> {
        if !is_ours(&self.file) {
            return Err(self.blocked());
        }
        let found = std::fs::metadata(&self.file).ok().map(|file| file.len());
        let same = |known: Digest| found == Some(known.bytes) && Digest::of_file(&self.file) == Some(known);
        let kept = if found.is_none() || self.known.is_some_and(same) { None } else { Some(self.keep()?) };
        self.known = Some(self.write(&self.file, document)?);
        Ok(kept)
    }

    /// Saves a version of a name, `office.mgf.NAME.lampyris.json`, and returns its file. A version of that name is replaced.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for a name of other than letters, digits, blanks, `-` and `_`, or of more than 64;
    /// [`Error::CannotWrite`].
    pub fn save_version(&self, name: &str, document: &Document) -> Result<PathBuf> {
        let plain = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
        if name.is_empty() || name.chars().count() > 64 || !name.chars().all(plain) {
            let mend = "needs 1 to 64 letters, digits, blanks, - or _";
            return Err(Error::BadSetting(format!("the name of a version {mend}")));
        }
        let file = self.version(name)?;
        self.write(&file, document)?;
        Ok(file)
    }

    fn version(&self, name: &str) -> Result<PathBuf> {
        let stem = stem(&self.file).ok_or_else(|| self.cannot("its name is not Unicode"))?;
        Ok(self.file.with_file_name(format!("{stem}.{name}{SUFFIX}")))
    }

    /// Gives what lies here the first name that is free.
    fn keep(&self) -> Result<PathBuf> {
        for number in 1..10_000 {
            let file = self.version(&number.to_string())?;
            if std::fs::symlink_metadata(&file).is_err() {
                std::fs::rename(&self.file, &file).map_err(|e| self.cannot(e))?;
                return Ok(file);
            }
        }
        Err(self.cannot("too many earlier ones lie beside it"))
    }

    fn write(&self, file: &Path, document: &Document) -> Result<Digest> {
        // A link that came with a scene could lead to any of the user's files.
        if !is_ours(file) {
            return Err(self.blocked());
        }
        let text = Document { scene: self.reading.clone(), ..document.clone() }.text();
        let cannot = |e: io::Error| Error::CannotWrite { file: file.into(), reason: e.to_string() };
        atomic::write(file, text.as_bytes()).map_err(cannot)?;
        Ok(Digest::new(text.as_bytes()))
    }

    fn blocked(&self) -> Error {
        self.cannot("a link or folder of its name is in the way")
    }

    fn cannot(&self, why: impl std::fmt::Display) -> Error {
        Error::CannotWrite { file: self.file.clone(), reason: why.to_string() }
    }
}

/// The name of a file from a document: relative if it lies beneath the document's folder, else from the root.
fn name_from(document: &Path, file: &Path) -> Option<String> {
    let folder = document.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // Folders with links followed; the file under its own name, by which a scene may call what it holds.
    let own = std::path::absolute(file).ok()?;
    let (folder, own_folder) = (folder.canonicalize().ok()?, own.parent()?.canonicalize().ok()?);
    let file = own_folder.join(own.file_name()?);
    let name = file.strip_prefix(&folder).unwrap_or(&file);
    name.to_str().map(str::to_owned)
}

/// True if a regular file is there, or nothing.
fn is_ours(file: &Path) -> bool {
    match std::fs::symlink_metadata(file) {
        Ok(found) => found.is_file(),
        Err(error) => error.kind() == ErrorKind::NotFound,
    }
}

/// Takes away what a program left that was killed while it wrote. Nobody else writes here now.
fn sweep(file: &Path) {
    let (Some(folder), Some(name)) = (file.parent(), file.file_name().and_then(OsStr::to_str)) else {
        return;
    };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let start = format!(".{name}.");
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let left = entry.file_name().to_str().is_some_and(|n| n.starts_with(&start) && n.ends_with(".part"));
        if left {
            // It is in nobody's way.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// An empty file beside a document, locked as long as this lives, and gone afterwards. The document itself cannot be the
/// lock: each saving puts another file in its place.
struct Lock {
    path: PathBuf,
    _file: File,
}

enum Refusal {
    Taken,
    Io(io::Error),
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Refusal {
        Refusal::Io(error)
    }
}

impl Lock {
    fn new(document: &Path) -> std::result::Result<Lock, Refusal> {
        let other = |what: &str| Refusal::Io(io::Error::new(ErrorKind::InvalidInput, what));
        let mut name = OsString::from(".");
        name.push(document.file_name().ok_or_else(|| other("the path names no file"))?);
        name.push(".lock");
        let path = document.with_file_name(name);
        if !is_ours(&path) || !is_ours(document) {
            return Err(other("a link or folder of its name is in the way"));
        }
        // Whoever had it may take it away between opening and locking; then there is another.
        for _ in 0..100 {
            let file = OpenOptions::new().write(true).create(true).truncate(false).open(&path)?;
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(Refusal::Taken),
                // Some file systems know no locks; a second writer is rarer than they are.
                Err(TryLockError::Error(e)) if e.kind() == ErrorKind::Unsupported => {}
                Err(TryLockError::Error(e)) => return Err(e.into()),
            }
            if is_at(&file, &path) {
                return Ok(Lock { path, _file: file });
            }
        }
        Err(Refusal::Taken)
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Where nobody could tell that it is another file by now, it stays.
        if cfg!(unix) {
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

/// True if the open file is the one of this name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |(a, b): (std::fs::Metadata, std::fs::Metadata)| (a.dev(), a.ino()) == (b.dev(), b.ino());
    file.metadata().ok().zip(std::fs::metadata(path).ok()).is_some_and(same)
}

/// Elsewhere it is not taken away.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}
