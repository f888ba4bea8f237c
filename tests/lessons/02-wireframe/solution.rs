//! All of mission 2.
use common::{Color, IVec2, Image, Model, Vec3};
use lines::line;

/// The pixel in which a point lies; at exactly 1, the last one.
pub fn to_pixel(point: Vec3, image: &Image) -> IVec2 {
    let pixel = |coordinate: f32, size: i32| {
        let exact = (f64::from(coordinate) + 1.0) * f64::from(size) / 2.0;
        if coordinate == 1.0 { size - 1 } else { exact.floor() as i32 }
    };
    IVec2::new(pixel(point.x, image.width()), pixel(point.y, image.height()))
}

/// Three sides a triangle.
pub fn wireframe(model: &Model, image: &mut Image, color: Color) {
    for corners in model.faces() {
        let [a, b, c] = corners.map(|corner| to_pixel(corner, image));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            line(from, to, image, color);
        }
    }
}
