use camera::{LESSON, METHODS};
use common::{Color, Format, Image, Vec3};
use transforms::{place, projection, translate};
use triangles::fill;
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_each_text, assert_similar, letter, run};

const SCENE: [&str; 6] = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE];

/// A letter about a centre off the origin, from the side: `listing` does not bring it to the middle, the others do.
#[test]
fn every_method_looks_at_a_letter() {
    let center = Vec3::new(7.0, 2.0, -3.0);
    let eye = center + Vec3::new(-12.0, 3.0, 16.0);
    assert_each_text(&LESSON, "letter", METHODS, |method| {
        let view = (method.run)(eye, center, Vec3::Y).unwrap();
        let all = translate(Vec3::new(20.5, 12.5, 0.0)) * projection(eye.distance(center)) * view.matrix;
        let mut image = Image::new(41, 25, Format::Gray);
        for corners in letter() {
            let placed = corners.map(|corner| place(&all, corner + center - view.origin).unwrap().truncate());
            fill(placed, image.bounds(), |x, y, _| image.set(x, y, Color::WHITE));
        }
        image
    });
}

#[test]
fn every_method_draws_the_sphere() {
    let view = ["--eye", "1,1,3", "--center", "0.4,-0.2,0"];
    assert_each_drawn(&LESSON, METHODS, &[&SCENE[..], &view].concat());
}

#[test]
fn the_turntable_goes_around() {
    let folder = tempfile::tempdir().unwrap();
    let around = ["--light", "1,2,0", "--eye", "1,1,3", "--turntable", "4", "--out", "stop.png"];
    let output = run("camera", folder.path(), &[&SCENE[..], &around].concat());
    assert!(output.status.success());
    for n in 0..4 {
        let picture = Image::read(&folder.path().join(format!("stop-00{n}.png"))).unwrap();
        assert_similar(&LESSON, &format!("turntable-{n}"), &picture);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
