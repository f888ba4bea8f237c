//! What an instructor's rules make of the points: weighted, and less what being late costs.
//!
//! All is in hundredths of a point, in integers. Free days are spent where they save the student most: spent in order, a
//! work that is too late to be accepted could use up days that another one needs.

use std::collections::BTreeMap;

use crate::results::{Class, Outcome, Work};
use crate::rules::Rules;

/// What the rules make of a class.
#[derive(Debug)]
pub(crate) struct Marks {
    /// The highest total, in hundredths of a point.
    pub(crate) of: u64,
    /// The most that each lesson can come to, in hundredths of a point.
    pub(crate) of_lessons: Vec<u64>,
    /// By submission.
    pub(crate) students: BTreeMap<String, Vec<Mark>>,
}

/// What counts of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
    /// How many days late it was handed in.
    pub(crate) days: u32,
    /// How many of these are free.
    pub(crate) free: u32,
    /// Whether it was accepted that late.
    pub(crate) accepted: bool,
    /// What counts, in hundredths of a point; nothing while it is not graded.
    pub(crate) counted: Option<u64>,
    /// The most that it can be.
    pub(crate) of: u64,
}

/// A lesson of a student.
#[derive(Clone, Copy, Debug)]
struct Part {
    earned: Option<u32>,
    points: u32,
    weight: u32,
    days: u32,
}

impl Marks {
    /// Applies rules.
    ///
    /// # Errors
    /// Where something has a deadline, and it is not said when it was handed in.
    pub(crate) fn new(class: &Class, rules: &Rules) -> anyhow::Result<Self> {
        let worth = |lesson: &crate::results::Lesson| hundredths(lesson.points(), rules.weight(&lesson.name));
        let mut students = BTreeMap::new();
        for (name, works) in &class.submissions {
            let part = |(work, lesson): (&Work, &crate::results::Lesson)| -> anyhow::Result<Part> {
                let graded = matches!(work.outcome, Outcome::Ran { .. } | Outcome::NotCompiled(_));
                Ok(Part {
                    earned: work.earned(),
                    points: lesson.points(),
                    weight: rules.weight(&lesson.name),
                    days: if graded { rules.days_late(name, &lesson.name)? } else { 0 },
                })
            };
            let parts = works.iter().zip(&class.lessons).map(part).collect::<anyhow::Result<Vec<_>>>()?;
            students.insert(name.clone(), marks(&parts, &Terms::of(rules)));
        }
        let of_lessons: Vec<u64> = class.lessons.iter().map(worth).collect();
        Ok(Self { of: of_lessons.iter().sum(), of_lessons, students })
    }
}

/// The sum of marks; nothing while one is not graded.
pub(crate) fn total(marks: &[Mark]) -> Option<u64> {
    marks.iter().map(|mark| mark.counted).sum()
}

