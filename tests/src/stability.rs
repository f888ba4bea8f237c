//! Where methods fail, and where they must not: tables of (input, method, what must happen).
//!
//! A lesson writes the table and one function, which runs a method on an input and says what became of it. A row
//! may name several methods, as in `("scaled, bresenham", Exact)`.

use std::fmt::{self, Display, Formatter};
use std::panic::{AssertUnwindSafe, catch_unwind};

use common::Method;

/// What must happen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Must {
    /// Nothing is wrong.
    Exact,
    /// The error is at most this.
    AtMost(f64),
    /// The error is this large at least, and at most that.
    Between(f64, f64),
    /// Just this is wrong.
    Fails(&'static str),
    /// There is no result.
    Nothing,
}

/// Methods of a table, with commas between them, and what must happen with each.
pub type Row = (&'static str, Must);

/// What an input is called, the input, and the rows of the methods.
pub type Case<I> = (&'static str, I, &'static [Row]);

/// What a method did.
#[derive(Clone, Debug, PartialEq)]
pub enum Did {
    /// All that is wrong, in words; none if nothing is.
    Faults(String),
    /// How far off the result is.
    Error(f64),
    /// It gave no result.
    Nothing,
    /// It panicked.
    Panicked,
}

impl From<Vec<String>> for Did {
    fn from(faults: Vec<String>) -> Self {
        Self::Faults(faults.join(", "))
    }
}

impl From<f64> for Did {
    fn from(error: f64) -> Self {
        Self::Error(error)
    }
}

impl From<Option<f64>> for Did {
    fn from(error: Option<f64>) -> Self {
        error.map_or(Self::Nothing, Self::Error)
    }
}

impl Must {
    fn met(self, did: &Did) -> bool {
        match (self, did) {
            (Must::Exact, Did::Faults(faults)) => faults.is_empty(),
            (Must::Exact, Did::Error(error)) => *error == 0.0,
            (Must::AtMost(limit), Did::Error(error)) => *error <= limit,
            (Must::Between(low, high), Did::Error(error)) => (low..=high).contains(error),
            (Must::Fails(expected), Did::Faults(faults)) => faults == expected,
            (Must::Nothing, Did::Nothing) => true,
            _ => false,
        }
    }
}

impl Display for Must {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Must::Exact => write!(f, "exact"),
            Must::AtMost(limit) => write!(f, "an error of at most {limit:?}"),
            Must::Between(low, high) => write!(f, "an error from {low:?} to {high:?}"),
            Must::Fails(faults) => write!(f, "`{faults}`"),
            Must::Nothing => write!(f, "no result"),
        }
    }
}

impl Display for Did {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Did::Faults(faults) if faults.is_empty() => write!(f, "exact"),
            Did::Faults(faults) => write!(f, "`{faults}`"),
            Did::Error(error) => write!(f, "an error of {error:?}"),
            Did::Nothing => write!(f, "no result"),
            Did::Panicked => write!(f, "a panic"),
        }
    }
}

/// The faults that there are, each with its number: `gaps 3`.
#[must_use]
pub fn counted<const N: usize>(faults: [(&str, usize); N]) -> Vec<String> {
    let there = faults.into_iter().filter(|fault| fault.1 > 0);
    there.map(|(what, count)| format!("{what} {count}")).collect()
}

/// Runs each row of each case, where every method of the lesson's table has one row.
///
/// # Panics
/// Where a row is not met, with all such rows; where a method has no row, or several, or there is no such method.
pub fn every_method<F, I, D: Into<Did>>(
    lesson: &str,
    methods: &[Method<F>],
    cases: &[Case<I>],
    run: impl Fn(&Method<F>, &I) -> D,
) {
    report(&[astray(lesson, methods, cases, 1), unmet(lesson, methods, cases, run)].concat());
}

/// As [`every_method`], where some methods have nothing to show.
///
/// # Panics
/// As [`every_method`], but for a method without a row.
pub fn some_methods<F, I, D: Into<Did>>(
    lesson: &str,
    methods: &[Method<F>],
    cases: &[Case<I>],
    run: impl Fn(&Method<F>, &I) -> D,
) {
    report(&[astray(lesson, methods, cases, 0), unmet(lesson, methods, cases, run)].concat());
}

