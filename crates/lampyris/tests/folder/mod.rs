//! Folders of files made for one test, loading from them, and the harm that can be done to a file bit by bit.
#![allow(dead_code, reason = "each test binary uses its own part")]

use lampyris::Result;
use lampyris::import::{Loaded, Options, load};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// A folder that vanishes with its test.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new() -> Folder {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let name = format!("lampyris-files-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
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

/// Loads every prefix of `seed` and every flip of a bit in its first kilobyte, none in more than 10 s; shows what was
/// loaded to `check`, and returns how many that were, of how many.
pub(crate) fn mutate(
    folder: &Folder,
    extension: &str,
    seed: &[u8],
    options: &Options,
    mut check: impl FnMut(&Loaded),
) -> (usize, usize) {
    let end = seed.len().min(1024);
    let prefixes = (0..=end).map(|n| seed[..n].to_vec());
    let flips = (0..8 * end).map(|bit| {
        let mut bytes = seed.to_vec();
        bytes[bit / 8] ^= 1 << (bit % 8);
        bytes
    });
    let (mut good, mut all) = (0, 0);
    for bytes in prefixes.chain(flips) {
        let start = Instant::now();
        // A name of its own each: overwriting a file makes some file systems wait for the disk.
        let path = folder.write(&format!("{all}.{extension}"), &bytes);
        let loaded = load(&path, options);
        assert!(start.elapsed() < Duration::from_secs(10));
        std::fs::remove_file(path).unwrap();
        all += 1;
        if let Ok(loaded) = loaded {
            good += 1;
            check(&loaded);
        }
    }
    (good, all)
}
