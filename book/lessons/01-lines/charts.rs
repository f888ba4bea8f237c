//! Lesson 1: segments.

use checks::segment::{distances, thickness};
use common::{Bounds, Color, Format, IVec2, Image, Method, Vec2Swizzles};
use fastrand::Rng;
use lines::{Line, METHODS};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// How a method draws.
type Draw = fn(IVec2, IVec2, &mut Image, Color);

/// The side of the picture that segments are drawn into.
const SIDE: i32 = 1000;

const HALF: (f64, &str) = (0.5, "within ½ px");

pub(crate) const CHART: Chart = Chart {
    name: "01-lines",
    job: "Lesson 1, the pixels of a segment",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity { name: "distance between pixels and line", unit: "px", limit: HALF },
    further: &["steps_without_pixel_%", "ends_missed", "reversed_differs_%"],
    samples: "random segments of 1 to 999 px in all directions",
    exhaustive: false,
    proved: &[],
    errors,
    timed: "such segments of 100 px, in a picture of 1000×1000",
    throughput: "Mpx/s",
    work,
    sizes: Sizes { name: "pixels a segment", all: &[1, 10, 100, 1000], usual: 100 },
    stability: Stability {
        stress: "length of segments of slope 0.37 and 0.61, px",
        falling: false,
        error: Quantity { name: "largest distance", unit: "px", limit: (1.0, "1 px") },
        measure: stability,
    },
    wrong: &["step-0.1", "step-0.01", "per-column", "listing"],
    advice: &[
        ("bresenham", "always, unless the line must be smooth: exact, any ends, free outside the picture"),
        ("distance", "where stairs would show"),
        ("wu", "the same, where the thickness may vary with the direction"),
        ("scaled", "inside the picture, with ends below 2²⁹: as exact, without setting up a window"),
    ],
};

/// The same methods by another measure: how thick their lines are, and how smooth.
pub(crate) const COVERAGE_CHART: Chart = Chart {
    name: "01-lines-coverage",
    job: "Lesson 1, a line one pixel thick",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity { name: "error of a pixel's share", unit: "of the pixel", limit: (0.1, "within 1/10") },
    further: &["ink_%"],
    samples: "random segments of 9 to 999 px in all directions, without their ends",
    exhaustive: false,
    proved: &[],
    errors: coverage_errors,
    timed: "segments of 100 px, in a picture of 1000×1000",
    throughput: "Mpx/s",
    work,
    sizes: Sizes { name: "pixels a segment", all: &[100], usual: 100 },
    stability: Stability {
        stress: "slope",
        falling: false,
        error: Quantity {
            name: "largest error of a pixel's share",
            unit: "of the pixel",
            limit: (0.1, "1/10 of a pixel"),
        },
        measure: coverage_stability,
    },
    wrong: CHART.wrong,
    advice: &[
        ("distance", "where lines of all directions should look alike"),
        ("wu", "nearly level or upright lines"),
        ("bresenham", "where stairs do no harm"),
    ],
};

/// A segment with two ends in the picture, its length any power of 10 up to the side with the same chance.
fn random_segment(random: &mut Rng) -> (IVec2, IVec2) {
    loop {
        let length = f64::from(SIDE).powf(random.f64());
        let (sin, cos) = (random.f64() * std::f64::consts::TAU).sin_cos();
        let [x, y] = [0, 0].map(|_| random.i32(0..SIDE));
        let b = IVec2::new(x + (length * cos).round() as i32, y + (length * sin).round() as i32);
        let inside = (0..SIDE).contains(&b.x) && (0..SIDE).contains(&b.y);
        if inside && b != IVec2::new(x, y) {
            return (IVec2::new(x, y), b);
        }
    }
}

fn pixels(method: usize, a: IVec2, b: IVec2) -> Vec<(i32, i32, u8)> {
    let mut pixels = Vec::new();
    (METHODS[method].run.visit)(a, b, Bounds::EVERYTHING, &mut |x, y, coverage| {
        pixels.push((x, y, coverage));
    });
    pixels
}

