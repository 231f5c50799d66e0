//! The gather: what points receive from (virtual) point lights, [Keller97, eq. 3] with the geometry term clamped.
//!
//! `from_light` is the clear version for one point and one light; `packet` does the same for sixteen points at once,
//! with shadow rays started at the light, and is tested against it. What clamping takes is paid back elsewhere.

use super::gloss::{GlossyPoints, Law, Shed, Three};
use super::pick::{Open, pick, pick_for_point};
use super::{Lights, Pass};
use crate::color::Rgb;
use crate::eye::{LANES, Packet, Tile, Visible};
use crate::geometry::{Kernel, Occluder, Ray, Wide, lanes, positive};
use crate::light::Shine;
use crate::material::{Class, Glossy};
use crate::particle::{Beacon, Vpl};
use crate::sequence::ledger::eye as ledger;
use crate::world::{Surface, World};
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// Geometry × angular law of a light at a point, without visibility: lux for unit intensity, with the receiver's
/// cosine. `normal` is the shading normal; the sign of the cosine is the caller's concern.
pub(super) fn geometry_term(light: &Vpl<'_>, x: Vec3, normal: Vec3) -> f32 {
    let d = light.position - x;
    match light.shine {
        // min(G, b) with G = cos θ_x cos θ_y / |x−y|² [Kollig and Keller 2004].
        Shine::Lambert(n) => {
            let d2 = d.length_squared();
            (normal.dot(d).abs() * (-n.dot(d)).max(0.0) / (d2 * d2)).min(light.bound)
        }
        Shine::Isotropic => {
            let d2 = d.length_squared();
            normal.dot(d).abs() / (d2 * d2.sqrt())
        }
        Shine::Beam(axis, beam) => {
            let d2 = d.length_squared();
            let distance = d2.sqrt();
            normal.dot(d).abs() / (d2 * distance) * beam.profile(-axis.dot(d) / distance)
        }
        Shine::Distant => normal.dot(light.position).abs(),
    }
}

/// Unit direction from `x` toward a light.
pub(super) fn direction(light: &Vpl<'_>, x: Vec3) -> Vec3 {
    match light.shine {
        Shine::Distant => light.position,
        _ => (light.position - x).normalize_or_zero(),
    }
}

/// Intensity of a light toward `x`: constant unless its vertex is glossy.
pub(super) fn intensity(light: &Vpl<'_>, toward_light: Vec3) -> Rgb {
    match &light.gloss {
        Some(y) => light.intensity * y.eval(Class::Dull, -toward_light, y.wo),
        None => light.intensity,
    }
}

/// Radiance that the dull lobes of `x` send toward its `wo` by an unblocked light of geometry term `g` [cd/m²].
fn reflected(x: &Surface<'_>, light: &Vpl<'_>, g: f32) -> Rgb {
    let wi = direction(light, x.position);
    let f = x.eval(Class::Dull, x.wo, wi);
    if f.is_black() {
        return Rgb::BLACK;
    }
    let distance = match light.shine {
        Shine::Distant => f32::INFINITY,
        _ => (light.position - x.position).length(),
    };
    f * intensity(light, wi) * x.clear_to(wi, distance, light.gloss.as_ref()) * g
}

/// Radiance that the dull lobes of `x` send toward its `wo` by one light's light [cd/m²].
pub fn from_light(world: &World, x: &Surface<'_>, light: &Vpl<'_>, rays: &mut u64) -> Rgb {
    let g = geometry_term(light, x.position, x.shading);
    if g.is_nan() || g <= 0.0 {
        return Rgb::BLACK;
    }
    let value = reflected(x, light, g);
    if value.is_black() {
        return Rgb::BLACK;
    }
    let wi = direction(light, x.position);
    *rays += 1;
    let from = x.spawn(wi);
    let blocked = match light.shine {
        Shine::Distant => world.tracer().occluded(&Ray::new(from, wi)),
        _ => world.tracer().blocked(light.position, from),
    };
    if blocked { Rgb::BLACK } else { value }
}

/// `from_light` over a list.
pub fn from_lights(world: &World, x: &Surface<'_>, lights: &[Vpl<'_>], rays: &mut u64) -> Rgb {
    lights.iter().map(|l| from_light(world, x, l, rays)).fold(Rgb::BLACK, |a, b| a + b)
}

