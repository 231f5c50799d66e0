//! What lights this: the illuminance at a point, lamp by lamp, and by which ways it comes.
//!
//! A question is a film of one meter in which each emitter is summed apart, and each part of the light too. The light paths
//! are those of any other meter, dealt to the emitters by the same shares and rounded up, so that a batch costs about what
//! it costs there, however many lamps there are. Batches are kept apart by randomisation, not in a frame: what a set of lamps gives
//! varies less than its lamps do, and that can be told for any set afterwards.

use super::GoOn;
use super::film::Film;
use crate::color::Rgb;
use crate::error::{Error, Result};
use crate::eye::{Eye, Meter};
use crate::frame::mean_and_variance;
use crate::integrator;
use crate::particle::Plan;
use crate::settings::{Batch, Settings, Statistics};
use crate::testing::student_quantile;
use crate::world::World;
use std::f32::consts::PI;

/// Emitters that a question tells apart at most: each takes some 20 kB while a batch of 64 eye passes is summed.
const MOST_EMITTERS: usize = 1 << 12;

/// What lights a point? To be pursued batch by batch, by [`Session::pursue`](crate::session::Session::pursue).
pub struct Question {
    meter: Meter,
    settings: Settings,
    /// Which state of the world the sums are of.
    world: Option<u64>,
    film: Option<Film>,
    batches: u32,
    /// Of each randomisation.
    sums: Vec<Sum>,
}

/// The batches of one randomisation.
#[derive(Clone, Default)]
struct Sum {
    batches: u32,
    /// Of each emitter, in the colour that it has as a lamp of its group, by kind and channel.
    light: Vec<[[f64; 3]; KINDS]>,
}

/// Kinds of light that are told apart.
const KINDS: usize = 3;

/// What is known of the light at a point. Copies are what was known then.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    batches: u32,
    /// Of each randomisation that has batches, how many, and the lux of each emitter by kind in their mean.
    found: Vec<(u32, Vec<[f64; KINDS]>)>,
}

/// An illuminance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// [lx].
    pub lux: f32,
    /// Half of its 95 % interval [lx]; infinite before two randomisations have a batch.
    pub error: f32,
}

/// What some lamps give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// In all.
    pub all: Reading,
    /// Straight from the lamp.
    pub direct: Reading,
    /// By way of surfaces, the light of planar mirrors among it.
    pub indirect: Reading,
    /// Thrown by glass, polish and curved mirrors. Meters, where photons do not stay, miss that of points and parallel light
    /// (docs/light-transport.md).
    pub caustic: Reading,
}

impl Question {
    /// What lights that side of that point, by such settings.
    ///
    /// # Errors
    /// [`Error::BadSetting`] for settings that make no sense, and for the part *path*, which does not tell by which way
    /// light comes.
    pub fn new(meter: Meter, settings: &Settings) -> Result<Question> {
        settings.check()?;
        if settings.parts.iter().any(|part| part == "path") {
            return Err(Error::BadSetting(
                "\"path\" does not tell direct light from indirect: ask for other parts".into(),
            ));
        }
        Ok(Question {
            meter,
            settings: settings.clone(),
            world: None,
            film: None,
            batches: 0,
            sums: Vec::new(),
        })
    }

    /// Where.
    pub fn meter(&self) -> Meter {
        self.meter
    }

    /// Batches that are known of the world as it stood when the question was pursued last.
    pub fn batches(&self) -> u32 {
        self.batches
    }

    /// What was done in this state of the world.
    pub fn statistics(&self) -> Statistics {
        self.film.as_ref().map(|film| film.statistics).unwrap_or_default()
    }

