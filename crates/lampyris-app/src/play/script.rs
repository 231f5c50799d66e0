//! The script of a walkthrough: JSON in, checked numbers out, and what holds at each frame.
//!
//! Between keys values run straight, before the first and after the last they stay. A key may leave out what it does not
//! set: then that runs on between its neighbours that do.

use super::json;
use glam::{Vec3, Vec4};
use lampyris::{Error, Result};
use serde::Deserialize;
use std::io::Read;
use std::path::{Path, PathBuf};

/// What a script may ask for.
const BYTES: u64 = 1 << 24;
const FRAMES: u32 = 100_000;
const KEYS: usize = 10_000;
const FASTEST: u32 = 1000;
/// Batches in a window.
pub(crate) const WINDOW: u32 = 64;
/// Largest coordinate [m], angle [°] or factor: sums of several stay finite.
const LARGEST: f32 = 1e9;

/// A walkthrough.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a script in braces, as in { \"frames\": 60 }")]
pub(crate) struct Script {
    /// File of the scene, from the script's folder.
    #[serde(default, deserialize_with = "json::file")]
    pub(crate) scene: Option<PathBuf>,
    /// Width and height [pixels].
    #[serde(default = "usual_size", deserialize_with = "json::size")]
    pub(crate) size: (u32, u32),
    /// Frames a second, for films.
    #[serde(default = "usual_rate", deserialize_with = "json::count")]
    pub(crate) fps: u32,
    #[serde(deserialize_with = "json::count")]
    pub(crate) frames: u32,
    /// Batches of which a frame is the mean while lights and objects move.
    #[serde(default = "usual_window", deserialize_with = "json::count")]
    pub(crate) window: u32,
    #[serde(default, deserialize_with = "json::list")]
    pub(crate) camera: Vec<CameraKey>,
    #[serde(default, deserialize_with = "json::list")]
    pub(crate) lights: Vec<Track<LightKey>>,
    #[serde(default, deserialize_with = "json::list")]
    pub(crate) objects: Vec<Track<ObjectKey>>,
}

/// The keys of something that has a name.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a track in braces, of \"name\" and \"keys\"")]
#[serde(bound(deserialize = "K: Deserialize<'de>"))]
pub(crate) struct Track<K> {
    #[serde(deserialize_with = "json::text")]
    pub(crate) name: String,
    #[serde(deserialize_with = "json::list")]
    pub(crate) keys: Vec<K>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a key in braces, as in { \"frame\": 0 }")]
pub(crate) struct CameraKey {
    #[serde(deserialize_with = "json::count")]
    frame: u32,
    #[serde(default, deserialize_with = "json::vector")]
    pub(crate) eye: Option<Vec3>,
    #[serde(default, deserialize_with = "json::vector")]
    pub(crate) target: Option<Vec3>,
    #[serde(default, deserialize_with = "json::vector")]
    pub(crate) up: Option<Vec3>,
    /// Vertical [degrees].
    #[serde(default, deserialize_with = "json::number")]
    pub(crate) fov: Option<f32>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a key in braces, as in { \"frame\": 0 }")]
pub(crate) struct LightKey {
    #[serde(deserialize_with = "json::count")]
    frame: u32,
    /// Where a light that is no surface is [m].
    #[serde(default, deserialize_with = "json::vector")]
    pub(crate) position: Option<Vec3>,
    /// Factor on what the file says.
    #[serde(default, deserialize_with = "json::number")]
    pub(crate) power: Option<f32>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a key in braces, as in { \"frame\": 0 }")]
pub(crate) struct ObjectKey {
    #[serde(deserialize_with = "json::count")]
    frame: u32,
    /// Away from where the file has it [m].
    #[serde(rename = "move", default, deserialize_with = "json::vector")]
    pub(crate) shift: Option<Vec3>,
    /// Axis, and degrees about it through the middle of the object.
    #[serde(default, deserialize_with = "json::turn")]
    pub(crate) turn: Option<Vec4>,
    /// Factor about the middle of the object.
    #[serde(default, deserialize_with = "json::number")]
    pub(crate) scale: Option<f32>,
}

fn usual_size() -> (u32, u32) {
    (640, 480)
}

fn usual_rate() -> u32 {
    25
}

fn usual_window() -> u32 {
    1
}

/// A key of any kind.
pub(crate) trait Key {
    /// When it holds.
    fn frame(&self) -> u32;
    /// Every number that it sets.
    fn numbers(&self) -> Vec<f32>;
    /// What is wrong with a number, if anything is.
    fn fault(&self) -> Option<&'static str>;
}

impl Key for CameraKey {
    fn frame(&self) -> u32 {
        self.frame
    }

    fn numbers(&self) -> Vec<f32> {
        [self.eye, self.target, self.up].iter().flatten().flat_map(Vec3::to_array).chain(self.fov).collect()
    }

    fn fault(&self) -> Option<&'static str> {
        self.fov.filter(|fov| !(*fov > 0.0 && *fov < 179.0)).map(|_| "fov must be within 0 and 179 degrees")
    }
}

impl Key for LightKey {
    fn frame(&self) -> u32 {
        self.frame
    }

    fn numbers(&self) -> Vec<f32> {
        self.position.iter().flat_map(Vec3::to_array).chain(self.power).collect()
    }

    fn fault(&self) -> Option<&'static str> {
        self.power.filter(|power| *power < 0.0).map(|_| "power must not be negative")
    }
}

impl Key for ObjectKey {
    fn frame(&self) -> u32 {
        self.frame
    }

    fn numbers(&self) -> Vec<f32> {
        let vectors =
            self.shift.iter().flat_map(Vec3::to_array).chain(self.turn.iter().flat_map(Vec4::to_array));
        vectors.chain(self.scale).collect()
    }

