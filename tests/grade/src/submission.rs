//! What was handed in: of each student a folder, an archive or some files, of which one file a lesson is read.
//!
//! A file is never chosen by guess. Where there are two that differ, or none at a place that is known but others, a
//! person has to look.

mod files;
mod place;
mod systems;

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

use crate::file;
use crate::results::Look;
use files::{Entry, Files};
use place::{Place, place};

/// How long a name may be, in bytes. A file system takes 255.
const LONGEST: usize = 160;
/// How many files are told by name.
const TOLD: usize = 3;

/// What one student, or group, handed in.
pub(crate) struct Submission {
    /// Its name, in which what is not plain text is written as `%` and two digits: no two are the same.
    pub(crate) name: String,
    /// Files and folders, and what they are called within the submission: nothing for its folder.
    parts: Vec<(PathBuf, String)>,
    /// Whether Canvas has marked any of it as late; other systems mark nothing.
    pub(crate) late: bool,
}

/// What there is of a lesson.
#[derive(Debug, PartialEq)]
pub(crate) enum Source {
    /// The text of the mission's file, as it is.
    Text(Vec<u8>),
    /// No file.
    Missing,
    /// Something that a person has to look at.
    NotRead(Look),
}

/// What a file can be told by.
pub(crate) struct Wanted<'a> {
    /// All lessons of the course.
    pub(crate) lessons: &'a [String],
    /// Whether no other one is wanted, so that a file need not say of which it is.
    pub(crate) alone: bool,
    /// What students were given for it.
    pub(crate) handed_out: &'a HandedOut,
}

/// What students were given for a lesson.
pub(crate) struct HandedOut {
    /// Which of all lessons it is.
    lesson: usize,
    /// The mission's file.
    pub(crate) starter: Vec<u8>,
    /// The lesson's own file.
    own: Vec<u8>,
}

impl HandedOut {
    /// Reads what the course has of one of its lessons, as in `01-lines`.
    pub(crate) fn read(course: &Path, lessons: &[String], lesson: &str) -> anyhow::Result<Self> {
        let read = |file: &str| {
            let path = course.join("lessons").join(lesson).join(file);
            std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))
        };
        let place = lessons.iter().position(|other| other == lesson).context("a lesson is gone")?;
        Ok(Self { lesson: place, starter: read("mission/src/lib.rs")?, own: read("src/lib.rs")? })
    }
}

/// The submissions of a class, by name: its folders, its zip files, and what Moodle and Canvas have named.
pub(crate) fn all(class: &Path) -> anyhow::Result<Vec<Submission>> {
    let entries = std::fs::read_dir(class).with_context(|| format!("cannot read {}", class.display()))?;
    let mut found: BTreeMap<String, Vec<(PathBuf, String)>> = BTreeMap::new();
    let mut late = BTreeSet::new();
    for entry in entries {
        let entry = entry.with_context(|| format!("cannot read {}", class.display()))?;
        let name = plain(&entry.file_name());
        let kind = entry.file_type().with_context(|| format!("cannot read {}", entry.path().display()))?;
        let folder = kind.is_dir() || kind.is_symlink();
        let (owner, shown) = match systems::named(&name) {
            _ if files::is_litter(&name) => continue,
            Some(named) => {
                late.extend(named.late.then(|| named.owner.clone()));
                (named.owner, named.file.to_string())
            }
            None if folder => (name, String::new()),
            None if files::end(&name) == "zip" => (name[..name.len() - 4].to_string(), name),
            None if files::end(&name) == "rs" => (name.clone(), name),
            // A list, say.
            None => continue,
        };
        found.entry(owner).or_default().push((entry.path(), shown));
    }
    ensure!(
        !found.is_empty(),
        "{} holds no submission: each is a folder or a zip file, or named by Moodle or Canvas",
        class.display()
    );
    let bounded = |(name, mut parts): (String, Vec<(PathBuf, String)>)| {
        parts.sort();
        Submission { late: late.contains(&name), name: bounded(name), parts }
    };
    let mut all: Vec<Submission> = found.into_iter().map(bounded).collect();
    all.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(all)
}

/// A file's name as text; `%`, and what is no character of XML's or a control character, and what is not UTF-8 become `%`
/// and two digits.
fn plain(name: &OsStr) -> String {
    let escape = |bytes: &[u8]| bytes.iter().map(|byte| format!("%{byte:02X}")).collect::<String>();
    let odd = |c: char| c == '%' || c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}');
    let chunks = name.as_bytes().utf8_chunks().map(|chunk| {
        let valid: String = (chunk.valid().chars())
            .map(|c| if odd(c) { escape(c.to_string().as_bytes()) } else { c.into() })
            .collect();
        valid + &escape(chunk.invalid())
    });
    chunks.collect()
}

/// A name that can be that of a file: of a longer one the beginning, and a digest by which it differs from others.
fn bounded(name: String) -> String {
    if name.len() <= LONGEST {
        return name;
    }
    let digest = file::digest([name.as_bytes()]);
    format!("{}…{}", &name[..name.floor_char_boundary(LONGEST - 20)], &digest[..12])
}

/// What a submission is called whose file has this name.
#[cfg(test)]
pub(crate) fn name_of(bytes: &[u8]) -> String {
    bounded(plain(OsStr::from_bytes(bytes)))
}

impl Submission {
    /// The one that a folder is.
    pub(crate) fn at(folder: &Path) -> Self {
        Self { name: "submission".into(), parts: vec![(folder.into(), String::new())], late: false }
    }

