//! What goes over the wire: messages of the page, read and bounded here, and the head of a frame. docs/wire.md says what they
//! mean.

use crate::door::Role;
use crate::patch::Patch;
use glam::Vec3;
use lampyris::scene::Camera;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The version of all this.
pub(crate) const PROTOCOL: u32 = 1;

/// Longest name or label that is taken [bytes].
pub(crate) const NAME: usize = 200;

/// From how many times its height an orthographic view is seen: lines that are parallel meet 1 % later than never.
const AWAY: f32 = 100.0;

/// Sizes of pictures that are made [pixels].
pub(crate) const LEAST: u32 = 16;
pub(crate) const MOST: u32 = 4096;

/// A message of the page.
#[derive(Clone, Debug)]
pub(crate) struct Message {
    /// It counts those of a socket.
    pub(crate) seq: u32,
    pub(crate) what: Do,
}

/// What is to be done.
#[derive(Clone, Debug)]
pub(crate) enum Do {
    Ack,
    Size { width: u32, height: u32 },
    Camera(Look),
    Ask { id: u32, question: Question },
    Begin { label: String },
    Set { patch: Box<Patch> },
    Add { lamp: Box<Value> },
    Copy { lamps: Vec<u32>, count: u32, step: Vec3 },
    Remove { lamps: Vec<u32> },
    Group { lamps: Vec<u32>, name: Option<String> },
    End { label: Option<String> },
    Cancel,
    Undo,
    Redo,
    Solo { lamps: Vec<u32> },
    Display { patch: Box<Value> },
    Expose,
    Reach { most: f32, maintenance: f64 },
    Look { id: Option<u32>, name: Option<String>, what: String, seconds: f32 },
    Save { name: Option<String> },
    Edit { take: bool },
    Links { what: String, role: Option<Role>, id: Option<u32> },
}

/// From where to look.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Look {
    pub(crate) eye: Vec3,
    pub(crate) target: Vec3,
    pub(crate) up: Vec3,
    pub(crate) fov: f32,
    /// What is seen from below to above, if not by perspective [m].
    #[serde(default)]
    pub(crate) height: Option<f32>,
    /// What is nearer is not seen [m].
    #[serde(default)]
    pub(crate) near: f32,
}

/// What may be asked.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "what", rename_all = "lowercase")]
pub(crate) enum Question {
    Point { frame: u32, x: f32, y: f32 },
    Ray { origin: Vec3, direction: Vec3 },
    Light { point: Vec3, normal: Vec3 },
    Command,
    Picture { format: String, width: u32, height: u32, batches: u32 },
}

impl Message {
    /// Reads a message; else its number, as far as it has one, and what is wrong.
    pub(crate) fn read(text: &str) -> Result<Message, (u32, String)> {
        let value: Value = serde_json::from_str(text).map_err(|e| (0, format!("this is no JSON: {e}")))?;
        let Value::Object(mut fields) = value else { return Err((0, "need an object".into())) };
        let seq = fields.remove("seq").and_then(|n| n.as_u64()).and_then(|n| u32::try_from(n).ok());
        let seq = seq.ok_or((0, "need seq, a number".to_owned()))?;
        let what = match fields.remove("do") {
            Some(Value::String(what)) => what,
            _ => return Err((seq, "need do, what is to be done".into())),
        };
        Do::read(&what, fields)
            .map(|what| Message { seq, what })
            .map_err(|why| (seq, format!("{what}: {why}")))
    }
}

