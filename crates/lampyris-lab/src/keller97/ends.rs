//! §4.2: gloss at both ends of the light of a virtual point light, and what it costs at each.

use crate::effort::Effort;
use crate::error::Result;
use crate::experiment::{Experiment, KELLER97};
use crate::findings::{Comparison, Findings, Image, Table, digits};
use crate::plot::{Axis, Plot, Series};
use crate::stage::{CORNELL, Literal, made_of, of_1997, of_thing, picture};
use crate::statistics::mean;
use lampyris::Rgb;
use lampyris::backend::{Absorption, Batch, Settings};
use lampyris::light::Shine;
use lampyris::material::{Bsdf, Class, Diffuse, Material, Ward};
use lampyris::output::Exposure;
use lampyris::particle::{Plan, Vpl, Walk};
use lampyris::scene::Scene;
use lampyris::sequence::Sequence;
use lampyris::world::World;
use std::f32::consts::FRAC_1_PI;

pub(crate) const ENDS: Experiment = Experiment {
    name: "keller97-gloss-ends",
    title: "Gloss at both ends of a virtual light",
    paper: KELLER97,
    place: "§4.2",
    claim: "T_mn uses the full BRDF where light is received. If particles are equipped with their direction of incidence, more general \
            emission of light sources can be simulated, too. What either costs is not said.",
    seconds: [6.0, 80.0],
    run: ends,
};

const PATHS: u32 = 128;

/// Of what floor and back wall are made. Lobes below 0.15 no virtual light of ours takes part in.
const ALPHAS: [f32; 4] = [0.5, 0.35, 0.25, 0.15];

/// Which of the two ends are glossy: the floor, where light leaves, and the wall, where it arrives.
const ENDS_OF: [(&str, [bool; 2]); 3] =
    [("receiving", [false, true]), ("emitting", [true, false]), ("both", [true, true])];

fn ends(effort: &Effort<'_>) -> Result<Findings> {
    let edge = effort.of(40, 96);
    let draws = effort.of(48, 128);
    let scene = effort.scene("cornell.mgf")?;
    let steps = 1 + ALPHAS.len() * ENDS_OF.len();
    let matt = Measured::new(effort, &coated(&scene, [None; 2]), edge, draws)?;
    effort.step(1, steps)?;
    let mut table = Table::new(
        format!(
            "light that the floor sends to the back wall of the Cornell box: one walk of {PATHS} paths, by {draws} of them"
        ),
        [
            "α",
            "glossy end",
            "RMS error over the mean [%]",
            "over that of matt ends",
            "paths for the error of matt ends",
            "light lost where virtual lights send it evenly [%]",
        ],
    );
    table.row([
        "–".into(),
        "none".into(),
        digits(100.0 * matt.error),
        "1".into(),
        PATHS.to_string(),
        "–".into(),
    ]);
    let mut curves = [const { Vec::new() }; ENDS_OF.len()];
    let mut found = Findings::default();
    let mut images = vec![("matt ends".to_owned(), matt.first.clone())];
    for (number, alpha) in ALPHAS.into_iter().enumerate() {
        for (case, (name, glossy)) in ENDS_OF.into_iter().enumerate() {
            let alphas = glossy.map(|glossy| glossy.then_some(alpha));
            let measured = Measured::new(effort, &coated(&scene, alphas), edge, draws)?;
            let worse = measured.error / matt.error;
            table.row([
                alpha.to_string(),
                name.into(),
                digits(100.0 * measured.error),
                digits(worse),
                digits(f64::from(PATHS) * worse * worse),
                if glossy[0] { digits(100.0 * (1.0 - measured.evenly)) } else { "–".into() },
            ]);
            curves[case].push([f64::from(alpha), 100.0 * measured.error]);
            if number + 1 == ALPHAS.len() {
                let what = format!("error by gloss at the {name} end, α = {alpha}, over that of matt ends");
                found.compare(Comparison::new(what.replace("the both end", "both ends"), "", worse));
                images.push((format!("α = {alpha}, glossy: {name}"), measured.first));
                if glossy[1] {
                    images.push((format!("the same, {draws} walks"), measured.mean));
                }
            }
            effort.step(2 + number * ENDS_OF.len() + case, steps)?;
        }
    }
    let view = CORNELL.view([edge, edge]);
    let exposure = Exposure::Ev(Exposure::Auto.ev(&matt.mean));
    let zoom = effort.of(4, 1);
    let image = |(caption, light)| Image::of_light(caption, picture(&view, light), exposure).zoomed(zoom);
    found.show(images.into_iter().map(image).collect::<Vec<_>>());
    let plot = Plot::new(
        format!("Error of the wall by the floor's virtual lights, {PATHS} paths"),
        Axis::linear("α, less is glossier").from_to(0.0, 0.55),
        Axis::linear("RMS error over the mean [%]"),
    );
    let level = ALPHAS.map(|alpha| [f64::from(alpha), 100.0 * matt.error]).to_vec();
    let curves =
        ENDS_OF.iter().zip(curves).map(|((name, _), points)| Series::line(format!("glossy: {name}"), points));
    found.show(curves.fold(plot, Plot::with).with(Series::dashes("matt ends", level)));
    found.show(table);
    found.gap("The report names both ends and measures neither. Errors are the spread of independent walks, pixel by pixel, so they have no part of any reference; the geometry term is clamped as Lampyris does, alike for all.");
    found.gap("Floor and wall reflect 60 %, half of it by Ward's lobe where they are glossy. Lobes of α < 0.15 Lampyris does not ask virtual lights for: it follows them from the eye, and photons over them from the lights.");
    Ok(found)
}

