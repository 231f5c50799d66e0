//! The program as a script sees it: exit codes, streams and JSON.

use std::process::{Command, Output, Stdio};

fn lampyris(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lampyris")).args(args).output().unwrap()
}

/// Exit code, standard output, standard error.
fn run(args: &[&str]) -> (i32, String, String) {
    let output = lampyris(args);
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn usage_errors_are_2_with_an_empty_standard_output() {
    let bad: &[&[&str]] = &[
        &[],
        &["paint"],
        &["render"],
        &["render", "a.mgf", "--size", "0x5"],
        &["render", "a.mgf", "--size", "640"],
        &["render", "a.mgf", "--eye", "1,2"],
        &["render", "a.mgf", "--eye", "1,2,3"],
        &["render", "a.mgf", "--fov", "200"],
        &["render", "a.mgf", "--tone", "sepia"],
        &["render", "a.mgf", "--exposure", "bright"],
        &["render", "a.mgf", "--batches", "0"],
        &["render", "a.mgf", "--time", "-1"],
        &["render", "a.mgf", "--parts", "direct,glitter"],
        &["render", "a.mgf", "--sequence", "dice"],
        &["render", "a.mgf", "--absorption", "none"],
        &["render", "a.mgf", "-o", "picture.jpg"],
        &["measure", "a.mgf"],
        &["completions", "cobol"],
    ];
    for args in bad {
        let (code, out, err) = run(args);
        assert_eq!(code, 2, "{args:?}: {err}");
        assert!(out.is_empty() && !err.is_empty(), "{args:?}");
    }
}

#[test]
fn what_cannot_be_read_is_3_in_one_line() {
    for args in [
        &["info", "missing.mgf"][..],
        &["info", "missing.xyz"],
        &["render", "missing.mgf"],
        &["measure", "missing.mgf", "--points", "missing.txt"],
    ] {
        let (code, out, err) = run(args);
        assert_eq!(code, 3, "{args:?}: {err}");
        assert!(out.is_empty() && err.starts_with("error: ") && err.lines().count() == 1, "{err}");
        assert!(err.contains("missing"), "{err}");
    }
}

#[test]
fn a_missing_folder_is_4_before_any_work() {
    let (code, _, err) = run(&["render", "missing.mgf", "-o", "no-such-folder/a.png"]);
    assert_eq!(code, 4, "{err}");
}

#[test]
fn help_and_version_go_to_standard_output() {
    let (code, out, _) = run(&["render", "--help"]);
    assert_eq!(code, 0);
    for word in ["Examples:", "--eye", "--no-compensate", "--max-triangles", "cd/m²"] {
        assert!(out.contains(word), "{word}");
    }
    // The heading of the limits covers nothing else.
    let (options, limits) = out.split_once("Limits on what a scene may ask for").unwrap();
    assert!(options.contains("--quiet") && !limits.split_once("Examples").unwrap().0.contains("--quiet"));
    let (code, out, _) = run(&["--version"]);
    assert_eq!((code, out.as_str()), (0, concat!("lampyris ", env!("CARGO_PKG_VERSION"), "\n")));
}

#[test]
fn list_prints_tables_and_one_json_value() {
    let (code, out, _) = run(&["list"]);
    assert!(code == 0 && out.contains("filmic") && out.contains("sobol-owen") && out.contains("exr"));
    let (code, out, err) = run(&["list", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let value: serde_json::Value = serde_json::from_str(&out).unwrap();
    for table in ["parts", "sequences", "absorption", "picture_formats", "tone_curves"] {
        assert!(value[table].as_array().is_some_and(|t| t.len() >= 3), "{table}");
    }
}

#[test]
fn every_shell_gets_completions() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let (code, out, err) = run(&["completions", shell]);
        assert!(code == 0 && err.is_empty() && out.contains("no-compensate"), "{shell}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_or_closed_stream_is_no_panic() {
    let full = || Stdio::from(std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
    for args in [&["list"][..], &["list", "--json"], &["completions", "bash"], &["--help"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lampyris"));
        let output =
            command.args(args).stdout(full()).stderr(Stdio::piped()).spawn().unwrap().wait_with_output();
        let output = output.unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(4), "{args:?}: {err}");
        assert!(!err.contains("panicked"), "{err}");
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_lampyris"));
    let status = command.args(["info", "missing.mgf"]).stdout(full()).stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(3));
    let mut child =
        Command::new(env!("CARGO_BIN_EXE_lampyris")).args(["list"]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
