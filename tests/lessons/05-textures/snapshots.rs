use common::{Attributes, Color, Format, Image, Model, Vec3};
use textures::{LESSON, METHODS};
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_each_text};

/// A square whose texture coordinates go from -¼ to 1¼: what each method does inside, at the border, beyond.
#[test]
fn every_method_draws_a_square() {
    let text =
        b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt -.25 -.25\nvt 1.25 -.25\nvt 1.25 1.25\nvt -.25 1.25\n\
                 f 1/1 2/2 3/3 4/4\n";
    let square = Model::parse(text, Attributes { uvs: true, normals: false }).unwrap();
    // Four by four texels: the lower left one white, each row and column darker than the one before.
    let mut texture = Image::new(4, 4, Format::Gray);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::gray(1.0 - (x + y) as f32 / 8.0));
    }
    assert_each_text(&LESSON, "square", METHODS, |method| {
        let mut image = Image::new(48, 24, Format::Gray);
        (method.run.draw)(&square, &texture, Vec3::Z, &mut image);
        image
    });
}

#[test]
fn every_method_draws_the_sphere() {
    assert_each_drawn(&LESSON, METHODS, &["--size", "200x200", "--model", SPHERE, "--texture", CRATE]);
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
