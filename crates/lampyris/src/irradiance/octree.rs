//! Balls in a tree of cubes, to be found by a point: each ball lies in the cubes that it meets among those of about its size
//! [Ward et al. 1988]. What is found, and in which order, depends on the balls and the order in which they came alone.

use glam::Vec3;

/// The least radius that the tree tells from smaller ones [half edges of the whole].
const LEAST: f32 = 1e-4;

/// Numbered balls.
#[derive(Clone, Debug)]
pub(super) struct Octree {
    center: Vec3,
    /// Half the edge of the whole [m].
    half: f32,
    /// The first is the whole.
    nodes: Vec<Node>,
}

#[derive(Clone, Debug, Default)]
struct Node {
    /// Nodes of the octants; 0 where there is none.
    octants: [u32; 8],
    balls: Vec<u32>,
}

impl Octree {
    /// Nothing yet, in a cube; what lies outside of it is found as well.
    pub(super) fn new(center: Vec3, half: f32) -> Octree {
        Octree { center, half, nodes: vec![Node::default()] }
    }

    /// Adds a ball.
    pub(super) fn insert(&mut self, ball: u32, center: Vec3, radius: f32) {
        // In cubes of one to two radii: larger ones would hold much that is not around a point.
        let roomy = radius.max(LEAST * self.half);
        let mut open = vec![(0, self.center, self.half)];
        while let Some((node, middle, half)) = open.pop() {
            if half <= roomy {
                self.nodes[node].balls.push(ball);
                continue;
            }
            let (low, high) = (center - radius, center + radius);
            for octant in 0..8 {
                // Octants at the border of the whole reach beyond it.
                let meets = |axis: usize| {
                    if octant >> axis & 1 == 1 {
                        high[axis] >= middle[axis]
                    } else {
                        low[axis] < middle[axis]
                    }
                };
                if (0..3).all(meets) {
                    let child = self.child(node, octant);
                    open.push((child, corner(middle, 0.5 * half, octant), 0.5 * half));
                }
            }
        }
    }

    /// Balls around a point, and some that only come near it.
    pub(super) fn around(&self, point: Vec3) -> impl Iterator<Item = u32> {
        let (mut next, mut middle, mut half) = (Some(0), self.center, self.half);
        let nodes = std::iter::from_fn(move || {
            let node: &Node = &self.nodes[next?];
            let octant =
                (0..3).fold(0, |octant, axis| octant | usize::from(point[axis] >= middle[axis]) << axis);
            half *= 0.5;
            middle = corner(middle, half, octant);
            next = Some(node.octants[octant] as usize).filter(|child| *child > 0);
            Some(node)
        });
        nodes.flat_map(|node| node.balls.iter().copied())
    }

    fn child(&mut self, node: usize, octant: usize) -> usize {
        if self.nodes[node].octants[octant] == 0 {
            self.nodes[node].octants[octant] = self.nodes.len() as u32;
            self.nodes.push(Node::default());
        }
        self.nodes[node].octants[octant] as usize
    }
}

/// The corner of a cube, or the middle of one of its octants, that an octant's number says.
fn corner(middle: Vec3, half: f32, octant: usize) -> Vec3 {
    let side = |axis: usize| if octant >> axis & 1 == 1 { half } else { -half };
    middle + Vec3::new(side(0), side(1), side(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::uniform;

    #[test]
    fn every_ball_is_found_from_within_once() {
        let vector = |k: u32| Vec3::from_array([0, 1, 2].map(|d| 2.4 * uniform(1, k, d) - 1.2));
        let balls: Vec<(Vec3, f32)> =
            (0..600).map(|k| (vector(k), libm::exp2f(-12.0 * uniform(2, k, 0)))).collect();
        let mut tree = Octree::new(Vec3::ZERO, 1.0);
        (0..).zip(&balls).for_each(|(k, (center, radius))| tree.insert(k, *center, *radius));
        let (mut within, mut looked_at) = (0, 0);
        for k in 0..4000 {
            let point = vector(1000 + k);
            let found: Vec<u32> = tree.around(point).collect();
            for (ball, (center, radius)) in (0..).zip(&balls) {
                let times = found.iter().filter(|other| **other == ball).count();
                let inside = point.distance(*center) <= *radius;
                assert!(times == 1 || (times == 0 && !inside), "{ball} {times} times from {point}");
                within += usize::from(inside);
            }
            looked_at += found.len();
        }
        assert!(within > 10_000 && looked_at < 10 * within, "{looked_at} for {within}");
    }
}
