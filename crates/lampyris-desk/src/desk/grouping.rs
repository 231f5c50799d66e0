//! Groups that people make: each lamp belongs to one at most, whose master dims it with the others.

use super::Desk;
use crate::model::{Group, Model};
use crate::patch::{GroupPatch, LampPatch, Patch};
use std::collections::BTreeSet;

/// Most groups that there may be, those that are gone counted.
const GROUPS: usize = 4096;

impl Desk {
    /// Makes lamps a group of a name, or, without one, takes them out of theirs. Groups that are left empty go.
    pub(super) fn group(&mut self, seq: u32, lamps: &[u32], name: Option<String>) -> Result<bool, String> {
        let lamps: BTreeSet<u32> = lamps.iter().copied().collect();
        let there = |id: &u32| self.model.lamps.get(*id as usize).is_some_and(|lamp| !lamp.gone);
        if lamps.is_empty() || !lamps.iter().all(there) {
            return Err("need lamps that there are".into());
        }
        if name.as_ref().is_some_and(String::is_empty) {
            return Err("a group needs a name".into());
        }
        let made = name.is_some();
        let to = self.model.place_for(name)?;
        let shall = LampPatch { group: Some(to), ..LampPatch::default() };
        let mut patch =
            Patch { lamps: lamps.iter().map(|id| (*id, shall.clone())).collect(), ..Patch::default() };
        let set = |gone| GroupPatch { gone: Some(gone), ..GroupPatch::default() };
        patch.groups.extend(self.model.emptied(&lamps).into_iter().map(|id| (id, set(true))));
        // It comes as one that is gone: that it is there now is what undo takes back.
        patch.groups.extend(made.then_some((to, set(false))));
        self.edit(seq, patch, 0.0)
    }
}

impl Model {
    /// A group more, or the one of lamps that are in none: it is never there.
    fn place_for(&mut self, name: Option<String>) -> Result<u32, String> {
        let loose = |own: &Group| own.name.is_empty() && own.gone;
        let known = self.groups.iter().position(loose).filter(|_| name.is_none());
        if known.is_none() && self.groups.len() >= GROUPS {
            return Err(format!("there is room for {GROUPS} groups"));
        }
        let at = known.unwrap_or_else(|| {
            self.groups.push(Group { name: name.unwrap_or_default(), on: true, level: 1.0, gone: true });
            self.groups.len() - 1
        });
        Ok(at as u32)
    }

