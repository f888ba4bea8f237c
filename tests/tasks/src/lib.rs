//! Missions: the functions that a student writes, and the tasks on which they are tried.
//!
//! A mission is a set of functions. A [`Mission`] has checks, a check has tasks, made from a seed, and a task is a
//! call of those functions that returns a [`Raw`] result: pixels or numbers. What is right is known elsewhere: a
//! program that is built of this and of what a student wrote, such as `my-lines`, does tasks and writes down what
//! came of them. The lesson's `judge`, a program of its own, has the lesson's own functions do the same tasks, and
//! compares.
//!
//! Each lesson's mission is a package in `tests/lessons/NN-name/tasks`. It calls nothing that the mission asks for.

mod code;
mod raw;
pub mod scenery;
mod student;

use std::path::Path;

use common::Vec3;
use fastrand::Rng;

pub use code::Code;
pub use raw::{Answer, Raw};
pub use student::{attempt, cargo};

/// The course's folder.
pub const COURSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The seed of the inputs that students see.
pub const SEED: u64 = 1;

/// What a student writes in a lesson, and how it is checked. `F` is a set of functions.
pub struct Mission<F: 'static> {
    /// Number and name, as in `01-lines`.
    pub lesson: &'static str,
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
}

/// How far a right result may be from the reference's, since sums of floats depend on their order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// By how much a number may be off, relative where it is above 1; or a colour channel, in 255ths.
    pub tolerance: f32,
    /// How many pixels may be quite different: those in which the last bit decides between two texels or two
    /// surfaces.
    pub strays: usize,
}

impl Precision {
    /// Not at all.
    pub const EXACT: Self = Self { tolerance: 0.0, strays: 0 };
    /// Two 255ths, for what is shaded.
    pub const SHADED: Self = Self { tolerance: 2.0, strays: 0 };
    /// A model in a picture of 400×400: fewer than 1 pixel in 4000 may differ.
    pub const MODEL: Self = Self { tolerance: 2.0, strays: 39 };
    /// Rounding in f32, a few operations deep.
    pub const NUMBERS: Self = Self { tolerance: 1e-4, strays: 0 };
}

/// What is drawn, in pixels, with its depth: the two ends of a segment, or the corners of a triangle.
pub type Shape = Vec<Vec3>;

/// What comes of a set of functions.
type With<F, T> = Box<dyn Fn(&F) -> T>;

/// Calls of a student's functions on one input.
pub struct Task<F> {
    /// The input, for the reader: a call, or a few words.
    pub input: String,
    /// The same as Rust, for a test in the student's crate. After it, `got` is what is judged.
    pub code: String,
    /// Makes the calls.
    pub work: With<F, Raw>,
    /// What a picture consists of, in the order in which it is drawn. These functions place it.
    pub shapes: With<F, Vec<Shape>>,
}

impl<F> Task<F> {
    /// A task from what goes in, in words and as Rust, and what is done with it.
    pub fn new(
        input: impl Into<String>,
        code: impl Into<String>,
        work: impl Fn(&F) -> Raw + 'static,
    ) -> Self {
        let (input, code) = (input.into(), code.into());
        Self { input, code, work: Box::new(work), shapes: Box::new(|_| Vec::new()) }
    }

    /// A single call, after the lines of Rust that it needs.
    pub fn call(before: &str, call: String, work: impl Fn(&F) -> Raw + 'static) -> Self {
        let code = format!("{before}let got = {call};");
        Self::new(call, code, work)
    }

    /// The same task of a picture of these shapes.
    #[must_use]
    pub fn of(self, shapes: impl Fn(&F) -> Vec<Shape> + 'static) -> Self {
        Self { shapes: Box::new(shapes), ..self }
    }
}

impl<F> Mission<F> {
    /// The tasks of each check. A check's random numbers do not depend on the checks before it.
    #[must_use]
    pub fn tasks(&self, seed: u64) -> Vec<Vec<Task<F>>> {
        self.checks.iter().map(|check| (check.tasks)(&mut Rng::with_seed(seed))).collect()
    }
}

/// A lesson's name, of its number and name: `lines` of `01-lines`.
#[must_use]
pub fn name(lesson: &str) -> &str {
    lesson.split_once('-').map_or(lesson, |(_, name)| name)
}

/// A lesson's number, as it is said: `1` of `01-lines`.
#[must_use]
pub fn number(lesson: &str) -> &str {
    lesson.split_once('-').map_or(lesson, |(number, _)| number).trim_start_matches('0')
}

/// The lessons of a course that have a mission, in order, by number and name: its folders `lessons/NN-name`.
///
/// # Errors
/// Where that folder cannot be read.
pub fn lessons(course: &Path) -> std::io::Result<Vec<String>> {
    let folder = course.join("lessons");
    let mut lessons = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if folder.join(&name).join("mission/Cargo.toml").exists() {
            lessons.push(name);
        }
    }
    lessons.sort();
    Ok(lessons)
}