    fn fault(&self) -> Option<&'static str> {
        if self.scale.is_some_and(|scale| scale <= 0.0) {
            return Some("scale must be more than 0");
        }
        let axis = self.turn.map_or(Vec3::X, Vec4::truncate);
        axis.try_normalize()
            .is_none()
            .then_some("turn must be an axis, three numbers of which one is not 0, and degrees")
    }
}

/// What a value is at a frame; `None` where no key sets it.
pub(crate) fn at<K: Key, V>(keys: &[K], frame: u32, value: impl Fn(&K) -> Option<V>) -> Option<V>
where
    V: Copy + std::ops::Mul<f32, Output = V> + std::ops::Add<Output = V>,
{
    let set = || keys.iter().filter_map(|key| Some((key.frame(), value(key)?)));
    let before = set().take_while(|(k, _)| *k <= frame).last();
    let after = set().find(|(k, _)| *k > frame);
    match (before, after) {
        (Some((first, a)), Some((last, b))) if first < frame => {
            let share = (frame - first) as f32 / (last - first) as f32;
            Some(a * (1.0 - share) + b * share)
        }
        (Some((_, value)), _) | (None, Some((_, value))) => Some(value),
        (None, None) => None,
    }
}

impl Script {
    /// Reads and checks a script.
    ///
    /// # Errors
    /// [`Error::CannotRead`], and [`Error::BadInput`] with the place and the mend.
    pub(crate) fn read(file: &Path) -> Result<Script> {
        let cannot = |e: std::io::Error| Error::CannotRead { file: file.into(), reason: e.to_string() };
        let mut text = Vec::new();
        std::fs::File::open(file).and_then(|f| f.take(BYTES + 1).read_to_end(&mut text)).map_err(cannot)?;
        let bad = |place: String, reason: String| Error::BadInput { file: file.into(), place, reason };
        if text.len() as u64 > BYTES {
            return Err(bad("end".into(), format!("a script of more than {BYTES} bytes; use fewer keys")));
        }
        let script: Script = serde_json::from_slice(&text)
            .map_err(|e| bad(format!("line {} column {}", e.line(), e.column()), json::reason(&e)))?;
        script.check().map_err(|(place, reason)| bad(place, reason))?;
        Ok(script)
    }

    /// Place and mend of the first thing that makes no sense.
    fn check(&self) -> std::result::Result<(), (String, String)> {
        let need =
            |fits: bool, place: &str, mend: String| if fits { Ok(()) } else { Err((place.into(), mend)) };
        let (width, height) = self.size;
        let pixels = crate::parse::PIXELS;
        let fits = width > 0 && height > 0 && u64::from(width) * u64::from(height) <= pixels;
        need(fits, "size", format!("need at least 1 x 1 and at most {pixels} pixels"))?;
        need((1..=FRAMES).contains(&self.frames), "frames", format!("need 1 to {FRAMES}"))?;
        need((1..=FASTEST).contains(&self.fps), "fps", format!("need 1 to {FASTEST}"))?;
        need((1..=WINDOW).contains(&self.window), "window", format!("need 1 to {WINDOW}"))?;
        let tracks =
            self.lights.iter().map(|t| t.keys.len()).chain(self.objects.iter().map(|t| t.keys.len()));
        let keys = tracks.sum::<usize>() + self.camera.len();
        let tracks = self.lights.len() + self.objects.len();
        need(keys <= KEYS && tracks <= KEYS, "script", format!("need at most {KEYS} keys in all"))?;
        check_keys("camera", &self.camera)?;
        for (k, track) in self.lights.iter().enumerate() {
            check_keys(&format!("lights[{k}].keys"), &track.keys)?;
        }
        for (k, track) in self.objects.iter().enumerate() {
            check_keys(&format!("objects[{k}].keys"), &track.keys)?;
        }
        Ok(())
    }
}

fn check_keys<K: Key>(list: &str, keys: &[K]) -> std::result::Result<(), (String, String)> {
    let mut last = None;
    for (k, key) in keys.iter().enumerate() {
        let place = format!("{list}[{k}]");
        if !key.numbers().iter().all(|n| n.abs() <= LARGEST) {
            return Err((place, format!("need numbers from -{LARGEST} to {LARGEST}")));
        }
        if let Some(fault) = key.fault() {
            return Err((place, fault.into()));
        }
        if key.frame() > FRAMES || last.is_some_and(|last| key.frame() <= last) {
            return Err((
                place,
                format!("need keys in the order of their frames, each once and up to {FRAMES}"),
            ));
        }
        last = Some(key.frame());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(frame: u32, eye: Option<Vec3>, fov: Option<f32>) -> CameraKey {
        CameraKey { frame, eye, target: None, up: None, fov }
    }

    #[test]
    fn values_run_straight_between_the_keys_that_set_them() {
        let keys = [
            key(2, Some(Vec3::ZERO), Some(40.0)),
            key(4, None, Some(50.0)),
            key(6, Some(Vec3::splat(8.0)), None),
        ];
        let fov = |frame| at(&keys, frame, |k| k.fov).unwrap();
        assert_eq!([0, 2, 3, 4, 5, 9].map(fov), [40.0, 40.0, 45.0, 50.0, 50.0, 50.0]);
        let eye = |frame| at(&keys, frame, |k| k.eye).unwrap().x;
        assert_eq!([0, 2, 3, 4, 5, 6, 9].map(eye), [0.0, 0.0, 2.0, 4.0, 6.0, 8.0, 8.0]);
        assert_eq!(at(&keys, 3, |k| k.up), None);
    }
}
