//! A tree with small trees grafted on: what was placed anew since the tree was built. Rays walk one hierarchy as before;
//! above the old root and those of the grafts stand a few nodes that are built whenever a graft changes. What the old tree
//! holds of an instance that now stands elsewhere is overwritten with NaN, which nothing hits, and its boxes shrink.

use super::build::{SAH_DEPTH, build};
use super::{Block, Bounds, Hierarchy, Item, LEAF, NONE, Node, Tree, WIDTH};
use rayon::prelude::*;

/// Most grafts; beyond it somebody has to join them. It bounds how deep the tree becomes.
pub(in crate::geometry) const MOST: usize = 1 << 10;

/// Levels above the old root and the grafts: below those by area each halves the largest range.
pub(super) const DEPTH: usize = SAH_DEPTH + MOST.ilog2() as usize + 1;

/// A tree, what was cut out of it, and what was grafted on.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct Grafted {
    /// What rays walk: nodes and blocks of the old tree, then of the grafts, then the nodes above them.
    pub(in crate::geometry) tree: Tree,
    /// How many of them are the old tree's.
    nodes: usize,
    blocks: usize,
    /// Its root, whose place is the new root's, and its box.
    root: Option<Node>,
    bounds: Bounds,
    grafts: Vec<Graft>,
}

/// A tree of some instances, as it is before it is grafted on.
#[derive(Clone, Debug)]
struct Graft {
    instances: Vec<u32>,
    tree: Tree,
}

impl Block {
    /// Takes the triangles of an instance out; false if there are none.
    fn erase(&mut self, instance: u32) -> bool {
        let mut found = false;
        for i in (0..WIDTH).filter(|i| self.instance[*i] == instance) {
            found |= !self.corners[0][i].is_nan();
            self.corners.iter_mut().for_each(|of| of[i] = f32::NAN);
        }
        found
    }

    /// The box around its triangles.
    fn bounds(&self) -> Bounds {
        let there = (0..WIDTH).filter(|i| !self.corners[0][*i].is_nan());
        there.fold(Bounds::default(), |b, i| b.union(&Bounds::of(&self.corners(i))))
    }
}

impl Node {
    /// Shrinks its boxes to what is left of its children: nodes with these boxes, or blocks. Returns the box around all.
    fn fit(&mut self, nodes: &[Bounds], blocks: &[Block]) -> Bounds {
        let mut all = Bounds::default();
        for (i, child) in self.child.iter().enumerate().filter(|(_, child)| **child != NONE) {
            let bounds = match child & LEAF {
                0 => nodes[*child as usize],
                _ => blocks[(child & !LEAF) as usize].bounds(),
            };
            for axis in 0..3 {
                self.bounds[axis][i] = bounds.lower[axis];
                self.bounds[axis + 3][i] = bounds.upper[axis];
            }
            all = all.union(&bounds);
        }
        all
    }
}

impl Grafted {
    pub(in crate::geometry) fn new(tree: Tree) -> Grafted {
        Grafted {
            nodes: tree.hierarchy.nodes.len(),
            blocks: tree.blocks.len(),
            root: tree.hierarchy.nodes.first().cloned(),
            bounds: tree.bounds(),
            tree,
            grafts: Vec::new(),
        }
    }

    /// The instances that a graft holds, if there are as many grafts as there may be.
    pub(in crate::geometry) fn crowd(&self) -> impl Iterator<Item = u32> {
        let full = self.grafts.len() >= MOST;
        self.grafts.iter().filter(move |_| full).flat_map(|g| &g.instances).copied()
    }

    /// Takes instances out, and grafts a tree of them on, if there is one.
    pub(in crate::geometry) fn replace(&mut self, instances: &[u32], tree: Option<Tree>) {
        let (mut first, stock) = (self.grafts.len(), self.nodes);
        for number in instances {
            match self.grafts.iter().position(|g| g.instances.contains(number)) {
                None => self.cut(*number),
                Some(k) => {
                    let graft = &mut self.grafts[k];
                    graft.instances.retain(|i| i != number);
                    for block in &mut graft.tree.blocks {
                        block.erase(*number);
                    }
                    if graft.instances.is_empty() {
                        self.grafts.remove(k);
                    }
                    first = first.min(k);
                }
            }
        }
        // What moves now will probably move again: at the end it disturbs no others.
        self.grafts.extend(tree.map(|tree| Graft { instances: instances.to_vec(), tree }));
        self.grow(if stock == self.nodes { first } else { 0 });
    }

