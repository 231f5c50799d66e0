//! Sixteen neighbouring eye paths and the dull vertices they end on, laid out for the gather.
//!
//! What every light asks of a vertex lies in arrays; the whole surface is worked out again where somebody asks.

use super::follow::{Ended, Next, follow, next};
use super::{Eye, Meter, Numbers, Rect, Sampling};
use crate::color::Rgb;
use crate::geometry::{Hit, Hits16, LANES, Ray, lane, lanes};
use crate::material::Glossy;
use crate::scene::View;
use crate::sequence;
use crate::settings::Rays;
use crate::world::{Finish, Surface, World};
use glam::Vec3;

/// One value of each lane for each axis.
type Vectors = [[f32; LANES]; 3];

/// The first dull vertex of an eye path.
#[derive(Clone, Copy, Debug)]
pub struct Visible<'w> {
    /// The vertex.
    pub surface: Surface<'w>,
    /// What its radiance is multiplied by on its way to the eye.
    pub throughput: Rgb,
}

/// Something that glows where an eye path comes by.
#[derive(Clone, Copy, Debug)]
pub struct Gleam {
    /// Whose path.
    pub lane: usize,
    /// Which emitter.
    pub emitter: u32,
    /// What of its light reaches the eye [cd/m²].
    pub radiance: Rgb,
}

/// What the auxiliary planes want to know.
#[derive(Clone, Copy, Debug)]
pub struct First {
    /// Directional albedo.
    pub albedo: Rgb,
    /// Shading normal on the side of the eye.
    pub normal: Vec3,
    /// Distance [m].
    pub depth: f32,
    /// Instance number.
    pub instance: u32,
}

/// Sixteen neighbouring eye paths. Lanes outside the masks hold what an earlier pass left.
#[derive(Clone)]
pub struct Packet<'w> {
    world: &'w World,
    /// Pixel of the tile, row by row, that each lane belongs to; `u32::MAX` outside the picture.
    pub pixels: [u32; LANES],
    /// Where in the picture these pixels lie, x and y.
    place: [[u32; LANES]; 2],
    /// Lanes whose path met a dull surface.
    pub live: u16,
    /// Of these, lanes with a Lambertian reflector: no BSDF need be evaluated.
    pub lambertian: u16,
    /// Of these, lanes with a lobe over a Lambertian reflector.
    pub glossy: u16,
    /// Of these, lanes that no light reaches through the surface: lit from the side of the eye alone.
    pub opaque: u16,
    /// Off the surface on the side of the eye [m], x y z.
    pub position: Vectors,
    /// Shading normals.
    pub shading: Vectors,
    /// Geometric normals on the side of the eye.
    pub geometric: Vectors,
    /// ρ of the Lambertian lanes; of others the albedo of the dull lobes at normal incidence.
    pub reflectance: [Rgb; LANES],
    /// What the glossy lanes reflect.
    pub gloss: [Glossy; LANES],
    /// What each vertex' radiance is multiplied by on its way to the eye.
    pub throughput: [Rgb; LANES],
    /// What glowed along the paths.
    pub gleams: Vec<Gleam>,
    /// The random numbers of each lane.
    pub numbers: [Numbers; LANES],
    ends: Ends,
}

/// How the paths of a packet came to where they end.
#[derive(Clone)]
#[expect(clippy::large_enum_variant, reason = "one in each packet, which stays where it is")]
enum Ends {
    /// Nowhere yet.
    Nowhere,
    /// On meters: position and normal say all.
    Meters,
    /// On what camera rays met, or, where `last` says so, on what the last ray of a longer path met.
    Camera { directions: Vectors, hits: Hits16, last: [Option<(Vec3, Hit)>; LANES] },
}

