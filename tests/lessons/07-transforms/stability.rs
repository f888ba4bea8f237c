use std::f32::consts::{FRAC_PI_2, FRAC_PI_6, PI};

use checks::{matrix, turn};
use common::{DMat3, DVec3, Mat3, Mat4, Vec3, Vec4Swizzles};
use transforms::affine::{about, euler, model, rotate_x, rotate_y, rotate_z, shear_x};
use transforms::inverse::INVERSES;
use transforms::rotation::{ROTATIONS, euler_angles, from_quaternion, quaternion, rodrigues_f64};
use transforms::{LESSON, METHODS, normal_matrix, place, projection, scale, translate, viewport};
use verify::method;
use verify::stability::Must::{AtMost, Between, Exact, Nothing};
use verify::stability::{Case, every_method};

/// How many rotations by 1 radian about (1, 2, 3) are composed, and how far each method's matrix is off the rotation by
/// the whole angle in direction. Platforms round a sine differently, and so the errors that grow from it.
const DIRECTION: &[Case<u32>] = &[
    ("1 turn", 1, &[("f32, f32-renormalised", AtMost(3e-7)), ("f64", AtMost(1e-7))]),
    ("1,000 turns", 1_000, &[("f32, f32-renormalised", Between(1e-6, 1e-3)), ("f64", AtMost(1e-7))]),
    ("a million turns", 1_000_000, &[("f32, f32-renormalised", Between(1e-3, 0.5)), ("f64", AtMost(1e-7))]),
];

/// The same matrices, and how far they are off a rotation's lengths and right angles.
const SHAPE: &[Case<u32>] = &[
    ("1 turn", 1, &[("f32, f32-renormalised, f64", AtMost(3e-7))]),
    ("1,000 turns", 1_000, &[("f32", Between(1e-6, 1e-3)), ("f32-renormalised, f64", AtMost(3e-7))]),
    (
        "a million turns",
        1_000_000,
        &[("f32", Between(1e-3, 0.5)), ("f32-renormalised", AtMost(4e-7)), ("f64", AtMost(3e-7))],
    ),
];

#[test]
fn every_composition_does_what_it_must() {
    let axis = Vec3::new(1.0, 2.0, 3.0).normalize();
    every_method(LESSON.name, METHODS, DIRECTION, |method, &count| {
        turn::error(&(method.run)(axis, 1.0, count), axis.as_dvec3(), f64::from(count))
    });
    every_method(LESSON.name, METHODS, SHAPE, |method, &count| turn::skew(&(method.run)(axis, 1.0, count)));
}

/// In f64 rounding adds up as in f32, a billion times less, and takes twice the memory. (The method's result is
/// rounded to f32, which hides it.)
#[test]
fn f64_drifts_a_billion_times_less() {
    let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
    let step = rodrigues_f64(axis, 1.0);
    let off = |count: u32| {
        let product = (0..count).fold(DMat3::IDENTITY, |product, _| step * product);
        let along = |unit: DVec3| (product * unit - turn::turned(unit, axis, f64::from(count))).length();
        DVec3::AXES.into_iter().map(along).fold(0.0, f64::max)
    };
    let (few, many) = (off(1_000), off(1_000_000));
    assert!((1e-15..1e-12).contains(&few) && (1e-12..5e-10).contains(&many), "{few:.1e}, {many:.1e}");
    assert_eq!(size_of::<DMat3>(), 2 * size_of::<Mat3>());
}

