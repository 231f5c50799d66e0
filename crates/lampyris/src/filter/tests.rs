//! Planes made by hand, of which one knows what neighbours may share.

use super::seen::{Glimpse, Seen};
use super::{Kernel, Settings, Smooth};
use crate::color::Rgb;
use crate::eye::Rect;
use crate::sequence::uniform;
use glam::Vec3;

const WIDTH: u32 = 37;
const HEIGHT: u32 = 21;
const SLACK: f32 = 0.01;

/// What is seen at a pixel: vertex, normal, surface, tint, light.
type Pixel = (Vec3, Vec3, u32, Rgb, Rgb);

/// A picture whose pixels `at` says, put together from two pieces, by the light of two layers: one has half as much.
fn seen(at: impl Fn(u32, u32) -> Option<Pixel>) -> Seen {
    let pieces = [
        Rect { x: 0, y: 0, width: 20, height: HEIGHT },
        Rect { x: 20, y: 0, width: WIDTH - 20, height: HEIGHT },
    ];
    let glimpses = pieces.map(|rect| {
        let mut glimpse = Glimpse::new(rect, 2);
        let mut lit = vec![Rgb::BLACK; (rect.width * rect.height) as usize];
        for k in 0..rect.width * rect.height {
            let (x, y) = rect.pixel(k);
            if let Some((position, normal, alike, tint, light)) = at(x, y) {
                glimpse.place(k as usize, position, normal, tint, SLACK);
                glimpse.surface(k as usize, alike << 8);
                lit[k as usize] = tint * light;
            }
        }
        add(&mut glimpse, &lit);
        glimpse
    });
    let mut seen = Seen::new((WIDTH, HEIGHT), 2);
    assert_eq!(seen.append(0..HEIGHT, &[&glimpses[0], &glimpses[1]]), 0..HEIGHT);
    seen
}

/// Adds light to the first layer, and half as much to the second.
fn add(glimpse: &mut Glimpse, light: &[Rgb]) {
    glimpse.add_shared(0, light);
    glimpse.add_shared(1, &light.iter().map(|v| *v * 0.5).collect::<Vec<_>>());
}

fn tint(x: u32, y: u32) -> Rgb {
    let channel = |c: u32| 0.05 + 0.9 * uniform(c, x, y);
    Rgb::new(channel(1), channel(2), channel(3))
}

fn light(x: u32, y: u32) -> Rgb {
    Rgb::grey(1.0 + uniform(4, x, y))
}

fn floor(x: u32, y: u32) -> Vec3 {
    Vec3::new(x as f32, 0.0, y as f32)
}

/// Asserts that what `Smooth` finds is `expected`, by every kernel with the same bits; edges where `edge` says.
fn assert_smooth(
    seen: &Seen,
    interleave: [u32; 2],
    expected: impl Fn(u32, u32) -> Rgb,
    edge: impl Fn(u32, u32) -> bool,
) {
    let settings = Settings { interleave, ..Settings::interactive() };
    let plain = Smooth::new(Kernel::Portable, seen, 0..HEIGHT, &settings);
    for kernel in [Kernel::Avx2, Kernel::Avx512] {
        let other = Smooth::new(kernel, seen, 0..HEIGHT, &settings);
        assert_eq!(other.values, plain.values, "{kernel:?}");
    }
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let (found, expected) = (plain.at(0, x, y), expected(x, y));
            let off = (found - expected).map(f32::abs).max_channel();
            assert!(off < 1e-5, "({x}, {y}): {found:?} for {expected:?}");
            assert_eq!(plain.at(1, x, y), found * 0.5, "({x}, {y})");
            assert_eq!(plain.edge(x, y), edge(x, y), "({x}, {y})");
        }
    }
}

fn border(x: u32, y: u32) -> bool {
    x == 0 || y == 0 || x == WIDTH - 1 || y == HEIGHT - 1
}

#[test]
fn even_light_is_found_under_any_texture() {
    let textured = seen(|x, y| Some((floor(x, y), Vec3::Y, 1, tint(x, y), Rgb::new(0.5, 2.0, 3.0))));
    assert_smooth(&textured, [5, 5], |_, _| Rgb::new(0.5, 2.0, 3.0), border);
}

/// Also in a colour that some pixels do not reflect: of these nothing can be learned, and they do not darken others.
#[test]
fn pixels_that_reflect_nothing_say_nothing() {
    let striped = |x: u32| if x.is_multiple_of(3) { Rgb::new(0.5, 0.0, 0.0) } else { Rgb::grey(0.7) };
    let seen = seen(|x, y| Some((floor(x, y), Vec3::Y, 1, striped(x), Rgb::WHITE)));
    assert_smooth(&seen, [3, 3], |_, _| Rgb::WHITE, border);
}

/// Under an even texture light is the mean over the box, each class of the interleaving once.
#[test]
fn boxes_are_as_wide_as_the_interleaving() {
    let even = seen(|x, y| Some((floor(x, y), Vec3::Y, 1, Rgb::grey(0.6), light(x, y))));
    for [n, m] in [[1, 1], [3, 3], [5, 5], [5, 3]] {
        let mean = |x: u32, y: u32| {
            let columns = x.saturating_sub(n / 2)..(x + n / 2 + 1).min(WIDTH);
            let rows = y.saturating_sub(m / 2)..(y + m / 2 + 1).min(HEIGHT);
            let inside = || rows.clone().flat_map(|y| columns.clone().map(move |x| (x, y)));
            let sum = inside().fold(Rgb::BLACK, |sum, (x, y)| sum + light(x, y));
            sum * (1.0 / inside().count() as f32)
        };
        // Boxes of one pixel look at no neighbour.
        assert_smooth(&even, [n, m], mean, |x, y| border_within(x, y, [n, m]));
    }
}

