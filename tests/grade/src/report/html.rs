//! One page with everything, pictures included, that needs no network and no server.

use std::collections::BTreeMap;

use askama::Template;

use super::{lines, not_run};
use crate::proof::Wall;
use crate::results::{Check, Class, Judged, Lesson, Outcome, Pictures, Work};

/// The page as `templates/report.html` lays it out.
#[derive(Template)]
#[template(path = "report.html")]
struct Page<'a> {
    seed: u64,
    lessons: &'a [Lesson],
    walls: &'a [Wall],
    students: Vec<Student<'a>>,
    points: u32,
    mean: String,
}

struct Student<'a> {
    /// Of its part of the page.
    id: String,
    name: &'a str,
    works: Vec<Part<'a>>,
    earned: u32,
    /// All states, for the filter.
    states: String,
}

struct Part<'a> {
    lesson: &'a Lesson,
    earned: u32,
    state: &'a str,
    /// The state as a name of a style.
    class: String,
    /// Who handed in the same text, and is shown above.
    same_as: Option<Shown<'a>>,
    /// Why it was not run, and what was said.
    not_run: Option<(&'a str, &'a str)>,
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
        let earned = works.iter().map(Work::earned).sum();
        students.push(Student { id, name, works: parts, earned, states });
    }
    let sum: u32 = students.iter().map(|student| student.earned).sum();
    let mean = format!("{:.1}", f64::from(sum) / students.len().max(1) as f64);
    let (lessons, walls) = (&class.lessons, &class.walls);
    Ok(Page { seed: class.seed, lessons, walls, students, points: class.points(), mean }.render()?)
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
        earned: work.earned(),
        state: work.state(),
        class: work.state().replace(' ', "-"),
        same_as,
        not_run: not_run(work),
        checks: judged.iter().zip(&lesson.checks).map(row).collect(),
        printed,
    }
}
