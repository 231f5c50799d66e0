//! Facts about photon maps: the tree is one, searches find what a look at all photons finds, and estimates of even light
//! are right in the mean.

use super::{Estimate, Kernel, Nearest, Past, Photon, PhotonMap, Precomputed, Reach, Reader};
use crate::color::Rgb;
use crate::sequence;
use crate::testing::{Moments, sidak};
use glam::Vec3;

fn random(i: u32, d: u32) -> f32 {
    sequence::uniform(11, i, d)
}

/// Photons of 1 lm at places, from above.
fn map(places: impl IntoIterator<Item = Vec3>) -> PhotonMap {
    let photon = |p| Photon::new(p, Vec3::Y, Vec3::Y, Rgb::WHITE, Past::default());
    PhotonMap::new(places.into_iter().map(photon).collect())
}

/// Clouds that trees find easy or hard, of so many points.
fn clouds(count: u32) -> Vec<(&'static str, Vec<Vec3>)> {
    let all = |place: &dyn Fn(u32) -> Vec3| (0..count).map(place).collect();
    let cube = |i: u32| Vec3::new(random(i, 0), random(i, 1), random(i, 2));
    vec![
        ("a cube", all(&cube)),
        ("a plane", all(&|i| Vec3::new(random(i, 0) * 3.0, -1.0, random(i, 2)))),
        ("a line", all(&|i| Vec3::new(1.0, 2.0, random(i, 0)))),
        ("a slanted line", all(&|i| Vec3::splat(random(i, 0)) * Vec3::new(1.0, -2.0, 0.5))),
        ("one point", all(&|_| Vec3::new(0.3, 0.3, 0.3))),
        ("few points", all(&|i| (cube(i) * 3.0).floor())),
        ("a dense corner", all(&|i| cube(i) * cube(i) * cube(i) * cube(i))),
    ]
}

#[test]
fn every_range_is_split_in_the_middle_of_its_longest_edge() {
    fn check(photons: &[Photon]) {
        if photons.len() <= super::tree::LEAF {
            return;
        }
        let [low, high] = super::tree::extent(photons);
        let (left, rest) = photons.split_at(photons.len() / 2);
        let (node, right) = rest.split_first().unwrap();
        assert!(left.len() == right.len() || left.len() == right.len() + 1);
        let (edges, axis) = (high - low, node.axis());
        assert_eq!(edges[axis], edges.max_element());
        assert!(left.iter().all(|p| p.position()[axis] <= node.position()[axis]));
        assert!(right.iter().all(|p| p.position()[axis] >= node.position()[axis]));
        check(left);
        check(right);
    }
    let bits = |p: Vec3| p.to_array().map(f32::to_bits);
    for count in (0..80).chain([1000, 4095, 4096, 20_000]) {
        for (name, places) in clouds(count) {
            let map = map(places.clone());
            check(map.photons());
            let mut there: Vec<_> = map.photons().iter().map(|p| bits(p.position())).collect();
            let mut given: Vec<_> = places.into_iter().map(bits).collect();
            there.sort_unstable();
            given.sort_unstable();
            assert_eq!(there, given, "{name}");
        }
    }
}

#[test]
fn equal_photons_make_equal_maps_on_any_number_of_threads() {
    for (name, places) in clouds(50_000) {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let flux = |i: usize| Rgb::new(i as f32, 1.0, -2.0);
            let photon = |(i, p): (usize, &Vec3)| Photon::new(*p, Vec3::Y, Vec3::X, flux(i), Past::default());
            let photons: Vec<Photon> = places.iter().enumerate().map(photon).collect();
            pool.install(|| PhotonMap::new(photons))
        };
        let one = on(1);
        assert!(one == on(2) && one == on(16), "{name}");
    }
}

