//! What an instructor's file says of weights and deadlines, and when was handed in what.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, bail};
use jiff::Timestamp;
use serde::Deserialize;
use toml::Spanned;
use toml::value::Datetime;

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

/// What is said of a time that may be meant otherwise elsewhere.
const TIME: &str = "a time is to be written with its offset from UTC, as in 2026-10-05T23:59:00+02:00";

impl TryFrom<Datetime> for Due {
    type Error = &'static str;

    fn try_from(time: Datetime) -> Result<Self, &'static str> {
        time.to_string().parse().map(Self).map_err(|_| TIME)
    }
}

/// By submission and lesson; for all lessons if no lesson is named.
type Submitted = BTreeMap<(String, Option<String>), Timestamp>;

impl Rules {
    /// Reads the rules, and when was handed in what.
    ///
    /// # Errors
    /// Where a file cannot be read, or has something in it that is not understood: its name and the line.
    pub(crate) fn read(rules: &Path, submitted: Option<&Path>, lessons: &[String]) -> anyhow::Result<Self> {
        let text = read(rules)?;
        let parsed = Self::parse(&text, lessons);
        let mut own = parsed.map_err(|(line, why)| anyhow!("{}:{line}: {why}", rules.display()))?;
        let due = own.lessons.iter().find(|(_, lesson)| lesson.due.is_some()).map(|(name, _)| name.get_ref());
        match (submitted, due) {
            (Some(path), _) => {
                let times = times(&read(path)?, lessons);
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
        let at = |lesson: Option<&str>| self.submitted.get(&(submission.into(), lesson.map(String::from)));
        let submitted = at(Some(lesson)).or_else(|| at(None)).with_context(|| {
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

fn unknown(lesson: &str, lessons: &[String]) -> String {
    let first = lessons.first().map_or("01-lines", String::as_str);
    format!("`{lesson}` is no lesson: they are called as in {first}")
}

/// A row of the table of times.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    submission: String,
    lesson: Option<String>,
    submitted: String,
}

/// Reads a table with the columns `submission`, `submitted` and, if it is not the same for all, `lesson`.
fn times(text: &str, lessons: &[String]) -> Result<Submitted, (u64, String)> {
    let mut table = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let head = table.headers().map_err(|error| (1, error.to_string()))?.clone();
    let mut all = Submitted::new();
    for record in table.records() {
        let line = |error: &csv::Error| error.position().map_or(1, csv::Position::line);
        let record = record
            .map_err(|error| (line(&error), "a row has more or fewer cells than the head".to_string()))?;
        let at = record.position().map_or(1, csv::Position::line);
        let wrong = |why: String| (at, why);
        let row: Row = record.deserialize(Some(&head)).map_err(|error| match error.into_kind() {
            csv::ErrorKind::Deserialize { err, .. } => wrong(err.kind().to_string()),
            _ => wrong("it is not understood".into()),
        })?;
        if let Some(lesson) = row.lesson.as_ref().filter(|lesson| !lessons.contains(lesson)) {
            return Err(wrong(unknown(lesson, lessons)));
        }
        let time = row.submitted.parse().map_err(|_| wrong(format!("`{}`: {TIME}", row.submitted)))?;
        if all.insert((row.submission.clone(), row.lesson), time).is_some() {
            return Err(wrong(format!("there are two times for {}", row.submission)));
        }
    }
    Ok(all)
}

/// The flags that name these files.
#[derive(clap::Args)]
#[group(skip)]
pub(crate) struct Flags {
    /// Weights and late days, in TOML: the points that they come to stand beside the others.
    #[arg(long, value_name = "FILE")]
    rules: Option<PathBuf>,
    /// When was handed in what: a CSV file with the columns submission, lesson, submitted.
    #[arg(long, value_name = "FILE", requires = "rules")]
    submitted: Option<PathBuf>,
}

impl Flags {
    /// Reads the rules, if there are any.
    pub(crate) fn read(&self, course: &Path) -> anyhow::Result<Option<Rules>> {
        let Some(path) = &self.rules else { return Ok(None) };
        let lessons =
            tasks::lessons(course).with_context(|| format!("{} is not the course", course.display()))?;
        Rules::read(path, self.submitted.as_deref(), &lessons).map(Some)
    }
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
        rules.submitted = times(
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
        for (text, line, words) in [
            (
                "submission,submitted\nann,2026-10-05\n",
                2,
                "`2026-10-05`: a time is to be written with its offset",
            ),
            ("submission,submitted\nann,2026-10-05T10:00:00\n", 2, "with its offset"),
            (
                "submission,submitted\n\nann,2026-10-05T10:00:00Z\nann,2026-10-05T10:00:00Z\n",
                4,
                "two times for ann",
            ),
            ("submission,lesson,submitted\nann,lines,2026-10-05T10:00:00Z\n", 2, "`lines` is no lesson"),
            ("submission,submitted\nann\n", 2, "more or fewer cells"),
            ("name,submitted\nann,2026-10-05T10:00:00Z\n", 2, "unknown field `name`"),
        ] {
            let (at, why) = times(text, &lessons()).unwrap_err();
            assert!(at == line && why.contains(words) && !why.contains('\n'), "{text}: {at}: {why}");
        }
    }
}
