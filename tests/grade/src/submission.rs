//! What was handed in: a folder each, of which one file a lesson is read.

use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

/// The largest source that is read, in bytes. A mission takes some thirty lines.
const LARGEST: u64 = 1 << 20;

/// A folder of the class.
pub(crate) struct Submission {
    /// Its name, in which what is not plain text is written as `%` and two digits: no two are the same.
    pub(crate) name: String,
    folder: PathBuf,
}

/// What there is of a lesson.
pub(crate) enum Source {
    /// The text of its `lib.rs`, as it is.
    Text(Vec<u8>),
    /// No file.
    Missing,
    /// A file that is not read, and why.
    Refused(String),
}

/// The submissions of a folder, by name. Files in it and hidden folders are none.
pub(crate) fn all(class: &Path) -> anyhow::Result<Vec<Submission>> {
    let entries = std::fs::read_dir(class).with_context(|| format!("cannot read {}", class.display()))?;
    let mut found = Vec::new();
    for entry in entries {
        let entry = entry.with_context(|| format!("cannot read {}", class.display()))?;
        let hidden = entry.file_name().as_bytes().starts_with(b".");
        let kind = entry.file_type().with_context(|| format!("cannot read {}", entry.path().display()))?;
        if !hidden && (kind.is_dir() || kind.is_symlink()) {
            found.push(Submission { name: plain(&entry.file_name()), folder: entry.path() });
        }
    }
    ensure!(!found.is_empty(), "{} holds no folder: each submission is one", class.display());
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// A file's name as text; `%`, control characters and what is not UTF-8 become `%` and two digits.
fn plain(name: &OsStr) -> String {
    let escape = |bytes: &[u8]| bytes.iter().map(|byte| format!("%{byte:02X}")).collect::<String>();
    let chunks = name.as_bytes().utf8_chunks().map(|chunk| {
        let valid: String = (chunk.valid().chars())
            .map(|c| if c == '%' || c.is_control() { escape(c.to_string().as_bytes()) } else { c.into() })
            .collect();
        valid + &escape(chunk.invalid())
    });
    chunks.collect()
}

impl Submission {
    /// Reads what was handed in for a lesson, such as `01-lines`: `mission/src/lib.rs` of a clone, or of its
    /// `lessons` folder alone, or a plain `01-lines.rs`; also one folder deeper, as archives are unpacked.
    pub(crate) fn source(&self, lesson: &str) -> Source {
        let places = |folder: &str| {
            [
                format!("{folder}lessons/{lesson}/mission/src/lib.rs"),
                format!("{folder}{lesson}/mission/src/lib.rs"),
                format!("{folder}{lesson}.rs"),
            ]
        };
        let deeper = only_folder(&self.folder).map(|name| places(&format!("{name}/")));
        let places = places("").into_iter().chain(deeper.into_iter().flatten());
        let look = |place: String| match read(&self.folder, Path::new(&place)) {
            Ok(None) => None,
            Ok(Some(text)) => Some(Source::Text(text)),
            Err(why) => Some(Source::Refused(why.to_string())),
        };
        places.map(look).find_map(|source| source).unwrap_or(Source::Missing)
    }
}

/// The name of the one folder in a folder, if there is but one.
fn only_folder(folder: &Path) -> Option<String> {
    let entries = std::fs::read_dir(folder).ok()?.filter_map(Result::ok);
    let mut folders = entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_dir()));
    let only = folders.next()?.file_name().into_string().ok()?;
    folders.next().is_none().then_some(only)
}

/// Reads a file below a folder, if it is there. A link is not followed, since it could lead anywhere, and
/// only a regular file is opened: another kind could be read for ever.
fn read(folder: &Path, place: &Path) -> anyhow::Result<Option<Vec<u8>>> {
    let steps: Vec<&Path> = place.ancestors().filter(|step| !step.as_os_str().is_empty()).collect();
    let paths = std::iter::once(folder.to_path_buf()).chain(steps.iter().rev().map(|step| folder.join(step)));
    for path in paths {
        let Ok(found) = std::fs::symlink_metadata(&path) else { return Ok(None) };
        let shown = path.strip_prefix(folder).unwrap_or(&path).display().to_string();
        let shown = if shown.is_empty() { "the folder".into() } else { shown };
        ensure!(!found.is_symlink(), "{shown} is a symbolic link, which is not followed");
        if path == folder.join(place) {
            ensure!(found.is_file(), "{shown} is not a file");
            ensure!(found.len() <= LARGEST, "{shown} is larger than {} KiB", LARGEST >> 10);
        }
    }
    let text =
        std::fs::read(folder.join(place)).with_context(|| format!("cannot read {}", place.display()))?;
    Ok(Some(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_no_text_stay_apart() {
        let names = [&b"a\xff"[..], b"a\xfe", b"a%FF", b"a\n", b"O'Neil \"x\"", "é".as_bytes()];
        let plain = names.map(|name| plain(OsStr::from_bytes(name)));
        assert_eq!(plain, ["a%FF", "a%FE", "a%25FF", "a%0A", "O'Neil \"x\"", "é"]);
    }

    #[test]
    fn a_file_is_found_in_each_of_its_places_and_nowhere_else() {
        for (place, found) in [
            ("lessons/01-lines/mission/src/lib.rs", true),
            ("01-lines/mission/src/lib.rs", true),
            ("01-lines.rs", true),
            ("top/lessons/01-lines/mission/src/lib.rs", true),
            // The lesson's own.
            ("lessons/01-lines/src/lib.rs", false),
            ("top/more/01-lines.rs", false),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join(place);
            std::fs::create_dir_all(file.parent().unwrap()).unwrap();
            std::fs::write(file, "text").unwrap();
            let submission = Submission { name: "a".into(), folder: folder.path().into() };
            let text = matches!(submission.source("01-lines"), Source::Text(text) if text == b"text");
            assert_eq!(text, found, "{place}");
        }
    }
}
