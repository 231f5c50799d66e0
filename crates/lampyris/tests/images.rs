//! Pictures through the gate: what is read, by which numbers, and that no file asks for more than it is granted.
#![cfg(feature = "pictures")]

use exr::prelude::WritableImage;
use image::codecs::{jpeg::JpegEncoder, png::PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use lampyris::import::Limits;
use lampyris::import::image::{Gate, Refusal};
use lampyris::texture::{Image, Pixels};

const WIDTH: u32 = 12;
const HEIGHT: u32 = 7;

/// A value for each pixel and channel.
fn value(x: u32, y: u32, c: u32) -> u8 {
    (x * 20 + y * 7 + c * 50) as u8
}

fn png(color: ExtendedColorType, bytes_a_pixel: u32) -> Vec<u8> {
    let each = |k: u32| value(k / bytes_a_pixel % WIDTH, k / bytes_a_pixel / WIDTH, k % bytes_a_pixel);
    let raw: Vec<u8> = (0..WIDTH * HEIGHT * bytes_a_pixel).map(each).collect();
    let mut file = Vec::new();
    PngEncoder::new(&mut file).write_image(&raw, WIDTH, HEIGHT, color).unwrap();
    file
}

fn jpeg(color: ExtendedColorType, channels: u32) -> Vec<u8> {
    let raw: Vec<u8> = (0..WIDTH * HEIGHT * channels)
        .map(|k| value(k / channels % WIDTH, k / channels / WIDTH, 0))
        .collect();
    let mut file = Vec::new();
    JpegEncoder::new_with_quality(&mut file, 100).encode(&raw, WIDTH, HEIGHT, color).unwrap();
    file
}

fn float(x: u32, y: u32) -> [f32; 3] {
    [0, 1, 2].map(|c| f32::from(value(x, y, c)) * 0.25 + 0.125)
}

fn hdr() -> Vec<u8> {
    let pixels: Vec<image::Rgb<f32>> =
        (0..WIDTH * HEIGHT).map(|k| image::Rgb(float(k % WIDTH, k / WIDTH))).collect();
    let mut file = Vec::new();
    let encoder = image::codecs::hdr::HdrEncoder::new(&mut file);
    encoder.encode(&pixels, WIDTH as usize, HEIGHT as usize).unwrap();
    file
}

fn exr() -> Vec<u8> {
    let channels = exr::prelude::SpecificChannels::rgb(|at: exr::math::Vec2<usize>| {
        let [r, g, b] = float(at.0 as u32, at.1 as u32);
        (r, g, b)
    });
    let mut file = std::io::Cursor::new(Vec::new());
    exr::prelude::Image::from_channels((WIDTH as usize, HEIGHT as usize), channels)
        .write()
        .to_buffered(&mut file)
        .unwrap();
    file.into_inner()
}

fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("png", png(ExtendedColorType::Rgba8, 4)),
        ("jpeg", jpeg(ExtendedColorType::Rgb8, 3)),
        ("hdr", hdr()),
        ("exr", exr()),
    ]
}

fn decode(file: &[u8]) -> Image {
    Gate::new(Limits::default()).admit(file).expect("admitted").decode("name").expect("decoded")
}

fn bytes(image: &Image) -> &[[u8; 4]] {
    match &image.pixels {
        Pixels::Byte(pixels) => pixels,
        Pixels::Float(_) => panic!("floats"),
    }
}

fn at(k: usize) -> (u32, u32) {
    (k as u32 % WIDTH, k as u32 / WIDTH)
}

#[test]
fn png_of_every_kind() {
    for (color, depth) in [
        (ExtendedColorType::L8, 1),
        (ExtendedColorType::La8, 2),
        (ExtendedColorType::Rgb8, 3),
        (ExtendedColorType::Rgba8, 4),
    ] {
        let image = decode(&png(color, depth));
        assert_eq!((image.width, image.height, image.name.as_str()), (WIDTH, HEIGHT, "name"));
        for (k, pixel) in bytes(&image).iter().enumerate() {
            let v = |c| value(at(k).0, at(k).1, c);
            let expected = match depth {
                1 => [v(0), v(0), v(0), 255],
                2 => [v(0), v(0), v(0), v(1)],
                3 => [v(0), v(1), v(2), 255],
                _ => [v(0), v(1), v(2), v(3)],
            };
            assert_eq!(*pixel, expected, "{color:?} {k}");
        }
    }
    // Of 16 bits, in the byte order of the machine here and most significant first in the file, the upper 8.
    let wide = decode(&png(ExtendedColorType::Rgb16, 6));
    let upper = |c: u32| value(0, 0, if cfg!(target_endian = "little") { 2 * c + 1 } else { 2 * c });
    assert_eq!(bytes(&wide)[0], [upper(0), upper(1), upper(2), 255]);
}

