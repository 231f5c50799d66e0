//! The scene made traceable: what a ray meets first, and whether two points see each other. Meshes used once lie in
//! one tree in world space; meshes used more often keep a tree each, below a tree over their instances. It knows
//! neither materials nor light. How one instance comes to stand elsewhere is said in `replace`.

use super::bvh::{
    Best, Bounds, End, Grafted, Hierarchy, Item, Kernel, Placed, Plane, Primitive, Slab, Tree, build,
};
use super::{Hit, Ray, Screen};
use glam::{Affine3A, Vec3};
use rayon::prelude::*;

/// Triangles of a mesh, in its own space.
#[derive(Clone, Copy, Debug)]
pub struct MeshGeometry<'a> {
    /// Positions of the vertices.
    pub positions: &'a [Vec3],
    /// Vertices of each triangle, counter-clockwise seen from the front.
    pub triangles: &'a [[u32; 3]],
    /// Triangles whose back lets rays pass (one-sided surfaces); none where it is empty.
    pub one_sided: &'a [bool],
    /// Triangles that may have holes, of which a [`Screen`] knows; none where it is empty.
    pub screened: &'a [bool],
}

/// A mesh in its place.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Which mesh.
    pub mesh: u32,
    /// Mesh space → world.
    pub transform: Affine3A,
}

/// Triangles that rays can be traced through.
#[derive(Clone, Debug)]
pub struct Tracer {
    pub(super) kernel: Kernel,
    /// In world space: all meshes that were used once, and what was placed anew since.
    pub(super) flat: Grafted,
    /// Of each mesh the tree that its instances share; `u32::MAX` for none.
    pub(super) trees: Vec<u32>,
    pub(super) shared: Vec<Shared>,
    top: Hierarchy,
    pub(super) placed: Vec<Instance>,
    bounds: Bounds,
    report: Report,
}

/// What was built at first, and what was left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Triangles that can be hit, counted once for every instance.
    pub triangles: u64,
    /// Triangles without area, with corners that are not finite, too far out (|x| > 1.8e18) or that do not exist.
    pub dropped_triangles: u64,
    /// Instances whose transform is singular or not finite, or whose mesh does not exist.
    pub dropped_instances: u64,
}

/// Tree of a mesh that several instances share, in its own space.
#[derive(Clone, Debug)]
pub(super) struct Shared {
    pub(super) tree: Tree,
    triangles: u64,
}

#[derive(Clone, Debug)]
pub(super) struct Instance {
    pub(super) place: Placed,
    tree: u32,
    /// The box around it.
    bounds: Bounds,
    /// Rows of the inverse matrix, in f64 so that only the rounding of the placed corners is left.
    inverse: [[f64; 3]; 3],
    /// Bounds that rounding, carried back into mesh space.
    error: f32,
}

/// Beyond this, products of coordinates leave f32.
const FARTHEST: f32 = 1.8e18;

