//! What the targets share: bytes become scenes and pictures, and small scenes are rendered.
//! Any bytes may be refused; none may panic, take long, fill the memory or give a scene or a picture that is unsound.
//! `fuzz/run` builds and runs the targets.

mod edited;
mod render;
mod sound;

use lampyris::document::Document;
use lampyris::import::image::Gate;
use lampyris::import::{self, Limits, Options};
use peak_alloc::PeakAlloc;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::{LazyLock, Mutex, PoisonError};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Bytes that reading may hold, and for each of the input's.
const MEMORY_LIMIT: (usize, usize) = (64 << 20, 64);

/// Divides an input into a scene's file and another one that it may name.
const MARKER: &[u8] = b"\n%%%\n";

/// A folder of this process. Whoever sets the place of temporary files also empties it.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("lampyris-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    folder
});

/// Lets panics unwind, since those of foreign decoders are caught on their way; tells of each place once. Those that are
/// not caught end the target.
static PANICS: LazyLock<()> = LazyLock::new(|| {
    let seen = Mutex::new(BTreeSet::new());
    std::panic::set_hook(Box::new(move |panic| {
        let place = panic.location().map(ToString::to_string).unwrap_or_default();
        if seen.lock().unwrap_or_else(PoisonError::into_inner).insert(place) {
            eprintln!("{panic}");
        }
    }));
});

/// What may be asked for while fuzzing: enough to reach all code, and what is refused is refused early.
fn options() -> Options {
    let limits = Limits {
        triangles: 20_000,
        entities: 20_000,
        array: 5_000,
        nodes: 5_000,
        instances: 5_000,
        image_pixels: 1 << 18,
        image_bytes: 16 << 20,
        ..Limits::default()
    };
    Options { limits, circle_steps: 8, ..Options::default() }
}

/// Loads an input as the file `name`; what follows a line `%%%` is the file `other` beside it.
pub fn scene(name: &str, other: &str, input: &[u8]) {
    LazyLock::force(&PANICS);
    let at = input.windows(MARKER.len()).position(|w| w == MARKER);
    let (main, rest) = at.map_or((input, &input[..0]), |at| (&input[..at + 1], &input[at + MARKER.len()..]));
    let path = FOLDER.join(name);
    std::fs::write(&path, main).expect("room for a file");
    std::fs::write(FOLDER.join(other), rest).expect("room for a file");
    match frugal(input, || render::install(|| import::load(&path, &options()))) {
        Ok(loaded) => {
            sound::check(&loaded.scene);
            frugal(input, || render::render(loaded.scene, input.len()));
        }
        Err(error) => assert!(error.to_string().len() < 4000, "a message to read: {error}"),
    }
}

/// Reads an input as a picture of any format, and renders in the light of a small one.
pub fn picture(input: &[u8]) {
    LazyLock::force(&PANICS);
    let read =
        || Gate::new(options().limits).admit(input).ok().and_then(|admitted| admitted.decode("picture").ok());
    if let Some(image) = frugal(input, || render::install(read)) {
        sound::check_image(&image);
        frugal(input, || render::render_in_light_of(image, input.len()));
    }
}

/// Reads an input as saved edits of a small scene.
pub fn document(input: &[u8]) {
    LazyLock::force(&PANICS);
    let file = std::path::Path::new("scene.mgf.lampyris.json");
    match frugal(input, || Document::read(file, input, &options().limits)) {
        Ok(document) => {
            assert_eq!(
                Document::read(file, document.text().as_bytes(), &Limits::default()).ok(),
                Some(document.clone())
            );
            let before = edited::scene();
            let (after, lost) = frugal(input, || document.apply(before.clone()));
            assert!(lost.iter().all(|line| line.len() < 1000 && !line.contains('\n')), "a line to read");
            sound::check(&after);
            // What was applied is what differs.
            let again = Document::of(&before, &after).apply(before).0;
            assert_eq!(format!("{again:?}"), format!("{after:?}"));
            frugal(input, || render::render(after, input.len()));
        }
        Err(error) => assert!(error.to_string().len() < 4000, "a message to read: {error}"),
    }
}

/// Does something within the memory that `input` justifies.
fn frugal<R>(input: &[u8], work: impl FnOnce() -> R) -> R {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = work();
    let (peak, (fixed, each)) = (MEMORY.peak_usage().saturating_sub(before), MEMORY_LIMIT);
    assert!(peak <= fixed + each * input.len(), "{peak} bytes of memory for {}", input.len());
    result
}
