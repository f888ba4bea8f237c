//! What mission 10 gives: a view, the way to the window, and a loop over triangles and pixels. All of it is made of lessons
//! 3 to 8, so that the program in which a submission runs has nothing of lesson 10.

use camera::basis;
use common::{Image, Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use textures::repeat;
use transforms::translate;
use triangles::fill;

/// The view of an eye that looks at a centre, with the **eye** as its origin and what it looks at on the negative z axis.
/// `None` where eye and centre are one point.
#[must_use]
pub fn view(eye: Vec3, center: Vec3, up: Vec3) -> Option<Mat4> {
    Some(Mat4::from_mat3(basis(eye, center, up)?) * translate(-eye))
}

/// From clip space to the window of a picture of that size: x and y in pixels, z from 0 at the near plane to 1 at the far
/// one, and 1/w.
#[must_use]
pub fn to_window(clip: Vec4, size: Vec2) -> Vec4 {
    let ndc = clip.xyz() / clip.w;
    ((ndc + 1.0) / 2.0 * size.extend(1.0)).extend(1.0 / clip.w)
}

/// A triangle in the world, with (u, v) at its corners.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// Where its corners are.
    pub corners: [Vec3; 3],
    /// Where they are in the texture.
    pub uvs: [Vec2; 3],
}

/// Draws triangles with a texture that repeats, what is nearer in front. `weights` makes weights on the triangle of weights
/// in the picture and the corners' 1/w. A triangle with a corner at w ≤ 1e-6 is left out.
pub fn draw(
    triangles: &[Triangle],
    texture: &Image,
    to_clip: Mat4,
    weights: impl Fn(Vec3, Vec3) -> Vec3,
    image: &mut Image,
) {
    let (size, bounds) = (image.size(), image.bounds());
    let mut depths = vec![1.0_f32; (image.width() * image.height()) as usize];
    for Triangle { corners, uvs } in triangles {
        let clip = corners.map(|corner| to_clip * corner.extend(1.0));
        // NaN is not above it either.
        if !clip.iter().all(|corner| corner.w > 1e-6) {
            continue;
        }
        let window = clip.map(|corner| to_window(corner, size));
        let [z, inverse_w] = [2, 3].map(|n| Vec3::from_array(window.map(|corner| corner[n])));
        let width = image.width();
        fill(window.map(Vec4::xy), bounds, |x, y, in_picture| {
            let nearest = &mut depths[(y * width + x) as usize];
            // Depth in the window is even in the picture, what lies on the triangle is not.
            let depth = in_picture.dot(z);
            if depth < *nearest {
                *nearest = depth;
                let on_triangle = weights(in_picture, inverse_w);
                let uv = uvs[0] * on_triangle.x + uvs[1] * on_triangle.y + uvs[2] * on_triangle.z;
                image.set(x, y, repeat(texture, uv));
            }
        });
    }
}
