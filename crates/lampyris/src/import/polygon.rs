//! Polygons as triangles: ear clipping, for concave outlines, holes (`fh`) and seams that touch themselves.
//! Ears are kept in a queue and reflex corners in a tree, so that each corner is tried a few times and each try is
//! cheap [Eberly, Triangulation by Ear Clipping]; an outline that crosses itself gets as many triangles, but no sense.

use super::point_tree::PointTree;
use glam::{DVec2, DVec3};
use std::collections::VecDeque;

/// Corners cut off by force before an outline is given up as crossing itself.
const PATIENCE: usize = 16;

/// A polygon's triangles.
pub(super) struct Triangulation {
    /// Indices of points, counter-clockwise about the normal.
    pub(super) triangles: Vec<[u32; 3]>,
    /// False if the outline crosses itself.
    pub(super) simple: bool,
}

/// Twice the vector area of an outline [m²]: its normal by the right-hand rule (Newell).
pub(super) fn vector_area(outline: &[DVec3]) -> DVec3 {
    let Some(&origin) = outline.first() else { return DVec3::ZERO };
    outline.windows(2).map(|e| (e[0] - origin).cross(e[1] - origin)).fold(DVec3::ZERO, |a, b| a + b)
}

/// The points in the plane across `normal`, seen from its tip, so that counter-clockwise stays so.
pub(super) fn flatten(points: &[DVec3], normal: DVec3) -> Vec<DVec2> {
    let n = normal.abs();
    let axis = if n.x >= n.y && n.x >= n.z {
        0
    } else if n.y >= n.z {
        1
    } else {
        2
    };
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let turned = normal[axis] < 0.0;
    points
        .iter()
        .map(|p| if turned { DVec2::new(p[second], p[first]) } else { DVec2::new(p[first], p[second]) })
        .collect()
}

/// Triangulates an outline with holes: `contours` are the ends of the runs of points that make the contours, the
/// counter-clockwise outline first, then holes in either sense; each of three points or more.
pub(super) fn triangulate(points: &[DVec2], contours: &[usize]) -> Triangulation {
    let outer = contours.first().copied().unwrap_or(points.len());
    let mut ring: Vec<u32> = (0..outer as u32).collect();
    let mut holes: Vec<Vec<u32>> = contours
        .windows(2)
        .map(|ends| {
            let hole = (ends[0] as u32..ends[1] as u32).collect::<Vec<_>>();
            if signed_area(points, &hole) > 0.0 { hole.into_iter().rev().collect() } else { hole }
        })
        .collect();
    // From the right to the left, so that the way out of a hole meets only what is joined already.
    let rightmost =
        |hole: &[u32]| hole.iter().map(|&i| points[i as usize].x).fold(f64::NEG_INFINITY, f64::max);
    holes.sort_by(|a, b| rightmost(b).total_cmp(&rightmost(a)));
    for hole in &holes {
        bridge(points, &mut ring, hole);
    }
    clip(points, &ring)
}

fn signed_area(points: &[DVec2], ring: &[u32]) -> f64 {
    let at = |k: usize| points[ring[k % ring.len()] as usize];
    (0..ring.len()).map(|k| (at(k) - at(0)).perp_dot(at(k + 1) - at(0))).sum()
}

/// Joins a hole to the outline by a seam from the hole's rightmost point to an outline point that it sees
/// [Eberly, §3].
fn bridge(points: &[DVec2], ring: &mut Vec<u32>, hole: &[u32]) {
    let at = |i: u32| points[i as usize];
    let from = (0..hole.len()).max_by(|&a, &b| at(hole[a]).x.total_cmp(&at(hole[b]).x)).unwrap_or(0);
    let m = at(hole[from]);
    // The nearest edge to the right that a horizontal ray meets, going up (the inside is to its left).
    let mut best: Option<(f64, usize)> = None;
    for k in 0..ring.len() {
        let (a, b) = (at(ring[k]), at(ring[(k + 1) % ring.len()]));
        if a.y <= m.y && b.y >= m.y && a.y < b.y {
            let x = a.x + (m.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if x >= m.x && best.is_none_or(|(least, _)| x < least) {
                best = Some((x, if a.x > b.x { k } else { (k + 1) % ring.len() }));
            }
        }
    }
    let target = match best {
        // Outline points in the triangle between the ray and the edge may hide its end: take the flattest of them.
        Some((x, end)) => {
            let (hit, p) = (DVec2::new(x, m.y), at(ring[end]));
            let corner = if p.y < m.y { [m, p, hit] } else { [m, hit, p] };
            let slope = |q: DVec2| (q.y - m.y).abs() / (q.x - m.x);
            let hidden = (0..ring.len()).filter(|&k| {
                let q = at(ring[k]);
                q.x > m.x && q != p && within(corner, q)
            });
            hidden.fold(end, |best, k| {
                let (q, b) = (at(ring[k]), at(ring[best]));
                let (s, t) = (slope(q), slope(b));
                if s < t || (s == t && q.x < b.x) { k } else { best }
            })
        }
        // The hole lies outside: any seam will do, the outline crosses itself.
        None => ring.len() - 1,
    };
    // A point of the ring may be doubled by earlier seams; take the copy whose corner holds the seam.
    let twins = (0..ring.len()).filter(|&k| at(ring[k]) == at(ring[target]));
    let sees = |k: usize| {
        let (a, p, b) =
            (at(ring[(k + ring.len() - 1) % ring.len()]), at(ring[k]), at(ring[(k + 1) % ring.len()]));
        let (left, right) = ((b - p).perp_dot(m - p) > 0.0, (p - a).perp_dot(m - p) > 0.0);
        if (p - a).perp_dot(b - p) > 0.0 { left && right } else { left || right }
    };
    let target = twins.into_iter().find(|&k| sees(k)).unwrap_or(target);
    let seam: Vec<u32> =
        (0..=hole.len()).map(|k| hole[(from + k) % hole.len()]).chain([ring[target]]).collect();
    ring.splice(target + 1..target + 1, seam);
}

/// Whether the counter-clockwise triangle, its edges included, holds `p`.
fn within([a, b, c]: [DVec2; 3], p: DVec2) -> bool {
    (b - a).perp_dot(p - a) >= 0.0 && (c - b).perp_dot(p - b) >= 0.0 && (a - c).perp_dot(p - c) >= 0.0
}

/// The ring as a linked list that loses its ears.
struct Ring<'a> {
    points: &'a [DVec2],
    ring: &'a [u32],
    next: Vec<u32>,
    previous: Vec<u32>,
    alive: Vec<bool>,
}