    /// Takes an instance out of the old tree: one look at each block.
    fn cut(&mut self, instance: u32) {
        let Hierarchy { nodes, .. } = &mut self.tree.hierarchy;
        let (old, Some(root)) = (&mut self.tree.blocks[..self.blocks], &mut self.root) else { return };
        let erase = |block: &mut Block| block.erase(instance);
        if !old.par_iter_mut().with_min_len(1024).map(erase).reduce(|| false, |a, b| a | b) {
            return;
        }
        // Children come after their parents.
        let mut boxes = vec![Bounds::default(); self.nodes];
        for k in (1..self.nodes).rev() {
            boxes[k] = nodes[k].fit(&boxes, old);
        }
        self.bounds = root.fit(&boxes, old);
        if self.bounds.is_empty() {
            (self.nodes, self.blocks, self.root) = (0, 0, None);
            nodes.clear();
            self.tree.blocks.clear();
        }
    }

    /// Bytes held.
    pub(in crate::geometry) fn memory(&self) -> usize {
        self.tree.memory() + self.grafts.iter().map(|g| g.tree.memory()).sum::<usize>()
    }

    /// Puts the grafts on anew from that number on, and the nodes above them.
    fn grow(&mut self, from: usize) {
        let Grafted { tree, grafts, .. } = self;
        let (nodes, blocks) = (&mut tree.hierarchy.nodes, &mut tree.blocks);
        let kept = || grafts[..from].iter().map(|g| &g.tree);
        // The place of the root is kept even where the old tree is empty.
        let stock = self.nodes.max(1);
        nodes.truncate(stock + kept().map(|t| t.hierarchy.nodes.len()).sum::<usize>());
        blocks.truncate(self.blocks + kept().map(|t| t.blocks.len()).sum::<usize>());
        nodes.resize(nodes.len().max(1), Node::EMPTY);
        for graft in &grafts[from..] {
            let (node_base, leaf_base) = (nodes.len() as u32, blocks.len() as u32);
            nodes.extend(graft.tree.hierarchy.nodes.iter().map(|n| n.moved(node_base, leaf_base)));
            blocks.extend_from_slice(&graft.tree.blocks);
        }
        // The roots: the old one gives way to a new one, if there is one above it.
        let mut roots = Vec::with_capacity(grafts.len() + 1);
        let mut items = Vec::with_capacity(grafts.len() + 1);
        if let Some(root) = &self.root {
            if grafts.is_empty() {
                nodes[0] = root.clone();
                tree.hierarchy.bounds = self.bounds;
                return;
            }
            roots.push(nodes.len() as u32);
            items.push(Item { bounds: self.bounds, index: 0 });
            nodes.push(root.clone());
        }
        let mut next = stock as u32;
        for graft in grafts.iter() {
            let bounds = graft.tree.bounds();
            if !bounds.is_empty() {
                items.push(Item { bounds, index: roots.len() as u32 });
                roots.push(next);
            }
            next += graft.tree.hierarchy.nodes.len() as u32;
        }
        if items.is_empty() {
            nodes.clear();
            tree.hierarchy.bounds = Bounds::default();
            return;
        }
        let (top, leaves) = build(&mut items, 1);
        let Hierarchy { nodes: above, bounds } = top;
        let base = nodes.len() as u32 - 1;
        let child = |child: u32| match child {
            NONE => NONE,
            leaf if leaf & LEAF != 0 => {
                let item = leaves[(leaf & !LEAF) as usize].start;
                roots[items[item as usize].index as usize]
            }
            inner => base + inner,
        };
        let mut above = above.into_iter().map(|n| Node { child: n.child.map(child), ..n });
        nodes[0] = above.next().unwrap_or(Node::EMPTY);
        nodes.extend(above);
        tree.hierarchy.bounds = bounds;
    }
}
