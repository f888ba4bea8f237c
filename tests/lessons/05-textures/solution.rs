//! All of mission 5.
use common::{Color, Image, Model, Vec2, Vec3};
use triangles::flat_intensity;
use zbuffer::{DepthBuffer, fill_nearest, to_screen};

/// The texel in which (u, v) lies, or else the nearest.
pub fn texel(texture: &Image, uv: Vec2) -> Color {
    let at = (uv * texture.size()).floor().as_ivec2();
    let at = at.clamp(texture.bounds().min, texture.bounds().max);
    texture.get(at.x, at.y).unwrap_or(Color::BLACK)
}

/// The mean of the corners' (u, v).
pub fn interpolate([a, b, c]: [Vec2; 3], weights: Vec3) -> Vec2 {
    a * weights.x + b * weights.y + c * weights.z
}

/// A model in the colour at each (u, v), flat-shaded.
pub fn draw_textured(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: impl Fn(Vec2) -> Color,
) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    let size = image.size();
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        let intensity = flat_intensity(corners, light);
        if intensity >= 0.0 {
            let screen = corners.map(|corner| to_screen(corner, size));
            let draw = |x, y, weights| {
                image.set(x, y, color(interpolate(uvs, weights)).shaded(intensity));
            };
            fill_nearest(screen, &mut depths, |depth| depth, draw);
        }
    }
    depths
}
