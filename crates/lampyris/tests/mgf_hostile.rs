//! MGF files that mean harm, or are merely broken: nothing panics, nothing is opened outside the root, and whatever
//! multiplies meets a limit.

mod mgf_support;

use lampyris::Error;
use lampyris::import::{Limits, Options, load};
use mgf_support::{Folder, load_text, load_with};
use std::time::{Duration, Instant};

const SQUARE: &str = "v a =\np 0 0 0\nn 0 0 1\nv b =\np 1 0 0\nv c =\np 1 1 0\nv d =\np 0 1 0\n";

fn limited(set: impl FnOnce(&mut Limits)) -> Options {
    let mut options = Options::default();
    set(&mut options.limits);
    options
}

/// Loads at the limit, is refused with the option's name one above.
fn assert_limit(
    option: &str,
    limit: u64,
    set: fn(&mut Limits, u64),
    attempt: impl Fn(&Options) -> lampyris::Result<()>,
) {
    attempt(&limited(|l| set(l, limit))).unwrap_or_else(|e| panic!("{option} at {limit}: {e}"));
    match attempt(&limited(|l| set(l, limit - 1))) {
        Err(Error::OverLimit { option: named, limit: told, .. }) => {
            assert_eq!((named, told), (option, limit - 1))
        }
        other => panic!("{option} one above {}: {other:?}", limit - 1),
    }
}

fn text(text: String) -> impl Fn(&Options) -> lampyris::Result<()> {
    move |options| load_with(&text, options).map(drop)
}

#[test]
fn every_limit_holds_exactly() {
    assert_limit("--max-file-bytes", 500, |l, n| l.file_bytes = n, text("# ".to_string() + &"x".repeat(498)));
    for (shape, triangles) in [
        ("f a b c", 1),
        ("f a b c d", 2),
        ("sph a 1", 360),
        ("ring a 0 1", 20),
        ("torus a 1 2", 800),
        ("cone a 1 b 0", 20),
        ("fh a b c d - a b c", 7),
    ] {
        let twice = format!("{SQUARE}{shape}\n{shape}\n");
        assert_limit("--max-triangles", 2 * triangles, |l, n| l.triangles = n, text(twice));
    }
    assert_limit("--max-triangles", 12, |l, n| l.triangles = n, text(format!("{SQUARE}prism a b c d 1\n")));
    // Nine lines of the square, the array's begin, then its block and end seven times; blank lines are free.
    let array = format!("{SQUARE}\nxf -a 7 -t 1 0 0\nf a b c\n\nxf\n");
    assert_limit("--max-entities", 9 + 1 + 2 * 7, |l, n| l.entities = n, text(array));
    assert_limit("--max-array", 60, |l, n| l.array = n, text("xf -a 3 -a 4\nxf -i 9 -a 5\nxf\nxf\n".into()));
    assert_limit("--max-polygon", 5, |l, n| l.polygon = n, text(format!("{SQUARE}f a b c d a\n")));
    assert_limit("--max-polygon", 7, |l, n| l.polygon = n, text(format!("{SQUARE}fh a b c d - a b c\n")));
    assert_limit("--max-polygon", 4, |l, n| l.polygon = n, text(format!("{SQUARE}prism a b c d 1\n")));
    let folder = Folder::new();
    for k in 0..9 {
        folder.write(&format!("{k}.mgf"), format!("i {}.mgf\n", k + 1));
    }
    let main = folder.write("9.mgf", "").with_file_name("0.mgf");
    assert_limit("--max-include-depth", 9, |l, n| l.include_depth = n, |o| load(&main, o).map(drop));
}

#[test]
fn the_defaults_are_those_of_the_manual() {
    let l = Limits::default();
    assert_eq!((l.include_depth, l.array, l.polygon), (16, 10_000_000, 65_536));
    assert_eq!((l.triangles, l.entities, l.file_bytes), (50_000_000, 50_000_000, 4 << 30));
}

fn assert_over(result: lampyris::Result<lampyris::import::Loaded>, option: &str) {
    match result {
        Err(Error::OverLimit { option: named, .. }) => assert_eq!(named, option),
        other => panic!("{option}: {other:?}"),
    }
}

