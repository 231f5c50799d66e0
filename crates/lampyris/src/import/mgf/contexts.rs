//! A named context of MGF: the table of everything named so far, and the entry that field entities edit.
//! Selecting follows the four forms `k`, `k id`, `k id =`, `k id = template`; readers take values by copy.

use super::args::Reason;
use crate::import::report::quote;
use std::collections::HashMap;
use std::rc::Rc;

/// The contexts of one kind.
pub(super) struct Contexts<T> {
    kind: &'static str,
    names: HashMap<Rc<str>, usize>,
    /// Name and value in the order of their first definition; entry 0 is the one without a name.
    entries: Vec<(Rc<str>, T)>,
    current: usize,
}

impl<T: Clone + Default> Contexts<T> {
    /// Only the unnamed context, with its defaults.
    pub(super) fn new(kind: &'static str) -> Contexts<T> {
        Contexts { kind, names: HashMap::new(), entries: vec![("".into(), T::default())], current: 0 }
    }

    /// Makes a context the current one by the words after its keyword.
    pub(super) fn select(&mut self, words: &[&str]) -> Reason<()> {
        match words {
            [] => {
                self.entries[0].1 = T::default();
                self.current = 0;
            }
            [name] => self.current = self.find(name)?,
            [name, "="] => self.define(name, T::default()),
            [name, "=", template] => {
                let value = self.entries[self.find(template)?].1.clone();
                self.define(name, value);
            }
            _ => {
                return Err(format!(
                    "write \"{0}\", \"{0} id\", \"{0} id =\" or \"{0} id = template\"",
                    self.kind
                ));
            }
        }
        Ok(())
    }

    /// The context called `name`.
    pub(super) fn get(&self, name: &str) -> Reason<&T> {
        Ok(&self.entries[self.find(name)?].1)
    }

    /// The current context.
    pub(super) fn current(&self) -> &T {
        &self.entries[self.current].1
    }

    /// The current context, to be edited.
    pub(super) fn current_mut(&mut self) -> &mut T {
        &mut self.entries[self.current].1
    }

    /// The current context's name; empty for the unnamed one.
    pub(super) fn current_name(&self) -> &Rc<str> {
        &self.entries[self.current].0
    }

    /// Every named context in the order of its first definition.
    pub(super) fn named(&self) -> impl Iterator<Item = (&Rc<str>, &T)> {
        self.entries[1..].iter().map(|(name, value)| (name, value))
    }

    fn find(&self, name: &str) -> Reason<usize> {
        let found = self.names.get(name).copied();
        found.ok_or_else(|| format!("{} {} is not defined before this line", self.kind, quote(name)))
    }

    fn define(&mut self, name: &str, value: T) {
        match self.names.get(name) {
            Some(&i) => {
                self.current = i;
                self.entries[i].1 = value;
            }
            None => {
                let name: Rc<str> = name.into();
                self.current = self.entries.len();
                self.names.insert(name.clone(), self.current);
                self.entries.push((name, value));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_four_forms() {
        let mut c = Contexts::<i32>::new("color");
        *c.current_mut() = 5;
        c.select(&["a", "="]).unwrap();
        *c.current_mut() = 1;
        c.select(&["b", "=", "a"]).unwrap();
        assert_eq!(*c.current(), 1);
        *c.current_mut() = 2;
        c.select(&["a"]).unwrap();
        assert_eq!((*c.current(), *c.get("b").unwrap()), (1, 2));
        c.select(&[]).unwrap();
        assert_eq!(*c.current(), 0, "the unnamed context forgets");
        c.select(&["a", "=", "a"]).unwrap();
        assert_eq!(*c.current(), 1);
        c.select(&["a", "="]).unwrap();
        assert_eq!((*c.current(), c.named().count()), (0, 2));
    }

    #[test]
    fn what_is_not_defined_is_an_error() {
        let mut c = Contexts::<i32>::new("color");
        for words in [&["x"][..], &["y", "=", "x"], &["a", "b"], &["a", "=", "b", "c"]] {
            assert!(c.select(words).is_err(), "{words:?}");
        }
        assert_eq!(c.named().count(), 0);
    }
}
