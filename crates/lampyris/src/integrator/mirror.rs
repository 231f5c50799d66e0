//! Light over one planar mirror, by virtual light sources [Keller97, §4.2]: every light point and virtual light before
//! a mirror has an image behind it that shines through the mirror as through a window, G taken along the whole way.
//!
//! So also the light of points and spots is found, which no path from the eye can aim at. Curved mirrors, glass, polish
//! and more than one mirror in a row make no images; such paths are *caustic*'s.

use super::pane::Pane;
use super::pick::pick;
use super::short::Way;
use super::{Costly, Integrator, Lights, Pass, compensation, direct, gather};
use crate::color::Rgb;
use crate::eye::{LANES, Numbers, Packet, Tile};
use crate::geometry::{Ray, lane, lanes};
use crate::light::Shine;
use crate::material::Class;
use crate::particle::Vpl;
use crate::sequence::{self, ledger::eye as ledger};
use crate::settings::Rays;
use crate::world::{Mirror as Plane, Surface, World};
use glam::Vec3;

/// Mirrors that reflect less make their images by chance, in proportion: a window pane costs less than a looking-glass.
const SURE: f32 = 0.25;

/// Lights, and virtual lights, whose images stand for all of them where a single point is shaded: what is over a mirror at
/// the end of a short ray matters little.
const SOURCES: f32 = 1.0;

/// Images picked in a perfect mirror for each virtual light picked: one costs three times as much, and gives less.
const MIRRORED: f32 = 0.25;

/// Paths L (S|D)* D M D S* E and L M D S* E.
pub(super) struct Mirror;

impl Integrator for Mirror {
    fn name(&self) -> &'static str {
        "mirror"
    }

    fn paths(&self) -> &'static str {
        "L ((S|D)* D)? M D S* E"
    }

    fn gathers_photons(&self) -> bool {
        true
    }

    fn add<'w>(&self, pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut Rays) {
        let world = pass.world;
        if world.mirrors().is_empty() {
            return;
        }
        up_to_clamp(pass, tile, out, &mut rays.shadow);
        let reach = 1.0 / pass.plan.bound.min(pass.plan.emitter_bound).sqrt();
        let near = tile.packets.iter().filter(|p| may_be_near(world, p.extent(), reach));
        let costly = Costly { purpose: b'm', phase: 3, stake: tile.stake };
        costly.add(pass, near, out, |x, numbers, found| {
            direct::near_light(pass, x, Way::Folded, numbers, found, rays);
            compensation::beyond_clamp(pass, *x, Way::Folded, numbers.branch(0), found, rays);
        });
    }
}

/// Adds what every point of a tile receives of the light of each group over mirrors, up to the clamp.
fn up_to_clamp<'w>(pass: &Pass<'w>, tile: &Tile<'w>, out: &mut [Vec<Rgb>], rays: &mut u64) {
    let (world, kernel) = (pass.world, pass.world.tracer().kernel());
    // Many virtual lights are picked among packet by packet.
    let picks = |lights: &Lights<'w>| lights.picks(pass.settings, lights.vpls, tile);
    let images: Vec<Vec<Image<'w>>> =
        pass.lights.iter().map(|lights| images(pass, lights, picks(lights).is_none())).collect();
    for p in tile.packets.iter().filter(|p| p.live != 0) {
        // The same for all groups: mirrors know nothing of light.
        let panes: Vec<Pane<'_>> = world.mirrors().iter().map(|plane| Pane::new(kernel, plane, p)).collect();
        for ((lights, out), images) in pass.zip(&mut *out).zip(&images) {
            let picked = picks(lights).map_or(Vec::new(), |most| picked(world, lights, p, &panes, most));
            let shown = images.iter().filter(|image| image.may_be_shown_by(&panes[image.number as usize]));
            gather::add(p, &packet(world, p, shown.chain(&picked), rays), out);
        }
    }
}

/// The images of a group's light points, and of all of its virtual lights if so asked, that chance decides for.
fn images<'w>(pass: &Pass<'w>, lights: &Lights<'w>, all: bool) -> Vec<Image<'w>> {
    let sources = lights.points.iter().chain(if all { lights.vpls } else { &[] });
    let seed = sequence::hash(pass.sampling.seed, b'm'.into());
    sources
        .flat_map(|light| Image::all(pass.world, light))
        .zip(0..)
        .filter_map(|(image, k)| image.drawn(sequence::uniform(seed, pass.sampling.index, k)))
        .collect()
}

