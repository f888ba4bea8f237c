use common::{Color, Format, Image, Vec2};
use triangles::{LESSON, METHODS};
use verify::{assert_drawn, assert_each_drawn, assert_each_text};

#[test]
fn every_method_draws_two_neighbours() {
    assert_each_text(&LESSON, "neighbours", METHODS, |method| {
        let mut image = Image::new(24, 16, Format::Gray);
        let [a, b, c, d] = [(1.5, 2.0), (20.0, 1.0), (16.5, 14.5), (3.25, 12.0)].map(Vec2::from);
        (method.run.draw)([a, b, c], &mut image, Color::WHITE);
        // The second one, darker, shows which pixels of the common side it takes from the first.
        (method.run.draw)([a, c, d], &mut image, Color::gray(0.5));
        image
    });
}

#[test]
fn every_method_draws_the_slides_picture() {
    assert_each_drawn(&LESSON, METHODS, &[]);
}

#[test]
fn every_method_draws_the_head_both_ways() {
    for method in METHODS {
        for fill in ["random", "flat"] {
            let arguments = [
                "--size",
                "200x200",
                "--light",
                "-1,1,2",
                "--fill",
                fill,
                "--method",
                method.name,
                "--model",
            ];
            assert_drawn(&LESSON, &format!("head-{fill}-{}", method.name), &arguments);
        }
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
