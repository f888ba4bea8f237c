use std::f32::consts::PI;

use checks::turn;
use common::{DVec3, Mat3, Mat4, Quat, Vec2, Vec3};
use glam::EulerRot;
use proptest::prelude::*;
use transforms::affine::{euler, model, rotate_x, rotate_y, rotate_z, shear_x};
use transforms::inverse::{INVERSES, cofactors, elimination, rigid};
use transforms::rotation::{ROTATIONS, euler_angles, from_quaternion, quaternion, rodrigues};
use transforms::{normal_matrix, orthonormal, place, projection, scale, translate, viewport};

fn vector(range: std::ops::Range<f32>) -> impl Strategy<Value = Vec3> {
    (range.clone(), range.clone(), range).prop_map(Vec3::from)
}

/// A direction, 1 long.
fn direction() -> impl Strategy<Value = Vec3> {
    vector(-1.0..1.0).prop_filter_map("too short", |v| (v.length() > 0.1).then(|| v.normalize()))
}

/// An affine map that is far from flattening anything.
fn affine() -> impl Strategy<Value = Mat4> {
    (vector(-5.0..5.0), vector(-180.0..180.0), vector(0.5..2.0), -1.0f32..1.0)
        .prop_map(|(moved, degrees, size, slant)| model(moved, degrees, size) * shear_x(slant, -slant))
}

/// Sines and cosines are rounded differently by glam and by platforms.
const CLOSE: f32 = 1e-5;

proptest! {
    #[test]
    fn the_matrices_are_glams(v in vector(-9.0..9.0), axis in direction(), angle in -PI..PI) {
        prop_assert_eq!(translate(v), Mat4::from_translation(v));
        prop_assert_eq!(scale(v), Mat4::from_scale(v));
        let degrees = angle.to_degrees();
        prop_assert!(rotate_x(degrees).abs_diff_eq(Mat3::from_rotation_x(angle), CLOSE));
        prop_assert!(rotate_y(degrees).abs_diff_eq(Mat3::from_rotation_y(angle), CLOSE));
        prop_assert!(rotate_z(degrees).abs_diff_eq(Mat3::from_rotation_z(angle), CLOSE));
        prop_assert!(rodrigues(axis, angle).abs_diff_eq(Mat3::from_axis_angle(axis, angle), CLOSE));
        prop_assert!(quaternion(axis, angle).abs_diff_eq(Quat::from_axis_angle(axis, angle), CLOSE));
        let q = Quat::from_axis_angle(axis, angle);
        prop_assert!(from_quaternion(q).abs_diff_eq(Mat3::from_quat(q), CLOSE));
    }

    #[test]
    fn euler_angles_are_glams(degrees in vector(-180.0..180.0)) {
        let [x, y, z] = degrees.to_array().map(f32::to_radians);
        // Ry·Rx·Rz is what glam calls YXZ.
        let expected = Mat3::from_euler(EulerRot::YXZ, y, x, z);
        prop_assert!(euler(degrees).abs_diff_eq(expected, CLOSE));
    }

    #[test]
    fn every_rotation_is_one_and_the_right_one(axis in direction(), angle in -PI..PI) {
        for method in ROTATIONS {
            let got = (method.run)(axis, angle);
            // Near a pitch of 90° Euler angles have half the digits.
            let allowed = if method.name == "euler" { 1e-3 } else { 1e-6 };
            prop_assert!(turn::skew(&got) < 2e-6, "{}", method.name);
            let error = turn::error(&got, axis.as_dvec3(), f64::from(angle));
            prop_assert!(error < allowed, "{}: {error}", method.name);
        }
    }

    #[test]
    fn euler_angles_come_back(degrees in vector(-180.0..180.0)) {
        let turned = euler(degrees);
        prop_assert!(euler(euler_angles(turned)).abs_diff_eq(turned, 1e-3));
    }

    #[test]
    fn an_inverse_undoes_its_matrix(m in affine(), axis in direction(), angle in -PI..PI, by in vector(-5.0..5.0)) {
        for inverse in [cofactors(&m), elimination(&m)] {
            let inverse = inverse.unwrap();
            prop_assert!((inverse * m).abs_diff_eq(Mat4::IDENTITY, 1e-3));
            prop_assert!(inverse.abs_diff_eq(m.inverse(), 1e-3));
        }
        let moved = translate(by) * Mat4::from_mat3(rodrigues(axis, angle));
        prop_assert!((rigid(&moved) * moved).abs_diff_eq(Mat4::IDENTITY, CLOSE));
    }

    #[test]
    fn the_normal_matrix_keeps_right_angles(m in affine(), u in direction(), v in direction()) {
        prop_assume!(u.cross(v).length() > 0.1);
        let normal = normal_matrix(&m).unwrap() * u.cross(v);
        for along in [u, v] {
            let cosine = normal.normalize().dot(m.transform_vector3(along).normalize());
            prop_assert!(cosine.abs() < 1e-4, "{cosine}");
        }
    }

    #[test]
    fn orthonormal_mends_a_rotation_and_leaves_it_otherwise(axis in direction(), angle in -PI..PI, fault in vector(-1e-3..1e-3)) {
        let turned = rodrigues(axis, angle);
        let bent = turned + Mat3::from_cols(fault, fault.rotate_x(1.0), fault.rotate_y(1.0));
        prop_assert!(turn::skew(&orthonormal(bent)) < 1e-6);
        prop_assert!(orthonormal(bent).abs_diff_eq(turned, 1e-2));
    }

    /// x' = x / (1 - z/d), in f64.
    #[test]
    fn projections_follow_similar_triangles(p in vector(-1.0..1.0), d in 1.1f32..100.0) {
        let got = place(&projection(d), p).unwrap().as_dvec3();
        let p = p.as_dvec3();
        let expected: DVec3 = p / (1.0 - p.z / f64::from(d));
        prop_assert!((got - expected).length() < 1e-5 * (1.0 + expected.length()));
    }

    #[test]
    fn a_viewport_is_what_lessons_2_to_6_did(p in vector(-1.0..1.0), width in 1u16..2000, height in 1u16..2000) {
        let size = Vec2::new(f32::from(width), f32::from(height));
        let got = place(&viewport(size.x, size.y, 0.5), p).unwrap();
        prop_assert_eq!(got, zbuffer::to_screen(p, size));
    }

    #[test]
    fn no_matrix_panics(entries in any::<[f32; 16]>(), point in any::<[f32; 3]>()) {
        let m = Mat4::from_cols_array(&entries);
        for method in INVERSES {
            let _ = (method.run)(&m);
        }
        let _ = (place(&m, Vec3::from_array(point)), normal_matrix(&m));
    }
}
