//! Compares answers with what is expected: what is wrong, how much of it, and where first.

use std::fmt;

use checks::picture::{self, Fault};
use common::{Color, IVec2};
use tasks::{Answer, Precision, Raw};

use super::{AnswerKey, Question};

impl Question {
    /// In what a result differs from the expected one.
    pub(crate) fn differs(&self, got: &Raw) -> Vec<Finding> {
        compare(&self.expected, got, self.precision)
    }
}

/// One thing that is wrong with an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// Pixels that should be drawn and are not.
    Missing {
        /// How many.
        count: usize,
        /// The lowest, of these the leftmost.
        first: IVec2,
    },
    /// Pixels that should be black and are not.
    Extra {
        /// How many.
        count: usize,
        /// The lowest, of these the leftmost.
        first: IVec2,
    },
    /// Pixels of another colour than expected.
    WrongColor {
        /// How many.
        count: usize,
        /// The lowest, of these the leftmost.
        first: IVec2,
        /// What it should be there.
        expected: Color,
        /// What it is there.
        got: Color,
    },
    /// Pixels with another depth than expected.
    WrongDepth {
        /// How many.
        count: usize,
        /// The lowest, of these the leftmost.
        first: IVec2,
        /// What it should be there.
        expected: f32,
        /// What it is there.
        got: f32,
    },
    /// Another value than expected.
    WrongValue {
        /// What it should be.
        expected: String,
        /// What it is.
        got: String,
    },
    /// Entries of a matrix that are other numbers than expected.
    WrongNumber {
        /// How many.
        count: usize,
        /// Row of the first one, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// What it should be there.
        expected: f32,
        /// What it is there.
        got: f32,
    },
    /// A list of another length than expected.
    WrongLength {
        /// How long it should be.
        expected: usize,
        /// How long it is.
        got: usize,
    },
    /// Points of a list that are others than expected.
    WrongPoint {
        /// How many.
        count: usize,
        /// The first one, from 0.
        index: usize,
        /// What it should be.
        expected: String,
        /// What it is.
        got: String,
    },
    /// A result of another kind or size than expected.
    WrongShape,
    /// A `todo!` was reached.
    Unwritten(String),
    /// The code panicked or ended the process.
    Crashed(String),
    /// No result within the time limit.
    OutOfTime,
}

impl Finding {
    /// The first wrong pixel.
    pub(crate) fn pixel(&self) -> Option<IVec2> {
        match self {
            Self::Missing { first, .. }
            | Self::Extra { first, .. }
            | Self::WrongColor { first, .. }
            | Self::WrongDepth { first, .. } => Some(*first),
            _ => None,
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pixels = |count: usize| if count == 1 { "1 pixel".into() } else { format!("{count} pixels") };
        match self {
            Self::Missing { count, first } => {
                write!(f, "{} missing, the first at ({}, {})", pixels(*count), first.x, first.y)
            }
            Self::Extra { count, first } => {
                write!(f, "{} too many, the first at ({}, {})", pixels(*count), first.x, first.y)
            }
            Self::WrongColor { count, first, expected, got } => {
                let hex = |c: &Color| format!("{:02x}{:02x}{:02x}", c.r, c.g, c.b);
                let (IVec2 { x, y }, got, expected) = (first, hex(got), hex(expected));
                write!(
                    f,
                    "{} of another colour, the first at ({x}, {y}): {got}, not {expected}",
                    pixels(*count)
                )
            }
            Self::WrongDepth { count, first, expected, got } => {
                let IVec2 { x, y } = first;
                write!(
                    f,
                    "{} of another depth, the first at ({x}, {y}): {got}, not {expected}",
                    pixels(*count)
                )
            }
            Self::WrongValue { expected, got } => write!(f, "gave {got}, expected {expected}"),
            Self::WrongNumber { count, row, column, expected, got } => {
                // As glam names it.
                let entry = ["x", "y", "z", "w"].get(*column).zip(["x", "y", "z", "w"].get(*row));
                let entry = entry.map(|(axis, part)| format!(", {axis}_axis.{part},")).unwrap_or_default();
                write!(
                    f,
                    "gave {got} in row {row}, column {column}{entry} of the matrix, expected {expected}"
                )?;
                match count {
                    1 => Ok(()),
                    2 => write!(f, "; another number is wrong"),
                    more => write!(f, "; {} more numbers are wrong", more - 1),
                }
            }
            Self::WrongLength { expected, got } => {
                write!(f, "gave a list of {got}, expected one of {expected}")
            }
            Self::WrongPoint { count, index, expected, got } => {
                write!(f, "gave {got} in place {index} of the list, expected {expected}")?;
                match count {
                    1 => Ok(()),
                    2 => write!(f, "; another place is wrong"),
                    more => write!(f, "; {} more places are wrong", more - 1),
                }
            }
            Self::WrongShape => write!(f, "the result has another size than it should"),
            Self::Unwritten(said) => write!(f, "not written yet: {said}"),
            Self::Crashed(said) => write!(f, "crashed: {said}"),
            Self::OutOfTime => write!(f, "ran out of time: does a loop never end?"),
        }
    }
}

/// What is wrong with one answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Its place among the check's questions.
    pub question: usize,
    /// At least one.
    pub findings: Vec<Finding>,
}