#[test]
fn what_lies_nowhere_is_left_out() {
    let map = map([Vec3::X, Vec3::NAN, Vec3::INFINITY, Vec3::Y, Vec3::new(0.0, f32::NEG_INFINITY, 0.0)]);
    assert_eq!(map.photons().len(), 2);
    for nowhere in [Vec3::NAN, Vec3::INFINITY] {
        map.within(nowhere, 1e9, |_, _, _| unreachable!());
        assert_eq!(map.closest(nowhere, 1e9, |_, _| true), None);
    }
    let empty = PhotonMap::new(Vec::new());
    for radius in [0.0, 1.0, f32::INFINITY] {
        empty.within(Vec3::ZERO, radius, |_, _, _| unreachable!());
        assert_eq!(empty.closest(Vec3::ZERO, radius, |_, _| true), None);
        for reach in [Reach::Within(radius), Reach::Nearest { count: 5, within: radius }] {
            let mut reader = Reader::new(&empty, Estimate { kernel: Kernel::Cone, reach });
            assert!(reader.irradiance(Vec3::ZERO, Vec3::Y).is_black());
        }
    }
}

/// All searches against a look at all photons, to the bit, at 14 000 places.
#[test]
fn searches_find_what_a_look_at_all_photons_finds() {
    let mut asked = 0;
    for count in [1, 7, 32, 33, 65, 100, 1500] {
        for (name, places) in clouds(count) {
            let map = map(places);
            for i in 0..290_u32 {
                let near = map.photons()[(i * 7) as usize % map.photons().len()].position();
                let jump = Vec3::new(random(i, 8), random(i, 9), random(i, 10)) - 0.5;
                let x = match i % 4 {
                    0 => near,
                    1 => near + jump * 0.05,
                    2 => near + jump,
                    _ => jump * 20.0,
                };
                let radius = [0.0, 0.01, 0.1, 0.5, 3.0, f32::INFINITY][i as usize % 6];
                let key =
                    |(number, p): (u32, &Photon)| (((x - p.position()).length_squared()).to_bits(), number);
                let mut all: Vec<(u32, u32)> = (0..).zip(map.photons()).map(key).collect();
                all.retain(|(distance2, _)| f32::from_bits(*distance2) <= radius * radius);
                all.sort_unstable();

                let mut found = Vec::new();
                map.within(x, radius, |number, p, distance2| {
                    assert_eq!(map.photons()[number as usize], *p);
                    found.push((distance2.to_bits(), number));
                });
                found.sort_unstable();
                assert_eq!(found, all, "{count} in {name}, {radius} m around {x}");

                let most = [0, 1, 2, 5, 50, 3000][i as usize / 6 % 6];
                let wanted = |number: u32| number.is_multiple_of(1 + i % 3);
                all.retain(|(_, number)| wanted(*number));
                let mut nearest = Nearest::new(most);
                map.nearest(x, radius, &mut nearest, |number, _, _| wanted(number));
                let farthest = nearest.found().next();
                let mut found: Vec<(u32, u32)> = nearest.found().map(|(k, d)| (d.to_bits(), k)).collect();
                found.sort_unstable();
                assert_eq!(found, all[..all.len().min(most)], "{most} of {count} in {name} at {x}");
                if nearest.is_full() {
                    assert_eq!(farthest.map(|(k, d)| (d.to_bits(), k)), found.last().copied());
                }
                let closest = map.closest(x, radius, |number, _| wanted(number));
                assert_eq!(closest, all.first().map(|(_, number)| *number));
                asked += 1;
            }
        }
    }
    assert!(asked >= 10_000, "{asked}");
}

/// One photon seen through each kernel over a fixed radius: ∫ E dA is its flux, to within what a midpoint rule of 600²
/// steps errs at the rim of the constant one.
#[test]
fn a_photon_gives_its_flux_and_no_more() {
    const STEPS: u32 = 600;
    let n = Vec3::new(0.3, 0.8, -0.5).normalize();
    let frame = crate::geometry::Frame::new(n);
    let (r, position) = (0.3, Vec3::new(4.0, -2.0, 1.0));
    let map = PhotonMap::new(vec![Photon::new(position, n, n, Rgb::new(1.0, -0.5, 0.0), Past::default())]);
    let step = 2.4 * r / STEPS as f32;
    for kernel in Kernel::ALL {
        let mut reader = Reader::new(&map, Estimate { kernel, reach: Reach::Within(r) });
        let mut sum = [0.0_f64; 3];
        for k in 0..STEPS * STEPS {
            let [x, y] = [k / STEPS, k % STEPS].map(|k| (k as f32 + 0.5) * step - 1.2 * r);
            let e = reader.irradiance(position + frame.s * x + frame.t * y, n);
            (0..3).for_each(|c| sum[c] += f64::from(e[c] * step * step));
        }
        let error = (sum[0] - 1.0).abs().max((sum[1] + 0.5).abs()).max(sum[2].abs());
        assert!(error < 1e-3, "{kernel:?}: {sum:?}");
        assert!(reader.irradiance(position, -n).is_black());
    }
}

