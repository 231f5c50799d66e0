//! What the studio is asked to do: everybody may put something down, and it takes all of it between batches.

use super::Opened;
use crate::legend::{Legend, Quantity};
use crate::screen::Frame;
use crate::wire::Look;
use lampyris::Rgb;
use lampyris::eye::Meter;
use lampyris::geometry::Ray;
use lampyris::scene::Edit;
use serde_json::Value;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What is to be done, until it is.
#[derive(Default)]
pub(super) struct Work {
    /// From where to look, the number of that camera, and the message that asked.
    pub(super) camera: Option<(Look, u32, u32)>,
    pub(super) size: Option<[u32; 2]>,
    /// Edits in order; of those of one thing that follow each other only the last.
    pub(super) edits: Vec<(Edit, u32)>,
    pub(super) questions: Vec<Asked>,
    /// In which colours the layers are shown, and the message that asked.
    pub(super) mix: Option<(Vec<Rgb>, u32)>,
    /// What pictures are to tell besides light, and the message that asked.
    pub(super) survey: Option<(Survey, u32)>,
    /// Where to measure from now on.
    pub(super) meters: Option<Vec<Meter>>,
    /// What the desk wants to be kept with the edits, and the name of the version, if it is to have one.
    pub(super) save: Option<(Value, Option<String>)>,
    /// The scene's file was read again; what the desk wants to be kept.
    pub(super) reload: Option<(Box<Opened>, Value)>,
    pub(super) ended: bool,
}

/// What pictures tell besides light, for false colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Survey {
    /// What surfaces reflect.
    pub(crate) surfaces: bool,
    /// What each layer has, in sketches too: they are mixed in other colours than they are shown in.
    pub(crate) layers: bool,
    /// What clamping takes from virtual lights, and short rays pay back.
    pub(crate) clamped: bool,
}

impl Survey {
    /// What a legend takes.
    pub(crate) fn of(legend: Option<&Legend>) -> Survey {
        let is = |quantity| legend.is_some_and(|legend| legend.quantity == quantity);
        let (differs, clamped) = (is(Quantity::Difference), is(Quantity::Clamped));
        Survey { surfaces: differs || is(Quantity::Illuminance), layers: differs, clamped }
    }
}

/// A question, and who asked it.
pub(crate) struct Asked {
    pub(crate) client: u64,
    pub(crate) id: u32,
    pub(crate) what: What,
}

/// What is asked.
pub(crate) enum What {
    /// What lies behind a pixel of a frame that was shown, and the colours of the layers now and in a look, where these are
    /// compared.
    Pixel(Frame, [f32; 2], Option<[Vec<Rgb>; 2]>),
    /// What a ray meets first.
    Ray(Ray),
    /// What lights a point.
    Light(Meter),
}

/// The way to the thread.
pub(crate) struct Studio {
    work: Mutex<Work>,
    wake: Condvar,
    /// Whether anybody looks on.
    pub(super) watched: AtomicBool,
    /// What is to be done makes the batch at hand pointless, or shall not wait for it.
    pub(super) urgent: AtomicBool,
}

impl Studio {
    pub(crate) fn new() -> Studio {
        Studio {
            work: Mutex::default(),
            wake: Condvar::new(),
            watched: AtomicBool::new(false),
            urgent: AtomicBool::new(false),
        }
    }

    /// Whether anybody looks on: if nobody does, no more is drawn than the first who comes is glad to see.
    pub(crate) fn watched(&self, watched: bool) {
        self.watched.store(watched, Ordering::Relaxed);
        self.wake.notify_one();
    }

    /// Looks from elsewhere.
    pub(crate) fn look(&self, look: Look, number: u32, seq: u32) {
        self.put(true, |work| work.camera = Some((look, number, seq)));
    }

    /// Draws in another size.
    pub(crate) fn resize(&self, size: [u32; 2]) {
        self.put(true, |work| work.size = Some(size));
    }

    /// Edits the scene.
    pub(crate) fn edit(&self, edits: Vec<Edit>, seq: u32) {
        let urgent = edits.iter().any(|edit| !matches!(edit, Edit::Mix { .. }));
        self.put(urgent, |work| {
            for edit in edits {
                match work.edits.last_mut().filter(|(last, _)| replaces(&edit, last)) {
                    Some(last) => *last = (edit, seq),
                    None => work.edits.push((edit, seq)),
                }
            }
        });
    }

    /// The layers are shown in other colours, which may be others than the scene's.
    pub(crate) fn mix(&self, colors: Vec<Rgb>, seq: u32) {
        self.put(false, |work| work.mix = Some((colors, seq)));
    }

    /// What pictures are to tell from now on besides light.
    pub(crate) fn survey(&self, survey: Survey, seq: u32) {
        self.put(true, |work| work.survey = Some((survey, seq)));
    }

    /// Asks.
    pub(crate) fn ask(&self, asked: Asked) {
        self.put(true, |work| work.questions.push(asked));
    }

    pub(crate) fn end(&self) {
        self.put(true, |work| work.ended = true);
    }

    /// Measures at some points, in the place of those before.
    pub(crate) fn measure(&self, meters: Vec<Meter>) {
        self.put(false, |work| work.meters = Some(meters));
    }

    /// Goes on with a scene that was read again, and the edits of this one.
    pub(crate) fn reload(&self, opened: Box<Opened>, desk: Value) {
        self.put(true, |work| work.reload = Some((opened, desk)));
    }

    /// Writes the edits down, with what the desk wants to be kept; as a version of a name, if it has one.
    pub(crate) fn save(&self, desk: Value, name: Option<String>) {
        self.put(false, |work| {
            // A version that was asked for and not made yet is one of what is now.
            let asked = work.save.take().and_then(|(_, name)| name);
            work.save = Some((desk, name.or(asked)));
        });
    }

    fn put(&self, urgent: bool, put: impl FnOnce(&mut Work)) {
        let mut work = self.work();
        put(&mut work);
        if urgent {
            self.urgent.store(true, Ordering::Relaxed);
        }
        self.wake.notify_one();
    }

    fn work(&self) -> MutexGuard<'_, Work> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What there is to do; waits for it until a time, for ever where there is none.
    pub(super) fn take(&self, until: Option<Instant>) -> Work {
        let mut work = self.work();
        let idle = |work: &Work| {
            !work.ended
                && work.camera.is_none()
                && work.size.is_none()
                && work.edits.is_empty()
                && work.mix.is_none()
                && work.questions.is_empty()
                && work.save.is_none()
                && work.meters.is_none()
                && work.survey.is_none()
                && work.reload.is_none()
        };
        while idle(&work) {
            work = match until.map(|until| until.saturating_duration_since(Instant::now())) {
                Some(Duration::ZERO) => break,
                Some(left) => self.wake.wait_timeout(work, left).unwrap_or_else(PoisonError::into_inner).0,
                None => self.wake.wait(work).unwrap_or_else(PoisonError::into_inner),
            };
        }
        self.urgent.store(false, Ordering::Relaxed);
        std::mem::take(&mut work)
    }
}

/// Whether an edit makes the one before it pointless.
fn replaces(edit: &Edit, last: &Edit) -> bool {
    match (edit, last) {
        (Edit::Light { light: a, .. }, Edit::Light { light: b, .. }) => a == b,
        (Edit::Move { instance: a, .. }, Edit::Move { instance: b, .. }) => a == b,
        (Edit::Material { material: a, .. }, Edit::Material { material: b, .. }) => a == b,
        (Edit::Mix { group: a, .. }, Edit::Mix { group: b, .. }) => a == b,
        _ => false,
    }
}
