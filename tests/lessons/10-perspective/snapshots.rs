use common::Image;
use perspective::{DEPTHS, LESSON, METHODS};
use tempfile::tempdir;
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_similar, run};

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}

/// The floor tilted, so that depth changes along a row: affine warps, every-16 and every-8 ripple.
#[test]
fn every_method_draws_the_floor() {
    let tilted = ["--size", "200x200", "--eye", "0.2,0.3,3", "--center", "0.2,-0.2,0", "--up", "1,0.3,0"];
    assert_each_drawn(&LESSON, METHODS, &tilted);
}

/// The depths in grey, as each way keeps them.
#[test]
fn every_way_keeps_its_depths() {
    for row in DEPTHS {
        let folder = tempdir().unwrap();
        let flags = [
            "--size",
            "200x200",
            "--near",
            "1",
            "--projection",
            row.name,
            "--depth",
            "d.png",
            "--out",
            "a.png",
        ];
        assert!(run(LESSON.name, folder.path(), &flags).status.success());
        let depths = Image::read(&folder.path().join("d.png")).unwrap();
        assert_similar(&LESSON, &format!("depths-{}", row.name), &depths);
    }
}

#[test]
fn a_model_alone() {
    let scene = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE, "--fov", "60"];
    assert_drawn(&LESSON, "sphere", &scene);
}

/// So low and near that the floor passes behind the eye: the cells that do are missing, until lesson 11.
#[test]
fn what_passes_behind_the_eye_is_missing() {
    assert_drawn(
        &LESSON,
        "left-out",
        &["--size", "200x200", "--eye", "0.9,-0.7,1.9", "--center", "0,-0.5,0", "--fov", "70"],
    );
}