    /// Groups that have no lamps but these.
    fn emptied(&self, lamps: &BTreeSet<u32>) -> Vec<u32> {
        let group = |id: &u32| self.lamps.get(*id as usize).map(|lamp| lamp.group);
        let left: BTreeSet<u32> = lamps.iter().filter_map(group).collect();
        let stays = |own: u32| {
            let mut others = (0..).zip(&self.lamps).filter(|(id, lamp)| !lamp.gone && !lamps.contains(id));
            others.any(|(_, lamp)| lamp.group == own)
        };
        let there = |own: &u32| self.groups.get(*own as usize).is_some_and(|group| !group.gone);
        left.into_iter().filter(there).filter(|own| !stays(*own)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::desk::hostile;
    use crate::model::Model;
    use crate::studio::bare;
    use crate::wire::{Do, Message};
    use crate::{opening, saving, state};
    use lampyris::import;
    use lampyris::world::World;
    use serde_json::{Value, json};
    use std::path::Path;

    /// A desk before the office, and its model as it was opened.
    fn office() -> (Desk, Model) {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/office.mgf");
        let mut world = World::new(import::load(&file, &import::Options::default()).unwrap().scene);
        world.separate(16).unwrap();
        let model = opening::open(&world);
        (hostile::desk(&model, &bare(world.scene())), model)
    }

    fn told(desk: &Desk) -> Value {
        state::whole(&desk.model, desk.scene.as_ref().unwrap())
    }

    /// The members of the group of a name, as all are told.
    fn members(desk: &Desk, name: &str) -> Option<Value> {
        let groups = told(desk)["groups"].as_object().unwrap().clone();
        groups.values().find(|own| own["name"] == name).map(|own| own["lamps"].clone())
    }

    fn undo(desk: &mut Desk) {
        desk.hear(1, Message { seq: 1, what: Do::Undo });
    }

    #[test]
    fn groups_are_made_dimmed_left_and_undone() {
        let (mut desk, opened) = office();
        let before = told(&desk);
        let rows = before["groups"].as_object().unwrap().len();
        desk.in_gesture(1, "Group", |desk| desk.group(1, &[4, 2, 2, 5], Some("evening".into()))).unwrap();
        assert_eq!(members(&desk, "evening"), Some(json!([2, 4, 5])));
        let id = desk.model.lamps[2].group;
        assert!([4, 5].iter().all(|k| desk.model.lamps[*k].group == id));
        let master = GroupPatch { level: Some(0.5), name: Some("late".into()), ..GroupPatch::default() };
        let dim = Patch { groups: [(id, master)].into(), ..Patch::default() };
        desk.in_gesture(2, "Dim", |desk| desk.edit(2, dim, 0.0)).unwrap();
        assert_eq!(desk.model.level_of(&desk.model.lamps[4]), 0.5);
        // It is kept, and comes back where the scene is opened again.
        let mut again = opened;
        assert_eq!(saving::restore(&mut again, &saving::kept(&desk.model)), Vec::<String>::new());
        assert_eq!(format!("{again:?}"), format!("{:?}", desk.model));
        // One goes, and is dimmed by none; then the others, and the group with them.
        desk.in_gesture(3, "Ungroup", |desk| desk.group(3, &[4], None)).unwrap();
        assert_eq!(members(&desk, "late"), Some(json!([2, 5])));
        assert_eq!(
            (desk.model.level_of(&desk.model.lamps[4]), &told(&desk)["lamps"]["4"]["group"]),
            (1.0, &Value::Null)
        );
        desk.in_gesture(4, "Ungroup", |desk| desk.group(4, &[5, 2], None)).unwrap();
        assert_eq!(members(&desk, "late"), None);
        let groups = told(&desk)["groups"].as_object().unwrap().len();
        assert!(groups <= rows, "nothing is left of it");
        undo(&mut desk);
        assert_eq!(members(&desk, "late"), Some(json!([2, 5])));
        undo(&mut desk);
        undo(&mut desk);
        assert_eq!(members(&desk, "evening"), Some(json!([2, 4, 5])));
        undo(&mut desk);
        assert_eq!(told(&desk)["groups"], before["groups"]);
        assert_eq!(told(&desk)["lamps"], before["lamps"]);
    }

    #[test]
    fn copies_and_new_lamps_bring_no_group_back() {
        let (mut desk, _) = office();
        let add = |desk: &mut Desk| {
            let lamp = json!({"kind": "point", "place": {"position": [1, 1, 1]}});
            desk.hear(1, Message { seq: 1, what: Do::Add { lamp: Box::new(lamp) } });
            desk.model.lamps.len() as u32 - 1
        };
        let first = add(&mut desk);
        desk.in_gesture(2, "Ungroup", |desk| desk.group(2, &[first], None)).unwrap();
        desk.hear(
            1,
            Message { seq: 3, what: Do::Copy { lamps: vec![first], count: 1, step: glam::Vec3::X } },
        );
        assert_eq!(told(&desk)["lamps"][(first + 1).to_string()]["group"], Value::Null);
        assert_eq!(members(&desk, "added"), None);
        let third = add(&mut desk);
        assert_eq!(members(&desk, "added"), Some(json!([third])));
    }

    #[test]
    fn groups_that_make_no_sense_are_refused() {
        let (mut desk, opened) = office();
        for (lamps, name) in
            [(vec![], Some("a")), (vec![0, 99], Some("a")), (vec![0], Some("")), (vec![99], None)]
        {
            assert!(
                desk.in_gesture(1, "Group", |desk| desk.group(1, &lamps, name.map(str::to_owned))).is_err()
            );
        }
        assert_eq!((desk.model.groups.len(), desk.history.steps()), (opened.groups.len(), 0));
    }
}
