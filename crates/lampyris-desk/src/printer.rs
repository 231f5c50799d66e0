//! Pictures to keep: the program renders the saved document by itself, beside the desk, so that what is kept is what anybody
//! else renders of it, to the bit. One at a time.

use crate::event::{Event, Inbox};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How often it is looked whether a picture is done.
const LOOK: Duration = Duration::from_millis(50);

/// Pixels and batches of a picture.
const PIXELS: u64 = 1 << 26;
const BATCHES: u32 = 100_000;

/// A picture that is asked for.
#[derive(Clone, Debug)]
pub(crate) struct Order {
    pub(crate) client: u64,
    pub(crate) id: u32,
    pub(crate) format: String,
    pub(crate) size: [u32; 2],
    pub(crate) batches: u32,
}

impl Order {
    /// Why it cannot be done, if it cannot.
    pub(crate) fn check(&self) -> Result<(), String> {
        let pixels = u64::from(self.size[0]) * u64::from(self.size[1]);
        if !["png", "exr"].contains(&self.format.as_str()) {
            return Err("pictures are kept as png or exr".into());
        }
        if pixels == 0 || pixels > PIXELS || !(1..=BATCHES).contains(&self.batches) {
            return Err(format!("need 1 to {PIXELS} pixels and 1 to {BATCHES} batches"));
        }
        Ok(())
    }
}

/// The folder of finished pictures, and what is being made.
pub(crate) struct Printer {
    program: PathBuf,
    folder: PathBuf,
    work: Mutex<Work>,
}

#[derive(Default)]
struct Work {
    child: Option<Child>,
    made: u32,
}

impl Printer {
    /// Pictures come into a folder of their own, which goes with the desk.
    pub(crate) fn new(program: PathBuf) -> Printer {
        let folder = std::env::temp_dir().join(format!("lampyris-pictures-{}", std::process::id()));
        Printer { program, folder, work: Mutex::default() }
    }

    /// Makes a picture by the arguments of `lampyris render`, but for the file, and tells when it is there; or says why not.
    pub(crate) fn start(
        self: &Arc<Self>,
        order: Order,
        args: &[String],
        inbox: &Inbox,
    ) -> Result<(), String> {
        let mut work = self.work();
        if work.child.is_some() {
            return Err("another picture is being made".into());
        }
        let cannot = |e: std::io::Error| format!("no picture can be made: {e}");
        std::fs::create_dir_all(&self.folder).map_err(cannot)?;
        work.made += 1;
        let name = format!("picture-{}.{}", work.made, order.format);
        let mut command = Command::new(&self.program);
        command.args(args).arg("-o").arg(self.folder.join(&name)).arg("--quiet");
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        work.child = Some(command.spawn().map_err(cannot)?);
        let (printer, inbox) = (self.clone(), inbox.clone());
        std::thread::spawn(move || {
            if let Some(done) = printer.wait() {
                let done = done.map(|()| name);
                inbox.put(Event::Made { client: order.client, id: order.id, done });
            }
        });
        Ok(())
    }

    /// Waits for the picture that is being made; `None` where it was stopped.
    fn wait(&self) -> Option<Result<(), String>> {
        loop {
            std::thread::sleep(LOOK);
            let mut work = self.work();
            let done = match work.child.as_mut()?.try_wait() {
                Ok(None) => continue,
                Ok(Some(status)) if status.success() => Ok(()),
                Ok(Some(status)) => Err(format!("no picture was made: {status}")),
                Err(error) => Err(format!("no picture was made: {error}")),
            };
            work.child = None;
            return Some(done);
        }
    }

    /// The bytes of a picture that was made.
    pub(crate) fn picture(&self, name: &str) -> Option<Vec<u8>> {
        let number = name.strip_prefix("picture-").and_then(|rest| rest.split_once('.'));
        let known = number.is_some_and(|(number, format)| {
            number.parse::<u32>().is_ok() && ["png", "exr"].contains(&format)
        });
        known.then(|| std::fs::read(Path::new(&self.folder).join(name)).ok()).flatten()
    }

    /// Stops what is being made, and removes what was.
    pub(crate) fn end(&self) {
        let mut work = self.work();
        if let Some(mut child) = work.child.take() {
            let _ = child.kill();
            let _ = child.wait();
        }
        let _ = std::fs::remove_dir_all(&self.folder);
    }

    fn work(&self) -> MutexGuard<'_, Work> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
