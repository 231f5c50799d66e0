//! The desk itself: who edits, what was done, what all are told. It holds what shall be and never waits for light: rays are
//! the studio's, pictures the screen's.

mod answering;
mod comparing;
mod editing;
mod grouping;
#[cfg(test)]
mod hostile;
mod looks;
mod reaching;
mod showing;
mod telling;

use crate::adding::NewLamp;
use crate::album::Album;
use crate::door::{Door, Role};
use crate::event::{Event, Inbox, Progress};
use crate::history::{Gesture, History};
use crate::hub::Hub;
use crate::meters::Layout;
use crate::model::Model;
use crate::patch::{LampPatch, Patch};
use crate::printer::{Order, Printer};
use crate::saving;
use crate::screen::{Screen, Show};
use crate::state;
use crate::studio::{Studio, Survey};
use crate::wire::{Do, Look, Message, PROTOCOL};
use lampyris::Rgb;
use lampyris::measuring::Estimate;
use lampyris::scene::Scene;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

/// How long edits wait to be saved, and to be saved again where that failed.
const SOON: Duration = Duration::from_millis(400);
const AGAIN: Duration = Duration::from_secs(3);

/// The desk.
pub(crate) struct Desk {
    hub: Arc<Hub>,
    door: Arc<Door>,
    studio: Arc<Studio>,
    screen: Arc<Screen>,
    printer: Arc<Printer>,
    album: Arc<Album>,
    inbox: Inbox,
    /// Pictures that wait until all is saved.
    orders: Vec<Order>,
    file: PathBuf,
    build: Arc<str>,
    model: Model,
    /// The scene without its geometry.
    scene: Option<Scene>,
    warnings: Vec<String>,
    look: Option<Look>,
    layout: Layout,
    /// What is said of meters and grids.
    told: Value,
    /// What each point that is measured reads [lx], and of each layer in white, what it sends out if it is matt and white
    /// [cd/m²].
    readings: Vec<Estimate>,
    by_layer: Vec<Vec<Rgb>>,
    /// Whether they have all the batches that meters get.
    measured: bool,
    saved: Value,
    /// By when there is something to save.
    unsaved: Option<Instant>,
    cameras: u32,
    history: History,
    gesture: Option<Gesture>,
    solo: BTreeSet<u32>,
    show: Show,
    metered: bool,
    white: Value,
    progress: Option<Progress>,
    clients: BTreeMap<u64, Role>,
    editor: Option<u64>,
    /// The last message of the editor that was applied.
    seq: u32,
    /// The program ends when nobody looks any more.
    ends_alone: bool,
    /// Batches after which a picture is finished.
    enough: u32,
    /// Documents on their way to the disk.
    saving: u32,
    /// Some looks may have no thumbnail.
    unseen: bool,
    /// Whether the layers can show the look that is compared with as it is.
    exact: bool,
}

/// What decides a desk when it begins.
pub(crate) struct Parts {
    pub(crate) hub: Arc<Hub>,
    pub(crate) door: Arc<Door>,
    pub(crate) studio: Arc<Studio>,
    pub(crate) screen: Arc<Screen>,
    pub(crate) printer: Arc<Printer>,
    pub(crate) album: Arc<Album>,
    pub(crate) inbox: Inbox,
    pub(crate) file: PathBuf,
    pub(crate) build: Arc<str>,
    pub(crate) ends_alone: bool,
    pub(crate) enough: u32,
}

impl Desk {
    pub(crate) fn new(parts: Parts) -> crate::error::Result<Desk> {
        let Parts { hub, door, studio, screen, printer, album, inbox, file, build, ends_alone, enough } =
            parts;
        Ok(Desk {
            hub,
            door,
            studio,
            screen,
            printer,
            album,
            inbox,
            orders: Vec::new(),
            file,
            build,
            model: Model::default(),
            scene: None,
            warnings: Vec::new(),
            look: None,
            layout: Layout::default(),
            told: Value::Null,
            readings: Vec::new(),
            by_layer: Vec::new(),
            measured: false,
            saved: json!({"state": "clean", "file": null, "why": null}),
            unsaved: None,
            cameras: 0,
            history: History::new()?,
            gesture: None,
            solo: BTreeSet::new(),
            show: Show::default(),
            metered: false,
            white: Value::Null,
            progress: None,
            clients: BTreeMap::new(),
            editor: None,
            seq: 0,
            ends_alone,
            enough,
            saving: 0,
            unseen: false,
            exact: true,
        })
    }