fn errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(40_000) {
        let (a, b) = random_segment(&mut random);
        for (method, errors) in errors.iter_mut().enumerate() {
            let mut drawn = pixels(method, a, b);
            let (largest, mean) = distances(a, b, &drawn);
            let all = a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)) as usize + 1;
            let missed =
                [a, b].iter().filter(|end| !drawn.iter().any(|&(x, y, _)| (x, y) == (end.x, end.y))).count();
            let mut reversed = pixels(method, b, a);
            drawn.sort_unstable();
            reversed.sort_unstable();
            let gaps = 100.0 * all.saturating_sub(steps(a, b, &drawn)) as f64 / all as f64;
            errors.add(largest, mean, &[gaps, missed as f64, if drawn == reversed { 0.0 } else { 100.0 }]);
        }
    }
    errors
}

/// Segments of that many pixels, in all directions. Steps without a pixel are no work done.
fn work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let length = (size as i32 - 1).min(SIDE - 1);
    let mut segment = || {
        let rise = random.i32(-length..=length);
        let (x, low) = (random.i32(0..SIDE - length), random.i32(0..SIDE - rise.abs()));
        let y = if rise < 0 { low - rise } else { low };
        let (a, b) = (IVec2::new(x, y), IVec2::new(x + length, y + rise));
        let (a, b) = if random.bool() { (a, b) } else { (b, a) };
        if random.bool() { (a, b) } else { (a.yx(), b.yx()) }
    };
    let segments: Vec<(IVec2, IVec2)> = (0..(20_000 / size).max(20)).map(|_| segment()).collect();
    let draws = |draw: Draw, amount: usize| {
        let (segments, mut image) = (segments.clone(), Image::new(SIDE as u16, SIDE as u16, Format::Rgb));
        Work::new(amount as f64, move || {
            segments.iter().for_each(|&(a, b)| draw(a, b, &mut image, Color::WHITE));
            image.get(0, 0)
        })
    };
    let nothing = draws(|_, _, _, _| {}, 0);
    let work = |(n, method): (usize, &Method<Line>)| {
        let done = segments.iter().map(|&(a, b)| steps(a, b, &pixels(n, a, b)));
        draws(method.run.draw, done.sum())
    };
    std::iter::once(nothing).chain(METHODS.iter().enumerate().map(work)).collect()
}

/// How many steps along the major axis have a pixel.
fn steps(a: IVec2, b: IVec2, drawn: &[(i32, i32, u8)]) -> usize {
    let steep = a.x.abs_diff(b.x) < a.y.abs_diff(b.y);
    let mut steps: Vec<i32> = drawn.iter().map(|&(x, y, _)| if steep { y } else { x }).collect();
    steps.sort_unstable();
    steps.dedup();
    steps.len()
}

/// How much of each pixel is covered wrongly, held against a line 1 px thick; the ends apart, where it has a shape
/// that nobody stated.
fn coverage_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), COVERAGE_CHART.further.len());
    for _ in 0..effort.samples(20_000) {
        let (a, b) = loop {
            let (a, b) = random_segment(&mut random);
            if (a - b).abs().max_element() >= 8 {
                break (a, b);
            }
        };
        for (method, errors) in errors.iter_mut().enumerate() {
            let found = thickness(a, b, &pixels(method, a, b));
            errors.add(found.largest, found.mean, &[100.0 * found.ink]);
        }
    }
    errors
}

/// Steeper and steeper lines.
fn coverage_stability(_: Effort) -> Vec<Series> {
    let rises = [5, 10, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200];
    let largest = |method, rise| {
        let (a, b) = (IVec2::ZERO, IVec2::new(200, rise));
        thickness(a, b, &pixels(method, a, b)).largest
    };
    let series = |method| rises.map(|rise| (f64::from(rise) / 200.0, largest(method, rise))).to_vec();
    (0..METHODS.len()).map(series).collect()
}

fn stability(effort: Effort) -> Vec<Series> {
    let lengths =
        (3..=if effort.quick { 15 } else { 21 }).map(|half| 10f64.powf(f64::from(half) / 3.0) as i32);
    let largest = |method, length: i32| {
        let ends = [0.37, 0.61].map(|slope| IVec2::new(length, (slope * f64::from(length)).round() as i32));
        ends.map(|b| distances(IVec2::ZERO, b, &pixels(method, IVec2::ZERO, b)).0)
            .into_iter()
            .fold(0.0, f64::max)
    };
    let series =
        |method| lengths.clone().map(|length| (f64::from(length), largest(method, length))).collect();
    (0..METHODS.len()).map(series).collect()
}