/// How a check was passed.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The check.
    pub name: &'static str,
    /// What it asks.
    pub asks: &'static str,
    /// What it is worth.
    pub points: u32,
    /// The answers that are wrong; if there is none, all points are earned.
    pub wrong: Vec<Wrong>,
    /// How many answers are right, of how many. Of those that are expected to be the same, one counts: whoever answers
    /// always the same has answered once.
    pub right: [usize; 2],
    /// What explains the answers, if a known fault gives the same ones.
    pub cause: Option<String>,
}

impl Verdict {
    /// The points earned, in proportion to what is right, rounded down.
    #[must_use]
    pub fn earned(&self) -> u32 {
        let [right, of] = self.right;
        if self.wrong.is_empty() { self.points } else { self.points * right as u32 / of as u32 }
    }
}

impl AnswerKey {
    /// Judges the answers to these questions. One that is not there counts as a crash.
    #[must_use]
    pub fn judge(&self, answers: &[Answer]) -> Verdict {
        let none = Answer::Crashed("there is no answer".into());
        let answer = |n: usize| answers.get(n).unwrap_or(&none);
        let wrong: Vec<Wrong> = (self.questions.iter().enumerate())
            .map(|(question, asked)| Wrong { question, findings: findings(asked, answer(question)) })
            .filter(|wrong| !wrong.findings.is_empty())
            .collect();
        let alike = |asked: &Question| self.questions.iter().filter(|q| q.expected == asked.expected).count();
        let more = self.questions.iter().map(alike).max().unwrap_or(1) - 1;
        let of = self.questions.len();
        let right = [(of - wrong.len()).saturating_sub(more), of - more];
        Verdict { name: self.name, asks: self.asks, points: self.points, wrong, right, cause: None }
    }
}

/// What is wrong with an answer; nothing if it is right.
fn findings(question: &Question, answer: &Answer) -> Vec<Finding> {
    match answer {
        Answer::Raw(raw) => question.differs(raw),
        Answer::Unwritten(said) => vec![Finding::Unwritten(said.clone())],
        Answer::Crashed(said) => vec![Finding::Crashed(said.clone())],
        Answer::OutOfTime => vec![Finding::OutOfTime],
    }
}

