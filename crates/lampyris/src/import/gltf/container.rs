//! From a file's bytes to the two parts of a GLB, or to plain JSON; and the two kinds of names that buffers have.

/// JSON, and the binary chunk if there is one.
#[derive(Debug, PartialEq)]
pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    pub(super) binary: Option<&'a [u8]>,
}

/// What is wrong, and at which offset.
pub(super) type Fault = (usize, String);

const JSON: &[u8] = b"JSON";
const BINARY: &[u8] = b"BIN\0";

/// Splits a file; one that does not begin with GLB's magic word is all JSON.
pub(super) fn split(bytes: &[u8]) -> Result<Parts<'_>, Fault> {
    if !bytes.starts_with(b"glTF") {
        // The mark of byte order says nothing in UTF-8.
        let json = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        return Ok(Parts { json, binary: None });
    }
    let version = word(bytes, 4).ok_or((4, "the header is cut off".to_string()))?;
    if version != 2 {
        return Err((4, format!("version {version} of the container; version 2 is what is read")));
    }
    let length = word(bytes, 8).ok_or((8, "the header is cut off".to_string()))? as usize;
    let bytes = bytes.get(..length).ok_or_else(|| {
        let there = bytes.len();
        (8, format!("the file should have {length} bytes and has {there}: it is cut off"))
    })?;
    let (json, rest) = chunk(bytes, 12)?.ok_or((12, "there is no chunk of JSON".to_string()))?;
    if json.kind != JSON {
        return Err((12, "the first chunk is not JSON".into()));
    }
    let binary = chunk(bytes, rest)?.map(|(c, _)| c).filter(|c| c.kind == BINARY).map(|c| c.data);
    Ok(Parts { json: json.data, binary })
}

struct Chunk<'a> {
    kind: &'a [u8],
    data: &'a [u8],
}

/// The chunk at `at` and where the next one begins; `None` at the end.
fn chunk(bytes: &[u8], at: usize) -> Result<Option<(Chunk<'_>, usize)>, Fault> {
    if at >= bytes.len() {
        return Ok(None);
    }
    let cut = || (at, "a chunk is cut off".to_string());
    let length = word(bytes, at).ok_or_else(cut)? as usize;
    let start = at + 8;
    let end = start.checked_add(length).ok_or_else(cut)?;
    let kind = bytes.get(at + 4..start).ok_or_else(cut)?;
    let data = bytes.get(start..end).ok_or_else(cut)?;
    Ok(Some((Chunk { kind, data }, end)))
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let four = bytes.get(at..at.checked_add(4)?)?;
    four.try_into().ok().map(u32::from_le_bytes)
}

/// The bytes of a `data:` name; `None` if it is another kind of name.
pub(super) fn data(uri: &str) -> Option<Result<Vec<u8>, String>> {
    let rest = uri.strip_prefix("data:")?;
    Some(match rest.split_once(',') {
        Some((kind, text)) if kind.ends_with(";base64") => base64(text.as_bytes()),
        Some((_, text)) => Ok(unescaped(text)),
        None => Err("a data URI without a comma".into()),
    })
}

/// The file name that a relative URI means.
pub(super) fn file_name(uri: &str) -> Result<String, String> {
    String::from_utf8(unescaped(uri)).map_err(|_| "a file name that is not UTF-8".into())
}

/// `%41` is `A`; what is no such code stays.
fn unescaped(text: &str) -> Vec<u8> {
    let bytes = text.as_bytes();
    let hex = |at: usize| bytes.get(at).and_then(|&b| char::from(b).to_digit(16));
    let mut out = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        match (byte, hex(at + 1), hex(at + 2)) {
            (b'%', Some(high), Some(low)) => {
                out.push((high * 16 + low) as u8);
                at += 3;
            }
            _ => {
                out.push(byte);
                at += 1;
            }
        }
    }
    out
}

/// RFC 4648, with or without padding.
fn base64(text: &[u8]) -> Result<Vec<u8>, String> {
    let end = text.iter().rposition(|&b| b != b'=').map_or(0, |last| last + 1);
    let mut out = Vec::with_capacity(end / 4 * 3 + 2);
    let (mut bits, mut held) = (0u32, 0u32);
    for &byte in &text[..end] {
        let value = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return Err("a character that is not base64".into()),
        };
        bits = (bits << 6) | u32::from(value);
        held += 6;
        if held >= 8 {
            held -= 8;
            out.push((bits >> held) as u8);
        }
    }
    if end % 4 == 1 { Err("base64 that ends within a byte".into()) } else { Ok(out) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_follows_the_vectors_of_its_standard() {
        let vectors = [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg==", "foob"),
            ("Zm9vYmFy", "foobar"),
        ];
        for (text, want) in vectors {
            assert_eq!(base64(text.as_bytes()).unwrap(), want.as_bytes());
            assert_eq!(base64(text.trim_end_matches('=').as_bytes()).unwrap(), want.as_bytes());
        }
        for bad in ["Z", "Zg=v", "Z g=", "Zm9vY", "\u{e4}"] {
            assert!(base64(bad.as_bytes()).is_err(), "{bad}");
        }
    }

    #[test]
    fn names_are_unescaped_once() {
        assert_eq!(file_name("a%20b%2Fc").unwrap(), "a b/c");
        assert_eq!(file_name("100%").unwrap(), "100%");
        assert_eq!(file_name("%2541").unwrap(), "%41");
        assert!(file_name("%FF").is_err());
        assert_eq!(data("data:application/octet-stream;base64,AQI=").unwrap().unwrap(), [1, 2]);
        assert!(data("box.bin").is_none());
    }

    #[test]
    fn a_container_is_cut_at_its_lengths() {
        let glb = b"glTF\x02\0\0\0\x20\0\0\0\x04\0\0\0JSON{}  \x00\0\0\0BIN\0";
        let parts = split(glb).unwrap();
        assert_eq!(parts, Parts { json: b"{}  ", binary: Some(b"") });
        for end in 4..glb.len() {
            assert!(split(&glb[..end]).is_err(), "{end}");
        }
        assert_eq!(split(b"\xEF\xBB\xBF{}").unwrap().json, b"{}");
    }
}