/// An unbiased estimate of [`from_lights`] by `most` of the lights in the mean, evenly apart, from a start that `u` draws.
pub fn from_some_lights(
    world: &World,
    x: &Surface<'_>,
    lights: &[Vpl<'_>],
    most: f32,
    u: f32,
    rays: &mut u64,
) -> Rgb {
    some_of(lights, most, u, |light| from_light(world, x, light, rays))
}

/// An unbiased estimate of [`from_lights`] by about `most` of a group's virtual lights, picked by what they would give; `u`
/// draws them.
pub(super) fn from_some_vpls(
    world: &World,
    x: &Surface<'_>,
    lights: &Lights<'_>,
    most: f32,
    u: f32,
    rays: &mut u64,
) -> Rgb {
    if lights.vpls.len() as f32 <= most {
        return from_lights(world, x, lights.vpls, rays);
    }
    let mut sum = Rgb::BLACK;
    let point = (x.position, x.shading, x.finish.transmits);
    pick_for_point(world.tracer().kernel(), point, lights.beacons, most, u, |k, factor| {
        sum += from_light(world, x, &lights.vpls[k], rays) * factor;
    });
    sum
}

/// An unbiased estimate of the sum of `light_of` over all lights.
pub(super) fn some_of<'a, 'w>(
    lights: &'a [Vpl<'w>],
    most: f32,
    u: f32,
    light_of: impl FnMut(&'a Vpl<'w>) -> Rgb,
) -> Rgb {
    let gap = (lights.len() as f32 / most).max(1.0);
    let some = (0..).map_while(|i| lights.get(((u + i as f32) * gap) as usize));
    some.map(light_of).fold(Rgb::BLACK, |a, b| a + b) * gap
}

/// What is known of whether lights are seen before a ray is traced. Lights of one emitter are asked for one after the other.
pub(super) trait Sight: Copy {
    /// Of some lanes of the packet of a number, below [`PARTS`], those that surely see a light, and those that a ray has
    /// to tell of.
    fn of(&mut self, number: usize, packet: &Packet<'_>, light: &Vpl<'_>, of: u16) -> [u16; 2];
}

/// Nothing: rays tell.
#[derive(Clone, Copy)]
pub(super) struct Unknown;

impl Sight for Unknown {
    #[inline(always)]
    fn of(&mut self, _: usize, _: &Packet<'_>, _: &Vpl<'_>, of: u16) -> [u16; 2] {
        [0, of]
    }
}

/// Adds what every point of a tile receives from the light points of a pass; `sight` is what is known of any packets.
pub(super) fn tile_of_points(
    pass: &Pass<'_>,
    tile: &Tile<'_>,
    sight: impl Sight,
    out: &mut [Vec<Rgb>],
    rays: &mut u64,
) {
    for (lights, out) in pass.zip(out) {
        self::tile(pass.world, tile, (lights.points, sight), out, rays);
    }
}

