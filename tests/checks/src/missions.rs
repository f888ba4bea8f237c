//! The missions: what a student writes, the tasks it is tried on, and the judgement.
//!
//! A mission is a set of functions, such as [`lines::Lines`]. A [`Mission`] has checks, a check has tasks, made
//! from a seed, and a task is a call of those functions that returns a [`Raw`] result: pixels or numbers. The
//! same task, done with the lesson's own functions, gives what is expected. So three things can be apart, in
//! three processes if need be:
//!
//! 1. a [`Task`] is done with anybody's functions and knows nothing of what is right;
//! 2. [`Mission::key`] does them with the reference and keeps the results as [`Sheet`]s;
//! 3. [`Sheet::judge`] compares the two and knows nothing of the functions.
//!
//! [`run`] is a student's program, which does all three.

mod causes;
pub mod judge;
pub mod program;
pub mod raw;
mod scenery;

pub mod camera;
pub mod gouraud;
pub mod lines;
pub mod shaders;
pub mod textures;
pub mod transforms;
pub mod triangles;
pub mod wireframe;
pub mod zbuffer;

use fastrand::Rng;

pub use judge::{Cause, Precision, Question, Sheet};
pub use program::run;
pub use raw::{Answer, Raw};

/// The lessons that have a mission, in order.
pub const LESSONS: [&str; 9] = [
    "01-lines",
    "02-wireframe",
    "03-triangles",
    "04-zbuffer",
    "05-textures",
    "06-gouraud",
    "07-transforms",
    "08-camera",
    "09-shaders",
];

/// What is expected in each of them, for a seed.
pub const KEYS: [fn(u64) -> Vec<Sheet>; 9] = [
    |seed| lines::MISSION.key(seed),
    |seed| wireframe::MISSION.key(seed),
    |seed| triangles::MISSION.key(seed),
    |seed| zbuffer::MISSION.key(seed),
    |seed| textures::MISSION.key(seed),
    |seed| gouraud::MISSION.key(seed),
    |seed| transforms::MISSION.key(seed),
    |seed| camera::MISSION.key(seed),
    |seed| shaders::MISSION.key(seed),
];

/// The seed of the inputs that students see.
pub const SEED: u64 = 1;

/// What a student writes in a lesson, and how it is checked. `F` is a set of functions.
pub struct Mission<F: 'static> {
    /// Number and name, as in `01-lines`.
    pub lesson: &'static str,
    /// The functions as the lesson has them.
    pub reference: F,
    /// The checks, in the order in which one would make them pass.
    pub checks: &'static [Check<F>],
}

/// One thing that a mission is checked for.
pub struct Check<F: 'static> {
    /// A word or two.
    pub name: &'static str,
    /// What it asks, in one line.
    pub asks: &'static str,
    /// What it is worth; those of a mission add up to 10.
    pub points: u32,
    /// The tasks, the same ones for the same random numbers.
    pub tasks: fn(&mut Rng) -> Vec<Task<F>>,
    /// How exact the results must be.
    pub precision: Precision,
    /// The faults that it recognises.
    pub causes: fn() -> Vec<Cause>,
}

/// Calls of a student's functions on one input.
pub struct Task<F> {
    /// The input, for the reader.
    pub input: String,
    /// Makes the calls.
    pub work: Box<dyn Fn(&F) -> Raw>,
}

impl<F> Task<F> {
    /// A task from what goes in and what is done with it.
    pub fn new(input: impl Into<String>, work: impl Fn(&F) -> Raw + 'static) -> Self {
        Self { input: input.into(), work: Box::new(work) }
    }
}

impl<F> Mission<F> {
    /// The name of the student's package, as in `my-lines`.
    #[must_use]
    pub fn package(&self) -> String {
        format!("my-{}", self.lesson.split_once('-').map_or(self.lesson, |(_, name)| name))
    }

    /// The tasks of each check. A check's random numbers do not depend on the checks before it.
    #[must_use]
    pub fn tasks(&self, seed: u64) -> Vec<Vec<Task<F>>> {
        self.checks.iter().map(|check| (check.tasks)(&mut Rng::with_seed(seed))).collect()
    }

    /// The questions of each check, with what is expected.
    #[must_use]
    pub fn key(&self, seed: u64) -> Vec<Sheet> {
        let sheet = |(check, tasks): (&Check<F>, Vec<Task<F>>)| Sheet {
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
            causes: (check.causes)(),
        };
        self.checks.iter().zip(self.tasks(seed)).map(sheet).collect()
    }
}
