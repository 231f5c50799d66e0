//! The emitters of a scene, and how the light paths are dealt to them (docs/light-transport.md, "The walk").
//!
//! An emitter's number is its place in the scene's [`Reference`], where everything is entered that ever shone: it stays,
//! and so do its random numbers and its share, whatever becomes of the others. What is there and dark keeps its share for
//! when it shines again; what was taken away has none until it is back.

use super::facet::Facets;
use super::finish::Finish;
use crate::color::Rgb;
use crate::light::{Bounds, EmissiveSide, Emitter, GlowingTriangle, Light, Sky, State};
use crate::material::Coverage;
use crate::scene::{Reference, Scene, Share, Source};
use glam::Vec3;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// The least share of a two-sided emitter's particles that its worse side keeps: never 0, or its light were lost.
const LEAST_SIDE: f32 = 0.05;

/// All emitters by number.
pub(super) struct Emitters {
    /// Who they are, and their shares as long as they are there.
    pub(super) reference: Reference,
    pub(super) all: Vec<Emitter>,
    there: Vec<bool>,
    numbers: HashMap<Source, u32>,
    /// (instance, material) → emitters of its front and its back.
    sides: BTreeMap<(u32, u32), [Option<u32>; 2]>,
    /// What each has of the N paths of a batch.
    pub(super) shares: Vec<f32>,
    /// Their running sum.
    cumulative: Vec<f32>,
    /// Emitters that rays can meet without hitting a triangle: spheres and discs.
    pub(super) lamps: Vec<u32>,
    pub(super) environment: Option<u32>,
    /// The box around each that has an area.
    extents: Vec<Option<[Vec3; 2]>>,
    /// All those boxes.
    pub(super) boxes: Vec<[Vec3; 2]>,
    /// Those that were set since [`Emitters::take_changed`].
    changed: Vec<u32>,
}

impl Emitters {
    /// None is there yet.
    pub(super) fn new(reference: &Reference) -> Emitters {
        let mut reference = reference.clone();
        for of in &mut reference.shares {
            of.share = if of.share > 0.0 { of.share.min(1.0) } else { 0.0 };
        }
        let count = reference.shares.len();
        Emitters {
            numbers: (0..).zip(&reference.shares).map(|(number, of)| (of.source, number)).collect(),
            all: vec![Emitter::NONE; count],
            there: vec![false; count],
            extents: vec![None; count],
            reference,
            sides: BTreeMap::new(),
            shares: Vec::new(),
            cumulative: Vec::new(),
            lamps: Vec::new(),
            environment: None,
            boxes: Vec::new(),
            changed: Vec::new(),
        }
    }

    /// What stands for a source from now on: dark or bright, or nothing where it is not there. What never shone has no
    /// number before it does.
    fn set(&mut self, source: Source, emitter: Option<Emitter>, dark: bool) -> Option<u32> {
        let number = match self.numbers.get(&source) {
            Some(number) => *number,
            None if dark || emitter.is_none() => return None,
            None => {
                let number = self.all.len() as u32;
                self.numbers.insert(source, number);
                self.reference.shares.push(Share { source, share: 0.0, group: 0 });
                self.all.push(Emitter::NONE);
                self.there.push(false);
                self.extents.push(None);
                number
            }
        };
        let there = emitter.is_some();
        self.put(number, emitter);
        there.then_some(number)
    }

    /// What stands under a number from now on.
    fn put(&mut self, number: u32, emitter: Option<Emitter>) {
        let k = number as usize;
        self.there[k] = emitter.is_some();
        self.extents[k] = emitter.as_ref().and_then(Emitter::extent);
        self.all[k] = emitter.unwrap_or(Emitter::NONE);
        self.changed.push(number);
    }

    /// A light that is no surface.
    pub(super) fn set_light(&mut self, number: u32, light: &Light) {
        let there = light.state != State::Away && light.is_sound();
        let dark = light.state == State::Off || light.kind.brightness().is_black();
        self.set(Source::Light(number), there.then(|| Emitter::from(light)), dark);
    }

    /// What surrounds the scene.
    pub(super) fn set_environment(&mut self, scene: &Scene) {
        let around = environment(scene);
        let dark = around.is_none();
        self.environment = self.set(Source::Environment, around, dark);
    }