    /// Adds a batch; of a world in another state it is the first.
    pub(super) fn add(&mut self, world: &World, state: u64, go_on: GoOn<'_>) -> Result<bool> {
        let film = match &mut self.film {
            Some(film) if self.world == Some(state) && film.plan.layers() == world.emitters().len() => film,
            film => {
                let emitters = world.emitters().len();
                if emitters > MOST_EMITTERS {
                    return Err(Error::BadSetting(format!(
                        "the scene has {emitters} lamps: what lights a point is told for {MOST_EMITTERS} at most"
                    )));
                }
                let plan = Plan::by_emitters(world, &self.settings);
                let sum = Sum { batches: 0, light: vec![Default::default(); emitters] };
                (self.world, self.batches) = (Some(state), 0);
                self.sums = vec![sum; self.settings.replicates as usize];
                film.insert(Film::by(world, Eye::Meters(vec![self.meter]), &self.settings, plan, true)?)
            }
        };
        let index = self.batches;
        if !film.add(world, Batch { index }, true, go_on) {
            return Ok(false);
        }
        self.batches += 1;
        let sum = &mut self.sums[(index % self.settings.replicates) as usize];
        sum.batches += 1;
        for (emitter, light) in sum.light.iter_mut().enumerate() {
            for (part, plane) in film.integrators.iter().zip(film.frame.planes_of(emitter)) {
                let own = &mut light[kind(part.name())];
                let found = plane.first().copied().unwrap_or_default().to_array();
                own.iter_mut().zip(found).for_each(|(sum, v)| *sum += f64::from(v));
            }
            // The next batch is summed by itself.
            film.frame.restart(emitter);
        }
        Ok(true)
    }

    /// What is known, in the colours that the lamps have now.
    pub(super) fn answer(&self, world: &World, state: u64) -> Answer {
        if self.world != Some(state) {
            return Answer::default();
        }
        let mix = world.mix();
        let colors: Vec<Rgb> = (0..world.emitters().len() as u32)
            .map(|emitter| mix.get(world.group_of(emitter)).copied().unwrap_or(Rgb::WHITE))
            .collect();
        let found = self.sums.iter().filter(|sum| sum.batches > 0).map(|sum| {
            let by = f64::from(PI) / f64::from(sum.batches);
            let lux = |(light, color): (&[[f64; 3]; KINDS], &Rgb)| light.map(|v| by * luminance(v, *color));
            (sum.batches, sum.light.iter().zip(&colors).map(lux).collect())
        });
        Answer { batches: self.batches, found: found.collect() }
    }
}

/// Which kind of light a part is of.
fn kind(part: &str) -> usize {
    match part {
        "direct" => 0,
        "caustic" | integrator::CAUSTIC_ORACLE => 2,
        _ => 1,
    }
}

/// Of light in a colour.
fn luminance(light: [f64; 3], color: Rgb) -> f64 {
    let channels = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 1.0, 0.0), Rgb::new(0.0, 0.0, 1.0)];
    channels.iter().zip(light).map(|(channel, v)| f64::from((*channel * color).luminance()) * v).sum()
}

impl Answer {
    /// Batches that it is the mean of.
    pub fn batches(&self) -> u32 {
        self.batches
    }

    /// What all lamps give together.
    pub fn total(&self) -> Shares {
        self.shares(|lux| lux.iter().fold([0.0; KINDS], sum))
    }

    /// What some emitters give together; numbers that the scene does not have give nothing.
    pub fn of(&self, emitters: &[u32]) -> Shares {
        self.shares(|lux| emitters.iter().filter_map(|e| lux.get(*e as usize)).fold([0.0; KINDS], sum))
    }

    fn shares(&self, of: impl Fn(&[[f64; KINDS]]) -> [f64; KINDS]) -> Shares {
        let found: Vec<(f64, [f64; KINDS])> =
            self.found.iter().map(|(batches, lux)| (f64::from(*batches), of(lux))).collect();
        let reading = |tell: &dyn Fn(&[f64; KINDS]) -> f64| {
            let all: Vec<(f64, f64)> = found.iter().map(|(batches, lux)| (*batches, tell(lux))).collect();
            match all.as_slice() {
                [] => Reading { lux: 0.0, error: f32::INFINITY },
                [(_, lux)] => Reading { lux: *lux as f32, error: f32::INFINITY },
                _ => {
                    let (lux, variance) = mean_and_variance(&all);
                    let factor = student_quantile(0.05, all.len() as f64 - 1.0);
                    Reading { lux: lux as f32, error: (factor * variance.sqrt()) as f32 }
                }
            }
        };
        Shares {
            all: reading(&|lux| lux.iter().sum()),
            direct: reading(&|lux| lux[0]),
            indirect: reading(&|lux| lux[1]),
            caustic: reading(&|lux| lux[2]),
        }
    }
}

fn sum(sum: [f64; KINDS], lux: &[f64; KINDS]) -> [f64; KINDS] {
    std::array::from_fn(|k| sum[k] + lux[k])
}
