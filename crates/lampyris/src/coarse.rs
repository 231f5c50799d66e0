//! A coarse solution of all light, to be looked up by the parts of the solution of 1996: in each batch its walk leaves light on
//! surface elements and in photon maps, each light group's apart [Keller96, §4.3].
//!
//! Lookups are linear in this light, so the mean of pictures by many coarse batches is the picture by one large one; what stays
//! is that elements are of one brightness each, and that photons light what lies around them.

mod shades;

use crate::color::Rgb;
use crate::elements::{ElementLight, Elements, shares};
use crate::error::Result;
use crate::geometry::Hit;
use crate::map::{Estimate, Kernel, Photon, PhotonMap, Precomputed, Reach, Reader, Seen};
use crate::particle::Plan;
use crate::photon;
use crate::scatter::{Arrival, RandomWalk, Rules};
use crate::sequence;
use crate::settings::{Batch, Settings, Source};
use crate::world::{Surface, World};
use glam::Vec3;
use shades::Shades;
use std::f32::consts::FRAC_1_PI;
use std::ops::Range;

/// k: illuminance is kept at every so many photons.
const KEPT: u32 = 4;

/// The radius of illuminance that is kept, in units of r. Many rays find it at many places: they level what few photons leave
/// uneven, but not what a disc loses over the edge of its surface.
const NARROW: f32 = 0.25;

/// What parts look up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wants {
    /// The means of elements, and photons where gloss sees them.
    pub reflected: bool,
    /// Photons that came over a sharp surface.
    pub caustics: bool,
    /// Shadow photons of lamps.
    pub shadows: bool,
}

/// What is found once a world, for all batches.
#[derive(Clone, Debug)]
pub struct Grounds {
    /// Where their means are looked up.
    elements: Option<Elements>,
    /// Whether photons of all light are looked up.
    all: bool,
    /// Whether those of caustics are.
    caustics: bool,
    /// r [m].
    radius: f32,
    /// Where lamps are seen, if anybody asks.
    shades: Option<Shades>,
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
    reflected: Reflected,
    /// What came over a sharp surface.
    caustics: Option<PhotonMap>,
}

/// What surfaces reflect.
#[derive(Clone, Debug, Default)]
enum Reflected {
    /// Nobody asks.
    #[default]
    Nothing,
    /// Radiance of each element [cd/m²], and all photons where gloss sees them.
    Elements(Vec<Rgb>, Option<PhotonMap>),
    /// Illuminance kept at photons.
    Photons(Precomputed),
}

impl Reflected {
    /// All light that comes to surfaces.
    fn photons(&self) -> Option<&PhotonMap> {
        match self {
            Reflected::Nothing => None,
            Reflected::Elements(_, photons) => photons.as_ref(),
            Reflected::Photons(kept) => Some(kept.map()),
        }
    }
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
        let by_elements = settings.gather.source == Source::Elements;
        let elements =
            (wants.reflected && by_elements).then(|| Elements::new(world, settings.gather.element));
        let elements = elements.transpose()?;
        let radius = settings.gather.radius * world.bounds().radius;
        let all = wants.reflected && (!by_elements || world.has_gloss());
        let caustics = wants.caustics && world.bodies().make_caustics();
        let shades = wants.shadows.then(|| Shades::new(world, settings));
        Ok(Some(Grounds { elements, all, caustics, radius, shades }))
    }

    /// The light of some emitters is another one now, while surfaces stayed where they were.
    pub fn follow(&mut self, world: &World, settings: &Settings, emitters: &[u32]) {
        if let Some(shades) = &mut self.shades {
            shades.renew(world, settings, emitters);
        }
    }

    /// Rays that it took until now.
    pub fn rays(&self) -> u64 {
        self.shades.as_ref().map_or(0, |shades| shades.rays)
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
        let map = all.then(|| PhotonMap::new(photons.all));
        let reflected = match (means, map) {
            (Some((elements, mut means)), map) => {
                means.add(&[], count, 0);
                Reflected::Elements(means.radiances(elements), map)
            }
            (None, Some(map)) => Reflected::Photons(Precomputed::new(map, KEPT, self.within(NARROW))),
            (None, None) => Reflected::Nothing,
        };
        Layer { reflected, caustics: caustics.then(|| PhotonMap::new(photons.caustics)) }
    }

    /// By the photons within a share of r.
    fn within(&self, share: f32) -> Estimate {
        Estimate { kernel: Kernel::Constant, reach: Reach::Within(share * self.radius) }
    }

    /// The illuminance of a side of a surface [lx]: that which is kept nearest, not farther than half the radius that it is of;
    /// where there is none, that of all photons within this radius. Together they are right in the mean, however few
    /// photons there are (docs/light-transport.md, "Final gathering").
    fn irradiance(&self, kept: &Precomputed, x: Vec3, normal: Vec3) -> Rgb {
        let here = || Reader::new(kept.map(), self.within(NARROW)).irradiance(x, normal);
        kept.irradiance(x, normal, 0.5 * NARROW * self.radius).unwrap_or_else(here)
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

    /// Adds to each group's sum `factor` times the radiance that `y`, where a ray hit, reflects evenly to the side of its `wo`
    /// [cd/m²].
    #[inline]
    pub fn add_mean(&self, world: &World, hit: &Hit, y: &Surface<'_>, factor: Rgb, out: &mut [Rgb]) {
        let element = self.grounds.elements.as_ref().and_then(|elements| elements.at(world, hit, y.front));
        for (out, layer) in out.iter_mut().zip(&self.layers) {
            match (&layer.reflected, element) {
                (Reflected::Elements(means, _), Some(element)) => *out += factor * means[element as usize],
                (Reflected::Photons(kept), _) => {
                    for (share, normal) in shares(y).into_iter().zip([y.normal, -y.normal]) {
                        if !share.is_black() {
                            let lux = self.grounds.irradiance(kept, y.position, normal);
                            *out += factor * share * lux * FRAC_1_PI;
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// What shadow photons know of the way from the side of a surface that the unit `normal` points to, to an emitter.
    #[inline]
    pub fn seen(&self, emitter: u32, x: Vec3, normal: Vec3) -> Seen {
        self.grounds.shades.as_ref().map_or(Seen::Unsure, |shades| shades.seen(emitter, x, normal))
    }

    /// Whether there are photons of all light.
    pub fn has_photons(&self) -> bool {
        self.grounds.all
    }

    /// Adds to each group's sum `factor` times the radiance that the dull lobes of `y` send toward its `wo`, by their full f_r
    /// and the photons around it [cd/m²].
    pub fn add_lit(&self, y: &Surface<'_>, factor: Rgb, out: &mut [Rgb]) {
        self.read(y, factor, out, |layer| layer.reflected.photons());
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
        let estimate = self.grounds.within(1.0);
        for (out, layer) in out.iter_mut().zip(&self.layers) {
            if let Some(map) = map(layer) {
                *out += factor * Reader::new(map, estimate).radiance(y);
            }
        }
    }
}