impl<'w> Packet<'w> {
    /// No paths as yet, and no pixels.
    pub fn new(world: &'w World) -> Packet<'w> {
        Packet {
            world,
            pixels: [u32::MAX; LANES],
            place: [[0; LANES]; 2],
            live: 0,
            lambertian: 0,
            glossy: 0,
            opaque: 0,
            position: [[0.0; LANES]; 3],
            shading: [[0.0; LANES]; 3],
            geometric: [[0.0; LANES]; 3],
            reflectance: [Rgb::BLACK; LANES],
            gloss: [Glossy { base: Rgb::BLACK, specular: Rgb::BLACK, alpha: 1.0 }; LANES],
            throughput: [Rgb::WHITE; LANES],
            gleams: Vec::new(),
            numbers: [Numbers { index: 0, seed: 0 }; LANES],
            ends: Ends::Nowhere,
        }
    }

    /// Puts it elsewhere: `pixels` as in [`Packet::pixels`] for a tile of `rect`.
    pub fn place(&mut self, rect: Rect, pixels: [u32; LANES]) {
        self.pixels = pixels;
        self.live = 0;
        for (k, pixel) in pixels.iter().enumerate() {
            let (x, y) = if *pixel == u32::MAX { (0, 0) } else { rect.pixel(*pixel) };
            (self.place[0][k], self.place[1][k]) = (x, y);
        }
    }

    /// Lanes within the picture.
    pub fn lanes(&self) -> impl Iterator<Item = usize> + use<> {
        let pixels = self.pixels;
        (0..LANES).filter(move |k| pixels[*k] != u32::MAX)
    }

    /// The vertex of a lane.
    pub fn visible(&self, k: usize) -> Option<Visible<'w>> {
        if self.live >> k & 1 == 0 {
            return None;
        }
        let surface = match &self.ends {
            Ends::Nowhere => return None,
            Ends::Meters => Surface::meter(lane(&self.position, k), lane(&self.geometric, k)),
            Ends::Camera { directions, hits, last } => match &last[k] {
                Some((direction, hit)) => self.world.surface(*direction, hit),
                None => self.world.surface(lane(directions, k), &hits.get(k)?),
            },
        };
        Some(Visible { surface, throughput: self.throughput[k] })
    }

    /// Unit direction from the vertex of a live lane along the path to the eye.
    pub fn toward_eye(&self, k: usize) -> Vec3 {
        match &self.ends {
            Ends::Nowhere | Ends::Meters => lane(&self.geometric, k),
            Ends::Camera { directions, last, .. } => -last[k].map_or_else(|| lane(directions, k), |(d, _)| d),
        }
    }

    /// The first surface on a lane's camera ray, for the auxiliary planes.
    pub fn first(&self, k: usize) -> Option<First> {
        let Ends::Camera { directions, hits, .. } = &self.ends else { return None };
        let hit = hits.get(k)?;
        let s = self.world.surface(lane(directions, k), &hit);
        let albedo = s.finish.sharp + s.finish.dull;
        Some(First { albedo, normal: s.shading, depth: hit.t, instance: s.instance })
    }

    /// A number that tells the surface that a lane sees from others, of its instance and material, and whether chance led
    /// the path on from there, though it might have ended. Of a lane that sees through mirrors and glass it is the surface at
    /// the end.
    pub fn alike(&self, k: usize) -> Option<(u32, bool)> {
        let Ends::Camera { hits, last, .. } = &self.ends else { return None };
        let first = hits.get(k)?;
        let polished = self.live >> k & 1 == 0 || last[k].is_some();
        let polished = polished && self.world.finish(first.instance, first.triangle).weights().1 > 0.0;
        let (instance, triangle) = match &last[k] {
            Some((_, hit)) if !polished => (hit.instance, hit.triangle),
            _ => (first.instance, first.triangle),
        };
        let went_on = last[k].as_ref().is_none_or(|(_, hit)| *hit != first);
        Some((
            sequence::hash(instance, self.world.facets().material(instance, triangle)),
            polished && went_on,
        ))
    }

