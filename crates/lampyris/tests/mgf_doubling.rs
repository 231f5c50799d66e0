//! Twice the file, about twice the time. In a binary of its own, since tests beside it would disturb the clock.

mod mgf_support;

use lampyris::import::{Options, load};
use mgf_support::Folder;
use std::time::{Duration, Instant};

const SQUARE: &str = "v a =\np 0 0 0\nv b =\np 1 0 0\nv c =\np 1 1 0\nv d =\np 0 1 0\n";

/// What it is, its size, and how to make it of a size.
type Case<'a> = (&'a str, usize, &'a dyn Fn(usize) -> String);

/// The best of five loads of each, taken in turn so that a busy machine slows both.
fn costs(texts: [String; 2]) -> [Duration; 2] {
    let folder = Folder::new();
    let paths = texts.map(|text| folder.write(&format!("{}.mgf", text.len()), text));
    let mut best = [Duration::MAX; 2];
    for _ in 0..5 {
        for (best, path) in best.iter_mut().zip(&paths) {
            let start = Instant::now();
            load(path, &Options::default()).unwrap();
            *best = start.elapsed().min(*best);
        }
    }
    best
}

#[test]
fn doubling_a_file_about_doubles_its_time() {
    let polygon = |n: usize| {
        let zigzag = |k: usize| if k.is_multiple_of(2) { 0.0 } else { 1.0 + (k % 7) as f64 };
        let points: String = (0..n).map(|k| format!("v {k} =\np {k} {} 0\n", zigzag(k) + 10.0)).collect();
        let names: String = (0..n).rev().map(|k| format!(" {k}")).collect();
        format!("{points}v l =\np 0 -1 0\nv r =\np {n} -1 0\nf l r{names}\n")
    };
    let cases: [Case; 7] = [
        ("lines", 50_000, &|n| format!("{SQUARE}{}", "f a b c\n".repeat(n))),
        ("names", 25_000, &|n| (0..n).map(|k| format!("v v{k} =\nm m{k} =\nc c{k} =\n")).collect()),
        ("polygon", 30_000, &polygon),
        ("objects", 25_000, &|n| format!("{SQUARE}{}{}", "o thing\nf a b c\n".repeat(n), "o\n".repeat(n))),
        ("transforms", 25_000, &|n| {
            format!("{SQUARE}{}f a b c\n{}", "xf -rx 1\n".repeat(n), "xf\n".repeat(n))
        }),
        ("unknown", 25_000, &|n| (0..n).map(|k| format!("x{k}\n")).collect()),
        ("array", 25_000, &|n| format!("{SQUARE}xf -a {n} -t 1e-3 0 0\nf a b c\nxf\n")),
    ];
    for (name, n, make) in cases {
        let [single, double] = costs([make(n), make(2 * n)]);
        let ratio = double.as_secs_f64() / single.as_secs_f64();
        // Tables that outgrow a cache cost a little more than twice; what is quadratic costs four times.
        assert!(ratio < 3.2 && double < Duration::from_secs(10), "{name}: {single:?} then {double:?}");
    }
}
