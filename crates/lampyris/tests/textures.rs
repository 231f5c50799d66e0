//! Looking up a place in a picture: pixel centres, borders and everything beyond them.

use glam::Vec2;
use lampyris::texture::{Encoding, Filter, Image, Pixels, Texture, Wrap, linear};

const SIZE: [u32; 2] = [5, 3];

fn image() -> Image {
    let pixel = |k: u32| [k as f32, (k * k) as f32, 1.0];
    let pixels = Pixels::Float((0..SIZE[0] * SIZE[1]).map(pixel).collect());
    Image { name: String::new(), width: SIZE[0], height: SIZE[1], pixels }
}

fn texture(wrap: Wrap, filter: Filter) -> Texture {
    Texture { image: 0, encoding: Encoding::Linear, wrap: [wrap; 2], filter }
}

fn centre(x: i32, y: i32) -> Vec2 {
    Vec2::new((x as f32 + 0.5) / SIZE[0] as f32, (y as f32 + 0.5) / SIZE[1] as f32)
}

/// Which pixel stands at `i` outside the picture.
fn inside(i: i32, size: u32, wrap: Wrap) -> u32 {
    let n = size as i32;
    (match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::Clamp => i.clamp(0, n - 1),
        Wrap::Mirror => {
            let k = i.rem_euclid(2 * n);
            if k < n { k } else { 2 * n - 1 - k }
        }
    }) as u32
}

const WRAPS: [Wrap; 3] = [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp];

/// At centres both filters give the pixel, wherever it comes from; half way between, the linear one gives the mean.
#[test]
fn centres_and_middles_with_every_wrap() {
    let image = image();
    for wrap in WRAPS {
        let at = |x: i32, y: i32| (inside(y, SIZE[1], wrap) * SIZE[0] + inside(x, SIZE[0], wrap)) as f32;
        for (x, y) in (-12..17).flat_map(|x| (-8..11).map(move |y| (x, y))) {
            for filter in [Filter::Linear, Filter::Nearest] {
                let [r, g, b, a] = texture(wrap, filter).at(&image, centre(x, y));
                let expected = at(x, y);
                assert!((r - expected).abs() < 1e-4, "{wrap:?} {filter:?} {x} {y}: {r} {expected}");
                assert!((g - expected * expected).abs() < 1e-2 && (b - 1.0).abs() < 1e-6 && a == 1.0);
            }
            let middle = (centre(x, y) + centre(x + 1, y + 1)) * 0.5;
            let [r, ..] = texture(wrap, Filter::Linear).at(&image, middle);
            let expected = 0.25 * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1));
            assert!((r - expected).abs() < 1e-4, "{wrap:?} {x} {y}: {r} {expected}");
        }
    }
}

/// Bytes are linear before they are mixed: black and white make one half, not what byte 128 stands for.
#[test]
fn bytes_are_made_linear_first() {
    let pixels = Pixels::Byte(vec![[0, 0, 0, 0], [255, 255, 255, 255]]);
    let image = Image { name: String::new(), width: 2, height: 1, pixels };
    let colour = Texture { encoding: Encoding::Srgb, ..texture(Wrap::Clamp, Filter::Linear) };
    assert_eq!(colour.at(&image, Vec2::new(0.5, 0.5)), [0.5; 4]);
    let single = |v| Image { width: 1, pixels: Pixels::Byte(vec![[v, v, v, v]]), ..image.clone() };
    for v in [1, 10, 11, 128, 254] {
        let number = f32::from(v) / 255.0;
        let [r, _, _, a] = colour.at(&single(v), Vec2::ZERO);
        // Alpha is linear always.
        assert!(r == linear(v) && (a - number).abs() < 1e-6);
        let [r, ..] = texture(Wrap::Clamp, Filter::Linear).at(&single(v), Vec2::ZERO);
        assert!((r - number).abs() < 1e-6);
    }
}

#[test]
fn no_place_is_outside() {
    let image = image();
    let wild =
        [0.0, -0.0, 1.0, -1.0, 1e30, -1e30, f32::NAN, f32::INFINITY, f32::MIN_POSITIVE, 1.0 - f32::EPSILON];
    for wrap in WRAPS {
        for filter in [Filter::Linear, Filter::Nearest] {
            for (u, v) in wild.iter().flat_map(|u| wild.iter().map(move |v| (*u, *v))) {
                let [r, ..] = texture(wrap, filter).at(&image, Vec2::new(u, v));
                assert!((0.0..=14.0).contains(&r), "{u} {v}: {r}");
            }
        }
    }
}

#[test]
fn figures_of_a_whole_picture() {
    let image = image();
    assert!((image.mean(Encoding::Linear)[0] - 7.0).abs() < 1e-6 && image.least(Encoding::Linear, 2) == 1.0);
    // Columns of black and white, far more than are looked at.
    let (width, height) = (2048, 1024);
    let pixels = (0..width * height).map(|k| if k % 2 == 0 { [0; 4] } else { [255; 4] }).collect();
    let columns = Image { name: String::new(), width, height, pixels: Pixels::Byte(pixels) };
    assert!((columns.mean(Encoding::Srgb)[1] - 0.5).abs() < 0.01 && columns.least(Encoding::Srgb, 3) == 0.0);
    assert!(columns.is_sound() && !Image { height: 5, ..columns }.is_sound());
}
