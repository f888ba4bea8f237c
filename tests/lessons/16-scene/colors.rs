//! Version 1's triangle, whose colours are to be interpolated bilinearly, which takes four corners.

use common::DVec2;

use crate::truth::{Eye, Truth, distance};
use crate::versions::{picture_at, scene_at};

const RED: [f64; 3] = [255.0, 0.0, 0.0];
const GREEN: [f64; 3] = [0.0, 255.0, 0.0];
const BLUE: [f64; 3] = [0.0, 0.0, 255.0];

fn between(a: [f64; 3], b: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|n| a[n] + share * (b[n] - a[n]))
}

/// The colour at a height from 0 to 1 and so far from the left side, by the shares that the corners have of the area.
fn by_areas(at: DVec2) -> [f64; 3] {
    let [a, b, c] = [[-0.5, -0.5], [0.5, -0.5], [0.0, 0.5]].map(DVec2::from);
    let area = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let shares = [area(at, b, c), area(a, at, c), area(a, b, at)].map(|part| part / area(a, b, c));
    std::array::from_fn(|n| shares[0] * RED[n] + shares[1] * GREEN[n] + shares[2] * BLUE[n])
}

/// Along both slanting sides, then along the row between them.
fn by_rows(at: DVec2) -> [f64; 3] {
    let height = at.y + 0.5;
    let [left, right] = [-0.5, 0.5].map(|x| x * (1.0 - height));
    let [on_left, on_right] = [RED, GREEN].map(|corner| between(corner, BLUE, height));
    between(on_left, on_right, (at.x - left) / (right - left))
}

/// Between the four corners of the square around it, the upper two blue.
fn by_square(at: DVec2) -> [f64; 3] {
    between(between(RED, GREEN, at.x + 0.5), BLUE, at.y + 0.5)
}

/// Points inside.
fn inside() -> impl Iterator<Item = DVec2> {
    (1..64).flat_map(|row| {
        let height = f64::from(row) / 64.0;
        (0..=32).map(move |n| DVec2::new((f64::from(n) / 32.0 - 0.5) * (1.0 - height), height - 0.5))
    })
}

/// Read as sides first and rows then, it is the mean by areas, whichever way the triangle lies. Read as the square's, which
/// bilinear interpolation is about, the sides themselves are wrong: half-way up the side between red and blue an eighth is green.
#[test]
fn two_readings_of_bilinear() {
    for at in inside() {
        assert!(distance(by_areas(at), by_rows(at)) < 1e-9, "{at}");
    }
    let off = inside().map(|at| distance(by_areas(at), by_square(at))).fold(0.0, f64::max);
    assert!((off - 255.0 / 8.0).abs() < 1e-9, "{off}");
    let half_way_up = DVec2::new(-0.25, 0.0);
    assert_eq!(by_areas(half_way_up), [127.5, 0.0, 127.5]);
    assert_eq!(by_square(half_way_up), [95.625, 31.875, 127.5]);
}

/// What is drawn is the mean by areas at each pixel's centre, rounded to nearest; corners are rounded to 1/256 px, of which a
/// colour goes through 255 levels in 12 px.
#[test]
fn colours_are_means_by_areas() {
    let picture = picture_at(1, 0.0, false);
    let size = picture.size().as_dvec2();
    let mut seen = 0;
    for (x, y, color) in picture.pixels() {
        let [r, g, b] = [color.r, color.g, color.b].map(f64::from);
        if [r, g, b] == [0.0; 3] {
            continue;
        }
        let at = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5) / size * 10.0 - 5.0;
        assert!(distance([r, g, b], by_areas(at)) < 0.6, "({x}, {y}) is {color:?}, not {:?}", by_areas(at));
        seen += 1;
    }
    assert!((90..=102).contains(&seen), "{seen}");
    Truth::new(&scene_at(1, 0.0), Eye::Orthographic).check(&picture, 0.6, 0.05);
}
