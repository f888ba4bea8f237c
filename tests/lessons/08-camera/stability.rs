use camera::turntable::turned;
use camera::{LESSON, METHODS, basis, lookat};
use checks::{turn, view};
use common::{DVec3, Mat3, Vec3};
use transforms::place;
use verify::stability::Must::{AtMost, Between, Nothing};
use verify::stability::{Case, every_method};

/// Eye, centre and up.
type Given = [[f32; 3]; 3];

/// Where the camera stands, and how far each method's view of a point near the centre is from the exact one. A large
/// error is so to within a half: processors that fuse multiplications round differently.
const TABLE: &[Case<Given>] = &[
    (
        "the slides' camera",
        [[1.0, 1.0, 2.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", AtMost(3e-7))],
    ),
    (
        "from the front, a centre off the origin",
        [[3.0, 4.0, 9.0], [3.0, 4.0, 5.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", AtMost(1e-6))],
    ),
    (
        "turned about y, the centre on y: R·c = c",
        [[5.0, 2.0, 1.0], [0.0, 2.0, 0.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", AtMost(1e-6))],
    ),
    (
        "turned, a centre off the origin",
        [[5.0, 2.0, 1.0], [1.0, 2.0, 1.0], [0.0, 1.0, 0.0]],
        &[("listing", Between(1.0, 3.0)), ("lookat, relative", AtMost(1e-6))],
    ),
    (
        "up is neither 1 long nor at right angles to the view",
        [[1.0, 1.0, 2.0], [0.0, 0.0, 0.0], [0.5, 7.0, -3.0]],
        &[("listing, lookat, relative", AtMost(3e-7))],
    ),
    (
        "far from the origin, at 10^3",
        [[1001.0, 1.0, 1002.0], [1000.0, 0.0, 1000.0], [0.0, 1.0, 0.0]],
        &[("listing", Between(405.0, 1_215.0)), ("lookat", AtMost(1e-3)), ("relative", AtMost(1e-6))],
    ),
    (
        "far from the origin, at 10^6",
        [[1_000_001.0, 1.0, 1_000_002.0], [1_000_000.0, 0.0, 1_000_000.0], [0.0, 1.0, 0.0]],
        &[
            ("listing", Between(405_000.0, 1_215_000.0)),
            ("lookat", Between(0.04, 0.12)),
            ("relative", AtMost(1e-6)),
        ],
    ),
    (
        "eye and centre are one point",
        [[1.0, 2.0, 3.0], [1.0, 2.0, 3.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", Nothing)],
    ),
    (
        "eye and centre 10^-30 apart",
        [[1e-30, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", AtMost(1e-6))],
    ),
    (
        "eye and centre 10^30 apart",
        [[1e30, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        &[("listing, lookat, relative", AtMost(1e-6))],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, camera| {
        let [eye, center, up] = camera.map(Vec3::from_array);
        // A step that every f32 up to 2²⁰ can take.
        let point = center + Vec3::new(0.5, -0.25, 0.125);
        let got = (method.run)(eye, center, up).and_then(|view| place(&view.matrix, point - view.origin))?;
        Some((got.as_dvec3() - view::seen(point.as_dvec3(), eye, center, up)).length())
    });
}

/// How far the camera's right is from where it should be, in radians.
fn angle_off(eye: Vec3, up: Vec3) -> f64 {
    let got = basis(eye, Vec3::ZERO, up).unwrap();
    // However wrong, it stays a basis.
    assert!(turn::skew(&got.transpose()) < 1e-6, "{up}: {got}");
    got.row(0).as_dvec3().angle_between(view::basis(eye, Vec3::ZERO, up)[0])
}

/// Up within an angle θ of the view: what is left of it is θ long, and rounding by ε turns the camera by ε/θ.
#[test]
fn up_near_the_view_costs_digits() {
    let eye = Vec3::new(1.0, 2.0, 3.0);
    let across = Vec3::new(2.0, -1.0, 0.0).normalize();
    for theta in [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        // The mean over turns of up about the view, as single errors may be small by chance.
        let off = |n: u8| {
            let side = turn::turned(across.as_dvec3(), eye.as_dvec3(), f64::from(n)).as_vec3();
            angle_off(eye, eye.normalize() + side * theta)
        };
        let mean = (0..50).map(off).sum::<f64>() / 50.0;
        let share = mean * f64::from(theta) / f64::from(f32::EPSILON);
        assert!((0.03..1.0).contains(&share), "{theta}: off by {mean:.1e}, {share} times epsilon/theta");
    }
}

/// Up along the view to within 1e-6, against it, or 0: the axis farthest from the view is up instead.
#[test]
fn up_along_the_view_is_replaced() {
    for (eye, up, instead) in [
        (Vec3::Z, Vec3::Z, Vec3::Y),
        (Vec3::Z, Vec3::NEG_Z, Vec3::Y),
        (Vec3::Y, Vec3::Y, Vec3::Z),
        (Vec3::NEG_Y, Vec3::Y, Vec3::Z),
        (Vec3::X, Vec3::X, Vec3::Y),
        (Vec3::new(0.3, 2.0, 0.1), Vec3::new(0.3, 2.0, 0.1), Vec3::Z),
        (Vec3::Z, Vec3::ZERO, Vec3::Y),
        (Vec3::Z, Vec3::new(5e-7, 0.0, 1.0), Vec3::Y),
        (Vec3::Z, Vec3::new(1e-6, 0.0, 1.0), Vec3::Y),
    ] {
        assert_eq!(basis(eye, Vec3::ZERO, up), basis(eye, Vec3::ZERO, instead), "{eye} {up}");
    }
    assert_ne!(basis(Vec3::Z, Vec3::ZERO, Vec3::new(2e-6, 0.0, 1.0)), basis(Vec3::Z, Vec3::ZERO, Vec3::Y));
}

/// Neither up nor the eye's distance is too long or too short to have a direction.
#[test]
fn only_the_directions_count() {
    for (eye, up, instead) in [
        (Vec3::Z, Vec3::new(0.0, 1e-30, 1e-30), Vec3::Y),
        (Vec3::Z, Vec3::new(1e30, 0.0, 0.0), Vec3::X),
        (Vec3::Z, Vec3::new(1e20, 1e20, 0.0), Vec3::new(1.0, 1.0, 0.0)),
        (Vec3::Z * 1e20, Vec3::Y, Vec3::Y),
        (Vec3::Z * 1e-30, Vec3::X * 1e-38, Vec3::X),
    ] {
        let [got, expected] =
            [(eye, up), (Vec3::Z, instead)].map(|(eye, up)| basis(eye, Vec3::ZERO, up).unwrap());
        assert!(got.abs_diff_eq(expected, 1e-6), "{eye} {up}: {got}");
    }
}

/// The centre is the origin of the view, and the eye stands before it.
#[test]
fn the_centre_is_the_middle_and_the_eye_before_it() {
    let (eye, center) = (Vec3::new(3.0, -2.0, 7.0), Vec3::new(1.0, 4.0, 2.0));
    let m = lookat(eye, center, Vec3::Y).unwrap();
    assert!(place(&m, center).unwrap().length() < 1e-6);
    assert!((place(&m, eye).unwrap() - Vec3::Z * eye.distance(center)).length() < 2e-6);
}

/// The turntable keeps the distance and the height, and comes back.
#[test]
fn the_turntable_turns_about_up() {
    let (eye, center, up) = (Vec3::new(3.0, 2.0, 1.0), Vec3::new(1.0, 0.0, 0.0), Vec3::Y * 3.0);
    assert_eq!(turned(eye, center, up, 0.0), eye);
    assert!((turned(eye, center, up, 1.0) - eye).length() < 1e-5);
    for n in 1..8 {
        let share = n as f32 / 8.0;
        let exact = center.as_dvec3()
            + turn::turned((eye - center).as_dvec3(), DVec3::Y, f64::from(share) * std::f64::consts::TAU);
        assert!((turned(eye, center, up, share).as_dvec3() - exact).length() < 2e-6, "{n}");
    }
    // To the right: a quarter of a turn from the front the eye is at the right.
    assert!((turned(Vec3::Z, Vec3::ZERO, Vec3::Y, 0.25) - Vec3::X).length() < 1e-6);
    // Without an up it turns about y.
    assert_eq!(turned(eye, center, Vec3::ZERO, 0.3), turned(eye, center, Vec3::Y, 0.3));
}

#[test]
fn from_the_front_the_basis_is_the_worlds() {
    assert_eq!(basis(Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y), Some(Mat3::IDENTITY));
}
