use camera::{basis, lookat};
use checks::{turn, view};
use common::Vec3;
use glam::camera::rh::view::look_at_mat4;
use proptest::prelude::*;
use transforms::place;

fn vector() -> impl Strategy<Value = Vec3> {
    (-9.0f32..9.0, -9.0f32..9.0, -9.0f32..9.0).prop_map(Vec3::from)
}

proptest! {
    /// Whatever is up, even nothing: three directions at right angles, that look at the centre.
    #[test]
    fn the_basis_is_orthonormal(eye in vector(), center in vector(), up in prop_oneof![vector(), Just(Vec3::ZERO)]) {
        prop_assume!(eye.distance(center) > 1e-3);
        let rows = basis(eye, center, up).unwrap();
        prop_assert!(turn::skew(&rows.transpose()) < 1e-6);
        prop_assert!((rows.row(0).cross(rows.row(1)) - rows.row(2)).length() < 1e-6);
        prop_assert!((rows.row(2) - (eye - center).normalize()).length() < 1e-6);
    }

    #[test]
    fn the_view_is_exact_to_a_rounding(eye in vector(), center in vector(), up in vector(), point in vector()) {
        let back = (eye - center).normalize_or_zero();
        prop_assume!(eye.distance(center) > 0.1 && up.length() > 0.1 && up.normalize().cross(back).length() > 0.1);
        let got = place(&lookat(eye, center, up).unwrap(), point).unwrap().as_dvec3();
        prop_assert!((got - view::seen(point.as_dvec3(), eye, center, up)).length() < 1e-4);
        // glam looks from the eye, where this view has the centre as its origin.
        let from_eye = look_at_mat4(eye, center, up.normalize()).transform_point3(point);
        let shifted = got.as_vec3() - Vec3::Z * eye.distance(center);
        prop_assert!((from_eye - shifted).length() < 1e-4);
    }

    #[test]
    fn nothing_is_ever_nan(eye in any::<[f32; 3]>(), center in any::<[f32; 3]>(), up in any::<[f32; 3]>()) {
        let [eye, center, up] = [eye, center, up].map(Vec3::from_array);
        if let Some(rows) = basis(eye, center, up) {
            prop_assert!(rows.is_finite(), "{eye} {center} {up}: {rows}");
        }
    }
}