fn border_within(x: u32, y: u32, [n, m]: [u32; 2]) -> bool {
    (n > 1 && (x == 0 || x == WIDTH - 1)) || (m > 1 && (y == 0 || y == HEIGHT - 1))
}

/// A floor and a wall, each evenly lit: no light crosses the corner between them.
#[test]
fn light_stays_on_its_side_of_a_corner() {
    let wall = |x: u32| x >= 17;
    let corner = seen(|x, y| {
        let tint = tint(x, y);
        Some(if wall(x) {
            (Vec3::new(16.5, x as f32 - 16.5, y as f32), Vec3::NEG_X, 2, tint, Rgb::grey(3.0))
        } else {
            (floor(x, y), Vec3::Y, 1, tint, Rgb::grey(1.0))
        })
    });
    let expected = |x, _| Rgb::grey(if wall(x) { 3.0 } else { 1.0 });
    assert_smooth(&corner, [5, 5], expected, |x, y| border(x, y) || x == 16 || x == 17);
}

/// Parallel surfaces are one if their distance is within the slack for each pixel between them, else two.
#[test]
fn steps_are_told_from_slopes() {
    let step = |height: f32| {
        seen(move |x, y| {
            let lift = Vec3::Y * if x < 17 { 0.0 } else { height };
            Some((floor(x, y) + lift, Vec3::Y, 1, Rgb::grey(0.5), Rgb::grey(if x < 17 { 1.0 } else { 2.0 })))
        })
    };
    let two = |x: u32, _: u32| Rgb::grey(if x < 17 { 1.0 } else { 2.0 });
    assert_smooth(&step(2.1 * SLACK), [5, 5], two, |x, y| border(x, y) || x == 16 || x == 17);
    let blurred = |x: u32, _: u32| match x {
        15 => Rgb::grey(6.0 / 5.0),
        16 => Rgb::grey(7.0 / 5.0),
        17 => Rgb::grey(8.0 / 5.0),
        18 => Rgb::grey(9.0 / 5.0),
        _ => two(x, 0),
    };
    assert_smooth(&step(0.9 * SLACK), [5, 5], blurred, border);
}

/// The void shares nothing, and another material on the same plane is an edge that light crosses.
#[test]
fn voids_and_seams() {
    let seen = seen(|x, y| {
        let material = if y < 10 { 1 } else { 2 };
        (x < 30).then(|| (floor(x, y), Vec3::Y, material, tint(x, y), Rgb::grey(2.0)))
    });
    let expected = |x: u32, _: u32| if x < 30 { Rgb::grey(2.0) } else { Rgb::BLACK };
    assert_smooth(&seen, [3, 3], expected, |x, y| border(x, y) || x >= 29 || y == 9 || y == 10);
}

/// Rows come in bands, and what is found does not depend on how they are cut.
#[test]
fn bands_leave_no_trace() {
    let bumpy = |x: u32, y: u32| {
        let lift = Vec3::Y * if (x / 5 + y / 3).is_multiple_of(2) { 0.0 } else { 0.05 };
        Some((floor(x, y) + lift, Vec3::Y, 1, tint(x, y), light(x, y)))
    };
    let whole = seen(bumpy);
    let settings = Settings { interleave: [5, 7], ..Settings::interactive() };
    let expected = Smooth::new(Kernel::Portable, &whole, 0..HEIGHT, &settings);
    for cuts in [vec![1, 2, 3, 4, 5, 6, 7, 20, 21], vec![10, 21], vec![3, 19, 21], vec![21]] {
        let mut parts = Seen::new((WIDTH, HEIGHT), 2);
        // A second picture follows the first in the same planes.
        for _ in 0..2 {
            let (mut start, mut done) = (0, 0);
            for end in &cuts {
                let rect = Rect { x: 0, y: start, width: WIDTH, height: end - start };
                let mut glimpse = Glimpse::new(rect, 2);
                let mut lit = vec![Rgb::BLACK; (rect.width * rect.height) as usize];
                for k in 0..rect.width * rect.height {
                    let (x, y) = rect.pixel(k);
                    let (position, normal, alike, tint, light) = bumpy(x, y).expect("a surface");
                    glimpse.place(k as usize, position, normal, tint, SLACK);
                    glimpse.surface(k as usize, alike << 8);
                    lit[k as usize] = tint * light;
                }
                add(&mut glimpse, &lit);
                let rows = parts.append(start..*end, &[&glimpse]);
                assert_eq!(rows.start, done);
                let found = Smooth::new(Kernel::Portable, &parts, rows.clone(), &settings);
                for y in
                    rows.start.saturating_sub(1)..if rows.is_empty() { 0 } else { (rows.end + 1).min(HEIGHT) }
                {
                    for x in 0..WIDTH {
                        let of = |s: &Smooth| (s.at(0, x, y), s.at(1, x, y), s.edge(x, y));
                        assert_eq!(of(&found), of(&expected), "({x}, {y}) of {cuts:?}");
                    }
                }
                (start, done) = (*end, rows.end);
            }
            assert_eq!(done, HEIGHT);
        }
    }
}
