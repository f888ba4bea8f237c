//! All of mission 7.
use common::{Mat4, Vec3, Vec4Swizzles};

pub use transforms_given::{scale, translate};

/// From [−1, 1]² to pixels.
pub fn viewport(width: f32, height: f32, zoom: f32) -> Mat4 {
    translate(Vec3::new(width / 2.0, height / 2.0, 0.0)) * scale(Vec3::new(width * zoom, height * zoom, 1.0))
}

/// w = 1 − z/d.
pub fn projection(d: f32) -> Mat4 {
    let mut m = Mat4::IDENTITY;
    m.z_axis.w = -1.0 / d;
    m
}

/// Divided by w, before the eye alone.
pub fn place(m: &Mat4, point: Vec3) -> Option<Vec3> {
    let p = *m * point.extend(1.0);
    (p.w > 1e-6).then(|| p.xyz() / p.w)
}