/// Adds the radiance at one point by light over a mirror, up to the clamp of virtual lights, group by
/// group: the clear, scalar form.
pub(super) fn at(pass: &Pass<'_>, x: &Surface<'_>, numbers: Numbers, out: &mut [Rgb], rays: &mut Rays) {
    let world = pass.world;
    if world.mirrors().is_empty() {
        return;
    }
    let u = numbers.one(ledger::light(0));
    let some = |lights: &[Vpl<'_>], most, u, rays: &mut u64| {
        gather::some_of(lights, most, u, |light| {
            let images = Image::all(world, light);
            images.map(|image| image.light_at(world, x, rays)).fold(Rgb::BLACK, |a, b| a + b)
        })
    };
    for (lights, out) in pass.zip(out) {
        let (most, u) = (SOURCES * lights.share, lights.turned(u));
        let traced = &mut rays.compensation;
        *out += some(lights.points, most, u, traced) + some(lights.vpls, most, u, traced);
    }
    direct::near_light(pass, x, Way::Folded, numbers, out, rays);
}

/// The images of virtual lights that a packet traces: the stronger a mirror the more.
fn picked<'w>(
    world: &'w World,
    lights: &Lights<'w>,
    p: &Packet<'_>,
    panes: &[Pane<'_>],
    most: f32,
) -> Vec<Image<'w>> {
    let kernel = world.tracer().kernel();
    let first = p.numbers[p.live.trailing_zeros() as usize].branch(b'm'.into());
    let mut images = Vec::new();
    for ((reflected, plane), pane) in lights.reflected.iter().zip(world.mirrors()).zip(panes) {
        let (beacons, of) = reflected.seen_from(kernel, plane, pane.bounds());
        if beacons.is_empty() {
            continue;
        }
        let number = reflected.mirror;
        let share = MIRRORED * most * plane.strength();
        let u = lights.turned(first.branch(u32::from(number)).one(ledger::PICK));
        pick(kernel, p, (&beacons, pane), share, u, |k, factor| {
            let image = Image::new(plane, number, &lights.vpls[of[k] as usize]);
            images.extend(image.map(|image| Image { weight: factor, ..image }));
        });
    }
    images
}

fn may_be_near(world: &World, extent: [Vec3; 2], reach: f32) -> bool {
    reach > 0.0 && world.mirrors().iter().any(|m| m.may_be_near(extent, reach))
}

/// A light as it appears in a mirror.
struct Image<'w> {
    /// The light itself.
    source: &'w Vpl<'w>,
    /// Position, or direction if distant, and angular law of the image. A glossy vertex keeps its own BSDF.
    image: Vpl<'w>,
    /// The mirror and its number.
    plane: &'w Plane,
    number: u8,
    /// 1 over the probability that there is this image.
    weight: f32,
}

