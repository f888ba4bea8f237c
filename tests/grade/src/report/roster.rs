//! Points in the file in which Canvas or Moodle take them back: the one that they gave, filled in.
//!
//! Students are told by their numbers there, with which the names of a download's files end, as in `smithann_1234`.

use std::path::Path;

use anyhow::{Context, anyhow, ensure};
use csv::{ReaderBuilder, StringRecord, Writer};

use super::csv::{harmless, points};
use crate::file;
use crate::marks::{self, Marks, decimal};
use crate::results::{Class, total};

/// The columns that say who somebody is, of Canvas and of Moodle.
const IDENTITIES: [&str; 9] = [
    "Student",
    "ID",
    "SIS User ID",
    "SIS Login ID",
    "Identifier",
    "Full name",
    "Email address",
    "ID number",
    "Username",
];

/// The columns that Canvas wants back.
const CANVAS: [&str; 5] = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"];

/// What a system gave.
pub(crate) struct Roster {
    head: StringRecord,
    rows: Vec<StringRecord>,
    system: System,
}

/// Whose file it is, and where its columns are.
enum System {
    /// The gradebook, *Export*: the column of the number, and those to give back.
    Canvas(usize, Vec<usize>),
    /// An assignment, *Download grading worksheet*: the columns of the number and of the grade.
    Moodle(usize, usize),
}

impl Roster {
    /// Reads a file.
    ///
    /// # Errors
    /// Where it cannot be read, or is of neither system.
    pub(crate) fn read(path: &Path) -> anyhow::Result<Self> {
        let wrong = || format!("cannot read {}", path.display());
        let text = std::fs::read_to_string(path).with_context(wrong)?;
        Self::parse(&text).with_context(|| path.display().to_string())
    }

    fn parse(text: &str) -> anyhow::Result<Self> {
        let text = text.trim_start_matches('\u{feff}');
        let mut table = ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
        let head = table.headers()?.clone();
        let column = |name: &str| head.iter().position(|own| own.trim() == name);
        let system = match (column("ID"), column("Identifier"), column("Grade")) {
            (Some(id), ..) => System::Canvas(id, CANVAS.iter().filter_map(|name| column(name)).collect()),
            (None, Some(id), Some(grade)) => System::Moodle(id, grade),
            _ => {
                return Err(anyhow!(
                    "it has neither the column ID of Canvas’ gradebook nor Identifier and Grade of Moodle’s worksheet"
                ));
            }
        };
        let rows = table.records().collect::<Result<_, _>>()?;
        Ok(Self { head, rows, system })
    }

    /// What its students are called.
    pub(super) fn identities(&self) -> Vec<String> {
        let columns: Vec<usize> = IDENTITIES
            .iter()
            .filter_map(|name| self.head.iter().position(|own| own.trim() == *name))
            .collect();
        let of =
            |row: &StringRecord| columns.iter().map(|n| cell(row, *n).trim().to_string()).collect::<Vec<_>>();
        self.rows.iter().flat_map(of).collect()
    }

    /// The file to give back. Who is not graded, or not in the class, gets no points there: what the system has stays.
    fn filled(&self, class: &Class, marks: Option<&Marks>) -> anyhow::Result<Vec<u8>> {
        let mut table = Writer::from_writer(Vec::new());
        match &self.system {
            System::Canvas(id, back) => {
                let cells =
                    |row: &StringRecord| back.iter().map(|n| cell(row, *n).to_string()).collect::<Vec<_>>();
                let names = class.lessons.iter().map(|lesson| lesson.name.clone());
                table.write_record(cells(&self.head).into_iter().chain(names))?;
                for row in &self.rows {
                    let worth = cell(row, 0).trim().eq_ignore_ascii_case("Points Possible");
                    let found = works(class, cell(row, *id).trim());
                    let of = |n: usize| match (found, marks) {
                        (_, None) if worth => class.lessons[n].points().to_string(),
                        (_, Some(marks)) if worth => decimal(marks.of_lessons[n]),
                        (Some((_, works)), None) => points(works[n].earned()),
                        (Some((name, _)), Some(marks)) => counted(marks.students[name][n].counted),
                        (None, _) => String::new(),
                    };
                    let cells = cells(row).iter().map(|text| harmless(text)).collect::<Vec<_>>();
                    table.write_record(cells.into_iter().chain((0..class.lessons.len()).map(of)))?;
                }
            }
            System::Moodle(id, grade) => {
                table.write_record(&self.head)?;
                for row in &self.rows {
                    let number = cell(row, *id).trim_start_matches("Participant").trim();
                    let earned = works(class, number).map(|(name, works)| match marks {
                        Some(marks) => counted(marks::total(&marks.students[name])),
                        None => points(total(works)),
                    });
                    let fill = |(n, text): (usize, &str)| match &earned {
                        Some(earned) if n == *grade && !earned.is_empty() => earned.clone(),
                        _ => harmless(text),
                    };
                    table.write_record(row.iter().enumerate().map(fill))?;
                }
            }
        }
        table.into_inner().map_err(|error| anyhow!("{error}"))
    }

