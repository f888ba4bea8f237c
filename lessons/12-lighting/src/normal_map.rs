//! Normals from a map, in the model's own space.
//!
//! A map of normals is a texture that holds directions instead of colours. Made from a fine shape, it gives its detail to a
//! mesh of few triangles: light falls as on the fine shape, while the outline stays the mesh's. In **object space** a texel's
//! red, green and blue are the normal's x, y and z, whatever triangle it is laid on. That is simple and exact under any matrix
//! of the model, but each texel is of one place of one model: two sides of it cannot share a patch of the map as mirror
//! images, and where the surface bends, the normals stay behind. [`tangent`](crate::tangent) has the other way.

use common::{Color, Image, Vec2, Vec3};

use crate::scene::Scene;
use crate::surface::{Shape, Surface};

/// The vector in a texel of a map: x in red, y in green, z in blue; 128 stands for 0, 1 for −1 and 255 for 1. That is Vulkan's
/// signed normalised format with 128 added, and a flat map, (128, 128, 255), changes nothing. (By glTF's custom, 2·c/255 − 1, no
/// texel stands for 0: a flat map leans by a third of a degree.)
///
/// The length is 1 but for the rounding to 8 bits.
// ANCHOR: decoded
#[inline]
#[must_use]
pub fn decoded(texel: Color) -> Vec3 {
    let channel = |code: u8| (f32::from(code) - 128.0) / 127.0;
    Vec3::new(channel(texel.r), channel(texel.g), channel(texel.b))
}
// ANCHOR_END: decoded

/// The normals of a map in object space; nothing is interpolated for them. Glossy all over.
#[derive(Clone, Copy)]
pub struct ObjectNormals<'a>(pub &'a Image);

// ANCHOR: object
impl Surface for ObjectNormals<'_> {
    type Constant = ();
    type Varying = ();

    #[inline]
    fn triangle(&self, _: &Scene, _: usize) {}

    #[inline]
    fn corner(&self, _: &Scene, _: usize, _: usize) {}

    #[inline]
    fn at(&self, scene: &Scene, (): (), uv: Vec2, (): ()) -> Shape {
        let normal = decoded(scene.uniforms.wrap.texel(self.0, uv));
        Shape { normal: scene.normals_to_world * normal, gloss: 1.0 }
    }
}
// ANCHOR_END: object
