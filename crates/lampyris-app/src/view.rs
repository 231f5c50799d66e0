//! `lampyris view`: the lighting desk, a page in the browser.

use crate::cli::ViewerArgs;
use crate::failure::{Failure, INTERRUPTED};
use crate::{interrupt, say, scene_file, viewing};
use lampyris_desk::{Ender, Opened, Options};
use std::net::SocketAddr;
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// How often Ctrl-C is looked for.
const LOOK: Duration = Duration::from_millis(50);

/// How long a browser has to start.
const SHOWN: Duration = Duration::from_secs(30);

/// Serves until Ctrl-C, or until the last page is closed, if that is asked for.
pub(crate) fn view(args: ViewerArgs) -> Result<ExitCode, Failure> {
    let options = Options {
        address: SocketAddr::new(args.listen, args.port),
        exposed: args.expose,
        file: args.scene.file.clone(),
        program: std::env::current_exe().unwrap_or_else(|_| "lampyris".into()),
        size: args.size.into(),
        batches: args.batches,
        threads: args.threads.map(|n| n as usize),
        ends_with_page: args.exit_with_page,
    };
    let ready = |link: &str, ender: Ender| {
        say::note(link);
        if !args.no_open {
            show(link);
        }
        interrupt::rendering();
        std::thread::spawn(move || {
            while !interrupt::asked() {
                std::thread::sleep(LOOK);
            }
            ender.end();
        });
    };
    let open = |file: Option<&Path>| {
        let file = file.unwrap_or(&args.scene.file);
        let document = scene_file::read(file, &args.scene.reading, args.quiet)?;
        let camera = viewing::asked(&args.view, &document.scene)?;
        Ok::<_, Failure>(Opened { document, camera })
    };
    lampyris_desk::serve(options, ready, open)?;
    Ok(if interrupt::asked() { ExitCode::from(INTERRUPTED) } else { ExitCode::SUCCESS })
}

/// Opens a link where there is a desktop. By way of a file of the user's own: arguments of programs can be read by all.
fn show(link: &str) {
    let desktop = cfg!(not(unix))
        || cfg!(target_os = "macos")
        || ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| std::env::var_os(name).is_some());
    if !desktop {
        return;
    }
    let file = std::env::temp_dir().join(format!("lampyris-{}.html", std::process::id()));
    let page = format!("<!doctype html><meta charset=utf-8><script>location.replace({link:?})</script>");
    if let Err(error) = private(&file, &page).and_then(|()| open::that_detached(&file)) {
        say::note(&format!("cannot open it: {error}"));
    }
    std::thread::spawn(move || {
        std::thread::sleep(SHOWN);
        let _ = std::fs::remove_file(file);
    });
}

/// Writes a file that is new and nobody else's.
fn private(file: &Path, text: &str) -> std::io::Result<()> {
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    std::io::Write::write_all(&mut options.open(file)?, text.as_bytes())
}
