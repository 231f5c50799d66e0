//! Documents on the disk: found, held to their folder, written whole, by one program at a time.

mod folder;

use folder::Folder;
use lampyris::document::{Ask, Document, Opened, Place, beside, is_document, open};
use lampyris::error::Error;
use lampyris::import::Options;
use lampyris::light::State;
use lampyris::scene::Edit;
use std::path::{Path, PathBuf};

const SCENE: &str = "v a = \n p 0 0 0\nv b = \n p 1 0 0\nv c = \n p 0 1 0\no table\nf a b c\no\n";

fn put(folder: &Folder, name: &str) -> PathBuf {
    folder.write(name, SCENE)
}

fn plain(path: &Path) -> lampyris::Result<Opened> {
    open(path, &Ask::default(), None)
}

/// What was opened, with its table taken away.
fn cleared(opened: &Opened) -> Document {
    let mut after = opened.scene.clone();
    after.apply(&Edit::Mesh { instance: 0, mesh: None }).expect("a table");
    Document::of(&opened.before, &after)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|e| e.expect("an entry").file_name().into_string().expect("text")).collect();
    names.sort();
    names
}

#[test]
fn edits_are_saved_beside_the_scene_and_opened_again() {
    let folder = Folder::new();
    let scene = put(&folder, "office.mgf");
    let file = folder.0.join("office.mgf.lampyris.json");
    assert_eq!(beside(&scene), file);
    assert!(is_document(&file) && !is_document(&scene));
    let opened = plain(&scene).expect("a scene");
    assert!(opened.document == Document::default() && opened.warnings.is_empty());
    let mut place = Place::claim(&opened, None).expect("room");
    assert_eq!(names(&folder.0), [".office.mgf.lampyris.json.lock", "office.mgf"]);
    assert_eq!((place.save(&cleared(&opened)).expect("room"), place.notes().len()), (None, 0));
    drop(place);
    assert_eq!(names(&folder.0), ["office.mgf", "office.mgf.lampyris.json"]);
    assert_eq!(std::fs::read_to_string(&scene).expect("the scene"), SCENE, "untouched");

    let again = plain(&file).expect("a document");
    assert_eq!((again.lost.len(), again.document.scene.file.as_str()), (0, "office.mgf"));
    assert_eq!(again.scene.instances[0].mesh, u32::MAX);
    assert_eq!(format!("{:?}", again.before), format!("{:?}", opened.before));
    assert_eq!(again.warnings, [""; 0]);
    // What is not edited further says the same.
    let same = Document::of(&again.before, &again.scene);
    let rest = |document: &Document| document.text().lines().skip(3).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rest(&same), rest(&again.document));
    let told = plain(&scene).expect("a scene").warnings;
    assert_eq!(told, [format!("edits of it lie in {}: open that to see them", file.display())]);
}

/// Whoever opens the scene alone and edits it loses nothing of what lay beside it.
#[test]
fn earlier_edits_are_kept() {
    let folder = Folder::new();
    let scene = put(&folder, "office.mgf");
    let opened = plain(&scene).expect("a scene");
    for round in 0..3 {
        let mut place = Place::claim(&opened, None).expect("room");
        let mut document = Document::default();
        document.desk = round.into();
        let earlier = place.save(&document).expect("room");
        let expected = (round > 0).then(|| folder.0.join(format!("office.mgf.{round}.lampyris.json")));
        assert_eq!(earlier, expected);
        assert_eq!(place.save(&document).expect("room"), None, "now it is our own");
        let version = place.save_version("evening 1", &document).expect("room");
        assert_eq!(plain(&version).expect("a version").document.desk, round);
        for name in ["", "a/b", "..", "a.b", "a\n", &"x".repeat(65)] {
            assert!(matches!(place.save_version(name, &document), Err(Error::BadSetting(_))), "{name:?}");
        }
    }
    let desk = |name: &str| plain(&folder.0.join(name)).expect("a document").document.desk;
    assert_eq!([desk("office.mgf.1.lampyris.json"), desk("office.mgf.2.lampyris.json")], [0, 1]);
    assert_eq!(desk("office.mgf.lampyris.json"), 2);
}