impl<'w> Image<'w> {
    /// The images of a light.
    fn all(world: &'w World, source: &'w Vpl<'w>) -> impl Iterator<Item = Image<'w>> {
        (0..).zip(world.mirrors()).filter_map(move |(number, plane)| Image::new(plane, number, source))
    }

    /// `None` where the light lies in the mirror's plane or shines away from it.
    fn new(plane: &'w Plane, number: u8, source: &'w Vpl<'w>) -> Option<Image<'w>> {
        let y = source.position;
        if let Shine::Distant = source.shine {
            let image = Vpl { position: plane.turned(y), ..*source };
            return Some(Image { source, image, plane, number, weight: 1.0 });
        }
        plane.height(y)?;
        let shine = match source.shine {
            Shine::Lambert(n) if !plane.may_be_before(y, n) => return None,
            Shine::Lambert(n) => Shine::Lambert(plane.turned(n)),
            Shine::Beam(axis, beam) => Shine::Beam(plane.turned(axis), beam),
            other => other,
        };
        let image = Vpl { position: plane.image(y), shine, ..*source };
        Some(Image { source, image, plane, number, weight: 1.0 })
    }

    /// The image if `u` in [0, 1) decides for it.
    fn drawn(self, u: f32) -> Option<Image<'w>> {
        let probability = (self.plane.strength() / SURE).min(1.0);
        (u < probability).then(|| Image { weight: 1.0 / probability, ..self })
    }

    /// False only if none of the points that look through the pane sees the image.
    fn may_be_shown_by(&self, pane: &Pane<'_>) -> bool {
        matches!(self.image.shine, Shine::Distant) || pane.may_show_any(self.image.position)
    }

    /// False only if the pyramid of the image through the mirror does not hold `x`.
    fn may_shine_on(&self, x: Vec3) -> bool {
        if self.plane.height(x).is_none() {
            return false;
        }
        let d = match self.image.shine {
            Shine::Distant => self.image.position,
            _ => self.image.position - x,
        };
        self.plane.may_be_crossed(x, d)
    }

    /// Radiance that the dull lobes of `x` send toward its `wo` by the image [cd/m²].
    fn light_at(&self, world: &World, x: &Surface<'_>, rays: &mut u64) -> Rgb {
        let g = gather::geometry_term(&self.image, x.position, x.shading);
        if g.is_nan() || g <= 0.0 || !self.may_shine_on(x.position) {
            return Rgb::BLACK;
        }
        let value = self.reflected(x, g);
        if value.is_black() {
            return Rgb::BLACK;
        }
        let from = x.spawn(gather::direction(&self.image, x.position));
        value * self.share_seen(world, x, from, rays)
    }

    /// The same without the mirror and what blocks the way, for a geometry term `g`.
    fn reflected(&self, x: &Surface<'_>, g: f32) -> Rgb {
        let wi = gather::direction(&self.image, x.position);
        let f = x.eval(Class::Dull, x.wo, wi);
        if f.is_black() {
            return Rgb::BLACK;
        }
        f * gather::intensity(self.source, self.plane.turned(wi)) * (g * self.weight)
    }

    /// What the mirror reflects of the light on its way to `x`, whose side toward the mirror rays leave at `from`; black
    /// where the way is blocked or misses the mirror.
    fn share_seen(&self, world: &World, x: &Surface<'_>, from: Vec3, rays: &mut u64) -> Rgb {
        *rays += 2;
        let mirror = |p: &Surface<'_>| p.mirror == Some(self.number);
        if let Shine::Distant = self.source.shine {
            let toward = self.source.position;
            let at = world.closest(&Ray::new(from, self.image.position)).filter(mirror);
            return at.map_or(Rgb::BLACK, |at| {
                let blocked = world.tracer().occluded(&Ray::new(at.spawn(toward), toward));
                if blocked { Rgb::BLACK } else { at.mirrored().1 * at.clear_from(from, Some(x)) }
            });
        }
        let origin = self.source.position;
        let direction = (self.plane.image(from) - origin).normalize_or_zero();
        let at = world.closest(&Ray::new(origin, direction)).filter(mirror);
        at.map_or(Rgb::BLACK, |at| {
            if world.tracer().blocked(at.spawn(at.wo), from) {
                return Rgb::BLACK;
            }
            let toward = (at.position - from).normalize_or_zero();
            let clear = x.clear_to(toward, (at.position - from).length(), None);
            at.mirrored().1 * clear * at.clear_from(origin, self.source.gloss.as_ref())
        })
    }
}

/// Radiance leaving each point of a packet by a list of images [cd/m²]: [`Image::light_at`], but with one packet of rays
/// from each light to the mirror.
fn packet<'i>(
    world: &World,
    p: &Packet<'_>,
    images: impl Iterator<Item = &'i Image<'i>>,
    rays: &mut u64,
) -> [Rgb; LANES] {
    let mut points = gather::Points::new(p);
    let mut radiance = [Rgb::BLACK; LANES];
    for image in images {
        let together = if matches!(image.image.shine, Shine::Distant) { 0 } else { p.opaque };
        let (g, lit) = gather::geometry_terms(world.tracer().kernel(), &image.image, p, together);
        let point = |k: usize| lane(&p.position, k);
        let lit = lanes(lit).filter(|k| image.may_shine_on(point(*k))).fold(0, |m, k| m | 1u16 << k);
        if lit != 0 {
            let share = shares_seen(world, image, lit, point, rays);
            for k in lanes(lit) {
                if !share[k].is_black()
                    && let Some(x) = points.get(k)
                {
                    radiance[k] += image.reflected(&x.surface, g[k]) * share[k];
                }
            }
        }
        for k in lanes(p.live & !together) {
            if let Some(x) = points.get(k) {
                radiance[k] += image.light_at(world, &x.surface, rays);
            }
        }
    }
    radiance
}

/// [`Image::share_seen`] for the lanes of `lit`.
fn shares_seen(
    world: &World,
    image: &Image<'_>,
    lit: u16,
    point: impl Fn(usize) -> Vec3,
    rays: &mut u64,
) -> [Rgb; LANES] {
    let origin = image.source.position;
    let mut directions = [[0.0; LANES]; 3];
    for k in lanes(lit) {
        let d = (image.plane.image(point(k)) - origin).normalize_or_zero();
        (directions[0][k], directions[1][k], directions[2][k]) = (d.x, d.y, d.z);
    }
    let hits = world.tracer().closest16(origin, &directions, lit);
    *rays += u64::from(lit.count_ones());
    let mut share = [Rgb::BLACK; LANES];
    for k in lanes(lit) {
        let direction = lane(&directions, k);
        let met = hits.get(k).filter(|hit| world.mirror_of(hit) == Some(image.number));
        if let Some(at) = met.map(|hit| world.surface(direction, &hit)) {
            *rays += 1;
            if !world.tracer().blocked(at.spawn(at.wo), point(k)) {
                share[k] = at.mirrored().1 * at.clear_from(origin, image.source.gloss.as_ref());
            }
        }
    }
    share
}
