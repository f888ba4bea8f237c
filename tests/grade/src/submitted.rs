//! When was handed in what: a table of our own, Moodle's grading worksheet, or Gradescope's metadata.

use std::collections::BTreeMap;
use std::path::Path;

use csv::{ErrorKind, Position, Reader, ReaderBuilder, StringRecord, Trim};
use jiff::Timestamp;
use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use saphyr::{LoadableYamlNode, Yaml};
use serde::Deserialize;

use crate::rules::unknown;

/// What is said of a time that may be meant otherwise elsewhere.
pub(crate) const TIME: &str =
    "a time is to be written with its offset from UTC, as in 2026-10-05T23:59:00+02:00";

/// The column of Moodle's worksheet, downloaded in English.
const MODIFIED: &str = "Last modified (submission)";

/// How Moodle writes times: in English, with or without the clock of 12 hours, and in American English.
const MOODLE: [&str; 3] = ["%A, %d %B %Y, %I:%M %p", "%A, %d %B %Y, %H:%M", "%A, %B %d, %Y, %I:%M %p"];

/// When was handed in what.
#[derive(Clone, Debug)]
pub(crate) enum Submitted {
    /// By submission and lesson; for all lessons if no lesson is named.
    Named(BTreeMap<(String, Option<String>), Timestamp>),
    /// By the number with which a submission's name ends, as in `Ann Smith_1234`.
    Numbered(BTreeMap<String, Timestamp>),
}

impl Default for Submitted {
    fn default() -> Self {
        Self::Named(BTreeMap::new())
    }
}

impl Submitted {
    /// Reads a file of one of the three kinds.
    ///
    /// # Errors
    /// What is not understood, and its line.
    pub(crate) fn read(
        path: &Path,
        text: &str,
        lessons: &[String],
        zone: Option<&TimeZone>,
    ) -> Result<Self, (u64, String)> {
        let metadata = path.extension().is_some_and(|end| end == "yml" || end == "yaml");
        let mut head = ReaderBuilder::new().trim(Trim::All).from_reader(text.as_bytes());
        let worksheet = head.headers().is_ok_and(|head| head.iter().any(|name| name == "Identifier"));
        match (worksheet, zone) {
            _ if metadata => gradescope(text),
            (true, Some(zone)) => moodle(head, zone),
            (true, None) => Err((
                1,
                "Moodle’s worksheet does not say its time zone: add --zone, as in --zone Europe/Berlin"
                    .into(),
            )),
            (false, _) => table(text, lessons),
        }
    }

    /// When something was handed in, if that is said.
    pub(crate) fn at(&self, submission: &str, lesson: &str) -> Option<Timestamp> {
        match self {
            Self::Named(all) => {
                let at = |lesson: Option<&str>| all.get(&(submission.into(), lesson.map(String::from)));
                at(Some(lesson)).or_else(|| at(None)).copied()
            }
            Self::Numbered(all) => all.get(submission.rsplit_once('_')?.1).copied(),
        }
    }
}

/// A row of our table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    submission: String,
    lesson: Option<String>,
    submitted: String,
}

