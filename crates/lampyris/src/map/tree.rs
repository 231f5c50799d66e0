//! The balanced 3d-tree of a photon map: an order of its photons, without pointers [Keller96, §4.3; Jarosz05, §2.4.2].
//!
//! A range of photons is a subtree: its middle one is the node, what is before it the left subtree, never the smaller one,
//! what is behind it the right one; the node splits the range's points along the longest edge of the box around them. A range
//! of [`LEAF`] or fewer is not split further: to look at all of them is faster. Of photons that lie level along an axis the
//! one that came first is the lower: so there is but one such order, on any number of threads.

use super::photon::Photon;
use glam::Vec3;
use rayon::prelude::*;

/// Most photons of a range that is not split.
pub(super) const LEAF: usize = 32;

/// Ranges of fewer photons are sorted by one thread.
const PARALLEL: usize = 4096;

/// What sorting needs to know of a photon.
#[derive(Clone, Copy)]
struct Point {
    at: [f32; 3],
    /// Its place among those that came.
    number: u32,
}

/// Puts photons in the order of the tree; their positions must be finite.
pub(super) fn balanced(photons: &[Photon]) -> Vec<Photon> {
    let point = |(number, p): (u32, &Photon)| Point { at: p.position().to_array(), number };
    let numbers = (0..photons.len() as u32).into_par_iter();
    let mut points: Vec<Point> =
        numbers.zip(photons).with_min_len(PARALLEL).map(|(k, p)| point((k, p))).collect();
    let mut axes = vec![0; photons.len()];
    split(&mut points, &mut axes);
    let ordered = points.par_iter().zip(&axes).with_min_len(PARALLEL);
    ordered.map(|(point, axis)| photons[point.number as usize].splitting(*axis)).collect()
}

/// The box around photons.
pub(super) fn extent(photons: &[Photon]) -> [Vec3; 2] {
    let nothing = || [Vec3::INFINITY, Vec3::NEG_INFINITY];
    let union = |[lo, hi]: [Vec3; 2], [low, high]: [Vec3; 2]| [lo.min(low), hi.max(high)];
    photons.par_iter().with_min_len(PARALLEL).map(|p| [p.position(); 2]).reduce(nothing, union)
}

/// Orders a range, and tells along which axis each of its nodes splits.
fn split(points: &mut [Point], axes: &mut [u8]) {
    if points.len() <= LEAF {
        points.sort_unstable_by_key(|p| p.number);
        return;
    }
    let axis = widest(points);
    let middle = points.len() / 2;
    match axis {
        0 => select::<0>(points, middle),
        1 => select::<1>(points, middle),
        _ => select::<2>(points, middle),
    }
    axes[middle] = axis;
    let parallel = points.len() >= PARALLEL;
    let (left, right) = points.split_at_mut(middle);
    let (left_axes, right_axes) = axes.split_at_mut(middle);
    let (right, right_axes) = (&mut right[1..], &mut right_axes[1..]);
    if parallel {
        rayon::join(|| split(left, left_axes), || split(right, right_axes));
    } else {
        split(left, left_axes);
        split(right, right_axes);
    }
}

/// The longest edge of the box around points; of equal ones the first.
fn widest(points: &[Point]) -> u8 {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in points {
        for axis in 0..3 {
            low[axis] = if p.at[axis] < low[axis] { p.at[axis] } else { low[axis] };
            high[axis] = if p.at[axis] > high[axis] { p.at[axis] } else { high[axis] };
        }
    }
    let edge = |axis: usize| high[axis] - low[axis];
    let first = if edge(1) > edge(0) { 1 } else { 0 };
    if edge(2) > edge(first) { 2 } else { first as u8 }
}

/// Brings to its place what stands there in the order along an axis, and lower points before it.
fn select<const AXIS: usize>(points: &mut [Point], middle: usize) {
    points.select_nth_unstable_by(middle, |a, b| {
        a.at[AXIS].total_cmp(&b.at[AXIS]).then(a.number.cmp(&b.number))
    });
}
