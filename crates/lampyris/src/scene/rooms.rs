//! Rooms of a storey: which room a standing place is in, and which room a point of a surface belongs to. Doors part rooms;
//! whatever is wide enough to be no door does not.

use crate::geometry::{Hit, Ray};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::TAU;

/// Places of a storey that say what can be seen of it, and at least one of each room.
const WITNESSES: usize = 32;

/// Directions in which it is felt out whether a place is wide.
const FEELERS: usize = 64;

/// Finds the nearest hit of a ray.
type Trace<'a> = &'a (dyn Fn(&Ray) -> Option<Hit> + Sync);

/// The rooms that one gets about in without passing a door.
pub(super) struct Rooms<'a> {
    trace: Trace<'a>,
    /// Wide places and the room of each.
    middles: Vec<(Vec3, usize)>,
    /// Some of them, room by room.
    witnesses: Vec<Vec<Vec3>>,
}

/// Whether a point is in sight of a place.
pub(super) fn sees(trace: Trace<'_>, eye: Vec3, point: Vec3) -> bool {
    trace(&Ray::new(eye, point - eye)).is_some_and(|h| (h.t - 1.0).abs() < 1e-3)
}

/// Whether nothing is in the way.
fn free(trace: Trace<'_>, from: Vec3, way: Vec3) -> bool {
    trace(&Ray::new(from, way)).is_none_or(|hit| hit.t >= 1.0)
}

impl<'a> Rooms<'a> {
    /// Of places at eye height those are wide around which a disc as wide as a `door` [m] is free; two of them are in one
    /// room if the disc can be moved straight from one to the other, or by way of further ones. Where no place is wide all
    /// are taken to be.
    pub(super) fn new(trace: Trace<'a>, up: Vec3, eyes: &[Vec3], door: f32) -> Rooms<'a> {
        let (right, ahead) = up.any_orthonormal_pair();
        let wide = |eye: &Vec3| {
            let angles = (0..FEELERS).map(|k| TAU * k as f32 / FEELERS as f32);
            angles.map(libm::sincosf).all(|(s, c)| free(trace, *eye, (right * c + ahead * s) * (0.5 * door)))
        };
        let mut places: Vec<Vec3> = eyes.par_iter().copied().filter(wide).collect();
        let anywhere = places.is_empty();
        if anywhere {
            places = eyes.to_vec();
        }
        let leads = |from: Vec3, to: Vec3| {
            let side = (to - from).cross(up).normalize_or_zero() * (0.5 * door);
            [Vec3::ZERO, side, -side].into_iter().all(|off| free(trace, from + off, to - from))
        };
        let (mut middles, mut witnesses) = (Vec::new(), Vec::new());
        let step = places.len().div_ceil(WITNESSES).max(1);
        while let Some(first) = places.pop() {
            let (number, mut room, mut reached) = (witnesses.len(), vec![first], vec![first]);
            while let Some(from) = reached.pop() {
                let (next, rest): (Vec<Vec3>, Vec<Vec3>) =
                    places.into_par_iter().partition(|to| anywhere || leads(from, *to));
                places = rest;
                room.extend(&next);
                reached.extend(next);
            }
            middles.extend(room.iter().map(|eye| (*eye, number)));
            witnesses.push(room.into_iter().step_by(step).collect());
        }
        Rooms { trace, middles, witnesses }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.witnesses.len()
    }

    /// The room of a place at eye height: that of the nearest wide place in sight.
    pub(super) fn at(&self, eye: Vec3) -> Option<usize> {
        let distance = |(middle, _): &&(Vec3, usize)| middle.distance_squared(eye);
        let seen = self.middles.iter().filter(|(middle, _)| free(self.trace, eye, *middle - eye));
        seen.min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|(_, room)| *room)
    }

    /// The room of a point of a surface, `None` if no place sees it: what several rooms see, some of them through doors, is
    /// of that most of whose places see it.
    pub(super) fn home(&self, point: Vec3) -> Option<usize> {
        let share = |eyes: &Vec<Vec3>| {
            eyes.iter().filter(|eye| sees(self.trace, **eye, point)).count() as f32 / eyes.len() as f32
        };
        let shares = self.witnesses.iter().map(share).enumerate().filter(|(_, share)| *share > 0.0);
        shares.reduce(|a, b| if b.1 > a.1 { b } else { a }).map(|(room, _)| room)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall in the plane x = 0 with a passage from y = 0 to a width, between walls at x = −3 and x = 3.
    fn wall(width: f32) -> impl Fn(&Ray) -> Option<Hit> + Sync {
        move |ray| {
            let at = |x: f32| (x - ray.origin.x) / ray.direction.x;
            let shut = |x: f32, t: f32| {
                let y = ray.origin.y + t * ray.direction.y;
                x != 0.0 || !(0.0..width).contains(&y)
            };
            let hits = [-3.0, 0.0, 3.0].map(|x| (x, at(x)));
            let first = hits.into_iter().filter(|(x, t)| *t > 0.0 && shut(*x, *t)).map(|(_, t)| t);
            first.reduce(f32::min).map(|t| Hit { t, u: 0.0, v: 0.0, instance: 0, triangle: 0 })
        }
    }

    fn eyes() -> Vec<Vec3> {
        (0..80).map(|k| Vec3::new((k % 10) as f32 * 0.6 - 2.7, (k / 10) as f32 * 0.6 - 2.1, 1.6)).collect()
    }

    #[test]
    fn doors_part_rooms_and_wider_passages_do_not() {
        for (width, count) in [(0.0, 2), (1.2, 2), (2.2, 1), (4.0, 1)] {
            let trace = wall(width);
            let rooms = Rooms::new(&trace, Vec3::Z, &eyes(), 1.4);
            assert_eq!(rooms.count(), count, "{width} m");
            let [left, right] = [-2.7, 2.7].map(|x| rooms.at(Vec3::new(x, 0.0, 1.6)));
            assert_eq!(left == right, count == 1, "{width} m");
            // Before the wall, too, where no disc has room; but in the opening one may be in either.
            for eye in eyes().into_iter().filter(|eye| eye.y < -0.5) {
                assert_eq!(rooms.at(eye), if eye.x < 0.0 { left } else { right }, "{eye} at {width} m");
            }
        }
        let narrow = wall(0.9);
        let row: Vec<Vec3> = (0..10).map(|k| Vec3::new(-2.7 + 0.2 * k as f32, 3.0, 1.6)).collect();
        let rooms = Rooms::new(&narrow, Vec3::Z, &row, 9.0);
        assert_eq!((rooms.count(), rooms.at(row[3])), (1, Some(0)));
    }

    #[test]
    fn what_is_seen_through_a_door_is_not_of_this_room() {
        let trace = wall(0.9);
        let rooms = Rooms::new(&trace, Vec3::Z, &eyes(), 1.4);
        // Places near y = 0.4 of either room see both of these points.
        for x in [-3.0, 3.0] {
            let home = rooms.home(Vec3::new(x, 0.4, 1.6));
            assert!(home.is_some() && home == rooms.at(Vec3::new(0.9 * x, 0.4, 1.6)));
        }
        assert_eq!(rooms.home(Vec3::new(4.0, 0.4, 1.6)), None);
        assert!(sees(&trace, Vec3::new(2.0, 0.4, 1.6), Vec3::new(-3.0, 0.4, 1.6)));
    }
}
