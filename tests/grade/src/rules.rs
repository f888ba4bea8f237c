//! What an instructor's file says of weights and deadlines, and when was handed in what.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, bail};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use serde::Deserialize;
use toml::Spanned;
use toml::value::Datetime;

use crate::submitted::{self, Submitted};

/// Weights, deadlines, and what being late costs. What is not said is 1, none, and nothing.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rules {
    #[serde(default)]
    pub(crate) late: Late,
    #[serde(default)]
    lessons: BTreeMap<Spanned<String>, Lesson>,
    #[serde(skip)]
    submitted: Submitted,
}

/// What being late costs.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Late {
    /// Days that each student has for all lessons together.
    #[serde(default)]
    pub(crate) free_days: Number<100>,
    /// What each further day takes of a lesson's points, in hundredths of them.
    #[serde(default)]
    pub(crate) penalty: Number<100>,
    /// How many days after the deadline something is accepted, be they free or not.
    pub(crate) last_day: Option<Number<1000>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Lesson {
    #[serde(default = "once")]
    weight: Number<1000>,
    due: Option<Due>,
}

/// A number from 0 to the largest that makes sense.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(try_from = "i64")]
pub(crate) struct Number<const MOST: u32>(pub(crate) u32);

impl<const MOST: u32> TryFrom<i64> for Number<MOST> {
    type Error = String;

    fn try_from(number: i64) -> Result<Self, String> {
        let number = u32::try_from(number).ok().filter(|number| *number <= MOST);
        number.map(Self).ok_or_else(|| format!("it is to be a number from 0 to {MOST}"))
    }
}

fn once() -> Number<1000> {
    Number(1)
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "Datetime")]
struct Due(Timestamp);

impl TryFrom<Datetime> for Due {
    type Error = &'static str;

    fn try_from(time: Datetime) -> Result<Self, &'static str> {
        time.to_string().parse().map(Self).map_err(|_| submitted::TIME)
    }
}

impl Rules {
    /// Reads the rules, and when was handed in what.
    ///
    /// # Errors
    /// Where a file cannot be read, or has something in it that is not understood: its name and the line.
    fn read(flags: &Flags, rules: &Path, lessons: &[String]) -> anyhow::Result<Self> {
        let text = read(rules)?;
        let parsed = Self::parse(&text, lessons);
        let mut own = parsed.map_err(|(line, why)| anyhow!("{}:{line}: {why}", rules.display()))?;
        let due = own.lessons.iter().find(|(_, lesson)| lesson.due.is_some()).map(|(name, _)| name.get_ref());
        match (&flags.submitted, due) {
            (Some(path), _) => {
                let times = Submitted::read(path, &read(path)?, lessons, flags.zone.as_ref());
                own.submitted = times.map_err(|(line, why)| anyhow!("{}:{line}: {why}", path.display()))?;
            }
            (None, Some(lesson)) => {
                bail!(
                    "{}: {lesson} has a deadline: give --submitted FILE, which says when was handed in what",
                    rules.display()
                );
            }
            (None, None) => (),
        }
        Ok(own)
    }

    fn parse(text: &str, lessons: &[String]) -> Result<Self, (usize, String)> {
        let line = |at: usize| 1 + text[..at].matches('\n').count();
        let rules: Self = toml::from_str(text).map_err(|error| {
            (error.span().map_or(1, |span| line(span.start)), error.message().replace('\n', " "))
        })?;
        match rules.lessons.keys().find(|name| !lessons.contains(name.get_ref())) {
            Some(name) => Err((line(name.span().start), unknown(name.get_ref(), lessons))),
            None => Ok(rules),
        }
    }

    /// How often a lesson's points count.
    pub(crate) fn weight(&self, lesson: &str) -> u32 {
        self.lesson(lesson).map_or(1, |lesson| lesson.weight.0)
    }

    /// How many days late something was handed in, those that have begun included.
    ///
    /// # Errors
    /// Where there is a deadline, and it is not said when that was.
    pub(crate) fn days_late(&self, submission: &str, lesson: &str) -> anyhow::Result<u32> {
        let Some(Due(due)) = self.lesson(lesson).and_then(|lesson| lesson.due) else { return Ok(0) };
        let submitted = self.submitted.at(submission, lesson).with_context(|| {
            format!("--submitted does not say when {submission} handed in {lesson}, which has a deadline: add a row")
        })?;
        let late = submitted.duration_since(due).as_nanos().max(0).cast_unsigned();
        Ok(u32::try_from(late.div_ceil(86_400_000_000_000)).unwrap_or(u32::MAX))
    }

    fn lesson(&self, name: &str) -> Option<&Lesson> {
        self.lessons.iter().find(|(own, _)| own.get_ref() == name).map(|(_, lesson)| lesson)
    }
}