#[test]
fn jpeg_grey_and_coloured() {
    for (color, channels) in [(ExtendedColorType::L8, 1), (ExtendedColorType::Rgb8, 3)] {
        let image = decode(&jpeg(color, channels));
        assert_eq!((image.width, image.height), (WIDTH, HEIGHT));
        for (k, pixel) in bytes(&image).iter().enumerate() {
            let expected = value(at(k).0, at(k).1, 0);
            assert!(pixel[..3].iter().all(|v| v.abs_diff(expected) <= 4), "{k}: {pixel:?} {expected}");
            assert_eq!(pixel[3], 255);
        }
    }
}

#[test]
fn floats_keep_their_light() {
    for (name, file, precision) in [("hdr", hdr(), 1.0 / 128.0), ("exr", exr(), 0.0)] {
        let image = decode(&file);
        let Pixels::Float(pixels) = &image.pixels else { panic!("{name}: bytes") };
        assert_eq!(pixels.len(), (WIDTH * HEIGHT) as usize);
        for (k, pixel) in pixels.iter().enumerate() {
            let expected = float(at(k).0, at(k).1);
            let brightest = expected.iter().fold(0.0f32, |a, b| a.max(*b));
            for (got, expected) in pixel.iter().zip(expected) {
                assert!((got - expected).abs() <= brightest * precision, "{name} {k}: {got} {expected}");
            }
        }
    }
}

/// What the program writes, it reads: long rows with runs, and narrow ones without.
#[test]
fn hdr_in_all_three_encodings() {
    let head =
        |w: usize, h: usize| format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {h} +X {w}\n").into_bytes();
    let read = |file: Vec<u8>| match decode(&file).pixels {
        Pixels::Float(pixels) => pixels,
        Pixels::Byte(_) => panic!("bytes"),
    };
    let (a, b) = ([128, 64, 0, 129], [1, 255, 7, 130]);
    let light = |[r, g, b, e]: [u8; 4]| {
        [r, g, b].map(|m| (f32::from(m) + 0.5) / 256.0 * 2f32.powi(i32::from(e) - 128))
    };
    let plain = [head(2, 1), a.to_vec(), b.to_vec()].concat();
    assert_eq!(read(plain), [light(a), light(b)]);
    let repeated = [head(4, 1), a.to_vec(), vec![1, 1, 1, 2], b.to_vec()].concat();
    assert_eq!(read(repeated), [light(a), light(a), light(a), light(b)]);
    // 0x0103 times more: two counts in a row.
    let many = [head(0x105, 1), a.to_vec(), vec![1, 1, 1, 3, 1, 1, 1, 1], b.to_vec()].concat();
    assert_eq!(read(many), [vec![light(a); 0x104], vec![light(b)]].concat());
    let mut runs = [head(8, 1), vec![2, 2, 0, 8]].concat();
    for k in 0..4 {
        runs.extend([131, a[k], 2, b[k], a[k], 131, b[k]]);
    }
    let expected = [vec![a; 3], vec![b, a], vec![b; 3]].concat();
    assert_eq!(read(runs), expected.into_iter().map(light).collect::<Vec<_>>());
}

/// Six hundred suns are enough, there is no light less than none, and what is no number is dark.
#[test]
fn floats_are_held_within_bounds() {
    let rgbe = [b"#?RGBE\n\n-Y 1 +X 1\n".as_slice(), &[255; 4]].concat();
    assert_eq!(decode(&rgbe).pixels, Pixels::Float(vec![[1e12; 3]]));
    let values = [f32::NAN, f32::INFINITY, -1.0, f32::MAX, 0.5];
    let channels =
        exr::prelude::SpecificChannels::rgb(|at: exr::math::Vec2<usize>| (values[at.0], 0.0f32, 1.0f32));
    let mut file = std::io::Cursor::new(Vec::new());
    exr::prelude::Image::from_channels((5, 1), channels).write().to_buffered(&mut file).unwrap();
    let expected = [0.0, 0.0, 0.0, 1e12, 0.5].map(|r| [r, 0.0, 1.0]);
    assert_eq!(decode(&file.into_inner()).pixels, Pixels::Float(expected.to_vec()));
}

