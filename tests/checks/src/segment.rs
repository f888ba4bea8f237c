//! A drawn segment against the ideal line, in rational numbers.
//!
//! Distances are measured across the major axis, the one along which the segment is longer, between a
//! pixel's centre and the line through the centres of the two end pixels. The distance at a right angle is
//! never larger.

use std::collections::BTreeMap;

use common::{Bounds, IVec2, Vec2Swizzles};

/// How the pixels of a drawn segment lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Pixels, counted as often as they were plotted.
    pub pixels: usize,
    /// Steps along the major axis, between the ends, that have no pixel.
    pub gaps: u64,
    /// Steps that have more than one pixel, or the same one more than once.
    pub doubled: u64,
    /// Pixels before the first end or behind the second.
    pub beyond: usize,
    /// How many of the two ends were not plotted.
    pub missed_ends: usize,
    /// The largest distance of a pixel from the line, in px: exact, then rounded to f64.
    pub largest: f64,
    /// Whether the largest distance is at most ½ px: decided exactly.
    pub nearest: bool,
    /// The mean distance, in px.
    pub mean: f64,
}

impl Report {
    /// Whether this is what an ideal algorithm draws: one pixel a step, the nearest one, both ends.
    #[must_use]
    pub fn is_ideal(&self) -> bool {
        (self.gaps, self.doubled, self.beyond, self.missed_ends) == (0, 0, 0, 0) && self.nearest
    }
}

/// The segment with its major axis first.
struct Axes {
    steep: bool,
    start: [i128; 2],
    /// Signed extent along the major and the minor axis.
    extent: [i128; 2],
}

impl Axes {
    fn new(a: IVec2, b: IVec2) -> Self {
        Self::between(a.to_array().map(i128::from), b.to_array().map(i128::from))
    }

    fn between([ax, ay]: [i128; 2], [bx, by]: [i128; 2]) -> Self {
        let [dx, dy] = [bx - ax, by - ay];
        let steep = dy.abs() > dx.abs();
        let order = |x: i128, y: i128| if steep { [y, x] } else { [x, y] };
        Self { steep, start: order(ax, ay), extent: order(dx, dy) }
    }

    /// Steps from the start, counted towards the end; and the distance's numerator over the segment's
    /// length (over 1 if that is 0), with `minor` and the result in units of 1/`unit`.
    fn locate(&self, major: i128, minor: i128, unit: i128) -> (i128, i128) {
        let [along, across] = self.extent;
        let step = (major - self.start[0]) * if along < 0 { -1 } else { 1 };
        let off = minor - self.start[1] * unit;
        if along == 0 {
            return (step, off.abs().max(step.abs() * unit));
        }
        (step, (off * along.abs() - across * step * unit).abs())
    }

    fn length(&self) -> i128 {
        self.extent[0].abs()
    }
}

/// Measures the pixels of a segment from `a` to `b` that was drawn without smoothing.
#[must_use]
pub fn measure(a: IVec2, b: IVec2, pixels: &[(i32, i32)]) -> Report {
    let axes = Axes::new(a, b);
    let located = |&(x, y): &(i32, i32)| {
        let [major, minor] = if axes.steep { [y, x] } else { [x, y] };
        axes.locate(major.into(), minor.into(), 1)
    };
    let mut steps: BTreeMap<i128, u64> = BTreeMap::new();
    let (mut largest, mut sum) = (0, 0);
    for (step, distance) in pixels.iter().map(located) {
        *steps.entry(step).or_default() += 1;
        largest = largest.max(distance);
        sum += distance;
    }
    let within: Vec<u64> = steps.range(0..=axes.length()).map(|(_, &count)| count).collect();
    let denominator = axes.length().max(1);
    Report {
        pixels: pixels.len(),
        gaps: (axes.length() + 1) as u64 - within.len() as u64,
        doubled: within.iter().filter(|&&count| count > 1).count() as u64,
        beyond: pixels.len() - within.iter().sum::<u64>() as usize,
        missed_ends: [a, b].iter().filter(|end| !pixels.contains(&(end.x, end.y))).count(),
        largest: largest as f64 / denominator as f64,
        nearest: 2 * largest <= denominator,
        mean: sum as f64 / denominator as f64 / pixels.len().max(1) as f64,
    }
}