/// Adds what every point of a tile receives from a list of lights.
fn tile(
    world: &World,
    tile: &Tile<'_>,
    (lights, sight): (&[Vpl<'_>], impl Sight),
    out: &mut [Rgb],
    rays: &mut u64,
) {
    if lights.is_empty() {
        return;
    }
    let mut asked: Vec<Asked<'_, '_>> = lights.iter().map(|light| Asked::new(light, 1.0)).collect();
    let live: Vec<&Packet<'_>> = tile.packets.iter().filter(|p| p.live != 0).collect();
    for some in live.chunks(PARTS) {
        let mut gathered: Vec<Gathered<'_, '_>> = some.iter().map(|p| Gathered::new(p)).collect();
        match some.len() {
            1 => gather::<1>(world, &mut gathered, &mut asked, sight, rays),
            _ => gather::<PARTS>(world, &mut gathered, &mut asked, sight, rays),
        }
        for (p, gathered) in some.iter().zip(&mut gathered) {
            add(p, &gathered.take(), out);
        }
    }
}

/// Packets of neighbouring pixels whose shadow rays walk together.
pub(super) const PARTS: usize = 4;

/// Adds what every point of a tile receives from those virtual lights of a pass that `which` names of each group, as many
/// of them as settings allow.
pub(super) fn tile_of_vpls<'w>(
    pass: &Pass<'w>,
    tile: &Tile<'_>,
    which: impl Fn(&'w Lights<'w>) -> (&'w [Vpl<'w>], &'w [Beacon]),
    out: &mut [Vec<Rgb>],
    rays: &mut u64,
) {
    let (world, kernel) = (pass.world, pass.world.tracer().kernel());
    let picks = |lights: &'w Lights<'w>| lights.picks(pass.settings, which(lights).0, tile);
    for (lights, out) in pass.zip(out).filter(|(lights, _)| picks(lights).is_none()) {
        self::tile(world, tile, (which(lights).0, Unknown), out, rays);
    }
    if pass.lights.iter().all(|lights| picks(lights).is_none()) {
        return;
    }
    let mut asked = Vec::new();
    for p in tile.packets.iter().filter(|p| p.live != 0) {
        let mut gathered = Gathered::new(p);
        let u = p.numbers[p.live.trailing_zeros() as usize].one(ledger::PICK);
        for (lights, out) in pass.zip(out) {
            let (Some(most), (vpls, beacons)) = (picks(lights), which(lights)) else { continue };
            asked.clear();
            pick(kernel, p, (beacons, &Open), most, lights.turned(u), |k, factor| {
                asked.push(Asked::new(&vpls[k], factor));
            });
            if !asked.is_empty() {
                gather::<1>(world, std::slice::from_mut(&mut gathered), &mut asked, Unknown, rays);
                add(p, &gathered.take(), out);
            }
        }
    }
}

/// Adds the radiance of each point of a packet to its pixel.
pub(super) fn add(p: &Packet<'_>, radiance: &[Rgb; LANES], out: &mut [Rgb]) {
    for k in lanes(p.live) {
        out[p.pixels[k] as usize] += p.throughput[k] * radiance[k];
    }
}

/// The vertices of a packet, each worked out when it is first asked for and once for all lights.
pub(super) struct Points<'p, 'w> {
    packet: &'p Packet<'w>,
    /// Nothing before one is asked for: mostly none is.
    known: Vec<Option<Visible<'w>>>,
}

impl<'p, 'w> Points<'p, 'w> {
    pub(super) fn new(packet: &'p Packet<'w>) -> Points<'p, 'w> {
        Points { packet, known: Vec::new() }
    }

    /// The vertex of a lane.
    pub(super) fn get(&mut self, k: usize) -> Option<&Visible<'w>> {
        self.known.resize(LANES, None);
        let known = &mut self.known[k];
        if known.is_none() {
            *known = self.packet.visible(k);
        }
        known.as_ref()
    }
}

/// Radiance leaving each point of a packet by a list of lights [cd/m²].
pub fn packet(world: &World, p: &Packet<'_>, lights: &[Vpl<'_>], rays: &mut u64) -> [Rgb; LANES] {
    let mut gathered = Gathered::new(p);
    let mut asked: Vec<Asked<'_, '_>> = lights.iter().map(|light| Asked::new(light, 1.0)).collect();
    gather::<1>(world, std::slice::from_mut(&mut gathered), &mut asked, Unknown, rays);
    gathered.take()
}

/// A light that packets ask for.
struct Asked<'l, 'w> {
    light: &'l Vpl<'w>,
    /// How often its light counts.
    factor: f32,
    /// What hid it last.
    occluder: Occluder,
}

impl<'l, 'w> Asked<'l, 'w> {
    fn new(light: &'l Vpl<'w>, factor: f32) -> Asked<'l, 'w> {
        Asked { light, factor, occluder: Occluder::default() }
    }
}

/// Lights whose geometry terms are worked out together.
const RUN: usize = 16;

