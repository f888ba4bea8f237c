//! Judgement of missions: what is right, what is wrong, and why.
//!
//! A lesson's judge is a program, `tests/lessons/NN-name/judge.rs`: the lesson's own functions as [`Judge`], and the
//! faults that it recognises in the results. It judges in two ways:
//!
//! - for a student it starts the program that was built of what the student wrote, asks it for its answers, and
//!   says what it finds, with a picture;
//! - for the grader, which runs such programs behind walls, it says what is asked, and judges answers in a file.

pub mod ask;
pub mod causes;
mod check;
mod compare;
mod mark;
mod show;

use std::path::Path;
use std::process::ExitCode;

use common::terminal::eprintln;
use tasks::{Mission, Precision, Raw};

pub use compare::{Finding, Verdict, Wrong};
pub use mark::picture_files;

/// A mission, and what is right.
pub struct Judge<F: 'static> {
    /// What is asked.
    pub mission: Mission<F>,
    /// The functions as the lesson has them.
    pub reference: F,
    /// For each check, in order, the faults that it recognises.
    pub causes: &'static [(&'static str, Causes)],
}

/// Makes a list of faults.
pub type Causes = fn() -> Vec<Cause>;

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
    /// The tasks, in the order of their answers.
    pub questions: Vec<Question>,
    /// Faults that it would recognise.
    pub causes: Vec<Cause>,
}

/// A fault that students make.
#[derive(Clone, Copy)]
pub struct Cause {
    /// What the student did, and the cure.
    pub name: &'static str,
    /// Whether this fault, and nothing else, is what is wrong with a result. It is tried, not guessed: mostly
    /// by doing the same to the expected result, see [`Question::becomes`].
    pub explains: fn(&Question, &Raw) -> bool,
}

impl<F> Judge<F> {
    /// The questions of each check, with what is expected.
    ///
    /// # Panics
    /// Where the rows of causes are not those of the checks.
    #[must_use]
    pub fn key(&self, seed: u64) -> Vec<AnswerKey> {
        let names = self.mission.checks.iter().map(|check| check.name);
        assert!(names.eq(self.causes.iter().map(|row| row.0)), "a row of causes for each check, in order");
        let rows = self.mission.checks.iter().zip(self.mission.tasks(seed)).zip(self.causes);
        rows.map(|((check, tasks), (_, causes))| AnswerKey {
            name: check.name,
            asks: check.asks,
            points: check.points,
            questions: tasks
                .into_iter()
                .map(|task| Question {
                    expected: (task.work)(&self.reference),
                    input: task.input,
                    precision: check.precision,
                })
                .collect(),
            causes: causes(),
        })
        .collect()
    }

    /// A judge's program.
    ///
    /// The exit code is 0 if everything is right, 1 if not; for the grader, 0 if it could judge.
    #[must_use]
    pub fn run(&self) -> ExitCode {
        let arguments: Vec<String> = std::env::args().skip(1).collect();
        let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let result = match words.as_slice() {
            ["show", program] => self.show(Path::new(program), true),
            ["tell", program] => self.show(Path::new(program), false),
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
