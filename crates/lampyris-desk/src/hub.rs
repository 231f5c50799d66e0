//! All who are connected: what is said to them, and the picture that they are to see. A client who does not keep up is let
//! go, so nothing piles up here.

use crate::door::{Pass, Role};
use hyper::body::Bytes;
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::{mpsc, watch};
use tokio_tungstenite::tungstenite::Utf8Bytes;

/// Texts that wait for one client at most; who has more waiting does not read.
const WAITING: usize = 512;

/// Most clients at once.
pub(crate) const CLIENTS: usize = 256;

/// A picture on its way to all.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// Head and picture, of which all clients share one copy.
    pub(crate) bytes: Bytes,
    pub(crate) camera: Arc<CameraText>,
}

/// The message that tells a camera.
#[derive(Clone, Debug, Default)]
pub(crate) struct CameraText {
    pub(crate) number: u32,
    pub(crate) text: Utf8Bytes,
}

/// What one client is told.
pub(crate) type Mail = mpsc::Receiver<Utf8Bytes>;

#[derive(Clone)]
struct Client {
    pass: Pass,
    texts: mpsc::Sender<Utf8Bytes>,
}

/// The clients.
pub(crate) struct Hub {
    clients: Mutex<BTreeMap<u64, Client>>,
    frames: watch::Sender<Option<Arc<Shown>>>,
}

impl Hub {
    pub(crate) fn new() -> Hub {
        Hub { clients: Mutex::default(), frames: watch::Sender::new(None) }
    }

    /// Takes a client in; `None` where there are too many.
    pub(crate) fn join(&self, id: u64, pass: Pass) -> Option<(Mail, watch::Receiver<Option<Arc<Shown>>>)> {
        let mut clients = self.clients();
        if clients.len() >= CLIENTS {
            return None;
        }
        let (texts, mail) = mpsc::channel(WAITING);
        clients.insert(id, Client { pass, texts });
        let mut frames = self.frames.subscribe();
        frames.mark_changed();
        Some((mail, frames))
    }

    pub(crate) fn leave(&self, id: u64) {
        self.clients().remove(&id);
    }

    /// Who is here.
    pub(crate) fn present(&self) -> Vec<(u64, Role)> {
        self.clients().iter().map(|(id, client)| (*id, client.pass.role)).collect()
    }

    /// To one.
    pub(crate) fn tell(&self, id: u64, message: &Value) {
        let mut clients = self.clients();
        let text = Utf8Bytes::from(message.to_string());
        if clients.get(&id).is_some_and(|client| client.texts.try_send(text).is_err()) {
            clients.remove(&id);
        }
    }

    /// To all.
    pub(crate) fn tell_all(&self, message: &Value) {
        let text = Utf8Bytes::from(message.to_string());
        self.clients().retain(|_, client| client.texts.try_send(text.clone()).is_ok());
    }

    /// Everybody who came by a link that is none any more goes.
    pub(crate) fn dismiss(&self, stays: impl Fn(Pass) -> bool) {
        self.clients().retain(|_, client| stays(client.pass));
    }

    /// The next picture.
    pub(crate) fn show(&self, shown: Shown) {
        self.frames.send_replace(Some(Arc::new(shown)));
    }

    fn clients(&self) -> MutexGuard<'_, BTreeMap<u64, Client>> {
        self.clients.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
