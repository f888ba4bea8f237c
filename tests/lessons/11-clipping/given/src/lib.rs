//! What mission 11 gives: corners in clip space, the six planes, and a loop over triangles and pixels. All of it is made of
//! lessons 3 to 10, so that the program in which a submission runs has nothing of lesson 11.

use common::{Bounds, Image, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::{perspective_weights, window};
use textures::repeat;
use triangles::fill;

/// A corner in clip space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipVertex {
    /// Where it is, before division by w.
    pub position: Vec4,
    /// Where it is in the texture.
    pub uv: Vec2,
}

/// The planes of what is seen, −w ≤ x, y, z ≤ w: near, far, left, right, bottom, top.
pub const PLANES: [Vec4; 6] = [
    Vec4::new(0.0, 0.0, 1.0, 1.0),
    Vec4::new(0.0, 0.0, -1.0, 1.0),
    Vec4::new(1.0, 0.0, 0.0, 1.0),
    Vec4::new(-1.0, 0.0, 0.0, 1.0),
    Vec4::new(0.0, 1.0, 0.0, 1.0),
    Vec4::new(0.0, -1.0, 0.0, 1.0),
];

/// The triangles of a polygon without dents.
pub fn fan(polygon: &[ClipVertex]) -> impl Iterator<Item = [ClipVertex; 3]> + '_ {
    (2..polygon.len()).map(|last| [polygon[0], polygon[last - 1], polygon[last]])
}

/// Calls `visit(x, y, depth, uv)` for the pixels of a triangle; for none where a corner is not in front of the eye.
pub fn pixels(triangle: [ClipVertex; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, f32, Vec2)) {
    let size = (bounds.max + 1).as_vec2();
    let [Some(a), Some(b), Some(c)] = triangle.map(|corner| window(corner.position, size)) else { return };
    let [depths, inverse_w] = [2, 3].map(|n| Vec3::new(a[n], b[n], c[n]));
    let uvs = triangle.map(|corner| corner.uv);
    fill([a.xy(), b.xy(), c.xy()], bounds, |x, y, in_picture| {
        let on_triangle = perspective_weights(in_picture, inverse_w);
        let uv = uvs[0] * on_triangle.x + uvs[1] * on_triangle.y + uvs[2] * on_triangle.z;
        visit(x, y, in_picture.dot(depths), uv);
    });
}

/// Draws triangles with a texture that repeats, what is nearer in front: those that face the eye, cut by all six planes.
pub fn draw(
    triangles: &[[ClipVertex; 3]],
    texture: &Image,
    facing: impl Fn([Vec4; 3]) -> f64,
    clip: impl Fn(&[ClipVertex], Vec4) -> Vec<ClipVertex>,
    image: &mut Image,
) {
    let (bounds, width) = (image.bounds(), image.width());
    let mut nearest = vec![1.0_f32; (image.width() * image.height()) as usize];
    for triangle in triangles {
        if facing(triangle.map(|corner| corner.position)) > 0.0 {
            let polygon = PLANES.iter().fold(triangle.to_vec(), |polygon, &plane| clip(&polygon, plane));
            for triangle in fan(&polygon) {
                pixels(triangle, bounds, |x, y, depth, uv| {
                    let nearest = &mut nearest[(y * width + x) as usize];
                    if depth < *nearest {
                        *nearest = depth;
                        image.set(x, y, repeat(texture, uv));
                    }
                });
            }
        }
    }
}