fn report(wrong: &[String]) {
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

/// What must happen with each of a row's methods.
fn named((names, must): Row) -> impl Iterator<Item = Row> {
    names.split(", ").map(move |name| (name, must))
}

/// The rows without a method, and the methods with fewer rows than `least`, or more than one.
fn astray<F, I>(lesson: &str, methods: &[Method<F>], cases: &[Case<I>], least: usize) -> Vec<String> {
    let mut wrong = Vec::new();
    for (input, _, rows) in cases {
        let names: Vec<&str> = rows.iter().copied().flat_map(named).map(|row| row.0).collect();
        for method in methods {
            let count = names.iter().filter(|&&name| name == method.name).count();
            if !(least..=1).contains(&count) {
                wrong.push(format!("{lesson}, {input}: {count} rows for `{}`", method.name));
            }
        }
        let unknown = names.iter().filter(|name| Method::find(methods, name).is_none());
        wrong.extend(unknown.map(|name| format!("{lesson}, {input}: there is no method `{name}`")));
    }
    wrong
}

/// The rows in which something else happens than must.
fn unmet<F, I, D: Into<Did>>(
    lesson: &str,
    methods: &[Method<F>],
    cases: &[Case<I>],
    run: impl Fn(&Method<F>, &I) -> D,
) -> Vec<String> {
    let mut wrong = Vec::new();
    for (input, given, rows) in cases {
        for (name, must) in rows.iter().copied().flat_map(named) {
            let Some(method) = Method::find(methods, name) else { continue };
            let did = catch_unwind(AssertUnwindSafe(|| run(method, given).into())).unwrap_or(Did::Panicked);
            if !must.met(&did) {
                wrong.push(format!("{lesson}, {input}, {name}: {must} was expected, but it is {did}"));
            }
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::Must::{AtMost, Between, Exact, Fails, Nothing};
    use super::*;

    type Root = fn(f64) -> Option<f64>;

    const fn method(name: &'static str, run: Root) -> Method<Root> {
        Method { name, run, promise: "", failure: "" }
    }

    const METHODS: &[Method<Root>] = &[
        method("exact", |x| (x >= 0.0).then(|| x.sqrt())),
        method("linear", |x| Some(x / 2.0 + 0.5)),
        method("careless", |x| if x < 0.0 { panic!("of {x}") } else { Some(x) }),
    ];

    fn error(method: &Method<Root>, x: &f64) -> Option<f64> {
        (method.run)(*x).map(|root| (root * root - x).abs())
    }

    fn complaints(cases: &[Case<f64>]) -> Vec<String> {
        [astray("roots", METHODS, cases, 1), unmet("roots", METHODS, cases, error)].concat()
    }

    #[test]
    fn a_table_that_is_met_says_nothing() {
        let four: &[Row] = &[("exact", Exact), ("linear, careless", Between(2.0, 12.0))];
        every_method("roots", METHODS, &[("1", 1.0, &[("exact, linear, careless", Exact)])], error);
        every_method("roots", METHODS, &[("4", 4.0, four)], error);
        some_methods("roots", METHODS, &[("-1", -1.0, &[("exact", Nothing)])], error);
    }

    #[test]
    fn every_unmet_row_is_named() {
        let four: &[Row] = &[("exact", Nothing), ("linear", AtMost(2.0)), ("careless", Between(13.0, 14.0))];
        let below: &[Row] = &[("exact", AtMost(9.0)), ("linear, careless", Exact)];
        let expected = [
            "roots, 4, exact: no result was expected, but it is an error of 0.0",
            "roots, 4, linear: an error of at most 2.0 was expected, but it is an error of 2.25",
            "roots, 4, careless: an error from 13.0 to 14.0 was expected, but it is an error of 12.0",
            "roots, -1, exact: an error of at most 9.0 was expected, but it is no result",
            "roots, -1, linear: exact was expected, but it is an error of 1.0",
            "roots, -1, careless: exact was expected, but it is a panic",
        ];
        assert_eq!(complaints(&[("4", 4.0, four), ("-1", -1.0, below)]), expected);
    }

    #[test]
    fn a_method_without_its_one_row_is_named() {
        let rows: &[Row] = &[("linear", Exact), ("linear", Exact), ("newton, exact", Exact)];
        let expected = [
            "roots, 1: 2 rows for `linear`",
            "roots, 1: 0 rows for `careless`",
            "roots, 1: there is no method `newton`",
        ];
        assert_eq!(complaints(&[("1", 1.0, rows)]), expected);
    }

    #[test]
    fn faults_are_compared_to_the_letter() {
        let holes = |count: usize| Did::from(counted([("holes", count), ("doubled", 0)]));
        assert!(Exact.met(&holes(0)) && Fails("holes 2").met(&holes(2)));
        assert!(
            !Exact.met(&holes(2)) && !Fails("holes 2").met(&holes(0)) && !Fails("holes 2").met(&holes(3))
        );
        assert!(!AtMost(1.0).met(&Did::Error(f64::NAN)) && !Exact.met(&Did::Error(f64::NAN)));
    }
}