fn read(path: &Path) -> anyhow::Result<String> {
    let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(text.trim_start_matches('\u{feff}').to_string())
}

pub(crate) fn unknown(lesson: &str, lessons: &[String]) -> String {
    let first = lessons.first().map_or("01-lines", String::as_str);
    format!("`{lesson}` is no lesson: they are called as in {first}")
}

/// The flags that name these files.
#[derive(clap::Args)]
#[group(skip)]
pub(crate) struct Flags {
    /// Weights and late days, in TOML: the points that they come to stand beside the others.
    #[arg(long, value_name = "FILE")]
    rules: Option<PathBuf>,
    /// When was handed in what: a CSV file with the columns submission, lesson, submitted; or Moodle's grading worksheet, or
    /// Gradescope's metadata, `submission_metadata.yml`.
    #[arg(long, value_name = "FILE", requires = "rules")]
    submitted: Option<PathBuf>,
    /// The time zone of Moodle's worksheet, as in Europe/Berlin: times there are in that of who downloaded it.
    #[arg(long, requires = "submitted", value_parser = zone)]
    zone: Option<TimeZone>,
}

impl Flags {
    /// Reads the rules, if there are any.
    pub(crate) fn read(&self, course: &Path) -> anyhow::Result<Option<Rules>> {
        let Some(path) = &self.rules else { return Ok(None) };
        let lessons =
            tasks::lessons(course).with_context(|| format!("{} is not the course", course.display()))?;
        Rules::read(self, path, &lessons).map(Some)
    }
}

fn zone(name: &str) -> Result<TimeZone, String> {
    TimeZone::get(name).map_err(|_| "no time zone is called so; one is Europe/Berlin".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lessons() -> Vec<String> {
        ["01-lines", "02-wireframe"].map(String::from).to_vec()
    }

    const RULES: &str = "[late]\nfree_days = 2\npenalty = 10\nlast_day = 7\n\n[lessons.01-lines]\nweight = 3\n\
                         due = 2026-10-05T23:59:00+02:00\n";

    #[test]
    fn rules_are_read() {
        let mut rules = Rules::parse(RULES, &lessons()).unwrap();
        assert_eq!(
            [rules.late.free_days.0, rules.late.penalty.0, rules.late.last_day.unwrap().0],
            [2, 10, 7]
        );
        assert_eq!(["01-lines", "02-wireframe"].map(|lesson| rules.weight(lesson)), [3, 1]);
        rules.submitted = submitted::table(
            "submitted,submission\n2026-10-05T21:59:00Z,ann\n2026-10-05T21:59:01Z,ben\n\
             2026-10-06T23:59:00+02:00,cem\n2026-10-07T00:00:00+02:00,di\n",
            &lessons(),
        )
        .unwrap();
        let days = ["ann", "ben", "cem", "di"].map(|name| rules.days_late(name, "01-lines").unwrap());
        assert_eq!(days, [0, 1, 1, 2]);
        assert_eq!(rules.days_late("eva", "02-wireframe").unwrap(), 0);
        let unsaid = rules.days_late("eva", "01-lines").unwrap_err().to_string();
        assert!(unsaid.contains("when eva handed in 01-lines"), "{unsaid}");
    }

    #[test]
    fn what_is_not_understood_is_told_with_its_line() {
        for (text, line, words) in [
            ("[late]\npenalty = 10\npenalti = 5\n", 3, "unknown field `penalti`"),
            ("[lat]\n", 1, "unknown field `lat`"),
            ("[late]\n\npenalty = 101", 3, "a number from 0 to 100"),
            ("[late]\nfree_days = -1", 2, "a number from 0 to 100"),
            ("[late]\nfree_days = 1.5", 2, "invalid type: floating point `1.5`"),
            ("[lessons.01-lines]\nweight = 2\n[lessons.03-lines]\n", 3, "`03-lines` is no lesson"),
            ("[lessons.01-lines]\ndue = 2026-10-05T23:59:00", 2, "with its offset from UTC"),
            ("[lessons.01-lines]\ndue = 2026-10-05", 2, "with its offset from UTC"),
            ("[lessons.01-lines]\ndue = \"Monday\"", 2, "invalid type"),
            ("[lessons.01-lines]\nwight = 1", 2, "unknown field `wight`"),
            ("[late]\npenalty = 1\n[late]\n", 3, "duplicate key"),
            ("[late", 1, "unclosed table"),
        ] {
            let (at, why) = Rules::parse(text, &lessons()).unwrap_err();
            assert!(at == line && why.contains(words) && !why.contains('\n'), "{text}: {at}: {why}");
        }
    }
}
