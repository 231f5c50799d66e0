//! A coarse solution of all light, to be looked up by the parts of the solution of 1996: in each batch its walk leaves light on
//! surface elements and in photon maps, each light group's apart [Keller96, §4.3].
//!
//! Lookups are linear in this light, so the mean of pictures by many coarse batches is the picture by one large one; what stays
//! is that elements are of one brightness each, and that photons light what lies around them.

use crate::color::Rgb;
use crate::elements::{ElementLight, Elements};
use crate::error::Result;
use crate::geometry::Hit;
use crate::map::{Estimate, Kernel, Photon, PhotonMap, Reach, Reader};
use crate::particle::Plan;
use crate::photon;
use crate::scatter::{Arrival, RandomWalk, Rules};
use crate::sequence;
use crate::settings::{Batch, Settings};
use crate::world::{Surface, World};

/// What parts look up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wants {
    /// The means of elements, and photons where gloss sees them.
    pub reflected: bool,
    /// Photons that came over a sharp surface.
    pub caustics: bool,
}

/// What is found once a world, for all batches.
#[derive(Clone, Debug)]
pub struct Grounds {
    wants: Wants,
    elements: Option<Elements>,
    gloss: bool,
    /// r [m].
    radius: f32,
}

/// The light of one batch.
#[derive(Clone, Debug)]
pub struct Coarse<'g> {
    grounds: &'g Grounds,
    /// Of each group that was asked for.
    layers: Vec<Layer>,
    /// Rays that it took.
    pub rays: u64,
}

/// The light of one group.
#[derive(Clone, Debug, Default)]
struct Layer {
    /// Radiance that each element reflects [cd/m²].
    reflected: Vec<Rgb>,
    /// All light that comes to surfaces.
    all: Option<PhotonMap>,
    /// What came over a sharp surface.
    caustics: Option<PhotonMap>,
}

impl Grounds {
    /// What these settings ask for; `None` where that is nothing.
    ///
    /// # Errors
    /// [`Error::BadSetting`](crate::Error::BadSetting) where elements would be too many.
    pub fn new(world: &World, settings: &Settings, wants: Wants) -> Result<Option<Grounds>> {
        if wants == Wants::default() {
            return Ok(None);
        }
        let elements = wants.reflected.then(|| Elements::new(world, settings.gather.element)).transpose()?;
        let radius = settings.gather.radius * world.bounds().radius;
        Ok(Some(Grounds { wants, elements, gloss: world.has_gloss(), radius }))
    }
}

impl<'g> Coarse<'g> {
    /// Walks the paths of a batch: those of the plan's layers given. The light of no layer depends on which others are.
    pub fn new(
        world: &World,
        grounds: &'g Grounds,
        settings: &Settings,
        plan: &Plan,
        groups: &[usize],
        batch: Batch,
    ) -> Coarse<'g> {
        let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
        let seed = sequence::hash(sequence::hash(settings.seed, replicate), u32::from(b'c'));
        let mut coarse = Coarse { grounds, layers: Vec::new(), rays: 0 };
        for group in groups {
            let is_its = |emitter: u32| plan.layer_of(emitter) == *group && !plan.is_dark(world, emitter);
            let shares = (0..).zip(world.shares()).filter(|(emitter, _)| is_its(*emitter));
            let share: f64 = shares.map(|(_, share)| f64::from(*share)).sum();
            let count = (f64::from(settings.gather.paths) * share).ceil() as u32;
            let rules = Rules { seed: sequence::hash(seed, *group as u32), ..Rules::default() };
            let tint = |emitter| if is_its(emitter) { plan.tint(emitter) } else { Rgb::BLACK };
            let walk = RandomWalk::tinted(world, rules, tint);
            let first = block.wrapping_mul(count);
            let paths = first..first.saturating_add(count);
            let mut layer = Layer::default();
            if let Some(elements) = &grounds.elements {
                let light = ElementLight::of(&walk, elements, paths.clone());
                coarse.rays += light.rays();
                layer.reflected = light.radiances(elements);
            }
            // The same paths again: to walk them is little beside what looks them up.
            let mut photons = |wanted: &(dyn Fn(&Arrival<'_>) -> bool + Sync)| {
                let (map, rays) = PhotonMap::of_walk(&walk, paths.clone(), wanted);
                coarse.rays += rays;
                map
            };
            let dull = |light: &Arrival<'_>| !light.surface.finish.dull.is_black();
            if grounds.wants.reflected && grounds.gloss {
                layer.all = Some(photons(&dull));
            }
            if grounds.wants.caustics && world.bodies().make_caustics() {
                let far = photons(&|light| light.sharp && light.diffused && dull(light));
                // Of lamps, photons are aimed: a walk hardly finds what is small.
                let aimed = settings.photons;
                let (near, rays) = photon::from_lights(world, aimed, &tint, (block, rules.seed), true);
                coarse.rays += rays;
                let all = near.iter().map(Photon::from).chain(far.photons().iter().copied());
                layer.caustics = Some(PhotonMap::new(all.collect()));
            }
            coarse.layers.push(layer);
        }
        coarse
    }

    /// Adds to each group's sum `factor` times the radiance that a side of a surface reflects evenly [cd/m²].
    #[inline]
    pub fn add_mean(&self, world: &World, hit: &Hit, front: bool, factor: Rgb, out: &mut [Rgb]) {
        let element = self.grounds.elements.as_ref().and_then(|elements| elements.at(world, hit, front));
        if let Some(element) = element {
            for (out, layer) in out.iter_mut().zip(&self.layers) {
                *out += factor * layer.reflected[element as usize];
            }
        }
    }

    /// Whether there are photons of all light.
    pub fn has_photons(&self) -> bool {
        self.layers.iter().any(|layer| layer.all.is_some())
    }

    /// Adds to each group's sum `factor` times the radiance that the dull lobes of `y` send toward its `wo`, by their full f_r
    /// and the photons around it [cd/m²].
    pub fn add_lit(&self, y: &Surface<'_>, factor: Rgb, out: &mut [Rgb]) {
        self.read(y, factor, out, |layer| layer.all.as_ref());
    }

    /// The same of light that came over a sharp surface.
    pub fn add_caustics(&self, y: &Surface<'_>, factor: Rgb, out: &mut [Rgb]) {
        self.read(y, factor, out, |layer| layer.caustics.as_ref());
    }

    fn read<'a>(
        &'a self,
        y: &Surface<'_>,
        factor: Rgb,
        out: &mut [Rgb],
        map: impl Fn(&'a Layer) -> Option<&'a PhotonMap>,
    ) {
        let estimate = Estimate { kernel: Kernel::Constant, reach: Reach::Within(self.grounds.radius) };
        for (out, layer) in out.iter_mut().zip(&self.layers) {
            if let Some(map) = map(layer) {
                *out += factor * Reader::new(map, estimate).radiance(y);
            }
        }
    }
}
