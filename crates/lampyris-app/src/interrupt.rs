//! Ctrl-C: once to finish the picture as it is, twice to leave at once, but never in the middle of writing a file.

use crate::failure::INTERRUPTED;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// There is a picture worth finishing.
static RENDERING: AtomicBool = AtomicBool::new(false);
static ASKED: AtomicBool = AtomicBool::new(false);
/// Held while a temporary file exists, which nobody else would remove.
static WRITING: Mutex<()> = Mutex::new(());

/// From now on Ctrl-C ends the program with its own exit code.
pub(crate) fn watch() {
    // Without a handler Ctrl-C still ends the program, only without a picture.
    let _ = ctrlc::set_handler(|| {
        if ASKED.swap(true, Ordering::SeqCst) || !RENDERING.load(Ordering::SeqCst) {
            let _written = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
    // A file over the process' limit shall be an error like a full disk, not the end of the program.
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Default::default());
}

/// Writes a file; a second Ctrl-C waits for its end.
pub(crate) fn writing<R>(write: impl FnOnce() -> R) -> R {
    let _writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    write()
}

/// From now on the first Ctrl-C is only noted.
pub(crate) fn rendering() {
    RENDERING.store(true, Ordering::SeqCst);
}

/// Whether the user wants an end.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
