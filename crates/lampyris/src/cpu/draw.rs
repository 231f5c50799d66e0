//! How a batch is drawn: light first, then bands of tiles, each seen once for all layers, lit part by part, summed and shown.

use super::GoOn;
use super::begun::Begun;
use super::film::Film;
use crate::coarse::Coarse;
use crate::color::Rgb;
use crate::eye::{Eye, Rect, Sampling, Tile};
use crate::filter::{Filter, Glimpse};
use crate::frame::{Auxiliary, Frame, Tiles};
use crate::geometry::{lane, lanes};
use crate::integrator::{self, Integrator, Lights, Pass};
use crate::irradiance::Irradiance;
use crate::particle::Walk;
use crate::photon::Photons;
use crate::sequence::{self, jittered_hammersley};
use crate::settings::{Batch, Rays, Statistics};
use crate::world::World;
use rayon::prelude::*;
use std::ops::Range;

/// Least edge of a tile [pixels]: its visible points and sums stay in the nearest cache.
const TILE: u32 = 16;

/// How far from each other's tangent plane the vertices of neighbouring pixels may lie and still be of one surface
/// [edges of a pixel].
const SLACK: f32 = 1.7;

/// The least edge for n interleaved pixels: whole packets of each class.
fn tile_edge(n: u32) -> u32 {
    TILE.div_ceil(4 * n) * 4 * n
}

/// What becomes of light when it is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Neighbours share it.
    Shared,
    /// They do not.
    Own,
    /// They do not, and further eye rays find it again.
    Emission,
}

impl Kind {
    fn of(integrator: &dyn Integrator) -> Kind {
        match integrator.is_smooth() {
            true => Kind::Shared,
            false if integrator.name() == "emission" => Kind::Emission,
            false => Kind::Own,
        }
    }
}

/// One plane of what is drawn in a tile.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    kind: Kind,
    /// Which of a layer's exact sums it is added to.
    sum: usize,
    /// Whether it is for the light of second eye paths alone: it stays empty until there are some.
    late: bool,
}

impl Plane {
    /// The planes that integrators draw into, and of each integrator which two are its: that of first eye paths and that of
    /// second ones. Either the parts are told apart, or three planes hold what is to be shown in the same way.
    pub(super) fn deal(integrators: &[&dyn Integrator], apart: bool) -> (Vec<Plane>, Vec<[usize; 2]>) {
        let kinds = integrators.iter().map(|i| Kind::of(*i));
        if !apart {
            let planes =
                [Kind::Shared, Kind::Own, Kind::Emission].map(|kind| Plane { kind, sum: 0, late: false });
            let two =
                kinds.map(|kind| [kind, Kind::Own].map(|kind| planes.iter().position(|p| p.kind == kind)));
            let two = two.map(|places| places.map(Option::unwrap_or_default)).collect();
            return (planes.to_vec(), two);
        }
        let number = integrators.len();
        let first = kinds.zip(0..).map(|(kind, sum)| Plane { kind, sum, late: false });
        let second = (0..number).map(|sum| Plane { kind: Kind::Own, sum, late: true });
        (first.chain(second).collect(), (0..number).map(|k| [k, number + k]).collect())
    }
}

/// What all tiles of a batch share.
struct Shared<'w> {
    world: &'w World,
    batch: Batch,
    /// The light groups that the batch is added to.
    groups: &'w [usize],
    /// Of each class, the light of these groups.
    lights: Vec<Vec<Lights<'w>>>,
    photons: Option<Photons>,
    coarse: Option<Coarse<'w>>,
    irradiance: Option<Irradiance>,
}

/// Pieces of work that a batch is cut into at least, however small the picture: a handful of meters keeps all threads
/// busy. A fixed number, since cuts decide the last bits of sums.
const PIECES: u32 = 64;

/// What some eye passes in one tile add to the frame.
struct Summed {
    rect: Rect,
    /// Of each layer, the planes that its sums have.
    layers: Vec<Vec<Vec<Rgb>>>,
    auxiliary: Option<Auxiliary>,
    glimpse: Option<Glimpse>,
    rays: Rays,
    non_finite: u64,
}

/// Tiles that are worked on together, at least, before they are summed: all threads are busy, and little waits.
const TOGETHER: usize = 128;

