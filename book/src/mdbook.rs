//! mdBook's part: from Markdown in one folder to pages.

use std::io::Write;
use std::path::Path;
use std::sync::{Arc, Mutex};

use anyhow::ensure;
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;

use crate::markup::escaped;

/// Builds pages into a folder, whose old content goes, from a folder that holds `SUMMARY.md` and all that it lists.
/// Settings and theme are in the book's own folder. What mdBook would only warn of is an error.
///
/// # Errors
/// What mdBook says.
pub(crate) fn build(book: &Path, source: &Path, out: &Path) -> anyhow::Result<()> {
    let mut config = settings(book)?;
    config.book.src = source.into();
    config.build.build_dir = std::path::absolute(out)?;
    let mdbook = MDBook::load_with_config(book, config)?;
    let warnings = Warnings::default();
    let writer = warnings.clone();
    let subscriber = tracing_subscriber::fmt()
        .with_max_level(tracing::Level::WARN)
        .with_ansi(false)
        .without_time()
        .with_writer(move || writer.clone())
        .finish();
    tracing::subscriber::with_default(subscriber, || mdbook.build())?;
    let text =
        warnings.0.lock().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
    ensure!(text.is_empty(), "mdBook warns: {}", text.trim());
    Ok(())
}

/// The book's settings; as in mdBook's own program, `MDBOOK_OUTPUT__HTML__SITE_URL` in the environment stands above
/// `site-url` in the file, and so on.
fn settings(book: &Path) -> anyhow::Result<Config> {
    let mut config = Config::from_disk(book.join("book.toml"))?;
    config.update_from_env()?;
    Ok(config)
}

/// How a reader tells of a mistake: a link to the issues of the repository that the settings name, or else words.
///
/// # Errors
/// Where the settings cannot be read.
pub(crate) fn issues(book: &Path) -> anyhow::Result<String> {
    let config = settings(book)?;
    let address: Option<String> = config.get("output.html.git-repository-url")?;
    Ok(match address {
        Some(address) => {
            let address = escaped(address.trim_end_matches('/'));
            format!("<a href=\"{address}/issues\">Tell us</a>.")
        }
        None => "Tell us where you have the course from; <code>git remote get-url origin</code> knows the address, and \
                 <em>Issues</em> is the place."
            .into(),
    })
}

/// Where mdBook's warnings go.
#[derive(Clone, Default)]
struct Warnings(Arc<Mutex<Vec<u8>>>);

impl Write for Warnings {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if let Ok(mut all) = self.0.lock() {
            all.extend_from_slice(bytes);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