/// Reads a table with the columns `submission`, `submitted` and, if it is not the same for all, `lesson`.
pub(crate) fn table(text: &str, lessons: &[String]) -> Result<Submitted, (u64, String)> {
    let mut table = ReaderBuilder::new().trim(Trim::All).from_reader(text.as_bytes());
    let head = table.headers().map_err(|error| (1, error.to_string()))?.clone();
    let mut all = BTreeMap::new();
    for record in table.records() {
        let (at, record) = whole(record)?;
        let wrong = |why: String| (at, why);
        let row: Row = record.deserialize(Some(&head)).map_err(|error| match error.into_kind() {
            ErrorKind::Deserialize { err, .. } => wrong(err.kind().to_string()),
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
    Ok(Submitted::Named(all))
}

/// A row and its line.
fn whole(record: csv::Result<StringRecord>) -> Result<(u64, StringRecord), (u64, String)> {
    let line = |error: &csv::Error| error.position().map_or(1, Position::line);
    let record =
        record.map_err(|error| (line(&error), "a row has more or fewer cells than the head".to_string()))?;
    Ok((record.position().map_or(1, Position::line), record))
}

/// Reads Moodle's worksheet: its numbers are those in the names of the download. Who has handed in nothing has a dash there.
fn moodle(mut table: Reader<&[u8]>, zone: &TimeZone) -> Result<Submitted, (u64, String)> {
    let head = table.headers().map_err(|error| (1, error.to_string()))?.clone();
    let column = |name: &str| {
        let found = head.iter().position(|own| own == name);
        found.ok_or_else(|| (1, format!("Moodle’s worksheet has no column `{name}`: download it in English")))
    };
    let (number, modified) = (column("Identifier")?, column(MODIFIED)?);
    let mut all = BTreeMap::new();
    for record in table.records() {
        let (at, record) = whole(record)?;
        let number = record[number].trim_start_matches("Participant").trim().to_string();
        let written = &record[modified];
        if matches!(written, "" | "-") {
            continue;
        }
        let time = MOODLE.iter().find_map(|format| DateTime::strptime(format, written).ok());
        // An hour that the end of summer repeats is taken as the first, which harms nobody.
        let time = time.and_then(|time| zone.to_timestamp(time).ok()).ok_or_else(|| {
            (
                at,
                format!(
                    "`{written}` is no time as Moodle writes it in English: download it in that language"
                ),
            )
        })?;
        if all.insert(number.clone(), time).is_some() {
            return Err((at, format!("there are two times for {number}")));
        }
    }
    Ok(Submitted::Numbered(all))
}

/// Reads Gradescope's metadata, whose keys are the names of the export's folders.
fn gradescope(text: &str) -> Result<Submitted, (u64, String)> {
    let parsed =
        Yaml::load_from_str(text).map_err(|error| (error.marker().line() as u64, error.info().into()))?;
    let all = parsed.first().and_then(Yaml::as_mapping);
    let all = all.ok_or_else(|| (1, "it is not Gradescope’s submission_metadata.yml".to_string()))?;
    let time = |(name, one): (&Yaml, &Yaml)| {
        let name = name.as_str().unwrap_or_default().to_string();
        // Ruby writes a space before the offset.
        let time = (one.as_mapping_get(":created_at").and_then(Yaml::as_str))
            .and_then(|written| written.replacen(' ', "T", 1).replace(' ', "").parse().ok());
        match time {
            Some(time) => Ok(((name, None), time)),
            None => Err((1, format!("`{name}` has no `:created_at:` that is a time"))),
        }
    };
    all.iter().map(time).collect::<Result<_, _>>().map(Submitted::Named)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, text: &str, zone: Option<&str>) -> Result<Submitted, (u64, String)> {
        let zone = zone.map(|zone| TimeZone::get(zone).unwrap());
        Submitted::read(Path::new(name), text, &["01-lines".into()], zone.as_ref())
    }

    /// The columns and the forms of a time are those of Moodle's source; what is in them is ours.
    const WORKSHEET: &str = concat!(
        "Identifier,\"Full name\",Status,Grade,\"Last modified (submission)\",\"Feedback comments\"\r\n",
        "\"Participant 101\",\"Ann Smith\",Submitted,,\"Monday, 5 October 2026, 11:59 PM\",\"two\nlines\"\r\n",
        "\"Participant 102\",Ben,Submitted,,\"Monday, October 5, 2026, 12:05 AM\",\r\n",
        "\"Participant 103\",Cem,Submitted,,\"Sunday, 25 October 2026, 14:00\",\r\n",
        "\"Participant 104\",Di,\"No submission\",,-,\r\n",
    );

    #[test]
    fn moodle_says_when() {
        let times = read("grades.csv", WORKSHEET, Some("Europe/Berlin")).unwrap();
        let at = |name: &str| times.at(name, "01-lines").map(|time| time.to_string());
        assert_eq!(at("Ann Smith_101").unwrap(), "2026-10-05T21:59:00Z");
        assert_eq!(at("Ben_102").unwrap(), "2026-10-04T22:05:00Z");
        // Summer has ended.
        assert_eq!(at("Cem_103").unwrap(), "2026-10-25T13:00:00Z");
        assert_eq!([at("Di_104"), at("101"), at("x_1")], [None, None, None]);
    }

    #[test]
    fn gradescope_says_when() {
        let text = concat!(
            "submission_7001:\n  :submitters:\n  - :name: Ann Smith\n    :sid: '1'\n    :email: ann@example.org\n",
            "  :created_at: 2026-10-05 21:59:00.339000000 Z\n  :score: 7.0\n  :status: processed\n",
            "  :history:\n  - :id: 6900\n    :created_at: 2026-10-01 08:00:00.000000000 Z\n",
            "submission_7002:\n  :submitters: []\n  :created_at: 2026-10-05 23:59:00.5 +02:00\n",
        );
        let times = read("submission_metadata.yml", text, None).unwrap();
        let at = |name: &str| times.at(name, "01-lines").map(|time| time.to_string());
        assert_eq!(at("submission_7001").unwrap(), "2026-10-05T21:59:00.339Z");
        assert_eq!(at("submission_7002").unwrap(), "2026-10-05T21:59:00.5Z");
        assert_eq!(at("submission_7003"), None);
    }

    #[test]
    fn what_is_not_understood_is_told_with_its_line() {
        let head = "Identifier,Last modified (submission)\n";
        let german = format!("{head}Participant 1,-\nParticipant 2,\"Montag, 5. Oktober 2026, 23:59\"\n");
        let other_day = format!("{head}Participant 2,\"Tuesday, 5 October 2026, 23:59\"\n");
        let one = "Participant 1,\"Monday, 5 October 2026, 23:59\"\n";
        let twice = format!("{head}{one}{one}");
        let short = format!("{head}Participant 1\n");
        let (none, utc) = (None, Some("UTC"));
        for (name, text, zone, line, words) in [
            (
                "t.csv",
                "submission,submitted\nann,2026-10-05\n",
                none,
                2,
                "`2026-10-05`: a time is to be written",
            ),
            ("t.csv", "submission,submitted\nann,2026-10-05T10:00:00\n", none, 2, "with its offset"),
            (
                "t.csv",
                "submission,submitted\n\nann,2026-10-05T10:00:00Z\nann,2026-10-05T10:00:00Z\n",
                none,
                4,
                "two times for ann",
            ),
            (
                "t.csv",
                "submission,lesson,submitted\nann,lines,2026-10-05T10:00:00Z\n",
                none,
                2,
                "`lines` is no lesson",
            ),
            ("t.csv", "submission,submitted\nann\n", none, 2, "more or fewer cells"),
            ("t.csv", "name,submitted\nann,2026-10-05T10:00:00Z\n", none, 2, "unknown field `name`"),
            ("t.csv", WORKSHEET, none, 1, "add --zone"),
            ("t.csv", "Identifier,Grade\n", utc, 1, "no column `Last modified (submission)`"),
            ("t.csv", &german, utc, 3, "`Montag, 5. Oktober 2026, 23:59` is no time as Moodle writes it"),
            ("t.csv", &other_day, utc, 2, "is no time"),
            ("t.csv", &twice, utc, 3, "two times for 1"),
            ("t.csv", &short, utc, 2, "fewer cells"),
            ("t.yml", "submission_1:\n  :score: 1\n", none, 1, "`submission_1` has no `:created_at:`"),
            ("t.yml", "submission_1:\n  :created_at: soon\n", none, 1, "`submission_1` has no"),
            ("t.yml", "- 1\n", none, 1, "not Gradescope’s"),
            ("t.yml", "", none, 1, "not Gradescope’s"),
            ("t.yml", "a: 1\nb: [\n", none, 3, ""),
        ] {
            let (at, why) = read(name, text, zone).unwrap_err();
            assert!(at == line && why.contains(words) && !why.contains('\n'), "{text}: {at}: {why}");
        }
    }
}
