//! What ⌊ρ̄ʲN⌋ loses, and the random threshold does not.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Demand, Findings, Table, digits};
use crate::plot::{Axis, Mark, Plot, Series};
use glam::{Affine3A, Vec3};
use lampyris::backend::{Absorption, Backend, Settings};
use lampyris::cpu::Cpu;
use lampyris::eye::{Eye, Meter};
use lampyris::scene::{Instance, Mesh, Scene};

pub(crate) const THINNING: Experiment = Experiment {
    name: "keller97-thinning",
    title: "The light that fractional absorption loses",
    paper: KELLER97,
    place: "§3.2 and Figure 6",
    claim: "Generation j of the walk has ⌊ρ̄ʲN⌋ particles, each compensated by N/⌊ρ̄ʲN⌋; the walk ends when no particle remains.",
    seconds: [3.0, 70.0],
    run: thinning,
};

/// The share of the indirect light in the generations that have no particle.
fn lost(reflectance: f64, n: f64) -> f64 {
    let mut kept = 0;
    while libm::pow(reflectance, f64::from(kept + 1)) * n >= 1.0 - 1e-9 {
        kept += 1;
    }
    libm::pow(reflectance, f64::from(kept))
}

fn thinning(effort: &Effort<'_>) -> Result<Findings> {
    let six = effort.scene("cube.mgf")?;
    let scene = as_one(&six);
    let mut cpu = Cpu::new(None)?;
    let mut found = Findings::default();
    let counts = [9, 16, 32, 128, 1024];
    let mut table = Table::new(
        "share of the indirect light in the closed cube with ρ = 1/2 that is missing [%]; ± is half the 95 % interval",
        ["N", "⌊ρ̄ʲN⌋ by theory", "⌊ρ̄ʲN⌋ by our walk", "±", "of six lamps: ⌊ρ̄ʲN/6⌋", "random threshold", "±"],
    );
    let mut walked = Vec::new();
    for (number, paths) in counts.into_iter().enumerate() {
        let batches = (effort.of(60_000, 1_000_000) / paths).max(64);
        let mut of = |scene, absorption| missing(effort, &mut cpu, scene, (absorption, paths, batches));
        let (literal, literal_error) = of(&scene, Absorption::Paper)?;
        let (dealt, _) = of(&six, Absorption::Paper)?;
        let (ours, error) = of(&scene, Absorption::Fractional)?;
        let theory = 100.0 * lost(0.5, f64::from(paths));
        table.row([
            paths.to_string(),
            digits(theory),
            digits(literal),
            digits(literal_error),
            digits(dealt),
            digits(ours),
            digits(error),
        ]);
        walked.push((theory, literal, literal_error, ours, error));
        effort.step(number + 1, counts.len())?;
    }
    for (paths, (theory, literal, literal_error, ours, error)) in counts.into_iter().zip(walked) {
        let what = format!("missing with ⌊ρ̄ʲN⌋, N = {paths}");
        let slack = (2.0 * literal_error).max(0.02 * theory);
        found.compare(
            Comparison::new(what, "%", literal)
                .says(format!("nothing; by theory {} %", digits(theory)))
                .demand(Demand::Within(theory - slack, theory + slack)),
        );
        if paths == 9 {
            found.compare(
                Comparison::new("missing with a random threshold, N = 9", "%", ours)
                    .demand(Demand::Within(-2.0 * error, 2.0 * error)),
            );
        }
    }
    let mut plot = Plot::new(
        "Missing indirect light by theory",
        Axis::log("paths of a batch, N"),
        Axis::log("missing share of the indirect light [%]"),
    );
    for reflectance in [0.5, 0.7, 0.9] {
        let points = (0..=70).map(|k| libm::pow(10.0, 0.5 + f64::from(k) * 0.05));
        let points = points.map(|n| [n, 100.0 * lost(reflectance, n)]).collect();
        plot = plot.with(Series::of(format!("ρ̄ = {reflectance}"), points, Mark::Curve));
    }
    found.show(table);
    found.show(plot);
    found.gap(
        "Every batch loses the light of the generations that have no particle, and accumulating batches never mends it. The report's \
         N = 128 loses under a per cent where ρ̄ = 1/2; batches of interactive size, N = 9, lose an eighth. Lampyris draws a threshold at \
         random instead, which keeps every generation in the mean.",
    );
    found.gap("The report chooses a lamp by composition and then thins all particles together. Where each lamp has a share of the paths of its own, as it must if lamps are to be dimmed apart, rounding down is done lamp by lamp and loses far more.");
    found.gap("Figure 6 multiplies by f_d where the cosine-distributed direction asks for π f_d, and compounds N/⌊ρ̄ʲN⌋ in its loop; what is run here is what the text means.");
    Ok(found)
}

/// The same surfaces as one body, so that the walls together are one lamp.
fn as_one(scene: &Scene) -> Scene {
    let mut whole = Mesh::default();
    for instance in &scene.instances {
        let mesh = &scene.meshes[instance.mesh as usize];
        let first = whole.positions.len() as u32;
        whole.positions.extend(mesh.positions.iter().map(|p| instance.transform.transform_point3(*p)));
        whole.triangles.extend(mesh.triangles.iter().map(|t| t.map(|corner| corner + first)));
        whole.materials.extend(&mesh.materials);
    }
    let instance = Instance { name: "walls".into(), mesh: 0, transform: Affine3A::IDENTITY };
    Scene { meshes: vec![whole], instances: vec![instance], ..scene.clone() }
}

/// How much of the light reflected by the walls is missing in the mean over some meters, and half the 95 % interval [%].
fn missing(
    effort: &Effort<'_>,
    cpu: &mut Cpu,
    scene: &Scene,
    (absorption, paths, batches): (Absorption, u32, u32),
) -> Result<(f64, f64)> {
    // Of radiance 1/2 on every wall 1/4 is emitted, and 1/4 reflected.
    const REFLECTED: f64 = 0.25;
    let settings = Settings {
        // Meters in the air need no clamp, whose compensation would count longer paths than the walk has.
        parts: vec!["vpl".into()],
        clamp: 0.0,
        paths,
        passes: Some(1),
        absorption,
        replicates: 32,
        ..Settings::default()
    };
    let places = (1..4).flat_map(|x| (1..4).map(move |y| Vec3::new(x as f32 * 0.25, y as f32 * 0.25, 0.5)));
    let meters: Vec<Meter> = places
        .flat_map(|position| [Vec3::X, Vec3::NEG_Y, Vec3::Z].map(|normal| Meter { position, normal }))
        .collect();
    effort.render(cpu, (scene.clone(), Eye::Meters(meters)), &settings, batches)?;
    let frame = cpu.frame()?;
    let mean = crate::statistics::mean(&frame.mean());
    let error = f64::from(frame.relative_error() * frame.student_factor()) * mean;
    Ok((100.0 * (1.0 - mean / REFLECTED), 100.0 * error / REFLECTED))
}

#[cfg(test)]
mod tests {
    use super::lost;

    #[test]
    fn generations_without_a_particle_are_lost() {
        assert_eq!([9.0, 16.0, 32.0, 128.0].map(|n| lost(0.5, n)), [0.125, 0.0625, 0.03125, 0.0078125]);
    }
}
