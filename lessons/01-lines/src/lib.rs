//! Lesson 1: the pixels of a line segment.
//!
//! **You will see** a white and a red line, 68 pixels each. **New:** going from a formula with real numbers
//! to a loop with whole ones, one step at a time, and knowing at each step what is still wrong.
//!
//! The job: given two pixels *a* and *b*, visit the pixels of the segment between them. An ideal result has
//! a pixel in each column (or row, if the segment is steep), never more than half a pixel from the line
//! through the two pixels' centres; both ends are among them, and b→a gives the same pixels as a→b.
//!
//! [`METHODS`] holds eleven ways to do it. [`slides`] has the eight that lead to the algorithm, [`bresenham()`]
//! the algorithm itself, [`wu()`] and [`distance()`] its smooth relatives. Each one calls `plot(x, y, coverage)` for its
//! pixels, `coverage` being the share of the pixel that the line covers, in 255ths. `window` is what can be
//! seen: only the last three look at it, the others walk the whole segment.
//!
//! Conventions: whole pixels, origin bottom-left, y up. Coordinates are any `i32`.

pub mod bresenham;
pub mod distance;
mod major;
pub mod slides;
pub mod wu;

use common::{Bounds, Color, IVec2, Image, Lesson, Method, Table};

pub use bresenham::bresenham;
pub use distance::distance;
pub use wu::wu;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 1,
    name: "lines",
    title: "Lines",
    job: "the pixels of a line segment",
    tables: &[Table { name: "", job: "Set the pixels of a segment", rows: || Method::rows(METHODS) }],
};

/// The coverage of a pixel that is wholly the line's.
pub(crate) const FULL: u8 = 255;

/// One method as two functions that share their code.
#[derive(Clone, Copy)]
pub struct Line {
    /// Draws the segment; compiled for just this, it is what gets timed.
    pub draw: fn(IVec2, IVec2, &mut Image, Color),
    /// Calls `plot(x, y, coverage)` for the pixels of the segment; tests look at it this way.
    pub visit: Visit,
}

/// Two ends, a window, and `plot(x, y, coverage)`.
pub type Visit = fn(IVec2, IVec2, Bounds, &mut dyn FnMut(i32, i32, u8));

/// Draws the segment from `a` to `b`, both included, by Bresenham's algorithm. What lies outside the
/// picture is left out and costs nothing.
// ANCHOR: line
pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {
    bresenham(a, b, image.bounds(), |x, y, _| image.set(x, y, color));
}
// ANCHOR_END: line

/// Colours pixels of a picture by how much of each is covered.
fn blend(image: &mut Image, color: Color) -> impl FnMut(i32, i32, u8) {
    move |x, y, coverage| image.blend(x, y, color, coverage)
}

/// The ways to draw a segment, from the first idea to the last.
pub const METHODS: &[Method<Line>] = &[
    Method {
        name: "step-0.1",
        run: Line {
            draw: |a, b, image, color| slides::step_tenth(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::step_tenth(a, b, window, plot),
        },
        promise: "about ten pixels, spread evenly",
        failure: "gaps beyond 10 px; repeats pixels below; may miss the far end",
    },
    Method {
        name: "step-0.01",
        run: Line {
            draw: |a, b, image, color| slides::step_hundredth(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::step_hundredth(a, b, window, plot),
        },
        promise: "about a hundred pixels, spread evenly",
        failure: "gaps beyond 100 px; wasteful below; may miss the far end",
    },
    Method {
        name: "per-column",
        run: Line {
            draw: |a, b, image, color| slides::per_column(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::per_column(a, b, window, plot),
        },
        promise: "one pixel in every column",
        failure: "gaps if steep; nothing if leftward; a wrong pixel if both ends are one; rounds down",
    },
    Method {
        name: "transposed",
        run: Line {
            draw: |a, b, image, color| slides::transposed(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::transposed(a, b, window, plot),
        },
        promise: "no gaps in any direction, about 1 px off",
        failure: "a wrong pixel if both ends are one; rounds down; over 1 px off beyond 10⁵ px, wrong beyond 2²⁴",
    },
    Method {
        name: "slope",
        run: Line {
            draw: |a, b, image, color| slides::slope(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::slope(a, b, window, plot),
        },
        promise: "no gaps, one addition a pixel",
        failure: "rounds down; rounding adds up: some 0.3 px more after 16,000 px, at worst 4; 11 and 60 after 65,000",
    },
    Method {
        name: "fraction",
        run: Line {
            draw: |a, b, image, color| slides::fraction(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::fraction(a, b, window, plot),
        },
        promise: "no gaps, rounds to nearest, y is an integer",
        failure: "rounding adds up, more slowly: at worst 0.05 px after a million; a tie may fall either way",
    },
    Method {
        name: "scaled",
        run: Line {
            draw: |a, b, image, color| slides::scaled(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::scaled(a, b, window, plot),
        },
        promise: "integers only: exact, at most 1/2 px off",
        failure: "32 bits overflow on lines of some 2³⁰ px; walks what cannot be seen",
    },
    Method {
        name: "listing",
        run: Line {
            draw: |a, b, image, color| slides::listing(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| slides::listing(a, b, window, plot),
        },
        promise: "integers only, compared with 0 (the slides' last version, as printed)",
        failure: "steps before it plots: 1 px ahead, and past the end, on slopes above 1/2; overflows too",
    },
    Method {
        name: "bresenham",
        run: Line {
            draw: |a, b, image, color| bresenham(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| bresenham(a, b, window, plot),
        },
        promise: "exact, at most 1/2 px off, any 32-bit ends; costs only what can be seen",
        failure: "jagged: a pixel is the line's or is not",
    },
    Method {
        name: "wu",
        run: Line {
            draw: |a, b, image, color| wu(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| wu(a, b, window, plot),
        },
        promise: "smooth: two pixels share each column, 1/255 px off; any 32-bit ends; costs only what can be seen",
        failure: "twice the pixels, each mixed with what lies below; sloping lines are paler, at 45 degrees by 29 %",
    },
    Method {
        name: "distance",
        run: Line {
            draw: |a, b, image, color| distance(a, b, image.bounds(), blend(image, color)),
            visit: |a, b, window, plot| distance(a, b, window, plot),
        },
        promise: "smooth, within 12 % as thick in every direction: coverage by the distance at a right angle; any 32-bit ends",
        failure: "up to three pixels a step, each mixed with what lies below; ends stick out by half a pixel",
    },
];