    /// Writes the file to give back into the folder of the reports.
    ///
    /// # Errors
    /// Where no submission is one of the roster's.
    pub(super) fn write(&self, class: &Class, marks: Option<&Marks>, folder: &Path) -> anyhow::Result<()> {
        let (System::Canvas(id, _) | System::Moodle(id, _)) = &self.system;
        let number = |row: &StringRecord| cell(row, *id).trim_start_matches("Participant").trim().to_string();
        let found = self.rows.iter().any(|row| works(class, &number(row)).is_some());
        ensure!(found, "no submission’s name ends with a number of the roster, as in smithann_1234");
        file::write(&folder.join("import.csv"), &self.filled(class, marks)?)
    }
}

fn cell(row: &StringRecord, column: usize) -> &str {
    row.get(column).unwrap_or_default()
}

/// What counts, for a cell; nothing while it is not graded.
fn counted(hundredths: Option<u64>) -> String {
    hundredths.map(decimal).unwrap_or_default()
}

/// The submission of a number's student, and what was handed in.
fn works<'a>(class: &'a Class, number: &str) -> Option<(&'a String, &'a Vec<crate::results::Work>)> {
    let own = |name: &str| name.rsplit_once('_').is_some_and(|(_, own)| own == number);
    class.submissions.iter().find(|(name, _)| !number.is_empty() && own(name))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::results::{Check, Lesson, Look, Outcome, Work};

    fn class() -> Class {
        let check = Check { name: "a".into(), asks: "what".into(), points: 10 };
        let lesson = Lesson { name: "01-lines".into(), checks: vec![check] };
        let look = Look { found: String::new(), because: String::new(), cure: String::new() };
        let submissions = [
            ("smithann_101", Outcome::NotCompiled("it".into())),
            ("Ben_102", Outcome::NotGraded(look)),
            ("cem", Outcome::Missing),
        ];
        let work = |(name, outcome): (&str, Outcome)| {
            (name.to_string(), vec![Work { text: String::new(), outcome }])
        };
        let submissions = submissions.into_iter().map(work).collect();
        Class { seed: 2, lessons: vec![lesson], walls: vec![], submissions, late: BTreeSet::new() }
    }

    fn filled(text: &str) -> String {
        String::from_utf8(Roster::parse(text).unwrap().filled(&class(), None).unwrap()).unwrap()
    }

    #[test]
    fn canvas_gets_its_students_back() {
        let text = "\u{feff}Student,ID,SIS User ID,SIS Login ID,Section,Old (7)\n    Points Possible,,,,,5\n\
                    \"Smith, Ann\",101,s1,ann,A,3\n=Ben,102,s2,ben,A,\nDi,104,s4,di,A,1\n";
        let expected = "Student,ID,SIS User ID,SIS Login ID,Section,01-lines\n    Points Possible,,,,,10\n\
                        \"Smith, Ann\",101,s1,ann,A,0\n'=Ben,102,s2,ben,A,\nDi,104,s4,di,A,\n";
        assert_eq!(filled(text), expected);
    }

    #[test]
    fn moodle_gets_its_worksheet_back() {
        let text = "Identifier,Full name,Status,Grade,Maximum Grade\nParticipant 101,Ann Smith,Submitted,,10\n\
                    Participant 102,Ben,Submitted,7,10\n";
        let expected = "Identifier,Full name,Status,Grade,Maximum Grade\nParticipant 101,Ann Smith,Submitted,0,10\n\
             Participant 102,Ben,Submitted,7,10\n";
        assert_eq!(filled(text), expected);
    }

    #[test]
    fn other_tables_are_refused() {
        assert!(Roster::parse("Name,Points\nAnn,1\n").is_err());
        let folder = tempfile::tempdir().unwrap();
        let write = |text| Roster::parse(text).unwrap().write(&class(), None, folder.path());
        assert!(write("Student,ID\nAnn,7\n").is_err() && !folder.path().join("import.csv").exists());
        assert!(write("ID\n101\n").is_ok() && folder.path().join("import.csv").exists());
    }
}
