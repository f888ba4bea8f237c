//! Unit normals at the corners of a model: the file's, made 1 long, or else computed.

use common::{Model, Vec3};

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
    let faces = model.faces().map(area_normal);
    let unit = |(normals, face): ([Vec3; 3], Vec3)| {
        normals.map(|normal| normal.try_normalize().unwrap_or_else(|| face.normalize_or_zero()))
    };
    given.into_iter().zip(faces).map(unit).collect()
}
// ANCHOR_END: corner_normals

// ANCHOR: mean_normals
/// At each position the sum of the normals of the triangles there, each as long as its triangle is large.
fn mean_normals(model: &Model) -> Vec<[Vec3; 3]> {
    let mut sums = vec![Vec3::ZERO; model.positions().len()];
    for (triangle, corners) in model.triangles().iter().zip(model.faces()) {
        triangle.iter().for_each(|&i| sums[i as usize] += area_normal(corners));
    }
    model.triangles().iter().map(|triangle| triangle.map(|i| sums[i as usize])).collect()
}

/// The normal of a triangle, as long as twice its area.
fn area_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}
// ANCHOR_END: mean_normals