#[test]
fn what_multiplies_is_refused_in_time() {
    let start = Instant::now();
    let nested = "xf -a 1000 -t 1 0 0\n".repeat(20);
    assert_over(load_text(format!("{SQUARE}{nested}f a b c\n")), "--max-array");
    assert_over(load_text("xf -a 18446744073709551615 -a 2\n"), "--max-array");
    // A thousand huge spheres, refused by counting.
    let fine = Options { circle_steps: 4096, ..Options::default() };
    assert_over(load_with(format!("{SQUARE}xf -a 1000 -t 1 0 0\nsph a 1\nxf\n"), &fine), "--max-triangles");
    // Files that include the next ten times each, sixteen deep.
    let folder = Folder::new();
    for k in 0..16 {
        folder.write(&format!("{k}.mgf"), format!("i {}.mgf\n", k + 1).repeat(10));
    }
    let main = folder.write("16.mgf", "").with_file_name("0.mgf");
    assert_over(load(&main, &limited(|l| l.entities = 100_000)), "--max-entities");
    // A long comment read again and again costs as much as many short lines.
    let long = format!("xf -a 100000 -t 1 0 0\n# {}\nxf\n", "x".repeat(1_000_000));
    assert_over(load_with(long, &limited(|l| l.entities = 100_000)), "--max-entities");
    let blank = format!("xf -a 1000000 -t 1 0 0\n{}xf\n", "\n".repeat(1_000_000));
    assert_over(load_with(blank, &limited(|l| l.entities = 100_000)), "--max-entities");
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
}

#[test]
fn files_that_include_themselves_are_refused() {
    let folder = Folder::new();
    folder.write("main.mgf", "i part.mgf\n");
    folder.write("part.mgf", "i ./main.mgf -t 1 0 0\n");
    let text = folder.load("main.mgf").unwrap_err().to_string();
    assert!(text.contains("part.mgf:line 1: \"./main.mgf\" includes itself"), "{text}");
}

#[test]
fn a_line_is_a_mebibyte_at_most() {
    let line = |bytes: usize| format!("# {}\n", "x".repeat(bytes - 2));
    let loaded = load_text(line(1 << 20)).unwrap();
    assert!(loaded.warnings[0].contains("longer than the 4096"), "{:?}", loaded.warnings);
    assert!(load_text(line((1 << 20) + 1)).is_err());
    assert!(load_text(line(4096)).unwrap().warnings.is_empty());
    assert!(!load_text(line(4097)).unwrap().warnings.is_empty());
}

#[cfg(unix)]
#[test]
fn nothing_outside_the_root_is_opened() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    folder.write("secret.mgf", "rd CANARY\n");
    folder.write("scene/sub/inner.mgf", "");
    folder.write("scene/main.mgf", "");
    let at = |name: &str| folder.0.join("scene").join(name);
    symlink("../secret.mgf", at("link.mgf")).unwrap();
    symlink("..", at("up")).unwrap();
    symlink("/dev/zero", at("zero.mgf")).unwrap();
    symlink("loop.mgf", at("loop.mgf")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(at("pipe.mgf")).status().unwrap().success());
    let absolute = folder.0.join("secret.mgf").display().to_string();
    let own = at("sub/inner.mgf").display().to_string();
    for name in [
        "../secret.mgf",
        "sub/../../secret.mgf",
        "sub/../../scene/sub/inner.mgf",
        "../missing.mgf",
        "link.mgf",
        "up/secret.mgf",
        "up/scene/../secret.mgf",
        "zero.mgf",
        "loop.mgf",
        "pipe.mgf",
        "sub",
        ".",
        "..",
        "/etc/passwd",
        "/dev/zero",
        &absolute,
        &own,
        "//etc/passwd",
        "C:\\secret.mgf",
        "c:secret.mgf",
        "\\\\host\\secret.mgf",
        "file:///etc/passwd",
        "http://host/secret.mgf",
        "..\\secret.mgf",
        "%2e%2e/secret.mgf",
        "sub/inner.mgf/../../../secret.mgf",
        "main.mgf/",
        "a\0b",
        "~/secret.mgf",
    ] {
        std::fs::write(at("main.mgf"), format!("i {name}\n")).unwrap();
        let text = folder.load("scene/main.mgf").expect_err(name).to_string();
        assert!(!text.contains("CANARY") && text.contains("main.mgf:line 1: "), "{name}: {text}");
    }
    // The way out names the mend, and does not tell whether anything is there.
    let refused = |name: &str| {
        std::fs::write(at("main.mgf"), format!("i {name}\n")).unwrap();
        folder.load("scene/main.mgf").unwrap_err().to_string().replace(name, "NAME")
    };
    assert_eq!(refused("../secret.mgf"), refused("../missing.mgf"));
    assert!(refused("../secret.mgf").contains("--root"));
    // What stays inside is read, by any way.
    for name in ["sub/inner.mgf", "./sub/./inner.mgf", "sub/../sub/inner.mgf"] {
        std::fs::write(at("main.mgf"), format!("i {name}\n")).unwrap();
        folder.load("scene/main.mgf").unwrap();
    }
}

