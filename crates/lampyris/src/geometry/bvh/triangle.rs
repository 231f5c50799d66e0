//! One ray against one triangle: the watertight test [Woop et al. 2013], whose edge functions have exact
//! signs, so that a ray never slips between neighbours. Whether the meeting lies in front of the start (and before
//! the end of a segment) is decided by the exact side of the plane, not by an epsilon. This is the scalar oracle; the
//! SIMD kernels repeat its operations in its order and call it for the rare lanes that need f64.

use glam::Vec3;

/// Below this the f32 edge functions of a tiny triangle lose their digits, and f64 takes over.
pub(super) const TINY: f32 = 1e-30;

/// The shear that turns a ray into the +z axis: `kz` is the largest axis of the direction.
///
/// Unlike the paper, x and y are not swapped for negative directions: that would only flip the sign of all three edge
/// functions, and `negative` remembers it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    pub(super) kx: usize,
    pub(super) ky: usize,
    pub(super) kz: usize,
    pub(super) sx: f32,
    pub(super) sy: f32,
    pub(super) sz: f32,
    pub(super) negative: bool,
}

impl Shear {
    #[inline(always)]
    pub(crate) fn new(direction: Vec3) -> Shear {
        let d = direction.to_array();
        let kz = largest_axis(d);
        let [kx, ky] = OTHERS[kz];
        // One division serves the shear and the boxes; both allow for the rounding of the products.
        let sz = 1.0 / d[kz];
        Shear { kx, ky, kz, sx: d[kx] * sz, sy: d[ky] * sz, sz, negative: d[kz] < 0.0 }
    }
}

/// The axes after each axis.
static OTHERS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// The axis of the largest component; the first of equals. Without branches, which rays in all directions would fool.
#[inline(always)]
pub(super) fn largest_axis(d: [f32; 3]) -> usize {
    let a = d.map(f32::abs);
    let second = a[1] > a[0];
    let larger = if second { a[1] } else { a[0] };
    std::hint::select_unpredictable(a[2] > larger, 2, usize::from(second))
}

/// Where a line meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub(super) t: f32,
    pub(super) u: f32,
    pub(super) v: f32,
}

/// Sheared corners (x, y) and unsheared heights z, relative to the ray's origin.
struct Sheared {
    x: [f32; 3],
    y: [f32; 3],
    z: [f32; 3],
}

fn shear(corners: &[Vec3; 3], origin: Vec3, s: &Shear) -> Sheared {
    let p = corners.map(|c| (c - origin).to_array());
    let z = p.map(|p| p[s.kz]);
    Sheared {
        x: [0, 1, 2].map(|i| p[i][s.kx] - s.sx * z[i]),
        y: [0, 1, 2].map(|i| p[i][s.ky] - s.sy * z[i]),
        z,
    }
}

fn opposed<T: PartialOrd + Default>(e: &[T; 3]) -> bool {
    let zero = T::default();
    e.iter().any(|e| *e < zero) && e.iter().any(|e| *e > zero)
}

/// Weights of the corners where the line pierces the triangle, and whether their sum of areas was positive.
/// `None` where it passes by. [Woop et al. 2013, §3]
fn weights(p: &Sheared) -> Option<([f32; 3], bool)> {
    let (x, y) = (p.x, p.y);
    let e = [x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2], x[1] * y[0] - y[1] * x[0]];
    // A difference of rounded products has the sign of the exact one or is zero: a pair of opposed signs is final.
    if opposed(&e) {
        return None;
    }
    let det = e[0] + e[1] + e[2];
    if e.contains(&0.0) || det.abs() < TINY {
        return exact_weights(p);
    }
    let inverse = 1.0 / det;
    // NaN (the filling of a block) passes the tests above and fails here.
    (inverse.is_finite()).then(|| (e.map(|e| e * inverse), det > 0.0))
}

