//! Opens the book in a browser.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use anyhow::{Context, bail};
use charts::lessons::LESSONS;

use crate::html;

/// Builds the book where it is out of date, says where the page is, and opens it if asked to.
///
/// # Errors
/// Where there is no such page, or the book cannot be built.
pub(crate) fn read(page: Option<&str>, out: &Path, open: bool) -> anyhow::Result<()> {
    let name = name_of(page.unwrap_or("index"), &names()?)?;
    if !is_current(out)? {
        print!("Building the book … ");
        std::io::stdout().flush()?;
        let start = Instant::now();
        html::build(out)?;
        println!("{:.0} s", start.elapsed().as_secs_f64());
    }
    let path = out.join(name);
    println!("{}", path.display());
    if open && let Err(error) = open::that(&path) {
        println!(
            "No browser can be opened from here ({error}): open this file with yours, or show the book to it by"
        );
        println!("cargo run -p book -- serve");
    }
    Ok(())
}

/// The names of all pages, without ending.
fn names() -> anyhow::Result<Vec<String>> {
    let files = html::files(Path::new(html::BOOK), LESSONS)?;
    let mut names: Vec<String> =
        files.iter().map(|(name, _)| name.with_extension("").display().to_string()).collect();
    names.sort();
    Ok(names)
}

/// The file of a page that is asked for by its name, or as a chapter by its number or its lesson's name.
fn name_of(asked: &str, names: &[String]) -> anyhow::Result<PathBuf> {
    let number = asked.parse::<u8>().ok();
    let lesson = LESSONS.iter().map(|lesson| &lesson.lesson);
    let folder = lesson
        .filter(|lesson| Some(lesson.number) == number || lesson.name == asked)
        .map(common::Lesson::folder)
        .next();
    let name = folder.as_deref().unwrap_or_else(|| asked.trim_end_matches(".html"));
    if !names.iter().any(|known| known == name) {
        bail!("there is no page `{asked}`, but {}", names.join(", "));
    }
    Ok(Path::new(name).with_extension("html"))
}

/// Whether the book is younger than this program and whatever the pages may quote or show.
fn is_current(out: &Path) -> anyhow::Result<bool> {
    let Ok(built) = std::fs::metadata(out.join("index.html")).and_then(|index| index.modified()) else {
        return Ok(false);
    };
    let program = std::env::current_exe()?.metadata()?.modified()?;
    Ok(program < built && !is_changed(Path::new(crate::ROOT), built)?)
}

/// Whether anything in a folder was changed or removed since, but for what is built or hidden, and for the missions,
/// which no page quotes: their learners change them all the time.
fn is_changed(folder: &Path, since: SystemTime) -> anyhow::Result<bool> {
    let entries = std::fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    for entry in entries {
        let entry = entry?;
        let name = entry.file_name();
        if matches!(name.to_str(), Some("target" | "out" | "node_modules" | "mission"))
            || name.as_encoded_bytes().starts_with(b".")
        {
            continue;
        }
        let kind = entry.metadata()?;
        if kind.modified()? > since || kind.is_dir() && is_changed(&entry.path(), since)? {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_chapter_has_a_number_and_a_name() {
        let names = names().unwrap();
        for asked in ["3", "03", "triangles", "03-triangles", "03-triangles.html"] {
            assert_eq!(name_of(asked, &names).unwrap(), Path::new("03-triangles.html"), "{asked}");
        }
        assert_eq!(name_of("glossary", &names).unwrap(), Path::new("glossary.html"));
        assert_eq!(name_of("index", &names).unwrap(), Path::new("index.html"));
        for asked in ["99", "0", "nothing", "", "../README", "charts/methods"] {
            let error = name_of(asked, &names).unwrap_err().to_string();
            assert!(error.contains(&format!("`{asked}`")) && error.contains("03-triangles"), "{error}");
        }
    }

    #[test]
    fn what_was_changed_since_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("lessons/01");
        fs::create_dir_all(&inner).unwrap();
        fs::create_dir(folder.path().join("target")).unwrap();
        fs::write(inner.join("lib.rs"), "").unwrap();
        let later = SystemTime::now() + Duration::from_secs(60);
        let found = || is_changed(folder.path(), later).unwrap();
        assert!(!found());
        let much_later = later + Duration::from_secs(60);
        let touch = |path: &Path| {
            fs::File::options().append(true).create(true).open(path).unwrap().set_modified(much_later)
        };
        touch(&folder.path().join("target/made")).unwrap();
        touch(&folder.path().join(".hidden")).unwrap();
        fs::create_dir(inner.join("mission")).unwrap();
        touch(&inner.join("mission/lib.rs")).unwrap();
        assert!(!found());
        touch(&inner.join("lib.rs")).unwrap();
        assert!(found());
    }
}
