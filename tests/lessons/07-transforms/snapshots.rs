use common::{Bounds, Color, Format, Image, Mat4, Vec2, Vec3};
use transforms::inverse::INVERSES;
use transforms::rotation::ROTATIONS;
use transforms::{LESSON, METHODS, place, scale, translate};
use triangles::fill;
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn, assert_each_text, letter};

const SCENE: [&str; 6] = ["--size", "200x200", "--model", SPHERE, "--texture", CRATE];

/// The letter under a matrix, in the middle of a picture of 25×25.
fn picture(m: &Mat4) -> Image {
    let mut image = Image::new(25, 25, Format::Gray);
    let bounds: Bounds = image.bounds();
    for corners in letter() {
        let placed = corners.map(|corner| place(m, corner).unwrap().truncate() + Vec2::splat(12.5));
        fill(placed, bounds, |x, y, _| image.set(x, y, Color::WHITE));
    }
    image
}

/// A third of a quarter turn, by each way to turn.
#[test]
fn every_rotation_turns_a_letter() {
    assert_each_text(&LESSON, "turned", ROTATIONS, |method| {
        picture(&Mat4::from_mat3((method.run)(Vec3::Z, 30f32.to_radians())))
    });
}

/// A letter moved and stretched, and brought back by each inverse: `transpose` is none for a stretch.
#[test]
fn every_inverse_brings_a_letter_back() {
    let m = translate(Vec3::new(3.0, 1.0, 0.0)) * scale(Vec3::new(1.5, 0.75, 1.0));
    assert_each_text(&LESSON, "back", INVERSES, |method| picture(&((method.run)(&m).unwrap() * m)));
}

#[test]
fn every_method_draws_the_sphere() {
    assert_each_drawn(&LESSON, METHODS, &SCENE);
}

/// From just before the sphere, from twice as far, and from infinitely far, where nothing is foreshortened.
#[test]
fn the_sphere_from_three_distances() {
    for distance in ["1.2", "4", "inf"] {
        let name = format!("distance-{distance}");
        assert_drawn(&LESSON, &name, &[&SCENE[..], &["--distance", distance]].concat());
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