/// The same in f64, where products of f32 are exact.
#[cold]
fn exact_weights(p: &Sheared) -> Option<([f32; 3], bool)> {
    let (x, y) = (p.x.map(f64::from), p.y.map(f64::from));
    let e = [x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2], x[1] * y[0] - y[1] * x[0]];
    let det = e[0] + e[1] + e[2];
    (!opposed(&e) && det != 0.0 && det.is_finite()).then(|| (e.map(|e| (e / det) as f32), det > 0.0))
}

/// Where the half-line meets the triangle, front or back alike; `true` if it came from the front (seen
/// counter-clockwise).
pub(super) fn crossing(
    corners: &[Vec3; 3],
    origin: Vec3,
    direction: Vec3,
    s: &Shear,
) -> Option<(Crossing, bool)> {
    let p = shear(corners, origin, s);
    let (b, positive) = weights(&p)?;
    if !ahead(&p.z, s.negative, || in_front(&Plane::new(corners, origin), direction)) {
        return None;
    }
    let t = s.sz * (b[0] * p.z[0] + b[1] * p.z[1] + b[2] * p.z[2]);
    let t = if t > f32::MIN_POSITIVE { t } else { f32::MIN_POSITIVE };
    Some((Crossing { t, u: b[1], v: b[2] }, positive != s.negative))
}

/// Does the open segment from `origin` to `target` pierce the triangle? If so, whether from the front, and the weights of
/// the second and third corner there. `s` is the shear of `target - origin`.
pub(super) fn pierced(
    corners: &[Vec3; 3],
    origin: Vec3,
    target: Vec3,
    s: &Shear,
) -> Option<(bool, [f32; 2])> {
    let p = shear(corners, origin, s);
    let (b, positive) = weights(&p)?;
    let end = target.to_array()[s.kz] - origin.to_array()[s.kz];
    between(&p.z, end, s.negative, || separates(&Plane::new(corners, origin), target))
        .then_some((positive != s.negative, [b[1], b[2]]))
}

/// Three heights on one side of zero say where the meeting is: it lies among them. Else the plane decides.
fn ahead(z: &[f32; 3], negative: bool, plane: impl FnOnce() -> bool) -> bool {
    let z = if negative { z.map(|z| -z) } else { *z };
    z.iter().all(|z| *z > 0.0) || (z.iter().any(|z| *z > 0.0) && plane())
}

fn between(z: &[f32; 3], end: f32, negative: bool, plane: impl FnOnce() -> bool) -> bool {
    let (z, end) = if negative { (z.map(|z| -z), -end) } else { (*z, end) };
    z.iter().all(|z| *z > 0.0 && *z < end)
        || (z.iter().any(|z| *z > 0.0) && z.iter().any(|z| *z < end) && plane())
}

/// The plane of a triangle seen from an origin, in f64: for coordinates in f32 its signs are exact in all but name.
pub(crate) struct Plane {
    pub(crate) normal: [f64; 3],
    pub(super) corner: [f64; 3],
    /// normal · (corner − origin)
    pub(super) height: f64,
}

impl Plane {
    pub(crate) fn new(corners: &[Vec3; 3], origin: Vec3) -> Plane {
        let [a, b, c] = corners.map(|c| c.to_array().map(f64::from));
        let o = origin.to_array().map(f64::from);
        let (e, f) = (sub(b, a), sub(c, a));
        let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        Plane { normal, corner: a, height: dot(normal, sub(a, o)) }
    }
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Does the direction lead from the origin to the plane?
pub(super) fn in_front(plane: &Plane, direction: Vec3) -> bool {
    let along = dot(plane.normal, direction.to_array().map(f64::from));
    (plane.height > 0.0 && along > 0.0) || (plane.height < 0.0 && along < 0.0)
}

/// Does the plane separate the origin from the target?
pub(super) fn separates(plane: &Plane, target: Vec3) -> bool {
    let beyond = dot(plane.normal, sub(plane.corner, target.to_array().map(f64::from)));
    (plane.height > 0.0 && beyond < 0.0) || (plane.height < 0.0 && beyond > 0.0)
}
