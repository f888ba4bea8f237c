use common::{Color, Image};
use perspective::{DEPTHS, LESSON, METHODS};
use tempfile::tempdir;
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_similar, draw, run};

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

/// A picture that is wider, or higher, than a square shows more beside the model: the field of view is the vertical one.
#[test]
fn no_size_squashes_the_model() {
    let sphere = |size: &str, fov: &str| {
        draw("perspective", &["--model", SPHERE, "--texture", CRATE, "--size", size, "--fov", fov])
    };
    let square = sphere("300x300", "45");
    // As high as 480 px, of which 300 are 45 degrees.
    let fov = format!("{}", 2.0 * (22.5_f64.to_radians().tan() * 1.6).atan().to_degrees());
    for (size, fov, left, bottom) in [("600x300", "45", 150, 0), ("300x480", fov.as_str(), 0, 90)] {
        let picture = sphere(size, fov);
        let inside = |x: i32, y: i32| square.get(x - left, y - bottom);
        let moved =
            picture.pixels().filter(|&(x, y, color)| inside(x, y).unwrap_or(Color::BLACK) != color).count();
        // Other sums are rounded otherwise: a corner may move by 1/256 px.
        assert!(moved < 90, "{size}: {moved} pixels differ");
    }
}
