//! What the tests of each judge ask of it.

use std::collections::BTreeSet;
use std::path::Path;

use tasks::{Answer, COURSE, Raw, SEED, attempt};

use super::fault::Row;
use super::{AnswerKey, Judge, Verdict};

impl<F> Judge<F> {
    /// What the checks say of these functions. Answers cross as text, as they do between processes.
    ///
    /// # Panics
    /// Where an answer is not the same after the crossing.
    #[must_use]
    pub fn verdicts(&self, functions: &F, seed: u64) -> Vec<Verdict> {
        let cross = |answer: Answer| answer.to_string().parse().expect("it was just written");
        let tasks = self.mission.tasks(seed);
        let answers: Vec<Answer> =
            tasks.iter().flatten().map(|task| cross(attempt(task, functions))).collect();
        self.judge(seed, &self.key(seed), &answers)
    }

    /// Checks that functions which do nothing earn nothing, whatever the seed.
    ///
    /// # Panics
    /// Where they earn something.
    #[track_caller]
    pub fn earns_nothing(&self, nothing: &F) {
        for seed in [SEED, 2, 3] {
            let verdicts = self.verdicts(nothing, seed);
            let earning: Vec<_> = verdicts.iter().filter(|verdict| verdict.earned() > 0).collect();
            assert!(earning.is_empty(), "{earning:?}");
        }
    }

    /// Checks that a fault costs points of a check, and that its cause is said to be one with these words.
    ///
    /// # Panics
    /// Where that is not so.
    #[track_caller]
    pub fn recognises(&self, functions: &F, check: &str, words: &str) {
        let verdicts = self.verdicts(functions, SEED);
        let verdict = verdicts.iter().find(|verdict| verdict.name == check).expect("there is such a check");
        assert!(verdict.earned() < verdict.points, "{verdict:?}");
        assert!(verdict.cause.as_ref().is_some_and(|cause| cause.contains(words)), "{verdict:?}");
    }

    /// Checks of each known wrong version, whatever the seed, that it costs points, and that of its first wrong check
    /// it is said to be the cause; that there are at least six; and that the hints are there.
    ///
    /// # Panics
    /// Where that is not so.
    #[track_caller]
    pub fn check_faults(&self) {
        let causes: BTreeSet<&str> = self.faults.iter().map(|fault| fault.cause).collect();
        assert!(causes.len() == self.faults.len() && causes.len() >= 6, "{}: {causes:?}", causes.len());
        let chapter = Path::new(COURSE).join("book/lessons").join(self.mission.lesson).join("chapter.md");
        let chapter = std::fs::read_to_string(chapter).expect("a lesson has a chapter");
        for fault in self.faults {
            let hint = fault.hint.map(|hint| format!("<summary>Hint {hint}:"));
            assert!(hint.is_none_or(|hint| chapter.contains(&hint)), "{}", fault.cause);
        }
        for seed in [SEED, 2] {
            let (keys, tasks) = (self.key(seed), self.mission.tasks(seed));
            for (fault, version) in
                self.faults.iter().flat_map(|fault| fault.versions.iter().map(move |v| (fault, v)))
            {
                let mut answers: Vec<Vec<Answer>> = Vec::new();
                let found = keys.iter().zip(&tasks).find_map(|(key, own)| {
                    answers.push(own.iter().map(|task| attempt(task, version)).collect());
                    let verdict = key.judge(answers.last()?);
                    let rows: Vec<Row<F>> = (keys.iter().zip(&tasks).zip(&answers))
                        .map(|((key, tasks), answers)| (key, &tasks[..], &answers[..]))
                        .collect();
                    let (&row, before) = rows.split_last()?;
                    (!verdict.wrong.is_empty()).then(|| (verdict, self.faults_of(before, row)))
                });
                let (verdict, faults) = found.unwrap_or_else(|| panic!("{:?} earns all", fault.cause));
                let causes: Vec<&str> = faults.iter().map(|fault| fault.cause).collect();
                assert!(
                    causes == [fault.cause],
                    "{}: {causes:?}, with seed {seed}: {verdict:?}",
                    fault.cause
                );
            }
        }
    }

    /// Checks that the reference is right whatever the seed, that each check asks for something else with another one, and
    /// that the points add up to 10.
    ///
    /// # Panics
    /// Where that is not so.
    #[track_caller]
    pub fn check(&self) {
        for seed in [SEED, 2, 3] {
            let verdicts = self.verdicts(&self.reference, seed);
            let wrong: Vec<_> = verdicts.iter().filter(|verdict| !verdict.wrong.is_empty()).collect();
            assert!(wrong.is_empty(), "{wrong:?}");
            assert_eq!(verdicts.iter().map(Verdict::earned).sum::<u32>(), 10);
        }
        let asked = |key: &AnswerKey| -> Vec<(String, Raw)> {
            key.questions.iter().map(|asked| (asked.input.clone(), asked.expected.clone())).collect()
        };
        for (key, other) in self.key(2).iter().zip(self.key(3)) {
            assert!(asked(key) != asked(&other), "{}: the same whatever the seed", key.name);
        }
    }
}
