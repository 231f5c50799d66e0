//! Paths: by what things are called instead of by their numbers, so that a document still fits when the scene's file has
//! changed elsewhere. The second of a name is `name#2`. A name that itself ends so is written with its number, `a#2#1`, and
//! every path means one thing.

use std::collections::HashMap;

/// The names of a list.
pub(super) struct Names<'a> {
    names: Vec<&'a str>,
    /// Who has a name, in order.
    owners: HashMap<&'a str, Vec<u32>>,
}

impl<'a> Names<'a> {
    pub(super) fn new(names: impl Iterator<Item = &'a str>) -> Names<'a> {
        let names: Vec<&str> = names.collect();
        let mut owners: HashMap<&str, Vec<u32>> = HashMap::new();
        (0..).zip(&names).for_each(|(number, name)| owners.entry(name).or_default().push(number));
        Names { names, owners }
    }

    /// The path of a number; `None` for one that is not in the list.
    pub(super) fn path(&self, number: u32) -> Option<String> {
        let name = self.names.get(number as usize)?;
        let place = self.owners.get(name)?.binary_search(&number).ok()? + 1;
        let plain = place == 1 && split(name).1.is_none();
        Some(if plain { (*name).to_owned() } else { format!("{name}#{place}") })
    }

    /// The number of a path; `None` where nothing is called so.
    pub(super) fn number(&self, path: &str) -> Option<u32> {
        let (name, place) = split(path);
        self.owners.get(name)?.get(place.unwrap_or(1) - 1).copied()
    }
}

/// A name and, where it ends in one, the number behind it, from 1.
fn split(path: &str) -> (&str, Option<usize>) {
    let numbered = path.rsplit_once('#').filter(|(_, digits)| digits.bytes().all(|d| d.is_ascii_digit()));
    let number =
        |(name, digits): (&'_ str, &str)| digits.parse().ok().filter(|n| *n > 0).map(|n| (name.len(), n));
    match numbered.and_then(number) {
        Some((end, number)) => (&path[..end], Some(number)),
        None => (path, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_and_numbers_are_one_to_one() {
        let all = [
            "a",
            "b",
            "a",
            "",
            "a#2",
            "a#2",
            "",
            "#1",
            "#",
            "a#0",
            "a#2#1",
            "a#x",
            "ü/ö",
            "a#99999999999999999999",
        ];
        let names = Names::new(all.into_iter());
        let paths: Vec<String> = (0..all.len() as u32).filter_map(|n| names.path(n)).collect();
        assert_eq!(paths[..7], ["a", "b", "a#2", "", "a#2#1", "a#2#2", "#2"]);
        assert_eq!(paths.len(), all.len());
        for (number, path) in (0..).zip(&paths) {
            assert_eq!(names.number(path), Some(number), "{path}");
        }
        assert_eq!(names.path(all.len() as u32), None);
        for path in ["c", "a#3", "b#2", "a#2#3", "a#18446744073709551616"] {
            assert_eq!(names.number(path), None, "{path}");
        }
    }
}