impl Ring<'_> {
    fn at(&self, node: u32) -> DVec2 {
        self.points[self.ring[node as usize] as usize]
    }

    fn corner(&self, node: u32) -> [DVec2; 3] {
        [self.at(self.previous[node as usize]), self.at(node), self.at(self.next[node as usize])]
    }

    /// Positive at a convex corner, zero at a straight one.
    fn turn(&self, node: u32) -> f64 {
        let [a, b, c] = self.corner(node);
        (b - a).perp_dot(c - b)
    }

    /// A convex corner whose triangle holds no other corner (`touching`: its border may).
    fn is_ear(&self, node: u32, reflex: &mut PointTree, touching: bool) -> bool {
        if self.turn(node) <= 0.0 {
            return false;
        }
        let corner = self.corner(node);
        let [a, b, c] = corner;
        !reflex.any_near(corner, |other| {
            let p = self.at(other);
            // Seams bring other corners to the same points; they are no obstacle.
            let obstacle =
                self.alive[other as usize] && p != a && p != b && p != c && self.turn(other) <= 0.0;
            obstacle
                && within(corner, p)
                && !(touching
                    && [(a, b), (b, c), (c, a)].iter().any(|&(s, t)| (t - s).perp_dot(p - s) <= 0.0))
        })
    }

    /// Cuts a corner off; its neighbours.
    fn cut(&mut self, node: u32, out: &mut Vec<[u32; 3]>) -> [u32; 2] {
        let (a, c) = (self.previous[node as usize], self.next[node as usize]);
        out.push([a, node, c].map(|n| self.ring[n as usize]));
        self.next[a as usize] = c;
        self.previous[c as usize] = a;
        self.alive[node as usize] = false;
        [a, c]
    }
}

fn clip(points: &[DVec2], ring: &[u32]) -> Triangulation {
    let n = ring.len() as u32;
    let mut list = Ring {
        points,
        ring,
        next: (0..n).map(|i| (i + 1) % n).collect(),
        previous: (0..n).map(|i| (i + n - 1) % n).collect(),
        alive: vec![true; n as usize],
    };
    let reflex = (0..n).filter(|&i| list.turn(i) <= 0.0).collect();
    let mut reflex = PointTree::new(reflex, |i| list.at(i));
    let mut triangles = Vec::with_capacity(ring.len().saturating_sub(2));
    let mut left = n;
    // A corner is queued again when a neighbour goes; entries from before that are stale.
    let mut version = vec![0u32; n as usize];
    let mut queue: VecDeque<(u32, u32)> = (0..n).map(|i| (i, 0)).collect();
    let mut touching = false;
    let mut patience = PATIENCE;
    while left > 2 {
        let Some((node, stamp)) = queue.pop_front() else {
            // No ear is left: the outline touches itself, or crosses itself. First allow the one, then use force.
            let rest: Vec<u32> = (0..n).filter(|&i| list.alive[i as usize]).collect();
            if touching {
                patience -= 1;
                if patience == 0 {
                    let fan =
                        rest.windows(2).skip(1).map(|e| [rest[0], e[0], e[1]].map(|k| ring[k as usize]));
                    triangles.extend(fan);
                    return Triangulation { triangles, simple: false };
                }
                let node = rest.iter().copied().find(|&i| list.turn(i) > 0.0).unwrap_or(rest[0]);
                list.cut(node, &mut triangles);
                left -= 1;
            }
            touching = true;
            queue.extend(rest.into_iter().map(|i| (i, version[i as usize])));
            continue;
        };
        if !list.alive[node as usize]
            || stamp != version[node as usize]
            || !list.is_ear(node, &mut reflex, touching)
        {
            continue;
        }
        for neighbour in list.cut(node, &mut triangles) {
            version[neighbour as usize] += 1;
            queue.push_back((neighbour, version[neighbour as usize]));
        }
        left -= 1;
    }
    Triangulation { triangles, simple: patience == PATIENCE }
}

#[cfg(test)]
#[path = "polygon_tests.rs"]
mod tests;