/// Adds the light of some lights, each so often as it counts, to at most P packets.
fn gather<const P: usize>(
    world: &World,
    packets: &mut [Gathered<'_, '_>],
    asked: &mut [Asked<'_, '_>],
    mut sight: impl Sight,
    rays: &mut u64,
) {
    let (tracer, kernel) = (world.tracer(), world.tracer().kernel());
    let mut terms = [[[0.0; LANES]; RUN]; P];
    for run in asked.chunks_mut(RUN) {
        for (gathered, terms) in packets.iter().zip(&mut terms) {
            let lights = run.iter().map(|asked| asked.light);
            kernel.run(Terms { lights, packet: gathered.packet, terms });
        }
        for (k, asked) in run.iter_mut().enumerate() {
            let (mut targets, mut sure, mut open) = ([&packets[0].packet.position; P], [0; P], [0; P]);
            for (i, Gathered { packet, .. }) in packets.iter().enumerate() {
                targets[i] = &packet.position;
                let lit = positive(&terms[i][k]) & packets[i].together(asked.light);
                [sure[i], open[i]] = sight.of(i, packet, asked.light, lit);
                *rays += u64::from(open[i].count_ones());
            }
            let mut blocked = [0; P];
            if open != blocked {
                blocked = tracer.occluded_parts(asked.light.position, targets, open, &mut asked.occluder);
            }
            for (i, gathered) in packets.iter_mut().enumerate() {
                gathered.add(world, asked, &terms[i][k], sure[i] | open[i] & !blocked[i], rays);
            }
        }
    }
}

/// What the points of a packet have received so far.
struct Gathered<'p, 'w> {
    packet: &'p Packet<'w>,
    points: Points<'p, 'w>,
    gloss: GlossyPoints,
    /// Of the Lambertian ones and those with a lobe over that, by colour and lane.
    irradiance: Three,
    /// What the lobes make of it, for ρ_s = 1.
    lobes: Three,
    /// Of the others.
    radiance: [Rgb; LANES],
}

impl<'p, 'w> Gathered<'p, 'w> {
    fn new(packet: &'p Packet<'w>) -> Gathered<'p, 'w> {
        Gathered {
            packet,
            points: Points::new(packet),
            gloss: GlossyPoints::new(packet),
            irradiance: [[0.0; LANES]; 3],
            lobes: [[0.0; LANES]; 3],
            radiance: [Rgb::BLACK; LANES],
        }
    }

    /// Lanes that [`Terms`] and packets of shadow rays are for: not those that light may reach through the surface.
    fn together(&self, light: &Vpl<'_>) -> u16 {
        if matches!(light.shine, Shine::Distant) { 0 } else { self.packet.opaque }
    }

    /// Adds the light of one light: to the lanes of `seen`, by its geometry terms, and to those that are asked one by one.
    fn add(&mut self, world: &World, asked: &Asked<'_, '_>, g: &[f32; LANES], seen: u16, rays: &mut u64) {
        let (p, kernel) = (self.packet, world.tracer().kernel());
        let Asked { light, factor, .. } = asked;
        if seen != 0 {
            let law = Law::new(light, *factor);
            let of = if law.is_some() { seen & (p.lambertian | self.gloss.of) } else { 0 };
            match &law {
                Some(law) if law.has_lobe() || of & self.gloss.of != 0 => kernel.run(Shed {
                    plain: &mut self.irradiance,
                    glossy: &mut self.lobes,
                    packet: p,
                    points: &self.gloss,
                    light: light.position,
                    law,
                    g,
                    of,
                }),
                Some(law) => kernel.run(Sum { into: &mut self.irradiance, intensity: law.even, g, of }),
                None => {}
            }
            for k in lanes(seen & !of) {
                if let Some(x) = self.points.get(k) {
                    self.radiance[k] += reflected(&x.surface, light, g[k]) * *factor;
                }
            }
        }
        for k in lanes(p.live & !self.together(light)) {
            if let Some(x) = self.points.get(k) {
                self.radiance[k] += from_light(world, &x.surface, light, rays) * *factor;
            }
        }
    }

