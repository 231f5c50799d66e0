//! The theorems of `shapes`: counts, areas, and the divergence theorem, ∮ x·n dA = 3 V, for what is closed.

use super::*;
use std::f64::consts::PI;

fn sums(patch: &Patch) -> (f64, f64) {
    patch.triangles.iter().fold((0.0, 0.0), |(area, volume), t| {
        let [a, b, c] = t.map(|i| patch.vertices[i as usize].point);
        (area + 0.5 * (b - a).cross(c - a).length(), volume + a.dot(b.cross(c)) / 6.0)
    })
}

/// Shading normals look to the same side as their triangles.
fn assert_normals_agree(patch: &Patch) {
    for t in &patch.triangles {
        let [a, b, c] = t.map(|i| patch.vertices[i as usize]);
        let n = (b.point - a.point).cross(c.point - a.point);
        for v in [a, b, c] {
            assert!((v.normal.length() - 1.0).abs() < 1e-9 && v.normal.dot(n) > 0.0, "{v:?} {n}");
        }
    }
}

#[test]
fn a_fine_sphere_has_the_area_and_volume_of_a_sphere() {
    for (inward, sign) in [(false, 1.0), (true, -1.0)] {
        let patch = revolve(DVec3::new(1.0, 2.0, 3.0), DVec3::Z, &sphere_profile(2.0, 256), 256, inward);
        let (area, volume) = sums(&patch);
        assert!((area / (16.0 * PI) - 1.0).abs() < 3e-4, "{area}");
        assert!((volume * sign / (32.0 / 3.0 * PI) - 1.0).abs() < 3e-4, "{volume}");
        assert_normals_agree(&patch);
    }
}

#[test]
fn a_fine_torus_has_the_area_and_volume_of_a_torus() {
    for (r1, r2) in [(1.0, 3.0), (0.0, 2.0)] {
        for (inward, sign) in [(false, 1.0), (true, -1.0)] {
            let axis = DVec3::new(1.0, -2.0, 0.5);
            let patch = revolve(DVec3::ZERO, axis, &torus_profile(r1, r2, 256), 256, inward);
            let (area, volume) = sums(&patch);
            let (tube, center) = ((r2 - r1) / 2.0, (r1 + r2) / 2.0);
            assert!((area / (4.0 * PI * PI * tube * center) - 1.0).abs() < 3e-4, "{area}");
            assert!((volume * sign / (2.0 * PI * PI * tube * tube * center) - 1.0).abs() < 6e-4, "{volume}");
        }
    }
    assert_normals_agree(&revolve(DVec3::ZERO, DVec3::X, &torus_profile(1.0, 3.0, 32), 32, true));
}

#[test]
fn counts_are_those_foretold() {
    let profiles = [
        (sphere_profile(1.0, 20), 360),
        (cone_profile(1.0, 1.0, 2.0), 40),
        (cone_profile(1.0, 0.0, 2.0), 20),
        (cone_profile(0.0, 1.0, 2.0), 20),
        (ring_profile(0.0, 1.0), 20),
        (ring_profile(0.5, 1.0), 40),
        (torus_profile(1.0, 2.0, 20), 800),
    ];
    for (profile, count) in profiles {
        let patch = revolve(DVec3::ZERO, DVec3::Y, &profile, 20, false);
        assert_eq!((patch.triangles.len() as u64, revolved_triangles(&profile, 20)), (count, count));
    }
}

#[test]
fn a_cone_and_two_rings_close_a_frustum() {
    let (low, axis) = (DVec3::new(0.3, -1.0, 2.0), DVec3::new(1.0, 2.0, 2.0));
    let side = revolve(low, axis, &cone_profile(2.0, 1.0, 3.0), 1024, false);
    let top = revolve(low + axis, axis, &ring_profile(0.0, 1.0), 1024, false);
    let bottom = revolve(low, -axis, &ring_profile(0.0, 2.0), 1024, false);
    let volume: f64 = [&side, &top, &bottom].into_iter().map(|p| sums(p).1).sum();
    assert!((volume / (7.0 * PI) - 1.0).abs() < 3e-5, "{volume}");
    assert_normals_agree(&side);
    assert_normals_agree(&revolve(low, axis, &cone_profile(0.0, 1.0, 3.0), 20, true));
}

#[test]
fn a_prism_is_closed_and_turned_by_its_length() {
    let outline = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    let vertices = outline.map(|(x, y)| Vertex { point: DVec3::new(x, y, 5.0), normal: DVec3::ZERO });
    for length in [2.0, -2.0] {
        let (patch, flaws) = prism(&vertices, length).unwrap();
        let (area, volume) = sums(&patch);
        assert_eq!((patch.triangles.len(), flaws), (20, Flaws::default()));
        assert!((area - (6.0 + 16.0)).abs() < 1e-12, "{area}");
        assert!((volume - 3.0 * length).abs() < 1e-12, "positive volume is outward: {volume}");
        let far = patch.vertices.iter().map(|v| v.point.z).find(|z| *z != 5.0);
        assert_eq!(far, Some(5.0 - length));
    }
}

#[test]
fn polygons_without_area_and_bent_ones_are_told_apart() {
    let at = |list: &[[f64; 3]]| -> Vec<Vertex> {
        list.iter().map(|&p| Vertex { point: DVec3::from_array(p), normal: DVec3::ZERO }).collect()
    };
    assert!(polygon(at(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]), &[3]).is_none());
    assert!(polygon(at(&[[1.0; 3], [1.0; 3], [1.0; 3]]), &[3]).is_none());
    let bent = at(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 0.0]]);
    assert!(polygon(bent, &[4]).is_some_and(|(patch, flaws)| patch.triangles.len() == 2 && flaws.bent));
    let flat = at(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert!(polygon(flat, &[4]).is_some_and(|(_, flaws)| flaws == Flaws::default()));
}
