//! The builder: ranges of boxes split by the surface area heuristic over bins of their centres [Wald 2007] until eight
//! ranges make a node. Large subtrees grow in parallel, yet the tree depends on the boxes alone. It does not split
//! boxes, and below a fixed depth it halves by number, so that no scene makes it deep.

use super::{Hierarchy, LEAF, Node, WIDTH};
use glam::Vec3;
use rayon::prelude::*;

/// Wide levels split by surface area.
pub(super) const SAH_DEPTH: usize = 14;
/// Each level below at least halves the largest range: 2³¹ boxes end within 31 more, leaves being bits of a u32.
pub(super) const MAX_DEPTH: usize = SAH_DEPTH + 31;

const BINS: usize = 16;
/// Ranges of fewer boxes are built by one thread.
const PARALLEL: usize = 4096;

/// An axis-aligned box; the default is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) lower: Vec3,
    pub(crate) upper: Vec3,
}

impl Default for Bounds {
    fn default() -> Bounds {
        Bounds { lower: Vec3::INFINITY, upper: Vec3::NEG_INFINITY }
    }
}

impl Bounds {
    pub(crate) fn of(points: &[Vec3]) -> Bounds {
        points.iter().fold(Bounds::default(), |b, p| b.union(&Bounds { lower: *p, upper: *p }))
    }

    pub(crate) fn union(&self, other: &Bounds) -> Bounds {
        Bounds { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.lower.x > self.upper.x
    }

    /// Twice the centre: halving would only cost.
    fn centre(&self) -> Vec3 {
        self.lower + self.upper
    }

    fn half_area(&self) -> f32 {
        let e = self.upper - self.lower;
        if self.is_empty() { 0.0 } else { e.x * e.y + e.y * e.z + e.z * e.x }
    }
}

/// A finite box and the number of what is in it.
#[derive(Clone, Copy)]
pub(crate) struct Item {
    pub(crate) bounds: Bounds,
    pub(crate) index: u32,
}

/// Where the items of a leaf lie.
pub(crate) type Leaf = std::ops::Range<u32>;

/// Items on their way to become a child: their box, and the place of the first among all.
struct Range<'a> {
    items: &'a mut [Item],
    bounds: Bounds,
    first: u32,
}

