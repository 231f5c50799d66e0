//! The images that materials look at, decoded from files, data URIs or views. One that fails is a warning: the factors
//! of its materials remain.

use super::buffers::Buffers;
use super::container::{data, file_name};
use super::json;
use super::material::images_used;
use crate::error::Result;
use crate::import::Limits;
use crate::import::files::Root;
use crate::import::image::{Gate, Source};
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::texture::Image;
use std::borrow::Cow;
use std::path::Path;

/// The scene's images, and for each of the document's which one it became.
pub(super) fn read(
    document: &json::Document,
    buffers: &Buffers<'_>,
    root: &Root,
    file: &Path,
    limits: &Limits,
    notes: &mut Notes,
) -> Result<(Vec<Image>, Vec<Option<u32>>)> {
    let used = images_used(document);
    let (indices, sources): (Vec<usize>, Vec<Source<'_>>) = document
        .images
        .iter()
        .enumerate()
        .filter(|(index, _)| used[*index])
        .map(|(index, image)| {
            let bytes = bytes(image, buffers, root, file);
            (index, Source { name: called(image, index), bytes })
        })
        .unzip();
    let decoded = Gate::new(*limits).decode(&sources).map_err(|(_, over)| over.into_error(file))?;
    let mut images = Vec::new();
    let mut numbers = vec![None; document.images.len()];
    for (index, made) in indices.into_iter().zip(decoded) {
        match made {
            Ok(image) => {
                numbers[index] = Some(images.len() as u32);
                images.push(image);
            }
            Err(why) => {
                let warning = format!("{why}; the material's factors stand for it");
                notes.warn(format!("image {index}"), &warning);
            }
        }
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
