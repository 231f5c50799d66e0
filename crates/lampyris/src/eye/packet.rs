//! Sixteen neighbouring eye paths and the dull vertices they end on, laid out for the gather.
//!
//! What every light asks of a vertex lies in arrays; the whole surface is worked out again where somebody asks.

use super::follow::{Ended, first, passing, second, second_weight, second_weight_seen};
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
    /// Lanes whose first surface a second path leaves.
    forks: u16,
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
    /// On what camera rays met, or, where `last` says so, on what the last ray of a longer path met; of second paths it
    /// always does.
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
            forks: 0,
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

    /// A number that tells the surface that a lane sees from others, of its instance and material. Of a lane that sees
    /// through mirrors and glass it is the surface at the end.
    pub fn alike(&self, k: usize) -> Option<u32> {
        let Ends::Camera { hits, last, .. } = &self.ends else { return None };
        let Hit { instance, triangle, .. } = last[k].map(|(_, hit)| hit).or_else(|| hits.get(k))?;
        Some(sequence::hash(instance, self.world.facets().material(instance, triangle)))
    }

    /// The box around the points of live lanes.
    pub fn extent(&self) -> [Vec3; 2] {
        lanes(self.live)
            .map(|k| lane(&self.position, k))
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)])
    }

    /// Forgets the paths of an earlier pass and draws new numbers.
    pub(super) fn start(&mut self, eye: &Eye, samplings: &[&Sampling; LANES]) {
        (self.live, self.lambertian, self.glossy, self.opaque, self.forks) = (0, 0, 0, 0, 0);
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
        let hits = match view.is_cut() {
            false => world.tracer().closest16(view.eye(), &directions, inside),
            true => behind_the_cut(world, view, &directions, inside),
        };

        let (mut plain, mut glowing) = (0u16, 0u16);
        // Neighbours often meet the same triangle.
        let (mut last, mut known) = ((u32::MAX, u32::MAX), None);
        for k in lanes(hits.hit) {
            if last != (hits.instance[k], hits.triangle[k]) {
                last = (hits.instance[k], hits.triangle[k]);
                known = plain_finish(world, last);
            }
            let Some(finish) = known else { continue };
            let (sharp, dull) = finish.weights();
            if dull > 0.0 || sharp <= 0.0 {
                plain |= 1 << k;
                glowing |= u16::from(!finish.emission.is_black()) << k;
            }
            if dull > 0.0 {
                self.forks |= u16::from(sharp > 0.0) << k;
                self.note(k, finish);
            }
        }
        let points = world.points16(&directions, &hits, plain);
        (self.position, self.geometric, self.shading) = (points.position, points.normal, points.normal);
        for k in lanes(plain) {
            self.bend(k, hits.get(k), points.side[k]);
        }
        for k in lanes(glowing) {
            self.glow(k, [hits.instance[k], hits.triangle[k]], points.side[k] > 0.0);
        }

        let ray_of = |k: usize| {
            let direction = lane(&directions, k);
            let skipped = view.skipped(direction);
            let hit = hits.get(k).map(|hit| Hit { t: hit.t - skipped, ..hit });
            (Ray::new(view.eye() + direction * skipped, direction), hit)
        };
        let winding = if world.has_environment() { inside } else { hits.hit } & !plain;
        if world.has_lamps() {
            for k in lanes(inside & !winding) {
                let ((ray, hit), gleams) = (ray_of(k), &mut self.gleams);
                passing(world, &ray, hit, &mut gleams_of(k, gleams));
            }
        }
        let mut last = [None; LANES];
        for k in lanes(winding) {
            let ((ray, hit), gleams) = (ray_of(k), &mut self.gleams);
            let (ended, forks) = first(world, ray, hit, self.numbers[k], &mut gleams_of(k, gleams), rays);
            self.forks |= u16::from(forks) << k;
            last[k] = ended.map(|ended| self.end(k, ended));
        }
        self.ends = Ends::Camera { directions, hits, last };
    }

    /// Lanes whose first surface a second path leaves.
    pub(super) fn forks(&self) -> impl Iterator<Item = usize> + use<> {
        lanes(self.forks)
    }

    /// Sets the shading normal of a lane that has a plain hit, seen from the front (1) or from behind (−1).
    #[inline]
    fn bend(&mut self, k: usize, hit: Option<Hit>, side: f32) {
        let Some(hit) = hit.filter(|hit| !self.world.all_flat(hit.instance)) else { return };
        let normal = lane(&self.geometric, k) * side;
        let bent = self.world.shading_normal(&hit, normal) * side;
        for axis in 0..3 {
            self.shading[axis][k] = bent[axis];
        }
    }

    /// Keeps what a lane sees of a triangle that glows.
    fn glow(&mut self, k: usize, [instance, triangle]: [u32; 2], front: bool) {
        let finish = self.world.finish(instance, triangle);
        if (front || finish.both_sides_glow)
            && let Some(emitter) = self.world.emitter_at(instance, triangle, front)
        {
            gleams_of(k, &mut self.gleams)(emitter, finish.emission);
        }
    }

    /// The scene.
    pub(super) fn world(&self) -> &'w World {
        self.world
    }

    /// The surface that a second path leaves, one of `samples`, and its weight, if it is to be followed.
    fn second(&self, k: usize, samples: u32) -> Option<(Surface<'w>, f32)> {
        let Ends::Camera { directions, hits, last } = &self.ends else { return None };
        let (direction, hit, numbers) = (lane(directions, k), hits.get(k)?, self.numbers[k]);
        if self.live >> k & 1 == 1 && last[k].is_none() {
            let finish = self.world.finish(hit.instance, hit.triangle);
            let cosine = -direction.dot(lane(&self.shading, k));
            let weight = second_weight_seen(finish, cosine, numbers, samples)?;
            return Some((self.world.surface(direction, &hit), weight));
        }
        let surface = self.world.surface(direction, &hit);
        let weight = second_weight(&surface, numbers, samples)?;
        Some((surface, weight))
    }

    /// Forgets everything, for second paths to come.
    pub(super) fn clear(&mut self) {
        (self.live, self.lambertian, self.glossy, self.opaque, self.forks) = (0, 0, 0, 0, 0);
        self.pixels = [u32::MAX; LANES];
        self.gleams.clear();
        if let Ends::Camera { last, .. } = &mut self.ends {
            *last = [None; LANES];
        } else {
            let (directions, hits) = ([[0.0; LANES]; 3], Hits16::default());
            self.ends = Ends::Camera { directions, hits, last: [None; LANES] };
        }
    }

    /// Follows the second path of a lane of `first`, seen from `eye`, as one of its own lanes, if it is to be followed where a
    /// pixel has so many samples. Returns the [`Tile::stake`] of that path alone.
    ///
    /// [`Tile::stake`]: super::Tile::stake
    pub(super) fn follow(
        &mut self,
        to: usize,
        (first, lane): (&Packet<'w>, usize),
        eye: Vec3,
        samples: u32,
        rays: &mut Rays,
    ) -> Option<f32> {
        let (surface, weight) = first.second(lane, samples)?;
        let numbers = [first.numbers[lane], first.numbers[lane].branch(b'2'.into())];
        (self.pixels[to], self.numbers[to]) = (first.pixels[lane], numbers[1]);
        (0..2).for_each(|axis| self.place[axis][to] = first.place[axis][lane]);
        let gleams = &mut self.gleams;
        let ended = second(self.world, (eye, surface), weight, numbers, &mut gleams_of(to, gleams), rays);
        if let Some(ended) = ended {
            let end = self.end(to, ended);
            if let Ends::Camera { last, .. } = &mut self.ends {
                last[to] = Some(end);
            }
        }
        let (own, other) = (self.passed_on(to), first.passed_on(lane));
        Some(if own < other { own / other } else { 1.0 })
    }

    /// What reaches the eye of the light that falls on a lane's vertex.
    fn passed_on(&self, k: usize) -> f32 {
        if self.live >> k & 1 == 1 { (self.throughput[k] * self.reflectance[k]).max_channel() } else { 0.0 }
    }

    /// Ends where a longer path did; returns the direction of its last ray, and what that met.
    fn end(&mut self, k: usize, Ended { surface, hit, throughput }: Ended<'_>) -> (Vec3, Hit) {
        self.end_on(k, &surface);
        self.throughput[k] = throughput;
        (-surface.wo, hit)
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

/// Keeps what glows along the path of a lane.
fn gleams_of(lane: usize, gleams: &mut Vec<Gleam>) -> impl FnMut(u32, Rgb) {
    move |emitter, radiance| {
        if !radiance.is_black() {
            gleams.push(Gleam { lane, emitter, radiance });
        }
    }
}

/// What a triangle is made of if nothing but that is to be known of it.
fn plain_finish(world: &World, (instance, triangle): (u32, u32)) -> Option<&Finish> {
    let finish = world.finish(instance, triangle);
    // A body of glass may have absorbed some of the light on its way here.
    let odd = finish.painted || finish.bsdf.is_solid_interface();
    (!odd).then_some(finish)
}
/// What rays from the eye meet first behind the plane that a view is cut at, each lane by itself.
fn behind_the_cut(world: &World, view: &View, directions: &[[f32; LANES]; 3], inside: u16) -> Hits16 {
    let mut hits = Hits16::default();
    for k in lanes(inside) {
        let direction = lane(directions, k);
        let skipped = view.skipped(direction);
        let Some(hit) = world.tracer().closest(&Ray::new(view.eye() + direction * skipped, direction)) else {
            continue;
        };
        hits.hit |= 1 << k;
        (hits.t[k], hits.u[k], hits.v[k]) = (hit.t + skipped, hit.u, hit.v);
        (hits.instance[k], hits.triangle[k]) = (hit.instance, hit.triangle);
    }
    hits
}