impl<'a> Range<'a> {
    fn new(items: &'a mut [Item], first: u32) -> Range<'a> {
        let bounds = items.iter().fold(Bounds::default(), |b, i| b.union(&i.bounds));
        Range { items, bounds, first }
    }
}

#[derive(Default)]
struct Subtree {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

/// A hierarchy over boxes with at most `leaf` of them in a leaf. Sorts the items so that each leaf is a run of them.
pub(crate) fn build(items: &mut [Item], leaf: usize) -> (Hierarchy, Vec<Leaf>) {
    if items.is_empty() {
        return (Hierarchy::default(), Vec::new());
    }
    let root = Range::new(items, 0);
    let all = root.bounds;
    let tree = grow(root, leaf, 0);
    (Hierarchy { nodes: tree.nodes, bounds: all }, tree.leaves)
}

/// A node and what is below it; the root is a node even if one leaf would do.
fn grow(range: Range<'_>, leaf: usize, depth: usize) -> Subtree {
    let parallel = range.items.len() >= PARALLEL;
    let below = |child: Range<'_>| {
        let bounds = child.bounds;
        if child.items.len() <= leaf {
            let leaf = child.first..child.first + child.items.len() as u32;
            (bounds, Subtree { nodes: Vec::new(), leaves: vec![leaf] })
        } else {
            (bounds, grow(child, leaf, depth + 1))
        }
    };
    let children = divide(range, leaf, depth < SAH_DEPTH);
    join(if parallel {
        children.into_par_iter().map(below).collect()
    } else {
        children.into_iter().map(below).collect()
    })
}

/// Splits the child of the largest area (or number, far down) until the node is full or all children are leaves.
fn divide(range: Range<'_>, leaf: usize, by_area: bool) -> Vec<Range<'_>> {
    let mut children = vec![range];
    while children.len() < WIDTH {
        let weight = |i: usize| {
            if by_area { children[i].bounds.half_area() } else { children[i].items.len() as f32 }
        };
        let largest = (0..children.len())
            .filter(|&i| children[i].items.len() > leaf)
            .max_by(|&a, &b| weight(a).total_cmp(&weight(b)));
        let Some(largest) = largest else { break };
        let range = children.swap_remove(largest);
        let middle = if by_area { split(range.items) } else { None };
        let middle = middle.unwrap_or_else(|| halve(range.items));
        let (left, right) = range.items.split_at_mut(middle);
        children.push(Range::new(left, range.first));
        children.push(Range::new(right, range.first + middle as u32));
    }
    children
}

/// Puts subtrees under a new root. A subtree without nodes is a leaf.
fn join(subtrees: Vec<(Bounds, Subtree)>) -> Subtree {
    let mut all = Subtree { nodes: vec![Node::EMPTY], leaves: Vec::new() };
    for (i, (bounds, subtree)) in subtrees.into_iter().enumerate() {
        let (node_base, leaf_base) = (all.nodes.len() as u32, all.leaves.len() as u32);
        for axis in 0..3 {
            all.nodes[0].bounds[axis][i] = bounds.lower[axis];
            all.nodes[0].bounds[axis + 3][i] = bounds.upper[axis];
        }
        all.nodes[0].child[i] = if subtree.nodes.is_empty() { leaf_base | LEAF } else { node_base };
        all.nodes.extend(subtree.nodes.iter().map(|node| node.moved(node_base, leaf_base)));
        all.leaves.extend(subtree.leaves);
    }
    all
}

/// Partitions by the cheapest plane between bins; `None` if all centres coincide.
fn split(items: &mut [Item]) -> Option<usize> {
    let centres = items.iter().fold(Bounds::default(), |b, i| {
        b.union(&Bounds { lower: i.bounds.centre(), upper: i.bounds.centre() })
    });
    let scale = BINS as f32 / (centres.upper - centres.lower);
    let bin = |item: &Item, axis: usize| {
        (((item.bounds.centre()[axis] - centres.lower[axis]) * scale[axis]) as usize).min(BINS - 1)
    };
    let mut bins = [[(Bounds::default(), 0usize); BINS]; 3];
    for item in items.iter() {
        for (axis, bins) in bins.iter_mut().enumerate() {
            let (bounds, count) = &mut bins[bin(item, axis)];
            *bounds = bounds.union(&item.bounds);
            *count += 1;
        }
    }
    let (_, axis, plane) = (0..3)
        .filter(|&axis| centres.upper[axis] > centres.lower[axis])
        .flat_map(|axis| cheapest(&bins[axis]).map(|(cost, plane)| (cost, axis, plane)))
        .min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(partition(items, |item| bin(item, axis) < plane))
}

/// The bin before which to cut, and what that costs: areas weighed by the blocks of triangles they will hold.
fn cheapest(bins: &[(Bounds, usize); BINS]) -> Option<(f32, usize)> {
    let cost = |b: &Bounds, count: usize| b.half_area() * count.div_ceil(WIDTH) as f32;
    let mut right = [(Bounds::default(), 0); BINS];
    let mut sum = (Bounds::default(), 0);
    for i in (1..BINS).rev() {
        sum = (sum.0.union(&bins[i].0), sum.1 + bins[i].1);
        right[i] = sum;
    }
    let mut left = (Bounds::default(), 0);
    let mut best = None;
    for i in 1..BINS {
        left = (left.0.union(&bins[i - 1].0), left.1 + bins[i - 1].1);
        let cost = cost(&left.0, left.1) + cost(&right[i].0, right[i].1);
        if left.1 > 0 && right[i].1 > 0 && best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, i));
        }
    }
    best
}

fn partition(items: &mut [Item], goes_left: impl Fn(&Item) -> bool) -> usize {
    let mut middle = 0;
    for i in 0..items.len() {
        if goes_left(&items[i]) {
            items.swap(i, middle);
            middle += 1;
        }
    }
    middle
}

/// Half of the items by number, along the axis on which their centres spread most.
fn halve(items: &mut [Item]) -> usize {
    let centres = items.iter().fold(Bounds::default(), |b, i| {
        b.union(&Bounds { lower: i.bounds.centre(), upper: i.bounds.centre() })
    });
    let axis = super::triangle::largest_axis((centres.upper - centres.lower).to_array());
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        a.bounds.centre()[axis].total_cmp(&b.bounds.centre()[axis]).then(a.index.cmp(&b.index))
    });
    middle
}
