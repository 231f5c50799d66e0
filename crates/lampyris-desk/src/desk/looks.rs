//! Looks: what all faders stand at, under a name. Of each the desk makes a thumbnail as soon as the picture has settled, by a
//! mix of its layers.

use super::Desk;
use crate::album;
use crate::mixer;
use crate::model::Model;
use crate::patch::Patch;
use crate::screen;
use crate::state;
use crate::wire::Kind;
use lampyris::Rgb;
use serde::Deserialize;
use serde_json::{Value, json};

/// Batches that a picture needs before thumbnails are taken of it, if it is not final before.
const SETTLED: u32 = 2;

impl Desk {
    /// Stores, recalls, updates, names and removes looks.
    pub(super) fn look(
        &mut self,
        seq: u32,
        (id, name): (Option<u32>, Option<String>),
        what: &str,
        seconds: f32,
    ) -> Result<bool, String> {
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
        self.in_gesture(seq, &label, |desk| desk.edit(seq, patch, seconds))
    }

    /// The lamps as a look has them; those that came after it as they are.
    pub(super) fn as_in(&self, look: u32) -> Option<Model> {
        let patch = Patch::deserialize(&self.model.notes.looks.get(&look)?["patch"]).ok()?;
        let faders = Patch { lamps: patch.lamps, groups: patch.groups, ..Patch::default() };
        let Model { lamps, groups, .. } = &self.model;
        let mut model = Model { lamps: lamps.clone(), groups: groups.clone(), ..Model::default() };
        model.apply(&faders).ok()?;
        Some(model)
    }

    /// Level and colour of each layer as a look has them, and whether layers can show it as it is.
    pub(super) fn colors_in(&self, look: u32) -> Option<(Vec<Rgb>, bool)> {
        Some(mixer::colors(&self.as_in(look)?, self.scene.as_ref()?))
    }

    /// Makes the thumbnail of one look that has none, once there is a picture that has settled.
    pub(super) fn photograph(&mut self) {
        let light = self.screen.settled();
        let ready = |kind: Kind, batches: u32| kind == Kind::Final || batches >= SETTLED;
        let Some((still, _)) = light.filter(|(still, kind)| ready(*kind, still.batches())) else { return };
        if self.show.ev.is_none() {
            return;
        }
        let looks = &self.model.notes.looks;
        let Some(id) = self.album.wanting(looks) else {
            self.unseen = false;
            return;
        };
        let size = album::small(still.size());
        let made = self.colors_in(id).and_then(|(colors, _)| {
            let radiance = still.small(&colors, size);
            screen::encode(radiance, size, &self.show, Kind::Settled)
        });
        self.album.put(id, &looks[&id], made.unwrap_or_default());
        self.tell_patch(json!({"looks": {id.to_string(): self.look_told(id)}}));
    }

    /// What is told of a look, with its thumbnail.
    pub(super) fn look_told(&self, id: u32) -> Value {
        let Some(mut look) = self.model.notes.looks.get(&id).cloned() else { return Value::Null };
        if let Some(look) = look.as_object_mut() {
            look.insert("picture".into(), self.album.address(id));
        }
        look
    }

    /// Puts thumbnails into a state or a patch of it.
    pub(super) fn with_photos(&self, mut told: Value) -> Value {
        if let Some(looks) = told.get_mut("looks").and_then(Value::as_object_mut) {
            for (id, look) in looks {
                *look = id.parse().map_or(Value::Null, |id| self.look_told(id));
            }
        }
        told
    }
}