/// A run that leaves its row, and a repetition of nothing.
#[test]
fn hdr_runs_stay_in_their_rows() {
    let head = |w: usize| format!("#?RGBE\n\n-Y 1 +X {w}\n").into_bytes();
    for rest in [vec![2, 2, 0, 8, 255, 1], vec![1, 1, 1, 1, 0, 0, 0, 0], vec![9, 9, 9, 9, 1, 1, 1, 255]] {
        let file = [head(8), rest].concat();
        let admitted = Gate::new(Limits::default()).admit(&file).unwrap();
        assert!(admitted.decode("").is_err());
    }
}

#[test]
fn foreign_formats_are_named() {
    let named = |start: &[u8]| match Gate::new(Limits::default()).admit(start) {
        Err(Refusal::Unreadable(reason)) => reason,
        other => panic!("{other:?}"),
    };
    assert!(named(b"\xabKTX 20\xbb\r\n\x1a\n").starts_with("KTX2 "));
    assert!(named(b"RIFF\0\0\0\0WEBPVP8 ").starts_with("WebP "));
    assert!(named(b"DDS |").starts_with("DDS "));
    assert!(named(b"hello").starts_with("no picture"));
    assert!(named(b"").starts_with("no picture"));
}

fn refusal(limits: Limits, files: &[&[u8]]) -> Option<Refusal> {
    let mut gate = Gate::new(limits);
    files.iter().find_map(|f| gate.admit(f).err())
}

#[test]
fn limits_at_the_limit_and_one_below() {
    for (name, file) in seeds() {
        let depth = if matches!(name, "png" | "jpeg") { 4 } else { 12 };
        let pixels = u64::from(WIDTH * HEIGHT);
        let twice = [file.as_slice(); 2];
        let with = |image_pixels, image_bytes| Limits { image_pixels, image_bytes, ..Limits::default() };
        assert_eq!(refusal(with(pixels, 2 * depth * pixels), &twice), None, "{name}");
        let option = |limits| match refusal(limits, &twice) {
            Some(Refusal::OverLimit { option, .. }) => option,
            other => panic!("{name}: {other:?}"),
        };
        assert_eq!(option(with(pixels - 1, u64::MAX)), "--max-image-pixels");
        assert_eq!(option(with(pixels, 2 * depth * pixels - 1)), "--max-image-bytes");
    }
}

/// A PNG's header alone: no decoder need be asked.
fn png_header(width: u32, height: u32) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    file.extend(width.to_be_bytes());
    file.extend(height.to_be_bytes());
    file
}

#[test]
fn sides_and_bombs() {
    let all = Limits { image_pixels: u64::MAX, image_bytes: u64::MAX, ..Limits::default() };
    let refused = |file: Vec<u8>| matches!(refusal(all, &[&file]), Some(Refusal::Unreadable(_)));
    assert!(!refused(png_header(65_536, 1)));
    assert!(refused(png_header(65_537, 1)) && refused(png_header(1, 65_537)) && refused(png_header(0, 1)));
    // 64 MiB may come from anything; beyond, a byte of the file stands for 2000 at most.
    assert!(!refused(png_header(4096, 4096)));
    assert!(refused(png_header(4096, 4097)));
    let needed = 4096 * 4097 * 4 / 2000;
    let padded = |length: usize| [png_header(4096, 4097), vec![0; length]].concat()[..length].to_vec();
    assert!(!refused(padded(needed)) && refused(padded(needed - 1)));
}

