//! What the values of a script must be, in the words of whoever writes one: its reader would name types of Rust.

use glam::{Vec3, Vec4};
use serde::de::{Deserialize, Deserializer, Error as _, SeqAccess, Visitor};
use serde_json::Value;
use serde_json::error::Category;
use std::fmt::Formatter;
use std::marker::PhantomData;
use std::path::PathBuf;

/// A value that `read` understands; else the error says what is needed.
fn given<'de, D: Deserializer<'de>, T>(
    from: D,
    need: &str,
    read: impl FnOnce(&Value) -> Option<T>,
) -> Result<T, D::Error> {
    let value = Value::deserialize(from)?;
    read(&value).ok_or_else(|| D::Error::custom(format!("need {need}, not {}", shown(&value))))
}

/// What stands there, briefly.
fn shown(value: &Value) -> String {
    match value {
        Value::Null => "null".into(),
        Value::Bool(_) | Value::Number(_) => value.to_string(),
        Value::String(_) => "text in quotes".into(),
        Value::Array(list) => format!("a list of {}", list.len()),
        Value::Object(_) => "an object in braces".into(),
    }
}

fn numbers<const N: usize>(value: &Value) -> Option<[f32; N]> {
    let list: Vec<f32> = value.as_array()?.iter().map(scalar).collect::<Option<_>>()?;
    list.try_into().ok()
}

fn scalar(value: &Value) -> Option<f32> {
    Some(value.as_f64()? as f32)
}

fn natural(value: &Value) -> Option<u32> {
    u32::try_from(value.as_u64()?).ok()
}

/// Null is as good as nothing.
fn unless_null<T>(value: &Value, read: impl FnOnce(&Value) -> Option<T>) -> Option<Option<T>> {
    if value.is_null() { Some(None) } else { read(value).map(Some) }
}

pub(super) fn count<'de, D: Deserializer<'de>>(from: D) -> Result<u32, D::Error> {
    given(from, "a whole number from 0 to 4294967295", natural)
}

pub(super) fn size<'de, D: Deserializer<'de>>(from: D) -> Result<(u32, u32), D::Error> {
    given(from, "width and height, as in [640, 480]", |value| match value.as_array()?.as_slice() {
        [width, height] => Some((natural(width)?, natural(height)?)),
        _ => None,
    })
}

pub(super) fn text<'de, D: Deserializer<'de>>(from: D) -> Result<String, D::Error> {
    given(from, "a name in quotes", |value| value.as_str().map(str::to_owned))
}

pub(super) fn file<'de, D: Deserializer<'de>>(from: D) -> Result<Option<PathBuf>, D::Error> {
    given(from, "a file's name in quotes", |value| {
        unless_null(value, |value| value.as_str().map(PathBuf::from))
    })
}

pub(super) fn number<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f32>, D::Error> {
    given(from, "a number", |value| unless_null(value, scalar))
}

pub(super) fn vector<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec3>, D::Error> {
    let read = |value: &Value| numbers(value).map(Vec3::from_array);
    given(from, "three numbers, as in [0.5, 0, 2]", |value| unless_null(value, read))
}

pub(super) fn turn<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec4>, D::Error> {
    let read = |value: &Value| numbers(value).map(Vec4::from_array);
    given(from, "an axis and degrees, as in [0, 0, 1, 90]", |value| unless_null(value, read))
}

/// Items one after the other, so that an error has the place of its item.
pub(super) fn list<'de, D: Deserializer<'de>, T: Deserialize<'de>>(from: D) -> Result<Vec<T>, D::Error> {
    struct List<T>(PhantomData<T>);
    impl<'de, T: Deserialize<'de>> Visitor<'de> for List<T> {
        type Value = Vec<T>;

        fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
            f.write_str("a list in brackets")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<Vec<T>, A::Error> {
            let mut items = Vec::new();
            while let Some(item) = from.next_element()? {
                items.push(item);
            }
            Ok(items)
        }
    }
    from.deserialize_seq(List(PhantomData))
}

/// What a parser's error means to whoever wrote the script, without its place.
pub(super) fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let text = text.split(" at line ").next().unwrap_or_default();
    if error.classify() == Category::Eof {
        return "the script ends too early: a quote, bracket or brace is open".into();
    }
    if error.classify() == Category::Syntax {
        return format!("{text}: not JSON; compare with the example in docs/formats.md");
    }
    let wrong = text.strip_prefix("invalid type: ").and_then(|text| text.split_once(", expected "));
    if let Some((found, need)) = wrong {
        let found = match found {
            "map" => "an object in braces",
            "sequence" => "a list in brackets",
            text if text.starts_with("string") => "text in quotes",
            other => other.rsplit(' ').next().unwrap_or(other).trim_matches('`'),
        };
        return format!("need {need}, not {found}");
    }
    if let Some(field) = text.strip_prefix("missing field ") {
        return format!("{field} is missing");
    }
    if let Some(field) = text.strip_prefix("duplicate field ") {
        return format!("{field} stands here twice; keep one");
    }
    text.replace(", expected one of", "; known are").replace(", expected", "; known is")
}