    /// The box around the points of live lanes.
    pub fn extent(&self) -> [Vec3; 2] {
        lanes(self.live)
            .map(|k| lane(&self.position, k))
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)])
    }

    /// Forgets the paths of an earlier pass and draws new numbers.
    pub(super) fn start(&mut self, eye: &Eye, samplings: &[&Sampling; LANES]) {
        (self.live, self.lambertian, self.glossy, self.opaque) = (0, 0, 0, 0);
        self.gleams.clear();
        self.throughput = [Rgb::WHITE; LANES];
        let [x, y] = &self.place;
        for (k, numbers) in self.numbers.iter_mut().enumerate() {
            *numbers = eye.numbers(x[k], y[k], samplings[k]);
        }
    }

    /// Ends on meters.
    pub(super) fn lay_out(&mut self, meters: &[Meter]) {
        self.ends = Ends::Meters;
        for k in self.lanes() {
            let meter = &meters[self.place[0][k] as usize];
            if meter.is_somewhere() {
                self.end_on(k, &Surface::meter(meter.position, meter.normal));
            }
        }
    }

    /// Camera rays share their origin: they are traced as a packet, what follows a sharp lobe one by one.
    pub(super) fn look_through(&mut self, view: &View, samplings: &[&Sampling; LANES], rays: &mut Rays) {
        let world = self.world;
        let inside = self.lanes().fold(0u16, |mask, k| mask | 1 << k);
        rays.eye += u64::from(inside.count_ones());
        let [x, y] = [0, 1].map(|axis| -> [f32; LANES] {
            std::array::from_fn(|k| self.place[axis][k] as f32 + samplings[k].offset[axis])
        });
        let directions = view.directions(&x, &y);
        let hits = world.tracer().closest16(view.eye(), &directions, inside);

        let (mut plain, mut winding) = (0u16, inside);
        if !world.has_lamps() {
            winding = if world.has_environment() { inside } else { hits.hit };
            // Neighbours often meet the same triangle.
            let (mut last, mut known) = ((u32::MAX, u32::MAX), None);
            for k in lanes(hits.hit) {
                if last != (hits.instance[k], hits.triangle[k]) {
                    last = (hits.instance[k], hits.triangle[k]);
                    known = plain_finish(world, last);
                }
                let Some(finish) = known else { continue };
                if let Next::Ends(weight) = next(finish, self.numbers[k], 0) {
                    plain |= 1 << k;
                    self.throughput[k] = Rgb::grey(weight);
                    self.note(k, finish);
                }
            }
            winding &= !plain;
        }
        let points = world.points16(&directions, &hits, plain);
        (self.position, self.geometric, self.shading) = (points.position, points.normal, points.normal);

        let mut last = [None; LANES];
        for k in lanes(winding) {
            let ray = Ray::new(view.eye(), lane(&directions, k));
            let first = hits.get(k);
            let gleam = |emitter, radiance: Rgb| {
                if !radiance.is_black() {
                    self.gleams.push(Gleam { lane: k, emitter, radiance });
                }
            };
            let ended = follow(world, ray, first, self.numbers[k], gleam, rays);
            if let Some(Ended { surface, hit, throughput }) = ended {
                self.end_on(k, &surface);
                self.throughput[k] = throughput;
                last[k] = Some((-surface.wo, hit));
            }
        }
        self.ends = Ends::Camera { directions, hits, last };
    }

    fn end_on(&mut self, k: usize, surface: &Surface<'_>) {
        self.note(k, &surface.finish);
        let p = surface.spawn(surface.wo);
        for axis in 0..3 {
            self.position[axis][k] = p[axis];
            self.shading[axis][k] = surface.shading[axis];
            self.geometric[axis][k] = surface.normal[axis];
        }
    }

    /// What the gather asks of a lane's finish.
    #[inline]
    fn note(&mut self, k: usize, finish: &Finish) {
        self.live |= 1 << k;
        self.reflectance[k] = finish.lambertian.unwrap_or(finish.dull);
        self.lambertian |= u16::from(finish.lambertian.is_some()) << k;
        if finish.lambertian.is_none()
            && let Some(gloss) = finish.bsdf.glossy()
        {
            self.glossy |= 1 << k;
            self.gloss[k] = gloss;
        }
        self.opaque |= u16::from(!finish.transmits) << k;
    }
}

/// What a triangle is made of if nothing but that is to be known of it.
fn plain_finish(world: &World, (instance, triangle): (u32, u32)) -> Option<&Finish> {
    let finish = world.finish(instance, triangle);
    // A body of glass may have absorbed some of the light on its way here.
    let odd = finish.painted || finish.bsdf.is_solid_interface() || !finish.emission.is_black();
    (!odd && world.all_flat(instance)).then_some(finish)
}
