//! Table 2: what inverting the BRDF saves in rooms.

use super::KELLER96;
use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::Experiment;
use crate::findings::{Comparison, Demand, Findings, Table};
use lampyris::Rgb;
use lampyris::elements::{Criterion, Elements, converge};
use lampyris::material::{Bsdf, Diffuse, Ward};
use lampyris::scatter::{Inversion, RandomWalk, Rules};
use lampyris::scene::Scene;
use lampyris::sequence::Generator;
use lampyris::world::World;

pub(crate) const TABLE_2: Experiment = Experiment {
    name: "keller96-table-2",
    title: "Paths needed in rooms, with and without inversion",
    paper: KELLER96,
    place: "Table 2, §4.4",
    claim: "Office (6070 elements, 5 lights): congruential 48 000, inversive 51 000, Halton 39 000, Faure 41 000 paths, and no fewer with \
            inversion, but for Faure's 38 000. Soda, with specular surfaces: 70 000, 71 000, 65 000 and 66 000 without, 54 000, 64 000, \
            55 000 and 49 000 with inversion.",
    seconds: [12.0, 120.0],
    run: table_2,
};

fn table_2(effort: &Effort<'_>) -> Result<Findings> {
    let generators: &[Generator] = if effort.quick {
        &[Generator::Congruential, Generator::Halton]
    } else {
        &[
            Generator::Congruential,
            Generator::Inversive,
            Generator::Halton,
            Generator::Faure { dimensions: 16 },
        ]
    };
    let rooms = [
        ("cornell.mgf", "diffuse", effort.scene("cornell.mgf")?),
        ("office.mgf", "mainly diffuse", effort.scene("office.mgf")?),
        ("foyer.mgf", "a polished floor", effort.scene("foyer.mgf")?),
        ("cornell.mgf, glossy", "specular", polished(effort.scene("cornell.mgf")?)),
    ];
    let size = effort.of(0.5, 0.3);
    let most = effort.of(300_000, 4_000_000);
    let mut found = Findings::default();
    let mut table = Table::new(
        format!("paths needed, elements of {size} m at most"),
        ["room", "surfaces", "elements", "lamps", "generator", "N without inversion", "N with inversion"],
    );
    let told = |n: Option<u32>| n.map_or(format!("more than {most}"), |n| n.to_string());
    let steps = rooms.len() * generators.len();
    let mut done = 0;
    for (name, kind, scene) in rooms {
        let world = World::new(scene);
        let elements = Elements::new(&world, size)?;
        let criterion = Criterion { most, ..Criterion::default().scaled_to(&elements) };
        for generator in generators {
            let n = |inversion| {
                let rules = Rules { inversion, ..Rules::paper(*generator, 1) };
                converge(&RandomWalk::new(&world, rules), &elements, &criterion).paths
            };
            let (without, with) = (n(Inversion::Cosine), n(Inversion::Bsdf));
            table.row([
                name.into(),
                kind.into(),
                elements.len().to_string(),
                world.emitters().len().to_string(),
                generator.name().into(),
                told(without),
                told(with),
            ]);
            if let (Some(without), Some(with)) = (without, with) {
                let what = format!("N with over N without inversion, {name}, {}", generator.name());
                let comparison = Comparison::new(what, "", f64::from(with) / f64::from(without));
                let paper = |diffuse: f64, specular: f64| if kind == "specular" { specular } else { diffuse };
                found.compare(match (kind, generator) {
                    ("diffuse", _) => comparison.paper(1.0).demand(Demand::Within(1.0, 1.0)),
                    (_, Generator::Congruential) => {
                        comparison.paper(paper(1.0, 54.0 / 70.0)).demand(Demand::AtMost(1.0))
                    }
                    (_, Generator::Halton) => {
                        comparison.paper(paper(1.0, 55.0 / 65.0)).demand(Demand::AtMost(1.0))
                    }
                    _ => comparison,
                });
            }
            done += 1;
            effort.step(done, steps)?;
        }
    }
    found.show(table);
    found.gap("The paper's rooms office, cabin, doll and soda are not at hand; the specular one here is the Cornell box in gloss, held against the paper's soda. ε is scaled by the area of the room, which the paper does not say.");
    Ok(found)
}

/// Every diffuse surface with two thirds of its light in a glossy lobe.
fn polished(mut scene: Scene) -> Scene {
    for material in &mut scene.materials {
        if let Bsdf::Diffuse(diffuse) = material.bsdf {
            material.bsdf = Bsdf::Ward(Ward {
                base: Diffuse::opaque(diffuse.reflectance * 0.3),
                specular: Rgb::grey(0.6),
                alpha: 0.1,
                transmission: Rgb::BLACK,
                transmission_alpha: 0.0,
            });
        }
    }
    scene
}
