//! The numbers of the chapter's worked example and of its quizzes, computed by the lesson's own code.

use common::{Color, Format, Image, Vec2};
use textures::METHODS;

/// The texel of a row of five that a method finds; `None` for black.
fn found(method: &str, u: f32) -> Option<u8> {
    let mut row = Image::new(5, 1, Format::Rgb);
    (0..5).for_each(|x| row.set(x, 0, Color::rgb(x as u8 + 1, 0, 0)));
    let method = METHODS.iter().find(|row| row.name == method).unwrap();
    (method.run.sample)(&row, Vec2::new(u, 0.2)).r.checked_sub(1)
}

#[test]
fn the_row_of_five() {
    for (u, texel) in [(0.1, 0), (0.59, 2), (0.6, 3), (1.0, 4), (-0.3, 0)] {
        assert_eq!(found("nearest", u), Some(texel), "{u}");
    }
    assert_eq!((found("round", 0.59), found("round", 0.95)), (Some(3), None));
}

#[test]
fn a_texel_under_half_the_light() {
    assert_eq!(Color::rgb(200, 100, 40).shaded(0.5), Color::rgb(100, 50, 20));
}
