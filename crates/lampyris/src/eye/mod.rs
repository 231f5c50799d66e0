//! From the eye to the first dull surface: the visible points of a tile, sixteen to a packet.
//!
//! An eye path goes on through sharp lobes (mirrors, glass, polish); what glows along it, seen directly or by reflection, is
//! the part *emission*. The first dull vertex x is what integrators shade. At the first surface a path splits in two where
//! light comes from there in two ways, and the second paths have packets of their own.

mod follow;
mod packet;

pub use crate::geometry::LANES;
pub(crate) use follow::balance;
pub use packet::{First, Gleam, Packet, Visible};

use crate::scene::View;
use crate::sequence::{self, sobol};
use crate::settings::Rays;
use crate::world::World;
use glam::Vec3;

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

    /// The four numbers of the group of dimensions that `dimension` begins.
    pub fn four(self, dimension: u32) -> [f32; 4] {
        sobol::sobol_owen_four(self.index, dimension, self.seed)
    }

    /// An independent set for another purpose at the same pixel and sample.
    pub fn branch(self, purpose: u32) -> Numbers {
        Numbers { seed: sequence::hash(self.seed, purpose), ..self }
    }
}

/// The visible points of one eye pass in a rectangle of the picture, or of one class of its pixels.
#[derive(Clone)]
pub struct Tile<'w> {
    /// Where.
    pub rect: Rect,
    /// The points.
    pub packets: Vec<Packet<'w>>,
    /// How many of the virtual lights that others pick are worth picking here: 1, or the share of their light that second
    /// paths bring, if that is less.
    pub stake: f32,
    /// Rays it took.
    pub rays: u64,
}

impl Default for Tile<'_> {
    /// No rectangle yet.
    fn default() -> Self {
        let rect = Rect { x: 0, y: 0, width: 0, height: 0 };
        Tile { rect, packets: Vec::new(), stake: 1.0, rays: 0 }
    }
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

    /// Edge of a pixel where it shows `position` [m]; nothing for meters.
    pub fn pixel_size(&self, position: Vec3) -> f32 {
        match self {
            Eye::Camera(view) => (position - view.eye()).length() * view.pixel_size(),
            Eye::Meters(_) => 0.0,
        }
    }

    /// The numbers of a pixel's sample.
    pub fn numbers(&self, x: u32, y: u32, sampling: &Sampling) -> Numbers {
        let pixel = y.wrapping_mul(self.size().0).wrapping_add(x);
        Numbers { index: sampling.index, seed: sequence::hash(sampling.seed, pixel) }
    }

    /// Lays out the packets of a rectangle of pixels, as yet without visible points: a tile for each class of the n × m
    /// pixels that are interleaved, row by row. The rectangle begins at a multiple of n × m. What `tiles` held is
    /// forgotten, its memory used again.
    pub fn lay_out<'w>(&self, world: &'w World, rect: Rect, [n, m]: [u32; 2], tiles: &mut Vec<Tile<'w>>) {
        tiles.resize_with((n * m) as usize, Tile::default);
        for (tile, class) in tiles.iter_mut().zip(0..) {
            self.lay_out_class(world, rect, [n, m], class, tile);
        }
    }

    /// [`Eye::lay_out`] for one of the n × m classes.
    pub fn lay_out_class<'w>(
        &self,
        world: &'w World,
        rect: Rect,
        [n, m]: [u32; 2],
        class: u32,
        tile: &mut Tile<'w>,
    ) {
        // Meters lie in one row: there a packet is a run of sixteen.
        let (bw, bh) = if matches!(self, Eye::Camera(_)) { (4, 4) } else { (LANES as u32, 1) };
        let blocks = |from: u32, to: u32, step: u32| (from..to).step_by(step as usize);
        (tile.rect, tile.stake, tile.rays) = (rect, 1.0, 0);
        let columns = blocks(class % n, rect.width, bw * n);
        let corners =
            blocks(class / n, rect.height, bh * m).flat_map(|y| columns.clone().map(move |x| (x, y)));
        let mut count = 0;
        for (left, top) in corners {
            let pixels = std::array::from_fn(|lane| {
                let (x, y) = (left + lane as u32 % bw * n, top + lane as u32 / bw * m);
                if x < rect.width && y < rect.height { y * rect.width + x } else { u32::MAX }
            });
            if count == tile.packets.len() {
                tile.packets.push(Packet::new(world));
            }
            tile.packets[count].place(rect, pixels);
            count += 1;
        }
        tile.packets.truncate(count);
    }

    /// [`Eye::lay_out`] afresh.
    pub fn tiles<'w>(&self, world: &'w World, rect: Rect, interleave: [u32; 2]) -> Vec<Tile<'w>> {
        let mut tiles = Vec::new();
        self.lay_out(world, rect, interleave, &mut tiles);
        tiles
    }

    /// Sends the eye paths of one pass through a tile.
    pub fn look(&self, sampling: &Sampling, tile: &mut Tile<'_>) {
        let samplings = [sampling; LANES];
        tile.rays = tile.packets.iter_mut().map(|packet| self.look_by(&samplings, packet)).sum();
    }

    /// Follows the second paths of tiles that were looked at, which left their first surface in another way than the first
    /// paths: a tile of them for each. What they see is to be added to what the first ones see; a pixel may occur in them
    /// once or not at all. Where a pixel has more `samples` at once, fewer second paths leave each. What `seconds` held is
    /// forgotten, its memory used again.
    pub fn split<'w>(&self, tiles: &[Tile<'w>], samples: u32, seconds: &mut Vec<Tile<'w>>) {
        seconds.resize_with(tiles.len(), Tile::default);
        for (tile, second) in tiles.iter().zip(seconds) {
            let (mut count, mut stakes, mut rays) = (0, 0.0, Rays::default());
            second.packets.iter_mut().for_each(Packet::clear);
            if let Eye::Camera(view) = self {
                for (first, lane) in tile.packets.iter().flat_map(|p| p.forks().map(move |lane| (p, lane))) {
                    let (number, to) = (count / LANES, count % LANES);
                    if number == second.packets.len() {
                        let mut packet = Packet::new(first.world());
                        packet.clear();
                        second.packets.push(packet);
                    }
                    let packet = &mut second.packets[number];
                    if let Some(stake) = packet.follow(to, (first, lane), view.eye(), samples, &mut rays) {
                        stakes += stake;
                        count += 1;
                    }
                }
            }
            second.packets.truncate(count.div_ceil(LANES));
            let live: u32 = second.packets.iter().map(|packet| packet.live.count_ones()).sum();
            (second.rect, second.stake, second.rays) = (tile.rect, stakes / live.max(1) as f32, rays.eye);
        }
    }

    /// Sends the eye paths of a packet, each lane's as a sampling of its own has it, as far as the first paths go. Returns
    /// the rays it took.
    pub fn look_by(&self, samplings: &[&Sampling; LANES], packet: &mut Packet<'_>) -> u64 {
        let mut rays = Rays::default();
        packet.start(self, samplings);
        match self {
            Eye::Camera(view) => packet.look_through(view, samplings, &mut rays),
            Eye::Meters(meters) => packet.lay_out(meters),
        }
        rays.eye
    }
}

impl Rect {
    /// Picture coordinates of a pixel of the rectangle, counted row by row.
    pub fn pixel(&self, k: u32) -> (u32, u32) {
        (self.x + k % self.width, self.y + k / self.width)
    }
}
