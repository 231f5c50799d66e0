//! What the targets share: bytes become files, files become scenes, small scenes become pictures of 8 × 8 pixels.
//! Any bytes may be refused; none may panic, take long, fill the memory or give a scene or a picture that is unsound.
//! `fuzz/run` builds and runs the targets.

mod sound;

use lampyris::backend::{Backend, Batch, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::Eye;
use lampyris::import::{self, Limits, Options};
use lampyris::scene::{Scene, View, find_view};
use lampyris::world::World;
use peak_alloc::PeakAlloc;
use std::cell::RefCell;
use std::path::PathBuf;
use std::sync::LazyLock;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Triangles up to which a scene is rendered.
const SMALL: usize = 2000;

/// Bytes that loading may hold, and for each of the input's.
const MEMORY_LIMIT: (usize, usize) = (64 << 20, 64);

/// Divides an input into a scene's file and another one that it may name.
const MARKER: &[u8] = b"\n%%%\n";

/// A folder of this process. Whoever sets the place of temporary files also empties it.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("lampyris-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    folder
});

thread_local! {
    /// One thread, kept: more of them would only make runs differ.
    static CPU: RefCell<Cpu> = RefCell::new(Cpu::new(Some(1)).expect("a thread"));
}

/// What may be asked for while fuzzing: enough to reach all code, and what is refused is refused early.
fn options() -> Options {
    let limits = Limits {
        triangles: 20_000,
        entities: 20_000,
        array: 5_000,
        ..Limits::default()
    };
    Options { limits, circle_steps: 8, ..Options::default() }
}

/// Loads an input as the file `name`; what follows a line `%%%` is the file `other` beside it.
pub fn scene(name: &str, other: &str, input: &[u8]) {
    let at = input.windows(MARKER.len()).position(|w| w == MARKER);
    let (main, rest) = at.map_or((input, &input[..0]), |at| (&input[..at + 1], &input[at + MARKER.len()..]));
    let path = FOLDER.join(name);
    std::fs::write(&path, main).expect("room for a file");
    std::fs::write(FOLDER.join(other), rest).expect("room for a file");
    let loaded = CPU.with_borrow(|cpu| frugal(input, || cpu.install(|| import::load(&path, &options()))));
    match loaded {
        Ok(loaded) => {
            sound::check(&loaded.scene);
            render(loaded.scene, input.len());
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

/// Renders a small scene, by the parts or by the oracle.
fn render(scene: Scene, choice: usize) {
    let triangles = |mesh: u32| scene.meshes[mesh as usize].triangles.len();
    if scene.instances.iter().map(|i| triangles(i.mesh)).sum::<usize>() > SMALL {
        return;
    }
    let mut settings = Settings { paths: 4, auxiliary: true, ..Settings::default() };
    if choice % 2 == 1 {
        settings.parts = vec!["path".into()];
    }
    CPU.with_borrow_mut(|cpu| {
        let camera = scene.cameras.first().cloned();
        let world = cpu.install(|| World::new(scene));
        let find = || find_view(world.scene(), &|ray| world.tracer().closest(ray), 1.0).camera;
        let camera = camera.unwrap_or_else(|| cpu.install(find));
        cpu.begin_world(world, Eye::Camera(View::new(&camera, 8, 8)), &settings).expect("settings");
        cpu.add(Batch { index: 0 }).expect("a job");
        assert_eq!(cpu.statistics().non_finite, 0);
        assert!(cpu.frame().expect("a job").mean().iter().all(|pixel| pixel.is_finite()));
    });
}
