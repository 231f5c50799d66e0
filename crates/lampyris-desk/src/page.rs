//! The page's files, as they were built into the program.

/// A file of the page.
pub(crate) struct File {
    /// Where it is asked for.
    pub(crate) path: &'static str,
    /// What it is.
    pub(crate) kind: &'static str,
    pub(crate) bytes: &'static [u8],
}

macro_rules! file {
    ($path:literal, $name:literal, $kind:literal) => {
        File { path: $path, kind: $kind, bytes: include_bytes!(concat!("../web/dist/", $name)) }
    };
}

/// All of them.
pub(crate) const FILES: &[File] = &[
    file!("/", "index.html", "text/html; charset=utf-8"),
    file!("/desk.js", "desk.js", "text/javascript; charset=utf-8"),
    file!("/gizmo.js", "gizmo.js", "text/javascript; charset=utf-8"),
    file!("/desk.css", "desk.css", "text/css; charset=utf-8"),
    file!("/icons.svg", "icons.svg", "image/svg+xml"),
    file!("/THIRD-PARTY.txt", "THIRD-PARTY.txt", "text/plain; charset=utf-8"),
];

/// Which page this is: another build has another mark.
pub(crate) fn build() -> String {
    let mut mark = 0xcbf2_9ce4_8422_2325_u64;
    for byte in FILES.iter().flat_map(|file| file.bytes) {
        mark = (mark ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{}-{mark:016x}", env!("CARGO_PKG_VERSION"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the page asks for is here, and it asks nobody else.
    #[test]
    fn the_page_is_whole() {
        let html = String::from_utf8_lossy(FILES[0].bytes);
        for part in html.split(['"', '\'']).filter(|part| part.ends_with(".js") || part.ends_with(".css")) {
            let path = format!("/{}", part.trim_start_matches(['.', '/']));
            assert!(FILES.iter().any(|file| file.path == path), "{part}");
        }
        assert!(!html.contains("http://") && !html.contains("https://"));
    }
}
