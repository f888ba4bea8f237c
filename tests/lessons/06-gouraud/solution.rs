//! All of mission 6.
use common::{Image, Vec3};
use textures::{interpolate, texel};
use zbuffer::{DepthBuffer, fill_nearest};

pub use gouraud_given::{Drawn, Scene, corner_normals};

/// The cosine at each corner.
pub fn intensities(normals: [Vec3; 3], light: Vec3) -> Vec3 {
    Vec3::from_array(normals.map(|normal| normal.dot(light)))
}

/// Interpolated, then clamped.
pub fn gouraud(
    scene: &Scene,
    image: &mut Image,
    place: impl Fn(Vec3) -> Option<Vec3>,
) -> Drawn<DepthBuffer<f32>> {
    let mut drawn = Drawn { depths: DepthBuffer::new(image, f32::NEG_INFINITY), left_out: 0 };
    for (n, (corners, uvs)) in scene.model.faces().zip(scene.model.face_uvs()).enumerate() {
        let [Some(a), Some(b), Some(c)] = corners.map(&place) else {
            drawn.left_out += 1;
            continue;
        };
        let intensities = intensities(scene.normals[n], scene.light);
        let draw = |x, y, weights| {
            let color = texel(scene.texture, interpolate(uvs, weights));
            image.set(x, y, color.shaded(intensities.dot(weights).max(0.0)));
        };
        fill_nearest([a, b, c], &mut drawn.depths, |depth| depth, draw);
    }
    drawn
}
