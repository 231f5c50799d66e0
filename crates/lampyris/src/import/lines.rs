//! The lines of a text file: any of the three line ends, continued by a backslash right before the line end.
//! A place in the file can be kept and returned to, which is how arrays repeat their block.
//! No word is understood here.

use std::borrow::Cow;

/// Longest line unless asked otherwise, continuations joined [bytes].
pub(super) const LINE_BYTES: usize = 1 << 20;

/// A place between two lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Place {
    /// Byte offset of the next line.
    pub(super) offset: usize,
    /// Its number less one.
    pub(super) line: u64,
}

/// A line with its continuations joined.
pub(super) struct Line<'a> {
    /// Its text.
    pub(super) text: Cow<'a, str>,
    /// Number of its first physical line, from 1.
    pub(super) number: u64,
}

/// A line that is longer than the limit, and its number.
#[derive(Debug)]
pub(super) struct TooLong(pub(super) u64);

/// The next line that is not blank from `place` on, which moves behind it; `None` at the end.
pub(super) fn next_line<'a>(
    bytes: &'a [u8],
    place: &mut Place,
    limit: usize,
) -> Result<Option<Line<'a>>, TooLong> {
    loop {
        let number = place.line + 1;
        let Some(mut part) = physical(bytes, place) else { return Ok(None) };
        let mut joined = Vec::new();
        while let [front @ .., b'\\'] = part {
            joined.extend_from_slice(front);
            joined.push(b' ');
            if joined.len() > limit {
                return Err(TooLong(number));
            }
            part = physical(bytes, place).unwrap_or_default();
        }
        if joined.len() + part.len() > limit {
            return Err(TooLong(number));
        }
        let text = if joined.is_empty() {
            String::from_utf8_lossy(part)
        } else {
            joined.extend_from_slice(part);
            Cow::Owned(String::from_utf8_lossy(&joined).into_owned())
        };
        if text.bytes().any(|b| b != b' ' && b != b'\t') {
            return Ok(Some(Line { text, number }));
        }
    }
}

/// The words of a line.
pub(super) fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split([' ', '\t']).filter(|w| !w.is_empty())
}

/// The next physical line without its end.
fn physical<'a>(bytes: &'a [u8], place: &mut Place) -> Option<&'a [u8]> {
    let rest = bytes.get(place.offset..).filter(|r| !r.is_empty())?;
    let end = rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
    let gap = match rest.get(end..) {
        Some([b'\r', b'\n', ..]) => 2,
        Some([_, ..]) => 1,
        _ => 0,
    };
    place.offset += end + gap;
    place.line += 1;
    Some(&rest[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<(u64, Vec<String>)> {
        let mut place = Place::default();
        let mut out = Vec::new();
        while let Some(line) = next_line(text.as_bytes(), &mut place, LINE_BYTES).unwrap() {
            out.push((line.number, words(&line.text).map(String::from).collect()));
        }
        out
    }

    fn line(number: u64, words: &[&str]) -> (u64, Vec<String>) {
        (number, words.iter().map(|w| w.to_string()).collect())
    }

    #[test]
    fn three_line_ends_are_the_same() {
        let want = vec![line(1, &["a", "1"]), line(3, &["b"]), line(4, &["c"])];
        for end in ["\n", "\r", "\r\n"] {
            assert_eq!(all(&["a 1", "", " \tb", "c"].join(end)), want, "{end:?}");
        }
    }

    #[test]
    fn a_backslash_before_the_line_end_joins() {
        assert_eq!(
            all("f a\\\nb \\\r\n\tc\nd\\ e\n"),
            [line(1, &["f", "a", "b", "c"]), line(4, &["d\\", "e"])]
        );
        assert_eq!(all("a\\"), [line(1, &["a"])]);
        assert_eq!(all("\\\n\\\n"), []);
    }

    #[test]
    fn lines_end_at_a_mebibyte() {
        for (bytes, good) in [(LINE_BYTES, true), (LINE_BYTES + 1, false)] {
            let text = "x".repeat(bytes);
            assert_eq!(next_line(text.as_bytes(), &mut Place::default(), LINE_BYTES).is_ok(), good);
            let joined = "x".repeat(bytes - 3) + "\\\nyy";
            assert_eq!(next_line(joined.as_bytes(), &mut Place::default(), LINE_BYTES).is_ok(), good);
        }
    }

    #[test]
    fn a_place_can_be_returned_to() {
        let text = b"a\nb\nc\n";
        let mut place = Place::default();
        next_line(text, &mut place, LINE_BYTES).unwrap();
        let kept = place;
        next_line(text, &mut place, LINE_BYTES).unwrap();
        place = kept;
        let again = next_line(text, &mut place, LINE_BYTES).unwrap().unwrap();
        assert_eq!((again.text.as_ref(), again.number), ("b", 2));
    }
}