impl Tracer {
    /// Builds the trees, in parallel, the same for any number of threads. Nothing has holes.
    pub fn build(meshes: &[MeshGeometry<'_>], instances: &[Placement]) -> Tracer {
        Tracer::with_screen(meshes, instances, &Screen::default())
    }

    /// [`Tracer::build`] for meshes whose screened triangles have the holes that `screen` says. Every ray respects them.
    pub fn with_screen(meshes: &[MeshGeometry<'_>], instances: &[Placement], screen: &Screen) -> Tracer {
        let mut uses = vec![0u32; meshes.len()];
        let mut report = Report::default();
        let usable: Vec<(u32, &Placement)> =
            (0..).zip(instances).filter(|(_, i)| (i.mesh as usize) < meshes.len() && usable(i)).collect();
        report.dropped_instances = (instances.len() - usable.len()) as u64;
        for (_, instance) in &usable {
            uses[instance.mesh as usize] += 1;
        }

        let once = usable.iter().filter(|(_, i)| uses[i.mesh as usize] == 1);
        let soup = Soup::new(
            once.map(|(number, i)| Moved::new(&meshes[i.mesh as usize], *number, &i.transform)).collect(),
        );
        let flat = Tree::new(soup.count, |k| soup.primitive(k), screen);
        report.triangles = flat.triangles();
        report.dropped_triangles = u64::from(soup.count) - report.triangles;

        let mut trees = vec![u32::MAX; meshes.len()];
        let mut several = Vec::new();
        for (mesh, _) in uses.iter().enumerate().filter(|(_, uses)| **uses > 1) {
            trees[mesh] = several.len() as u32;
            several.push(&meshes[mesh]);
        }
        let shared: Vec<Shared> = several
            .into_par_iter()
            .map(|mesh| {
                let whole = Moved::new(mesh, 0, &Affine3A::IDENTITY);
                let tree = Tree::new(mesh.triangles.len() as u32, |k| whole.primitive(k), screen);
                Shared { triangles: tree.triangles(), tree }
            })
            .collect();

        let mut placed = Vec::new();
        for (number, placement) in usable.iter().filter(|(_, i)| uses[i.mesh as usize] > 1) {
            let tree = trees[placement.mesh as usize];
            let of = &shared[tree as usize];
            let instance = (!of.tree.is_empty())
                .then(|| Instance::new(*number, tree, &of.tree.bounds(), &placement.transform));
            if let Some(None) = instance {
                report.dropped_instances += 1;
                continue;
            }
            report.triangles += of.triangles;
            report.dropped_triangles += meshes[placement.mesh as usize].triangles.len() as u64 - of.triangles;
            placed.extend(instance.flatten());
        }
        let mut tracer = Tracer {
            kernel: Kernel::detect(),
            flat: Grafted::new(flat),
            trees,
            shared,
            top: Hierarchy::default(),
            placed: Vec::new(),
            bounds: Bounds::default(),
            report,
        };
        tracer.raise(placed);
        tracer
    }

    /// Builds the tree over the instances of shared meshes.
    pub(super) fn raise(&mut self, placed: Vec<Instance>) {
        let mut items: Vec<Item> =
            (0..).zip(&placed).map(|(index, i)| Item { bounds: i.bounds, index }).collect();
        let (top, leaves) = build(&mut items, 1);
        // Leaves of the top hierarchy hold one instance each: keep the instances in their order.
        let instance = |leaf: std::ops::Range<u32>| placed[items[leaf.start as usize].index as usize].clone();
        self.placed = leaves.into_iter().map(instance).collect();
        self.top = top;
        self.measure();
    }

    /// The box around everything; what was taken out of a tree may still count.
    pub(super) fn measure(&mut self) {
        let boxes = self.placed.iter().map(|i| i.bounds);
        self.bounds = boxes.fold(self.flat.tree.bounds(), |a, b| a.union(&b));
    }

    /// The nearest hit with 0 < t < `t_max`; of equally near ones that of the smallest instance, then triangle. Rays
    /// that are not finite, or whose direction is longer than 8e37 (its reciprocal leaves f32), miss.
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        if !sound(ray) {
            return None;
        }
        let mut best = Best::none(ray.t_max);
        self.flat.tree.closest(self.kernel, ray, None, &mut best);
        if self.has_placed() {
            self.closest_placed(ray, &mut best);
        }
        best.hit()
    }

    /// The part of [`Tracer::closest`] that meets shared meshes.
    pub(super) fn closest_placed(&self, ray: &Ray, best: &mut Best) {
        let slab = Slab::new(ray.origin, ray.direction, &self.bounds, 0.0);
        self.top.walk(&slab, best.t, |leaf| {
            let instance = &self.placed[leaf as usize];
            let tree = &self.shared[instance.tree as usize].tree;
            let slab = instance.slab(ray, tree);
            tree.closest(self.kernel, ray, Some((&instance.place, &slab)), best);
            best.t
        });
    }

    /// Is there any hit with 0 < t < `t_max`?
    pub fn occluded(&self, ray: &Ray) -> bool {
        sound(ray) && self.stops(ray, End::Distance(ray.t_max))
    }

    /// Is the open segment between two points blocked? Unlike a ray's `t_max`, both ends are exact: points just off a
    /// surface ([`super::SurfacePoint::spawn`]) are never blocked by it, and contact is seen however close.
    pub fn blocked(&self, from: Vec3, to: Vec3) -> bool {
        let ray = Ray::between(from, to);
        sound(&ray) && self.stops(&ray, End::Point(to))
    }

    fn stops(&self, ray: &Ray, end: End) -> bool {
        self.flat.tree.occluded(self.kernel, ray, end, None)
            || (self.has_placed() && self.placed_stop(ray, end))
    }

    /// Does a shared mesh block the ray?
    pub(super) fn placed_stop(&self, ray: &Ray, end: End) -> bool {
        let mut hit = false;
        let slab = Slab::new(ray.origin, ray.direction, &self.bounds, 0.0);
        self.top.walk(&slab, ray.t_max, |leaf| {
            let instance = &self.placed[leaf as usize];
            let tree = &self.shared[instance.tree as usize].tree;
            let slab = instance.slab(ray, tree);
            hit = tree.occluded(self.kernel, ray, end, Some((&instance.place, &slab)));
            if hit { f32::NEG_INFINITY } else { ray.t_max }
        });
        hit
    }

    /// A box around everything, `None` if there is nothing.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        (!self.bounds.is_empty()).then_some((self.bounds.lower, self.bounds.upper))
    }

