//! Folders of MGF files made for one test, and loading from them.
#![allow(dead_code, reason = "each test binary uses its own part")]

use lampyris::import::{Loaded, Options, load};
use lampyris::{Error, Result};
use std::path::{Path, PathBuf};

#[path = "../folder/mod.rs"]
pub(crate) mod folder;

pub(crate) use folder::Folder;

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
