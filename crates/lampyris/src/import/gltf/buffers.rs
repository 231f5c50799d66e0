//! The bytes that a document names: its buffers, and views of them. Each file is read once, however often it is named.

use super::container::{data, file_name};
use super::json;
use super::meshopt;
use crate::import::files::Root;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// A buffer's bytes, wherever they are.
#[derive(Clone)]
enum Bytes<'a> {
    Chunk(&'a [u8]),
    File(Rc<Vec<u8>>),
}

impl Bytes<'_> {
    fn get(&self) -> &[u8] {
        match self {
            Bytes::Chunk(bytes) => bytes,
            Bytes::File(bytes) => bytes,
        }
    }
}

/// Every buffer, or why it cannot be had; and the views.
pub(super) struct Buffers<'a> {
    buffers: Vec<Result<Bytes<'a>, String>>,
    views: &'a [json::BufferView],
    /// Views that were packed, or why they are not there.
    unpacked: HashMap<u32, Result<Vec<u8>, String>>,
}

/// Bytes that packed views may become in all, for each byte of all buffers; real ones have less than ten.
const UNPACKED: u64 = 32;

impl<'a> Buffers<'a> {
    /// Reads the buffers that any view looks at.
    pub(super) fn open(
        document: &'a json::Document,
        binary: Option<&'a [u8]>,
        root: &Root,
        file: &Path,
    ) -> Buffers<'a> {
        let mut wanted = vec![false; document.buffers.len()];
        for view in &document.buffer_views {
            let packed = view.extensions.as_ref().and_then(|e| e.meshopt.as_ref()).map(|m| m.buffer);
            for k in [Some(view.buffer), packed].into_iter().flatten() {
                if let Some(w) = wanted.get_mut(k as usize) {
                    *w = true;
                }
            }
        }
        let mut files: HashMap<PathBuf, Rc<Vec<u8>>> = HashMap::new();
        let mut open = |(k, buffer): (usize, &json::Buffer)| -> Result<Bytes<'a>, String> {
            let Some(uri) = buffer.uri.as_deref() else {
                let chunk = binary.filter(|_| k == 0);
                return chunk.map(Bytes::Chunk).ok_or_else(|| format!("buffer {k} has no data"));
            };
            if let Some(bytes) = data(uri) {
                return bytes.map(|b| Bytes::File(Rc::new(b))).map_err(|e| format!("buffer {k}: {e}"));
            }
            let path = root.resolve(file, &file_name(uri)?)?;
            if let Some(bytes) = files.get(&path) {
                return Ok(Bytes::File(bytes.clone()));
            }
            let bytes = Rc::new(root.read(&path).map_err(|e| e.to_string())?);
            files.insert(path, bytes.clone());
            Ok(Bytes::File(bytes))
        };
        let unused = |k| Err(format!("buffer {k} was not read"));
        let pairs = document.buffers.iter().enumerate().zip(wanted);
        let buffers = pairs.map(|(b, wanted)| if wanted { open(b) } else { unused(b.0) }).collect();
        let mut all = Buffers { buffers, views: &document.buffer_views, unpacked: HashMap::new() };
        all.unpack();
        all
    }

    /// Unpacks each packed view once, before it is known how often it will be asked for.
    fn unpack(&mut self) {
        let there: u64 = self.buffers.iter().flatten().map(|b| b.get().len() as u64).sum();
        let mut left = there.saturating_mul(UNPACKED);
        for (k, view) in (0..).zip(self.views) {
            let Some(packed) = view.extensions.as_ref().and_then(|e| e.meshopt.as_ref()) else { continue };
            let size = packed.count.saturating_mul(u64::from(packed.byte_stride));
            let made = match left.checked_sub(size) {
                Some(rest) => {
                    left = rest;
                    self.slice(packed.buffer, packed.byte_offset, packed.byte_length)
                        .and_then(|source| meshopt::decode(packed, source))
                }
                None => {
                    Err(format!("unpacked views have more than {UNPACKED} times the bytes of the buffers"))
                }
            };
            self.unpacked.insert(k, made.map_err(|e| format!("bufferView {k}: {e}")));
        }
    }

    /// The bytes of a view, and the distance of its elements if it says so.
    pub(super) fn view(&self, index: u32) -> Result<(&[u8], Option<usize>), String> {
        let view = self.views.get(index as usize).ok_or_else(|| format!("there is no bufferView {index}"))?;
        let bytes = match self.unpacked.get(&index) {
            Some(made) => made.as_deref().map_err(String::clone)?,
            None => self
                .slice(view.buffer, view.byte_offset, view.byte_length)
                .map_err(|e| format!("bufferView {index}: {e}"))?,
        };
        Ok((bytes, view.byte_stride.map(|s| s as usize)))
    }

    fn slice(&self, buffer: u32, offset: u64, length: u64) -> Result<&[u8], String> {
        let bytes = match self.buffers.get(buffer as usize) {
            Some(Ok(bytes)) => bytes.get(),
            Some(Err(why)) => return Err(why.clone()),
            None => return Err(format!("there is no buffer {buffer}")),
        };
        let end = offset.checked_add(length).and_then(|e| usize::try_from(e).ok());
        let range = end.and_then(|end| bytes.get(offset as usize..end));
        range.ok_or_else(|| {
            let there = bytes.len();
            format!("{length} bytes at {offset} reach beyond buffer {buffer}, which has {there}")
        })
    }
}
