use common::{Attributes, Color, Format, Image, Model, Vec3};
use gouraud::{LESSON, METHODS, Scene, corner_normals};
use verify::{CRATE, SPHERE, assert_picture, assert_text, draw};

/// An octahedron, lit from the left: `none` has no shape, `flat` has edges, `gouraud` goes round them.
#[test]
fn every_method_shades_an_octahedron() {
    let text = b"v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nvt 0 0\n\
                 f 5/1 1/1 3/1\nf 5/1 3/1 2/1\nf 5/1 2/1 4/1\nf 5/1 4/1 1/1\n";
    let model = Model::parse(text, Attributes { uvs: true, normals: true }).unwrap();
    let mut white = Image::new(1, 1, Format::Gray);
    white.set(0, 0, Color::WHITE);
    let light = Vec3::new(-2.0, 1.0, 2.0).normalize();
    for method in METHODS {
        let mut image = Image::new(36, 20, Format::Gray);
        let normals = corner_normals(&model);
        (method.run)(&Scene { model: &model, normals, texture: &white, light }, &mut image);
        assert_text(&LESSON, &format!("octahedron-{}", method.name), &image);
    }
}

#[test]
fn every_method_draws_the_sphere() {
    for method in METHODS {
        let arguments = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE, "--light", "-1,1,2"];
        let picture = draw("gouraud", &[&arguments[..], &["--method", method.name]].concat());
        assert_picture(&LESSON, method.name, &picture, 0);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    let picture = draw("gouraud", &["--size", "200x200"]);
    assert_picture(&LESSON, "default", &picture, 0);
}