    /// What was built at first, and what was left out.
    pub fn report(&self) -> Report {
        self.report
    }

    /// Bytes held by the trees.
    pub fn memory(&self) -> usize {
        let shared: usize = self.shared.iter().map(|s| s.tree.memory()).sum();
        self.flat.memory() + shared + self.top.memory() + size_of_val(&self.placed[..])
    }

    pub(super) fn has_placed(&self) -> bool {
        !self.placed.is_empty()
    }

    /// The kernel in use.
    pub fn kernel(&self) -> Kernel {
        self.kernel
    }

    /// The same tracer with another kernel; `None` if this machine lacks it. Hits do not depend on it.
    pub fn with_kernel(mut self, kernel: Kernel) -> Option<Tracer> {
        self.kernel = kernel;
        kernel.available().then_some(self)
    }
}

impl Instance {
    /// `None` where it would reach farther than rays do.
    pub(super) fn new(number: u32, tree: u32, mesh: &Bounds, transform: &Affine3A) -> Option<Instance> {
        let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { mesh.lower[axis] } else { mesh.upper[axis] };
            transform.transform_point3(Vec3::new(pick(0), pick(1), pick(2)))
        });
        // Rounding of a transformed vertex: 4 operations on terms no larger than this.
        let m = transform.matrix3;
        let farthest = mesh.lower.abs().max(mesh.upper.abs());
        let terms = m.x_axis.abs() * farthest.x + m.y_axis.abs() * farthest.y + m.z_axis.abs() * farthest.z;
        let size = Vec3::from(terms + transform.translation.abs());
        let bounds = Bounds::of(&corners);
        let margin = Vec3::splat(size.max_element() * 8.0 * f32::EPSILON);
        let bounds = Bounds { lower: bounds.lower - margin, upper: bounds.upper + margin };
        let reach = bounds.lower.abs().max(bounds.upper.abs());
        if !(reach.is_finite() && reach.max_element() <= FARTHEST) {
            return None;
        }
        let inverse = inverse(transform);
        let norm =
            inverse.map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).into_iter().fold(0.0, f64::max);
        let error = norm as f32 * margin.x;
        let place = Placed {
            instance: number,
            transform: *transform,
            mirrored: transform.matrix3.determinant() < 0.0,
        };
        Some(Instance { place, tree, bounds, inverse, error })
    }

    /// The ray in the space of the mesh, as far as boxes are concerned; t stays what it was.
    fn slab(&self, ray: &Ray, tree: &Tree) -> Slab {
        let apply = |x: [f64; 3]| {
            Vec3::from_array(self.inverse.map(|r| (r[0] * x[0] + r[1] * x[1] + r[2] * x[2]) as f32))
        };
        let at = self.place.transform.translation;
        let origin = apply([0, 1, 2].map(|a| f64::from(ray.origin[a]) - f64::from(at[a])));
        let direction = apply(ray.direction.to_array().map(f64::from));
        let error = self.error + origin.abs().max_element() * 4.0 * f32::EPSILON;
        Slab::new(origin, direction, &tree.bounds(), error)
    }
}

