//! The page of a class: an overview, what to look at, numbers. It needs no network and no server, and links to the pages
//! of the students.

use std::collections::BTreeMap;

use askama::Template;

use super::numbers::{self, Count};
use super::{counted, late, points, student};
use crate::marks::{self, Marks, decimal};
use crate::proof::Wall;
use crate::results::{Class, Lesson, Look, total};

/// The page as `templates/report.html` lays it out.
#[derive(Template)]
#[template(path = "report.html")]
struct Page<'a> {
    lessons: &'a [Lesson],
    walls: &'a [Wall],
    /// Whose, of which lessons, and what a person has to look at.
    looks: Vec<(&'a str, String, &'a Look)>,
    /// Those that Canvas marked as late, and nothing else did.
    late: Vec<&'a str>,
    students: Vec<Student<'a>>,
    points: u32,
    /// The most that can count; nothing where there are no rules.
    counted_of: String,
    /// How many are graded; the numbers are of these.
    graded: usize,
    mean: String,
    median: String,
    histogram: Vec<Count>,
    passed: Vec<Count>,
    /// Lessons, and who handed in the same file: names and links.
    same: Vec<(&'a str, Vec<(&'a str, String)>)>,
}

struct Student<'a> {
    name: &'a str,
    /// The link to the student's page.
    page: String,
    works: Vec<Part<'a>>,
    /// Points, or a dash.
    earned: String,
    /// What counts, where there are rules.
    counted: Option<String>,
    /// All states, for the filter.
    states: String,
}

struct Part<'a> {
    /// Points, or a dash.
    earned: String,
    state: &'a str,
    /// The state as a name of a style.
    class: String,
}

/// The page of a class.
pub(super) fn page(class: &Class, marks: Option<&Marks>) -> anyhow::Result<String> {
    let mut texts: BTreeMap<(usize, &str), Vec<(&str, String)>> = BTreeMap::new();
    let mut students = Vec::new();
    for (name, works) in &class.submissions {
        let page = student::link(name);
        for (lesson, work) in works.iter().enumerate().filter(|(_, work)| !work.text.is_empty()) {
            texts.entry((lesson, &work.text)).or_default().push((name, page.clone()));
        }
        let part = |work: &'_ crate::results::Work| Part {
            earned: points(work.earned()),
            state: work.state(),
            class: work.state().replace(' ', "-"),
        };
        let works_shown: Vec<Part> = works.iter().map(part).collect();
        let states = works_shown.iter().map(|part| part.class.as_str()).collect::<Vec<_>>().join(" ");
        let earned = points(total(works));
        let counted = marks.map(|marks| counted(marks::total(&marks.students[name])));
        students.push(Student { name, page, works: works_shown, earned, counted, states });
    }
    let several = texts.into_iter().filter(|(_, students)| students.len() > 1);
    let same =
        several.map(|((lesson, _), students)| (class.lessons[lesson].name.as_str(), students)).collect();
    let totals = numbers::totals(class);
    let page = Page {
        lessons: &class.lessons,
        walls: &class.walls,
        looks: class.looks(),
        late: late(class, marks),
        students,
        points: class.points(),
        counted_of: marks.map(|marks| decimal(marks.of)).unwrap_or_default(),
        graded: totals.len(),
        mean: numbers::mean(&totals),
        median: numbers::median(&totals),
        histogram: numbers::histogram(&totals, class.points()),
        passed: numbers::passed(class),
        same,
    };
    Ok(page.render()?)
}
