//! `JUnit`'s XML, which forges show as test results: a suite for each submission and lesson, a case for each check.

use std::collections::BTreeMap;
use std::time::Duration;

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::{Time, lines, not_run};
use crate::results::{Check, Class, Lesson, Outcome, Work};

pub(super) fn report(class: &Class, times: &[Time]) -> anyhow::Result<String> {
    let seconds: BTreeMap<(&str, &str), f64> = (times.iter())
        .map(|time| ((&*time.submission, &*time.lesson), time.compiling + time.running))
        .collect();
    let mut report = Report::new("grade");
    for (name, works) in &class.submissions {
        for (work, lesson) in works.iter().zip(&class.lessons) {
            let mut suite = TestSuite::new(format!("{name}: {}", lesson.name));
            let seconds = seconds.get(&(name, &*lesson.name)).copied().unwrap_or(0.0);
            suite.set_time(Duration::from_secs_f64(seconds));
            // A program does all checks in one go: each has its share of the time.
            let share = Duration::from_secs_f64(seconds / lesson.checks.len().max(1) as f64);
            suite.add_test_cases(cases(work, lesson).into_iter().map(|mut case| {
                case.set_classname(format!("{}.{name}", lesson.name)).set_time(share);
                case
            }));
            report.add_test_suite(suite);
        }
    }
    Ok(report.to_string()?)
}

fn cases(work: &Work, lesson: &Lesson) -> Vec<TestCase> {
    let why = |check: usize| match &work.outcome {
        Outcome::Ran { checks, .. } => checks.get(check).map(lines).unwrap_or_default(),
        _ => {
            not_run(work).map(|(why, said)| format!("{why}\n{said}").trim().to_string()).into_iter().collect()
        }
    };
    let case = |(n, check): (usize, &Check)| {
        let why = why(n);
        let status = match why.first().and_then(|line| line.lines().next()) {
            None => TestCaseStatus::success(),
            Some(line) => {
                let kind = match work.outcome {
                    Outcome::NotGraded(_) => NonSuccessKind::Error,
                    _ => NonSuccessKind::Failure,
                };
                let mut status = TestCaseStatus::non_success(kind);
                status.set_message(line).set_description(why.join("\n"));
                status
            }
        };
        TestCase::new(format!("{} ({} points)", check.name, check.points), status)
    };
    lesson.checks.iter().enumerate().map(case).collect()
}
