//! The walk in plain Rust: one ray, one box, one triangle after the other. It is the oracle of the SIMD kernels and
//! serves machines without them. It does not hurry.

use super::{Best, End, Hierarchy, LEAF, Line, NONE, Placed, STACK, Slab, Tree, WIDTH};
use crate::geometry::Ray;

pub(super) fn closest(tree: &Tree, ray: &Ray, placed: Option<(&Placed, &Slab)>, best: &mut Best) {
    let (line, slab) = (Line::new(ray), tree.slab(ray, placed));
    walk(&tree.hierarchy, &slab, best.t, |leaf| {
        let block = &tree.blocks[leaf as usize];
        let moved;
        let block = match placed {
            Some((place, _)) => {
                moved = block.placed(place);
                &moved
            }
            None => block,
        };
        for i in 0..WIDTH {
            block.offer(i, &line, &tree.screen, best);
        }
        best.t
    });
}

pub(super) fn occluded(tree: &Tree, ray: &Ray, end: End, placed: Option<(&Placed, &Slab)>) -> bool {
    let (line, slab) = (Line::new(ray), tree.slab(ray, placed));
    let t_max = match end {
        End::Distance(t) => t,
        End::Point(_) => 1.0,
    };
    let mut hit = false;
    walk(&tree.hierarchy, &slab, t_max, |leaf| {
        let block = &tree.blocks[leaf as usize];
        hit = match placed {
            Some((place, _)) => {
                let moved = block.placed(place);
                (0..WIDTH).any(|i| moved.blocks(i, &line, end, &tree.screen))
            }
            None => (0..WIDTH).any(|i| block.blocks(i, &line, end, &tree.screen)),
        };
        if hit { f32::NEG_INFINITY } else { t_max }
    });
    hit
}

/// Calls `visit` with the leaves that the line meets, nearest boxes first, as far as the distance it returned last.
pub(super) fn walk(hierarchy: &Hierarchy, slab: &Slab, t_max: f32, mut visit: impl FnMut(u32) -> f32) {
    let mut stack = [(NONE, 0f32); STACK];
    let mut depth = 0;
    let mut limit = t_max + slab.slack;
    if !hierarchy.nodes.is_empty() {
        stack[0] = (0, 0.0);
        depth = 1;
    }
    while depth > 0 {
        depth -= 1;
        let (child, enter) = stack[depth];
        if enter > limit {
            continue;
        }
        if child & LEAF != 0 {
            limit = visit(child & !LEAF) + slab.slack;
            continue;
        }
        let node = &hierarchy.nodes[child as usize];
        let first = depth;
        for i in 0..WIDTH {
            let b = |k: usize| node.bounds[k][i];
            let (enter, leave) = slab.span([b(0), b(1), b(2)], [b(3), b(4), b(5)]);
            if node.child[i] == NONE || enter > leave || enter > limit {
                continue;
            }
            let mut at = depth;
            while at > first && stack[at - 1].1 < enter {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = (node.child[i], enter);
            depth += 1;
        }
    }
}
