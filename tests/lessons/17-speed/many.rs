//! From one triangle to a million.

use clipping::{Counts, Cull};
use common::Color;
use speed::{METHODS, Plan};

use crate::canvas::{Canvas, Way, differing, drawn};
use crate::soup::{Corner, Soup};

const SIZE: [u16; 2] = [320, 200];

/// A sheet of that many fields across and up, as large as the picture, in waves that hide parts of each other.
fn sheet(across: usize, up: usize) -> Soup {
    let [width, height] = SIZE.map(|side| 256.0 * f32::from(side));
    let corner = |n: usize| {
        let (s, t) = ((n % (across + 1)) as f32 / across as f32, (n / (across + 1)) as f32 / up as f32);
        let wave = (9.0 * s).sin() * (7.0 * t).cos();
        let [x, y] = [(s + 0.1 * wave) * width, (t - 0.2 * wave) * height].map(|place| place as i32);
        Corner { x, y, z: 0.5 + 0.4 * wave, w: 1.5 + wave }
    };
    let corners: Vec<Corner> = (0..(across + 1) * (up + 1)).map(corner).collect();
    Soup::grid(&corners, across + 1, SIZE)
}

fn check(across: usize, up: usize, ways: &[Way]) {
    let soup = sheet(across, up);
    let mesh = soup.mesh();
    let draw = |canvas: &mut Canvas| -> Counts { canvas.draw(&soup.shader(), &mesh, Cull::None) };
    let (expected, counts) = drawn(Way::Simple, SIZE, Color::BLACK, draw);
    assert!(counts.filled > across * up, "{counts:?}");
    for &way in ways {
        let (got, got_counts) = drawn(way, SIZE, Color::BLACK, draw);
        assert_eq!(differing(&expected, &got), None, "{} triangles by {way:?}", 2 * across * up);
        assert_eq!(got_counts, counts);
    }
}

#[test]
fn meshes_of_two_triangles_to_two_hundred_thousand() {
    let plans = METHODS.iter().filter_map(|method| method.run.plan);
    let plans = plans.map(|plan| if plan.threads == 1 { plan } else { Plan { threads: 2, ..plan } });
    let ways: Vec<Way> = [Way::Blocks].into_iter().chain(plans.map(Way::tiled)).collect();
    for side in [1, 3, 10, 32, 100, 316] {
        check(side, side, &ways);
    }
}

#[test]
fn a_million_triangles() {
    let plan = Plan { tile: Some(64), hierarchical: true, deferred: true, threads: 2 };
    check(1000, 500, &[Way::tiled(plan)]);
}
