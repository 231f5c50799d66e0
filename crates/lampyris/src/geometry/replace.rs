//! How one instance comes to stand elsewhere, or nowhere, without building everything anew. Its triangles leave the tree
//! that holds them by being overwritten with what nothing hits; then it gets a small tree of its own in world space, or,
//! where its mesh is shared, another place below the tree over the instances. Hits are those of a tracer built afresh,
//! bit for bit; only the time they take may differ.

use super::tracer::{Instance, Moved, Soup, usable};
use super::{MeshGeometry, Placement, Screen, Tracer};
use crate::geometry::bvh::Tree;

/// Most trees of what was placed anew: each costs a look at every ray. Beyond this number all of them become one.
const MOST: usize = 16;

impl Tracer {
    /// The instances whose triangles [`Tracer::replace`] wants to see if `number` stands otherwise from now on: itself,
    /// unless its mesh is shared, and from time to time others.
    pub fn concerned(&self, number: u32, placement: Option<&Placement>) -> Vec<u32> {
        let shared = |p: &Placement| self.trees.get(p.mesh as usize).is_some_and(|t| *t != u32::MAX);
        if placement.is_none_or(shared) {
            return Vec::new();
        }
        let others = self.loose.iter().filter(|_| self.loose.len() >= MOST).flatten().copied();
        std::iter::once(number).chain(others.filter(|i| *i != number)).collect()
    }

    /// Instance `number` stands as `placement` says from now on; `None` takes it away. `concerned` are the instances that
    /// [`Tracer::concerned`] names, in their places, with what is known of their meshes.
    pub fn replace(
        &mut self,
        number: u32,
        placement: Option<&Placement>,
        concerned: &[(u32, MeshGeometry<'_>, Placement)],
        screen: &Screen,
    ) {
        self.take_out(number);
        for (other, ..) in concerned.iter().filter(|(other, ..)| *other != number) {
            self.take_out(*other);
        }
        let meshes: Vec<Moved<'_>> = (concerned.iter().filter(|(_, _, p)| usable(p)))
            .map(|(number, mesh, p)| Moved::new(mesh, *number, &p.transform))
            .collect();
        if !meshes.is_empty() {
            let soup = Soup::new(meshes);
            self.flat.push(Tree::new(soup.count, |k| soup.primitive(k), screen));
            self.loose.push(concerned.iter().map(|(number, ..)| *number).collect());
            self.measure();
        } else if let Some(p) = placement.filter(|p| usable(p)) {
            let tree = self.trees.get(p.mesh as usize).copied().unwrap_or(u32::MAX);
            if let Some(of) = self.shared.get(tree as usize).filter(|of| !of.tree.is_empty()) {
                let instance = Instance::new(number, tree, &of.tree.bounds(), &p.transform);
                let mut placed = std::mem::take(&mut self.placed);
                placed.push(instance);
                self.raise(placed);
            }
        }
    }

    /// Asks another screen for the holes of all triangles; it must give the same answers.
    pub fn ask(&mut self, screen: &Screen) {
        let shared = self.shared.iter_mut().map(|s| &mut s.tree);
        self.flat.iter_mut().chain(shared).for_each(|tree| tree.ask(screen));
    }

    /// Takes an instance out of the tree that holds it.
    fn take_out(&mut self, number: u32) {
        if let Some(k) = self.loose.iter().position(|of| of.contains(&number)) {
            if self.loose[k].len() == 1 {
                self.loose.remove(k);
                self.flat.remove(k + 1);
            } else {
                self.loose[k].retain(|i| *i != number);
                self.flat[k + 1].erase(number);
            }
        } else if let Some(k) = self.placed.iter().position(|i| i.place.instance == number) {
            let mut placed = std::mem::take(&mut self.placed);
            placed.remove(k);
            self.raise(placed);
        } else if let Some(first) = self.flat.first_mut() {
            first.erase(number);
        }
    }
}
