//! How many grey levels each pattern tells apart on an edge, by its angle, and how far off it is.

use antialiasing::{METHODS, pattern};
use checks::area::area;
use checks::edge::quality;
use common::{Color, Vec2};

use crate::scenes::{Scene, codes, flat, places};

/// An edge along an axis passes the samples of a standard pattern one by one, those of a grid four by four; along a diagonal
/// some of either are level with each other.
#[test]
fn a_standard_pattern_tells_all_its_levels_apart_along_an_axis() {
    let levels = |method| [0.0, 90.0, 45.0, 135.0].map(|degrees| quality(&places(method), degrees).levels);
    let table =
        METHODS.iter().filter(|method| method.name != "area").map(|method| (method.name, levels(method)));
    let expected = [
        ("none", [2, 2, 2, 2]),
        ("ssaa-4", [5, 5, 5, 5]),
        ("ssaa-16", [17, 17, 14, 13]),
        ("ordered-16", [5, 5, 8, 8]),
        ("msaa-2", [3, 3, 3, 2]),
        ("msaa-4", [5, 5, 5, 5]),
        ("msaa-8", [9, 9, 7, 7]),
        ("msaa-16", [17, 17, 14, 13]),
    ];
    assert_eq!(table.collect::<Vec<_>>(), expected);
}

/// What the reference says of an edge is what each method draws: along an edge of irrational slope, some 700 pixels long, the
/// mean error is the integral over all offsets, to within what so few pixels can show.
#[test]
fn drawn_edges_are_as_good_as_their_patterns() {
    for (slope, turned) in [(0.618_034_f64, false), (0.070_710_68, true), (0.314_159_27, false)] {
        let [width, height] = [700.0, (700.0 * slope).ceil() + 2.0];
        // Through (0, 1), and far to its right.
        let at = |x: f64| [x, 1.0 + x * slope];
        let corners = [at(-4.0), at(900.0), [900.0, -4000.0]]
            .map(|[x, y]| if turned { [y, x] } else { [x, y] }.map(|n| n as f32));
        let size = if turned { [height, width] } else { [width, height] }.map(|n| n as u16);
        let scene =
            Scene { size, background: Color::BLACK, triangles: vec![flat(corners, 0.5, Color::WHITE)] };
        let degrees = if turned { 90.0 - slope.atan().to_degrees() } else { slope.atan().to_degrees() };
        for method in METHODS {
            let image = scene.drawn(&method.run);
            let (mut sum, mut pixels) = (0.0, 0.0);
            for (x, y) in scene.pixels() {
                let white = area(corners.map(Vec2::from), x, y);
                if white > 0.0 && white < 1.0 {
                    sum += (codes(image.get(x, y).unwrap())[0] - 255.0 * white).abs();
                    pixels += 1.0;
                }
            }
            let mean = sum / pixels;
            // An area is rounded to the nearest code, no more.
            let expected = if method.name == "area" { 0.25 } else { quality(&places(method), degrees).mean };
            assert!(
                pixels > 700.0 && (mean - expected).abs() < 0.01 * expected + 0.1,
                "{}, {degrees}: {mean}, not {expected}",
                method.name
            );
        }
    }
}

/// More samples are nearer to the area: over all angles, each pattern by a fifth at least than the one before.
#[test]
fn more_samples_show_an_edge_better() {
    let mean = |samples: usize| {
        let angles = (0..360).map(|n| quality(pattern(samples), f64::from(n) / 2.0));
        angles.map(|quality| quality.mean).sum::<f64>() / 360.0
    };
    let means = [1, 2, 4, 8, 16].map(mean);
    assert!(means.windows(2).all(|pair| pair[1] < 0.8 * pair[0]), "{means:?}");
}
