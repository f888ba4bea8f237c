//! Reports without names, for a second marker or for showing: whoever has the key knows who is who, and nobody else.
//!
//! A student's pseudonym is a digest of the class' secret seed and of the name, so that it stays the same for a term. In
//! what students, their programs and their compiler said, names are struck out, those of others too.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use anyhow::{Context, anyhow, ensure};
use regex::{Regex, RegexBuilder};

use super::csv::harmless;
use super::{PAGE, csv, html, student};
use crate::file;
use crate::marks::Marks;
use crate::results::{Class, Outcome, Work};

/// Where they are.
const FOLDER: &str = "anonymous";
/// Where it is said who is who: beside that folder, which can be given away as it is.
const KEY: &str = "anonymous-key-keep-it-to-yourself.csv";
/// What stands where a name was.
const STRUCK: &str = "[…]";
/// From how many letters on a name is struck out within a word, too, as in `AnnSmith.rs`.
const WITHIN: usize = 4;

/// Writes them. Beside the names of submissions, others are known that students have, as in a roster.
pub(super) fn write(
    class: &Class,
    marks: Option<&Marks>,
    others: &[String],
    folder: &Path,
) -> anyhow::Result<()> {
    let key = pseudonyms(class)?;
    let (class, marks) = (anonymous(class, others, &key)?, marks.map(|marks| renamed(marks, &key)));
    let (out, marks) = (folder.join(FOLDER), marks.as_ref());
    // Those of another seed have other names.
    if out.exists() {
        std::fs::remove_dir_all(&out).with_context(|| format!("cannot clear {}", out.display()))?;
    }
    file::write(&out.join("grades.csv"), &csv::grades(&class, marks)?)?;
    for (name, works) in &class.submissions {
        let page = student::page(&class, name, works, marks)?;
        file::write(&out.join(student::file(name)), page.as_bytes())?;
    }
    file::write(&out.join(PAGE), html::page(&class, marks)?.as_bytes())?;

    let mut table = ::csv::Writer::from_writer("\u{feff}".as_bytes().to_vec());
    table.write_record(["pseudonym", "submission (whoever has this file knows who is who)"])?;
    let rows: BTreeMap<&String, &String> = key.iter().map(|(name, pseudonym)| (pseudonym, name)).collect();
    rows.into_iter().try_for_each(|(pseudonym, name)| table.write_record([pseudonym, &harmless(name)]))?;
    file::write(&folder.join(KEY), &table.into_inner().map_err(|error| anyhow!("{error}"))?)
}

/// What each is called.
fn pseudonyms(class: &Class) -> anyhow::Result<BTreeMap<String, String>> {
    let seed = class.seed.to_le_bytes();
    let pseudonym = |name: &String| {
        let digest = file::digest([b"pseudonym".as_slice(), &seed, name.as_bytes()]);
        (name.clone(), format!("student-{}", &digest[..12]))
    };
    let all: BTreeMap<String, String> = class.submissions.keys().map(pseudonym).collect();
    let different: BTreeSet<&String> = all.values().collect();
    ensure!(different.len() == all.len(), "two pseudonyms are the same: give another --seed");
    Ok(all)
}

fn renamed(marks: &Marks, key: &BTreeMap<String, String>) -> Marks {
    let students = marks.students.iter().map(|(name, own)| (key[name].clone(), own.clone())).collect();
    Marks { of: marks.of, of_lessons: marks.of_lessons.clone(), students }
}

/// The class under other names, and without those that are known in what was said.
fn anonymous(class: &Class, others: &[String], key: &BTreeMap<String, String>) -> anyhow::Result<Class> {
    let names = class.submissions.keys().chain(others).map(String::as_str);
    let names = Names::new(names, class.lessons.iter().map(|lesson| lesson.name.as_str()))?;
    let work = |work: &Work| Work { text: work.text.clone(), outcome: without(&work.outcome, &names) };
    let submissions = class.submissions.iter();
    let submissions =
        submissions.map(|(name, works)| (key[name].clone(), works.iter().map(work).collect())).collect();
    let late = class.late.iter().filter_map(|name| key.get(name).cloned()).collect();
    Ok(Class { submissions, late, ..class.clone() })
}

