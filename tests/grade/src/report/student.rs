//! A page for a student, pictures included, that needs no network and no other file. It names nobody else, and not the
//! seed.

use askama::Template;

use super::{counted, lines, not_run, points};
use crate::marks::{self, Mark, Marks, decimal};
use crate::results::{Check, Class, Judged, Lesson, Outcome, Pictures, Work, total};

/// The page as `templates/student.html` lays it out.
#[derive(Template)]
#[template(path = "student.html")]
struct Page<'a> {
    name: &'a str,
    works: Vec<Part<'a>>,
    earned: String,
    points: u32,
    /// What counts, and of how much, where there are rules.
    counted: Option<[String; 2]>,
}

struct Part<'a> {
    lesson: &'a Lesson,
    /// Points, or a dash.
    earned: String,
    state: &'a str,
    /// The state as a name of a style.
    class: String,
    /// Why it was not run, and what was said.
    not_run: Option<(&'a str, String)>,
    checks: Vec<Row<'a>>,
    printed: &'a str,
    /// What counts of it, and why, where there are rules.
    counted: Option<String>,
}

struct Row<'a> {
    name: &'a str,
    asks: &'a str,
    earned: u32,
    points: u32,
    lines: Vec<String>,
    pictures: Option<&'a Pictures>,
}

/// The page of a student.
pub(super) fn page(
    class: &Class,
    name: &str,
    works: &[Work],
    marks: Option<&Marks>,
) -> anyhow::Result<String> {
    let own = marks.map(|marks| marks.students[name].as_slice());
    let counted = |marks: &Marks| [counted(marks::total(&marks.students[name])), decimal(marks.of)];
    let page = Page {
        name,
        earned: points(total(works)),
        points: class.points(),
        counted: marks.map(counted),
        works: (works.iter().zip(&class.lessons).enumerate())
            .map(|(n, (work, lesson))| part(work, lesson, own.map(|own| &own[n])))
            .collect(),
    };
    Ok(page.render()?)
}

/// In words, what counts of a lesson.
fn why(mark: &Mark) -> String {
    let days = |days: u32| if days == 1 { "1 day".to_string() } else { format!("{days} days") };
    let late = match mark {
        Mark { days: 0, .. } => String::new(),
        Mark { accepted: false, .. } => format!(", {} late, which is too late", days(mark.days)),
        Mark { free: 0, .. } => format!(", {} late", days(mark.days)),
        _ => format!(", {} late, of which {} free", days(mark.days), mark.free),
    };
    format!("counts {} of {}{late}", counted(mark.counted), decimal(mark.of))
}

/// The page's file, in the folder of the reports.
pub(super) fn file(name: &str) -> String {
    format!("students/{name}.html")
}

/// A link to that file from that folder: of what is no letter or digit each byte as `%` and two digits (RFC 3986, 2.1).
pub(super) fn link(name: &str) -> String {
    let encode = |byte: u8| match byte {
        b'/' | b'.' | b'-' | b'_' => char::from(byte).to_string(),
        _ if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    file(name).bytes().map(encode).collect()
}

fn part<'a>(work: &'a Work, lesson: &'a Lesson, mark: Option<&Mark>) -> Part<'a> {
    let (judged, printed) = match &work.outcome {
        Outcome::Ran { checks, printed } => (checks.as_slice(), printed.trim()),
        _ => (&[][..], ""),
    };
    let row = |(judged, check): (&'a Judged, &'a Check)| Row {
        name: &check.name,
        asks: &check.asks,
        earned: judged.earned,
        points: check.points,
        lines: lines(judged),
        pictures: judged.pictures.as_ref(),
    };
    Part {
        lesson,
        earned: points(work.earned()),
        state: work.state(),
        class: work.state().replace(' ', "-"),
        not_run: not_run(work),
        checks: judged.iter().zip(&lesson.checks).map(row).collect(),
        printed,
        counted: mark.map(why),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_leads_to_its_file() {
        assert_eq!(link("ann-1_x"), "students/ann-1_x.html");
        assert_eq!(link("a%FF #1?\"é"), "students/a%25FF%20%231%3F%22%C3%A9.html");
    }
}
