//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use std::f32::consts::TAU;

use common::{Color, Format, Image, Vec2, Vec4};
use filtering::footprint::Gradients;
use filtering::layout::Rows;
use filtering::light::{ENCODED, SRGB};
use filtering::{Footprint, Level, MIPMAPS, Wrap, bilinear, level};

use super::sketches::of_box;

#[test]
fn a_wave_and_its_alias_have_the_same_samples() {
    for (fast, slow) in [(0.9, 0.1), (0.75, 0.25), (1.1, 0.1)] {
        for n in 0..20 {
            let [a, b] = [fast, slow].map(|f: f32| (TAU * f * n as f32).cos());
            assert!((a - b).abs() < 1e-4, "{fast}, {n}");
        }
    }
}

/// A pattern of 0.9 periods a pixel moved by s is its alias moved by nine times as much the other way.
#[test]
fn the_alias_runs_backwards() {
    let s = 0.03;
    for n in 0..20 {
        let moved = (TAU * 0.9 * (n as f32 - s)).cos();
        let alias = (TAU * 0.1 * (n as f32 + 9.0 * s)).cos();
        assert!((moved - alias).abs() < 1e-4, "{n}");
    }
}

#[test]
fn what_the_box_and_the_tent_leave() {
    let box_leaves = [0.0, 0.5, 1.0, 1.5].map(of_box);
    for (got, expected) in box_leaves.into_iter().zip([1.0, 0.64, 0.0, -0.21]) {
        assert!((got - expected).abs() < 0.005, "{got}, not {expected}");
    }
    assert!((of_box(1.5).powi(2) - 0.05).abs() < 0.005);
}

/// A row of numbers, taken as they are.
fn row(numbers: &[u8]) -> Image {
    let mut image = Image::new(numbers.len() as u16, 1, Format::Rgb);
    (0..).zip(numbers).for_each(|(x, &n)| image.set(x, 0, Color::rgb(n, n, n)));
    image
}

#[test]
fn two_and_a_half_degrees() {
    let night = Level::<Rows>::new(&row(&[8, 4, 2, 6]), &ENCODED);
    let at = |hours: f32| bilinear(&night, Vec2::new(hours / 4.0, 0.5), Wrap::Clamp).x;
    assert_eq!(at(2.25), 2.5);
    // Without the half, and half an hour later.
    assert_eq!(at(2.75), 3.0);
}

#[test]
fn a_third_more_memory_and_nearly_twice_as_much() {
    let share = |width: u16, height: u16| {
        let levels = MIPMAPS[0].run.levels(&Image::new(width, height, Format::Gray), Wrap::Clamp);
        let texels: i32 = levels.iter().map(|level| level.width() * level.height()).sum();
        f64::from(texels) / (f64::from(width) * f64::from(height))
    };
    assert!(share(256, 256) < 4.0 / 3.0 && share(256, 256) > 1.33);
    assert!(share(1, 256) < 2.0 && share(1, 256) > 1.99);
}

/// Each texel of a row of five alone: what of it is in the two.
#[test]
fn two_and_a_half_of_five() {
    for (i, expected) in [[20, 0], [20, 0], [10, 10], [0, 20], [0, 20]].into_iter().enumerate() {
        let mut numbers = [0; 5];
        numbers[i] = 50;
        let two = &MIPMAPS[0].run.levels(&row(&numbers), Wrap::Clamp)[1];
        assert_eq!([0, 1].map(|x| two.get(x, 0).unwrap().r), expected, "{i}");
    }
    let sizes = MIPMAPS[0].run.levels(&Image::new(1, 6, Format::Gray), Wrap::Clamp);
    assert_eq!(sizes.iter().map(Image::height).collect::<Vec<_>>(), [6, 3, 1]);
}

#[test]
fn codes_and_light() {
    let light = |code: u8| SRGB.light(Color::rgb(code, code, code)).x / 255.0;
    let code = |light: f32| SRGB.color(Vec4::splat(255.0 * light)).r;
    assert!((light(128) - 0.22).abs() < 0.005 && (light(64) - 0.05).abs() < 0.005);
    assert_eq!([0.5, 0.25, 1.0 / 256.0].map(code), [188, 137, 13]);
}

/// The floor of the example by hand: at the depth 2, from a height of 1. A pixel is 1 wide and 1 high.
#[test]
fn a_floor_by_hand() {
    let (height, size) = (1.0, Vec2::splat(2.0));
    let corners = [Vec2::new(-3.0, 1.0), Vec2::new(4.0, 1.5), Vec2::new(0.0, 9.0)];
    let clip = corners.map(|uv| Vec4::new(uv.x, -height, 0.0, uv.y));
    // The pixel (0, 0) has its centre half a unit left of the middle and half a unit below the horizon.
    let (x, q) = (-0.5, 0.5);
    let depth = height / q;
    let Footprint { x: right, y: up } =
        Gradients::new(clip, corners, size).footprint(0, 0, Vec2::new(x * depth, depth));
    assert!(right.distance(Vec2::new(depth, 0.0)) < 1e-5, "{right}");
    // Up is against q.
    assert!((up.y - depth * depth / height).abs() < 1e-5, "{up}");
}

#[test]
fn levels_of_footprints() {
    let of = |x: [f32; 2], y: [f32; 2]| level(Footprint { x: x.into(), y: y.into() }, Vec2::ONE);
    let near = |got: f32, expected: f32| (got - expected).abs() < 0.005;
    assert!(near(of([6.0, 8.0], [-1.0, 3.0]), 3.32));
    assert!(near(of([4.0, 0.0], [0.0, 0.0]), 2.0) && near(of([4.0, 4.0], [0.0, 0.0]), 2.5));
    // By the area, which is not what is asked for.
    let area = Vec2::new(6.0, 8.0).perp_dot(Vec2::new(-1.0, 3.0));
    assert!(area == 26.0 && near(0.5 * area.log2(), 2.35) && near(1.05_f32.log2(), 0.07));
}

#[test]
fn rows_and_tiles_are_equal_at_fourteen_degrees() {
    let angle = 0.25_f32.atan();
    let (sin, cos) = angle.sin_cos();
    assert!((angle.to_degrees() - 14.0).abs() < 0.05);
    assert!((cos / 16.0 + sin - (cos + sin) / 4.0).abs() < 1e-6);
}
