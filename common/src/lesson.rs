//! What a lesson is called, and which tables of methods it has.
//!
//! A lesson says it once, in its public constant `LESSON`. Its program, its tests, its chapter, its chart and
//! its row in the README are derived from there, or held against it by a test.

use crate::Method;

/// One lesson of the course.
#[derive(Clone, Copy, Debug)]
pub struct Lesson {
    /// Its place in the course, from 1.
    pub number: u8,
    /// The name of its package.
    pub name: &'static str,
    /// The title of its chapter.
    pub title: &'static str,
    /// Its job, in one line.
    pub job: &'static str,
    /// Its tables of methods.
    pub tables: &'static [Table],
}

/// One of a lesson's tables of methods, without the functions, which have other types in each.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// What it is called beside the lesson's other tables; empty for `METHODS`.
    pub name: &'static str,
    /// The job that all its methods do.
    pub job: &'static str,
    /// Its rows, in order.
    pub rows: fn() -> Vec<Row>,
}

/// What a row of a table says of its method.
pub type Row = Method<()>;

impl Lesson {
    /// Number and name, as its folders and files have them: `01-lines`.
    #[must_use]
    pub fn folder(&self) -> String {
        format!("{:02}-{}", self.number, self.name)
    }
}