/// The box with a floor and a back wall that reflect 60 %, half of it by a lobe where there is an α.
fn coated(scene: &Scene, [floor, wall]: [Option<f32>; 2]) -> Scene {
    let bsdf = |alpha: Option<f32>| match alpha {
        None => Bsdf::Diffuse(Diffuse::opaque(Rgb::grey(0.6))),
        Some(alpha) => Bsdf::Ward(Ward {
            base: Diffuse::opaque(Rgb::grey(0.3)),
            specular: Rgb::grey(0.3),
            alpha,
            transmission: Rgb::BLACK,
            transmission_alpha: 0.0,
        }),
    };
    let floored = made_of(scene, "floor", Material::new("floor", bsdf(floor)));
    made_of(&floored, "wall_back", Material::new("wall", bsdf(wall)))
}

/// What some walks make of the light that goes from floor to wall.
struct Measured {
    /// The picture by the first of them, and by all.
    first: Vec<Rgb>,
    mean: Vec<Rgb>,
    /// Standard deviation of the wall's pixels in the mean square, over their mean.
    error: f64,
    /// Light that comes to the eye if virtual lights send it evenly, over what comes.
    evenly: f64,
}

impl Measured {
    fn new(effort: &Effort<'_>, scene: &Scene, edge: u32, draws: u32) -> Result<Measured> {
        let world = World::new(scene.clone());
        let view = CORNELL.view([edge, edge]);
        let bound =
            Plan::new(&world, &Settings { paths: PATHS, passes: Some(1), ..Settings::default() }).bound;
        let literal = Literal { bound, ..Literal::new(&world, &view) };
        let (mut pictures, mut even) = (Vec::new(), 0.0);
        for seed in 0..draws {
            let drawn = Settings {
                absorption: Absorption::Fractional,
                sequence: Sequence::SobolOwen,
                seed,
                ..of_1997(PATHS)
            };
            let walk = Walk::new(&world, &drawn, &Plan::new(&world, &drawn), Batch { index: 0 });
            let lights: Vec<Vpl<'_>> =
                walk.vpls.iter().filter(|light| is_on_the_floor(light)).copied().collect();
            let share = 1.0 / drawn.classes() as f32;
            let light = |lights: &[Vpl<'_>]| -> Vec<Rgb> {
                literal.light_of(lights).into_iter().map(|light| light * share).collect()
            };
            pictures.push(light(&lights));
            if lights.iter().any(|light| light.gloss.is_some()) {
                let all: Vec<Vpl<'_>> = lights.iter().map(evenly).collect();
                even += mean(&of_thing(&world, &view, &light(&all), "wall_back")) / f64::from(draws);
            }
            effort.go_on_or_stop()?;
        }
        let all = mean_of_pictures(&pictures);
        let wall = |picture: &[Rgb]| of_thing(&world, &view, picture, "wall_back");
        let walls: Vec<Vec<Rgb>> = pictures.iter().map(|picture| wall(picture)).collect();
        let lit = mean(&wall(&all));
        let first = pictures.swap_remove(0);
        Ok(Measured { first, mean: all, error: spread(&walls) / lit, evenly: even / lit })
    }
}

fn is_on_the_floor(light: &Vpl<'_>) -> bool {
    matches!(light.shine, Shine::Lambert(n) if n.y > 0.9) && light.position.y < 1e-3
}

/// A virtual light that sends what its vertex reflects to all sides, as a Lambertian would.
fn evenly<'w>(light: &Vpl<'w>) -> Vpl<'w> {
    match &light.gloss {
        None => *light,
        Some(y) => {
            Vpl { intensity: light.intensity * y.albedo(Class::Dull) * FRAC_1_PI, gloss: None, ..*light }
        }
    }
}

fn mean_of_pictures(pictures: &[Vec<Rgb>]) -> Vec<Rgb> {
    let share = 1.0 / pictures.len() as f32;
    (0..pictures[0].len())
        .map(|k| pictures.iter().fold(Rgb::BLACK, |sum, picture| sum + picture[k] * share))
        .collect()
}

/// Standard deviation of luminances from picture to picture, in the mean square over their pixels.
fn spread(pictures: &[Vec<Rgb>]) -> f64 {
    let mean = mean_of_pictures(pictures);
    let square = |picture: &Vec<Rgb>| crate::statistics::rms(picture, &mean).powi(2);
    (pictures.iter().map(square).sum::<f64>() / (pictures.len() - 1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::tests::shipped;

    /// A Lambertian floor's virtual lights are even as they are, and a glossy floor's send on what it reflects.
    #[test]
    fn even_lights_keep_the_flux() {
        let scene = shipped("cornell.mgf").scene().clone();
        let settings = of_1997(256);
        for alpha in [None, Some(0.25)] {
            let world = World::new(coated(&scene, [alpha, None]));
            let walk = Walk::new(&world, &settings, &Plan::new(&world, &settings), Batch { index: 0 });
            let lights: Vec<&Vpl<'_>> = walk.vpls.iter().filter(|light| is_on_the_floor(light)).collect();
            assert!(lights.len() > 10);
            for light in lights {
                assert_eq!(light.gloss.is_some(), alpha.is_some());
                let even = evenly(light);
                match alpha {
                    None => assert_eq!(even.intensity, light.intensity),
                    // Between what the base and what base and lobe reflect, per π.
                    Some(_) => {
                        let share = even.intensity.g / light.intensity.g * std::f32::consts::PI;
                        assert!((0.3..0.65).contains(&share) && even.gloss.is_none(), "{share}");
                    }
                }
            }
        }
    }

    #[test]
    fn pictures_spread_as_their_numbers_do() {
        let pictures = [1.0, 2.0, 3.0].map(|v| vec![Rgb::grey(v), Rgb::grey(2.0 * v)]);
        assert!((spread(&pictures) - 2.5_f64.sqrt()).abs() < 1e-6);
    }
}
