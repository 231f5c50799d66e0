//! The scene made traceable: hierarchy, emitters with their fixed shares, and the few figures that settings need.
//! It changes only between frames and is shared, read-only, by everything that shades.

mod bodies;
mod facet;
mod finish;
mod mirrors;
mod points;
mod relief;
mod surface;

pub use bodies::{Bodies, Body, MOST_BODIES};
pub use facet::{Facet, Facets};
pub use finish::{Coat, Finish};
pub use mirrors::{Mirror, Mirrors};
pub use points::Points;
pub use surface::Surface;

use crate::color::Rgb;
use crate::geometry::{Hit, MeshGeometry, Placement, Ray, Screen, SurfacePoint, Tracer};
use crate::light::{Arrival, Bounds, EmissiveSide, Emitter, GlowingTriangle, Sky};
use crate::material::{Coverage, Sides};
use crate::scene::{Least, Mesh, Scene};
use crate::sequence;
use glam::Vec3;
use std::collections::HashMap;
use std::sync::Arc;

/// The least share of a two-sided emitter's particles that its worse side keeps: never 0, or its light were lost.
const LEAST_SIDE: f32 = 0.05;

/// Seed of the screens of half-there surfaces.
const SCREEN: u32 = 0x5c4e_e111;

/// A scene ready for light.
pub struct World {
    scene: Arc<Scene>,
    tracer: Tracer,
    facets: Facets,
    mirrors: Mirrors,
    finishes: Vec<Finish>,
    /// What has sharp lobes.
    bodies: Bodies,
    emitters: Vec<Emitter>,
    /// p_ℓ: the share of the light paths that starts at each emitter; sums to 1.
    shares: Vec<f32>,
    /// Running sum of the shares.
    cumulative: Vec<f32>,
    /// (instance, material) → emitters of its front and its back.
    sides: HashMap<(u32, u32), [Option<u32>; 2]>,
    /// Emitters that rays can meet without hitting a triangle: spheres and discs.
    lamps: Vec<u32>,
    environment: Option<u32>,
    /// Boxes around the emitters that have an area.
    glow_boxes: Vec<[Vec3; 2]>,
    bounds: Bounds,
    area: f32,
    mean_reflectance: f32,
}

