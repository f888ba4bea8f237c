//! Who has handed in much the same as somebody else, whatever it was renamed and reformatted to.
//!
//! ```text
//! tokens         a text without names, numbers, comments and layout
//! fingerprints   the few hashes by which passages are found
//! compare        the passages that two texts have in common
//! page           HTML and CSV
//! ```
//!
//! What was handed out is left out, and so is what more than half of the texts of a lesson have. For n texts of t tokens,
//! reading takes time and memory in proportion to n·t, and comparing time in proportion to n²·t.

mod compare;
mod fingerprints;
mod page;
#[cfg(test)]
mod tests;
mod tokens;

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::{Path, PathBuf};

use anyhow::Context;

use crate::file;
use crate::submission::{self, HandedOut, Source, Wanted};
use compare::{Shares, shares};
use fingerprints::{Work, grams};
use tokens::{Tokens, tokens};

/// The largest text that is compared, in tokens. A mission takes some three hundred.
const LARGEST: usize = 20_000;
/// How many tokens of its own a text needs: in fewer, much is alike by chance.
const LEAST: usize = 60;
/// Of how many different texts half are what everybody has, and not what a few have from each other.
const CLASS: usize = 10;

/// What to compare.
pub(crate) struct Options {
    /// The class.
    pub(crate) class: PathBuf,
    /// Where the reports go.
    pub(crate) report: PathBuf,
    /// The course.
    pub(crate) course: PathBuf,
    /// Which lessons.
    pub(crate) lessons: Vec<String>,
    /// From which share on a pair is listed, from 0 to 1.
    pub(crate) least: f64,
    /// How many pairs are listed.
    pub(crate) most: usize,
}

/// Different texts, and who handed them in.
type Texts = BTreeMap<Vec<u8>, Vec<String>>;

/// What a person has to look at: whose, of which lesson, and what.
type Note = (String, String, String);

/// What was found in a class.
struct Found {
    lessons: Vec<Lesson>,
    /// The pairs that are listed, those with the largest shares first.
    pairs: Vec<Pair>,
    /// How many there are from the least share on.
    above: usize,
    notes: Vec<Note>,
}

/// A lesson, and all different texts of it.
struct Lesson {
    /// As in `01-lines`.
    name: String,
    texts: Vec<Text>,
    /// How many submissions have too little of their own to be compared.
    short: usize,
    /// How many tokens on average were left out of a text, since more than half have them.
    common: usize,
    /// How many pairs of students' texts have a share of so many percent, rounded down.
    counts: [usize; 101],
}

/// A text, of all who handed it in.
struct Text {
    names: Vec<String>,
    /// Whether it is the course's.
    given: bool,
    text: String,
    tokens: Tokens,
    /// Without what was handed out.
    whole: Work,
    /// Nor with what most have.
    work: Work,
}

impl Text {
    /// What of two texts is compared, if it is enough: with the course's, also what most have.
    fn with<'a>(&'a self, other: &'a Self) -> Option<(&'a Work, &'a Work)> {
        let both =
            if self.given || other.given { (&self.whole, &other.whole) } else { (&self.work, &other.work) };
        (both.0.own >= LEAST && both.1.own >= LEAST).then_some(both)
    }
}

/// Two texts of a lesson.
#[derive(Clone, Copy)]
struct Pair {
    lesson: usize,
    texts: [usize; 2],
    shares: Shares,
}

/// Compares the texts of a class, and writes the reports. Returns whether a person has to look at something.
pub(crate) fn report(options: &Options) -> anyhow::Result<bool> {
    let found = find(options)?;
    let page = options.report.join("pairs.html");
    file::write(&page, page::page(&found, options)?.as_bytes())?;
    file::write(&options.report.join("pairs.csv"), &page::table(&found)?)?;
    for (name, lesson, note) in &found.notes {
        println!("look here: {name}, {lesson}: {note}");
    }
    let compared: usize = found.lessons.iter().map(|lesson| lesson.texts.len()).sum();
    println!(
        "{compared} different texts, {} pairs of at least {:.0} %\n{}",
        found.above,
        options.least * 100.0,
        page.display()
    );
    Ok(!found.notes.is_empty())
}

fn find(options: &Options) -> anyhow::Result<Found> {
    let mut notes = Vec::new();
    let texts = read(options, &mut notes)?;
    let mut found = Found { lessons: Vec::new(), pairs: Vec::new(), above: 0, notes };
    for (name, texts) in options.lessons.iter().zip(texts) {
        let lesson = prepare(&options.course, name, texts, &mut found.notes)?;
        found.lessons.push(lesson);
        found.compare(options);
    }
    found.notes.sort();
    Ok(found)
}

/// Reads the texts of each lesson, with the names of all who handed one in.
fn read(options: &Options, notes: &mut Vec<Note>) -> anyhow::Result<Vec<Texts>> {
    let lessons = tasks::lessons(&options.course)?;
    let handed_out = |lesson: &String| HandedOut::read(&options.course, &lessons, lesson);
    let handed_out: Vec<HandedOut> = options.lessons.iter().map(handed_out).collect::<Result<_, _>>()?;
    let mut texts = vec![Texts::new(); handed_out.len()];
    for submission in submission::all(&options.class)? {
        let files = submission.files();
        for ((handed_out, texts), name) in handed_out.iter().zip(&mut texts).zip(&options.lessons) {
            let alone = options.lessons.len() == 1;
            match files.source(&Wanted { lessons: &lessons, alone, handed_out }) {
                Source::Text(text) => texts.entry(text).or_default().push(submission.name.clone()),
                Source::Missing => (),
                Source::NotRead(look) => {
                    let note =
                        format!("found {}, not compared because {}; {}", look.found, look.because, look.cure);
                    notes.push((submission.name.clone(), name.clone(), note));
                }
            }
        }
    }
    Ok(texts)
}

