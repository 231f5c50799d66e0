//! The text of a document: JSON of one thing a line, in an order that stays, so that versions can be compared line by line.
//! Numbers read back to the bit. What is unknown is refused rather than lost at the next saving.

use super::{Document, Edits, Entries, Reading, VERSION};
use crate::error::{Error, Result};
use crate::import::Limits;
use crate::material::glows_soundly;
use crate::scene::{Camera, Group};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use serde_json::ser::{Formatter, Serializer};
use std::io::{self, Write};
use std::path::Path;

/// Columns of text that hold a whole value of what nobody here interprets.
const WIDTH: usize = 110;

/// What of a file is looked at before everything else.
#[derive(Deserialize)]
struct Head {
    lampyris: Option<Value>,
}

/// What is read from a file: a section that is not there says nothing.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Text {
    lampyris: u32,
    scene: Reading,
    layers: Option<u32>,
    #[serde(deserialize_with = "some")]
    view: Option<Option<Camera>>,
    lights: Entries<super::LightEdit>,
    added_lights: Vec<crate::light::Light>,
    objects: Entries<super::ObjectEdit>,
    added_objects: Vec<super::Added>,
    materials: Entries<super::MaterialEdit>,
    groups: Option<Vec<Group>>,
    flux: Option<f64>,
    emitters: Option<Vec<super::Shining>>,
    desk: Value,
}

/// A null that means something.
fn some<'de, D: serde::Deserializer<'de>>(from: D) -> std::result::Result<Option<Option<Camera>>, D::Error> {
    Option::deserialize(from).map(Some)
}

impl Document {
    /// Reads a document, whose file is called so in messages.
    ///
    /// # Errors
    /// [`Error::BadInput`] for what is no document, is of a newer version, or says what is unknown or cannot be;
    /// [`Error::OverLimit`] for more lists and objects than [`Limits::nodes`], and more bytes than [`Limits::json_bytes`].
    pub fn read(file: &Path, text: &[u8], limits: &Limits) -> Result<Document> {
        let bad = |place: String, reason: String| Error::BadInput { file: file.into(), place, reason };
        let broken = |error: serde_json::Error| {
            let text = error.to_string();
            let text = text.split(" at line ").next().unwrap_or_default();
            // A message is one line of a few, whatever the file holds.
            let reason = text.chars().filter(|c| !c.is_control()).take(300).collect();
            bad(format!("line {}, column {}", error.line(), error.column()), reason)
        };
        within(file, text.len() as u64, limits)?;
        // Each takes far more memory than its two letters.
        let count = text.iter().filter(|byte| matches!(byte, b'{' | b'[')).count() as u64;
        if count > limits.nodes {
            let what = format!("the number of lists and objects, {count},");
            let place = "0".into();
            return Err(Error::OverLimit {
                file: file.into(),
                place,
                what,
                limit: limits.nodes,
                option: "--max-nodes",
            });
        }
        let start = || "line 1".to_string();
        if text.trim_ascii_start().first().is_some_and(|byte| *byte != b'{') {
            return Err(bad(start(), "this is no document of Lampyris, which begins with a brace".into()));
        }
        let head: Head = serde_json::from_slice(text).map_err(broken)?;
        match head.lampyris.as_ref().and_then(Value::as_u64) {
            None => return Err(bad(start(), "this is no document of Lampyris: it states no version".into())),
            Some(version) if version == u64::from(VERSION) => {}
            Some(0) => return Err(bad(start(), "there is no version 0".into())),
            Some(newer) => {
                let mend = "a newer Lampyris has written it and can read it";
                let reason =
                    format!("it is a document of version {newer}, and this program knows {VERSION}: {mend}");
                return Err(bad(start(), reason));
            }
        }
        let read: Text = serde_json::from_slice(text).map_err(broken)?;
        let edits = Edits {
            view: read.view,
            lights: read.lights,
            added_lights: read.added_lights,
            objects: read.objects,
            added_objects: read.added_objects,
            materials: read.materials,
            groups: read.groups,
            flux: read.flux,
            emitters: read.emitters,
        };
        edits.check().map_err(|(section, reason)| bad(format!("the section \"{section}\""), reason))?;
        let of = |scale: f32| scale > 0.0 && scale.is_finite();
        if read.scene.environment.as_ref().is_some_and(|e| !of(e.scale)) {
            return Err(bad("the section \"scene\"".into(), "the scale must be a number above 0".into()));
        }
        Ok(Document { scene: read.scene, layers: read.layers, desk: read.desk, edits })
    }

