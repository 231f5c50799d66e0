//! From the eye to the first dull surface: the visible points of a tile, sixteen to a packet.
//!
//! An eye path goes on through sharp lobes (mirrors, glass, polish) by chance; what glows along it, seen directly or
//! by reflection, is the part *emission*. The first dull vertex x is what integrators shade.

use crate::color::Rgb;
use crate::geometry::{Hits16, Ray};
use crate::material::Class;
use crate::scene::View;
use crate::sequence::{self, ledger::eye as ledger, sobol};
use crate::settings::Rays;
use crate::world::{Surface, World};
use glam::Vec3;

/// Lanes of a packet: a block of 4 × 4 pixels.
pub const LANES: usize = 16;

/// Sharp vertices after which an eye path is continued by roulette.
const CERTAIN_VERTICES: u32 = 6;

/// Sharp vertices after which an eye path ends. Glass with facets may hold light for hundreds of them.
const MAX_VERTICES: u32 = 1024;

/// The surest roulette: of paths that lose nothing on their way one in 10⁸ lives to be cut off.
const SUREST: f32 = 0.98;

/// What looks at the scene.
#[derive(Clone, Debug)]
pub enum Eye {
    /// A camera with a picture size.
    Camera(View),
    /// Illuminance meters: a picture of one row, each value E/π of one meter.
    Meters(Vec<Meter>),
}

/// A point and the direction it faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meter {
    /// Where [m].
    pub position: Vec3,
    /// Unit normal of the side that measures.
    pub normal: Vec3,
}

impl Meter {
    /// False where a number is missing, or so far out that the fourth power of the distance leaves `f32`: such a meter
    /// reads 0.
    fn is_somewhere(&self) -> bool {
        self.position.abs().max_element() < 1e9 && self.normal.is_finite()
    }
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Left edge.
    pub x: u32,
    /// Upper edge.
    pub y: u32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

/// The random numbers of one eye path: a pure function of pixel, sample and dimension.
#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    /// Which sample of the pixel.
    pub index: u32,
    /// The pixel's seed.
    pub seed: u32,
}

impl Numbers {
    /// One number in [0, 1).
    pub fn one(self, dimension: u32) -> f32 {
        sobol::sobol_owen(self.index, dimension, self.seed)
    }

    /// Two numbers of neighbouring dimensions.
    pub fn pair(self, dimension: u32) -> [f32; 2] {
        sobol::sobol_owen_pair(self.index, dimension, self.seed)
    }

    /// An independent set for another purpose at the same pixel and sample.
    pub fn branch(self, purpose: u32) -> Numbers {
        Numbers { seed: sequence::hash(self.seed, purpose), ..self }
    }
}

/// The first dull vertex of an eye path.
#[derive(Clone, Copy, Debug)]
pub struct Visible<'w> {
    /// The vertex.
    pub surface: Surface<'w>,
    /// What its radiance is multiplied by on its way to the eye.
    pub throughput: Rgb,
}

/// Sixteen neighbouring eye paths, laid out for the gather.
#[derive(Clone, Debug)]
pub struct Packet<'w> {
    /// Pixel of the tile, row by row, that each lane belongs to; `u32::MAX` outside the picture.
    pub pixels: [u32; LANES],
    /// Lanes whose path met a dull surface.
    pub live: u16,
    /// Of these, lanes with a Lambertian reflector: no BSDF need be evaluated.
    pub lambertian: u16,
    /// Of these, lanes that no light reaches through the surface: lit from the side of the eye alone.
    pub opaque: u16,
    /// Off the surface on the side of the eye [m], x y z.
    pub position: [[f32; LANES]; 3],
    /// Shading normals.
    pub shading: [[f32; LANES]; 3],
    /// Geometric normals on the side of the eye.
    pub geometric: [[f32; LANES]; 3],
    /// The vertices of live lanes; others hold what an earlier pass left.
    visible: [Option<Visible<'w>>; LANES],
    /// What glowed along the path [cd/m²].
    pub emission: [Rgb; LANES],
    /// Directions of the camera rays, and what they met first.
    camera: Option<([[f32; LANES]; 3], Hits16)>,
    /// The random numbers of each lane.
    pub numbers: [Numbers; LANES],
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

/// The visible points of one eye pass in a rectangle of the picture.
#[derive(Clone, Debug)]
pub struct Tile<'w> {
    /// Where.
    pub rect: Rect,
    /// The points.
    pub packets: Vec<Packet<'w>>,
    /// Rays it took.
    pub rays: u64,
}