impl Film {
    /// Adds a batch to the light groups that have the fewest, to all, unless some began anew; or only to what they show. It
    /// goes on as long as `go_on` says, which is asked before every tile; false if it was given up. The same batch then
    /// completes it; for another one the groups that have part of it begin anew.
    pub(super) fn add(&mut self, world: &World, batch: Batch, kept: bool, go_on: GoOn<'_>) -> bool {
        if !go_on() {
            return false;
        }
        let mut begun = self.begin(batch, kept);
        let mut frame = std::mem::take(&mut self.frame);
        let mut statistics = self.statistics;
        let done = self.light_and_draw(world, &mut begun, &mut frame, &mut statistics, go_on);
        (self.frame, self.statistics) = (frame, statistics);
        if done.is_none() {
            self.give_up(begun);
        }
        done.is_some()
    }

    /// `None` if it was given up.
    fn light_and_draw(
        &self,
        world: &World,
        begun: &mut Begun,
        frame: &mut Frame,
        statistics: &mut Statistics,
        go_on: GoOn<'_>,
    ) -> Option<()> {
        let (groups, batch) = (begun.groups.clone(), begun.batch);
        let walk =
            |group: &usize| go_on().then(|| Walk::of_layer(world, &self.settings, &self.plan, batch, *group));
        let walks = groups.par_iter().map(walk).collect::<Option<Vec<Walk<'_>>>>()?;
        // Meters hang in the air, where no photon stays: they take the oracle.
        let useful = matches!(self.eye, Eye::Camera(_)) && world.bodies().make_caustics();
        let useful = useful && integrator::gather_photons(&self.integrators);
        if useful && !go_on() {
            return None;
        }
        let photons = useful.then(|| Photons::new(world, &self.settings, &self.plan, &groups, &walks, batch));
        if self.grounds.is_some() && !go_on() {
            return None;
        }
        let coarse = self
            .grounds
            .as_ref()
            .map(|grounds| Coarse::new(world, grounds, &self.settings, &self.plan, &groups, batch));
        statistics.rays.particle += coarse.as_ref().map_or(0, |coarse| coarse.rays);
        let irradiance = self.irradiance(world, coarse.as_ref(), &groups, batch);
        if let Some(irradiance) = &irradiance {
            statistics.rays += irradiance.rays;
            statistics.records += irradiance.records() as u64;
        }
        for walk in &walks {
            statistics.rays.particle += walk.rays;
            statistics.vpls += (walk.lights.len() + walk.vpls.len()) as u64;
        }
        statistics.rays.particle += photons.as_ref().map_or(0, |p| p.rays);
        let lights = self.lights(world, &groups, &walks);
        if begun.kept && begun.bands == 0 {
            frame.begin(&groups);
        }
        self.draw(
            &Shared { world, batch, groups: &groups, lights, photons, coarse, irradiance },
            begun,
            frame,
            statistics,
            go_on,
        )
    }

    /// Irradiance at some of what the first eye pass sees, where a part gathers it and may interpolate.
    fn irradiance(
        &self,
        world: &World,
        coarse: Option<&Coarse<'_>>,
        groups: &[usize],
        batch: Batch,
    ) -> Option<Irradiance> {
        let coarse = coarse.filter(|_| integrator::wants(&self.integrators).reflected)?;
        let light = (coarse, groups.len());
        Irradiance::new(world, &self.eye, &self.settings, light, self.sampling(batch, 0))
    }

