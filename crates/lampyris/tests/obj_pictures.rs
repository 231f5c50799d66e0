//! Pictures of OBJ's materials: decoded by as many threads as there are, and none of it to be seen in scene or warnings.
#![cfg(feature = "pictures")]

mod folder;

use folder::Folder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use lampyris::import::{Limits, Loaded, Options, load};
use lampyris::texture::Pixels;
use lampyris::{Error, Result};

/// Pictures, the first of them the largest, so that the order of being done is not that of the file.
const PICTURES: u32 = 24;

fn side(k: u32) -> u32 {
    4 + 8 * (PICTURES - k)
}

/// A picture whose every pixel is `color`.
fn png(side: u32, color: [u8; 3]) -> Vec<u8> {
    let mut file = Vec::new();
    let raw = color.repeat((side * side) as usize);
    PngEncoder::new(&mut file).write_image(&raw, side, side, ExtendedColorType::Rgb8).unwrap();
    file
}

/// Every third picture is worn by two materials, by another spelling if it is there; every fifth is cut off, every seventh
/// is missing.
fn written() -> Folder {
    let folder = Folder::new();
    let mut library = String::new();
    for k in 0..PICTURES {
        let mut file = png(side(k), [k as u8, 1, 2]);
        if k % 5 == 4 {
            file.truncate(file.len() - 20);
        }
        if k % 7 != 6 {
            folder.write(&format!("{k}.png"), file);
        }
        library += &format!("newmtl {k}\nmap_Kd {k}.png\nmap_Bump -bm 0.5 {k}.png\n");
        if k % 3 == 2 {
            let here = if k % 7 == 6 { "" } else { "./" };
            library += &format!("newmtl {k} again\nmap_Ke {here}{k}.png\n");
        }
    }
    folder.write("grey.png", png(8, [7, 7, 7]));
    folder.write("lib.mtl", library + "newmtl rough\nbump grey.png\n");
    folder.write("more.mtl", "newmtl other\nmap_d 0.png\n");
    folder
        .write("main.obj", "mtllib lib.mtl\nmtllib more.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl 0\nf 1 2 3\n");
    folder
}

fn with(threads: usize, folder: &Folder, limits: Limits) -> Result<Loaded> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| load(&folder.0.join("main.obj"), &Options { limits, ..Options::default() }))
}

fn is_good(k: u32) -> bool {
    k % 5 != 4 && k % 7 != 6
}

#[test]
fn scene_and_warnings_are_in_the_order_of_the_file() {
    let folder = written();
    let loaded = with(1, &folder, Limits::default()).unwrap();
    let good: Vec<u32> = (0..PICTURES).filter(|k| is_good(*k)).collect();
    let images = &loaded.scene.images;
    assert_eq!(images.len(), good.len() + 1);
    for (image, k) in images.iter().zip(&good) {
        assert_eq!((image.name.as_str(), image.width), (format!("{k}.png").as_str(), side(*k)));
        assert!(matches!(&image.pixels, Pixels::Byte(p) if p[0] == [*k as u8, 1, 2, 255]));
    }
    let scene = &loaded.scene;
    let image = |map: lampyris::material::Map| scene.textures[map.texture as usize].image as usize;
    for material in &scene.materials {
        let maps = &material.maps;
        let number = material.name.split(' ').next().unwrap().parse::<u32>();
        let place = number.ok().and_then(|k| good.iter().position(|g| *g == k));
        let again = material.name.ends_with("again");
        assert_eq!(maps.color.map(image), place.filter(|_| !again), "{}", material.name);
        assert_eq!(maps.emission.map(image), place.filter(|_| again), "{}", material.name);
        let normal = place.filter(|_| !again).map(|place| (place, 0.5));
        assert_eq!(maps.normal.map(|(map, scale)| (image(map), scale)), normal, "{}", material.name);
        assert_eq!(maps.alpha.map(image), (material.name == "other").then_some(0));
    }
    // A picture that is cut off is told once however many name it, a missing one for each that does.
    let bad = (0..PICTURES).filter(|k| !is_good(*k));
    assert_eq!(loaded.warnings.len(), bad.clone().count() + 1);
    for (k, warning) in bad.zip(&loaded.warnings) {
        let missing = k % 7 == 6;
        let times = if !missing {
            ""
        } else if k % 3 == 2 {
            " (3 times)"
        } else {
            " (2 times)"
        };
        assert!(warning.contains(&format!("{k}.png\"")), "{warning}");
        assert_eq!(warning.contains("cannot open"), missing, "{warning}");
        assert!(warning.ends_with(&format!("factors stand for it{times}")), "{k}: {warning}");
    }
    assert!(loaded.warnings.last().unwrap().contains("pictures of heights"));
    for threads in [2, 5] {
        let other = with(threads, &folder, Limits::default()).unwrap();
        assert_eq!(other.warnings, loaded.warnings);
        assert_eq!(format!("{:?}", other.scene), format!("{:?}", loaded.scene), "{threads} threads");
    }
}

#[test]
fn limits_are_met_before_any_picture_is_decoded() {
    let folder = written();
    let bytes = |k: u32| 4 * u64::from(side(k) * side(k));
    // The fifth is cut off: only its header says what it would need, and that is enough to count.
    let five = (0..5).map(bytes).sum::<u64>();
    let limits = |image_bytes| Limits { image_bytes, ..Limits::default() };
    for threads in [1, 4] {
        match with(threads, &folder, limits(five)) {
            Err(Error::OverLimit { file, what, option, .. }) => {
                assert_eq!(file.file_name().unwrap(), "lib.mtl");
                assert_eq!(what, format!("{} bytes of decoded pictures", five + bytes(5)));
                assert_eq!(option, "--max-image-bytes");
            }
            other => panic!("{other:?}"),
        }
    }
    let all = (0..PICTURES).filter(|k| k % 7 != 6).map(bytes).sum::<u64>() + 4 * 64;
    assert!(with(3, &folder, limits(all)).is_ok());
    assert!(with(3, &folder, limits(all - 1)).is_err());
}
