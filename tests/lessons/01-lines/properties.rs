use checks::segment::{draws, largest_smooth, measure, smooth_share, thickness};
use common::{Bounds, IVec2};
use lines::slides::scaled;
use lines::{METHODS, bresenham, distance, wu};
use proptest::prelude::*;

use crate::{places, visited};

fn point(range: std::ops::RangeInclusive<i32>) -> impl Strategy<Value = IVec2> {
    (range.clone(), range).prop_map(|(x, y)| IVec2::new(x, y))
}

/// Any coordinates, and those at the ends of the range more often than they would come up.
fn any_point() -> impl Strategy<Value = IVec2> {
    let coordinate = || prop_oneof![any::<i32>(), -50..50, Just(i32::MIN), Just(i32::MAX)];
    (coordinate(), coordinate()).prop_map(|(x, y)| IVec2::new(x, y))
}

/// A window of 12×12 px about the point at a share of the way from `a` to `b`.
fn window_on(a: IVec2, b: IVec2, share: f64, shift: IVec2) -> Bounds {
    let on = |from: i32, to: i32, shift: i32| {
        let at = f64::from(from) + (f64::from(to) - f64::from(from)) * share + f64::from(shift);
        (at as i32).clamp(i32::MIN + 6, i32::MAX - 6)
    };
    let middle = IVec2::new(on(a.x, b.x, shift.x), on(a.y, b.y, shift.y));
    Bounds { min: middle - 6, max: middle + 6 }
}

/// In a window, `bresenham` and `wu` draw what the rational line demands, and go no farther.
fn check_window(a: IVec2, b: IVec2, window: Bounds) {
    let all = (window.min.y..=window.max.y).flat_map(|y| (window.min.x..=window.max.x).map(move |x| (x, y)));
    let mut hard = places(&visited(|plot| bresenham(a, b, window, plot)));
    hard.sort_unstable();
    let mut expected: Vec<_> = all.clone().filter(|&(x, y)| draws(a, b, x, y)).collect();
    expected.sort_unstable();
    assert_eq!(hard, expected);

    let smooth = visited(|plot| wu(a, b, window, plot));
    assert!(smooth.len() <= 2 * 14, "{} pixels", smooth.len());
    for (x, y) in all {
        let coverage: u32 =
            smooth.iter().filter(|pixel| (pixel.0, pixel.1) == (x, y)).map(|p| u32::from(p.2)).sum();
        let error = f64::from(coverage) / 255.0 - smooth_share(a, b, x, y);
        assert!(error.abs() <= 1.0 / 255.0 + 1e-9, "({x}, {y}) has {coverage}/255, off by {error}");
    }
}

proptest! {
    #[test]
    fn bresenham_is_ideal_and_the_same_from_either_end(a in point(-300..=300), b in point(-300..=300)) {
        let run = |a, b| {
            let mut pixels = places(&visited(|plot| bresenham(a, b, Bounds::EVERYTHING, plot)));
            pixels.sort_unstable();
            pixels
        };
        let pixels = run(a, b);
        prop_assert!(measure(a, b, &pixels).is_ideal());
        prop_assert_eq!(pixels.len() as i32, (b - a).abs().max_element() + 1);
        prop_assert_eq!(pixels, run(b, a));
    }

    #[test]
    fn scaled_draws_the_pixels_of_bresenham(a in point(-300..=300), b in point(-300..=300)) {
        let expected = visited(|plot| bresenham(a, b, Bounds::EVERYTHING, plot));
        prop_assert_eq!(visited(|plot| scaled(a, b, Bounds::EVERYTHING, plot)), expected);
    }

    #[test]
    fn wu_is_smooth_and_the_same_from_either_end(a in point(-300..=300), b in point(-300..=300)) {
        let run = |a, b| {
            let mut pixels = visited(|plot| wu(a, b, Bounds::EVERYTHING, plot));
            pixels.sort_unstable();
            pixels
        };
        let pixels = run(a, b);
        prop_assert!(largest_smooth(a, b, &pixels) <= 1.0 / 255.0);
        prop_assert!([a, b].iter().all(|end| pixels.contains(&(end.x, end.y, 255))));
        prop_assert_eq!(pixels, run(b, a));
    }

    #[test]
    fn distance_is_as_thick_in_every_direction_and_the_same_from_either_end(
        a in point(-300..=300), b in point(-300..=300), shift in point(-8..=8),
    ) {
        let run = |a, b, window| {
            let mut pixels = visited(|plot| distance(a, b, window, plot));
            pixels.sort_unstable();
            pixels
        };
        let pixels = run(a, b, Bounds::EVERYTHING);
        prop_assert!(pixels.iter().all(|pixel| pixel.2 > 0));
        let found = thickness(a, b, &pixels);
        prop_assert!(found.largest < 0.1, "{found:?}");
        prop_assert!([a, b].iter().all(|end| pixels.contains(&(end.x, end.y, 255))));
        prop_assert_eq!(&pixels, &run(b, a, Bounds::EVERYTHING));
        // What is seen in a window is what is seen there of the whole.
        let window = window_on(a, b, 0.4, shift);
        let inside = |pixels: Vec<(i32, i32, u8)>| -> Vec<_> {
            pixels.into_iter().filter(|&(x, y, _)| window.contains(x, y)).collect()
        };
        prop_assert_eq!(inside(pixels), inside(run(a, b, window)));
    }

    #[test]
    fn any_segment_is_right_in_any_window(
        a in any_point(), b in any_point(), share in 0.0..=1.0, shift in point(-8..=8),
    ) {
        check_window(a, b, window_on(a, b, share, shift));
    }

    #[test]
    fn no_method_panics_anywhere(a in any_point(), shift in point(-40..=40)) {
        let b = IVec2::new(a.x.saturating_add(shift.x), a.y.saturating_add(shift.y));
        for method in METHODS {
            let mut count = 0;
            (method.run.visit)(a, b, Bounds::EVERYTHING, &mut |_, _, _| count += 1);
            // Three pixels in each of up to 41 steps.
            let most = if method.name == "distance" { 123 } else { 101 };
            prop_assert!(count <= most);
        }
    }
}

/// Where the first step that is seen is half-way between two pixels, the lower one is taken, as if all had been walked.
#[test]
fn a_window_may_begin_at_a_tie() {
    for (a, b) in [((0, 0), (2, 1)), ((0, 0), (6, 3)), ((0, 1), (2, 0)), ((0, 0), (10, 5)), ((0, 0), (1, 2))]
    {
        let (a, b) = (IVec2::from(a), IVec2::from(b));
        for n in 0..6 {
            check_window(a, b, Bounds { min: IVec2::new(n, -1), max: IVec2::new(n + 11, 10) });
            check_window(a, b, Bounds { min: IVec2::new(-1, n), max: IVec2::new(10, n + 11) });
        }
    }
}

/// The longest segments there are, at both ends and in between.
#[test]
fn the_longest_segments_are_right() {
    let (low, high) = (i32::MIN, i32::MAX);
    for (a, b) in [
        (IVec2::new(low, low), IVec2::new(high, high)),
        (IVec2::new(low, high), IVec2::new(high, low)),
        (IVec2::new(high, high - 1), IVec2::new(low, low)),
        (IVec2::new(low, 3), IVec2::new(high, -4)),
        (IVec2::new(-9, high), IVec2::new(8, low)),
    ] {
        for share in [0.0, 1e-9, 0.25, 0.5, 0.999, 1.0] {
            check_window(a, b, window_on(a, b, share, IVec2::ZERO));
        }
    }
}
