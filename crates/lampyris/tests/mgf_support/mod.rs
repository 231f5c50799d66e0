//! Folders of MGF files made for one test, and loading from them.
#![allow(dead_code, reason = "each test binary uses its own part")]

use lampyris::import::{Loaded, Options, load};
use lampyris::{Error, Result};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder that vanishes with its test.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new() -> Folder {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let name = format!("lampyris-mgf-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        path
    }

    pub(crate) fn load(&self, name: &str) -> Result<Loaded> {
        load(&self.0.join(name), &Options::default())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Loads a text as the scene `main.mgf`.
pub(crate) fn load_with(text: impl AsRef<[u8]>, options: &Options) -> Result<Loaded> {
    let folder = Folder::new();
    load(&folder.write("main.mgf", text), options)
}

pub(crate) fn load_text(text: impl AsRef<[u8]>) -> Result<Loaded> {
    load_with(text, &Options::default())
}

/// The loaded scene; it must give no warning.
pub(crate) fn clean(text: &str) -> lampyris::scene::Scene {
    let loaded = load_text(text).unwrap();
    assert_eq!(loaded.warnings, Vec::<String>::new());
    loaded.scene
}

/// The line and the reason of what must be broken input.
pub(crate) fn bad(text: &str) -> (String, String) {
    match load_text(text) {
        Err(Error::BadInput { place, reason, .. }) => (place, reason),
        other => panic!("{text:?}: {other:?}"),
    }
}

/// The folder of published scenes.
pub(crate) fn scenes() -> PathBuf {
    Path::new(&std::env::var_os("LAMPYRIS_SCENES").expect("LAMPYRIS_SCENES names the folder of scenes"))
        .join("mgf")
}
