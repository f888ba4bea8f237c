use common::{Attributes, Color, Format, Image, Model};
use verify::{assert_drawn, assert_each_drawn, assert_each_text};
use wireframe::{LESSON, METHODS};

/// A tetrahedron that touches all four borders.
const TETRAHEDRON: &[u8] =
    b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0.1 -0.4 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn every_method_draws_a_tetrahedron() {
    let model = Model::parse(TETRAHEDRON, Attributes::default()).unwrap();
    assert_each_text(&LESSON, "tetrahedron", METHODS, |method| {
        let mut image = Image::new(33, 33, Format::Gray);
        (method.run.draw)(&model, &mut image, Color::WHITE);
        image
    });
}

#[test]
fn every_method_draws_the_head() {
    assert_each_drawn(&LESSON, METHODS, &["--size", "300x300"]);
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