/// What somebody else writes there meanwhile, by hand or by going back to a version, is not lost either.
#[test]
fn another_hands_edits_are_kept() {
    let folder = Folder::new();
    let scene = put(&folder, "office.mgf");
    let mut place = Place::claim(&plain(&scene).expect("a scene"), None).expect("room");
    place.save(&Document::default()).expect("room");
    drop(place);
    let opened = plain(&beside(&scene)).expect("a document");
    let mut place = Place::claim(&opened, None).expect("room");
    assert_eq!(place.save(&cleared(&opened)).expect("room"), None, "it was opened");
    for round in 1..4 {
        let text =
            format!("{{\"lampyris\": 1, \"scene\": {{\"file\": \"office.mgf\"}}, \"layers\": {round}}}");
        std::fs::write(place.file(), &text).expect("room");
        let kept = place.save(&cleared(&opened)).expect("room").expect("another hand's");
        assert_eq!(kept, folder.0.join(format!("office.mgf.{round}.lampyris.json")));
        assert_eq!(std::fs::read_to_string(kept).expect("a document"), text);
        assert_eq!(place.save(&Document::default()).expect("room"), None);
    }
    std::fs::remove_file(place.file()).expect("a document");
    assert_eq!(place.save(&Document::default()).expect("room"), None, "taken away is taken away");
}

#[test]
fn one_program_writes_at_a_time() {
    let folder = Folder::new();
    let opened = plain(&put(&folder, "office.mgf")).expect("a scene");
    let state = folder.0.join("state");
    let first = Place::claim(&opened, Some(&state)).expect("room");
    let Err(Error::CannotWrite { reason, .. }) = Place::claim(&opened, Some(&state)) else {
        panic!("two of them")
    };
    assert!(reason.contains("another program"), "{reason}");
    drop(first);
    // Many at once: never two, and in the end one.
    let held = std::sync::atomic::AtomicU32::new(0);
    let claims = || {
        (0..50)
            .filter(|_| {
                let Ok(place) = Place::claim(&opened, None) else { return false };
                let others = held.fetch_add(1, std::sync::atomic::Ordering::SeqCst);
                assert_eq!(others, 0);
                held.fetch_sub(1, std::sync::atomic::Ordering::SeqCst);
                drop(place);
                true
            })
            .count()
    };
    let all: usize = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(claims)).collect();
        threads.into_iter().map(|t| t.join().expect("no panic")).sum()
    });
    assert!(all > 0);
    assert!(Place::claim(&opened, None).is_ok());
}

/// Where nothing can be written beside the scene, edits go to the user's folder, and are found again.
#[test]
fn the_users_folder_takes_what_the_scenes_does_not() {
    let folder = Folder::new();
    let state = folder.0.join("state/lampyris");
    let scenes = ["one/office.mgf", "two/office.mgf"].map(|name| put(&folder, name));
    let mut files = Vec::new();
    for scene in &scenes {
        // What is in the way of the lock is in the way of everything.
        std::fs::create_dir(scene.with_file_name(".office.mgf.lampyris.json.lock")).expect("a folder");
        let opened = open(scene, &Ask::default(), Some(&state)).expect("a scene");
        assert!(Place::claim(&opened, None).is_err());
        let mut place = Place::claim(&opened, Some(&state)).expect("room");
        let note = place.notes().join(" ");
        assert!(note.contains("edits are kept in") && note.contains("in the way"), "{note}");
        place.save(&cleared(&opened)).expect("room");
        files.push(place.file().to_owned());
    }
    assert_ne!(files[0], files[1], "scenes of one name do not meet");
    for (file, scene) in files.iter().zip(&scenes) {
        assert_eq!(file.parent(), Some(state.as_path()));
        let again = open(file, &Ask::default(), Some(&state)).expect("a document");
        assert_eq!((again.scene.instances[0].mesh, again.lost.len()), (u32::MAX, 0));
        assert_eq!(again.scene_file.canonicalize().ok(), scene.canonicalize().ok());
        let warnings = open(scene, &Ask::default(), Some(&state)).expect("a scene").warnings;
        assert!(warnings.len() == 1 && warnings[0].contains(&*file.display().to_string()), "{warnings:?}");
        // A file that names one anywhere is believed nowhere else.
        let copy = folder.write("copy.lampyris.json", std::fs::read(file).expect("a document"));
        let error = open(&copy, &Ask::default(), Some(&state)).expect_err("outside").to_string();
        assert!(error.contains("not a relative path"), "{error}");
    }
}

