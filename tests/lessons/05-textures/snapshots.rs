use common::{Attributes, Color, Format, Image, Model, Vec3};
use textures::{LESSON, METHODS};
use verify::{CRATE, SPHERE, assert_picture, assert_text, draw};

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
    for method in METHODS {
        let mut image = Image::new(48, 24, Format::Gray);
        (method.run.draw)(&square, &texture, Vec3::Z, &mut image);
        assert_text(&LESSON, &format!("square-{}", method.name), &image);
    }
}

#[test]
fn every_method_draws_the_sphere() {
    for method in METHODS {
        let arguments = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE, "--method", method.name];
        assert_picture(&LESSON, method.name, &draw("textures", &arguments), 0);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    let picture = draw("textures", &["--size", "200x200"]);
    assert_picture(&LESSON, "default", &picture, 0);
}