/// Hundredths of a point as a decimal number.
pub(crate) fn decimal(hundredths: u64) -> String {
    let text = format!("{}.{:02}", hundredths / 100, hundredths % 100);
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

fn hundredths(points: u32, weight: u32) -> u64 {
    100 * u64::from(points) * u64::from(weight)
}

/// What being late costs.
#[derive(Clone, Debug)]
struct Terms {
    free_days: u32,
    penalty: u32,
    last_day: Option<u32>,
}

impl Terms {
    fn of(rules: &Rules) -> Self {
        let last_day = rules.late.last_day.map(|day| day.0);
        Self { free_days: rules.late.free_days.0, penalty: rules.late.penalty.0, last_day }
    }

    fn accepted(&self, part: &Part) -> bool {
        self.last_day.is_none_or(|last| part.days <= last)
    }

    /// What counts of a part if so many of its days are free.
    fn counted(&self, part: &Part, free: u32) -> u64 {
        let percent = 100_u32.saturating_sub((part.days - free).saturating_mul(self.penalty));
        let percent = if self.accepted(part) { percent } else { 0 };
        hundredths(part.earned.unwrap_or(0), part.weight) / 100 * u64::from(percent)
    }
}

fn marks(parts: &[Part], terms: &Terms) -> Vec<Mark> {
    let most = |part: &Part, left: usize| 0..=left.min(part.days as usize);
    let all = terms.free_days as usize;
    // The best that the parts from the n-th on come to with so many free days.
    let mut best = vec![vec![0_u64; all + 1]];
    for part in parts.iter().rev() {
        let later = &best[best.len() - 1];
        let with = |left: usize| {
            most(part, left).map(|free| terms.counted(part, free as u32) + later[left - free]).max()
        };
        best.push((0..=all).map(|left| with(left).unwrap_or(0)).collect());
    }
    best.pop();
    let mut left = all;
    let mark = |part: &Part| {
        let later = best.pop().unwrap_or_default();
        let worth = |free: usize| terms.counted(part, free as u32) + later[left - free];
        let top = most(part, left).map(worth).max().unwrap_or(0);
        // No more of them than help.
        let free = most(part, left).find(|free| worth(*free) == top).unwrap_or(0);
        left -= free;
        Mark {
            days: part.days,
            free: free as u32,
            accepted: terms.accepted(part),
            counted: part.earned.map(|_| terms.counted(part, free as u32)),
            of: hundredths(part.points, part.weight),
        }
    };
    parts.iter().map(mark).collect()
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    fn part() -> impl Strategy<Value = Part> {
        let days = prop_oneof![Just(0), 0..12_u32, Just(u32::MAX)];
        (0..=10_u32, 0..4_u32, days).prop_map(|(earned, weight, days)| Part {
            earned: Some(earned),
            points: 10,
            weight,
            days,
        })
    }

    fn terms() -> impl Strategy<Value = Terms> {
        let last = prop::option::of(0..10_u32);
        let penalty = prop_oneof![0..40_u32, Just(100)];
        (0..8_u32, penalty, last).prop_map(|(free_days, penalty, last_day)| Terms {
            free_days,
            penalty,
            last_day,
        })
    }

    fn sum(parts: &[Part], terms: &Terms) -> u64 {
        total(&marks(parts, terms)).unwrap()
    }

    /// All ways to spend the free days, tried one by one.
    fn by_hand(parts: &[Part], terms: &Terms, left: u32) -> u64 {
        let Some((first, others)) = parts.split_first() else { return 0 };
        let with = |free| terms.counted(first, free) + by_hand(others, terms, left - free);
        (0..=left.min(first.days)).map(with).max().unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn later_is_never_better(parts in vec(part(), 1..6), terms in terms(), at in any::<prop::sample::Index>(), more in 1..9_u32) {
            let mut later = parts.clone();
            let late = &mut later[at.index(parts.len())];
            late.days = late.days.saturating_add(more);
            prop_assert!(sum(&later, &terms) <= sum(&parts, &terms));
            let kinder = Terms { free_days: terms.free_days + 1, ..terms.clone() };
            prop_assert!(sum(&parts, &terms) <= sum(&parts, &kinder));
        }

        #[test]
        fn weights_scale(parts in vec(part(), 1..6), terms in terms(), times in 0..5_u32) {
            let heavier: Vec<Part> = parts.iter().map(|part| Part { weight: times * part.weight, ..*part }).collect();
            prop_assert_eq!(sum(&heavier, &terms), u64::from(times) * sum(&parts, &terms));
        }

        #[test]
        fn who_is_in_time_has_the_plain_total(parts in vec(part(), 1..6), terms in terms()) {
            let plain: Vec<Part> = parts.iter().map(|part| Part { weight: 1, days: 0, ..*part }).collect();
            let points: u32 = plain.iter().filter_map(|part| part.earned).sum();
            prop_assert_eq!(sum(&plain, &terms), 100 * u64::from(points));
        }

        #[test]
        fn free_days_are_spent_best(parts in vec(part(), 1..5), terms in terms()) {
            let marks = marks(&parts, &terms);
            prop_assert_eq!(total(&marks).unwrap(), by_hand(&parts, &terms, terms.free_days));
            prop_assert!(marks.iter().map(|mark| mark.free).sum::<u32>() <= terms.free_days);
            for (mark, part) in marks.iter().zip(&parts) {
                prop_assert!(mark.free <= part.days && mark.counted.unwrap() <= mark.of);
            }
        }
    }

    #[test]
    fn a_term_by_hand() {
        let terms = Terms { free_days: 2, penalty: 10, last_day: Some(7) };
        let part = |earned, weight, days| Part { earned: Some(earned), points: 10, weight, days };
        // Two free days save 2 of the second lesson's points each, and only 1 of the first one's.
        let parts = [part(10, 1, 3), part(10, 2, 2), part(9, 1, 8)];
        let marks = marks(&parts, &terms);
        let counted: Vec<String> = marks.iter().map(|mark| decimal(mark.counted.unwrap())).collect();
        assert_eq!(counted, ["7", "20", "0"]);
        assert_eq!(marks.iter().map(|mark| mark.free).collect::<Vec<_>>(), [0, 2, 0]);
        assert!(!marks[2].accepted);
        let waiting = super::marks(&[Part { earned: None, ..parts[0] }, parts[1]], &terms);
        assert_eq!((total(&waiting), waiting[1].counted), (None, Some(2000)));
        assert_eq!([0, 5, 50, 1230, 1205].map(decimal), ["0", "0.05", "0.5", "12.3", "12.05"]);
    }
}
