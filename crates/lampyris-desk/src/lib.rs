//! The lighting desk: a session of Lampyris behind a web server of its own, and the page that shows it.
//!
//! Four threads, and the renderer's: the *network* talks to clients (`http`, `client`), the *desk* decides what shall be
//! (`desk`), the *studio* renders it (`studio`), and the *screen* mixes and encodes what is seen (`screen`). None waits for
//! another: the desk's inbox takes everything, the studio's work and the screen's light keep the latest, and a client who
//! does not read is let go. What is said between them and a page is in docs/wire.md.

mod adding;
mod album;
mod client;
mod color;
mod desk;
mod door;
mod edits;
mod error;
mod event;
mod handled;
mod history;
mod http;
mod hub;
mod legend;
mod meters;
mod mixer;
mod model;
mod opening;
mod page;
mod patch;
mod place;
mod printer;
mod reachable;
mod saver;
mod saving;
mod screen;
mod state;
mod studio;
mod surfaces;
mod watch;
mod wire;

pub use error::{Error, Result};
pub use event::Opened;

use album::Album;
use desk::{Desk, Parts};
use door::Door;
use event::{Event, Inbox};
use hub::Hub;
use lampyris::document;
use printer::Printer;
use screen::Screen;
use std::fmt::Display;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use studio::Studio;

/// How a desk is set up.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where to listen; port 0 for a free one. At any other the link is the same each time, kept in the user's folder for
    /// state: a page that is open finds back to a desk that was started again.
    pub address: SocketAddr,
    /// Whether the address may be reached from other machines.
    pub exposed: bool,
    /// The file that the scene comes from.
    pub file: PathBuf,
    /// The program, of which pictures to keep are asked.
    pub program: PathBuf,
    /// Width and height of pictures before a page says what it has room for [pixels].
    pub size: [u32; 2],
    /// Batches after which a picture is finished.
    pub batches: u32,
    /// Threads that render; all cores where `None`.
    pub threads: Option<usize>,
    /// Whether to end when the last page is closed.
    pub ends_with_page: bool,
}

/// What ends a desk from outside.
#[derive(Clone)]
pub struct Ender(Inbox);

impl Ender {
    /// Ends it.
    pub fn end(&self) {
        self.0.put(Event::End);
    }
}

/// Serves a desk until it ends. `ready` is told the link to edit as soon as it can be opened, and how to end; `open` reads the
/// scene, or, when that changes, its file alone.
///
/// # Errors
/// Where the address cannot be listened on, or the system refuses a thread; and what `open` says.
pub fn serve<E: From<Error> + Display + Send>(
    options: Options,
    ready: impl FnOnce(&str, Ender),
    open: impl Fn(Option<&Path>) -> std::result::Result<Opened, E> + Sync,
) -> std::result::Result<(), E> {
    if !options.address.ip().is_loopback() && !options.exposed {
        return Err(Error::Exposed(options.address).into());
    }
    let listener = http::listen(options.address)?;
    let address = listener
        .local_addr()
        .map_err(|e| Error::CannotListen { address: options.address, reason: e.to_string() })?;
    let name = format!("desk-{}.key", address.port());
    let keeps =
        document::state_folder().filter(|_| options.address.port() != 0).map(|state| state.join(name));
    let door = Arc::new(Door::new(address, keeps.as_deref())?);
    let (inbox, events) = Inbox::new();
    let (hub, studio, screen) = (Arc::new(Hub::new()), Arc::new(Studio::new()), Arc::new(Screen::new()));
    let printer = Arc::new(Printer::new(options.program.clone()));
    let album = Arc::new(Album::default());
    let server = http::Server::new(door.clone(), hub.clone(), inbox.clone(), printer.clone(), album.clone());
    let parts = Parts {
        hub: hub.clone(),
        door: door.clone(),
        studio: studio.clone(),
        screen: screen.clone(),
        printer,
        album,
        inbox: inbox.clone(),
        file: options.file.clone(),
        build: server.build.clone(),
        ends_alone: options.ends_with_page,
        enough: options.batches,
    };
    let desk = Desk::new(parts)?;
    server.start(listener)?;
    let link = door.links().first().map(|link| door.address_of(link)).unwrap_or_default();
    ready(&link, Ender(inbox.clone()));
    let over = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(move || desk.run(&events));
        let metered = inbox.clone();
        scope.spawn(|| screen.run(&hub, move |ev| metered.put(Event::Metered { ev })));
        let done = open(None).and_then(|opened| {
            let (file, events) = (opened.document.scene_file.clone(), inbox.clone());
            let (open, over) = (&open, &over);
            scope.spawn(move || watch::watch(&file, over, &events, || open(Some(&file))));
            studio::run(&studio, opened, &options, &screen, &inbox).map_err(E::from)
        });
        over.store(true, Ordering::Relaxed);
        if done.is_err() {
            inbox.put(Event::End);
        }
        done
    })
}
