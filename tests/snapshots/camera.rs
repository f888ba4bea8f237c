use camera::METHODS;
use common::Image;
use verify::{CRATE, SPHERE, assert_similar, draw, run};

const SCENE: [&str; 6] = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE];

/// A centre off the origin: `lookat` brings it to the middle, `listing` does not.
#[test]
fn every_method_looks_at_a_point() {
    for method in METHODS {
        let view = ["--eye", "2.7,1.7,3", "--center", "0.7,0.2,-1", "--method", method.name];
        let picture = draw("camera", &[&SCENE[..], &view].concat());
        assert_similar(&format!("08-camera-{}", method.name), &picture);
    }
}

#[test]
fn the_turntable_goes_around() {
    let folder = tempfile::tempdir().unwrap();
    let around = ["--light", "1,2,0", "--eye", "1,1,3", "--turntable", "4", "--out", "stop.png"];
    let output = run("camera", folder.path(), &[&SCENE[..], &around].concat());
    assert!(output.status.success());
    for n in 0..4 {
        let picture = Image::read(&folder.path().join(format!("stop-00{n}.png"))).unwrap();
        assert_similar(&format!("08-camera-turntable-{n}"), &picture);
    }
}