/// Rows of the inverse of the matrix, by cofactors.
fn inverse(transform: &Affine3A) -> [[f64; 3]; 3] {
    let m = transform.matrix3;
    let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis].map(|v| v.to_array().map(f64::from));
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let rows = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = a[0] * rows[0][0] + a[1] * rows[0][1] + a[2] * rows[0][2];
    rows.map(|row| row.map(|x| x / determinant))
}

fn sound(ray: &Ray) -> bool {
    sound_origin(ray.origin) & sound_direction(ray.direction) & !ray.t_max.is_nan()
}

pub(super) fn sound_origin(origin: Vec3) -> bool {
    // False for NaN; without branches, as the rest of the setting up of a ray.
    let [x, y, z] = origin.to_array().map(|o| o.abs() <= FARTHEST);
    x & y & z
}

/// The sum of the components lets no NaN pass. Reciprocals of both bounds are neither infinite nor subnormal.
#[inline(always)]
pub(super) fn sound_direction(direction: Vec3) -> bool {
    let length = direction.x.abs() + direction.y.abs() + direction.z.abs();
    (f32::MIN_POSITIVE..=1.0 / f32::MIN_POSITIVE).contains(&length)
}

/// Can the transform be undone?
pub(super) fn usable(instance: &Placement) -> bool {
    let determinant = instance.transform.matrix3.determinant();
    let inverse = instance.transform.inverse();
    instance.transform.is_finite() && determinant != 0.0 && determinant.is_finite() && inverse.is_finite()
}

/// A mesh in its place, triangle by triangle.
pub(super) struct Moved<'a> {
    mesh: &'a MeshGeometry<'a>,
    instance: u32,
    transform: &'a Affine3A,
    mirrored: bool,
}

impl<'a> Moved<'a> {
    pub(super) fn new(mesh: &'a MeshGeometry<'a>, instance: u32, transform: &'a Affine3A) -> Moved<'a> {
        Moved { mesh, instance, transform, mirrored: transform.matrix3.determinant() < 0.0 }
    }

    /// A triangle, if it can be hit.
    fn primitive(&self, number: u32) -> Option<Primitive> {
        let (mesh, at) = (self.mesh, number as usize);
        let vertices = mesh.triangles[at];
        let position = |v: u32| mesh.positions.get(v as usize).map(|p| self.transform.transform_point3(*p));
        let corners = [position(vertices[0])?, position(vertices[1])?, position(vertices[2])?];
        let near = corners.iter().all(|c| c.abs().max_element() <= FARTHEST && c.is_finite());
        (near && Plane::new(&corners, corners[0]).normal != [0.0; 3]).then_some(Primitive {
            corners,
            instance: self.instance,
            triangle: number,
            culled: mesh.one_sided.get(at).copied().unwrap_or(false),
            mirrored: self.mirrored,
            screened: mesh.screened.get(at).copied().unwrap_or(false),
        })
    }
}

/// The triangles of several meshes, counted through.
pub(super) struct Soup<'a> {
    meshes: Vec<Moved<'a>>,
    /// Number of the first triangle of each.
    first: Vec<u32>,
    pub(super) count: u32,
}

impl<'a> Soup<'a> {
    pub(super) fn new(meshes: Vec<Moved<'a>>) -> Soup<'a> {
        let mut count = 0;
        let first = meshes
            .iter()
            .map(|m| {
                let first = count;
                count += m.mesh.triangles.len() as u32;
                first
            })
            .collect();
        Soup { meshes, first, count }
    }

    pub(super) fn primitive(&self, k: u32) -> Option<Primitive> {
        // The last that begins there or before: those without triangles begin where the next one does.
        let mesh = self.first.partition_point(|first| *first <= k) - 1;
        self.meshes[mesh].primitive(k - self.first[mesh])
    }
}
