//! Edits in the shape of the state: of each thing the fields that shall be otherwise, in absolute values. Applied to a model
//! a patch yields the patch that takes it back, so undo is one more patch, and a gesture is its patches laid over each other.

use glam::{Quat, Vec3};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// What shall be otherwise.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Patch {
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) lamps: BTreeMap<u32, LampPatch>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) groups: BTreeMap<u32, GroupPatch>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) things: BTreeMap<u32, ThingPatch>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) materials: BTreeMap<u32, MaterialPatch>,
    /// What the page keeps and the desk only measures by; null for one that is gone.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) views: BTreeMap<u32, Option<Value>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) looks: BTreeMap<u32, Option<Value>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) meters: BTreeMap<u32, Option<Value>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) grids: BTreeMap<u32, Option<Value>>,
}

/// Fields of one kind of thing, each as it shall be or left as it is.
macro_rules! fields {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        pub(crate) struct $name {
            $($(#[$field_doc])* #[serde(skip_serializing_if = "Option::is_none")] pub(crate) $field: Option<$kind>,)*
        }

        impl $name {
            /// What it says, and where it says nothing what `older` does.
            fn over(&mut self, older: &$name) {
                $(if self.$field.is_none() { self.$field = older.$field.clone(); })*
            }
        }
    };
}

fields! {
    /// Of a lamp.
    LampPatch {
        name: String,
        on: bool,
        /// A factor on the lamp's flux.
        level: f32,
        color: ColorPatch,
        group: u32,
        /// Dark, and not traced.
        parked: bool,
        place: Place,
        /// Taken away.
        gone: bool,
    }
}

fields! {
    /// Of a colour. Each mode keeps its values.
    ColorPatch {
        mode: Mode,
        /// [K]
        kelvin: f32,
        /// Duv × 1000.
        tint: f32,
        /// Linear Rec. 709; only its hue counts.
        rgb: [f32; 3],
        /// CIE 1931.
        xy: [f32; 2],
    }
}

fields! {
    /// Where a lamp is and what it points at, as far as it has such things.
    Place {
        /// [m]
        position: Vec3,
        /// A unit vector.
        direction: Vec3,
        /// What it points at wherever it stands [m].
        aim: Vec3,
        /// [m]
        radius: f32,
        /// Whole angles of a spot's beam [degrees].
        inner: f32,
        outer: f32,
        /// Of a surface, about its middle as the file has it.
        rotation: Quat,
        scale: f32,
    }
}

fields! {
    /// Of a group of lamps.
    GroupPatch {
        name: String,
        on: bool,
        level: f32,
        gone: bool,
    }
}

fields! {
    /// Of an object.
    ThingPatch {
        place: Place,
        hidden: bool,
        locked: bool,
    }
}

fields! {
    /// Of a material.
    MaterialPatch {
        /// Linear reflectance.
        color: [f32; 3],
        roughness: f32,
        /// Reflectance of its gloss.
        specular: f32,
        /// Of glass: what passes.
        transmittance: [f32; 3],
    }
}

/// What decides a lamp's colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Mode {
    #[default]
    File,
    Kelvin,
    Rgb,
    Xy,
}

impl Patch {
    /// What it says, and where it says nothing what `older` does.
    pub(crate) fn over(&mut self, older: Patch) {
        for (id, older) in older.lamps {
            let own = self.lamps.entry(id).or_default();
            let (color, place) = (own.color.take(), own.place.take());
            own.over(&older);
            own.color = laid(color, older.color, ColorPatch::over);
            own.place = laid(place, older.place, Place::over);
        }
        for (id, older) in older.groups {
            self.groups.entry(id).or_default().over(&older);
        }
        for (id, older) in older.things {
            let own = self.things.entry(id).or_default();
            let place = own.place.take();
            own.over(&older);
            own.place = laid(place, older.place, Place::over);
        }
        for (id, older) in older.materials {
            self.materials.entry(id).or_default().over(&older);
        }
        let notes = [
            (&mut self.views, older.views),
            (&mut self.looks, older.looks),
            (&mut self.meters, older.meters),
            (&mut self.grids, older.grids),
        ];
        for (own, older) in notes {
            for (id, note) in older {
                match (own.get_mut(&id), note) {
                    (None, note) => drop(own.insert(id, note)),
                    (Some(Some(Value::Object(own))), Some(Value::Object(older))) => {
                        older.into_iter().for_each(|(name, field)| {
                            own.entry(name).or_insert(field);
                        });
                    }
                    (Some(_), _) => {}
                }
            }
        }
    }
}

/// Fields over older ones, where there are both.
fn laid<T: Clone>(own: Option<T>, older: Option<T>, over: impl Fn(&mut T, &T)) -> Option<T> {
    match (own, older) {
        (Some(mut own), Some(older)) => {
            over(&mut own, &older);
            Some(own)
        }
        (own, older) => own.or(older),
    }
}

/// Sets a field that shall be otherwise, and returns what it was.
pub(crate) fn swap<T: Clone>(own: &mut T, shall: &Option<T>) -> Option<T> {
    shall.as_ref().map(|shall| std::mem::replace(own, shall.clone()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Patch {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn the_newer_lies_over_the_older() {
        let mut new = of(r#"{"lamps":{"1":{"level":0.5,"color":{"kelvin":3000}}},"views":{"0":null}}"#);
        new.over(of(
            r#"{"lamps":{"1":{"level":1,"on":true,"color":{"kelvin":2700,"tint":1}},"2":{"on":false}},"views":{"0":{"a":1},"1":{"b":2}}}"#,
        ));
        let expected = of(
            r#"{"lamps":{"1":{"level":0.5,"on":true,"color":{"kelvin":3000,"tint":1}},"2":{"on":false}},"views":{"0":null,"1":{"b":2}}}"#,
        );
        assert_eq!(new, expected);
    }

    #[test]
    fn patches_are_written_as_they_are_read() {
        let text = r#"{"lamps":{"3":{"level":0.5,"place":{"position":[1.0,2.0,3.0]}}},"meters":{"0":null}}"#;
        assert_eq!(serde_json::to_string(&of(text)).unwrap(), text);
    }
}
