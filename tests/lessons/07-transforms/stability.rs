use std::f32::consts::{FRAC_PI_2, FRAC_PI_6, PI};
use std::ops::RangeInclusive;

use checks::{matrix, turn};
use common::{DVec3, Mat3, Mat4, Vec3, Vec4Swizzles};
use transforms::affine::{about, model, rotate_x, rotate_y, rotate_z, shear_x};
use transforms::inverse::INVERSES;
use transforms::rotation::{ROTATIONS, euler_angles, from_quaternion, quaternion};
use transforms::{METHODS, normal_matrix, place, projection, scale, translate, viewport};
use verify::method;

/// What must happen.
#[derive(Debug)]
enum Must {
    /// An error of at most this.
    AtMost(f64),
    /// An error in this range: platforms round a sine differently, and so the errors that grow from it.
    Fail(RangeInclusive<f64>),
    /// No result.
    Nothing,
}
use Must::{AtMost, Fail, Nothing};

impl Must {
    fn met(&self, error: Option<f64>) -> bool {
        match (self, error) {
            (AtMost(limit), Some(error)) => error <= *limit,
            (Fail(range), Some(error)) => range.contains(&error),
            (Nothing, None) => true,
            _ => false,
        }
    }
}

type Row = (&'static str, Must);

/// A method's error in direction, and in lengths and right angles.
type Composed = (&'static str, Must, Must);

/// How many rotations by 1 radian about (1, 2, 3) are composed, and how far each method's matrix is from the
/// rotation by the whole angle: in direction, then in lengths and right angles.
const COMPOSED: &[(u32, &[Composed])] = &[
    (
        1,
        &[
            ("f32", AtMost(3e-7), AtMost(3e-7)),
            ("f32-renormalised", AtMost(3e-7), AtMost(3e-7)),
            ("f64", AtMost(1e-7), AtMost(3e-7)),
        ],
    ),
    (
        1_000,
        &[
            ("f32", Fail(1e-6..=1e-3), Fail(1e-6..=1e-3)),
            ("f32-renormalised", Fail(1e-6..=1e-3), AtMost(3e-7)),
            ("f64", AtMost(1e-7), AtMost(3e-7)),
        ],
    ),
    (
        1_000_000,
        &[
            ("f32", Fail(1e-3..=0.5), Fail(1e-3..=0.5)),
            ("f32-renormalised", Fail(1e-3..=0.5), AtMost(4e-7)),
            ("f64", AtMost(1e-7), AtMost(3e-7)),
        ],
    ),
];

#[test]
fn every_composition_does_what_it_must() {
    let axis = Vec3::new(1.0, 2.0, 3.0).normalize();
    for (count, rows) in COMPOSED {
        assert!(rows.iter().map(|row| row.0).eq(METHODS.iter().map(|method| method.name)), "{count}");
        for (name, direction, shape) in *rows {
            let got = method(METHODS, name)(axis, 1.0, *count);
            let off = turn::error(&got, axis.as_dvec3(), f64::from(*count));
            let skew = turn::skew(&got);
            assert!(direction.met(Some(off)), "{count} by {name}: {off:.1e}, but {direction:?} was expected");
            assert!(shape.met(Some(skew)), "{count} by {name}: {skew:.1e}, but {shape:?} was expected");
        }
    }
}

/// Input, axis, angle, and how far each way to turn is from the rotation in f64.
const TURNED: &[(&str, Vec3, f32, &[Row])] = &[
    (
        "not at all",
        Vec3::Y,
        0.0,
        &[("euler", AtMost(0.0)), ("rodrigues", AtMost(0.0)), ("quaternion", AtMost(0.0))],
    ),
    (
        "30° about a slanting axis",
        Vec3::new(1.0, 2.0, 3.0),
        FRAC_PI_6,
        &[("euler", AtMost(5e-7)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
    (
        "half a turn",
        Vec3::new(-1.0, 0.5, 1.0),
        PI,
        &[("euler", AtMost(5e-7)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
    (
        "a million radians",
        Vec3::Z,
        1e6,
        &[("euler", AtMost(5e-7)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
    (
        "a pitch of 90°",
        Vec3::X,
        FRAC_PI_2,
        &[("euler", AtMost(5e-7)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
    (
        "a pitch of 90° - 0.02°, where the sine is flat",
        Vec3::X,
        FRAC_PI_2 - 3.5e-4,
        &[("euler", Fail(1e-6..=1e-3)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
    (
        "by 1e-4",
        Vec3::new(1.0, 2.0, 3.0),
        1e-4,
        &[("euler", AtMost(5e-7)), ("rodrigues", AtMost(3e-7)), ("quaternion", AtMost(3e-7))],
    ),
];

#[test]
fn every_rotation_does_what_it_must() {
    for (input, axis, angle, rows) in TURNED {
        assert!(rows.iter().map(|row| row.0).eq(ROTATIONS.iter().map(|method| method.name)), "{input}");
        for (name, must) in *rows {
            let axis = axis.normalize();
            let error =
                turn::error(&method(ROTATIONS, name)(axis, *angle), axis.as_dvec3(), f64::from(*angle));
            assert!(must.met(Some(error)), "{input}, {name}: {error:.1e}, but {must:?} was expected");
        }
    }
}

/// Input, a matrix of whole numbers divided by a power of 2, and how far each inverse is from the exact one, as
/// a share of its largest entry.
const INVERTED: &[(&str, matrix::Whole, f32, &[Row])] = &[
    (
        "the identity",
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        1.0,
        &[("cofactors", AtMost(0.0)), ("elimination", AtMost(0.0)), ("transpose", AtMost(0.0))],
    ),
    (
        "a quarter turn and a move",
        [[0, -1, 0, 7], [1, 0, 0, -3], [0, 0, 1, 5], [0, 0, 0, 1]],
        1.0,
        &[("cofactors", AtMost(0.0)), ("elimination", AtMost(0.0)), ("transpose", AtMost(0.0))],
    ),
    (
        "a stretch by 3",
        [[3, 0, 0, 0], [0, 3, 0, 0], [0, 0, 3, 0], [0, 0, 0, 1]],
        1.0,
        &[("cofactors", AtMost(1e-7)), ("elimination", AtMost(1e-7)), ("transpose", Fail(2.6..=2.7))],
    ),
    (
        "a shear",
        [[1, 2, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        1.0,
        &[("cofactors", AtMost(0.0)), ("elimination", AtMost(0.0)), ("transpose", Fail(1.0..=1.0))],
    ),
    (
        "the projection from a distance of 2",
        [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, -1, 2]],
        2.0,
        &[("cofactors", AtMost(0.0)), ("elimination", AtMost(0.0)), ("transpose", Fail(0.5..=0.5))],
    ),
    (
        "a zero where elimination begins",
        [[0, 2, 1, 0], [3, 0, 0, 1], [1, 1, 0, 0], [0, 0, 4, 5]],
        1.0,
        &[("cofactors", AtMost(1e-6)), ("elimination", AtMost(1e-6)), ("transpose", Fail(1.0..=1.0))],
    ),
    (
        "Hilbert's matrix times 420, its small determinants exact in f32",
        [[420, 210, 140, 105], [210, 140, 105, 84], [140, 105, 84, 70], [105, 84, 70, 60]],
        1.0,
        &[("cofactors", AtMost(1e-7)), ("elimination", Fail(1e-6..=1e-3)), ("transpose", Fail(4e3..=5e3))],
    ),
    (
        "the same, its rows times 7, 11, 13, 17",
        [[2940, 1470, 980, 735], [2310, 1540, 1155, 924], [1820, 1365, 1092, 910], [1785, 1428, 1190, 1020]],
        1.0,
        &[
            ("cofactors", Fail(1e-4..=1e-3)),
            ("elimination", Fail(1e-6..=1e-4)),
            ("transpose", Fail(5e6..=6e6)),
        ],
    ),
    (
        "rows that differ by 1 in 16,384",
        [[16384, 16383, 0, 0], [16383, 16382, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        1.0,
        &[("cofactors", Nothing), ("elimination", Nothing), ("transpose", Fail(1.9..=2.1))],
    ),
    (
        "flattened",
        [[1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 0, 4], [0, 0, 0, 1]],
        1.0,
        &[
            ("cofactors", Nothing),
            ("elimination", Nothing),
            ("transpose", Fail(f64::INFINITY..=f64::INFINITY)),
        ],
    ),
    (
        "flattened, and not to be seen at once",
        [[1, 2, 3, 0], [4, 5, 6, 0], [7, 8, 9, 0], [0, 0, 0, 1]],
        1.0,
        &[
            ("cofactors", Nothing),
            ("elimination", Nothing),
            ("transpose", Fail(f64::INFINITY..=f64::INFINITY)),
        ],
    ),
    (
        "made smaller by 2^43: its determinant is no f32",
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1 << 43]],
        (1_u64 << 43) as f32,
        &[("cofactors", Nothing), ("elimination", AtMost(0.0)), ("transpose", Fail(1.0..=1.0))],
    ),
];

#[test]
fn every_inverse_does_what_it_must() {
    for (input, whole, divisor, rows) in INVERTED {
        assert!(rows.iter().map(|row| row.0).eq(INVERSES.iter().map(|method| method.name)), "{input}");
        let columns = whole.map(|row| row.map(|entry| entry as f32 / divisor));
        let m = Mat4::from_cols_array_2d(&columns).transpose();
        let exact = matrix::inverse(whole);
        for (name, must) in *rows {
            // The inverse of M/d is d·M⁻¹.
            let got = method(INVERSES, name)(&m).map(|inverse| inverse * (1.0 / divisor));
            let error = got.map(|got| exact.map_or(f64::INFINITY, |exact| matrix::error(&got, &exact)));
            assert!(must.met(error), "{input}, {name}: {error:?}, but {must:?} was expected");
        }
    }
}

#[test]
fn a_matrix_with_nan_has_no_inverse() {
    let m = Mat4::from_diagonal((Vec3::ONE * f32::NAN).extend(1.0));
    for method in INVERSES.iter().filter(|method| method.name != "transpose") {
        assert_eq!((method.run)(&m), None, "{}", method.name);
    }
}

/// Near the eye a point goes to infinity, at its height and behind it there is no place.
#[test]
fn what_nears_the_eye_goes_to_infinity_and_behind_it_is_nothing() {
    let m = projection(2.0);
    for (z, expected) in [
        (-2.0, Some(0.5)),
        (0.0, Some(1.0)),
        (1.0, Some(2.0)),
        (2.0 - f32::powi(2.0, -10), Some(2048.0)),
        (2.0 - f32::powi(2.0, -18), Some(524_288.0)),
        // w = 2⁻²⁰ = 9.5e-7 is below the limit.
        (2.0 - f32::powi(2.0, -19), None),
        (2.0, None),
        (3.0, None),
        (f32::INFINITY, None),
        (f32::NAN, None),
    ] {
        let x = place(&m, Vec3::new(1.0, 0.0, z)).map(|p| p.x);
        assert_eq!(x, expected, "{z}");
    }
}

/// The slides' question: from infinitely far away the projection is the identity.
#[test]
fn from_infinitely_far_nothing_is_foreshortened() {
    assert_eq!(projection(f32::INFINITY), Mat4::IDENTITY);
    assert_eq!(place(&projection(f32::INFINITY), Vec3::new(1.0, 2.0, 1e30)), Some(Vec3::new(1.0, 2.0, 1e30)));
}

#[test]
fn a_viewport_takes_the_square_to_the_picture() {
    let half = viewport(800.0, 600.0, 0.5);
    let corners =
        [(-1.0, -1.0), (0.0, 0.0), (1.0, 1.0)].map(|(x, y)| place(&half, Vec3::new(x, y, 0.25)).unwrap());
    assert_eq!(corners, [(0.0, 0.0), (400.0, 300.0), (800.0, 600.0)].map(|(x, y)| Vec3::new(x, y, 0.25)));
    let small = viewport(800.0, 600.0, 0.4);
    assert!((place(&small, Vec3::ONE).unwrap() - Vec3::new(720.0, 540.0, 1.0)).length() < 1e-3);
}

/// A point moves, a vector does not.
#[test]
fn points_move_and_vectors_do_not() {
    let m = translate(Vec3::new(1.0, 2.0, 3.0));
    assert_eq!((m * Vec3::X.extend(1.0)).xyz(), Vec3::new(2.0, 2.0, 3.0));
    assert_eq!((m * Vec3::X.extend(0.0)).xyz(), Vec3::X);
}

/// Moved and then turned is not turned and then moved; the assignment's order scales first and moves last.
#[test]
fn the_order_of_products_matters() {
    let (moved, turned) = (translate(Vec3::X), Mat4::from_mat3(rotate_z(90.0)));
    let close = |m: Mat4, to: Vec3| (place(&m, Vec3::X).unwrap() - to).length() < 1e-6;
    assert!(close(turned * moved, Vec3::new(0.0, 2.0, 0.0)));
    assert!(close(moved * turned, Vec3::new(1.0, 1.0, 0.0)));
    // Twice as long, a quarter turn about x, moved: y becomes 2z.
    let placed = model(Vec3::new(5.0, 0.0, 0.0), Vec3::new(90.0, 0.0, 0.0), Vec3::splat(2.0));
    assert!((place(&placed, Vec3::Y).unwrap() - Vec3::new(5.0, 0.0, 2.0)).length() < 1e-6);
    // z before x before y: Ry·Rx·Rz takes y to -x by the first and leaves it there, then to z by the last.
    let all = model(Vec3::ZERO, Vec3::splat(90.0), Vec3::ONE);
    assert!((place(&all, Vec3::Y).unwrap() - Vec3::Z).length() < 1e-6);
    // The centre of a rotation about a point stays.
    let point = Vec3::new(3.0, -1.0, 0.5);
    assert!((place(&about(point, turned), point).unwrap() - point).length() < 1e-6);
    assert!((place(&about(point, turned), point + Vec3::X).unwrap() - point - Vec3::Y).length() < 1e-6);
}

/// At a pitch of 90° turning about z is turning about y: of the two angles only their difference is left.
#[test]
fn gimbal_lock_makes_two_angles_one() {
    let locked = |y: f32, z: f32| rotate_y(y) * rotate_x(90.0) * rotate_z(z);
    for (y, z) in [(30.0, 0.0), (50.0, 20.0), (0.0, -30.0)] {
        assert!(locked(y, z).abs_diff_eq(locked(30.0, 0.0), 1e-6));
    }
    let angles = euler_angles(locked(50.0, 20.0));
    assert!((angles.x - 90.0).abs() < 0.03, "{angles}");
    // At just 90° all of the turn is given to y.
    let up = Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y);
    let angles = euler_angles(rotate_y(50.0) * up);
    assert!((angles - Vec3::new(90.0, 50.0, 0.0)).length() < 1e-4, "{angles}");
}

/// q and -q are one rotation, so that the way between two rotations may be the long one.
#[test]
fn every_rotation_has_two_quaternions() {
    let q = quaternion(Vec3::Y, 1.0);
    assert_eq!(from_quaternion(q), from_quaternion(-q));
    assert_eq!(quaternion(Vec3::Y, 1.0 + 2.0 * PI).dot(q).signum(), -1.0);
}

/// 1 - cos of a small angle is 0 in f32, and with it the part of Rodrigues' formula along the axis, 5e-9 here.
#[test]
fn rodrigues_formula_loses_the_second_order_of_tiny_angles() {
    let axis = Vec3::new(1.0, 1.0, 0.0).normalize();
    let symmetric = |m: Mat3| f64::from(m.x_axis.y) + f64::from(m.y_axis.x);
    assert_eq!(symmetric(method(ROTATIONS, "rodrigues")(axis, 1e-4)), 0.0);
    let quaternion = symmetric(method(ROTATIONS, "quaternion")(axis, 1e-4));
    assert!((quaternion / 5e-9 - 1.0).abs() < 1e-3, "{quaternion}");
}

/// Turned as points are, the normals of a surface at 45° that is stretched by s are off by atan((s² - 1) / 2s).
/// The inverse transpose keeps them at right angles to the surface.
#[test]
fn normals_need_the_inverse_transpose() {
    for s in [1.0f32, 1.5, 2.0, 4.0, 10.0] {
        let m = scale(Vec3::new(s, 1.0, 1.0));
        let (normal, along) = (Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, -1.0, 0.0));
        let surface = (m * along.extend(0.0)).xyz();
        let right = normal_matrix(&m).unwrap() * normal;
        assert!(right.dot(surface).abs() < 1e-6, "{s}");
        let wrong = (m * normal.extend(0.0)).xyz().as_dvec3();
        let off = wrong.angle_between(right.as_dvec3());
        let s = f64::from(s);
        assert!((off - ((s * s - 1.0) / (2.0 * s)).atan()).abs() < 1e-6, "{s}: {off}");
    }
    assert_eq!(normal_matrix(&scale(Vec3::new(1.0, 0.0, 1.0))), None);
    assert_eq!(normal_matrix(&projection(2.0)), Some(Mat3::IDENTITY));
}

/// An axis that is 1.1 long makes what is no rotation; Euler angles are always one, though another.
#[test]
fn an_axis_must_have_length_1() {
    let skews = ROTATIONS.iter().map(|method| turn::skew(&(method.run)(Vec3::new(0.0, 1.1, 0.0), 1.0)));
    let skews: Vec<f64> = skews.collect();
    assert!(skews[0] < 1e-6 && skews[1] > 0.1 && skews[2] > 0.01, "{skews:?}");
}

/// Slanting by a factor of y moves a point along x alone, and in the plane keeps what is in it.
#[test]
fn maps_of_the_plane_stay_in_it() {
    let m = translate(Vec3::new(3.0, 4.0, 0.0)) * shear_x(0.5, 0.0) * scale(Vec3::new(2.0, 3.0, 1.0));
    assert_eq!(place(&m, Vec3::new(1.0, 2.0, 0.0)), Some(Vec3::new(8.0, 10.0, 0.0)));
    let turned = Mat4::from_mat3(rotate_z(33.0)) * m;
    let expected = turn::turned(DVec3::new(8.0, 10.0, 0.0), DVec3::Z, 33f64.to_radians());
    assert!((place(&turned, Vec3::new(1.0, 2.0, 0.0)).unwrap().as_dvec3() - expected).length() < 1e-5);
}