/// In what a result differs from the expected one.
pub(crate) fn compare(expected: &Raw, got: &Raw, precision: Precision) -> Vec<Finding> {
    let Precision { tolerance, strays } = precision;
    match (expected, got) {
        (Raw::Picture(expected), Raw::Picture(got)) => {
            let faults = picture::faults(expected, got, tolerance.clamp(0.0, 255.0) as u8);
            let same_size = !matches!(faults[..], [Fault::Size { .. }]);
            if same_size && faults.len() <= strays { Vec::new() } else { group(&faults) }
        }
        (Raw::Depths { width, values }, Raw::Depths { width: got_width, values: got })
            if width == got_width && values.len() == got.len() =>
        {
            let off = first_off(values, got, tolerance).filter(|&(count, ..)| count > strays);
            let finding = off.map(|(count, n, expected, got)| {
                let first = IVec2::new((n % width) as i32, (n / width) as i32);
                Finding::WrongDepth { count, first, expected, got }
            });
            finding.into_iter().collect()
        }
        (Raw::Numbers { columns, values }, Raw::Numbers { columns: got_columns, values: got })
            if columns == got_columns && values.len() == got.len() =>
        {
            let finding = first_off(values, got, tolerance).map(|(count, n, one, other)| {
                if values.len() == *columns {
                    Finding::WrongValue { expected: value(values), got: value(got) }
                } else {
                    Finding::WrongNumber {
                        count,
                        row: n / columns,
                        column: n % columns,
                        expected: one,
                        got: other,
                    }
                }
            });
            finding.into_iter().collect()
        }
        (Raw::Numbers { values, .. }, Raw::Numbers { values: got, .. })
            if values.is_empty() != got.is_empty() =>
        {
            let option = |values: &[f32]| match values {
                [] => "None".into(),
                some => format!("Some({})", value(some)),
            };
            vec![Finding::WrongValue { expected: option(values), got: option(got) }]
        }
        (Raw::List { columns, values }, Raw::List { columns: got_columns, values: got })
            if columns == got_columns =>
        {
            if values.len() != got.len() {
                let [expected, got] = [values, got].map(|values| values.len() / columns);
                return vec![Finding::WrongLength { expected, got }];
            }
            let points = || values.chunks_exact(*columns).zip(got.chunks_exact(*columns)).enumerate();
            let mut wrong = points().filter(|(_, (a, b))| first_off(a, b, tolerance).is_some());
            let first = wrong.next().map(|(index, (expected, got))| Finding::WrongPoint {
                count: 1 + wrong.count(),
                index,
                expected: value(expected),
                got: value(got),
            });
            first.into_iter().collect()
        }
        _ => vec![Finding::WrongShape],
    }
}

/// A number, a vector, or the rows of a matrix.
pub(crate) fn value(values: &[f32]) -> String {
    let list = |values: &[f32]| values.iter().map(|n| format!("{n}")).collect::<Vec<_>>().join(", ");
    match values {
        [n] => format!("{n}"),
        values if values.len() <= 4 => format!("({})", list(values)),
        values => {
            let side = values.len().isqrt();
            format!("[{}]", values.chunks(side).map(list).collect::<Vec<_>>().join("; "))
        }
    }
}

/// How many numbers are off by more than the tolerance, and the place and values of the first. A tolerance is
/// absolute up to 1 and relative beyond; infinities and NaN are equal to themselves alone.
fn first_off(expected: &[f32], got: &[f32], tolerance: f32) -> Option<(usize, usize, f32, f32)> {
    let same = |a: f32, b: f32| {
        a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= tolerance * a.abs().clamp(1.0, f32::MAX)
    };
    let off = || (0..expected.len()).filter(|&n| !same(expected[n], got[n]));
    off().next().map(|n| (off().count(), n, expected[n], got[n]))
}

/// The faults of a picture, one finding for each kind.
fn group(faults: &[Fault]) -> Vec<Finding> {
    let count = |kind: fn(&Fault) -> bool| faults.iter().filter(|fault| kind(fault)).count();
    let missing = count(|fault| matches!(fault, Fault::Missing(_)));
    let extra = count(|fault| matches!(fault, Fault::Extra(_)));
    let recolored = count(|fault| matches!(fault, Fault::WrongColor { .. }));
    let mut findings: Vec<Finding> = Vec::new();
    for fault in faults {
        let finding = match *fault {
            Fault::Size { .. } => Finding::WrongShape,
            Fault::Missing(first) => Finding::Missing { count: missing, first },
            Fault::Extra(first) => Finding::Extra { count: extra, first },
            Fault::WrongColor { at, expected, got } => {
                Finding::WrongColor { count: recolored, first: at, expected, got }
            }
        };
        let kind = std::mem::discriminant(&finding);
        if findings.iter().all(|found| std::mem::discriminant(found) != kind) {
            findings.push(finding);
        }
    }
    findings
}