    /// Its text, as it lies in a file.
    pub fn text(&self) -> String {
        let mut text = format!("{{\n  \"lampyris\": {VERSION}");
        let mut section = |name: &str, says: bool, body: String| {
            if says {
                text.extend([",\n  \"", name, "\": ", &body]);
            }
        };
        let e = &self.edits;
        section("scene", true, lines(&self.scene, 0));
        section("layers", self.layers.is_some(), lines(&self.layers, 0));
        section("view", e.view.is_some(), lines(&e.view, 0));
        section("lights", !e.lights.0.is_empty(), lines(&e.lights, 1));
        section("added_lights", !e.added_lights.is_empty(), lines(&e.added_lights, 1));
        section("objects", !e.objects.0.is_empty(), lines(&e.objects, 1));
        section("added_objects", !e.added_objects.is_empty(), lines(&e.added_objects, 1));
        section("materials", !e.materials.0.is_empty(), lines(&e.materials, 1));
        section("groups", e.groups.is_some(), lines(&e.groups, 1));
        section("flux", e.flux.is_some(), lines(&e.flux, 0));
        section("emitters", e.emitters.is_some(), lines(&e.emitters, 1));
        section("desk", !self.desk.is_null(), fitting(&self.desk, 1));
        text + "\n}\n"
    }
}

/// Refuses a file that is too long.
pub(super) fn within(file: &Path, bytes: u64, limits: &Limits) -> Result<()> {
    let what = format!("the document's size of {bytes} bytes");
    let (limit, option) = (limits.json_bytes, "--max-json-bytes");
    let over = Error::OverLimit { file: file.into(), place: "0".into(), what, limit, option };
    if bytes > limit { Err(over) } else { Ok(()) }
}

impl Edits {
    /// What no scene could have, by section.
    fn check(&self) -> std::result::Result<(), (&'static str, String)> {
        let groups = self.groups.as_deref().unwrap_or_default();
        if groups.len() > Group::MOST {
            return Err(("groups", format!("{} groups; there are at most {}", groups.len(), Group::MOST)));
        }
        if let Some(group) = groups.iter().find(|g| !glows_soundly(g.color)) {
            return Err(("groups", format!("{:?} has a level that is not finite or too bright", group.name)));
        }
        if self.flux.is_some_and(|flux| !flux.is_finite() || flux < 0.0) {
            return Err(("flux", "it must be a number from 0".into()));
        }
        for (k, of) in self.emitters.iter().flatten().enumerate() {
            let side = of.object.is_some() || of.added_object.is_some() || of.material.is_some() || of.back;
            let whole = (of.object.is_some() != of.added_object.is_some()) && of.material.is_some();
            let kinds = [of.light.is_some(), of.added_light.is_some(), side, of.environment];
            if kinds.iter().filter(|kind| **kind).count() != 1 || (side && !whole) {
                let who = "a light, an object with a material, or the environment";
                return Err(("emitters", format!("number {k} must name {who}, and one of them")));
            }
            if !(0.0..=1.0).contains(&of.share) {
                return Err(("emitters", format!("number {k} has a share that is not between 0 and 1")));
            }
            if usize::from(of.group) >= groups.len().max(1) {
                return Err(("emitters", format!("number {k} is of group {}, which there is not", of.group)));
            }
        }
        Ok(())
    }
}