#[cfg(unix)]
#[test]
fn a_wider_root_lets_more_in() {
    let folder = Folder::new();
    folder.write("lib.mgf", SQUARE);
    let main = folder.write("scene/main.mgf", "i ../lib.mgf\nf a b c\n");
    assert!(load(&main, &Options::default()).is_err());
    let wide = Options { root: Some(folder.0.clone()), ..Options::default() };
    assert_eq!(load(&main, &wide).unwrap().scene.summary().triangles, 1);
    // A root beside the scene is refused, and so are scenes that are no files.
    let other = Options { root: Some(folder.0.join("scene/nowhere")), ..Options::default() };
    assert!(load(&main, &other).is_err());
    std::fs::create_dir(folder.0.join("other")).unwrap();
    let beside = Options { root: Some(folder.0.join("other")), ..Options::default() };
    assert!(load(&main, &beside).unwrap_err().to_string().contains("--root"));
    std::fs::create_dir(folder.0.join("dir.mgf")).unwrap();
    assert!(load(&folder.0.join("dir.mgf"), &Options::default()).is_err());
    assert!(load(&folder.0.join("missing.mgf"), &Options::default()).is_err());
}

/// Three files of about a kilobyte that use every entity.
fn seeds() -> [String; 3] {
    let colors = "c red =\n\tcxy .6 .3\nc lamp =\n\tcct 2900\nc k =\n\tcspec 400 700 1 2 3 \\\n 2 1\nc mixed = red\n\tcmix .3 red .7 lamp\n";
    let materials = "m wall =\n\tc red\n\trd .4\n\trs .05 .1\nm lamp =\n\tc lamp\n\tsides 1\n\ted 1e4\nm glass =\n\tsides 1\n\tir 1.52 0\n\tc\n\tts .85 0\n\trs .08 0\nm sail = wall\n\ttd .2\n";
    let shapes = "v o =\n\tp 0 0 0\n\tn 0 0 1\nv u =\n\tp 0 0 2\no room\nm wall\nf a b c d\nfh a b c - d o u\no lamp\nm lamp\nsph o .25\ncyl o .1 u\ncone o 1 u .5\n\no\nprism a b c d 1.5\nring o 0 1\ntorus o .2 .4\no\n";
    let placed = "xf -rx 30 -t 1 2 3\nxf -a 3 -t 1 0 0 -a 2 -ry 15 -i 2 -s .5 -mx\nm sail\nf a b c\nxf\ni part.mgf -t 0 0 5\nies lamp.ies -m 2\nxf\nodd entity\n";
    let pad = |s: String| {
        let missing = 1024usize.saturating_sub(s.len());
        format!("{s}# {}\n", "end ".repeat(missing / 4))
    };
    [
        pad(format!("{colors}{materials}{SQUARE}f a b c\n")),
        pad(format!("{SQUARE}{materials}{shapes}").replace("\tc red\n", "").replace("\tc lamp\n", "")),
        pad(format!("# placed\r\n{SQUARE}m sail =\r\ntd .5\n{placed}")),
    ]
}

/// `folder::mutate`, and what loads must be sound.
fn mutate(folder: &Folder, seed: &[u8]) -> (usize, usize) {
    let options = limited(|l| {
        *l = Limits { triangles: 100_000, entities: 20_000, array: 1000, ..*l };
    });
    mgf_support::folder::mutate(folder, "mgf", seed, &options, |loaded| {
        for mesh in &loaded.scene.meshes {
            assert!(mesh.positions.iter().chain(&mesh.normals).all(|p| p.is_finite()));
            assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
            assert_eq!(mesh.triangles.len(), mesh.materials.len());
            assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.positions.len());
        }
    })
}

#[test]
fn broken_files_never_panic() {
    let folder = Folder::new();
    folder.write("part.mgf", "sph a .5\n");
    for seed in seeds() {
        load(&folder.write("main.mgf", &seed), &Options::default()).unwrap();
        let (good, all) = mutate(&folder, seed.as_bytes());
        assert!(all > 9000 && good > all / 10, "{good} of {all} loaded: the seeds must not break at once");
    }
}

#[test]
#[ignore = "needs LAMPYRIS_SCENES"]
fn broken_published_files_never_panic() {
    let folder = Folder::new();
    for name in ["cube.mgf", "corridor.mgf", "examp1.mgf"] {
        let (good, all) = mutate(&folder, &std::fs::read(mgf_support::scenes().join(name)).unwrap());
        assert!(good > all / 10, "{name}: {good} of {all} loaded");
    }
}