/// Which sample of every pixel an eye pass takes.
#[derive(Clone, Copy, Debug)]
pub struct Sampling {
    /// Place within the pixel, the same for all pixels [Keller97, §4.1].
    pub offset: [f32; 2],
    /// Number of the sample within its randomisation.
    pub index: u32,
    /// Seed of the randomisation.
    pub seed: u32,
}

impl Eye {
    /// Width and height of its picture.
    pub fn size(&self) -> (u32, u32) {
        match self {
            Eye::Camera(view) => (view.width, view.height),
            Eye::Meters(meters) => (meters.len() as u32, 1),
        }
    }

    /// The numbers of a pixel's sample.
    pub fn numbers(&self, x: u32, y: u32, sampling: &Sampling) -> Numbers {
        let pixel = y.wrapping_mul(self.size().0).wrapping_add(x);
        Numbers { index: sampling.index, seed: sequence::hash(sampling.seed, pixel) }
    }

    /// The packets of a rectangle of pixels, as yet without visible points.
    pub fn tile<'w>(&self, rect: Rect) -> Tile<'w> {
        // Meters lie in one row: there a packet is a run of sixteen.
        let (bw, bh) = if matches!(self, Eye::Camera(_)) { (4, 4) } else { (LANES, 1) };
        let mut packets = Vec::new();
        for by in (0..rect.height).step_by(bh) {
            for bx in (0..rect.width).step_by(bw) {
                let mut packet = Packet::empty();
                for (lane, pixel) in packet.pixels.iter_mut().enumerate() {
                    let (x, y) = (bx + (lane % bw) as u32, by + (lane / bw) as u32);
                    if x < rect.width && y < rect.height {
                        *pixel = y * rect.width + x;
                    }
                }
                packets.push(packet);
            }
        }
        Tile { rect, packets, rays: 0 }
    }

    /// Sends the eye paths of one pass through a tile.
    pub fn look<'w>(&self, world: &'w World, sampling: &Sampling, tile: &mut Tile<'w>) {
        let mut rays = Rays::default();
        let rect = tile.rect;
        for packet in &mut tile.packets {
            (packet.live, packet.lambertian, packet.opaque) = (0, 0, 0);
            packet.emission = [Rgb::BLACK; LANES];
            for k in packet.lanes() {
                let (x, y) = rect.pixel(packet.pixels[k]);
                packet.numbers[k] = self.numbers(x, y, sampling);
            }
            match self {
                Eye::Camera(view) => packet.look_through(world, view, rect, sampling.offset, &mut rays),
                Eye::Meters(meters) => packet.lay_out(meters, rect),
            }
        }
        tile.rays = rays.eye;
    }
}

impl Rect {
    /// Picture coordinates of a pixel of the rectangle, counted row by row.
    pub fn pixel(&self, k: u32) -> (u32, u32) {
        (self.x + k % self.width, self.y + k / self.width)
    }
}

