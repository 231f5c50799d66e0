//! What is broken in a document and yet needed by nothing: the picture is right, but who made the file should know.

use super::accessor::Accessors;
use super::buffers::Buffers;
use super::json::{Document, Shape};
use crate::import::notes::Notes;

/// Warns of views and accessors that reach beyond their bytes, and of nodes that make no trees.
pub(super) fn check(document: &Document, buffers: &Buffers<'_>, notes: &mut Notes) {
    for index in 0..document.buffer_views.len() as u32 {
        if let Err(why) = buffers.view(index) {
            notes.warn(format!("bufferView {index}"), &format!("broken, though nothing needs it: {why}"));
        }
    }
    // Of matrices only the first column is measured: nothing here reads them.
    let shapes = [Shape::Scalar, Shape::Vec2, Shape::Vec3, Shape::Vec4, Shape::Other];
    let accessors = Accessors::new(document, buffers, u64::MAX);
    let with_view = (0..).zip(&document.accessors).filter(|(_, a)| a.buffer_view.is_some());
    for (index, _) in with_view {
        if let Err(why) = accessors.get(index, &shapes) {
            notes.warn(format!("accessor {index}"), &format!("broken, though nothing needs it: {why}"));
        }
    }
    if !makes_trees(document) {
        notes.warn(
            "nodes",
            "nodes with two parents, loops, or children that do not exist, beside the scene shown",
        );
    }
}

/// Whether each node has one parent at most, and is reached from one that has none.
fn makes_trees(document: &Document) -> bool {
    let mut parents = vec![0u32; document.nodes.len()];
    for child in document.nodes.iter().flat_map(|n| n.children.iter()) {
        match parents.get_mut(*child as usize) {
            Some(count) => *count += 1,
            None => return false,
        }
    }
    if parents.iter().any(|p| *p > 1) {
        return false;
    }
    let mut open: Vec<u32> = (0..).zip(&parents).filter(|(_, p)| **p == 0).map(|(k, _)| k).collect();
    let mut reached = 0;
    while let Some(node) = open.pop() {
        reached += 1;
        open.extend(document.nodes[node as usize].children.iter());
    }
    reached == parents.len()
}
