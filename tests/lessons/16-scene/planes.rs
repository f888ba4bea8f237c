//! Near and far of the orthographic projection: the assignment's cut its own objects in half.

use checks::assignment::{PROJECTION, pixel, projected};
use common::{Color, DVec2, DVec3, Image, Mat4, Vec4};
use scene::{Counts, Scene, Target, render_scene};

use crate::truth::{Eye, Truth};
use crate::versions::{SIZE, drawn, scene_at};

/// So much of x and y from near to far, as the assignment's matrices have it, but of the course's space.
fn between(share: f32, near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        Vec4::new(share, 0.0, 0.0, 0.0),
        Vec4::new(0.0, share, 0.0, 0.0),
        Vec4::new(0.0, 0.0, -2.0 / (far - near), 0.0),
        Vec4::new(0.0, 0.0, -(far + near) / (far - near), 1.0),
    )
}

fn through(scene: &Scene, projection: &Mat4) -> (Image, Counts) {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    let counts = render_scene(scene, &mut target, projection, &Mat4::IDENTITY);
    (target.into_picture(), counts)
}

fn different(a: &Image, b: &Image) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| a.2 != b.2).count()
}

/// By the matrix as it is written the cube of version 0, whose middle the formula has at a quarter of the width, would stand
/// on the left border: it says two fifths where the formula says one.
#[test]
fn two_fifths_are_not_a_fifth() {
    let (size, at) = (DVec2::new(1024.0, 768.0), DVec3::new(-2.5, 0.0, 2.0));
    assert_eq!(pixel(at, size).x, 256.0);
    let x = |rows: &[[f64; 4]; 4]| (projected(rows, at).x + 1.0) / 2.0 * size.x;
    assert_eq!(x(&PROJECTION), 0.0);
    let mut halved = PROJECTION;
    (halved[0][0], halved[1][1]) = (0.2, 0.2);
    assert_eq!(x(&halved), 256.0);
    // And half of its pixels are there.
    let count =
        |picture: &Image| picture.pixels().filter(|pixel| pixel.0 < 80 && pixel.2 == Color::WHITE).count();
    let scene = scene_at(0, 0.0);
    let [as_stated, as_written] =
        [0.2, 0.4].map(|share| count(&through(&scene, &between(share, 0.0, 4.0)).0));
    let [expected, half] = [16.0 * 12.0, 32.0 * 24.0 / 2.0];
    assert_eq!([as_stated as f64, as_written as f64], [expected, half]);
}

/// Its depths are those of near = 0 and far = 2, and all objects stand at 2.
#[test]
fn the_far_plane_goes_through_the_objects() {
    let depth = |z: f64| projected(&PROJECTION, DVec3::new(0.0, 0.0, z)).z;
    assert_eq!([0.0, 2.0, 1.5, 2.5, 1.0, 3.0].map(depth), [-1.0, 1.0, 0.5, 1.5, 0.0, 2.0]);
    let scene = scene_at(4, 0.0);
    let (_, whole) = through(&scene, &between(0.2, 0.0, 4.0));
    let (_, halved) = through(&scene, &between(0.2, 0.0, 2.0));
    assert_eq!((whole.triangles.outside, whole.triangles.cut), (0, 0));
    // Of the cube the back face is beyond and the sides are cut; of the sphere half of the triangles are, some with a corner
    // on the plane itself, which is not beyond.
    assert_eq!(halved.triangles.outside + halved.triangles.cut, 2 + 8 + 224 / 2);
    assert!(halved.triangles.outside >= 2 + 224 / 4);
}

/// At rest the front halves hide that the others are missing, so the picture is the same, as the assignment says. Once things
/// turn, what reaches beyond the plane beside the front is missing.
#[test]
fn what_is_cut_off_is_seen_once_things_turn() {
    let pair = |seconds: f64| {
        let scene = scene_at(4, seconds);
        [4.0, 2.0].map(|far| through(&scene, &between(0.2, 0.0, far)).0)
    };
    let [whole, halved] = pair(0.0);
    assert_eq!(different(&whole, &halved), 0);
    let [whole, halved] = pair(1.7);
    let missing = different(&whole, &halved);
    assert!((5..200).contains(&missing), "{missing}");
}

/// Whether a point is beyond a plane is asked at each pixel. At each corner, as it is put, whole triangles would go: of the
/// cube at rest all but the two in front.
#[test]
fn cuts_are_exact() {
    let scene = scene_at(4, 1.7);
    let mut truth = Truth::new(&scene, Eye::Orthographic);
    truth.depths = [0.0, 2.0];
    truth.check(&through(&scene, &between(0.2, 0.0, 2.0)).0, 1.02, 0.1);
    truth.depths = [1.6, 2.1];
    truth.check(&through(&scene, &between(0.2, 1.6, 2.1)).0, 1.02, 0.1);

    let still = scene_at(4, 0.0);
    let mesh = still.entities[0].levels.finest();
    let depth = |face: usize, corner: usize| 2.0 - mesh.positions()[mesh.vertex(face, corner)].z;
    let kept = (0..12).filter(|&face| (0..3).all(|corner| depth(face, corner) <= 2.0)).count();
    assert_eq!(kept, 2);
}

/// The formula knows no depth: it would show what is behind the camera as well as what is before it. The course's planes are
/// where they cut nothing of the scenes.
#[test]
fn the_formula_has_no_planes_and_the_course_has() {
    for number in 0..5 {
        let scene = scene_at(number, 1.7);
        let [four, thousand] = [4.0, 1000.0].map(|far| through(&scene, &between(0.2, 0.0, far)).0);
        assert!(different(&four, &drawn(&scene, number).0) == 0, "version {number}");
        // Where the surfaces of cube and sphere meet, depths 250 times as dense may be rounded the other way.
        assert!(different(&four, &thousand) <= 2, "version {number}: {}", different(&four, &thousand));
    }
    let mut scene = scene_at(0, 0.0);
    scene.entities.iter_mut().for_each(|entity| entity.position.z = 2.0);
    let (picture, counts) = drawn(&scene, 0);
    assert!(picture.pixels().all(|pixel| pixel.2 == Color::BLACK));
    assert_eq!(counts.outside, 2);
    assert_eq!(pixel(DVec3::new(-2.5, 0.0, -2.0), DVec2::new(1024.0, 768.0)), DVec2::new(256.0, 384.0));
}
