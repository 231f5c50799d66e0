//! The walk against brute force, and the builder against scenes made to hurt it.

use super::*;

fn random(state: &mut u32) -> f32 {
    *state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((*state >> ((*state >> 28) + 4)) ^ *state).wrapping_mul(277_803_737);
    (((word >> 22) ^ word) >> 8) as f32 / (1 << 24) as f32
}

fn vector(state: &mut u32) -> Vec3 {
    Vec3::new(random(state), random(state), random(state))
}

fn primitive(corners: [Vec3; 3], triangle: u32) -> Primitive {
    Primitive {
        corners,
        instance: 0,
        triangle,
        culled: triangle.is_multiple_of(5),
        mirrored: triangle.is_multiple_of(7),
        screened: false,
    }
}

/// Triangles of all sizes, slivers, needles, duplicates, coplanar grids.
fn soup(count: u32, state: &mut u32) -> Vec<Primitive> {
    let mut all: Vec<Primitive> = Vec::new();
    for i in 0..count {
        let at = vector(state);
        let size = libm::powf(0.01, random(state));
        let mut corners = [0; 3].map(|_| at + (vector(state) - 0.5) * size);
        match i % 8 {
            0 => corners[2] = corners[0].lerp(corners[1], 0.5) + vector(state) * 1e-7,
            1 => corners = corners.map(|c| (c * 8.0).round() / 8.0),
            2 => {
                corners =
                    corners.map(|c| Vec3::new((c.x * 8.0).round() / 8.0, (c.y * 8.0).round() / 8.0, 0.5))
            }
            3 if !all.is_empty() => corners = all[(random(state) * all.len() as f32) as usize].corners,
            _ => {}
        }
        all.push(primitive(corners, i));
    }
    all
}

fn kernels() -> impl Iterator<Item = Kernel> {
    [Kernel::Portable, Kernel::Avx2, Kernel::Avx512].into_iter().filter(|k| k.available())
}

/// Corners, points of edges and of faces, grid points, anything.
fn target(soup: &[Primitive], state: &mut u32) -> Vec3 {
    let [a, b, c] = soup[(random(state) * soup.len() as f32) as usize].corners;
    match (random(state) * 5.0) as u32 {
        0 => a,
        1 => a + (b - a) * random(state),
        2 => a.lerp(b, random(state)).lerp(c, random(state)),
        3 => (vector(state) * 8.0).round() / 8.0,
        _ => vector(state),
    }
}

#[test]
#[expect(clippy::needless_range_loop, reason = "lanes run through several arrays")]
fn walks_agree_with_brute_force() {
    let mut state = 1;
    let (mut hits, mut blocked) = (0, 0);
    for count in [1, 7, 8, 9, 100, 3000] {
        let soup = soup(count, &mut state);
        let tree = Tree::new(soup.len() as u32, |i| Some(soup[i as usize]), &Screen::default());
        for _ in 0..(300_000 / (count as usize + 100)) {
            let origin = if random(&mut state) < 0.5 {
                target(&soup, &mut state)
            } else {
                vector(&mut state) * 3.0 - 1.0
            };
            let mut targets = [[0.0; LANES]; 3];
            for i in 0..LANES {
                let to = target(&soup, &mut state);
                // Some lanes equal, some axis-parallel, some pointing nowhere special.
                let to = if i % 4 == 3 { origin + Vec3::AXES[i % 3] } else { to };
                for axis in 0..3 {
                    targets[axis][i] = to[axis];
                }
            }
            let lane = |i: usize| Vec3::new(targets[0][i], targets[1][i], targets[2][i]);
            let live = (0..LANES).filter(|&i| lane(i) != origin).fold(0u16, |l, i| l | 1 << i);
            let directions = [0, 1, 2].map(|a| targets[a].map(|t| t - origin[a]));

            let mut expected = [None; LANES];
            let mut stopped = 0u16;
            for i in (0..LANES).filter(|i| live >> i & 1 == 1) {
                let ray = Ray::between(origin, lane(i));
                let line = Line::new(&ray);
                let mut best = Best::none(f32::INFINITY);
                for block in &tree.blocks {
                    for k in 0..WIDTH {
                        block.offer(k, &line, &Screen::default(), &mut best);
                        stopped |=
                            u16::from(block.blocks(k, &line, End::Point(lane(i)), &Screen::default())) << i;
                    }
                }
                expected[i] = best.hit();
                hits += u32::from(best.found);
                for kernel in kernels() {
                    let mut found = Best::none(f32::INFINITY);
                    tree.closest(kernel, &ray, None, &mut found);
                    assert_eq!(found.hit(), expected[i], "{kernel:?}");
                    let to_there = End::Point(lane(i));
                    assert_eq!(
                        tree.occluded(kernel, &ray, to_there, None),
                        stopped >> i & 1 == 1,
                        "{kernel:?}"
                    );
                    for t in [best.t, best.t.next_up(), 0.5 * best.t] {
                        let nearer = best.found && best.t < t;
                        assert_eq!(tree.occluded(kernel, &ray, End::Distance(t), None), nearer, "{kernel:?}");
                    }
                }
            }
            blocked += stopped.count_ones();
            // Blocks at random to be asked first: none, any, and numbers that there are not.
            let reversed = targets.map(|mut axis| {
                axis.reverse();
                axis
            });
            let firsts = [NONE, (random(&mut state) * tree.blocks.len() as f32) as u32, 1 << 30];
            for kernel in kernels() {
                let mut best = PacketBest::none();
                tree.closest16(kernel, origin, &directions, live, &mut best);
                for (i, expected) in expected.iter().enumerate() {
                    assert_eq!(best.lane(i).hit(), *expected, "{kernel:?}");
                }
                for mut first in firsts {
                    // Then again with what blocked last.
                    for _ in 0..2 {
                        let [found] = tree.occluded_parts(kernel, origin, [&targets], [live], &mut first);
                        assert_eq!(found, stopped, "{kernel:?} {first}");
                        // Together with the same the other way round, with none and with some of them.
                        let parts = [&targets, &reversed, &targets, &targets];
                        let lives = [live, live.reverse_bits(), 0, live & 0xf0];
                        let found = tree.occluded_parts(kernel, origin, parts, lives, &mut first);
                        let expected = [stopped, stopped.reverse_bits(), 0, stopped & 0xf0];
                        assert_eq!(found, expected, "{kernel:?} {first}");
                    }
                }
            }
        }
    }
    assert!(hits > 10_000 && blocked > 5_000, "{hits} {blocked}");
}

