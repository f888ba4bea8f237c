use filtering::{LESSON, METHODS, MIPMAPS, WRAPS};
use verify::{CRATE, assert_drawn, assert_each_drawn};

const SIZE: [&str; 2] = ["--size", "200x200"];

/// A wooden box from so near that its texels are four pixels wide.
const NEAR: [&str; 14] = [
    "--size",
    "160x160",
    "--model",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/cube.obj"),
    "--texture",
    CRATE,
    "--eye",
    "0.8,0.75,1.45",
    "--center",
    "0.5,0.43,0.5",
    "--fov",
    "7",
    "--light",
    "0.6,0.4,0.7",
];

#[test]
fn every_method_draws_the_head_on_its_floor() {
    assert_each_drawn(&LESSON, METHODS, &SIZE);
}

#[test]
fn every_method_draws_a_box_from_near() {
    for method in METHODS {
        let name = format!("near-{}", method.name);
        assert_drawn(&LESSON, &name, &[&NEAR[..], &["--method", method.name]].concat());
    }
}

#[test]
fn levels_are_made_in_each_way() {
    for row in MIPMAPS {
        let name = format!("mipmaps-{}", row.name);
        assert_drawn(&LESSON, &name, &[&SIZE[..], &["--mipmaps", row.name]].concat());
    }
}

#[test]
fn beyond_its_border_a_texture_is_what_is_asked_for() {
    for row in WRAPS {
        let name = format!("wrap-{}", row.name);
        assert_drawn(&LESSON, &name, &[&SIZE[..], &["--wrap", row.name]].concat());
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &SIZE);
}
