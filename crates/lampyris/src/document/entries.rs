//! What is said of things by their paths: an object in JSON, in the order of the scene, that names each of them once.

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::fmt::Formatter;
use std::marker::PhantomData;

/// Paths, and what is said of each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entries<T>(pub(super) Vec<(String, T)>);

impl<T> Default for Entries<T> {
    fn default() -> Entries<T> {
        Entries(Vec::new())
    }
}

impl<T: Serialize> Serialize for Entries<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(Some(self.0.len()))?;
        self.0.iter().try_for_each(|(path, value)| map.serialize_entry(path, value))?;
        map.end()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entries<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Entries<T>, D::Error> {
        struct Reader<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Reader<T> {
            type Value = Entries<T>;

            fn expecting(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object in braces")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut from: A) -> Result<Entries<T>, A::Error> {
                let mut entries: Vec<(String, T)> = Vec::new();
                while let Some(entry) = from.next_entry()? {
                    entries.push(entry);
                }
                let mut paths: Vec<&str> = entries.iter().map(|(path, _)| path.as_str()).collect();
                paths.sort_unstable();
                match paths.windows(2).find(|two| two[0] == two[1]) {
                    Some(two) => Err(A::Error::custom(format!("{:?} stands here twice; keep one", two[0]))),
                    None => Ok(Entries(entries)),
                }
            }
        }
        from.deserialize_map(Reader(PhantomData))
    }
}