/// The largest distance from the line, in px, of the centre of mass of a step's pixels; for a smooth line.
/// Infinite where a step has no pixel or their coverages do not add up to 255.
#[must_use]
pub fn largest_smooth(a: IVec2, b: IVec2, pixels: &[(i32, i32, u8)]) -> f64 {
    let axes = Axes::new(a, b);
    let mut mass: BTreeMap<i128, (i128, i128)> = BTreeMap::new();
    for &(x, y, coverage) in pixels {
        let [major, minor] = if axes.steep { [y, x] } else { [x, y] }.map(i128::from);
        let (total, moment) = mass.entry(major).or_default();
        *total += i128::from(coverage);
        *moment += minor * i128::from(coverage);
    }
    let whole = mass.len() as i128 == axes.length() + 1 && mass.values().all(|&(total, _)| total == 255);
    let distance = |(&major, &(_, moment)): (&i128, &(i128, i128))| axes.locate(major, moment, 255).1;
    let largest = mass.iter().map(distance).max().unwrap_or(0);
    if whole { largest as f64 / 255.0 / axes.length().max(1) as f64 } else { f64::INFINITY }
}

/// How far drawn pixels and the ideal line are apart, in px: the largest distance and the mean over the steps.
///
/// The distance at a step is that of its farthest pixel or, where pixels are covered in part, of their centre
/// of mass. A step without a pixel is as far away as the nearest step that has one; where nothing is drawn, all
/// are infinitely far. Pixels beyond the ends count for the largest distance only.
#[must_use]
pub fn distances(a: IVec2, b: IVec2, pixels: &[(i32, i32, u8)]) -> (f64, f64) {
    let axes = Axes::new(a, b);
    let (length, unit) = (axes.length(), axes.length().max(1) as f64);
    let mut steps: Vec<Option<f64>> = vec![None; length as usize + 1];
    // Of each step: its pixels' farthest distance, and the sum and the moment of their coverages.
    let mut drawn: BTreeMap<i128, (i128, [i128; 2])> = BTreeMap::new();
    for &(x, y, coverage) in pixels {
        let [major, minor] = if axes.steep { [y, x] } else { [x, y] }.map(i128::from);
        let (farthest, [total, moment]) = drawn.entry(major).or_insert((-1, [0, 0]));
        *farthest = if coverage < 255 { i128::MAX } else { axes.locate(major, minor, 1).1.max(*farthest) };
        *total += i128::from(coverage);
        *moment += minor * i128::from(coverage);
    }
    let mut largest = 0.0_f64;
    for (major, (farthest, [total, moment])) in drawn {
        // Where a pixel is covered in part, they share the light.
        let shared = farthest == i128::MAX;
        let (step, off) =
            if shared { axes.locate(major, moment, total) } else { (axes.locate(major, 0, 1).0, farthest) };
        let off = off as f64 / if shared { total as f64 } else { 1.0 } / unit;
        match usize::try_from(step).ok().and_then(|step| steps.get_mut(step)) {
            Some(distance) => *distance = Some(off),
            None => largest = largest.max((step - length).max(-step) as f64),
        }
    }
    // Once from either end, how many steps ago there was a pixel.
    let mut since = vec![f64::INFINITY; steps.len()];
    let (mut forth, mut back) = (f64::INFINITY, f64::INFINITY);
    for n in 0..steps.len() {
        let mirrored = steps.len() - 1 - n;
        forth = if steps[n].is_some() { 0.0 } else { forth + 1.0 };
        back = if steps[mirrored].is_some() { 0.0 } else { back + 1.0 };
        since[n] = since[n].min(forth);
        since[mirrored] = since[mirrored].min(back);
    }
    let distance = |n: usize| steps[n].unwrap_or(since[n]);
    let sum: f64 = (0..steps.len()).map(distance).sum();
    ((0..steps.len()).map(distance).fold(largest, f64::max), sum / steps.len() as f64)
}

/// Whether an ideal algorithm draws the pixel (x, y): its centre is less than ½ px from the line, or exactly
/// ½ px on the side of the end that comes first along the major axis.
#[must_use]
pub fn draws(a: IVec2, b: IVec2, x: i32, y: i32) -> bool {
    Axes::new(a, b).draws(x, y)
}

