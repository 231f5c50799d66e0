//! The house rules of CONTRIBUTING.md, asserted about the sources themselves.
//! They are properties of the repository, not of light; nothing is rendered here.

use lampyris::backend::Settings;
use lampyris::integrator;
use lampyris::material::SHARP_ALPHA;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Every file beneath `folder` whose name ends so: path from the root, and text.
fn files(folder: &str, ending: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            if path.is_dir() && !["target", "node_modules"].contains(&name.as_str()) && !name.starts_with('.')
            {
                folders.push(path);
            } else if name.ends_with(ending) {
                let from_root = path.strip_prefix(root()).unwrap().to_str().unwrap().to_owned();
                found.push((from_root, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found.sort();
    found
}

fn sources() -> Vec<(String, String)> {
    [files("crates", ".rs"), files("fuzz", ".rs")].concat()
}

/// The comments of a file as one text.
fn comments(text: &str) -> String {
    let lines = text.lines().filter_map(|l| l.trim_start().strip_prefix("//"));
    lines.map(|l| l.trim_start_matches(['/', '!']).trim()).collect::<Vec<_>>().join(" ")
}

/// Keys of citations: in brackets, separated by semicolons, before the first comma; a name that ends in a year.
fn keys(comments: &str) -> BTreeSet<String> {
    let brackets = comments.split('[').skip(1).filter_map(|after| after.split_once(']'));
    let parts = brackets.flat_map(|(inside, _)| inside.split(';'));
    let key = |part: &str| part.split(',').next().unwrap_or_default().trim().to_owned();
    parts.map(key).filter(|k| is_key(k)).collect()
}

fn is_key(text: &str) -> bool {
    let digits = text.chars().rev().take_while(char::is_ascii_digit).count();
    let letter = |c: char| c.is_alphabetic() || c == ' ' || c == '.' || c == '-';
    text.starts_with(char::is_uppercase)
        && matches!(digits, 2 | 4)
        && text.chars().count() > digits + 1
        && text[..text.len() - digits].chars().all(letter)
}

/// Cells of the tables of a markdown text, row by row; an escaped bar is part of its cell.
fn rows(markdown: &str) -> Vec<Vec<String>> {
    let bar = "\u{0}";
    let lines = markdown.lines().filter(|l| l.starts_with("| "));
    let cells = |l: &str| {
        let l = l.trim().trim_matches('|').replace("\\|", bar);
        l.split('|').map(|c| c.replace(bar, "|").trim().to_owned()).collect()
    };
    lines.map(cells).collect()
}

/// What stands in backquotes.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// Keys of docs/papers.md with the files that are said to use them.
fn papers() -> BTreeMap<String, Vec<String>> {
    let text = read("docs/papers.md");
    let listed = rows(&text).into_iter().filter(|row| row[0].starts_with('['));
    listed
        .map(|row| {
            let files = quoted(&row[3]).into_iter().map(|f| format!("crates/lampyris/{f}")).collect();
            (row[0].trim_matches(['[', ']']).to_owned(), files)
        })
        .collect()
}

#[test]
fn every_citation_is_in_the_list_of_papers_and_the_list_is_true() {
    let papers = papers();
    assert!(papers.len() > 20 && papers.keys().all(|k| is_key(k)), "{papers:?}");
    let mut used: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (path, text) in sources() {
        for key in keys(&comments(&text)) {
            assert!(papers.contains_key(&key), "{path} cites [{key}], which docs/papers.md does not list");
            used.entry(key).or_default().insert(path.clone());
        }
    }
    for (key, listed) in &papers {
        let using = used.remove(key).unwrap_or_default();
        for file in listed {
            assert!(using.contains(file), "docs/papers.md: {file} does not cite [{key}]");
        }
        let missing = using.iter().find(|f| f.starts_with("crates/lampyris/src") && !listed.contains(f));
        assert_eq!(missing, None, "cites [{key}]; docs/papers.md does not say so");
    }
    let prose = read("docs/light-transport.md");
    for key in keys(&prose) {
        assert!(papers.contains_key(&key), "docs/light-transport.md cites [{key}]");
    }
}

#[test]
fn files_are_short() {
    let mut lengths: Vec<(usize, String)> =
        sources().into_iter().map(|(path, text)| (text.lines().count(), path)).collect();
    lengths.sort();
    let at = |share: f64| &lengths[(lengths.len() as f64 * share) as usize];
    assert!(at(0.5).0 <= 170, "median: {:?}", at(0.5));
    assert!(at(0.9).0 <= 400, "one in ten is longer than {:?}", at(0.9));
    assert!(lengths[lengths.len() - 1].0 <= 600, "longest: {:?}", lengths[lengths.len() - 1]);
}

#[test]
fn every_file_says_what_it_is() {
    for (path, text) in sources() {
        assert!(text.starts_with("//! "), "{path} begins with no description");
    }
}

/// The layers of ARCHITECTURE.md, from the ground up.
fn layers() -> Vec<Vec<String>> {
    let text = read("ARCHITECTURE.md");
    let block =
        text.split("```layers\n").nth(1).and_then(|b| b.split("```").next()).expect("a block of layers");
    block.lines().map(|l| l.split_whitespace().map(str::to_owned).collect()).collect()
}

/// The text without its unit tests, which may look anywhere.
fn without_tests(text: &str) -> &str {
    text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default()
}

#[test]
fn modules_use_earlier_layers_only() {
    let layers = layers();
    let layer = |module: &str| layers.iter().position(|l| l.iter().any(|m| m == module));
    for (path, text) in files("crates/lampyris/src", ".rs") {
        let inside = path.strip_prefix("crates/lampyris/src/").unwrap();
        let module = inside.split('/').next().unwrap().trim_end_matches(".rs");
        if module == "lib" || inside.ends_with("tests.rs") {
            continue;
        }
        let own = layer(module).unwrap_or_else(|| panic!("ARCHITECTURE.md puts {module} in no layer"));
        let code: Vec<&str> =
            without_tests(&text).lines().filter(|l| !l.trim_start().starts_with("//")).collect();
        for used in code.join("\n").split("crate::").skip(1) {
            assert!(!used.starts_with('{'), "{path}: a line of its own for each module used");
            let used: String = used.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let Some(of_used) = layer(&used) else { continue };
            assert!(used == module || of_used < own, "{path} uses {used}, which is not below {module}");
        }
    }
    let declared = read("crates/lampyris/src/lib.rs");
    for module in layers.iter().flatten() {
        assert!(declared.contains(&format!("mod {module};")), "ARCHITECTURE.md: there is no module {module}");
    }
}

#[test]
fn the_code_map_names_every_module() {
    let map = read("ARCHITECTURE.md");
    for module in layers().iter().flatten() {
        let row = rows(&map).into_iter().find(|row| quoted(&row[0]).contains(&module.as_str()));
        assert!(row.is_some(), "ARCHITECTURE.md: the code map lacks {module}");
    }
}

#[test]
fn the_readme_lists_the_integrators_there_are() {
    let readme = read("README.md");
    let section =
        readme.split("## The parts of the light").nth(1).and_then(|s| s.split("\n## ").next()).unwrap();
    let told: Vec<(String, String)> = rows(section)
        .into_iter()
        .filter(|row| row[0].starts_with('`'))
        .map(|row| (quoted(&row[0])[0].to_owned(), quoted(&row[1])[0].to_owned()))
        .collect();
    let there: Vec<(String, String)> =
        integrator::ALL.iter().map(|i| (i.name().to_owned(), i.paths().to_owned())).collect();
    assert_eq!(told, there);
}

#[test]
fn the_formats_told_are_the_formats_there() {
    let (readme, formats) = (read("README.md"), read("docs/formats.md"));
    for format in lampyris::import::FORMATS {
        let extension = format!("`.{}`", format.extensions[0]);
        assert!(formats.contains(&extension), "docs/formats.md says nothing of {extension}");
    }
    #[cfg(feature = "pictures")]
    for format in lampyris::output::FORMATS {
        let name = format.name.split(':').next().unwrap().split(' ').next().unwrap();
        assert!(readme.contains(name), "README.md says nothing of {name}");
    }
    assert!(readme.contains("MGF"));
}

#[test]
fn the_manual_states_the_defaults() {
    let (manual, defaults) = (read("docs/light-transport.md"), Settings::default());
    let told = [
        format!("; c = {}\nunless", defaults.clamp),
        format!("r = {} by default", defaults.replicates),
        format!("α < {SHARP_ALPHA} (`SHARP_ALPHA`)"),
    ];
    for text in told {
        assert!(manual.contains(&text), "docs/light-transport.md should say \"{text}\"");
    }
}

#[test]
fn ci_runs_the_command_of_the_readme() {
    let command = "./test";
    assert!(read("test").lines().any(|l| l == "cargo test --workspace --locked"));
    assert!(read("README.md").contains(&format!("```sh\n{command}\n```")));
    assert!(read(".ci/run").lines().any(|l| l == command));
}

#[test]
fn tests_are_left_out_for_named_reasons_only() {
    let attribute = concat!("#[", "ignore");
    let allowed = ["needs LAMPYRIS_SCENES", "needs LAMPYRIS_REFS", "long: "];
    for (path, text) in sources() {
        for line in text.lines().map(str::trim).filter(|l| l.starts_with(attribute)) {
            let reason = line.split('"').nth(1).unwrap_or_default();
            let good = allowed.iter().any(|a| reason.starts_with(a)) && reason != "long: ";
            assert!(good, "{path}: {line}");
        }
        let skipped = ["```", "ignore"].concat();
        assert!(!comments(&text).contains(&skipped), "{path}: an example that is not compiled");
    }
}

#[test]
fn nothing_is_left_for_later() {
    let words = [["TO", "DO"], ["FIX", "ME"], ["XX", "X"], ["HA", "CK"]].map(|w| w.concat());
    let texts = sources().into_iter().chain(files(".", ".md")).chain(files(".", ".toml"));
    for (path, text) in texts {
        for word in &words {
            assert!(!text.contains(word), "{path} says {word}");
        }
    }
}

#[test]
fn unsafe_code_is_where_it_is_allowed() {
    let word = ["un", "safe"].concat();
    for (path, text) in sources() {
        let named = path.contains("/simd_") || path == "crates/lampyris/src/geometry/bvh/mod.rs";
        let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
        let used = code.flat_map(|l| l.split(|c: char| !c.is_alphanumeric() && c != '_')).any(|w| w == word);
        assert!(named || !used, "{path} is no module for {word} code");
    }
}

#[test]
fn links_in_the_manuals_lead_somewhere() {
    for (path, text) in files(".", ".md") {
        let folder = root().join(&path);
        for after in text.split("](").skip(1) {
            let target = after.split(')').next().unwrap().split('#').next().unwrap();
            if target.is_empty() || target.starts_with("http") {
                continue;
            }
            let file = folder.parent().unwrap().join(target);
            assert!(file.exists(), "{path} links to {target}");
        }
    }
}
