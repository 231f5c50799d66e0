//! `lampyris view`: the lighting desk, a page in the browser.

use crate::cli::ViewerArgs;
use crate::failure::{Failure, INTERRUPTED};
use crate::{interrupt, say, scene_file, viewing};
use lampyris_desk::{Ender, Opened, Options};
use std::net::SocketAddr;
use std::process::ExitCode;
use std::time::Duration;

/// How often Ctrl-C is looked for.
const LOOK: Duration = Duration::from_millis(50);

/// Serves until Ctrl-C, or until the last page is closed, if that is asked for.
pub(crate) fn view(args: ViewerArgs) -> Result<ExitCode, Failure> {
    let options = Options {
        address: SocketAddr::new(args.listen, args.port),
        exposed: args.expose,
        file: args.scene.file.clone(),
        size: args.size.into(),
        batches: args.batches,
        threads: args.threads.map(|n| n as usize),
        ends_with_page: args.exit_with_page,
    };
    let ready = |link: &str, ender: Ender| {
        say::note(link);
        interrupt::rendering();
        std::thread::spawn(move || {
            while !interrupt::asked() {
                std::thread::sleep(LOOK);
            }
            ender.end();
        });
    };
    let open = || {
        let document = scene_file::load(&args.scene, args.quiet)?;
        let camera = viewing::asked(&args.view, &document.scene)?;
        Ok::<_, Failure>(Opened { document, camera })
    };
    lampyris_desk::serve(options, ready, open)?;
    Ok(if interrupt::asked() { ExitCode::from(INTERRUPTED) } else { ExitCode::SUCCESS })
}