    /// The radiance that leaves the points by what they received since this was asked last [cd/m²].
    fn take(&mut self) -> [Rgb; LANES] {
        let p = self.packet;
        let mut radiance = std::mem::replace(&mut self.radiance, [Rgb::BLACK; LANES]);
        let (irradiance, lobes) = (std::mem::take(&mut self.irradiance), std::mem::take(&mut self.lobes));
        let of = |[r, g, b]: &Three, k: usize| Rgb::new(r[k], g[k], b[k]);
        for k in lanes(p.lambertian) {
            radiance[k] += p.reflectance[k] * of(&irradiance, k) * FRAC_1_PI;
        }
        for k in lanes(self.gloss.of) {
            let Glossy { base, specular, .. } = p.gloss[k];
            radiance[k] += base * of(&irradiance, k) * FRAC_1_PI + specular * of(&lobes, k);
        }
        radiance
    }
}

/// Adds a light's intensity times its geometry terms to some lanes.
struct Sum<'a> {
    into: &'a mut [[f32; LANES]; 3],
    intensity: Rgb,
    g: &'a [f32; LANES],
    of: u16,
}

impl Wide for Sum<'_> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        let Rgb { r, g, b } = self.intensity;
        for k in 0..LANES {
            let term = if self.of >> k & 1 == 1 { self.g[k] } else { 0.0 };
            self.into[0][k] += r * term;
            self.into[1][k] += g * term;
            self.into[2][k] += b * term;
        }
    }
}

/// `geometry_term` for sixteen opaque reflectors, and the lanes of `of` where it is not zero.
pub(super) fn geometry_terms(
    kernel: Kernel,
    light: &Vpl<'_>,
    packet: &Packet<'_>,
    of: u16,
) -> ([f32; LANES], u16) {
    if of == 0 {
        return ([0.0; LANES], 0);
    }
    let mut g = [[0.0; LANES]];
    kernel.run(Terms { lights: std::iter::once(light), packet, terms: &mut g });
    let [g] = g;
    let lit = positive(&g) & of;
    (g, lit)
}

/// The geometry terms of some lights at sixteen points that reflect on the side of the eye; none of distant lights.
struct Terms<'a, 'w, L> {
    lights: L,
    packet: &'a Packet<'w>,
    terms: &'a mut [[f32; LANES]],
}

impl<'l, 'v: 'l, L: Iterator<Item = &'l Vpl<'v>>> Wide for Terms<'_, '_, L> {
    type Out = ();

    #[inline(always)]
    fn run(self) {
        for (light, g) in self.lights.zip(self.terms) {
            *g = terms(light, self.packet);
        }
    }
}

/// The geometry terms of one light.
#[inline(always)]
fn terms(light: &Vpl<'_>, p: &Packet<'_>) -> [f32; LANES] {
    let mut g = [0.0; LANES];
    let y = light.position;
    let (mut cos_x, mut front, mut d2) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    let mut cos_y = [1.0; LANES];
    let n = match light.shine {
        Shine::Lambert(n) => n,
        Shine::Beam(axis, _) => axis,
        _ => Vec3::ZERO,
    };
    for k in 0..LANES {
        let (dx, dy, dz) = (y.x - p.position[0][k], y.y - p.position[1][k], y.z - p.position[2][k]);
        d2[k] = dx * dx + dy * dy + dz * dz;
        cos_x[k] = dx * p.shading[0][k] + dy * p.shading[1][k] + dz * p.shading[2][k];
        front[k] = dx * p.geometric[0][k] + dy * p.geometric[1][k] + dz * p.geometric[2][k];
        cos_y[k] = -(dx * n.x + dy * n.y + dz * n.z);
    }
    match light.shine {
        Shine::Lambert(_) => {
            for k in 0..LANES {
                g[k] = (cos_x[k].max(0.0) * cos_y[k].max(0.0) / (d2[k] * d2[k])).min(light.bound);
            }
        }
        Shine::Isotropic => {
            for k in 0..LANES {
                g[k] = cos_x[k].max(0.0) / (d2[k] * d2[k].sqrt());
            }
        }
        Shine::Beam(_, beam) => {
            for k in 0..LANES {
                let d = d2[k].sqrt();
                g[k] = cos_x[k].max(0.0) / (d2[k] * d) * beam.profile(cos_y[k] / d);
            }
        }
        Shine::Distant => {}
    }
    for k in 0..LANES {
        g[k] = if (g[k] > 0.0) & (front[k] > 0.0) { g[k] } else { 0.0 };
    }
    g
}