/// The pixels that an ideal algorithm draws in the bounds; the ends may lie anywhere up to ±2⁵⁰.
#[must_use]
pub fn pixels(a: [i128; 2], b: [i128; 2], bounds: Bounds) -> Vec<(i32, i32)> {
    let axes = Axes::between(a, b);
    let [low, high] = if axes.steep { [bounds.min.yx(), bounds.max.yx()] } else { [bounds.min, bounds.max] };
    let slope = axes.extent[1] as f64 / axes.extent[0] as f64;
    let mut pixels = Vec::new();
    for major in low.x..=high.x {
        // Where about the pixel is; `draws` then decides which one. A segment of one pixel has no slope.
        let along = (i128::from(major) - axes.start[0]) as f64;
        let risen = if slope.is_finite() { along * slope } else { 0.0 };
        let about = axes.start[1] + risen.round() as i128;
        for minor in about - 1..=about + 1 {
            if i128::from(low.y) <= minor && minor <= i128::from(high.y) {
                let (x, y) = if axes.steep { (minor as i32, major) } else { (major, minor as i32) };
                if axes.draws(x, y) {
                    pixels.push((x, y));
                }
            }
        }
    }
    pixels
}

/// How much of the pixel (x, y) a smooth line takes: 1 less its distance from the line in px, at least 0.
#[must_use]
pub fn smooth_share(a: IVec2, b: IVec2, x: i32, y: i32) -> f64 {
    let share = |(above, length): (i128, i128)| (1.0 - above.abs() as f64 / length.max(1) as f64).max(0.0);
    Axes::new(a, b).above(x, y).map_or(0.0, share)
}

/// The area that a line 1 px thick through the segment's ends, and beyond them, has in common with the pixel (x, y):
/// from 0 to 1, in f64. NaN where both ends are one.
#[must_use]
pub fn thick_share(a: IVec2, b: IVec2, x: i32, y: i32) -> f64 {
    let [dx, dy] = [f64::from(b.x) - f64::from(a.x), f64::from(b.y) - f64::from(a.y)];
    let length = dx.hypot(dy);
    // By symmetry only how far off the pixel's centre is counts, and the larger and the smaller share of the slope.
    let off = (dx * (f64::from(y) - f64::from(a.y)) - dy * (f64::from(x) - f64::from(a.x))).abs() / length;
    let [small, large] = [dx.abs().min(dy.abs()) / length, dx.abs().max(dy.abs()) / length];
    below(0.5 - off, small, large) - below(-0.5 - off, small, large)
}

/// A drawn line held against one 1 px thick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thickness {
    /// The largest and the mean error of a pixel's share, over the pixels that either line touches.
    pub largest: f64,
    /// See `largest`.
    pub mean: f64,
    /// What was drawn, as a share of what such a line covers.
    pub ink: f64,
}

/// How the shares of drawn pixels differ from those of a line 1 px thick. Without the last three steps at either end,
/// where the line has a shape that nobody stated; of a segment that is no longer all is 0. What is drawn more than once
/// counts with its largest share.
#[must_use]
pub fn thickness(a: IVec2, b: IVec2, pixels: &[(i32, i32, u8)]) -> Thickness {
    const ENDS: i128 = 3;
    let axes = Axes::new(a, b);
    let mut shares: BTreeMap<(i32, i32), u8> = BTreeMap::new();
    let mut add = |x: i32, y: i32, coverage: u8| {
        let major = i128::from(if axes.steep { y } else { x });
        if (ENDS..=axes.length() - ENDS).contains(&axes.locate(major, 0, 1).0) {
            let share = shares.entry((x, y)).or_default();
            *share = coverage.max(*share);
        }
    };
    pixels.iter().for_each(|&(x, y, coverage)| add(x, y, coverage));
    // All that the thick line touches is within 2 px of where it passes; of a long one the first thousand steps tell.
    for step in ENDS..=(axes.length() - ENDS).min(1000) {
        let [along, across] = axes.extent;
        let major = axes.start[0] + step * along.signum();
        let about = axes.start[1] + across * step / along.abs().max(1);
        for minor in about - 2..=about + 2 {
            let [x, y] = if axes.steep { [minor, major] } else { [major, minor] }.map(|n| n as i32);
            add(x, y, 0);
        }
    }
    let (mut largest, mut sum, mut count, mut ink, mut all) = (0.0_f64, 0.0, 0_u32, 0.0, 0.0);
    for (&(x, y), &coverage) in &shares {
        let (share, exact) = (f64::from(coverage) / 255.0, thick_share(a, b, x, y));
        if share > 0.0 || exact > 0.0 {
            largest = largest.max((share - exact).abs());
            sum += (share - exact).abs();
            count += 1;
        }
        ink += share;
        all += exact;
    }
    if count == 0 {
        return Thickness { largest: 0.0, mean: 0.0, ink: 0.0 };
    }
    Thickness { largest, mean: sum / f64::from(count), ink: ink / all }
}

