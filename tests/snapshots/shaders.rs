use shaders::{METHODS, SHADERS};
use verify::{CRATE, SPHERE, assert_similar, draw};

const SCENE: [&str; 6] = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE];

/// Both methods are held against one picture of each shader.
#[test]
fn every_shader_draws_the_sphere() {
    for shader in SHADERS {
        for method in METHODS {
            let look = ["--shader", shader.name, "--method", method.name];
            let picture = draw("shaders", &[&SCENE[..], &look].concat());
            assert_similar(&format!("09-shaders-{}", shader.name), &picture);
        }
    }
}

#[test]
fn the_sheet_has_the_first_four() {
    for method in METHODS {
        let picture = draw("shaders", &[&SCENE[..], &["--method", method.name]].concat());
        assert_similar("09-shaders-sheet", &picture);
    }
}

#[test]
fn two_levels_are_black_and_grey() {
    let look = ["--shader", "quantized", "--levels", "2"];
    assert_similar("09-shaders-quantized-2", &draw("shaders", &[&SCENE[..], &look].concat()));
}
