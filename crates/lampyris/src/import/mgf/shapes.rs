//! MGF's solids as triangles in their own space: surfaces of revolution, prisms, polygons.
//! Every curved shape is one profile turned about an axis. Orientation follows the sign of the radii; placing, and
//! with it mirroring, is done later.

use crate::import::polygon::{Triangulation, flatten, triangulate, vector_area};
use glam::{DVec2, DVec3};

/// A vertex with its shading normal, zero for "the surface's own".
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Vertex {
    pub(super) point: DVec3,
    pub(super) normal: DVec3,
}

/// Triangles before they are placed.
#[derive(Default)]
pub(super) struct Patch {
    pub(super) vertices: Vec<Vertex>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// A point of a profile: distance from the axis, height along it, and the outward normal in the same plane.
#[derive(Clone, Copy)]
pub(super) struct Station {
    pub(super) radius: f64,
    pub(super) height: f64,
    pub(super) normal: DVec2,
}

/// How many triangles [`revolve`] makes.
pub(super) fn revolved_triangles(profile: &[Station], steps: u32) -> u64 {
    let band = |e: &[Station]| if e[0].radius == 0.0 || e[1].radius == 0.0 { 1 } else { 2 };
    profile.windows(2).map(band).sum::<u64>() * u64::from(steps)
}

/// Turns a profile about the axis through `origin` along `axis` (any length > 0) in `steps` facets.
///
/// The front is to the right of the profile as it climbs; `inward` turns it, and the normals.
pub(super) fn revolve(origin: DVec3, axis: DVec3, profile: &[Station], steps: u32, inward: bool) -> Patch {
    let w = axis.normalize();
    // The facets begin where the reference implementation's do, so that bounds agree.
    let lead = if w.x.abs() < 0.6 {
        DVec3::X
    } else if w.y.abs() < 0.6 {
        DVec3::Y
    } else {
        DVec3::Z
    };
    let u = lead.cross(w).normalize();
    let v = w.cross(u);
    // By quarters, so that a circle closes and its quadrants are alike to the bit.
    let quarter = steps / 4;
    let directions: Vec<DVec3> = (0..steps)
        .map(|k| {
            let (sin, cos) =
                libm::sincos(f64::from(k % quarter) / f64::from(quarter) * std::f64::consts::FRAC_PI_2);
            match k / quarter {
                0 => u * cos + v * sin,
                1 => v * cos - u * sin,
                2 => -(u * cos + v * sin),
                _ => u * sin - v * cos,
            }
        })
        .collect();
    let sense = if inward { -1.0 } else { 1.0 };
    let mut patch = Patch::default();
    for (row, station) in profile.iter().enumerate() {
        for (k, &d) in directions.iter().enumerate() {
            // At an apex each facet has a vertex of its own, whose normal looks along the facet's middle.
            let facing = if station.radius == 0.0 {
                (d + directions[(k + 1) % directions.len()]).normalize()
            } else {
                d
            };
            let normal = (facing * station.normal.x + w * station.normal.y) * sense;
            patch.vertices.push(Vertex { point: origin + d * station.radius + w * station.height, normal });
        }
        if row == 0 {
            continue;
        }
        let (low, high) = ((row as u32 - 1) * steps, row as u32 * steps);
        for k in 0..steps {
            let (a, b) = (low + k, low + (k + 1) % steps);
            let (c, d) = (high + (k + 1) % steps, high + k);
            if profile[row - 1].radius == 0.0 {
                patch.push([a, c, d], inward);
            } else {
                patch.push([a, b, d], inward);
                if station.radius != 0.0 {
                    patch.push([b, c, d], inward);
                }
            }
        }
    }
    patch
}

/// The profile of a cone's or cylinder's side of the given height; radii ≥ 0, not both 0.
pub(super) fn cone_profile(low: f64, high: f64, height: f64) -> Vec<Station> {
    let normal = DVec2::new(height, low - high).normalize();
    vec![Station { radius: low, height: 0.0, normal }, Station { radius: high, height, normal }]
}

/// The profile of a sphere, from pole to pole.
pub(super) fn sphere_profile(radius: f64, steps: u32) -> Vec<Station> {
    let bands = steps / 2;
    let station = |k: u32| {
        let (sin, cos) = libm::sincos(f64::from(k) / f64::from(bands) * std::f64::consts::PI);
        let normal = DVec2::new(if k == 0 || k == bands { 0.0 } else { sin }, -cos);
        Station { radius: radius * normal.x, height: radius * normal.y, normal }
    };
    (0..=bands).map(station).collect()
}

/// The profile of a ring seen from the tip of its axis; flat, without shading normals.
pub(super) fn ring_profile(inner: f64, outer: f64) -> Vec<Station> {
    [outer, inner].map(|radius| Station { radius, height: 0.0, normal: DVec2::ZERO }).into()
}

/// The profile of a torus: its tube's circle, from the innermost point on.
pub(super) fn torus_profile(inner: f64, outer: f64, steps: u32) -> Vec<Station> {
    let (tube, center) = ((outer - inner) / 2.0, (outer + inner) / 2.0);
    let station = |k: u32| {
        let (sin, cos) = libm::sincos(f64::from(k % steps) / f64::from(steps) * std::f64::consts::TAU);
        let innermost = k.is_multiple_of(steps);
        let normal = DVec2::new(-cos, -sin);
        let radius = if innermost { inner } else { center + tube * normal.x };
        Station { radius, height: if innermost { 0.0 } else { tube * normal.y }, normal }
    };
    (0..=steps).map(station).collect()
}

/// A polygon with holes (`contours`: ends of the runs of vertices), or `None` if it has no area.
pub(super) fn polygon(vertices: Vec<Vertex>, contours: &[usize]) -> Option<(Patch, Flaws)> {
    let points: Vec<DVec3> = vertices.iter().map(|v| v.point).collect();
    let outline = &points[..contours.first().copied().unwrap_or(points.len())];
    let (triangulation, flaws) = face(&points, outline, contours)?;
    Some((Patch { vertices, triangles: triangulation.triangles }, flaws))
}

/// A closed prism over the polygon, `length` along minus its normal.
pub(super) fn prism(vertices: &[Vertex], length: f64) -> Option<(Patch, Flaws)> {
    let points: Vec<DVec3> = vertices.iter().map(|v| v.point).collect();
    let (end, flaws) = face(&points, &points, &[points.len()])?;
    let shift = -vector_area(&points).normalize() * length;
    let mut patch = Patch::default();
    // The ends: flat, hence with vertices of their own.
    patch.vertices.extend(points.iter().map(|&point| Vertex { point, normal: DVec3::ZERO }));
    patch.vertices.extend(points.iter().map(|&p| Vertex { point: p + shift, normal: DVec3::ZERO }));
    let n = points.len() as u32;
    patch.triangles.extend(&end.triangles);
    patch.triangles.extend(end.triangles.iter().map(|&[a, b, c]| [c + n, b + n, a + n]));
    for k in 0..points.len() {
        let (a, b) = (vertices[k], vertices[(k + 1) % points.len()]);
        let first = patch.vertices.len() as u32;
        let far = |v: Vertex| Vertex { point: v.point + shift, ..v };
        patch.vertices.extend([a, far(a), far(b), b]);
        patch.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| i + first)));
    }
    Some((patch, flaws))
}

/// What is wrong with a polygon that can be used all the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Flaws {
    pub(super) bent: bool,
    pub(super) crossed: bool,
}

fn face(points: &[DVec3], outline: &[DVec3], contours: &[usize]) -> Option<(Triangulation, Flaws)> {
    let area = vector_area(outline);
    let origin = outline[0];
    let extent = points.iter().map(|p| (*p - origin).length()).fold(0.0, f64::max);
    // Thinner than one part in 10⁹ there is no telling which way it faces.
    if area.length() <= 1e-9 * extent * extent {
        return None;
    }
    let normal = area.normalize();
    let bent = points.iter().any(|p| (*p - origin).dot(normal).abs() > 1e-3 * extent);
    let triangulation = triangulate(&flatten(points, normal), contours);
    let crossed = !triangulation.simple;
    Some((triangulation, Flaws { bent, crossed }))
}

impl Patch {
    fn push(&mut self, [a, b, c]: [u32; 3], turned: bool) {
        self.triangles.push(if turned { [a, c, b] } else { [a, b, c] });
    }
}

#[cfg(test)]
#[path = "shapes_tests.rs"]
mod tests;