    /// Does what comes, until the end.
    pub(crate) fn run(mut self, events: &Receiver<Event>) {
        while let Some(event) = self.next(events) {
            match event {
                Event::Opened { model, scene, look, warnings } => {
                    // Undo goes by numbers, which mean the same only if nothing came or went.
                    if self.scene.is_some() && !model.is_like(&self.model) {
                        self.history.clear();
                    }
                    (self.model, self.scene, self.warnings) = (*model, Some(*scene), warnings);
                    self.solo.retain(|id| (*id as usize) < self.model.lamps.len());
                    self.look = Some(look);
                    self.album.clear();
                    self.unseen = true;
                    self.end_comparison_with_nothing();
                    self.mix(self.seq, 0.0);
                    self.studio.survey(Survey::of(self.show.legend.as_deref()), self.seq);
                    self.lay_out();
                    self.hub.present().into_iter().for_each(|(client, _)| self.tell_state(client));
                }
                Event::Joined { client, role } => self.join(client, role),
                Event::Left { client } => {
                    self.leave(client);
                    if self.ends_alone && self.clients.is_empty() {
                        break;
                    }
                }
                Event::Said { client, message } => self.hear(client, message),
                Event::Progress(progress) => {
                    self.progress = Some(progress);
                    self.hub.tell_all(&self.status());
                    let layers = state::layers(self.scene.as_ref(), self.progress.as_ref());
                    self.tell_patch(json!({"layers": layers}));
                }
                Event::Found { client, id, found } => {
                    let answer = state::found(&self.model, id, found);
                    self.hub.tell(client, &answer);
                }
                Event::Metered { ev } => {
                    (self.show.ev, self.metered) = (Some(ev), true);
                    self.tell_patch(json!({"display": self.display()}));
                }
                Event::Saved { saved, times } => {
                    self.saving = self.saving.saturating_sub(times);
                    let before = std::mem::replace(&mut self.saved, saved);
                    if self.saved["state"] == "failed" {
                        // Until there is room again, or another folder.
                        self.save_in(AGAIN);
                    } else if self.unsaved.is_some() || self.saving > 0 {
                        self.saved["state"] = "waiting".into();
                    }
                    if self.saved != before {
                        self.tell_patch(json!({"saved": self.saved}));
                    }
                    self.print();
                }
                Event::Lit { client, id, answer, done } => {
                    self.hub.tell(client, &state::lit(&self.model, id, &answer, done));
                }
                Event::Measured { readings, by_layer, done } => {
                    (self.readings, self.by_layer, self.measured) = (readings, by_layer, done);
                    self.read_meters();
                    self.tell_readings();
                }
                Event::Changed(opened) => {
                    self.end_gesture();
                    self.studio.reload(opened, saving::kept(&self.model));
                }
                Event::Broken { why } => {
                    self.hub.tell_all(&json!({"is": "event", "what": "broken", "why": why}))
                }
                Event::Reloaded { lost } => {
                    let event = json!({"is": "event", "what": "reloaded", "kept": self.history.steps(), "lost": lost});
                    self.hub.tell_all(&event);
                }
                Event::Made { client, id, done } => {
                    let answer = match done {
                        Ok(name) => {
                            json!({"is": "answer", "id": id, "name": name, "url": format!("/made/{name}")})
                        }
                        Err(why) => json!({"is": "answer", "id": id, "why": why}),
                    };
                    self.hub.tell(client, &answer);
                    self.print();
                }
                Event::Idle => self.save(None),
                Event::Refused { why } => {
                    if let Some(editor) = self.editor {
                        self.hub.tell(editor, &json!({"is": "refused", "seq": self.seq, "why": why}));
                    }
                }
                Event::End => break,
            }
            if self.unseen {
                self.photograph();
            }
        }
        self.end_gesture();
        self.save(None);
        self.hub.tell_all(&json!({"is": "event", "what": "bye"}));
        self.printer.end();
        self.studio.end();
        self.screen.end();
    }