/// What a ray meets on its way to the first surface: a lamp's glow, or the environment behind everything.
#[derive(Clone, Copy, Debug)]
pub struct Glow {
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
    /// Builds hierarchy and emitters.
    pub fn new(scene: Scene) -> World {
        let scene = Arc::new(scene);
        let one_sided = |m: &Mesh| -> Vec<bool> {
            m.materials.iter().map(|k| scene.materials[*k as usize].sides == Sides::FrontOnly).collect()
        };
        let one_sided: Vec<Vec<bool>> = scene.meshes.iter().map(one_sided).collect();
        let mut least = Least::new(&scene);
        let screened: Vec<Vec<bool>> = scene.meshes.iter().map(|m| screened(&scene, m, &mut least)).collect();
        let meshes: Vec<MeshGeometry<'_>> = (scene.meshes.iter().zip(&one_sided).zip(&screened))
            .map(|((m, one_sided), screened)| MeshGeometry {
                positions: &m.positions,
                triangles: &m.triangles,
                one_sided,
                screened,
            })
            .collect();
        let placements: Vec<Placement> =
            scene.instances.iter().map(|i| Placement { mesh: i.mesh, transform: i.transform }).collect();
        let with_holes = scene.clone();
        let screen =
            Screen::new(move |instance, triangle, u, v| is_hole(&with_holes, instance, triangle, u, v));
        let tracer = Tracer::with_screen(&meshes, &placements, &screen);
        let mut finishes: Vec<Finish> = scene.materials.iter().map(Finish::from).collect();
        for mesh in scene.meshes.iter().filter(|m| !m.colors.is_empty()) {
            mesh.materials.iter().for_each(|k| finishes[*k as usize].painted = true);
        }
        let facets = Facets::new(&scene);
        let mirrors = Mirrors::find(&facets, &scene.materials);
        let sharp: Vec<bool> =
            finishes.iter().zip(&scene.materials).map(|(f, m)| f.may_be_sharp(m, &mut least)).collect();
        let mut world = World {
            tracer,
            bodies: Bodies::find(&facets, &finishes, &sharp, &mirrors),
            mirrors,
            facets,
            finishes,
            emitters: scene.lights.iter().filter(|l| l.is_sound()).map(Emitter::from).collect(),
            shares: Vec::new(),
            cumulative: Vec::new(),
            sides: HashMap::new(),
            lamps: Vec::new(),
            environment: None,
            glow_boxes: Vec::new(),
            bounds: Bounds::default(),
            area: 0.0,
            mean_reflectance: 0.0,
            scene,
        };
        world.measure_surfaces();
        let lit = |e: &Emitter| e.area() > 0.0 && matches!(e, Emitter::Lamp(_));
        world.lamps = (0..).zip(&world.emitters).filter(|(_, e)| lit(e)).map(|(k, _)| k).collect();
        world.gather_emissive_sides();
        if let Some(around) = environment(&world.scene) {
            world.environment = Some(world.emitters.len() as u32);
            world.emitters.push(around);
        }
        world.glow_boxes = world.emitters.iter().filter_map(Emitter::extent).collect();
        world.share_out();
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

    /// All emitters, in an order fixed by the scene.
    pub fn emitters(&self) -> &[Emitter] {
        &self.emitters
    }

    /// p_ℓ of each emitter.
    pub fn shares(&self) -> &[f32] {
        &self.shares
    }

    /// The sphere around everything.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Total surface area A [m²], each side of a surface counted once.
    pub fn area(&self) -> f32 {
        self.area
    }

    /// ρ̄ = Σ ρ_k A_k / Σ A_k, luminance of all lobes [Keller97, §3.2].
    pub fn mean_reflectance(&self) -> f32 {
        self.mean_reflectance
    }

    /// True if rays may pass through the glow of a sphere or disc.
    pub fn has_lamps(&self) -> bool {
        !self.lamps.is_empty()
    }

    /// True if rays that leave the scene find light.
    pub fn has_environment(&self) -> bool {
        self.environment.is_some()
    }

    /// False only if no point of an emitter's area lies within `distance` of the box from `low` to `high`.
    pub fn may_glow_near(&self, [low, high]: [Vec3; 2], distance: f32) -> bool {
        // Of very many emitters one is likely to be near, and asking all of them costs more than a ray.
        const MANY: usize = 64;
        let near = |[lo, hi]: &[Vec3; 2]| {
            let gap = (*lo - high).max(low - *hi).max(Vec3::ZERO);
            gap.length_squared() <= distance * distance
        };
        self.glow_boxes.len() > MANY || self.glow_boxes.iter().any(near)
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
            mirror: self.mirrors.of(hit.instance, hit.triangle),
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
        self.sides.get(&(surface.instance, surface.material)).and_then(|s| s[usize::from(!surface.front)])
    }

    /// Density, in solid angle from `x`, with which next-event estimation finds the emitting side of a surface.
    pub fn pdf_toward(&self, surface: &Surface<'_>, x: Vec3) -> f32 {
        let Some(k) = self.emitter_of(surface) else { return 0.0 };
        let distance = (surface.position - x).length();
        let cosine = surface.normal.dot(surface.wo).abs();
        let Emitter::Side(side) = &self.emitters[k as usize] else { return 0.0 };
        self.shares[k as usize] * (distance * distance / (cosine * side.area_around(surface.triangle)))
    }

    /// Lamps that a ray from `origin` passes before `t_max`, and the environment if nothing ends the ray.
    pub fn glows(&self, origin: Vec3, direction: Vec3, t_max: f32, mut see: impl FnMut(Glow)) {
        for &k in &self.lamps {
            let e = &self.emitters[k as usize];
            if let Some((distance, radiance, cosine)) = e.met_by(origin, direction, t_max) {
                let pdf = self.shares[k as usize] * e.pdf(origin, distance, cosine);
                see(Glow { radiance, pdf, distance, cosine });
            }
        }
        if let (Some(k), true) = (self.environment, t_max == f32::INFINITY) {
            let (radiance, pdf) = self.emitters[k as usize].around(direction);
            let pdf = self.shares[k as usize] * pdf;
            see(Glow { radiance, pdf, distance: f32::INFINITY, cosine: 1.0 });
        }
    }

    /// The emitter that `u` in [0, 1) chooses by its share, and the share; `None` where nothing shines.
    pub fn choose_emitter(&self, u: f32) -> Option<(u32, f32)> {
        let k = self.cumulative.partition_point(|c| *c <= u);
        (k < self.emitters.len()).then(|| (k as u32, self.shares[k]))
    }

    fn measure_surfaces(&mut self) {
        let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (mut area, mut reflected) = (0.0_f64, 0.0_f64);
        let albedo = |(f, m): (&Finish, _)| f.mean_albedo(m, &self.scene);
        let albedos: Vec<f32> = self.finishes.iter().zip(&self.scene.materials).map(albedo).collect();
        for (_, _, facet) in self.facets.iter() {
            let [a, b, c] = facet.corners;
            let a2 = f64::from((b - a).cross(c - a).length());
            if !a2.is_finite() {
                continue;
            }
            for p in [a, b, c] {
                (lo, hi) = (lo.min(p), hi.max(p));
            }
            area += 0.5 * a2;
            reflected += 0.5 * a2 * f64::from(albedos[facet.material as usize]);
        }
        for light in self.scene.lights.iter().filter(|l| l.is_sound()) {
            if let Some((p, r)) = light.extent() {
                (lo, hi) = (lo.min(p - r), hi.max(p + r));
            }
        }
        if lo.x <= hi.x {
            // A little more than the box's sphere: distant light starts outside everything.
            self.bounds = Bounds { center: (lo + hi) * 0.5, radius: 0.5 * (hi - lo).length() * 1.001 };
        }
        if self.bounds.radius == 0.0 {
            // Over nothing at all the sky still has a share of the paths, and lights meters.
            self.bounds.radius = 1.0;
        }
        self.area = area as f32;
        self.mean_reflectance = if area > 0.0 { (reflected / area) as f32 } else { 0.0 };
    }

    fn gather_emissive_sides(&mut self) {
        // Grouped in order of first appearance: emitters are numbered by the scene alone.
        let mut order: Vec<(u32, u32)> = Vec::new();
        let mut groups: HashMap<(u32, u32), (Vec<GlowingTriangle>, Vec<u32>)> = HashMap::new();
        for (instance, triangle, facet) in self.facets.iter() {
            if self.finishes[facet.material as usize].emission.is_black() || facet.normal == Vec3::ZERO {
                continue;
            }
            let key = (instance, facet.material);
            let (triangles, numbers) = groups.entry(key).or_insert_with(|| {
                order.push(key);
                Default::default()
            });
            triangles.push(GlowingTriangle { vertices: facet.corners, normal: facet.normal });
            numbers.push(triangle);
        }
        for key in order {
            let (front, numbers) = groups.remove(&key).unwrap_or_default();
            let both = self.finishes[key.1 as usize].both_sides_glow;
            let back =
                front.iter().filter(|_| both).map(|t| GlowingTriangle { normal: -t.normal, ..*t }).collect();
            let sides = [front, back].map(|triangles| emissive_side(&self.scene, key, triangles, &numbers));
            let numbers = sides.map(|side| {
                side.map(|side| {
                    self.emitters.push(Emitter::Side(side));
                    self.emitters.len() as u32 - 1
                })
            });
            self.sides.insert(key, numbers);
        }
    }

    /// Shares by power; the two sides of one surface split theirs by what a pilot finds before each of them.
    fn share_out(&mut self) {
        // Lights may be too bright for the numbers; shares are finite always.
        let importance = |e: &Emitter| f64::from(e.importance(self.bounds).min(f32::MAX));
        let mut weights: Vec<f64> = self.emitters.iter().map(importance).collect();
        for sides in self.sides.values() {
            if let [Some(front), Some(back)] = *sides {
                let (f, b) = (self.openness(front), self.openness(back));
                let both = weights[front as usize] + weights[back as usize];
                let front_part =
                    f64::from((f / (f + b).max(f32::MIN_POSITIVE)).clamp(LEAST_SIDE, 1.0 - LEAST_SIDE));
                weights[front as usize] = both * front_part;
                weights[back as usize] = both * (1.0 - front_part);
            }
        }
        let total: f64 = weights.iter().sum();
        let mut running = 0.0;
        for w in weights {
            running += w;
            self.shares.push(if total > 0.0 { (w / total) as f32 } else { 0.0 });
            self.cumulative.push(if total > 0.0 { (running / total) as f32 } else { 0.0 });
        }
    }

    /// How freely an emitter's light spreads, 0 to 1: the mean free path of a few particles against the scene's size.
    fn openness(&self, emitter: u32) -> f32 {
        const PILOTS: u32 = 64;
        let reach = 0.1 * self.area.sqrt();
        let free = |i: u32| {
            let u = [0, 1, 2, 3].map(|d| sequence::halton(i + 1, d));
            let start = self.emitters[emitter as usize].emit(u, self.bounds);
            let t =
                self.tracer.closest(&Ray::new(start.origin, start.direction)).map_or(f32::INFINITY, |h| h.t);
            (t / reach).min(1.0)
        };
        (0..PILOTS).map(free).sum::<f32>() / PILOTS as f32
    }
}

/// Which triangles of a mesh may have holes.
fn screened(scene: &Scene, mesh: &Mesh, least: &mut Least<'_>) -> Vec<bool> {
    if mesh.materials.iter().all(|k| scene.materials[*k as usize].coverage == Coverage::Full) {
        return Vec::new();
    }
    let mut known = HashMap::new();
    let mut holes = |k: &u32| {
        let material = &scene.materials[*k as usize];
        *known.entry(*k).or_insert_with(|| least.may_have_holes(material, mesh))
    };
    mesh.materials.iter().map(&mut holes).collect()
}

/// Does light pass through a hit of a surface that is not all there? What is there in part is a screen of holes finer
/// than any ray: the bits of a hit say by their hash whether it met one.
fn is_hole(scene: &Scene, instance: u32, triangle: u32, u: f32, v: f32) -> bool {
    let Some(spot) = scene.spot(instance, triangle, u, v) else { return false };
    let Some(material) = spot.mesh.materials.get(triangle as usize) else { return false };
    let coverage = spot.coverage(&scene.materials[*material as usize]);
    let place = [instance, triangle, u.to_bits(), v.to_bits()].into_iter().fold(SCREEN, sequence::hash);
    coverage <= sequence::unit_f32(place)
}

/// One side of the triangles of an instance and material, by their numbers in the mesh.
fn emissive_side(
    scene: &Arc<Scene>,
    (instance, material): (u32, u32),
    triangles: Vec<GlowingTriangle>,
    numbers: &[u32],
) -> Option<EmissiveSide> {
    let m = &scene.materials[material as usize];
    if m.maps.emission.is_none() && m.coverage == Coverage::Full {
        return EmissiveSide::new(m.emission, triangles);
    }
    let numbers = numbers[..triangles.len()].to_vec();
    let means: Vec<Rgb> = numbers.iter().map(|k| scene.mean_emission(instance, *k, m)).collect();
    let scene = scene.clone();
    EmissiveSide::painted(triangles, numbers, &means, m.emission.luminance(), move |triangle, u, v| {
        let spot = scene.spot(instance, triangle, u, v);
        spot.map_or(Rgb::BLACK, |spot| spot.emission(&scene.materials[material as usize]))
    })
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
