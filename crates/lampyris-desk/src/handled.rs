//! The mix while a hand moves a fader. A picture is the sum of its layers times their colours: what it is without those that
//! the hand moves is kept, and a new level costs as many layers as it changes instead of all of them. A large picture
//! is mixed with half its edges. The last places of such a mix differ from those of a whole one: what rests is mixed whole.

use lampyris::Rgb;
use lampyris::frame::Still;
use std::collections::BTreeMap;
use std::sync::{Arc, Weak};

/// Layers that are kept apart at most: who moves more of them mixes all.
const APART: usize = 4;

/// Pixels of a picture that takes longer to be made, sent and drawn than a hand likes to wait.
const LARGE: u32 = 1 << 20;

/// The size in which a picture is mixed while a hand moves [pixels].
pub(crate) fn size(of: [u32; 2]) -> [u32; 2] {
    if is_large(of) { of.map(|edge| edge.div_ceil(2)) } else { of }
}

fn is_large([width, height]: [u32; 2]) -> bool {
    width.saturating_mul(height) > LARGE
}

/// What is kept of the light that is being mixed.
#[derive(Default)]
pub(crate) struct Kept {
    /// The light, as long as somebody else keeps it.
    light: Weak<Still>,
    /// In these colours it is `base`.
    colors: Vec<Rgb>,
    base: Vec<Rgb>,
    /// Layers in white.
    layers: BTreeMap<usize, Vec<Rgb>>,
}

impl Kept {
    /// The light in those colours, in its [`size`].
    pub(crate) fn mix(&mut self, light: &Arc<Still>, colors: &[Rgb]) -> Vec<Rgb> {
        let known = Weak::ptr_eq(&self.light, &Arc::downgrade(light)) && self.colors.len() == colors.len();
        let changes = self.colors.iter().zip(colors).enumerate();
        let changes = changes.filter(|(_, (was, now))| was != now);
        let changes: Vec<(usize, Rgb)> = changes.map(|(k, (was, now))| (k, *now - *was)).collect();
        if !known || changes.len() > APART {
            let base = fitting(light.mix(colors), light.size());
            let light = Arc::downgrade(light);
            *self = Kept { light, colors: colors.to_vec(), base: base.clone(), layers: BTreeMap::new() };
            return base;
        }
        let mut sum = self.base.clone();
        for (number, by) in changes {
            let own = || light.layer(number).map(|layer| fitting(layer, light.size())).unwrap_or_default();
            let layer = self.layers.entry(number).or_insert_with(own);
            // What is taken away may be a last place more than there was.
            let add = |sum: &mut Rgb, layer: &Rgb| *sum = (*sum + *layer * by).map(|v| v.max(0.0));
            sum.iter_mut().zip(layer.iter()).for_each(|(sum, layer)| add(sum, layer));
        }
        sum
    }
}

fn fitting(radiance: Vec<Rgb>, size: [u32; 2]) -> Vec<Rgb> {
    if is_large(size) { halved(&radiance, size[0] as usize) } else { radiance }
}

/// A picture of half the edges: each pixel is the mean of those that were in its place.
fn halved(radiance: &[Rgb], width: usize) -> Vec<Rgb> {
    let mean = |rows: &[Rgb], x: usize| {
        let block = rows.chunks(width).flat_map(|row| &row[x..width.min(x + 2)]);
        let (sum, count) = block.fold((Rgb::BLACK, 0.0), |(sum, count), c| (sum + *c, count + 1.0));
        sum * (1.0 / count)
    };
    let pairs = radiance.chunks(2 * width.max(1));
    pairs.flat_map(|rows| (0..width).step_by(2).map(move |x| mean(rows, x))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use lampyris::backend::Settings;
    use lampyris::cpu::Cpu;
    use lampyris::import;
    use lampyris::scene::{Camera, Edit};
    use lampyris::session::Session;
    use lampyris::world::World;

    /// The mean of a half is that of the whole where blocks are whole, and a block at the rim is that of its rest.
    #[test]
    fn half_a_picture_is_as_bright_as_all_of_it() {
        for [width, height] in [[1, 1], [2, 2], [5, 3], [6, 4], [7, 8]] {
            let at = |k: u32| Rgb::new((k % width) as f32, (k / width) as f32, 1.0);
            let own = halved(&(0..width * height).map(at).collect::<Vec<_>>(), width as usize);
            let half = width.div_ceil(2);
            assert_eq!(own.len() as u32, half * height.div_ceil(2));
            for (k, mean) in (0..).zip(own) {
                // Of 2k and 2k + 1, if both are there.
                let middle = |k: u32, edge: u32| (2 * k + (2 * k + 1).min(edge - 1)) as f32 / 2.0;
                assert_eq!(mean, Rgb::new(middle(k % half, width), middle(k / half, height), 1.0));
            }
        }
    }

    /// However levels change, one by one or all, up or down or to nothing: what is kept gives what the whole mix gives.
    #[test]
    fn what_is_kept_gives_the_whole_mix() {
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/office.mgf");
        let loaded = import::load(&file, &import::Options::default()).unwrap();
        let cpu = Cpu::new(Some(1)).unwrap();
        let mut world = cpu.install(|| World::new(loaded.scene));
        cpu.install(|| world.separate(16)).unwrap();
        let (eye, target, up) = ([0.6, 0.4, 1.6].into(), [4.0, 2.4, 0.8].into(), [0.0, 0.0, 1.0].into());
        let camera = Camera { name: "in".into(), eye, target, up, fov_y: 65.0 };
        world.apply(&Edit::View { camera: Some(camera) }).unwrap();
        let mut session = Session::begin(cpu, world, [24, 16], &Settings::interactive()).unwrap();
        let mut kept = Kept::default();
        for batch in 0..3 {
            assert!(session.step_while(&|| true).unwrap());
            let still = Arc::new(session.frame().unwrap().still());
            let mut colors = still.colors();
            for turn in 0..40_usize {
                let level = [0.0, 0.3, 1.7, 1.0][turn % 4];
                let moved = if turn % 13 == 12 { colors.len() } else { 1 + turn % 2 };
                for k in 0..moved {
                    let number = (turn / 5 + k) % colors.len();
                    colors[number] = Rgb::new(level, 0.9 * level, 0.5 * level);
                }
                let (own, whole) = (kept.mix(&still, &colors), still.mix(&colors));
                let most = whole.iter().fold(0.0, |most: f32, c| most.max(c.max_channel()));
                for (own, whole) in own.iter().zip(whole) {
                    let far = (*own - whole).map(f32::abs).max_channel();
                    assert!(far <= 1e-5 * most, "batch {batch}, turn {turn}: {own:?} is not {whole:?}");
                }
            }
        }
    }
}
