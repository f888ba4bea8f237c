use lighting::{LESSON, METHODS};
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn};

#[test]
fn every_method_lights_the_head() {
    assert_each_drawn(&LESSON, METHODS, &["--size", "200x200"]);
}

/// The sphere, its light near its side, so that it is lit and shines in one part alone.
#[test]
fn every_method_lights_a_sphere() {
    for method in METHODS {
        let scene = [
            "--size",
            "160x160",
            "--model",
            SPHERE,
            "--texture",
            CRATE,
            "--eye",
            "0,0,3",
            "--center",
            "0,0,0",
        ];
        let light = ["--light-at", "1.5,1,1", "--diffuse", "0.8", "--specular", "0.6", "--falloff", "linear"];
        let flags = [&scene[..], &light, &["--method", method.name]].concat();
        assert_drawn(&LESSON, &format!("sphere-{}", method.name), &flags);
    }
}

/// Normals go by the inverse transpose.
#[test]
fn a_stretched_sphere_is_lit_as_an_egg() {
    let scene =
        ["--size", "160x160", "--model", SPHERE, "--texture", CRATE, "--eye", "0,0,3", "--center", "0,0,0"];
    assert_drawn(&LESSON, "stretched", &[&scene[..], &["--stretch", "1,0.4,0.7"]].concat());
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
