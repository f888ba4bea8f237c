//! Shows the book in a browser, for those whose browser does not open files.

use std::fs::File;
use std::path::{Component, Path, PathBuf};

use anyhow::{Context, anyhow, ensure};
use tiny_http::{Header, Request, Response, Server};

/// Serves the files of a folder on this machine, until it is interrupted.
///
/// # Errors
/// Where there is no book, or the port is taken.
pub(crate) fn serve(folder: &Path, port: u16) -> anyhow::Result<()> {
    ensure!(
        folder.join("index.html").is_file(),
        "{}: there is no book here; cargo run -p book builds it",
        folder.display()
    );
    let server = Server::http(("127.0.0.1", port)).map_err(|error| anyhow!("port {port}: {error}"))?;
    let port = server.server_addr().to_ip().context("the server has no port")?.port();
    println!("http://127.0.0.1:{port}/ shows the book; Ctrl-C ends it");
    for request in server.incoming_requests() {
        // A reader that has gone away wants no answer.
        let _ = answer(request, folder);
    }
    Ok(())
}

fn answer(request: Request, folder: &Path) -> std::io::Result<()> {
    let file = path_of(request.url(), folder).and_then(|path| Some((File::open(&path).ok()?, path)));
    match file {
        Some((file, path)) => {
            let kind = Header::from_bytes("Content-Type", kind_of(&path)).expect("the kinds are plain text");
            request.respond(Response::from_file(file).with_header(kind))
        }
        None => request.respond(Response::from_string("There is no such page.\n").with_status_code(404)),
    }
}

/// The file of an address, if it lies in the folder.
fn path_of(url: &str, folder: &Path) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.trim_start_matches('/');
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let inside = path.components().all(|part| matches!(part, Component::Normal(_)));
    inside.then(|| folder.join(path))
}

fn kind_of(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css",
        Some("js") => "text/javascript",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("woff2") => "font/woff2",
        Some("csv" | "txt") => "text/plain; charset=utf-8",
        Some("json") => "application/json",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_outside_the_folder_is_served() {
        let folder = Path::new("book");
        assert_eq!(path_of("/", folder), Some("book/index.html".into()));
        assert_eq!(path_of("/a/b.svg?x#y", folder), Some("book/a/b.svg".into()));
        for url in ["/../secret", "/a/../../secret", "/./x"] {
            assert!(
                path_of(url, folder).is_none_or(|path| path.starts_with("book") && !url.contains("..")),
                "{url}"
            );
        }
    }
}
