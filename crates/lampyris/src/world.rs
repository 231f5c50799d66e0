//! The scene made traceable: hierarchy, emitters with their fixed shares, and the few figures that settings need.
//! It changes only between frames and is shared, read-only, by everything that shades.

mod facet;
mod finish;
mod mirrors;
mod surface;

pub use facet::{Facet, Facets};
pub use finish::Finish;
pub use mirrors::{Mirror, Mirrors};
pub use surface::Surface;

use crate::color::Rgb;
use crate::geometry::{Hit, MeshGeometry, Placement, Ray, SurfacePoint, Tracer};
use crate::light::{Arrival, Bounds, EmissiveSide, Emitter, GlowingTriangle};
use crate::material::Sides;
use crate::scene::Scene;
use crate::sequence;
use glam::Vec3;
use std::collections::HashMap;

/// The least share of a two-sided emitter's particles that its worse side keeps: never 0, or its light were lost.
const LEAST_SIDE: f32 = 0.05;

/// A scene ready for light.
pub struct World {
    scene: Scene,
    tracer: Tracer,
    facets: Facets,
    mirrors: Mirrors,
    finishes: Vec<Finish>,
    /// Any of the finishes has sharp lobes.
    sharp: bool,
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
        let one_sided = |m: &crate::scene::Mesh| -> Vec<bool> {
            m.materials.iter().map(|k| scene.materials[*k as usize].sides == Sides::FrontOnly).collect()
        };
        let one_sided: Vec<Vec<bool>> = scene.meshes.iter().map(one_sided).collect();
        let meshes: Vec<MeshGeometry<'_>> = scene
            .meshes
            .iter()
            .zip(&one_sided)
            .map(|(m, one_sided)| MeshGeometry {
                positions: &m.positions,
                triangles: &m.triangles,
                one_sided,
            })
            .collect();
        let placements: Vec<Placement> =
            scene.instances.iter().map(|i| Placement { mesh: i.mesh, transform: i.transform }).collect();
        let tracer = Tracer::build(&meshes, &placements);
        let finishes: Vec<Finish> = scene.materials.iter().map(Finish::from).collect();
        let facets = Facets::new(&scene);
        let mut world = World {
            tracer,
            mirrors: Mirrors::find(&facets, &scene.materials),
            facets,
            sharp: finishes.iter().any(|f| !f.sharp.is_black()),
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
        if !world.scene.environment.is_black() {
            world.environment = Some(world.emitters.len() as u32);
            world.emitters.push(Emitter::Environment { radiance: world.scene.environment });
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
        self.sharp
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
        let shading = self.facets.shading_normal(facet, hit.u, hit.v);
        let point = SurfacePoint::new(&facet.corners, hit.u, hit.v);
        Surface {
            position: point.position,
            error: point.error,
            normal: facet.normal * side,
            shading: if finish.bsdf.is_solid_interface() { shading } else { shading * side },
            wo,
            finish,
            front,
            instance: hit.instance,
            material: facet.material,
            mirror: self.mirrors.of(hit.instance, hit.triangle),
        }
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
        self.shares[k as usize] * self.emitters[k as usize].pdf(x, distance, cosine)
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
            let pdf = self.shares[k as usize] * self.emitters[k as usize].pdf(origin, t_max, 1.0);
            let radiance = self.scene.environment;
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
        for (_, facet) in self.facets.iter() {
            let [a, b, c] = facet.corners;
            let a2 = f64::from((b - a).cross(c - a).length());
            if !a2.is_finite() {
                continue;
            }
            for p in [a, b, c] {
                (lo, hi) = (lo.min(p), hi.max(p));
            }
            let finish = &self.finishes[facet.material as usize];
            let rho = finish.sharp + finish.dull;
            area += 0.5 * a2;
            reflected += 0.5 * a2 * f64::from(rho.luminance().clamp(0.0, 1.0));
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
        let mut groups: HashMap<(u32, u32), Vec<GlowingTriangle>> = HashMap::new();
        for (instance, facet) in self.facets.iter() {
            if self.finishes[facet.material as usize].emission.is_black() || facet.normal == Vec3::ZERO {
                continue;
            }
            let key = (instance, facet.material);
            groups
                .entry(key)
                .or_insert_with(|| {
                    order.push(key);
                    Vec::new()
                })
                .push(GlowingTriangle { vertices: facet.corners, normal: facet.normal });
        }
        for key in order {
            let finish = &self.finishes[key.1 as usize];
            let front = groups.remove(&key).unwrap_or_default();
            let (radiance, both) = (finish.emission, finish.both_sides_glow);
            let back =
                front.iter().filter(|_| both).map(|t| GlowingTriangle { normal: -t.normal, ..*t }).collect();
            let mut number = |side: Option<EmissiveSide>| {
                side.map(|side| {
                    self.emitters.push(Emitter::Side(side));
                    self.emitters.len() as u32 - 1
                })
            };
            let numbers =
                [number(EmissiveSide::new(radiance, front)), number(EmissiveSide::new(radiance, back))];
            self.sides.insert(key, numbers);
        }
    }

    /// Shares by power; the two sides of one surface split theirs by what a pilot finds before each of them.
    fn share_out(&mut self) {
        let mut weights: Vec<f64> =
            self.emitters.iter().map(|e| f64::from(e.power(self.bounds).luminance().max(0.0))).collect();
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
