//! Watches the scene's file: who works on the building saves it again and again, and the light goes on.

use crate::event::{Event, Inbox, Opened};
use std::fmt::Display;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, SystemTime};

/// How often the file is looked at. It is read when it has stayed the same for as long.
const LOOK: Duration = Duration::from_millis(300);

/// Reads the file again whenever it changes, until it is all over.
pub(crate) fn watch<E: Display>(
    file: &Path,
    over: &AtomicBool,
    inbox: &Inbox,
    open: impl Fn() -> Result<Opened, E>,
) {
    let mut known = seen(file);
    let mut last = known;
    while !over.load(Ordering::Relaxed) {
        std::thread::sleep(LOOK);
        let now = seen(file);
        let settled = now == last;
        last = now;
        // While it is written anew there may be none.
        if !settled || now == known || now.is_none() {
            continue;
        }
        known = now;
        inbox.put(match open() {
            Ok(opened) => Event::Changed(Box::new(opened)),
            Err(error) => Event::Broken { why: error.to_string() },
        });
    }
}

fn seen(file: &Path) -> Option<(SystemTime, u64)> {
    let data = std::fs::metadata(file).ok()?;
    Some((data.modified().ok()?, data.len()))
}