/// JSON whose outer `broken` levels have an entry a line.
fn lines(value: &impl Serialize, broken: usize) -> String {
    let mut text = Vec::new();
    let mut to = Serializer::with_formatter(&mut text, Lines { depth: 0, broken, filled: false });
    // Nothing in a document has keys that are no strings, and writing to memory does not fail.
    let written = value.serialize(&mut to).map(|()| String::from_utf8_lossy(&text).into_owned());
    written.unwrap_or_else(|_| "null".into())
}

/// How [`lines`] are set.
struct Lines {
    depth: usize,
    broken: usize,
    /// Whether the list or object that ends has anything in it.
    filled: bool,
}

impl Lines {
    fn begin(&mut self, to: &mut (impl Write + ?Sized), bracket: &str) -> io::Result<()> {
        self.depth += 1;
        self.filled = false;
        to.write_all(bracket.as_bytes())
    }

    fn end(&mut self, to: &mut (impl Write + ?Sized), bracket: &str) -> io::Result<()> {
        let breaks = self.filled && self.depth <= self.broken;
        self.depth = self.depth.saturating_sub(1);
        self.filled = true;
        let line = if breaks { indented(self.depth + 1) } else { String::new() };
        to.write_all((line + bracket).as_bytes())
    }

    fn next(&mut self, to: &mut (impl Write + ?Sized), first: bool) -> io::Result<()> {
        self.filled = true;
        let comma = if first { "" } else { "," };
        let gap = match (self.depth <= self.broken, first) {
            (true, _) => indented(self.depth + 1),
            (false, true) => String::new(),
            (false, false) => " ".into(),
        };
        to.write_all((comma.to_owned() + &gap).as_bytes())
    }
}

impl Formatter for Lines {
    fn begin_array<W: Write + ?Sized>(&mut self, to: &mut W) -> io::Result<()> {
        self.begin(to, "[")
    }

    fn end_array<W: Write + ?Sized>(&mut self, to: &mut W) -> io::Result<()> {
        self.end(to, "]")
    }

    fn begin_array_value<W: Write + ?Sized>(&mut self, to: &mut W, first: bool) -> io::Result<()> {
        self.next(to, first)
    }

    fn begin_object<W: Write + ?Sized>(&mut self, to: &mut W) -> io::Result<()> {
        self.begin(to, "{")
    }

    fn end_object<W: Write + ?Sized>(&mut self, to: &mut W) -> io::Result<()> {
        self.end(to, "}")
    }

    fn begin_object_key<W: Write + ?Sized>(&mut self, to: &mut W, first: bool) -> io::Result<()> {
        self.next(to, first)
    }

    fn begin_object_value<W: Write + ?Sized>(&mut self, to: &mut W) -> io::Result<()> {
        to.write_all(b": ")
    }
}

/// JSON that breaks what is wider than a line.
fn fitting(value: &Value, depth: usize) -> String {
    let whole = lines(value, 0);
    if whole.len() + 2 * depth <= WIDTH {
        return whole;
    }
    let (line, end) = (indented(depth + 1), indented(depth));
    match value {
        Value::Array(list) if list.iter().any(|v| v.is_array() || v.is_object()) => {
            let inside: Vec<String> = list.iter().map(|v| line.clone() + &fitting(v, depth + 1)).collect();
            format!("[{}{end}]", inside.join(","))
        }
        Value::Object(map) => {
            let entry =
                |(key, v): (&String, &Value)| format!("{line}{}: {}", lines(key, 0), fitting(v, depth + 1));
            let inside: Vec<String> = map.iter().map(entry).collect();
            format!("{{{}{end}}}", inside.join(","))
        }
        _ => whole,
    }
}

/// A new line at that depth.
fn indented(depth: usize) -> String {
    format!("\n{}", "  ".repeat(depth))
}
