use common::{Attributes, Color, Format, Image, Model};
use verify::{assert_picture, assert_text, draw};
use wireframe::{LESSON, METHODS};

/// A tetrahedron that touches all four borders.
const TETRAHEDRON: &[u8] =
    b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0.1 -0.4 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn every_method_draws_a_tetrahedron() {
    let model = Model::parse(TETRAHEDRON, Attributes::default()).unwrap();
    for method in METHODS {
        let mut image = Image::new(33, 33, Format::Gray);
        (method.run.draw)(&model, &mut image, Color::WHITE);
        assert_text(&LESSON, &format!("tetrahedron-{}", method.name), &image);
    }
}

#[test]
fn every_method_draws_the_head() {
    for method in METHODS {
        let picture = draw("wireframe", &["--size", "300x300", "--method", method.name]);
        assert_picture(&LESSON, method.name, &picture, 0);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    let picture = draw("wireframe", &["--size", "200x200"]);
    assert_picture(&LESSON, "default", &picture, 0);
}
