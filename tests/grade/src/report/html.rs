//! One page with everything, pictures included, that needs no network and no server.

use std::collections::BTreeMap;

use askama::Template;

use super::{lines, not_run};
use crate::proof::Wall;
use crate::results::{Check, Class, Judged, Lesson, Look, Outcome, Pictures, Work, total};

/// The page as `templates/report.html` lays it out.
#[derive(Template)]
#[template(path = "report.html")]
struct Page<'a> {
    lessons: &'a [Lesson],
    walls: &'a [Wall],
    /// Whose, of which lessons, and what a person has to look at.
    looks: Vec<(&'a str, String, &'a Look)>,
    students: Vec<Student<'a>>,
    points: u32,
    /// Of those who are graded.
    mean: String,
}

struct Student<'a> {
    /// Of its part of the page.
    id: String,
    name: &'a str,
    works: Vec<Part<'a>>,
    /// Points, or a dash.
    earned: String,
    /// All states, for the filter.
    states: String,
}

struct Part<'a> {
    lesson: &'a Lesson,
    /// Points, or a dash.
    earned: String,
    state: &'a str,
    /// The state as a name of a style.
    class: String,
    /// Who handed in the same text, and is shown above.
    same_as: Option<Shown<'a>>,
    /// Why it was not run, and what was said.
    not_run: Option<(&'a str, String)>,
    checks: Vec<Row<'a>>,
    printed: &'a str,
}

/// A student's place on the page, and name.
type Shown<'a> = (String, &'a str);

struct Row<'a> {
    name: &'a str,
    asks: &'a str,
    earned: u32,
    points: u32,
    lines: Vec<String>,
    pictures: Option<&'a Pictures>,
}

pub(super) fn page(class: &Class) -> anyhow::Result<String> {
    // Each text of a lesson is shown once.
    let mut first: BTreeMap<(usize, &str), Shown> = BTreeMap::new();
    let mut students = Vec::new();
    for (n, (name, works)) in class.submissions.iter().enumerate() {
        let id = format!("s{}", n + 1);
        let mut parts = Vec::new();
        for (lesson, work) in works.iter().enumerate() {
            let shown = first.entry((lesson, &work.text)).or_insert((id.clone(), name));
            let same_as = Some(shown.clone()).filter(|(by, _)| *by != id && !work.text.is_empty());
            parts.push(part(work, &class.lessons[lesson], same_as));
        }
        let states = parts.iter().map(|part| part.class.as_str()).collect::<Vec<_>>().join(" ");
        students.push(Student { id, name, works: parts, earned: points(total(works)), states });
    }
    let graded: Vec<u32> = class.submissions.values().filter_map(|works| total(works)).collect();
    let mean = format!("{:.1}", f64::from(graded.iter().sum::<u32>()) / graded.len().max(1) as f64);
    let (lessons, walls) = (&class.lessons, &class.walls);
    let (looks, points) = (class.looks(), class.points());
    Ok(Page { lessons, walls, looks, students, points, mean }.render()?)
}

fn points(earned: Option<u32>) -> String {
    earned.map_or_else(|| "–".into(), |points| points.to_string())
}

fn part<'a>(work: &'a Work, lesson: &'a Lesson, same_as: Option<Shown<'a>>) -> Part<'a> {
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
        same_as,
        not_run: not_run(work),
        checks: judged.iter().zip(&lesson.checks).map(row).collect(),
        printed,
    }
}
