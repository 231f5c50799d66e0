//! Surface elements A_k: facets cut into parts, numbered on each of their sides, and the light that the walk of 1996 leaves on
//! them [Keller96, §4.2–4.3; docs/light-transport.md, "The walk of 1996"].
//!
//! A facet is halved at the middle of its longest edge, and each half again, so that all parts of a facet have one area, and
//! none is thinner than half of what it was cut from. Which part a hit lies in, its barycentric coordinates tell;
//! nothing is stored of a part but its area.
//!
//! An element knows no directions: what the dull lobes of its material send on counts as if it left by Lambert's law.

mod converge;
mod cube;
mod light;

pub use converge::{Converged, Criterion, converge};
pub use cube::{ClosedCube, CubeRun};
pub use light::ElementLight;
pub(crate) use light::shares;

use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::geometry::Hit;
use crate::material::Sides;
use crate::world::World;
use glam::Vec3;

/// Elements that a scene may be cut into.
pub const MOST_ELEMENTS: usize = 1 << 24;

/// Halvings of one facet at most.
const MOST_HALVINGS: u32 = 24;

/// The surface of a world, cut into elements.
#[derive(Clone, Debug)]
pub struct Elements {
    /// Of each instance, where its facets begin in `facets`; one more at the end.
    starts: Vec<u32>,
    facets: Vec<Cut>,
    /// [m²]
    areas: Vec<f32>,
}

/// How one facet is cut.
#[derive(Clone, Copy, Debug)]
struct Cut {
    /// Number of its first element.
    first: u32,
    halvings: u8,
    two_sided: bool,
}

impl Elements {
    /// Parts none of whose edges is longer than `size` [m]; infinite leaves facets whole. An error if they are too
    /// many, or of no size.
    pub fn new(world: &World, size: f32) -> Result<Elements> {
        let too_many = || {
            Error::BadSetting(format!("elements of {size} m are more than {MOST_ELEMENTS}: make them larger"))
        };
        if size.is_nan() || size <= 0.0 {
            return Err(Error::BadSetting(format!("elements of {size} m: their size is more than nothing")));
        }
        let fine = |corners: &[Vec3; 3], n: u32| {
            (0..1 << n).all(|part| longest(&part_of(corners, part, n).0).1 <= size * size)
        };
        let halvings = |corners: &[Vec3; 3]| (0..MOST_HALVINGS).find(|n| fine(corners, *n));
        Elements::cut(world, &halvings).ok_or_else(too_many)
    }

    /// Every facet halved so many times; an error if elements are too many.
    pub fn halved(world: &World, halvings: u32) -> Result<Elements> {
        Elements::cut(world, &|_| (halvings < MOST_HALVINGS).then_some(halvings)).ok_or_else(|| {
            Error::BadSetting(format!("{halvings} halvings make more than {MOST_ELEMENTS} elements"))
        })
    }

    /// By the number of halvings that each facet needs; `None` where one needs too many.
    fn cut(world: &World, halvings: &dyn Fn(&[Vec3; 3]) -> Option<u32>) -> Option<Elements> {
        let mut all = Elements { starts: Vec::new(), facets: Vec::new(), areas: Vec::new() };
        for instance in 0..world.scene().instances.len() as u32 {
            all.starts.push(all.facets.len() as u32);
            for triangle in 0..world.facets().count(instance) {
                all.push(world, [instance, triangle], halvings)?;
            }
        }
        all.starts.push(all.facets.len() as u32);
        Some(all)
    }

    fn push(
        &mut self,
        world: &World,
        [instance, triangle]: [u32; 2],
        halvings: &dyn Fn(&[Vec3; 3]) -> Option<u32>,
    ) -> Option<()> {
        let facet = world.facets().get(instance, triangle);
        let [a, b, c] = facet.corners;
        let area = 0.5 * (b - a).cross(c - a).length();
        let halvings = if area > 0.0 && area.is_finite() { halvings(&facet.corners)? } else { 0 };
        let two_sided = world.scene().materials[facet.material as usize].sides != Sides::FrontOnly;
        let count = (1_usize << halvings) * if two_sided { 2 } else { 1 };
        let first = self.areas.len();
        if first + count > MOST_ELEMENTS {
            return None;
        }
        self.facets.push(Cut { first: first as u32, halvings: halvings as u8, two_sided });
        let area = if area.is_finite() { area / (1_u32 << halvings) as f32 } else { 0.0 };
        self.areas.resize(first + count, area);
        Some(())
    }

    /// K, how many there are: sides that are there, glowing or not.
    pub fn len(&self) -> usize {
        self.areas.len()
    }

    /// True if nothing has a surface.
    pub fn is_empty(&self) -> bool {
        self.areas.is_empty()
    }

    /// |A_k| [m²].
    pub fn area(&self, element: u32) -> f32 {
        self.areas[element as usize]
    }

