//! All of mission 4.
use common::{Image, Vec3};

pub use zbuffer_given::{DepthBuffer, Surface, to_screen};

/// The pixels that are nearer than what was drawn there.
pub fn fill_nearest<D: Copy + PartialOrd>(
    corners: [Vec3; 3],
    depths: &mut DepthBuffer<D>,
    store: impl Fn(f32) -> D,
    mut visit: impl FnMut(i32, i32, Vec3),
) {
    let depth_of = Vec3::from(corners.map(|corner| corner.z));
    triangles::fill(corners.map(|corner| corner.truncate()), depths.bounds(), |x, y, weights: Vec3| {
        let depth = store(depth_of.dot(weights));
        if depth > depths.get(x, y) {
            depths.set(x, y, depth);
            visit(x, y, weights);
        }
    });
}

/// Surfaces with a buffer of f32.
pub fn z_f32(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    for surface in surfaces {
        fill_nearest(surface.corners, &mut depths, |depth| depth, |x, y, _| image.set(x, y, surface.color));
    }
    depths
}
