//! What the tests of each judge ask of it.

use tasks::{Answer, SEED};

use super::{AnswerKey, Judge, Verdict};

impl<F> Judge<F> {
    /// What the checks say of these functions. Answers cross as text, as they do between processes.
    ///
    /// # Panics
    /// Where an answer is not the same after the crossing.
    #[must_use]
    pub fn verdicts(&self, functions: &F, seed: u64) -> Vec<Verdict> {
        let cross = |answer: Answer| answer.to_string().parse().expect("it was just written");
        let (keys, tasks) = (self.key(seed), self.mission.tasks(seed));
        let judge = |(key, tasks): (&AnswerKey, Vec<tasks::Task<F>>)| {
            let answers: Vec<Answer> =
                tasks.iter().map(|task| cross(Answer::Raw((task.work)(functions)))).collect();
            key.judge(&answers)
        };
        keys.iter().zip(tasks).map(judge).collect()
    }

    /// Checks that a fault costs the points of a check, and that its cause is said to be one with these words.
    ///
    /// # Panics
    /// Where that is not so.
    #[track_caller]
    pub fn recognises(&self, functions: &F, check: &str, words: &str) {
        let verdicts = self.verdicts(functions, SEED);
        let verdict = verdicts.iter().find(|verdict| verdict.name == check).expect("there is such a check");
        assert_eq!(verdict.earned(), 0, "{verdict:?}");
        assert!(verdict.cause.is_some_and(|cause| cause.contains(words)), "{verdict:?}");
    }

    /// Checks that the reference is right whatever the seed, and that the points add up to 10.
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
    }
}
