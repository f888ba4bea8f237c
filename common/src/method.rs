//! One job, several methods, one table.
//!
//! A lesson lists its methods once, in a public constant `METHODS`, in the order in which one would
//! discover them: naive, right, fast. The lesson's program, its tests, its chart and its page of the book
//! are all derived from that table.

/// One way to do a lesson's job; a row of its table.
#[derive(Clone, Copy, Debug)]
pub struct Method<F> {
    /// What it is called on the command line and in charts.
    pub name: &'static str,
    /// The function, or the two instances of it that a lesson needs.
    pub run: F,
    /// In one line: what may be relied on.
    pub promise: &'static str,
    /// In one line: where it fails, or what it costs.
    pub failure: &'static str,
}

impl<F> Method<F> {
    /// The row of that name.
    #[must_use]
    pub fn find<'a>(table: &'a [Self], name: &str) -> Option<&'a Self> {
        table.iter().find(|method| method.name == name)
    }

    /// What the rows of a table say, without their functions.
    #[must_use]
    pub fn rows(table: &[Self]) -> Vec<Method<()>> {
        let row = |&Self { name, promise, failure, .. }: &Self| Method { name, run: (), promise, failure };
        table.iter().map(row).collect()
    }

    /// The table as text, two lines a row: the promise, the failure.
    #[must_use]
    pub fn list(table: &[Self]) -> String {
        let width = table.iter().map(|method| method.name.len()).max().unwrap_or(0);
        let row = |Method { name, promise, failure, .. }: &Self| {
            format!("{name:width$}  {promise}\n{:width$}  fails: {failure}\n", "")
        };
        table.iter().map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Function = fn(i32) -> i32;

    const TABLE: &[Method<Function>] = &[
        Method { name: "one", run: |n| n + 1, promise: "adds one", failure: "at the top" },
        Method { name: "double", run: |n| n * 2, promise: "doubles", failure: "half-way up" },
    ];

    #[test]
    fn a_row_is_found_by_its_name() {
        assert_eq!((Method::find(TABLE, "double").unwrap().run)(21), 42);
        assert!(Method::find(TABLE, "Double").is_none());
    }

    #[test]
    fn the_list_is_aligned() {
        let expected =
            "one     adds one\n        fails: at the top\ndouble  doubles\n        fails: half-way up\n";
        assert_eq!(Method::list(TABLE), expected);
    }
}
