//! The desk itself: who edits, what was done, what all are told. It holds what shall be and never waits for light: rays are
//! the studio's, pictures the screen's.

use crate::adding::{self, NewLamp};
use crate::door::{Door, Role};
use crate::edits::{edits, lit_at};
use crate::history::{Gesture, History};
use crate::hub::Hub;
use crate::mixer::mix;
use crate::model::{Body, Group, Model, Touched};
use crate::patch::{LampPatch, Patch, Place};
use crate::screen::{Screen, Show};
use crate::state;
use crate::studio::{Asked, Found, Progress, Studio};
use crate::wire::{Do, Look, Message, PROTOCOL, Question};
use glam::Vec3;
use lampyris::Rgb;
use lampyris::light::Light;
use lampyris::output::ToneCurve;
use lampyris::scene::{Edit, Scene};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};

/// The group of lamps that were added.
const ADDED: &str = "added";

/// What happens at a desk.
pub(crate) enum Event {
    /// The scene is there.
    Opened {
        model: Box<Model>,
        scene: Box<Scene>,
        look: Look,
        warnings: Vec<String>,
    },
    /// It is not, or no more.
    Failed {
        why: String,
    },
    Joined {
        client: u64,
        role: Role,
    },
    Left {
        client: u64,
    },
    Said {
        client: u64,
        message: Message,
    },
    Progress(Progress),
    Found {
        client: u64,
        id: u32,
        found: Option<Found>,
    },
    /// An exposure was metered.
    Metered {
        ev: f32,
    },
    /// The renderer did not follow an edit.
    Refused {
        why: String,
    },
    /// The program shall end.
    End,
}

/// Where events go.
#[derive(Clone)]
pub(crate) struct Inbox(Sender<Event>);

impl Inbox {
    pub(crate) fn new() -> (Inbox, Receiver<Event>) {
        let (send, receive) = mpsc::channel();
        (Inbox(send), receive)
    }

    /// Nobody listens any more once the program ends.
    pub(crate) fn put(&self, event: Event) {
        let _ = self.0.send(event);
    }
}

/// The desk.
pub(crate) struct Desk {
    hub: Arc<Hub>,
    door: Arc<Door>,
    studio: Arc<Studio>,
    screen: Arc<Screen>,
    file: PathBuf,
    build: Arc<str>,
    model: Model,
    /// The scene without its geometry.
    scene: Option<Scene>,
    warnings: Vec<String>,
    look: Option<Look>,
    cameras: u32,
    history: History,
    gesture: Option<Gesture>,
    solo: BTreeSet<u32>,
    show: Show,
    metered: bool,
    white: Value,
    progress: Option<Progress>,
    failed: Option<String>,
    clients: BTreeMap<u64, Role>,
    editor: Option<u64>,
    /// The last message of the editor that was applied.
    seq: u32,
    /// The program ends when nobody looks any more.
    ends_alone: bool,
}

/// What decides a desk when it begins.
pub(crate) struct Parts {
    pub(crate) hub: Arc<Hub>,
    pub(crate) door: Arc<Door>,
    pub(crate) studio: Arc<Studio>,
    pub(crate) screen: Arc<Screen>,
    pub(crate) file: PathBuf,
    pub(crate) build: Arc<str>,
    pub(crate) ends_alone: bool,
}

impl Desk {
    pub(crate) fn new(parts: Parts) -> crate::error::Result<Desk> {
        let Parts { hub, door, studio, screen, file, build, ends_alone } = parts;
        Ok(Desk {
            hub,
            door,
            studio,
            screen,
            file,
            build,
            model: Model::default(),
            scene: None,
            warnings: Vec::new(),
            look: None,
            cameras: 0,
            history: History::new()?,
            gesture: None,
            solo: BTreeSet::new(),
            show: Show::default(),
            metered: false,
            white: Value::Null,
            progress: None,
            failed: None,
            clients: BTreeMap::new(),
            editor: None,
            seq: 0,
            ends_alone,
        })
    }

