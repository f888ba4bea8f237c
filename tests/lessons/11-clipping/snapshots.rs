use clipping::{LESSON, METHODS};
use verify::{CRATE, assert_drawn, assert_each_drawn};

/// Inside of a cube of twelve triangles, near one of its walls: most of them are behind the eye, too.
const INSIDE: [&str; 12] = [
    "--size",
    "160x160",
    "--model",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/cube.obj"),
    "--texture",
    CRATE,
    "--eye",
    "0.3,0.1,0.2",
    "--center",
    "-0.7,-0.1,-0.5",
    "--fov",
    "100",
];

#[test]
fn every_method_draws_the_head_on_its_floor() {
    assert_each_drawn(&LESSON, METHODS, &["--size", "200x200"]);
}

#[test]
fn a_cube_from_inside_shows_its_backs() {
    for method in METHODS {
        let name = format!("inside-{}", method.name);
        let look = ["--method", method.name, "--cull", "front", "--light", "-0.8,-0.5,-0.6"];
        assert_drawn(&LESSON, &name, &[&INSIDE[..], &look].concat());
    }
}

/// One sees what the front hid: the inside of the far half, mostly in the dark.
#[test]
fn without_its_fronts_the_head_is_hollow() {
    assert_drawn(&LESSON, "cull-front", &["--size", "200x200", "--cull", "front"]);
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
