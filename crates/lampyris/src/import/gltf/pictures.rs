//! The images that materials look at, decoded from files, data URIs or views. One that fails is a warning: the factors
//! of its materials remain.

use super::buffers::Buffers;
use super::container::{data, file_name};
use super::json;
use super::material::images_used;
use crate::error::Result;
use crate::import::Limits;
use crate::import::files::Root;
use crate::import::image::{Gate, Refusal};
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::texture::Image;
use rayon::prelude::*;
use std::borrow::Cow;
use std::path::Path;

/// The scene's images, and for each of the document's which one it became. Headers are looked at one after the other, so
/// that the limits mean the same on any machine; then all cores decode.
pub(super) fn read(
    document: &json::Document,
    buffers: &Buffers<'_>,
    root: &Root,
    file: &Path,
    limits: &Limits,
    notes: &mut Notes,
) -> Result<(Vec<Image>, Vec<Option<u32>>)> {
    let used = images_used(document);
    let pairs = document.images.iter().zip(used);
    let sources: Vec<_> = pairs.map(|(i, used)| used.then(|| bytes(i, buffers, root, file))).collect();
    let mut gate = Gate::new(*limits);
    let mut admitted = Vec::with_capacity(sources.len());
    for source in &sources {
        admitted.push(match source {
            None => None,
            Some(Err(why)) => Some(Err(why.clone())),
            Some(Ok(bytes)) => match gate.admit(bytes) {
                Ok(picture) => Some(Ok(picture)),
                Err(Refusal::Unreadable(why)) => Some(Err(why)),
                Err(over) => return Err(over.into_error(file)),
            },
        });
    }
    let names = document.images.iter().enumerate().map(|(k, i)| called(i, k)).collect::<Vec<_>>();
    let decoded: Vec<_> = admitted
        .into_par_iter()
        .zip(&names)
        .map(|(picture, name)| picture.map(|p| p.and_then(|p| p.decode(name))))
        .collect();
    let mut images = Vec::new();
    let mut numbers = Vec::with_capacity(decoded.len());
    for (index, made) in decoded.into_iter().enumerate() {
        let made = made.and_then(|made| {
            let warn = |why| {
                notes.warn(format!("image {index}"), &format!("{why}; the material's factors stand for it"))
            };
            made.map_err(warn).ok()
        });
        numbers.push(made.map(|image| {
            images.push(image);
            images.len() as u32 - 1
        }));
    }
    Ok((images, numbers))
}

fn called(image: &json::Image, index: usize) -> String {
    let uri = image.uri.as_deref().filter(|u| !u.starts_with("data:"));
    image.name.as_deref().or(uri).map_or_else(|| format!("image {index}"), |n| clipped(n).to_owned())
}

/// The bytes of a picture's file.
fn bytes<'b>(
    image: &json::Image,
    buffers: &'b Buffers<'_>,
    root: &Root,
    file: &Path,
) -> std::result::Result<Cow<'b, [u8]>, String> {
    if let Some(view) = image.buffer_view {
        return Ok(Cow::Borrowed(buffers.view(view)?.0));
    }
    let uri = image.uri.as_deref().ok_or("an image without data")?;
    if let Some(bytes) = data(uri) {
        return bytes.map(Cow::Owned);
    }
    let path = root.resolve(file, &file_name(uri)?)?;
    root.read(&path).map(Cow::Owned).map_err(|e| e.to_string())
}