    /// Does what comes, until the end.
    pub(crate) fn run(mut self, events: &Receiver<Event>) {
        while let Ok(event) = events.recv() {
            match event {
                Event::Opened { model, scene, look, warnings } => {
                    (self.model, self.scene, self.warnings) = (*model, Some(*scene), warnings);
                    self.look = Some(look);
                    self.hub.present().into_iter().for_each(|(client, _)| self.tell_state(client));
                }
                Event::Failed { why } => {
                    self.hub.tell_all(&json!({"is": "event", "what": "broken", "why": why}));
                    self.failed = Some(why);
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
                    self.hub.tell_all(&json!({"is": "patch", "seq": self.seq, "patch": {"layers": layers}}));
                }
                Event::Found { client, id, found } => {
                    let answer = state::found(&self.model, id, found);
                    self.hub.tell(client, &answer);
                }
                Event::Metered { ev } => {
                    (self.show.ev, self.metered) = (Some(ev), true);
                    self.tell_patch(json!({"display": self.display()}));
                }
                Event::Refused { why } => {
                    if let Some(editor) = self.editor {
                        self.hub.tell(editor, &json!({"is": "refused", "seq": self.seq, "why": why}));
                    }
                }
                Event::End => break,
            }
        }
        self.hub.tell_all(&json!({"is": "event", "what": "bye"}));
        self.studio.end();
        self.screen.end();
    }

    fn join(&mut self, client: u64, role: Role) {
        self.clients.insert(client, role);
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
        if let Some(why) = &self.failed {
            self.hub.tell(client, &json!({"is": "event", "what": "broken", "why": why}));
        }
    }

