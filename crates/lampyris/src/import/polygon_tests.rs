//! The theorems of `polygon`: triangles are as many as they must be, and cover exactly the outline's area.

use super::*;
use std::time::{Duration, Instant};

fn area_of(points: &[DVec2], triangles: &[[u32; 3]]) -> (f64, f64) {
    let areas = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        0.5 * (b - a).perp_dot(c - a)
    });
    areas.fold((0.0, 0.0), |(signed, absolute), a| (signed + a, absolute + a.abs()))
}

/// Σ|area| = Σ area = the outline's: no triangle is turned, none overlaps, none is missing.
fn assert_exact(points: &[DVec2], contours: &[usize]) -> Triangulation {
    let made = triangulate(points, contours);
    let mut start = 0;
    let mut want = 0.0;
    for (k, &end) in contours.iter().enumerate() {
        let ring: Vec<u32> = (start as u32..end as u32).collect();
        let area = 0.5 * signed_area(points, &ring).abs();
        want += if k == 0 { area } else { -area };
        start = end;
    }
    let (signed, absolute) = area_of(points, &made.triangles);
    assert!(made.simple, "{points:?}");
    assert_eq!(made.triangles.len(), points.len() + 2 * (contours.len() - 1) - 2);
    assert!(
        (signed - want).abs() <= 1e-9 * want && (absolute - want).abs() <= 1e-9 * want,
        "{signed} {absolute} {want}"
    );
    made
}

fn points(list: &[(f64, f64)]) -> Vec<DVec2> {
    list.iter().map(|&(x, y)| DVec2::new(x, y)).collect()
}

/// A pseudo-random number in [0, 1) that depends on its index alone.
fn noise(i: u32) -> f64 {
    let h = i.wrapping_mul(0x9E37_79B9) ^ (i >> 3).wrapping_mul(0x85EB_CA6B);
    f64::from((h ^ (h >> 15)).wrapping_mul(0x2C1B_3C6D) >> 8) / f64::from(1 << 24)
}

/// A star-shaped outline with random radii: about half its corners are reflex.
fn star(n: u32) -> Vec<DVec2> {
    (0..n)
        .map(|k| {
            let (sin, cos) = libm::sincos(f64::from(k) / f64::from(n) * std::f64::consts::TAU);
            DVec2::new(cos, sin) * (0.5 + noise(k))
        })
        .collect()
}

/// A square of `side²` square holes.
fn sieve(side: u32) -> (Vec<DVec2>, Vec<usize>) {
    let s = f64::from(side);
    let mut points = points(&[(0.0, 0.0), (s, 0.0), (s, s), (0.0, s)]);
    let mut contours = vec![4];
    for (x, y) in (0..side).flat_map(|x| (0..side).map(move |y| (f64::from(x), f64::from(y)))) {
        points
            .extend([(0.2, 0.2), (0.2, 0.8), (0.8, 0.8), (0.8, 0.2)].map(|(u, v)| DVec2::new(x + u, y + v)));
        contours.push(points.len());
    }
    (points, contours)
}

#[test]
fn convex_and_concave_outlines() {
    assert_exact(&points(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), &[3]);
    assert_exact(&points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]), &[6]);
    // An arrow head, whose only good diagonal starts at the reflex corner.
    assert_exact(&points(&[(0.0, 0.0), (2.0, 1.0), (0.0, 2.0), (1.0, 1.0)]), &[4]);
}

#[test]
fn corners_on_a_straight_edge() {
    assert_exact(&points(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (0.0, 2.0)]), &[6]);
    assert_exact(&points(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0), (0.0, 1.0)]), &[5]);
}

#[test]
fn star_shaped_outlines_of_any_size() {
    for n in [3, 4, 5, 10, 50, 333, 4000] {
        assert_exact(&star(n), &[n as usize]);
    }
}

#[test]
fn holes_are_left_open() {
    for side in [1, 2, 3, 7, 16] {
        let (points, contours) = sieve(side);
        assert_exact(&points, &contours);
    }
    // A hole given counter-clockwise is a hole all the same.
    let (mut points, contours) = sieve(1);
    points[4..].reverse();
    assert_exact(&points, &contours);
}

#[test]
fn a_seam_to_a_hole_in_the_outline_itself() {
    // One outline that goes to the hole and back by the same way, as `f` writes holes.
    let seam = points(&[
        (0.0, 0.0),
        (3.0, 0.0),
        (3.0, 3.0),
        (0.0, 3.0),
        (0.0, 0.0),
        (1.0, 1.0),
        (1.0, 2.0),
        (2.0, 2.0),
        (2.0, 1.0),
        (1.0, 1.0),
    ]);
    let made = triangulate(&seam, &[10]);
    let (signed, absolute) = area_of(&seam, &made.triangles);
    assert_eq!(made.triangles.len(), 8);
    assert!(
        made.simple && (signed - 8.0).abs() < 1e-12 && (absolute - 8.0).abs() < 1e-12,
        "{signed} {absolute}"
    );
}

#[test]
fn crossed_outlines_end_with_as_many_triangles() {
    let bow = points(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!(triangulate(&bow, &[4]).triangles.len(), 2);
    for n in [100u32, 1000, 20_000] {
        let scribble: Vec<_> = (0..n).map(|i| DVec2::new(noise(2 * i), noise(2 * i + 1))).collect();
        let made = triangulate(&scribble, &[n as usize]);
        assert_eq!((made.triangles.len(), made.simple), (n as usize - 2, false));
    }
    let same = vec![DVec2::ONE; 50];
    assert_eq!(triangulate(&same, &[50]).triangles.len(), 48);
}

#[test]
fn flattening_keeps_the_sense_of_turning() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    for turn in [glam::DMat3::IDENTITY, glam::DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X)] {
        for mirror in [1.0, -1.0] {
            let placed = corners.map(|p| turn * p * mirror);
            let n = vector_area(&placed);
            assert!((n.length() - 1.0).abs() < 1e-12);
            assert!(signed_area(&flatten(&placed, n), &[0, 1, 2]) > 0.0);
            assert!(signed_area(&flatten(&placed, -n), &[0, 1, 2]) < 0.0);
        }
    }
}

#[test]
fn sixty_thousand_corners_do_not_take_their_square() {
    let n = 60_000;
    let tooth = |k: u32| {
        let height = if k.is_multiple_of(2) { 0.0 } else { f64::from(n) * (0.5 + noise(k)) };
        DVec2::new(f64::from(k), height)
    };
    let mut comb: Vec<_> = (0..n - 1).map(tooth).collect();
    comb.push(DVec2::new(0.5 * f64::from(n), -1.0));
    comb.reverse();
    for outline in [star(n), comb] {
        let start = Instant::now();
        assert!(triangulate(&outline, &[n as usize]).simple);
        // Measured: 0.1 s. Each of n corners against each of n/2 reflex ones would take ten seconds and more.
        assert!(start.elapsed() < Duration::from_secs(3), "{:?}", start.elapsed());
    }
}