/// Makes the texts of a lesson comparable, and adds the course's own.
fn prepare(course: &Path, name: &str, texts: Texts, notes: &mut Vec<Note>) -> anyhow::Result<Lesson> {
    let tests = course.join("tests/lessons").join(name);
    let own = course.join("lessons").join(name);
    let starter = rust(&own.join("mission/src"))? + &rust(&tests.join("given/src"))?;
    let handed_out: HashSet<u64> = grams(&tokens(&starter).kinds).map(|(hash, _)| hash).collect();

    let mut read = Vec::new();
    for (text, names) in texts {
        let text = String::from_utf8_lossy(&text).into_owned();
        let tokens = tokens(&text);
        let note = match tokens.fault {
            _ if tokens.kinds.len() > LARGEST => Some(format!(
                "found {} tokens, not compared because no mission takes {LARGEST}; look at it by hand",
                tokens.kinds.len()
            )),
            Some((line, fault)) => Some(format!(
                "found {fault} in line {line}, so that what follows may be compared wrongly; look at it by hand"
            )),
            None => None,
        };
        if let Some(note) = note {
            notes.extend(names.iter().map(|submission| (submission.clone(), name.into(), note.clone())));
        }
        if tokens.kinds.len() <= LARGEST {
            read.push((names, text, tokens));
        }
    }
    let before: Vec<Work> = read.iter().map(|(_, _, tokens)| Work::new(tokens, &handed_out)).collect();
    let given: HashSet<u64> = handed_out.iter().copied().chain(common(&before)).collect();

    let mut lesson = Lesson { name: name.into(), texts: Vec::new(), short: 0, common: 0, counts: [0; 101] };
    let count = read.len().max(1);
    let mut left_out = 0;
    for ((names, text, tokens), whole) in read.into_iter().zip(before) {
        let work = Work::new(&tokens, &given);
        left_out += whole.own - work.own;
        if work.own < LEAST {
            lesson.short += names.len();
        }
        lesson.texts.push(Text { names, given: false, text, tokens, whole, work });
    }
    lesson.common = left_out / count;
    lesson.texts.sort_by(|a, b| a.names.cmp(&b.names));
    for (name, text) in [
        ("the lesson’s own code", rust(&own.join("src"))?),
        ("the course’s solution", std::fs::read_to_string(tests.join("solution.rs"))?),
    ] {
        let tokens = tokens(&text);
        let whole = Work::new(&tokens, &handed_out);
        let work = whole.clone();
        lesson.texts.push(Text { names: vec![name.into()], given: true, text, tokens, whole, work });
    }
    Ok(lesson)
}

/// What more than half of many texts have.
fn common(works: &[Work]) -> Vec<u64> {
    let mut counts: HashMap<u64, usize> = HashMap::new();
    if works.len() >= CLASS {
        for work in works {
            let own: HashSet<u64> = grams(&work.kinds).map(|(hash, _)| hash).collect();
            own.into_iter().for_each(|hash| *counts.entry(hash).or_default() += 1);
        }
    }
    counts.into_iter().filter(|(_, count)| *count * 2 > works.len()).map(|(hash, _)| hash).collect()
}

impl Found {
    /// Compares the texts of the last lesson, each with each.
    fn compare(&mut self, options: &Options) {
        let number = self.lessons.len() - 1;
        let lesson = &mut self.lessons[number];
        let mut counts = [0; 101];
        for (n, first) in lesson.texts.iter().enumerate() {
            for (m, second) in lesson
                .texts
                .iter()
                .enumerate()
                .skip(n + 1)
                .filter(|(_, second)| !(first.given && second.given))
            {
                let Some((one, other)) = first.with(second) else { continue };
                let shares = shares(one, other);
                if !second.given {
                    counts[percent(shares.larger())] += 1;
                }
                if shares.larger() >= options.least {
                    self.above += 1;
                    self.pairs.push(Pair { lesson: number, texts: [n, m], shares });
                }
            }
            if self.pairs.len() > 2 * options.most {
                keep(&mut self.pairs, options.most);
            }
        }
        lesson.counts = counts;
        keep(&mut self.pairs, options.most);
    }
}

/// Keeps the pairs with the largest shares, in their order.
fn keep(pairs: &mut Vec<Pair>, most: usize) {
    pairs.sort_by(|a, b| {
        let shares = |pair: &Pair| (pair.shares.larger(), pair.shares.of_first + pair.shares.of_second);
        let ((a_most, a_sum), (b_most, b_sum)) = (shares(a), shares(b));
        b_most
            .total_cmp(&a_most)
            .then(b_sum.total_cmp(&a_sum))
            .then((a.lesson, a.texts).cmp(&(b.lesson, b.texts)))
    });
    pairs.truncate(most);
}

/// A share from 0 to 1 in percent, rounded down: only all of it is 100.
fn percent(share: f64) -> usize {
    (share * 100.0) as usize
}

/// The Rust files of a folder but its program, one after the other; nothing without a folder.
fn rust(folder: &Path) -> anyhow::Result<String> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Ok(String::new()) };
    let mut paths = entries.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    paths.retain(|path| path.extension().is_some_and(|end| end == "rs") && !path.ends_with("main.rs"));
    paths.sort();
    let read = |path: &PathBuf| {
        std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
    };
    paths.iter().map(read).collect()
}
