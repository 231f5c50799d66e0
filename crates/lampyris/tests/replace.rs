//! A tracer whose instances were placed anew, taken away and brought back hits what one built afresh hits, to the bit, by
//! every kernel.

mod common;

use common::{Rng, Shape, kernels, shapes};
use glam::{Affine3A, Quat, Vec3};
use lampyris::geometry::{LANES, MeshGeometry, Placement, Ray, Tracer};

fn signed(rng: &mut Rng) -> Vec3 {
    rng.vector() * 2.0 - 1.0
}

fn somewhere(rng: &mut Rng) -> Affine3A {
    let scale = Vec3::new(0.2 + rng.unit(), 0.2 + rng.unit(), 0.2 + rng.unit()) * Vec3::new(1.0, -1.0, 1.0);
    let turn = Quat::from_axis_angle(signed(rng).normalize(), rng.unit() * 6.0);
    Affine3A::from_scale_rotation_translation(scale, turn, signed(rng) * 2.0)
}

/// Instances that may have no mesh.
struct Stage<'a> {
    meshes: Vec<MeshGeometry<'a>>,
    places: Vec<Placement>,
    tracer: Tracer,
}

impl<'a> Stage<'a> {
    fn new(shapes: &'a [Shape], places: Vec<Placement>) -> Stage<'a> {
        let geometry = |s: &'a Shape| MeshGeometry {
            positions: &s.positions,
            triangles: &s.triangles,
            one_sided: &[],
            screened: &[],
        };
        let meshes: Vec<MeshGeometry<'_>> = shapes.iter().map(geometry).collect();
        let tracer = Tracer::build(&meshes, &places);
        Stage { meshes, places, tracer }
    }

    /// The instance `number`, the next one perhaps, is this from now on. Returns how many instances were looked at.
    fn place(&mut self, number: usize, placement: Placement) -> usize {
        self.places.resize(self.places.len().max(number + 1), placement);
        self.places[number] = placement;
        let known = |k: u32| Some((k, *self.meshes.get(self.places[k as usize].mesh as usize)?));
        let now = known(number as u32).map(|_| placement);
        let concerned: Vec<(u32, MeshGeometry<'_>, Placement)> =
            (self.tracer.concerned(number as u32, now.as_ref()))
                .into_iter()
                .filter_map(|k| known(k).map(|(k, mesh)| (k, mesh, self.places[k as usize])))
                .collect();
        self.tracer.replace(number as u32, now.as_ref(), &concerned);
        concerned.len()
    }

    /// Asserts the bits of rays into the stage; returns how many hit.
    fn is_fresh(&self, rays: usize, rng: &mut Rng) -> usize {
        let fresh = Tracer::build(&self.meshes, &self.places);
        let mut hits = 0;
        for kernel in kernels() {
            let [edited, fresh] =
                [&self.tracer, &fresh].map(|t| t.clone().with_kernel(kernel).expect("available"));
            for _ in 0..rays {
                let (origin, target) = (signed(rng) * 3.0, signed(rng) * 2.0);
                let ray = Ray::new(origin, target - origin);
                let hit = edited.closest(&ray);
                assert_eq!(hit, fresh.closest(&ray), "{kernel:?}");
                assert_eq!(edited.blocked(origin, target), fresh.blocked(origin, target), "{kernel:?}");
                let targets: [[f32; LANES]; 3] =
                    [0, 1, 2].map(|axis| [0; LANES].map(|_| target[axis] + 0.5 * rng.unit()));
                let directions = [0, 1, 2].map(|axis| targets[axis].map(|t| t - origin[axis]));
                let packet = |t: &Tracer| t.closest16(origin, &directions, u16::MAX);
                assert_eq!(packet(&edited), packet(&fresh), "{kernel:?}");
                let shadows = |t: &Tracer| t.occluded16(origin, &targets, u16::MAX);
                assert_eq!(shadows(&edited), shadows(&fresh), "{kernel:?}");
                hits += usize::from(hit.is_some());
            }
        }
        hits
    }
}

const AWAY: u32 = u32::MAX;

#[test]
fn placed_anew_is_built_afresh() {
    let mut rng = Rng::new(4);
    let shapes = shapes(0.7, Vec3::ZERO);
    // Every shape once, the first three twice: they share their trees.
    let mesh = |k: usize| (k % shapes.len()) as u32;
    let places = (0..shapes.len() + 3).map(|k| Placement { mesh: mesh(k), transform: somewhere(&mut rng) });
    let mut stage = Stage::new(&shapes, places.collect());
    assert!(stage.is_fresh(100, &mut rng) > 50);
    let mut hits = 0;
    for step in 0..200 {
        let number = rng.below(stage.places.len() + usize::from(stage.places.len() < 20));
        let transform = match rng.below(20) {
            // What cannot be undone is not there.
            0 => Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0)),
            _ => somewhere(&mut rng),
        };
        let mesh = if rng.below(6) == 0 { AWAY } else { rng.below(shapes.len()) as u32 };
        stage.place(number, Placement { mesh, transform });
        if step % 4 == 0 {
            hits += stage.is_fresh(12, &mut rng);
        }
    }
    assert!(hits > 500, "{hits}");
    // Everything away, and something back.
    let all = stage.places.len();
    for k in 0..all {
        stage.place(k, Placement { mesh: AWAY, transform: Affine3A::IDENTITY });
    }
    assert_eq!(stage.is_fresh(100, &mut rng), 0);
    stage.place(all - 1, Placement { mesh: 0, transform: Affine3A::IDENTITY });
    stage.place(0, Placement { mesh: 4, transform: somewhere(&mut rng) });
    assert!(stage.is_fresh(100, &mut rng) > 30);
}

/// Thousands of small things moved one by one: from time to time they join in one tree.
#[test]
fn crowds_join() {
    let mut rng = Rng::new(8);
    let shard = Shape {
        name: "shard",
        positions: vec![Vec3::ZERO, Vec3::X * 0.2, Vec3::Y * 0.2],
        triangles: vec![[0, 1, 2]],
        centre: Vec3::ZERO,
        inside: 0.0,
    };
    // Each of a mesh of its own, so that none is shared.
    let shards = vec![shard; 1100];
    let places = (0..).map(|mesh| Placement { mesh, transform: somewhere(&mut rng) });
    let mut stage = Stage::new(&shards, places.take(1100).collect());
    let mut most = 0;
    for k in 0..1100 {
        let transform = somewhere(&mut rng);
        most = stage.place(k, Placement { mesh: k as u32, transform }).max(most);
    }
    assert!(most > 1000, "{most} at once");
    assert!(stage.is_fresh(300, &mut rng) > 100);
    // One of the crowd moves alone again.
    stage.place(17, Placement { mesh: 17, transform: Affine3A::IDENTITY });
    stage.place(1090, Placement { mesh: AWAY, transform: Affine3A::IDENTITY });
    assert!(stage.is_fresh(300, &mut rng) > 100);
}