/// Photons strewn at random over a plane, 1 lm each: every kernel over a radius and over the nearest gives their density in
/// the mean. Of 64 independent maps, Student's t, corrected for the number of forms.
#[test]
fn even_light_is_even_in_the_mean_by_every_kernel() {
    const PHOTONS: u32 = 2000;
    let reaches = [
        Reach::Within(0.15),
        // Of three the variance is that of 1/r², which would be infinite of two.
        Reach::Nearest { count: 4, within: 9.0 },
        Reach::Nearest { count: 50, within: 9.0 },
        // Ten lie there in the mean: now the nearest set the radius, now it is the limit.
        Reach::Nearest { count: 10, within: 0.08 },
        Reach::Nearest { count: 3000, within: 0.2 },
    ];
    let forms: Vec<Estimate> = reaches
        .iter()
        .flat_map(|reach| Kernel::ALL.map(|kernel| Estimate { kernel, reach: *reach }))
        .collect();
    let mut moments = vec![Moments::default(); forms.len()];
    for draw in 0..64_u32 {
        let place = |i: u32| {
            let [x, z] = [0, 1].map(|d| 2.0 * sequence::uniform(draw + 1, i, d) - 1.0);
            Vec3::new(x, 0.0, z)
        };
        let map = map((0..PHOTONS).map(place));
        for (form, moments) in forms.iter().zip(&mut moments) {
            let mut reader = Reader::new(&map, *form);
            // Nine places, far from the rim.
            let at = |k: u32| Vec3::new((k % 3) as f32 * 0.4 - 0.4, 0.0, (k / 3) as f32 * 0.4 - 0.4);
            let mean = (0..9).map(|k| f64::from(reader.irradiance(at(k), Vec3::Y).g)).sum::<f64>() / 9.0;
            moments.push(mean / (f64::from(PHOTONS) / 4.0));
        }
    }
    for (form, moments) in forms.iter().zip(&moments) {
        let p = moments.p_value(1.0);
        assert!(p > sidak(0.01, forms.len()), "{form:?}: {} ± {}", moments.mean(), moments.standard_error());
        assert!(moments.standard_error() < 0.1, "{form:?} says nothing: {}", moments.standard_error());
    }
}

/// A wall of a millimetre lit on one side alone, a floor that meets it, a shelf above the floor: none gets the others' light.
#[test]
fn light_stays_on_its_surface() {
    let mut photons = Vec::new();
    let mut lay = |place: &dyn Fn(f32, f32) -> Vec3, normal: Vec3, flux: Rgb| {
        for i in 0..4000 {
            let p = place(random(i, 3), random(i, 4));
            photons.push(Photon::new(p, normal, normal, flux, Past::default()));
        }
    };
    lay(&|u, v| Vec3::new(u, v, 0.0), Vec3::Z, Rgb::new(1.0, 0.0, 0.0));
    lay(&|u, v| Vec3::new(u, 0.0, v), Vec3::Y, Rgb::new(0.0, 1.0, 0.0));
    lay(&|u, v| Vec3::new(u, 0.08, 0.2 + v), Vec3::Y, Rgb::new(0.0, 0.0, 1.0));
    let map = PhotonMap::new(photons);
    for reach in [Reach::Within(0.1), Reach::Nearest { count: 40, within: 0.1 }] {
        for kernel in Kernel::ALL {
            let mut reader = Reader::new(&map, Estimate { kernel, reach });
            let front = reader.irradiance(Vec3::new(0.5, 0.05, 0.0), Vec3::Z);
            assert!(front.r > 1000.0 && front.g == 0.0 && front.b == 0.0, "{front:?}");
            assert!(reader.irradiance(Vec3::new(0.5, 0.3, -1e-3), Vec3::NEG_Z).is_black());
            let floor = reader.irradiance(Vec3::new(0.5, 0.0, 0.05), Vec3::Y);
            assert!(floor.g > 1000.0 && floor.r == 0.0 && floor.b == 0.0, "{floor:?}");
            let shelf = reader.irradiance(Vec3::new(0.5, 0.08, 0.5), Vec3::Y);
            assert!(shelf.b > 1000.0 && shelf.r == 0.0, "{shelf:?}");
        }
    }
}