    /// Of each class, the light of some groups.
    fn lights<'w>(&self, world: &World, groups: &[usize], walks: &'w [Walk<'w>]) -> Vec<Vec<Lights<'w>>> {
        let mut shares = vec![0.0; self.plan.layers()];
        for (emitter, share) in (0..).zip(world.shares()) {
            // What is dark has no light paths either.
            shares[self.plan.layer_of(emitter)] +=
                if self.plan.is_dark(world, emitter) { 0.0 } else { *share };
        }
        let of_class = |class: u32| {
            let of_group = |(group, walk): (&usize, &'w Walk<'w>)| {
                let ((vpls, beacons), beyond) = (walk.vpls_of(class), walk.beyond_of(class));
                let (share, points) = (shares[*group], walk.lights_of(class));
                Lights {
                    group: *group,
                    share,
                    points,
                    vpls,
                    beacons,
                    reflected: walk.reflected_of(class),
                    beyond,
                }
            };
            groups.iter().zip(walks).map(of_group).collect()
        };
        (0..self.settings.classes()).map(of_class).collect()
    }

    /// Draws what is left of a batch, some rows of tiles after the others, and adds it to a frame; `None` if it was given up.
    fn draw(
        &self,
        shared: &Shared<'_>,
        begun: &mut Begun,
        frame: &mut Frame,
        statistics: &mut Statistics,
        go_on: GoOn<'_>,
    ) -> Option<()> {
        let (width, _) = self.eye.size();
        let passes = self.settings.eye_passes();
        let replicate = shared.batch.index % self.settings.replicates;
        let rects = self.rects(shared.batch);
        let run = passes.div_ceil(PIECES.div_ceil(rects.len().max(1) as u32)).max(1);
        let Begun { kept, note, .. } = *begun;
        let sampling = self.sampling(shared.batch, 0);
        let glows = self.integrators.iter().any(|i| i.name() == "emission");
        let layer_of = |emitter| {
            let group = self.plan.layer_of(emitter);
            let place = shared.groups.iter().position(|own| glows && *own == group);
            place.map(|place| (place, self.plan.tint(emitter)))
        };
        let filter = Filter {
            world: shared.world,
            eye: &self.eye,
            sampling,
            settings: &self.settings,
            layer_of: &layer_of,
        };
        for band in bands(&rects).skip(begun.bands) {
            let pieces: Vec<(Rect, Range<u32>)> = band
                .iter()
                .flat_map(|rect| (0..passes).step_by(run as usize).map(|p| (*rect, p..passes.min(p + run))))
                .collect();
            let done = pieces
                .par_iter()
                .map_init(Default::default, |paths, (rect, numbers)| {
                    go_on().then(|| self.render(paths, *rect, numbers.clone(), shared, note, &layer_of))
                })
                .collect::<Option<Vec<Summed>>>()?;
            begun.bands += 1;
            begun.pixels = band.last().map_or(begun.pixels, |last| {
                place(*last, width, (last.width * last.height) as usize - 1) + 1
            });
            if let (Some(seen), Some(first), Some(last)) = (&mut begun.seen, band.first(), band.last()) {
                let glimpses: Vec<&Glimpse> = done.iter().filter_map(|p| p.glimpse.as_ref()).collect();
                let mut shown: Vec<&mut Vec<Rgb>> = frame.shown_mut(shared.groups);
                let rows = first.y..last.y + last.height;
                statistics.rays.eye += filter.show(seen, rows, &glimpses, &mut shown);
            }
            let mut layers: Vec<(usize, Tiles)> = shared.groups.iter().map(|k| (*k, Vec::new())).collect();
            for piece in done {
                self::note(&piece, width, statistics, frame);
                for ((_, tiles), planes) in layers.iter_mut().zip(piece.layers) {
                    match tiles.last_mut().filter(|(rect, _)| *rect == piece.rect) {
                        Some((_, sums)) => {
                            let pairs = sums.iter_mut().flatten().zip(planes.iter().flatten());
                            pairs.for_each(|(sum, v)| *sum += *v);
                        }
                        None => tiles.push((piece.rect, planes)),
                    }
                }
            }
            // A batch is summed by itself before it is added: others may then merge it to the same bits.
            if kept {
                frame.add(replicate, &layers);
            }
        }
        for group in shared.groups {
            if kept { frame.count(*group, replicate) } else { frame.count_shown(*group) }
        }
        if let Some(sums) = frame.auxiliary_mut().filter(|_| note) {
            sums.samples += passes;
        }
        Some(())
    }

    /// The picture cut into tiles, elsewhere in each batch: what pixels of a tile have in common must not show.
    fn rects(&self, batch: Batch) -> Vec<Rect> {
        let (width, height) = self.eye.size();
        let seed = sequence::hash(sequence::hash(self.settings.seed, u32::from(b't')), batch.index);
        let cuts = |size: u32, axis: usize| {
            let n = self.settings.interleave[axis];
            let edge = tile_edge(n);
            // Tiles begin at multiples of n, or classes would not meet.
            let first = n * (sequence::hash(seed, axis as u32) % (edge / n) + 1);
            let starts: Vec<u32> = std::iter::once(0).chain((first..size).step_by(edge as usize)).collect();
            let ends: Vec<u32> = starts[1..].iter().copied().chain([size]).collect();
            starts.into_iter().zip(ends).map(|(start, end)| (start, end - start)).collect::<Vec<_>>()
        };
        let columns = cuts(width, 0);
        let rows = cuts(height, 1);
        let rects = rows.iter().flat_map(|(y, height)| {
            columns.iter().map(move |(x, width)| Rect { x: *x, y: *y, width: *width, height: *height })
        });
        rects.collect()
    }

    /// Some eye passes of a batch in one tile; `note` asks for what the eye meets first. `tiles` and `seconds` are memory to
    /// use.
    fn render<'w>(
        &'w self,
        [tiles, seconds]: &mut [Vec<Tile<'w>>; 2],
        rect: Rect,
        numbers: Range<u32>,
        shared: &Shared<'w>,
        note: bool,
        layer_of: &dyn Fn(u32) -> Option<(usize, Rgb)>,
    ) -> Summed {
        let pixels = (rect.width * rect.height) as usize;
        let layers = shared.groups.len();
        let plane = |of: &Plane| vec![vec![Rgb::BLACK; if of.late { 0 } else { pixels }]; layers];
        let mut planes: Vec<Vec<Vec<Rgb>>> = self.planes.iter().map(plane).collect();
        let mut auxiliary = note.then(|| Auxiliary::new(pixels));
        let mut rays = Rays::default();
        self.eye.lay_out(shared.world, rect, self.settings.interleave, tiles);
        let samples = self.settings.eye_passes();
        for number in numbers {
            let sampling = self.sampling(shared.batch, number);
            for tile in tiles.iter_mut() {
                self.eye.look(&sampling, tile);
            }
            self.eye.split(tiles, samples, seconds);
            rays.eye += tiles.iter().chain(&*seconds).map(|tile| tile.rays).sum::<u64>();
            if seconds.iter().any(|tile| !tile.packets.is_empty()) {
                planes.iter_mut().flatten().for_each(|plane| plane.resize(pixels, Rgb::BLACK));
            }
            let first = number as usize * tiles.len();
            let passes: Vec<Pass<'_>> = shared.lights[first..first + tiles.len()]
                .iter()
                .map(|lights| Pass {
                    world: shared.world,
                    settings: &self.settings,
                    plan: &self.plan,
                    eye: &self.eye,
                    lights,
                    photons: shared.photons.as_ref(),
                    coarse: shared.coarse.as_ref(),
                    irradiance: shared.irradiance.as_ref(),
                    sampling,
                })
                .collect();
            for (integrator, [first, second]) in self.integrators.iter().zip(&self.planes_of) {
                for (pass, tile) in passes.iter().zip(tiles.iter()) {
                    integrator.add(pass, tile, &mut planes[*first], &mut rays);
                }
                let more = passes.iter().zip(seconds.iter()).filter(|(_, tile)| !tile.packets.is_empty());
                for (pass, tile) in more.filter(|_| !integrator.starts_at_the_eye()) {
                    integrator.add(pass, tile, &mut planes[*second], &mut rays);
                }
            }
            if let Some(sums) = &mut auxiliary {
                tiles.iter().for_each(|tile| note_first(tile, sums));
            }
        }
        let scale = 1.0 / samples as f32;
        let mut non_finite = 0;
        for v in planes.iter_mut().flatten().flatten() {
            if v.is_finite() {
                *v *= scale;
            } else {
                *v = Rgb::BLACK;
                non_finite += 1;
            }
        }
        let glimpse = self.settings.filter.then(|| self.glimpse(rect, tiles, &planes, layer_of));
        let mut layers: Vec<Vec<Vec<Rgb>>> = vec![Vec::new(); layers];
        for (plane, of) in planes.into_iter().zip(&self.planes) {
            for (layer, plane) in layers.iter_mut().zip(plane) {
                match layer.get_mut(of.sum) {
                    Some(sum) => sum.iter_mut().zip(plane).for_each(|(sum, v)| *sum += v),
                    None => layer.push(plane),
                }
            }
        }
        Summed { rect, layers, auxiliary, glimpse, rays, non_finite }
    }

    /// What a batch of one eye pass saw in a tile.
    fn glimpse(
        &self,
        rect: Rect,
        tiles: &[Tile<'_>],
        planes: &[Vec<Vec<Rgb>>],
        layer_of: &dyn Fn(u32) -> Option<(usize, Rgb)>,
    ) -> Glimpse {
        let layers = planes.first().map_or(0, Vec::len);
        let mut glimpse = Glimpse::new(rect, layers);
        for layer in 0..layers {
            for (plane, of) in planes.iter().zip(&self.planes) {
                match of.kind {
                    Kind::Shared => glimpse.add_shared(layer, &plane[layer]),
                    Kind::Own => glimpse.add_own(layer, &plane[layer]),
                    Kind::Emission => {}
                }
            }
        }
        for p in tiles.iter().flat_map(|tile| &tile.packets) {
            for gleam in &p.gleams {
                if let Some((layer, tint)) = layer_of(gleam.emitter) {
                    glimpse.gleam(layer, p.pixels[gleam.lane] as usize, gleam.radiance * tint);
                }
            }
            for k in p.lanes() {
                if let Some(surface) = p.alike(k) {
                    glimpse.surface(p.pixels[k] as usize, surface);
                }
            }
            for k in lanes(p.live) {
                let (position, normal) = (lane(&p.position, k), lane(&p.shading, k));
                let tint = p.throughput[k] * p.reflectance[k];
                let slack = self.eye.pixel_size(position) * SLACK;
                glimpse.place(p.pixels[k] as usize, position, normal, tint, slack);
            }
        }
        glimpse
    }

    /// The sample that an eye pass takes: a jittered Hammersley point for its number, both coordinates shifted
    /// mod 1 by numbers drawn anew in each batch, without which the survivors among the paths, a prefix, would only
    /// see one side of each pixel.
    fn sampling(&self, batch: Batch, number: u32) -> Sampling {
        let settings = &self.settings;
        let (replicate, block) = (batch.index % settings.replicates, batch.index / settings.replicates);
        let seed = sequence::hash(sequence::hash(settings.seed, replicate), u32::from(b'e'));
        let passes = settings.eye_passes();
        let jitter = sequence::hash(seed, block);
        let offset = [0, 1].map(|d| {
            let shifted = jittered_hammersley(number, passes, d, jitter) + sequence::uniform(seed, block, d);
            shifted.fract()
        });
        Sampling { offset, index: block.wrapping_mul(passes).wrapping_add(number), seed }
    }
}

/// Tiles that are worked on together: whole rows of them, or a part of the only one.
fn bands(rects: &[Rect]) -> impl Iterator<Item = &[Rect]> {
    let columns = rects.iter().take_while(|rect| rect.y == rects[0].y).count().max(1);
    let together = if columns < rects.len() { TOGETHER.div_ceil(columns) * columns } else { TOGETHER };
    rects.chunks(together)
}

/// What a piece of work counted, and what its paths met first.
fn note(piece: &Summed, width: u32, statistics: &mut Statistics, frame: &mut Frame) {
    statistics.rays += piece.rays;
    statistics.non_finite += piece.non_finite;
    if let (Some(sums), Some(part)) = (frame.auxiliary_mut(), &piece.auxiliary) {
        (0..part.depth.len()).for_each(|k| sums.add(place(piece.rect, width, k), part, k));
    }
}

/// Adds what the paths of a tile met first.
fn note_first(tile: &Tile<'_>, sums: &mut Auxiliary) {
    for packet in &tile.packets {
        for k in packet.lanes() {
            let Some(first) = packet.first(k) else { continue };
            let at = packet.pixels[k] as usize;
            sums.albedo[at] += first.albedo;
            sums.normal[at] += Rgb::new(first.normal.x, first.normal.y, first.normal.z);
            sums.depth[at] += first.depth;
            if sums.object[at] == 0 {
                sums.object[at] = first.instance + 1;
            }
        }
    }
}

/// Where in the picture, row by row, a tile's pixel lies.
fn place(rect: Rect, width: u32, k: usize) -> usize {
    let (x, y) = rect.pixel(k as u32);
    y as usize * width as usize + x as usize
}