/// An outcome, in which names are struck out.
fn without(outcome: &Outcome, names: &Names) -> Outcome {
    let mut outcome = outcome.clone();
    match &mut outcome {
        Outcome::Missing => (),
        Outcome::NotGraded(look) => {
            for text in [&mut look.found, &mut look.because, &mut look.cure] {
                names.strike(text);
            }
        }
        Outcome::NotCompiled(said) => names.strike(said),
        Outcome::Ran { checks, printed } => {
            names.strike(printed);
            let told = checks.iter_mut().flat_map(|check| &mut check.told);
            told.flat_map(|wrong| &mut wrong.findings).for_each(|finding| names.strike(finding));
        }
    }
    outcome
}

/// Names, and the words that they consist of.
struct Names(Option<Regex>);

impl Names {
    /// The words of lessons are no names: `lines` of `lines-ann`, as GitHub Classroom calls it.
    fn new<'a>(
        names: impl Iterator<Item = &'a str>,
        lessons: impl Iterator<Item = &'a str>,
    ) -> anyhow::Result<Self> {
        let split =
            |text: &'a str| text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        let known: BTreeSet<String> = lessons.flat_map(split).map(str::to_lowercase).collect();
        let mut words: BTreeSet<String> = BTreeSet::new();
        for name in names {
            words.extend(split(name).chain([name]).map(str::to_lowercase));
        }
        // A letter is no name, nor is a short number: there are many in what is said of pixels.
        let telling = |word: &String| {
            let least = if word.bytes().all(|byte| byte.is_ascii_digit()) { WITHIN } else { 2 };
            word.chars().count() >= least && !known.contains(word)
        };
        let mut words: Vec<String> = words.into_iter().filter(telling).collect();
        if words.is_empty() {
            return Ok(Self(None));
        }
        words.sort_by_key(|word| std::cmp::Reverse(word.len()));
        let any = words.iter().map(|word| regex::escape(word)).collect::<Vec<_>>().join("|");
        let any = RegexBuilder::new(&any).case_insensitive(true).size_limit(1 << 30).build();
        Ok(Self(Some(any.context("there are too many names")?)))
    }

    fn strike(&self, text: &mut String) {
        let Some(any) = &self.0 else { return };
        let (mut rest, mut from) = (String::new(), 0);
        let mut at = 0;
        while let Some(found) = any.find_at(text, at) {
            let before = text[..found.start()].chars().next_back();
            let after = text[found.end()..].chars().next();
            let alone = ![before, after].into_iter().flatten().any(char::is_alphanumeric);
            if alone || found.as_str().chars().count() >= WITHIN {
                rest += &text[from..found.start()];
                rest += STRUCK;
                (from, at) = (found.end(), found.end());
            } else {
                at = found.start() + text[found.start()..].chars().next().map_or(1, char::len_utf8);
            }
        }
        rest += &text[from..];
        *text = rest;
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::btree_set;
    use proptest::prelude::*;

    use super::*;
    use crate::report::{Extras, Roster};
    use crate::results::{Check, Judged, Lesson, Look, Wrong};

    #[test]
    fn names_are_struck_out_and_words_of_lessons_are_not() {
        let names = ["smithann_4711", "lines-Eva", "Li", "Zoë O'Neil"];
        let names = Names::new(names.into_iter(), ["01-lines"].into_iter()).unwrap();
        for (said, left) in [
            ("// by Smithann, 4711", "// by […], […]"),
            ("my_lines: eva's line", "my_lines: […]'s line"),
            ("MySmithAnn.rs, ZOË", "My[…].rs, ZOË"),
            ("lines of Li-like evaluation (47, 11)", "lines of […]-like evaluation (47, 11)"),
            ("zoë o'neil", "[…]"),
            ("", ""),
        ] {
            let mut text = said.to_string();
            names.strike(&mut text);
            assert_eq!(text, left.replace("ZOË", "[…]"), "{said}");
        }
        assert!(Names::new(["a", "7"].into_iter(), [].into_iter()).unwrap().0.is_none());
    }

    /// A class in which everyone names everyone, in all that can be said.
    fn class(names: &BTreeSet<String>) -> Class {
        let said: String = names.iter().map(|name| format!("// {name}, {}\n", name.to_lowercase())).collect();
        let glued = |name: &str| format!("My{}File.rs", name.split('_').next().unwrap_or_default());
        let check = Check { name: "a".into(), asks: "what".into(), points: 10 };
        let outcome = |(n, name): (usize, &String)| match n % 4 {
            0 => Outcome::NotCompiled(said.clone()),
            1 => Outcome::NotGraded(Look { found: glued(name), because: said.clone(), cure: said.clone() }),
            2 => Outcome::Missing,
            _ => {
                let told = vec![Wrong { input: "one".into(), findings: vec![format!("panicked: {said}")] }];
                let judged = Judged { earned: 3, cause: None, inputs: 2, wrong: 1, told, pictures: None };
                Outcome::Ran { checks: vec![judged], printed: said.clone() }
            }
        };
        let work = |(n, name)| {
            // The first two have handed in the same file.
            let text = if n < 2 { "same".into() } else { format!("{n}") };
            (String::clone(name), vec![Work { text, outcome: outcome((n, name)) }])
        };
        let submissions = names.iter().enumerate().map(work).collect();
        Class {
            seed: 7,
            lessons: vec![Lesson { name: "01-lines".into(), checks: vec![check] }],
            walls: vec![],
            submissions,
            late: names.clone(),
        }
    }

    /// The names and the bytes of all files below a folder.
    fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
        let mut all = Vec::new();
        for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
            if entry.path().is_dir() {
                all.extend(files(&entry.path()));
            } else {
                let name = entry.file_name().into_string().unwrap();
                all.push((name, std::fs::read(entry.path()).unwrap()));
            }
        }
        all
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn nobody_is_named(names in btree_set("[XQZJKV][xqzjkv]{5,8}_[0-9]{9}", 1..9), login in "[xqzjkv]{8}") {
            let class = class(&names);
            let folder = tempfile::tempdir().unwrap();
            let number = names.first().unwrap().split('_').nth(1).unwrap();
            let roster = format!("Student,ID,SIS Login ID\n\"Vz{login}, A\",{number},{login}\n");
            std::fs::write(folder.path().join("roster.csv"), roster).unwrap();
            let roster = Some(Roster::read(&folder.path().join("roster.csv")).unwrap());
            let extras = Extras { roster, anonymous: true, ..Extras::default() };
            crate::report::write(&class, vec![], &extras, folder.path()).unwrap();

            let key = std::fs::read_to_string(folder.path().join(KEY)).unwrap();
            let parts = names.iter().flat_map(|name| name.split('_')).chain([login.as_str()]);
            let parts: Vec<String> = parts.map(str::to_lowercase).collect();
            let files = files(&folder.path().join(FOLDER));
            prop_assert_eq!(files.len(), names.len() + 2);
            for (file, bytes) in &files {
                let text = format!("{file} {}", String::from_utf8_lossy(bytes)).to_lowercase();
                for part in &parts {
                    prop_assert!(!text.contains(part), "{part} in {file}: {text}");
                }
            }
            // Who has the key finds everyone.
            for name in &names {
                let line = key.lines().find(|line| line.ends_with(&format!(",{name}"))).unwrap();
                let page = format!("{}.html", line.split(',').next().unwrap());
                prop_assert!(files.iter().any(|(file, _)| *file == page), "{page}");
            }
            // A name stays the same when others come, and is another one with another seed.
            let own = |class: &Class| pseudonyms(class).unwrap().pop_first().unwrap();
            let first: BTreeSet<String> = names.iter().take(1).cloned().collect();
            prop_assert_eq!(own(&class), own(&self::class(&first)));
            prop_assert_ne!(own(&class), own(&Class { seed: 8, ..class.clone() }));
        }
    }
}
