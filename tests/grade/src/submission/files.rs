//! The files of a submission, in folders and in zip files. Nothing is unpacked, and no link is followed.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, ensure};
use zip::ZipArchive;

use super::plain;

/// The largest source that is read, in bytes. A mission takes some thirty lines.
const LARGEST: u64 = 1 << 20;
/// The largest archive, in bytes.
const ARCHIVE: u64 = 64 << 20;
/// How many files a submission may have, those in archives included.
const MOST: usize = 50_000;
/// How many archives are opened.
const ARCHIVES: usize = 16;
/// How many folders deep files are looked for.
const DEEPEST: usize = 12;
/// How many folders deep archives are looked for: a copy of the course may have others.
const SHALLOW: usize = 3;
/// Ends of names of archives that are not read.
const OTHER_ARCHIVES: [&str; 8] = ["7z", "bz2", "gz", "rar", "tar", "tgz", "xz", "zst"];

/// What there is of a submission.
#[derive(Default)]
pub(super) struct Files {
    /// Those that end in `.rs`, links included.
    pub(super) rust: Vec<Entry>,
    /// Others, by their paths.
    pub(super) others: Vec<String>,
    /// What cannot be looked into, and may hold anything: the path, why, and the cure.
    pub(super) closed: Vec<[String; 3]>,
    seen: usize,
    archives: usize,
}

/// A file that may be a mission's.
pub(super) struct Entry {
    /// From the submission's folder on, as text.
    pub(super) path: String,
    at: At,
}

enum At {
    Disk(PathBuf),
    /// A file in an archive, by its number there.
    Zip(PathBuf, usize),
}

impl Entry {
    /// The file's text.
    ///
    /// # Errors
    /// Where it is no plain file, too large, or damaged; in words that go on from its name.
    pub(super) fn read(&self) -> anyhow::Result<Vec<u8>> {
        match &self.at {
            At::Disk(path) => {
                let found = std::fs::symlink_metadata(path)?;
                ensure!(!found.is_symlink(), "it is a symbolic link, which is not followed");
                ensure!(found.is_file(), "it is not a file");
                bounded(File::open(path).context("it cannot be read")?)
            }
            At::Zip(path, number) => {
                let mut archive = ZipArchive::new(BufReader::new(File::open(path)?))?;
                let entry = archive.by_index(*number)?;
                ensure!(!entry.is_symlink(), "it is a symbolic link, which is not followed");
                bounded(entry)
            }
        }
    }
}

/// Reads what is not too large, and no more of it, whatever its size is said to be.
fn bounded(file: impl Read) -> anyhow::Result<Vec<u8>> {
    let mut text = Vec::new();
    file.take(LARGEST + 1).read_to_end(&mut text)?;
    ensure!(text.len() as u64 <= LARGEST, "it is larger than {} KiB", LARGEST >> 10);
    Ok(text)
}

impl Files {
    /// Adds a file, a folder with all that is in it, or an archive.
    pub(super) fn add(&mut self, at: &Path, shown: &str, depth: usize) {
        if let Err(error) = self.try_add(at, shown, depth) {
            let cure = "make it readable, and give the same command again";
            self.close(shown, &format!("it cannot be read ({error:#})"), cure);
        }
    }

    fn close(&mut self, path: &str, why: &str, cure: &str) {
        let path = if path.is_empty() { "the folder" } else { path };
        self.closed.push([path, why, cure].map(String::from));
    }

