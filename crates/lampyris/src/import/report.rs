//! Warnings gathered while a file is read: one for each kind, with its first place and its count.
//! The number of kinds kept is bounded, since a hostile file could make each of its lines a kind of its own.
//! Nothing is printed here.

use std::collections::HashMap;

/// Kinds of warnings that are told apart; later ones are only counted.
const KINDS: usize = 100;

/// Longest piece of a file's text that a message repeats [characters].
const QUOTED: usize = 40;

/// The warnings so far, in the order of their first appearance.
#[derive(Default)]
pub(super) struct Report {
    kinds: Vec<(String, String, u64)>,
    index: HashMap<String, usize>,
    others: u64,
}

impl Report {
    /// Notes one occurrence of `kind` at `place` (`file:line`, made only for the first of a kind).
    pub(super) fn warn(&mut self, kind: &str, place: impl FnOnce() -> String) {
        if let Some(&i) = self.index.get(kind) {
            self.kinds[i].2 += 1;
        } else if self.kinds.len() < KINDS {
            self.index.insert(kind.into(), self.kinds.len());
            self.kinds.push((place(), kind.into(), 1));
        } else {
            self.others += 1;
        }
    }

    /// One line a kind.
    pub(super) fn into_lines(self) -> Vec<String> {
        let line = |(place, kind, count): (String, String, u64)| match count {
            1 => format!("{place}: {kind}"),
            _ => format!("{place}: {kind} ({count} times)"),
        };
        let mut lines: Vec<_> = self.kinds.into_iter().map(line).collect();
        if self.others > 0 {
            lines.push(format!("{} more warnings of other kinds", self.others));
        }
        lines
    }
}

/// `text` in quotes as a message may show it: at most 40 characters, all of them printable ASCII.
///
/// A message must not become a way to read a file that happens to be no scene at all.
pub(super) fn quote(text: &str) -> String {
    let shown: String =
        text.chars().take(QUOTED).map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect();
    let more = if text.chars().nth(QUOTED).is_some() { "…" } else { "" };
    format!("\"{shown}{more}\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_counted_with_their_first_place() {
        let mut report = Report::default();
        for line in 3..6 {
            report.warn("odd", || format!("a.mgf:line {line}"));
        }
        report.warn("other", || "b".into());
        assert_eq!(report.into_lines(), ["a.mgf:line 3: odd (3 times)", "b: other"]);
    }

    #[test]
    fn a_flood_of_kinds_is_bounded() {
        let mut report = Report::default();
        for kind in 0..100_000 {
            report.warn(&kind.to_string(), String::new);
        }
        let lines = report.into_lines();
        assert_eq!((lines.len(), lines[KINDS].as_str()), (KINDS + 1, "99900 more warnings of other kinds"));
    }

    #[test]
    fn quotes_are_short_and_printable() {
        assert_eq!(quote("plain"), "\"plain\"");
        assert_eq!(quote("a\u{1b}[31mé"), "\"a?[31m?\"");
        assert_eq!(quote(&"x".repeat(41)), format!("\"{}…\"", "x".repeat(40)));
        assert_eq!(quote(&"x".repeat(40)), format!("\"{}\"", "x".repeat(40)));
    }
}
