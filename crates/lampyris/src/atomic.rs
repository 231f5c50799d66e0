//! A file is the whole old one or the whole new one at every instant, whatever fails.
//! The bytes go to a temporary file beside it, to the disk, and then to their name by one rename.

use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Result, Write};
use std::path::{Path, PathBuf};

/// Puts `bytes` at `path`. On failure the temporary file is gone and what was at `path` is untouched.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    // A link keeps pointing where it does: the file it names is the one replaced.
    let path = path.canonicalize().unwrap_or_else(|_| path.into());
    let name =
        path.file_name().ok_or_else(|| Error::new(ErrorKind::InvalidInput, "the path names no file"))?;
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if path.is_dir() {
        return Err(Error::new(ErrorKind::IsADirectory, "it is a folder"));
    }
    let (mut file, temporary) = create_beside(folder, &name.to_string_lossy())?;
    file.write_all(bytes)?;
    file.sync_all()?;
    drop(file);
    std::fs::rename(&temporary.0, &path)?;
    sync_folder(folder)
}

/// A temporary file's path; dropping it removes the file, if a rename has not already moved it away.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        // After the rename there is nothing to remove, after a failure nobody to tell.
        let _ = std::fs::remove_file(&self.0);
    }
}

/// A new file of a name that no one else uses, in the folder of the final one: a rename cannot cross file systems.
fn create_beside(folder: &Path, name: &str) -> Result<(File, Temporary)> {
    let process = std::process::id();
    for attempt in 0..100 {
        let path = folder.join(format!(".{name}.{process}-{attempt}.part"));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((file, Temporary(path))),
            Err(e) if e.kind() == ErrorKind::AlreadyExists => {}
            Err(e) => return Err(e),
        }
    }
    Err(Error::new(ErrorKind::AlreadyExists, "too many temporary files beside it"))
}

/// Brings the rename itself to the disk.
fn sync_folder(folder: &Path) -> Result<()> {
    #[cfg(unix)]
    match File::open(folder)?.sync_all() {
        // Some file systems have no such call for folders; the rename is done all the same.
        Err(e) if !matches!(e.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => return Err(e),
        _ => {}
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own, gone at the end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Folder {
            let path = std::env::temp_dir().join(format!("lampyris-{name}-{}", std::process::id()));
            std::fs::create_dir_all(&path).unwrap();
            Folder(path)
        }

        fn files(&self) -> Vec<String> {
            let entries = std::fs::read_dir(&self.0).unwrap();
            let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
            names.sort();
            names
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn replaces_and_leaves_nothing_else() {
        let folder = Folder::new("replace");
        let path = folder.0.join("a.png");
        write(&path, b"old").unwrap();
        write(&path, b"new").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"new");
        assert_eq!(folder.files(), ["a.png"]);
    }

    #[test]
    fn a_failed_rename_leaves_no_temporary_file() {
        let folder = Folder::new("rename");
        let (_, temporary) = create_beside(&folder.0, "a.png").unwrap();
        assert_eq!(folder.files().len(), 1);
        assert!(std::fs::rename(&temporary.0, folder.0.join("missing/a.png")).is_err());
        drop(temporary);
        assert!(folder.files().is_empty());
    }

    #[test]
    fn readers_never_see_half_a_file() {
        let folder = Folder::new("readers");
        let path = folder.0.join("a.exr");
        let whole = |k: u8| vec![k; 100_000];
        write(&path, &whole(0)).unwrap();
        std::thread::scope(|scope| {
            scope.spawn(|| (1..100).for_each(|k| write(&path, &whole(k)).unwrap()));
            for _ in 0..500 {
                let seen = std::fs::read(&path).unwrap();
                assert_eq!(seen, whole(seen[0]));
            }
        });
        assert_eq!(folder.files(), ["a.exr"]);
    }

    #[test]
    fn a_folder_in_the_way_stays() {
        let folder = Folder::new("folder");
        let path = folder.0.join("a.exr");
        std::fs::create_dir(&path).unwrap();
        assert!(write(&path, b"new").is_err());
        assert!(write(&folder.0.join("missing/a.exr"), b"new").is_err());
        assert_eq!(folder.files(), ["a.exr"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_keeps_pointing() {
        let folder = Folder::new("link");
        std::fs::write(folder.0.join("real.png"), b"old").unwrap();
        std::os::unix::fs::symlink("real.png", folder.0.join("link.png")).unwrap();
        write(&folder.0.join("link.png"), b"new").unwrap();
        assert_eq!(std::fs::read(folder.0.join("real.png")).unwrap(), b"new");
        assert_eq!(folder.files(), ["link.png", "real.png"]);
    }
}
