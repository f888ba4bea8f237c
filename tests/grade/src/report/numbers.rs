//! A class in numbers.

use crate::results::{Class, Outcome, total};

/// How many of a number there are.
pub(super) struct Count {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) of: usize,
}

impl Count {
    /// In hundredths, rounded.
    pub(super) fn percent(&self) -> usize {
        (200 * self.count + self.of) / (2 * self.of.max(1))
    }
}

/// The totals of those who are graded, the smallest first.
pub(super) fn totals(class: &Class) -> Vec<u32> {
    let mut totals: Vec<u32> = class.submissions.values().filter_map(|works| total(works)).collect();
    totals.sort_unstable();
    totals
}

/// The mean, with one digit.
pub(super) fn mean(totals: &[u32]) -> String {
    format!("{:.1}", f64::from(totals.iter().sum::<u32>()) / totals.len().max(1) as f64)
}

/// What is in the middle, or halfway between the two that are.
pub(super) fn median(sorted: &[u32]) -> String {
    let half = sorted.len() / 2;
    match sorted.get(half) {
        None => "0".into(),
        Some(middle) if sorted.len() % 2 == 1 => middle.to_string(),
        Some(above) => (f64::from(sorted[half - 1] + above) / 2.0).to_string(),
    }
}

/// How many have each tenth of the points; those who have all are in the last one.
pub(super) fn histogram(totals: &[u32], points: u32) -> Vec<Count> {
    let tenth = |total: u32| (10 * total / points.max(1)).min(9);
    let count = |n: u32| totals.iter().filter(|total| tenth(**total) == n).count();
    let end = |n: u32| if n == 9 { 100 } else { 10 * n + 9 };
    let row = |n| Count { name: format!("{}–{} %", 10 * n, end(n)), count: count(n), of: totals.len() };
    (0..10).map(row).collect()
}

/// For each check how many earned all of its points, of those who handed something in that is graded.
pub(super) fn passed(class: &Class) -> Vec<Count> {
    let mut rows = Vec::new();
    for (n, lesson) in class.lessons.iter().enumerate() {
        let works = class.submissions.values().filter_map(|works| works.get(n));
        let works: Vec<_> =
            works.filter(|work| !matches!(work.outcome, Outcome::Missing | Outcome::NotGraded(_))).collect();
        for (k, check) in lesson.checks.iter().enumerate() {
            let count = works.iter().filter(|work| work.earned_in(k) == Some(check.points)).count();
            rows.push(Count { name: format!("{} {}", lesson.name, check.name), count, of: works.len() });
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_is_in_the_middle() {
        let medians = [&[][..], &[3], &[3, 6], &[0, 2, 2, 10], &[1, 2, 9]].map(median);
        assert_eq!(medians, ["0", "3", "4.5", "2", "2"]);
        assert_eq!(mean(&[1, 2]), "1.5");
    }

    #[test]
    fn each_is_in_one_tenth() {
        let counts = |totals: &[u32], points| {
            histogram(totals, points).iter().map(|row| row.count).collect::<Vec<_>>()
        };
        assert_eq!(counts(&[0, 1, 19, 20, 199, 200], 200), [3, 1, 0, 0, 0, 0, 0, 0, 0, 2]);
        assert_eq!(counts(&[0], 0).iter().sum::<usize>(), 1);
        let row = &histogram(&[5, 6, 9], 10)[9];
        assert_eq!((&*row.name, row.count, row.percent()), ("90–100 %", 1, 33));
    }
}
