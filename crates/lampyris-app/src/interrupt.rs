//! Ctrl-C: once to finish the picture as it is, twice to leave at once.

use crate::failure::INTERRUPTED;
use std::sync::atomic::{AtomicBool, Ordering};

/// There is a picture worth finishing.
static RENDERING: AtomicBool = AtomicBool::new(false);
static ASKED: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C ends the program with its own exit code.
pub(crate) fn watch() {
    // Without a handler Ctrl-C still ends the program, only without a picture.
    let _ = ctrlc::set_handler(|| {
        if ASKED.swap(true, Ordering::SeqCst) || !RENDERING.load(Ordering::SeqCst) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
}

/// From now on the first Ctrl-C is only noted.
pub(crate) fn rendering() {
    RENDERING.store(true, Ordering::SeqCst);
}

/// Whether the user wants an end.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
