//! A k-d tree over points of the plane that answers one question: which of them lie within a triangle?
//! Boxes are culled against the triangle's edges too, so that long thin triangles cost little.
//! Points are never removed; who asks sorts out those that no longer count.

use glam::DVec2;

/// Points in a leaf at most.
const LEAF: usize = 8;

/// The tree: an implicit heap of boxes over an array of point numbers.
pub(super) struct PointTree {
    items: Vec<u32>,
    boxes: Vec<[DVec2; 2]>,
    stack: Vec<(usize, usize, usize)>,
}

impl PointTree {
    /// Over the points `items`, numbers that `at` places.
    pub(super) fn new(mut items: Vec<u32>, at: impl Fn(u32) -> DVec2) -> PointTree {
        let mut boxes = Vec::new();
        let mut stack = vec![(0, 0, items.len())];
        while let Some((node, low, high)) = stack.pop() {
            let bounds =
                items[low..high].iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[a, b], &i| {
                    let p = at(i);
                    [a.min(p), b.max(p)]
                });
            if boxes.len() <= node {
                boxes.resize(node + 1, [DVec2::INFINITY, DVec2::NEG_INFINITY]);
            }
            boxes[node] = bounds;
            if high - low > LEAF {
                let middle = (low + high) / 2;
                let extent = bounds[1] - bounds[0];
                let axis = usize::from(extent.y > extent.x);
                items[low..high]
                    .select_nth_unstable_by(middle - low, |&a, &b| at(a)[axis].total_cmp(&at(b)[axis]));
                stack.push((2 * node + 1, low, middle));
                stack.push((2 * node + 2, middle, high));
            }
        }
        PointTree { items, boxes, stack }
    }

    /// True if `blocks` says so of any point in a box that touches the triangle (counter-clockwise).
    pub(super) fn any_near(&mut self, triangle: [DVec2; 3], mut blocks: impl FnMut(u32) -> bool) -> bool {
        let [a, b, c] = triangle;
        let (least, most) = (a.min(b).min(c), a.max(b).max(c));
        let edges = [(a, b), (b, c), (c, a)];
        self.stack.clear();
        self.stack.push((0, 0, self.items.len()));
        while let Some((node, low, high)) = self.stack.pop() {
            let [from, to] = self.boxes[node];
            let apart = from.x > most.x || from.y > most.y || to.x < least.x || to.y < least.y;
            // The box's corner furthest to the left of each edge must not lie to its right.
            let beyond = |&(p, q): &(DVec2, DVec2)| {
                let normal = DVec2::new(p.y - q.y, q.x - p.x);
                let x = if normal.x > 0.0 { to.x } else { from.x };
                let y = if normal.y > 0.0 { to.y } else { from.y };
                normal.dot(DVec2::new(x, y) - p) < 0.0
            };
            if apart || edges.iter().any(beyond) {
                continue;
            }
            if high - low <= LEAF {
                if self.items[low..high].iter().any(|&i| blocks(i)) {
                    return true;
                }
            } else {
                let middle = (low + high) / 2;
                self.stack.push((2 * node + 1, low, middle));
                self.stack.push((2 * node + 2, middle, high));
            }
        }
        false
    }
}
