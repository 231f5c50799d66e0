//! How a desk edits: patches to the model, what follows from them to the renderer, and gestures to the log.

use super::{Desk, SOON};
use crate::adding;
use crate::edits::{edits, lit_at};
use crate::history::Gesture;
use crate::model::{Body, Group, Lamp, Touched};
use crate::patch::{GroupPatch, LampPatch, Mode, Patch, Place};
use crate::state;
use glam::Vec3;
use lampyris::light::{Light, State};
use lampyris::scene::Edit;
use serde_json::json;

/// The group of lamps that were added.
const ADDED: &str = "added";

/// Most lamps that there may be before another is added, those that were taken away counted.
const LAMPS: u32 = 4096;

impl Desk {
    /// Does something in the gesture at hand, or in one of its own, which never was where it is refused.
    pub(super) fn in_gesture(
        &mut self,
        seq: u32,
        label: &str,
        done: impl FnOnce(&mut Desk) -> Result<bool, String>,
    ) -> Result<bool, String> {
        let alone = self.gesture.is_none();
        if alone {
            let label = label.to_owned();
            self.gesture = Some(Gesture { label, forward: Patch::default(), inverse: Patch::default() });
        }
        let result = done(self);
        if alone && result.is_err() {
            self.cancel_gesture(seq)?;
        } else if alone {
            self.end_gesture();
        }
        result
    }

    /// A lamp more, of the next number, in a group. Undo takes it away, its number stays.
    pub(super) fn add(&mut self, seq: u32, mut light: Light, group: Option<u32>) -> Result<bool, String> {
        let scene = self.scene.as_mut().ok_or("the scene is not there yet")?;
        let (number, id) = (scene.lights.len() as u32, self.model.lamps.len() as u32);
        if id >= LAMPS {
            return Err(format!("there is room for {LAMPS} lamps"));
        }
        // It comes as one that was taken away, and so does its group: that they are there now is what undo takes back.
        light.state = State::Away;
        let edit = Edit::AddLight { light: light.clone() };
        scene.apply(&edit).map_err(|e| e.to_string())?;
        let emitter = adding::enter(scene, number);
        let known = || self.model.groups.iter().position(|own| own.name == ADDED).map(|at| at as u32);
        // A copy stays where its pattern is, in a group or in none.
        let comes = group.is_none();
        let group = group.or_else(known).unwrap_or_else(|| {
            self.model.groups.push(Group { name: ADDED.into(), on: true, level: 1.0, gone: true });
            self.model.groups.len() as u32 - 1
        });
        let lamp = adding::lamp(number, &light, emitter, group);
        self.model.lamps.push(Lamp { gone: true, ..lamp });
        self.studio.edit(vec![edit], seq);
        let lamp = LampPatch { gone: Some(false), ..LampPatch::default() };
        let mut there = Patch { lamps: [(id, lamp)].into(), ..Patch::default() };
        if comes && self.model.groups.get(group as usize).is_some_and(|group| group.gone) {
            let back = GroupPatch { gone: Some(false), ..GroupPatch::default() };
            there.groups.insert(group, back);
        }
        self.edit(seq, there, 0.0)
    }

    pub(super) fn copy(&mut self, seq: u32, lamps: &[u32], count: u32, step: Vec3) -> Result<bool, String> {
        let all = self.model.lamps.len() + lamps.len().saturating_mul(count as usize);
        if all > LAMPS as usize {
            return Err(format!("there is room for {LAMPS} lamps"));
        }
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
                let color = (own.color.mode != Mode::File).then(|| own.color.whole());
                let (level, on) = (Some(own.level), Some(own.on));
                let like = LampPatch { level, on, color, ..LampPatch::default() };
                self.edit(seq, Patch { lamps: [(id, like)].into(), ..Patch::default() }, 0.0)?;
            }
        }
        Ok(true)
    }

    /// The way things fall.
    pub(super) fn down(&self) -> Vec3 {
        self.scene.as_ref().and_then(|scene| scene.up).map_or(Vec3::NEG_Z, |up| -up)
    }

    /// An edit of the gesture at hand.
    pub(super) fn edit(&mut self, seq: u32, patch: Patch, seconds: f32) -> Result<bool, String> {
        let (inverse, traced) = self.carry_out(seq, &patch, seconds)?;
        if let Some(gesture) = &mut self.gesture {
            // Forth to the latest, back to the first.
            let before = std::mem::replace(&mut gesture.forward, patch);
            gesture.forward.over(before);
            gesture.inverse.over(inverse);
        }
        Ok(traced)
    }

    /// Does what a patch says, tells everybody, and returns the patch that takes it back and whether it asks for rays; or
    /// nothing is changed.
    pub(super) fn carry_out(
        &mut self,
        seq: u32,
        patch: &Patch,
        seconds: f32,
    ) -> Result<(Patch, bool), String> {
        let Some(before) = self.scene.clone() else { return Err("the scene is not there yet".into()) };
        let inverse = self.model.apply(patch)?;
        let mut touched = Touched::of(patch);
        let traced = self.scene.as_mut().map_or(Ok(Vec::new()), |scene| edits(&self.model, scene, &touched));
        let done = traced.and_then(|mut traced| {
            let mixed = self.sorted()?;
            let sorted = mixed.iter().any(|edit| !matches!(edit, Edit::Mix { .. }));
            let traces = !traced.is_empty() || sorted;
            traced.extend(mixed);
            Ok((traced, traces, sorted))
        });
        match done {
            Ok((edits, traced, sorted)) => {
                touched.spread(&self.model, &inverse, sorted);
                self.studio.edit(edits, seq);
                self.save_in(SOON);
                if !touched.looks.is_empty() {
                    self.unseen = true;
                    self.end_comparison_with_nothing();
                }
                self.mix(seq, seconds);
                if !touched.meters.is_empty() || !touched.grids.is_empty() {
                    self.lay_out();
                }
                let Some(scene) = &self.scene else { return Ok((inverse, traced)) };
                let patch = self.with_photos(state::of(&self.model, scene, &touched));
                self.tell_patch_of(seq, patch);
                Ok((inverse, traced))
            }
            Err(why) => {
                self.scene = Some(before);
                self.model.apply(&inverse)?;
                Err(why)
            }
        }
    }

    /// The gesture at hand never was. Returns whether that asks for rays.
    pub(super) fn cancel_gesture(&mut self, seq: u32) -> Result<bool, String> {
        match self.gesture.take() {
            Some(gesture) if gesture.inverse != Patch::default() => {
                self.carry_out(seq, &gesture.inverse, 0.0).map(|(_, traced)| traced)
            }
            _ => Ok(false),
        }
    }

    pub(super) fn end_gesture(&mut self) {
        let Some(gesture) = self.gesture.take().filter(|gesture| gesture.forward != gesture.inverse) else {
            return;
        };
        if let Err(error) = self.history.push(&gesture) {
            self.hub.tell_all(&json!({"is": "event", "what": "unlogged", "why": error.to_string()}));
        }
        self.tell_history();
    }
}