    /// L_{0,k}: the radiance that the element sends out itself, asked in its middle [cd/m²].
    pub fn emission(&self, world: &World, element: u32) -> Rgb {
        let place = self.facets.partition_point(|cut| cut.first <= element) - 1;
        let cut = self.facets[place];
        // The last that begins there or before: those without facets begin where the next one does.
        let instance = self.starts.partition_point(|start| *start as usize <= place) - 1;
        let triangle = place as u32 - self.starts[instance];
        let facet = world.facets().get(instance as u32, triangle);
        let number = element - cut.first;
        let (part, side) = match cut.two_sided {
            true => (number / 2, if number.is_multiple_of(2) { 1.0 } else { -1.0 }),
            false => (number, 1.0),
        };
        let (_, weights) = part_of(&facet.corners, part, cut.halvings.into());
        let middle = |k: usize| weights.iter().map(|w| w[k]).sum::<f32>() / 3.0;
        let hit = Hit { t: 0.0, u: middle(1), v: middle(2), instance: instance as u32, triangle };
        world.surface(facet.normal * -side, &hit).emission()
    }

    /// Σ |A_k| [m²].
    pub fn total_area(&self) -> f64 {
        self.areas.iter().map(|a| f64::from(*a)).sum()
    }

    /// The element that a hit lies in, on the front or on the back; `None` on the back of what has none.
    pub fn at(&self, world: &World, hit: &Hit, front: bool) -> Option<u32> {
        let start = *self.starts.get(hit.instance as usize)?;
        let cut = self.facets.get(start as usize + hit.triangle as usize)?;
        let part = match cut.halvings {
            0 => 0,
            n => {
                let corners = world.facets().get(hit.instance, hit.triangle).corners;
                part_at(&corners, [1.0 - hit.u - hit.v, hit.u, hit.v], u32::from(n))
            }
        };
        match (cut.two_sided, front) {
            (true, _) => Some(cut.first + 2 * part + u32::from(!front)),
            (false, true) => Some(cut.first + part),
            (false, false) => None,
        }
    }
}

/// The corner that the longest edge lies opposite to, the first of several, and the square of that edge's length.
fn longest(corners: &[Vec3; 3]) -> (usize, f32) {
    let edge = |k: usize| (corners[(k + 1) % 3] - corners[(k + 2) % 3]).length_squared();
    let pick = |best: (usize, f32), k: usize| if edge(k) > best.1 { (k, edge(k)) } else { best };
    (1..3).fold((0, edge(0)), pick)
}

/// Corners of part number `part` after `n` halvings, in space and as weights of the facet's corners.
fn part_of(corners: &[Vec3; 3], part: u32, n: u32) -> ([Vec3; 3], [[f32; 3]; 3]) {
    let mut corners = *corners;
    let mut weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for level in (0..n).rev() {
        let apex = longest(&corners).0;
        let (a, b) = ((apex + 1) % 3, (apex + 2) % 3);
        let middle = (corners[a] + corners[b]) * 0.5;
        let mean = std::array::from_fn(|k| 0.5 * (weights[a][k] + weights[b][k]));
        let moved = if part >> level & 1 == 0 { b } else { a };
        (corners[moved], weights[moved]) = (middle, mean);
    }
    (corners, weights)
}

/// The number of the part in which a point of the given weights lies.
fn part_at(corners: &[Vec3; 3], weights: [f32; 3], n: u32) -> u32 {
    let (mut corners, mut w, mut part) = (*corners, weights, 0);
    for _ in 0..n {
        let apex = longest(&corners).0;
        let (a, b) = ((apex + 1) % 3, (apex + 2) % 3);
        let middle = (corners[a] + corners[b]) * 0.5;
        // Nearer to a than to b: b's weight moves to the middle, and as much of a's.
        let second = w[b] > w[a];
        let (near, far) = if second { (b, a) } else { (a, b) };
        (w[near], w[far]) = (w[near] - w[far], 2.0 * w[far]);
        corners[far] = middle;
        part = part << 1 | u32::from(second);
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::uniform;

    #[test]
    fn a_point_is_found_in_the_part_that_it_was_put_into() {
        let triangles = [
            [Vec3::ZERO, Vec3::X, Vec3::Y],
            [Vec3::ZERO, Vec3::X, Vec3::new(0.5, 0.75_f32.sqrt(), 0.0)],
            [Vec3::ZERO, Vec3::new(7.0, 1.0, 0.0), Vec3::new(3.0, 0.5, 0.1)],
        ];
        for corners in &triangles {
            for n in 0..8 {
                let area = |c: &[Vec3; 3]| 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).length();
                for part in 0..1 << n {
                    let (sub, weights) = part_of(corners, part, n);
                    assert!((area(&sub) * (1 << n) as f32 / area(corners) - 1.0).abs() < 1e-3);
                    // Anywhere within, but for the rounding at the rim.
                    let r = [1, 2, 3].map(|d| 0.05 + uniform(n, part, d));
                    let sum: f32 = r.iter().sum();
                    let at = std::array::from_fn(|k| (0..3).map(|c| r[c] / sum * weights[c][k]).sum());
                    assert_eq!(part_at(corners, at, n), part, "{corners:?}, {n}");
                }
            }
        }
    }

    #[test]
    fn halves_of_a_right_triangle_are_right_triangles() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for n in 0..10 {
            for part in 0..1 << n {
                let (sub, _) = part_of(&corners, part, n);
                let longest = longest(&sub).1;
                assert!((longest * (1 << n) as f32 - 2.0).abs() < 1e-5, "{n}, {part}: {longest}");
            }
        }
    }
}
