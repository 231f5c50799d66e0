//! Takes single bright speckles out of what a display shows: the few paths by which a caustic reaches a pixel carry
//! much light each, long before their mean settles.
//! It is for eyes only: it loses light, and no file of cd/m² passes through it.

use crate::color::Rgb;

/// How many times brighter than its second brightest neighbour a pixel may be. Edges and lines one pixel wide have
/// two bright neighbours or more and stay as they are.
const OUTSTANDING: f32 = 1.5;

/// The picture with every pixel that stands out alone brought down to its second brightest neighbour.
pub(super) fn despeckle(width: u32, height: u32, radiance: &[Rgb]) -> Vec<Rgb> {
    let (w, h) = (width as usize, height as usize);
    let luminance: Vec<f32> = radiance.iter().map(|c| c.luminance()).collect();
    let calm = |k: usize| {
        let (x, y) = (k % w, k / w);
        let (mut first, mut second) = (0.0f32, 0.0f32);
        for ny in y.saturating_sub(1)..(y + 2).min(h) {
            for nx in x.saturating_sub(1)..(x + 2).min(w) {
                let v = luminance[ny * w + nx];
                if (nx, ny) != (x, y) && v > second {
                    (first, second) = if v > first { (v, first) } else { (first, v) };
                }
            }
        }
        let own = luminance[k];
        if own > OUTSTANDING * second { radiance[k] * (second / own) } else { radiance[k] }
    };
    (0..radiance.len()).map(calm).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(bright: &[(usize, usize)]) -> Vec<Rgb> {
        let mut p = vec![Rgb::grey(1.0); 8 * 6];
        bright.iter().for_each(|(x, y)| p[y * 8 + x] = Rgb::new(90.0, 100.0, 50.0));
        p
    }

    #[test]
    fn a_lone_pixel_goes_wherever_it_is() {
        for at in [(3, 3), (0, 0), (7, 5), (7, 2)] {
            let calm = despeckle(8, 6, &picture(&[at]));
            assert!(calm.iter().all(|c| (c.luminance() - 1.0).abs() < 1e-5), "{at:?}");
        }
    }

    #[test]
    fn lines_areas_and_darkness_stay() {
        let line: Vec<_> = (0..8).map(|x| (x, 2)).collect();
        let block = [(2, 2), (3, 2), (2, 3), (3, 3)];
        for kept in [&line[1..7], &block[..]] {
            let before = picture(kept);
            let after = despeckle(8, 6, &before);
            let inner = &kept[usize::from(kept.len() == 6)..kept.len() - usize::from(kept.len() == 6)];
            assert!(inner.iter().all(|(x, y)| after[y * 8 + x] == before[y * 8 + x]));
        }
        let mut dark = picture(&[]);
        dark[20] = Rgb::BLACK;
        assert_eq!(despeckle(8, 6, &dark)[20], Rgb::BLACK);
    }
}