impl<'w> Packet<'w> {
    fn empty() -> Packet<'w> {
        Packet {
            pixels: [u32::MAX; LANES],
            live: 0,
            lambertian: 0,
            opaque: 0,
            position: [[0.0; LANES]; 3],
            shading: [[0.0; LANES]; 3],
            geometric: [[0.0; LANES]; 3],
            visible: [None; LANES],
            emission: [Rgb::BLACK; LANES],
            camera: None,
            numbers: [Numbers { index: 0, seed: 0 }; LANES],
        }
    }

    /// The vertex of a lane.
    pub fn visible(&self, k: usize) -> Option<&Visible<'w>> {
        if self.live >> k & 1 == 1 { self.visible[k].as_ref() } else { None }
    }

    /// The first surface on a lane's camera ray, for the auxiliary planes.
    pub fn first(&self, world: &World, k: usize) -> Option<First> {
        let ([x, y, z], hits) = self.camera.as_ref()?;
        let hit = hits.get(k)?;
        let s = world.surface(Vec3::new(x[k], y[k], z[k]), &hit);
        let albedo = s.finish.sharp + s.finish.dull;
        Some(First { albedo, normal: s.shading, depth: hit.t, instance: s.instance })
    }

    /// The box around the points of live lanes.
    pub fn extent(&self) -> [Vec3; 2] {
        let points = (0..LANES).filter(|k| self.live >> k & 1 == 1);
        let [x, y, z] = &self.position;
        points
            .map(|k| Vec3::new(x[k], y[k], z[k]))
            .fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)])
    }

    /// Lanes within the picture.
    pub fn lanes(&self) -> impl Iterator<Item = usize> + use<'w> {
        let pixels = self.pixels;
        (0..LANES).filter(move |k| pixels[*k] != u32::MAX)
    }

    fn lay_out(&mut self, meters: &[Meter], rect: Rect) {
        for k in self.lanes() {
            let meter = &meters[(rect.x + self.pixels[k]) as usize];
            if meter.is_somewhere() {
                self.set(k, Surface::meter(meter.position, meter.normal), Rgb::WHITE);
            }
        }
    }

    /// Camera rays share their origin: they are traced as a packet, what follows a sharp lobe one by one.
    fn look_through(&mut self, world: &'w World, view: &View, rect: Rect, offset: [f32; 2], rays: &mut Rays) {
        let mut directions = [[0.0; LANES]; 3];
        let mut live = 0u16;
        for k in self.lanes() {
            let (x, y) = rect.pixel(self.pixels[k]);
            let d = view.ray(x as f32 + offset[0], y as f32 + offset[1]).direction;
            (directions[0][k], directions[1][k], directions[2][k]) = (d.x, d.y, d.z);
            live |= 1 << k;
        }
        rays.eye += u64::from(live.count_ones());
        let hits = world.tracer().closest16(view.eye(), &directions, live);
        for k in self.lanes() {
            let ray = Ray::new(view.eye(), Vec3::new(directions[0][k], directions[1][k], directions[2][k]));
            let first = hits.get(k).map(|hit| world.surface(ray.direction, &hit));
            match first {
                Some(surface) if !surface.finish.is_sharp_or_glows() && !world.has_lamps() => {
                    self.set(k, surface, surface.clear_from(view.eye(), None));
                }
                _ => {
                    if let Some(x) = follow(world, ray, first, self.numbers[k], &mut self.emission[k], rays) {
                        self.set(k, x.surface, x.throughput);
                    }
                }
            }
        }
        self.camera = Some((directions, hits));
    }

    #[inline]
    fn set(&mut self, k: usize, surface: Surface<'w>, throughput: Rgb) {
        self.live |= 1 << k;
        if surface.finish.lambertian.is_some() {
            self.lambertian |= 1 << k;
        }
        if !surface.finish.transmits {
            self.opaque |= 1 << k;
        }
        let p = surface.spawn(surface.wo);
        for axis in 0..3 {
            self.position[axis][k] = p[axis];
            self.shading[axis][k] = surface.shading[axis];
            self.geometric[axis][k] = surface.normal[axis];
        }
        self.visible[k] = Some(Visible { surface, throughput });
    }
}