#[test]
fn documents_name_files_beneath_their_folder_only() {
    let folder = Folder::new();
    put(&folder, "outside.mgf");
    put(&folder, "inner/sub/room.mgf");
    let document =
        |file: &str| format!("{{\"lampyris\": 1, \"scene\": {{\"file\": {}}}}}", serde_json::json!(file));
    let try_open = |file: &str| plain(&folder.write("inner/a.lampyris.json", document(file)));
    let below = try_open("sub/room.mgf").expect("beneath it");
    assert_eq!(below.scene.instances.len(), 1);
    let absolute = folder.0.join("inner/sub/room.mgf");
    for name in [
        "../outside.mgf",
        "sub/../../outside.mgf",
        "",
        ".",
        "sub",
        "/etc/passwd",
        "missing.mgf",
        "a\0b",
        "file://a.mgf",
        "a.lampyris.json",
        absolute.to_str().expect("text"),
    ] {
        let error = try_open(name).expect_err(name);
        assert!(matches!(error, Error::CannotRead { .. }), "{name}: {error}");
    }
    // A wider root is for who trusts it.
    let ask =
        Ask { options: Options { root: Some(folder.0.clone()), ..Options::default() }, ..Ask::default() };
    folder.write("inner/a.lampyris.json", document("../outside.mgf"));
    assert_eq!(
        open(&folder.0.join("inner/a.lampyris.json"), &ask, None).expect("beneath it").scene.instances.len(),
        1
    );
    // A scene in a folder below may name what the document may.
    folder.write("inner/sub/more.mgf", "i ../other.mgf\n");
    put(&folder, "inner/other.mgf");
    assert_eq!(try_open("sub/more.mgf").expect("beneath it").scene.instances.len(), 1);
    folder.write("inner/sub/more.mgf", "i ../../outside.mgf\n");
    assert!(try_open("sub/more.mgf").is_err());
}

#[cfg(unix)]
#[test]
fn links_are_not_written_through() {
    let folder = Folder::new();
    let scene = put(&folder, "scenes/office.mgf");
    let precious = folder.write("precious", "mine");
    let opened = plain(&scene).expect("a scene");
    let links = ["office.mgf.lampyris.json", ".office.mgf.lampyris.json.lock"];
    for link in links.map(|name| scene.with_file_name(name)) {
        std::os::unix::fs::symlink(&precious, &link).expect("a link");
        assert!(Place::claim(&opened, None).is_err());
        std::fs::remove_file(&link).expect("a link");
    }
    // One that appears later is found too.
    let mut place = Place::claim(&opened, None).expect("room");
    place.save(&cleared(&opened)).expect("room");
    std::fs::remove_file(place.file()).expect("a document");
    std::os::unix::fs::symlink(&precious, place.file()).expect("a link");
    assert!(matches!(place.save(&cleared(&opened)), Err(Error::CannotWrite { .. })));
    assert_eq!(std::fs::read(&precious).expect("a file"), b"mine");
    // A link to a document out of its folder is not followed either.
    let document =
        folder.write("a.lampyris.json", "{\"lampyris\": 1, \"scene\": {\"file\": \"office.mgf\"}}");
    let link = scene.with_file_name("b.lampyris.json");
    std::os::unix::fs::symlink(document, &link).expect("a link");
    assert!(plain(&link).is_err());
}

