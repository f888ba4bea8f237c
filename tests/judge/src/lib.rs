//! Judgement of missions: what is right, what is wrong, and why.
//!
//! A lesson's judge is a program, `tests/lessons/NN-name/judge.rs`: the lesson's own functions as [`Judge`], and, in
//! `faults.rs`, known wrong versions of them. It judges in two ways:
//!
//! - for a student it starts the program that was built of what the student wrote, asks it for its answers, and
//!   says what it finds, with a picture;
//! - for the grader, which runs such programs behind walls, it says what is asked, and judges answers in a file.

pub mod ask;
mod check;
mod compare;
mod enlarge;
mod fault;
mod input;
mod mark;
pub mod marks;
pub mod message;
mod report;
mod show;
pub mod source;

use std::path::Path;
use std::process::ExitCode;

use common::terminal::eprintln;
use tasks::{Answer, Mission, Precision, Raw, Task};

pub use compare::{Finding, Verdict, Wrong};
pub use fault::Fault;
use fault::Row;
pub use mark::picture_files;

/// A mission, and what is right.
pub struct Judge<F: 'static> {
    /// What is asked.
    pub mission: Mission<F>,
    /// The functions as the lesson has them.
    pub reference: F,
    /// Wrong versions that it recognises by their answers. Where two give the same ones, the first is named.
    pub faults: &'static [Fault<F>],
}

/// A task with its solution, apart from the functions that find it.
pub struct Question {
    /// What goes in, for the reader.
    pub input: String,
    /// What should come out.
    pub expected: Raw,
    /// How exact a result must be.
    pub precision: Precision,
}

/// The questions of one check.
pub struct AnswerKey {
    /// What the check is called.
    pub name: &'static str,
    /// What it asks, in one line.
    pub asks: &'static str,
    /// What it is worth.
    pub points: u32,
    /// The number of its first input, of all that the mission has, from 1.
    pub first: usize,
    /// The tasks, in the order of their answers.
    pub questions: Vec<Question>,
}

impl<F> Judge<F> {
    /// The questions of each check, with what is expected.
    #[must_use]
    pub fn key(&self, seed: u64) -> Vec<AnswerKey> {
        let mut first = 1;
        let rows = self.mission.checks.iter().zip(self.mission.tasks(seed));
        rows.map(|(check, tasks)| {
            let question = |task: Task<F>| Question {
                expected: (task.work)(&self.reference),
                input: task.input,
                precision: check.precision,
            };
            let questions: Vec<Question> = tasks.into_iter().map(question).collect();
            let key =
                AnswerKey { name: check.name, asks: check.asks, points: check.points, first, questions };
            first += key.questions.len();
            key
        })
        .collect()
    }

    /// Judges the answers to the questions of keys, check by check.
    pub(crate) fn judge(&self, seed: u64, keys: &[AnswerKey], answers: &[Answer]) -> Vec<Verdict> {
        let all = self.mission.checks.iter().zip(self.mission.tasks(seed));
        let asked = all.filter(|(check, _)| keys.iter().any(|key| key.name == check.name));
        let tasks: Vec<Vec<Task<F>>> = asked.map(|(_, tasks)| tasks).collect();
        let mut rest = answers;
        let mut take = |count: usize| {
            let (own, others) = rest.split_at(count.min(rest.len()));
            rest = others;
            own
        };
        let rows: Vec<Row<F>> = keys
            .iter()
            .zip(&tasks)
            .map(|(key, tasks)| (key, &tasks[..], take(key.questions.len())))
            .collect();
        // What the first wrong check shows is looked for in those after it.
        let mut named: Option<Vec<&Fault<F>>> = None;
        let verdict = |(n, &row): (usize, &Row<F>)| {
            let (key, _, own) = row;
            let mut verdict = key.judge(own);
            if !verdict.wrong.is_empty() {
                let mut faults = self.faults_of(&rows[..n], row);
                match &named {
                    None => named = Some(faults.clone()),
                    Some(named) => {
                        let again =
                            |fault: &&Fault<F>| named.iter().any(|named| std::ptr::eq(*named, *fault));
                        if faults.iter().any(again) {
                            faults.retain(again);
                        } else if faults.len() > 1 || named.iter().any(|fault| fault.spoils(&row)) {
                            faults.clear();
                        }
                    }
                }
                let told: Vec<String> = faults.iter().map(|fault| fault.told(self.mission.lesson)).collect();
                verdict.cause = Some(told.join("; or ")).filter(|told| !told.is_empty());
            }
            verdict
        };
        rows.iter().enumerate().map(verdict).collect()
    }

    /// A judge's program.
    ///
    /// The exit code is 0 if everything is right, 1 if not; for the grader, 0 if it could judge.
    #[must_use]
    pub fn run(&self) -> ExitCode {
        let arguments: Vec<String> = std::env::args().skip(1).collect();
        let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let result = match words.as_slice() {
            ["show", program, check @ ..] => self.show(Path::new(program), check.first().copied(), true),
            ["tell", program, check @ ..] => self.show(Path::new(program), check.first().copied(), false),
            ["input", _, number] => self.print_input(number),
            ["test", program, words @ ..] => self.test(Path::new(program), words),
            ["checks", seed] => self.print_checks(seed),
            ["mark", seed, answers, pictures] => self.mark(seed, Path::new(answers), Path::new(pictures)),
            _ => {
                eprintln(format_args!("for students: cargo run -p my-{}", tasks::name(self.mission.lesson)));
                return ExitCode::from(2);
            }
        };
        result.unwrap_or_else(|error| {
            eprintln(format_args!("error: {error:#}"));
            ExitCode::FAILURE
        })
    }
}
