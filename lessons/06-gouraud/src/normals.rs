//! Unit normals at the corners of a model: the file's, made 1 long, or else computed.

use common::direction::unit;
use common::{DVec3, Model, Vec3};

// ANCHOR: corner_normals
/// The unit normals of each triangle's corners: the model's, or computed where it has none.
///
/// A normal of the file may have any length. One without a length has no direction: its triangle's own
/// normal stands in.
#[must_use]
pub fn corner_normals(model: &Model) -> Vec<[Vec3; 3]> {
    let given = match model.face_normals() {
        normals if normals.len() > 0 => normals.collect(),
        _ => mean_normals(model),
    };
    let unit_or_own = |(normals, corners): ([Vec3; 3], [Vec3; 3])| {
        let own = || area_normal(corners).normalize_or_zero().as_vec3();
        normals.map(|normal| unit(normal).unwrap_or_else(own))
    };
    given.into_iter().zip(model.faces()).map(unit_or_own).collect()
}
// ANCHOR_END: corner_normals

// ANCHOR: mean_normals
/// At each position the mean of the normals of the triangles there, each as heavy as its triangle is large;
/// 0 where they cancel, as on the two sides of a sheet, but for rounding.
fn mean_normals(model: &Model) -> Vec<[Vec3; 3]> {
    let mut sums = vec![(DVec3::ZERO, 0.0); model.positions().len()];
    for (triangle, corners) in model.triangles().iter().zip(model.faces()) {
        let normal = area_normal(corners);
        for &i in triangle {
            let (sum, areas) = &mut sums[i as usize];
            *sum += normal;
            *areas += normal.length();
        }
    }
    let mean = |i: u32| match sums[i as usize] {
        (sum, areas) if sum.length() > CANCELLED * areas => (sum / areas).as_vec3(),
        _ => Vec3::ZERO,
    };
    model.triangles().iter().map(|triangle| triangle.map(mean)).collect()
}

/// The share of its summands below which a sum of normals is what rounding has left of it. In f64 that is some
/// 1e-16 a summand; directions that are worth something do not come near.
const CANCELLED: f64 = 1e-12;

/// The normal of a triangle, as long as twice its area. In f64, where no product of f32 is too large.
fn area_normal(corners: [Vec3; 3]) -> DVec3 {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    (b - a).cross(c - a)
}
// ANCHOR_END: mean_normals
