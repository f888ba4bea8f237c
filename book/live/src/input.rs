//! What a reader can move.

use common::{Method, Vec2};

/// One thing that a reader can move.
pub enum Input {
    /// A point of the drawing, dragged or moved by the arrow keys. Two values, in the sheet's coordinates.
    Point {
        /// What it is called.
        label: &'static str,
        /// Where it is at first.
        from: [f64; 2],
        /// The lowest x and y.
        low: [f64; 2],
        /// The highest x and y.
        high: [f64; 2],
        /// What an arrow key moves it by; it is nowhere but in whole steps from the lowest.
        step: f64,
    },
    /// A slider. One value.
    Slider {
        /// What it is called.
        label: &'static str,
        /// Where it is at first.
        from: f64,
        /// Its ends.
        range: [f64; 2],
        /// What an arrow key moves it by.
        step: f64,
    },
    /// What is turned by dragging over the picture, and by two sliders: to the right, −180° to 180°, and down, −90° to 90°. Two
    /// values, in whole degrees.
    Turn {
        /// How it is turned at first.
        from: [f64; 2],
    },
    /// A choice from a table of methods, which tells the chosen one's promise and failure. One value, the number of the row.
    Choice {
        /// What it is called.
        label: &'static str,
        /// The table.
        rows: fn() -> Vec<Method<()>>,
        /// The name of the row that is chosen at first.
        from: &'static str,
    },
    /// A button that draws by each method of the choice before it, again and again in turn, and tells how long each takes here.
    /// No value.
    Times,
}

/// What a number may be.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// What it is at first.
    pub from: f64,
    /// The least.
    pub low: f64,
    /// The greatest.
    pub high: f64,
}

impl Range {
    /// What a number becomes: what is none is as at first.
    #[must_use]
    pub fn nearest(self, value: f64) -> f64 {
        if value.is_nan() { self.from } else { value.clamp(self.low, self.high) }
    }
}

impl Input {
    /// What its values may be, two at most.
    pub fn ranges(&self) -> impl Iterator<Item = Range> + use<> {
        let range = |from, low, high| Some(Range { from, low, high });
        match self {
            Self::Point { from, low, high, .. } => {
                [range(from[0], low[0], high[0]), range(from[1], low[1], high[1])]
            }
            Self::Slider { from, range: [low, high], .. } => [range(*from, *low, *high), None],
            Self::Turn { from } => [range(from[0], -180.0, 180.0), range(from[1], -90.0, 90.0)],
            Self::Choice { rows, from, .. } => {
                let rows = rows();
                let first = rows.iter().position(|row| row.name == *from).unwrap_or_default();
                [range(first as f64, 0.0, rows.len().saturating_sub(1) as f64), None]
            }
            Self::Times => [None; 2],
        }
        .into_iter()
        .flatten()
    }
}

/// The rows of a table with other functions than the table's, as many, and with their names alone: the other words are in the
/// page's script.
///
/// What the compiler computes leaves the table's own functions out of the page's code, which each row's would else be in with all
/// that it can do.
pub(crate) const fn with<F, R: Copy, const N: usize>(table: &[Method<F>], runs: [R; N]) -> [Method<R>; N] {
    assert!(table.len() == N);
    let mut rows = [Method { name: "", run: runs[0], promise: "", failure: "" }; N];
    let mut n = 0;
    while n < N {
        rows[n] = Method { name: table[n].name, run: runs[n], promise: "", failure: "" };
        n += 1;
    }
    rows
}

/// A table with its rows' names and functions alone.
macro_rules! named {
    ($table:expr) => {
        const { &$crate::input::with($table, $crate::input::runs::<_, { $table.len() }>($table)) }
    };
}
pub(crate) use named;

/// The functions of a table.
pub(crate) const fn runs<F: Copy, const N: usize>(table: &[Method<F>]) -> [F; N] {
    let mut runs = [table[0].run; N];
    let mut n = 0;
    while n < N {
        runs[n] = table[n].run;
        n += 1;
    }
    runs
}

/// The values of a figure's inputs, taken in the inputs' order.
pub struct Values<'a> {
    rest: std::slice::Iter<'a, f64>,
    coarse: bool,
}

impl<'a> Values<'a> {
    /// All of them, and whether a figure that takes long may be drawn in fewer pixels. Most are not.
    #[must_use]
    pub fn new(values: &'a [f64], coarse: bool) -> Self {
        Self { rest: values.iter(), coarse }
    }

    /// How many pixels wide and high to draw: `whole`, or half of it if the drawing may be coarse.
    #[must_use]
    pub fn side(&self, whole: u16) -> u16 {
        if self.coarse { whole / 2 } else { whole }
    }

    /// A slider's.
    pub fn number(&mut self) -> f32 {
        self.rest.next().copied().unwrap_or_default() as f32
    }

    /// A point's.
    pub fn point(&mut self) -> Vec2 {
        Vec2::new(self.number(), self.number())
    }

    /// The row that is chosen.
    ///
    /// # Panics
    /// Where the table is empty.
    pub fn choice<F>(&mut self, table: &'static [Method<F>]) -> &'static Method<F> {
        &table[(self.number() as usize).min(table.len() - 1)]
    }
}