    /// Which materials glow, or have glowed somewhere.
    pub(super) fn glowing(&self, finishes: &[Finish]) -> Vec<bool> {
        let mut glowing: Vec<bool> = finishes.iter().map(|f| !f.emission.is_black()).collect();
        for of in &self.reference.shares {
            if let Source::Side { material, .. } = of.source
                && let Some(glowing) = glowing.get_mut(material as usize)
            {
                *glowing = true;
            }
        }
        glowing
    }

    /// All surfaces of an instance whose material is among the `glowing`.
    pub(super) fn set_instance(
        &mut self,
        instance: u32,
        facets: &Facets,
        finishes: &[Finish],
        glowing: &[bool],
    ) {
        let known: Vec<(u32, u32)> =
            self.sides.range((instance, 0)..=(instance, u32::MAX)).map(|(k, _)| *k).collect();
        for key in known {
            for number in self.sides.remove(&key).into_iter().flatten().flatten() {
                self.put(number, None);
            }
        }
        // Grouped in order of first appearance: emitters are numbered by the scene alone.
        let mut groups: Vec<(u32, Vec<GlowingTriangle>, Vec<u32>)> = Vec::new();
        let mut places = HashMap::new();
        for triangle in 0..facets.count(instance) {
            let material = facets.material(instance, triangle);
            if !glowing[material as usize] {
                continue;
            }
            let facet = facets.get(instance, triangle);
            if facet.normal == Vec3::ZERO {
                continue;
            }
            let place = *places.entry(material).or_insert_with(|| {
                groups.push((material, Vec::new(), Vec::new()));
                groups.len() - 1
            });
            let (_, triangles, numbers) = &mut groups[place];
            triangles.push(GlowingTriangle { vertices: facet.corners, normal: facet.normal });
            numbers.push(triangle);
        }
        for (material, front, numbers) in groups {
            let finish = &finishes[material as usize];
            let back = finish.both_sides_glow.then(|| {
                front.iter().map(|t| GlowingTriangle { normal: -t.normal, ..*t }).collect::<Vec<_>>()
            });
            let dark = finish.emission.is_black();
            let key = (instance, material);
            let mut number = |triangles: Option<Vec<GlowingTriangle>>, back: bool| {
                let source = Source::Side { instance, material, back };
                if dark && !self.numbers.contains_key(&source) {
                    return None;
                }
                let side = triangles.and_then(|t| emissive_side(&facets.scene, key, t, &numbers));
                self.set(source, side.map(Emitter::Side), dark)
            };
            let numbers = [number(Some(front), false), number(back, true)];
            if numbers != [None; 2] {
                self.sides.insert(key, numbers);
            }
        }
    }

    /// Works out the lists, after emitters were set. Who shines for the first time is given a share, by power; the two
    /// sides of one surface split theirs by how openly they shine. Returns whether any share was given.
    pub(super) fn share_out(&mut self, bounds: Bounds, openness: impl Fn(&Emitter) -> f32) -> bool {
        let given = self.give_shares(bounds, openness);
        let there = |k: &usize| self.there[*k];
        let shares = self.reference.shares.iter().zip(&self.there);
        self.shares = shares.map(|(of, there)| if *there { of.share } else { 0.0 }).collect();
        let mut running = 0.0;
        let mut run = |p: &f32| {
            running += f64::from(*p);
            running as f32
        };
        self.cumulative = self.shares.iter().map(&mut run).collect();
        let lit = |k: &usize| self.all[*k].area() > 0.0 && matches!(self.all[*k], Emitter::Lamp(_));
        self.lamps = (0..self.all.len()).filter(there).filter(lit).map(|k| k as u32).collect();
        self.boxes = self.extents.iter().flatten().copied().collect();
        given
    }