    fn leave(&mut self, client: u64) {
        self.clients.remove(&client);
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
                let alone = self.gesture.is_none();
                if alone {
                    let label = state::label(&self.model, &patch);
                    self.gesture =
                        Some(Gesture { label, forward: Patch::default(), inverse: Patch::default() });
                }
                let done = self.edit(seq, *patch);
                if alone {
                    self.end_gesture();
                }
                done
            }
            Do::End => {
                self.end_gesture();
                Ok(false)
            }
            Do::Cancel => match self.gesture.take() {
                Some(gesture) => self.carry_out(seq, &gesture.inverse).map(|(_, traced)| traced),
                None => Ok(false),
            },
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
                let (_, traced) = self.carry_out(seq, patch)?;
                self.tell_history();
                Ok(traced)
            }
            Do::Solo { lamps } => {
                self.solo = lamps.into_iter().collect();
                Ok(false)
            }
            Do::Display { patch } => self.display_as(&patch).map(|()| false),
            Do::Expose => {
                self.show.ev = None;
                self.screen.show(self.show);
                Ok(false)
            }
            Do::Links { what, role, id } => self.links(client, &what, role, id).map(|()| false),
            Do::Add { lamp } => {
                let new: NewLamp = serde_json::from_value(*lamp).map_err(|e| e.to_string())?;
                self.in_gesture("Add a lamp", |desk| {
                    let light = new.light(desk.model.lamps.len(), desk.down())?;
                    desk.add(seq, light, None)
                })
            }
            Do::Copy { lamps, count, step } => {
                self.in_gesture("Copy", |desk| desk.copy(seq, &lamps, count, step))
            }
            Do::Remove { lamps } => {
                let gone = LampPatch { gone: Some(true), ..LampPatch::default() };
                let lamps = lamps.into_iter().map(|id| (id, gone.clone())).collect();
                self.in_gesture("Remove", |desk| desk.edit(seq, Patch { lamps, ..Patch::default() }))
            }
            Do::Look { id, name, what, .. } => self.look(seq, id, name, &what),
            Do::Ack | Do::Ask { .. } | Do::Edit { .. } => Ok(false),
            Do::Save { .. } => Err("this desk cannot do that".into()),
        }
    }

    /// Does something in the gesture at hand, or in one of its own.
    fn in_gesture<R>(&mut self, label: &str, done: impl FnOnce(&mut Desk) -> R) -> R {
        let alone = self.gesture.is_none();
        if alone {
            let label = label.to_owned();
            self.gesture = Some(Gesture { label, forward: Patch::default(), inverse: Patch::default() });
        }
        let result = done(self);
        if alone {
            self.end_gesture();
        }
        result
    }

    /// A lamp more, of the next number, in a group. Undo takes it away, its number stays.
    fn add(&mut self, seq: u32, light: Light, group: Option<u32>) -> Result<bool, String> {
        let scene = self.scene.as_mut().ok_or("the scene is not there yet")?;
        let (number, id) = (scene.lights.len() as u32, self.model.lamps.len() as u32);
        let edit = Edit::AddLight { light: light.clone() };
        scene.apply(&edit).map_err(|e| e.to_string())?;
        let emitter = adding::enter(scene, number);
        let known = self.model.groups.iter().position(|own| own.name == ADDED && !own.gone);
        let group = group.or(known.map(|at| at as u32)).unwrap_or_else(|| {
            self.model.groups.push(Group { name: ADDED.into(), on: true, level: 1.0, gone: false });
            self.model.groups.len() as u32 - 1
        });
        self.model.lamps.push(adding::lamp(number, &light, emitter, group));
        self.studio.edit(vec![edit], seq);
        let there = LampPatch { gone: Some(false), ..LampPatch::default() };
        self.edit(seq, Patch { lamps: [(id, there)].into(), ..Patch::default() })?;
        if let Some(gesture) = &mut self.gesture {
            gesture.inverse.lamps.entry(id).or_default().gone = Some(true);
        }
        let touched = Touched { groups: [group].into(), ..Touched::default() };
        let patch = self.scene.as_ref().map(|scene| state::of(&self.model, scene, &touched));
        self.tell_patch(json!(patch));
        Ok(true)
    }

    fn copy(&mut self, seq: u32, lamps: &[u32], count: u32, step: Vec3) -> Result<bool, String> {
        for id in lamps {
            let own =
                self.model.lamps.get(*id as usize).ok_or_else(|| format!("there is no lamp {id}"))?.clone();
            let Body::Light(_, file) = &own.body else {
                return Err(format!(
                    "{} is part of the building; only lamps that are no surfaces can be copied",
                    own.name
                ));
            };
            for number in 1..=count {
                let by = step * number as f32;
                let shift = |p: Option<Vec3>| p.map(|p| p + by);
                let place = Place {
                    position: shift(own.place.position),
                    aim: shift(own.place.aim),
                    ..own.place.clone()
                };
                let kind = lit_at(file, &place);
                let light = Light::new(format!("{} {}", own.name, number + 1), kind);
                self.add(seq, light, Some(own.group))?;
                let id = self.model.lamps.len() as u32 - 1;
                let like = LampPatch { level: Some(own.level), on: Some(own.on), ..LampPatch::default() };
                self.edit(seq, Patch { lamps: [(id, like)].into(), ..Patch::default() })?;
            }
        }
        Ok(true)
    }

    /// Looks: what all faders stand at.
    fn look(&mut self, seq: u32, id: Option<u32>, name: Option<String>, what: &str) -> Result<bool, String> {
        let looks = &self.model.notes.looks;
        let known = |id: Option<u32>| id.filter(|id| looks.contains_key(id)).ok_or("there is no such look");
        let named =
            |id: u32| looks.get(&id).and_then(|look| look["name"].as_str()).unwrap_or_default().to_owned();
        let set = |id: u32, look: Option<Value>| Patch { looks: [(id, look)].into(), ..Patch::default() };
        let (label, patch) = match what {
            "store" => {
                let id = looks.keys().next_back().map_or(0, |last| last + 1);
                let name = name.unwrap_or_else(|| format!("look {}", id + 1));
                (
                    format!("Store {name}"),
                    set(id, Some(json!({"name": name, "patch": state::faders(&self.model)}))),
                )
            }
            "update" => {
                let id = known(id)?;
                let look = json!({"name": named(id), "patch": state::faders(&self.model)});
                (format!("Update {}", named(id)), set(id, Some(look)))
            }
            "rename" => {
                let id = known(id)?;
                let mut look = looks[&id].clone();
                look["name"] = name.ok_or("need a name")?.into();
                (format!("Rename {}", named(id)), set(id, Some(look)))
            }
            "remove" => {
                let id = known(id)?;
                (format!("Remove {}", named(id)), set(id, None))
            }
            "recall" => {
                let id = known(id)?;
                let patch = serde_json::from_value(looks[&id]["patch"].clone()).map_err(|e| e.to_string())?;
                (named(id), patch)
            }
            _ => return Err("need store, recall, update, rename or remove".into()),
        };
        self.in_gesture(&label, |desk| desk.edit(seq, patch))
    }

    /// The way things fall.
    fn down(&self) -> Vec3 {
        self.scene.as_ref().and_then(|scene| scene.up).map_or(Vec3::NEG_Z, |up| -up)
    }

    /// An edit of the gesture at hand.
    fn edit(&mut self, seq: u32, patch: Patch) -> Result<bool, String> {
        let (mut inverse, traced) = self.carry_out(seq, &patch)?;
        if let Some(gesture) = &mut self.gesture {
            // Forth to the latest, back to the first.
            let mut forward = patch;
            forward.over(std::mem::take(&mut gesture.forward));
            gesture.forward = forward;
            let mut first = std::mem::take(&mut gesture.inverse);
            first.over(std::mem::take(&mut inverse));
            gesture.inverse = first;
        }
        Ok(traced)
    }

    /// Does what a patch says, tells everybody, and returns the patch that takes it back and whether it asks for rays; or
    /// nothing is changed.
    fn carry_out(&mut self, seq: u32, patch: &Patch) -> Result<(Patch, bool), String> {
        let Some(scene) = &mut self.scene else { return Err("the scene is not there yet".into()) };
        let inverse = self.model.apply(patch)?;
        let touched = Touched::of(patch);
        let before = (scene.clone(), ());
        let done = edits(&self.model, scene, &touched).and_then(|mut traced| {
            let mixed = mix(&self.model, scene)?;
            let traces = !traced.is_empty() || mixed.iter().any(|edit| !matches!(edit, Edit::Mix { .. }));
            traced.extend(mixed);
            Ok((traced, traces))
        });
        match done {
            Ok((edits, traced)) => {
                self.studio.edit(edits, seq);
                let patch = state::of(&self.model, scene, &touched);
                self.hub.tell_all(&json!({"is": "patch", "seq": seq, "patch": patch}));
                Ok((inverse, traced))
            }
            Err(why) => {
                *scene = before.0;
                self.model.apply(&inverse)?;
                Err(why)
            }
        }
    }

    fn end_gesture(&mut self) {
        let Some(gesture) = self.gesture.take().filter(|gesture| gesture.forward != gesture.inverse) else {
            return;
        };
        if let Err(error) = self.history.push(&gesture) {
            self.hub.tell_all(&json!({"is": "event", "what": "unlogged", "why": error.to_string()}));
        }
        self.tell_history();
    }

    fn answer(&mut self, client: u64, id: u32, question: Question) -> Result<bool, String> {
        match question {
            Question::Point { frame, x, y } => {
                let frame = self.screen.frame(frame).ok_or("this frame is too old to ask about")?;
                self.studio.ask(Asked { client, id, frame, at: [x, y] });
                Ok(false)
            }
            Question::Light { .. } | Question::Command | Question::Picture { .. } => {
                Err("this desk cannot tell that".into())
            }
        }
    }

    fn display_as(&mut self, patch: &Value) -> Result<(), String> {
        let mut show = self.show;
        if let Some(ev) = patch.get("ev") {
            let ev =
                ev.as_f64().filter(|ev| ev.abs() <= 60.0).ok_or("an exposure lies between -60 and 60")?;
            show.ev = Some(ev as f32);
        }
        if let Some(tone) = patch.get("tone") {
            show.tone = tone.as_str().and_then(ToneCurve::from_name).ok_or("there is no such tone curve")?;
        }
        if let Some(white) = patch.get("white") {
            show.white = state::white(white)?;
            self.white = white.clone();
        }
        self.show = show;
        self.screen.show(show);
        self.tell_patch(json!({"display": self.display()}));
        Ok(())
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

    fn tell_patch(&self, patch: Value) {
        self.hub.tell_all(&json!({"is": "patch", "seq": self.seq, "patch": patch}));
    }

    fn tell_history(&self) {
        self.tell_patch(json!({"history": self.history_state()}));
    }

    fn tell_state(&self, client: u64) {
        let Some(scene) = &self.scene else { return };
        let mut whole = state::whole(&self.model, scene);
        whole["scene"] = state::scene(scene, &self.file, &self.model, &self.warnings);
        whole["layers"] = state::layers(Some(scene), self.progress.as_ref());
        whole["display"] = self.display();
        whole["solo"] = json!(self.solo);
        whole["history"] = self.history_state();
        whole["saved"] = json!({"state": "clean", "file": null, "why": null});
        whole["editor"] = self.editor_for(client);
        whole["status"] = self.status();
        whole["camera"] = json!(self.look);
        self.hub.tell(client, &json!({"is": "state", "seq": self.seq, "state": whole}));
    }

    fn editor_for(&self, client: u64) -> Value {
        json!({"you": self.editor == Some(client), "name": self.editor.map(|id| format!("guest {id}"))})
    }

    fn history_state(&self) -> Value {
        let [undo, redo] = self.history.labels();
        json!({"undo": undo, "redo": redo, "steps": self.history.steps()})
    }

    fn display(&self) -> Value {
        let tone = self.show.tone.name();
        json!({"ev": self.show.ev, "metered": self.metered, "tone": tone, "white": self.white, "false_color": null})
    }

    fn status(&self) -> Value {
        match &self.progress {
            None => json!({"is": "status", "stage": "loading"}),
            Some(p) => {
                let error = p.error.is_finite().then_some(p.error);
                json!({"is": "status", "stage": p.stage, "fps": p.fps, "batches": p.batches, "error": error,
                       "good_in": p.good_in, "size": p.size, "layers": p.layers.len()})
            }
        }
    }
}