/// An axis and an angle, and how far each way to turn is from the rotation in f64.
const TURNED: &[Case<(Vec3, f32)>] = &[
    ("not at all", (Vec3::Y, 0.0), &[("euler, rodrigues, quaternion", Exact)]),
    (
        "30° about a slanting axis",
        (Vec3::new(1.0, 2.0, 3.0), FRAC_PI_6),
        &[("euler", AtMost(5e-7)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
    (
        "half a turn",
        (Vec3::new(-1.0, 0.5, 1.0), PI),
        &[("euler", AtMost(5e-7)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
    (
        "a million radians",
        (Vec3::Z, 1e6),
        &[("euler", AtMost(5e-7)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
    (
        "a pitch of 90°",
        (Vec3::X, FRAC_PI_2),
        &[("euler", AtMost(5e-7)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
    (
        "a pitch of 90° - 0.02°, where the sine is flat",
        (Vec3::X, FRAC_PI_2 - 3.5e-4),
        &[("euler", Between(1e-6, 1e-3)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
    (
        "by 1e-4",
        (Vec3::new(1.0, 2.0, 3.0), 1e-4),
        &[("euler", AtMost(5e-7)), ("rodrigues, quaternion", AtMost(3e-7))],
    ),
];

#[test]
fn every_rotation_does_what_it_must() {
    every_method(LESSON.name, ROTATIONS, TURNED, |method, &(axis, angle)| {
        let axis = axis.normalize();
        turn::error(&(method.run)(axis, angle), axis.as_dvec3(), f64::from(angle))
    });
}

/// A matrix of whole numbers and a power of 2 that divides it, and how far each inverse is from the exact one, as a
/// share of its largest entry.
const INVERTED: &[Case<(matrix::Whole, f32)>] = &[
    (
        "the identity",
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination, transpose", Exact)],
    ),
    (
        "a quarter turn and a move",
        ([[0, -1, 0, 7], [1, 0, 0, -3], [0, 0, 1, 5], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination, transpose", Exact)],
    ),
    (
        "a stretch by 3",
        ([[3, 0, 0, 0], [0, 3, 0, 0], [0, 0, 3, 0], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination", AtMost(1e-7)), ("transpose", Between(2.6, 2.7))],
    ),
    (
        "a shear",
        ([[1, 2, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination", Exact), ("transpose", Between(1.0, 1.0))],
    ),
    (
        "the projection from a distance of 2",
        ([[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, -1, 2]], 2.0),
        &[("cofactors, elimination", Exact), ("transpose", Between(0.5, 0.5))],
    ),
    (
        "a zero where elimination begins",
        ([[0, 2, 1, 0], [3, 0, 0, 1], [1, 1, 0, 0], [0, 0, 4, 5]], 1.0),
        &[("cofactors, elimination", AtMost(1e-6)), ("transpose", Between(1.0, 1.0))],
    ),
    (
        "Hilbert's matrix times 420, its small determinants exact in f32",
        ([[420, 210, 140, 105], [210, 140, 105, 84], [140, 105, 84, 70], [105, 84, 70, 60]], 1.0),
        &[
            ("cofactors", AtMost(1e-7)),
            ("elimination", Between(1e-6, 1e-3)),
            ("transpose", Between(4e3, 5e3)),
        ],
    ),
    (
        "the same, its rows times 7, 11, 13, 17",
        (
            [
                [2940, 1470, 980, 735],
                [2310, 1540, 1155, 924],
                [1820, 1365, 1092, 910],
                [1785, 1428, 1190, 1020],
            ],
            1.0,
        ),
        &[
            ("cofactors", Between(1e-4, 1e-3)),
            ("elimination", Between(1e-6, 1e-4)),
            ("transpose", Between(5e6, 6e6)),
        ],
    ),
    (
        "rows that differ by 1 in 16,384",
        ([[16384, 16383, 0, 0], [16383, 16382, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination", Nothing), ("transpose", Between(1.9, 2.1))],
    ),
    (
        "flattened",
        ([[1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 0, 4], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination", Nothing), ("transpose", Between(f64::INFINITY, f64::INFINITY))],
    ),
    (
        "flattened, and not to be seen at once",
        ([[1, 2, 3, 0], [4, 5, 6, 0], [7, 8, 9, 0], [0, 0, 0, 1]], 1.0),
        &[("cofactors, elimination", Nothing), ("transpose", Between(f64::INFINITY, f64::INFINITY))],
    ),
    (
        "made smaller by 2^43: its determinant is no f32",
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1 << 43]], (1_u64 << 43) as f32),
        &[("cofactors", Nothing), ("elimination", Exact), ("transpose", Between(1.0, 1.0))],
    ),
];

#[test]
fn every_inverse_does_what_it_must() {
    every_method(LESSON.name, INVERSES, INVERTED, |method, (whole, divisor)| {
        let columns = whole.map(|row| row.map(|entry| entry as f32 / divisor));
        let m = Mat4::from_cols_array_2d(&columns).transpose();
        // The inverse of M/d is d·M⁻¹.
        let got = (method.run)(&m).map(|inverse| inverse * (1.0 / divisor))?;
        Some(matrix::inverse(whole).map_or(f64::INFINITY, |exact| matrix::error(&got, &exact)))
    });
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
    // The limit itself is behind the eye, the next number before it.
    let at = |w: f32| place(&Mat4::from_diagonal(Vec3::ONE.extend(w)), Vec3::Z);
    assert_eq!(at(1e-6), None);
    assert_eq!(at(1e-6f32.next_up()), Some(Vec3::Z / 1e-6f32.next_up()));
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

/// Moved and then turned is not turned and then moved; the usual order scales first and moves last.
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

/// At a pitch of exactly 90° the whole turn is y's, and z is 0; just below, each has its own, as far as the digits go.
#[test]
fn euler_angles_change_at_a_pitch_of_exactly_90_degrees() {
    // Exact quarter turns, in which what the other formula divides is 0.
    let [x, y] = [Vec3::X, Vec3::Y];
    for (m, expected) in [
        (Mat3::from_cols(Vec3::NEG_Z, x, -y), Vec3::new(90.0, 90.0, 0.0)),
        (Mat3::from_cols(Vec3::NEG_Z, -x, y), Vec3::new(-90.0, 90.0, 0.0)),
    ] {
        let angles = euler_angles(m);
        assert!((angles - expected).length() < 1e-5, "{angles}, not {expected}");
        assert!(euler(angles).abs_diff_eq(m, 1e-6), "{angles}");
    }
    let below_one = 1f32.next_down();
    for (pitch, sine) in [(90.0, 1.0), (89.98, below_one), (-89.98, -below_one), (89.0, 0.999_847_7)] {
        let m = euler(Vec3::new(pitch, 50.0, 20.0));
        assert_eq!(-m.z_axis.y, sine, "{pitch}");
        let angles = euler_angles(m);
        let expected = if sine == 1.0 { Vec3::new(90.0, 30.0, 0.0) } else { Vec3::new(pitch, 50.0, 20.0) };
        assert!((angles - expected).abs().max_element() < 0.03, "{pitch}: {angles}");
        assert!((angles.z == 0.0) == (sine == 1.0), "{pitch}: {angles}");
    }
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
