//! All of mission 11.
use common::{Vec4, Vec4Swizzles as _};

pub use clipping_given::{ClipVertex, PLANES, draw};

/// The determinant of x, y and w.
pub fn facing(corners: [Vec4; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| corner.xyw().as_dvec3());
    a.cross(b).dot(c)
}

/// One plane of Sutherland and Hodgman's.
pub fn clip(polygon: &[ClipVertex], plane: Vec4) -> Vec<ClipVertex> {
    let mut result = Vec::new();
    for i in 0..polygon.len() {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let (from, to) = (plane.dot(a.position), plane.dot(b.position));
        if from >= 0.0 {
            result.push(a);
        }
        if (from >= 0.0) != (to >= 0.0) {
            // A weight for each end: exchange them, and nothing changes.
            let (weight_a, weight_b) = (-to / (from - to), from / (from - to));
            let position = a.position * weight_a + b.position * weight_b;
            result.push(ClipVertex { position, uv: a.uv * weight_a + b.uv * weight_b });
        }
    }
    result
}
