//! Writes edits to the disk, on a thread of its own: a slow disk holds nobody up. Of what waits only the latest is written.

use crate::error::{Error, Result};
use crate::event::{Event, Inbox};
use lampyris::document::{self, Document, Place};
use serde_json::{Value, json};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::JoinHandle;

/// The thread. It goes when everything is written.
pub(crate) struct Saver {
    documents: Option<Sender<(Document, Option<String>)>>,
    thread: Option<JoinHandle<()>>,
}

impl Saver {
    /// Begins, for edits of what was opened. The place is claimed with the first of them.
    pub(crate) fn start(opened: document::Opened, inbox: Inbox) -> Result<Saver> {
        let (documents, waiting) = mpsc::channel();
        let thread = std::thread::Builder::new()
            .name("saver".into())
            .spawn(move || run(&opened, &waiting, &inbox))
            .map_err(|e| Error::System { what: "a thread for saving", reason: e.to_string() })?;
        Ok(Saver { documents: Some(documents), thread: Some(thread) })
    }

    pub(crate) fn save(&self, document: Document, name: Option<String>) {
        if let Some(documents) = &self.documents {
            let _ = documents.send((document, name));
        }
    }
}

impl Drop for Saver {
    fn drop(&mut self) {
        self.documents = None;
        self.thread.take().map(JoinHandle::join);
    }
}

fn run(opened: &document::Opened, waiting: &Receiver<(Document, Option<String>)>, inbox: &Inbox) {
    let mut place = None;
    while let Ok(mut next) = waiting.recv() {
        let mut times = 1;
        while next.1.is_none()
            && let Ok(later) = waiting.try_recv()
        {
            next = later;
            times += 1;
        }
        let saved = write(opened, &mut place, &next)
            .unwrap_or_else(|error| json!({"state": "failed", "file": null, "why": error.to_string()}));
        inbox.put(Event::Saved { saved, times });
    }
}

fn write(
    opened: &document::Opened,
    place: &mut Option<Place>,
    (document, name): &(Document, Option<String>),
) -> lampyris::Result<Value> {
    let own = match place {
        Some(own) => own,
        None => place.insert(Place::claim(opened, document::state_folder().as_deref())?),
    };
    let earlier = own.save(document)?;
    let version = name.as_deref().map(|name| own.save_version(name, document)).transpose()?;
    let notes: Vec<&str> = own.notes().iter().map(String::as_str).collect();
    Ok(json!({
        "state": "saved", "file": own.file().display().to_string(), "why": notes.join("; "),
        "earlier": earlier.map(|file| file.display().to_string()),
        "version": version.map(|file| file.display().to_string()),
    }))
}