impl Do {
    fn read(what: &str, mut fields: Map<String, Value>) -> Result<Do, String> {
        #[derive(Deserialize)]
        struct Size {
            width: u32,
            height: u32,
        }
        #[derive(Deserialize)]
        struct Copies {
            lamps: Vec<u32>,
            count: u32,
            step: Vec3,
        }
        #[derive(Deserialize)]
        struct Links {
            what: String,
            role: Option<Role>,
            id: Option<u32>,
        }
        #[derive(Deserialize)]
        struct ALook {
            id: Option<u32>,
            name: Option<String>,
            what: String,
            #[serde(default)]
            seconds: f32,
        }
        let done = match what {
            "ack" => Do::Ack,
            "size" => {
                let Size { width, height } = all(fields)?;
                let fits = |n: u32| (LEAST..=MOST).contains(&n);
                if !fits(width) || !fits(height) {
                    return Err(format!("a picture has {LEAST} to {MOST} pixels each way"));
                }
                Do::Size { width, height }
            }
            "camera" => {
                let look: Look = all(fields)?;
                look.check()?;
                Do::Camera(look)
            }
            "ask" => {
                let id = field(&mut fields, "id")?;
                Do::Ask { id, question: all(fields)? }
            }
            "begin" => Do::Begin { label: name(field(&mut fields, "label")?)? },
            "set" => Do::Set { patch: field(&mut fields, "patch")? },
            "add" => Do::Add { lamp: field(&mut fields, "lamp")? },
            "copy" => {
                let Copies { lamps, count, step } = all(fields)?;
                if !step.is_finite() || !(1..=100).contains(&count) {
                    return Err("need a step and 1 to 100 copies".into());
                }
                Do::Copy { lamps, count, step }
            }
            "remove" => Do::Remove { lamps: field(&mut fields, "lamps")? },
            "group" => {
                let name = text(&mut fields, "name")?;
                Do::Group { lamps: field(&mut fields, "lamps")?, name }
            }
            "end" => Do::End { label: text(&mut fields, "label")? },
            "cancel" => Do::Cancel,
            "undo" => Do::Undo,
            "redo" => Do::Redo,
            "solo" => Do::Solo { lamps: fields.remove("lamps").map_or(Ok(Vec::new()), of)? },
            "display" => Do::Display { patch: field(&mut fields, "patch")? },
            "expose" => Do::Expose,
            "reach" => {
                let most = fields.remove("most").map_or(Ok(1.0), of)?;
                if !(1.0..=10.0).contains(&most) {
                    return Err("levels may be set up to 1 to 10 times the lamps' flux".into());
                }
                let maintenance = fields.remove("maintenance").map_or(Ok(1.0), of)?;
                if !(maintenance > 0.0 && maintenance <= 1.0) {
                    return Err("a maintenance factor lies between 0 and 1".into());
                }
                Do::Reach { most, maintenance }
            }
            "look" => {
                let ALook { id, name: called, what, seconds } = all(fields)?;
                let seconds = if seconds.is_finite() { seconds.clamp(0.0, 3600.0) } else { 0.0 };
                Do::Look { id, name: called.map(name).transpose()?, what, seconds }
            }
            "save" => Do::Save { name: text(&mut fields, "name")? },
            "edit" => Do::Edit { take: field::<String>(&mut fields, "what")? == "take" },
            "links" => {
                let Links { what, role, id } = all(fields)?;
                Do::Links { what, role, id }
            }
            _ => return Err("this is not known".into()),
        };
        Ok(done)
    }
}

impl Look {
    /// The camera that the library knows.
    pub(crate) fn camera(&self) -> Camera {
        Camera { name: String::new(), eye: self.eye, target: self.target, up: self.up, fov_y: self.fov }
    }

    /// The same, seen from so far away that it is nearly orthographic, if it is to be that: [`AWAY`] times its height.
    pub(crate) fn in_perspective(self) -> Look {
        let Some(height) = self.height else { return self };
        let away = (self.target - self.eye).normalize_or_zero() * (AWAY * height);
        let fov = 2.0 * libm::atanf(0.5 / AWAY).to_degrees();
        let near = self.near + AWAY * height;
        Look { eye: self.eye - away, fov, near, height: None, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), String> {
        let far = [self.eye, self.target].iter().any(|p| p.abs().max_element() >= 1e6);
        let height = self.height.is_none_or(|h| h > 0.0 && h < 1e6);
        let near = (0.0..1e6).contains(&self.near);
        match self.camera().is_sound() && !far && height && near {
            true => Ok(()),
            false => Err("this camera looks nowhere".into()),
        }
    }
}

impl From<&Camera> for Look {
    fn from(camera: &Camera) -> Look {
        let Camera { eye, target, up, fov_y, .. } = *camera;
        Look { eye, target, up, fov: fov_y, height: None, near: 0.0 }
    }
}

fn all<T: for<'a> Deserialize<'a>>(fields: Map<String, Value>) -> Result<T, String> {
    of(Value::Object(fields))
}

fn of<T: for<'a> Deserialize<'a>>(value: Value) -> Result<T, String> {
    serde_json::from_value(value).map_err(|e| e.to_string())
}

fn field<T: for<'a> Deserialize<'a>>(fields: &mut Map<String, Value>, name: &str) -> Result<T, String> {
    of(fields.remove(name).ok_or_else(|| format!("need {name}"))?).map_err(|e| format!("{name}: {e}"))
}

/// A name, if there is one.
fn text(fields: &mut Map<String, Value>, field: &str) -> Result<Option<String>, String> {
    let named: Option<String> = fields.remove(field).map_or(Ok(None), of)?;
    named.map(name).transpose()
}

/// A name that is not too long and has no characters that are none.
pub(crate) fn name(text: String) -> Result<String, String> {
    match text.len() <= NAME && !text.chars().any(char::is_control) {
        true => Ok(text),
        false => Err(format!("a name has at most {NAME} bytes and no control characters")),
    }
}

/// What a frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Moving,
    Settled,
    Final,
}

