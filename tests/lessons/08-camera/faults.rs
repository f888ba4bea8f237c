//! Each fault stands in the code here and is recognised by its result alone.

use camera_tasks::Camera;
use common::Mat4;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let lookat = |lookat, words| {
        JUDGE.recognises(&Camera { lookat, ..reference }, "centre", words);
    };
    lookat(camera::listing, "subtracted after turning");
    lookat(
        |eye, center, up| {
            let rows = camera::basis(eye, center, up)?;
            Some(Mat4::from_mat3(rows) * transforms::translate(center))
        },
        "the centre is added",
    );
    lookat(
        |eye, center, up| {
            let rows = camera::basis(eye, center, up)?;
            Some(Mat4::from_mat3(rows) * transforms::translate(-eye))
        },
        "the eye is subtracted",
    );
    let basis = |basis, words| {
        JUDGE.recognises(&Camera { basis, ..reference }, "basis", words);
    };
    basis(|eye, center, up| Some(camera::basis(eye, center, up)?.transpose()), "stands in columns");
    basis(|eye, center, up| camera::basis(center, eye, up), "looks away");
    basis(
        |eye, center, up| {
            let z = (eye - center).normalize();
            let x = up.cross(z);
            Some(common::Mat3::from_cols(x, z.cross(x), z).transpose())
        },
        "not 1 long",
    );
    basis(
        |eye, center, up| {
            let z = (eye - center).normalize();
            let x = up.cross(z).normalize();
            Some(common::Mat3::from_cols(x, x.cross(z), z).transpose())
        },
        "upside down",
    );
}