    /// What happens next; nothing for a while, where edits wait to be saved.
    fn next(&self, events: &Receiver<Event>) -> Option<Event> {
        let Some(due) = self.unsaved else { return events.recv().ok() };
        let left = due.saturating_duration_since(Instant::now());
        // However much happens, saving has its turn.
        if left.is_zero() {
            return Some(Event::Idle);
        }
        match events.recv_timeout(left) {
            Ok(event) => Some(event),
            Err(RecvTimeoutError::Timeout) => Some(Event::Idle),
            Err(RecvTimeoutError::Disconnected) => None,
        }
    }

    /// Edits are to be written down before so long; until they are, nobody is told that they are saved.
    fn save_in(&mut self, wait: Duration) {
        let due = Instant::now() + wait;
        self.unsaved = Some(self.unsaved.map_or(due, |own| own.min(due)));
        if matches!(self.saved["state"].as_str(), Some("clean" | "saved")) {
            self.saved["state"] = "waiting".into();
            self.tell_patch(json!({"saved": self.saved}));
        }
    }

    /// Has the edits written down, if there are some, or as a version of a name.
    fn save(&mut self, name: Option<String>) {
        if self.unsaved.take().is_some() || name.is_some() {
            self.saving += 1;
            self.studio.save(saving::kept(&self.model), name);
        }
    }

    fn join(&mut self, client: u64, role: Role) {
        self.clients.insert(client, role);
        self.studio.watched(true);
        if role == Role::Edit && self.editor.is_none() {
            self.pass_pen(Some(client));
        }
        let role = if role == Role::Edit { "edit" } else { "watch" };
        let hello =
            json!({"is": "hello", "protocol": PROTOCOL, "build": *self.build, "you": client, "role": role});
        self.hub.tell(client, &hello);
        if self.scene.is_some() {
            self.tell_state(client);
        }
    }

    fn leave(&mut self, client: u64) {
        self.clients.remove(&client);
        self.studio.watched(!self.clients.is_empty());
        if self.editor == Some(client) {
            self.end_gesture();
            let next = self.clients.iter().find(|(_, role)| **role == Role::Edit).map(|(id, _)| *id);
            self.pass_pen(next);
        }
    }

    /// Somebody else edits from now on.
    fn pass_pen(&mut self, to: Option<u64>) {
        let from = std::mem::replace(&mut self.editor, to);
        self.seq = 0;
        for client in [from, to].into_iter().flatten() {
            self.hub.tell(
                client,
                &json!({"is": "patch", "seq": 0, "patch": {"editor": self.editor_for(client)}}),
            );
        }
        if let Some(from) = from.filter(|from| Some(*from) != to && to.is_some()) {
            self.hub.tell(from, &json!({"is": "event", "what": "taken"}));
        }
    }

    fn hear(&mut self, client: u64, Message { seq, what }: Message) {
        let role = self.clients.get(&client).copied();
        let done = match what {
            Do::Ack => return,
            Do::Ask { id, question } => self.answer(client, id, question),
            Do::Edit { take } => match (take, role, self.editor == Some(client)) {
                (true, Some(Role::Edit), false) => {
                    self.end_gesture();
                    self.pass_pen(Some(client));
                    Ok(false)
                }
                (false, _, true) => {
                    self.end_gesture();
                    self.pass_pen(None);
                    Ok(false)
                }
                (true, Some(Role::Watch), _) => Err("this link is for looking on".into()),
                _ => Ok(false),
            },
            _ if self.editor != Some(client) => Err("somebody else is editing".into()),
            _ if self.scene.is_none() => Err("the scene is not there yet".into()),
            what => self.follow(client, seq, what),
        };
        match done {
            Ok(traced) if self.editor == Some(client) => {
                self.seq = seq;
                self.screen.applied(seq, traced);
            }
            Ok(_) => {}
            Err(why) => self.hub.tell(client, &json!({"is": "refused", "seq": seq, "why": why})),
        }
    }

