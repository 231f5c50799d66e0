//! The scene made traceable: hierarchy, emitters with their fixed shares, and the few figures that settings need.
//! It changes only between frames, by edits, and is shared, read-only, by everything that shades.

mod bodies;
mod edit;
mod emitters;
mod facet;
mod finish;
mod geometry;
mod groups;
mod measure;
mod mirrors;
mod points;
mod relief;
mod surface;

pub use bodies::{Bodies, Body, MOST_BODIES};
pub use edit::Changes;
pub use facet::{Facet, Facets};
pub use finish::{Coat, Finish};
pub use mirrors::{Mirror, Mirrors};
pub use points::Points;
pub use surface::Surface;

use crate::color::Rgb;
use crate::geometry::{Hit, Ray, SurfacePoint, Tracer};
use crate::light::{Arrival, Bounds, Emitter};
use crate::scene::{Least, Scene};
use crate::sequence;
use emitters::Emitters;
use glam::Vec3;
use measure::{Extent, Figures};
use std::sync::Arc;

/// A scene ready for light.
pub struct World {
    scene: Arc<Scene>,
    tracer: Tracer,
    facets: Facets,
    mirrors: Mirrors,
    finishes: Vec<Finish>,
    /// What has sharp lobes.
    bodies: Bodies,
    /// Of each material whether it may have sharp lobes.
    sharp: Vec<bool>,
    /// Of each material its mean albedo.
    albedos: Vec<f32>,
    /// Of each instance.
    extents: Vec<Extent>,
    figures: Figures,
    emitters: Emitters,
    least: Least,
}

/// What a ray meets on its way to the first surface: a lamp's glow, or the environment behind everything.
#[derive(Clone, Copy, Debug)]
pub struct Glow {
    /// Whose it is.
    pub emitter: u32,
    /// Radiance toward the ray's origin [cd/m²].
    pub radiance: Rgb,
    /// Probability of choosing the emitter times the density of `toward` for it [sr⁻¹].
    pub pdf: f32,
    /// How far away [lengths of the ray's unit direction]; infinite for the environment.
    pub distance: f32,
    /// Cosine at the emitter; 1 for the environment.
    pub cosine: f32,
}

impl World {
    /// Builds hierarchy and emitters, and gives those of the scene's emitters a share that have none yet.
    pub fn new(scene: Scene) -> World {
        let scene = Arc::new(scene);
        let mut least = Least::default();
        let tracer = geometry::tracer(&scene, &mut least);
        let facets = Facets::new(&scene);
        let count = scene.materials.len();
        let mut world = World {
            tracer,
            mirrors: Mirrors::find(&facets, &scene.materials),
            bodies: Bodies::default(),
            facets,
            finishes: scene.materials.iter().map(Finish::from).collect(),
            sharp: vec![false; count],
            albedos: vec![0.0; count],
            extents: Vec::new(),
            figures: Figures::default(),
            emitters: Emitters::new(&scene.reference),
            least,
            scene,
        };
        for mesh in world.scene.meshes.iter().filter(|m| !m.colors.is_empty()) {
            mesh.materials.iter().for_each(|k| world.finishes[*k as usize].painted = true);
        }
        (0..count as u32).for_each(|k| world.weigh(k));
        world.find_bodies();
        world.measure_all();
        let World { scene, facets, finishes, emitters, .. } = &mut world;
        (0..).zip(&scene.lights).for_each(|(number, light)| emitters.set_light(number, light));
        let glowing = emitters.glowing(finishes);
        for instance in 0..scene.instances.len() as u32 {
            emitters.set_instance(instance, facets, finishes, &glowing);
        }
        emitters.set_environment(scene);
        world.conclude();
        world.emitters.take_changed();
        world
    }

    /// The scene as it stands.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The ray tracer.
    pub fn tracer(&self) -> &Tracer {
        &self.tracer
    }

    /// Its triangles.
    pub fn facets(&self) -> &Facets {
        &self.facets
    }

    /// All emitters, in an order fixed by the scene, with [`Emitter::NONE`] where one is not there any more.
    pub fn emitters(&self) -> &[Emitter] {
        &self.emitters.all
    }

    /// p_ℓ, what each emitter has of the light paths, dark or not. They sum to 1 in a scene as it was loaded; what is
    /// added brings its own.
    pub fn shares(&self) -> &[f32] {
        &self.emitters.shares
    }

    /// Into how many groups the lamps are sorted, whose light is summed apart: at least one.
    pub fn groups(&self) -> usize {
        self.scene.groups.len().max(1)
    }

    /// What the light of each group is multiplied by when it is shown.
    pub fn mix(&self) -> Vec<Rgb> {
        match self.scene.groups.as_slice() {
            [] => vec![Rgb::WHITE],
            groups => groups.iter().map(|group| group.color).collect(),
        }
    }

    /// The group of an emitter.
    #[inline]
    pub fn group_of(&self, emitter: u32) -> usize {
        usize::from(self.emitters.reference.shares[emitter as usize].group)
    }

