//! The laboratory as a script sees it: its list, its report, and what goes wrong with it.

mod support;

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::time::{Duration, Instant};
use support::{Folder, command, run};

/// The folder of the scenes that ship.
fn scenes() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").to_str().unwrap().to_owned()
}

/// Names of all experiments.
fn names(folder: &Folder) -> Vec<String> {
    let list = run(folder, "lab list --json").json();
    list.as_array().unwrap().iter().map(|row| row["name"].as_str().unwrap().to_owned()).collect()
}

/// The values of an attribute in a page.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    page.split(start.as_str()).skip(1).map(|rest| rest.split('"').next().unwrap()).collect()
}

/// Every element is closed where it must be, and no bare character of markup is in the text.
fn is_well_formed(page: &str) {
    let body = page.strip_prefix("<!DOCTYPE html>\n").expect("a document type");
    let mut open = Vec::new();
    let mut pieces = body.split('<');
    assert_eq!(pieces.next(), Some(""));
    for piece in pieces {
        let (tag, text) = piece.split_once('>').unwrap_or_else(|| panic!("a tag has no end: {piece}"));
        assert!(!text.contains('>'), "{text}");
        for entity in text.split('&').skip(1).chain(tag.split('&').skip(1)) {
            assert!(["amp;", "lt;", "gt;", "quot;"].iter().any(|e| entity.starts_with(e)), "&{entity}");
        }
        let name = tag.trim_matches('/').split_whitespace().next().unwrap_or_default();
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "{piece}");
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// A page without scripts whose links all lead somewhere, with sections of these experiments and no others.
fn check(report: &Path, experiments: &[String]) {
    let page = std::fs::read_to_string(report.join("index.html")).unwrap();
    is_well_formed(&page);
    assert!(!page.contains("<script") && !page.contains("http"), "the page stands alone");
    let sections: Vec<&str> = values(&page, "id");
    assert_eq!(sections, experiments);
    let linked: BTreeSet<&str> = values(&page, "href").into_iter().chain(values(&page, "src")).collect();
    for link in &linked {
        match link.strip_prefix('#') {
            Some(id) => assert!(sections.contains(&id), "{link}"),
            None => assert!(report.join(link).is_file(), "{link}"),
        }
    }
    assert!(values(&page, "alt").len() == values(&page, "src").len());
    let figures: Value =
        serde_json::from_str(&std::fs::read_to_string(report.join("figures.json")).unwrap()).unwrap();
    let figures = figures.as_array().unwrap();
    assert_eq!(figures.iter().map(|f| f["name"].as_str().unwrap()).collect::<Vec<_>>(), experiments);
    for figure in figures {
        let name = figure["name"].as_str().unwrap();
        for told in ["title", "paper", "place", "claim"] {
            assert!(!figure[told].as_str().unwrap().is_empty(), "{name}: {told}");
        }
        assert!(!figure["comparisons"].as_array().unwrap().is_empty(), "{name} compares nothing");
        assert!(!figure["gaps"].as_array().unwrap().is_empty(), "{name} tells of no gap");
        for comparison in figure["comparisons"].as_array().unwrap() {
            assert!(comparison["ours"].is_f64(), "{name}: {comparison}");
        }
    }
}

#[test]
fn what_cannot_be_run_is_said() {
    let folder = Folder::new("lab-bad");
    let missing = format!("lab run keller97-figure-8 --scenes {}/nowhere", folder.0.display());
    folder.put("file", "");
    std::fs::create_dir(folder.0.join("mine")).unwrap();
    folder.put("mine/index.html", "a page of somebody's own");
    for (args, code, word) in [
        ("lab", 2, "Usage"),
        ("lab run", 2, "NAME"),
        ("lab run alchemy", 2, "known: "),
        ("lab run keller97-figure-1 --quick --depth 3", 2, "--depth"),
        ("lab run keller97-figure-1 -o file", 4, "file"),
        ("lab run keller97-figure-1 -o mine", 4, "no report"),
        (missing.as_str(), 3, "--scenes"),
    ] {
        let done = run(&folder, args);
        assert_eq!(done.code, code, "{args}: {}", done.err);
        assert!(done.out.is_empty() && done.err.contains(word), "{args}: {}", done.err);
    }
    assert_eq!(
        std::fs::read_to_string(folder.0.join("mine/index.html")).unwrap(),
        "a page of somebody's own"
    );
}

#[test]
fn a_report_grows_by_experiments_and_keeps_them() {
    let folder = Folder::new("lab-grows");
    let report = folder.0.join("report");
    let first = run(&folder, "lab run lecture-halton --quick");
    assert_eq!((first.code, first.out.trim()), (0, "report/index.html"), "{}", first.err);
    check(&report, &["lecture-halton".into()]);
    let second = run(&folder, "lab run keller97-figure-4 keller97-figure-1 --quick --quiet");
    assert_eq!((second.code, second.err.as_str()), (0, ""));
    // In the order of the list, whatever the order of the runs.
    let there: Vec<String> = (names(&folder).into_iter())
        .filter(|n| ["lecture-halton", "keller97-figure-1", "keller97-figure-4"].contains(&n.as_str()))
        .collect();
    assert_eq!(there.len(), 3);
    check(&report, &there);
    // What was left by a program of another shape is left out.
    folder.put("report/lecture-halton/figures.json", "{}");
    assert_eq!(run(&folder, "lab run keller97-figure-1 --quick").code, 0);
    check(&report, &there[..2]);
}

#[test]
fn a_scene_that_does_not_ship_is_asked_for() {
    let folder = Folder::new("lab-further");
    let mut command = command(&folder, &format!("lab run keller97-figure-12 --quick --scenes {}", scenes()));
    assert!(command.env_remove("LAMPYRIS_SCENES").status().unwrap().success());
    let page = std::fs::read_to_string(folder.0.join("report/index.html")).unwrap();
    assert!(page.contains("Set LAMPYRIS_SCENES"));
}

#[test]
#[cfg(unix)]
fn an_interrupted_run_keeps_what_is_finished() {
    let folder = Folder::new("lab-interrupted");
    let mut child = command(&folder, &format!("lab run all --quick --scenes {}", scenes())).spawn().unwrap();
    let finished = folder.0.join("report/keller96-discrepancy/figures.json");
    let start = Instant::now();
    while !finished.exists() {
        assert!(start.elapsed() < Duration::from_secs(120), "no experiment is finished");
        std::thread::sleep(Duration::from_millis(20));
    }
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let all = names(&folder);
    let report = folder.0.join("report");
    let kept: Vec<String> =
        all.iter().filter(|n| report.join(n).join("figures.json").exists()).cloned().collect();
    assert!(!kept.is_empty() && kept.len() < all.len(), "{kept:?}");
    check(&report, &kept);
}

#[test]
#[ignore = "long: a few minutes"]
fn all_experiments_make_one_page() {
    let folder = Folder::new("lab-all");
    let done = run(&folder, &format!("lab run all --quick --scenes {}", scenes()));
    assert_eq!(done.code, 0, "{}", done.err);
    check(&folder.0.join("report"), &names(&folder));
}
