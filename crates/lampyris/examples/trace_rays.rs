//! Speed of the tracer on one core: `trace_rays [--any | --from-end | --from-start | --packet] soup.tris.bin rays.f32`.
//! Soup: raw f32 [n][3][3]; rays: raw f32 [n][8] = ox oy oz tnear dx dy dz tfar (tnear counts as 0). It prints how
//! many rays hit, the sum of t and Mrays/s; `--from-end` and `--from-start` trace segments 16 by 16 from the end or
//! start that they share, `--packet` half-lines 16 by 16 from their common origin. `--portable` and `--avx2` choose a
//! kernel below the best.

use glam::{Affine3A, Vec3};
use lampyris::geometry::{Kernel, LANES, MeshGeometry, Occluder, Placement, Ray, Tracer};
use std::collections::HashMap;
use std::time::Instant;

const REPETITIONS: usize = 7;

/// Seconds of CPU time where the system tells (Linux), else of the clock.
fn now(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|s| s.split(' ').next().and_then(|n| n.parse::<f64>().ok()));
    nanoseconds.map_or(start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

fn floats(path: &str) -> std::io::Result<Vec<f32>> {
    let bytes = std::fs::read(path)?;
    Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
}

fn closest(tracer: &Tracer, rays: &[Ray]) -> (u64, f64) {
    rays.iter()
        .filter_map(|ray| tracer.closest(ray))
        .fold((0, 0.0), |(n, t), hit| (n + 1, t + f64::from(hit.t)))
}

fn any(tracer: &Tracer, rays: &[Ray]) -> (u64, f64) {
    (rays.iter().filter(|ray| tracer.occluded(ray)).count() as u64, 0.0)
}

/// Half-lines in the order of the file, sixteen of one origin at a time.
fn packet(tracer: &Tracer, rays: &[Ray]) -> (u64, f64) {
    let (mut hits, mut sum) = (0, 0.0);
    for rays in rays.chunks(LANES) {
        let mut directions = [[0.0; LANES]; 3];
        for (i, ray) in rays.iter().enumerate() {
            for (axis, directions) in directions.iter_mut().enumerate() {
                directions[i] = ray.direction[axis];
            }
        }
        let met = tracer.closest16(rays[0].origin, &directions, ((1u32 << rays.len()) - 1) as u16);
        hits += u64::from(met.hit.count_ones());
        sum += met.t.iter().map(|t| f64::from(*t)).sum::<f64>();
    }
    (hits, sum)
}

/// Segments of one end.
struct Shadows {
    shared: Vec3,
    /// Which of the points that are shared.
    number: usize,
    others: [[f32; LANES]; 3],
    live: u16,
}

/// Segments in the order of the file, as long as they share a point within rounding: one end, and the other one.
fn gather(segments: &[[Vec3; 2]]) -> Vec<Shadows> {
    let mut all = Vec::new();
    let mut numbers = HashMap::new();
    let mut rest = segments;
    while let Some(&[shared, _]) = rest.first() {
        let margin = 1e-5 * (1.0 + shared.abs().max_element());
        let near = |s: &&[Vec3; 2]| (s[0] - shared).abs().max_element() <= margin;
        let count = rest.iter().take(LANES).take_while(near).count();
        let mut others = [[0.0; LANES]; 3];
        for (i, [_, other]) in rest[..count].iter().enumerate() {
            for (axis, others) in others.iter_mut().enumerate() {
                others[i] = other[axis];
            }
        }
        let next = numbers.len();
        let number = *numbers.entry((shared * 1e3).to_array().map(|x| x as i32)).or_insert(next);
        all.push(Shadows { shared, number, others, live: ((1u32 << count) - 1) as u16 });
        rest = &rest[count..];
    }
    all
}

fn shadows(tracer: &Tracer, shadows: &[Shadows]) -> (u64, f64) {
    let mut occluders = vec![Occluder::default(); shadows.len()];
    let mut hits = 0;
    for s in shadows {
        let occluder = &mut occluders[s.number];
        hits += u64::from(tracer.occluded_parts(s.shared, [&s.others], [s.live], occluder)[0].count_ones());
    }
    (hits, 0.0)
}

#[expect(clippy::print_stdout, clippy::print_stderr, reason = "a program that reports to the terminal")]
fn main() -> std::io::Result<()> {
    let (options, files): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|a| a.starts_with("--"));
    let [soup, rays] = &files[..] else {
        eprintln!("trace_rays [--any | --from-end | --from-start | --packet] soup.tris.bin rays.f32");
        std::process::exit(2);
    };
    let has = |option: &str| options.iter().any(|o| o == option);
    let positions: Vec<Vec3> = floats(soup)?.chunks_exact(3).map(Vec3::from_slice).collect();
    let triangles: Vec<[u32; 3]> =
        (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = MeshGeometry { positions: &positions, triangles: &triangles, one_sided: &[], screened: &[] };
    let start = Instant::now();
    let tracer = Tracer::build(&[mesh], &[Placement { mesh: 0, transform: Affine3A::IDENTITY }]);
    let kernel = match () {
        () if has("--portable") => Kernel::Portable,
        () if has("--avx2") => Kernel::Avx2,
        () => tracer.kernel(),
    };
    let Some(tracer) = tracer.with_kernel(kernel) else {
        eprintln!("this machine has no {kernel:?}");
        std::process::exit(2);
    };
    println!(
        "{:?} build {:.3} s memory {:.1} B/triangle {:?}",
        tracer.kernel(),
        start.elapsed().as_secs_f64(),
        tracer.memory() as f64 / triangles.len() as f64,
        tracer.report()
    );
    let rays: Vec<Ray> = floats(rays)?
        .chunks_exact(8)
        .map(|r| Ray { origin: Vec3::from_slice(r), direction: Vec3::from_slice(&r[4..]), t_max: r[7] })
        .collect();

    let packets = if has("--from-end") {
        gather(&rays.iter().map(|r| [r.at(1.0), r.origin]).collect::<Vec<_>>())
    } else {
        gather(&rays.iter().map(|r| [r.origin, r.at(1.0)]).collect::<Vec<_>>())
    };
    let trace = || {
        if has("--from-end") || has("--from-start") {
            shadows(&tracer, &packets)
        } else if has("--packet") {
            packet(&tracer, &rays)
        } else if has("--any") {
            any(&tracer, &rays)
        } else {
            closest(&tracer, &rays)
        }
    };
    // Long enough for the clock of the scheduler.
    let rounds = (1_000_000 / rays.len().max(1)).max(1);
    let mut best = f64::INFINITY;
    let (mut hits, mut sum) = (0, 0.0);
    for _ in 0..REPETITIONS {
        let begin = now(start);
        for _ in 0..rounds {
            (hits, sum) = trace();
        }
        best = best.min((now(start) - begin) / rounds as f64);
    }
    println!(
        "rays {} hits {hits} sum t {sum:.6e} Mrays/s {:.3}",
        rays.len(),
        rays.len() as f64 / best * 1e-6
    );
    Ok(())
}
