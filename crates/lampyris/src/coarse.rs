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
use std::ops::Range;

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
    elements: Option<Elements>,
    /// Whether photons of all light are looked up.
    all: bool,
    /// Whether those of caustics are.
    caustics: bool,
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

/// What some paths leave behind.
#[derive(Default)]
struct Left {
    /// On elements [lm].
    elements: Vec<(u32, Rgb)>,
    all: Vec<Photon>,
    caustics: Vec<Photon>,
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
        let all = wants.reflected && world.has_gloss();
        let caustics = wants.caustics && world.bodies().make_caustics();
        Ok(Some(Grounds { elements, all, caustics, radius }))
    }

    /// The light of some paths, each walked once for all that is wanted of it; adds the rays that they took.
    fn light(&self, walk: &RandomWalk<'_>, paths: Range<u32>, rays: &mut u64) -> Layer {
        let Grounds { elements, all, caustics, .. } = self;
        if elements.is_none() && !all && !caustics {
            return Layer::default();
        }
        let (world, count) = (walk.world(), paths.len() as u32);
        let share = 1.0 / count.max(1) as f32;
        let take = |left: &mut Left, light: &Arrival<'_>| {
            if let Some(elements) = elements {
                elements.lit_by(world, light, |element, flux| left.elements.push((element, flux)));
            }
            let of_caustics = *caustics && light.sharp && light.diffused;
            if (*all || of_caustics)
                && !light.surface.finish.dull.is_black()
                && let Some(photon) = Photon::of(light, share)
            {
                left.all.extend(all.then_some(photon));
                left.caustics.extend(of_caustics.then_some(photon));
            }
        };
        let mut means = elements.as_ref().map(|elements| (elements, ElementLight::new(elements)));
        let mut photons = Left::default();
        *rays += walk.in_waves(paths, take, |left| {
            if let Some((_, means)) = &mut means {
                means.add(&left.elements, 0, 0);
            }
            photons.all.extend(left.all);
            photons.caustics.extend(left.caustics);
        });
        let radiances = |(elements, mut means): (&Elements, ElementLight)| {
            means.add(&[], count, 0);
            means.radiances(elements)
        };
        Layer {
            reflected: means.map(radiances).unwrap_or_default(),
            all: all.then(|| PhotonMap::new(photons.all)),
            caustics: caustics.then(|| PhotonMap::new(photons.caustics)),
        }
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
            let mut layer = grounds.light(&walk, paths, &mut coarse.rays);
            if let Some(far) = &layer.caustics {
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
