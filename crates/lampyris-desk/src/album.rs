//! Thumbnails of looks, each for as long as its look is as it was when it was made. They are made anew wherever there is
//! none, and so saved nowhere.

use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Width of a thumbnail, and its greatest height [pixels].
const EDGES: [u32; 2] = [96, 96];

/// Where thumbnails are asked for: the path, and the number of one.
pub(crate) const PLACE: &str = "/look/";

/// A thumbnail.
struct Photo {
    /// The look as it was.
    of: Value,
    /// No two have the same number, so nobody has an old one for a new one.
    number: u32,
    jpeg: Arc<[u8]>,
}

/// All of them, by the numbers of the looks.
#[derive(Default)]
pub(crate) struct Album {
    photos: Mutex<Photos>,
}

#[derive(Default)]
struct Photos {
    by_look: BTreeMap<u32, Photo>,
    made: u32,
}

impl Album {
    /// The first look of which there is none as it is now. Those of looks that are gone go.
    pub(crate) fn wanting(&self, looks: &BTreeMap<u32, Value>) -> Option<u32> {
        let mut photos = self.photos();
        photos.by_look.retain(|id, photo| looks.get(id).is_some_and(|look| look["patch"] == photo.of));
        looks.keys().find(|id| !photos.by_look.contains_key(id)).copied()
    }

    /// Puts one in, of a look as it is; an empty one where none can be made.
    pub(crate) fn put(&self, id: u32, look: &Value, jpeg: Vec<u8>) {
        let mut photos = self.photos();
        photos.made += 1;
        let number = photos.made;
        photos.by_look.insert(id, Photo { of: look["patch"].clone(), number, jpeg: jpeg.into() });
    }

    /// The address of that of a look; null where there is none.
    pub(crate) fn address(&self, id: u32) -> Value {
        let photos = self.photos();
        let photo = photos.by_look.get(&id).filter(|photo| !photo.jpeg.is_empty());
        photo.map_or(Value::Null, |photo| format!("{PLACE}{}", photo.number).into())
    }

    /// What is at an address.
    pub(crate) fn photo(&self, path: &str) -> Option<Arc<[u8]>> {
        let number: u32 = path.strip_prefix(PLACE)?.parse().ok()?;
        let photos = self.photos();
        let mut all = photos.by_look.values().filter(|photo| !photo.jpeg.is_empty());
        all.find(|photo| photo.number == number).map(|photo| photo.jpeg.clone())
    }

    /// There is another scene.
    pub(crate) fn clear(&self) {
        self.photos().by_look.clear();
    }

    fn photos(&self) -> MutexGuard<'_, Photos> {
        self.photos.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The size of a thumbnail of a picture of that size: never larger, and of its shape where that is no slip.
pub(crate) fn small([width, height]: [u32; 2]) -> [u32; 2] {
    let across = width.min(EDGES[0]);
    let down = u64::from(across) * u64::from(height) / u64::from(width.max(1));
    [across.max(1), (down as u32).clamp(1, EDGES[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A look has its own thumbnail, as it was last; of those that are gone none stays.
    #[test]
    fn thumbnails_go_with_their_looks() {
        let album = Album::default();
        let look = |level: f32| json!({"name": "evening", "patch": {"lamps": {"0": {"level": level}}}});
        let mut looks: BTreeMap<u32, Value> = [(3, look(0.5)), (7, look(1.0))].into();
        let wanting = |looks: &BTreeMap<u32, Value>| album.wanting(looks);
        assert_eq!(wanting(&looks), Some(3));
        album.put(3, &looks[&3], vec![1]);
        assert_eq!(wanting(&looks), Some(7));
        album.put(7, &looks[&7], vec![2]);
        assert_eq!(wanting(&looks), None);
        let address = |id: u32| album.address(id).as_str().unwrap_or_default().to_owned();
        let (first, second) = (address(3), address(7));
        assert_eq!(album.photo(&first).as_deref(), Some(&[1][..]));
        assert_eq!(album.photo(&second).as_deref(), Some(&[2][..]));
        // Called otherwise it is the same; updated it is another one.
        looks.get_mut(&3).unwrap()["name"] = "night".into();
        assert_eq!(wanting(&looks), None);
        looks.insert(3, look(0.1));
        assert_eq!(wanting(&looks), Some(3));
        assert_eq!((album.address(3), album.photo(&first)), (Value::Null, None));
        album.put(3, &looks[&3], vec![3]);
        assert!(address(3) != first && album.photo(&address(3)).as_deref() == Some(&[3][..]));
        // One that cannot be made is not tried again.
        looks.insert(9, json!({"name": "broken"}));
        album.put(9, &looks[&9], Vec::new());
        assert_eq!((wanting(&looks), album.address(9)), (None, Value::Null));
        looks.clear();
        assert_eq!(wanting(&looks), None);
        for path in [first.as_str(), &second, "/look/", "/look/-1", "/look/../etc", "/look/99999999999"] {
            assert_eq!(album.photo(path), None, "{path}");
        }
    }

    #[test]
    fn sizes_keep_the_shape() {
        assert_eq!(small([640, 480]), [96, 72]);
        assert_eq!(small([1920, 1080]), [96, 54]);
        assert_eq!(small([32, 24]), [32, 24]);
        assert_eq!(small([4096, 16]), [96, 1]);
        assert_eq!(small([16, 4096]), [16, 96]);
    }
}
