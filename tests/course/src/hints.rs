//! The hints of a mission, opened one by one. They are the folded paragraphs `Hint N: …` in the chapter's part on the
//! mission; which are open is kept in `out/my-NN-name.hints`, by their numbers.

use std::collections::BTreeSet;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use common::file::write_whole;
use common::printable::shown;
use judge::marks::{ENOUGH, Standing};
use tasks::{name, number};

use super::{Missions, text};

/// The most bytes that a list of hints takes.
const LIMIT: usize = 1 << 10;

/// A hint of a chapter.
#[derive(Debug, PartialEq)]
struct Hint<'a> {
    title: &'a str,
    /// In Markdown.
    body: &'a str,
}

/// Opens the hint of that number, or else the next one that is not open, of a mission or of the one at hand. Where all
/// are open, it tells them all again.
///
/// # Errors
/// Where there is no such mission or hint, the chapter cannot be read, or what is open cannot be kept.
pub fn open(missions: &Missions, which: Option<&str>, wanted: Option<usize>) -> anyhow::Result<String> {
    let mission = missions.find(which)?;
    let (lesson, own) = (&mission.lesson, name(&mission.lesson));
    let chapter = missions.chapter(mission)?;
    let chapter = with_numbers(&chapter, number(lesson));
    let hints = hints(&chapter);
    let of = hints.len();
    ensure!(of > 0, "chapter {} has no hints", number(lesson));
    let mut opened = opened(missions, mission)?;
    let chosen = match wanted.or_else(|| (1..=of).find(|n| !opened.contains(n))) {
        Some(n) if (1..=of).contains(&n) => n..=n,
        Some(n) => bail!("there is no hint {n}; chapter {} has {of}", number(lesson)),
        None => 1..=of,
    };
    opened.extend(chosen.clone());
    keep(missions, mission, &opened)?;

    let mut said = String::new();
    for n in chosen {
        let Hint { title, body } = hints[n - 1];
        said += &text::plain(&format!("Mission {}, {own}, hint {n} of {of}: {title}", number(lesson)), "");
        said += &format!("\n{}\n", text::plain(body, "  "));
    }
    let earned = mission.mark.as_ref().map_or(0, |mark| mark.earned);
    let left = of - opened.iter().filter(|n| (1..=of).contains(*n)).count();
    said += &match left {
        0 if mission.is_enough() => {
            format!("All hints are open. Our own code: cargo run -p course -- solution {own}\n")
        }
        0 => format!(
            "All hints are open. Our own code is told of from {ENOUGH} of 10 points on; you have {earned}.\n"
        ),
        1 => format!("One more is left: cargo run -p course -- hint {own}\n"),
        left => format!("{left} more are left: cargo run -p course -- hint {own}\n"),
    };
    Ok(said)
}

/// How many hints of a mission are open, and how many there are. `None` where that cannot be known.
pub(crate) fn count(missions: &Missions, mission: &Standing) -> Option<(usize, usize)> {
    let chapter = missions.chapter(mission).ok()?;
    let of = hints(&chapter).len();
    let opened = opened(missions, mission).ok()?;
    Some((opened.iter().filter(|n| (1..=of).contains(*n)).count(), of))
}

/// A chapter with `equation 3.4` or `figure 3.2` in the place of `{{see NAME}}`, numbered as in the book: by what comes
/// before. A name that there is not stays.
fn with_numbers(chapter: &str, lesson: &str) -> String {
    let mut text = String::new();
    let mut rest = chapter;
    while let Some((before, (name, behind))) =
        rest.split_once("{{see ").and_then(|(before, behind)| Some((before, behind.split_once("}}")?)))
    {
        let equation = chapter.find(&format!("$${{#{name}}}")).map(|at| {
            // Each formula before has two, this one its first.
            format!("equation {lesson}.{}", chapter[..at].matches("$$").count() / 2 + 1)
        });
        let figure = || {
            let at = ["figure", "chart"]
                .iter()
                .find_map(|kind| chapter.find(&format!("{{{{{kind} {name}}}}}")))?;
            let before = ["{{figure ", "{{chart "].map(|kind| chapter[..at].matches(kind).count());
            Some(format!("figure {lesson}.{}", before.iter().sum::<usize>() + 1))
        };
        let number = equation.or_else(figure);
        text += before;
        text += &number.unwrap_or_else(|| format!("{{{{see {name}}}}}"));
        rest = behind;
    }
    text + rest
}

/// The hints of a chapter, in order.
fn hints(chapter: &str) -> Vec<Hint<'_>> {
    let folded = chapter.split("<details>").skip(1).filter_map(|rest| rest.split_once("</details>"));
    folded
        .filter_map(|(folded, _)| {
            let (summary, body) = folded.trim_start().strip_prefix("<summary>")?.split_once("</summary>")?;
            let (_, title) = summary.strip_prefix("Hint ")?.split_once(": ")?;
            Some(Hint { title: title.trim(), body: body.trim() })
        })
        .collect()
}

/// Where it is kept which hints are open, from the course's folder.
fn file(mission: &Standing) -> PathBuf {
    Path::new("out").join(format!("my-{}.hints", mission.lesson))
}

fn opened(missions: &Missions, mission: &Standing) -> anyhow::Result<BTreeSet<usize>> {
    let path = file(mission);
    let numbers = match fs::read(missions.course.join(&path)) {
        Ok(bytes) if bytes.len() > LIMIT => None,
        Ok(bytes) => String::from_utf8(bytes).ok(),
        Err(error) if error.kind() == ErrorKind::NotFound => Some(String::new()),
        Err(error) => return Err(error).with_context(|| format!("cannot read {}", shown(&path))),
    };
    numbers
        .and_then(|numbers| numbers.split_whitespace().map(|number| number.parse().ok()).collect())
        .with_context(|| format!("{} is not a list of hints: remove it", shown(&path)))
}

fn keep(missions: &Missions, mission: &Standing, opened: &BTreeSet<usize>) -> anyhow::Result<()> {
    fs::create_dir_all(missions.course.join("out")).context("cannot create the folder out/")?;
    let numbers: Vec<String> = opened.iter().map(usize::to_string).collect();
    write_whole(&missions.course.join(file(mission)), format!("{}\n", numbers.join(" ")).as_bytes())?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_referred_to_has_the_book_s_number() {
        let chapter = "$$a$$\n{{figure one}} $a$ {{chart two}} {{see two}}, {{see one}}\n$$b$${#named}\n$$c$$\n\
                       {{see named}} {{see nothing}} {{see";
        let text = with_numbers(chapter, "3");
        assert!(text.contains("figure 3.2, figure 3.1\n"), "{text}");
        assert!(text.ends_with("equation 3.2 {{see nothing}} {{see"), "{text}");
    }

    #[test]
    fn hints_are_what_is_folded_and_called_so() {
        let chapter = "<details>\n<summary>Why?</summary>\n\nBecause.\n\n</details>\n\n<details>\n\
                       <summary>Hint 1: where: here?</summary>\n\nHere.\n\nAnd there.\n\n</details>\n\
                       <details>\n<summary>Line by line</summary>\nfn line() {}\n</details>\n\
                       <details>\n<summary>Hint 2: an open end</summary>\n\nfn line() {}\n";
        assert_eq!(hints(chapter), [Hint { title: "where: here?", body: "Here.\n\nAnd there." }]);
    }
}