    /// The sphere around everything.
    pub fn bounds(&self) -> Bounds {
        self.figures.bounds
    }

    /// Total surface area A [m²], each side of a surface counted once.
    pub fn area(&self) -> f32 {
        self.figures.area
    }

    /// ρ̄ = Σ ρ_k A_k / Σ A_k, luminance of all lobes [Keller97, §3.2].
    pub fn mean_reflectance(&self) -> f32 {
        self.figures.mean_reflectance
    }

    /// True if rays may pass through the glow of a sphere or disc.
    pub fn has_lamps(&self) -> bool {
        !self.emitters.lamps.is_empty()
    }

    /// True if rays that leave the scene find light.
    pub fn has_environment(&self) -> bool {
        self.emitters.environment.is_some()
    }

    /// False only if no point of an emitter's area lies within `distance` of the box from `low` to `high`.
    pub fn may_glow_near(&self, [low, high]: [Vec3; 2], distance: f32) -> bool {
        // Of very many emitters one is likely to be near, and asking all of them costs more than a ray.
        const MANY: usize = 64;
        let near = |[lo, hi]: &[Vec3; 2]| {
            let gap = (*lo - high).max(low - *hi).max(Vec3::ZERO);
            gap.length_squared() <= distance * distance
        };
        self.emitters.boxes.len() > MANY || self.emitters.boxes.iter().any(near)
    }

    /// True if any surface has sharp lobes: without them there are no caustics and no mirrors.
    pub fn has_sharp_surfaces(&self) -> bool {
        !self.bodies.all().is_empty()
    }

    /// What has sharp lobes, instance by instance.
    pub fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// Its planar mirrors.
    pub fn mirrors(&self) -> &[Mirror] {
        self.mirrors.all()
    }

    /// Which planar mirror a hit lies in.
    pub fn mirror_of(&self, hit: &Hit) -> Option<u8> {
        self.mirrors.of(hit.instance, hit.triangle)
    }