    /// Looks at what is there.
    pub(crate) fn files(&self) -> HandedIn {
        let mut files = Files::default();
        self.parts.iter().for_each(|(path, shown)| files.add(path, shown, 0));
        HandedIn(files)
    }
}

/// The files of a submission.
pub(crate) struct HandedIn(Files);

impl HandedIn {
    /// Reads what was handed in for a lesson.
    pub(crate) fn source(&self, wanted: &Wanted) -> Source {
        match self.find(wanted) {
            Ok(Some(text)) => Source::Text(text),
            Ok(None) => Source::Missing,
            Err(look) => Source::NotRead(look),
        }
    }

    fn find(&self, wanted: &Wanted) -> Result<Option<Vec<u8>>, Look> {
        let Files { rust, others, closed, .. } = &self.0;
        if let Some([found, because, cure]) = closed.first() {
            return Err(look(found, because, cure));
        }
        let placed: Vec<(&Entry, Place)> =
            rust.iter().map(|entry| (entry, place(&entry.path, wanted.lessons))).collect();
        let at = |wanted: &dyn Fn(Place) -> bool| -> Vec<&Entry> {
            placed.iter().filter(|(_, place)| wanted(*place)).map(|(entry, _)| *entry).collect()
        };
        let lesson = wanted.handed_out.lesson;
        let name = &wanted.lessons[lesson];
        let missions =
            at(&|place| place == Place::Mission(lesson) || wanted.alone && place == Place::Unnamed);
        if let Some(text) = choose(&missions, wanted)? {
            return Ok(Some(text));
        }

        // None. It is said what there is that may have been meant.
        let hint = format!("name it after its lesson, as in {}.rs", wanted.lessons[0]);
        let beside = at(&|place| place == Place::Beside(lesson));
        if !beside.is_empty() {
            let cure = format!("name the mission’s file {name}.rs");
            return Err(look(&list(paths(&beside)), "none of these is the mission’s file", &cure));
        }
        let unnamed = at(&|place| place == Place::Unnamed);
        if !unnamed.is_empty() {
            let cure = format!("grade one lesson at a time, with --lessons, or {hint}");
            return Err(look(&list(paths(&unnamed)), "it is not said of which lesson it is", &cure));
        }
        // A copy of the course has much else below its top folder.
        let tops: Vec<&str> =
            rust.iter().filter_map(|entry| place::top(&entry.path, wanted.lessons)).collect();
        let of_course = |path: &str| {
            tops.iter().any(|top| path.strip_prefix(top).is_some_and(|below| below.contains('/')))
        };
        let mut elsewhere = at(&|place| place == Place::Elsewhere);
        elsewhere.retain(|entry| !of_course(&entry.path));
        if !elsewhere.is_empty() {
            let because = "neither its name nor its folder says that it is a mission’s file";
            return Err(look(&list(paths(&elsewhere)), because, &hint));
        }
        if rust.is_empty() && !others.is_empty() {
            let others = list(others.iter().map(String::as_str).collect());
            return Err(look(&others, "none of it is a Rust file", &hint));
        }
        Ok(None)
    }
}

/// Reads the mission's file of all that may be it; nothing if there is none.
fn choose(missions: &[&Entry], wanted: &Wanted) -> Result<Option<Vec<u8>>, Look> {
    // In a lesson's folder there is its own file, too.
    let missions: Vec<&Entry> = (missions.iter().copied())
        .filter(|entry| {
            let own = entry.path.strip_suffix("src/lib.rs");
            let mission = own.map(|folder| format!("{folder}mission/src/lib.rs"));
            mission.is_none_or(|mission| missions.iter().all(|other| other.path != mission))
        })
        .collect();
    let mut found: Vec<(&str, Vec<u8>)> = Vec::new();
    for entry in missions {
        let text = entry.read().map_err(|why| {
            look(&entry.path, &format!("{why:#}"), "have it handed in again as a plain file")
        })?;
        if found.iter().all(|(_, other)| !same(other, &text)) {
            found.push((&entry.path, text));
        }
    }
    // What was handed out counts where there is nothing else.
    let HandedOut { starter, own, .. } = wanted.handed_out;
    for given in [own, starter] {
        if found.len() > 1 {
            found.retain(|(_, text)| !same(text, given));
        }
    }
    match found.as_slice() {
        [] => Ok(None),
        [(path, text)] if same(text, own) => {
            Err(look(path, "it is the lesson’s own file, as it was handed out", "ask for the mission’s file"))
        }
        [(_, text)] => Ok(Some(text.clone())),
        _ => Err(look(
            &list(found.iter().map(|(path, _)| *path).collect()),
            "each of them may be the mission’s file, and they differ",
            "leave the one that counts, and give the same command again",
        )),
    }
}

/// Whether two texts are the same but for the line ends of Windows.
fn same(a: &[u8], b: &[u8]) -> bool {
    let bytes = |text| <[u8]>::iter(text).filter(|byte| **byte != b'\r');
    bytes(a).eq(bytes(b))
}

fn look(found: &str, because: &str, cure: &str) -> Look {
    Look { found: found.into(), because: because.into(), cure: cure.into() }
}

fn paths<'a>(entries: &[&'a Entry]) -> Vec<&'a str> {
    entries.iter().map(|entry| entry.path.as_str()).collect()
}

/// The first of these names, and how many more there are.
fn list(names: Vec<&str>) -> String {
    let more = names.len().saturating_sub(TOLD);
    let told = names.into_iter().take(TOLD).map(|name| bounded(name.into())).collect::<Vec<_>>().join(", ");
    if more == 0 { told } else { format!("{told} and {more} more") }
}