    fn give_shares(&mut self, bounds: Bounds, openness: impl Fn(&Emitter) -> f32) -> bool {
        // Lights may be too bright for the numbers; shares are finite always.
        let importance = |e: &Emitter| f64::from(e.importance(bounds).min(f32::MAX));
        let wants = |k: usize| self.there[k] && self.reference.shares[k].share == 0.0;
        let mut weights: Vec<(usize, f64)> = (0..self.all.len())
            .filter(|k| wants(*k))
            .map(|k| (k, importance(&self.all[k])))
            .filter(|(_, weight)| *weight > 0.0)
            .collect();
        if weights.is_empty() {
            return false;
        }
        for (k, weight) in &mut weights {
            let Source::Side { instance, material, back } = self.reference.shares[*k].source else {
                continue;
            };
            let Some([Some(front), Some(behind)]) = self.sides.get(&(instance, material)) else { continue };
            let [front, behind] = [front, behind].map(|side| &self.all[*side as usize]);
            let (f, b) = (openness(front), openness(behind));
            let part = f64::from((f / (f + b).max(f32::MIN_POSITIVE)).clamp(LEAST_SIDE, 1.0 - LEAST_SIDE));
            *weight = (importance(front) + importance(behind)) * if back { 1.0 - part } else { part };
        }
        let reference = &mut self.reference;
        if reference.flux <= 0.0 || !reference.flux.is_finite() {
            reference.flux = weights.iter().map(|(_, weight)| weight).sum();
        }
        for (k, weight) in weights {
            reference.shares[k].share = ((weight / reference.flux) as f32).clamp(f32::MIN_POSITIVE, 1.0);
        }
        true
    }

    /// The emitters of the front and back of a material of an instance.
    pub(super) fn of(&self, instance: u32, material: u32) -> Option<&[Option<u32>; 2]> {
        self.sides.get(&(instance, material))
    }

    /// The emitters that `u` in [0, 1) chooses: where shares sum to more than 1, one of each stretch of length 1, so that
    /// no emitter's chances hang on what comes after it.
    pub(super) fn choose(&self, u: f32) -> impl Iterator<Item = u32> {
        let total = self.cumulative.last().copied().unwrap_or(0.0);
        (0..total.ceil() as u32).filter_map(move |stretch| {
            let k = self.cumulative.partition_point(|c| *c <= u + stretch as f32);
            (k < self.all.len()).then_some(k as u32)
        })
    }

    /// Numbers of those that were set since, in order.
    pub(super) fn take_changed(&mut self) -> Vec<u32> {
        let mut changed = std::mem::take(&mut self.changed);
        changed.sort_unstable();
        changed.dedup();
        changed
    }

    /// Asks another copy of the scene how textures glow; none for the time being.
    pub(super) fn ask(&mut self, scene: Option<&Arc<Scene>>) {
        for (of, emitter) in self.reference.shares.iter().zip(&mut self.all) {
            let (Emitter::Side(side), Source::Side { instance, material, .. }) = (emitter, of.source) else {
                continue;
            };
            match scene {
                _ if !side.is_painted() => {}
                None => side.ask(|_, _, _| Rgb::BLACK),
                Some(scene) => side.ask(glow(scene, (instance, material))),
            }
        }
    }
}

/// One side of the triangles of an instance and material, by their numbers in the mesh.
fn emissive_side(
    scene: &Arc<Scene>,
    key: (u32, u32),
    triangles: Vec<GlowingTriangle>,
    numbers: &[u32],
) -> Option<EmissiveSide> {
    let m = &scene.materials[key.1 as usize];
    if m.emission.is_black() || (m.maps.emission.is_none() && m.coverage == Coverage::Full) {
        return EmissiveSide::new(m.emission, triangles);
    }
    let means: Vec<Rgb> = numbers.iter().map(|k| scene.mean_emission(key.0, *k, m)).collect();
    EmissiveSide::painted(triangles, numbers.to_vec(), &means, m.emission.luminance(), glow(scene, key))
}

/// Radiance of a point of a triangle [cd/m²].
fn glow(
    scene: &Arc<Scene>,
    (instance, material): (u32, u32),
) -> impl Fn(u32, f32, f32) -> Rgb + Send + Sync + 'static {
    let scene = scene.clone();
    move |triangle, u, v| {
        let spot = scene.spot(instance, triangle, u, v);
        spot.map_or(Rgb::BLACK, |spot| spot.emission(&scene.materials[material as usize]))
    }
}

/// What surrounds a scene.
fn environment(scene: &Scene) -> Option<Emitter> {
    let radiance = scene.environment;
    match scene.environment_image.and_then(|k| scene.images.get(k as usize)) {
        _ if radiance.is_black() => None,
        None => Some(Emitter::Environment { radiance }),
        Some(picture) => {
            let up = scene.up.and_then(|up| up.try_normalize()).unwrap_or(Vec3::Y);
            Sky::new(picture, radiance, up).map(|sky| Emitter::Sky(Arc::new(sky)))
        }
    }
}
