//! All of mission 8.
use common::{Mat3, Mat4, Vec3};
use transforms::translate;

/// The rows x', y', z'.
pub fn basis(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat3> {
    let z = (eye - center).try_normalize()?;
    let x = up.cross(z).try_normalize()?;
    Some(Mat3::from_cols(x, z.cross(x), z).transpose())
}

/// R·(P − C).
pub fn lookat(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    let rows = basis(eye, center, up)?;
    Some(Mat4::from_mat3(rows) * translate(-center))
}