/// Follows an eye path through sharp lobes to its first dull vertex, adding up what glows on the way.
fn follow<'w>(
    world: &'w World,
    mut ray: Ray,
    first: Option<Surface<'w>>,
    numbers: Numbers,
    emission: &mut Rgb,
    rays: &mut Rays,
) -> Option<Visible<'w>> {
    let mut throughput = Rgb::WHITE;
    // Density with which the current ray was chosen; infinite if no light could have been sampled instead.
    let mut pdf = f32::INFINITY;
    let mut met = first;
    let mut last: Option<Surface<'w>> = None;
    for vertex in 0..MAX_VERTICES {
        let t_max = met.as_ref().map_or(f32::INFINITY, |s| (s.position - ray.origin).length());
        world.glows(ray.origin, ray.direction, t_max, |glow| {
            let clear = last.map_or(Rgb::WHITE, |s| s.clear_to(ray.direction, glow.distance, None));
            *emission += throughput * clear * glow.radiance * balance(pdf, glow.pdf);
        });
        let surface = met?;
        throughput *= surface.clear_from(ray.origin, last.as_ref());
        if !surface.emission().is_black() {
            let weight =
                if pdf.is_finite() { balance(pdf, world.pdf_toward(&surface, ray.origin)) } else { 1.0 };
            *emission += throughput * surface.emission() * weight;
        }
        let (sharp, dull) = surface.finish.weights();
        if sharp + dull <= 0.0 {
            return None;
        }
        let go_on = sharp / (sharp + dull);
        if go_on == 0.0 || numbers.one(ledger::class(vertex)) >= go_on {
            return Some(Visible { surface, throughput: throughput * (1.0 / (1.0 - go_on)) });
        }
        throughput *= 1.0 / go_on;
        *emission += throughput * highlight(world, &surface, numbers, vertex, rays);
        let u = numbers.pair(ledger::direction(vertex));
        let scatter = surface.sample(Class::Sharp, u, numbers.one(ledger::lobe(vertex)))?;
        throughput *= scatter.weight;
        pdf = scatter.pdf;
        if vertex >= CERTAIN_VERTICES {
            let stay = throughput.max_channel().clamp(0.0, SUREST);
            if numbers.one(ledger::roulette(vertex)) >= stay {
                return None;
            }
            throughput *= 1.0 / stay;
        }
        ray = Ray::new(surface.spawn(scatter.wi), scatter.wi);
        rays.eye += 1;
        last = Some(surface);
        met = world.closest(&ray);
    }
    None
}

/// Lights reflected by polish that is no delta lobe, by next-event estimation.
fn highlight(world: &World, surface: &Surface<'_>, numbers: Numbers, vertex: u32, rays: &mut Rays) -> Rgb {
    let Some((emitter, share)) = world.choose_emitter(numbers.one(ledger::light(vertex))) else {
        return Rgb::BLACK;
    };
    let Some(arrival) = world.emitters()[emitter as usize]
        .toward(surface.position, numbers.pair(ledger::light_point(vertex)))
    else {
        return Rgb::BLACK;
    };
    let value = surface.eval(Class::Sharp, surface.wo, arrival.wi) * surface.cosine(arrival.wi);
    if value.is_black() {
        return Rgb::BLACK;
    }
    rays.eye += 1;
    if !world.unblocked(surface.spawn(arrival.wi), &arrival) {
        return Rgb::BLACK;
    }
    let weight = balance(share * arrival.pdf, surface.pdf(Class::Sharp, arrival.wi));
    let clear = surface.clear_to(arrival.wi, arrival.distance(surface.position), None);
    value * clear * arrival.weight * (weight / share)
}

/// The balance heuristic [Veach 1997, eq. 9.12]; a technique of infinite density (a delta) takes all.
pub(crate) fn balance(own: f32, other: f32) -> f32 {
    if own.is_infinite() { 1.0 } else { own / (own + other) }
}
