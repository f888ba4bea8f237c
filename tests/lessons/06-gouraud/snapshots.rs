use common::{Format, Image, Model, Vec3};
use gouraud::{LESSON, METHODS};
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_each_text};

use crate::{BOTH, draw};

/// An octahedron, lit from the left: `none` has no shape, `flat` has edges, `gouraud` goes round them.
#[test]
fn every_method_shades_an_octahedron() {
    let text = b"v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nvt 0 0\n\
                 f 5/1 1/1 3/1\nf 5/1 3/1 2/1\nf 5/1 2/1 4/1\nf 5/1 4/1 1/1\n";
    let model = Model::parse(text, BOTH).unwrap();
    let light = Vec3::new(-2.0, 1.0, 2.0).normalize();
    assert_each_text(&LESSON, "octahedron", METHODS, |method| {
        let mut image = Image::new(36, 20, Format::Gray);
        draw(&model, light, method.name, &mut image);
        image
    });
}

#[test]
fn every_method_draws_the_sphere() {
    let scene = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE, "--light", "-1,1,2"];
    assert_each_drawn(&LESSON, METHODS, &scene);
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
