use common::{Color, Format, Image};
use shaders::{LESSON, METHODS, SHADERS};
use verify::{CRATE, SPHERE, assert_drawn, assert_similar, draw};

const SCENE: [&str; 6] = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE];

/// Both methods are held against one picture of each shader.
#[test]
fn every_shader_draws_the_sphere() {
    for shader in SHADERS {
        for method in METHODS {
            let look = ["--shader", shader.name, "--method", method.name];
            let picture = draw("shaders", &[&SCENE[..], &look].concat());
            assert_similar(&LESSON, shader.name, &picture);
        }
    }
}

#[test]
fn the_sheet_has_the_first_four() {
    for method in METHODS {
        let picture = draw("shaders", &[&SCENE[..], &["--method", method.name]].concat());
        assert_similar(&LESSON, "sheet", &picture);
    }
}

#[test]
fn two_levels_are_black_and_grey() {
    let look = ["--shader", "quantized", "--levels", "2"];
    assert_similar(&LESSON, "quantized-2", &draw("shaders", &[&SCENE[..], &look].concat()));
}

/// A checkered floor: both triangles warp it, each in its own way, as (u, v) is interpolated in the picture.
#[test]
fn a_checkered_floor_warps() {
    let folder = tempfile::tempdir().unwrap();
    let mut checks = Image::new(8, 8, Format::Rgb);
    for (x, y, _) in checks.clone().pixels() {
        checks.set(x, y, if (x + y) % 2 == 0 { Color::WHITE } else { Color::rgb(0x33, 0x66, 0x99) });
    }
    let [model, texture] = ["floor.obj", "checks.png"].map(|name| folder.path().join(name));
    checks.write(&texture).unwrap();
    let text =
        "v -1 -.5 1\nv 1 -.5 1\nv 1 -.5 -1\nv -1 -.5 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(&model, text).unwrap();
    let [model, texture] = [&model, &texture].map(|path| path.to_str().unwrap());
    let scene = ["--shader", "flat-texture", "--model", model, "--texture", texture, "--light", "0,1,0"];
    let picture = draw("shaders", &[&scene[..], &["--eye", "0,0.4,2", "--size", "300x300"]].concat());
    assert_similar(&LESSON, "floor", &picture);
}

/// A picture that is wider, or higher, than a square shows more beside the model, which keeps its shape and size.
#[test]
fn no_size_squashes_the_model() {
    let sphere = |size: &str| {
        draw("shaders", &[&SCENE[2..], &["--shader", "gouraud-texture", "--size", size]].concat())
    };
    let square = sphere("300x300");
    for (size, left, bottom) in [("600x300", 150, 0), ("300x480", 0, 90)] {
        let picture = sphere(size);
        let inside = |x: i32, y: i32| square.get(x - left, y - bottom);
        let moved =
            picture.pixels().filter(|&(x, y, color)| inside(x, y).unwrap_or(Color::BLACK) != color).count();
        // Sums with a larger half are rounded otherwise: a corner may move by 1/256 px.
        assert!(moved < 90, "{size}: {moved} pixels differ");
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
