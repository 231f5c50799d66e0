//! How one instance comes to stand elsewhere, or nowhere, without building everything anew: a small tree of its own in
//! world space is grafted onto that of all others, or, where its mesh is shared, it gets another place below the tree over
//! the instances. Hits are those of a tracer built afresh, bit for bit; only the time they take may differ.

use super::bvh::Tree;
use super::tracer::{Instance, Moved, Soup, usable};
use super::{MeshGeometry, Placement, Screen, Tracer};

impl Tracer {
    /// The instances whose triangles [`Tracer::replace`] wants to see if `number` stands otherwise from now on: itself,
    /// unless its mesh is shared, and once in thousands of times many others.
    pub fn concerned(&self, number: u32, placement: Option<&Placement>) -> Vec<u32> {
        if placement.is_none_or(|p| self.is_shared(p.mesh)) {
            return Vec::new();
        }
        std::iter::once(number).chain(self.flat.crowd().filter(|i| *i != number)).collect()
    }

    /// Instance `number` stands as `placement` says from now on; `None` takes it away. `concerned` are the instances that
    /// [`Tracer::concerned`] names, in their places, with what is known of their meshes.
    pub fn replace(
        &mut self,
        number: u32,
        placement: Option<&Placement>,
        concerned: &[(u32, MeshGeometry<'_>, Placement)],
    ) {
        let meshes: Vec<Moved<'_>> = (concerned.iter().filter(|(_, _, p)| usable(p)))
            .map(|(number, mesh, p)| Moved::new(mesh, *number, &p.transform))
            .collect();
        let tree = (!meshes.is_empty()).then(|| {
            let soup = Soup::new(meshes);
            Tree::new(soup.count, |k| soup.primitive(k), &Screen::default())
        });
        let place = placement.filter(|p| usable(p) && self.is_shared(p.mesh)).and_then(|p| {
            let tree = self.trees[p.mesh as usize];
            let of = &self.shared[tree as usize].tree;
            (!of.is_empty()).then(|| Instance::new(number, tree, &of.bounds(), &p.transform)).flatten()
        });
        let was_placed = self.placed.iter().any(|i| i.place.instance == number);
        if !was_placed || tree.is_some() {
            let others = concerned.iter().map(|(other, ..)| *other).filter(|other| *other != number);
            let numbers: Vec<u32> = others.chain([number]).collect();
            self.flat.replace(&numbers, tree);
        }
        if was_placed || place.is_some() {
            let mut placed = std::mem::take(&mut self.placed);
            placed.retain(|i| i.place.instance != number);
            placed.extend(place);
            self.raise(placed);
        }
        self.measure();
    }

    /// Asks another screen for the holes of all triangles; it must give the same answers.
    pub fn ask(&mut self, screen: &Screen) {
        let shared = self.shared.iter_mut().map(|s| &mut s.tree);
        shared.chain([&mut self.flat.tree]).for_each(|tree| tree.ask(screen));
    }

    fn is_shared(&self, mesh: u32) -> bool {
        self.trees.get(mesh as usize).is_some_and(|tree| *tree != u32::MAX)
    }
}
