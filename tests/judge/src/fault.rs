//! Known wrong versions: what explains wrong answers is found by making the same mistake.

use tasks::{Answer, Precision, Task, attempt};

use super::compare::compare;
use super::{AnswerKey, Judge, Question};

/// A check's questions, its tasks, and the answers to them.
pub(crate) type Row<'a, F> = (&'a AnswerKey, &'a [Task<F>], &'a [Answer]);

/// A mistake that students make.
pub struct Fault<F: 'static> {
    /// What was done, and the cure.
    pub cause: &'static str,
    /// The hint of the lesson's chapter that helps, if one does.
    pub hint: Option<u8>,
    /// The functions with this mistake in them, in the ways in which it is written.
    pub versions: &'static [F],
}

impl<F> Fault<F> {
    /// The cause, and where to find help.
    pub(crate) fn told(&self, lesson: &str) -> String {
        let chapter = tasks::number(lesson);
        let hint = self.hint.map(|hint| format!(" (hint {hint} of chapter {chapter})"));
        format!("{}{}", self.cause, hint.unwrap_or_default())
    }

    /// Whether it explains that a check is not passed: not all of its versions pass it.
    pub(crate) fn spoils(&self, row: &Row<F>) -> bool {
        !self.versions.iter().all(|version| passes(version, row))
    }
}

impl<F> Judge<F> {
    /// The faults that, on each input of a check, give what was answered. `before` are the checks that come before it: a
    /// fault that fails one of them in another way than the answers do is not what is wrong. One that passes it may be, as
    /// there may be two.
    pub(crate) fn faults_of(&self, before: &[Row<F>], row: Row<F>) -> Vec<&Fault<F>> {
        let gives = |version: &F, &(key, tasks, answers): &Row<F>| {
            let mut wrong = false;
            let same = tasks.iter().zip(&key.questions).zip(answers).all(|((task, question), answer)| {
                let own = attempt(task, version);
                wrong |= !right(question, &own);
                alike(&own, answer, question.precision)
            });
            same && wrong && answers.len() == tasks.len()
        };
        let is_it = |version: &F| {
            let agrees = |row: &Row<F>| passes(version, row) || gives(version, row);
            gives(version, &row) && before.iter().all(agrees)
        };
        self.faults.iter().filter(|fault| fault.versions.iter().any(is_it)).collect()
    }
}

fn passes<F>(version: &F, (key, tasks, _): &Row<F>) -> bool {
    tasks.iter().zip(&key.questions).all(|(task, question)| right(question, &attempt(task, version)))
}

fn right(question: &Question, answer: &Answer) -> bool {
    matches!(answer, Answer::Raw(raw) if question.differs(raw).is_empty())
}

/// Whether two answers come of the same mistake. Where a picture may have strays, these are closer to each other
/// than either may be to what is expected.
fn alike(a: &Answer, b: &Answer, precision: Precision) -> bool {
    // After the place in the code.
    let message = |said: &str| said.split_once(": ").map_or("", |(_, message)| message).to_string();
    match (a, b) {
        (Answer::Raw(a), Answer::Raw(b)) => {
            compare(a, b, Precision { strays: precision.strays / 4, ..precision }).is_empty()
        }
        (Answer::Crashed(a), Answer::Crashed(b)) => !message(a).is_empty() && message(a) == message(b),
        _ => false,
    }
}
