use scene::{LESSON, METHODS, VERSIONS};
use verify::{assert_drawn, assert_each_drawn};

const SIZE: [&str; 2] = ["--size", "160x120"];

/// Each version a while after its beginning, small.
#[test]
fn every_version() {
    for version in VERSIONS {
        let number = version.number.to_string();
        let name = format!("version-{number}");
        assert_drawn(&LESSON, &name, &[&SIZE[..], &["--version", &number, "--time", "1.5"]].concat());
    }
}

/// Spheres of each number of triangles, in version 5, where one is largest.
#[test]
fn every_method_draws_a_sphere() {
    assert_each_drawn(&LESSON, METHODS, &[&SIZE[..], &["--version", "5"]].concat());
}

/// After keys: as lines, from elsewhere, without smooth edges, and as smooth lines.
#[test]
fn what_keys_do() {
    for (name, version, keys) in [
        ("lines", "7", "F1"),
        ("around", "9", "Left*6 Up*3 W*8"),
        ("stairs", "10", "F2"),
        ("smooth-lines", "10", "F1 Right*10 Down*2 S*3"),
        ("stairs-of-lines", "11", "F1 F2"),
    ] {
        let arguments = ["--version", version, "--time", "1.5", "--keys", keys];
        assert_drawn(&LESSON, name, &[&SIZE[..], &arguments].concat());
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x150"]);
}