    fn try_add(&mut self, at: &Path, shown: &str, depth: usize) -> anyhow::Result<()> {
        let kind = std::fs::symlink_metadata(at)?.file_type();
        let end = end(shown);
        if kind.is_dir() && !is_rust(shown) {
            return self.add_folder(at, shown, depth);
        }
        if !self.count(shown) {
            return Ok(());
        }
        if is_rust(shown) {
            // What is none of a file is said where it is read.
            self.rust.push(Entry { path: shown.into(), at: At::Disk(at.into()) });
        } else if kind.is_symlink() {
            let path = if shown.is_empty() { "the folder" } else { shown };
            self.others.push(format!("{path} (a symbolic link, which is not followed)"));
        } else if depth > SHALLOW {
            self.others.push(shown.into());
        } else if end == "zip" && kind.is_file() {
            if let Err(why) = self.add_archive(at, shown) {
                let cure = "unpack it by hand beside it, and remove it, or have it handed in again";
                self.close(shown, &format!("it cannot be read as a zip file ({why:#})"), cure);
            }
        } else if OTHER_ARCHIVES.contains(&&*end) {
            let cure = "unpack it by hand beside it, and remove it";
            self.close(shown, "of archives only zip files are read", cure);
        } else {
            self.others.push(shown.into());
        }
        Ok(())
    }

    fn add_folder(&mut self, at: &Path, shown: &str, depth: usize) -> anyhow::Result<()> {
        if depth > DEEPEST {
            self.others.push(format!("{shown} (too deep to look into)"));
            return Ok(());
        }
        let mut names = std::fs::read_dir(at)?
            .map(|entry| Ok(entry?.file_name()))
            .collect::<std::io::Result<Vec<_>>>()?;
        names.sort();
        for name in names {
            let own = plain(&name);
            if !is_litter(&own) {
                let path = if shown.is_empty() { own } else { format!("{shown}/{own}") };
                self.add(&at.join(name), &path, depth + 1);
            }
        }
        Ok(())
    }

    fn add_archive(&mut self, at: &Path, shown: &str) -> anyhow::Result<()> {
        self.archives += 1;
        ensure!(self.archives <= ARCHIVES, "there are more than {ARCHIVES} of them");
        let size = std::fs::metadata(at)?.len();
        ensure!(size <= ARCHIVE, "it is larger than {} MiB", ARCHIVE >> 20);
        let archive = ZipArchive::new(BufReader::new(File::open(at)?))?;
        ensure!(archive.len() <= MOST, "it has more than {MOST} files");
        ensure!(!archive.has_duplicate_names(), "two of its files have the same name");
        let mut found = Vec::new();
        for number in 0..archive.len() {
            let entry = archive.by_index_data(number)?;
            // Some programs write `\` on Windows.
            let name = entry.name()?.replace('\\', "/");
            let steps: Vec<&str> = name.split('/').filter(|step| !matches!(*step, "" | ".")).collect();
            let outside = name.starts_with('/') || name.contains(':') || steps.contains(&"..");
            ensure!(!outside, "{} leads out of it", plain(name.as_ref()));
            if entry.is_dir() || steps.iter().any(|step| is_litter(step)) {
                continue;
            }
            ensure!(steps.len() <= DEEPEST, "folders are nested more than {DEEPEST} deep");
            let path = format!("{shown}/{}", plain(steps.join("/").as_ref()));
            match (is_rust(&path), entry.encrypted()) {
                (true, true) => return Err(anyhow!("{path} is encrypted")),
                (true, false) => found.push(Entry { path, at: At::Zip(at.into(), number) }),
                (false, _) if end(&path) == "zip" => {
                    return Err(anyhow!("{path} is a zip file in a zip file"));
                }
                (false, _) => self.others.push(path),
            }
        }
        for entry in found {
            if self.count(&entry.path) {
                self.rust.push(entry);
            }
        }
        Ok(())
    }

    /// Counts a file, as long as there are not too many.
    fn count(&mut self, shown: &str) -> bool {
        self.seen += 1;
        if self.seen == MOST + 1 {
            let why = format!("there are more than {MOST} files");
            self.close(shown, &why, "remove what was built, such as the folder target/");
        }
        self.seen <= MOST
    }
}

/// Whether a name is one of those that systems and programs leave behind: hidden, or of macOS' archives.
pub(super) fn is_litter(name: &str) -> bool {
    name.starts_with('.') || ["__macosx", "target"].iter().any(|litter| name.eq_ignore_ascii_case(litter))
}

fn is_rust(name: &str) -> bool {
    end(name) == "rs"
}

/// What is after the last point of a name, in small letters.
pub(super) fn end(name: &str) -> String {
    name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase()).unwrap_or_default()
}
