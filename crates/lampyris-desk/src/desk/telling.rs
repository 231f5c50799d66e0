//! What a desk tells: the state, what changed of it, and how far things are.

use super::Desk;
use crate::state;
use crate::studio::GROUPS;
use glam::Vec3;
use lampyris::Rgb;
use serde_json::{Value, json};
use std::collections::BTreeSet;

impl Desk {
    pub(super) fn tell_readings(&self) {
        let mut patch = json!({});
        for (slice, notes) in [("meters", &self.model.notes.meters), ("grids", &self.model.notes.grids)] {
            let read = notes.keys().filter(|id| !self.told[slice][id.to_string()].is_null());
            let entries = read
                .map(|id| (id.to_string(), state::measured(&notes[id], &self.told[slice][id.to_string()])));
            patch[slice] = entries.collect::<serde_json::Map<_, _>>().into();
        }
        self.tell_patch(patch);
    }

    pub(super) fn tell_patch(&self, patch: Value) {
        self.tell_patch_of(self.seq, patch);
    }

    /// What the editor's message of that number changed.
    pub(super) fn tell_patch_of(&self, seq: u32, patch: Value) {
        self.hub.tell_all(&json!({"is": "patch", "seq": seq, "by": self.editor, "patch": patch}));
    }

    pub(super) fn tell_history(&self) {
        self.tell_patch(json!({"history": self.history_state()}));
    }

    pub(super) fn tell_state(&self, client: u64) {
        let Some(scene) = &self.scene else { return };
        let mut whole = self.with_photos(state::whole(&self.model, scene));
        whole["scene"] = state::scene(scene, &self.file, &self.model, &self.warnings);
        whole["layers"] = state::layers(Some(scene), self.progress.as_ref());
        whole["display"] = self.display();
        whole["solo"] = json!(self.solo);
        whole["history"] = self.history_state();
        whole["saved"] = self.saved.clone();
        whole["editor"] = self.editor_for(client);
        whole["status"] = self.status();
        whole["camera"] = json!(self.look);
        self.hub.tell(client, &json!({"is": "state", "seq": self.seq, "state": whole}));
    }

    pub(super) fn editor_for(&self, client: u64) -> Value {
        json!({"you": self.editor == Some(client), "name": self.editor.map(|id| format!("guest {id}"))})
    }

    pub(super) fn history_state(&self) -> Value {
        let [undo, redo] = self.history.labels();
        json!({"undo": undo, "redo": redo, "steps": self.history.steps()})
    }

    pub(super) fn display(&self) -> Value {
        let tone = self.show.tone.name();
        let legend = self.show.legend.as_ref().map(|legend| {
            let mut told = legend.told();
            if legend.against().is_some() {
                told["exact"] = self.exact.into();
            }
            told
        });
        json!({"ev": self.show.ev, "metered": self.metered, "tone": tone, "white": self.white, "false_color": legend})
    }

    pub(super) fn status(&self) -> Value {
        match &self.progress {
            None => json!({"is": "status", "stage": "loading"}),
            Some(p) => {
                let error = p.error.is_finite().then_some(p.error);
                json!({"is": "status", "stage": p.stage, "fps": p.fps, "batches": p.batches, "error": error,
                       "good_in": p.good_in, "size": p.size, "layers": p.layers.len()})
            }
        }
    }

    /// The command line that renders what is seen.
    pub(super) fn command(&self) -> String {
        let size = self.progress.as_ref().map_or([640, 480], |p| p.size);
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_.,/+:=".contains(c);
        let quoted = |arg: String| match arg.chars().all(plain) {
            true => arg,
            false => format!("'{}'", arg.replace('\'', "'\\''")),
        };
        let args: Vec<String> = self.arguments(size, self.enough).into_iter().map(quoted).collect();
        format!("lampyris {} -o picture.png", args.join(" "))
    }

    /// The arguments that render what is seen, but for the file.
    pub(super) fn arguments(&self, [width, height]: [u32; 2], batches: u32) -> Vec<String> {
        let mut args = vec!["render".to_owned()];
        let vector = |v: Vec3| format!("{},{},{}", v.x, v.y, v.z);
        match self.saved["file"].as_str() {
            Some(file) => args.push(file.into()),
            // Sorted into groups as here, so that sums are rounded alike.
            None => args.extend([self.file.display().to_string(), "--groups".into(), GROUPS.to_string()]),
        }
        if let Some(look) = &self.look {
            let [eye, target, up] = [look.eye, look.target, look.up].map(vector);
            let view = [("--eye", eye), ("--target", target), ("--up", up), ("--fov", look.fov.to_string())];
            args.extend(view.into_iter().flat_map(|(name, value)| [name.to_owned(), value]));
            if look.near > 0.0 {
                args.extend(["--near".into(), look.near.to_string()]);
            }
        }
        let ev = self.show.ev.map_or("auto".into(), |ev| ev.to_string());
        let rest = [
            ("--size", format!("{width}x{height}")),
            ("--batches", batches.to_string()),
            ("--exposure", ev),
            ("--tone", self.show.tone.name().into()),
        ];
        args.extend(rest.into_iter().flat_map(|(name, value)| [name.to_owned(), value]));
        args
    }

    /// Has the next picture made that is asked for, once all is saved.
    pub(super) fn print(&mut self) {
        if self.saving > 0 || self.orders.is_empty() {
            return;
        }
        let order = self.orders.remove(0);
        let args = self.arguments(order.size, order.batches);
        let (client, id) = (order.client, order.id);
        if let Err(why) = self.printer.start(order, &args, &self.inbox) {
            self.hub.tell(client, &json!({"is": "answer", "id": id, "why": why}));
        }
    }

    /// Level and colour of each layer as it is shown.
    pub(super) fn colors(&self) -> Vec<Rgb> {
        self.soloed(self.colors_of_scene())
    }

    /// The same where none is shown alone.
    pub(super) fn colors_of_scene(&self) -> Vec<Rgb> {
        self.scene.iter().flat_map(|scene| &scene.groups).map(|group| group.color).collect()
    }

    /// Colours of the layers as far as these are shown.
    pub(super) fn soloed(&self, mut colors: Vec<Rgb>) -> Vec<Rgb> {
        let Some(scene) = &self.scene else { return Vec::new() };
        if !self.solo.is_empty() {
            let lamps = self.solo.iter().filter_map(|id| self.model.lamps.get(*id as usize));
            let emitters = lamps.flat_map(|lamp| &lamp.emitters);
            let layers: BTreeSet<u16> = emitters
                .filter_map(|(k, _)| scene.reference.shares.get(*k as usize))
                .map(|share| share.group)
                .collect();
            (0..)
                .zip(&mut colors)
                .filter(|(layer, _)| !layers.contains(layer))
                .for_each(|(_, color)| *color = Rgb::BLACK);
        }
        colors
    }
}