/// The area of the part of the unit square about the origin with small·x + large·y ≤ t, where (small, large) is 1 long
/// and 0 ≤ small ≤ large.
fn below(t: f64, small: f64, large: f64) -> f64 {
    // The square's shadow on that direction is a trapezium; its area up to t is asked for.
    let (half, plateau) = ((small + large) / 2.0, (large - small) / 2.0);
    let corner = |rest: f64| if small > 0.0 { rest * rest / (2.0 * small * large) } else { 0.0 };
    match t.abs() {
        beyond if beyond >= half => f64::from(t > 0.0),
        slope if slope > plateau => {
            let cut = corner(half - slope);
            if t > 0.0 { 1.0 - cut } else { cut }
        }
        _ => 0.5 + t / large,
    }
}

impl Axes {
    /// See [`draws`].
    fn draws(&self, x: i32, y: i32) -> bool {
        self.above(x, y).is_some_and(|(above, length)| -length <= 2 * above && 2 * above < length.max(1))
    }

    /// How far a pixel lies beyond the line, seen from the first end along the major axis, with the
    /// segment's length as the unit; and that length. `None` before the first end and behind the second.
    fn above(&self, x: i32, y: i32) -> Option<(i128, i128)> {
        let [major, minor] = if self.steep { [y, x] } else { [x, y] }.map(i128::from);
        let [along, across] = self.extent;
        let ends = [self.start, [self.start[0] + along, self.start[1] + across]];
        let [first, last] = if along < 0 { [ends[1], ends[0]] } else { ends };
        let (length, rise) = (last[0] - first[0], last[1] - first[1]);
        let step = major - first[0];
        let risen = (minor - first[1]) * if rise < 0 { -1 } else { 1 };
        let above = if length == 0 { risen } else { risen * length - step * rise.abs() };
        (0..=length).contains(&step).then_some((above, length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: IVec2 = IVec2::new(2, 1);

    #[test]
    fn an_ideal_line_is_ideal_from_either_end() {
        let pixels = [(2, 1), (3, 1), (4, 2), (5, 2)];
        for [from, to] in [[A, IVec2::new(5, 2)], [IVec2::new(5, 2), A]] {
            let report = measure(from, to, &pixels);
            assert!(report.is_ideal());
            assert_eq!((report.largest, report.mean), (1.0 / 3.0, 1.0 / 6.0));
        }
    }

    #[test]
    fn every_fault_is_counted() {
        // Steep and downward; one step missing, one doubled, one pixel beyond, the far end missed.
        let report = measure(A, IVec2::new(2, -3), &[(2, 1), (2, 0), (3, 0), (2, -2), (2, 2)]);
        let counts = (report.pixels, report.gaps, report.doubled, report.beyond, report.missed_ends);
        assert_eq!(counts, (5, 2, 1, 1, 1));
        assert_eq!((report.largest, report.nearest), (1.0, false));
    }

    #[test]
    fn a_segment_of_one_pixel_has_distances_too() {
        assert!(measure(A, A, &[(2, 1)]).is_ideal());
        assert_eq!(measure(A, A, &[(2, 0)]).largest, 1.0);
        assert_eq!(measure(A, A, &[]).gaps, 1);
    }

    #[test]
    fn a_tie_goes_to_the_first_end() {
        // Half-way, the line from (0, 0) to (2, 1) is ½ px from two pixels, as is its mirror image.
        for (b, tie, other) in [(IVec2::new(2, 1), 0, 1), (IVec2::new(2, -1), 0, -1)] {
            for [from, to] in [[IVec2::ZERO, b], [b, IVec2::ZERO]] {
                assert!(draws(from, to, 1, tie) && !draws(from, to, 1, other));
                assert!(draws(from, to, 2, b.y) && !draws(from, to, 3, b.y));
                assert_eq!([tie, other, 5].map(|y| smooth_share(from, to, 1, y)), [0.5, 0.5, 0.0]);
            }
        }
        assert!(draws(A, A, 2, 1) && !draws(A, A, 2, 0) && !draws(A, A, 2, 2) && !draws(A, A, 3, 1));
    }

    #[test]
    fn a_thick_line_covers_what_points_say() {
        for (b, x, y) in [(5, 2, 2), (3, 2, 1), (0, 1, 0), (-4, 1, -1), (7, 3, 5), (1, 2, 1), (5, 1, 2)]
            .map(|(dy, x, y)| (IVec2::new(5, dy), x, y))
        {
            let (dx, dy) = (f64::from(b.x), f64::from(b.y));
            let points = (0..400 * 400).filter(|n| {
                let [px, py] = [(n % 400, x), (n / 400, y)]
                    .map(|(n, at)| f64::from(at) - 0.5 + (f64::from(n) + 0.5) / 400.0);
                (dx * py - dy * px).abs() <= 0.5 * dx.hypot(dy)
            });
            let share = points.count() as f64 / 160_000.0;
            assert!((thick_share(IVec2::ZERO, b, x, y) - share).abs() < 0.002, "{b} {x} {y}: {share}");
        }
        assert_eq!(thick_share(IVec2::ZERO, IVec2::new(4, 0), 2, 1), 0.0);
        assert_eq!(thick_share(IVec2::ZERO, IVec2::new(0, 4), 0, 2), 1.0);
    }

    #[test]
    fn a_level_line_is_as_thick_as_it_should_be_and_a_thin_one_is_not() {
        let level: Vec<(i32, i32, u8)> = (0..=20).map(|x| (x, 0, 255)).collect();
        let right = Thickness { largest: 0.0, mean: 0.0, ink: 1.0 };
        assert_eq!(thickness(IVec2::ZERO, IVec2::new(20, 0), &level), right);
        // At 45° a chain of pixels lacks what lies between them.
        let diagonal: Vec<(i32, i32, u8)> = (0..=20).map(|x| (x, x, 255)).collect();
        let found = thickness(IVec2::ZERO, IVec2::new(20, 20), &diagonal);
        assert!((found.largest - 0.25).abs() < 1e-9 && (found.ink - 0.5f64.sqrt()).abs() < 1e-9, "{found:?}");
        assert_eq!(thickness(IVec2::ZERO, IVec2::new(20, 20), &[]).ink, 0.0);
        assert_eq!(thickness(IVec2::ZERO, IVec2::new(5, 0), &level).largest, 0.0);
    }

    #[test]
    fn what_is_missing_is_as_far_as_what_is_there() {
        let b = IVec2::new(6, 1);
        let at = |xs: &[i32]| xs.iter().map(|&x| (x, 1, 255)).collect::<Vec<_>>();
        assert_eq!(distances(A, b, &at(&[2, 3, 4, 5, 6])), (0.0, 0.0));
        assert_eq!(distances(A, b, &at(&[2, 6])), (2.0, 4.0 / 5.0));
        assert_eq!(distances(A, b, &at(&[2, 3, 4, 5, 6, 9])), (3.0, 0.0));
        assert_eq!(distances(A, b, &[]), (f64::INFINITY, f64::INFINITY));
        assert_eq!(distances(A, A, &[(2, 4, 255)]), (3.0, 3.0));
        let smooth = [(2, 1, 255), (3, 1, 127), (3, 2, 128), (4, 2, 255)];
        assert!((distances(A, IVec2::new(4, 2), &smooth).0 - 0.5 / 255.0).abs() < 1e-12);
    }

    #[test]
    fn all_the_pixels_are_those_that_are_drawn() {
        let bounds = Bounds { min: IVec2::new(-3, -4), max: IVec2::new(6, 5) };
        for n in 0..6_i32.pow(4) {
            let [ax, ay, bx, by] = [n % 6, n / 6 % 6, n / 36 % 6, n / 216].map(|n| 3 * n - 7);
            let (a, b) = (IVec2::new(ax, ay), IVec2::new(bx, by));
            let all = (-3..=6).flat_map(|x| (-4..=5).map(move |y| (x, y)));
            let expected: Vec<_> = all.filter(|&(x, y)| draws(a, b, x, y)).collect();
            let mut got = pixels([ax, ay].map(i128::from), [bx, by].map(i128::from), bounds);
            got.sort_unstable();
            assert_eq!(got, expected, "{a} to {b}");
        }
    }

    #[test]
    fn a_smooth_line_is_where_its_mass_is() {
        let b = IVec2::new(4, 2);
        let good = [(2, 1, 255), (3, 1, 127), (3, 2, 128), (4, 2, 255)];
        assert!((largest_smooth(A, b, &good) - 0.5 / 255.0).abs() < 1e-12);
        assert_eq!(largest_smooth(A, b, &good[..3]), f64::INFINITY);
        assert_eq!(largest_smooth(A, b, &[(2, 1, 255), (3, 1, 127), (4, 2, 255)]), f64::INFINITY);
    }
}