/// The header of an OpenEXR of one part with the attributes given beside a data window.
fn exr_header(window: [i32; 4], compression: u8, channels: usize) -> Vec<u8> {
    let mut file = b"\x76\x2f\x31\x01\x02\0\0\0".to_vec();
    let mut attribute = |name: &str, kind: &str, value: Vec<u8>| {
        file.extend([name.as_bytes(), b"\0", kind.as_bytes(), b"\0"].concat());
        file.extend((value.len() as u32).to_le_bytes());
        file.extend(value);
    };
    let corners: Vec<u8> = window.iter().flat_map(|c| c.to_le_bytes()).collect();
    attribute("dataWindow", "box2i", corners);
    attribute("compression", "compression", vec![compression]);
    let channel = [b"R\0\x01\0\0\0".as_slice(), &[0; 4], &1u32.to_le_bytes(), &1u32.to_le_bytes()].concat();
    attribute("channels", "chlist", [channel.repeat(channels), vec![0]].concat());
    file.push(0);
    file
}

#[test]
fn openexr_headers_are_held_to_their_file() {
    let admitted = |file: &[u8]| refusal(Limits::default(), &[file]).is_none();
    let small = [0, 0, 15, 15];
    assert!(admitted(&exr_header(small, 3, 256)));
    assert!(!admitted(&exr_header(small, 3, 257)));
    assert!(!admitted(&exr_header([5, 0, 3, 0], 3, 3)), "inside out");
    let far = 1 << 24;
    assert!(admitted(&exr_header([far, 0, far, 0], 3, 3)));
    assert!(!admitted(&exr_header([far + 1, 0, far + 1, 0], 3, 3)));
    assert!(!admitted(&exr_header([i32::MIN, i32::MIN, i32::MAX, i32::MAX], 3, 3)));
    // Two windows: one for us and one for the decoder, which knows them by their type as well.
    let two = exr_header(small, 3, 3);
    let window = [b"dataWindow\0sesame\0".as_slice(), &16u32.to_le_bytes(), &[0; 16]].concat();
    assert!(!admitted(&[&two[..8], &window, &two[8..]].concat()) && admitted(&two));
    // Without a type the decoder would read on, and find another window further down.
    let untyped = [b"typ\0\0".as_slice(), &4u32.to_le_bytes(), &[0; 4]].concat();
    assert!(!admitted(&[&two[..8], &untyped, &two[8..]].concat()));
    // One block of sixteen rows holds a picture of one row, unless that asks for much more than the picture.
    let wide = |columns: i32| [exr_header([0, 0, columns - 1, 0], 3, 4), vec![0; 1 << 20]].concat();
    assert!(admitted(&wide(65_536)));
    let tiled = |edge: u32| {
        let mut file = exr_header(small, 3, 3);
        let tiles = [b"tiles\0tiledesc\0".as_slice(), &9u32.to_le_bytes()].concat();
        let description = [tiles, edge.to_le_bytes().to_vec(), edge.to_le_bytes().to_vec(), vec![0]].concat();
        file.splice(8..8, description);
        file
    };
    assert!(admitted(&tiled(1024)) && !admitted(&tiled(2048)), "12 bytes a pixel, 16 MiB");
    // 10 000 rows of single blocks have a table of 80 000 bytes.
    let tall = exr_header([0, 0, 0, 9_999], 0, 3);
    let padded = |length: usize| [tall.clone(), vec![0; length - tall.len()]].concat();
    assert!(admitted(&padded(79_992)) && !admitted(&padded(79_991)));
}

/// Every prefix, every flipped bit of the first kilobyte: an answer, and no picture larger than was granted.
#[test]
fn broken_files_are_answered() {
    let limits = Limits { image_bytes: 1 << 20, ..Limits::default() };
    let mut decoded = 0;
    let mut attempt = |file: &[u8]| {
        if let Ok(image) = Gate::new(limits).admit(file).map_err(|e| e.to_string()).and_then(|a| a.decode(""))
        {
            let pixels = image.width as usize * image.height as usize;
            let (count, bytes) = match &image.pixels {
                Pixels::Byte(p) => (p.len(), 4 * p.len()),
                Pixels::Float(p) => (p.len(), 12 * p.len()),
            };
            assert!(count == pixels && bytes <= 1 << 20);
            decoded += 1;
        }
    };
    for (_, file) in seeds() {
        (0..file.len()).for_each(|n| attempt(&file[..n]));
        for bit in 0..8 * file.len().min(1024) {
            let mut file = file.clone();
            file[bit / 8] ^= 1 << (bit % 8);
            attempt(&file);
        }
    }
    assert!(decoded > 1000, "{decoded}");
}
