//! The images that materials look at, decoded from files, data URIs or views. One that fails is a warning: the factors
//! of its materials remain.

use super::buffers::Buffers;
use super::container::{data, file_name};
use super::json;
use super::material::images_used;
use crate::import::files::Root;
use crate::import::images::decode;
use crate::import::name::clipped;
use crate::import::notes::Notes;
use crate::texture::Image;
use std::path::Path;

/// The scene's images, and for each of the document's which one it became.
pub(super) fn read(
    document: &json::Document,
    buffers: &Buffers<'_>,
    root: &Root,
    file: &Path,
    notes: &mut Notes,
) -> (Vec<Image>, Vec<Option<u32>>) {
    let mut images = Vec::new();
    let mut numbers = Vec::with_capacity(document.images.len());
    for ((index, image), used) in document.images.iter().enumerate().zip(images_used(document)) {
        let number = used.then(|| one(image, buffers, root, file)).and_then(|made| match made {
            Ok(mut made) => {
                made.name = called(image, index);
                images.push(made);
                Some(images.len() as u32 - 1)
            }
            Err(why) => {
                notes.warn(format!("image {index}"), &format!("{why}; the material's factors stand for it"));
                None
            }
        });
        numbers.push(number);
    }
    (images, numbers)
}

fn called(image: &json::Image, index: usize) -> String {
    let uri = image.uri.as_deref().filter(|u| !u.starts_with("data:"));
    image.name.as_deref().or(uri).map_or_else(|| format!("image {index}"), |n| clipped(n).to_owned())
}

fn one(image: &json::Image, buffers: &Buffers<'_>, root: &Root, file: &Path) -> Result<Image, String> {
    if let Some(view) = image.buffer_view {
        return decode(buffers.view(view)?.0);
    }
    let uri = image.uri.as_deref().ok_or("an image without data")?;
    if let Some(bytes) = data(uri) {
        return decode(&bytes?);
    }
    let path = root.resolve(file, &file_name(uri)?)?;
    decode(&root.read(&path).map_err(|e| e.to_string())?)
}