/// More photons in one place than are asked for, and none at all: finite, and nothing.
#[test]
fn degenerate_places_have_finite_light() {
    let map = map((0..100).map(|_| Vec3::X));
    for kernel in Kernel::ALL {
        for reach in [Reach::Nearest { count: 10, within: 1.0 }, Reach::Within(0.0)] {
            let mut reader = Reader::new(&map, Estimate { kernel, reach });
            assert!(reader.irradiance(Vec3::X, Vec3::Y).is_finite());
            assert!(reader.irradiance(Vec3::ZERO, Vec3::Y).is_finite());
        }
        let few = Estimate { kernel, reach: Reach::Nearest { count: u32::MAX, within: f32::INFINITY } };
        assert!(Reader::new(&map, few).irradiance(Vec3::X, Vec3::Y).is_finite());
    }
}

/// What is kept at every k-th photon is the estimate there, and a look-up gives what is kept at the nearest of them on the
/// same side.
#[test]
fn what_is_kept_at_photons_is_found_again() {
    let place = |i: u32| Vec3::new(2.0 * random(i, 0), 0.0, 2.0 * random(i, 1));
    let estimate = Estimate { kernel: Kernel::Cone, reach: Reach::Nearest { count: 30, within: 1.0 } };
    for every in [1, 4] {
        let kept = Precomputed::new(map((0..20_000).map(place)), every, estimate);
        let photons = kept.map().photons();
        let (values, step) = kept.values();
        assert_eq!((values.len(), step), (photons.len().div_ceil(every as usize), every));
        let mut reader = Reader::new(kept.map(), estimate);
        for (value, photon) in values.iter().zip(photons.iter().step_by(every as usize)) {
            assert_eq!(*value, reader.irradiance(photon.position(), Vec3::Y));
        }
        for i in 0..1000 {
            let x = Vec3::new(2.0 * random(i, 5), 0.001, 2.0 * random(i, 6));
            let far = |k: usize| (photons[k].position() - x).length_squared();
            let nearest =
                (0..photons.len()).step_by(every as usize).min_by(|a, b| far(*a).total_cmp(&far(*b)));
            let expected = nearest.map(|k| values[k / every as usize]);
            assert_eq!(kept.irradiance(x, Vec3::Y, 1.0), expected);
            assert_eq!(kept.irradiance(x, Vec3::NEG_Y, 1.0), None);
            assert_eq!(kept.irradiance(x + Vec3::Y, Vec3::Y, 0.5), None);
        }
    }
}

/// Photons strewn at random, 1 lm each: what look-ups anywhere find is their density in the mean, by the constant kernel exactly.
#[test]
fn look_ups_are_right_in_the_mean() {
    const PHOTONS: u32 = 1500;
    let reaches = [Reach::Within(0.2), Reach::Nearest { count: 50, within: 9.0 }];
    for every in [1, 4] {
        for reach in reaches {
            let estimate = Estimate { kernel: Kernel::Constant, reach };
            let draw = |draw: u32| {
                let place = |i: u32| {
                    let [x, z] = [0, 1].map(|d| 2.0 * sequence::uniform(draw + 1, i, d) - 1.0);
                    Vec3::new(x, 0.0, z)
                };
                let kept = Precomputed::new(map((0..PHOTONS).map(place)), every, estimate);
                let at = |k: u32| Vec3::new((k % 8) as f32 * 0.1 - 0.35, 0.0, (k / 8) as f32 * 0.1 - 0.35);
                let found = |k| kept.irradiance(at(k), Vec3::Y, 1.0).map_or(0.0, |e| f64::from(e.g));
                (0..64).map(found).sum::<f64>() / 64.0 / (f64::from(PHOTONS) / 4.0)
            };
            let all: Moments = (0..256).map(draw).collect();
            let (p, error) = (all.p_value(1.0), all.standard_error());
            assert!(p > sidak(0.01, 4), "{every}, {reach:?}: {} ± {error}", all.mean());
            // Without itself a photon would tell one in fifty too little, and twice itself as much too much.
            assert!(error < 0.005, "{every}, {reach:?} says nothing: {error}");
        }
    }
}