/// The head of a frame, see docs/wire.md.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Head {
    pub(crate) number: u32,
    pub(crate) seq: u32,
    pub(crate) camera: u32,
    pub(crate) size: [u32; 2],
    pub(crate) kind: Kind,
    pub(crate) lossless: bool,
    pub(crate) false_color: bool,
    pub(crate) batches: u32,
    pub(crate) error: f32,
    /// How long its light took, and how long it took from there [s].
    pub(crate) light: f32,
    pub(crate) bytes: f32,
}

impl Head {
    pub(crate) const LENGTH: usize = 32;

    pub(crate) fn write(&self) -> [u8; Head::LENGTH] {
        let mut head = [0; Head::LENGTH];
        let mut put = |at: usize, bytes: &[u8]| head[at..at + bytes.len()].copy_from_slice(bytes);
        let tenths = |seconds: f32| (seconds * 1e4).clamp(0.0, 65535.0) as u16;
        put(0, &self.number.to_le_bytes());
        put(4, &self.seq.to_le_bytes());
        put(8, &self.camera.to_le_bytes());
        put(12, &(self.size[0] as u16).to_le_bytes());
        put(14, &(self.size[1] as u16).to_le_bytes());
        put(16, &[self.kind as u8, u8::from(self.lossless), u8::from(self.false_color), 0]);
        put(20, &self.batches.to_le_bytes());
        put(24, &self.error.to_le_bytes());
        put(28, &tenths(self.light).to_le_bytes());
        put(30, &tenths(self.bytes).to_le_bytes());
        head
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_that_make_sense() {
        let texts = [
            r#"{"do":"ack","seq":1,"frame":7}"#,
            r#"{"do":"size","seq":2,"width":640,"height":480}"#,
            r#"{"do":"camera","seq":3,"eye":[0,0,1.6],"target":[1,0,1.6],"up":[0,0,1],"fov":60}"#,
            r#"{"do":"ask","seq":4,"id":1,"what":"point","frame":7,"x":10,"y":20.5}"#,
            r#"{"do":"set","seq":5,"patch":{"lamps":{"3":{"level":0.5}}}}"#,
            r#"{"do":"solo","seq":6}"#,
            r#"{"do":"look","seq":7,"what":"store","name":"evening"}"#,
        ];
        for (seq, text) in (1..).zip(texts) {
            assert_eq!(Message::read(text).unwrap().seq, seq, "{text}");
        }
    }

    #[test]
    fn messages_that_do_not() {
        let texts = [
            "",
            "[]",
            "7",
            "{}",
            r#"{"do":"ack"}"#,
            r#"{"seq":1}"#,
            r#"{"do":"fly","seq":1}"#,
            r#"{"do":"ack","seq":-1}"#,
            r#"{"do":"size","seq":1,"width":1000000000,"height":480}"#,
            r#"{"do":"camera","seq":1,"eye":[0,0,1],"target":[0,0,1],"up":[0,0,1],"fov":60}"#,
            r#"{"do":"camera","seq":1,"eye":[1e39,0,1],"target":[0,0,1],"up":[0,0,1],"fov":60}"#,
            r#"{"do":"set","seq":1,"patch":{"lamps":{"x":{"level":0.5}}}}"#,
            r#"{"do":"set","seq":1,"patch":{"lamps":{"3":{"height":0.5}}}}"#,
            r#"{"do":"begin","seq":1,"label":"a\nb"}"#,
        ];
        for text in texts {
            assert!(Message::read(text).is_err(), "{text}");
        }
    }

    #[test]
    fn heads_are_as_documented() {
        let head = Head {
            number: 1,
            seq: 2,
            camera: 3,
            size: [640, 480],
            kind: Kind::Final,
            lossless: true,
            false_color: true,
            batches: 4,
            error: 0.5,
            light: 0.1,
            bytes: 0.01,
        };
        let bytes = head.write();
        let expected = [
            1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 128, 2, 224, 1, 2, 1, 1, 0, 4, 0, 0, 0, 0, 0, 0, 63, 232, 3,
            100, 0,
        ];
        assert_eq!(bytes, expected);
    }
}