    /// The first surface on a ray of unit direction.
    pub fn closest(&self, ray: &Ray) -> Option<Surface<'_>> {
        self.tracer.closest(ray).map(|hit| self.surface(ray.direction, &hit))
    }

    /// The surface at a hit, seen along the unit vector `direction`.
    #[inline]
    pub fn surface(&self, direction: Vec3, hit: &Hit) -> Surface<'_> {
        let facet = self.facets.get(hit.instance, hit.triangle);
        let finish = &self.finishes[facet.material as usize];
        let wo = -direction;
        // A triangle without area is never hit; a hit edge-on may find either side.
        let front = wo.dot(facet.normal) >= 0.0;
        let side = if front { 1.0 } else { -1.0 };
        let shading = self.facets.shading_normal(hit.instance, hit.triangle, facet.normal, hit.u, hit.v);
        let point = SurfacePoint::new(&facet.corners, hit.u, hit.v);
        let (finish, shading) = if finish.painted {
            self.painted(hit, &facet, finish, shading)
        } else {
            (Coat::Plain(finish), shading)
        };
        Surface {
            position: point.position,
            error: point.error,
            normal: facet.normal * side,
            shading: if finish.bsdf.is_solid_interface() { shading } else { shading * side },
            wo,
            finish,
            front,
            instance: hit.instance,
            triangle: hit.triangle,
            material: facet.material,
            mirror: self.mirror_of(hit),
        }
    }

    /// What a triangle is made of, textures apart.
    #[inline]
    pub fn finish(&self, instance: u32, triangle: u32) -> &Finish {
        &self.finishes[self.facets.material(instance, triangle) as usize]
    }

    /// False only if some facet of the instance has bent normals.
    #[inline]
    pub fn all_flat(&self, instance: u32) -> bool {
        self.facets.all_flat(instance)
    }

    /// Unit shading normal of an untextured hit on the front side, where `normal` is the geometric one.
    #[inline]
    pub fn shading_normal(&self, hit: &Hit, normal: Vec3) -> Vec3 {
        self.facets.shading_normal(hit.instance, hit.triangle, normal, hit.u, hit.v)
    }

    /// What textures and vertex colours make of a hit's finish and of its shading normal on the front side.
    #[inline(never)]
    fn painted<'w>(
        &'w self,
        hit: &Hit,
        facet: &Facet,
        finish: &'w Finish,
        shading: Vec3,
    ) -> (Coat<'w>, Vec3) {
        let material = &self.scene.materials[facet.material as usize];
        let Some(spot) = self.scene.spot(hit.instance, hit.triangle, hit.u, hit.v) else {
            return (Coat::Plain(finish), shading);
        };
        let bent = material.maps.normal.as_ref().map_or(shading, |map| {
            let transform = &self.scene.instances[hit.instance as usize].transform;
            relief::bent(&spot, map, transform, &facet.corners, facet.normal, shading)
        });
        (Coat::Own(finish.at(material, &spot)), bent)
    }

    /// True where nothing blocks the way from `from` to a light.
    pub fn unblocked(&self, from: Vec3, arrival: &Arrival) -> bool {
        !match arrival.end {
            Some(end) => self.tracer.blocked(from, end),
            None => self.tracer.occluded(&Ray::new(from, arrival.wi)),
        }
    }

    /// The emitter of the side of a surface that is looked at.
    pub fn emitter_of(&self, surface: &Surface<'_>) -> Option<u32> {
        self.emitters.of(surface.instance, surface.material).and_then(|s| s[usize::from(!surface.front)])
    }

    /// The emitter of a side of a triangle.
    pub fn emitter_at(&self, instance: u32, triangle: u32, front: bool) -> Option<u32> {
        let material = self.facets.material(instance, triangle);
        self.emitters.of(instance, material).and_then(|s| s[usize::from(!front)])
    }

    /// Density, in solid angle from `x`, with which next-event estimation finds the emitting side of a surface.
    pub fn pdf_toward(&self, surface: &Surface<'_>, x: Vec3) -> f32 {
        let Some(k) = self.emitter_of(surface) else { return 0.0 };
        let distance = (surface.position - x).length();
        let cosine = surface.normal.dot(surface.wo).abs();
        let Emitter::Side(side) = &self.emitters.all[k as usize] else { return 0.0 };
        let chance = self.emitters.shares[k as usize];
        chance * (distance * distance / (cosine * side.area_around(surface.triangle)))
    }

    /// True if the dull lobes of any surface are no Lambertian reflector's.
    pub fn has_gloss(&self) -> bool {
        self.finishes.iter().any(|finish| finish.lambertian.is_none() && !finish.dull.is_black())
    }

    /// Lamps that a ray from `origin` passes before `t_max`, and the environment if nothing ends the ray.
    pub fn glows(&self, origin: Vec3, direction: Vec3, t_max: f32, mut see: impl FnMut(Glow)) {
        let Emitters { all, shares, lamps, environment, .. } = &self.emitters;
        for &k in lamps {
            let e = &all[k as usize];
            if let Some((distance, radiance, cosine)) = e.met_by(origin, direction, t_max) {
                let pdf = shares[k as usize] * e.pdf(origin, distance, cosine);
                see(Glow { emitter: k, radiance, pdf, distance, cosine });
            }
        }
        if let (Some(k), true) = (*environment, t_max == f32::INFINITY) {
            let (radiance, pdf) = all[k as usize].around(direction);
            let pdf = shares[k as usize] * pdf;
            see(Glow { emitter: k, radiance, pdf, distance: f32::INFINITY, cosine: 1.0 });
        }
    }

    /// The emitters that `u` in [0, 1) chooses, and the probability of each, its share: one in a scene as it was loaded,
    /// more where lamps were added, perhaps none where some were taken away.
    pub fn choose_emitters(&self, u: f32) -> impl Iterator<Item = (u32, f32)> {
        self.emitters.choose(u).map(|k| (k, self.emitters.shares[k as usize]))
    }

    /// Works out what follows from a material's finish alone.
    fn weigh(&mut self, material: u32) {
        let k = material as usize;
        let (scene, finish) = (&self.scene, &self.finishes[k]);
        let m = &scene.materials[k];
        self.sharp[k] = finish.may_be_sharp(scene, m, &mut self.least);
        self.albedos[k] = finish.mean_albedo(m, scene);
    }

    /// Measures every instance.
    fn measure_all(&mut self) {
        let instances = 0..self.scene.instances.len() as u32;
        self.extents = instances.map(|i| Extent::new(&self.facets, &self.albedos, i)).collect();
    }

    fn find_bodies(&mut self) {
        self.bodies = Bodies::find(&self.facets, &self.finishes, &self.sharp, &self.mirrors);
    }

    /// Works out what is a sum over the whole scene, and the shares of who shines for the first time.
    fn conclude(&mut self) {
        self.figures = Figures::new(&self.extents, &self.scene.lights);
        let Figures { bounds, area, .. } = self.figures;
        let tracer = &self.tracer;
        let known = self.scene.reference.shares.len();
        let more = self.emitters.reference.shares.len() > known;
        if self.emitters.share_out(bounds, |e| openness(e, tracer, bounds, area)) || more {
            self.group_from(known);
            let reference = self.emitters.reference.clone();
            self.change_scene(|scene| scene.reference = reference);
        }
    }
}

/// How freely an emitter's light spreads, 0 to 1: the mean free path of a few particles against the scene's size.
fn openness(emitter: &Emitter, tracer: &Tracer, bounds: Bounds, area: f32) -> f32 {
    const PILOTS: u32 = 64;
    let reach = 0.1 * area.sqrt();
    let free = |i: u32| {
        let u = [0, 1, 2, 3].map(|d| sequence::halton(i + 1, d));
        let start = emitter.emit(u, bounds);
        let t = tracer.closest(&Ray::new(start.origin, start.direction)).map_or(f32::INFINITY, |h| h.t);
        (t / reach).min(1.0)
    };
    (0..PILOTS).map(free).sum::<f32>() / PILOTS as f32
}
