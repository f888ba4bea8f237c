//! All of mission 10.
use common::{Mat4, Vec3, Vec4};

pub use perspective_given::{draw, to_window, view};

/// From eye space to clip space.
pub fn frustum(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Option<Mat4> {
    let finite = [l, r, b, t, n].iter().all(|number| number.is_finite());
    if !(finite && 0.0 < n && n < f) || l == r || b == t {
        return None;
    }
    // For f = ∞ this is 0.
    let k = n / f;
    let rows = Mat4::from_cols(
        Vec4::new(2.0 * n / (r - l), 0.0, (r + l) / (r - l), 0.0),
        Vec4::new(0.0, 2.0 * n / (t - b), (t + b) / (t - b), 0.0),
        Vec4::new(0.0, 0.0, -(1.0 + k) / (1.0 - k), -2.0 * n / (1.0 - k)),
        Vec4::new(0.0, 0.0, -1.0, 0.0),
    );
    Some(rows.transpose()).filter(|matrix| matrix.is_finite())
}

/// λω over its sum.
pub fn perspective_weights(weights: Vec3, inverse_w: Vec3) -> Vec3 {
    let products = weights * inverse_w;
    products / products.element_sum()
}