/// Circles and surroundings are part of how a scene is read, and the arguments' go before the document's.
#[test]
fn a_document_says_how_its_scene_is_read() {
    let folder = Folder::new();
    let scene = folder.write("ball.mgf", "v c = \n p 0 0 0\no ball\nsph c 1\no\n");
    let sky = folder.write("sky.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n\x80\x80\x80\x81\x80\x80\x80\x81\x80\x80\x80\x81\x80\x80\x80\x81");
    let ask = Ask { circle: Some(8), environment: Some((sky.clone(), 3.0)), ..Ask::default() };
    let opened = open(&scene, &ask, None).expect("a scene");
    let mut place = Place::claim(&opened, None).expect("room");
    place.save(&Document::of(&opened.before, &opened.scene)).expect("room");
    let again = plain(place.file()).expect("a document");
    assert_eq!(format!("{:?}", again.scene), format!("{:?}", opened.scene));
    assert_eq!((again.environment.map(|e| e.1), again.scene.environment.g), (Some(3.0), 3.0));
    let other = Ask { circle: Some(12), environment: Some((sky, 5.0)), ..Ask::default() };
    let again = open(place.file(), &other, None).expect("a document");
    assert_eq!(again.scene.environment.g, 5.0);
    assert!(again.scene.meshes[0].triangles.len() > opened.scene.meshes[0].triangles.len());
}

/// What a killed program left of its last saving is swept away by the next one; other files stay.
#[test]
fn leftovers_go() {
    let folder = Folder::new();
    let opened = plain(&put(&folder, "office.mgf")).expect("a scene");
    folder.write(".office.mgf.lampyris.json.77-0.part", "{");
    folder.write(".office.mgf.lampyris.json.lock", "");
    folder.write(".other.mgf.lampyris.json.77-0.part", "{");
    drop(Place::claim(&opened, None).expect("room"));
    assert_eq!(names(&folder.0), [".other.mgf.lampyris.json.77-0.part", "office.mgf"]);
}

/// A scene that lost its lamps' file opens all the same.
#[test]
fn lost_edits_are_warnings() {
    let folder = Folder::new();
    put(&folder, "office.mgf");
    let lights: Vec<String> =
        (0..50).map(|k| format!("\"gone {k}\": {{\"state\": \"{:?}\"}}", State::Off)).collect();
    let text = format!(
        "{{\"lampyris\": 1, \"scene\": {{\"file\": \"office.mgf\"}}, \"lights\": {{{}}}}}",
        lights.join(",")
    );
    let opened = plain(&folder.write("office.mgf.lampyris.json", text)).expect("a document");
    assert_eq!((opened.lost.len(), opened.warnings.len()), (50, 21));
    assert_eq!(opened.warnings[0], "an edit is left out: light \"gone 0\" is not in the scene any more");
    assert_eq!(opened.warnings[20], "30 more edits are left out");
}

/// A program that is killed at any moment leaves a whole document, no older than the last that it had finished, and a place
/// that the next one may claim.
#[test]
fn killed_programs_leave_whole_documents() {
    const FOLDER: &str = "LAMPYRIS_TEST_SAVES_IN";
    if let Some(folder) = std::env::var_os(FOLDER) {
        let file = PathBuf::from(folder).join("office.mgf");
        let document_file = beside(&file);
        let opened = plain(if document_file.is_file() { &document_file } else { &file }).expect("whole");
        let mut place = Place::claim(&opened, None).expect("the other one is dead");
        let first = opened.document.desk["number"].as_u64().unwrap_or(0);
        for number in first + 1.. {
            let mut document = Document::default();
            document.desk = serde_json::json!({"number": number, "long": "x".repeat(50_000)});
            place.save(&document).expect("room");
        }
    }
    let folder = Folder::new();
    let file = beside(&put(&folder, "office.mgf"));
    let number = || match file.is_file() {
        true => plain(&file).expect("whole").document.desk["number"].as_u64().expect("a number"),
        false => 0,
    };
    let mut last = 0;
    for round in 0..30 {
        let mut child = std::process::Command::new(std::env::current_exe().expect("this program"));
        child.args(["--exact", "killed_programs_leave_whole_documents"]).env(FOLDER, &folder.0);
        let mut child = child.stdout(std::process::Stdio::null()).spawn().expect("a process");
        let start = std::time::Instant::now();
        while number() == last {
            assert!(start.elapsed().as_secs() < 60, "it does not save");
        }
        std::thread::sleep(std::time::Duration::from_micros(round * 1_700 % 13_000));
        child.kill().expect("a process");
        child.wait().expect("a process");
        assert!(number() > last);
        last = number();
    }
    let opened = plain(&file).expect("whole");
    drop(Place::claim(&opened, None).expect("nobody has it"));
    assert_eq!(names(&folder.0), ["office.mgf", "office.mgf.lampyris.json"]);
}
