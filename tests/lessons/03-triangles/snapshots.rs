use common::{Color, Format, Image, Vec2};
use triangles::{LESSON, METHODS};
use verify::{assert_picture, assert_text, draw};

#[test]
fn every_method_draws_two_neighbours() {
    for method in METHODS {
        let mut image = Image::new(24, 16, Format::Gray);
        let [a, b, c, d] = [(1.5, 2.0), (20.0, 1.0), (16.5, 14.5), (3.25, 12.0)].map(Vec2::from);
        (method.run.draw)([a, b, c], &mut image, Color::WHITE);
        // The second one, darker, shows which pixels of the common side it takes from the first.
        (method.run.draw)([a, c, d], &mut image, Color::gray(0.5));
        assert_text(&LESSON, &format!("neighbours-{}", method.name), &image);
    }
}

#[test]
fn every_method_draws_the_slides_picture() {
    for method in METHODS {
        assert_picture(&LESSON, method.name, &draw("triangles", &["--method", method.name]), 0);
    }
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
            let picture = draw("triangles", &arguments);
            assert_picture(&LESSON, &format!("head-{fill}-{}", method.name), &picture, 0);
        }
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    let picture = draw("triangles", &["--size", "200x200"]);
    assert_picture(&LESSON, "default", &picture, 0);
}