    /// What only the editor may. Returns whether it asks for rays.
    fn follow(&mut self, client: u64, seq: u32, what: Do) -> Result<bool, String> {
        match what {
            Do::Size { width, height } => {
                self.studio.resize([width, height]);
                Ok(false)
            }
            Do::Camera(look) => {
                let look = look.in_perspective();
                self.cameras += 1;
                self.studio.look(look.clone(), self.cameras, seq);
                self.look = Some(look);
                Ok(true)
            }
            Do::Begin { label } => {
                self.end_gesture();
                self.gesture = Some(Gesture { label, forward: Patch::default(), inverse: Patch::default() });
                Ok(false)
            }
            Do::Set { patch } => {
                let label = state::label(&self.model, &patch);
                self.in_gesture(seq, &label, |desk| desk.edit(seq, *patch, 0.0))
            }
            Do::End { label } => {
                if let (Some(gesture), Some(label)) = (&mut self.gesture, label) {
                    gesture.label = label;
                }
                self.end_gesture();
                Ok(false)
            }
            Do::Cancel => self.cancel_gesture(seq),
            Do::Undo | Do::Redo => {
                self.end_gesture();
                let undo = matches!(what, Do::Undo);
                let step = if undo { self.history.undo() } else { self.history.redo() };
                let Some(gesture) = step.map_err(|e| format!("the log cannot be read: {e}"))? else {
                    return Err(
                        if undo { "there is nothing to undo" } else { "there is nothing to redo" }.into()
                    );
                };
                let patch = if undo { &gesture.inverse } else { &gesture.forward };
                let (_, traced) = self.carry_out(seq, patch, 0.0)?;
                self.tell_history();
                Ok(traced)
            }
            Do::Solo { lamps } => {
                self.solo = lamps.into_iter().collect();
                self.mix(seq, 0.0);
                self.tell_patch(json!({"solo": self.solo}));
                Ok(false)
            }
            Do::Display { patch } => self.display_as(seq, &patch),
            Do::Reach { most, maintenance } => self.reach(seq, most, maintenance),
            Do::Expose => {
                self.show.ev = None;
                self.screen.show(self.show.clone());
                Ok(false)
            }
            Do::Links { what, role, id } => self.links(client, &what, role, id).map(|()| false),
            Do::Add { lamp } => {
                let new: NewLamp = serde_json::from_value(*lamp).map_err(|e| e.to_string())?;
                self.in_gesture(seq, "Add a lamp", |desk| {
                    let light = new.light(desk.model.lamps.len(), desk.down())?;
                    desk.add(seq, light, None)
                })
            }
            Do::Copy { lamps, count, step } => {
                self.in_gesture(seq, "Copy", |desk| desk.copy(seq, &lamps, count, step))
            }
            Do::Remove { lamps } => {
                let gone = LampPatch { gone: Some(true), ..LampPatch::default() };
                let lamps = lamps.into_iter().map(|id| (id, gone.clone())).collect();
                self.in_gesture(seq, "Remove", |desk| {
                    desk.edit(seq, Patch { lamps, ..Patch::default() }, 0.0)
                })
            }
            Do::Group { lamps, name } => {
                let label = if name.is_some() { "Group" } else { "Ungroup" };
                self.in_gesture(seq, label, |desk| desk.group(seq, &lamps, name))
            }
            Do::Look { id, name, what, seconds } => self.look(seq, (id, name), &what, seconds),
            Do::Ack | Do::Ask { .. } | Do::Edit { .. } => Ok(false),
            Do::Save { name } => {
                self.save_in(SOON);
                self.save(name);
                Ok(false)
            }
        }
    }

    fn links(&mut self, client: u64, what: &str, role: Option<Role>, id: Option<u32>) -> Result<(), String> {
        match (what, role, id) {
            ("list", _, _) => {}
            ("make", Some(role), _) => drop(self.door.make(role).map_err(|e| e.to_string())?),
            ("revoke", _, Some(id)) => {
                self.door.revoke(id);
                let door = self.door.clone();
                self.hub.dismiss(|pass| door.still(pass));
            }
            _ => return Err("need list, make with a role, or revoke with an id".into()),
        }
        let links = self.door.links();
        let told = links
            .iter()
            .map(|link| json!({"id": link.id, "role": link.role, "address": self.door.address_of(link)}));
        self.hub.tell(client, &json!({"is": "links", "links": told.collect::<Vec<_>>()}));
        Ok(())
    }

    /// What meters and grids there are.
    fn lay_out(&mut self) {
        self.layout = Layout::of(&self.model, -self.down(), self.look.as_ref());
        self.studio.measure(self.layout.points.clone());
    }
}