#[cfg(test)]
mod tests {
    use super::super::script::Script;
    use super::reason;

    #[test]
    fn errors_say_what_to_write() {
        let camera = |key: &str| format!(r#"{{"frames": 1, "camera": [{key}]}}"#);
        let object = |key: &str| format!(r#"{{"frames": 1, "objects": [{{"name": "a", "keys": [{key}]}}]}}"#);
        let cases = [
            (r#"{"frames": "ten"}"#.into(), "need a whole number from 0 to 4294967295, not text in quotes"),
            (r#"{"frames": 1.5}"#.into(), "need a whole number from 0 to 4294967295, not 1.5"),
            (r#"{"frames": -1}"#.into(), "need a whole number from 0 to 4294967295, not -1"),
            (r#"{"frames": 5000000000}"#.into(), "need a whole number from 0 to 4294967295, not 5000000000"),
            (r#"{"frames": null}"#.into(), "need a whole number from 0 to 4294967295, not null"),
            (r#"{"fps": 1}"#.into(), "`frames` is missing"),
            (r#"{"frames": 1, "frames": 2}"#.into(), "`frames` stands here twice; keep one"),
            (
                r#"{"frames": 1, "size": [640]}"#.into(),
                "need width and height, as in [640, 480], not a list of 1",
            ),
            (
                r#"{"frames": 1, "size": "640x480"}"#.into(),
                "need width and height, as in [640, 480], not text",
            ),
            (r#"{"frames": 1, "scene": 7}"#.into(), "need a file's name in quotes, not 7"),
            (r#"{"frames": 1, "camera": {}}"#.into(), "need a list in brackets, not an object in braces"),
            (r#"{"frames": 1, "camera": "front"}"#.into(), "need a list in brackets, not text in quotes"),
            (r#"{"frames": 1, "lights": true}"#.into(), "need a list in brackets, not true"),
            (
                r#"{"frames": 1, "lights": [3]}"#.into(),
                "need a track in braces, of \"name\" and \"keys\", not 3",
            ),
            (r#"{"frames": 1, "lights": [{"name": 3}]}"#.into(), "need a name in quotes, not 3"),
            (camera("0"), "need a key in braces, as in { \"frame\": 0 }, not 0"),
            (camera("\"eye\""), "need a key in braces, as in { \"frame\": 0 }, not text in quotes"),
            (camera("{}"), "`frame` is missing"),
            (
                camera(r#"{"frame": 0, "eye": [1, 2]}"#),
                "need three numbers, as in [0.5, 0, 2], not a list of 2",
            ),
            (
                camera(r#"{"frame": 0, "eye": [1, 2, "3"]}"#),
                "need three numbers, as in [0.5, 0, 2], not a list of 3",
            ),
            (camera(r#"{"frame": 0, "fov": "wide"}"#), "need a number, not text in quotes"),
            (
                camera(r#"{"frame": 0, "zoom": 2}"#),
                "unknown field `zoom`; known are `frame`, `eye`, `target`",
            ),
            (object(r#"{"frame": 0, "turn": 90}"#), "need an axis and degrees, as in [0, 0, 1, 90], not 90"),
            (
                object(r#"{"frame": 0, "move": {"x": 1}}"#),
                "need three numbers, as in [0.5, 0, 2], not an object",
            ),
            ("7".into(), "need a script in braces, as in { \"frames\": 60 }, not 7"),
            (r#"{"frames": 1"#.into(), "the script ends too early: a quote, bracket or brace is open"),
            (
                r#"{"frames": 1, "scene": "a"#.into(),
                "the script ends too early: a quote, bracket or brace is open",
            ),
            (
                r#"{"frames": 1,}"#.into(),
                "trailing comma: not JSON; compare with the example in docs/formats.md",
            ),
            ("frames = 1".into(), "not JSON"),
        ];
        for (script, words) in cases {
            let error = serde_json::from_str::<Script>(&script).unwrap_err();
            let said = reason(&error);
            assert!(
                said.starts_with(words) || (words == "not JSON" && said.contains(words)),
                "{script}: {said}"
            );
            assert!(error.line() == 1 && error.column() > 0, "{script}: {error}");
            let jargon = ["u32", "f32", "usize", "struct", "sequence", "map", "tuple", "Script", "invalid"];
            assert!(!jargon.iter().any(|word| said.contains(word)), "{script}: {said}");
        }
    }

    #[test]
    fn null_is_as_good_as_nothing() {
        let text = r#"{"frames": 1, "scene": null, "camera": [{"frame": 0, "eye": null, "fov": null}]}"#;
        let script: Script = serde_json::from_str(text).unwrap();
        assert_eq!((script.scene, script.camera[0].eye, script.camera[0].fov), (None, None, None));
    }
}
