//! Reading files that a scene names, and none beside: all lie beneath one root folder and are regular files.
//! A name is checked twice before anything is opened: as text, so that names that climb out do not even tell whether
//! they exist, and with its symbolic links followed. Nothing here knows a format.

use super::Options;
use super::report::quote;
use crate::error::{Error, Result};
use std::fs::File;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

/// The folder beneath which a scene's files must lie, and how large each may be.
pub(crate) struct Root {
    folder: PathBuf,
    limit: u64,
}

impl Root {
    /// The root for the scene at `scene`, and that file's path with links followed.
    pub(crate) fn new(scene: &Path, options: &Options) -> Result<(Root, PathBuf)> {
        let unreadable =
            |file: &Path, e: std::io::Error| Error::CannotRead { file: file.into(), reason: e.to_string() };
        let file = scene.canonicalize().map_err(|e| unreadable(scene, e))?;
        let folder = match &options.root {
            Some(root) => root.canonicalize().map_err(|e| unreadable(root, e))?,
            // Its own folder is where the name given lies, wherever a link may lead.
            None => {
                let parent = scene.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
                parent.canonicalize().map_err(|e| unreadable(parent, e))?
            }
        };
        let root = Root { folder, limit: options.limits.file_bytes };
        match root.refusal(&file) {
            None => Ok((root, file)),
            Some(reason) => Err(Error::CannotRead { file: scene.into(), reason }),
        }
    }

    /// The file called `name` in the file `from` (canonical), checked; or why it is refused.
    pub(crate) fn resolve(&self, from: &Path, name: &str) -> std::result::Result<PathBuf, String> {
        let shown = quote(name);
        let path = Path::new(name);
        let drive = name.as_bytes().get(1) == Some(&b':');
        if path.has_root() || drive || name.starts_with('\\') || name.contains("://") || name.contains('\0') {
            return Err(format!("{shown} is not a relative path; name files relative to this one"));
        }
        // As text first: what lies outside is not looked at.
        let mut folder = from.parent().unwrap_or(&self.folder).to_path_buf();
        for part in path.components() {
            match part {
                Component::ParentDir => {
                    folder.pop();
                    if !folder.starts_with(&self.folder) {
                        return Err(self.outside(&shown));
                    }
                }
                Component::Normal(name) => folder.push(name),
                _ => {}
            }
        }
        // The text decides only what may be looked at; the links decide what it is.
        let found = from.parent().unwrap_or(&self.folder).join(path).canonicalize();
        let found = found.map_err(|e| format!("cannot open {shown}: {e}"))?;
        match self.refusal(&found) {
            None => Ok(found),
            Some(reason) => Err(format!("{shown}: {reason}")),
        }
    }

    /// The bytes of a file that [`Root::resolve`] or [`Root::new`] returned.
    pub(crate) fn read(&self, file: &Path) -> Result<Vec<u8>> {
        let unreadable = |e: std::io::Error| Error::CannotRead { file: file.into(), reason: e.to_string() };
        let open = File::open(file).map_err(unreadable)?;
        let size = open.metadata().map_err(unreadable)?;
        if !size.is_file() {
            return Err(Error::CannotRead { file: file.into(), reason: "it is not a regular file".into() });
        }
        let over = |bytes: u64| Error::OverLimit {
            file: file.into(),
            place: "0".into(),
            what: format!("the file's size of {bytes} bytes"),
            limit: self.limit,
            option: "--max-file-bytes",
        };
        if size.len() > self.limit {
            return Err(over(size.len()));
        }
        // As much as it has, at once: growing would take up to twice as much.
        let mut bytes = Vec::new();
        let room = usize::try_from(size.len()).unwrap_or(usize::MAX);
        bytes.try_reserve_exact(room).map_err(|_| over(size.len()))?;
        open.take(self.limit.saturating_add(1)).read_to_end(&mut bytes).map_err(unreadable)?;
        // It may have grown since it was measured.
        if bytes.len() as u64 > self.limit { Err(over(bytes.len() as u64)) } else { Ok(bytes) }
    }

    /// Why a canonical path must not be opened.
    fn refusal(&self, file: &Path) -> Option<String> {
        if !file.starts_with(&self.folder) {
            return Some(self.outside("it"));
        }
        // Opening a pipe would wait for ever, and reading a device has no end.
        match std::fs::symlink_metadata(file) {
            Ok(kind) if kind.is_file() => None,
            Ok(_) => Some("it is not a regular file".into()),
            Err(e) => Some(e.to_string()),
        }
    }

    fn outside(&self, what: &str) -> String {
        format!(
            "{what} lies outside the scene's root {}; if the scene is trusted, widen the root with --root DIR",
            self.folder.display()
        )
    }
}
