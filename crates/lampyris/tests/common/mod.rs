//! Closed meshes that are hard on a tracer, and random numbers that never change.
#![allow(dead_code, unreachable_pub, reason = "each test takes what it needs")]

use glam::{Affine3A, Vec3};
use lampyris::geometry::{Kernel, MeshGeometry, Placement, Tracer};
use std::collections::HashMap;

/// A counter hashed (the finaliser of PCG's RXS-M-XS).
pub struct Rng(u32);

impl Rng {
    pub fn new(seed: u32) -> Rng {
        Rng(seed.wrapping_mul(0x9e37_79b9) ^ 0x55aa_1234)
    }

    pub fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    }

    pub fn unit(&mut self) -> f32 {
        (self.next() >> 8) as f32 / (1 << 24) as f32
    }

    pub fn below(&mut self, n: usize) -> usize {
        ((u64::from(self.next()) * n as u64) >> 32) as usize
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit())
    }
}

/// A closed mesh and a cube around its centre that is inside.
#[derive(Clone)]
pub struct Shape {
    pub name: &'static str,
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    pub centre: Vec3,
    pub inside: f32,
}

pub fn kernels() -> Vec<Kernel> {
    [Kernel::Portable, Kernel::Avx2, Kernel::Avx512].into_iter().filter(|k| k.available()).collect()
}

pub fn tracer(shape: &Shape) -> Tracer {
    let mesh = MeshGeometry {
        positions: &shape.positions,
        triangles: &shape.triangles,
        one_sided: &[],
        screened: &[],
    };
    Tracer::build(&[mesh], &[Placement { mesh: 0, transform: Affine3A::IDENTITY }])
}

/// The closed meshes, all about a metre in size before `scale`, around `offset`.
pub fn shapes(scale: f32, offset: Vec3) -> Vec<Shape> {
    let mut all = vec![stone(), room(), slivers()];
    for shape in &mut all {
        for p in &mut shape.positions {
            *p = *p * scale + offset;
        }
        shape.centre = offset;
        shape.inside *= scale;
    }
    all
}

/// An octahedron, four times subdivided, displaced.
fn stone() -> Shape {
    let mut positions = vec![Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    for _ in 0..4 {
        let mut middles = HashMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let mut middle = |i: u32, j: u32| {
                *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                    positions.push((positions[i as usize] + positions[j as usize]).normalize());
                    positions.len() as u32 - 1
                })
            };
            let (d, e, f) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
        }
        triangles = finer;
    }
    let mut rng = Rng::new(1);
    let positions = positions.iter().map(|p| *p * (0.7 + 0.5 * rng.unit())).collect();
    Shape { name: "stone", positions, triangles, centre: Vec3::ZERO, inside: 0.3 }
}

/// A box whose walls are grids with lines at `lines` (from -1 to 1), the same along each axis.
fn box_of(name: &'static str, lines: &[f32], inside: f32) -> Shape {
    let mut numbers = HashMap::new();
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    let last = lines.len() - 1;
    for axis in 0..3 {
        for side in [0, last] {
            let mut vertex = |i: usize, j: usize| {
                let mut key = [0; 3];
                (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (side, i, j);
                *numbers.entry(key).or_insert_with(|| {
                    positions.push(Vec3::from_array(key.map(|k| lines[k])));
                    positions.len() as u32 - 1
                })
            };
            for i in 0..last {
                for j in 0..last {
                    let [a, b, c, d] =
                        [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                    let pair = if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                    triangles.extend(pair.map(|[a, b, c]| if side == 0 { [a, b, c] } else { [a, c, b] }));
                }
            }
        }
    }
    Shape { name, positions, triangles, centre: Vec3::ZERO, inside }
}

/// A room, divided at irregular lines.
fn room() -> Shape {
    box_of("room", &[-1.0, -0.83, -0.8125, -0.31, 0.0, 0.0078125, 0.4, 0.77, 1.0], 0.9)
}

/// A box of slivers: lines closer than a thousandth.
fn slivers() -> Shape {
    box_of("slivers", &[-1.0, -0.9995, -0.999, 0.1, 0.1001, 0.10011, 0.99999, 1.0], 0.99)
}