fn depth(hierarchy: &Hierarchy, node: usize) -> usize {
    let children = hierarchy.nodes[node].child.iter().filter(|c| **c != NONE && **c & LEAF == 0);
    1 + children.map(|c| depth(hierarchy, *c as usize)).max().unwrap_or(0)
}

#[test]
fn no_scene_makes_the_tree_deep() {
    let point = |p: Vec3| Bounds { lower: p, upper: p };
    let same = vec![point(Vec3::ONE); 1_000_000];
    let powers: Vec<Bounds> = (0..20_000).map(|i| point(Vec3::splat(2f32.powi(i % 250 - 125)))).collect();
    let nested: Vec<Bounds> = (0..20_000)
        .map(|i| Bounds { lower: Vec3::splat(-(1.001f32.powi(i))), upper: Vec3::splat(1.001f32.powi(i)) })
        .collect();
    for boxes in [same, powers, nested] {
        let mut items: Vec<Item> =
            (0..).zip(&boxes).map(|(index, bounds)| Item { bounds: *bounds, index }).collect();
        let (hierarchy, leaves) = build(&mut items, WIDTH);
        assert!(depth(&hierarchy, 0) <= build::MAX_DEPTH);
        let mut all: Vec<u32> = leaves
            .iter()
            .flat_map(|leaf| &items[leaf.start as usize..leaf.end as usize])
            .map(|item| item.index)
            .collect();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..boxes.len() as u32), "every box lies in one leaf");
        assert!(leaves.iter().all(|l| l.len() <= WIDTH));
    }
}

#[test]
fn the_tree_does_not_depend_on_threads() {
    let soup = soup(30_000, &mut 3);
    let build = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        format!(
            "{:?}",
            pool.install(|| Tree::new(soup.len() as u32, |i| Some(soup[i as usize]), &Screen::default()))
        )
    };
    let one = build(1);
    assert!(one == build(2) && one == build(7));
}

#[test]
fn moved_blocks_are_moved_as_glam_moves_points() {
    let mut state = 5;
    let transform = Affine3A::from_mat3_translation(
        glam::Mat3::from_cols(vector(&mut state), vector(&mut state), vector(&mut state)),
        vector(&mut state) * 1e3,
    );
    let soup = soup(8, &mut state);
    let tree = Tree::new(soup.len() as u32, |i| Some(soup[i as usize]), &Screen::default());
    let moved = tree.blocks[0].placed(&Placed { instance: 4, transform, mirrored: true });
    for i in 0..WIDTH {
        let corners = tree.blocks[0].corners(i).map(|c| transform.transform_point3(c));
        assert_eq!(moved.corners(i), corners);
    }
}
