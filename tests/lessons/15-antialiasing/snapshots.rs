use antialiasing::{LESSON, METHODS, RESOLVES};
use verify::{assert_drawn, assert_each_drawn};

const SIZE: [&str; 2] = ["--size", "200x200"];

/// A frond that its texture's alpha cuts out, before the sky.
const FERN: [&str; 13] = [
    "--size",
    "160x160",
    "--model",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/square.obj"),
    "--texture",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/fern.png"),
    "--eye",
    "0.6,0.5,2.6",
    "--light-at",
    "0,1,3",
    "--background",
    "88aadd",
    "--alpha-to-coverage",
];

#[test]
fn every_method_draws_the_head_before_its_rays() {
    assert_each_drawn(&LESSON, METHODS, &SIZE);
}

#[test]
fn samples_are_resolved_in_each_way() {
    for row in RESOLVES {
        let name = format!("resolve-{}", row.name);
        assert_drawn(&LESSON, &name, &[&SIZE[..], &["--resolve", row.name]].concat());
    }
}

#[test]
fn alpha_covers_its_share_of_the_samples() {
    for method in ["none", "msaa-4", "msaa-16"] {
        let name = format!("fern-{method}");
        assert_drawn(&LESSON, &name, &[&FERN[..], &["--method", method]].concat());
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &SIZE);
}
